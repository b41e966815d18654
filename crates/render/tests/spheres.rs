//! Pictures of arrangements on a sphere.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use arrangement::Arrangement;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::topology::Sphere;
use splitstar_render::{Frame, GlobeOptions, Point, RenderError, Scene, Shape, SvgOptions};

#[allow(dead_code, reason = "other tests use more of it")]
mod geodesics;
#[allow(dead_code, reason = "other tests use more of it")]
mod model;

use geodesics::{arc, arrange, circle, point, polygon, sample, via};

type OnSphere = Arrangement<GeodesicTraits, Sphere>;

/// Along axes, where edges of the cases are on the horizon, and along others.
const VIEWS: [[f64; 3]; 9] = [
    [4.0, 2.0, 2.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 1.0],
    [1.0, 3.0, -7.0],
];

const EAST: [i64; 3] = [1, 0, 0];
const WEST: [i64; 3] = [-1, 0, 0];
const NORTH: [i64; 3] = [0, 0, 1];
const SOUTH: [i64; 3] = [0, 0, -1];

fn cases() -> Vec<(&'static str, Vec<Geodesic>)> {
    let planes = [[EAST, [0, 1, 0]], [EAST, NORTH], [[0, 1, 0], NORTH]];
    let circles: Vec<Geodesic> = planes.iter().map(|&[p, q]| circle(p, q)).collect();
    let diagonal = [[1, 1], [1, -1]].into_iter().flat_map(|[a, b]: [i64; 2]| {
        [circle(NORTH, [a, b, 0]), circle([0, 1, 0], [a, 0, b]), circle(EAST, [0, a, b])]
    });
    let small = |[x, y, z]: [i64; 3], [dx, dy, dz]: [i64; 3]| [20 * x + dx, 20 * y + dy, 20 * z + dz];
    let around = |p: [i64; 3], steps: [[i64; 3]; 3]| polygon(&steps.map(|step| small(p, step)));
    vec![
        ("nothing", Vec::new()),
        ("a point", vec![point([1, 2, 3])]),
        ("the equator", vec![circles[0].clone()]),
        ("a meridian circle", vec![circles[1].clone()]),
        ("three circles", circles.clone()),
        ("an arc", vec![arc([1, 2, 0], [1, -1, 3])]),
        ("an arc over the identification", vec![arc([-3, 1, 1], [-3, -2, 2])]),
        ("an arc that ends on the identification", vec![arc([-3, 0, 1], [-3, -2, 2])]),
        ("a part of the identification", vec![arc([-3, 0, 1], [-3, 0, -2])]),
        ("all of the identification", vec![via(SOUTH, WEST, NORTH)]),
        ("half a circle and a long arc", vec![via(EAST, [0, 1, 1], WEST), via([1, 1, 0], WEST, [1, -1, 0])]),
        ("through a pole", vec![arc([1, 1, 4], [-1, -1, 4])]),
        ("two arcs end in a pole", vec![arc(NORTH, [3, 1, 0]), arc(NORTH, [2, -5, 1])]),
        (
            "beside the identification and over it",
            [polygon(&[[-3, 0, 1], [-2, -2, 1], [-2, -2, -1]]), vec![arc([-3, 1, 4], [-3, -1, 4])]].concat(),
        ),
        ("around a pole, beside the identification", polygon(&[[-3, 0, 10], [1, 3, 9], [1, -3, 9]])),
        (
            "two triangles meet on the identification",
            [
                polygon(&[[-3, 0, 1], [-2, -2, 1], [-2, -2, -1]]),
                polygon(&[[-3, 0, 1], [-2, 2, 1], [-2, 2, -1]]),
            ]
            .concat(),
        ),
        ("around a pole", around(NORTH, [[1, 0, 0], [-1, 2, 0], [-1, -2, 0]])),
        ("around the end of the identification", around(WEST, [[0, 1, 1], [0, -2, 0], [0, 1, -1]])),
        ("beside the identification", polygon(&[[-3, 0, 1], [-2, -2, 1], [-2, -2, -1]])),
        (
            "a hole",
            [
                around(EAST, [[0, -6, -6], [0, 6, -6], [0, 0, 6]]),
                around(EAST, [[0, -1, -3], [0, 1, -3], [0, 0, 1]]),
            ]
            .concat(),
        ),
        ("points on the poles", vec![point(NORTH), point(SOUTH), circles[0].clone()]),
        ("the mirrors of a cube", circles.iter().cloned().chain(diagonal).collect()),
        ("an octant", polygon(&[EAST, [0, 1, 0], NORTH])),
    ]
}

/// Arcs from anywhere to anywhere.
fn scattered(count: usize, seed: u64) -> Vec<Geodesic> {
    let mut state = seed;
    let mut coordinate = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as i64 % 1000 - 500
    };
    let mut place = || [(); 3].map(|()| coordinate());
    (0..count).map(|_| arc(place(), place())).collect()
}

fn area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

fn faces(scene: &Scene) -> Vec<&[Vec<Point>]> {
    let shapes = scene.layers()[0].items().iter().map(|item| &item.shape);
    shapes
        .map(|shape| match shape {
            Shape::Region { rings, .. } => rings.as_slice(),
            other => panic!("{other:?}"),
        })
        .collect()
}

/// Which faces are drawn at a place.
fn faces_at(scene: &Scene, [x, y]: Point) -> Vec<usize> {
    let crosses = |(p, q): (&Point, &Point)| {
        (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    };
    let crossings = |ring: &Vec<Point>| {
        ring.iter().zip(ring.iter().cycle().skip(1)).filter(|&pair| crosses(pair)).count()
    };
    let all = faces(scene).into_iter().map(|rings| rings.iter().map(crossings).sum::<usize>());
    all.enumerate().filter(|(_, count)| count % 2 == 1).map(|(face, _)| face).collect()
}

fn globe(arrangement: &OnSphere, view: [f64; 3]) -> Scene {
    let options = GlobeOptions::default().with_view(view).expect("a direction");
    Scene::of_globe(arrangement, &options).expect("a sphere")
}

fn unfolded(arrangement: &OnSphere) -> Scene {
    Scene::of_arrangement(arrangement, None).expect("parameters are finite")
}

#[test]
fn faces_fill_both_pictures_once() {
    for (name, curves) in cases() {
        let arrangement = arrange(&curves);
        let globes =
            VIEWS.map(|view| (globe(&arrangement, view), TAU, 3e-4, format!("{name} from {view:?}")));
        let rectangle = (unfolded(&arrangement), 2.0 * PI * PI, 1e-12, format!("{name}, unfolded"));
        for (scene, whole, error, name) in globes.into_iter().chain([rectangle]) {
            let areas: Vec<f64> =
                faces(&scene).iter().map(|rings| rings.iter().map(|ring| area(ring)).sum()).collect();
            assert_eq!(areas.len(), arrangement.dcel().face_count(), "{name}");
            assert!(areas.iter().all(|&area| area > 0.0), "{name}: {areas:?}");
            let sum: f64 = areas.iter().sum();
            assert!((sum / whole - 1.0).abs() < error, "{name}: {areas:?} of {whole}");
        }
    }
}

/// Where the point with parameters u and v is drawn, and how far it is from the horizon.
fn place([u, v]: Point, view: [f64; 3]) -> (Point, f64) {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let toward = view.map(|c| c / dot(view, view).sqrt());
    let [x, y, z] = toward;
    let level = (x * x + y * y).sqrt();
    let right = if level < 1e-9 { [1.0, 0.0, 0.0] } else { [-y / level, x / level, 0.0] };
    let up = [y * right[2] - z * right[1], z * right[0] - x * right[2], x * right[1] - y * right[0]];
    // The identification is behind.
    let p = [-v.cos() * u.cos(), -v.cos() * u.sin(), v.sin()];
    let depth = dot(toward, p);
    let side = if depth > 0.0 { 1.0 } else { -1.0 };
    ([side * (dot(right, p) - 1.05), dot(up, p)], depth.abs())
}

#[test]
fn both_pictures_show_the_same_faces() {
    let mut compared = 0;
    let cases = cases().into_iter().map(|(name, curves)| (name, arrange(&curves)));
    let scattered = arrange(&scattered(40, 1));
    for (name, arrangement) in cases.chain([("the sample", sample()), ("forty arcs, seed 1", scattered)]) {
        let flat = unfolded(&arrangement);
        for view in VIEWS {
            let round = globe(&arrangement, view);
            for (i, j) in (0..24).flat_map(|i| (0..12).map(move |j| (i, j))) {
                let at = [(f64::from(i) + 0.41) / 24.0 * TAU, ((f64::from(j) + 0.57) / 12.0 - 0.5) * PI];
                let (seen_at, depth) = place(at, view);
                let expected = faces_at(&flat, at);
                assert_eq!(expected.len(), 1, "{name}, unfolded: {at:?}");
                // Beside edges, what is drawn straight here is not so there.
                let is_near_edge = (0..8).any(|k| {
                    let angle = f64::from(k) / 8.0 * TAU;
                    let moved = [at[0] + 0.02 / at[1].cos() * angle.cos(), at[1] + 0.02 * angle.sin()];
                    faces_at(&flat, [moved[0].clamp(1e-9, TAU - 1e-9), moved[1]]) != expected
                });
                if depth > 0.02 && !is_near_edge {
                    assert_eq!(faces_at(&round, seen_at), expected, "{name} from {view:?}: {at:?}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 20_000, "{compared}");
}

fn ids(scene: &Scene, layer: &str) -> Vec<String> {
    let layer = scene.layers().iter().find(|of| of.name() == layer).expect("a layer of this name");
    let mut ids: Vec<String> = layer.items().iter().flat_map(|item| item.id.clone()).collect();
    ids.sort();
    ids.dedup();
    ids
}

#[test]
fn the_sample_has_all_its_cells() {
    let arrangement = sample();
    let counts = arrangement.counts();
    for scene in [globe(&arrangement, VIEWS[0]), unfolded(&arrangement)] {
        assert_eq!(ids(&scene, "faces").len(), counts.faces);
        assert_eq!(ids(&scene, "edges").len(), arrangement.dcel().edge_count());
        assert_eq!(ids(&scene, "vertices").len(), counts.vertices);
    }
}

#[test]
fn the_sample_is_the_golden_one() {
    let arrangement = sample();
    let svg = unfolded(&arrangement).to_svg(&SvgOptions::default());
    assert!(svg == include_str!("golden/unfolded.svg"), "unfolded");
    let svg = globe(&arrangement, VIEWS[0]).to_svg(&SvgOptions::default());
    assert!(svg == include_str!("golden/globe.svg"), "a globe");
}

#[test]
fn a_turned_identification_changes_no_globe() {
    let turned = [3, -4];
    let [x, y] = turned.map(f64::from);
    let options = GlobeOptions::default();
    let turned_options = options.with_identification([x, y]).unwrap();
    for (name, curves) in cases() {
        let traits = GeodesicTraits::with_identification(turned.map(Into::into)).unwrap();
        let other = Arrangement::of_curves(traits, Sphere, &curves);
        let scene = Scene::of_globe(&other, &turned_options).unwrap();
        let expected = Scene::of_globe(&arrange(&curves), &options).unwrap();
        let sorted = |scene: &Scene| {
            let mut areas: Vec<f64> =
                faces(scene).iter().map(|rings| rings.iter().map(|ring| area(ring)).sum()).collect();
            areas.sort_by(f64::total_cmp);
            areas
        };
        let pairs = sorted(&scene).into_iter().zip(sorted(&expected));
        // Points along edges are others.
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 2e-3), "{name}");
    }
}

/// How often something is drawn.
fn count(scene: &Scene, layer: usize, id: &str) -> usize {
    scene.layers()[layer].items().iter().filter(|item| item.id.as_deref() == Some(id)).count()
}

#[test]
fn what_is_on_the_identification_is_on_both_sides() {
    let scene = unfolded(&arrange(&[arc([-3, 0, 1], [-3, 0, -2])]));
    assert_eq!(count(&scene, 2, "e0"), 2);
    let drawn = ids(&scene, "vertices").iter().map(|id| count(&scene, 3, id)).collect::<Vec<_>>();
    assert_eq!(drawn, [2, 2]);
}

#[test]
fn what_is_on_the_horizon_is_in_both_discs() {
    let scene = globe(&arrange(&[arc(EAST, [0, 1, 0]), point([-1, -1, 0]), point(NORTH)]), [0.0, 0.0, 1.0]);
    assert_eq!(count(&scene, 3, "e0"), 2);
    let drawn: Vec<usize> = ids(&scene, "vertices").iter().map(|id| count(&scene, 4, id)).collect();
    assert_eq!(drawn.iter().sum::<usize>(), 3 * 2 + 1);
}

#[test]
fn a_part_of_the_parameters_is_shown() {
    let frame = Frame::new([1.0, -FRAC_PI_2], [3.0, 0.5]).unwrap();
    let scene = Scene::of_arrangement(&sample(), Some(frame)).unwrap();
    assert_eq!(*scene.frame(), frame);
    assert!(scene.to_svg(&SvgOptions::default()).contains("data-id"));
}

#[test]
fn globes_are_of_spheres() {
    let plane = model::arrange(Vec::new(), Vec::new());
    let options = GlobeOptions::default();
    assert_eq!(Scene::of_globe(&plane, &options), Err(RenderError::NotASphere));
    assert_eq!(options.with_view([0.0; 3]), Err(RenderError::NoView));
    assert_eq!(options.with_identification([0.0; 2]), Err(RenderError::NoView));
    assert!(matches!(options.with_view([f64::NAN, 0.0, 1.0]), Err(RenderError::NotFinite { .. })));
}

#[test]
fn the_graticule_can_be_left_out() {
    let options = GlobeOptions::default();
    let layers = |options: GlobeOptions| {
        let scene = Scene::of_globe(&sample(), &options).unwrap();
        scene.layers().iter().map(|layer| layer.name().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(layers(options), ["faces", "graticule", "frame", "edges", "vertices"]);
    assert_eq!(layers(options.with_graticule(false)), ["faces", "frame", "edges", "vertices"]);
}
