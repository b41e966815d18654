//! Arrangements of curves as files have them, and what is refused.

use exact::Rational;
use exact::planar::Point2;
use splitstar_formats::{
    CurveError, CurveFault, InputCurve, StarArrangement, read_arrangement, read_curves, write_arrangement,
};
use std::ops::ControlFlow;
use std::path::Path;

const GOES_ON: fn(arrangement::sweep::Progress) -> ControlFlow<()> = |_| ControlFlow::Continue(());

fn point(x: i64, y: i64) -> Point2 {
    Point2::from_i64([x, y])
}

fn periods([p, q]: [i64; 2]) -> Option<[Rational; 2]> {
    Some([p, q].map(Rational::from))
}

fn of_curves(curves: &[InputCurve], period: Option<[Rational; 2]>) -> Result<StarArrangement, CurveError> {
    StarArrangement::of_curves_with(curves.to_vec(), period, GOES_ON)
        .map(|made| made.expect("nobody stops the sweep"))
}

/// Text, whether there is a polyline or a period, vertices, edges, faces and isolated vertices.
type Row = (&'static str, &'static str, [usize; 4]);

const ROWS: [Row; 7] = [
    ("", "linear", [0, 0, 1, 0]),
    ("segment 0 0 2 0\nsegment 1 0 3 0\npoint 1 0\npoint 9 9\n", "linear", [5, 3, 1, 1]),
    ("ray 0 0 1 0\nline 1 -1 1 1\n", "linear", [2, 4, 3, 0]),
    ("polyline 0 0 1 1 2 0\nline 0 0 1 0\npoint 0 5\n", "polycurves", [3, 4, 3, 1]),
    ("period 2 1\nsegment 0 0 2 0\npoint 7 3/2\n", "torus", [2, 1, 1, 1]),
    ("period 2 1\nsegment 0 0 2 1\n", "torus", [1, 1, 1, 0]),
    (
        "period 2 1\npolyline 0 0 1 1/2 2 0\npoint 5 5/2\nsegment 0 1/2 2 1/2\n",
        "torus polycurves",
        [2, 3, 2, 0],
    ),
];

#[test]
fn every_family_is_made() {
    for (text, family, counts) in ROWS {
        let file = read_curves(text.as_bytes(), None).unwrap_or_else(|error| panic!("{text}: {error}"));
        let made = StarArrangement::of_curves(&file).unwrap_or_else(|error| panic!("{text}: {error}"));
        let is = match made {
            StarArrangement::Linear(_) => "linear",
            StarArrangement::Polycurves(_) => "polycurves",
            StarArrangement::Torus(_) => "torus",
            _ => "torus polycurves",
        };
        assert_eq!(is, family, "{text}");
        let found = made.counts();
        assert_eq!([found.vertices, found.edges, found.faces, found.isolated], counts, "{text}");
        let written = write_arrangement(&made);
        let again = read_arrangement(&written, None).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(write_arrangement(&again), written, "{text}");
    }
}

/// Curves that no reader gives, but a program may.
#[test]
fn degenerate_curves_are_points_or_refused() {
    let twice = [point(1, 2), point(1, 2)];
    let polyline = InputCurve::Polyline(vec![point(1, 2); 3]);
    for period in [None, periods([5, 4])] {
        for curves in [
            vec![InputCurve::Segment(twice.clone())],
            vec![polyline.clone()],
            vec![polyline.clone(), InputCurve::Segment(twice.clone()), InputCurve::Point(point(1, 2))],
        ] {
            let counts = of_curves(&curves, period.clone()).map(|made| made.counts());
            let counts = counts.unwrap_or_else(|error| panic!("{curves:?}: {error}"));
            assert_eq!([counts.vertices, counts.edges, counts.isolated], [1, 0, 1], "{curves:?}");
        }
        let curves = [InputCurve::Point(point(0, 0)), InputCurve::Polyline(vec![])];
        let error = of_curves(&curves, period).map(|made| made.counts());
        assert_eq!(error, Err(CurveError { curve: 1, fault: CurveFault::Degenerate }));
    }
    for curve in [InputCurve::Ray(twice.clone()), InputCurve::Line(twice)] {
        for others in [vec![], vec![polyline.clone()]] {
            let number = others.len();
            let curves: Vec<_> = others.into_iter().chain([curve.clone()]).collect();
            let error = of_curves(&curves, None).map(|made| made.counts());
            assert_eq!(error, Err(CurveError { curve: number, fault: CurveFault::Degenerate }));
        }
    }
}

#[test]
fn what_a_torus_cannot_have_is_refused() {
    let segment = |x, y| InputCurve::Segment([point(0, 0), point(x, y)]);
    let unit = point(1, 0);
    let rows = [
        (vec![segment(1, 1), InputCurve::Ray([point(0, 0), unit.clone()])], [2, 1], 1, CurveFault::Ray),
        (vec![InputCurve::Line([point(0, 0), unit])], [2, 1], 0, CurveFault::Line),
        (vec![segment(1, 1)], [2, 0], 0, CurveFault::Period),
        (vec![segment(1, 1), segment(1 << 17, 1)], [1, 1], 1, CurveFault::TooManyTurns),
        (vec![segment(i64::MAX, 1)], [1, 1], 0, CurveFault::TooManyTurns),
        (vec![segment(1 << 16, 0), segment(1 << 16, 0), segment(0, 1)], [1, 1], 2, CurveFault::TooManyTurns),
    ];
    for (curves, period, curve, fault) in rows {
        let error = of_curves(&curves, periods(period)).map(|made| made.counts());
        assert_eq!(error, Err(CurveError { curve, fault }));
    }
    let error = CurveError { curve: 3, fault: CurveFault::Line };
    assert_eq!(
        error.to_string(),
        "curve 3: a line has no end on a torus; give a segment, or arrange in the plane"
    );
}

#[test]
fn a_watch_is_told_and_may_stop() {
    let curves: Vec<InputCurve> =
        (0..4000).map(|i| InputCurve::Segment([point(i, 0), point(i, 1)])).collect();
    let mut told = Vec::new();
    let made = StarArrangement::of_curves_with(curves.clone(), None, |progress| {
        told.push(progress.sites_met);
        ControlFlow::Continue(())
    });
    assert!(made.is_ok_and(|made| made.is_some_and(|made| made.counts().edges == 4000)));
    assert!(told.len() > 5 && told.is_sorted(), "{told:?}");
    let stopped = StarArrangement::of_curves_with(curves, None, |_| ControlFlow::Break(()));
    assert!(stopped.is_ok_and(|made| made.is_none()));
}

/// The seeds of the fuzz target `curves`: whatever order the curves are given in, their arrangement has one text, and comes back.
#[test]
fn the_seeds_have_one_text_in_both_orders() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/curves");
    let mut seeds = 0;
    for seed in std::fs::read_dir(folder).expect("the seeds are there") {
        let seed = seed.expect("a folder can be read").path();
        let bytes = std::fs::read(&seed).expect("a seed can be read");
        let file = read_curves(&bytes, None).unwrap_or_else(|error| panic!("{}: {error}", seed.display()));
        let mut curves = file.curves;
        let text_of = |curves: &[InputCurve]| {
            let made = of_curves(curves, file.period.clone());
            write_arrangement(&made.unwrap_or_else(|error| panic!("{}: {error}", seed.display())))
        };
        let text = text_of(&curves);
        let again =
            read_arrangement(&text, None).unwrap_or_else(|error| panic!("{}: {error}", seed.display()));
        assert_eq!(write_arrangement(&again), text, "{}", seed.display());
        curves.reverse();
        assert_eq!(text_of(&curves), text, "{}", seed.display());
        seeds += 1;
    }
    assert!(seeds >= 7, "{seeds} seeds");
}
