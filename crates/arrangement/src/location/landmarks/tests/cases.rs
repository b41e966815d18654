//! Arrangements with few landmarks or strange ones, and landmarks that follow edits.

use super::*;
use crate::models::{Linear, Segment};
use crate::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use crate::{Editor, Pieces};

fn segments_of(ends: &[[[i64; 2]; 2]]) -> Arrangement<SegmentTraits, BoundedPlane> {
    let segments: Vec<Segment> = ends.iter().map(|&ends| Segment::from_i64(ends).unwrap()).collect();
    Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments)
}

/// All generators on one arrangement; gives the numbers of landmarks.
#[track_caller]
fn all_agree<G: Model, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    queries: &[Point2],
) -> [usize; GENERATORS.len()] {
    GENERATORS.map(|generator| {
        let landmarks = Landmarks::with_generator(arrangement, generator);
        assert_eq!(landmarks.generator(), generator);
        agree(arrangement, queries, &landmarks, &format!("{generator:?}"));
        landmarks.count()
    })
}

const FAR: i64 = 1 << 60;

fn some_points() -> Vec<Point2> {
    let near = (-2..6).flat_map(|x| (-2..6).map(move |y| [x, y]));
    near.chain([[FAR, 3], [3, -FAR], [-FAR, FAR]]).map(Point2::from_i64).collect()
}

#[test]
fn an_empty_arrangement_has_no_landmark() {
    let plane = Arrangement::new(SegmentTraits, BoundedPlane);
    assert_eq!(all_agree(&plane, &some_points()), [0; 6]);
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let points: Vec<Point2> = some_points().iter().map(|p| traits.point(p)).collect();
    let torus = Arrangement::new(traits, FlatTorus);
    assert_eq!(all_agree(&torus, &points), [0; 6]);
}

#[test]
fn lines_that_meet_at_infinity_only_need_no_landmark() {
    let line = |p: [i64; 2], q: [i64; 2]| {
        let [p, q] = [p, q].map(Point2::from_i64);
        Linear::line(&p, &q).unwrap()
    };
    for to in [[1, 0], [1, 1], [1, -2], [0, 1]] {
        let lines: Vec<Linear> =
            (0..4).map(|i| [3 * i % 5, i]).map(|p| line(p, [p[0] + to[0], p[1] + to[1]])).collect();
        let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines);
        assert_eq!(all_agree(&arrangement, &some_points()), [0; 6], "{to:?}");
    }
}

#[test]
fn one_landmark_serves_all() {
    let mut pieces = Pieces::<SegmentTraits>::new();
    pieces.push_point(Point2::from_i64([2, 3]));
    let arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
    assert_eq!(all_agree(&arrangement, &some_points()), [1, 1, 1, 1, 1, 0]);
}

#[test]
fn a_star_is_crossed_from_its_middle() {
    let around = (-2..=2).flat_map(|x| (-2..=2).map(move |y| [x, y])).filter(|&end| end != [0, 0]);
    let spokes: Vec<[[i64; 2]; 2]> = around.map(|end| [[0, 0], end]).collect();
    all_agree(&segments_of(&spokes), &some_points());
}

/// Points that differ, but not as floats.
#[test]
fn landmarks_that_are_one_as_floats_are_one_landmark() {
    let shift = |i: i64| Rational::new(i.into(), 10_i64.pow(18).into()).unwrap();
    let billion = Rational::from(1_000_000_000);
    let points: Vec<Point2> =
        (0..300).map(|i| Point2::from_rationals(&[shift(i) + &billion, shift(i % 7) + &billion])).collect();
    let mut pieces = Pieces::<SegmentTraits>::new();
    for p in points.iter().step_by(2) {
        pieces.push_point(p.clone());
    }
    let first = Segment::new(points[0].clone(), points[299].clone()).unwrap();
    pieces.push_curve(first);
    let arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
    assert_eq!(Landmarks::new(&arrangement).count(), 1);
    all_agree(&arrangement, &points);
}

/// Coordinates beyond the floats are infinite, and quotients of such may be nothing.
#[test]
fn points_beyond_the_floats_are_located() {
    let huge = (0..11).fold(Rational::from(10), |value, _| &value * &value);
    let zero = Rational::from(0);
    assert!(huge.approx_f64().is_infinite());
    let corners = [[&zero, &zero], [&huge, &zero], [&huge, &huge], [&zero, &huge]]
        .map(|[x, y]| Point2::from_rationals(&[x.clone(), y.clone()]));
    let sides: Vec<Segment> =
        (0..4).map(|i| Segment::new(corners[i].clone(), corners[(i + 1) % 4].clone()).unwrap()).collect();
    let mut queries = some_points();
    let half = &huge * &quotient(1, 2);
    for x in [&half, &huge, &zero] {
        for y in [&half, &huge, &zero] {
            queries.extend(
                [[x.clone(), y.clone()], [-x.clone(), y.clone()]].map(|at| Point2::from_rationals(&at)),
            );
        }
    }
    let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &sides);
    assert_eq!(all_agree(&arrangement, &queries)[0], 1, "three corners are no landmarks");
    let far = Arrangement::of_curves(SegmentTraits, BoundedPlane, &sides[1..3]);
    assert_eq!(all_agree(&far, &queries)[0], 0);
}

#[test]
fn landmarks_of_another_state_are_stale() {
    let mut arrangement = segments_of(&[[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]]);
    let mut landmarks = Landmarks::with_generator(&arrangement, LandmarkGenerator::Grid { count: Some(9) });
    let p = Point2::from_i64([2, 1]);
    let stamp = landmarks.stamp();
    landmarks.renew(&arrangement);
    assert_eq!(landmarks.stamp(), stamp);
    arrangement.insert_points([p.clone()]);
    let stale = Err(Stale { stamp, of_arrangement: arrangement.stamp() });
    assert_eq!(landmarks.locate(&arrangement, &p), stale);
    assert_eq!(landmarks.shoot(&arrangement, &p, VerticalRay::Up), stale);
    landmarks.renew(&arrangement);
    assert!(matches!(landmarks.locate(&arrangement, &p), Ok(Cell::Vertex(_))));
    assert_eq!((landmarks.generator(), landmarks.count()), (LandmarkGenerator::Grid { count: Some(9) }, 9));
}

#[test]
fn as_observers_they_follow_edits() {
    for seed in 1..=3 {
        let mut numbers = Numbers::of_seed(seed);
        let Scene { curves, .. } = random_segments(&mut numbers, 8);
        let empty = Arrangement::new(SegmentTraits, BoundedPlane);
        let landmarks = Landmarks::with_generator(&empty, LandmarkGenerator::Halton { count: Some(20) });
        let mut editor = Editor::with_observers(empty, landmarks).unwrap();
        let queries = some_points();
        let check = |editor: &Editor<SegmentTraits, BoundedPlane, Landmarks>| {
            let cells = locate_by_sweep(editor.arrangement(), &queries);
            for (p, cell) in queries.iter().zip(cells) {
                let found = editor.observers().locate(editor.arrangement(), p);
                assert_eq!(found, Ok(cell), "seed {seed}, {p}");
            }
        };
        for curve in &curves {
            editor.insert_curve(curve);
            check(&editor);
        }
        for e in editor.arrangement().dcel().edges().collect::<Vec<_>>() {
            editor.remove_edge(e);
            check(&editor);
        }
        editor.insert_pieces(Pieces::of_curves(&SegmentTraits, &curves));
        check(&editor);
    }
}
