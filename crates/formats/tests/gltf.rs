//! glTF: what is written, taken apart again.

// A test fails by panicking, in its helpers too; floats are compared as what they are.
#![allow(clippy::unwrap_used, clippy::float_cmp)]

use exact::{Point3, Rational};
use polytope::{Facets, PolygonMesh};
use serde_json::{Value, json};
use splitstar_formats::{
    Format, Model, Object, Unit, WriteError, WriteNote, WriteOptions, Written, read, write,
};

fn model(points: &[&str], facets: &[&[u32]]) -> Model {
    let point = |text: &&str| {
        let coordinates: Vec<_> = text.split(' ').map(|word| word.parse().unwrap()).collect();
        Point3::from_rationals(&coordinates.try_into().unwrap())
    };
    let mut list = Facets::new();
    facets.iter().for_each(|cycle| list.push(cycle));
    Model::of_mesh(PolygonMesh { points: points.iter().map(point).collect(), facets: list })
}

fn named(mut model: Model, objects: &[(&str, u32)]) -> Model {
    model.objects =
        objects.iter().map(|&(name, first_facet)| Object { name: name.into(), first_facet }).collect();
    model
}

fn write_glb(model: &Model) -> Written {
    write(model, &WriteOptions::new(Format::Glb)).unwrap()
}

fn u32_at(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
}

fn number(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

/// One mesh of a file.
#[derive(PartialEq, Debug)]
struct Run {
    name: Option<String>,
    mode: usize,
    positions: Vec<[f32; 3]>,
    indices: Option<Vec<usize>>,
}

fn run(name: &str, mode: usize, positions: &[[f32; 3]], indices: Option<&[usize]>) -> Run {
    let name = (!name.is_empty()).then(|| name.to_string());
    Run { name, mode, positions: positions.to_vec(), indices: indices.map(<[usize]>::to_vec) }
}

/// The two chunks of a file, with all lengths and paddings checked.
fn chunks(bytes: &[u8]) -> (Value, &[u8]) {
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!(u32_at(bytes, 4), 2);
    assert_eq!(u32_at(bytes, 8), bytes.len());
    let length = u32_at(bytes, 12);
    assert!(length.is_multiple_of(4) && bytes.len().is_multiple_of(4));
    assert_eq!(&bytes[16..20], b"JSON");
    let text = &bytes[20..20 + length];
    assert!(text.trim_ascii_end().len() + 4 > length);
    let json = serde_json::from_slice(text).unwrap();
    let rest = &bytes[20 + length..];
    if rest.is_empty() {
        return (json, rest);
    }
    assert_eq!(u32_at(rest, 0), rest.len() - 8);
    assert_eq!(&rest[4..8], b"BIN\0");
    (json, &rest[8..])
}

/// The meshes of a file, with everything checked that the specification demands of their parts.
fn taken_apart(bytes: &[u8]) -> Vec<Run> {
    let (json, binary) = chunks(bytes);
    assert_eq!(json["asset"], json!({ "generator": "splitstar", "version": "2.0" }));
    assert_eq!(json["buffers"], json!([{ "byteLength": binary.len() }]));
    assert_eq!(json["scene"], 0);
    let mut covered = 0;
    for view in json["bufferViews"].as_array().unwrap() {
        // One behind the other, aligned, without gaps.
        assert_eq!((number(&view["buffer"]), number(&view["byteOffset"])), (0, covered));
        assert!(covered.is_multiple_of(4));
        covered += number(&view["byteLength"]);
    }
    assert_eq!(covered, binary.len());
    let data = |accessor: &Value, component: usize, target: usize, kind: &str, size: usize| {
        assert_eq!(number(&accessor["componentType"]), component);
        assert_eq!(accessor["type"], kind);
        let view = &json["bufferViews"][number(&accessor["bufferView"])];
        assert_eq!(number(&view["target"]), target);
        assert_eq!(number(&view["byteLength"]), size * number(&accessor["count"]));
        let offset = number(&view["byteOffset"]);
        binary[offset..offset + number(&view["byteLength"])].chunks_exact(size).map(<[u8]>::to_vec)
    };
    let nodes = json["nodes"].as_array().unwrap();
    assert_eq!(json["scenes"], json!([{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }]));
    let with_mesh: Vec<_> = nodes.iter().filter(|node| node.get("mesh").is_some()).collect();
    let meshes = json["meshes"].as_array().unwrap();
    assert_eq!(with_mesh.len(), meshes.len());
    let mut runs = Vec::new();
    for (at, (node, mesh)) in with_mesh.iter().zip(meshes).enumerate() {
        assert_eq!((number(&node["mesh"]), node.get("name")), (at, mesh.get("name")));
        let primitives = mesh["primitives"].as_array().unwrap();
        assert_eq!(primitives.len(), 1);
        let attributes = primitives[0]["attributes"].as_object().unwrap();
        assert_eq!(attributes.len(), 1);
        let accessor = &json["accessors"][number(&attributes["POSITION"])];
        let positions: Vec<[f32; 3]> = data(accessor, 5126, 34962, "VEC3", 12)
            .map(|bytes| [0, 4, 8].map(|at| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())))
            .collect();
        for axis in 0..3 {
            let column = || positions.iter().map(|position| position[axis]);
            // The parser may be off by the last bit of a double, which a 32-bit float does not have.
            let bound = |name: &str| accessor[name][axis].as_f64().unwrap() as f32;
            assert_eq!(bound("min"), column().fold(f32::INFINITY, f32::min));
            assert_eq!(bound("max"), column().fold(f32::NEG_INFINITY, f32::max));
            assert_eq!(accessor["min"].as_array().unwrap().len(), 3);
            assert_eq!(accessor["max"].as_array().unwrap().len(), 3);
        }
        let indices = primitives[0].get("indices").map(|accessor| {
            let accessor = &json["accessors"][number(accessor)];
            let indices: Vec<usize> =
                data(accessor, 5125, 34963, "SCALAR", 4).map(|bytes| u32_at(&bytes, 0)).collect();
            assert!(indices.iter().all(|&index| index < positions.len()));
            indices
        });
        let name = mesh.get("name").map(|name| name.as_str().unwrap().to_string());
        runs.push(Run { name, mode: number(&primitives[0]["mode"]), positions, indices });
    }
    runs
}

const POINTS: &[&str] = &["0 0 0", "1 0 0", "0 1 0", "0 0 1", "7 7 7"];

#[test]
fn every_kind_of_mesh_has_its_mode() {
    let [o, x, y, z, far] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [7.0; 3]];
    let rows: [(&[&[u32]], Run); 4] = [
        (&[], run("", 0, &[o, x, y, z, far], None)),
        (&[&[3, 1], &[0, 3]], run("", 1, &[o, x, z], Some(&[2, 1, 0, 2]))),
        (&[&[4, 0, 2]], run("", 4, &[o, y, far], Some(&[2, 0, 1]))),
        (&[&[0, 1, 2], &[3, 1, 0]], run("", 4, &[o, x, y, z], Some(&[0, 1, 2, 3, 1, 0]))),
    ];
    for (facets, expected) in rows {
        let written = write_glb(&model(POINTS, facets));
        let positions = expected.positions.len();
        assert_eq!(taken_apart(&written.bytes), [expected]);
        assert!(written.largest_rounding.is_zero());
        let unused = if facets.is_empty() { 0 } else { POINTS.len() - positions };
        let notes = [WriteNote::UnusedVertices(unused)];
        assert_eq!(written.notes, &notes[..usize::from(unused > 0)]);
    }
}

#[test]
fn polygons_are_cut() {
    let square = model(&["0 0 0", "1 0 0", "1 1 0", "0 1 0"], &[&[0, 1, 2, 3], &[3, 2, 1, 0]]);
    let written = write_glb(&square);
    assert_eq!(written.notes, [WriteNote::Triangulated { from: 2, to: 4 }]);
    let runs = taken_apart(&written.bytes);
    assert_eq!(runs[0].positions.len(), 4);
    assert_eq!(runs[0].indices.as_ref().unwrap().len(), 12);
}

#[test]
fn objects_are_nodes_with_their_own_vertices() {
    let names = ["a \"quoted\" \\ name", "B\u{fc}chse \u{1f9e9}\n"];
    let facets: &[&[u32]] = &[&[4, 3, 1], &[0, 1, 2], &[1, 0, 3], &[3, 2, 0]];
    let objects = [(names[0], 1), ("empty", 3), (names[1], 3)];
    let written = write_glb(&named(model(POINTS, facets), &objects));
    let [o, x, y, z] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let expected = [
        run("", 4, &[x, z, [7.0; 3]], Some(&[2, 1, 0])),
        run(names[0], 4, &[o, x, y, z], Some(&[0, 1, 2, 1, 0, 3])),
        run(names[1], 4, &[o, y, z], Some(&[2, 1, 0])),
    ];
    assert_eq!(taken_apart(&written.bytes), expected);
    let (json, _) = chunks(&written.bytes);
    assert_eq!(json["nodes"][2], json!({ "name": "empty" }));

    let points = named(model(POINTS, &[]), &[("cloud", 0)]);
    assert_eq!(taken_apart(&write_glb(&points).bytes)[0].name.as_deref(), Some("cloud"));
}

#[test]
fn a_unit_scales_to_meters() {
    let facets: &[&[u32]] = &[&[0, 1, 2]];
    let points = ["0 0 0", "1000 0 0", "0 1/3 -5"];
    let rows: [(Option<Unit>, f32, f32, f32); 5] = [
        (None, 1000.0, 1.0 / 3.0, -5.0),
        (Some(Unit::Meter), 1000.0, 1.0 / 3.0, -5.0),
        (Some(Unit::Millimeter), 1.0, 1.0 / 3000.0, -0.005),
        (Some(Unit::Inch), 25.4, 0.0254 / 3.0, -0.127),
        (Some(Unit::Foot), 304.8, 0.1016, -1.524),
    ];
    for (unit, x, y, z) in rows {
        let mut model = model(&points, facets);
        model.unit = unit;
        let written = write_glb(&model);
        assert_eq!(written.notes, []);
        let runs = taken_apart(&written.bytes);
        assert_eq!(runs[0].positions, [[0.0; 3], [x, 0.0, 0.0], [0.0, y, z]], "{unit:?}");
        let text = String::from_utf8_lossy(&written.bytes).into_owned();
        assert!(text.contains(&format!("\"min\":[0.0,0.0,{:?}]", f64::from(z))), "{unit:?}: {text}");
        // The rounding is that of the numbers in the file.
        let meters = unit.map_or(Rational::ONE, Unit::meters);
        let mesh = model.shape.mesh().unwrap();
        let roundings = mesh.points.iter().zip(&runs[0].positions).flat_map(|(point, floats)| {
            let rounding = |axis: usize| {
                let written = Rational::try_from(f64::from(floats[axis])).unwrap();
                (written - point.coordinate(axis) * &meters).abs()
            };
            [0, 1, 2].map(rounding)
        });
        assert_eq!(written.largest_rounding, roundings.max().unwrap(), "{unit:?}");
    }
}

#[test]
fn rounding_is_that_of_written_vertices_only() {
    let facets: &[&[u32]] = &[&[0, 1, 2]];
    let exact = write_glb(&model(&["0 0 0", "1 0 0", "0 -0.5 0", "1/3 1e300 0"], facets));
    assert!(exact.largest_rounding.is_zero());
    let rounded = write_glb(&model(&["0 0 0", "16777217 0 0", "0 -1e-60 0"], facets));
    assert_eq!(rounded.largest_rounding, Rational::ONE);
    let runs = taken_apart(&rounded.bytes);
    assert_eq!(runs[0].positions[1][0], 16_777_216.0);
    // What rounds to zero has no sign.
    assert_eq!(runs[0].positions[2][1].to_bits(), 0);
    assert_eq!(chunks(&rounded.bytes).0["accessors"][0]["min"], json!([0.0, 0.0, 0.0]));
}

#[test]
fn too_large_and_empty_models() {
    let options = WriteOptions::new(Format::Glb);
    let far = model(&["0 0 0", "1 0 0", "0 1e39 0"], &[&[0, 1, 2]]);
    assert_eq!(write(&far, &options).unwrap_err(), WriteError::TooLargeForFloat { vertex: 2 });
    let mut near = far;
    near.unit = Some(Unit::Millimeter);
    assert!(write(&near, &options).is_ok());

    assert_eq!(write(&model(&[], &[]), &options).unwrap_err(), WriteError::NoVertices);
}

#[test]
fn the_bytes_are_the_same_each_time_and_only_written() {
    let model = named(model(POINTS, &[&[0, 1, 2]]), &[("a", 0)]);
    let bytes = write_glb(&model).bytes;
    assert_eq!(bytes, write_glb(&model).bytes);
    let text = "{\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"max\":[1.0,1.0,0.0],\
         \"min\":[0.0,0.0,0.0],\"type\":\"VEC3\"},{\"bufferView\":1,\"componentType\":5125,\"count\":3,\
         \"type\":\"SCALAR\"}],\"asset\":{\"generator\":\"splitstar\",\"version\":\"2.0\"},\
         \"bufferViews\":[{\"buffer\":0,\"byteLength\":36,\"byteOffset\":0,\"target\":34962},\
         {\"buffer\":0,\"byteLength\":12,\"byteOffset\":36,\"target\":34963}],\
         \"buffers\":[{\"byteLength\":48}],\"meshes\":[{\"name\":\"a\",\"primitives\":[{\"attributes\":\
         {\"POSITION\":0},\"indices\":1,\"mode\":4}]}],\"nodes\":[{\"mesh\":0,\"name\":\"a\"}],\"scene\":0,\
         \"scenes\":[{\"nodes\":[0]}]}";
    assert_eq!(std::str::from_utf8(&bytes[20..20 + text.len()]), Ok(text));
    let error = read(&bytes, None).unwrap_err().to_string();
    assert_eq!(error, "glTF cannot be read; it is written only; give OBJ, STL, PLY or 3MF");
}

/// Nodes, meshes, accessors and views of many objects refer to each other in order; names are escaped.
#[test]
fn many_objects_stand_one_after_the_other() {
    const OBJECTS: u32 = 3_000;
    let facets: Vec<[u32; 3]> =
        (0..OBJECTS).map(|object| [[0, 1, 2], [0, 1, 3]][object as usize % 2]).collect();
    let facets: Vec<&[u32]> = facets.iter().map(|cycle| cycle.as_slice()).collect();
    let mut model = model(POINTS, &facets);
    let name = |object: u32| format!("\"{object}\"\n\\");
    model.objects = (0..OBJECTS).map(|object| Object { name: name(object), first_facet: object }).collect();
    let runs = taken_apart(&write_glb(&model).bytes);
    assert_eq!(runs.len(), OBJECTS as usize);
    for (object, run) in runs.iter().enumerate() {
        assert_eq!(run.name, Some(name(object as u32)));
        assert_eq!(run.positions[2], if object % 2 == 0 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] });
        assert_eq!(run.indices, Some(vec![0, 1, 2]));
    }
}
