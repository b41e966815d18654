//! What the writers say of what they change or leave out.

// A test fails by panicking, in its helpers too.
#![allow(clippy::unwrap_used)]

use polytope::PolygonMesh;
use splitstar_formats::{Format, Model, Object, ReadModel, Shape, Unit, WriteOptions, read, write};

/// Two triangles, and two vertices that are in no facet.
const TRIANGLES: &[u8] = b"OFF\n6 2 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n8 8 8\n3 1 2 3\n3 1 2 4\n";
const TRIANGLE: &[u8] = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const POINTS: &[u8] = b"OFF\n2 0 0\n0 0 0\n1 0 0\n";
const SQUARE: &[u8] = b"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

fn model(text: &[u8], objects: &[(&str, u32)], unit: Option<Unit>) -> Model {
    let mut model = read(text, None).unwrap().model;
    model.unit = unit;
    model.objects =
        objects.iter().map(|&(name, first_facet)| Object { name: name.into(), first_facet }).collect();
    model
}

fn notes(model: &Model, format: Format) -> Vec<String> {
    let written = write(model, &WriteOptions::new(format)).unwrap();
    written.notes.iter().map(ToString::to_string).collect()
}

const UNUSED: &str = "the format has no vertices beside facets: 2 vertices left out";
const ASSUMED: &str = "the format needs a unit, and the model has none: millimeter is written";

#[test]
fn vertices_and_units() {
    use Format::{Glb, Obj, Off, Ply, PlyAscii, PlyBigEndian, Star, Stl, StlAscii, ThreeMf, Vrml};
    let [triangles, points] = [TRIANGLES, POINTS].map(|text| model(text, &[], None));
    for format in [Off, Obj, Ply, PlyBigEndian, PlyAscii, Vrml] {
        assert!(notes(&triangles, format).is_empty(), "{format:?}");
    }
    for format in [Stl, StlAscii, Glb, Star] {
        assert_eq!(notes(&triangles, format), [UNUSED], "{format:?}");
    }
    assert_eq!(notes(&triangles, ThreeMf), [ASSUMED, UNUSED]);
    for format in [Off, Obj, Ply, PlyBigEndian, PlyAscii, Vrml, Glb, Star] {
        assert!(notes(&points, format).is_empty(), "{format:?}");
    }
    let inches = model(TRIANGLE, &[], Some(Unit::Inch));
    assert!(notes(&inches, ThreeMf).is_empty());
    assert_eq!(notes(&inches, Off), ["the format has no unit: inch is not written"]);
    let one = TRIANGLES.to_vec();
    let one = String::from_utf8(one).unwrap().replace("3 1 2 4", "3 1 2 5");
    let one = one.replace("3 1 2 3", "3 1 2 4");
    assert_eq!(
        notes(&model(one.as_bytes(), &[], None), Star),
        ["the format has no vertices beside facets: 2 vertices left out"]
    );
}

#[test]
fn names() {
    let no_objects = "the format has no objects: one is written without its name";
    let changed = |names: &str| format!("the format does not take all names as they are: {names} changed");
    let one = changed("1 name of an object");
    for (name, obj, stl, threemf, vrml) in [
        ("plain", "", "", "", ""),
        ("", "", "", "", ""),
        ("two words", "", "", "", &*one),
        ("a\nb", &*one, &*one, &*one, &*one),
        ("a #b", &one, "", "", &one),
        ("a\\", &one, "", "", &one),
        (" a", &one, &one, "", &one),
        ("a\u{FFFE}", "", "", &one, ""),
        ("7", "", "", "", &one),
    ] {
        let model = model(TRIANGLE, &[(name, 0)], Some(Unit::Meter));
        let rows = [
            (Format::Obj, obj),
            (Format::StlAscii, stl),
            (Format::ThreeMf, threemf),
            (Format::Vrml, vrml),
            (Format::Star, ""),
            (Format::Glb, ""),
            (Format::Off, if name.is_empty() { "" } else { no_objects }),
            (Format::Ply, if name.is_empty() { "" } else { no_objects }),
            (Format::Stl, if name.is_empty() { "" } else { no_objects }),
        ];
        for (format, expected) in rows {
            let mut notes = notes(&model, format);
            notes.retain(|note| !note.contains("unit"));
            assert_eq!(notes.join("\n"), expected, "{name:?} to {format:?}");
        }
    }
    let two = model(TRIANGLES, &[("a\n", 0), ("b\n", 1)], None);
    assert_eq!(notes(&two, Format::Obj), [changed("2 names of objects")]);
    let as_one = "the format has no objects: 2 are written as one, without their names";
    assert_eq!(notes(&two, Format::Off), [as_one]);
    assert_eq!(notes(&two, Format::StlAscii), [as_one, UNUSED]);
}

#[test]
fn objects_without_facets() {
    let dropped = |objects: &str| format!("the format has no objects without facets: {objects} left out");
    let one = model(TRIANGLE, &[("a\n", 0), ("b", 0), ("c\n", 1)], Some(Unit::Meter));
    for format in [Format::Obj, Format::Vrml] {
        let notes = notes(&one, format);
        assert_eq!(notes[0], dropped("2 objects"), "{format:?}");
    }
    assert_eq!(notes(&one, Format::ThreeMf), [dropped("2 objects")]);
    assert!(notes(&one, Format::Glb).is_empty());
    assert!(notes(&one, Format::Star).is_empty());
    let point = model(POINTS, &[("a", 0)], None);
    assert_eq!(notes(&point, Format::Obj), [dropped("1 object")]);
    assert!(notes(&point, Format::Vrml).is_empty());
}

#[test]
fn one_and_many() {
    let square = model(SQUARE, &[], Some(Unit::Meter));
    assert_eq!(notes(&square, Format::ThreeMf), ["the format has triangles only: 1 facet cut into 2"]);
}

/// A mesh has no object that none of its files had.
#[test]
fn a_mesh_without_objects_stays_one() {
    let mut read_model: ReadModel = read(TRIANGLE, None).unwrap();
    for format in [Format::ThreeMf, Format::Obj, Format::Vrml, Format::StlAscii, Format::Star] {
        let written = write(&read_model.model, &WriteOptions::new(format)).unwrap();
        read_model = read(&written.bytes, None).unwrap();
        assert!(read_model.model.objects.is_empty(), "{format:?}");
    }
    let star = write(&read_model.model, &WriteOptions::new(Format::Star)).unwrap();
    assert!(!String::from_utf8(star.bytes).unwrap().contains("object"));
}

type Spoil<'a> = &'a dyn Fn(&mut Model);

/// A model that a program made may be anything, and is refused before it is written.
#[test]
fn models_that_are_none_are_refused_in_every_format() {
    let cases: [(Spoil<'_>, &str); 5] = [
        (
            &|model| model.shape = Shape::Mesh(PolygonMesh::default()),
            "there is no vertex; at least one is needed",
        ),
        (
            &|model| push(model, &[0, 1, 7]),
            "facet 1 has the vertex 7, which does not exist; correct the facet",
        ),
        (
            &|model| push(model, &[2]),
            "facet 1 has fewer than two vertices; a facet needs three, and a segment two",
        ),
        (
            &|model| model.objects = vec![object(2)],
            "object 0 is not where it should be: objects ascend, and begin with facets of the model",
        ),
        (
            &|model| model.objects = vec![object(1), object(0)],
            "object 0 is not where it should be: objects ascend, and begin with facets of the model",
        ),
    ];
    for (spoil, message) in cases {
        let mut spoilt = model(TRIANGLE, &[], None);
        spoil(&mut spoilt);
        for format in Format::ALL {
            let error = write(&spoilt, &WriteOptions::new(format)).unwrap_err();
            assert_eq!(error.to_string(), message, "{format:?}");
        }
    }
}

fn push(model: &mut Model, cycle: &[u32]) {
    let Shape::Mesh(mesh) = &mut model.shape else { panic!("a triangle is a mesh") };
    mesh.facets.push(cycle);
}

fn object(first_facet: u32) -> Object {
    Object { name: "a".into(), first_facet }
}

#[test]
fn a_text_in_utf_16_is_named() {
    for bytes in [&b"\xFF\xFEO\0F\0F\0"[..], b"\xFE\xFF\0v"] {
        for name in [None, Some("x.obj")] {
            let error = read(bytes, name).unwrap_err();
            assert_eq!(error.to_string(), "a text in UTF-16 cannot be read; write it in UTF-8");
        }
    }
}
