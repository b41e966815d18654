//! Overlays and reflections.

use crate::agree::{assert_agrees, map_of};
use crate::random::geodesic;
use arrangement::models::Geodesic;
use arrangement::overlay::Cell;
use dcel::FaceId;
use splitstar_cubical::{At, CubeSide, CubicalArrangement, CubicalProvenance, overlay_all};
use testkit::Rng;

fn drawn(rng: &mut Rng, range: i64) -> Vec<Geodesic> {
    (0..rng.below(5)).map(|_| geodesic(rng, range)).collect()
}

/// Every real cell comes from a real one, and faces lie in faces.
#[track_caller]
fn check_provenance(
    map: &CubicalArrangement,
    provenance: &CubicalProvenance,
    operands: &[&CubicalArrangement],
    context: &str,
) {
    assert_eq!(provenance.operand_count(), operands.len());
    for side in CubeSide::ALL {
        for id in map.side(side).dcel().edges() {
            let cells = provenance.of_edge(At { side, id });
            let is_real = operands.iter().zip(cells).any(
                |(operand, &cell)| matches!(cell, Cell::Edge(id) if operand.is_real_edge(At { side, id })),
            );
            assert_eq!(map.is_real_edge(At { side, id }), is_real, "{context}");
        }
        for id in map.side(side).dcel().vertices() {
            let v = At { side, id };
            assert_eq!(provenance.of_vertex(v).len(), operands.len(), "{context}");
        }
    }
    for face in map.faces() {
        let whole: Vec<_> = provenance.of_face(map, operands, face).collect();
        for part in map.parts(face) {
            let of_part = provenance.of_part(part).iter().zip(operands);
            let faces = of_part.map(|(&id, operand)| operand.face_of(At { side: part.side, id }));
            assert!(faces.eq(whole.iter().copied().map(Some)), "{context}: parts of one face");
        }
    }
}

#[test]
fn an_overlay_is_the_arrangement_of_all_arcs() {
    let mut rng = Rng::new(0x0c0b_e01a);
    for round in 0..300 {
        let context = format!("seed {}", rng.state());
        let operands: Vec<Vec<Geodesic>> =
            (0..1 + rng.below(3)).map(|_| drawn(&mut rng, 1 + round % 3)).collect();
        let maps: Vec<CubicalArrangement> = operands.iter().map(|arcs| map_of(arcs)).collect();
        let maps: Vec<&CubicalArrangement> = maps.iter().collect();
        let (map, provenance) = overlay_all(&maps);
        assert_agrees(&map, &operands.concat(), &context);
        check_provenance(&map, &provenance, &maps, &context);
    }
}

#[test]
fn a_reflection_is_the_arrangement_of_the_opposite_arcs() {
    let mut rng = Rng::new(0x0c0b_e4ef);
    for round in 0..300 {
        let context = format!("seed {}", rng.state());
        let arcs = drawn(&mut rng, 1 + round % 3);
        let map = map_of(&arcs);
        let reflected = map.reflected();
        let opposite: Vec<Geodesic> = arcs.iter().map(Geodesic::antipodal).collect();
        assert_agrees(&reflected, &opposite, &context);
        assert_eq!(reflected.counts_with_artificial(), map.counts_with_artificial(), "{context}");
        assert_eq!(reflected.check_valid(), [], "{context}");
        for face in map.faces() {
            let opposite = |part: At<FaceId>| At { side: part.side.opposite(), id: part.id };
            let mut parts: Vec<_> = map.parts(face).map(opposite).collect();
            parts.sort_unstable();
            assert!(reflected.parts(face).eq(parts), "{context}: a face keeps its id");
        }
        let again = reflected.reflected();
        assert_agrees(&again, &arcs, &context);
        for side in CubeSide::ALL {
            let point = |map: &CubicalArrangement, v| map.side(side).point(v).cloned();
            let mut vertices = map.side(side).dcel().vertices();
            assert!(vertices.all(|v| point(&again, v) == point(&map, v)), "{context}: all is as it was");
        }
    }
}
