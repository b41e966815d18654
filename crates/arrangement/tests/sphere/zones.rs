//! The zone of a curve, against brute force and against overlays.

use crate::arcs::Curve;
use crate::families::rows;
use crate::graph::{Graph, Place};
use crate::matching::Matching;
use crate::own::sweep;
use crate::random::{random_curve, random_curves};
use splitstar_arrangement::Editor;
use splitstar_arrangement::overlay::{Cell, overlay_all};
use std::collections::BTreeSet;
use testkit::Rng;

/// Checks zones, and tells how many cells these have.
fn check(curves: &[Curve], others: &[Curve], context: &str) -> usize {
    let graph = Graph::new(curves);
    let globe = sweep(curves);
    let matching = Matching::new(&graph, &globe, context);
    let editor = Editor::new(globe.clone());
    let mut count = 0;
    for curve in others {
        let context = format!("zone of {curve:?}, {context}");
        let (expected, is_met) = graph.zone(curve);
        let cells = editor.zone_cells_of(&curve.own());
        let found: BTreeSet<Place> = cells.iter().map(|&cell| matching.place(cell)).collect();
        assert_eq!(found, expected, "{context}");
        let is_face = |place: &Place| matches!(place, Place::Face(_));
        assert_eq!(editor.meets_anything(&curve.own()), !expected.iter().all(is_face), "{context}");
        assert_eq!(editor.interior_meets_anything(&curve.own()), is_met, "{context}");
        // The cells of the curve in the overlay.
        let (overlay, provenance) = overlay_all(&[&globe, &sweep(std::slice::from_ref(curve))]);
        let of_curve = |cell: Cell| !matches!(cell, Cell::Face(_));
        let vertices = overlay.vertices().map(|v| provenance.of_vertex(v));
        let edges = overlay.dcel().edges().map(|e| provenance.of_edge(e));
        let met = vertices.chain(edges).filter(|origin| of_curve(origin[1]));
        let met: BTreeSet<Place> = met.map(|origin| matching.place(origin[0])).collect();
        assert_eq!(met, expected, "overlay, {context}");
        count += expected.len();
    }
    count
}

#[test]
fn zones_in_families() {
    let mut rng = Rng::new(31);
    let rows = rows();
    let mut count = 0;
    for row in &rows {
        let context = format!("{}, seed {}: {:?}", row.name, rng.state(), row.curves);
        let mut others: Vec<Curve> = (0..4).map(|_| random_curve(&mut rng, 2)).collect();
        // Curves of this family and of others.
        for row in [row, rng.choose(&rows), rng.choose(&rows)] {
            if !row.curves.is_empty() {
                others.push(rng.choose(&row.curves).clone());
            }
        }
        count += check(&row.curves, &others, &context);
    }
    assert!(count > 10_000, "{count}");
}

#[test]
fn zones_among_random_curves() {
    let mut rng = Rng::new(32);
    let mut count = 0;
    for case in 0..1000 {
        let seed = rng.state();
        let range = 1 + case as i64 % 3;
        let curves = random_curves(&mut rng, 1 + case % 14, range);
        let others: Vec<Curve> = (0..4).map(|_| random_curve(&mut rng, range)).collect();
        count += check(&curves, &others, &format!("case {case}, seed {seed}: {curves:?}"));
    }
    assert!(count > 10_000, "{count}");
}
