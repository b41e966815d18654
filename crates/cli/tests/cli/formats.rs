//! Between formats: what is kept, what is told, and how a format is known.

use crate::{Folder, Run, counts, model, program, run, run_with};
use serde_json::json;
use std::fs;

/// The formats that are read, by the names and endings they are asked for.
const FORMATS: [(&str, &str); 10] = [
    ("off", "off"),
    ("obj", "obj"),
    ("stl", "stl"),
    ("stl-ascii", "stl"),
    ("ply", "ply"),
    ("ply-big-endian", "ply"),
    ("ply-ascii", "ply"),
    ("3mf", "3mf"),
    ("wrl", "wrl"),
    ("star", "star"),
];

fn convert(from: &str, to: &str, options: &[&str]) -> Run {
    run(&[&["convert", from, "-o", to], options].concat())
}

fn info(file: &str) -> serde_json::Value {
    run(&["info", file, "--json"]).json()
}

/// Integers are exact in every format.
#[test]
fn every_format_to_every_format() {
    let folder = Folder::new("formats_pairs");
    for (name, expected, volume, genus) in
        [("convex/cube.off", [8, 12, 6], "8", 0), ("nonconvex/ring.off", [16, 24, 10], "8", 1)]
    {
        let check = |file: &str, format: &str, unit| {
            let facts = info(file);
            assert_eq!(counts(&facts), expected, "{file}");
            assert_eq!(facts["format"], format, "{file}");
            assert_eq!(facts["volume"], volume, "{file}");
            assert_eq!(facts["genus"], json!([genus]), "{file}");
            assert_eq!(facts["unit"], unit, "{file}");
        };
        let millimeter = json!("millimeter");
        for (at, (first, ending)) in FORMATS.into_iter().enumerate() {
            // Packed and not by turns.
            let packed = |number: usize| if (at + number).is_multiple_of(2) { "" } else { ".gz" };
            let one = folder.path(&format!("one-{first}.{ending}{}", packed(0)));
            convert(&model(name), &one, &["--format", &format!("{first}{}", packed(0))]).ok();
            let keeps_unit = |format: &str| matches!(format, "3mf" | "star");
            check(&one, first, if first == "3mf" { &millimeter } else { &json!(null) }.clone());
            for (number, (second, ending)) in FORMATS.into_iter().enumerate() {
                let two = folder.path(&format!("two-{second}.{ending}{}", packed(number)));
                convert(&one, &two, &["--format", &format!("{second}{}", packed(number))]).ok();
                // Without a unit, 3MF means millimeters.
                let has_unit = second == "3mf" || first == "3mf" && keeps_unit(second);
                check(&two, second, if has_unit { &millimeter } else { &json!(null) }.clone());
            }
        }
    }
}

/// Fractions: exact formats keep them, polygons of the others are no longer planar, triangles are.
#[test]
fn fractions_in_every_format() {
    let folder = Folder::new("formats_fractions");
    let model = model("convex/odp.xoff");
    let volume = json!("2143151794000/3");
    for (first, ending) in [("off", "off"), ("wrl", "wrl"), ("star", "star.gz")] {
        let one = folder.path(&format!("one.{ending}"));
        assert_eq!(convert(&model, &one, &[]).notes(), [""; 0]);
        for (second, ending) in FORMATS {
            let two = folder.path(&format!("two.{ending}"));
            let converted = convert(&one, &two, &["--format", second, "--json"]);
            let stderr = converted.stderr.clone();
            let object = converted.json();
            let facts = info(&two);
            let case = format!("{first} to {second}: {stderr}");
            if matches!(second, "off" | "wrl" | "star") {
                assert_eq!(object["rounding"], "0", "{case}");
                assert_eq!((counts(&facts), &facts["volume"]), ([17, 32, 17], &volume), "{case}");
                continue;
            }
            assert_ne!(object["rounding"], "0", "{case}");
            assert!(stderr.contains("written as floats; the largest rounding is "), "{case}");
            assert_eq!((&facts["closed"], &facts["genus"]), (&json!(true), &json!([0])), "{case}");
            if matches!(second, "stl" | "stl-ascii" | "3mf") {
                assert!(stderr.contains("the format has triangles only: 17 facets cut into 30"), "{case}");
                assert!(facts["volume"].is_string(), "{case}");
            } else {
                assert_eq!(facts["volume"], json!(null), "{case}");
                let message = convert(&two, &one, &[]).error(1);
                assert!(message.contains(" the facet is not planar: "), "{message}");
                assert!(message.ends_with("; --triangulate cuts it into triangles"), "{message}");
                convert(&two, &folder.path("cut.off"), &["--triangulate"]).ok();
            }
        }
    }
}

#[test]
fn units_are_kept_and_converted() {
    let folder = Folder::new("formats_units");
    let cube = model("convex/cube.off");
    let [inch, star, again, millimeter, out] =
        ["inch.3mf", "inch.star", "again.3mf", "millimeter.star", "out.star"].map(|name| folder.path(name));
    // What has no unit is given one; coordinates stay.
    convert(&cube, &inch, &["--unit", "inch"]).ok();
    convert(&inch, &star, &[]).ok();
    convert(&star, &again, &[]).ok();
    for file in [&inch, &star, &again] {
        let facts = info(file);
        assert_eq!((&facts["unit"], &facts["volume"]), (&json!("inch"), &json!("8")), "{file}");
    }
    assert_eq!(fs::read(&inch).unwrap(), fs::read(&again).unwrap());
    // An inch is 127/5 millimeters.
    convert(&again, &millimeter, &["--unit", "millimeter"]).ok();
    let facts = info(&millimeter);
    let volume = json!(format!("{}/125", 8 * 127_i64.pow(3)));
    assert_eq!((&facts["unit"], &facts["volume"]), (&json!("millimeter"), &volume));
    assert_eq!(facts["bounds"]["max"], json!(["127/5", "127/5", "127/5"]));
    convert(&millimeter, &out, &["--unit", "inch"]).ok();
    assert_eq!(info(&out)["volume"], "8");
    fs::remove_file(&out).unwrap();
    // A sum has one unit.
    let message = run(&["sum", &star, &cube, &millimeter, "-o", &out]).error(1);
    assert_eq!(
        message,
        format!(
            "error: {millimeter}: its unit is millimeter, that of {star} is inch; `splitstar convert --unit inch` \
             makes them one"
        )
    );
    assert!(!folder.names().contains(&"out.star".to_string()));
    assert_eq!(run(&["sum", &cube, &star, "-o", &out, "--json"]).json()["unit"], "inch");
    let off = folder.path("out.off");
    let lost = run(&["sum", &star, &cube, "-o", &off]);
    let note = format!("note: {off}: the format has no unit: inch is not written");
    assert_eq!(lost.notes().last(), Some(&note.as_str()));
}

#[test]
fn objects_are_kept() {
    let folder = Folder::new("formats_objects");
    let tetrahedron = |name: &str, at: usize| {
        format!(
            "v {at} 0 0\nv {} 0 0\nv {at} 1 0\nv {at} 0 1\no {name}\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n",
            at + 1
        )
    };
    let text = [tetrahedron("left one", 0), tetrahedron("right", 5)].concat();
    let mut file = folder.write("two.obj", &text);
    let names = json!(["left one", "right"]);
    let first = folder.path("first.obj");
    convert(&file, &first, &[]).ok();
    for name in ["a.3mf", "b.star", "c.3mf.gz", "d.star", "e.obj"] {
        let next = folder.path(name);
        convert(&file, &next, &[]).ok();
        assert_eq!(info(&next)["objects"], names, "{name}");
        file = next;
    }
    assert_eq!(fs::read(first).unwrap(), fs::read(&file).unwrap());
    let out = folder.path("out.off");
    let one = convert(&file, &out, &[]);
    let note = "the format has no objects: 2 are written as one, without their names";
    assert_eq!(one.notes(), [format!("note: {out}: {note}")]);
    assert_eq!(info(&out)["objects"], json!([]));
}

#[test]
fn a_format_is_known_by_its_content() {
    let folder = Folder::new("formats_content");
    let cube = model("convex/cube.off");
    for (format, _) in [&FORMATS[..], &[("glb", "glb")]].concat() {
        for packed in ["", ".gz"] {
            let format_name = format!("{format}{packed}");
            let written = folder.path("written");
            convert(&cube, &written, &["--format", &format_name]).ok();
            let mut command = program();
            command.args(["convert", &cube, "-o", "-", "--format", &format_name]);
            let streamed = command.output().unwrap().stdout;
            assert_eq!(streamed, fs::read(&written).unwrap(), "{format_name}");
            if format == "glb" {
                continue;
            }
            // Endings that lie, that say nothing, and no name at all.
            for name in ["liar.off", "liar.stl", "liar.obj", "liar.3mf.gz", "some.thing", "nothing"] {
                let file = folder.path(name);
                fs::write(&file, &streamed).unwrap();
                assert_eq!(info(&file)["format"], format, "{format_name} as {name}");
            }
            assert_eq!(run_with(&["info", "-", "--json"], &streamed).json()["format"], format);
        }
    }
}

#[test]
fn endings_that_are_not_known() {
    let folder = Folder::new("formats_endings");
    let cube = folder.write("cube.txt", &fs::read_to_string(model("convex/cube.off")).unwrap());
    let message = convert(&cube, &folder.path("out.txt"), &[]).error(2);
    assert!(message.starts_with("error: convert: `.txt` is the ending of no format; "), "{message}");
    for (options, name) in [(&["--format", "obj"][..], "out.txt"), (&[], "out"), (&[], "OUT.PLY.GZ")] {
        let out = folder.path(name);
        convert(&cube, &out, options).ok();
        let format = if name == "OUT.PLY.GZ" { "ply" } else { *options.get(1).unwrap_or(&"off") };
        assert_eq!(info(&out)["format"], format, "{name}");
    }
    let message = convert(&cube, &folder.path("x.off"), &["--format", "dae"]).error(2);
    assert!(message.starts_with("error: convert: unknown format `dae`: off, obj, stl, "), "{message}");
}

#[test]
fn what_is_not_read_is_named() {
    let folder = Folder::new("formats_refused");
    let cube = model("convex/cube.off");
    let [glb, packed, twice, out] =
        ["cube.glb", "cube.off.gz", "twice.gz", "out.off"].map(|n| folder.path(n));
    convert(&cube, &glb, &[]).ok();
    let message = format!("error: {glb}: glTF cannot be read; it is written only; give OBJ, STL, PLY or 3MF");
    assert_eq!(convert(&glb, &out, &[]).error(1), message);
    assert_eq!(run(&["info", &glb]).error(1), message);
    convert(&cube, &packed, &[]).ok();
    // Gzip holds at most 65535 bytes that are not packed in one block: header, block, checksum, length.
    let inner = fs::read(&packed).unwrap();
    let length = (inner.len() as u16).to_le_bytes();
    let mut outer = b"\x1F\x8B\x08\x00\x00\x00\x00\x00\x00\xFF\x01".to_vec();
    outer.extend([length[0], length[1], !length[0], !length[1]]);
    outer.extend(&inner);
    outer.extend(crate::encode::crc32(&inner).to_le_bytes());
    outer.extend((inner.len() as u32).to_le_bytes());
    fs::write(&twice, outer).unwrap();
    let message = format!("error: {twice}: gzip within gzip cannot be read; unpack it once");
    assert_eq!(run(&["info", &twice]).error(1), message);
}

#[test]
fn facets_with_holes() {
    let folder = Folder::new("formats_holes");
    let ring = model("nonconvex/ring.off");
    let [star, off, stl] = ["ring.star", "ring.off", "ring.stl"].map(|name| folder.path(name));
    let joined = format!(
        "note: {ring}: coplanar facets and collinear edges joined: 16 facets and 24 vertices became 10 and 16"
    );
    let run_star = convert(&ring, &star, &["--join"]);
    assert_eq!(run_star.notes(), [joined.as_str()]);
    assert_eq!(folder.read("ring.star").matches(" hole ").count(), 2);
    let facts = info(&star);
    assert_eq!((counts(&facts), &facts["complex"]["holes"]), ([16, 24, 10], &json!(2)));
    // A mesh has no holes.
    let refused = "not written: OFF cannot hold the holes of 2 facets; write star, or cut the facets into triangles with \
                   --triangulate";
    assert_eq!(convert(&star, &off, &[]).error(1), format!("error: {off}: {refused}"));
    assert!(!fs::exists(&off).unwrap());
    let cut = "the format has no holes: 2 facets with holes cut into 16 triangles";
    assert_eq!(
        convert(&ring, &off, &["--join", "--lossy"]).notes(),
        [joined.clone(), format!("note: {off}: {cut}")]
    );
    assert!(convert(&star, &off, &["--triangulate"]).notes().is_empty());
    assert_eq!((counts(&info(&off)), &info(&off)["volume"]), ([16, 24, 10], &json!("8")));
    // Joined and cut again.
    assert_eq!(convert(&ring, &off, &["--join", "--triangulate"]).notes(), [joined.as_str()]);
    assert_eq!((counts(&info(&off)), &info(&off)["volume"]), ([16, 24, 10], &json!("8")));
    let from_star = convert(&star, &stl, &["--lossy"]);
    let triangles = "the format has triangles only: 24 facets cut into 32";
    assert_eq!(from_star.notes(), [format!("note: {stl}: {cut}"), format!("note: {stl}: {triangles}")]);
    for file in [&off, &stl] {
        let facts = info(file);
        assert_eq!((counts(&facts), &facts["volume"]), ([16, 24, 10], &json!("8")));
        assert_eq!(facts["genus"], json!([1]));
    }
}

/// The examples of the page: vertices, edges and facets, and what OFF says of them, with `--lossy` and without.
const EXAMPLES: [([u64; 3], &str, &str); 6] = [
    ([3, 3, 1], "", ""),
    ([8, 12, 6], "OFF cannot hold 26 marks of their own", ""),
    (
        [10, 9, 1],
        "OFF cannot hold the holes of 1 facet, and 1 isolated vertex, and 1 edge of its own, and 1 facet without volume \
         behind it",
        NOTHING,
    ),
    (
        [0, 0, 1],
        "OFF cannot hold 1 unbounded cell",
        "the set is unbounded, and only star can hold it; write star, or cut it off",
    ),
    ([1, 2, 1], "OFF cannot hold 2 marks of their own, and 2 unbounded cells", NOTHING),
    ([2, 3, 0], "OFF cannot hold 2 unbounded cells", NOTHING),
];
const NOTHING: &str = "the set has no inner points, so that no mesh is left of it; write star";

#[test]
fn examples_of_the_star_format() {
    let folder = Folder::new("formats_examples");
    let page = fs::read_to_string(model("../docs/star.md")).unwrap();
    let texts: Vec<&str> =
        page.split("```star\n").skip(1).map(|rest| rest.split_once("```").unwrap().0).collect();
    assert_eq!(texts.len(), EXAMPLES.len());
    let [out, off] = ["out.star", "out.off"].map(|name| folder.path(name));
    for (text, (expected, refused, refused_lossy)) in texts.into_iter().zip(EXAMPLES) {
        let file = folder.write("example.star", text);
        assert_eq!(counts(&info(&file)), expected, "{text}");
        // They are written as they are.
        convert(&file, &out, &[]).ok();
        assert_eq!(folder.read("out.star"), text);
        for (options, refused) in [(&[][..], refused), (&["--lossy"][..], refused_lossy)] {
            let run = convert(&file, &off, options);
            if refused.is_empty() {
                run.ok();
                fs::remove_file(&off).unwrap();
                continue;
            }
            let message = run.error(1);
            assert!(message.starts_with(&format!("error: {off}: not written: {refused}")), "{message}");
            assert!(!fs::exists(&off).unwrap());
            if !refused.ends_with(" it off") && refused != NOTHING {
                let message = run_sum(&file, &off);
                let what = refused.strip_prefix("OFF cannot hold ").unwrap();
                assert!(message.contains(&format!("the file has {what}; ")), "{message}");
            }
        }
    }
}

fn run_sum(file: &str, out: &str) -> String {
    run(&["sum", file, &model("convex/cube.off"), "-o", out]).error(1)
}

#[test]
fn marks_are_left_out_only_if_it_is_allowed() {
    let folder = Folder::new("formats_marks");
    let page = fs::read_to_string(model("../docs/star.md")).unwrap();
    let open_cube = page.split("```star\n").nth(2).unwrap().split_once("```").unwrap().0;
    let file = folder.write("open.star", open_cube);
    let off = folder.path("out.off");
    let lossy = convert(&file, &off, &["--lossy"]);
    let notes = [
        "left out: 26 marks of their own",
        "the format has no objects: one is written without its name",
        "the format has no unit: millimeter is not written",
    ];
    assert_eq!(lossy.notes(), notes.map(|note| format!("note: {off}: {note}")));
    let facts = info(&off);
    assert_eq!((counts(&facts), &facts["volume"]), ([8, 12, 6], &json!("1")));
}

#[test]
fn quiet_silences_every_note() {
    let folder = Folder::new("formats_quiet");
    let soup = model("invalid/facet_soup.off");
    let page = fs::read_to_string(model("../docs/star.md")).unwrap();
    let open_cube = page.split("```star\n").nth(2).unwrap().split_once("```").unwrap().0;
    let open_cube = folder.write("open.star", open_cube);
    let [stl, off, obj] = ["out.stl", "out.off", "out.obj"].map(|name| folder.path(name));
    let [dp, ring, odp] = ["convex/dp.off", "nonconvex/ring.off", "convex/odp.xoff"].map(model);
    let zero_area = model("invalid/zero_area_facet.off");
    for words in [
        &["convert", &soup, "-o", &stl][..],
        &["convert", &ring, "-o", &off, "--join", "--lossy"],
        &["convert", &open_cube, "-o", &off, "--lossy"],
        &["convert", &odp, "-o", &obj],
        &["convert", &odp, "-o", &off, "--float"],
        &["convert", &dp, "-o", &off, "--rotate", "1,0,0,33"],
        &["sum", &soup, &zero_area, "-o", &off],
        &["sum", &ring, &soup, "-o", &off, "--hull"],
        &["info", &soup, "--json"],
    ] {
        let loud = run(words);
        assert!(!loud.notes().is_empty(), "{words:?}");
        loud.ok();
        for option in ["-q", "--quiet"] {
            let quiet = run(&[words, &[option]].concat());
            assert_eq!(quiet.stderr, "", "{words:?}");
            quiet.ok();
        }
    }
}

/// The diagonal that is chosen makes a dent here.
#[test]
fn triangles_for_a_facet_that_is_not_planar() {
    let folder = Folder::new("formats_not_planar");
    let [file, cube] = [model("invalid/non_planar_quad.off"), model("convex/cube.off")];
    let out = folder.path("out.off");
    let message = run(&["sum", &file, &cube, "-o", &out, "--triangulate"]).error(1);
    let expected = "12: not convex: the edge from vertex 5 (line 8) to vertex 7 (line 10) is reflex, between the \
                    facets 1 (line 12) and 1 (line 12); --hull takes the convex hull instead";
    assert_eq!(message, format!("error: {file}:{expected}"));
    let sum = run(&["sum", &file, &cube, "-o", &out, "--triangulate", "--hull", "--json"]);
    assert!(
        sum.notes()[0].starts_with(&format!("note: {file}: the convex hull is taken; ")),
        "{}",
        sum.stderr
    );
    assert_eq!(counts(&sum.json()), [11, 17, 8]);
}

/// A set without points is a set.
#[test]
fn the_empty_set() {
    let folder = Folder::new("formats_empty_set");
    let file = folder.write("empty.star", "star 1 complex\nend\n");
    let [out, off] = ["out.star", "out.off"].map(|name| folder.path(name));
    let facts = info(&file);
    assert_eq!((counts(&facts), &facts["dimension"], &facts["bounds"]), ([0; 3], &json!(null), &json!(null)));
    convert(&file, &out, &[]).ok();
    assert_eq!(folder.read("out.star"), folder.read("empty.star"));
    let refused = format!("error: {off}: not written: OFF cannot hold the empty set; ");
    assert!(convert(&file, &off, &[]).error(1).starts_with(&refused));
    assert_eq!(convert(&file, &off, &["--lossy"]).error(1), format!("error: {off}: not written: {NOTHING}"));
    let message = run_sum(&file, &off);
    assert!(message.contains("a closed polytope is needed, and the file has the empty set; "), "{message}");
    let message = run(&["hull", &file, "-o", &off]).error(1);
    assert!(message.ends_with("there is no vertex, and so there is no hull; give points"), "{message}");
    assert!(!fs::exists(&off).unwrap());
}
