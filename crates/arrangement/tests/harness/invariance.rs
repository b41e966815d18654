//! What changes nothing: the order of input, which end is first, and maps of the plane.

use crate::curves::{Curve, P, fraction};
use crate::models::{Linears, Model, Polylinears, Segments};
use crate::oracle::brute_force;
use crate::random::random_curves;
use crate::routes::{Made, Route};
use exact::planar::Point2;
use testkit::Rng;

fn sweep<M: Model>(model: &M, curves: &[Curve]) -> Made<M> {
    Route::Sweep.build(model, curves, &mut Rng::new(0)).expect("the model can carry the curves")
}

/// An exact map of the plane, and whether it turns the orientation round.
type Map = (&'static str, fn(&P) -> P, bool);

const MAPS: &[Map] = &[
    ("rotation", |[x, y]| [-y, x.clone()], false),
    ("half turn", |[x, y]| [-x, -y], false),
    ("shear", |[x, y]| [x + y, y.clone()], false),
    ("reflection", |[x, y]| [y.clone(), x.clone()], true),
    ("reflection of u", |[x, y]| [-x, y.clone()], true),
    ("translation", |[x, y]| [x + fraction(1, 3), y - fraction(5, 7)], false),
];

fn check_maps<M: Model>(model: &M, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(77);
    for _ in 0..cases {
        let seed = rng.state();
        let curves = random_curves(&mut rng, 9, 5, are_bounded);
        let arrangement = sweep(model, &curves);
        let mut shuffled: Vec<Curve> = curves.iter().map(Curve::swapped).collect();
        rng.shuffle(&mut shuffled);
        let difference = arrangement.difference(&sweep(model, &shuffled));
        assert!(difference.is_none(), "{difference:?}, seed {seed}: {curves:?} and {shuffled:?}");
        for (name, map, is_mirrored) in MAPS {
            let mapped: Vec<Curve> = curves.iter().map(|curve| curve.mapped(map)).collect();
            let image = sweep(model, &mapped);
            assert_eq!(image.check_valid(), [], "{name}, seed {seed}: {mapped:?}");
            let of_point = |p: &Point2| Point2::from_rationals(&map(&p.coordinates()));
            assert!(
                arrangement.is_isomorphic_under(&image, of_point, *is_mirrored),
                "{name}, seed {seed}: {curves:?}"
            );
        }
    }
}

#[test]
fn segments() {
    check_maps(&Segments, 300, true);
}

#[test]
fn linear_curves() {
    check_maps(&Linears, 300, false);
}

#[test]
fn polycurves() {
    check_maps(&Polylinears, 60, false);
}

/// Two arrangements are the same if and only if brute force finds the same cells.
#[test]
fn different_curves_are_told_apart() {
    let mut rng = Rng::new(4);
    let (mut same, mut different) = (0, 0);
    for _ in 0..4000 {
        let seed = rng.state();
        let pair = [0; 2].map(|_| random_curves(&mut rng, 2, 1, false));
        let cells = pair.each_ref().map(|curves| brute_force(curves));
        let [a, b] = pair.each_ref().map(|curves| sweep(&Linears, curves));
        let is_same = cells[0].vertices == cells[1].vertices && cells[0].edges == cells[1].edges;
        assert_eq!(a.is_isomorphic(&b), is_same, "seed {seed}: {pair:?}, {:?}", a.difference(&b));
        // The order around infinity is all that a map must keep of lines.
        assert!(!is_same || a.is_isomorphic_under(&b, Point2::clone, false), "seed {seed}: {pair:?}");
        same += u32::from(is_same);
        different += u32::from(!is_same);
    }
    assert!(same > 100 && different > 1000, "{same} and {different}");
}
