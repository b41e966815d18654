//! The names and the colours of cells in pictures of spheres.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

use arrangement::Arrangement;
use arrangement::location::{Naive, PointLocation};
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::overlay::Cell;
use arrangement::topology::Sphere;
use arrangement::traits::ApproxTraits;
use splitstar_render::{Colour, GlobeOptions, Item, Point, Scene, Shape};

#[allow(dead_code, reason = "other tests use more of it")]
mod geodesics;

use geodesics::{arc, arrange, circle, direction, point, polygon, sample, via};

type OnSphere = Arrangement<GeodesicTraits, Sphere>;

const NORTH: [i64; 3] = [0, 0, 1];
const SOUTH: [i64; 3] = [0, 0, -1];

fn cases() -> Vec<(&'static str, Vec<Geodesic>)> {
    let star = |pole: [i64; 3]| {
        let feet = [[3, 1, 0], [-1, 3, 1], [-3, -2, -1], [2, -5, 1], [-4, 0, 1], [1, 1, 0]];
        feet.map(|foot| arc(pole, foot)).to_vec()
    };
    let scattered = (0..8_i64)
        .map(|k| circle([k * 37 % 11 - 5, k * 17 % 7 - 3, 4], [3, k * 29 % 13 - 6, k * 23 % 9 - 4]));
    vec![
        ("nothing", Vec::new()),
        ("edges meet at the south pole, and nothing is at the north pole", star(SOUTH)),
        ("edges meet at the north pole, and nothing is at the south pole", star(NORTH)),
        ("edges meet at both", [star(SOUTH), star(NORTH)].concat()),
        ("a point on the north pole", vec![point(NORTH), circle([1, 0, 0], [0, 1, 0])]),
        ("a point on the south pole", vec![point(SOUTH), point([-2, 0, 1]), point([1, 2, 3])]),
        (
            "three sectors at the south pole",
            [
                polygon(&[SOUTH, [3, 1, -1], [-1, 3, 1]]),
                polygon(&[SOUTH, [-1, 3, 1], [-3, -2, 1]]),
                polygon(&[SOUTH, [-3, -2, 1], [3, 1, -1]]),
            ]
            .concat(),
        ),
        (
            "circles through both poles",
            [[1, 0], [3, 1], [-1, 4]].map(|[x, y]| circle([x, y, 0], NORTH)).to_vec(),
        ),
        (
            "arcs along and over the identification",
            vec![
                arc([-3, 0, 1], [-3, 0, -2]),
                arc([-3, 1, 4], [-3, -1, 4]),
                via([1, 1, 0], [-1, 0, 0], [1, -1, 0]),
            ],
        ),
        ("eight circles", scattered.collect()),
    ]
}

fn all() -> Vec<(&'static str, OnSphere)> {
    let cases = cases().into_iter().map(|(name, curves)| (name, arrange(&curves)));
    cases.chain([("the sample", sample())]).collect()
}

fn unfolded(arrangement: &OnSphere) -> Scene {
    Scene::of_arrangement(arrangement, None).expect("parameters are finite")
}

fn globe(arrangement: &OnSphere) -> Scene {
    Scene::of_globe(arrangement, &GlobeOptions::default()).expect("a sphere")
}

/// The items of a layer, with the numbers in their names.
fn items<'a>(scene: &'a Scene, layer: &str) -> Vec<(usize, &'a Item)> {
    let prefix = &layer[..1];
    let layer = scene.layers().iter().find(|of| of.name() == layer).expect("a layer of this name");
    let number = |item: &Item| item.id.as_ref()?.strip_prefix(prefix)?.parse().ok();
    layer.items().iter().map(|item| (number(item).expect("a name"), item)).collect()
}

fn is_near(p: Point, q: Point) -> bool {
    (p[0] - q[0]).abs() < 1e-9 && (p[1] - q[1]).abs() < 1e-9
}

#[test]
fn vertices_and_edges_are_where_their_numbers_say() {
    for (name, arrangement) in all() {
        let order = arrangement.cell_order();
        let place =
            |v| arrangement.traits().approx_point(arrangement.point(v).expect("a vertex that is a point"));
        let scene = unfolded(&arrangement);
        for (number, item) in items(&scene, "vertices") {
            let [u, height] = place(order.vertices[number]);
            match &item.shape {
                Shape::Marker { at, .. } => {
                    let is_there = is_near(*at, [u, height]) || (u == 0.0 && is_near(*at, [TAU, height]));
                    assert!(is_there, "{name}: v{number}");
                }
                Shape::Polyline(points) => assert!((points[0][1] - height).abs() < 1e-9, "{name}: v{number}"),
                other => panic!("{name}: {other:?}"),
            }
        }
        let drawn: BTreeSet<usize> = items(&scene, "edges").iter().map(|(number, _)| *number).collect();
        assert_eq!(drawn.len(), order.edges.len(), "{name}");
        for (number, item) in items(&scene, "edges") {
            let Shape::Polyline(points) = &item.shape else { panic!("{name}: {:?}", item.shape) };
            let ends = arrangement.dcel().ends(order.edges[number]).map(place);
            for (end, drawn) in ends.into_iter().zip([points[0], points[points.len() - 1]]) {
                // At a pole, the longitude is that of the edge.
                assert!((end[1] - drawn[1]).abs() < 1e-9, "{name}: e{number}");
                let is_pole = end[1].abs() > 1.57;
                assert!(is_pole || end[0] == 0.0 || is_near(end, drawn), "{name}: e{number}");
            }
            // The other edge between these ends is on another circle.
            let normal = arrangement.curve_of(order.edges[number]).circle().pole().approx_f64();
            for &[u, v] in points {
                let place = [-v.cos() * u.cos(), -v.cos() * u.sin(), v.sin()];
                let height: f64 = (0..3).map(|k| normal[k] * place[k]).sum();
                assert!(height.abs() < 1e-9, "{name}: e{number}");
            }
        }
    }
}

/// Which faces are drawn at a place of the unfolded picture.
fn faces_at(scene: &Scene, [x, y]: Point) -> Vec<usize> {
    let crosses = |(p, q): (&Point, &Point)| {
        (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    };
    let is_in = |item: &Item| match &item.shape {
        Shape::Region { rings, .. } => {
            let count = |ring: &Vec<Point>| {
                ring.iter().zip(ring.iter().cycle().skip(1)).filter(|&pair| crosses(pair)).count()
            };
            rings.iter().map(count).sum::<usize>() % 2 == 1
        }
        other => panic!("{other:?}"),
    };
    items(scene, "faces").into_iter().filter(|(_, item)| is_in(item)).map(|(number, _)| number).collect()
}

#[test]
fn faces_are_where_their_numbers_say() {
    for (name, arrangement) in all() {
        let (order, scene) = (arrangement.cell_order(), unfolded(&arrangement));
        let mut wrong = 0;
        let mut seen = BTreeSet::new();
        for (i, j) in (0..48).flat_map(|i| (0..24).map(move |j| (i, j))) {
            let [u, v] = [(f64::from(i) + 0.41) / 48.0 * TAU, ((f64::from(j) + 0.57) / 24.0 - 0.5) * PI];
            let place = [-v.cos() * u.cos(), -v.cos() * u.sin(), v.sin()].map(|c| (c * 1e9) as i64);
            let Ok(Cell::Face(face)) = Naive.locate(&arrangement, &direction(place)) else { continue };
            let number = order.faces.iter().position(|&f| f == face).expect("a face in order");
            seen.insert(number);
            // Beside edges, what is drawn straight here is not so there.
            wrong += usize::from(faces_at(&scene, [u, v]) != [number]);
        }
        assert!(wrong <= 20, "{name}: {wrong} of 1152");
        assert!(seen.len() * 3 >= order.faces.len() * 2, "{name}: {seen:?} of {}", order.faces.len());
    }
}

#[test]
fn both_pictures_have_the_same_names_and_colours() {
    for (name, arrangement) in all() {
        let [flat, round] = [unfolded(&arrangement), globe(&arrangement)];
        let names = |scene: &Scene, layer| items(scene, layer).iter().map(|of| of.0).collect::<BTreeSet<_>>();
        for layer in ["faces", "edges", "vertices"] {
            assert_eq!(names(&flat, layer), names(&round, layer), "{name}: {layer}");
        }
        assert_eq!(fills(&flat), fills(&round), "{name}");
    }
}

fn fills(scene: &Scene) -> BTreeMap<usize, Colour> {
    items(scene, "faces")
        .into_iter()
        .map(|(number, item)| (number, item.style.fill.expect("filled").colour))
        .collect()
}

#[test]
fn faces_that_share_an_edge_have_different_colours() {
    for (name, arrangement) in all() {
        let (order, dcel) = (arrangement.cell_order(), arrangement.dcel());
        let fills = fills(&globe(&arrangement));
        assert!(fills.values().all(|fill| (0..8).any(|k| *fill == Colour::pale(k))), "{name}: {fills:?}");
        for e in dcel.edges() {
            let sides = [e.halfedge(), e.halfedge().twin()].map(|h| {
                let place = order.faces.iter().position(|&f| f == dcel.face(h));
                place.expect("a face in order")
            });
            let [left, right] = sides.map(|side| fills[&side]);
            assert!(sides[0] == sides[1] || left != right, "{name}: {sides:?}");
        }
    }
}
