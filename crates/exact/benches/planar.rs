//! Nanoseconds per call of the predicates and constructions of `exact::planar`, at several widths.
//!
//! `cargo bench -p splitstar-exact --bench planar`

#![allow(clippy::print_stdout)]

mod common;

use common::{INPUTS, Random, time};
use exact::planar::{Line2, Point2, compare_xy, side_of_line};
use exact::{Integer, Rational};

impl Random {
    /// Not negative.
    fn coordinates(&mut self, bits: u32) -> [Integer; 2] {
        [(); 2].map(|()| {
            let value = (Integer::from(self.next()) << 64) + Integer::from(self.next());
            value >> (128 - bits)
        })
    }

    fn point(&mut self, bits: u32) -> Point2 {
        point(self.coordinates(bits))
    }

    fn line(&mut self, bits: u32) -> Line2 {
        loop {
            let [p, q] = [(); 2].map(|()| self.point(bits));
            if let Some(line) = Line2::through(&p, &q) {
                return line;
            }
        }
    }

    fn crossing(&mut self, bits: u32) -> (Line2, Line2, Point2) {
        loop {
            let (l, m) = (self.line(bits), self.line(bits));
            if let Some(p) = Point2::crossing(&l, &m) {
                return (l, m, p);
            }
        }
    }

    /// Two crossings of four lines in one point with odd halves as coordinates, and one that shares a line with the first.
    fn equal(&mut self, bits: u32) -> [Point2; 3] {
        loop {
            let [x, y] = self.coordinates(bits);
            let lines = [(); 4].map(|()| {
                let [i, j] = self.coordinates(bits);
                let [u, v] = [&x + &x + Integer::ONE - &i, &y + &y + Integer::ONE - &j];
                Line2::through(&point([i, j]), &point([u, v]))
            });
            if let [Some(k), Some(l), Some(m), Some(n)] = &lines
                && let Some(p) = Point2::crossing(k, l)
                && let Some(q) = Point2::crossing(m, n)
                && let Some(r) = Point2::crossing(k, m)
            {
                return [p, q, r];
            }
        }
    }
}

fn point(coordinates: [Integer; 2]) -> Point2 {
    Point2::from_rationals(&coordinates.map(Rational::from))
}

fn main() {
    for bits in [20, 22, 29, 31, 40, 53, 60, 64, 100] {
        let mut random = Random(bits.into());
        let explicit: Vec<_> = (0..INPUTS).map(|_| [(); 2].map(|()| random.point(bits))).collect();
        let crossings: Vec<_> = (0..INPUTS).map(|_| (random.crossing(bits), random.crossing(bits))).collect();
        let equal: Vec<_> = (0..INPUTS).map(|_| random.equal(bits)).collect();
        let rows = [
            ("Line2::through", time(&explicit, |[p, q]| Line2::through(p, q))),
            ("Point2::crossing", time(&crossings, |((l, m, _), _)| Point2::crossing(l, m))),
            ("compare_xy, explicit", time(&explicit, |[p, q]| compare_xy(p, q))),
            ("compare_xy, crossings", time(&crossings, |((_, _, p), (_, _, q))| compare_xy(p, q))),
            ("compare_xy, equal", time(&equal, |[p, q, _]| compare_xy(p, q))),
            ("compare_xy, equal on a line", time(&equal, |[p, _, r]| compare_xy(p, r))),
            ("compare_xy, itself", time(&crossings, |((_, _, p), _)| compare_xy(p, p))),
            (
                "side, explicit",
                time(&crossings.iter().zip(&explicit).collect::<Vec<_>>(), |(((l, _, _), _), [p, _])| {
                    side_of_line(p, l)
                }),
            ),
            ("side, crossing", time(&crossings, |((l, _, _), (_, _, p))| side_of_line(p, l))),
            ("side, on its line", time(&crossings, |((l, _, p), _)| side_of_line(p, l))),
            ("compare_slope", time(&crossings, |((l, m, _), _)| l.compare_slope(m))),
            ("clone of a crossing", time(&crossings, |((_, _, p), _)| p.clone())),
        ];
        println!("\n{bits} bits");
        for (name, ns) in rows {
            println!("  {name:28} {ns:7.1} ns");
        }
    }
}
