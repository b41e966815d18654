//! Written files, and files that were changed.

use super::{binary, good_files, mesh, packed, read_ply, text};
use exact::Point3;
use polytope::{Facets, PolygonMesh};
use splitstar_formats::{Format, Kind, Model, WriteError, WriteNote, WriteOptions, read, write};
use testkit::{Rng, mutate};

fn model(points: &[&str], facets: &[&[u32]]) -> Model {
    let point = |text: &&str| {
        let coordinates: Vec<_> = text.split(' ').map(|word| word.parse().unwrap()).collect();
        Point3::from_rationals(&coordinates.try_into().unwrap())
    };
    let mut list = Facets::new();
    facets.iter().for_each(|cycle| list.push(cycle));
    Model::of_mesh(PolygonMesh { points: points.iter().map(point).collect(), facets: list })
}

const VARIANTS: [Format; 3] = [Format::Ply, Format::PlyBigEndian, Format::PlyAscii];

#[test]
fn written_files_come_back_the_same() {
    let square = ["0 0 0", "1/2 0 0", "1/2 -3/1024 0", "0 9007199254740991 1208925819614629174706176"];
    let many: Vec<u32> = (0..300).collect();
    let circle: Vec<String> = many.iter().map(|at| format!("{at} {} 0", at * at)).collect();
    let circle: Vec<&str> = circle.iter().map(String::as_str).collect();
    let models = [
        (model(&square, &[]), Kind::Points),
        (model(&square, &[&[0, 1], &[2, 0]]), Kind::Segments),
        (model(&square, &[&[3, 1, 0, 2]]), Kind::Polygon),
        (model(&square, &[&[3, 1, 0, 2], &[0, 1, 2]]), Kind::Surface),
        (model(&circle, &[&many[..255], &many[1..256]]), Kind::Surface),
        (model(&circle, &[&many, &[0, 1, 2]]), Kind::Surface),
    ];
    for (model, kind) in &models {
        for format in VARIANTS {
            let written = write(model, &WriteOptions::new(format)).unwrap();
            assert_eq!(written.largest_rounding.to_string(), "0");
            assert_eq!(written.notes, Vec::<WriteNote>::new());
            // The content tells, whatever the name says.
            let read = read(&written.bytes, Some("stl")).unwrap();
            assert_eq!(read.format, format);
            let mesh = mesh(read);
            let original = model.shape.mesh().unwrap();
            assert_eq!(Kind::of(&mesh), *kind);
            assert_eq!((&mesh.points, &mesh.facets), (&original.points, &original.facets), "{format:?}");
        }
    }
}

#[test]
fn the_variants_look_like_this() {
    let square = model(&["0 0 0", "1 0 0", "1 1/4 0", "0 1/3 0"], &[&[0, 1, 2, 3], &[3, 2, 1, 0]]);
    let written = |format| write(&square, &WriteOptions::new(format)).unwrap();
    let header = "comment written by splitstar\nelement vertex 4\n\
         property double x\nproperty double y\nproperty double z\n\
         element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    let ascii = written(Format::PlyAscii);
    assert_eq!(
        String::from_utf8(ascii.bytes).unwrap(),
        format!(
            "ply\nformat ascii 1.0\n{header}0 0 0\n1 0 0\n1 0.25 0\n0 0.3333333333333333 0\n4 0 1 2 3\n4 3 \
             2 1 0\n"
        )
    );
    assert_eq!(ascii.largest_rounding.to_string(), "1/30000000000000000");
    let words = "d0 d0 d0 d1 d0 d0 d1 d.25 d0 d0 d0.3333333333333333 d0 B4 i0 i1 i2 i3 B4 i3 i2 i1 i0";
    for (format, order) in [(Format::Ply, "little"), (Format::PlyBigEndian, "big")] {
        let mut expected = format!("ply\nformat binary_{order}_endian 1.0\n{header}").into_bytes();
        expected.extend(packed(words, order == "big"));
        let written = written(format);
        assert_eq!(written.bytes, expected);
        assert_eq!(written.largest_rounding.to_string(), "1/54043195528445952");
    }

    let segments = model(&["0 0 0", "1 0 0"], &[&[0, 1]]);
    let written = write(&segments, &WriteOptions::new(Format::PlyAscii)).unwrap().bytes;
    let text = String::from_utf8(written).unwrap();
    assert!(text.ends_with(
        "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n0 1\n"
    ));
}

#[test]
fn what_no_double_can_say_is_refused() {
    let model = model(&["0 0 0", "0 -1e309 0"], &[]);
    for format in VARIANTS {
        let error = write(&model, &WriteOptions::new(format)).unwrap_err();
        assert_eq!(error, WriteError::TooLargeForFloat { vertex: 1 });
    }
}

const SPLICES: &[&[u8]] = &[
    b"\n",
    b"\r",
    b" ",
    b"-1",
    b"0",
    b"7",
    b"4294967294",
    b"1/3",
    b"1e400",
    b"nan",
    b"\xFF\xFF\xFF\xFF",
    b"\x00",
    b"\x7F\x80\x00\x00",
    b"property list uchar int q\n",
    b"property double q\n",
    b"element q 2\n",
    b"element face 1\n",
    b"end_header\n",
    b"char",
    b"uint",
    b"x",
    b"vertex1",
    b"edge",
    b"ascii",
    b"binary_big_endian",
];

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x0091_5EED;
    const CASES: usize = 30_000;
    let bases: Vec<Vec<u8>> = good_files()
        .iter()
        .flat_map(|row| {
            let binary = |big_endian| binary(&row.elements, &row.words, big_endian);
            [text(&row.elements, &row.text), binary(false), binary(true)]
        })
        .collect();
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Rng::new(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let mut file = bases[random.index(bases.len())].clone();
        for _ in 0..=random.index(3) {
            // The first line stays, so that the file is read as what it was.
            let mut rest = file.split_off(4);
            mutate(&mut rest, SPLICES, &mut random);
            file.append(&mut rest);
        }
        match read_ply(&file) {
            Ok(read) => {
                accepted += 1;
                let model = Model::of_mesh(mesh(read));
                // Beyond the doubles, or the same again where nothing is rounded.
                for format in VARIANTS {
                    let Ok(written) = write(&model, &WriteOptions::new(format)) else { continue };
                    let again = mesh(read_ply(&written.bytes).unwrap_or_else(|e| panic!("case {case}: {e}")));
                    let original = model.shape.mesh().unwrap();
                    assert_eq!(again.facets, original.facets, "case {case}");
                    let same = again.points == original.points;
                    assert_eq!(same, written.largest_rounding.is_zero(), "case {case}");
                }
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    println!("{accepted} accepted");
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
}
