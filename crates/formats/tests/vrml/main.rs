//! VRML 2: tables of texts with the meshes or the errors that they must give, and the way back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod bad;
mod writing;

use polytope::PolygonMesh;
use splitstar_formats::{Format, Model, Place, ReadModel, read};

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
        "PROTO Thing [ field SFNode part Group { } eventIn SFBool set ] { PROTO Inner [] { Group { } }\
         DEF a Group { children [ DEF b Group { children Inner { } } ] } ROUTE a.x TO b.y }\n\
         PROTO Unused [ field MFNode parts [ Shape { } ] ] { Group { children Shape { geometry Sphere { } } } }\n\
         EXTERNPROTO Other [ field SFBool on ] [ \"a.wrl\" \"b.wrl\" ] EXTERNPROTO Third [ ] \"c.wrl\"\n\
         Thing { part NULL }\nShape { appearance Other { on TRUE } geometry PointSet { coord Coordinate { point 1 2 3 } } }",
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
