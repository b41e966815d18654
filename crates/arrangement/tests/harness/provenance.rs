//! Where the cells of overlays and insertions come from: a point of each new cell is looked for in each operand by a scan.

use crate::curves::{Curve, P, at, fraction, rational};
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::oracle::brute_force;
use crate::random::random_curves;
use crate::scan::Scan;
use crate::torus::{Torus, pieces, random_curves as random_torus_curves, sweep};
use crate::torus_oracle::TorusCurve;
use exact::Rational;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::{Cell, Provenance, overlay_all};
use std::collections::BTreeSet;
use testkit::Rng;

/// Checks vertices, edges and all faces of which a point is found; gives how many faces these are.
pub(crate) fn check(result: &Scan, operands: &[Scan], provenance: &Provenance, context: &str) -> usize {
    assert_eq!(provenance.operand_count(), operands.len());
    let mut points: Vec<P> = Vec::new();
    for (v, p) in result.vertices() {
        for (operand, &cell) in operands.iter().zip(provenance.of_vertex(*v)) {
            assert!(
                operand.locate(p).is_none_or(|found| found == cell),
                "vertex {p:?} in {cell:?}, {context}"
            );
        }
        points.push(p.clone());
    }
    for (e, p) in result.edge_samples() {
        for (i, (operand, &cell)) in operands.iter().zip(provenance.of_edge(e)).enumerate() {
            let found = operand.locate(&p);
            assert!(
                found.is_none_or(|found| found == cell),
                "edge at {p:?}: {cell:?} of {i}, {found:?}, {context}"
            );
        }
        points.push(p);
    }
    let mut faces = BTreeSet::new();
    let third = fraction(1, 3);
    for (p, q) in
        points.iter().flat_map(|p| points.iter().map(move |q| (p, q))).step_by(1 + points.len() / 20)
    {
        let middle: P = [0, 1].map(|i| &p[i] + (&q[i] - &p[i]) * &third);
        let Some(Cell::Face(f)) = result.locate(&middle) else { continue };
        for (operand, &face) in operands.iter().zip(provenance.of_face(f)) {
            let found = operand.locate(&middle);
            assert!(found.is_none_or(|found| found == Cell::Face(face)), "face at {middle:?}, {context}");
        }
        faces.insert(f);
    }
    faces.len()
}

fn deal<C: Clone>(curves: &[C], hands: usize, rng: &mut Rng) -> Vec<Vec<C>> {
    let mut parts = vec![Vec::new(); hands];
    for curve in curves {
        parts[rng.index(hands)].push(curve.clone());
    }
    parts
}

fn run<M: Model>(model: &M, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(17);
    let mut faces = 0;
    let period = model.period();
    for _ in 0..cases {
        let context = format!("{model:?}, seed {}", rng.state());
        let range = rng.between(2, 6);
        let curves = random_curves(&mut rng, 9, range, are_bounded);
        let context = format!("{context}: {curves:?}");
        let scan = |arrangement: &Arrangement<M::Traits, M::Surface>, curves: &[Curve]| {
            Scan::new(arrangement, &brute_force(curves), period.as_ref())
        };
        let make = |curves: &[Curve]| {
            let pieces = model.pieces(curves).expect("the model can carry them");
            Arrangement::of_pieces(model.traits(), model.surface(), pieces)
        };
        for hands in [2, 3] {
            let parts = deal(&curves, hands, &mut rng);
            let operands: Vec<_> = parts.iter().map(|part| make(part)).collect();
            let scans: Vec<Scan> = operands.iter().zip(&parts).map(|(a, part)| scan(a, part)).collect();
            let (result, provenance) = overlay_all(&operands.iter().collect::<Vec<_>>());
            faces += check(&scan(&result, &curves), &scans, &provenance, &context);
            let mut grown = operands[0].clone();
            let provenance = grown.insert_pieces(model.pieces(&parts[1..].concat()).expect("as before"));
            faces += check(&scan(&grown, &curves), &scans[..1], &provenance, &context);
        }
    }
    assert!(faces > cases as usize * 4, "{faces}");
}

#[test]
fn segments() {
    run(&Segments, 150, true);
}

#[test]
fn minimal_segments() {
    run(&MinimalSegments, 50, true);
}

#[test]
fn linear_curves() {
    run(&Linears, 150, false);
}

#[test]
fn polylines() {
    run(&Polylines, 50, true);
}

#[test]
fn polycurves_of_linear_curves() {
    run(&Polylinears, 50, false);
}

#[test]
fn segments_with_data() {
    run(&Numbered, 50, true);
}

#[test]
fn torus_with_seams_anywhere() {
    run(&WideTorus::new([61, 57], [rational(-3), rational(-2)]), 60, true);
}

fn scan_torus(arrangement: &Torus, period: &P) -> Scan {
    Scan::new(arrangement, &brute_force(&[]), Some(period))
}

/// An overlay of parts, and an insertion of the others into the first.
fn check_torus(parts: &[Vec<TorusCurve>], period: &P, context: &str) -> usize {
    let operands: Vec<Torus> = parts.iter().map(|part| sweep(part, period)).collect();
    let scans: Vec<Scan> = operands.iter().map(|operand| scan_torus(operand, period)).collect();
    let (result, provenance) = overlay_all(&operands.iter().collect::<Vec<_>>());
    let context = format!("{context}: {parts:?}");
    let faces = check(&scan_torus(&result, period), &scans, &provenance, &context);
    let mut grown = operands[0].clone();
    let provenance = grown.insert_pieces(pieces(operands[0].traits(), &parts[1..].concat()));
    faces + check(&scan_torus(&grown, period), &scans[..1], &provenance, &context)
}

#[test]
fn curves_round_a_torus() {
    let mut rng = Rng::new(23);
    let mut faces = 0;
    for case in 0..150 {
        let size = [[1, 1], [2, 3], [4, 3], [5, 5]][rng.index(4)];
        let context = format!("case {case}, periods {size:?}, seed {}", rng.state());
        let curves = random_torus_curves(&mut rng, size, 6);
        for hands in [2, 3] {
            faces += check_torus(&deal(&curves, hands, &mut rng), &size.map(rational), &context);
        }
    }
    assert!(faces > 800, "{faces}");
}

/// An edge along the bottom lies in the face below it, where the face above ends and begins at the same vertices.
#[test]
fn an_edge_along_the_bottom_between_two_geodesics() {
    let closed = |x, y, winding| TorusCurve::Closed(at(x, y), winding);
    let parts = [vec![closed(1, 0, [0, 1]), closed(3, 0, [0, 1])], vec![closed(0, 0, [1, 0])]];
    let period = at(4, 4);
    assert!(check_torus(&parts, &period, "blue along the bottom") >= 2);
    let [red, blue] = [&parts[0], &parts[1]].map(|part| sweep(part, &period));
    let (result, provenance) = overlay_all(&[&red, &blue]);
    let middle = [rational(2), Rational::ZERO];
    let Some(Cell::Edge(e)) = scan_torus(&result, &period).locate(&middle) else {
        panic!("no edge is there")
    };
    let Some(face) = scan_torus(&red, &period).locate(&middle) else { panic!("a face is there") };
    assert_eq!(provenance.of_edge(e)[0], face);
    assert_ne!(face, Cell::Face(red.corner_face()), "between the geodesics, not around the corner");
}

/// The path comes to its vertices on seams from the right and the top side only.
#[test]
fn vertices_to_which_edges_come_only_from_the_top_or_the_right() {
    let period = at(4, 4);
    for path in [TorusCurve::Path(at(2, 0), at(0, -1)), TorusCurve::Path(at(0, 0), at(-1, -1))] {
        check_torus(&[vec![path], vec![]], &period, "a path from a seam");
    }
}
