//! Wrappers: they forward every method, and add what they promise.

#![allow(clippy::unwrap_used)]

#[path = "../common/rational_segments.rs"]
mod rational_segments;

mod everything;

use everything::{Everything, Line, call_each};
use rational_segments::{RationalSegments, point, segment};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::polycurve::{ConnectTraits, PolycurveTraits};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, CurveEnd, DirectionalTraits, Intersection, Piece, UMonotoneTraits,
};
use splitstar_arrangement::wrappers::{
    Call, ConsolidatedTraits, CountingTraits, CurveDataTraits, DataSet, Method, RuleOf, TracingTraits,
    WithData,
};
use std::sync::Mutex;

const A: Line = Line([1, 2]);
const B: Line = Line([2, 3]);

fn plain_answers() -> Vec<String> {
    call_each(&Everything, &5, &A, &B, |curve| format!("{curve:?}"))
}

#[test]
fn every_method_is_counted_once() {
    let traits = CountingTraits::new(Everything);
    assert_eq!(traits.counters().total(), 0);
    assert_eq!(call_each(&traits, &5, &A, &B, |curve| format!("{curve:?}")), plain_answers());
    traits.connect(&1, &2, &mut Vec::new());
    for &method in Method::ALL {
        assert_eq!(traits.counters().count(method), 1, "{method}");
    }
    assert_eq!(traits.counters().iter().count(), Method::ALL.len());
    traits.counters().reset();
    assert_eq!(traits.counters().total(), 0);
}

#[test]
fn every_method_is_counted_through_data() {
    let traits = CurveDataTraits::new(CountingTraits::new(Everything));
    let [a, b] = [A, B].map(|curve| WithData::new(curve, 'x'));
    let curve = WithData::new(5, 'y');
    let answers = call_each(&traits, &curve, &a, &b, |curve| format!("{:?}", curve.curve));
    assert_eq!(answers, plain_answers());
    for &method in Method::ALL {
        let expected = u64::from(method != Method::Connect);
        assert_eq!(traits.inner().counters().count(method), expected, "{method}");
    }
}

#[test]
fn a_trace_has_each_call_with_arguments_and_answer() {
    let lines = Mutex::new(Vec::new());
    let sink = |call: &Call<'_>| lines.lock().unwrap().push(call.to_string());
    let traits = TracingTraits::new(Everything, sink);
    assert_eq!(call_each(&traits, &5, &A, &B, |curve| format!("{curve:?}")), plain_answers());
    let lines = lines.into_inner().unwrap();
    assert_eq!(lines.len(), Method::ALL.len() - 1);
    for line in [
        "compare_u(1, 2) = Less",
        "order_key(3) = 3",
        "end_point(Line([1, 2]), Max) = Some(2)",
        "split(Line([1, 2]), 5) = [Line([1, 5]), Line([5, 2])]",
        "intersect(Line([1, 2]), Line([2, 3])) = [Point(7, Even), Overlap(Line([1, 2]))]",
        "next_meeting(Line([1, 2]), Line([2, 3]), Window { after: Some(1), until: Some(6), first_to_end: 1 }) \
         = At(106, Even)",
        "end_of_overlap(Line([1, 2]), Line([2, 3]), Some(1)) = Some(202)",
        "make_u_monotone(_) = [Curve { curve: Line([5, 9]), is_artificial: [true, false] }, Point(5)]",
        "approx_curve(Line([1, 2]), None, Some(2), [1.0, 2.0, 3.0, 4.0]) = [[1.0, 4.0]]",
        "compare_u_of_ends((Line([1, 2]), Min), (Line([2, 3]), Max)) = Less",
    ] {
        assert!(lines.iter().any(|traced| traced == line), "{line} is not in {lines:#?}");
    }
}

#[test]
fn data_goes_where_the_curve_goes() {
    let traits = CurveDataTraits::new(RationalSegments);
    let [a, b] =
        [([0, 0], [4, 0], "a"), ([2, 0], [6, 0], "b")].map(|(p, q, data)| WithData::new(segment(p, q), data));
    let halves = traits.split(&a, &point([1, 0]));
    assert_eq!(halves.each_ref().map(|half| half.data), ["a", "a"]);
    assert_eq!(traits.merge(&halves[0], &halves[1]), Some(a.clone()));
    let [_, other] = traits.split(&WithData::new(a.curve.clone(), "b"), &point([1, 0]));
    assert!(!traits.is_mergeable(&halves[0], &other) && traits.merge(&halves[0], &other).is_none());
    assert_eq!(traits.trim(&a, Some(&point([1, 0])), None).data, "a");
    let mut common = Vec::new();
    traits.intersect(&b, &a, &mut common);
    let overlap = WithData::new(segment([2, 0], [4, 0]), "b");
    assert_eq!(common, [Intersection::Overlap(overlap)], "the data of the first");
    let mut pieces = Vec::new();
    traits.make_u_monotone(&a, &mut pieces);
    assert_eq!(pieces, [Piece::Curve { curve: a, is_artificial: [false; 2] }]);

    let lines = CurveDataTraits::new(PolycurveTraits::new(RationalSegments));
    let polyline = lines.inner().make_polyline([[0, 0], [2, 2], [1, 5]].map(point)).unwrap();
    let mut pieces = Vec::new();
    lines.make_u_monotone(&WithData::new(polyline, 17), &mut pieces);
    let mut turned = 0;
    for piece in &pieces {
        let Piece::Curve { curve, .. } = piece else { panic!("no point is on its own") };
        assert_eq!(curve.data, 17);
        assert_eq!(lines.opposite(curve).data, 17);
        turned += usize::from(!lines.is_directed_right(curve));
    }
    assert_eq!((pieces.len(), turned), (2, 1));
}

#[test]
fn data_follow_the_rule_of_the_user() {
    let rule = RuleOf { overlap: |a: &u32, b: &u32| a + b, merge: |a: &u32, b: &u32| Some(*a.max(b)) };
    let traits = CurveDataTraits::with_rule(RationalSegments, rule);
    let [a, b, c] = [([0, 0], [4, 0], 1), ([2, 0], [6, 0], 2), ([4, 0], [5, 0], 4)]
        .map(|(p, q, data)| WithData::new(segment(p, q), data));
    let mut common = Vec::new();
    traits.intersect(&a, &b, &mut common);
    assert_eq!(common, [Intersection::Overlap(WithData::new(segment([2, 0], [4, 0]), 3))]);
    assert!(traits.is_mergeable(&a, &c));
    assert_eq!(traits.merge(&a, &c), Some(WithData::new(segment([0, 0], [5, 0]), 4)));
}

#[test]
fn sets_of_data_unite_where_curves_overlap() {
    let set = |elements: &[i32]| elements.iter().copied().collect::<DataSet<i32>>();
    assert_eq!(set(&[3, 1, 3]).iter().collect::<Vec<_>>(), [&1, &3]);
    assert_eq!(set(&[1, 3]).union(&set(&[2, 3, 9])), set(&[1, 2, 3, 9]));
    assert_eq!(set(&[1, 3]).union(&set(&[])), set(&[1, 3]));
    assert_eq!(set(&[3]).union(&set(&[1, 3])), set(&[1, 3]));
    assert!(set(&[1, 3]).has(&3) && !set(&[1, 3]).has(&2) && set(&[]).is_empty());
    assert_eq!(format!("{:?}", DataSet::single('x')), "{'x'}");

    let traits = ConsolidatedTraits::consolidated(RationalSegments);
    let curves = [([0, 0], [4, 0], 1), ([2, 0], [6, 0], 2), ([3, 0], [5, 0], 2)]
        .map(|(p, q, data)| WithData::new(segment(p, q), DataSet::single(data)));
    let mut common = Vec::new();
    traits.intersect(&curves[0], &curves[1], &mut common);
    assert_eq!(common, [Intersection::Overlap(WithData::new(segment([2, 0], [4, 0]), set(&[1, 2])))]);
    let [left, right] = traits.split(&curves[1], &point([4, 0]));
    assert!(traits.is_mergeable(&left, &right));
    assert!(!traits.is_mergeable(&WithData::new(left.curve, set(&[1, 2])), &right));
}

/// The sets of all edges, each as a text of its ends and the set, in order.
fn edges<G, D: Ord + Clone + std::fmt::Debug + Send + Sync>(
    arrangement: &Arrangement<ConsolidatedTraits<G, D>, BoundedPlane>,
) -> Vec<String>
where
    G: splitstar_arrangement::traits::BoundedTraits + UMonotoneTraits,
{
    let mut edges: Vec<String> = arrangement
        .dcel()
        .edges()
        .map(|e| {
            let edge = arrangement.make_edge_curve(e);
            let end = |end| arrangement.traits().end_point(&edge, end).unwrap();
            format!("{:?} {:?} {:?}", end(CurveEnd::Min), end(CurveEnd::Max), edge.data)
        })
        .collect();
    edges.sort();
    edges
}

#[test]
fn edges_know_all_their_curves() {
    let traits = ConsolidatedTraits::consolidated(RationalSegments);
    let curves = [([0, 0], [4, 0], 1), ([2, 0], [6, 0], 2), ([3, 0], [5, 0], 3), ([1, 0], [1, 5], 4)]
        .map(|(p, q, data)| WithData::new(segment(p, q), DataSet::single(data)));
    let arrangement = Arrangement::of_curves(traits, BoundedPlane, &curves);
    let expected = [
        "(0, 0) (1, 0) {1}",
        "(1, 0) (1, 5) {4}",
        "(1, 0) (2, 0) {1}",
        "(2, 0) (3, 0) {1, 2}",
        "(3, 0) (4, 0) {1, 2, 3}",
        "(4, 0) (5, 0) {2, 3}",
        "(5, 0) (6, 0) {2}",
    ];
    assert_eq!(edges(&arrangement), expected);

    let traits = ConsolidatedTraits::consolidated(PolycurveTraits::new(RationalSegments));
    let polyline = |vertices: &[[i64; 2]], data| {
        let curve = PolycurveTraits::new(RationalSegments)
            .make_polyline(vertices.iter().copied().map(point))
            .unwrap();
        WithData::new(curve, DataSet::single(data))
    };
    let curves =
        [polyline(&[[0, 0], [2, 2], [4, 0], [6, 0]], 'a'), polyline(&[[1, 1], [2, 2], [3, 1], [6, 9]], 'b')];
    let arrangement = Arrangement::of_curves(traits, BoundedPlane, &curves);
    let expected =
        ["(0, 0) (1, 1) {'a'}", "(1, 1) (3, 1) {'a', 'b'}", "(3, 1) (6, 0) {'a'}", "(3, 1) (6, 9) {'b'}"];
    assert_eq!(edges(&arrangement), expected);
}
