//! Files of placements: what is read, and what is said of wrong ones.

use splitstar_formats::{Place, pack_gzip, read_placements};

fn shown(text: &[u8]) -> Vec<String> {
    let placements = read_placements(text, None).unwrap_or_else(|error| panic!("{error}"));
    let one = |placement: &splitstar_formats::FilePlacement| {
        let translation = placement.translation.to_string();
        match &placement.rotation {
            None => translation,
            Some(q) => {
                format!("{translation} by {}", q.components().each_ref().map(ToString::to_string).join(" "))
            }
        }
    };
    placements.iter().map(one).collect()
}

#[test]
fn placements_are_read() {
    let rows: &[(&str, &[&str])] = &[
        ("", &[]),
        ("# nothing\n\n", &[]),
        ("0 0 0", &["(0, 0, 0)"]),
        ("\u{FEFF}1 -2 +3\r\n\r\n.5 1/3 -1e-1 # all of them\n", &["(1, -2, 3)", "(1/2, 1/3, -1/10)"]),
        ("1 2 3 2 0 0 4\n", &["(1, 2, 3) by 1 0 0 2"]),
        ("1 2 3 0.5 1/3 0 -1\n0 0 0 -1 0 0 0", &["(1, 2, 3) by 3 2 0 -6", "(0, 0, 0) by 1 0 0 0"]),
    ];
    for (text, expected) in rows {
        assert_eq!(shown(text.as_bytes()), *expected, "{text}");
        assert_eq!(shown(&pack_gzip(text.as_bytes())), *expected, "{text}");
    }
}

#[test]
fn wrong_placements_are_refused() {
    let rows: &[(&str, u32, &str)] = &[
        (
            "0 0\n",
            1,
            "the line ends where a translation (`x y z`, or `x y z w x y z` with a quaternion) was expected",
        ),
        ("0 0 0\n\n1\n", 3, "the line ends where a translation"),
        ("0 0 0 1\n", 1, "the line ends where a quaternion behind the translation"),
        ("0 0 0 1 0 0\n", 1, "the line ends where a quaternion behind the translation"),
        ("0 0 0 1 0 0 0 0\n", 1, "`0` where the end of the line was expected"),
        ("0 0 0 0 0 0 0\n", 1, "the quaternion is zero; 1 0 0 0 does not rotate"),
        ("0 0 zero\n", 1, "`zero` is no number"),
        ("0 0 1/0\n", 1, "`1/0`"),
        ("OFF\n8 6 12\n", 1, "`OFF` where a translation"),
        ("nan 0 0\n", 1, "`nan` where a translation"),
        ("0 nan 0\n", 1, "`nan` is not finite"),
        ("0,0,0\n", 1, "`0,0,0` is no number"),
        ("0 0 1e999\n", 1, "the exponent of `1e999` is too large"),
    ];
    for (text, line, sentence) in rows {
        let error = read_placements(text.as_bytes(), None).expect_err(text);
        assert_eq!(error.place, Some(Place::Line(*line)), "{text}");
        assert!(error.sentence().starts_with(sentence), "{text}: {error}");
    }
    let error = read_placements(b"\xFF\xFE0\x000\x00", None).expect_err("two bytes for a letter");
    assert_eq!(error.to_string(), "a text in UTF-16 cannot be read; write it in UTF-8");
}

#[test]
fn memory_is_in_proportion_to_the_file() {
    // Each line makes numbers of hundreds of digits out of few bytes.
    let text = "1e400 1e-400 1e399\n".repeat(1 << 17);
    let error = read_placements(text.as_bytes(), None).expect_err("too much");
    assert!(error.sentence().starts_with("reading it would take more than"), "{error}");
    let text = "1 0 0\n".repeat(1 << 20);
    assert_eq!(read_placements(text.as_bytes(), None).expect("small numbers").len(), 1 << 20);
}

/// The seeds of the fuzz target `placements`: four of them are read.
#[test]
fn seeds_of_the_fuzz_target() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/placements");
    let mut read = Vec::new();
    for seed in std::fs::read_dir(folder).expect("the seeds are there") {
        let path = seed.expect("an entry").path();
        let bytes = std::fs::read(&path).expect("a file");
        if read_placements(&bytes, None).is_ok() {
            read.push(path.file_name().expect("a name").to_string_lossy().into_owned());
        }
    }
    read.sort();
    assert_eq!(read, ["mixed", "packed", "rotations", "translations"]);
}
