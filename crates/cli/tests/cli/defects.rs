//! The defects of `models/invalid` in every other format, as `sum` tells them; the files are made in `encode`.

use crate::encode::{Encoded, Kind, Mesh};
use crate::{Folder, counts, model, run};
use std::fs;

/// What comes of the sum with a cube.
enum Outcome {
    /// Its counts, and the notes of the file.
    Sum([u64; 3], &'static [&'static str]),
    /// Where the file is wrong, and the message, in which `{v3}` stands for vertex 3, `{f3}` for facet 3.
    Refused(At, &'static str),
}
use Outcome::{Refused, Sum};

#[derive(Clone, Copy)]
enum At {
    /// By the index in the OFF file.
    Vertex(usize),
    /// By the index in this file.
    Facet(usize),
    /// A corner of a facet.
    Corner(usize, usize),
    Byte(usize),
    Nowhere,
}
use At::{Byte, Corner, Facet, Nowhere, Vertex};

/// A defect of a mesh, and what comes of it where there are polygons and where there are triangles.
struct Row {
    file: &'static str,
    polygons: Outcome,
    triangles: Outcome,
}

const CUBE: [u64; 3] = [8, 12, 6];
/// What is said of the triangles of a cube.
const JOINED: &str = "coplanar facets and collinear edges joined: 12 facets and 8 vertices became 6 and 8";
const INSIDE_OUT: &str = "the mesh is inside out; its facets were turned round";
const TRIANGLES: &str = "coplanar facets and collinear edges joined: 6 facets and 5 vertices became 4 and 4";
const FLAT: &str = "the surface encloses no volume: read as a polytope of dimension 2";

const ROWS: &[Row] = &[
    Row {
        file: "open_mesh.off",
        polygons: Refused(
            Facet(0),
            "not closed: the edge from {v0} to {v3} has a facet on one side only; {hull}",
        ),
        triangles: Refused(
            Facet(1),
            "not closed: the edge from {v0} to {v3} has a facet on one side only; {hull}",
        ),
    },
    Row {
        file: "flipped_facet.off",
        polygons: Refused(
            Facet(3),
            "the orientation disagrees: the facets {f0} and {f3} both run from {v2} to {v1}; turn one of them \
             round; {hull}",
        ),
        triangles: Refused(
            Facet(7),
            "the orientation disagrees: the facets {f0} and {f7} both run from {v2} to {v1}; turn one of them \
             round; {hull}",
        ),
    },
    Row {
        file: "inside_out.off",
        polygons: Sum(CUBE, &[INSIDE_OUT]),
        triangles: Sum(CUBE, &[INSIDE_OUT, JOINED]),
    },
    Row {
        file: "non_planar_quad.off",
        polygons: Refused(
            Facet(1),
            "the facet is not planar: {v7} lies 0.894427 off the plane of its first corners; the square of this \
             distance is 4/5; --triangulate cuts it into triangles, and {hull}",
        ),
        // Triangles are planar; these make a convex polytope.
        triangles: Sum(
            [11, 17, 8],
            &["coplanar facets and collinear edges joined: 12 facets and 8 vertices became 7 and 8"],
        ),
    },
    Row {
        file: "self_intersecting.off",
        polygons: Refused(
            Facet(7),
            "not convex: the edge from {v0} to {v5} is reflex, between the facets {f7} and {f4}; {hull}",
        ),
        triangles: Refused(
            Facet(7),
            "not convex: the edge from {v0} to {v5} is reflex, between the facets {f7} and {f4}; {hull}",
        ),
    },
    Row {
        file: "overlapping_shells.off",
        polygons: Refused(
            Facet(6),
            "not convex: the surface has 2 shells, those of the facets {f0} and {f6}, say; {hull}",
        ),
        triangles: Refused(
            Facet(12),
            "not convex: the surface has 2 shells, those of the facets {f0} and {f12}, say; {hull}",
        ),
    },
    Row {
        file: "zero_area_facet.off",
        polygons: Sum([13, 21, 10], &[TRIANGLES]),
        triangles: Sum([13, 21, 10], &[TRIANGLES]),
    },
    Row { file: "flat.off", polygons: Sum([10, 15, 7], &[FLAT]), triangles: Sum([10, 15, 7], &[FLAT]) },
    Row {
        file: "non_manifold_edge.off",
        polygons: Refused(
            Vertex(1),
            "not convex: 4 facets meet at the edge from {v1} to {v6}, and only two may; {hull}",
        ),
        triangles: Refused(
            Vertex(1),
            "not convex: 4 facets meet at the edge from {v1} to {v6}, and only two may; {hull}",
        ),
    },
    Row {
        file: "non_manifold_vertex.off",
        polygons: Refused(
            Vertex(6),
            "not convex: the facets at {v6} form more than one cycle around it; {hull}",
        ),
        triangles: Refused(
            Vertex(6),
            "not convex: the facets at {v6} form more than one cycle around it; {hull}",
        ),
    },
];

#[test]
fn meshes_with_defects_in_every_format() {
    let folder = Folder::new("defects_meshes");
    for Row { file, polygons, triangles } in ROWS {
        let mesh = Mesh::of_off(&model(&format!("invalid/{file}")));
        for kind in Kind::ALL {
            let expected = if kind.has_polygons() { polygons } else { triangles };
            check(&folder, file, kind, &mesh.encode(kind), expected);
        }
    }
}

const POLYGONS: &[Kind] = &[Kind::Obj, Kind::PlyAscii, Kind::Ply, Kind::PlyBig];
const PLY: &[Kind] = &[Kind::PlyAscii, Kind::Ply, Kind::PlyBig];
const STL: &[Kind] = &[Kind::StlAscii, Kind::Stl];
const THREEMF: &[Kind] = &[Kind::ThreeMf];
const OBJ: &[Kind] = &[Kind::Obj];
const TEXT: &[Kind] = &[Kind::Obj, Kind::StlAscii, Kind::PlyAscii, Kind::ThreeMf];
const BINARY: &[Kind] = &[Kind::Stl, Kind::Ply, Kind::PlyBig];

const UNUSED: &str = "1 unused vertex dropped";
const WELDED: &str = "24 vertices welded to 8 at equal positions";
const POINTS: &str = "no facets: read as a point set, its convex hull is taken";
const TWO: &str = "a facet of two vertices beside polygons; remove it, or give it a third vertex";
const TWICE: &str = "the facet has vertex 0 twice in a row; name every vertex of a facet once";
const EMPTY: &str = "the mesh is empty: it has no vertex; at least one is needed";

/// Where it matters that corners have indices, and that coordinates have a type. What is not here is impossible.
const FORMATS: &[(&str, &[Kind], Outcome)] = &[
    ("duplicate_vertex_unused.off", POLYGONS, Sum(CUBE, &[UNUSED])),
    ("duplicate_vertex_unused.off", THREEMF, Sum(CUBE, &[UNUSED, JOINED])),
    // No vertex is without a facet, and equal positions are one vertex.
    ("duplicate_vertex_unused.off", STL, Sum(CUBE, &[JOINED])),
    ("facet_soup.off", POLYGONS, Sum(CUBE, &[WELDED])),
    ("facet_soup.off", THREEMF, Sum(CUBE, &[WELDED, JOINED])),
    ("facet_soup.off", STL, Sum(CUBE, &[JOINED])),
    ("zero_facets.off", POLYGONS, Sum(CUBE, &[POINTS])),
    ("zero_facets.off", THREEMF, Sum(CUBE, &[POINTS])),
    ("zero_facets.off", &[Kind::StlAscii], Refused(Nowhere, EMPTY)),
    ("zero_facets.off", &[Kind::Stl], Refused(Byte(80), EMPTY)),
    ("two_vertex_facet.off", POLYGONS, Refused(Facet(6), TWO)),
    ("repeated_index.off", PLY, Refused(Facet(5), TWICE)),
    (
        "repeated_index.off",
        OBJ,
        Refused(Facet(5), "the facet has vertex 1 twice in a row; name every vertex of a facet once"),
    ),
    ("repeated_index.off", THREEMF, Refused(Facet(10), TWICE)),
    (
        "repeated_index.off",
        STL,
        Sum(CUBE, &["1 facet has two corners at the same position: left out", JOINED]),
    ),
    (
        "index_out_of_range.off",
        OBJ,
        Refused(Facet(5), "vertex index 9, but there are 8 vertices; indices run from 1 to 8"),
    ),
    ("index_out_of_range.off", PLY, Refused(Corner(5, 3), OUT_OF_RANGE)),
    ("index_out_of_range.off", THREEMF, Refused(Facet(11), OUT_OF_RANGE)),
    // In OBJ -1 has a meaning: the test below.
    (
        "negative_index.off",
        OBJ,
        Refused(Facet(5), "`0` is no vertex index; write whole numbers counted from 1"),
    ),
    ("negative_index.off", PLY, Refused(Corner(5, 3), NEGATIVE)),
    ("negative_index.off", THREEMF, Refused(Facet(11), NEGATIVE)),
    ("coordinate_nan.off", TEXT, Refused(Vertex(0), "`nan` is not finite; write a finite number")),
    ("coordinate_nan.off", BINARY, Refused(Vertex(0), "`NaN` is not finite; write a finite number")),
    ("coordinate_inf.off", &Kind::ALL, Refused(Vertex(0), INFINITE)),
    (
        "coordinate_word.off",
        TEXT,
        Refused(Vertex(0), "`zero` is no number; write an integer, a decimal or a fraction p/q"),
    ),
    (
        "zero_denominator.xoff",
        TEXT,
        Refused(Vertex(0), "`1/0` has the denominator zero; write a fraction p/q with q not zero"),
    ),
    (
        "exponent_bomb.off",
        TEXT,
        Refused(
            Vertex(0),
            "the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
        ),
    ),
    // Its nearest float is infinite.
    ("exponent_bomb.off", BINARY, Refused(Vertex(0), INFINITE)),
    ("huge_exponent.off", POLYGONS, Sum(CUBE, &[])),
    ("huge_exponent.off", &[Kind::StlAscii, Kind::ThreeMf], Sum(CUBE, &[JOINED])),
    // The x of vertex 1, which is a third corner.
    ("huge_exponent.off", &[Kind::Stl], Refused(Byte(100), INFINITE)),
];

const OUT_OF_RANGE: &str = "vertex index 8, but there are 8 vertices; indices run from 0 to 7";
const NEGATIVE: &str = "vertex index -1, but there are 8 vertices; indices run from 0 to 7";
const INFINITE: &str = "`inf` is not finite; write a finite number";

#[test]
fn defects_that_depend_on_the_format() {
    let folder = Folder::new("defects_formats");
    for (file, kinds, expected) in FORMATS {
        let mesh = Mesh::of_off(&model(&format!("invalid/{file}")));
        for &kind in *kinds {
            check(&folder, file, kind, &mesh.encode(kind), expected);
        }
    }
}

/// Counted back from the last vertex before the facet.
#[test]
fn negative_indices_of_obj() {
    let folder = Folder::new("defects_negative");
    let mesh = Mesh::of_off(&model("convex/cube.off"));
    let mut counted_back = mesh.clone();
    // The encoder adds one to each.
    counted_back.facets.iter_mut().flatten().for_each(|index| *index -= 9);
    check(&folder, "negative", Kind::Obj, &counted_back.encode(Kind::Obj), &Sum(CUBE, &[]));
    counted_back.facets[3][2] = -10;
    let message = "vertex index -9, but there are 8 vertices; indices run from 1 to 8";
    check(&folder, "too far", Kind::Obj, &counted_back.encode(Kind::Obj), &Refused(Facet(3), message));
}

/// Runs the sum with a cube, and compares all that is said.
fn check(folder: &Folder, what: &str, kind: Kind, encoded: &Encoded, expected: &Outcome) {
    let what = format!("{what} as {kind:?}");
    let file = folder.path(&format!("defect.{}", kind.ending()));
    fs::write(&file, &encoded.bytes).unwrap();
    let out = folder.path("out.star");
    let run = run(&["sum", &file, &model("convex/cube.off"), "-o", &out, "--json"]);
    match expected {
        Sum(expected, notes) => {
            let notes: Vec<_> =
                notes.iter().map(|note| format!("note: {}{note}", kind.place(&file, None))).collect();
            assert_eq!(run.notes(), notes, "{what}");
            assert_eq!(counts(&run.json()), *expected, "{what}");
            fs::remove_file(&out).unwrap();
        }
        Refused(at, message) => {
            let place = match *at {
                Vertex(vertex) => Some(encoded.vertices[vertex]),
                Corner(facet, corner) if kind.is_binary() => Some(encoded.facets[facet] + 1 + 4 * corner),
                Corner(facet, _) | Facet(facet) => Some(encoded.facets[facet]),
                Byte(byte) => Some(byte),
                Nowhere => None,
            };
            let message = filled(message, kind, encoded);
            let expected = format!("error: {}{message}", kind.place(&file, place));
            assert_eq!(run.error(1), expected, "{what}");
        }
    }
    fs::remove_file(&file).unwrap();
    assert_eq!(folder.names(), [""; 0], "{what}");
}

/// The message with the names of vertices and facets.
fn filled(message: &str, kind: Kind, encoded: &Encoded) -> String {
    let unit = if kind.is_binary() { "byte" } else { "line" };
    let first = usize::from(kind == Kind::Obj);
    let mut message = message.replace("{hull}", "--hull takes the convex hull instead");
    for (index, (number, place)) in encoded.numbers.iter().zip(&encoded.vertices).enumerate() {
        message =
            message.replace(&format!("{{v{index}}}"), &format!("vertex {} ({unit} {place})", number + first));
    }
    for (index, place) in encoded.facets.iter().enumerate() {
        message = message.replace(&format!("{{f{index}}}"), &format!("{index} ({unit} {place})"));
    }
    message
}
