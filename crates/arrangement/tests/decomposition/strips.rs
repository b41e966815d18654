//! Strips whose left side is glued to the right one: cylinders, spheres, and what is between.

use crate::laws::check;
use crate::paths::{Curve, make};
use splitstar_arrangement::traits::SideKind::{self, Closed, Contracted, Open};
use testkit::Rng;

pub(crate) const SIZE: [i64; 2] = [6, 4];

pub(crate) const KINDS: [[SideKind; 2]; 6] = [
    [Open, Open],
    [Contracted, Contracted],
    [Closed, Closed],
    [Contracted, Open],
    [Closed, Contracted],
    [Open, Closed],
];

pub(crate) fn random_curve(rng: &mut Rng, kinds: [SideKind; 2]) -> Curve {
    let [width, height] = SIZE;
    let is_closed = |v: i64| match v {
        0 => kinds[0] == Closed,
        v if v == height => kinds[1] == Closed,
        _ => true,
    };
    loop {
        let any = |rng: &mut Rng| [rng.index(width as usize) as i64, rng.index(height as usize + 1) as i64];
        let [p, mut q] = [any(rng), any(rng)];
        let curve = match rng.index(8) {
            0 => Curve::Parallel(p[1]),
            1 => Curve::Path([p, p]),
            // A meridian or a part of one, often where the sides are glued.
            2 => {
                let u = if rng.one_in(2) { 0 } else { p[0] };
                Curve::Path([[u, 0], [u, q[1].max(1)]])
            }
            3 => Curve::Path([[p[0], height], [p[0], q[1].min(height - 1)]]),
            4 => {
                q[0] += width * (1 + rng.index(2) as i64);
                Curve::Path([p, q])
            }
            _ => {
                q[0] += if rng.one_in(3) { width } else { 0 };
                Curve::Path([p, q])
            }
        };
        let is_on_strip = match curve {
            Curve::Parallel(v) => is_closed(v),
            Curve::Path([p, q]) => p[1] != q[1] || is_closed(p[1]),
        };
        if is_on_strip {
            return curve;
        }
    }
}

#[test]
fn complexes_of_random_arrangements() {
    for (number, kinds) in (0..).zip(KINDS) {
        let seed = 7001 + number;
        let mut rng = Rng::new(seed);
        for round in 0..400 {
            let curves: Vec<Curve> = (0..rng.index(9)).map(|_| random_curve(&mut rng, kinds)).collect();
            let context = format!("seed {seed}, round {round}, {kinds:?}: {curves:?}");
            check(&make::<true>(SIZE, kinds, &curves), &context);
        }
    }
}
