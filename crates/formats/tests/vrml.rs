//! VRML 2: tables of texts with the meshes or the errors that they must give, and the way back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use polytope::PolygonMesh;
use splitstar_formats::{Format, Kind, Model, Object, Place, ReadModel, WriteOptions, Written, read, write};

const HEADER: &str = "#VRML V2.0 utf8\n";

fn mesh(read: &ReadModel) -> &PolygonMesh {
    read.model.shape.mesh().expect("a VRML file has a mesh")
}

/// The coordinates of every point, as text.
fn shown(mesh: &PolygonMesh) -> Vec<String> {
    mesh.points.iter().map(|p| p.coordinates().map(|c| c.to_string()).join(" ")).collect()
}

fn objects(model: &Model) -> Vec<(&str, u32)> {
    model.objects.iter().map(|object| (object.name.as_str(), object.first_facet)).collect()
}

struct Good {
    name: &'static str,
    /// Behind the header.
    text: &'static str,
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
    objects: &'static [(&'static str, u32)],
}

const fn good(
    name: &'static str,
    text: &'static str,
    points: &'static [&'static str],
    facets: &'static [&'static [u32]],
    objects: &'static [(&'static str, u32)],
) -> Good {
    Good { name, text, points, facets, objects }
}

const TRIANGLE: &[&str] = &["0 0 0", "1 0 0", "0 1 0"];
const TWICE: &[&str] = &["0 0 0", "1 0 0", "0 1 0", "0 0 0", "1 0 0", "0 1 0"];
const ONE: &[&[u32]] = &[&[0, 1, 2]];
const TURNED: &[&[u32]] = &[&[0, 2, 1]];

const GOOD: &[Good] = &[
    good(
        "triangle",
        "Shape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 0 1 0] } coordIndex [0 1 2 -1] } }",
        TRIANGLE,
        ONE,
        &[],
    ),
    good(
        "no blanks, no last -1",
        "Shape{geometry IndexedFaceSet{coord Coordinate{point[0,0,0,1,0,0,0,1,0]}coordIndex[0,1,2]}}",
        TRIANGLE,
        ONE,
        &[],
    ),
    good(
        "indices first, comments, every other field",
        "WorldInfo { title \"a \\\" } ] # \\\\\" info [\"b\" \"c\nd\"] }\r\nNavigationInfo { type \"WALK\" }\r# }\n\
         Shape {\n appearance Appearance { material DEF red Material { diffuseColor 1 0 0 } texture NULL }\n\
         geometry IndexedFaceSet { # here {\n coordIndex [ 0, 1, 2, -1, 2 1 0 -1 ]\n solid FALSE convex FALSE ccw TRUE\n\
         creaseAngle 0.5 normal NULL color Color { color [1 0 0, 0 1 0] } colorIndex [0 1 -1] colorPerVertex FALSE\n\
         texCoord DEF t TextureCoordinate { point [0 0 1 1] } texCoordIndex [0 1 0 -1] normalIndex 3 vendor nan\n\
         coord Coordinate { point [ 0 0 0 1 0 0 0 1 0 ] } }\n}\nROUTE a.b TO c.d\n",
        TRIANGLE,
        &[&[0, 1, 2], &[2, 1, 0]],
        &[],
    ),
    good(
        "numbers",
        "Shape { geometry PointSet { coord Coordinate { point [.5 -1e-2 1/3 +2. 4/-2 0.10] } } }",
        &["1/2 -1/100 1/3", "2 -2 1/10"],
        &[],
        &[],
    ),
    good(
        "one point without brackets",
        "Shape { geometry PointSet { coord Coordinate { point 1 2 3 } } }",
        &["1 2 3"],
        &[],
        &[],
    ),
    good(
        "clockwise",
        "Shape { geometry IndexedFaceSet { ccw FALSE coord Coordinate { point [0 0 0 1 0 0 0 1 0] } coordIndex [0 1 2] } }",
        TRIANGLE,
        TURNED,
        &[],
    ),
    good(
        "lines",
        "DEF a Shape { geometry IndexedLineSet { coord Coordinate { point [0 0 0 1 0 0 0 1 0] } \
         coordIndex [0 1 2 -1 2 0] } }",
        TRIANGLE,
        &[&[0, 1], &[1, 2], &[2, 0]],
        &[("a", 0)],
    ),
    good(
        "exact coordinates as words",
        "Shape { geometry PointSet { coord ExactCoordinate { point [1/3 0 0, -4/6 1e2 .1] } } }",
        &["1/3 0 0", "-2/3 100 1/10"],
        &[],
        &[],
    ),
    good(
        "exact coordinates as strings",
        "PROTO ExactCoordinate [ exposedField MFVec3f point [] field MFString exact [] ] \
         { Coordinate { point IS point } }\n\
         Shape { geometry PointSet { coord ExactCoordinate { point [9 9 9] exact [\"1/3 0 0\", \" -4/6,1e2 .1 \"] } } }",
        &["1/3 0 0", "-2/3 100 1/10"],
        &[],
        &[],
    ),
    good(
        "exact coordinates of one string, or none",
        "Shape { geometry PointSet { coord ExactCoordinate { exact \"1/3 0 0\" } } }\n\
         Shape { geometry PointSet { coord ExactCoordinate { exact [] point [1 2 3] } } }\n\
         Shape { geometry PointSet { coord NULL } } Shape { geometry NULL } Shape { } \
         Shape { geometry PointSet { coord Coordinate { exact [\"1 1 1\"] } } }",
        &["1/3 0 0", "1 2 3"],
        &[],
        &[],
    ),
    good(
        "transforms",
        "Transform { children [ Transform { scale 2 2 2 translation 0 1/2 0 rotation 0 1 0 0 \
         scaleOrientation 0 0 1 3 children Shape { geometry PointSet { coord Coordinate { point [1 1 1] } } } } ]\n\
         translation 0.1 0 0 scale 1 3 1 center 0 0 0 } \
         Transform { center 1 1 0 scale 2 1 1/2 children [ Shape { geometry PointSet { coord Coordinate { \
         point [0 0 4] } } } ] }",
        &["21/10 15/2 2", "-1 0 2"],
        &[],
        &[],
    ),
    good(
        "a reflection",
        "Transform { scale 1 1 -1 children Shape { geometry IndexedFaceSet { coord Coordinate { \
         point [0 0 0 1 0 0 0 1 0] } coordIndex [0 1 2] } } }",
        TRIANGLE,
        TURNED,
        &[],
    ),
    good(
        "names",
        "DEF world Group { children [ Shape { geometry DEF g IndexedFaceSet { coord DEF c Coordinate { \
         point [0 0 0 1 0 0 0 1 0] } coordIndex [0 1 2] } } DEF part-2 Shape { geometry USE g } NULL ] }\n\
         Shape { geometry IndexedFaceSet { coord USE c coordIndex [2 1 0 -1] } }",
        TRIANGLE,
        &[&[0, 1, 2], &[0, 1, 2], &[2, 1, 0]],
        &[("world", 0), ("part-2", 1), ("", 2)],
    ),
    good(
        "nodes used twice",
        "DEF part Shape { geometry IndexedFaceSet { coord Coordinate { point [0 0 0 1 0 0 0 1 0] } \
         coordIndex [0 1 2] } }\nTransform { scale 1 1 5 children DEF again Group { children USE part } } USE part",
        TWICE,
        &[&[0, 1, 2], &[3, 4, 5], &[0, 1, 2]],
        &[("part", 0), ("part", 1), ("part", 2)],
    ),
    good(
        "a name given twice",
        "DEF c Group { children Shape { geometry DEF c PointSet { coord DEF c Coordinate { point 1 2 3 } } } }\n\
         Shape { geometry PointSet { coord USE c } }\n\
         Script { field SFNode n DEF c Coordinate { point 7 7 7 } }\nShape { geometry PointSet { coord USE c } }",
        &["1 2 3", "7 7 7"],
        &[],
        &[],
    ),
    good(
        "groups",
        "Anchor { url \"x\" children [ Billboard { children [ Collision { proxy Shape { geometry Sphere { } } \
         children Shape { geometry PointSet { coord Coordinate { point 1 2 3 } } } } ] } ] bboxSize 1 1 1 }",
        &["1 2 3"],
        &[],
        &[],
    ),
    good(
        "levels and choices",
        "LOD { range [1 2] level [ Shape { geometry PointSet { coord Coordinate { point 1 2 3 } } } \
         Shape { geometry Sphere { } } ] } LOD { level [] }\n\
         Switch { choice [ Inline { url \"x\" } DEF b Group { children Shape { geometry PointSet { \
         coord Coordinate { point 4 5 6 } } } } NULL ] whichChoice 1 }\n\
         Switch { choice [ Shape { geometry Cone { } } ] } Switch { whichChoice 7 choice [ NULL ] } \
         Switch { whichChoice -1 choice Shape { } } Switch { whichChoice 1 choice Shape { } }",
        &["1 2 3", "4 5 6"],
        &[],
        &[],
    ),
    good(
        "prototypes",
        "PROTO Thing [ field SFNode part Shape { geometry Box { } } eventIn SFBool set ] { PROTO Inner [] { Group { } }\
         DEF a Group { children [ DEF b Shape { geometry Sphere { } } ] } ROUTE a.x TO b.y }\n\
         EXTERNPROTO Other [ field SFBool on ] [ \"a.wrl\" \"b.wrl\" ] EXTERNPROTO Third [ ] \"c.wrl\"\n\
         Thing { part NULL } Other { on TRUE }\nShape { geometry PointSet { coord Coordinate { point 1 2 3 } } }",
        &["1 2 3"],
        &[],
        &[],
    ),
    good(
        "a box",
        "DEF box Transform { translation 1 1 1 children [ Shape { geometry Box { } } ] }",
        &["0 0 0", "2 0 0", "0 2 0", "2 2 0", "0 0 2", "2 0 2", "0 2 2", "2 2 2"],
        &[&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 2, 3, 1], &[4, 5, 7, 6]],
        &[("box", 0)],
    ),
];

#[test]
fn every_good_row_gives_its_mesh() {
    for row in GOOD {
        for (name, header) in [("", HEADER), (" (byte order mark)", "\u{FEFF}#VRML V2.0 utf8 # by hand\r\n")]
        {
            let name = format!("{}{name}", row.name);
            let read =
                read([header, row.text].concat().as_bytes(), None).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(read.format, Format::Vrml, "{name}");
            assert_eq!(shown(mesh(&read)), row.points, "{name}");
            assert_eq!(mesh(&read).facets.iter().collect::<Vec<_>>(), row.facets, "{name}");
            assert_eq!(objects(&read.model), row.objects, "{name}");
        }
    }
}

#[test]
fn cells_know_their_lines() {
    let text = "Shape { geometry IndexedFaceSet { coord Coordinate { point [\n0 0 0 1\r\n0 0\r0 1 0\n] } coordIndex [\n0 1 \
                2 -1 2\n1 0] } }";
    let read = read([HEADER, text].concat().as_bytes(), None).unwrap();
    assert_eq!(
        [0, 1, 2].map(|at| read.places.vertices.get(at)),
        [3, 3, 5].map(|line| Some(Place::Line(line)))
    );
    assert_eq!([0, 1].map(|at| read.places.facets.get(at)), [7, 7].map(|line| Some(Place::Line(line))));
}

/// Name, text behind the header, and the whole message.
const BAD: &[(&str, &str, &str)] = &[
    ("nothing", "", "the mesh is empty: it has no vertex; at least one is needed"),
    (
        "a node that is not closed",
        "Shape {\n geometry NULL\n",
        "line 3: the file ends where `}` was expected, for the `{` of line 2; complete it, or correct the counts",
    ),
    (
        "a string that is not closed",
        "WorldInfo { title \"a\n\\\" } ",
        "line 3: the file ends where the `\"` was expected that closes the string of line 2; complete it, or correct \
         the counts",
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
        "line 3: `\\\"0 0\\\"` where the three coordinates of a point in quotes was expected; correct it",
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
        "line 3: vertex index 3, but the file has 3 vertices; indices run from 0 to 2",
    ),
    ("negative", "[0 1 -2]", "line 3: vertex index -2, but the file has 3 vertices; indices run from 0 to 2"),
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
        ("# nothing", "the file is empty; a mesh was expected"),
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

fn model(points: &[[&str; 3]], facets: &[&[u32]], objects: &[(&str, u32)]) -> Model {
    let mut mesh = PolygonMesh { points: Vec::new(), facets: polytope::Facets::new() };
    mesh.points.extend(points.iter().map(|p| exact::Point3::from_rationals(&p.map(|c| c.parse().unwrap()))));
    facets.iter().for_each(|cycle| mesh.facets.push(cycle));
    let mut model = Model::of_mesh(mesh);
    let object = |&(name, first_facet): &(&str, u32)| Object { name: name.into(), first_facet };
    model.objects = objects.iter().map(object).collect();
    model
}

fn write_vrml(model: &Model, float: bool) -> Written {
    let mut options = WriteOptions::new(Format::Vrml);
    options.float = float;
    write(model, &options).unwrap()
}

const DECIMALS: &[[&str; 3]] = &[["0", "0", "0"], ["1.5", "0", "0"], ["0", "-1/8", "0"], ["0", "0", "2e3"]];
const FRACTIONS: &[[&str; 3]] =
    &[["0", "0", "0"], ["1/3", "0", "0"], ["0", "-1e399", "0"], ["0", "0", "2e3"]];
const FACETS: &[&[u32]] = &[&[0, 2, 1], &[0, 1, 3], &[3, 1, 2, 0]];

#[test]
fn files_have_this_layout() {
    let appearance = "  appearance Appearance { material Material {} }\n";
    let decimals = "Coordinate {\n      point [\n        0 0 0\n        1.5 0 0\n        0 -0.125 0\n        0 0 2000\n      \
                    ]\n    }\n";
    let written = write_vrml(&model(DECIMALS, &FACETS[..2], &[("a", 0), ("no name", 1)]), false);
    assert_eq!(
        String::from_utf8(written.bytes).unwrap(),
        format!(
            "{HEADER}DEF a Shape {{\n{appearance}  geometry IndexedFaceSet {{\n    solid TRUE\n    convex TRUE\n    \
             coord DEF points {decimals}    coordIndex [\n      0 2 1 -1\n    ]\n  }}\n}}\n\
             Shape {{\n{appearance}  geometry IndexedFaceSet {{\n    solid TRUE\n    convex TRUE\n    \
             coord USE points\n    coordIndex [\n      0 1 3 -1\n    ]\n  }}\n}}\n"
        )
    );
    let written = write_vrml(&model(FRACTIONS, &[], &[]), false);
    assert!(written.largest_rounding.is_zero());
    let huge = "1".to_string() + &"0".repeat(399);
    assert_eq!(
        String::from_utf8(written.bytes).unwrap(),
        format!(
            "{HEADER}PROTO ExactCoordinate [ exposedField MFVec3f point [] field MFString exact [] ] {{\n  \
             Coordinate {{ point IS point }}\n}}\nShape {{\n{appearance}  geometry PointSet {{\n    coord \
             ExactCoordinate {{\n      point [\n        0 0 0\n        0.3333333333333333 0 0\n        0 -3e38 0\n        \
             0 0 2000\n      ]\n      exact [\n        \"0 0 0\"\n        \"1/3 0 0\"\n        \"0 -{huge} 0\"\n        \
             \"0 0 2000\"\n      ]\n    }}\n  }}\n}}\n"
        )
    );
}

#[test]
fn written_files_come_back() {
    let lines: &[&[u32]] = &[&[2, 1], &[3, 0], &[2, 0]];
    let names: [&[(&str, u32)]; 4] =
        [&[], &[("points", 0), ("points_", 2)], &[("a+b", 1), ("", 2)], &[("a", 0), ("a", 1), ("\u{e9}", 2)]];
    for objects in names {
        for points in [DECIMALS, FRACTIONS] {
            for facets in [FACETS, lines, &FACETS[..1], &[]] {
                let objects: Vec<_> =
                    objects.iter().filter(|(_, first)| (*first as usize) < facets.len()).copied().collect();
                let model = model(points, facets, &objects);
                let bytes = write_vrml(&model, false).bytes;
                let again = read(&bytes, None).unwrap();
                assert_eq!(again.format, Format::Vrml);
                assert_eq!(mesh(&again).points, model.shape.mesh().unwrap().points);
                assert_eq!(mesh(&again).facets, model.shape.mesh().unwrap().facets);
                assert_eq!(again.model.objects, model.objects);
                assert_eq!(write_vrml(&again.model, false).bytes, bytes);
            }
        }
    }
}

#[test]
fn what_is_no_name_is_left_out() {
    for name in ["1a", "-a", "a b", "a.b", "a#b", "a\"", "a{", "DEF", "TO", "eventIn", "a\u{7f}", "a\n"] {
        let bytes = write_vrml(&model(DECIMALS, &FACETS[..1], &[(name, 0)]), false).bytes;
        assert!(read(&bytes, None).unwrap().model.objects.is_empty(), "{name:?}");
    }
}

#[test]
fn floats_are_written_on_request() {
    let mut points = FRACTIONS.to_vec();
    points[2] = ["0", "1", "0"];
    let written = write_vrml(&model(&points, &[], &[]), true);
    assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
    assert!(!written.bytes.windows(5).any(|word| word == b"Exact"));
    let mut options = WriteOptions::new(Format::Vrml);
    options.float = true;
    let error = write(&model(FRACTIONS, &[], &[]), &options).unwrap_err();
    assert_eq!(error, splitstar_formats::WriteError::TooLargeForFloat { vertex: 2 });
}

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }
}

const SPLICES: &[&str] = &[
    " ",
    "\n",
    "\r",
    "#",
    "\"",
    "\\",
    "{",
    "}",
    "[",
    "]",
    ",",
    "-",
    "-1",
    "0",
    "9",
    "1/3",
    "1e401",
    "\0",
    " DEF a ",
    " USE a ",
    " NULL ",
    " TRUE ",
    " PROTO ",
    " IS ",
    " Shape { } ",
    " children [ ] ",
    " scale 1 2 3 ",
    "4294967295",
    " Group { children [ ",
    " ] } ",
];

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x0097;
    const CASES: usize = 20_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Random(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let row = &GOOD[random.below(GOOD.len())];
        let mut text = row.text.as_bytes().to_vec();
        for _ in 0..=random.below(3) {
            let at = random.below(text.len() + 1);
            let end = (at + random.below(12)).min(text.len());
            let splice = match random.below(3) {
                0 => SPLICES[random.below(SPLICES.len())].as_bytes().to_vec(),
                1 => text[at..end].to_vec(),
                _ => Vec::new(),
            };
            let to = if random.below(2) == 0 { at } else { end };
            text.splice(at..to, splice);
        }
        match read(&[HEADER.as_bytes(), &text].concat(), None) {
            Ok(read_once) => {
                accepted += 1;
                let again = read(&write_vrml(&read_once.model, false).bytes, None).unwrap();
                assert_eq!(mesh(&again).points, mesh(&read_once).points, "case {case}");
                assert_eq!(mesh(&again).facets, mesh(&read_once).facets, "case {case}");
                assert_eq!(Kind::of(mesh(&again)), Kind::of(mesh(&read_once)), "case {case}");
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
}
