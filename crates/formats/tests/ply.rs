//! PLY: tables of files with the meshes or the errors that they must give, and the way there and back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use exact::Point3;
use polytope::{Facets, PolygonMesh};
use splitstar_formats::{
    Format, Kind, Model, Place, PlaceList, ReadError, ReadModel, WriteError, WriteNote, WriteOptions, read,
    write,
};

fn read_ply(bytes: &[u8]) -> Result<ReadModel, ReadError> {
    read(bytes, Some("ply"))
}

fn mesh(read: ReadModel) -> PolygonMesh {
    read.model.shape.into_mesh().expect("a PLY file has a mesh")
}

/// The coordinates of every point, as text.
fn shown(mesh: &PolygonMesh) -> Vec<String> {
    mesh.points.iter().map(|p| p.coordinates().map(|c| c.to_string()).join(" ")).collect()
}

/// The bytes of words with their types before them: `b` and `B` for char and uchar, `h`, `H`, `i`, `I` likewise, `f`
/// and `d` for the floats.
fn packed(words: &str, big_endian: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    for word in words.split_whitespace() {
        let (kind, value) = word.split_at(1);
        let mut number = match kind {
            "b" => value.parse::<i8>().unwrap().to_be_bytes().to_vec(),
            "B" => value.parse::<u8>().unwrap().to_be_bytes().to_vec(),
            "h" => value.parse::<i16>().unwrap().to_be_bytes().to_vec(),
            "H" => value.parse::<u16>().unwrap().to_be_bytes().to_vec(),
            "i" => value.parse::<i32>().unwrap().to_be_bytes().to_vec(),
            "I" => value.parse::<u32>().unwrap().to_be_bytes().to_vec(),
            "f" => value.parse::<f32>().unwrap().to_be_bytes().to_vec(),
            "d" => value.parse::<f64>().unwrap().to_be_bytes().to_vec(),
            _ => panic!("{word}"),
        };
        if !big_endian {
            number.reverse();
        }
        bytes.append(&mut number);
    }
    bytes
}

/// A binary file: the elements of the header, and the body as packed words.
fn binary(elements: &str, words: &str, big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let mut file = format!("ply\nformat binary_{order}_endian 1.0\n{elements}end_header\n").into_bytes();
    file.extend(packed(words, big_endian));
    file
}

/// A file with a text as its body.
fn text(elements: &str, body: &str) -> Vec<u8> {
    format!("ply\nformat ascii 1.0\n{elements}end_header\n{body}").into_bytes()
}

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
const VERTICES: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const FACES: &str = "element face 1\nproperty list uchar int vertex_indices\n";
const POINTS: &str = "0 0 0\n1 0 0\n0 1 0\n";
const FLOATS: &str = "f0 f0 f0 f1 f0 f0 f0 f1 f0";

struct Good {
    name: &'static str,
    elements: String,
    /// The same records as a text and as packed words.
    text: String,
    words: String,
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
}

const TRIANGLE: &[&str] = &["0 0 0", "1 0 0", "0 1 0"];

fn good_files() -> Vec<Good> {
    let row = |name, elements: &str, text: &str, words: &str, points, facets| Good {
        name,
        elements: elements.into(),
        text: text.into(),
        words: words.into(),
        points,
        facets,
    };
    let triangle: &[&[u32]] = &[&[0, 1, 2]];
    vec![
        row(
            "a triangle",
            &format!("{VERTICES}{FACES}"),
            &format!("{POINTS}3 0 1 2\n"),
            &format!("{FLOATS} B3 i0 i1 i2"),
            TRIANGLE,
            triangle,
        ),
        row("points", VERTICES, POINTS, FLOATS, TRIANGLE, &[]),
        row(
            "no facets",
            &format!("{VERTICES}element face 0\n{FACES}").replace("face 1", "edge 0"),
            POINTS,
            FLOATS,
            TRIANGLE,
            &[],
        ),
        row(
            "segments",
            &format!(
                "{VERTICES}element edge 2\nproperty short vertex2\nproperty float w\nproperty uint vertex1\n"
            ),
            &format!("{POINTS}1 0.5 0\n2 0.5 1\n"),
            &format!("{FLOATS} h1 f.5 I0 h2 f.5 I1"),
            TRIANGLE,
            &[&[0, 1], &[1, 2]],
        ),
        row(
            "edges beside facets are skipped",
            &format!("{VERTICES}element edge 1\nproperty int vertex1\nproperty int vertex2\n{FACES}"),
            &format!("{POINTS}0 0\n3 0 1 2\n"),
            &format!("{FLOATS} i0 i0 B3 i0 i1 i2"),
            TRIANGLE,
            triangle,
        ),
        row(
            "other elements before, between and behind",
            &format!(
                "comment a\nelement camera 1\nproperty double view\nproperty list uchar float matrix\n\
                 element none 0\n\
                 obj_info b\n{VERTICES}element material 2\nproperty list ushort double a\nproperty char b\n\
                 {FACES}element last 2\nproperty uchar q\n"
            ),
            &format!("7 2 1 2\n{POINTS}1 5 -1\n0 -1\n3 0 1 2\n1\n2\n"),
            &format!("d7 B2 f1 f2 {FLOATS} H1 d5 b-1 H0 b-1 B3 i0 i1 i2 B1 B2"),
            TRIANGLE,
            triangle,
        ),
        row(
            "properties in any order, lists among them",
            "element vertex 3\nproperty uchar red\nproperty int z\nproperty list char short l\nproperty double x\n\
             property float nx\nproperty short y\nproperty double q\n\
             element face 1\nproperty uchar a\nproperty list int uchar vertex_index\n\
             property list uchar float texcoord\nproperty int flags\n",
            "255 0 2 1 2 0 .5 0 0\n255 0 0 1 .5 0 0\n255 0 1 9 0 .5 1 0\n1 3 0 1 2 2 .5 .5 0\n",
            "B255 i0 b2 h1 h2 d0 f.5 h0 d0 B255 i0 b0 d1 f.5 h0 d0 B255 i0 b1 h9 d0 f.5 h1 d0 \
             B1 i3 B0 B1 B2 B2 f.5 f.5 i0",
            TRIANGLE,
            triangle,
        ),
        row(
            "integers as coordinates",
            "element vertex 3\nproperty int8 x\nproperty uint32 y\nproperty int32 z\n\
             element face 1\nproperty list uint8 uint16 vertex_indices\n",
            "-128 4294967295 -2147483648\n1 2 3\n127 0 0\n3 2 1 0\n",
            "b-128 I4294967295 i-2147483648 b1 I2 i3 b127 I0 i0 B3 H2 H1 H0",
            &["-128 4294967295 -2147483648", "1 2 3", "127 0 0"],
            &[&[2, 1, 0]],
        ),
        row(
            "dyadic numbers",
            &VERTICES.replace("float y", "float64 y").replace("vertex 3", "vertex 1"),
            "-0.375 1.1102230246251565404236316680908203125e-16 1e10\n",
            "f-0.375 d1.1102230246251565e-16 f1e10",
            &["-3/8 1/9007199254740992 10000000000"],
            &[],
        ),
    ]
}

#[test]
fn every_variant_of_a_good_file_is_the_same_mesh() {
    for row in good_files() {
        let files = [
            (text(&row.elements, &row.text), Format::PlyAscii),
            (binary(&row.elements, &row.words, false), Format::Ply),
            (binary(&row.elements, &row.words, true), Format::PlyBigEndian),
        ];
        for (file, format) in files {
            let read = read_ply(&file).unwrap_or_else(|error| panic!("{} {format:?}: {error}", row.name));
            assert_eq!(read.format, format, "{}", row.name);
            let mesh = mesh(read);
            assert_eq!(shown(&mesh), row.points, "{} {format:?}", row.name);
            assert_eq!(mesh.facets.iter().collect::<Vec<_>>(), row.facets, "{} {format:?}", row.name);
        }
    }
}

#[test]
fn numbers_in_a_text_count_as_written() {
    let file = text(&VERTICES.replace("float", "int"), "0.1 1/3 -25e-2\n1. .5 +7\n0 -0 2/4 \n");
    assert_eq!(shown(&mesh(read_ply(&file).unwrap())), ["1/10 1/3 -1/4", "1 1/2 7", "0 0 1/2"]);
}

#[test]
fn binary_floats_are_dyadic_numbers() {
    let file = binary(&VERTICES.replace("vertex 3", "vertex 1"), "f0.1 f1e-45 f-0", false);
    let tenth = "13421773/134217728";
    let smallest = format!("1/{}", exact::Integer::from(2).pow(149));
    assert_eq!(shown(&mesh(read_ply(&file).unwrap())), [format!("{tenth} {smallest} 0")]);
}

/// Line ends of every kind in the header; behind a binary one the body may begin with the bytes of a line end.
#[test]
fn headers_have_any_line_ends() {
    for end in ["\n", "\r\n", "\r"] {
        let elements = "comment q\nelement vertex 2\nproperty char x\nproperty char y\nproperty char z\n\n";
        let header = |format| {
            format!("ply\nformat {format} 1.0\n{elements}end_header \n").replace('\n', end).into_bytes()
        };
        let mut file = header("binary_little_endian");
        file.extend(b"\n\n\r\r\n\x01");
        let mesh_of = |file: &[u8]| shown(&mesh(read_ply(file).unwrap_or_else(|e| panic!("{end:?}: {e}"))));
        assert_eq!(mesh_of(&file), ["10 10 13", "13 10 1"], "{end:?}");
        let mut file = header("ascii");
        file.extend(format!("1 2\n3\n\n 4\t5 6 \n\n").replace('\n', end).bytes());
        assert_eq!(mesh_of(&file), ["1 2 3", "4 5 6"], "{end:?}");
        // The last line may end with the file.
        let bare = file.iter().rposition(|byte| *byte == b'6').unwrap() + 1;
        assert_eq!(mesh_of(&file[..bare]), ["1 2 3", "4 5 6"], "{end:?}");
        let error = read_ply(&[&file[..bare], b" 7"].concat()).unwrap_err();
        assert_eq!(error.place, Some(Place::Line(13)), "{end:?}: {error}");
    }
}

#[test]
fn long_lines_and_many_properties_are_fine() {
    let mut elements = format!("comment {}\nelement vertex 1\n", "x".repeat(100_000));
    let mut words = String::new();
    for property in 0..1_000 {
        elements += &format!("property {} p{property}\n", ["char", "double"][property % 2]);
        words += ["b1 ", "d1 "][property % 2];
    }
    let file = binary(&format!("{elements}{XYZ}"), &format!("{words}f1 f2 f3"), true);
    assert_eq!(shown(&mesh(read_ply(&file).unwrap())), ["1 2 3"]);
}

#[test]
fn places_are_lines_and_bytes() {
    let elements = format!("{VERTICES}{FACES}");
    let read = read_ply(&text(&elements, "0 0\n0\n1 0 0\n\n0 1 0\n3 0\n1 2\n")).unwrap();
    assert_eq!(read.places.vertices, PlaceList::Lines(vec![10, 12, 14]));
    assert_eq!(read.places.facets, PlaceList::Lines(vec![15]));

    let file = binary(&elements, &format!("{FLOATS} B3 i0 i1 i2"), false);
    let body = file.len() as u64 - 49;
    let read = read_ply(&file).unwrap();
    let places: Vec<_> = (0..4).map(|vertex| read.places.vertices.get(vertex)).collect();
    let byte = |at| Some(Place::Byte(body + at));
    assert_eq!(places, [byte(0), byte(12), byte(24), None]);
    assert_eq!(read.places.facets, PlaceList::Bytes(vec![body + 36]));

    let elements =
        "element vertex 2\nproperty list uchar char l\nproperty char x\nproperty char y\nproperty char z\n";
    let file = binary(elements, "B2 b0 b0 b1 b2 b3 B0 b4 b5 b6", true);
    let body = file.len() as u64 - 10;
    assert_eq!(read_ply(&file).unwrap().places.vertices, PlaceList::Bytes(vec![body, body + 6]));
}

/// Headers that are wrong, with what is said of them.
const BAD_HEADERS: &[(&str, &str)] = &[
    ("", "the file is empty; a mesh was expected"),
    (
        "plywood\n",
        "line 1: no known format: the file begins with `plywood`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read",
    ),
    ("ply\n", "line 1: the file ends where `end_header` was expected; complete it, or correct the counts"),
    (
        "ply\nformat ascii 1.0\nelement vertex 1\n",
        "line 3: the file ends where `end_header` was expected; complete it, or correct the counts",
    ),
    ("ply\nformat ascii 2.0\n", "line 2: PLY of version 2.0 cannot be read; write version 1.0"),
    (
        "ply\nformat binary 1.0\n",
        "line 2: `binary` where `ascii`, `binary_little_endian` or `binary_big_endian` was expected; correct it",
    ),
    (
        "ply\nformat ascii\n",
        "line 2: `format ascii` where `format ascii 1.0`, `format binary_little_endian 1.0` or \
         `format binary_big_endian 1.0` was expected; correct it",
    ),
    (
        "ply\nformat ascii 1.0\nformat ascii 1.0\n",
        "line 3: `format ascii 1.0` where one line `format` only was expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nend_header\n",
        "line 3: `end_header` where a line `format ascii 1.0` (or binary) was expected; correct it",
    ),
    (
        "ply\nnonsense 1\n",
        "line 2: `nonsense 1` where `format`, `comment`, `obj_info`, `element`, `property` or `end_header` was \
         expected; correct it",
    ),
    ("ply\nelement vertex\n", "line 2: `element vertex` where `element NAME COUNT` was expected; correct it"),
    (
        "ply\nelement vertex 1 2\n",
        "line 2: `element vertex 1 2` where `element NAME COUNT` was expected; correct it",
    ),
    ("ply\nelement vertex -1\n", "line 2: `-1` is no number of vertices; write a whole number, 0 or larger"),
    (
        "ply\nelement face 4294967295\n",
        "line 2: 4294967295 facets are too many; a mesh has at most 4294967294",
    ),
    (
        "ply\nelement dust 99999999999999999999\n",
        "line 2: 99999999999999999999 elements are too many; a mesh has at most 4294967294",
    ),
    (
        "ply\nproperty float x\n",
        "line 2: `property float x` where an element before its properties was expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty x\n",
        "line 3: `property x` where `property TYPE NAME` or `property list COUNTTYPE TYPE NAME` was expected; \
         correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty list uchar x\n",
        "line 3: `property list uchar x` where `property TYPE NAME` or `property list COUNTTYPE TYPE NAME` was \
         expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty int64 x\n",
        "line 3: `int64` where a type (char, uchar, short, ushort, int, uint, float, double) was expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty float x\nproperty int x\n",
        "line 4: `x` where a property that the element does not have yet was expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty list uchar float y\n",
        "line 3: `y` where a coordinate that is a number, not a list was expected; correct it",
    ),
    (
        "ply\nelement a 1\nproperty list float int l\n",
        "line 3: `float` where an integer type for the length of a list was expected; correct it",
    ),
    (
        "ply\nelement face 1\nproperty list uchar float vertex_indices\n",
        "line 3: `float` where an integer type for vertex indices was expected; correct it",
    ),
    (
        "ply\nelement face 1\nproperty int vertex_indices\n",
        "line 3: `int` where `list` (a facet has a list of vertices) was expected; correct it",
    ),
    (
        "ply\nelement face 1\nproperty list uchar int vertex_indices\nproperty list uchar int vertex_index\n",
        "line 4: `vertex_index` where a property that the element does not have yet was expected; correct it",
    ),
    (
        "ply\nelement edge 1\nproperty float vertex1\n",
        "line 3: `float` where an integer type for vertex indices was expected; correct it",
    ),
    (
        "ply\nformat ascii 1.0\nend_header now\n",
        "line 3: `end_header now` where `end_header` alone in its line was expected; correct it",
    ),
    (
        "ply\nformat ascii 1.0\nend_header\n",
        "line 3: the mesh is empty: it has no vertex; at least one is needed",
    ),
];

#[test]
fn bad_headers_are_refused_by_their_lines() {
    for (file, message) in BAD_HEADERS {
        assert_eq!(&read_ply(file.as_bytes()).unwrap_err().to_string(), message, "{file:?}");
    }
}

/// Elements that do not fit together, behind a line for the format; with what is said of them.
#[test]
fn elements_that_do_not_fit_together_are_refused() {
    let face = "element face 1\nproperty list uchar int vertex_indices\n";
    let rows = [
        (
            "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n".to_string(),
            "line 3: the mesh is empty: it has no vertex; at least one is needed",
        ),
        (
            "element vertex 1\nproperty float x\nproperty float z\n".to_string(),
            "line 3: an element `vertex` without a property `y` cannot be read; give every vertex x, y and z",
        ),
        (
            format!("{face}{VERTICES}"),
            "line 3: an element `face` before the element `vertex` cannot be read; put the vertices first",
        ),
        (
            format!("element edge 1\nproperty int vertex1\nproperty int vertex2\n{VERTICES}"),
            "line 3: an element `edge` before the element `vertex` cannot be read; put the vertices first",
        ),
        (
            format!("{VERTICES}element face 1\nproperty list uchar int vertices\n"),
            "line 7: an element `face` without a list `vertex_indices` cannot be read; give every facet its vertices",
        ),
        (
            format!("{VERTICES}element edge 1\nproperty int vertex1\n"),
            "line 7: an element `edge` without properties `vertex1` and `vertex2` cannot be read; give every edge \
             its two vertices",
        ),
        (
            format!("{VERTICES}{face}{face}"),
            "line 9: a second element `face` cannot be read; put all its records into the first",
        ),
        (
            format!("{VERTICES}element tristrips 1\nproperty list int int vertex_indices\n"),
            "line 7: an element `tristrips` (strips of triangles) cannot be read; write the facets one by one, as an \
             element `face`",
        ),
        (
            format!("element void 4294967294\n{VERTICES}"),
            "line 3: the element `void` without properties cannot be read; give it properties, or remove it",
        ),
        (
            "element vertex 4294967294\n".to_string(),
            "line 3: the element `vertex` without properties cannot be read; give it properties, or remove it",
        ),
    ];
    for (elements, message) in rows {
        for file in [text(&elements, ""), binary(&elements, "", false)] {
            assert_eq!(read_ply(&file).unwrap_err().to_string(), message, "{elements:?}");
        }
    }
}

#[test]
fn bad_texts_are_refused_by_their_lines() {
    let elements = format!("{VERTICES}{FACES}");
    let rows = [
        (
            "",
            "line 9: the file ends where a vertex was expected, after 0 of 3 vertices; complete it, or correct the counts",
        ),
        (
            "0 0 0\n1 0\n",
            "line 11: the file ends where a vertex was expected, after 1 of 3 vertices; complete it, or correct the counts",
        ),
        ("0 0 zero\n", "line 10: `zero` is no number; write an integer, a decimal or a fraction p/q"),
        ("0 0\nnan\n", "line 11: `nan` is not finite; write a finite number"),
        ("0 0 1/0\n", "line 10: `1/0` has the denominator zero; write a fraction p/q with q not zero"),
        ("0 0 0 0\n", "line 10: `0` where the end of the line, after a vertex, was expected; correct it"),
        (
            "V\n",
            "line 13: the file ends where a facet was expected, after 0 of 1 facets; complete it, or correct the counts",
        ),
        (
            "V3 0 1\n",
            "line 13: the file ends where a facet was expected, after 0 of 1 facets; complete it, or correct the counts",
        ),
        (
            "V4294967294 0 1 2\n",
            "line 13: the file ends where a facet was expected, after 0 of 1 facets; complete it, or correct the counts",
        ),
        (
            "V4294967295 0 1 2\n",
            "line 13: 4294967295 vertices of a facet are too many; a mesh has at most 4294967294",
        ),
        (
            "V-3 0 1 2\n",
            "line 13: `-3` is no number of vertices of a facet; write a whole number, 0 or larger",
        ),
        (
            "V3.0 0 1 2\n",
            "line 13: `3.0` is no number of vertices of a facet; write a whole number, 0 or larger",
        ),
        ("V3 0 1 3\n", "line 13: vertex index 3, but the file has 3 vertices; indices run from 0 to 2"),
        ("V3 0\n-1 2\n", "line 14: vertex index -1, but the file has 3 vertices; indices run from 0 to 2"),
        ("V3 0 1.5 2\n", "line 13: `1.5` is no vertex index; write whole numbers counted from 0"),
        ("V3 0 1 1\n", "line 13: the facet has vertex 1 twice in a row; name every vertex of a facet once"),
        ("V1 0\n", "line 13: a facet of 1 vertex; a facet needs three, and a segment two"),
        (
            "V3 0 1 2 255\n",
            "line 13: `255` where the end of the line, after a facet, was expected; correct it",
        ),
        (
            "V3 0 1 2\n\n7\n",
            "line 15: `7` after the end of the last element that the header promises; remove it, or correct the counts",
        ),
    ];
    for (body, message) in rows {
        let file = text(&elements, &body.replace('V', POINTS));
        assert_eq!(read_ply(&file).unwrap_err().to_string(), message, "{body:?}");
    }
    let other = text(&format!("element a 2\nproperty list int int l\n{VERTICES}"), "1 5 7\n");
    let message = "line 10: `7` where the end of the line, after an element `a`, was expected; correct it";
    assert_eq!(read_ply(&other).unwrap_err().to_string(), message);
    let other = text(&format!("element a 2\nproperty list int int l\n{VERTICES}"), "-1\n");
    let message = "line 10: `-1` is no number of elements; write a whole number, 0 or larger";
    assert_eq!(read_ply(&other).unwrap_err().to_string(), message);
}

#[test]
fn bad_bodies_are_refused_by_their_bytes() {
    let faces = |kinds: &str| format!("{VERTICES}element face 2\nproperty list {kinds} vertex_indices\n");
    let promised = "complete it, or correct the counts";
    // Elements, words, and where behind the header the fault lies.
    let rows = [
        (VERTICES.into(), "f0 f0 f0 f1", 16, format!("the file ends where a vertex was expected, after 1 of 3 vertices; {promised}")),
        (VERTICES.replace("vertex 3", "vertex 4294967294"), "f0", 4, format!("the file ends where a vertex was expected, after 0 of 4294967294 vertices; {promised}")),
        (VERTICES.into(), "f0 f0 f0 f1 fNaN f0 f0 f1 f0", 16, "`NaN` is not finite; write a finite number".into()),
        (VERTICES.into(), "f0 f0 f0 f1 f0 f-inf f0 f1 f0", 20, "`-inf` is not finite; write a finite number".into()),
        (faces("uchar int"), "V", 36, format!("the file ends where a facet was expected, after 0 of 2 facets; {promised}")),
        (faces("uchar int"), "V B3 i0 i1 i2 B3 i0 h0", 56, format!("the file ends where a facet was expected, after 1 of 2 facets; {promised}")),
        (faces("uint double").replace("double", "int"), "V I4294967295 i0", 44, format!("the file ends where a facet was expected, after 0 of 2 facets; {promised}")),
        (faces("char int"), "V b3 i0 i1 i2 b-3", 49, "`-3` is no number of vertices of a facet; write a whole number, 0 or larger".into()),
        (faces("uchar int"), "V B3 i0 i-1 i2", 41, "vertex index -1, but the file has 3 vertices; indices run from 0 to 2".into()),
        (faces("uchar char"), "V B3 b0 b1 b3", 39, "vertex index 3, but the file has 3 vertices; indices run from 0 to 2".into()),
        (faces("uchar uint"), "V B3 I0 I1 I4294967295", 45, "vertex index 4294967295, but the file has 3 vertices; indices run from 0 to 2".into()),
        (faces("uchar int"), "V B3 i0 i1 i0", 36, "the facet has vertex 0 twice in a row; name every vertex of a facet once".into()),
        (faces("uchar int"), "V B0", 36, "a facet of 0 vertices; a facet needs three, and a segment two".into()),
        (faces("uchar int"), "V B3 i0 i1 i2 B2 i0 i1", 49, "a facet of two vertices beside polygons; remove it, or give it a third vertex".into()),
        (VERTICES.into(), "V B113 B10", 36, "`q\\n` after the end of the last element that the header promises; remove it, or correct the counts".into()),
        (format!("element a 4294967294\nproperty uchar q\n{VERTICES}"), "B1 B2", 2, format!("the file ends where an element `a` was expected, after 2 of 4294967294; {promised}")),
        (format!("element a 4294967294\nproperty list uchar int q\n{VERTICES}"), "B0 B1 i1 B0", 7, format!("the file ends where an element `a` was expected, after 3 of 4294967294; {promised}")),
        (format!("element a 1\nproperty list int int q\n{VERTICES}"), "i-7", 0, "`-7` is no number of elements; write a whole number, 0 or larger".into()),
        (format!("{VERTICES}element edge 1\nproperty int vertex1\nproperty int vertex2\n"), "V i0 i3", 40, "vertex index 3, but the file has 3 vertices; indices run from 0 to 2".into()),
        (format!("{VERTICES}element edge 1\nproperty int vertex1\nproperty int vertex2\n"), "V i1 i1", 36, "the facet has vertex 1 twice in a row; name every vertex of a facet once".into()),
    ];
    for (elements, words, offset, message) in rows {
        for big_endian in [false, true] {
            let words = words.replace('V', FLOATS);
            let file = binary(&elements, &words, big_endian);
            let body = file.len() - packed(&words, big_endian).len();
            let error = read_ply(&file).unwrap_err();
            let expected = format!("byte {}: {message}", body + offset);
            assert_eq!(error.to_string(), expected, "{elements:?} {words:?}");
            assert_eq!(error.format, Some(Format::Ply));
        }
    }
}

/// Files that cost as much memory as honest files can for each of their bytes.
#[test]
fn the_budget_allows_honest_files() {
    let count = 1_200_000;
    let elements = format!("element vertex {count}\nproperty uchar x\nproperty uchar y\nproperty uchar z\n");
    let mut file = binary(&elements, "", false);
    file.extend(std::iter::repeat_n(b'\x07', 3 * count));
    assert_eq!(mesh(read_ply(&file).unwrap()).points.len(), count);

    let elements = format!("{VERTICES}element face {count}\nproperty list uchar uchar vertex_indices\n");
    let mut file = binary(&elements, FLOATS, false);
    file.extend([3, 0, 1, 2].repeat(count));
    assert_eq!(mesh(read_ply(&file).unwrap()).facets.len(), count);
}

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
            "ply\nformat ascii 1.0\n{header}0 0 0\n1 0 0\n1 0.25 0\n0 0.3333333333333333 0\n4 0 1 2 3\n4 3 2 1 0\n"
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

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
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
    let mut random = Random(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let mut file = bases[random.below(bases.len())].clone();
        for _ in 0..=random.below(3) {
            // The first line stays, so that the file is read as what it was.
            let at = 4 + random.below(file.len() - 4);
            let end = (at + random.below(6)).min(file.len());
            let splice = SPLICES[random.below(SPLICES.len())].iter().copied();
            match random.below(5) {
                0 => file[at] ^= 1 << random.below(8),
                1 => file[at] = random.next() as u8,
                2 => drop(file.splice(at..at, splice)),
                3 => drop(file.splice(at..end, splice)),
                _ => drop(file.drain(at..end)),
            }
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
