//! Where the cells of overlays come from.

use crate::arcs::Curve;
use crate::families::rows;
use crate::graph::Graph;
use crate::matching::Matching;
use crate::own::{Globe, arc_of, coordinates, sweep};
use crate::random::random_curves;
use crate::space::opposite;
use splitstar_arrangement::overlay::{Cell, Provenance, overlay_all};
use testkit::Rng;

/// Every cell lies in the cells of the operands that it is said to come from; tells how many were asked.
fn check(overlay: &Globe, provenance: &Provenance, operands: &[(&[Curve], &Globe)], context: &str) -> usize {
    let dcel = overlay.dcel();
    let mut count = 0;
    for (i, (curves, globe)) in operands.iter().enumerate() {
        let graph = Graph::new(curves);
        let matching = Matching::new(&graph, globe, context);
        for v in overlay.vertices() {
            let p = coordinates(overlay, v);
            let found = matching.place(provenance.of_vertex(v)[i]);
            assert_eq!(found, graph.locate(&p), "{p:?} in {i}, {context}");
            count += 1;
        }
        for e in dcel.edges() {
            let arc = arc_of(overlay, e);
            for p in arc.inner_points() {
                let context = || format!("{p:?} of {e:?} in {i}, {context}");
                assert_eq!(matching.place(provenance.of_edge(e)[i]), graph.locate(&p), "{}", context());
                // On the left of an arc is its normal.
                let sides =
                    [(e.halfedge(), arc.normal.clone()), (e.halfedge().twin(), opposite(&arc.normal))];
                for (h, way) in sides {
                    let found = matching.place(Cell::Face(provenance.of_face(dcel.face(h))[i]));
                    assert_eq!(found, graph.beside_point(&p, &way), "beside {}", context());
                    count += 1;
                }
            }
        }
    }
    count
}

fn check_overlay(parts: &[&[Curve]], context: &str) -> usize {
    let context = format!("{context}: {parts:?}");
    let globes: Vec<Globe> = parts.iter().map(|part| sweep(part)).collect();
    let (overlay, provenance) = overlay_all(&globes.iter().collect::<Vec<_>>());
    let operands: Vec<(&[Curve], &Globe)> = parts.iter().copied().zip(&globes).collect();
    let mut count = check(&overlay, &provenance, &operands, &context);
    // What is inserted upon an arrangement comes from it.
    let mut grown = globes[0].clone();
    let provenance = grown.insert_curves(&crate::own::own(&parts[1..].concat()));
    count += check(&grown, &provenance, &operands[..1], &format!("inserted, {context}"));
    count
}

#[test]
fn overlays_of_families() {
    let mut rng = Rng::new(71);
    let rows = rows();
    let mut count = 0;
    for row in &rows {
        let other = rng.choose(&rows);
        if row.curves.len() + other.curves.len() < 24 {
            let context = format!("{} and {}", row.name, other.name);
            count += check_overlay(&[&row.curves, &other.curves], &context);
        }
    }
    assert!(count > 20_000, "{count}");
}

#[test]
fn overlays_of_random_curves() {
    let mut rng = Rng::new(72);
    let mut count = 0;
    for case in 0..300 {
        let context = format!("case {case}, seed {}", rng.state());
        let parts: Vec<Vec<Curve>> = (0..2 + case % 3).map(|_| random_curves(&mut rng, 6, 2)).collect();
        let parts: Vec<&[Curve]> = parts.iter().map(Vec::as_slice).collect();
        count += check_overlay(&parts, &context);
    }
    assert!(count > 20_000, "{count}");
}
