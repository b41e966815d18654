//! Headers that are refused.

use super::{VERTICES, binary, read_ply, text};

/// Headers that are wrong, with what is said of them.
const BAD_HEADERS: &[(&str, &str)] = &[
    ("", "the file is empty; a model was expected"),
    (
        "plywood\n",
        "line 1: no known format: the file begins with `plywood`; OFF, OBJ, STL, PLY, 3MF, VRML and star \
         can be read",
    ),
    ("ply\n", "line 1: the file ends where `end_header` was expected; complete it"),
    (
        "ply\nformat ascii 1.0\nelement vertex 1\n",
        "line 3: the file ends where `end_header` was expected; complete it",
    ),
    ("ply\nformat ascii 2.0\n", "line 2: PLY of version 2.0 cannot be read; write version 1.0"),
    (
        "ply\nformat binary 1.0\n",
        "line 2: `binary` where `ascii`, `binary_little_endian` or `binary_big_endian` was expected; \
         correct it",
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
        "line 2: `nonsense 1` where `format`, `comment`, `obj_info`, `element`, `property` or `end_header` \
         was \
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
        "line 3: `property x` where `property TYPE NAME` or `property list COUNTTYPE TYPE NAME` was \
         expected; \
         correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty list uchar x\n",
        "line 3: `property list uchar x` where `property TYPE NAME` or `property list COUNTTYPE TYPE NAME` \
         was \
         expected; correct it",
    ),
    (
        "ply\nelement vertex 1\nproperty int64 x\n",
        "line 3: `int64` where a type (char, uchar, short, ushort, int, uint, float, double) was expected; \
         correct it",
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
            "line 7: an element `face` without a list `vertex_indices` cannot be read; give every facet \
             its vertices",
        ),
        (
            format!("{VERTICES}element edge 1\nproperty int vertex1\n"),
            "line 7: an element `edge` without properties `vertex1` and `vertex2` cannot be read; give \
             every edge \
             its two vertices",
        ),
        (
            format!("{VERTICES}{face}{face}"),
            "line 9: a second element `face` cannot be read; put all its records into the first",
        ),
        (
            format!("{VERTICES}element tristrips 1\nproperty list int int vertex_indices\n"),
            "line 7: an element `tristrips` (strips of triangles) cannot be read; write the facets one by \
             one, as an \
             element `face`",
        ),
        (
            format!("element void 4294967294\n{VERTICES}"),
            "line 3: the element `void` without properties cannot be read; give it properties, or remove it",
        ),
        (
            "element vertex 4294967294\n".to_string(),
            "line 3: the element `vertex` without properties cannot be read; give it properties, or remove \
             it",
        ),
    ];
    for (elements, message) in rows {
        for file in [text(&elements, ""), binary(&elements, "", false)] {
            assert_eq!(read_ply(&file).unwrap_err().to_string(), message, "{elements:?}");
        }
    }
}
