//! Sums, hulls and facts, and the shape of what is printed.

use crate::{Folder, counts, model, run};
use serde_json::{Value, json};
use std::fs;

fn keys(object: &Value) -> Vec<&str> {
    object.as_object().unwrap().keys().map(String::as_str).collect()
}

/// The order of the keys in the text; a map sorts them.
fn order(text: &str, keys: &[&str]) {
    let places: Vec<usize> = keys.iter().map(|key| text.find(&format!("\"{key}\":")).unwrap()).collect();
    assert!(places.is_sorted(), "{text}");
}

const FACTS: [&str; 10] = [
    "vertices",
    "edges",
    "facets",
    "dimension",
    "convex",
    "closed",
    "components",
    "genus",
    "volume",
    "bounds",
];
/// What a file says beside its cells.
const FILE: [&str; 3] = ["format", "unit", "objects"];

#[test]
fn sums_by_both_methods_in_both_orders() {
    let rows = [
        ("convex/tetrahedron.off", "convex/cube.off", [16, 24, 10]),
        ("convex/icosahedron.off", "convex/octahedron.off", [24, 42, 20]),
        ("convex/dp.off", "convex/odp.xoff", [131, 261, 132]),
        ("maxfacets/p7.off", "maxfacets/p11_rot90y.off", [180, 350, 172]),
    ];
    let folder = Folder::new("sums");
    let [first, second] = ["first.off", "second.off"].map(|name| folder.path(name));
    for (a, b, expected) in rows {
        let [a, b] = [a, b].map(model);
        let one = run(&["sum", &a, &b, "-o", &first, "--json"]).json();
        let two = run(&["sum", &b, &a, "--method", "hull", "--json", "-o", &second]).json();
        assert_eq!(counts(&one), expected);
        assert_eq!((&one["method"], &two["method"]), (&json!("overlay"), &json!("hull")));
        for key in FACTS {
            assert_eq!(one[key], two[key], "{key}");
        }
        // What is in the file is what was reported.
        for file in [&first, &second] {
            let info = run(&["info", file, "--json"]).json();
            for key in FACTS {
                assert_eq!(one[key], info[key], "{key}");
            }
            assert_eq!(info["filed"]["vertices"], one["vertices"]);
        }
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = Folder::new("bytes");
    let [a, b] = ["convex/gs4.off", "convex/rgs4.xoff"].map(model);
    for name in ["one.off", "two.off"] {
        run(&["sum", &a, &b, &a, "-o", &folder.path(name)]).ok();
    }
    assert_eq!(folder.read("one.off"), folder.read("two.off"));
}

#[test]
fn json_of_info() {
    let run = run(&["info", &model("nonconvex/ring.off"), "--json"]);
    let mut expected = FACTS.to_vec();
    expected.insert(3, "filed");
    expected.splice(4..4, FILE);
    order(&run.stdout, &expected);
    let object = run.json();
    expected.sort_unstable();
    assert_eq!(keys(&object), expected);
    let facts = json!({
        "vertices": 16, "edges": 24, "facets": 10, "filed": {"vertices": 24, "facets": 16},
        "format": "off", "unit": null, "objects": [],
        "dimension": 3, "convex": false, "closed": true, "components": 1, "genus": [1], "volume": "8",
        "bounds": {"min": ["0", "0", "0"], "max": ["3", "3", "1"]}
    });
    assert_eq!(object, facts);
}

#[test]
fn json_of_info_on_other_meshes() {
    let info = |name: &str| run(&["info", &model(name), "--json"]).json();
    let open = info("invalid/open_mesh.off");
    assert_eq!(
        (&open["closed"], &open["volume"], &open["convex"]),
        (&json!(false), &Value::Null, &json!(false))
    );
    assert_eq!((&open["genus"], counts(&open)), (&json!([null]), [8, 12, 5]));
    let void = info("nonconvex/void_cube.off");
    assert_eq!(
        (&void["components"], &void["genus"], &void["volume"]),
        (&json!(2), &json!([0, 0]), &json!("26"))
    );
    let edge = info("invalid/non_manifold_edge.off");
    assert_eq!((&edge["closed"], &edge["volume"]), (&json!(false), &Value::Null));
    let flat = info("invalid/flat.off");
    assert_eq!((&flat["dimension"], &flat["volume"], counts(&flat)), (&json!(2), &json!("0"), [3, 3, 1]));
    let dp = info("convex/odp.xoff");
    assert_eq!((counts(&dp), &dp["volume"]), ([17, 32, 17], &json!("2143151794000/3")));
    assert_eq!(dp["bounds"]["min"], json!(["-40551136/18281", "-176490932/18281", "-1765440/181"]));
}

#[test]
fn json_of_results() {
    let folder = Folder::new("json");
    let [cube, odp, out] = [model("convex/cube.off"), model("convex/odp.xoff"), folder.path("out.off")];
    let made = ["method", "width_bits", "rounding", "seconds"];
    for words in [&["sum", &cube, &odp][..], &["hull", &odp], &["convert", &odp]] {
        let run = run(&[words, &["-o", &out, "--json"]].concat());
        assert_eq!(run.stderr, "");
        let expected = [&FACTS[..3], &FILE, &FACTS[3..], &made].concat();
        order(&run.stdout, &expected);
        let object = run.json();
        assert_eq!(object.as_object().unwrap().len(), expected.len(), "{object}");
        for phase in ["read", "compute", "write"] {
            assert!(object["seconds"][phase].as_f64().unwrap() >= 0.0, "{object}");
        }
        assert!(object["width_bits"].as_u64().unwrap() > 10, "{object}");
        assert_eq!(object["convex"], true);
    }
}

#[test]
fn results_of_low_dimension() {
    let folder = Folder::new("low");
    let point = folder.write("point.off", "OFF\n1 0 0\n1/2 2 3\n");
    let x = folder.write("x.off", "OFF\n2 1 1\n0 0 0\n1 0 0\n2 0 1\n");
    let y = folder.write("y.off", "OFF\n2 1 1\n0 0 0\n0 1 0\n2 0 1\n");
    let z = folder.write("z.off", "OFF\n2 1 1\n0 0 0\n0 0 1\n2 0 1\n");
    let out = folder.path("out.off");
    let sum = |operands: &[&String]| {
        let mut words = vec!["sum", "--json", "-o", &out];
        words.extend(operands.iter().map(|operand| operand.as_str()));
        let object = run(&words).json();
        let second = folder.read("out.off").lines().nth(1).unwrap().to_string();
        (counts(&object), object["dimension"].as_u64().unwrap(), second)
    };
    assert_eq!(sum(&[&point, &point]), ([1, 0, 0], 0, "1 0 0".into()));
    assert_eq!(sum(&[&x, &point]), ([2, 1, 0], 1, "2 1 1".into()));
    assert_eq!(sum(&[&x, &x]), ([2, 1, 0], 1, "2 1 1".into()));
    assert_eq!(sum(&[&x, &y]), ([4, 4, 1], 2, "4 1 4".into()));
    assert_eq!(sum(&[&x, &y, &z]), ([8, 12, 6], 3, "8 6 12".into()));
    // What was written is read as what it was.
    run(&["sum", &x, &y, "-o", &out]).ok();
    let square = folder.write("square.off", &folder.read("out.off"));
    let prism = run(&["sum", &square, &z, &point, "-o", &out, "--json"]).json();
    assert_eq!((counts(&prism), &prism["volume"]), ([8, 12, 6], &json!("1")));
    assert_eq!(prism["bounds"], json!({"min": ["1/2", "2", "3"], "max": ["3/2", "3", "4"]}));
}

#[test]
fn hulls_of_points() {
    let folder = Folder::new("hulls");
    let out = folder.path("out.off");
    let hull = |points: &str| {
        let count = points.lines().count();
        let file = folder.write("points.off", &format!("OFF\n{count} 0 0\n{points}\n"));
        counts(&run(&["hull", &file, "-o", &out, "--json"]).json())
    };
    assert_eq!(hull("1 2 3\n1.0 4/2 3e0"), [1, 0, 0]);
    assert_eq!(hull("0 0 0\n2 2 2\n1 1 1\n0.5 1/2 5e-1"), [2, 1, 0]);
    assert_eq!(hull("0 0 0\n2 0 0\n0 2 0\n1 1 0\n0.5 0.5 0"), [3, 3, 1]);
    assert_eq!(hull("0 0 0\n2 0 0\n0 2 0\n0 0 2\n1/3 1/3 1/3"), [4, 6, 4]);
    let files = ["convex/box_x.off", "convex/box_y.off"].map(model);
    let object = run(&["hull", &files[0], &files[1], "-o", &out, "--json"]).json();
    assert_eq!(object["method"], "hull");
    assert_eq!(object["dimension"], 3);
}

#[test]
fn a_file_that_is_not_convex() {
    let folder = Folder::new("not_convex");
    let [star, cube, out] = [model("nonconvex/star.off"), model("convex/cube.off"), folder.path("out.off")];
    let message = run(&["sum", &star, &cube, "-o", &out]).error(1);
    for word in
        ["not convex: the edge from vertex ", " is reflex, between the facets ", "(line ", "; --hull "]
    {
        assert!(message.contains(word), "{message}");
    }
    // The stella octangula: its hull is a cube of side 2, its reflex vertices the centres of the facets.
    let run_hull = run(&["sum", &star, &cube, "-o", &out, "--hull", "--json"]);
    assert_eq!(run_hull.notes().len(), 1, "{}", run_hull.stderr);
    assert!(run_hull.stderr.contains("lie at most 0 inside it"), "{}", run_hull.stderr);
    assert_eq!(counts(&run_hull.json()), [8, 12, 6]);
    // Its hull is the cuboctahedron; the vertex (1,1,1) is below the facet x + y + z = 4.
    let solid = model("nonconvex/stellated_rhombic_dodecahedron.off");
    let solid = run(&["sum", &solid, &cube, "-o", &out, "--hull"]);
    assert!(solid.stderr.contains("lie at most 0.57735 inside it"), "{}", solid.stderr);
    // Of what is convex already nothing is said.
    assert_eq!(run(&["sum", &cube, &cube, "-o", &out, "--hull"]).notes(), [""; 0]);
}

#[test]
fn the_table_of_info() {
    let run = run(&["info", &model("convex/odp_exact90.off")]);
    assert_eq!(run.stderr, "");
    let expected = "\
format      off
vertices    17
edges       32
facets      17
dimension   3
convex      yes
closed      yes
components  1
genus       0
volume      2143151794000/3
minimum     0 -9808 -9808
maximum     7000 9808 9808
";
    assert_eq!(run.ok(), expected);
}

#[test]
fn floats_tell_their_rounding() {
    let folder = Folder::new("floats");
    let [odp, cube] = [model("convex/odp.xoff"), model("convex/cube.off")];
    let [exact, float] = ["exact.off", "float.off"].map(|name| folder.path(name));
    let run_float = run(&["sum", &odp, &cube, "-o", &float, "--float", "--json"]);
    assert_eq!(run_float.notes().len(), 2);
    assert!(run_float.notes()[1].contains("not planar any more"), "{}", run_float.stderr);
    assert!(run_float.stderr.contains("the largest rounding is "), "{}", run_float.stderr);
    let object = run_float.json();
    let (p, q) = object["rounding"].as_str().unwrap().split_once('/').unwrap();
    let rounding = p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap();
    // Coordinates are below 2^14: half a unit in the last place is at most 2^-40, and the decimal is as near to the double.
    assert!(rounding > 0.0 && rounding <= 2.0_f64.powi(-39), "{rounding}");
    run(&["sum", &odp, &cube, "-o", &exact]).ok();
    let [exact, float] = [exact, float].map(|path| fs::read_to_string(path).unwrap());
    for (exact, float) in exact.lines().skip(2).zip(float.lines().skip(2)) {
        for (exact, float) in exact.split(' ').zip(float.split(' ')) {
            let nearest = match exact.split_once('/') {
                Some((p, q)) => p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap(),
                None => exact.parse().unwrap(),
            };
            assert_eq!(float, format!("{nearest}"), "{exact}");
        }
    }
    // Integers are not rounded.
    let object = run(&["convert", &cube, "-o", &folder.path("float.off"), "--float", "--json"]).json();
    assert_eq!(object["rounding"], "0");
}
