//! 3MF: what models mean, and what is written.

// A test fails by panicking, in its helpers too.
#![allow(clippy::unwrap_used)]

mod threemf_archives;

use splitstar_formats::{
    Encoding, Format, Kind, Model, Object, Place, ReadModel, Unit, WriteError, WriteNote, WriteOptions, read,
    write,
};
use std::io::Read;
use threemf_archives::{CORE, MESH, RELATIONSHIPS, TYPE, archive, model, package};

fn read_model(text: &str) -> ReadModel {
    read(&package(text), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn points(read: &ReadModel) -> Vec<String> {
    read.model.shape.mesh().unwrap().points.iter().map(ToString::to_string).collect()
}

fn facets(read: &ReadModel) -> Vec<Vec<u32>> {
    read.model.shape.mesh().unwrap().facets.iter().map(<[u32]>::to_vec).collect()
}

const TETRAHEDRON: [&str; 4] = ["(0, 0, 0)", "(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1/10)"];

#[test]
fn every_way_to_say_the_same_is_read() {
    let object = format!("<object id='1' name='a'>{MESH}</object>");
    let build = "<build><item objectid='1'/></build>";
    let prefixed = model("", &object, build)
        .replace("xmlns=", "xmlns:c=")
        .replace("</", "</c:")
        .replace('<', "<c:")
        .replace("<c:/c:", "</c:")
        .replace("<c:?", "<?");
    let rows = [
        ("plain", model("", &object, build)),
        ("no build", model("", &object, "")),
        ("an empty build", model("", &object, "<build/>")),
        ("CR LF", model("", &object, build).replace('\n', "\r\n")),
        ("a byte order mark", format!("\u{FEFF}{}", model("", &object, build))),
        ("a prefix", prefixed),
        ("comments", model("", &format!("<!-- <object> -->{object}<?print now?>"), build)),
        ("metadata", model("", &object, build).replace("<resources>", "<metadata name='Title'>a &amp; b &#65;<b/></metadata><resources>")),
        ("materials", model(
            "requiredextensions='m' xmlns:m='http://schemas.microsoft.com/3dmanufacturing/material/2015/02'",
            &format!("<basematerials id='7'><base name='x' displaycolor='#FF0000'/></basematerials><m:colorgroup id='8'><m:color color='#00F'/></m:colorgroup>{object}"),
            build,
        )),
        ("production without paths", model(
            "requiredextensions='p' xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'",
            &object.replace("<object ", "<object p:UUID='1-2' "),
            build,
        )),
        ("an extension that is not required", model("xmlns:b='urn:beams'", &object.replace("</mesh>", "<b:beamlattice><b:beams><b:beam v1='0' v2='1'/></b:beams></b:beamlattice></mesh>"), build)),
        ("properties of triangles", model("", &object.replace("v3=", "pid='7' p1='0' v3="), build)),
        ("ends of elements", model("", &object.replace("z='0'/>", "z='0'></vertex>"), build)),
        ("blanks and references", model("", &object.replace("'1'/>", " ' &#49;&#x09;' />").replace("x=' ' ", "x="), build).replace("' ' &#49;&#x09;'", "'&#49;&#x09;'")),
        ("other elements of other namespaces", model("", &object.replace("<triangles>", "<o:triangles xmlns:o='urn:o'><o:triangle v1='x'/></o:triangles><triangles xmlns:o='urn:o'><o:triangle/>"), build)),
        ("supports", model("", &format!("{object}<object id='2' type='support'>{MESH}</object>"), "<build><item objectid='2'/><item objectid='1'/></build>")),
        ("what is not built", model("", &format!("<object id='5'><mesh><vertices><vertex x='nan'/></vertices></mesh></object>{object}"), build)),
        ("a support as a component", model("", &format!("{}<object id='2' type='solidsupport'>{MESH}</object><object id='3' name='a'><components><component objectid='1'/><component objectid='2'/></components></object>", object.replace("name='a'", "")), "<build><item objectid='3'/></build>")),
        ("a part number for a name", model("", &object.replace("name=", "partnumber="), build)),
        ("fractions", model("", &object.replace("'0.1'", "'1/10'"), build)),
        ("exponents", model("", &object.replace("'0.1'", "' 1.0E-1 '"), build)),
    ];
    for (name, text) in rows {
        let read = read(&package(&text), None).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        assert_eq!(read.format, Format::ThreeMf, "{name}");
        assert_eq!(points(&read), TETRAHEDRON, "{name}\n{text}");
        assert_eq!(facets(&read), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], "{name}");
        assert_eq!(read.model.objects, [Object { name: "a".into(), first_facet: 0 }], "{name}");
        assert_eq!(read.model.unit, Some(Unit::Millimeter), "{name}");
    }
}

#[test]
fn the_model_is_found_in_the_archive() {
    let text = model("", &format!("<object id='1'>{MESH}</object>"), "");
    let relation = |target: &str| {
        format!(
            "<Relationships xmlns='{RELATIONSHIPS}'><Relationship Type='urn:other' Target='/x'/>\
             <Relationship Target='{target}' Id='a' Type='{TYPE}'/></Relationships>"
        )
    };
    type Row<'a> = (&'a str, Vec<(&'a str, String)>, &'a str);
    let rows: [Row<'_>; 6] = [
        ("no relationships", vec![("3D/3dmodel.model", text.clone())], "3D/3dmodel.model"),
        ("another case", vec![("3d/3DModel.Model", text.clone())], "3d/3DModel.Model"),
        ("absolute", vec![("_rels/.rels", relation("/a/b.model")), ("a/b.model", text.clone())], "a/b.model"),
        ("relative", vec![("_RELS/.RELS", relation("A/B.model")), ("a/b.model", text.clone())], "a/b.model"),
        (
            "not the usual one",
            vec![
                ("3D/3dmodel.model", "?".into()),
                ("_rels/.rels", relation("/b.model")),
                ("b.model", text.clone()),
            ],
            "b.model",
        ),
        (
            "no relationship to a model",
            vec![("_rels/.rels", relation("/b").replace(TYPE, "urn:x")), ("3D/3dmodel.model", text.clone())],
            "3D/3dmodel.model",
        ),
    ];
    for (name, files, part) in rows {
        let files: Vec<_> = files.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
        let read = read(&archive(&files), None).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(read.places.part.as_deref(), Some(part), "{name}");
        assert_eq!(points(&read), TETRAHEDRON, "{name}");
    }
}

#[test]
fn transforms_and_components_are_exact() {
    // An item of two components, one of which is turned and then mirrored; in inches.
    let resources = format!(
        "<object id='4' name='tip'>{MESH}</object>\n\
         <object id='2' name='both'><components><component objectid='4' transform='0 1 0 -1 0 0 0 0 1 0.5 0 0'/>\n\
         <component objectid='4'/></components></object>"
    );
    let build = "<build><item objectid='2' transform='-0.1 0 0 0 1 0 0 0 1 10 20 1/3'/>\n\
                 <item objectid='4' transform='1 0 0 0 1 0 0 0 1 0 0 0'/></build>";
    let read = read_model(&model("unit='inch'", &resources, build));
    assert_eq!(read.model.unit, Some(Unit::Inch));
    // (x, y, z) turned: (1/2 - y, x, z). Then: (10 - x/10, y + 20, z + 1/3).
    let turned = ["(199/20, 20, 1/3)", "(199/20, 21, 1/3)", "(201/20, 20, 1/3)", "(199/20, 20, 13/30)"];
    let moved = ["(10, 20, 1/3)", "(99/10, 20, 1/3)", "(10, 21, 1/3)", "(10, 20, 13/30)"];
    assert_eq!(points(&read), [turned, moved, TETRAHEDRON].concat());
    let mirrored = [[1, 2, 0], [3, 1, 0], [3, 2, 1], [3, 0, 2]];
    let plain = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let by = |cycles: [[u32; 3]; 4], base: u32| cycles.map(|cycle| cycle.map(|index| index + base));
    assert_eq!(facets(&read), [by(mirrored, 0), by(mirrored, 4), by(plain, 8)].concat());
    let object = |name: &str, first_facet| Object { name: name.into(), first_facet };
    assert_eq!(read.model.objects, [object("both", 0), object("tip", 8)]);
    // The places are those of the mesh, however often it is used.
    let first = read.places.vertices.get(0);
    assert!(matches!(first, Some(Place::Line(line)) if line > 1));
    assert_eq!(read.places.vertices.get(8), first);
    assert_eq!(read.places.facets.get(3), read.places.facets.get(11));
}

#[test]
fn without_a_build_all_that_is_no_component_is_taken() {
    let resources = format!(
        "<object id='9' name='part'>{MESH}</object><object id='2' name='whole'><components>\
         <component objectid='9'/></components></object><object id='3' name='alone'>{MESH}</object>"
    );
    let read = read_model(&model("", &resources, "<build></build>"));
    let names: Vec<_> = read.model.objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(names, ["whole", "alone"]);
}

#[test]
fn places_are_lines_of_the_part() {
    let text = "<?xml version='1.0'?>\r\n<model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>\r\
                <resources><object id='1'><mesh>\n<vertices><vertex x='0' y='0' z='0'/>\n\n<vertex\n x='1' y='0' z='0'/>\
                <vertex x='0' y='1' z='0'/></vertices>\n<triangles>\n<triangle v1='0' v2='1' v3='2'/></triangles>\
                </mesh></object></resources></model>";
    let read = read_model(text);
    let lines: Vec<_> = (0..3).filter_map(|vertex| read.places.vertices.get(vertex)).collect();
    assert_eq!(lines, [Place::Line(4), Place::Line(6), Place::Line(7)]);
    assert_eq!(read.places.facets.get(0), Some(Place::Line(9)));
    assert_eq!(read.places.part.as_deref(), Some("3D/3dmodel.model"));
}

/// Two objects with a vertex in common, and one without facets; a name that XML has to escape.
fn two_objects() -> Model {
    let mesh = b"OFF\n6 3 0\n0 0 0\n0.1 0 0\n0 1 0\n-1e-7 0 12345678901234567890\n9 9 9\n0 0 1\n\
                 3 0 1 2\n3 2 1 3\n3 5 1 0\n";
    let mut model = read(mesh, None).unwrap().model;
    let object = |name: &str, first_facet| Object { name: name.into(), first_facet };
    model.objects = vec![object("a <\"&'> \u{e9}\u{1}", 0), object("empty", 2), object("", 2)];
    model.unit = Some(Unit::Foot);
    model
}

#[test]
fn what_is_written_comes_back() {
    let model = two_objects();
    let options = WriteOptions::new(Format::ThreeMf);
    let written = write(&model, &options).unwrap();
    assert_eq!(written.largest_rounding.to_string(), "0");
    let notes = [WriteNote::NamesChanged(1), WriteNote::ObjectsDropped(1), WriteNote::UnusedVertices(1)];
    assert_eq!(written.notes, notes);
    assert_eq!(written.bytes, write(&model, &options).unwrap().bytes);
    let back = read(&written.bytes, None).unwrap();
    assert_eq!(back.model.unit, Some(Unit::Foot));
    let object = |name: &str, first_facet| Object { name: name.into(), first_facet };
    assert_eq!(back.model.objects, [object("a <\"&'> \u{e9}", 0), object("", 2)]);
    let points = points(&back);
    assert_eq!(points.len(), 7);
    assert_eq!(points[3], "(-1/10000000, 0, 12345678901234567890)");
    assert_eq!(facets(&back), [[0, 1, 2], [2, 1, 3], [6, 5, 4]]);
    // What was read is written the same, and read the same.
    let again = write(&back.model, &options).unwrap();
    let third = read(&again.bytes, None).unwrap();
    assert_eq!(third.model.objects, back.model.objects);
    assert_eq!((self::points(&third), facets(&third)), (points, facets(&back)));
    assert_eq!(again.bytes, write(&third.model, &options).unwrap().bytes);
}

#[test]
fn the_archive_is_as_the_standard_has_it() {
    let written = write(&two_objects(), &WriteOptions::new(Format::ThreeMf)).unwrap().bytes;
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(&written)).unwrap();
    let mut files = Vec::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).unwrap();
        let date = file.last_modified().unwrap();
        assert_eq!((date.year(), date.month(), date.day(), date.hour()), (1980, 1, 1, 0));
        let mut text = String::new();
        file.read_to_string(&mut text).unwrap();
        files.push((String::from_utf8(file.name_raw().to_vec()).unwrap(), text));
    }
    let names: Vec<_> = files.iter().map(|file| file.0.as_str()).collect();
    assert_eq!(names, ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]);
    let expected = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"foot\" xml:lang=\"en-US\" xmlns=\"{CORE}\">\n\
         <resources>\n<object id=\"1\" type=\"model\" name=\"a &lt;&quot;&amp;'&gt; \u{e9}\">\n<mesh>\n<vertices>\n\
         <vertex x=\"0\" y=\"0\" z=\"0\"/>\n<vertex x=\"0.1\" y=\"0\" z=\"0\"/>\n<vertex x=\"0\" y=\"1\" z=\"0\"/>\n\
         <vertex x=\"-0.0000001\" y=\"0\" z=\"12345678901234567890\"/>\n</vertices>\n<triangles>\n\
         <triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n<triangle v1=\"2\" v2=\"1\" v3=\"3\"/>\n</triangles>\n</mesh>\n\
         </object>\n<object id=\"2\" type=\"model\">\n<mesh>\n<vertices>\n<vertex x=\"0\" y=\"0\" z=\"0\"/>\n\
         <vertex x=\"0.1\" y=\"0\" z=\"0\"/>\n<vertex x=\"0\" y=\"0\" z=\"1\"/>\n</vertices>\n<triangles>\n\
         <triangle v1=\"2\" v2=\"1\" v3=\"0\"/>\n</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n\
         <item objectid=\"1\"/>\n<item objectid=\"2\"/>\n</build>\n</model>\n"
    );
    assert_eq!(files[2].1, expected);
}

#[test]
fn what_has_no_decimal_is_rounded_and_told() {
    let off = |text: &str| read(format!("OFF\n{text}").as_bytes(), None).unwrap().model;
    let third = off("3 1 0\n0 0 0\n1/3 0 0\n0 1 0\n3 0 1 2\n");
    let written = write(&third, &WriteOptions::new(Format::ThreeMf)).unwrap();
    assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
    let back = read(&written.bytes, None).unwrap();
    assert_eq!(points(&back)[1], "(3333333333333333/10000000000000000, 0, 0)");
    assert_eq!(back.model.unit, Some(Unit::Millimeter));
    let large = off("3 1 0\n0 0 0\n7e399 0 0\n0 1 0\n3 0 1 2\n");
    let error = write(&large, &WriteOptions::new(Format::ThreeMf)).unwrap_err();
    assert_eq!(error, WriteError::TooLargeForFloat { vertex: 1 });
    let square = off("4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    let written = write(&square, &WriteOptions::new(Format::ThreeMf)).unwrap();
    let notes = [WriteNote::Triangulated { from: 1, to: 2 }, WriteNote::UnitAssumed(Unit::Millimeter)];
    assert_eq!(written.notes, notes);
    assert_eq!(facets(&read(&written.bytes, None).unwrap()).len(), 2);
    let points = off("1 0 0\n0 0 0\n");
    let error = write(&points, &WriteOptions::new(Format::ThreeMf)).unwrap_err();
    assert_eq!(error, WriteError::NoFacets { format: Format::ThreeMf });
}

#[test]
fn gzip_may_be_around_it() {
    let model = two_objects();
    let written =
        write(&model, &WriteOptions::new(Encoding { format: Format::ThreeMf, gzip: true })).unwrap();
    let back = read(&written.bytes, None).unwrap();
    assert_eq!(back.format, Format::ThreeMf);
    assert_eq!(back.model.shape.mesh().map(Kind::of), Some(Kind::Surface));
}

/// The unpacked text of many small objects is long, but they are used once each.
#[test]
fn many_small_objects_are_read() {
    const OBJECTS: usize = 20_000;
    let object = |id: usize| {
        format!(
            "<object id='{id}' name='part {id}'><mesh><vertices><vertex x='{id}' y='0' z='0'/><vertex x='1' y='{id}' z='0'/>\
             <vertex x='0' y='1' z='{id}'/></vertices><triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh>\
             </object>"
        )
    };
    let resources: String = (1..=OBJECTS).map(object).collect();
    let items: String = (1..=OBJECTS).map(|id| format!("<item objectid='{id}'/>")).collect();
    let read = read_model(&model("", &resources, &format!("<build>{items}</build>")));
    assert_eq!((read.model.objects.len(), facets(&read).len()), (OBJECTS, OBJECTS));
}
