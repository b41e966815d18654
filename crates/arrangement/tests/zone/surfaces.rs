//! Strips whose left side is glued to the right one: cylinders, and spheres with poles.

use crate::oracle::{Seen, check};
use crate::paths::Curve;
use crate::strip::{Band, Strip};
use exact::planar::Point2;
use splitstar_arrangement::traits::SideKind::{self, Closed, Contracted, Open};
use splitstar_arrangement::{Arrangement, Editor};
use testkit::Rng;

const SIZE: [i64; 2] = [6, 4];

fn draw(rng: &mut Rng, kinds: [SideKind; 2]) -> Curve {
    let [width, height] = SIZE;
    let is_closed = |v: i64| match v {
        0 => kinds[0] == Closed,
        v if v == height => kinds[1] == Closed,
        _ => true,
    };
    loop {
        let mut any = || [rng.index(width as usize) as i64, rng.index(height as usize + 1) as i64];
        let [p, mut q] = [any(), any()];
        let curve = match rng.index(8) {
            0 => Curve::Parallel(p[1]),
            // A meridian or a part of one, often on the seam.
            1 | 2 => {
                let u = if rng.one_in(2) { 0 } else { p[0] };
                Curve::Path([[u, p[1].min(height - 1)], [u, height]])
            }
            3 => Curve::Path([[p[0], 0], [p[0], q[1].max(1)]]),
            _ => {
                q[0] += width * rng.index(3) as i64;
                Curve::Path([p, q])
            }
        };
        let is_on_strip = match curve {
            Curve::Parallel(v) => is_closed(v),
            Curve::Path([p, q]) => p != q && (p[1] != q[1] || is_closed(p[1])),
        };
        if is_on_strip {
            return curve;
        }
    }
}

fn run<const MEET_ONCE: bool>(v: [SideKind; 2]) {
    let mut rng = Rng::new(7);
    let mut seen = Seen::default();
    for _ in 0..60 {
        let seed = rng.state();
        let curves: Vec<Curve> = (0..rng.index(7)).map(|_| draw(&mut rng, v)).collect();
        let points = [[0, 1], [3, 2]].map(Point2::from_i64);
        let traits = Strip::<MEET_ONCE> { size: SIZE, v };
        let editor = Editor::new(Arrangement::of_curves_and_points(traits, Band(v), &curves, points));
        for _ in 0..3 {
            let curve = draw(&mut rng, v);
            check(&editor, &curve, &mut seen, &format!("{v:?}, seed {seed}, {curve:?} in {curves:?}"));
        }
    }
    assert!(seen.pieces > 180 && seen.crossings > 20 && seen.overlaps > 5 && seen.vertices > 50, "{seen:?}");
}

#[test]
fn cylinders() {
    for v in [[Closed, Closed], [Open, Open], [Closed, Open]] {
        run::<true>(v);
        run::<false>(v);
    }
}

#[test]
fn spheres_and_cones() {
    for v in [[Contracted, Contracted], [Contracted, Open], [Closed, Contracted]] {
        run::<true>(v);
        run::<false>(v);
    }
}

/// The overlap ends on the right side, where the point is one of the left side for those who ask the point alone.
#[test]
fn an_overlap_up_to_the_seam() {
    let v = [Closed, Closed];
    let traits = Strip::<false> { size: SIZE, v };
    let curves = [Curve::Parallel(2), Curve::Path([[1, 2], [5, 2]])];
    let editor = Editor::new(Arrangement::of_curves(traits, Band(v), &curves));
    for curve in [curves[0], Curve::Path([[2, 2], [8, 2]])] {
        check(&editor, &curve, &mut Seen::default(), "an overlap up to the seam");
    }
}
