//! Zones, subcurves and provenance of chains, against the same arcs given one by one.

use crate::arcs::{Arc, Curve, around, circle, short, via};
use crate::chains::{Chain, Made, chain, joints, make, random_chains};
use crate::graph::{Graph, Place};
use crate::own::{direction, normal_of, own, traits_of};
use crate::random::random_point;
use crate::space::{P, opposite};
use dcel::{EdgeId, FaceId};
use splitstar_arrangement::models::GeodesicArc;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::overlay::{Cell, Provenance, overlay_all};
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::traits::CurveEnd;
use splitstar_arrangement::{Editor, locate_all, subcurves};
use std::collections::{BTreeMap, BTreeSet};
use testkit::Rng;

fn arc_of(piece: &GeodesicArc) -> Arc {
    let ends = CurveEnd::BOTH.map(|end| piece.end(end).coordinates());
    Arc { normal: normal_of(piece), ends: Some(ends) }
}

/// The arcs of an edge.
fn arcs_of(made: &Made, e: EdgeId) -> Vec<Arc> {
    made.make_edge_curve(e).pieces().iter().map(arc_of).collect()
}

/// A cell as a user sees it: cuts are of the edges that are cut, which have a number.
fn seen(made: &Made, cell: Cell) -> Cell {
    let view = made.user_view();
    let number = |e| Cell::Edge(EdgeId::new(view.edge_of(e).index()));
    match cell {
        Cell::Vertex(v) if made.is_artificial(v) => {
            number(made.dcel().outgoing(v).expect("an artificial vertex has edges").edge_id())
        }
        Cell::Edge(e) => number(e),
        cell => cell,
    }
}

/// An arrangement of chains, and which of its cells those of their arcs lie in.
struct Matched {
    made: Made,
    graph: Graph,
    cell_of: BTreeMap<Place, Cell>,
}

impl Matched {
    fn new(identification: [i64; 2], chains: &[Vec<Curve>], context: &str) -> Self {
        let made = make(identification, chains, &[]);
        let graph = Graph::new(&chains.concat());
        let mut samples: Vec<(Place, P)> = Vec::new();
        samples.extend(graph.vertices.iter().map(|p| (graph.locate(p), p.clone())));
        let mut beside: Vec<(Place, FaceId)> = Vec::new();
        for (i, edge) in graph.edges.iter().enumerate() {
            samples.extend(edge.inner_points().into_iter().map(|p| (Place::Edge(i), p)));
        }
        for e in made.dcel().edges() {
            for arc in arcs_of(&made, e) {
                let p = arc.inner_points().swap_remove(0);
                for (h, way) in
                    [(e.halfedge(), arc.normal.clone()), (e.halfedge().twin(), opposite(&arc.normal))]
                {
                    beside.push((graph.beside_point(&p, &way), made.dcel().face(h)));
                }
            }
        }
        for v in made.vertices() {
            let p = made.point(v).expect("vertices are points").coordinates();
            samples.push((graph.locate(&p), p.clone()));
            let number = graph.vertices.binary_search(&p).ok();
            let isolated = number.and_then(|number| graph.isolated.get(&number));
            assert_eq!(isolated.is_some(), made.dcel().isolated_face(v).is_some(), "{p:?}, {context}");
            let face = isolated.map(|&boundary| Place::Face(graph.faces[boundary]));
            beside.extend(face.zip(made.dcel().isolated_face(v)));
        }
        if beside.is_empty() {
            beside.push((Place::Face(0), made.corner_face()));
        }
        let points: Vec<_> = samples.iter().map(|(_, p)| direction(p)).collect();
        let cells = locate_all(&made, &points).into_iter().map(|cell| seen(&made, cell));
        let on_curves = samples.into_iter().map(|(place, _)| place).zip(cells);
        let mut cell_of = BTreeMap::new();
        let faces = beside.into_iter().map(|(place, f)| (place, Cell::Face(f)));
        for (place, cell) in on_curves.chain(faces) {
            let known = *cell_of.entry(place).or_insert(cell);
            assert_eq!(known, cell, "{place:?} is in one cell, {context}");
        }
        // Every face is one face, and every cell is met.
        let faces: BTreeSet<Cell> =
            cell_of.values().copied().filter(|cell| matches!(cell, Cell::Face(_))).collect();
        assert_eq!(faces.len(), graph.counts.faces, "{context}");
        assert_eq!(faces.len(), made.dcel().face_count(), "{context}");
        Self { made, graph, cell_of }
    }

    fn cell(&self, place: Place) -> Cell {
        self.cell_of[&place]
    }
}

/// What the interior of a chain meets: what its arcs meet between their ends, and what lies where they are joined. Where one goes back along
/// the one before it, the chain has an end.
fn interior_meets(graph: &Graph, arcs: &[Curve]) -> bool {
    let all: Vec<Arc> = arcs.iter().map(Curve::arc).collect();
    let end_of = |i: usize, end: usize| all[i].ends.as_ref().map(|ends| &ends[end]);
    let last = all.len() - 1;
    let is_closed = last > 0 && end_of(0, 0) == end_of(last, 1);
    let joints = (0..last).map(|i| (i, i + 1)).chain(is_closed.then_some((last, 0)));
    let is_met = |(i, k): (usize, usize)| {
        let is_tip = all[k].normal == opposite(&all[i].normal);
        !is_tip && end_of(k, 0).is_some_and(|p| !matches!(graph.locate(p), Place::Face(_)))
    };
    joints.into_iter().any(is_met) || arcs.iter().any(|curve| graph.zone(curve).1)
}

/// The zones of chains among chains; tells how many cells they have.
fn check_zones(
    identification: [i64; 2],
    chains: &[Vec<Curve>],
    others: &[Vec<Curve>],
    context: &str,
) -> usize {
    let matched = Matched::new(identification, chains, context);
    let editor = Editor::new(matched.made.clone());
    let mut count = 0;
    for arcs in others {
        let context = format!("zone of {arcs:?}, {context}");
        let other = chain(editor.traits(), arcs);
        let places: BTreeSet<Place> = arcs.iter().flat_map(|curve| matched.graph.zone(curve).0).collect();
        let expected: BTreeSet<Cell> = places.iter().map(|&place| matched.cell(place)).collect();
        let found = editor.zone_cells_of(&other).into_iter().map(|cell| seen(&editor, cell));
        assert_eq!(found.collect::<BTreeSet<Cell>>(), expected, "{context}");
        let is_met = !expected.iter().all(|cell| matches!(cell, Cell::Face(_)));
        assert_eq!(editor.meets_anything(&other), is_met, "{context}");
        let is_met_between = interior_meets(&matched.graph, arcs);
        assert_eq!(editor.interior_meets_anything(&other), is_met_between, "{context}");
        // The cells of the chain in the overlay.
        let (overlay, provenance) =
            overlay_all(&[&matched.made, &make(identification, std::slice::from_ref(arcs), &[])]);
        let vertices = overlay.vertices().map(|v| provenance.of_vertex(v));
        let edges = overlay.dcel().edges().map(|e| provenance.of_edge(e));
        let met = vertices.chain(edges).filter(|origin| !matches!(origin[1], Cell::Face(_)));
        let met: BTreeSet<Cell> = met.map(|origin| seen(&editor, origin[0])).collect();
        // A joint that lies on a vertex or edge is a vertex of the overlay.
        assert_eq!(met, expected, "overlay, {context}");
        count += expected.len();
    }
    count
}

/// Arcs between joints, without what is cut besides.
fn parts(arcs: impl Iterator<Item = Arc>, joints: &[P]) -> Vec<(P, [P; 2])> {
    let mut parts = Vec::new();
    for arc in arcs {
        let [start, end] = arc.ends.clone().expect("pieces have ends");
        let mut stops: Vec<P> = joints.iter().filter(|p| arc.has_inside(p)).cloned().collect();
        stops.sort_by(|a, b| arc.compare(a, b));
        stops.dedup();
        let stops: Vec<P> = [start].into_iter().chain(stops).chain([end]).collect();
        parts.extend(stops.windows(2).map(|pair| (arc.normal.clone(), [pair[0].clone(), pair[1].clone()])));
    }
    parts.sort();
    parts
}

/// The subcurves of chains are those of their arcs, but for the joints; tells how many there are.
fn check_subcurves(identification: [i64; 2], chains: &[Vec<Curve>], rng: &mut Rng, context: &str) -> usize {
    let inner = traits_of(identification);
    let traits = PolycurveTraits::new(inner.clone());
    let mut given: Vec<Chain> = chains.iter().map(|arcs| chain(&traits, arcs)).collect();
    rng.shuffle(&mut given);
    let points: Vec<_> = (0..rng.index(3)).map(|_| direction(&random_point(rng, 2))).collect();
    let arcs = chains.concat();
    let mut joints = joints(chains);
    joints.extend(points.iter().map(|p| p.coordinates()));
    let found = subcurves(&traits, &Sphere, &given, &points);
    let singly = subcurves(&inner, &Sphere, &own(&arcs), &points);
    let found_parts = parts(found.iter().flat_map(|curve| curve.pieces()).map(arc_of), &joints);
    assert_eq!(found_parts, parts(singly.iter().map(arc_of), &joints), "{context}");
    // And they are the edges.
    let made: Made = splitstar_arrangement::Arrangement::of_curves_and_points(traits, Sphere, &given, points);
    let edges = made.dcel().edges().flat_map(|e| arcs_of(&made, e));
    assert_eq!(parts(edges, &joints), found_parts, "{context}");
    assert_eq!(made.dcel().edge_count(), found.len(), "{context}");
    found.len()
}

/// Every cell lies in the cells that it is said to come from; tells how many were asked.
fn check_origins(made: &Made, provenance: &Provenance, operands: &[&Matched], context: &str) -> usize {
    let dcel = made.dcel();
    let mut count = 0;
    for (i, operand) in operands.iter().enumerate() {
        let origin = |cell| seen(&operand.made, cell);
        for v in made.vertices() {
            let p = made.point(v).expect("vertices are points").coordinates();
            let expected = operand.cell(operand.graph.locate(&p));
            assert_eq!(origin(provenance.of_vertex(v)[i]), expected, "{p:?} in {i}, {context}");
            count += 1;
        }
        for e in dcel.edges() {
            for arc in arcs_of(made, e) {
                for p in arc.inner_points() {
                    let context = || format!("{p:?} of {e:?} in {i}, {context}");
                    let expected = operand.cell(operand.graph.locate(&p));
                    assert_eq!(origin(provenance.of_edge(e)[i]), expected, "{}", context());
                    let sides =
                        [(e.halfedge(), arc.normal.clone()), (e.halfedge().twin(), opposite(&arc.normal))];
                    for (h, way) in sides {
                        let found = Cell::Face(provenance.of_face(dcel.face(h))[i]);
                        let expected = operand.cell(operand.graph.beside_point(&p, &way));
                        assert_eq!(found, expected, "beside {}", context());
                        count += 1;
                    }
                }
            }
        }
    }
    count
}

fn check_overlay(identification: [i64; 2], parts: &[Vec<Vec<Curve>>], context: &str) -> usize {
    let operands: Vec<Matched> =
        parts.iter().map(|chains| Matched::new(identification, chains, context)).collect();
    let made: Vec<&Made> = operands.iter().map(|operand| &operand.made).collect();
    let (overlay, provenance) = overlay_all(&made);
    assert_eq!(overlay.difference(&make(identification, &parts.concat(), &[])), None, "{context}");
    let mut count = check_origins(&overlay, &provenance, &operands.iter().collect::<Vec<_>>(), context);
    // What is inserted upon an arrangement comes from it.
    let mut grown = operands[0].made.clone();
    let others: Vec<Chain> = parts[1..].concat().iter().map(|arcs| chain(grown.traits(), arcs)).collect();
    let provenance = grown.insert_curves(&others);
    count += check_origins(&grown, &provenance, &[&operands[0]], &format!("inserted, {context}"));
    count
}

const IDENTIFICATIONS: [[i64; 2]; 4] = [[-1, 0], [0, 1], [1, 1], [2, -1]];

fn path(corners: &[[i64; 3]]) -> Vec<Curve> {
    corners.windows(2).map(|pair| short(pair[0], pair[1])).collect()
}

/// Chains that are degenerate in one way each.
fn known() -> Vec<Vec<Curve>> {
    let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let minus = |p: [i64; 3]| p.map(|c| -c);
    let (w, s) = (minus(x), minus(z));
    vec![
        path(&[[3, 1, 5], [-2, 3, 5], [-2, -3, 6], [3, 1, 5]]),
        path(&[z, [1, 1, 0], [1, 3, 1], z]),
        path(&[z, x, s, y, z]),
        path(&[[1, 1, 1], z, [-1, -1, 2]]),
        path(&[[1, 1, 1], z, [1, -1, 2]]),
        path(&[x, y, w, minus(y), x]),
        path(&[w, z, x, s, w]),
        path(&[[-1, 1, 0], w, [-1, 2, 1]]),
        path(&[[-1, 0, 2], w, [-1, 2, 1]]),
        vec![via(x, y, w), via(w, z, x)],
        vec![around(y, x, z), short(x, z)],
        path(&[[1, 0, 0], [1, 4, 0], [1, 2, 2], [1, 2, -3]]),
        path(&[[4, 1, 1], [4, -1, -1], [4, -1, 1], [4, 1, -1], [4, 1, 1]]),
        path(&[x, y, [1, 1, 0]]),
        path(&[x, z, x]),
        vec![circle(z)],
        vec![via(s, [5, 2, 0], z)],
        vec![crate::arcs::point(z)],
        vec![crate::arcs::point([3, 1, 5])],
    ]
}

#[test]
fn zones_of_known_chains() {
    let chains = known();
    let mut count = 0;
    for identification in IDENTIFICATIONS {
        for one in &chains {
            let context = format!("{identification:?}: {one:?}");
            count += check_zones(identification, std::slice::from_ref(one), &chains, &context);
        }
        count += check_zones(identification, &[], &chains, &format!("{identification:?}: nothing"));
        count += check_zones(identification, &chains, &chains, &format!("{identification:?}: all"));
    }
    assert!(count > 3_000, "{count}");
}

#[test]
fn zones_of_random_chains() {
    let mut rng = Rng::new(64);
    let mut count = 0;
    for case in 0..300 {
        let seed = rng.state();
        let range = 1 + case % 2;
        let chains = random_chains(&mut rng, 4, range);
        let others = random_chains(&mut rng, 4, range);
        let identification = *rng.choose(&IDENTIFICATIONS);
        let context = format!("case {case}, seed {seed}, {identification:?}: {chains:?}");
        count += check_zones(identification, &chains, &others, &context);
    }
    assert!(count > 4_000, "{count}");
}

#[test]
fn subcurves_of_chains() {
    let mut rng = Rng::new(65);
    let mut count = 0;
    let known = known();
    for case in 0..800 {
        let seed = rng.state();
        let mut chains = random_chains(&mut rng, 5, 1 + case % 2);
        chains.extend((0..rng.index(3)).map(|_| rng.choose(&known).clone()));
        let identification = *rng.choose(&IDENTIFICATIONS);
        let context = format!("case {case}, seed {seed}, {identification:?}: {chains:?}");
        count += check_subcurves(identification, &chains, &mut rng, &context);
    }
    assert!(count > 5_000, "{count}");
}

#[test]
fn provenance_of_chains() {
    let mut rng = Rng::new(66);
    let mut count = 0;
    let known = known();
    for case in 0..200 {
        let seed = rng.state();
        let mut parts: Vec<Vec<Vec<Curve>>> =
            (0..2 + case % 3).map(|_| random_chains(&mut rng, 3, 1 + case % 2)).collect();
        parts[0].extend((0..rng.index(3)).map(|_| rng.choose(&known).clone()));
        let identification = *rng.choose(&IDENTIFICATIONS);
        let context = format!("case {case}, seed {seed}, {identification:?}: {parts:?}");
        count += check_overlay(identification, &parts, &context);
    }
    assert!(count > 10_000, "{count}");
}
