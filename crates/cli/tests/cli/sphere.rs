//! `splitstar arrange --surface sphere`, and `locate` in what it has written.

use crate::{Folder, model, run, run_with};
use serde_json::Value;
use std::collections::BTreeSet;

/// A file, and the numbers of vertices, edges, faces, isolated vertices and components, counted by hand.
type Row = (&'static str, &'static str, [u64; 5]);

const OCTAHEDRON: &str = "circle 1 0 0\ncircle 0 1 0\ncircle 0 0 1\n";

const ROWS: &[Row] = &[
    ("nothing", "# no curve\n", [0, 0, 1, 0, 0]),
    ("the equator", "circle 0 0 1\n", [1, 1, 2, 0, 1]),
    ("a meridian", "circle 1 0 0\n", [1, 1, 2, 0, 1]),
    ("the meridian of the identification", "circle 0 -7 0\n", [1, 1, 2, 0, 1]),
    ("a circle", "circle 1 2/3 -0.5\n", [1, 1, 2, 0, 1]),
    ("the same circle twice", "circle 1 2 3\ncircle -2 -4 -6\n", [1, 1, 2, 0, 1]),
    ("an arc", "arc 1 0 0  0 1 0\n", [2, 1, 1, 0, 1]),
    ("the longer arc", "arc 1 0 0  0 1 0  via -1 -1 0\n", [2, 1, 1, 0, 1]),
    ("both arcs", "arc 1 0 0  0 1 0\narc 0 1 0  1 0 0  via -1 -1 0\n", [2, 2, 2, 0, 1]),
    ("half a circle through a pole", "arc 1 0 0  -1 0 0  via 0 0 1\n", [2, 1, 1, 0, 1]),
    ("from pole to pole", "arc 0 0 1  0 0 -1  via 1 1 0\n", [2, 1, 1, 0, 1]),
    ("along the identification", "arc -1 0 -1  -1 0 2\npoint -1 0 0\n", [3, 2, 1, 0, 1]),
    ("the identification", "arc 0 0 -1  0 0 1  via -1 0 0\n", [2, 1, 1, 0, 1]),
    ("across the identification", "arc -1 -1 0  -1 1 0\n", [2, 1, 1, 0, 1]),
    ("points on poles and sides", "point 0 0 1\npoint 0 0 -3\npoint -1 0 0\npoint -2 0 0\n", [3, 0, 1, 3, 3]),
    ("a point on a pole that is passed", "circle 1 0 0\npoint 0 0 1\n", [1, 1, 2, 0, 1]),
    ("a crossing", "arc 1 -1 1  1 1 -1\narc 1 1 1  1 -1 -1\n", [5, 4, 1, 0, 1]),
    ("an overlap", "arc 1 0 0  0 1 0\narc 1 1 0  -1 1 0\n", [4, 3, 1, 0, 1]),
    ("an arc of a circle", "circle 0 0 1\narc 1 0 0  0 1 0\n", [2, 2, 2, 0, 1]),
    ("two circles", "circle 1 2 3\ncircle 3 2 1\n", [2, 4, 4, 0, 1]),
    ("three circles", OCTAHEDRON, [6, 12, 8, 0, 1]),
    (
        "five circles through the poles",
        "circle 1 0 0\ncircle 0 1 0\ncircle 1 1 0\ncircle 1 -1 0\ncircle 1 2 0\n",
        [2, 10, 10, 0, 1],
    ),
    ("three circles through two points", "circle 1 -1 0\ncircle 0 1 -1\ncircle 1 0 -1\n", [2, 6, 6, 0, 1]),
    ("a triangle of arcs", "arc 1 0 0  0 1 0\narc 0 1 0  0 0 1\narc 0 0 1  1 0 0\n", [3, 3, 2, 0, 1]),
    ("a closed polyline", "polyline 1 0 0  0 1 0  0 0 1  1 0 0\n", [1, 1, 2, 0, 1]),
    ("a polyline turns back", "polyline 1 0 0  0 1 0  1 1 0\n", [3, 2, 1, 0, 1]),
    ("a polyline and a circle", "polyline 1 0 1  1 1 -1  0 1 1\ncircle 0 0 1\n", [4, 5, 3, 0, 1]),
    (
        "two caps",
        "polyline 1 0 9  -1 1 9  -1 -1 9  1 0 9\npolyline 1 0 -9  -1 1 -9  -1 -1 -9  1 0 -9\n",
        [2, 2, 3, 0, 2],
    ),
    (
        "GeoJSON around a pole",
        "{\"type\":\"Polygon\",\"coordinates\":[[[0,80],[90,80.0],[180,80],[-90,80],[360,80]]]}\n",
        [1, 1, 2, 0, 1],
    ),
    (
        "GeoJSON to the poles",
        "{\"type\":\"MultiLineString\",\"coordinates\":[[[0,-90],[10,0],[20,90]],[[77,90],[100,0],[0,-90]]]}\n",
        [2, 2, 2, 0, 1],
    ),
    (
        "GeoJSON across the antimeridian",
        "{\"type\":\"Polygon\",\"coordinates\":[[[170,-10],[-170,-10],[-170,10],[170,10],[170,-10]]]}\n\
         {\"type\":\"MultiPoint\",\"coordinates\":[[180,0],[-180,0],[0,0],[12,90]]}\n",
        [4, 1, 2, 3, 4],
    ),
    (
        "neighbours",
        "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\nPOLYGON ((10 0, 20 0, 20 10, 10 10, 10 0))\n",
        [2, 3, 3, 0, 1],
    ),
];

const KEYS: [&str; 5] = ["vertices", "edges", "faces", "isolated", "components"];

fn cells(object: &Value) -> [u64; 5] {
    KEYS.map(|key| object[key].as_u64().unwrap())
}

fn with_splits(object: &Value) -> [u64; 3] {
    ["vertices", "edges", "faces"].map(|key| object["with_splits"][key].as_u64().unwrap())
}

/// The identification passes through vertices, along curves, and nowhere in particular.
const IDENTIFICATIONS: [&str; 7] = ["-1,0", "1,0", "0,1", "1,1", "-1,-1", "3,-7", "1/3,0.125"];

#[test]
fn cells_are_counted_wherever_the_sphere_is_cut_open() {
    let folder = Folder::new("sphere_counts");
    for (name, text, counts) in ROWS {
        let file = folder.write("curves.txt", text);
        for identification in IDENTIFICATIONS {
            let words = ["arrange", "--surface", "sphere", "--identification", identification, &file];
            let object = run(&[&words[..], &["--json"]].concat()).json();
            assert_eq!(cells(&object), *counts, "{name} at {identification}");
            // Euler's relation.
            let ([v, e, f], components) = (with_splits(&object), counts[4]);
            assert_eq!((v + f, f), (e + 1 + components, counts[2]), "{name} at {identification}");
        }
        let words = ["arrange", "--surface", "sphere", &file];
        let object = run(&[&words[..], &["--json"]].concat()).json();
        assert_eq!(cells(&object), *counts, "{name}");
        let [_, edges, faces] = with_splits(&object);
        for view in ["globe", "unfolded"] {
            let picture = run(&[&words[..], &["-o", "-", "--format", "svg", "--view", view]].concat()).ok();
            assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"), "{name}, {view}");
            let drawn: BTreeSet<&str> =
                picture.split("data-id=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
            let count = |cell: char| drawn.iter().filter(|id| id.starts_with(cell)).count() as u64;
            assert_eq!([count('e'), count('f')], [edges, faces], "{name}, {view}");
        }
        let star = run(&[&words[..], &["-o", "-"]].concat()).ok();
        let read = splitstar::formats::read_arrangement(star.as_bytes(), None)
            .unwrap_or_else(|error| panic!("{name}: {error}\n{star}"));
        let seen = read.counts();
        let seen = [seen.vertices, seen.edges, seen.faces, seen.isolated, seen.components];
        assert_eq!(seen.map(|n| n as u64), *counts, "{name}, read back");
        assert_eq!(splitstar::formats::write_arrangement(&read), star.as_bytes(), "{name}, written again");
    }
}

#[test]
fn the_order_of_curves_does_not_matter() {
    for (name, text, _) in ROWS.iter().filter(|row| !row.1.contains('{')) {
        let star = |text: &str| {
            run_with(&["arrange", "-q", "--surface", "sphere", "-", "-o", "-"], text.as_bytes()).ok()
        };
        let lines: Vec<&str> = text.lines().rev().collect();
        assert_eq!(star(text), star(&lines.join("\n")), "{name}");
    }
}

#[test]
fn the_mirrors_of_the_cube_are_counted() {
    let file = model("curves/sphere.txt");
    let more = "circle 1 1 1\ncircle 1 1 -1\ncircle 1 -1 1\ncircle -1 1 1\n";
    for identification in IDENTIFICATIONS {
        let words = ["arrange", "--surface", "sphere", "--json", "--identification", identification, &file];
        assert_eq!(cells(&run(&words).json()), [26, 72, 48, 0, 1], "{identification}");
        let all = run_with(&[&words[..], &["-"]].concat(), more.as_bytes()).json();
        assert_eq!(cells(&all), [50, 144, 96, 0, 1], "{identification}");
    }
}

#[test]
fn without_an_output_there_is_a_table() {
    let told =
        run_with(&["arrange", "--surface", "sphere", "-"], b"circle 0 0 1\narc 0 0 1  0 0 -1  via 1 0 0\n");
    assert_eq!(told.stderr, "");
    let table = "vertices    3\nedges       3\nfaces       2\nisolated    0\ncomponents  1\n\
                 with splits vertices 4, edges 4, faces 2\n";
    assert_eq!(told.ok(), table);
}

#[test]
fn pictures_are_of_a_globe_unless_asked_otherwise() {
    let folder = Folder::new("sphere_pictures");
    let file = folder.write("curves.txt", OCTAHEDRON);
    let picture = |words: &[&str]| {
        run(&[&["arrange", "-q", "--surface", "sphere", &file, "-o", "-", "--format", "svg"], words].concat())
            .ok()
    };
    let globe = picture(&[]);
    assert_eq!(picture(&["--view", "globe"]), globe);
    assert_ne!(picture(&["--view", "unfolded"]), globe);
}

/// A file, and the message without its beginning `error: FILE`.
const BAD: &[(&str, &str)] = &[
    ("arc 1 0 0\n", ":1: the line ends where an arc of two points (`arc x1 y1 z1 x2 y2 z2`) was expected"),
    ("\narc 1 2 3  2 4 6\n", ":2: both ends of the arc are the same point"),
    ("arc 1 0 0  -1 0 0\n", ":1: the ends of the arc are antipodal, and every arc between them is as short"),
    ("arc 1 0 0  0 1 0  via 0 0 1\n", ":1: the point behind `via` does not lie on the great circle"),
    ("arc 1 0 0  0 1 0  via 1 0 0\n", ":1: the point behind `via` is an end of the arc"),
    ("point 0 0 1\npoint 0 0 0\n", ":2: the vector is zero, and so it has no direction"),
    ("circle 0 0 0\n", ":1: the vector is zero"),
    ("polyline 1 0 0  0 1 0  0 -1 0\n", ":1: the point is antipodal to the one before it"),
    ("segment 0 0 1 1\n", ":1: `segment` in a file of the sphere cannot be read; give `arc`, `circle`"),
    ("period 4 3\n", ":1: `period` in a file of the sphere cannot be read"),
    (
        "{\"type\":\"Point\",\n\"coordinates\":[0,90.1]}\n",
        ":2: `90.1` where a latitude from -90 to 90 degrees",
    ),
    (
        "star 1 arrangement\nsurface plane\nface 0\nend\n",
        ":1: this is an arrangement (star), not a file of curves; give the curves of which it was made; `splitstar locate` asks",
    ),
    (
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":null},{\"type\":\"Feature\",\
         \"geometry\":{\"type\":\"LineString\",\"coordinates\":[[0,10],[180,-10]]}}]}\n",
        ":1: the point is antipodal to the one before it, and every arc between them is as short; give a point between \
         (in feature 1, counted from 0)",
    ),
    ("OFF\n3 1 0\n", ":1: this is a model (OFF), not a file of curves"),
];

#[test]
fn bad_files_are_refused_with_their_lines() {
    let folder = Folder::new("sphere_bad");
    for (text, message) in BAD {
        let file = folder.write("curves.txt", text);
        let out = folder.path("out.svg");
        let said = run(&["arrange", "--surface", "sphere", &file, "-o", &out]).error(1);
        assert!(said.starts_with(&format!("error: {file}{message}")), "{text:?}: {said}");
        assert_eq!(folder.names(), ["curves.txt"], "{text:?}");
    }
}

#[test]
fn other_verbs_name_the_one_for_curves() {
    let folder = Folder::new("sphere_verbs");
    let file = folder.write("curves.txt", OCTAHEDRON);
    let message = run(&["info", &file]).error(1);
    assert!(
        message.ends_with(&format!("not a model; `splitstar arrange {file} --surface sphere` reads it")),
        "{message}"
    );
    let message = run(&["locate", &file, &file]).error(1);
    assert!(
        message.ends_with(&format!(
            "not an arrangement; `splitstar arrange {file} --surface sphere -o OUT.star` makes one"
        )),
        "{message}"
    );
}

/// The places of vertices in the unfolded picture, by their names.
fn drawn_vertices(picture: &str) -> Vec<(u32, [f64; 2])> {
    let value =
        |tag: &str, key: &str| Some(tag.split_once(&format!("{key}=\""))?.1.split('"').next()?.to_string());
    let circles = picture.split("<circle ").skip(1).filter_map(|rest| {
        let tag = rest.split("/>").next()?;
        let number = value(tag, "data-id")?.strip_prefix('v')?.parse().ok()?;
        Some((number, [value(tag, "cx")?.parse().ok()?, value(tag, "cy")?.parse().ok()?]))
    });
    circles.collect()
}

/// What is drawn, written and located has one number. Nothing is at the north pole, and edges meet at the south pole, or the other way
/// round; and in the plane there is a vertex at infinity.
#[test]
fn pictures_have_the_numbers_of_the_text() {
    let folder = Folder::new("sphere_numbers");
    for pole in [-1, 1] {
        let curves = [[2, 1, 0], [-1, 2, 1], [-3, -2, -1], [1, -2, 2]]
            .map(|[x, y, z]| format!("arc 0 0 {pole}  {x} {y} {z}\n"));
        let text = format!("{}arc 3 1 0  1 3 1\npoint 5 -1 1\n", curves.concat());
        let file = folder.write("curves.txt", &text);
        let arrange = |words: &[&str]| {
            run(&[&["arrange", "-q", "--surface", "sphere", &file, "-o", "-"], words].concat()).ok()
        };
        let star_text = arrange(&[]);
        let star = folder.write("a.star", &star_text);
        let picture = arrange(&["--format", "svg", "--view", "unfolded"]);
        let drawn = drawn_vertices(&picture);
        // Longitude, counted from the antimeridian, grows to the right; latitude upwards.
        let mut places = Vec::new();
        for line in star_text.lines().filter(|line| line.starts_with("vertex ")) {
            let words: Vec<&str> = line.split(' ').collect();
            let [x, y, z] = [2, 3, 4].map(|k| words[k].parse::<f64>().unwrap());
            let number: u32 = words[1].parse().unwrap();
            let located = run_with(&["locate", &star, "-"], format!("{x} {y} {z}\n").as_bytes()).ok();
            assert_eq!(located, format!("vertex {number}\n"));
            if (x, y) != (0.0, 0.0) && words.len() == 5 {
                places
                    .push((number, [(-y).atan2(-x).rem_euclid(std::f64::consts::TAU), z.atan2(x.hypot(y))]));
            } else if words.len() == 5 {
                assert!(picture.contains(&format!("data-id=\"v{number}\"")), "the pole: {line}");
            }
        }
        // The arcs to the north pole make one more.
        let count = if pole < 0 { 7 } else { 8 };
        assert_eq!((places.len(), drawn.len()), (count, count), "{star_text}");
        let [(_, [left, bottom]), (_, [right, top])] = [0, count - 1].map(|k| places[k]);
        let at =
            |number: u32| drawn.iter().find(|of| of.0 == number).unwrap_or_else(|| panic!("v{number}")).1;
        let [[x0, y0], [x1, y1]] = [0, count - 1].map(|k| at(places[k].0));
        for &(number, [u, v]) in &places {
            let [x, y] = at(number);
            let expected = [
                x0 + (u - left) / (right - left) * (x1 - x0),
                y0 + (v - bottom) / (top - bottom) * (y1 - y0),
            ];
            assert!(
                (x - expected[0]).abs() < 0.01 && (y - expected[1]).abs() < 0.05,
                "v{number}: {x} {y}, {expected:?}"
            );
        }
        for (letter, keyword) in [('e', "edge "), ('f', "face ")] {
            let names: BTreeSet<&str> = picture
                .split("data-id=\"")
                .skip(1)
                .filter_map(|rest| rest.split('"').next()?.strip_prefix(letter))
                .collect();
            let numbers: BTreeSet<&str> =
                star_text.lines().filter_map(|line| line.strip_prefix(keyword)?.split(' ').next()).collect();
            assert_eq!(names, numbers);
        }
    }
    let plane = folder.write("plane.txt", "line 0 0 1 0\npoint 0 1\npoint 2 3\n");
    let picture = run(&["arrange", "-q", &plane, "-o", "-", "--format", "svg"]).ok();
    let numbers: Vec<u32> = drawn_vertices(&picture).iter().map(|of| of.0).collect();
    assert_eq!(numbers, [0, 1]);
}

const STRATEGIES: [&str; 5] = ["naive", "walk", "landmarks", "trapezoids", "sweep"];

/// The number of the vertex in the text of an arrangement.
fn vertex_at(star: &str, place: &str) -> String {
    let line = star.lines().find(|line| line.starts_with("vertex ") && line.ends_with(place));
    let line = line.unwrap_or_else(|| panic!("no vertex at {place}\n{star}"));
    format!("vertex {}", line.split(' ').nth(1).unwrap())
}

#[test]
fn points_are_located() {
    let folder = Folder::new("sphere_locate");
    let curves = folder.write("curves.txt", OCTAHEDRON);
    let signs = || (0..27).map(|k| [k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1]).filter(|v| *v != [0; 3]);
    let points: String = signs().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
    let points = folder.write("points.txt", &points);
    for identification in ["-1,0", "2,3"] {
        let file = folder.path("octahedron.star");
        let words = ["arrange", "-q", "--surface", "sphere", "--identification", identification];
        run(&[&words[..], &[&curves, "-o", &file]].concat()).ok();
        let ask = |words: &[&str]| run(&[&["locate", &file, &points], words].concat()).ok();
        let answers = ask(&[]);
        for ([x, y, z], answer) in signs().zip(answers.lines()) {
            let zeros = [x, y, z].into_iter().filter(|c| *c == 0).count();
            assert!(answer.starts_with(["face", "edge", "vertex"][zeros]), "{x} {y} {z}: {answer}");
            if zeros == 2 {
                let star = folder.read("octahedron.star");
                assert_eq!(answer, vertex_at(&star, &format!(" {x} {y} {z}")));
            }
        }
        if identification == "-1,0" {
            let different: BTreeSet<&str> = answers.lines().collect();
            assert_eq!(different.len(), 26);
        }
        for strategy in STRATEGIES {
            assert_eq!(ask(&["--strategy", strategy]), answers, "{strategy} at {identification}");
        }
        for ray in ["up", "down"] {
            let met = ask(&["--ray", ray]);
            for strategy in &STRATEGIES[..4] {
                assert_eq!(
                    ask(&["--ray", ray, "--strategy", strategy]),
                    met,
                    "{strategy} at {identification}"
                );
            }
        }
    }
}

#[test]
fn all_strategies_give_the_same_bytes() {
    let folder = Folder::new("sphere_strategies");
    let more = "polyline 3 1 2  -1 2 2  -2 0 1  0 -3 1  3 1 2\npolyline 0 0 1  1 5 0  0 0 -1  -1 -5 0\npoint -1 3 1\n\
        LINESTRING (170 10, -170 20, -170.5 -88, 45 -90)\narc 0 0 -1  1 2 0  via -1 -2 0\n";
    let more = folder.write("more.txt", more);
    let coordinates = || -3..=3;
    let mut points = String::from("POINT (-170 20)\nPOINT (180 17.5)\nPOINT (45 -89.99999)\n");
    for (x, y) in coordinates().flat_map(|x| coordinates().map(move |y| (x, y))) {
        let line = |z: i32| if (x, y, z) == (0, 0, 0) { String::new() } else { format!("{x} {y} {z}\n") };
        points.extend(coordinates().map(line));
    }
    let points = folder.write("points.txt", &points);
    for identification in ["-1,0", "1,5", "7,-2"] {
        let file = folder.path("a.star");
        let words = ["arrange", "-q", "--surface", "sphere", "--identification", identification];
        run(&[&words[..], &[&model("curves/sphere.txt"), &more, "-o", &file]].concat()).ok();
        for (ray, strategies) in [
            (&[][..], &STRATEGIES[..]),
            (&["--ray", "up"], &STRATEGIES[..4]),
            (&["--ray", "down"], &STRATEGIES[..4]),
        ] {
            let ask = |strategy: &[&str]| run(&[&["locate", &file, &points], ray, strategy].concat()).ok();
            let by_default = ask(&[]);
            assert_eq!(by_default.lines().count(), 3 + 342);
            for &strategy in strategies {
                assert_eq!(
                    ask(&["--strategy", strategy]),
                    by_default,
                    "{identification} {ray:?}: {strategy}"
                );
            }
        }
    }
}

#[test]
fn rays_go_along_meridians() {
    let folder = Folder::new("sphere_rays");
    // A small triangle north of the equator, and a point at the south pole.
    let curves = "circle 0 0 1\npolyline 9 1 3  9 -1 3  9 0 5  9 1 3\npoint 0 0 -1\n";
    let file = folder.path("a.star");
    run_with(&["arrange", "-q", "--surface", "sphere", "-", "-o", &file], curves.as_bytes()).ok();
    let star = folder.read("a.star");
    let ask = |point: &str, words: &[&str]| {
        run_with(&[&["locate", &file, "-"], words].concat(), point.as_bytes()).ok().trim_end().to_string()
    };
    let [inside, north, south] = ["9 0 4", "-1 -1 3", "0 1 -5"].map(|point| ask(point, &[]));
    assert!([&inside, &north, &south].iter().all(|answer| answer.starts_with("face")));
    assert_eq!(BTreeSet::from([&inside, &north, &south]).len(), 3);
    // Nothing is at the north pole.
    assert_eq!(
        [ask("0 0 1", &[]), ask("-1 -1 3", &["--ray", "up"]), ask("0 0 1", &["--ray", "up"])],
        [(); 3].map(|()| north.clone())
    );
    let pole = vertex_at(&star, " 0 0 -1");
    assert_eq!([ask("0 0 -3", &[]), ask("0 1 -5", &["--ray", "down"])], [(); 2].map(|()| pole.clone()));
    let equator = ask("2 1 0", &[]);
    assert!(equator.starts_with("edge"));
    assert_eq!(
        [ask("2 1 -9", &["--ray", "up"]), ask("2 1 1", &["--ray", "down"])],
        [(); 2].map(|()| equator.clone())
    );
    assert_eq!(ask("9 0 1", &["--ray", "up"]), ask("9 0 3", &[]));
    // The joint of the polyline, which is no vertex.
    assert_eq!(ask("9 0 4", &["--ray", "up"]), ask("9 0 5", &[]));
}

#[test]
fn places_are_located() {
    let folder = Folder::new("sphere_places");
    let file = folder.path("a.star");
    let curves = "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}";
    run_with(&["arrange", "-q", "--surface", "sphere", "-", "-o", &file], curves.as_bytes()).ok();
    let points = "{\"type\":\"MultiPoint\",\"coordinates\":[[5,5],[365,5],[-5,5],[5,0],[10,10]]}\n1 0 0\nPOINT (5 -90)\n";
    let answers = run_with(&["locate", &file, "-"], points.as_bytes()).ok();
    let answers: Vec<&str> = answers.lines().collect();
    let [inside, again, outside, side, corner, first, pole] = answers[..] else { panic!("{answers:?}") };
    assert_eq!((inside, outside), (again, pole));
    assert!(inside.starts_with("face") && outside.starts_with("face") && inside != outside);
    assert!(side.starts_with("edge"), "{answers:?}");
    // Joints and beginnings of polylines are no vertices, unless curves are cut there.
    assert!([corner, first].iter().all(|answer| !answer.starts_with("face")), "{answers:?}");
    let object = run_with(&["locate", &file, "-", "--json"], points.as_bytes()).json();
    assert_eq!(object["points"], 7);
    assert_eq!(object["located"]["faces"], 4);
    for (text, message) in [
        (
            "1 2\n",
            "error: -:1: the line ends where a point of three coordinates (`x y z`) was expected; complete it",
        ),
        (
            "0 0 0\n",
            "error: -:1: the vector is zero, and so it has no direction; give one coordinate that is not 0",
        ),
        (
            "segment 0 0 1 1\n",
            "error: -:1: `segment` in a file of points of the sphere cannot be read; give points as `x y z` or `point x y z`, \
             or in WKT or GeoJSON",
        ),
        (
            "period 4 3\n0 0 1\n",
            "error: -:1: `period` in a file of points of the sphere cannot be read; give points as `x y z` or `point x y z`, \
             or in WKT or GeoJSON",
        ),
        (
            "circle 0 0 1\n",
            "error: -:1: a circle in a file of points; remove it, or give the points that are asked about",
        ),
        (
            "POINT (0 91)\n",
            "error: -:1: `91` where a latitude from -90 to 90 degrees behind the longitude was expected; correct it",
        ),
    ] {
        assert_eq!(run_with(&["locate", &file, "-"], text.as_bytes()).error(1), message);
    }
    let plane = folder.write("plane.star", "star 1 arrangement\nsurface plane\nface 0\nend\n");
    let message = run_with(&["locate", &plane, "-"], b"1 2 3\n").error(1);
    assert_eq!(message, "error: -:1: `3` where the end of the line was expected; correct it");
}

#[test]
fn faces_too_narrow_for_a_picture_are_noted() {
    let folder = Folder::new("sphere_narrow");
    let out = folder.path("out.svg");
    let note = format!("note: {out}: coordinates differ too little for a picture; write star");
    for (text, is_noted) in [
        ("circle 1 2 3\ncircle 1 2 3.00000000000000000001\n", [true, true]),
        ("circle 1 2 3\ncircle 1 2 3.00001\n", [false; 2]),
        ("arc 1 0 0 0 1 0\narc 0 1 0 0 0 1\n", [false; 2]),
        ("point -1 0 1e400\n", [true; 2]),
        ("# nothing\n", [false; 2]),
    ] {
        let file = folder.write("curves.txt", text);
        for (view, is_noted) in ["globe", "unfolded"].into_iter().zip(is_noted) {
            let told = run(&["arrange", &file, "-o", &out, "--surface", "sphere", "--view", view]);
            assert_eq!(told.notes().contains(&note.as_str()), is_noted, "{view} {text}: {}", told.stderr);
            told.ok();
        }
    }
    let triangle = folder.write("triangle.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0.5 1e-16 0\n");
    let told = run(&["gauss", &triangle, "-o", &out]);
    assert!(told.notes().contains(&note.as_str()), "{}", told.stderr);
}
