//! Laws on random input, which is full of degenerate cases; the oracle for faces is a glued plane.

use crate::glue::face_count;
use crate::paths::{Curve, Made, make};
use crate::tables::KINDS;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::{Cell, Provenance, overlay_all};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{SideKind, UMonotoneTraits};
use std::collections::BTreeSet;
use testkit::Rng;

pub(crate) const SIZE: [i64; 2] = [6, 4];

fn random_curve(rng: &mut Rng, kinds: [SideKind; 2]) -> Curve {
    let [width, height] = SIZE;
    let is_closed = |v: i64| match v {
        0 => kinds[0] == SideKind::Closed,
        v if v == height => kinds[1] == SideKind::Closed,
        _ => true,
    };
    loop {
        let any = |rng: &mut Rng| [rng.index(width as usize) as i64, rng.index(height as usize + 1) as i64];
        let [p, mut q] = [any(rng), any(rng)];
        let curve = match rng.index(8) {
            0 => Curve::Parallel(p[1]),
            1 => Curve::Path([p, p]),
            // A meridian or a part of one, often on the seam.
            2 => {
                let u = if rng.one_in(2) { 0 } else { p[0] };
                Curve::Path([[u, 0], [u, q[1].max(1)]])
            }
            3 => Curve::Path([[p[0], height], [p[0], q[1].min(height - 1)]]),
            4 => {
                q[0] += width * (1 + rng.index(2) as i64);
                Curve::Path([p, q])
            }
            _ => {
                q[0] += if rng.one_in(3) { width } else { 0 };
                Curve::Path([p, q])
            }
        };
        let is_on_strip = match curve {
            Curve::Parallel(v) => is_closed(v),
            Curve::Path([p, q]) => p[1] != q[1] || is_closed(p[1]),
        };
        if is_on_strip {
            return curve;
        }
    }
}

pub(crate) fn random_curves(rng: &mut Rng, kinds: [SideKind; 2], most: usize) -> Vec<Curve> {
    (0..1 + rng.index(most)).map(|_| random_curve(rng, kinds)).collect()
}

/// Cells of the result fit together as the cells of each operand do from which they come, and all of these have some.
pub(crate) fn check_provenance<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
    result: &Arrangement<G, T>,
    operands: &[Arrangement<G, T>],
    provenance: &Provenance,
    context: &str,
) {
    let dcel = result.dcel();
    for (i, operand) in operands.iter().enumerate() {
        let face_of = |h| provenance.of_face(dcel.face(h))[i];
        let mut edges = BTreeSet::new();
        for e in dcel.edges() {
            let sides = [e.halfedge(), e.halfedge().twin()];
            match provenance.of_edge(e)[i] {
                Cell::Face(f) => assert_eq!(sides.map(face_of), [f; 2], "{context}: edge {e:?} of {i}"),
                Cell::Edge(old) => {
                    let expected = [old.halfedge(), old.halfedge().twin()].map(|h| operand.dcel().face(h));
                    assert_eq!(sides.map(face_of), expected, "{context}: edge {e:?} on {old:?} of {i}");
                    edges.insert(old);
                }
                Cell::Vertex(_) => panic!("{context}: an edge in a vertex"),
            }
        }
        assert_eq!(edges.len(), operand.dcel().edge_count(), "{context}: edges of {i}");
        let mut vertices = BTreeSet::new();
        for v in dcel.vertices() {
            let around: Vec<Cell> = dcel.around(v).map(|h| provenance.of_edge(h.edge_id())[i]).collect();
            let on_edges = around.iter().filter(|cell| matches!(cell, Cell::Edge(_))).count();
            let is_free = dcel.isolated_face(v).is_some();
            match provenance.of_vertex(v)[i] {
                Cell::Face(f) => {
                    assert!(around.iter().all(|&cell| cell == Cell::Face(f)), "{context}: {v:?} of {i}");
                    if let Some(face) = dcel.isolated_face(v) {
                        assert_eq!(provenance.of_face(face)[i], f, "{context}: isolated {v:?} of {i}");
                    }
                }
                Cell::Edge(old) => {
                    let on_old = around.iter().filter(|&&cell| cell == Cell::Edge(old)).count();
                    assert_eq!((on_old, on_edges), (2, 2), "{context}: {v:?} on {old:?} of {i}");
                }
                Cell::Vertex(old) => {
                    assert_eq!(operand.point(old), result.point(v), "{context}: {v:?} of {i}");
                    assert_eq!(operand.dcel().degree(old), on_edges, "{context}: {v:?} of {i}");
                    if let (true, Some(face)) = (is_free, operand.dcel().isolated_face(old)) {
                        let here = dcel.isolated_face(v).unwrap();
                        assert_eq!(provenance.of_face(here)[i], face, "{context}: isolated {v:?} of {i}");
                    }
                    vertices.insert(old);
                }
            }
        }
        assert_eq!(vertices.len(), operand.dcel().vertex_count(), "{context}: vertices of {i}");
        let faces: BTreeSet<_> = dcel.faces().map(|f| provenance.of_face(f)[i]).collect();
        assert_eq!(faces.len(), operand.dcel().face_count(), "{context}: faces of {i}");
    }
}

fn check_routes<const M: bool>(rng: &mut Rng, kinds: [SideKind; 2], curves: &[Curve], context: &str) {
    let arrangement = make::<M>(SIZE, kinds, curves);
    assert_eq!(arrangement.check_valid(), [], "{context}");
    assert_eq!(arrangement.counts().faces, face_count(SIZE, kinds, curves), "{context}");
    let same = |route: &str, other: &Made<M>| {
        assert_eq!(other.check_valid(), [], "{route}, {context}");
        assert_eq!(other.difference(&arrangement), None, "{route}, {context}");
    };
    let mut shuffled: Vec<Curve> = curves.iter().map(|curve| curve.swapped()).collect();
    rng.shuffle(&mut shuffled);
    same("shuffled", &make(SIZE, kinds, &shuffled));
    let count = 1 + rng.index(3);
    let mut parts = vec![Vec::new(); count];
    for &curve in curves {
        parts[rng.index(count)].push(curve);
    }
    let operands: Vec<Made<M>> = parts.iter().map(|part| make(SIZE, kinds, part)).collect();
    let (overlay, provenance) = overlay_all(&operands.iter().collect::<Vec<_>>());
    let context_of = |route: &str| format!("{route} of {parts:?}, {context}");
    same("overlay", &overlay);
    check_provenance(&overlay, &operands, &provenance, &context_of("overlay"));
    let mut grown = operands[0].clone();
    for part in &parts[1..] {
        let before = grown.clone();
        let provenance = grown.insert_curves(part);
        check_provenance(&grown, &[before], &provenance, &context_of("insertion"));
    }
    same("insertion", &grown);
    for by in 1..SIZE[0] {
        let moved: Vec<Curve> = curves.iter().map(|curve| curve.moved(by)).collect();
        let moved = make::<M>(SIZE, kinds, &moved);
        assert_eq!(moved.check_valid(), [], "moved by {by}, {context}");
        assert_eq!(moved.counts(), arrangement.counts(), "moved by {by}, {context}");
        let map = |p: &Point2| home(p.translated(&[by.into(), 0.into()]));
        assert!(arrangement.is_isomorphic_under(&moved, map, false), "moved by {by}, {context}");
    }
    let mirrored: Vec<Curve> = curves.iter().map(|curve| curve.mirrored()).collect();
    let mirrored: Made<M> = make(SIZE, kinds, &mirrored);
    assert_eq!(mirrored.check_valid(), [], "mirrored, {context}");
    let map = |p: &Point2| {
        let [u, v] = p.coordinates();
        home(Point2::from_rationals(&[-u, v]))
    };
    assert!(arrangement.is_isomorphic_under(&mirrored, map, true), "mirrored, {context}");
}

/// The point with u at least zero and below the width, if it is at most one round away.
fn home(p: Point2) -> Point2 {
    let [u, v] = p.coordinates();
    let width = SIZE[0].into();
    if u >= width {
        Point2::from_rationals(&[u - width, v])
    } else if u < 0.into() {
        Point2::from_rationals(&[u + width, v])
    } else {
        p
    }
}

#[test]
fn all_routes_make_the_same() {
    for (number, kinds) in (0..).zip(KINDS) {
        let seed = 4001 + number;
        let mut rng = Rng::new(seed);
        for round in 0..250 {
            let curves = random_curves(&mut rng, kinds, 8);
            let context = format!("seed {seed}, round {round}, {kinds:?}: {curves:?}");
            check_routes::<true>(&mut rng, kinds, &curves, &context);
            if round % 2 == 0 {
                check_routes::<false>(&mut rng, kinds, &curves, &context);
            }
        }
    }
}

#[test]
fn nothing_is_an_arrangement() {
    for kinds in KINDS {
        let empty: Made<true> = make(SIZE, kinds, &[]);
        let made = Arrangement::new(*empty.traits(), *empty.topology());
        assert_eq!(made.check_valid(), []);
        assert!(made.is_isomorphic(&empty));
    }
}
