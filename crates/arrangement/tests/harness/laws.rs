//! The laws of each predicate by itself, on random points and curves, against formulas.

use crate::curves::{Curve, P, Shape};
use crate::family::Family;
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments};
use crate::oracle::{brute_force, crossing, has_point};
use crate::random::random_curves;
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::traits::{BasicTraits, CurveEnd, Intersection, Multiplicity, UMonotoneTraits};
use std::cmp::Ordering;
use testkit::Rng;

type CurveOf<M> = <<M as Family>::Traits as BasicTraits>::UMonotoneCurve;

/// A curve of a model, and what it is.
struct Known<M: Model> {
    curve: CurveOf<M>,
    /// The lesser and the greater end, `None` if there is none.
    ends: [Option<P>; 2],
    /// `None` if it is vertical.
    slope: Option<Rational>,
    source: Curve,
}

impl<M: Model> Known<M> {
    fn new(model: &M, source: &Curve) -> Option<Self> {
        let Curve::Straight(shape, [p, q]) = source else { return None };
        let pieces = model.pieces(std::slice::from_ref(source))?;
        assert_eq!(pieces.curves().len(), 1, "a straight curve is u-monotone: {source:?}");
        let slope = (&q[1] - &p[1]).checked_div(&(&q[0] - &p[0]));
        let [start, stop] = match shape {
            Shape::Segment => [Some(p.clone()), Some(q.clone())],
            Shape::Ray => [Some(p.clone()), None],
            Shape::Line => [None, None],
        };
        let ends = if p < q { [start, stop] } else { [stop, start] };
        Some(Self { curve: pieces.curves()[0].clone(), ends, slope, source: source.clone() })
    }

    fn is_in_u_range(&self, p: &P) -> bool {
        let Curve::Straight(_, [q, _]) = &self.source else { return false };
        match &self.slope {
            None => p[0] == q[0],
            Some(_) => {
                self.ends[0].as_ref().is_none_or(|min| min[0] <= p[0])
                    && self.ends[1].as_ref().is_none_or(|max| p[0] <= max[0])
            }
        }
    }

    /// Where a point in the u-range is.
    fn compare(&self, p: &P) -> Ordering {
        let Curve::Straight(_, [q, _]) = &self.source else { return Ordering::Equal };
        match &self.slope {
            Some(slope) => p[1].cmp(&(&q[1] + slope * (&p[0] - &q[0]))),
            None if self.ends[0].as_ref().is_some_and(|min| p < min) => Ordering::Less,
            None if self.ends[1].as_ref().is_some_and(|max| p > max) => Ordering::Greater,
            None => Ordering::Equal,
        }
    }

    /// Compares to the right of a common point: verticals are above.
    fn compare_right(&self, other: &Self) -> Ordering {
        match (&self.slope, &other.slope) {
            (Some(a), Some(b)) => a.cmp(b),
            (a, b) => b.is_some().cmp(&a.is_some()),
        }
    }

    /// Compares to the left: verticals are below.
    fn compare_left(&self, other: &Self) -> Ordering {
        match (&self.slope, &other.slope) {
            (Some(a), Some(b)) => b.cmp(a),
            (a, b) => a.is_some().cmp(&b.is_some()),
        }
    }

    /// What is in common with another curve.
    fn common(&self, other: &Self) -> Option<[Option<P>; 2]> {
        if let Some(p) = crossing(&self.source, &other.source) {
            return Some([Some(p.clone()), Some(p)]);
        }
        let Curve::Straight(_, [p, _]) = &other.source else { return None };
        let is_one_line = self.slope == other.slope && {
            let Curve::Straight(_, [q, r]) = &self.source else { return None };
            has_point(&Curve::Straight(Shape::Line, [q.clone(), r.clone()]), p)
        };
        if !is_one_line {
            return None;
        }
        // `None` is less than all points.
        let min = self.ends[0].clone().max(other.ends[0].clone());
        let max = match (&self.ends[1], &other.ends[1]) {
            (Some(a), Some(b)) => Some(a.min(b).clone()),
            (a, b) => a.clone().or(b.clone()),
        };
        let is_empty = min.as_ref().zip(max.as_ref()).is_some_and(|(min, max)| min > max);
        (!is_empty).then_some([min, max])
    }
}

fn ends_of<G: BasicTraits<Point = Point2>>(traits: &G, curve: &G::UMonotoneCurve) -> [Option<P>; 2] {
    CurveEnd::BOTH.map(|end| traits.end_point(curve, end).map(Point2::coordinates))
}

/// Models whose curves have no side keys: a chain has many pieces.
const WITHOUT_SIDE_KEYS: [&str; 2] = ["Polylines", "Polylinears"];

/// How often keys were asked, and told something: that of which they tell nothing passes every law.
#[derive(Default, Debug)]
struct Told {
    points: u32,
    known_ranges: u32,
    /// Pairs that ranges order.
    ordered_pairs: u32,
    /// Points above or below curves.
    sides: u32,
    known_sides: u32,
}

impl Told {
    fn check(&self, model: &str) {
        assert!(self.points > 0 && self.ordered_pairs > 0, "{model}: {self:?}");
        assert_eq!(self.known_ranges, self.points, "{model}: the coordinates are small");
        assert!(self.sides > 0, "{model}: {self:?}");
        // All are at a distance from the curves that is large compared with the error of a float.
        let expected = if WITHOUT_SIDE_KEYS.contains(&model) { 0 } else { self.sides };
        assert_eq!(self.known_sides, expected, "{model}: {self:?}");
    }
}

fn check_points(
    traits: &impl BasicTraits<Point = Point2>,
    points: &[(P, Point2)],
    told: &mut Told,
    context: &str,
) {
    // Of a crossing with u = 0, the box goes from negative to positive floats: too many.
    for (_, own) in points.iter().filter(|(p, _)| !p[0].is_zero()) {
        told.points += 1;
        told.known_ranges += u32::from(traits.order_range(own).1 != u32::MAX);
    }
    for (p, own_p) in points {
        for (q, own_q) in points {
            assert_eq!(traits.compare_uv(own_p, own_q), p.cmp(q), "{context}: {p:?} {q:?}");
            assert_eq!(traits.compare_u(own_p, own_q), p[0].cmp(&q[0]), "{context}: {p:?} {q:?}");
            assert_eq!(traits.is_same_point(own_p, own_q), p == q, "{context}: {p:?} {q:?}");
            let [(low, spread), (other, other_spread)] = [own_p, own_q].map(|p| traits.order_range(p));
            if spread != u32::MAX && other_spread != u32::MAX && other > low + u64::from(spread) {
                assert!(p[0] < q[0], "{context}: {p:?} {q:?}");
                told.ordered_pairs += 1;
            }
        }
    }
}

fn check_curve<M: Model>(
    model: &M,
    known: &Known<M>,
    points: &[(P, Point2)],
    told: &mut Told,
    context: &str,
) {
    let (traits, curve) = (model.traits(), &known.curve);
    assert_eq!(traits.is_vertical(curve), known.slope.is_none(), "{context}");
    assert_eq!(ends_of(&traits, curve), known.ends, "{context}");
    for (p, own) in points {
        let context = || format!("{context}: {p:?} and {:?}", known.source);
        assert_eq!(traits.is_on_curve(own, curve), has_point(&known.source, p), "{}", context());
        assert_eq!(traits.is_in_u_range(own, curve), known.is_in_u_range(p), "{}", context());
        if known.is_in_u_range(p) {
            assert_eq!(traits.compare_v_at_u(own, curve), known.compare(p), "{}", context());
            let by_key = traits.compare_v_at_u_by_key(own, &traits.side_key(curve));
            assert!(by_key.is_none_or(|order| order == known.compare(p)), "{}", context());
            // A vertical curve has no key.
            if known.slope.is_some() && known.compare(p).is_ne() {
                told.sides += 1;
                told.known_sides += u32::from(by_key.is_some());
            }
        }
        let is_inside = has_point(&known.source, p) && !known.ends.contains(&Some(p.clone()));
        if is_inside {
            let [lesser, greater] = traits.split(curve, own);
            assert_eq!(ends_of(&traits, &lesser), [known.ends[0].clone(), Some(p.clone())], "{}", context());
            assert_eq!(ends_of(&traits, &greater), [Some(p.clone()), known.ends[1].clone()], "{}", context());
            assert!(traits.is_mergeable(&lesser, &greater), "{}", context());
            let whole = traits.merge(&greater, &lesser).expect("the parts of a curve are one");
            assert_eq!(ends_of(&traits, &whole), known.ends, "{}", context());
            let trimmed = traits.trim(curve, Some(own), None);
            assert_eq!(ends_of(&traits, &trimmed), [Some(p.clone()), known.ends[1].clone()], "{}", context());
        }
    }
}

fn check_pair<M: Model>(model: &M, a: &Known<M>, b: &Known<M>, points: &[(P, Point2)], context: &str) {
    let traits = model.traits();
    let context = || format!("{context}: {:?} and {:?}", a.source, b.source);
    let mut found = Vec::new();
    traits.intersect(&a.curve, &b.curve, &mut found);
    let expected: Vec<[Option<P>; 2]> = a.common(b).into_iter().collect();
    let found: Vec<[Option<P>; 2]> = found
        .iter()
        .map(|intersection| match intersection {
            Intersection::Point(p, multiplicity) => {
                assert_ne!(*multiplicity, Multiplicity::Even, "{}", context());
                [Some(p.coordinates()), Some(p.coordinates())]
            }
            Intersection::Overlap(curve) => ends_of(&traits, curve),
        })
        .collect();
    assert_eq!(found, expected, "{}", context());
    for (p, own) in points {
        if !has_point(&a.source, p) || !has_point(&b.source, p) {
            continue;
        }
        let is_end = |end: usize| a.ends[end].as_ref() == Some(p) || b.ends[end].as_ref() == Some(p);
        if !is_end(1) {
            let right = traits.compare_v_at_u_right(&a.curve, &b.curve, own);
            assert_eq!(right, a.compare_right(b), "right of {p:?}, {}", context());
        }
        if !is_end(0) {
            let left = traits.compare_v_at_u_left(&a.curve, &b.curve, own);
            assert_eq!(left, a.compare_left(b), "left of {p:?}, {}", context());
        }
    }
}

fn run<M: Model>(model: &M, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(99);
    let mut pairs = 0;
    let mut told = Told::default();
    for _ in 0..cases {
        let context = format!("{model:?}, seed {}", rng.state());
        let curves = random_curves(&mut rng, 6, 5, are_bounded);
        let known: Vec<Known<M>> = curves.iter().filter_map(|curve| Known::new(model, curve)).collect();
        let mut points: Vec<(P, Point2)> = Vec::new();
        // As they are given, and as crossings of lines.
        let vertices = brute_force(&curves).vertices;
        points.extend(vertices.into_iter().map(|p| (p.clone(), Point2::from_rationals(&p))));
        for (i, a) in known.iter().enumerate() {
            for b in &known[..i] {
                let mut common = Vec::new();
                model.traits().intersect(&a.curve, &b.curve, &mut common);
                points.extend(common.into_iter().filter_map(|intersection| match intersection {
                    Intersection::Point(p, _) => Some((p.coordinates(), p)),
                    Intersection::Overlap(_) => None,
                }));
            }
        }
        check_points(&model.traits(), &points, &mut told, &context);
        for a in &known {
            check_curve(model, a, &points, &mut told, &context);
            for b in &known {
                check_pair(model, a, b, &points, &context);
                pairs += 1;
            }
        }
    }
    assert!(pairs > cases, "{pairs} pairs");
    told.check(&format!("{model:?}"));
}

test_models! {
    segments: Segments, 300, true;
    minimal_segments: MinimalSegments, 100, true;
    linear_curves: Linears, 400, false;
    polylines: Polylines, 150, true;
    polycurves_of_linear_curves: Polylinears, 200, false;
    segments_with_data: Numbered, 60, true;
}
