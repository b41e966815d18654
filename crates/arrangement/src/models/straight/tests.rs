//! Tables of degenerate cases, run by every model of straight curves.

use crate::models::{LinearTraits, MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits};
use crate::traits::{
    ApproxTraits, ArrangementTraits, BasicTraits, CurveEnd, DirectionalTraits, Intersection, Meeting,
    Multiplicity, Piece, UMonotoneTraits, Window,
};
use exact::planar::Point2;
use std::cmp::Ordering::{self, Equal, Greater, Less};

type Ends = [[i64; 2]; 2];

fn point(p: [i64; 2]) -> Point2 {
    Point2::from_i64(p)
}

/// Runs a test on every model that has segments.
macro_rules! on_segments {
    ($($name:ident => $run:ident;)*) => {$(
        #[test]
        fn $name() {
            $run(&SegmentTraits, |ends| Segment::from_i64(ends).unwrap());
            $run(&MinimalSegmentTraits, |ends| MinimalSegment::from_i64(ends).unwrap());
            $run(&LinearTraits, |ends| Segment::from_i64(ends).unwrap().into());
        }
    )*};
}

on_segments! {
    heights_at_a_point => heights;
    order_right_and_left_of_a_point => orders;
    what_segments_have_in_common => intersections;
    where_neighbours_meet => meetings;
    cutting_and_joining => cuts;
    directions => directed;
}

const HEIGHTS: [(Ends, [i64; 2], Ordering); 13] = [
    ([[0, 0], [4, 2]], [2, 0], Less),
    ([[0, 0], [4, 2]], [2, 1], Equal),
    ([[0, 0], [4, 2]], [2, 2], Greater),
    ([[4, 2], [0, 0]], [2, 2], Greater),
    ([[0, 0], [4, 2]], [0, 0], Equal),
    ([[0, 0], [4, 2]], [4, 2], Equal),
    ([[0, 5], [4, 5]], [3, 4], Less),
    ([[3, 1], [3, 4]], [3, 0], Less),
    ([[3, 1], [3, 4]], [3, 1], Equal),
    ([[3, 1], [3, 4]], [3, 2], Equal),
    ([[3, 4], [3, 1]], [3, 4], Equal),
    ([[3, 1], [3, 4]], [3, 5], Greater),
    ([[i64::MIN, i64::MIN], [i64::MAX, i64::MAX]], [7, 6], Less),
];

fn heights<G: UMonotoneTraits<Point = Point2>>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve) {
    for (ends, p, expected) in HEIGHTS {
        let (curve, p) = (curve(ends), point(p));
        assert_eq!(traits.compare_v_at_u(&p, &curve), expected, "{p:?} {curve:?}");
        assert!(traits.is_in_u_range(&p, &curve));
        assert_eq!(traits.is_on_curve(&p, &curve), expected == Equal);
        assert_eq!(traits.is_vertical(&curve), ends[0][0] == ends[1][0]);
        if traits.is_on_curve(&p, &curve)
            && !ends.contains(&[p.approx_f64()[0] as i64, p.approx_f64()[1] as i64])
        {
            // Splitting changes no answer.
            for part in traits.split(&curve, &p) {
                assert_eq!(traits.compare_v_at_u(&p, &part), Equal);
            }
        }
        let outside = point([100, 0]);
        assert!(
            ends[1][0] > 100
                || !traits.is_in_u_range(&outside, &curve) && !traits.is_on_curve(&outside, &curve)
        );
    }
}

/// Two segments that begin (or end) in the origin, and their order away from it.
const ORDERS: [([i64; 2], [i64; 2], Ordering); 9] = [
    ([3, 1], [2, 1], Less),
    ([3, 1], [6, 2], Equal),
    ([3, 0], [5, 0], Equal),
    ([1, -5], [1, 5], Less),
    ([0, 1], [1, 1_000_000], Greater),
    ([0, 1], [0, 7], Equal),
    ([1, i64::MAX], [0, 1], Less),
    ([i64::MAX, i64::MAX - 1], [i64::MAX - 1, i64::MAX - 2], Greater),
    ([2, -1], [1, 0], Less),
];

fn orders<G: UMonotoneTraits<Point = Point2>>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve) {
    let origin = point([0, 0]);
    for (a, b, expected) in ORDERS {
        let right = [curve([[0, 0], a]), curve([b, [0, 0]])];
        assert_eq!(traits.compare_v_at_u_right(&right[0], &right[1], &origin), expected, "{right:?}");
        assert_eq!(
            traits.compare_v_at_u_right(&right[1], &right[0], &origin),
            expected.reverse(),
            "{right:?}"
        );
        let left = [a, b].map(|[x, y]| curve([[-x, -y], [0, 0]]));
        // A half turn exchanges up and down; but a vertical curve is below on the left as it is above on the right.
        let expected = expected.reverse();
        assert_eq!(traits.compare_v_at_u_left(&left[0], &left[1], &origin), expected, "{left:?}");
        assert_eq!(traits.compare_v_at_u_left(&left[1], &left[0], &origin), expected.reverse(), "{left:?}");
    }
}

const INTERSECTIONS: [(Ends, Ends, &str); 20] = [
    ([[0, 0], [2, 2]], [[0, 2], [2, 0]], "(1, 1) Odd"),
    ([[0, 0], [3, 1]], [[0, 1], [3, 0]], "(3/2, 1/2) Odd"),
    ([[0, 0], [2, 2]], [[2, 2], [4, 0]], "(2, 2) Unknown"),
    ([[0, 0], [4, 0]], [[2, 0], [2, 3]], "(2, 0) Unknown"),
    ([[0, 0], [4, 0]], [[2, 1], [2, 3]], ""),
    ([[0, 0], [4, 0]], [[2, -1], [2, 3]], "(2, 0) Odd"),
    ([[0, 0], [1, 1]], [[3, 0], [0, 3]], ""),
    ([[0, 0], [2, 0]], [[0, 1], [2, 1]], ""),
    ([[0, 0], [2, 0]], [[3, 0], [4, 0]], ""),
    ([[0, 0], [2, 0]], [[2, 0], [4, 0]], "(2, 0) Unknown"),
    ([[0, 0], [3, 0]], [[2, 0], [4, 0]], "(2, 0)-(3, 0)"),
    ([[0, 0], [9, 0]], [[4, 0], [2, 0]], "(2, 0)-(4, 0)"),
    ([[0, 0], [3, 3]], [[0, 0], [3, 3]], "(0, 0)-(3, 3)"),
    ([[0, 0], [3, 3]], [[3, 3], [0, 0]], "(0, 0)-(3, 3)"),
    ([[1, 0], [1, 5]], [[1, 9], [1, 4]], "(1, 4)-(1, 5)"),
    ([[1, 0], [1, 5]], [[1, 9], [1, 5]], "(1, 5) Unknown"),
    ([[1, 0], [1, 5]], [[2, 0], [2, 5]], ""),
    ([[0, 0], [6, 3]], [[2, 1], [8, 4]], "(2, 1)-(6, 3)"),
    ([[0, 0], [6, 3]], [[2, 1], [2, 4]], "(2, 1) Unknown"),
    (
        [[i64::MIN, i64::MIN], [i64::MAX, i64::MAX]],
        [[i64::MIN, i64::MAX], [i64::MAX, i64::MIN]],
        "(-1/2, -1/2) Odd",
    ),
];

pub(in crate::models) fn show<G: BasicTraits<Point = Point2>>(
    traits: &G,
    common: &[Intersection<Point2, G::UMonotoneCurve>],
) -> String {
    let one = |common: &Intersection<Point2, G::UMonotoneCurve>| match common {
        Intersection::Point(p, multiplicity) => format!("{p} {multiplicity:?}"),
        Intersection::Overlap(curve) => CurveEnd::BOTH
            .map(|end| traits.end_point(curve, end).map_or("..".to_owned(), ToString::to_string))
            .join("-"),
    };
    common.iter().map(one).collect::<Vec<_>>().join(" ")
}

fn intersections<G: UMonotoneTraits<Point = Point2>>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve) {
    for (a, b, expected) in INTERSECTIONS {
        let turn = |[p, q]: Ends| curve([q, p]);
        for [a, b] in [[curve(a), curve(b)], [curve(b), curve(a)], [turn(a), turn(b)]] {
            let mut common = Vec::new();
            traits.intersect(&a, &b, &mut common);
            assert_eq!(show(traits, &common), expected, "{a:?} {b:?}");
        }
    }
}

const MEETINGS: [(Ends, Ends, &str); 9] = [
    ([[0, 0], [4, 4]], [[0, 2], [4, 2]], "(2, 2)"),
    ([[0, 0], [2, 2]], [[0, 2], [4, 2]], "end"),
    ([[0, 0], [1, 1]], [[0, 2], [4, 2]], "never"),
    ([[0, 0], [9, 1]], [[0, 2], [4, 0]], "(36/11, 4/11)"),
    ([[0, 0], [9, 0]], [[0, 2], [4, 0]], "end"),
    ([[0, 0], [9, 0]], [[0, 2], [4, 1]], "never"),
    ([[0, 0], [0, 4]], [[-1, 1], [1, 1]], "(0, 1)"),
    ([[0, 0], [0, 1]], [[-1, 1], [1, 1]], "end"),
    ([[-1, -1], [1, 1]], [[0, 0], [0, 5]], "never"),
];

fn meetings<G: UMonotoneTraits<Point = Point2>>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve) {
    for (below, above, expected) in MEETINGS {
        let curves = [curve(below), curve(above)];
        let ends = curves.each_ref().map(|curve| traits.end_point(curve, CurveEnd::Max).unwrap());
        let starts = curves.each_ref().map(|curve| traits.end_point(curve, CurveEnd::Min).unwrap());
        let first_to_end = usize::from(ends[1] < ends[0]);
        let window =
            Window { after: Some(starts[0].max(starts[1])), until: Some(ends[first_to_end]), first_to_end };
        let found = match traits.next_meeting(&curves[0], &curves[1], window) {
            Meeting::Never => "never".to_owned(),
            Meeting::At(p, multiplicity) => {
                assert_eq!(multiplicity, Multiplicity::Odd);
                p.to_string()
            }
            Meeting::AtEnd => "end".to_owned(),
        };
        assert_eq!(found, expected, "{curves:?}");
    }
}

fn cuts<G: UMonotoneTraits<Point = Point2>>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve) {
    for (ends, p) in [([[0, 0], [6, 3]], [2, 1]), ([[5, 9], [5, 0]], [5, 1]), ([[4, 0], [0, 0]], [1, 0])] {
        let (whole, p) = (curve(ends), point(p));
        let [min, max] = CurveEnd::BOTH.map(|end| traits.end_point(&whole, end));
        let parts = traits.split(&whole, &p);
        assert_eq!(CurveEnd::BOTH.map(|end| traits.end_point(&parts[0], end)), [min, Some(&p)]);
        assert_eq!(CurveEnd::BOTH.map(|end| traits.end_point(&parts[1], end)), [Some(&p), max]);
        for [a, b] in [[0, 1], [1, 0]] {
            assert!(traits.is_mergeable(&parts[a], &parts[b]));
            let merged = traits.merge(&parts[a], &parts[b]).unwrap();
            assert_eq!(CurveEnd::BOTH.map(|end| traits.end_point(&merged, end)), [min, max]);
        }
        let same = traits.trim(&whole, min, max);
        assert_eq!(CurveEnd::BOTH.map(|end| traits.end_point(&same, end)), [min, max]);
        let part = traits.trim(&whole, Some(&p), None);
        assert_eq!(CurveEnd::BOTH.map(|end| traits.end_point(&part, end)), [Some(&p), max]);
    }
    for (a, b) in [
        ([[0, 0], [1, 1]], [[1, 1], [2, 3]]),
        ([[0, 0], [1, 1]], [[2, 2], [3, 3]]),
        ([[0, 0], [2, 2]], [[1, 1], [3, 3]]),
    ] {
        let (a, b) = (curve(a), curve(b));
        assert!(!traits.is_mergeable(&a, &b) && traits.merge(&a, &b).is_none());
    }
}

fn directed<G>(traits: &G, curve: impl Fn(Ends) -> G::UMonotoneCurve)
where
    G: ArrangementTraits<Point = Point2, Curve = <G as BasicTraits>::UMonotoneCurve>
        + DirectionalTraits
        + ApproxTraits,
{
    for (ends, is_right) in [
        ([[0, 0], [1, 0]], true),
        ([[1, 0], [0, 9]], false),
        ([[2, 2], [2, 3]], true),
        ([[2, 3], [2, 2]], false),
    ] {
        let curve = curve(ends);
        assert_eq!(traits.is_directed_right(&curve), is_right);
        assert_eq!(traits.source(&curve), Some(&point(ends[0])));
        assert_eq!(traits.target(&traits.opposite(&curve)), Some(&point(ends[0])));
        assert_eq!(traits.is_directed_right(&traits.split(&curve, &point(ends[0]))[0]), is_right);
        let mut pieces = Vec::new();
        traits.make_u_monotone(&curve, &mut pieces);
        let [Piece::Curve { curve: piece, is_artificial: [false, false] }] = &pieces[..] else {
            panic!("one piece with real ends")
        };
        assert_eq!(traits.source(piece), Some(&point(ends[0])));
        let mut floats = Vec::new();
        traits.approx_curve(&curve, None, None, [0.0; 4], &mut floats);
        assert_eq!(
            floats,
            CurveEnd::BOTH.map(|end| traits.approx_point(traits.end_point(&curve, end).unwrap()))
        );
    }
}
