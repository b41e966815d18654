//! Pictures of arrangements.

use splitstar_render::{Frame, Point, Scene, Shape, SvgOptions};

mod model;

use model::{LINE, RAY, Straight, arrange, sample, straight};

/// The signed measure of a region by the even-odd rule, if its rings are nested and do not cross.
fn area(rings: &[Vec<Point>]) -> f64 {
    let twice = |ring: &Vec<Point>| -> f64 {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum()
    };
    rings.iter().map(twice).sum::<f64>() / 2.0
}

fn face_areas(scene: &Scene) -> Vec<f64> {
    let shapes = scene.layers()[0].items().iter().map(|item| &item.shape);
    shapes
        .map(|shape| match shape {
            Shape::Region { rings, .. } => area(rings),
            other => panic!("{other:?}"),
        })
        .collect()
}

#[test]
fn faces_fill_the_window_once() {
    let rows: Vec<(&str, Vec<Straight>)> = vec![
        ("one line", vec![straight([0, 0], [3, 1], LINE)]),
        ("a vertical line", vec![straight([2, 0], [2, 1], LINE)]),
        ("parallel lines", (0..5).map(|k| straight([0, k * k], [3, k * k + 1], LINE)).collect()),
        ("lines far away", vec![straight([0, 1000], [1, 1001], LINE), straight([900, 0], [901, -1], LINE)]),
        ("a pencil", (-3..4).map(|k| straight([0, 0], [2, k], LINE)).collect()),
        ("one ray", vec![straight([0, 0], [5, 1], RAY)]),
        ("one vertical ray", vec![straight([0, 0], [0, -1], RAY)]),
        (
            "rays",
            vec![
                straight([0, 0], [1, 0], RAY),
                straight([0, 0], [-1, 5], RAY),
                straight([0, 0], [0, -1], RAY),
            ],
        ),
        ("lines", (0..9).map(|k| straight([0, k * k - 20], [5, 3 * k - 7], LINE)).collect()),
    ];
    for (name, curves) in rows {
        let arrangement = arrange(curves, Vec::new());
        let scene = Scene::of_arrangement(&arrangement, None).unwrap();
        let areas = face_areas(&scene);
        assert_eq!(areas.len(), arrangement.dcel().face_count(), "{name}");
        let (min, max) = (scene.frame().min(), scene.frame().max());
        let whole = (max[0] - min[0]) * (max[1] - min[1]);
        assert!(areas.iter().all(|&area| area > 0.0), "{name}: {areas:?}");
        assert!((areas.iter().sum::<f64>() / whole - 1.0).abs() < 1e-9, "{name}: {areas:?} of {whole}");
    }
}

#[test]
fn the_sample_has_all_its_cells() {
    let arrangement = sample();
    let scene = Scene::of_arrangement(&arrangement, None).unwrap();
    let counts = arrangement.counts();
    let drawn: Vec<usize> = scene.layers().iter().map(|layer| layer.items().len()).collect();
    assert_eq!(drawn, [counts.faces, counts.edges, counts.vertices]);
    let areas = face_areas(&scene);
    let (min, max) = (scene.frame().min(), scene.frame().max());
    let whole = (max[0] - min[0]) * (max[1] - min[1]);
    // Inner CCBs run clockwise, so that holes are subtracted.
    assert!((areas.iter().sum::<f64>() / whole - 1.0).abs() < 1e-9, "{areas:?}");
    assert!(areas.iter().any(|area| (area - 34.0).abs() < 1e-9), "a hole without its island");
    assert_eq!(scene.to_svg(&SvgOptions::default()), include_str!("golden/arrangement.svg"));
}

#[test]
fn a_small_frame_shows_a_part() {
    let frame = Frame::new([2.0, 2.0], [16.0, 10.0]).unwrap();
    let scene = Scene::of_arrangement(&sample(), Some(frame)).unwrap();
    assert_eq!(*scene.frame(), frame);
    let svg = scene.to_svg(&SvgOptions::default());
    assert!(svg.contains("data-id=\"v") && svg.len() < include_str!("golden/arrangement.svg").len());
}

#[test]
fn nothing_at_all_is_one_face() {
    let scene = Scene::of_arrangement(&arrange(Vec::new(), Vec::new()), None).unwrap();
    assert_eq!(face_areas(&scene), [1.0]);
    let scene = Scene::of_arrangement(&arrange(Vec::new(), vec![[3, 4, 1]]), None).unwrap();
    assert_eq!(scene.layers().iter().map(|layer| layer.items().len()).collect::<Vec<_>>(), [1, 0, 1]);
}
