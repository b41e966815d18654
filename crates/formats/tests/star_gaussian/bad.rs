//! What is refused, with its message.

use super::{maps, on_sphere, write};
use splitstar_formats::{read_arrangement, read_gaussian_map};
use testkit::{Rng, hull, model, mutate};

/// A segment: lines 1 to 11.
const SEGMENT: &str = "\
star 1 gaussian
surface sphere -1 0
curve 0 circle 0 0 1
vertex 0 -1 0 0 artificial
edge 0 0 0 curve 0
face 0
primal 0 0 0
outer -0
face 1
primal 0 0 2
outer +0
end
";

fn message(text: &str) -> String {
    match read_gaussian_map(text.as_bytes(), None) {
        Ok(_) => panic!("it is read:\n{text}"),
        Err(error) => error.to_string(),
    }
}

/// What is written in place of what, and the message; where it ends with `here`, the advice follows.
const CHANGES: &[(&str, &str, &str)] = &[
    (
        "gaussian\n",
        "complex\n",
        "line 1: a mesh (star kind `complex`) as a Gaussian map cannot be read; give a file that begins with `star 1 gaussian`",
    ),
    (
        "gaussian\n",
        "arrangement\n",
        "line 1: an arrangement (star kind `arrangement`) as a Gaussian map cannot be read; give a file that begins with `star 1 gaussian`",
    ),
    (
        "gaussian\n",
        "map\n",
        "line 1: star kind `map` cannot be read; this program knows the kinds `complex`, `arrangement` and `gaussian` only: update it, or correct the kind",
    ),
    (
        "star 1 gaussian",
        "OFF",
        "line 1: a file of OFF as a Gaussian map cannot be read; give a star file, which begins with `star 1 gaussian`",
    ),
    (
        "star 1",
        "star 2",
        "line 1: star version 2 cannot be read; this program knows version 1 only: update it",
    ),
    (
        "surface sphere -1 0",
        "curve 0 circle 0 0 1",
        "line 2: `curve` where the second line `surface sphere DX DY` or `surface cube` was expected; correct it",
    ),
    ("sphere -1 0", "torus 1 1", "line 2: `torus` where `sphere` or `cube` was expected; correct it"),
    ("sphere -1 0", "cube 1", "line 2: `1` where the end of the line was expected; correct it"),
    (
        "sphere -1 0",
        "sphere -1",
        "line 2: the line ends where one of two coordinates of the identification arc was expected; complete it",
    ),
    (
        "sphere -1 0",
        "sphere 0 0",
        "line 2: the direction of the identification arc is zero; give one that is not",
    ),
    (
        "sphere -1 0",
        "sphere -2 0",
        "line 2: the map of the hull of all `primal` points has `surface sphere -1 0` here",
    ),
    (
        "primal 0 0 2",
        "primal 0 0",
        "line 10: the line ends where one of three coordinates was expected; complete it",
    ),
    ("primal 0 0 2", "primal 0 0 2 0", "line 10: `0` where the end of the line was expected; correct it"),
    (
        "primal 0 0 2",
        "primal 0 0 x",
        "line 10: `x` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "primal 0 0 2",
        "primal 0 0 2.0",
        "line 10: the map of the hull of all `primal` points has `primal 0 0 2` here",
    ),
    (
        "primal 0 0 2",
        "primal 0 1 2",
        "line 3: the map of the hull of all `primal` points has `curve 0 circle 0 1 2` here",
    ),
    ("primal 0 0 2", "primal 0 0 0", "line 3: the map of the hull of all `primal` points has `face 0` here"),
    (
        "primal 0 0 2",
        "primal 0 0 -2",
        "line 7: the map of the hull of all `primal` points has `primal 0 0 -2` here",
    ),
    (
        "circle 0 0 1",
        "circle 0 0 1 1",
        "line 3: the map of the hull of all `primal` points has `curve 0 circle 0 0 1` here",
    ),
    (
        "vertex 0 -1 0 0 artificial",
        "vertex 0 -1 0 0",
        "line 4: the map of the hull of all `primal` points has `vertex 0 -1 0 0 artificial` here",
    ),
    ("outer -0\n", "", "line 8: the map of the hull of all `primal` points has `outer -0` here"),
    ("outer +0\n", "", "line 11: the map of the hull of all `primal` points has `outer +0` here"),
    (
        "outer +0\n",
        "outer +0\nisolated 0\n",
        "line 12: the map of the hull of all `primal` points has `end` here",
    ),
    ("primal 0 0 0\n", "", "line 3: the map of the hull of all `primal` points has `face 0` here"),
    ("end\n", "", "line 11: the file ends where a record or `end` was expected; complete it"),
    ("end\n", "end\nend\n", "line 13: `end` after the end of the map; remove it"),
    ("end\n", "end 1\n", "line 12: `1` where the end of the line was expected; correct it"),
];

#[test]
fn every_mistake_has_its_line_and_a_way_out() {
    assert!(read_gaussian_map(SEGMENT.as_bytes(), None).is_ok());
    for &(from, to, expected) in CHANGES {
        assert!(SEGMENT.contains(from), "{from}");
        let found = message(&SEGMENT.replacen(from, to, 1));
        if expected.ends_with("here") {
            let advice = "; write it so, or correct the points, or make the map again";
            assert_eq!(found, format!("{expected}{advice}"));
        } else {
            assert_eq!(found, expected);
        }
    }
}

#[test]
fn without_points_there_is_no_map() {
    for (text, expected) in [
        ("", "the file is empty"),
        ("star 1 gaussian\n", "line 1: the file ends where `surface` was expected; complete it"),
        (
            "star 1 gaussian\nsurface cube\nend\n",
            "line 3: the file has no `primal`: write the vertex of the polytope behind each face",
        ),
    ] {
        assert!(message(text).starts_with(expected), "{}", message(text));
    }
}

#[test]
fn kinds_are_told_apart() {
    let map = write(&on_sphere(&model("convex/cube.off"), [-1, 0]));
    let error = read_arrangement(map.as_bytes(), None).map(drop).unwrap_err().to_string();
    assert_eq!(
        error,
        "line 1: a Gaussian map (star kind `gaussian`) as an arrangement cannot be read; it stands for a polytope: \
         give a file that begins with `star 1 arrangement`, or curves"
    );
    // What is wrong with a map is told to who reads a model, too.
    let error = splitstar_formats::read(map.replace("vertex 0", "vertex 1").as_bytes(), None).unwrap_err();
    assert!(error.to_string().contains("the map of the hull of all `primal` points has"), "{error}");
}

/// A long line is not shown whole.
#[test]
fn messages_are_short() {
    let corners: Vec<[i64; 3]> = (0..40).map(|x| [x, x * x, 0]).chain([[20, 700, 1]]).collect();
    for map in maps(&hull(&corners)) {
        let text = write(&map);
        let line =
            text.lines().filter(|line| line.starts_with("outer")).max_by_key(|line| line.len()).unwrap();
        let message = message(&text.replace(line, "outer +0"));
        assert!(message.len() < 400, "{message}");
    }
}

/// Whatever is done to a text: it is refused, or means the same.
#[test]
fn damaged_texts_are_refused_or_mean_the_same() {
    let splices: [&[u8]; 8] =
        [b"primal 1 2 3\n", b"face 9\n", b" 0", b"\n", b"end\n", b"-", b"1/2", b"surface cube\n"];
    let mut rng = Rng::new(99);
    for name in ["convex/cube.off", "convex/octahedron.off", "maxfacets/p5.off"] {
        for map in maps(&model(name)) {
            let text = write(&map);
            for _ in 0..150 {
                let state = rng.state();
                let mut bytes = text.clone().into_bytes();
                mutate(&mut bytes, &splices, &mut rng);
                if let Ok(read) = read_gaussian_map(&bytes, None) {
                    let again = write(&read);
                    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
                    let of_file: String = String::from_utf8_lossy(&bytes)
                        .split(['\n', '\r'])
                        .map(|line| line.split('#').next().unwrap_or("").to_owned() + "\n")
                        .collect();
                    assert_eq!(words(&again), words(&of_file), "{name}, state {state}");
                }
            }
        }
    }
}
