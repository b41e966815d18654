//! Tables of texts with the meshes or the errors that they must give.

use polytope::PolygonMesh;
use splitstar_formats::{Kind, Place, ReadError, ReadModel, read};

/// OFF by its name, so that the messages are those of its reader whatever the content looks like.
fn read_off(text: &[u8]) -> Result<ReadModel, ReadError> {
    read(text, Some("off"))
}

fn mesh(read: ReadModel) -> PolygonMesh {
    read.model.shape.into_mesh().expect("an OFF file has a mesh")
}

/// The coordinates of every point, as text.
fn shown(mesh: &PolygonMesh) -> Vec<String> {
    mesh.points.iter().map(|p| p.coordinates().map(|c| c.to_string()).join(" ")).collect()
}

struct Good {
    name: &'static str,
    text: &'static [u8],
    kind: Kind,
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
}

const fn good(
    name: &'static str,
    text: &'static [u8],
    kind: Kind,
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
) -> Good {
    Good { name, text, kind, points, facets }
}

const TRIANGLE: &[&str] = &["0 0 0", "1 0 0", "0 1 0"];

const GOOD: &[Good] = &[
    good("one point", b"OFF\n1 0 0\n1 2 3\n", Kind::Points, &["1 2 3"], &[]),
    good("no line break at the end", b"OFF\n1 0 0\n1 2 3", Kind::Points, &["1 2 3"], &[]),
    good("counts beside the keyword", b"OFF 1 0 0\n1 2 3\n", Kind::Points, &["1 2 3"], &[]),
    good("counts on three lines", b"OFF\n1\n0\n0\n1 2 3\n", Kind::Points, &["1 2 3"], &[]),
    good("a vertex on three lines", b"OFF\n1 0 0\n1\n2\n\n3\n", Kind::Points, &["1 2 3"], &[]),
    good("tabs and blanks", b"\t OFF \n\n 1\t0  0 \n \t1 2\t3 \n\n \n", Kind::Points, &["1 2 3"], &[]),
    good("byte order mark", b"\xEF\xBB\xBFOFF\n1 0 0\n1 2 3\n", Kind::Points, &["1 2 3"], &[]),
    good("CR LF", b"OFF\r\n1 0 0\r\n1 2 3\r\n", Kind::Points, &["1 2 3"], &[]),
    good("CR", b"OFF\r1 0 0\r1 2 3\r", Kind::Points, &["1 2 3"], &[]),
    good(
        "comments",
        b"# first\nOFF# second\n#\n1 0 0 # third\n# fourth\n1 2#0\n3\n# last",
        Kind::Points,
        &["1 2 3"],
        &[],
    ),
    good(
        "numbers",
        b"OFF\n4 0 0\n-1.25 +2 .5\n5. 1e2 -25E-3\n1/3 -4/6 10/5\n0.0 -0 0/7\n",
        Kind::Points,
        &["-5/4 2 1/2", "5 100 -1/40", "1/3 -2/3 2", "0 0 0"],
        &[],
    ),
    good(
        "long numbers",
        b"OFF\n1 0 0\n123456789012345678901234567890 0.1234567890123456789012345 \
          3/123456789012345678901234567890\n",
        Kind::Points,
        &["123456789012345678901234567890 246913578024691357802469/2000000000000000000000000 \
           1/41152263004115226300411522630"],
        &[],
    ),
    good("largest exponent", b"OFF\n1 0 0\n0e400 0e-400 0\n", Kind::Points, &["0 0 0"], &[]),
    good("segment", b"OFF\n2 1 1\n0 0 0\n1 0 0\n2 0 1\n", Kind::Segments, &["0 0 0", "1 0 0"], &[&[0, 1]]),
    good(
        "two segments",
        b"OFF\n3 2 2\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n2 1 2\n",
        Kind::Segments,
        TRIANGLE,
        &[&[0, 1], &[1, 2]],
    ),
    good("polygon", b"OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Kind::Polygon, TRIANGLE, &[&[0, 1, 2]]),
    good(
        "surface",
        b"OFF\n3 2 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n",
        Kind::Surface,
        TRIANGLE,
        &[&[0, 1, 2], &[2, 1, 0]],
    ),
    good(
        "facet colours",
        b"OFF\n3 3 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 2 1 0 0.5 0.5 0.5 1.0\n3 1 0 2 7\n",
        Kind::Surface,
        TRIANGLE,
        &[&[0, 1, 2], &[2, 1, 0], &[1, 0, 2]],
    ),
    good(
        "a facet on two lines",
        b"OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0\n1 2 255 0 0\n",
        Kind::Polygon,
        TRIANGLE,
        &[&[0, 1, 2]],
    ),
    good(
        "vertex colours",
        b"COFF\n2 0 0\n0 0 0 255 0 0 255\n1 2 3 1 1 1\n",
        Kind::Points,
        &["0 0 0", "1 2 3"],
        &[],
    ),
    good("normals", b"NOFF\n2 0 0\n0 0 0 0 0 1\n1 2 3 nx ny nz\n", Kind::Points, &["0 0 0", "1 2 3"], &[]),
    good(
        "normals on lines of their own",
        b"NOFF\n2 0 0\n0 0 0\n0 0 1\n1 2 3\n0 0 1\n",
        Kind::Points,
        &["0 0 0", "1 2 3"],
        &[],
    ),
    good("all of them", b"STCNOFF\n1 0 0\n1 2 3 0 0 1 9 9 9 9 0.5 0.5\n", Kind::Points, &["1 2 3"], &[]),
    good("colours and normals", b"CNOFF 1 0 0\n1 2 3 0 0 1 9 9 9 9\n", Kind::Points, &["1 2 3"], &[]),
    good("colours without their prefix", b"OFF 1 0 0\n1 2 3 255 255 255\n", Kind::Points, &["1 2 3"], &[]),
];

#[test]
fn every_good_row_gives_its_mesh() {
    for row in GOOD {
        let mesh = mesh(read_off(row.text).unwrap_or_else(|e| panic!("{}: {e}", row.name)));
        assert_eq!(Kind::of(&mesh), row.kind, "{}", row.name);
        assert_eq!(shown(&mesh), row.points, "{}", row.name);
        assert_eq!(mesh.facets.iter().collect::<Vec<_>>(), row.facets, "{}", row.name);
    }
}

/// Name, text, and the whole message.
const BAD: &[(&str, &[u8], &str)] = &[
    ("empty", b"", "the file is empty; a model was expected"),
    ("blank", b"\n # OFF\n\r\n", "the file is empty; a model was expected"),
    (
        "another format",
        b"\nsculpture cube\n",
        "line 2: no known format: the file begins with `sculpture`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read",
    ),
    (
        "small letters",
        b"off\n1 0 0\n0 0 0\n",
        "line 1: no known format: the file begins with `off`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read",
    ),
    (
        "no blank behind the keyword",
        b"OFF8 6 12\n",
        "line 1: no known format: the file begins with `OFF8`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read",
    ),
    (
        "four coordinates",
        b"4OFF\n1 0 0\n0 0 0 1\n",
        "line 1: 4OFF (coordinates that are not three) cannot be read; \
         write the mesh as ASCII OFF with three coordinates a vertex",
    ),
    (
        "n coordinates",
        b"nOFF 3\n1 0 0\n0 0 0\n",
        "line 1: nOFF (coordinates that are not three) cannot be read; \
         write the mesh as ASCII OFF with three coordinates a vertex",
    ),
    (
        "binary",
        b"OFF BINARY\n\x00\x00\x00\x01",
        "line 1: OFF BINARY cannot be read; write the mesh as ASCII OFF with three coordinates a vertex",
    ),
    (
        "no counts",
        b"OFF\n\n",
        "line 2: the file ends where the numbers of vertices, facets and edges were expected; \
         complete it",
    ),
    (
        "negative count",
        b"OFF\n-1 0 0\n",
        "line 2: `-1` is no number of vertices; write a whole number, 0 or larger",
    ),
    (
        "fractional count",
        b"OFF\n1 0.5 0\n",
        "line 2: `0.5` is no number of facets; write a whole number, 0 or larger",
    ),
    (
        "count beyond 32 bits",
        b"OFF\n4294967295 0 0\n",
        "line 2: 4294967295 vertices are too many; a mesh has at most 4294967294",
    ),
    (
        "counts without edges",
        b"OFF\n1 0\n0 0 0\n",
        "line 3: `0` where the end of the line with the three counts (of vertices, facets and edges) was expected; \
         correct it",
    ),
    ("no vertex", b"OFF\n0 0 0\n", "line 2: the mesh is empty: it has no vertex; at least one is needed"),
    (
        "word",
        b"OFF\n1 0 0\n0 x1 0\n",
        "line 3: `x1` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "decimal comma",
        b"OFF\n1 0 0\n0 1,5 0\n",
        "line 3: `1,5` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "decimal in a fraction",
        b"OFF\n1 0 0\n0 1.5/2 0\n",
        "line 3: `1.5/2` is no number; write an integer, a decimal or a fraction p/q",
    ),
    ("not a number", b"OFF\n1 0 0\n0 0 NaN\n", "line 3: `NaN` is not finite; write a finite number"),
    ("infinity", b"OFF\n1 0 0\n-inf 0 0\n", "line 3: `-inf` is not finite; write a finite number"),
    (
        "zero denominator",
        b"OFF\n1 0 0\n0\n0\n-3/0\n",
        "line 5: `-3/0` has the denominator zero; write a fraction p/q with q not zero",
    ),
    (
        "large exponent",
        b"OFF\n1 0 0\n0 0 1e401\n",
        "line 3: the exponent of `1e401` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "negative large exponent",
        b"OFF\n1 0 0\n0 0 1e-401\n",
        "line 3: the exponent of `1e-401` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "exponent far beyond",
        b"OFF\n1 0 0\n0 0 1e-99999999999999999999999\n",
        "line 3: the exponent of `1e-99999999999999999999999` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "vertex missing",
        b"OFF\n2 0 0\n0 0 0\n",
        "line 3: the file ends where a vertex was expected, after 1 of 2 vertices; \
         complete it",
    ),
    (
        "coordinate missing",
        b"OFF\n2 0 0\n0 0 0\n1 2\n",
        "line 4: the file ends where a vertex was expected, after 1 of 2 vertices; \
         complete it",
    ),
    (
        "normal missing",
        b"NOFF\n1 0 0\n0 0 0 1",
        "line 3: the file ends where a vertex was expected, after 0 of 1 vertices; \
         complete it",
    ),
    (
        "facet missing",
        b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        "line 6: the file ends where a facet was expected, after 1 of 2 facets; \
         complete it",
    ),
    (
        "index missing",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
        "line 6: the file ends where a facet was expected, after 0 of 1 facets; \
         complete it",
    ),
    (
        "empty facet",
        b"OFF\n1 1 0\n0 0 0\n0\n",
        "line 4: a facet of 0 vertices; a facet needs three, and a segment two",
    ),
    (
        "facet of one vertex",
        b"OFF\n1 1 0\n0 0 0\n1 0\n",
        "line 4: a facet of 1 vertex; a facet needs three, and a segment two",
    ),
    (
        "facet of -3 vertices",
        b"OFF\n1 1 0\n0 0 0\n-3 0 0 0\n",
        "line 4: `-3` is no number of vertices of a facet; write a whole number, 0 or larger",
    ),
    (
        "segment beside a polygon",
        b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n",
        "line 6: a facet of two vertices beside polygons; remove it, or give it a third vertex",
    ),
    (
        "index too large",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
        "line 6: vertex index 3, but there are 3 vertices; indices run from 0 to 2",
    ),
    (
        "index far too large",
        b"OFF\n1 1 0\n0 0 0\n3 0 99999999999999999999 3\n",
        "line 4: vertex index 99999999999999999999, but there is 1 vertex; indices run from 0 to 0",
    ),
    (
        "negative index",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n",
        "line 6: vertex index -1, but there are 3 vertices; indices run from 0 to 2",
    ),
    (
        "fractional index",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.0 2\n",
        "line 6: `1.0` is no vertex index; write whole numbers counted from 0",
    ),
    (
        "vertex twice in a row",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1\n1 2\n",
        "line 6: the facet has vertex 1 twice in a row; name every vertex of a facet once",
    ),
    (
        "vertex first and last",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n",
        "line 6: the facet has vertex 0 twice in a row; name every vertex of a facet once",
    ),
    (
        "vertex twice",
        b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 1 2 1 3\n",
        "line 7: the facet has vertex 1 twice; name every vertex of a facet once",
    ),
    (
        "segment from a vertex to itself",
        b"OFF\n1 1 0\n0 0 0\n2 0 0\n",
        "line 4: the facet has vertex 0 twice in a row; name every vertex of a facet once",
    ),
    (
        "a facet too many",
        b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\n3 2 1 0\n",
        "line 8: `3` after the end of the mesh, whose counts promise 1 facet; remove it",
    ),
    (
        "a vertex too many",
        b"OFF\n1 0 0\n0 0 0\n1 0 0\n",
        "line 4: `1` after the end of the mesh, whose counts promise 0 facets; remove it",
    ),
];

#[test]
fn every_bad_row_gives_its_message() {
    for (name, text, message) in BAD {
        let error = read_off(text).expect_err(name);
        assert_eq!(error.to_string(), *message, "{name}");
        let place = error.place.map_or(String::new(), |place| format!("{place}: "));
        assert_eq!(format!("{place}{}", error.sentence()), *message, "{name}");
    }
}

#[test]
fn the_number_of_digits_is_limited() {
    let file = |token: &str| format!("OFF\n1 0 0\n0\n{token} 0\n");
    let most = exact::MAX_DIGITS as usize;
    let [nines, zeros] = ["9", "0"].map(|digit| digit.repeat(most));
    for token in
        [nines.clone(), zeros.clone(), format!("-{nines}/7{}", &nines[1..]), format!("0.{}", &nines[1..])]
    {
        read_off(file(&token).as_bytes()).unwrap();
    }
    for token in [format!("1{nines}"), format!("{zeros}1"), format!("7/{zeros}7"), format!("0.{nines}e9")] {
        let message = format!(
            "line 4: `{}...` has too many digits; an integer, a decimal and each part of a fraction may have 5000",
            &token[..40]
        );
        assert_eq!(read_off(file(&token).as_bytes()).unwrap_err().to_string(), message);
    }
}

#[test]
fn records_know_their_lines() {
    let text = b"OFF\n# a comment\n3 2 0\n0 0 0\n\n1 0\n0\n0 1 0\n3 0\n1 2\n3 2 1 0\n";
    let read = read_off(text).unwrap();
    let lines = |lines: &[u32]| lines.iter().copied().map(|line| Some(Place::Line(line))).collect::<Vec<_>>();
    let [vertices, facets] = [&read.places.vertices, &read.places.facets];
    assert_eq!((0..3).map(|v| vertices.get(v)).collect::<Vec<_>>(), lines(&[4, 6, 8]));
    assert_eq!((0..2).map(|f| facets.get(f)).collect::<Vec<_>>(), lines(&[9, 11]));
    assert_eq!((vertices.get(3), facets.get(2)), (None, None));
}

#[test]
fn decimals_are_exact() {
    // One tenth is not the nearest double of one tenth, and the sum of the two is 3/10.
    let mesh = mesh(read_off(b"OFF\n2 0 0\n0.1 0.30000000000000004 1e-400\n0.2 0.3 1e400\n").unwrap());
    let [first, second] = [0, 1].map(|vertex| mesh.points[vertex].coordinates());
    assert_eq!((&first[0] + &second[0]).to_string(), "3/10");
    assert!(first[1] > second[1]);
    assert_eq!((&first[2] * &second[2]).to_string(), "1");
}
