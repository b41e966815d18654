//! The way out and back, and changed files.

use super::{GOOD, HEADER, mesh};
use polytope::PolygonMesh;
use splitstar_formats::{Format, Kind, Model, Object, WriteNote, WriteOptions, Written, read, write};
use testkit::{Rng, mutate};

fn model(points: &[[&str; 3]], facets: &[&[u32]], objects: &[(&str, u32)]) -> Model {
    let mut mesh = PolygonMesh { points: Vec::new(), facets: polytope::Facets::new() };
    mesh.points.extend(points.iter().map(|p| exact::Point3::from_rationals(&p.map(|c| c.parse().unwrap()))));
    facets.iter().for_each(|cycle| mesh.facets.push(cycle));
    let mut model = Model::of_mesh(mesh);
    let object = |&(name, first_facet): &(&str, u32)| Object { name: name.into(), first_facet };
    model.objects = objects.iter().map(object).collect();
    model
}

fn write_vrml(model: &Model, float: bool) -> Written {
    let mut options = WriteOptions::new(Format::Vrml);
    options.float = float;
    write(model, &options).unwrap()
}

const DECIMALS: &[[&str; 3]] = &[["0", "0", "0"], ["1.5", "0", "0"], ["0", "-1/8", "0"], ["0", "0", "2e3"]];
const FRACTIONS: &[[&str; 3]] =
    &[["0", "0", "0"], ["1/3", "0", "0"], ["0", "-1e399", "0"], ["0", "0", "2e3"]];
const FACETS: &[&[u32]] = &[&[0, 2, 1], &[0, 1, 3], &[3, 1, 2, 0]];

#[test]
fn files_have_this_layout() {
    let appearance = "  appearance Appearance { material Material {} }\n";
    let decimals = "Coordinate {\n      point [\n        0 0 0\n        1.5 0 0\n        0 -0.125 0\n        0 0 2000\n      \
                    ]\n    }\n";
    let written = write_vrml(&model(DECIMALS, &FACETS[..2], &[("a", 0), ("no name", 1)]), false);
    assert_eq!(
        String::from_utf8(written.bytes).unwrap(),
        format!(
            "{HEADER}DEF a Shape {{\n{appearance}  geometry IndexedFaceSet {{\n    solid TRUE\n    convex TRUE\n    \
             coord DEF points {decimals}    coordIndex [\n      0 2 1 -1\n    ]\n  }}\n}}\n\
             DEF _no_name Shape {{\n{appearance}  geometry IndexedFaceSet {{\n    solid TRUE\n    convex TRUE\n    \
             coord USE points\n    coordIndex [\n      0 1 3 -1\n    ]\n  }}\n}}\n"
        )
    );
    let written = write_vrml(&model(FRACTIONS, &[], &[]), false);
    assert!(written.largest_rounding.is_zero());
    let huge = "1".to_string() + &"0".repeat(399);
    assert_eq!(
        String::from_utf8(written.bytes).unwrap(),
        format!(
            "{HEADER}PROTO ExactCoordinate [ exposedField MFVec3f point [] field MFString exact [] ] {{\n  \
             Coordinate {{ point IS point }}\n}}\nShape {{\n{appearance}  geometry PointSet {{\n    coord \
             ExactCoordinate {{\n      point [\n        0 0 0\n        0.3333333333333333 0 0\n        0 -3e38 0\n        \
             0 0 2000\n      ]\n      exact [\n        \"0 0 0\"\n        \"1/3 0 0\"\n        \"0 -{huge} 0\"\n        \
             \"0 0 2000\"\n      ]\n    }}\n  }}\n}}\n"
        )
    );
}

#[test]
fn written_files_come_back() {
    let lines: &[&[u32]] = &[&[2, 1], &[3, 0], &[2, 0]];
    let names: [&[(&str, u32)]; 4] =
        [&[], &[("points", 0), ("points_", 2)], &[("a+b", 1), ("", 2)], &[("a", 0), ("a", 1), ("\u{e9}", 2)]];
    for objects in names {
        for points in [DECIMALS, FRACTIONS] {
            for facets in [FACETS, lines, &FACETS[..1], &[]] {
                let objects: Vec<_> =
                    objects.iter().filter(|(_, first)| (*first as usize) < facets.len()).copied().collect();
                let model = model(points, facets, &objects);
                let bytes = write_vrml(&model, false).bytes;
                let again = read(&bytes, None).unwrap();
                assert_eq!(again.format, Format::Vrml);
                assert_eq!(mesh(&again).points, model.shape.mesh().unwrap().points);
                assert_eq!(mesh(&again).facets, model.shape.mesh().unwrap().facets);
                assert_eq!(again.model.objects, model.objects);
                assert_eq!(write_vrml(&again.model, false).bytes, bytes);
            }
        }
    }
}

#[test]
fn what_is_no_name_is_made_one() {
    for name in ["1a", "-a", "a b", "a.b", "a#b", "a\"", "a{", "DEF", "TO", "eventIn", "a\u{7f}", "a\n"] {
        let objects = [(name, 0), ("_a_b", 1), (name, 2)];
        let written = write_vrml(&model(DECIMALS, FACETS, &objects), false);
        assert_eq!(written.notes, [WriteNote::NamesChanged(2)], "{name:?}");
        let again = read(&written.bytes, None).unwrap().model.objects;
        let names: Vec<&str> = again.iter().map(|object| object.name.as_str()).collect();
        assert_eq!(again.iter().map(|object| object.first_facet).collect::<Vec<_>>(), [0, 1, 2], "{name:?}");
        assert_eq!(names[1], "_a_b");
        assert!(names[0] != names[1] && names[0] != names[2] && names[1] != names[2], "{names:?}");
        assert!(names.iter().all(|name| name.starts_with('_')), "{names:?}");
    }
}

/// Found by fuzzing OBJ: the names of many objects with one name doubled in length each time.
#[test]
fn many_objects_of_one_name_have_short_names() {
    let facets = vec![&[0_u32, 1, 2][..]; 3_000];
    let objects: Vec<(&str, u32)> = (0..3_000).map(|at| ("a b", at)).collect();
    let written = write_vrml(&model(DECIMALS, &facets, &objects), false);
    assert_eq!(written.notes, [WriteNote::NamesChanged(3_000)]);
    let objects = read(&written.bytes, None).unwrap().model.objects;
    assert_eq!(objects[0].name, "_a_b");
    assert_eq!(objects[2_999].name, "_a_b_3000");
}

#[test]
fn floats_are_written_on_request() {
    let mut points = FRACTIONS.to_vec();
    points[2] = ["0", "1", "0"];
    let written = write_vrml(&model(&points, &[], &[]), true);
    assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
    assert!(!written.bytes.windows(5).any(|word| word == b"Exact"));
    let mut options = WriteOptions::new(Format::Vrml);
    options.float = true;
    let error = write(&model(FRACTIONS, &[], &[]), &options).unwrap_err();
    assert_eq!(error, splitstar_formats::WriteError::TooLargeForFloat { vertex: 2 });
}

const SPLICES: &[&[u8]] = &[
    b" ",
    b"\n",
    b"\r",
    b"#",
    b"\"",
    b"\\",
    b"{",
    b"}",
    b"[",
    b"]",
    b",",
    b"-",
    b"-1",
    b"0",
    b"9",
    b"1/3",
    b"1e401",
    b"\0",
    b" DEF a ",
    b" USE a ",
    b" NULL ",
    b" TRUE ",
    b" PROTO ",
    b" IS ",
    b" Shape { } ",
    b" children [ ] ",
    b" scale 1 2 3 ",
    b"4294967295",
    b" Group { children [ ",
    b" ] } ",
];

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x0097;
    const CASES: usize = 20_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Rng::new(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let row = &GOOD[random.index(GOOD.len())];
        let mut text = row.text.as_bytes().to_vec();
        for _ in 0..=random.index(3) {
            mutate(&mut text, SPLICES, &mut random);
        }
        match read(&[HEADER.as_bytes(), &text].concat(), None) {
            Ok(read_once) => {
                accepted += 1;
                let again = read(&write_vrml(&read_once.model, false).bytes, None).unwrap();
                assert_eq!(mesh(&again).points, mesh(&read_once).points, "case {case}");
                assert_eq!(mesh(&again).facets, mesh(&read_once).facets, "case {case}");
                assert_eq!(Kind::of(mesh(&again)), Kind::of(mesh(&read_once)), "case {case}");
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
}
