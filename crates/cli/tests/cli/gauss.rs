//! `splitstar gauss`, files of Gaussian maps as operands, and the methods of `sum`.

use crate::{Folder, counts, model, run, run_with};
use serde_json::Value;

const METHODS: [&str; 5] = ["overlay", "sgm", "cgm", "lp", "hull"];

fn cells(object: &Value) -> [u64; 3] {
    ["vertices", "edges", "faces"].map(|key| object[key].as_u64().unwrap())
}

/// All methods give the same polytope: counts, volume and bounds, and the hull of one result is any other.
#[test]
fn all_methods_give_one_polytope() {
    let folder = Folder::new("gauss_methods");
    let rows: &[(&[&str], [u64; 3])] = &[
        (&["convex/cube.off", "convex/octahedron.off"], [24, 48, 26]),
        (&["convex/icosahedron.off", "convex/icosahedron.off"], [12, 30, 20]),
        (&["convex/dp.off", "convex/odp.xoff"], [131, 261, 132]),
        (&["convex/dp.off", "convex/odp_exact90.off"], [120, 238, 120]),
        (&["maxfacets/p4.off", "maxfacets/p4_rot60y.xoff", "maxfacets/p4_rot120y.xoff"], [38, 78, 42]),
    ];
    for (names, expected) in rows {
        let models: Vec<String> = names.iter().map(|name| model(name)).collect();
        let mut first: Option<Value> = None;
        let mut first_vertices: Option<Vec<String>> = None;
        for method in METHODS {
            let out = folder.path(&format!("{method}.off"));
            let mut words = vec!["sum"];
            words.extend(models.iter().map(String::as_str));
            words.extend(["-o", &out, "--method", method, "--json"]);
            let object = run(&words).json();
            assert_eq!(counts(&object), *expected, "{names:?} by {method}");
            assert_eq!(object["method"], method);
            // What is written is that polytope: its vertices have a hull of the same counts.
            let hull = run(&["hull", &out, "-o", &folder.path("hull.off"), "--json"]).json();
            assert_eq!(counts(&hull), *expected, "{names:?} by {method}");
            for key in ["volume", "bounds", "dimension"] {
                let first = first.get_or_insert_with(|| object.clone());
                assert_eq!(object[key], first[key], "{names:?} by {method}");
            }
            // The order of vertices may depend on the method; their lines have three words, those of facets more.
            let text = folder.read("hull.off");
            let mut vertices: Vec<String> =
                text.lines().filter(|line| line.split(' ').count() == 3).map(str::to_owned).collect();
            vertices.sort_unstable();
            assert!(vertices.len() as u64 >= expected[0], "{text}");
            assert_eq!(
                first_vertices.get_or_insert_with(|| vertices.clone()),
                &vertices,
                "{names:?} by {method}"
            );
        }
    }
}

#[test]
fn all_methods_take_every_dimension() {
    let folder = Folder::new("gauss_dimensions");
    let files = [
        folder.write("point.off", "OFF\n1 0 0\n1 2 3\n"),
        folder.write("segment.off", "OFF\n2 0 0\n0 0 0\n1 1/3 0\n"),
        folder.write("square.off", "OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
        model("convex/tetrahedron.off"),
    ];
    for a in &files {
        for b in &files {
            let out = folder.path("out.off");
            let by = |method| {
                let object = run(&["sum", a, b, "-o", &out, "--method", method, "--json"]).json();
                (
                    counts(&object),
                    object["dimension"].clone(),
                    object["volume"].clone(),
                    object["bounds"].clone(),
                )
            };
            let expected = by("overlay");
            METHODS.iter().for_each(|method| assert_eq!(by(method), expected, "{a} + {b} by {method}"));
        }
    }
}

/// CGAL gives wrong vertices for the first pair, and ends with a failure for the second.
#[test]
fn sums_that_others_get_wrong() {
    let folder = Folder::new("gauss_others");
    let out = folder.path("out.off");
    let points = "OFF\n8 0 0\n1 -2 2\n-1 -2 -2\n-1 -2 -1\n-1 1 2\n-2 -2 -2\n2 -2 -1\n-1 -2 1\n0 -2 1\n";
    let points = folder.write("points.off", points);
    let rows = [
        [model("convex/pentagonal_hexecontahedron.xoff"), model("convex/truncated_icosidodecahedron.xoff")],
        [points, model("convex/cube.off")],
    ];
    for [a, b] in rows {
        let by = |method| {
            let object = run(&["sum", &a, &b, "-o", &out, "--method", method, "--json"]).json();
            (counts(&object), object["volume"].clone(), object["bounds"].clone())
        };
        let expected = by("overlay");
        METHODS.iter().for_each(|method| assert_eq!(by(method), expected, "{a} + {b} by {method}"));
    }
}

/// Table 3.3 of the thesis, for the octahedron and the ellipsoid.
#[test]
fn maps_are_counted() {
    let rows = [
        ("convex/octahedron.off", "--cubical", [8, 12, 6], [24, 24, 12]),
        ("convex/octahedron.off", "--quiet", [8, 12, 6], [10, 14, 6]),
        ("convex/cube.off", "--quiet", [6, 12, 8], [6, 12, 8]),
        ("convex/el16.off", "--quiet", [512, 992, 482], [528, 1008, 482]),
        ("convex/el16.off", "--cubical", [512, 992, 482], [776, 1376, 612]),
    ];
    for (name, option, real, stored) in rows {
        let object = run(&["gauss", &model(name), option, "--json"]).json();
        assert_eq!(object["surface"], if option == "--cubical" { "cube" } else { "sphere" });
        assert_eq!(cells(&object), real, "{name} {option}");
        assert_eq!(cells(&object["with_splits"]), stored, "{name} {option}");
        let primal = &object["primal"];
        assert_eq!(counts(primal), [real[2], real[1], real[0]], "{name} {option}");
        assert_eq!(primal["dimension"], 3);
        assert!(["read", "compute", "write"].iter().all(|phase| object["seconds"][phase].is_f64()));
    }
    let table = run(&["gauss", &model("convex/cube.off")]).ok();
    assert_eq!(
        table,
        "surface     sphere\nvertices    6\nedges       12\nfaces       8\nwith splits vertices 6, edges 12, faces 8\n\
         polytope    dimension 3, vertices 8, edges 12, facets 6\n"
    );
}

/// A file of a map is a model: of its polytope.
#[test]
fn a_map_is_read_as_its_polytope() {
    let folder = Folder::new("gauss_operand");
    let (cube, octahedron) = (model("convex/cube.off"), model("convex/octahedron.off"));
    let maps = [
        ("sphere.star", vec![]),
        ("turned.star.gz", vec!["--identification", "2,1"]),
        ("cube.star", vec!["--cubical"]),
    ];
    for (name, options) in &maps {
        let map = folder.path(name);
        let mut words = vec!["gauss", &cube, "-o", &map];
        words.extend(options);
        let summary = run(&words);
        assert!(summary.stderr.starts_with("gauss: 6 vertices, 12 edges, 8 faces: "), "{}", summary.stderr);
        summary.ok();
        let info = run(&["info", &map, "--json"]).json();
        assert_eq!(
            (counts(&info), info["volume"].as_str().unwrap(), &info["convex"]),
            ([8, 12, 6], "8", &Value::Bool(true))
        );
        for method in METHODS {
            let out = folder.path("sum.off");
            let sum = run(&["sum", &map, &octahedron, "-o", &out, "--method", method, "--json"]).json();
            assert_eq!(counts(&sum), [24, 48, 26], "{name} by {method}");
        }
        let out = folder.path("cube.off");
        run(&["convert", &map, "-o", &out]).ok();
        assert_eq!(counts(&run(&["info", &out, "--json"]).json()), [8, 12, 6]);
        // The map of a map is the map.
        let again = folder.path("again.star");
        let mut words = vec!["gauss", &map, "-o", &again];
        words.extend(options);
        run(&words).ok();
        if !name.ends_with("gz") {
            assert_eq!(folder.read("again.star"), folder.read(name));
        }
    }
    let text = folder.read("sphere.star");
    let piped = run_with(&["info", "-", "--json"], text.as_bytes()).json();
    assert_eq!(counts(&piped), [8, 12, 6]);
}

#[test]
fn pictures_are_drawn() {
    let folder = Folder::new("gauss_pictures");
    let dp = model("convex/dp.off");
    let rows: [&[&str]; 4] =
        [&[], &["--view", "unfolded"], &["--cubical"], &["--identification", "0,1", "--view", "globe"]];
    for options in rows {
        let out = folder.path("map.svg");
        let mut words = vec!["gauss", &dp, "-o", &out];
        words.extend(options);
        run(&words).ok();
        let svg = folder.read("map.svg");
        assert!(svg.starts_with("<svg ") && svg.contains("data-layer=\"faces\""), "{options:?}");
        // Each face of the map has one name, wherever it is drawn.
        let mut names: Vec<&str> =
            svg.split("data-id=\"f").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), 17, "{options:?}");
    }
    let standard = run(&["gauss", &dp, "-o", "-", "--format", "svg", "--cubical"]).ok();
    assert!(standard.starts_with("<svg "));
}

#[test]
fn mistakes_are_told() {
    let folder = Folder::new("gauss_mistakes");
    let (cube, star) = (model("convex/cube.off"), model("nonconvex/star.off"));
    let out = folder.path("map.star");
    let message = run(&["gauss", &star, "-o", &out]).error(1);
    assert!(message.contains("not convex") && message.contains("--hull"), "{message}");
    let hull = run(&["gauss", &star, "--hull", "--json"]).json();
    assert_eq!(counts(&hull["primal"]), [8, 12, 6]);

    run(&["gauss", &cube, "-o", &out, "-q"]).ok();
    let changed = folder.read("map.star").replace("primal 1 1 1", "primal 1 1 2");
    let changed = folder.write("changed.star", &changed);
    for words in [vec!["info", &changed], vec!["gauss", &changed]] {
        let message = run(&words).error(1);
        assert!(
            message.contains("changed.star:3: the map of the hull of all `primal` points has"),
            "{message}"
        );
    }
    let message = run_with(&["locate", &out, "-"], b"1 0 0\n").error(1);
    assert!(message.contains("a Gaussian map (star kind `gaussian`) as an arrangement"), "{message}");
    let message = run(&["gauss", &model("curves/sphere.txt")]).error(1);
    assert!(message.contains("arrange"), "{message}");
    let message = run(&["gauss", "no_such_file.off"]).error(1);
    assert!(message.contains("no such file"), "{message}");

    let rows: [(&[&str], &str); 6] = [
        (&["gauss"], "a file to read expected, 0 given"),
        (&["gauss", "a", "b"], "one file to read expected, 2 given"),
        (&["gauss", "a", "-o", "b.off"], "a Gaussian map is not written as `.off`"),
        (&["gauss", "a", "-o", "-", "--json"], "write the map to a file"),
        (&["gauss", "a", "--cubical", "--view", "globe", "-o", "b.svg"], "`--cubical` and `--view` exclude"),
        (&["gauss", "a", "--identification", "0,0"], "is no direction"),
    ];
    for (words, expected) in rows {
        let message = run(words).error(2);
        assert!(message.contains(expected), "{message}");
    }
}
