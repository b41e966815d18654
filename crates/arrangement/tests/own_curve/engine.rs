//! The engine around the model, against the lattice.

use super::Random;
use super::lattice::{Cells, Node, pieces};
use super::own_curve::{Arc, Curve, Point, TaxicabTraits};
use splitstar_arrangement::overlay::{Cell, overlay_all};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::traits::{ApproxTraits, ArrangementTraits, BasicTraits, CurveEnd};
use splitstar_arrangement::{
    Arrangement, CommonEnds, do_any_meet, intersections, locate_by_sweep, subcurves,
};
use std::collections::{BTreeMap, BTreeSet};

type Taxicab = Arrangement<TaxicabTraits, BoundedPlane>;

fn make(curves: &[Curve]) -> Taxicab {
    Arrangement::of_curves(TaxicabTraits, BoundedPlane, curves)
}

/// The nodes that an arc goes through, from its picture.
fn nodes(arc: &Arc) -> Vec<Node> {
    let mut corners = Vec::new();
    TaxicabTraits.approx_curve(arc, None, None, [0.0; 4], &mut corners);
    let corners: Vec<Node> = corners.iter().map(|p| ((2.0 * p[0]) as i64, (2.0 * p[1]) as i64)).collect();
    let mut nodes = vec![corners[0]];
    for corner in &corners[1..] {
        while let Some(last) = nodes.last().copied().filter(|last| last != corner) {
            nodes.push((last.0 + 1, last.1 + (corner.1 - last.1).signum()));
        }
    }
    nodes
}

/// Cells as sets of nodes, whatever their ids: faces by the directed edges and the isolated vertices on their boundaries.
#[derive(PartialEq, Eq, Debug)]
struct Shape {
    faces: BTreeSet<BTreeSet<Vec<Node>>>,
    next: BTreeMap<Vec<Node>, Vec<Node>>,
    artificial: BTreeSet<Node>,
}

fn shape(arrangement: &Taxicab) -> Shape {
    let dcel = arrangement.dcel();
    let path = |h: dcel::HalfedgeId| {
        let mut path = nodes(&arrangement.make_edge_curve(h.edge_id()));
        if !h.is_even() {
            path.reverse();
        }
        path
    };
    let node = |v| arrangement.point(v).map(|p| (p.u, p.v)).unwrap();
    let mut faces = BTreeSet::new();
    let mut next = BTreeMap::new();
    for f in dcel.faces() {
        let mut boundary: BTreeSet<_> = dcel.isolated_vertices(f).map(|v| vec![node(v)]).collect();
        for ccb in dcel.face_ccbs(f) {
            for h in dcel.ccb_cycle(ccb) {
                boundary.insert(path(h));
                next.insert(path(h), path(dcel.next(h)));
            }
        }
        faces.insert(boundary);
    }
    let artificial = arrangement.vertices().filter(|&v| arrangement.is_artificial(v)).map(node).collect();
    Shape { faces, next, artificial }
}

fn check(arrangement: &Taxicab, curves: &[Curve], name: &str) {
    let cells = Cells::of(curves);
    assert!(arrangement.check_valid().is_empty(), "{name}: {:?}", arrangement.check_valid());
    let counts = arrangement.counts_with_splits();
    let points: Vec<Node> =
        arrangement.vertices().map(|v| arrangement.point(v).unwrap()).map(|p| (p.u, p.v)).collect();
    assert_eq!(points.iter().copied().collect::<BTreeSet<_>>(), cells.vertices, "{name}: {curves:?}");
    let edges: Vec<_> = arrangement.dcel().edges().map(|e| nodes(&arrangement.make_edge_curve(e))).collect();
    assert_eq!(edges.iter().cloned().collect::<BTreeSet<_>>(), cells.edges, "{name}: {curves:?}");
    assert_eq!([points.len(), edges.len()], [cells.vertices.len(), cells.edges.len()], "{name}: each once");
    let expected = [cells.faces, cells.isolated, cells.components];
    assert_eq!([counts.faces, counts.isolated, counts.components], expected, "{name}: {curves:?}");
    assert_eq!(arrangement.counts().vertices, points.len() - cells.hidden, "{name}: {curves:?}");
    assert_eq!(arrangement.counts().edges, edges.len() - cells.hidden, "{name}: {curves:?}");
}

fn circle(x: i32, y: i32, radius: u32) -> Curve {
    Curve::Circle { centre: [x, y], radius }
}

fn arc(tip: [i32; 2], opens_up: bool, range: [i32; 2]) -> Curve {
    Curve::Arc { tip, opens_up, range }
}

/// Every route to an arrangement, and every other operation.
fn check_all(curves: &[Curve], random: &mut Random, name: &str) {
    let arrangement = make(curves);
    check(&arrangement, curves, name);
    let expected = shape(&arrangement);

    let mut shuffled = curves.to_vec();
    for i in (1..shuffled.len()).rev() {
        shuffled.swap(i, random.below(i as u32 + 1) as usize);
    }
    assert_eq!(shape(&make(&shuffled)), expected, "{name}, in another order: {curves:?}");

    let (first, second) = shuffled.split_at(random.below(shuffled.len() as u32 + 1) as usize);
    let mut grown = make(first);
    grown.insert_curves(second);
    assert_eq!(arrangement.difference(&grown), None, "{name}, in two halves: {first:?} {second:?}");
    assert_eq!(shape(&grown), expected, "{name}, in two halves: {first:?} {second:?}");

    let [red, blue] = [make(first), make(second)];
    let (overlay, provenance) = overlay_all(&[&red, &blue]);
    assert_eq!(shape(&overlay), expected, "{name}, overlay: {first:?} {second:?}");
    for (operand, arrangement) in [&red, &blue].into_iter().enumerate() {
        let points: Vec<Point> = overlay.vertices().map(|v| *overlay.point(v).unwrap()).collect();
        let found: Vec<Cell> = overlay.vertices().map(|v| provenance.of_vertex(v)[operand]).collect();
        assert_eq!(found, locate_by_sweep(arrangement, &points), "{name}, provenance: {first:?} {second:?}");
        for e in overlay.dcel().edges() {
            let path = nodes(&overlay.make_edge_curve(e));
            let Cell::Edge(old) = provenance.of_edge(e)[operand] else { continue };
            let old = nodes(&arrangement.make_edge_curve(old));
            assert!(old.windows(path.len()).any(|part| part == path), "{name}: {path:?} is part of {old:?}");
        }
    }

    let parts = subcurves(&TaxicabTraits, &BoundedPlane, curves, &[]);
    let parts: Vec<_> = parts.iter().map(nodes).collect();
    assert_eq!(parts.iter().cloned().collect::<BTreeSet<_>>(), Cells::of(curves).edges, "{name}: {curves:?}");
    check_meetings(curves, name);
    check_locations(curves, &arrangement, name);
}

fn check_meetings(curves: &[Curve], name: &str) {
    let sets: Vec<BTreeSet<Node>> =
        curves.iter().map(|curve| pieces(curve).into_iter().flat_map(|(path, _)| path).collect()).collect();
    let pairs = || (0..sets.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let meet = pairs().any(|(i, j)| !sets[i].is_disjoint(&sets[j]));
    let found = do_any_meet(&TaxicabTraits, &BoundedPlane, curves, &[], CommonEnds::Count);
    assert_eq!(found, meet, "{name}: {curves:?}");
    // Every vertex that lies on two curves is a meeting, unless they run together there: then it is only a tip of all of them.
    let next_to = |curve: &Curve, v: &Node| -> BTreeSet<Node> {
        let paths = pieces(curve).into_iter().map(|(path, _)| path);
        let steps = paths.flat_map(|path| path.windows(2).map(|step| [step[0], step[1]]).collect::<Vec<_>>());
        steps.filter(|step| step.contains(v)).map(|[a, b]| if a == *v { b } else { a }).collect()
    };
    let is_meeting = |v: &Node| {
        let through = curves.iter().zip(&sets).filter(|(_, set)| set.contains(v));
        let around: Vec<BTreeSet<Node>> = through.map(|(curve, _)| next_to(curve, v)).collect();
        around.len() > 1 && (around[0].len() != 2 || around.iter().any(|next| *next != around[0]))
    };
    let expected: Vec<Node> = Cells::of(curves).vertices.into_iter().filter(is_meeting).collect();
    let found = intersections(&TaxicabTraits, &BoundedPlane, curves, &[], CommonEnds::Count);
    let found: Vec<Node> = found.iter().map(|p| (p.u, p.v)).collect();
    assert_eq!(found, expected, "{name}: {curves:?}");
}

/// Points of one cell are inside of the same circles.
fn check_locations(curves: &[Curve], arrangement: &Taxicab, name: &str) {
    let points: Vec<Point> = (-7..24).flat_map(|u| (-7..24).map(move |v| Point { u, v })).collect();
    let cells = Cells::of(curves);
    let on_edges: BTreeSet<Node> = cells.edges.iter().flatten().copied().collect();
    let mut inside: BTreeMap<Cell, Vec<bool>> = BTreeMap::new();
    for (p, cell) in points.iter().zip(locate_by_sweep(arrangement, &points)) {
        let node = (p.u, p.v);
        let is_right = match cell {
            Cell::Vertex(v) => arrangement.point(v) == Some(p),
            Cell::Edge(e) => {
                !cells.vertices.contains(&node) && nodes(&arrangement.make_edge_curve(e)).contains(&node)
            }
            Cell::Face(_) => !cells.vertices.contains(&node) && !on_edges.contains(&node),
        };
        assert!(is_right, "{name}: {p:?} is not in {cell:?}: {curves:?}");
        let circles = curves.iter().filter_map(|curve| match *curve {
            Curve::Circle { centre: [x, y], radius } => {
                Some((p.u - 2 * i64::from(x)).abs() + (p.v - 2 * i64::from(y)).abs() < 2 * i64::from(radius))
            }
            Curve::Arc { .. } => None,
        });
        let circles: Vec<bool> = circles.collect();
        assert_eq!(*inside.entry(cell).or_insert_with(|| circles.clone()), circles, "{name}: {p:?} {cell:?}");
    }
}

#[test]
fn degenerate_rows() {
    let rows: &[(&str, Vec<Curve>)] = &[
        ("nothing", vec![]),
        ("a point", vec![circle(1, 1, 0)]),
        ("a circle", vec![circle(1, 1, 1)]),
        ("the same circle three times", vec![circle(2, 2, 2), circle(2, 2, 2), circle(2, 2, 2)]),
        ("two crossings", vec![circle(2, 2, 2), circle(4, 2, 2), circle(3, 5, 2)]),
        ("crossings between integers", vec![circle(2, 2, 2), circle(4, 3, 2)]),
        ("touching in corners", vec![circle(2, 2, 2), circle(6, 2, 2), circle(2, 6, 2), circle(6, 6, 2)]),
        ("touching along sides", vec![circle(2, 2, 2), circle(4, 4, 2), circle(0, 4, 2)]),
        ("common corner, inside", vec![circle(2, 2, 2), circle(3, 2, 3), circle(1, 2, 1)]),
        ("common side, inside", vec![circle(3, 3, 3), circle(2, 2, 1), circle(4, 4, 1)]),
        ("nested", (1..8).map(|r| circle(4, 4, r)).collect()),
        ("tips that touch", vec![arc([3, 3], true, [0, 6]), arc([3, 3], false, [0, 6])]),
        (
            "one tip, many",
            vec![arc([3, 3], true, [0, 6]), arc([3, 3], true, [2, 4]), circle(3, 3, 0), circle(3, 5, 2)],
        ),
        ("two meetings of one pair", vec![arc([3, 1], true, [0, 6]), arc([3, 3], false, [0, 6])]),
        ("overlap between the tips", vec![arc([2, 1], true, [0, 6]), arc([4, 3], false, [0, 6])]),
        (
            "overlaps that part at tips",
            vec![arc([2, 1], true, [0, 6]), arc([4, 3], true, [0, 6]), arc([3, 2], true, [0, 6])],
        ),
        (
            "T-junctions",
            vec![
                arc([3, 3], true, [0, 6]),
                arc([6, 0], false, [4, 6]),
                arc([0, 0], true, [0, 1]),
                circle(5, 5, 1),
            ],
        ),
        (
            "points on vertices, edges and faces",
            vec![circle(3, 3, 2), circle(1, 3, 0), circle(2, 2, 0), circle(3, 3, 0), circle(0, 0, 0)],
        ),
        (
            "k through one point",
            vec![
                circle(3, 5, 2),
                circle(3, 1, 2),
                circle(1, 3, 2),
                circle(5, 3, 2),
                circle(2, 2, 2),
                circle(4, 4, 2),
            ],
        ),
    ];
    for (name, curves) in rows {
        check_all(curves, &mut Random(1), name);
    }
}

#[test]
fn random_curves() {
    for (count, size, rounds) in [(2, 4, 300), (3, 4, 300), (5, 6, 200), (9, 7, 100), (30, 9, 20)] {
        for seed in 0..rounds {
            let mut random = Random(seed * 100 + u64::from(count));
            let curves = random.curves(count, size);
            check_all(&curves, &mut random, &format!("{count} in {size}, seed {seed}"));
        }
    }
}

#[test]
fn a_quarter_turn_changes_no_count() {
    for seed in 0..50 {
        let mut random = Random(seed);
        let (mut curves, mut turned) = (Vec::new(), Vec::new());
        for _ in 0..12 {
            let ([x, y], radius) = ([random.coordinate(9), random.coordinate(9)], random.below(4));
            curves.push(circle(x, y, radius));
            turned.push(circle(-y, x, radius));
        }
        assert_eq!(make(&curves).counts(), make(&turned).counts(), "seed {seed}: {curves:?}");
    }
}

#[test]
fn a_circle_is_cut_into_two_artificial_pieces() {
    let mut out = Vec::new();
    TaxicabTraits.make_u_monotone(&circle(0, 0, 3), &mut out);
    assert_eq!(out.len(), 2);
    let arrangement = make(&[circle(0, 0, 3)]);
    assert_eq!(TaxicabTraits.end_point(&arrangement.curves()[0], CurveEnd::Max), Some(&Point { u: 6, v: 0 }));
    assert_eq!((arrangement.counts().vertices, arrangement.counts_with_splits().vertices), (1, 2));
}
