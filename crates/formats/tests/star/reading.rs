//! Good and bad files.

use crate::{CUBE, complex, examples, read, records, write};
use splitstar_formats::{Format, Kind, Place, Shape, Unit};

#[test]
fn the_examples_of_the_page_are_written_as_they_stand() {
    for text in examples() {
        let read = read(&text);
        assert_eq!(read.format, Format::Star);
        assert_eq!(write(&read.model), text);
    }
}

/// A file, and its canonical form.
const GOOD: &[[&str; 2]] = &[
    ["\u{FEFF}# first\r\n\r\n star\t1 complex # c\r\nend # c\r\n# behind\n\n", ""],
    ["star 1 complex\rvertex 5 0 0 0\rend", "vertex 0 0 0 0\n"],
    ["star 1 complex\nunit inch\nvertex 0 .5 1e2 -4/6\nend", "unit inch\nvertex 0 1/2 100 -2/3\n"],
    [
        "star 1 complex\nvertex 3 0 0 0 marked\nvertex 7 1 0 0\nedge 7 3 marked\nend",
        "vertex 0 0 0 0\nvertex 1 1 0 0\nedge 1 0\n",
    ],
    // The order of records is free.
    [
        "star 1 complex\nvertex 0 0 0 0\nvertex 1 1 0 0\nedge 0 1\nvolume 3\nvertex 2 0 1 0\nfacet 0 1 2 sides 3 0\nend",
        "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nvolume 3\nfacet 0 1 2 sides 3 0\n",
    ],
    // A facet with volume 1 in front is turned round, as nothing else is different from a mesh.
    [
        "star 1 complex\nvertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nfacet 0 1 2\nfacet 0 1 2 sides 1 0\nend",
        "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nfacet 0 1 2\nfacet 2 1 0\n",
    ],
    [
        "star 1 complex\nvolume 0 marked\nvolume 1 unmarked\nvolume 2\nvolume 9 unmarked\nend",
        "volume 0 marked\nvolume 1 unmarked\nvolume 2\nvolume 9 unmarked\n",
    ],
    ["star 1 complex\nvolume 0\nvolume 1 marked\nend", ""],
    [
        "star 1 complex\ndirection 0 1/2 1/3 0\ndirection 1 -30 -20 0\nedge 1 0 through 1/2 .5 0 unmarked\nend",
        "direction 0 3 2 0\ndirection 1 -3 -2 0\nedge 1 0 through 1/2 1/2 0 unmarked\n",
    ],
    // A half-plane with a line, and the same line as an edge: through another of its points.
    [
        "star 1 complex\ndirection 0 1 0 0\ndirection 1 0 1 0\ndirection 2 -1 0 0\nfacet 0 1 2 through 0 0 0 sides 0 0\nedge 2 0 through 5 0 0\nend",
        "direction 0 1 0 0\ndirection 1 0 1 0\ndirection 2 -1 0 0\nfacet 0 1 2 through 0 0 0 sides 0 0\n",
    ],
    [
        "star 1 complex\ndirection 0 1 0 0\ndirection 1 0 1 0\ndirection 2 -1 0 0\nfacet 0 1 2 through 0 0 0 sides 0 0\nedge 2 0 through 5 1 0\nend",
        "direction 0 1 0 0\ndirection 1 0 1 0\ndirection 2 -1 0 0\nfacet 0 1 2 through 0 0 0 sides 0 0\nedge 2 0 through 5 1 0\n",
    ],
    // Holes of one and two vertices, and a strip.
    [
        "star 1 complex\nvertex 0 0 0 0\ndirection 1 1 0 0\nvertex 2 0 1 0 unmarked\ndirection 3 -1 0 0\nvertex 4 1 1 0\nvertex 5 0 2 0\nfacet 0 1 5 3 hole 2 hole 4 1 unmarked\nend",
        "vertex 0 0 0 0\ndirection 1 1 0 0\nvertex 2 0 1 0 unmarked\ndirection 3 -1 0 0\nvertex 4 1 1 0\nvertex 5 0 2 0\nfacet 0 1 5 3 hole 2 hole 4 1 unmarked\n",
    ],
    [
        "star 1 complex\nobject \"a#\\\"\\\\\\n\\u{41}\\u{7}\"#c\nvertex 0 0 0 0\nend",
        "vertex 0 0 0 0\nobject \"a#\\\"\\\\\\nA\\u{7}\"\n",
    ],
];

#[test]
fn good_files_have_one_form() {
    for [text, canonical] in GOOD {
        let canonical = records(canonical);
        assert_eq!(write(&read(text).model), canonical, "{text}");
        assert_eq!(write(&read(&canonical).model), canonical, "{text}");
    }
}

#[test]
fn a_file_that_says_no_more_than_a_mesh_is_one() {
    let rows = [
        ("vertex 0 0 0 0\nvertex 1 1 0 0\n", Kind::Points),
        ("vertex 0 0 0 0\nvertex 1 1 0 0\nedge 0 1\n", Kind::Segments),
        ("vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nfacet 0 1 2 sides 0 0\n", Kind::Polygon),
        ("vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nfacet 0 1 2\n", Kind::Polygon),
        (CUBE, Kind::Surface),
    ];
    for (text, kind) in rows {
        let read = read(&records(text));
        assert_eq!(read.model.shape.mesh().map(Kind::of), Some(kind), "{text}");
    }
}

#[test]
fn places_units_and_objects_are_known() {
    let text = format!("star 1 complex\n# c\nunit foot\n{CUBE}object \"late\"\nend\n")
        .replace("facet 0 1 5 4", "object \"side\"\nobject \"\"\nfacet 0 1 5 4");
    let read = read(&text);
    assert_eq!(read.places.vertices.get(1), Some(Place::Line(5)));
    assert_eq!(read.places.facets.get(2), Some(Place::Line(16)));
    assert_eq!(read.model.unit, Some(Unit::Foot));
    let objects: Vec<_> = read.model.objects.iter().map(|o| (o.name.as_str(), o.first_facet)).collect();
    assert_eq!(objects, [("side", 2), ("", 2), ("late", 6)]);
    assert!(matches!(read.model.shape, Shape::Mesh(_)));
}

#[test]
fn objects_are_of_edges_where_there_is_no_facet() {
    let text = records("vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nedge 0 1\nobject \"b\"\nedge 1 2\n");
    let read = read(&text);
    assert_eq!(read.model.objects[0].first_facet, 1);
    assert_eq!(read.places.facets.get(1), Some(Place::Line(7)));
    assert_eq!(write(&read.model), text);
}

#[test]
fn defaults_are_filled_in() {
    let complex =
        complex(&records("vertex 3 0 0 0\nvertex 5 1 0 0\nvertex 9 0 1 0\nvertex 10 5 5 5\nfacet 9 5 3\n"));
    let facet = &complex.facets[0];
    assert_eq!((facet.outer.as_slice(), facet.sides, facet.marked), ([2, 1, 0].as_slice(), [0, 1], true));
    assert!(complex.vertices.iter().all(|vertex| vertex.marked));
    assert_eq!(complex.volumes.into_iter().collect::<Vec<_>>(), [(0, false), (1, true)]);
}

/// After the first line, and without `end`: what is said.
const BAD: &[[&str; 2]] = &[
    ["", "line 1: the file ends where a record or `end` was expected; complete it"],
    ["vertex 0 0 0 0\n\n", "line 3: the file ends where a record or `end` was expected; complete it"],
    ["end\nvertex 0 0 0 0", "line 3: `vertex` after the end of the complex; remove it"],
    ["end x", "line 2: `x` where the end of the line was expected; correct it"],
    [
        "point 0 0 0",
        "line 2: `point` where `vertex`, `direction`, `volume`, `object`, `facet`, `edge`, `unit`, `end` or a comment was expected; correct it",
    ],
    [
        "unit",
        "line 2: the line ends where `micron`, `millimeter`, `centimeter`, `inch`, `foot` or `meter` was expected; complete it",
    ],
    [
        "unit mm",
        "line 2: `mm` where `micron`, `millimeter`, `centimeter`, `inch`, `foot` or `meter` was expected; correct it",
    ],
    ["unit inch\nunit inch", "line 3: a second unit; remove one"],
    ["unit inch 2", "line 2: `2` where the end of the line was expected; correct it"],
    [
        "vertex",
        "line 2: the line ends where the number of the vertex, below 4294967295, was expected; complete it",
    ],
    [
        "vertex -1 0 0 0",
        "line 2: `-1` where the number of the vertex, below 4294967295, was expected; correct it",
    ],
    [
        "vertex 4294967295 0 0 0",
        "line 2: `4294967295` where the number of the vertex, below 4294967295, was expected; correct it",
    ],
    [
        "vertex 2 0 0 0\nvertex 2 0 0 0",
        "line 3: `2` where a number above 2, the one before, was expected; correct it",
    ],
    [
        "vertex 2 0 0 0\ndirection 1 0 0 1",
        "line 3: `1` where a number above 2, the one before, was expected; correct it",
    ],
    ["vertex 0 0 0", "line 2: the line ends where one of three coordinates was expected; complete it"],
    ["vertex 0 0 0 x", "line 2: `x` is no number; write an integer, a decimal or a fraction p/q"],
    ["vertex 0 0 0 1/0", "line 2: `1/0` has the denominator zero; write a fraction p/q with q not zero"],
    [
        "vertex 0 0 0 1e999999999",
        "line 2: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
    ],
    [
        "vertex 0 0 0 0 open",
        "line 2: `open` where `marked`, `unmarked` or the end of the line was expected; correct it",
    ],
    [
        "vertex 0 0 0 0 marked unmarked",
        "line 2: `unmarked` where the end of the line was expected; correct it",
    ],
    ["direction 0 0 0 0", "line 2: the direction is zero; give one that points somewhere"],
    ["direction 0 0 0 1 unmarked", "line 2: `unmarked` where the end of the line was expected; correct it"],
    ["volume", "line 2: the line ends where the number of the volume was expected; complete it"],
    ["volume x", "line 2: `x` where the number of the volume was expected; correct it"],
    ["volume 2\nvolume 2", "line 3: `2` where a number above 2, the volume before, was expected; correct it"],
    ["object", "line 2: the line ends where a name in quotes was expected; complete it"],
    ["object bracket", "line 2: `bracket` where a name in quotes was expected; correct it"],
    [
        "object \"bracket",
        "line 2: the line ends where the quote `\"` that ends the name was expected; complete it",
    ],
    [
        "object \"a\\t\"",
        "line 2: `\"a\\t\"` where a name with the escapes `\\\"`, `\\\\`, `\\n`, `\\u{..}` only was expected; correct it",
    ],
    [
        "object \"\\u{D800}\"",
        "line 2: `\"\\u{D800}\"` where a name with the escapes `\\\"`, `\\\\`, `\\n`, `\\u{..}` only was expected; correct it",
    ],
    ["object \"a\" b", "line 2: `b` where the end of the line was expected; correct it"],
    [
        "edge",
        "line 2: the line ends where the number of a vertex or direction declared above was expected; complete it",
    ],
    [
        "vertex 0 0 0 0\nedge 0 1",
        "line 3: `1` where the number of a vertex or direction declared above was expected; correct it",
    ],
    ["vertex 7 0 0 0\nedge 7 7", "line 3: both ends are vertex 7; name two different ones"],
    [
        "vertex 7 0 0 0\nvertex 8 0 0 0\nedge 7 8 9",
        "line 4: `9` where `through`, `marked`, `unmarked` or the end of the line was expected; correct it",
    ],
    [
        "vertex 7 0 0 0\nvertex 8 0 0 0\nedge 7 8 through 0 0 0",
        "line 4: `through` where the vertices say where it lies; remove it and its point",
    ],
    [
        "direction 7 1 0 0\ndirection 8 -2 0 0\nedge 7 8",
        "line 4: no vertex says where it lies; write `through` and one of its points",
    ],
    [
        "direction 7 1 0 0\ndirection 8 -2 0 0\nedge 7 8 through 0 0",
        "line 4: the line ends where one of three coordinates was expected; complete it",
    ],
    [
        "direction 7 1 0 0\ndirection 8 -2 0 1\nedge 7 8 through 0 0 0",
        "line 4: an edge between two directions that are not opposite; a line has opposite ones, a ray one",
    ],
    [
        "direction 7 1 0 0\ndirection 8 2 0 0\nedge 7 8",
        "line 4: an edge between two directions that are not opposite; a line has opposite ones, a ray one",
    ],
    // Edges that are there twice: in a mesh, beside facets, and lines.
    [
        "vertex 3 0 0 0\nvertex 4 1 0 0\nvertex 5 1 1 0\nedge 3 4\nedge 5 4\nedge 4 3\nedge 3 4\nend",
        "line 7: the edge stands in line 5 already; remove one of the two",
    ],
    [
        "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nfacet 0 1 2\nedge 0 1\nedge 1 0 unmarked\nend",
        "line 7: the edge stands in line 6 already; remove one of the two",
    ],
    [
        "direction 0 -2 3 0\ndirection 1 2 -3 0\nedge 0 1 through 0 0 0\nedge 0 1 through 1 1 0\nedge 1 0 through 4 -6 0\nend",
        "line 6: the edge stands in line 4 already; remove one of the two",
    ],
    ["facet", "line 2: a facet of 0 vertices; name three or more, or write an edge"],
    [
        "facet x",
        "line 2: `x` where a vertex, `hole`, `through`, `sides`, `marked`, `unmarked` or the end of the line was expected; correct it",
    ],
    [
        "facet 0",
        "line 2: `0` where the number of a vertex or direction declared above was expected; correct it",
    ],
    ["vertex 5 0 0 0\nfacet 5", "line 3: a facet of 1 vertex; name three or more, or write an edge"],
];

/// The same, after a triangle 5 6 7 and the directions 11 to 14.
const BAD_FACETS: &[[&str; 2]] = &[
    ["5 6", "a facet of 2 vertices; name three or more, or write an edge"],
    [
        "5 6 7 6",
        "vertex 6 stands twice in a cycle; name every vertex of a cycle once, and write a part that touches the cycle as a hole",
    ],
    ["5 6 7 hole", "a hole without a vertex that is a point; name one that is no direction"],
    ["5 6 7 hole 11", "a hole without a vertex that is a point; name one that is no direction"],
    [
        "5 6 7 hole 5 5",
        "vertex 5 stands twice in a cycle; name every vertex of a cycle once, and write a part that touches the cycle as a hole",
    ],
    ["5 6 7 hole 5 11 13", "a line without a vertex in a hole; put a vertex on it"],
    ["5 6 7 hole 9", "`9` where the number of a vertex or direction declared above was expected; correct it"],
    ["5 6 7 through 0 0 0", "`through` where the vertices say where it lies; remove it and its point"],
    [
        "5 6 7 sides 0",
        "the line ends where the number of a volume: 0, 1 or one declared above was expected; complete it",
    ],
    [
        "5 6 7 sides 0 2",
        "`2` where the number of a volume: 0, 1 or one declared above was expected; correct it",
    ],
    ["5 6 7 sides 0 0 0", "`0` where `marked`, `unmarked` or the end of the line was expected; correct it"],
    ["5 6 7 unmarked sides 0 0", "`sides` where the end of the line was expected; correct it"],
    [
        "5 6 7 sides 0 0 hole 6",
        "`hole` where `marked`, `unmarked` or the end of the line was expected; correct it",
    ],
    ["11 12 13 14", "no vertex says where it lies; write `through` and one of its points"],
    ["11 12 13", "no vertex says where it lies; write `through` and one of its points"],
    [
        "11 12 13 through 0 0 0 hole 5",
        "`hole` where `sides`, `marked`, `unmarked` or the end of the line was expected; correct it",
    ],
    ["5 11 13", "no vertex says where it lies; write `through` and one of its points"],
    [
        "5 11 13 12 14 through 0 0 0",
        "two lines without a vertex around one facet; put a vertex on all of its lines but one",
    ],
];

#[test]
fn bad_files_say_the_line_and_what_to_do() {
    for [text, message] in BAD {
        let text = format!("star 1 complex\n{text}");
        let error = splitstar_formats::read(text.as_bytes(), None).unwrap_err();
        assert_eq!(error.to_string(), *message, "{text}");
    }
    let before = "star 1 complex\nvertex 5 0 0 0\nvertex 6 1 0 0\nvertex 7 0 1 0\ndirection 11 1 0 0\n\
                  direction 12 0 1 0\ndirection 13 -1 0 0\ndirection 14 0 -1 0\n";
    for [facet, message] in BAD_FACETS {
        let text = format!("{before}facet {facet}");
        let error = splitstar_formats::read(text.as_bytes(), None).unwrap_err();
        assert_eq!(error.to_string(), format!("line 9: {message}"), "{facet}");
    }
}

#[test]
fn other_versions_and_kinds_are_refused() {
    let rows: [(&[u8], &str); 10] = [
        (b"star", "line 1: the line ends where the version, `1`, was expected; complete it"),
        (b"star one", "line 1: `one` where the version, `1`, was expected; correct it"),
        (b"star 1", "line 1: the line ends where the kind, `complex`, was expected; complete it"),
        (b"star 1 complex 3", "line 1: `3` where the end of the line was expected; correct it"),
        (
            b"\nstar 2 complex",
            "line 2: star version 2 cannot be read; this program knows version 1 only: update it",
        ),
        (
            b"star 1 arrangement",
            "line 1: an arrangement (star kind `arrangement`) as a mesh cannot be read; it has curves of a surface and no facets: give a mesh",
        ),
        (
            b"star 1 map",
            "line 1: star kind `map` cannot be read; this program knows the kinds `complex`, `arrangement` and `gaussian` only: update it, or correct the kind",
        ),
        (b"end", "line 1: `end` where the first line `star 1 complex` was expected; correct it"),
        (b" # only\n", "the file is empty; a model was expected"),
        (
            b"star 1 complex\nobject \"\xFF\"",
            "line 2: `\"\\xff\"` where a name in UTF-8 was expected; correct it",
        ),
    ];
    for (text, message) in rows {
        let error = splitstar_formats::read(text, Some("star")).unwrap_err();
        assert_eq!(error.to_string(), message, "{text:?}");
    }
}

#[test]
fn many_cells_that_are_almost_the_same_take_no_longer() {
    let n = 20_000;
    let mut lines = "direction 0 1 0 0\ndirection 1 0 1 0\ndirection 2 -1 0 0\n".to_string();
    (0..n).for_each(|i| lines += &format!("edge 0 2 through {i} {i} 0\n"));
    lines += &"facet 0 1 2 through 5 7 0\n".repeat(n);
    let text = records(&lines);
    let complex = complex(&text);
    // One of the lines is a side of all facets.
    assert_eq!(complex.summary().edges, n);
    assert_eq!(write(&read(&text).model).lines().count(), text.lines().count() - 1);
    let same = format!(
        "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nvertex 3 0 0 1\nedge 0 1\n{}",
        "facet 0 1 2\n".repeat(2 * n)
    );
    assert!(matches!(read(&records(&same)).model.shape, Shape::Complex(_)));
    let edges = same.replace("facet 0 1 2", "edge 1 2");
    assert!(splitstar_formats::read(records(&edges).as_bytes(), None).is_err());
}
