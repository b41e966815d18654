//! OBJ: tables of texts with the meshes or the errors that they must give, and the way back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod writing;

use polytope::PolygonMesh;
use splitstar_formats::{Format, Place, ReadError, ReadModel, read};

/// By its name, so that the messages are those of the OBJ reader whatever the content looks like.
fn read_obj(text: &[u8]) -> Result<ReadModel, ReadError> {
    read(text, Some("obj"))
}

fn mesh(read: &ReadModel) -> &PolygonMesh {
    read.model.shape.mesh().expect("an OBJ file has a mesh")
}

/// The coordinates of every point, as text.
fn shown(mesh: &PolygonMesh) -> Vec<String> {
    mesh.points.iter().map(|p| p.coordinates().map(|c| c.to_string()).join(" ")).collect()
}

struct Good {
    name: &'static str,
    text: &'static [u8],
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
    objects: &'static [(&'static str, u32)],
}

const fn good(
    name: &'static str,
    text: &'static [u8],
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
    objects: &'static [(&'static str, u32)],
) -> Good {
    Good { name, text, points, facets, objects }
}

const TRIANGLE: &[&str] = &["0 0 0", "1 0 0", "0 1 0"];
const ONE: &[&[u32]] = &[&[0, 1, 2]];
const TWO: &[&[u32]] = &[&[0, 1, 2], &[2, 1, 0]];

const GOOD: &[Good] = &[
    good("triangle", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", TRIANGLE, ONE, &[]),
    good("no line break at the end", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", TRIANGLE, ONE, &[]),
    good("CR LF", b"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", TRIANGLE, ONE, &[]),
    good("CR", b"v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", TRIANGLE, ONE, &[]),
    good("byte order mark", b"\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", TRIANGLE, ONE, &[]),
    good(
        "comments, blanks, blank lines",
        b"# first\n\n\tv  0 0\t0 # second\nv 1 0 0#third\n#v 9 9 9\n v 0 1 0 \n \nf 1 2 3#4\n#",
        TRIANGLE,
        ONE,
        &[],
    ),
    good("numbers", b"v .5 -1e-2 1/3\nv +2. 4/-2 0.10\n", &["1/2 -1/100 1/3", "2 -2 1/10"], &[], &[]),
    good("weights", b"v 0 0 0 1\nv 1 0 0 2.5\nv 0 1 0 0.1\nf 1 2 3", TRIANGLE, ONE, &[]),
    good("colours", b"v 0 0 0 1 .5 0\nv 1 0 0 1 1 0 0\nv 0 1 0 255 255 255\nf 1 2 3", TRIANGLE, ONE, &[]),
    good(
        "forms of corners",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvt 0 1\nvt 0 1 0\nvn 0 0 1\nvn nan nan nan\nvp 1\nvp 1 2 3\n\
          f 1/1 2/2 3/3\nf 3//1 2//1 1//-1\nf 1/1/1 2/-2/1 3/0/0\nf 3/ 2// 1/1/\n",
        TRIANGLE,
        &[&[0, 1, 2], &[2, 1, 0], &[0, 1, 2], &[2, 1, 0]],
        &[],
    ),
    good(
        "negative indices",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1/-1 -2/-2 -3/-3\nf 1 -1 -2\n",
        &["0 0 0", "1 0 0", "0 1 0", "5 5 5"],
        &[&[0, 1, 2], &[3, 2, 1], &[0, 3, 2]],
        &[],
    ),
    good(
        "polygons",
        b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nfo 4 3 2",
        &["0 0 0", "1 0 0", "1 1 0", "0 1 0"],
        &[&[0, 1, 2, 3], &[3, 2, 1]],
        &[],
    ),
    good(
        "continued lines",
        b"v 0 \\\n0 0\nv 1 0\\\r\n 0\n\\\nv 0 1 0\nf 1 \\\n2\\\n\\\n3\nvn 0\\\n 0 1\nparm u \\\n0 1\n",
        TRIANGLE,
        ONE,
        &[],
    ),
    good("a backslash at the end", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\", TRIANGLE, ONE, &[]),
    good(
        "other statements",
        b"mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\ns off\nusemtl red\nf 1 2 3\ns 1\ncstype bezier\n\
          deg 3\nend\nlod 3\nbevel on\nVendor.Word x y\n",
        TRIANGLE,
        ONE,
        &[],
    ),
    good(
        "objects",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\no first\nf 1 2 3\no empty\no  second part # why\nf 3 2 1\no last",
        TRIANGLE,
        TWO,
        &[("first", 0), ("second part", 1)],
    ),
    good(
        "facets before the first object",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no part#2\nf 3 2 1\n",
        TRIANGLE,
        TWO,
        &[("part#2", 1)],
    ),
    good(
        "groups",
        b"g\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng a b \\\nc\nf 3 2 1\n",
        TRIANGLE,
        TWO,
        &[("a b", 1)],
    ),
    good(
        "groups within objects",
        b"g a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng b\no \xFF\nf 3 2 1\ng c\n",
        TRIANGLE,
        TWO,
        &[("\u{FFFD}", 1)],
    ),
    good("a line", b"v 0 0 0\nv 1 0 0\nl 1 2\n", &["0 0 0", "1 0 0"], &[&[0, 1]], &[]),
    good(
        "polylines",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1/1 2/2 -1/3\no closing\nl 3 1\n",
        TRIANGLE,
        &[&[0, 1], &[1, 2], &[2, 0]],
        &[("closing", 2)],
    ),
    good("points", b"v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n", TRIANGLE, &[], &[]),
    good("some points", b"v 0 0 0\np 1\nv 7 7 7\nv 1 0 0\np -1 1\nv 0 1 0\np 4\nv 8 8 8", TRIANGLE, &[], &[]),
    good("points without statements", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", TRIANGLE, &[], &[]),
];

#[test]
fn every_good_row_gives_its_mesh() {
    for row in GOOD {
        let read = read_obj(row.text).unwrap_or_else(|e| panic!("{}: {e}", row.name));
        assert_eq!(read.format, Format::Obj, "{}", row.name);
        assert_eq!(shown(mesh(&read)), row.points, "{}", row.name);
        assert_eq!(mesh(&read).facets.iter().collect::<Vec<_>>(), row.facets, "{}", row.name);
        let objects: Vec<_> =
            read.model.objects.iter().map(|object| (object.name.as_str(), object.first_facet)).collect();
        assert_eq!(objects, row.objects, "{}", row.name);
        assert!(read.places.vertices.get(row.points.len()).is_none(), "{}", row.name);
        assert!(read.places.facets.get(row.facets.len()).is_none(), "{}", row.name);
    }
}

#[test]
fn cells_know_their_lines() {
    let read = read_obj(b"v 0 0 0\np 1\nv 7 7 7\nv 1 0 0\n# 5\np 3\n").unwrap();
    assert_eq!(
        [0, 1, 2].map(|at| read.places.vertices.get(at)),
        [Some(Place::Line(1)), Some(Place::Line(4)), None]
    );
    let read = read_obj(b"v 0 0 0\nv 7 7 7\n\nv 1 0 \\\n0\nf 1 \\\n2 3\nf 3 2 1\n").unwrap();
    assert_eq!(read.places.vertices.get(2), Some(Place::Line(4)));
    assert_eq!([0, 1].map(|at| read.places.facets.get(at)), [Some(Place::Line(6)), Some(Place::Line(8))]);
}

/// Name, text, and the whole message.
const BAD: &[(&str, &[u8], &str)] = &[
    ("empty", b"", "the file is empty; a model was expected"),
    ("only comments", b"\n # v 0 0 0\n\\\n", "the file is empty; a model was expected"),
    ("no vertex", b"o cube\n", "the mesh is empty: it has no vertex; at least one is needed"),
    ("no vertex named", b"v 0 0 0\np\n", "the mesh is empty: it has no vertex; at least one is needed"),
    (
        "no vertex yet",
        b"f 1 2 3\nv 0 0 0\n",
        "line 1: vertex index 1, but there is no vertex; write the vertices first",
    ),
    (
        "two coordinates",
        b"v 0 0 0\nv 1 2 # and\n",
        "line 2: `v 1 2` where a vertex of three coordinates (`v x y z`) was expected; correct it",
    ),
    (
        "eight numbers",
        b"v 0 0 0 1 1 1 1 8\n",
        "line 1: `8` where the end of a vertex of three to seven numbers was expected; correct it",
    ),
    ("a word", b"v 0 0 x\n", "line 1: `x` is no number; write an integer, a decimal or a fraction p/q"),
    (
        "a weight that is a word",
        b"v 0 0 0 w\n",
        "line 1: `w` is no number; write an integer, a decimal or a fraction p/q",
    ),
    ("infinite", b"v 0 inf 0\n", "line 1: `inf` is not finite; write a finite number"),
    (
        "a large exponent",
        b"v 0 1e999999999 0\n",
        "line 1: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "index 0",
        b"v 0 0 0\n\nf 0 1 2\n",
        "line 3: `0` is no vertex index; write whole numbers counted from 1",
    ),
    (
        "index too large",
        b"v 0 0 0\nv 1 0 0\nf 1 2 9/1/1\n",
        "line 3: vertex index 9, but there are 2 vertices; indices run from 1 to 2",
    ),
    (
        "index far too large",
        b"v 0 0 0\nf 1 2 99999999999999999999\n",
        "line 2: vertex index 2, but there is 1 vertex; indices run from 1 to 1",
    ),
    (
        "negative index too large",
        b"v 0 0 0\nf -2 1 1\n",
        "line 2: vertex index -2, but there is 1 vertex; indices run from 1 to 1",
    ),
    (
        "no index",
        b"v 0 0 0\nf 1 1.5 1\n",
        "line 2: `1.5` is no vertex index; write whole numbers counted from 1",
    ),
    (
        "index of texture coordinates only",
        b"v 0 0 0\nf 1 /1 1\n",
        "line 2: `` is no vertex index; write whole numbers counted from 1",
    ),
    (
        "bad texture index",
        b"v 0 0 0\nf 1/a 1 1\n",
        "line 2: `1/a` where a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` was expected; correct it",
    ),
    (
        "four indices",
        b"v 0 0 0\nf 1/1/1/1 1 1\n",
        "line 2: `1/1/1/1` where a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` was expected; correct it",
    ),
    (
        "a vertex twice",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -3\n",
        "line 4: the facet has vertex 1 twice in a row; name every vertex of a facet once",
    ),
    ("no corner", b"v 0 0 0\nf\n", "line 2: a facet of 0 vertices; a facet needs three, and a segment two"),
    ("one corner", b"v 0 0 0\nl 1\n", "line 2: a facet of 1 vertex; a facet needs three, and a segment two"),
    (
        "a line beside a facet",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n",
        "line 5: a facet of two vertices beside polygons; remove it, or give it a third vertex",
    ),
    (
        "a point beside a facet",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\nf 1 2 3\n",
        "line 4: points beside facets or lines cannot be read; remove them, or put them into a file of their own",
    ),
    (
        "a normal of two numbers",
        b"vn 0 1\n",
        "line 1: `vn 0 1` where a normal of three numbers was expected; correct it",
    ),
    (
        "no texture coordinates",
        b"vt\n",
        "line 1: `vt` where a texture vertex of one to three numbers was expected; correct it",
    ),
    (
        "a surface",
        b"v 0 0 0\ncstype bezier\nsurf 0 1 0 1 1\n",
        "line 3: free-form geometry (`surf`) cannot be read; turn it into polygons before export",
    ),
    (
        "another file",
        b"call part.obj\n",
        "line 1: a statement that takes in another file (`call`) cannot be read; put the content of that file \
         in its place",
    ),
    (
        "no word",
        b"v 0 0 0\n1 2 3\n",
        "line 2: `1` where a statement (`v`, `f`, `o` or another word) was expected; correct it",
    ),
];

#[test]
fn every_bad_row_gives_its_message() {
    for (name, text, message) in BAD {
        let error = read_obj(text).expect_err(name);
        assert_eq!(error.to_string(), *message, "{name}");
    }
}
