//! What the reader says to broken files, and to those that would never end.

use super::HEADER;
use splitstar_formats::read;

/// Name, text behind the header, and the whole message.
const BAD: &[(&str, &str, &str)] = &[
    ("nothing", "", "the mesh is empty: it has no vertex; at least one is needed"),
    (
        "a node that is not closed",
        "Shape {\n geometry NULL\n",
        "line 3: the file ends where `}` was expected, for the `{` of line 2; complete it",
    ),
    (
        "a string that is not closed",
        "WorldInfo { title \"a\n\\\" } ",
        "line 3: the file ends where the `\"` was expected that closes the string of line 2; complete it",
    ),
    (
        "brackets that do not fit",
        "Group {\n children [ }\n ]",
        "line 3: `}` where `]`, for the `[` of line 3, was expected; correct it",
    ),
    ("one bracket too many", "Group { }\n}", "line 3: `}` where a node was expected; correct it"),
    ("a node without a body", "Group Group { }", "line 2: `Group` where `{` was expected; correct it"),
    ("a number", "1 2 3", "line 2: `1` where a node was expected; correct it"),
    ("a field that is none", "Group { 1 }", "line 2: `1` where a field or `}` was expected; correct it"),
    ("a field without a value", "Group { children }", "line 2: `}` where a value was expected; correct it"),
    (
        "a field twice",
        "Group { children [ ]\n children [ ] }",
        "line 3: `children` where a field that the node does not yet have was expected; correct it",
    ),
    ("a prototype without a body", "PROTO A [ ] 7", "line 2: `7` where `{` was expected; correct it"),
    (
        "a prototype with a shape",
        "PROTO Tri [] {\n Shape { geometry Box { } } }\nShape { geometry Box { } }\nTri { }",
        "line 5: an instance of the PROTO `Tri`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype in a group",
        "PROTO Tri [] { Group { children Shape { } } }\nGroup { children [\n Tri { } ] }",
        "line 4: an instance of the PROTO `Tri`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype with another file",
        "PROTO In [] { Inline { url \"a.wrl\" } } DEF a In { }",
        "line 2: an instance of the PROTO `In`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype with a default shape",
        "PROTO A [ field SFNode part Shape { } ] { Group { children IS part } } A { }",
        "line 2: an instance of the PROTO `A`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype of prototypes",
        "PROTO A [] { Shape { } }\nPROTO B [] { Group { children A { } } }\nB { }",
        "line 4: an instance of the PROTO `B`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype within one",
        "PROTO A [] { PROTO B [] { Shape { } } B { } } A { }",
        "line 2: an instance of the PROTO `A`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype of another file",
        "EXTERNPROTO Tri [ field SFBool on ] [ \"a.wrl\" ]\nTri { }",
        "line 3: an instance of `Tri`, whose PROTO is in another file, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype of one of another file",
        "EXTERNPROTO A [ ] \"a.wrl\"\nPROTO B [] { A { } } B { }",
        "line 3: an instance of the PROTO `B`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype in an unknown node",
        "PROTO A [] { Shape { } } Panel { children [\n A { } ] }",
        "line 3: an instance of the PROTO `A`, which has shapes in it, cannot be read; write the nodes of the PROTO in its \
         place, or remove it if it has no shapes",
    ),
    (
        "a prototype without a name",
        "PROTO [ ] { }",
        "line 2: `[` where the name of a node type was expected; correct it",
    ),
    (
        "an unknown name",
        "Group { children USE a }\nDEF a Group { }",
        "line 2: `a` where a name that `DEF` has given before was expected; correct it",
    ),
    (
        "a name of a prototype",
        "PROTO A [ ] { DEF a Group { } }\nUSE a",
        "line 3: `a` where a name that `DEF` has given before was expected; correct it",
    ),
    (
        "a node within itself",
        "DEF a Group { children [\nUSE a ] }",
        "line 3: `a` where the name of a node that does not contain this place was expected; correct it",
    ),
    (
        "a rotation",
        "Transform {\n rotation 0 0 1\n 1.5707963 }",
        "line 3: a rotation by an angle that is not 0 cannot be read; apply the rotation before export",
    ),
    (
        "an oblique scale",
        "Transform { scale 1 2 1 scaleOrientation 0 0 1 1 }",
        "line 2: a scaleOrientation by an angle that is not 0 cannot be read; apply the rotation before export",
    ),
    (
        "a flat scale",
        "Transform { scale 1 0 1 }",
        "line 2: `1 ...` where a scale without 0 was expected; correct it",
    ),
    (
        "a short vector",
        "Transform { translation 1 2 }",
        "line 2: `}` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "another file",
        "Inline { url \"a.wrl\" }",
        "line 2: a node that takes in another file (`Inline`) cannot be read; put the content of that file in its \
         place",
    ),
    (
        "a sphere",
        "Shape {\n geometry Sphere { radius 2 } }",
        "line 3: the geometry `Sphere` cannot be read; turn it into an IndexedFaceSet before export, or remove it",
    ),
    (
        "a shape in an unknown node",
        "Joint {\n children Shape { } }",
        "line 2: a node of the type `Joint` with a Shape in it cannot be read; make it a Group or a Transform",
    ),
    (
        "no shape",
        "IndexedFaceSet { }",
        "line 2: `IndexedFaceSet` outside of a Shape cannot be read; put a Shape around it",
    ),
    (
        "a flat box",
        "Shape { geometry Box { size 1 0 1 } }",
        "line 2: `1 0 1` where a size of three positive numbers was expected; correct it",
    ),
    (
        "no coordinates",
        "Shape { geometry PointSet { coord Color { } } }",
        "line 2: `Color` where a Coordinate was expected; correct it",
    ),
    (
        "five numbers",
        "Shape { geometry PointSet { coord Coordinate { point [\n0 0 0\n1 2 ] } } }",
        "line 4: `]` where another coordinate, the number of which is divisible by three, was expected; correct it",
    ),
    (
        "a word",
        "Shape { geometry PointSet { coord Coordinate { point [\n0 0 x ] } } }",
        "line 3: `x` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "a large exponent",
        "Shape { geometry PointSet { coord Coordinate { point [\n0 0 1e999999999 ] } } }",
        "line 3: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "two exact coordinates",
        "Shape { geometry PointSet { coord ExactCoordinate { exact [\n\"0 0\" ] } } }",
        "line 3: `\"0 0\"` where the three coordinates of a point in quotes was expected; correct it",
    ),
    (
        "exact coordinates without quotes",
        "Shape { geometry PointSet { coord ExactCoordinate { exact [ 0 0 0 ] } } }",
        "line 2: `0` where the three coordinates of a point in quotes was expected; correct it",
    ),
    (
        "neither true nor false",
        "Shape { geometry IndexedFaceSet { ccw yes } }",
        "line 2: `yes` where TRUE or FALSE was expected; correct it",
    ),
    (
        "no choice",
        "Switch { whichChoice -2 }",
        "line 2: `-2` where the number of a choice was expected; correct it",
    ),
    (
        "a point beside a box",
        "Shape { geometry Box { } }\nShape { geometry PointSet { coord Coordinate { point [0 0 0] } } }",
        "line 3: a PointSet beside facets or lines cannot be read; remove it, or put it into a file of its own",
    ),
    (
        "a line beside a box",
        "Shape { geometry Box { } }\nShape { geometry IndexedLineSet { coord Coordinate { point [0 0 0 1 1 1] }\n\
         coordIndex [0 1] } }",
        "line 4: a facet of two vertices beside polygons; remove it, or give it a third vertex",
    ),
];

/// Name, indices of three vertices in two shapes, and the whole message.
const BAD_INDICES: &[(&str, &str, &str)] = &[
    (
        "index too large",
        "[0 1 3]",
        "line 3: vertex index 3, but there are 3 vertices; indices run from 0 to 2",
    ),
    ("negative", "[0 1 -2]", "line 3: vertex index -2, but there are 3 vertices; indices run from 0 to 2"),
    ("a word", "[0 1 two]", "line 3: `two` is no vertex index; write whole numbers counted from 0"),
    ("a decimal", "[0 1 2.0]", "line 3: `2.0` is no vertex index; write whole numbers counted from 0"),
    ("no list", "0", "line 3: `0` where `[` was expected; correct it"),
    ("no corner", "[0 1 2 -1 -1]", "line 3: a facet of 0 vertices; a facet needs three, and a segment two"),
    ("one corner", "[0 -1]", "line 3: a facet of 1 vertex; a facet needs three, and a segment two"),
    (
        "a vertex twice",
        "[0 1 2 1]",
        "line 3: the facet has vertex 1 twice; name every vertex of a facet once",
    ),
];

fn message(text: &str) -> Option<String> {
    read([HEADER, text].concat().as_bytes(), None).err().map(|error| error.to_string())
}

#[test]
fn every_bad_row_gives_its_message() {
    for (name, text, expected) in BAD {
        assert_eq!(message(text).as_deref(), Some(*expected), "{name}");
    }
    let coordinates = "coord Coordinate { point [0 0 0 1 0 0 0 1 0] }";
    for (name, indices, expected) in BAD_INDICES {
        let text = format!(
            "Shape {{ geometry PointSet {{ {coordinates} }} }}\n\
             Shape {{ geometry IndexedFaceSet {{ {coordinates} coordIndex {indices} }} }}"
        );
        assert_eq!(message(&text).as_deref(), Some(*expected), "{name}");
    }
}

#[test]
fn other_headers_are_named() {
    let rows = [
        (
            "#VRML V1.0 ascii\nSeparator { }",
            "line 1: VRML V1.0 ascii cannot be read; convert it to VRML 2 (VRML97)",
        ),
        ("# nothing", "the file is empty; a model was expected"),
        ("\nShape { }", "line 2: `Shape` where `#VRML V2.0 utf8` in the first line was expected; correct it"),
    ];
    for (text, message) in rows {
        assert_eq!(read(text.as_bytes(), Some("wrl")).unwrap_err().to_string(), message);
    }
}

#[test]
fn deep_and_wide_files_end() {
    let depth = 100_000;
    let deep = format!("{}{}", "Group { children [ ".repeat(depth), "] }".repeat(depth));
    let said = "line 2: nodes nested more than 64 deep cannot be read; take groups apart";
    assert_eq!(message(&deep).unwrap(), said);
    // 2^60 nodes of nothing.
    let mut wide = "DEF n0 Group { }\n".to_string();
    for k in 1..=60 {
        wide += &format!("DEF n{k} Group {{ children [ USE n{0} USE n{0} ] }}\n", k - 1);
    }
    assert!(message(&wide).unwrap().contains("too much for a file of this size"));
    // Digits that double at every level.
    let digits = format!("{}/{}", "7".repeat(2000), "9".repeat(1999) + "1");
    let transform = format!("Transform {{ scale {digits} {digits} {digits} children [\n");
    let long = format!("{}{}", transform.repeat(10), "] }".repeat(10));
    let said =
        "a Transform that makes numbers of more than 5000 digits cannot be read; write it with fewer digits";
    assert_eq!(message(&long).unwrap(), format!("line 4: {said}"));
}
