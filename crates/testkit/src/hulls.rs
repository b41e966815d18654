//! Random polytopes as hulls of random points: small boxes, so that degeneracies are frequent.

use crate::Rng;
use exact::{Integer, Point3};
use polytope::{Polytope, convex_hull};

/// The hull of points with small integer coordinates.
///
/// # Panics
/// If there is no point.
pub fn hull(points: &[[i64; 3]]) -> Polytope {
    around(&points.iter().map(|&p| Point3::from_i64(p)).collect::<Vec<_>>())
}

/// The hull of points.
///
/// # Panics
/// If there is no point.
pub fn around(points: &[Point3]) -> Polytope {
    convex_hull(points).expect("a hull is asked for some points")
}

/// Random points of the grid in the box from `-range` to `range`.
pub fn points_in_box(rng: &mut Rng, count: u64, range: i64) -> Vec<[i64; 3]> {
    (0..count).map(|_| [0; 3].map(|_: i64| rng.within(range))).collect()
}

/// Random points of the grid in a plane through the origin that two random vectors span (a line or a
/// point, if they are unlucky).
pub fn flat_points(rng: &mut Rng, count: u64, range: i64) -> Vec<[i64; 3]> {
    let axes = points_in_box(rng, 2, range.clamp(1, 3));
    combinations(rng, &axes, count, range)
}

/// Random points of the grid on a line through the origin.
pub fn collinear_points(rng: &mut Rng, count: u64, range: i64) -> Vec<[i64; 3]> {
    let axes = points_in_box(rng, 1, range.clamp(1, 3));
    combinations(rng, &axes, count, range)
}

fn combinations(rng: &mut Rng, axes: &[[i64; 3]], count: u64, range: i64) -> Vec<[i64; 3]> {
    let mut point = || {
        axes.iter().fold([0; 3], |sum: [i64; 3], axis| {
            let factor = rng.within(range);
            [0, 1, 2].map(|i: usize| sum[i] + factor * axis[i])
        })
    };
    (0..count).map(|_| point()).collect()
}

/// The hull of 4 to 12 random points in a box: of any dimension, mostly 3.
pub fn random_hull(rng: &mut Rng, range: i64) -> Polytope {
    let count = rng.between(4, 12);
    hull(&points_in_box(rng, count, range))
}

/// A random polytope of exactly this dimension, of at most 12 points in general or degenerate position.
///
/// # Panics
/// If `dimension` is above 3.
pub fn hull_of_dimension(rng: &mut Rng, dimension: u8, range: i64) -> Polytope {
    loop {
        let count = rng.between(4, 12);
        let points = match dimension {
            0 => points_in_box(rng, 1, range),
            1 => collinear_points(rng, count, range),
            2 => flat_points(rng, count, range),
            3 => points_in_box(rng, count, range),
            _ => panic!("there are dimensions 0 to 3"),
        };
        let polytope = hull(&points);
        if polytope.dimension() == dimension {
            return polytope;
        }
    }
}

/// A random integer of at most so many bits, of either sign.
fn wide_integer(rng: &mut Rng, bits: u32) -> Integer {
    let mut value = Integer::from(0);
    let mut left = bits;
    while left > 0 {
        let take = left.min(32);
        value = (value << take) + Integer::from((rng.bits() >> (64 - take)) as i64);
        left -= take;
    }
    if rng.one_in(2) { -value } else { value }
}

/// The hull of `count` random points whose coordinates have so many bits.
///
/// A third of the points are sums and differences of two others: parallel edges and planes remain
/// frequent however wide the coordinates are.
pub fn wide_hull(rng: &mut Rng, count: u64, bits: u32) -> Polytope {
    let mut points: Vec<[Integer; 3]> = Vec::new();
    for i in 0..count {
        if i >= 3 && rng.one_in(3) {
            let [a, b, c] = [0; 3].map(|_: u8| rng.below(i) as usize);
            points.push([0, 1, 2].map(|axis: usize| &points[a][axis] + &points[b][axis] - &points[c][axis]));
        } else {
            points.push([0; 3].map(|_: u8| wide_integer(rng, bits)));
        }
    }
    let point = |p: [Integer; 3]| Point3::new(p, Integer::from(1)).expect("one is positive");
    around(&points.into_iter().map(point).collect::<Vec<_>>())
}

/// The hull of small points and one with coordinates of so many bits.
pub fn mixed_width_hull(rng: &mut Rng, count: u64, range: i64, bits: u32) -> Polytope {
    let mut points: Vec<Point3> =
        points_in_box(rng, count, range).into_iter().map(Point3::from_i64).collect();
    let wide = [0; 3].map(|_: u8| wide_integer(rng, bits));
    points.push(Point3::new(wide, Integer::from(1)).expect("one is positive"));
    around(&points)
}

/// The hull of small rational points, each with a weight of its own of up to so many bits: half of
/// them are points of the grid written in other terms.
pub fn weighted_hull(rng: &mut Rng, count: u64, range: i64, bits: u32) -> Polytope {
    let points = points_in_box(rng, count, range);
    let mut weighted = |p: [i64; 3]| {
        let weight = wide_integer(rng, bits).abs() + Integer::from(1);
        let on_grid = rng.one_in(2);
        let mut offset = || if on_grid { Integer::from(0) } else { wide_integer(rng, bits) };
        Point3::new(p.map(|c| Integer::from(c) * &weight + offset()), weight.clone())
            .expect("the weight is positive")
    };
    around(&points.into_iter().map(&mut weighted).collect::<Vec<_>>())
}
