//! PLY: tables of files with the meshes or the errors that they must give, and the way there and back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod errors;
mod headers;
mod written;

use polytope::PolygonMesh;
use splitstar_formats::{Format, Place, PlaceList, ReadError, ReadModel, read};

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

/// The bytes of words with their types before them: `b` and `B` for char and uchar, `h`, `H`, `i`, `I`
/// likewise, `f` and `d` for the floats.
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
            "element vertex 3\nproperty uchar red\nproperty int z\nproperty list char short l\nproperty \
             double x\n\
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

/// Line ends of every kind in the header; behind a binary one the body may begin with the bytes of a line
/// end.
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
        file.extend("1 2\n3\n\n 4\t5 6 \n\n".replace('\n', end).bytes());
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
