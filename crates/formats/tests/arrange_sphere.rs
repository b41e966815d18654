//! Arrangements of curves on the sphere as files have them, and what is refused.

// A test prints its seed.
#![allow(clippy::print_stdout)]

use arrangement::models::GeodesicTraits;
use exact::Integer;
use exact::spherical::{Direction, GreatCircle, is_antipodal};
use splitstar_formats::{
    CurveError, CurveFault, SphereCurve, StarArrangement, read_arrangement, read_sphere_curves,
    write_arrangement,
};
use std::ops::ControlFlow;
use testkit::Rng;

fn at(x: i64, y: i64, z: i64) -> Direction {
    Direction::from_i64([x, y, z]).expect("not zero")
}

fn cut_at([x, y]: [i64; 2]) -> GeodesicTraits {
    GeodesicTraits::with_identification([x, y].map(Integer::from)).expect("not zero")
}

fn made(curves: &[SphereCurve], identification: [i64; 2]) -> Result<StarArrangement, CurveError> {
    StarArrangement::of_sphere_curves(curves.to_vec(), cut_at(identification))
}

/// Vertices, edges, faces, isolated vertices and components.
fn counts(arrangement: &StarArrangement) -> [usize; 5] {
    let counts = arrangement.counts();
    [counts.vertices, counts.edges, counts.faces, counts.isolated, counts.components]
}

fn check(arrangement: &StarArrangement) {
    match arrangement {
        StarArrangement::Sphere(arrangement) => assert_eq!(arrangement.check_valid(), []),
        StarArrangement::SpherePolycurves(arrangement) => assert_eq!(arrangement.check_valid(), []),
        _ => panic!("another surface"),
    }
}

#[test]
fn both_families_are_made() {
    let rows = [
        ("", false, [0, 0, 1, 0, 0]),
        ("circle 0 0 1\npoint 0 0 1\n", false, [2, 1, 2, 1, 2]),
        ("arc 1 0 0  0 1 0\narc 1 0 0  0 1 0  via -1 -1 0\n", false, [2, 2, 2, 0, 1]),
        ("polyline 1 0 0  0 1 0  0 0 1  1 0 0\narc 0 0 1  1 1 0\n", true, [2, 3, 3, 0, 1]),
        ("polyline 1 0 0  0 1 0\ncircle 0 0 1\npoint 1 0 1\n", true, [3, 2, 2, 1, 2]),
    ];
    for (text, has_polyline, expected) in rows {
        let file =
            read_sphere_curves(text.as_bytes(), None).unwrap_or_else(|error| panic!("{text}: {error}"));
        for identification in [[-1, 0], [1, 1], [0, -3]] {
            let made = made(&file.curves, identification).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert_eq!(matches!(made, StarArrangement::SpherePolycurves(_)), has_polyline, "{text}");
            check(&made);
            assert_eq!(counts(&made), expected, "{text}");
            let written = write_arrangement(&made);
            let again = read_arrangement(&written, None).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert_eq!(write_arrangement(&again), written, "{text}");
        }
    }
}

/// Curves that no reader gives, but a program may.
#[test]
fn curves_without_a_course_are_refused() {
    let rows = [
        (SphereCurve::Arc([at(1, 2, 3), at(2, 4, 6)]), CurveFault::Degenerate),
        (SphereCurve::Polyline(vec![]), CurveFault::Degenerate),
        (SphereCurve::Arc([at(1, 2, 3), at(-2, -4, -6)]), CurveFault::Antipodal),
        (SphereCurve::Polyline(vec![at(1, 0, 0), at(0, 1, 0), at(0, -1, 0)]), CurveFault::Antipodal),
        (SphereCurve::ArcVia(Box::new([at(1, 0, 0), at(1, 0, 0), at(0, 1, 0)])), CurveFault::Via),
        (SphereCurve::ArcVia(Box::new([at(1, 0, 0), at(1, 1, 1), at(0, 1, 0)])), CurveFault::Via),
        (SphereCurve::ArcVia(Box::new([at(1, 0, 0), at(-1, 0, 0), at(-1, 0, 0)])), CurveFault::Via),
        (SphereCurve::ArcVia(Box::new([at(1, 0, 0), at(0, 1, 0), at(1, 0, 0)])), CurveFault::Degenerate),
    ];
    let polyline = SphereCurve::Polyline(vec![at(1, 0, 0), at(0, 1, 0)]);
    for (curve, fault) in rows {
        for others in [vec![], vec![SphereCurve::Point(at(1, 1, 1)), polyline.clone()]] {
            let number = others.len();
            let curves: Vec<_> = others.into_iter().chain([curve.clone()]).collect();
            let error = made(&curves, [-1, 0]).map(|made| made.counts());
            assert_eq!(error, Err(CurveError { curve: number, fault }), "{curve:?}");
        }
    }
    for polyline in [vec![at(1, 2, 3)], vec![at(1, 2, 3); 3]] {
        let made = made(&[SphereCurve::Polyline(polyline)], [-1, 0]).expect("a point");
        assert_eq!(counts(&made), [1, 0, 1, 1, 1]);
    }
}

#[test]
fn a_watch_is_told_and_may_stop() {
    let curves: Vec<SphereCurve> =
        (0..4000).map(|i| SphereCurve::Arc([at(2000, i, 1), at(2000, i, 7)])).collect();
    let mut told = Vec::new();
    let made = StarArrangement::of_sphere_curves_with(curves.clone(), GeodesicTraits::new(), |progress| {
        told.push(progress.sites_met);
        ControlFlow::Continue(())
    });
    assert!(made.is_ok_and(|made| made.is_some_and(|made| made.counts().edges == 4000)));
    assert!(told.len() > 5 && told.is_sorted(), "{told:?}");
    let stop = |_| ControlFlow::Break(());
    let stopped = StarArrangement::of_sphere_curves_with(curves, GeodesicTraits::new(), stop);
    assert!(stopped.is_ok_and(|made| made.is_none()));
}

const SEED: u64 = 0x5F_A44;

/// A direction of few, often the same ones: poles, axes, diagonals.
fn direction(random: &mut Rng) -> Direction {
    loop {
        let coordinate = |random: &mut Rng| random.below(5) as i64 - 2;
        let vector = [coordinate(random), coordinate(random), coordinate(random)];
        if let Some(direction) = Direction::from_i64(vector) {
            return direction;
        }
    }
}

fn step(from: &Direction, random: &mut Rng) -> Direction {
    loop {
        let to = direction(random);
        if to != *from && !is_antipodal(from, &to) {
            return to;
        }
    }
}

fn curve(random: &mut Rng, has_polylines: bool) -> SphereCurve {
    let source = direction(random);
    let target = step(&source, random);
    match random.below(if has_polylines { 6 } else { 4 }) {
        0 => SphereCurve::Point(source),
        1 => {
            SphereCurve::Circle(GreatCircle::through(&source, &target).expect("neither equal nor antipodal"))
        }
        2 => {
            let [[a, b, c], [d, e, f]] = [source.coordinates(), target.coordinates()];
            let between = Direction::new([a + d, b + e, c + f]).expect("not antipodal");
            let via = if random.one_in(2) { between.opposite() } else { between };
            SphereCurve::ArcVia(Box::new([source, via, target]))
        }
        3 => SphereCurve::Arc([source, target]),
        _ => {
            let mut points = vec![source, target];
            for _ in 0..random.below(6) {
                let last = points.last().expect("there are two");
                points.push(step(last, random));
            }
            if random.one_in(3) && !is_antipodal(&points[0], points.last().expect("there are two")) {
                points.push(points[0].clone());
                points.dedup();
            }
            SphereCurve::Polyline(points)
        }
    }
}

/// Lines, polygons and points between few places, special ones among them, as GeoJSON has them.
fn features(random: &mut Rng) -> Vec<SphereCurve> {
    const LONGITUDES: [&str; 10] =
        ["0", "45", "90", "180", "-180", "-90", "-135.0000001", "179.9999999999", "12.3456789", "1e-9"];
    const LATITUDES: [&str; 9] = ["0", "90", "-90", "45", "-45", "89.9999999999", "1e-9", "-33.333333", "60"];
    let number = 1 + random.below(5);
    let lines: Vec<String> = (0..number)
        .map(|_| {
            let position = |random: &mut Rng| {
                let [longitude, latitude] =
                    [LONGITUDES.len(), LATITUDES.len()].map(|n| random.below(n as u64) as usize);
                format!("[{},{}]", LONGITUDES[longitude], LATITUDES[latitude])
            };
            let mut positions: Vec<String> = (0..2 + random.below(5)).map(|_| position(random)).collect();
            let kind = if random.one_in(3) { "MultiPoint" } else { "LineString" };
            if random.one_in(3) {
                positions.push(positions[0].clone());
            }
            format!("{{\"type\":\"{kind}\",\"coordinates\":[{}]}}", positions.join(","))
        })
        .collect();
    // Lines with antipodal positions in a row are refused.
    let read = |line: &String| read_sphere_curves(line.as_bytes(), None).ok();
    lines.iter().filter_map(read).flat_map(|file| file.curves).collect()
}

#[test]
fn neither_order_nor_identification_matters() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for case in 0..600 {
        let number = random.below(9);
        let mut curves: Vec<SphereCurve> = match case % 3 {
            0 => features(&mut random),
            kind => (0..number).map(|_| curve(&mut random, kind == 1)).collect(),
        };
        let expected = counts(&made(&curves, [-1, 0]).expect("curves have a course"));
        for identification in [[-1, 0], [0, 1], [1, 1], [2, -1], [7, 3]] {
            let first = made(&curves, identification).expect("curves have a course");
            check(&first);
            assert_eq!(counts(&first), expected, "case {case} at {identification:?}: {curves:?}");
            // Euler's relation.
            let [vertices, edges, faces, _, components] = expected;
            assert_eq!(vertices + faces, edges + 1 + components, "case {case}: {curves:?}");
            let text = write_arrangement(&first);
            let again = read_arrangement(&text, None).unwrap_or_else(|error| panic!("case {case}: {error}"));
            assert_eq!(write_arrangement(&again), text, "case {case}");
            curves.reverse();
            let second = made(&curves, identification).expect("curves have a course");
            assert!(write_arrangement(&second) == text, "case {case} at {identification:?}: {curves:?}");
        }
    }
}
