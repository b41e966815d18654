//! `splitstar convert`: exact motions and triangles.

use crate::{Folder, counts, model, run};
use serde_json::json;
use splitstar::exact::Point3;
use splitstar::formats;
use splitstar::polytope::PolygonMesh;
use std::fs;

fn mesh(path: &str) -> PolygonMesh {
    formats::read(&fs::read(path).unwrap(), None).unwrap().model.shape.into_mesh().unwrap()
}

fn points(path: &str) -> Vec<Point3> {
    mesh(path).points
}

#[test]
fn without_options_nothing_changes() {
    let folder = Folder::new("convert_nothing");
    for name in ["nonconvex/ring.off", "convex/odp.xoff", "invalid/open_mesh.off", "invalid/zero_facets.off"]
    {
        let file = model(name);
        run(&["convert", &file, "-o", &folder.path("out.off")]).ok();
        let [before, after] = [&file, &folder.path("out.off")].map(|path| mesh(path));
        assert_eq!(before.points, after.points, "{name}");
        assert_eq!(before.facets, after.facets, "{name}");
    }
}

/// The models were turned by another program (`generate.py`), in rational arithmetic.
#[test]
fn rotations_agree_with_the_turned_models() {
    let folder = Folder::new("convert_models");
    let out = folder.path("out.off");
    // R(t) about an axis, t the tangent of half the angle, is the quaternion 1 + t axis. Rz(1/10) after
    // Ry(9/10) is (10 + k)(10 + 9j) = 100 - 9i + 90j + 10k.
    let rows = [
        ("dp.off", ["--rotate", "0,1,0,90"], "odp_exact90.off", ["1", "0", "1", "0"]),
        ("dp.off", ["--rotate", "0,-3,0,-90"], "odp_exact90.off", ["1", "0", "1", "0"]),
        ("dp.off", ["--quat", "100,-9,90,10"], "odp.xoff", ["100", "-9", "90", "10"]),
        ("dp.off", ["--quat", "-10/9,0.1,-1,-1/9"], "odp.xoff", ["100", "-9", "90", "10"]),
        ("gs4.off", ["--quat", "50,0,0,1"], "rgs4.xoff", ["50", "0", "0", "1"]),
        ("el16.off", ["--rotate", "1,0,0,90"], "oel16_exact90.off", ["1", "1", "0", "0"]),
    ];
    for (from, words, to, quaternion) in rows {
        let [from, to] = [from, to].map(|name| model(&format!("convex/{name}")));
        let run = run(&[&["convert", &from, "-o", &out, "--json"], &words[..]].concat());
        let shown = format!(
            "turned by the quaternion {}
",
            quaternion.join(",")
        );
        assert!(run.stderr.ends_with(&shown), "{}", run.stderr);
        let object = run.json();
        assert_eq!(object["quaternion"], json!(quaternion), "{words:?}");
        assert_eq!(points(&out), points(&to), "{words:?}");
    }
}

#[test]
fn the_order_is_scale_reflect_rotate_translate() {
    let folder = Folder::new("convert_order");
    let file = folder.write("point.off", "OFF\n1 0 0\n1 2 3\n");
    let out = folder.path("out.off");
    // (1,2,3) to (1/2,1,3/2) to (-1/2,-1,-3/2) to (1,-1/2,-3/2) to (11,-1/2,-11/6).
    let motion = ["--translate", "10,0,-1/3", "--rotate", "0,0,1,90", "--reflect", "--scale", "0.5"];
    run(&[&["convert", &file, "-o", &out][..], &motion].concat()).ok();
    assert_eq!(folder.read("out.off"), "OFF\n1 0 0\n11 -1/2 -11/6\n");
}

#[test]
fn a_map_that_reflects_keeps_the_outside_outside() {
    let folder = Folder::new("convert_reflect");
    let [tetrahedron, ring] = [model("convex/tetrahedron.off"), model("nonconvex/ring.off")];
    let out = folder.path("out.off");
    for motion in [&["--reflect"][..], &["--scale", "-1"], &["--scale", "-1", "--reflect"]] {
        for file in [&tetrahedron, &ring] {
            let before = run(&["info", file, "--json"]).json();
            run(&[&["convert", file, "-o", &out], motion].concat()).ok();
            let after = run(&["info", &out, "--json"]);
            assert!(!after.stderr.contains("inside out"), "{}", after.stderr);
            assert_eq!(after.json()["volume"], before["volume"]);
        }
    }
    // A sum with the reflection: the difference body, which is its own reflection.
    run(&["convert", &tetrahedron, "-o", &out, "--reflect"]).ok();
    let difference = run(&["sum", &tetrahedron, &out, "-o", &folder.path("sum.off"), "--json"]);
    assert!(!difference.stderr.contains("note"), "{}", difference.stderr);
    assert_eq!(counts(&difference.json()), [12, 24, 14]);
}

#[test]
fn inverse_motions_cancel() {
    let folder = Folder::new("convert_inverse");
    let file = model("convex/icosahedron.off");
    let out = folder.path("out.off");
    run(&["convert", &file, "-o", &out, "--scale", "-7/3", "--rotate", "1,2,-3,45.25"]).ok();
    let turned = run(&["info", &out, "--json"]).json();
    assert_eq!(turned["convex"], true);
    run(&["convert", &out, "-o", &out, "--rotate", "1,2,-3,-45.25"]).ok();
    run(&["convert", &out, "-o", &out, "--scale", "-3/7"]).ok();
    assert_eq!(points(&out), points(&file));
}

#[test]
fn triangles_cover_the_same_surface() {
    let folder = Folder::new("convert_triangles");
    let out = folder.path("out.off");
    // The L and the star-shaped plate have facets that are not convex.
    for name in ["nonconvex/l_shape.off", "nonconvex/ring.off", "nonconvex/mushroom.off", "convex/dp.off"] {
        let file = model(name);
        let before = run(&["info", &file, "--json"]).json();
        let after = run(&["convert", &file, "-o", &out, "--triangulate", "--json"]).json();
        for key in ["vertices", "edges", "facets", "genus", "volume", "closed", "convex", "components"] {
            assert_eq!(after[key], before[key], "{name}: {key}");
        }
        let mesh = mesh(&out);
        assert!(mesh.facets.iter().all(|cycle| cycle.len() == 3), "{name}");
    }
}

#[test]
fn triangles_are_the_way_out_for_facets_that_are_not_planar() {
    let folder = Folder::new("convert_not_planar");
    let out = folder.path("out.off");
    run(&["convert", &model("invalid/non_planar_quad.off"), "-o", &out, "--triangulate"]).ok();
    let info = run(&["info", &out, "--json"]).json();
    assert_eq!((&info["closed"], &info["genus"]), (&json!(true), &json!([0])));
    assert!(info["volume"].is_string());
}

#[test]
fn degenerate_facets_are_named() {
    let folder = Folder::new("convert_degenerate");
    let out = folder.path("out.off");
    let flat = "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n3 0 1 2\n4 0 1 2 3\n";
    let file = folder.write("flat.off", flat);
    let message = run(&["convert", &file, "-o", &out, "--triangulate"]).error(1);
    assert_eq!(message, format!("error: {file}:8: the facet encloses no area; remove it"));
    // Two triangles of different size that cross: a bow tie.
    let tie = folder.write("tie.off", "OFF\n4 1 0\n0 0 0\n2 2 0\n2 0 0\n0 4 0\n4 0 1 2 3\n");
    let message = run(&["convert", &tie, "-o", &out, "--triangulate"]).error(1);
    assert_eq!(
        message,
        format!("error: {tie}:7: the boundary of the facet crosses or touches itself; cut it by hand")
    );
    assert_eq!(folder.names(), ["flat.off", "tie.off"]);
}
