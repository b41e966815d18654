//! Random curves: of small coordinates, so that everything degenerate happens, and of large ones.

use crate::arcs::Curve;
use crate::space::{P, at, cross, is_zero, opposite};
use exact::{Integer, Sign};
use testkit::Rng;

pub(crate) fn random_point(rng: &mut Rng, range: i64) -> P {
    loop {
        let p = at([0; 3].map(|_| rng.within(range)));
        if p.iter().any(|c| !c.is_zero()) {
            return p;
        }
    }
}

/// Often a pole, and often on the half meridian of the default identification or opposite.
fn random_end(rng: &mut Rng, range: i64) -> P {
    match rng.below(12) {
        0 => at([0, 0, if rng.one_in(2) { 1 } else { -1 }]),
        1 => at([-1 - rng.below(range as u64) as i64, 0, rng.within(range)]),
        2 => at([1, 0, rng.within(range)]),
        _ => random_point(rng, range),
    }
}

/// A point whose circle with another is told: on the same side or opposite, they tell none.
fn is_parallel(p: &P, q: &P) -> bool {
    is_zero(&cross(p, q))
}

/// Any curve.
pub(crate) fn random_curve(rng: &mut Rng, range: i64) -> Curve {
    let [p, q, r] = [0; 3].map(|_| random_end(rng, range));
    let is_same_way = |a: &P, b: &P| crate::space::primitive(a) == crate::space::primitive(b);
    match rng.below(16) {
        0 => Curve::Point(p),
        1 => Curve::Circle(p),
        // All round, with a vertex.
        2 if !is_parallel(&p, &q) => Curve::Around(p.clone(), p.clone(), cross(&p, &q)),
        // Half round.
        3 if !is_parallel(&p, &q) => Curve::Via(p.clone(), q, opposite(&p)),
        // Longer than half a circle, or shorter: the other way round.
        4..8 if !is_parallel(&p, &q) => {
            let normal = cross(&p, &q);
            let normal = if rng.one_in(2) { opposite(&normal) } else { normal };
            Curve::Around(p, q, normal)
        }
        // A part of a meridian, or all of one.
        8 | 9 => {
            let v = [0; 2].map(|_| rng.within(range));
            let through = |v: i64| [r[0].clone(), r[1].clone(), v.into()];
            let [a, b] = v.map(through);
            if crate::space::is_pole(&r) || is_parallel(&a, &b) {
                Curve::Point(p)
            } else {
                Curve::Short(a, b)
            }
        }
        // Through a pole.
        10 if !is_parallel(&p, &at([0, 0, 1])) => {
            let pole = at([0, 0, if rng.one_in(2) { 1 } else { -1 }]);
            let beyond = [-&p[0], -&p[1], r[2].clone()];
            if is_same_way(&pole, &beyond) { Curve::Point(p) } else { Curve::Via(p, pole, beyond) }
        }
        _ if is_parallel(&p, &q) => Curve::Point(q),
        _ => Curve::Short(p, q),
    }
}

pub(crate) fn random_curves(rng: &mut Rng, most: usize, range: i64) -> Vec<Curve> {
    match rng.below(5) {
        0 => random_overlaps(rng, most),
        _ => (0..rng.index(most + 1)).map(|_| random_curve(rng, range)).collect(),
    }
}

/// Arcs of two or three circles, and points of them: they overlap.
fn random_overlaps(rng: &mut Rng, most: usize) -> Vec<Curve> {
    const CIRCLES: [[[i64; 3]; 2]; 7] = [
        [[0, 0, 1], [-1, 0, 0]],
        [[0, 1, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 0, 1]],
        [[1, 1, 0], [0, 0, 1]],
        [[1, 1, 1], [1, -1, 0]],
        [[1, 0, 1], [-1, 0, 1]],
        [[2, -1, 3], [1, 2, 0]],
    ];
    let circles = [0; 3].map(|_| rng.choose(&CIRCLES).map(at));
    let mut curve = || {
        let [normal, start] = rng.choose(&circles).clone();
        let ahead = cross(&normal, &start);
        let mut point = || {
            let [s, t] =
                *rng.choose(&[[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [2, 1]]);
            [0, 1, 2].map(|i| Integer::from(s) * &start[i] + Integer::from(t) * &ahead[i])
        };
        let (p, q) = (point(), point());
        match rng.below(8) {
            0 => Curve::Point(p),
            1 => Curve::Circle(normal),
            _ => Curve::Around(p, q, if rng.one_in(2) { normal } else { opposite(&normal) }),
        }
    };
    (0..1 + most / 2).map(|_| curve()).collect()
}

/// A curve that is almost another: what of its points lie on circles and on each other, lies beside them.
pub(crate) fn almost(curve: &Curve, rng: &mut Rng) -> Curve {
    let mut near = |p: &P| -> P { p.each_ref().map(|c| (c.clone() << 40) + Integer::from(rng.within(1))) };
    match curve {
        Curve::Point(p) => Curve::Point(near(p)),
        Curve::Short(p, q) => Curve::Short(near(p), near(q)),
        Curve::Circle(n) => Curve::Circle(near(n)),
        Curve::Around(p, q, n) if !is_parallel(p, q) => {
            let (p, q) = (near(p), near(q));
            let normal = cross(&p, &q);
            let is_short = crate::space::dot(&normal, n).sign() == Sign::Positive;
            Curve::Around(p, q, if is_short { normal } else { opposite(&normal) })
        }
        Curve::Via(..) | Curve::Around(..) => curve.clone(),
    }
}
