//! The sweep over paths on a torus, against crossings in the universal cover.

use crate::watcher::{Counts, swept};
use exact::planar::Point2;
use exact::{Rational, Sign};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::{TorusPath, TorusSegment, TorusSegmentTraits};
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::{
    Along, ArrangementTraits, BasicTraits, CurveEnd, DirectionalTraits, Intersection, Piece, UMonotoneTraits,
};
use std::collections::BTreeSet;
use testkit::Rng;

type Pair = [Rational; 2];

fn sum(p: &Pair, q: &Pair) -> Pair {
    [&p[0] + &q[0], &p[1] + &q[1]]
}

fn difference(p: &Pair, q: &Pair) -> Pair {
    [&p[0] - &q[0], &p[1] - &q[1]]
}

fn cross(p: &Pair, q: &Pair) -> Rational {
    &p[0] * &q[1] - &p[1] * &q[0]
}

fn divided(p: &Rational, q: &Rational) -> Rational {
    p.checked_div(q).expect("not divided by zero")
}

/// The point at a time along a path.
fn at(start: &Pair, way: &Pair, time: &Rational) -> Pair {
    [0, 1].map(|i| &start[i] + &way[i] * time)
}

fn reduced(p: &Pair, period: &Pair) -> Pair {
    [0, 1].map(|i| &p[i] - Rational::from(divided(&p[i], &period[i]).floor()) * &period[i])
}

/// All multiples of the period, as numbers of periods, between two numbers and one more on either side.
fn multiples(from: &Rational, to: &Rational, period: &Rational) -> Vec<i64> {
    let [low, high] = if from <= to { [from, to] } else { [to, from] };
    let number = |value: &Rational| divided(value, period).floor().to_i64().expect("a small number");
    (number(low) - 1..=number(high) + 1).collect()
}

/// Every point of the torus that has to be an event: ends, crossings, and where paths meet sides.
fn points_by_cover(paths: &[TorusPath], points: &[Point2], period: &Pair) -> BTreeSet<Pair> {
    let unit = |time: &Rational| time.sign() != Sign::Negative && *time <= Rational::ONE;
    let mut all: BTreeSet<Pair> = points.iter().map(|p| reduced(&p.coordinates(), period)).collect();
    for (i, path) in paths.iter().enumerate() {
        let (start, way) = (path.start().coordinates(), path.displacement().clone());
        let end = sum(&start, &way);
        all.extend([&start, &end].map(|p| reduced(p, period)));
        for axis in 0..2 {
            if way[axis].is_zero() {
                continue;
            }
            for k in multiples(&start[axis], &end[axis], &period[axis]) {
                let time = divided(&(Rational::from(k) * &period[axis] - &start[axis]), &way[axis]);
                if unit(&time) {
                    all.insert(reduced(&at(&start, &way, &time), period));
                }
            }
        }
        for other in &paths[..i] {
            let (other_start, other_way) = (other.start().coordinates(), other.displacement().clone());
            let w = cross(&way, &other_way);
            if w.is_zero() {
                continue;
            }
            // A copy of the other path comes near only if its box does.
            let steps = |axis: usize| {
                let [low, high] =
                    [start[axis].clone().min(end[axis].clone()), start[axis].clone().max(end[axis].clone())];
                let reach = other_way[axis].abs();
                multiples(
                    &(low - &other_start[axis] - &reach),
                    &(high - &other_start[axis] + &reach),
                    &period[axis],
                )
            };
            for k in steps(0) {
                for l in steps(1) {
                    let step = [Rational::from(k) * &period[0], Rational::from(l) * &period[1]];
                    let between = difference(&sum(&other_start, &step), &start);
                    let (time, other_time) =
                        (divided(&cross(&between, &other_way), &w), divided(&cross(&between, &way), &w));
                    if unit(&time) && unit(&other_time) {
                        all.insert(reduced(&at(&start, &way, &time), period));
                    }
                }
            }
        }
    }
    all
}

/// The places of a point in the closed rectangle.
fn places(p: &Pair, period: &Pair) -> Vec<Pair> {
    let images = |i: usize| {
        let far = p[i].is_zero().then(|| period[i].clone());
        std::iter::once(p[i].clone()).chain(far).collect::<Vec<_>>()
    };
    let vs = images(1);
    images(0).into_iter().flat_map(|u| vs.iter().map(move |v| [u.clone(), v.clone()])).collect()
}

fn counts_by_cover(all: &BTreeSet<Pair>, curves: &[TorusSegment], period: &Pair) -> Counts {
    let all: Vec<Pair> = all.iter().flat_map(|p| places(p, period)).collect();
    let mut strands = BTreeSet::new();
    let mut members = 0;
    for curve in curves {
        let [min, max] = CurveEnd::BOTH.map(|end| curve.place(end).coordinates());
        let way = difference(&max, &min);
        let mut on: Vec<&Pair> = all
            .iter()
            .filter(|p| min <= **p && **p <= max && cross(&difference(p, &min), &way).is_zero())
            .collect();
        on.sort();
        members += on.len() - 1;
        strands.extend(on.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]));
    }
    Counts { points: all.len(), strands: strands.len(), members }
}

/// Cuts paths, and checks that the pieces make up the path, lie in the rectangle and never along its right or top side.
fn cut(
    traits: &TorusSegmentTraits,
    paths: &[TorusPath],
    curves: &mut Vec<TorusSegment>,
    points: &mut Vec<Point2>,
) {
    let [width, height] = traits.period().clone();
    for path in paths {
        let mut pieces = Vec::new();
        traits.make_u_monotone(path, &mut pieces);
        let mut rest = path.displacement().clone();
        let last = pieces.len() - 1;
        let mut joint = path.start();
        for (i, piece) in pieces.into_iter().enumerate() {
            let (curve, is_artificial) = match piece {
                Piece::Curve { curve, is_artificial } => (curve, is_artificial),
                Piece::Point(p) => {
                    points.push(p);
                    continue;
                }
            };
            let [min, max] = CurveEnd::BOTH.map(|end| curve.place(end).coordinates());
            let is_right = traits.is_directed_right(&curve);
            rest = if is_right {
                difference(&rest, &difference(&max, &min))
            } else {
                difference(&rest, &difference(&min, &max))
            };
            assert_eq!(traits.source(&curve), Some(&joint));
            joint = traits.target(&curve).expect("a curve on a torus has two ends").clone();
            let ends = if is_right { is_artificial } else { [is_artificial[1], is_artificial[0]] };
            assert_eq!(ends, [i > 0 || path.is_closed(), i < last || path.is_closed()]);
            for p in [&min, &max] {
                assert!(
                    !p.iter().any(|value| value.sign() == Sign::Negative) && p[0] <= width && p[1] <= height
                );
            }
            assert!(min[0] < width && (min[1] < height || max[1] < height), "{curve:?}");
            for end in CurveEnd::BOTH {
                assert!(traits.is_on_curve(curve.point(end), &curve));
                assert_eq!(curve.location(end).u == Along::High, curve.place(end).coordinates()[0] == width);
            }
            curves.push(curve);
        }
        assert!(rest.iter().all(Rational::is_zero), "the pieces make up the path");
    }
}

/// Ends, and what pairs of pieces have in common.
fn points_by_pairs(
    traits: &TorusSegmentTraits,
    curves: &[TorusSegment],
    points: &[Point2],
) -> BTreeSet<Pair> {
    let mut all = points.to_vec();
    for (i, a) in curves.iter().enumerate() {
        all.extend(CurveEnd::BOTH.map(|end| a.point(end).clone()));
        for b in &curves[..i] {
            let mut common = Vec::new();
            traits.intersect(a, b, &mut common);
            all.extend(common.into_iter().filter_map(|common| match common {
                Intersection::Point(p, _) => Some(p),
                Intersection::Overlap(_) => None,
            }));
        }
    }
    all.iter().map(Point2::coordinates).collect()
}

fn random_path(traits: &TorusSegmentTraits, rng: &mut Rng, size: i64, reach: i64) -> TorusPath {
    let start = Point2::from_i64([rng.within(2 * size), rng.within(2 * size)]);
    if rng.one_in(4) {
        let winding = [rng.within(reach.min(3)), rng.within(reach.min(3))];
        return traits.closed_path(&start, winding).expect("a short path");
    }
    let mut way = [rng.within(reach * size), rng.within(reach * size)];
    match rng.index(8) {
        0 => way[0] = 0,
        1 => way[1] = 0,
        2 => way = [way[0], way[0]],
        _ => {}
    }
    traits.path(&start, &way.map(Rational::from)).expect("a short path")
}

#[test]
fn paths_on_a_torus_as_in_the_universal_cover() {
    for (number, (size, reach)) in
        [(1, 1), (1, 3), (2, 2), (4, 1), (4, 3), (9, 2), (100, 2)].into_iter().enumerate()
    {
        for round in 0..60 {
            let seed = (number as u64) << 32 | round;
            let mut rng = Rng::new(seed);
            let period = if round % 3 == 2 {
                [Rational::new((2 * size + 1).into(), 2.into()).unwrap(), size.into()]
            } else {
                [size.into(), (size + (round as i64) % 2).into()]
            };
            let traits = TorusSegmentTraits::new(period.clone()).unwrap();
            let count = 1 + rng.index(if round < 30 { 2 } else { 6 });
            let paths: Vec<_> = (0..count).map(|_| random_path(&traits, &mut rng, size, reach)).collect();
            let mut points: Vec<_> = (0..rng.index(3))
                .map(|_| traits.point(&Point2::from_i64([rng.within(size), rng.within(size)])))
                .collect();
            let mut curves = Vec::new();
            cut(&traits, &paths, &mut curves, &mut points);
            let case = format!("{size} {reach}, seed {seed:#x}: {curves:?} {points:?}");
            let all = points_by_cover(&paths, &points, &period);
            assert_eq!(points_by_pairs(&traits, &curves, &points), all, "{case}");
            let expected = counts_by_cover(&all, &curves, &period);
            assert_eq!(swept(&traits, &FlatTorus, &curves, &points), expected, "{case}");
        }
    }
}

/// Edges are parts of their curves: what is inserted later meets parts only, along the sides too.
#[test]
fn paths_one_after_the_other() {
    for (number, (size, reach)) in [(1, 2), (2, 2), (4, 2)].into_iter().enumerate() {
        for round in 0..60 {
            let seed = (number as u64) << 40 | round;
            let mut rng = Rng::new(seed);
            let traits = TorusSegmentTraits::new([size.into(), size.into()]).expect("positive periods");
            let paths: Vec<_> =
                (0..2 + rng.index(4)).map(|_| random_path(&traits, &mut rng, size, reach)).collect();
            let whole = Arrangement::of_curves(traits.clone(), FlatTorus, &paths);
            let mut grown = Arrangement::new(traits, FlatTorus);
            for path in &paths {
                grown.insert_curves([path]);
                assert_eq!(grown.check_valid(), [], "{size} {reach}, seed {seed:#x}: {paths:?}");
            }
            let case = format!("{size} {reach}, seed {seed:#x}: {paths:?}");
            assert_eq!(grown.counts(), whole.counts(), "{case}");
            assert_eq!(grown.counts_with_splits(), whole.counts_with_splits(), "{case}");
        }
    }
}
