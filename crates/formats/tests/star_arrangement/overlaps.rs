//! Where curves overlap, the text tells nothing of it: it depends on the cells alone.

use super::models::{Row, linear_arrangement, polycurve_arrangement, torus_polycurve_arrangement};
use super::random::{MAKERS, Numbers, turned};
use super::{comes_back, write};
use arrangement::Arrangement;
use arrangement::models::{Linear, LinearTraits};
use arrangement::topology::UnboundedPlane;
use splitstar_formats::StarArrangement;

/// Curves on few lines: nearly all of them overlap others.
fn rows(numbers: &mut Numbers, name: &str) -> Vec<Row> {
    let count = 1 + numbers.below(12);
    let torus = |numbers: &mut Numbers| {
        let start = numbers.pair(4).map(|x| 2 * x);
        match numbers.below(if name == "torus" { 4 } else { 6 }) {
            0 => Row::Closed(start, [[1, 0], [0, 1], [1, 1], [2, 1]][numbers.below(4) as usize]),
            1..4 => Row::Path(start, numbers.pair(5).map(|x| 2 * (x - 2))),
            _ => Row::Polyline((0..2 + numbers.below(5)).map(|_| numbers.pair(4).map(|x| 2 * x)).collect()),
        }
    };
    let plane = |numbers: &mut Numbers| {
        let ([a, b], [c, d]) = (numbers.pair(4), numbers.pair(4));
        match numbers.below(if name == "linear" { 8 } else { 12 }) {
            0..5 => Row::Segment([a, b, c, d]),
            5 => Row::Ray([a, b, c, d]),
            6 => Row::Line([a, b, c, d]),
            7 => Row::Point([a, b]),
            _ => Row::Polyline((0..2 + numbers.below(5)).map(|_| numbers.pair(3)).collect()),
        }
    };
    (0..count).map(|_| if name.starts_with("torus") { torus(numbers) } else { plane(numbers) }).collect()
}

#[test]
fn overlaps_have_one_text_in_every_order() {
    let mut numbers = Numbers::new(11);
    for (name, make) in MAKERS {
        for case in 0..600 {
            let mut rows = rows(&mut numbers, name);
            let text = comes_back(&make(&rows));
            for _ in 0..4 {
                numbers.shuffle(&mut rows);
                let turned: Vec<Row> = rows
                    .iter()
                    .map(|row| if numbers.below(2) == 0 { turned(row) } else { row.clone() })
                    .collect();
                assert_eq!(write(&make(&turned)), text, "{name} {case}: {turned:?}");
            }
        }
    }
}

/// Straight curves, and the same as chains of one piece; and once more each edge as a curve of its own.
#[test]
fn texts_do_not_depend_on_what_curves_the_cells_come_from() {
    let mut numbers = Numbers::new(12);
    for case in 0..600 {
        let rows = rows(&mut numbers, "linear");
        let straight = linear_arrangement(&rows);
        let text = write(&straight);
        assert_eq!(write(&polycurve_arrangement(&rows)), text, "{case}: {rows:?}");
        let StarArrangement::Linear(straight) = straight else { panic!("straight curves") };
        let edges: Vec<Linear> = straight.dcel().edges().map(|e| straight.make_edge_curve(e)).collect();
        let points = straight.vertices().filter_map(|v| straight.point(v).cloned());
        let again = Arrangement::of_curves_and_points(LinearTraits, UnboundedPlane, &edges, points);
        assert_eq!(write(&again.into()), text, "{case}: {rows:?}");
    }
}

fn curves(text: &str) -> Vec<&str> {
    text.lines().filter(|line| line.starts_with("curve")).collect()
}

/// The support of an edge on which several run was the curve that came first.
#[test]
fn overlapping_segments_are_one_curve() {
    let [first, second] = [Row::Segment([0, 0, 8, 0]), Row::Segment([4, 0, 12, 0])];
    let texts =
        [[first.clone(), second.clone()], [second, first]].map(|rows| write(&linear_arrangement(&rows)));
    assert_eq!(curves(&texts[0]), ["curve 0 segment 0 0 3 0"]);
    assert_eq!(texts[0], texts[1]);
}

/// A chain that turns at a vertex is two curves, like the two segments that make the same cells.
#[test]
fn a_curve_goes_straight_on_at_vertices() {
    let corner = Row::Polyline(vec![[0, 0], [4, 4], [8, 0], [12, 0]]);
    let alone = write(&polycurve_arrangement(std::slice::from_ref(&corner)));
    assert_eq!(curves(&alone), ["curve 0 polyline 0 0 1 1 2 0 3 0"]);
    let met = write(&polycurve_arrangement(&[corner, Row::Segment([4, 4, 4, 8])]));
    assert_eq!(
        curves(&met),
        ["curve 0 segment 0 0 1 1", "curve 1 polyline 1 1 2 0 3 0", "curve 2 segment 1 1 1 2"]
    );
    // Two lines of a chain, each with others on it.
    let rows = [[0, 0, 4, 4], [4, 4, 8, 0], [4, 4, 8, 8], [0, 8, 4, 4]].map(Row::Segment);
    let crossing = write(&linear_arrangement(&rows));
    assert_eq!(curves(&crossing), ["curve 0 segment 0 0 2 2", "curve 1 segment 0 2 2 0"]);
}

/// A geodesic comes to the right side on the line on which it leaves the left one, and still is cut there.
#[test]
fn a_curve_ends_on_the_sides_of_a_torus() {
    let rows = [Row::Closed([0, 2], [1, 0]), Row::Path([0, 2], [4, 0]), Row::Path([4, 0], [0, 2])];
    let text = comes_back(&torus_polycurve_arrangement([2, 1], &rows));
    assert_eq!(curves(&text), ["curve 0 path 0 1/2 2 0", "curve 1 path 1 0 0 1/2"]);
}

/// At a vertex with more edges than are compared one by one.
#[test]
fn many_lines_through_a_point_are_one_curve_each() {
    let rows: Vec<Row> = (0..40).map(|i| Row::Line([4, 4, 5, 4 + i])).collect();
    let text = comes_back(&linear_arrangement(&rows));
    assert_eq!(curves(&text).len(), 40);
    assert!(text.contains("\nvertex 0 1 1\n"));
}

/// A ring that began in the middle of a side was cut there, and had another text.
#[test]
fn a_ring_has_one_text_wherever_it_begins() {
    let corners = [[0, 0], [4, 0], [8, 0], [9, 3], [8, 6], [4, 7], [0, 6], [0, 3]];
    let texts = (0..corners.len()).map(|start| {
        let ring: Vec<[i64; 2]> = (0..=corners.len()).map(|i| corners[(start + i) % corners.len()]).collect();
        comes_back(&polycurve_arrangement(&[Row::Polyline(ring)]))
    });
    let texts: Vec<_> = texts.collect();
    assert!(texts.iter().all(|text| *text == texts[0]), "{texts:?}");
}
