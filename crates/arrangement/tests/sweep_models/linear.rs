//! The sweep over segments, rays and lines, against all pairs.

use crate::watcher::{Counts, swept};
use exact::planar::{Line2, Point2};
use splitstar_arrangement::models::{
    Linear, LinearTraits, MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits,
};
use splitstar_arrangement::sweep::{Around, Event, SweepInput, SweepVisitor, sweep};
use splitstar_arrangement::topology::{BoundedPlane, UnboundedPlane};
use splitstar_arrangement::traits::{CurveEnd, Intersection, UMonotoneTraits};
use std::collections::HashSet;
use std::ops::ControlFlow;
use testkit::Rng;

/// All pairs of curves.
fn expected<G: UMonotoneTraits<Point = Point2>>(
    traits: &G,
    curves: &[G::UMonotoneCurve],
    points: &[Point2],
    line: impl Fn(&G::UMonotoneCurve) -> Line2,
) -> Counts {
    let mut all = points.to_vec();
    for (i, a) in curves.iter().enumerate() {
        all.extend(CurveEnd::BOTH.into_iter().filter_map(|end| traits.end_point(a, end).cloned()));
        for b in &curves[..i] {
            let mut common = Vec::new();
            traits.intersect(a, b, &mut common);
            all.extend(common.into_iter().filter_map(|common| match common {
                Intersection::Point(p, _) => Some(p),
                Intersection::Overlap(_) => None,
            }));
        }
    }
    all.sort();
    all.dedup();
    let mut strands = HashSet::new();
    let mut members = 0;
    for curve in curves {
        let on: Vec<usize> = (0..all.len()).filter(|&i| traits.is_on_curve(&all[i], curve)).collect();
        let mut places: Vec<Option<usize>> = on.into_iter().map(Some).collect();
        if traits.end_point(curve, CurveEnd::Min).is_none() {
            places.insert(0, None);
        }
        if traits.end_point(curve, CurveEnd::Max).is_none() {
            places.push(None);
        }
        members += places.len() - 1;
        strands.extend(places.windows(2).map(|pair| (line(curve), pair[0], pair[1])));
    }
    Counts { points: all.len(), strands: strands.len(), members }
}

/// Points of segments with integer ends, in lowest terms, with nothing but 128-bit integers.
fn points_in_machine_words(segments: &[[[i64; 2]; 2]]) -> usize {
    let mut points = HashSet::new();
    let gcd = |mut a: i128, mut b: i128| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let wide = |p: [i64; 2]| p.map(i128::from);
    for (i, &[p, q]) in segments.iter().enumerate() {
        let ([px, py], [qx, qy]) = (wide(p), wide(q));
        points.insert([px, py, 1]);
        points.insert([qx, qy, 1]);
        for &[r, s] in &segments[..i] {
            let ([rx, ry], [sx, sy]) = (wide(r), wide(s));
            let w = (qx - px) * (sy - ry) - (qy - py) * (sx - rx);
            let (t, u) = (
                (rx - px) * (sy - ry) - (ry - py) * (sx - rx),
                (rx - px) * (qy - py) - (ry - py) * (qx - px),
            );
            let [t, u, w] = if w < 0 { [-t, -u, -w] } else { [t, u, w] };
            if w > 0 && 0 <= t && t <= w && 0 <= u && u <= w {
                let (x, y) = (px * w + t * (qx - px), py * w + t * (qy - py));
                let d = gcd(gcd(x, y), w);
                points.insert([x / d, y / d, w / d]);
            }
        }
    }
    points.len()
}

type Ends = [[i64; 2]; 2];

const FAMILIES: [&str; 7] = ["random", "steep", "grid", "pencil", "few lines", "fan", "comb"];

/// Segments of a family, with ends of magnitude at most about `size`.
fn family(name: &str, count: usize, size: i64, rng: &mut Rng) -> Vec<Ends> {
    let mut segments = Vec::new();
    while segments.len() < count {
        let mut point = || [rng.within(size), rng.within(size)];
        let (p, q) = (point(), point());
        let i = segments.len() as i64;
        let ends = match name {
            "random" => [p, q],
            "steep" => [p, [p[0] + q[0] / size.max(1), q[1]]],
            "grid" if q[0] % 2 == 0 => [p, [p[0], q[1]]],
            "grid" => [p, [q[0], p[1]]],
            "pencil" => [p, [-p[0], -p[1]]],
            "few lines" => {
                let direction = [[1, 0], [0, 1], [1, 1], [2, -1]][rng.index(4)];
                let base = [rng.within(1), rng.within(1)];
                // Room for twice the number.
                let [p, q] = [p[0], q[0]].map(|t| if size > 1 << 60 { t / 4 } else { t });
                [p, q].map(|t| [base[0] + t * direction[0], base[1] + t * direction[1]])
            }
            "fan" => [[0, 0], p],
            _ => {
                if i == 0 {
                    [[-size, 0], [size, 0]]
                } else {
                    [[p[0], 0], [p[0], q[1].abs()]]
                }
            }
        };
        if ends[0] != ends[1] {
            segments.push(ends);
        }
    }
    segments
}

fn all_cases(mut run: impl FnMut(&[Ends], &[Point2], &str, &mut Rng)) {
    for (number, name) in FAMILIES.into_iter().enumerate() {
        for size in [1, 2, 4, 9, 60, 1_000_000, 1 << 62] {
            for round in 0..25 {
                let seed = (number as u64) << 32 | (size as u64) << 8 | round;
                let mut rng = Rng::new(seed);
                let count = 1 + rng.index(if round < 12 { 4 } else { 24 });
                let segments = family(name, count, size, &mut rng);
                let points: Vec<_> = (0..rng.index(4))
                    .map(|_| Point2::from_i64([rng.within(size), rng.within(size)]))
                    .collect();
                run(
                    &segments,
                    &points,
                    &format!("{name} {size}, seed {seed:#x}: {segments:?} {points:?}"),
                    &mut rng,
                );
            }
        }
    }
}

#[test]
fn segments_as_all_pairs() {
    all_cases(|segments, points, case, _| {
        let curves: Vec<_> = segments.iter().map(|&ends| Segment::from_i64(ends).unwrap()).collect();
        let brute = expected(&SegmentTraits, &curves, points, |curve| curve.line().clone());
        if points.is_empty() && segments.iter().flatten().flatten().all(|value| value.abs() <= 1 << 30) {
            assert_eq!(brute.points, points_in_machine_words(segments), "{case}");
        }
        assert_eq!(swept(&SegmentTraits, &BoundedPlane, &curves, points), brute, "{case}");
        let minimal: Vec<_> = segments.iter().map(|&ends| MinimalSegment::from_i64(ends).unwrap()).collect();
        assert_eq!(swept(&MinimalSegmentTraits, &BoundedPlane, &minimal, points), brute, "{case}");
        let linear: Vec<_> = curves.into_iter().map(Linear::from).collect();
        assert_eq!(swept(&LinearTraits, &UnboundedPlane, &linear, points), brute, "{case}");
    });
}

#[test]
fn segments_rays_and_lines_as_all_pairs() {
    all_cases(|segments, points, case, rng| {
        let curves: Vec<_> = segments
            .iter()
            .map(|&ends| {
                let [p, q] = ends.map(Point2::from_i64);
                match rng.index(3) {
                    0 => Linear::segment(p, q),
                    1 => Linear::ray(p, &q),
                    _ => Linear::line(&p, &q),
                }
                .unwrap()
            })
            .collect();
        let brute = expected(&LinearTraits, &curves, points, |curve| curve.supporting_line().clone());
        assert_eq!(swept(&LinearTraits, &UnboundedPlane, &curves, points), brute, "{case} {curves:?}");
    });
}

#[test]
fn a_visitor_stops_a_sweep() {
    struct First;
    impl SweepVisitor<SegmentTraits> for First {
        type Tag = ();
        fn event(&mut self, event: &Event<'_, SegmentTraits>, _: &mut Around<'_, ()>) -> ControlFlow<()> {
            if event.is_meeting { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }
    let curves = [[[0, 0], [2, 2]], [[0, 2], [2, 0]]].map(|ends| Segment::from_i64(ends).unwrap());
    for (count, is_met) in [(1, false), (2, true)] {
        let input = SweepInput::of_curves(&SegmentTraits, &BoundedPlane, &curves[..count], []);
        assert_eq!(sweep(&SegmentTraits, &BoundedPlane, &input, &mut First).is_break(), is_met);
    }
}
