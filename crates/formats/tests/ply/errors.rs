//! Bodies that are refused.

use super::{FACES, FLOATS, POINTS, VERTICES, binary, packed, read_ply, text};
use splitstar_formats::Format;

fn ends(expected: &str, read: &str) -> String {
    format!("the file ends where {expected} was expected, after {read}; complete it")
}

fn more_words(word: &str, record: &str) -> String {
    format!("`{word}` where the end of the line, after {record}, was expected; correct it")
}

fn no_count(word: &str, of: &str) -> String {
    format!("`{word}` is no number of {of}; write a whole number, 0 or larger")
}

fn outside(index: &str) -> String {
    format!("vertex index {index}, but there are 3 vertices; indices run from 0 to 2")
}

fn after_end(token: &str) -> String {
    format!("`{token}` after the end of the last element that the header promises; remove it")
}

#[test]
fn bad_texts_are_refused_by_their_lines() {
    let elements = format!("{VERTICES}{FACES}");
    let rows = [
        ("", 9, ends("a vertex", "0 of 3 vertices")),
        ("0 0 0\n1 0\n", 11, ends("a vertex", "1 of 3 vertices")),
        ("0 0 zero\n", 10, "`zero` is no number; write an integer, a decimal or a fraction p/q".into()),
        ("0 0\nnan\n", 11, "`nan` is not finite; write a finite number".into()),
        ("0 0 1/0\n", 10, "`1/0` has the denominator zero; write a fraction p/q with q not zero".into()),
        ("0 0 0 9\n", 10, more_words("9", "a vertex")),
        ("V\n", 13, ends("a facet", "0 of 1 facets")),
        ("V3 0 1\n", 13, ends("a facet", "0 of 1 facets")),
        ("V4294967294 0 1 2\n", 13, ends("a facet", "0 of 1 facets")),
        (
            "V4294967295 0 1 2\n",
            13,
            "4294967295 vertices of a facet are too many; a mesh has at most 4294967294".into(),
        ),
        ("V-3 0 1 2\n", 13, no_count("-3", "vertices of a facet")),
        ("V3.0 0 1 2\n", 13, no_count("3.0", "vertices of a facet")),
        ("V3 0 1 3\n", 13, outside("3")),
        ("V3 0\n-1 2\n", 14, outside("-1")),
        ("V3 0 1.5 2\n", 13, "`1.5` is no vertex index; write whole numbers counted from 0".into()),
        ("V3 0 1 1\n", 13, "the facet has vertex 1 twice in a row; name every vertex of a facet once".into()),
        ("V1 0\n", 13, "a facet of 1 vertex; a facet needs three, and a segment two".into()),
        ("V3 0 1 2 255\n", 13, more_words("255", "a facet")),
        ("V3 0 1 2\n\n7\n", 15, after_end("7")),
    ];
    for (body, line, message) in rows {
        let file = text(&elements, &body.replace('V', POINTS));
        assert_eq!(read_ply(&file).unwrap_err().to_string(), format!("line {line}: {message}"), "{body:?}");
    }
    let elements = format!("element a 2\nproperty list int int l\n{VERTICES}");
    let rows = [
        ("1 5 7\n", more_words("7", "an element `a`")),
        ("-1\n", no_count("-1", "elements")),
        ("1 5", ends("an element `a`", "1 of 2")),
    ];
    for (body, message) in rows {
        let error = read_ply(&text(&elements, body)).unwrap_err();
        assert_eq!(error.to_string(), format!("line 10: {message}"), "{body:?}");
    }
}

#[test]
fn bad_bodies_are_refused_by_their_bytes() {
    let faces = |kinds: &str| format!("{VERTICES}element face 2\nproperty list {kinds} vertex_indices\n");
    let edges = format!("{VERTICES}element edge 1\nproperty int vertex1\nproperty int vertex2\n");
    let before = |count, property| format!("element a {count}\nproperty {property} q\n{VERTICES}");
    let huge = VERTICES.replace("vertex 3", "vertex 4294967294");
    let twice =
        |vertex, how| format!("the facet has vertex {vertex} twice{how}; name every vertex of a facet once");
    // Elements, words, and where behind the header the fault lies.
    let rows = [
        (VERTICES.into(), "f0 f0 f0 f1", 16, ends("a vertex", "1 of 3 vertices")),
        (huge, "f0", 4, ends("a vertex", "0 of 4294967294 vertices")),
        (
            VERTICES.into(),
            "f0 f0 f0 f1 fNaN f0 f0 f1 f0",
            16,
            "`NaN` is not finite; write a finite number".into(),
        ),
        (
            VERTICES.into(),
            "f0 f0 f0 f1 f0 f-inf f0 f1 f0",
            20,
            "`-inf` is not finite; write a finite number".into(),
        ),
        (faces("uchar int"), "V", 36, ends("a facet", "0 of 2 facets")),
        (faces("uchar int"), "V B3 i0 i1 i2 B3 i0 h0", 56, ends("a facet", "1 of 2 facets")),
        (faces("uint int"), "V I4294967295 i0", 44, ends("a facet", "0 of 2 facets")),
        (faces("char int"), "V b3 i0 i1 i2 b-3", 49, no_count("-3", "vertices of a facet")),
        (faces("uchar int"), "V B3 i0 i-1 i2", 41, outside("-1")),
        (faces("uchar char"), "V B3 b0 b1 b3", 39, outside("3")),
        (faces("uchar uint"), "V B3 I0 I1 I4294967295", 45, outside("4294967295")),
        (faces("uchar int"), "V B3 i0 i1 i0", 36, twice(0, " in a row")),
        (faces("uchar int"), "V B4 i0 i1 i2 i1", 36, twice(1, "")),
        (
            faces("uchar int"),
            "V B0",
            36,
            "a facet of 0 vertices; a facet needs three, and a segment two".into(),
        ),
        (
            faces("uchar int"),
            "V B3 i0 i1 i2 B2 i0 i1",
            49,
            "a facet of two vertices beside polygons; remove it, or give it a third vertex".into(),
        ),
        (VERTICES.into(), "V B113 B10", 36, after_end("q\\n")),
        (before("4294967294", "uchar"), "B1 B2", 2, ends("an element `a`", "2 of 4294967294")),
        (before("4294967294", "list uchar int"), "B0 B0", 2, ends("an element `a`", "2 of 4294967294")),
        (before("1", "list int int"), "i-7", 0, no_count("-7", "elements")),
        (edges.clone(), "V i0 i3", 40, outside("3")),
        (edges.clone(), "V i1 i1", 36, twice(1, " in a row")),
        (edges, "V i1 h1", 42, ends("an edge", "0 of 1 edges")),
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
