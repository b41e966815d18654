//! The degenerate cases by name, with what a visitor is told.

use crate::oracle::{Recorder, Seen, Step, check};
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{
    Linear, LinearTraits, Segment, SegmentTraits, TorusPath, TorusSegmentTraits,
};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use splitstar_arrangement::traits::ArrangementTraits;
use splitstar_arrangement::{Arrangement, Editor};
use std::cmp::Ordering;

/// The calls in letters: `(` begins, `)` ends, `F` through a face, `V` at a vertex, `A` along an edge; at an edge `X` crosses,
/// `T` touches, `o` begins or ends, `J` comes to run along it or leaves it, or begins or ends running along it.
fn letters(steps: &[Step]) -> String {
    let letter = |step: &Step| match step {
        Step::Begins(_) => Some('('),
        Step::Ends(_) => Some(')'),
        Step::Vertex(..) => Some('V'),
        Step::Along(..) => Some('A'),
        Step::Enters(..) => Some('F'),
        Step::Leaves(..) => None,
        Step::Edge(_, _, passage) => Some(if passage.is_crossing() {
            'X'
        } else if passage.is_touching() {
            'T'
        } else if [passage.before, passage.after].contains(&Some(Ordering::Equal)) {
            'J'
        } else {
            'o'
        }),
    };
    steps.iter().filter_map(letter).collect()
}

fn row<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    editor: &Editor<G, T>,
    name: &str,
    curve: &G::Curve,
    expected: &str,
) {
    let mut recorder = Recorder::new(usize::MAX);
    let _ = editor.zone_of(curve, &mut recorder);
    assert_eq!(letters(&recorder.steps), expected, "{name}");
    check(editor, curve, &mut Seen::default(), name);
}

fn segment([x, y, z, w]: [i64; 4]) -> Segment {
    Segment::from_i64([[x, y], [z, w]]).unwrap()
}

#[test]
fn segments_in_a_square() {
    // A square with a diagonal, and a point in the lower triangle.
    let sides = [[0, 0, 4, 0], [4, 0, 4, 4], [0, 4, 4, 4], [0, 0, 0, 4], [0, 0, 4, 4]].map(segment);
    let points = [Point2::from_i64([3, 1])];
    let made = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &sides, points);
    let editor = Editor::new(made);
    for (name, ends, expected) in [
        ("outside", [-2, -1, -1, 5], "(F)"),
        ("inside of a face", [2, 1, 3, 2], "(F)"),
        ("through three edges", [-1, 1, 5, 2], "(FXFXFXF)"),
        ("through a corner", [3, 5, 5, 3], "(FVF)"),
        ("through the point", [2, 1, 4, 1], "(FVFo)"),
        ("from the point", [3, 1, 3, 2], "(VF)"),
        ("to the point, upwards", [3, 0, 3, 1], "(oFV)"),
        ("from edge to edge", [0, 1, 1, 1], "(oFo)"),
        ("from vertex to vertex", [0, 4, 4, 0], "(VFXFVFV)"),
        ("a whole edge", [0, 0, 4, 0], "(VAV)"),
        ("a whole edge and more", [-1, 4, 5, 4], "(FVAVF)"),
        ("within an edge", [1, 0, 3, 0], "(JAJ)"),
        ("from within an edge", [1, 0, 5, 0], "(JAVF)"),
        ("into an edge", [-1, 0, 1, 0], "(FVAJ)"),
        ("up a vertical edge", [0, 0, 0, 4], "(VAV)"),
        ("within a vertical edge", [4, 1, 4, 2], "(JAJ)"),
        ("up past a vertical edge", [4, -1, 4, 5], "(FVAVF)"),
        ("vertical through the diagonal", [2, -1, 2, 5], "(FXFXFXF)"),
        ("along the diagonal", [-1, -1, 5, 5], "(FVAVF)"),
    ] {
        row(&editor, name, &segment(ends), expected);
    }
}

#[test]
fn nothing_is_in_an_empty_arrangement() {
    let editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    row(&editor, "a segment", &segment([0, 0, 1, 1]), "(F)");
    let editor = Editor::new(Arrangement::new(LinearTraits, UnboundedPlane));
    let [p, q] = [[0, 0], [0, 1]].map(Point2::from_i64);
    row(&editor, "a vertical line", &Linear::line(&p, &q).unwrap(), "(F)");
}

#[test]
fn unbounded_curves() {
    let at = |u, v| Point2::from_i64([u, v]);
    let line = |p: [i64; 2], q: [i64; 2]| Linear::line(&Point2::from_i64(p), &Point2::from_i64(q)).unwrap();
    let curves = [line([0, 0], [1, 0]), line([0, 0], [0, 1]), Linear::ray(at(1, 1), &at(2, 2)).unwrap()];
    let editor = Editor::new(Arrangement::of_curves(LinearTraits, UnboundedPlane, &curves));
    for (name, curve, expected) in [
        ("a parallel above", line([0, 3], [1, 3]), "(FXFXF)"),
        ("the line itself", line([5, 0], [9, 0]), "(AVA)"),
        ("the vertical line itself", line([0, 5], [0, 6]), "(AVA)"),
        ("a ray on the line", Linear::ray(at(2, 0), &at(1, 0)).unwrap(), "(AVAJ)"),
        ("a ray up on the line", Linear::ray(at(0, 2), &at(0, 3)).unwrap(), "(JA)"),
        ("a line that becomes the ray", line([0, 0], [1, 1]), "(FVFVA)"),
        ("a ray from the start of the ray", Linear::ray(at(1, 1), &at(1, 0)).unwrap(), "(FXFV)"),
    ] {
        row(&editor, name, &curve, expected);
    }
    // That all end at infinity is no meeting.
    let far = Linear::ray(at(-1, -1), &at(-2, -5)).unwrap();
    assert!(!editor.meets_anything(&far));
}

#[test]
fn polylines_touch_and_part() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let polyline =
        |vertices: &[[i64; 2]]| traits.make_polyline(vertices.iter().copied().map(Point2::from_i64)).unwrap();
    let floor = polyline(&[[0, 0], [10, 0]]);
    let editor = Editor::new(Arrangement::of_curves(traits, BoundedPlane, [&floor]));
    for (name, vertices, expected) in [
        ("touches from above", &[[0, 2], [2, 0], [4, 2]][..], "(FTF)"),
        ("touches from below", &[[0, -2], [2, 0], [4, -2]], "(FTF)"),
        ("crosses twice", &[[1, 1], [3, -1], [5, 1]], "(FXFXF)"),
        ("lies on it for a while", &[[1, 1], [2, 0], [4, 0], [5, 1]], "(FJAJF)"),
        ("twice", &[[0, 1], [1, 0], [2, 0], [3, 1], [4, 0], [6, 0], [7, -1]], "(FJAJFJAJF)"),
        ("to the end", &[[1, 1], [2, 0], [10, 0]], "(FJAV)"),
        ("beyond the end", &[[1, 1], [2, 0], [12, 0]], "(FJAVF)"),
        ("ends within", &[[-1, 0], [2, 0]], "(FVAJ)"),
    ] {
        row(&editor, name, &polyline(vertices), expected);
    }
}

#[test]
fn paths_along_and_through_seams() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let path = |[x, y, dx, dy]: [i64; 4]| -> TorusPath {
        traits.path(&Point2::from_i64([x, y]), &[dx.into(), dy.into()]).unwrap()
    };
    // Along parts of both seams, and one path inside.
    let curves = [path([1, 0, 2, 0]), path([0, 1, 0, 2]), path([1, 1, 2, 2])];
    let editor = Editor::new(Arrangement::of_curves(traits.clone(), FlatTorus, &curves));
    for (name, steps, expected) in [
        ("along the bottom", [0, 0, 4, 0], "(FVAVF)"),
        ("within the edge at the bottom", [2, 0, 1, 0], "(JAV)"),
        ("along the left side", [0, 0, 0, 4], "(FVAVF)"),
        ("across the edge at the bottom", [2, -1, 0, 2], "(Fo)(oF)"),
        ("across the edge at the left", [-1, 2, 2, 0], "(Fo)(oF)"),
        ("to the edge at the bottom, from the top", [2, 3, 0, 1], "(Fo)"),
        ("across the corner", [-1, -1, 2, 2], "(VF)(FV)"),
        ("to a vertex at the bottom, from the top", [3, 3, 0, 1], "(VFV)"),
        ("from a vertex at the bottom, downwards", [3, 0, 0, -1], "(VFV)"),
    ] {
        row(&editor, name, &path(steps), expected);
    }
}

/// The joint of the curve is straight below the point where the vertical edge begins: only to the right of that are they neighbours.
#[test]
fn a_joint_straight_below_a_vertical_edge() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let polyline =
        |vertices: &[[i64; 2]]| traits.make_polyline(vertices.iter().copied().map(Point2::from_i64)).unwrap();
    let above = polyline(&[[0, 3], [2, 4], [2, 1], [0, 4]]);
    let editor = Editor::new(Arrangement::of_curves(traits, BoundedPlane, [&above]));
    row(&editor, "below", &polyline(&[[0, 1], [2, 0], [3, 4]]), "(F)");
}
