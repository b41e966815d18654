//! Strips of which two opposite sides are glued: cylinders, cones and spheres, upright and lying.

use crate::agree::assert_agree;
use crate::curves::P;
use crate::paths::Curve;
use crate::rays::Rays;
use crate::strip::{Band, Piece, Strip};
use crate::tube::{Part, Transposed, Tube};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::traits::SideKind::{self, Closed, Contracted, Open};
use testkit::Rng;

const SIZE: [i64; 2] = [6, 4];

/// A curve that does not lie on a side without points.
fn draw(rng: &mut Rng, kinds: [SideKind; 2]) -> Curve {
    let [width, height] = SIZE;
    let is_free = |v: i64| match v {
        0 => kinds[0] == Closed,
        v if v == height => kinds[1] == Closed,
        _ => true,
    };
    loop {
        let mut any = || [rng.index(width as usize) as i64, rng.index(height as usize + 1) as i64];
        let [p, mut q] = [any(), any()];
        let curve = match rng.index(9) {
            0 => Curve::Parallel(p[1]),
            1 => Curve::Path([p, p]),
            // A meridian or a part of one, often on the seam.
            2 | 3 => {
                let u = if rng.one_in(2) { 0 } else { p[0] };
                Curve::Path([[u, p[1].min(height - 1)], [u, height]])
            }
            4 => Curve::Path([[p[0], 0], [p[0], q[1].max(1)]]),
            5 => Curve::Path([[0, 0], [1 + p[0], q[1].max(1)]]),
            _ => {
                q[0] += width * rng.index(3) as i64;
                Curve::Path([p, q])
            }
        };
        let is_on_strip = match curve {
            Curve::Parallel(v) => is_free(v),
            Curve::Path([p, q]) => p[1] != q[1] || is_free(p[1]),
        };
        if is_on_strip {
            return curve;
        }
    }
}

/// Whether a point is of the strip, and on no side without points, and not on the right side.
fn is_inside(p: &P, kinds: [SideKind; 2]) -> bool {
    let [width, height] = SIZE.map(Rational::from);
    let zero = Rational::ZERO;
    let is_above = if kinds[0] == Closed { p[1] >= zero } else { p[1] > zero };
    let is_below = if kinds[1] == Closed { p[1] <= height } else { p[1] < height };
    is_above && is_below && p[0] >= zero && p[0] < width
}

fn check<const M: bool>(kinds: [SideKind; 2], curves: &[Curve], rng: &mut Rng, context: &str) -> usize {
    let arrangement = Arrangement::of_curves(Strip::<M> { size: SIZE, v: kinds }, Band(kinds), curves);
    assert_eq!(arrangement.check_valid(), [], "{context}");
    let ends = |piece: &Piece| [piece.segment.min(), piece.segment.max()].map(Point2::coordinates);
    let rays = Rays::new(&arrangement, SIZE.map(Rational::from), ends);
    let points = rays.points(rng, 25).into_iter().filter(|p| is_inside(p, kinds));
    let points: Vec<Point2> = points.map(|p| Point2::from_rationals(&p)).collect();
    let answers = assert_agree(&arrangement, &points, context);
    rays.check(&points, &answers, context)
}

#[test]
fn upright() {
    let mut known = 0;
    for kinds in [
        [Closed, Closed],
        [Open, Open],
        [Contracted, Contracted],
        [Contracted, Open],
        [Closed, Contracted],
        [Open, Closed],
    ] {
        let mut rng = Rng::new(9);
        for case in 0..120 {
            let seed = rng.state();
            let curves: Vec<Curve> = (0..case % 8).map(|_| draw(&mut rng, kinds)).collect();
            let context = format!("{kinds:?}, seed {seed}: {curves:?}");
            known += check::<true>(kinds, &curves, &mut rng, &context);
            if case % 2 == 0 {
                known += check::<false>(kinds, &curves, &mut rng, &context);
            }
        }
    }
    assert!(known > 20_000, "{known}");
}

/// Bottom and top are glued; u and v of curves and points are exchanged.
#[test]
fn lying() {
    let mut known = 0;
    for kinds in [[Open, Open], [Contracted, Contracted], [Open, Contracted]] {
        let mut rng = Rng::new(10);
        for case in 0..150 {
            let seed = rng.state();
            let curves: Vec<Curve> = (0..case % 8).map(|_| draw(&mut rng, kinds)).collect();
            let context = format!("lying, {kinds:?}, seed {seed}: {curves:?}");
            let traits = Transposed { strip: Strip { size: SIZE, v: kinds } };
            let arrangement = Arrangement::of_curves(traits, Tube(kinds), &curves);
            let ends = |part: &Part| [part.segment.min(), part.segment.max()].map(Point2::coordinates);
            let [width, height] = SIZE.map(Rational::from);
            let rays = Rays::new(&arrangement, [height, width], ends);
            let points = rays.points(&mut rng, 25).into_iter();
            let points = points.filter(|[u, v]| is_inside(&[v.clone(), u.clone()], kinds));
            let points: Vec<Point2> = points.map(|p| Point2::from_rationals(&p)).collect();
            let answers = assert_agree(&arrangement, &points, &context);
            known += rays.check(&points, &answers, &context);
        }
    }
    assert!(known > 5_000, "{known}");
}

/// They run together up to a pole, of which the traits give a point that is not greater than where they begin.
#[test]
fn twice_from_pole_to_pole() {
    let curve = Curve::Path([[0, 0], [4, 4]]);
    for kinds in [[Contracted, Contracted], [Open, Contracted]] {
        check::<false>(kinds, &[curve, curve], &mut Rng::new(1), "twice");
    }
}
