//! The laws of predicates on a torus: in the rectangle they are those of the plane, and sides are where they are said to be.

use crate::curves::{P, at, fraction};
use crate::oracle::{cross, minus};
use exact::planar::Point2;
use exact::{Rational, Sign};
use splitstar_arrangement::Pieces;
use splitstar_arrangement::models::{TorusSegment, TorusSegmentTraits};
use splitstar_arrangement::topology::{FlatTorus, Site, Topology};
use splitstar_arrangement::traits::{
    Along, BasicTraits, BoundaryTraits, CurveEnd, IdentifiedBottomTopTraits, IdentifiedLeftRightTraits,
    UMonotoneTraits,
};
use std::cmp::Ordering;
use testkit::Rng;

const PERIOD: [i64; 2] = [4, 3];

fn traits() -> TorusSegmentTraits {
    TorusSegmentTraits::new(at(PERIOD[0], PERIOD[1])).expect("the periods are positive")
}

fn along(value: &Rational, length: i64) -> Along {
    if value.is_zero() {
        Along::Low
    } else if *value == Rational::from(length) {
        Along::High
    } else {
        Along::Inside
    }
}

fn random_piece(rng: &mut Rng, traits: &TorusSegmentTraits) -> Vec<TorusSegment> {
    let denominator = if rng.one_in(3) { 2 } else { 1 };
    let start: P = PERIOD.map(|length| fraction(rng.below(2 * length as u64) as i64, denominator));
    let step: P = [0; 2].map(|_| fraction(rng.within(6), denominator));
    let path = traits.path(&Point2::from_rationals(&start), &step).expect("the path is short");
    Pieces::of_curves(traits, [&path]).curves().to_vec()
}

#[test]
fn ends_are_where_they_say() {
    let (traits, mut rng) = (traits(), Rng::new(3));
    let mut on_sides = 0;
    for _ in 0..2000 {
        let seed = rng.state();
        for piece in random_piece(&mut rng, &traits) {
            for end in CurveEnd::BOTH {
                let [x, y] = piece.place(end).coordinates();
                let location = traits.end_location(&piece, end);
                assert_eq!(location.u, along(&x, PERIOD[0]), "seed {seed}: {piece:?}");
                assert_eq!(location.v, along(&y, PERIOD[1]), "seed {seed}: {piece:?}");
                let point = traits.end_point(&piece, end).expect("an end on a torus is a point");
                let low = |value: Rational, length: i64| {
                    if value == Rational::from(length) { Rational::ZERO } else { value }
                };
                let [low_x, low_y] = [low(x, PERIOD[0]), low(y, PERIOD[1])];
                assert_eq!(traits.is_on_left_right(point), low_x.is_zero(), "seed {seed}");
                assert_eq!(traits.is_on_bottom_top(point), low_y.is_zero(), "seed {seed}");
                assert_eq!(point.coordinates(), [low_x, low_y], "seed {seed}");
                assert!(traits.is_canonical(point) && traits.is_own_curve(&piece), "seed {seed}: {piece:?}");
                let is_low = piece.place(end) == point;
                assert_eq!(traits.is_canonical(piece.place(end)), is_low, "seed {seed}: {piece:?}");
                on_sides += u32::from(!location.is_interior());
            }
            let [min, max] = CurveEnd::BOTH.map(|end| piece.place(end).coordinates());
            assert!(min < max, "seed {seed}: {piece:?}");
            let locations = CurveEnd::BOTH.map(|end| traits.end_location(&piece, end));
            let is_along_high = |of: fn(splitstar_arrangement::traits::Location) -> Along| {
                locations.iter().all(|&location| of(location) == Along::High)
            };
            assert!(
                !is_along_high(|l| l.u) && !is_along_high(|l| l.v),
                "a curve along a side is on the low one"
            );
            assert_eq!(traits.is_vertical(&piece), min[0] == max[0], "seed {seed}");
        }
    }
    assert!(on_sides > 1000, "{on_sides}");
}

/// The order in which a sweep meets sites is one: antisymmetric and transitive, and that of the rectangle.
#[test]
fn sites_are_in_order() {
    let (traits, mut rng) = (traits(), Rng::new(6));
    for _ in 0..200 {
        let seed = rng.state();
        let pieces: Vec<TorusSegment> = (0..6).flat_map(|_| random_piece(&mut rng, &traits)).collect();
        let ends = pieces.iter().flat_map(|piece| CurveEnd::BOTH.map(|end| (piece, end)));
        let sites: Vec<_> = ends
            .map(|(piece, end)| {
                (piece.place(end).coordinates(), Site::of_end(&FlatTorus, &traits, piece, end))
            })
            .collect();
        // The left side is before the bottom, and on other sides the order is lexicographic; so it is in the rectangle.
        for (p, a) in &sites {
            for (q, b) in &sites {
                assert_eq!(FlatTorus.compare_sites(&traits, a, b), p.cmp(q), "seed {seed}: {p:?} {q:?}");
            }
        }
    }
}

#[test]
fn sides_of_curves() {
    let (traits, mut rng) = (traits(), Rng::new(7));
    let (mut asked, mut told, mut compared) = (0, 0, 0);
    for _ in 0..400 {
        let seed = rng.state();
        let pieces: Vec<TorusSegment> = (0..3).flat_map(|_| random_piece(&mut rng, &traits)).collect();
        for a in &pieces {
            let [min, max] = CurveEnd::BOTH.map(|end| a.place(end).coordinates());
            // Points of the interior.
            for _ in 0..4 {
                let p: P = [0, 1].map(|i| fraction(rng.between(1, 2 * PERIOD[i] as u64 - 1) as i64, 2));
                let own = Point2::from_rationals(&p);
                if !(min[0] <= p[0] && p[0] <= max[0]) {
                    continue;
                }
                let side = cross(&minus(&max, &min), &minus(&p, &min)).sign();
                let expected = match side {
                    _ if traits.is_vertical(a) && p < min => Ordering::Less,
                    _ if traits.is_vertical(a) && p > max => Ordering::Greater,
                    _ if traits.is_vertical(a) => Ordering::Equal,
                    Sign::Negative => Ordering::Less,
                    Sign::Zero => Ordering::Equal,
                    Sign::Positive => Ordering::Greater,
                };
                assert_eq!(traits.compare_v_at_u(&own, a), expected, "seed {seed}: {p:?} {a:?}");
                // A vertical piece has no key; all others are far from the points that are not on them.
                let is_told = expected.is_ne() && !traits.is_vertical(a);
                let by_key = traits.compare_v_at_u_by_key(&own, &traits.side_key(a));
                assert_eq!(by_key, is_told.then_some(expected), "seed {seed}: {p:?} {a:?}");
                told += u32::from(is_told);
                asked += 1;
            }
            for b in &pieces {
                let mut common = Vec::new();
                traits.intersect(a, b, &mut common);
                for intersection in &common {
                    let splitstar_arrangement::traits::Intersection::Point(p, _) = intersection else {
                        continue;
                    };
                    assert!(traits.is_canonical(p), "seed {seed}: {a:?} {b:?}");
                    let is_interior = !traits.is_on_left_right(p) && !traits.is_on_bottom_top(p);
                    let is_max = [a, b].into_iter().any(|c| traits.end_point(c, CurveEnd::Max) == Some(p));
                    if is_interior && !is_max {
                        let [right, back] =
                            [traits.compare_v_at_u_right(a, b, p), traits.compare_v_at_u_right(b, a, p)];
                        assert_eq!(right, back.reverse(), "seed {seed}: {a:?} {b:?}");
                        compared += 1;
                    }
                }
            }
        }
    }
    assert!(told > 100 && asked > 500 && compared > 50, "{told} of {asked}, and {compared}");
}
