//! Pictures of maps on the sides of a cube.

use std::collections::BTreeMap;

use arrangement::models::Geodesic;
use cubical::{At, CubeSide, CubicalArrangement};
use splitstar_render::{Item, Layer, Point, Scene, Shape, SvgOptions};

#[allow(dead_code, reason = "other tests use more of it")]
mod geodesics;

use geodesics::{arc, circle, on_cube, point, polygon, sample_curves};

const AXES: [[i64; 3]; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

fn cases() -> Vec<(&'static str, Vec<Geodesic>)> {
    let [x, y, z] = AXES;
    let corners = |s: i64| [[s, 1, 1], [s, -1, 1], [s, -1, -1], [s, 1, -1]];
    let mut edges: Vec<Geodesic> = [1, -1].into_iter().flat_map(|s| polygon(&corners(s))).collect();
    edges.extend(corners(1).into_iter().map(|[_, b, c]| arc([1, b, c], [-1, b, c])));
    vec![
        ("nothing", Vec::new()),
        ("points inside, on an edge and at a corner", [[1, 2, 5], [3, 3, 1], [1, 1, 1]].map(point).into()),
        ("a circle", vec![circle([1, 2, 3], [3, -1, 2])]),
        ("three circles", vec![circle(x, y), circle(y, z), circle(z, x)]),
        ("an arc along an edge of the cube", vec![arc([2, 2, 1], [1, 1, -1])]),
        ("the edges of the cube", edges),
        ("a triangle around a corner", polygon(&[[3, 1, 1], [1, 3, 1], [1, 1, 3]])),
        ("the sample", sample_curves()),
    ]
}

fn layer<'a>(scene: &'a Scene, name: &str) -> &'a Layer {
    scene.layers().iter().find(|layer| layer.name() == name).expect("every picture has it")
}

fn area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

fn face_area(item: &Item) -> f64 {
    let Shape::Region { rings, .. } = &item.shape else { panic!("{item:?}") };
    rings.iter().map(|ring| area(ring)).sum()
}

fn sides_of<T>(map: &CubicalArrangement, count: impl Fn(CubeSide, &CubicalArrangement) -> T) -> Vec<T> {
    CubeSide::ALL.map(|side| count(side, map)).into()
}

#[test]
fn sides_are_covered_and_cells_are_told_apart() {
    for (name, curves) in cases() {
        let map = on_cube(&curves);
        let scene = Scene::of_cube(&map).unwrap();
        let names: Vec<&str> = scene.layers().iter().map(Layer::name).collect();
        assert_eq!(names, ["faces", "seams", "edges", "vertices", "labels"]);

        let faces = layer(&scene, "faces").items();
        assert!(faces.iter().all(|face| face_area(face) > 0.0), "{name}");
        let whole: f64 = faces.iter().map(face_area).sum();
        assert!((whole / 24.0 - 1.0).abs() < 1e-9, "{name}: {whole}");
        // One colour for each face, on whatever sides it lies.
        let mut styles = BTreeMap::new();
        for face in faces {
            let style = styles.entry(face.id.clone()).or_insert_with(|| face.style.clone());
            assert_eq!(*style, face.style, "{name}");
        }
        assert_eq!(styles.len(), map.face_count(), "{name}");

        let real = sides_of(&map, |side, map| {
            let edges = map.side(side).dcel().edges().filter(|&id| map.is_real_edge(At { side, id })).count();
            let vertices =
                map.side(side).vertices().filter(|&id| map.is_real_vertex(At { side, id })).count();
            [edges, vertices]
        });
        let all = sides_of(&map, |side, map| {
            [map.side(side).dcel().edge_count(), map.side(side).vertices().count()]
        });
        let total = |counts: &[[usize; 2]], i: usize| counts.iter().map(|count| count[i]).sum::<usize>();
        assert_eq!(layer(&scene, "edges").items().len(), total(&real, 0), "{name}");
        assert_eq!(layer(&scene, "seams").items().len(), total(&all, 0) - total(&real, 0), "{name}");
        let vertices = layer(&scene, "vertices").items();
        let artificial = vertices.iter().filter(|item| item.style.class.contains("artificial")).count();
        assert_eq!(vertices.len(), total(&all, 1), "{name}");
        assert_eq!(vertices.len() - artificial, total(&real, 1), "{name}");
    }
}

#[test]
fn edges_of_the_cube_may_be_edges_of_the_map() {
    let (_, curves) = cases().remove(5);
    let scene = Scene::of_cube(&on_cube(&curves)).unwrap();
    assert!(layer(&scene, "seams").items().is_empty());
    assert_eq!(layer(&scene, "edges").items().len(), 24);
}

#[test]
fn the_sample_is_the_golden_one() {
    let svg = Scene::of_cube(&on_cube(&sample_curves())).unwrap().to_svg(&SvgOptions::default());
    assert!(
        svg == include_str!("golden/cube.svg"),
        "`cargo run -p splitstar-render --example cube` prints the picture"
    );
}
