//! The way out and back, and changed files.

use super::{GOOD, mesh, read_obj};
use polytope::PolygonMesh;
use splitstar_formats::{Format, Kind, Model, Object, WriteNote, WriteOptions, Written, read, write};
use testkit::{Rng, mutate};

fn model(points: &[[&str; 3]], facets: &[&[u32]], objects: &[(&str, u32)]) -> Model {
    let mut mesh = PolygonMesh { points: Vec::new(), facets: polytope::Facets::new() };
    mesh.points.extend(points.iter().map(|p| exact::Point3::from_rationals(&p.map(|c| c.parse().unwrap()))));
    facets.iter().for_each(|cycle| mesh.facets.push(cycle));
    let mut model = Model::of_mesh(mesh);
    model.objects =
        objects.iter().map(|(name, first)| Object { name: (*name).into(), first_facet: *first }).collect();
    model
}

fn write_obj(model: &Model) -> Written {
    write(model, &WriteOptions::new(Format::Obj)).unwrap()
}

const CORNER: &[[&str; 3]] = &[["0", "0", "0"], ["1.5", "0", "0"], ["0", "-1/8", "0"], ["0", "0", "2e3"]];

#[test]
fn files_have_this_layout() {
    let rows: [(Model, &str); 5] = [
        (model(CORNER, &[], &[]), "p 1\np 2\np 3\np 4\n"),
        (model(CORNER, &[&[0, 1], &[3, 2]], &[("ends", 1)]), "l 1 2\no ends\nl 4 3\n"),
        (model(CORNER, &[&[0, 1, 2]], &[]), "f 1 2 3\n"),
        (
            model(
                CORNER,
                &[&[0, 2, 1], &[0, 1, 3], &[3, 1, 2, 0]],
                &[("", 0), ("a b", 1), ("", 2), ("empty", 3)],
            ),
            "f 1 3 2\no a b\nf 1 2 4\no\nf 4 2 3 1\n",
        ),
        (
            model(CORNER, &[&[0, 2, 1], &[0, 1, 3]], &[(" #1 \n#2\t#3#\\ ", 0), ("\u{e9}", 1)]),
            "o _1  _2 _3#_\nf 1 3 2\no \u{e9}\nf 1 2 4\n",
        ),
    ];
    let notes = [vec![WriteNote::ObjectsDropped(1)], vec![WriteNote::NamesChanged(1)]];
    let notes = std::iter::repeat_n(vec![], rows.len() - 2).chain(notes);
    for ((model, facets), notes) in rows.into_iter().zip(notes) {
        let written = write_obj(&model);
        let text = String::from_utf8(written.bytes).unwrap();
        assert_eq!(text, format!("v 0 0 0\nv 1.5 0 0\nv 0 -0.125 0\nv 0 0 2000\n{facets}"));
        assert!(written.largest_rounding.is_zero());
        assert_eq!(written.notes, notes);
    }
}

#[test]
fn written_files_come_back() {
    let facets: &[&[u32]] = &[&[0, 2, 1], &[0, 1, 3], &[3, 1, 2, 0]];
    for objects in [&[][..], &[("a  b", 0), ("c#", 2)], &[("a", 1), ("", 2)], &[("a", 0), ("a", 1), ("a", 2)]]
    {
        for facets in [facets, &[&[2, 1], &[3, 0], &[2, 0]]] {
            let model = model(CORNER, facets, objects);
            let bytes = write_obj(&model).bytes;
            let again = read(&bytes, None).unwrap();
            assert_eq!(again.format, Format::Obj);
            assert_eq!(mesh(&again).points, model.shape.mesh().unwrap().points);
            assert_eq!(mesh(&again).facets, model.shape.mesh().unwrap().facets);
            assert_eq!(again.model.objects, model.objects);
            assert_eq!(write_obj(&again.model).bytes, bytes);
        }
    }
    let points = model(CORNER, &[], &[]);
    let again = read(&write_obj(&points).bytes, None).unwrap();
    assert_eq!(mesh(&again).points, points.shape.mesh().unwrap().points);
}

#[test]
fn what_is_no_decimal_is_rounded() {
    let model = model(&[["1/3", "0.1", "1e-41"], ["1", "0", "0"], ["0", "1", "0"]], &[&[0, 1, 2]], &[]);
    let written = write_obj(&model);
    assert!(written.bytes.starts_with(b"v 0.3333333333333333 0.1 1e-41\n"));
    assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
    let again = read(&written.bytes, None).unwrap().model;
    assert_eq!(write_obj(&again).bytes, written.bytes);
}

const SPLICES: &[&[u8]] = &[
    b"\\",
    b"\\\n",
    b"\n",
    b"\r",
    b" ",
    b"#",
    b"/",
    b"//",
    b"-",
    b"0",
    b"9",
    b"-1",
    b"\0",
    b"\xFF",
    b"1e401",
    b"inf",
    b"\no x\n",
    b"\ng\n",
    b"\nl 1 2\n",
    b"\np 1\n",
    b"\nf 1 2 3\n",
    b"\nv 1 2 3\n",
    b"surf",
    b"4294967295",
    b"99999999999999999999999",
    b"vt",
    b"vn 1 2 3",
];

/// The first line stays, so that the format does.
#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x0B7;
    const CASES: usize = 20_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Rng::new(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let row = &GOOD[random.index(GOOD.len())];
        let mut text = row.text.to_vec();
        for _ in 0..=random.index(3) {
            mutate(&mut text, SPLICES, &mut random);
        }
        let text = [b"v 0 0 0\n", text.trim_ascii_start()].concat();
        match read_obj(&text) {
            Ok(read) => {
                accepted += 1;
                let again = read_obj(&write_obj(&read.model).bytes).unwrap();
                assert_eq!(mesh(&again).facets, mesh(&read).facets, "case {case}");
                assert_eq!(Kind::of(mesh(&again)), Kind::of(mesh(&read)), "case {case}");
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
}
