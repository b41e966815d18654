//! glTF 2, binary (`.glb`): written only.
//!
//! Every run of facets is a node with a mesh of its own. Positions are 32-bit floats; there are no normals,
//! so that the facets are shown flat. The unit of glTF is the meter: a model with a unit is scaled to it
//! exactly, before the coordinates are rounded; one without is written as it is. The axes are kept: what
//! shows the file takes y for up.

use crate::base::float::{is_collapsed, nearest_f32s};
use crate::base::model::{Kind, Unit};
use crate::base::numerals::Rounding;
use crate::format::Format;
use crate::write::{Body, Task, WriteError, too_large};
use exact::{Integer, Point3};
use serde_json::{Map, Value, json};
use std::borrow::Cow;

// The numbers of the specification for types, uses and modes.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const POINTS: u32 = 0;
const LINES: u32 = 1;
const TRIANGLES: u32 = 4;

/// Bytes of the header of the file, and of that of a chunk.
const FILE_HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// Writes triangles, segments or points. A run has the vertices that its facets use, in the order of the
/// mesh; an object without facets is a node without a mesh.
///
/// # Errors
/// A file of 4 GiB or more; a coordinate beyond the largest 32-bit float.
pub(crate) fn write(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let mut file = Assembly::default();
    let mut rounding = Rounding::none();
    let kind = Kind::of(mesh);
    if kind == Kind::Points {
        let name = task.objects.first().map_or("", |object| object.name.as_str());
        let all: Vec<u32> = (0..mesh.points.len() as u32).collect();
        if !all.is_empty() {
            let (positions, _) = file.add_positions(task, &all, &mut rounding)?;
            file.add_mesh(name, json!({ "attributes": { "POSITION": positions }, "mode": POINTS }));
        }
        return Ok(Body::new(file.into_bytes()?, rounding));
    }
    let mut collapsed = 0;
    let mode = if kind == Kind::Segments { LINES } else { TRIANGLES };
    // Where each vertex stands among those of its run; what other runs have left here is not looked at.
    let mut local = vec![0_u32; mesh.points.len()];
    for (name, run) in task.runs() {
        let corners: Vec<u32> = run.flat_map(|facet| mesh.facets.get(facet)).copied().collect();
        if corners.is_empty() {
            file.add_node(name, None);
            continue;
        }
        let mut used = corners.clone();
        used.sort_unstable();
        used.dedup();
        for (at, &vertex) in used.iter().enumerate() {
            local[vertex as usize] = at as u32;
        }
        let (positions, floats) = file.add_positions(task, &used, &mut rounding)?;
        if mode == TRIANGLES {
            let position = |vertex: u32| floats[local[vertex as usize] as usize];
            let triangles = corners.as_chunks::<3>().0;
            collapsed += triangles.iter().filter(|corners| is_collapsed(corners.map(position))).count();
        }
        let indices = file.add_indices(corners.iter().map(|&vertex| local[vertex as usize]))?;
        let attributes = json!({ "POSITION": positions });
        file.add_mesh(name, json!({ "attributes": attributes, "indices": indices, "mode": mode }));
    }
    Ok(Body { bytes: file.into_bytes()?, rounding, collapsed })
}

/// The parts of a file. Objects of JSON have their keys in alphabetical order, so that the bytes are the same
/// whether the library sorts them or keeps them.
#[derive(Default)]
struct Assembly {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

impl Assembly {
    /// Appends the positions of some vertices, and gives the index of their accessor, and them.
    fn add_positions(
        &mut self,
        task: &Task<'_>,
        vertices: &[u32],
        rounding: &mut Rounding,
    ) -> Result<(usize, Vec<[f32; 3]>), WriteError> {
        let mut positions = Vec::with_capacity(vertices.len());
        let view = self.add_view(12 * vertices.len(), ARRAY_BUFFER)?;
        let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for &vertex in vertices {
            let vertex = vertex as usize;
            let point = in_meters(&task.mesh.points[vertex], task.unit);
            let floats = nearest_f32s(&point, rounding).map_err(too_large(vertex))?;
            positions.push(floats);
            for axis in 0..3 {
                min[axis] = min[axis].min(floats[axis]);
                max[axis] = max[axis].max(floats[axis]);
                self.binary.extend_from_slice(&floats[axis].to_le_bytes());
            }
        }
        self.accessors.push(json!({
            "bufferView": view,
            "componentType": FLOAT,
            "count": vertices.len(),
            "max": max.map(f64::from),
            "min": min.map(f64::from),
            "type": "VEC3",
        }));
        Ok((self.accessors.len() - 1, positions))
    }

    /// Appends indices into the positions of a run, and gives the index of their accessor.
    fn add_indices(&mut self, indices: impl ExactSizeIterator<Item = u32>) -> Result<usize, WriteError> {
        let count = indices.len();
        let view = self.add_view(4 * count, ELEMENT_ARRAY_BUFFER)?;
        self.binary.extend(indices.flat_map(u32::to_le_bytes));
        self.accessors.push(json!({
            "bufferView": view,
            "componentType": UNSIGNED_INT,
            "count": count,
            "type": "SCALAR",
        }));
        Ok(self.accessors.len() - 1)
    }

    /// Announces so many bytes that will be appended. All lengths are multiples of 4, so that the
    /// offsets are, and the binary part needs no padding.
    fn add_view(&mut self, length: usize, target: u32) -> Result<usize, WriteError> {
        let offset = self.binary.len();
        check_length(offset + length)?;
        self.binary.reserve(length);
        self.views.push(json!({
            "buffer": 0,
            "byteLength": length,
            "byteOffset": offset,
            "target": target,
        }));
        Ok(self.views.len() - 1)
    }

    /// Appends a mesh of one primitive, and its node.
    fn add_mesh(&mut self, name: &str, primitive: Value) {
        let mut mesh = Map::new();
        if !name.is_empty() {
            mesh.insert("name".into(), name.into());
        }
        mesh.insert("primitives".into(), Value::Array(vec![primitive]));
        self.meshes.push(mesh.into());
        self.add_node(name, Some(self.meshes.len() - 1));
    }

    fn add_node(&mut self, name: &str, mesh: Option<usize>) {
        let mut node = Map::new();
        if let Some(mesh) = mesh {
            node.insert("mesh".into(), mesh.into());
        }
        if !name.is_empty() {
            node.insert("name".into(), name.into());
        }
        self.nodes.push(node.into());
    }

    /// The file: its header, a chunk of JSON and one of numbers, both of a length that 4 divides. The
    /// specification forbids empty lists and empty buffers: they are left out.
    fn into_bytes(self) -> Result<Vec<u8>, WriteError> {
        let Self { binary, views, accessors, meshes, nodes } = self;
        let buffers = if binary.is_empty() { vec![] } else { vec![json!({ "byteLength": binary.len() })] };
        let mut scene = Map::new();
        insert_list(&mut scene, "nodes", (0..nodes.len()).map(Value::from).collect());
        let mut root = Map::new();
        insert_list(&mut root, "accessors", accessors);
        root.insert("asset".into(), json!({ "generator": "splitstar", "version": "2.0" }));
        insert_list(&mut root, "bufferViews", views);
        insert_list(&mut root, "buffers", buffers);
        insert_list(&mut root, "meshes", meshes);
        insert_list(&mut root, "nodes", nodes);
        root.insert("scene".into(), 0.into());
        insert_list(&mut root, "scenes", vec![scene.into()]);
        let mut text = serde_json::to_vec(&root).expect("strings and finite numbers are JSON");
        text.resize(text.len().next_multiple_of(4), b' ');

        let chunks: &[(&[u8; 4], &[u8])] = &[(b"JSON", &text), (b"BIN\0", &binary)];
        let chunks = if binary.is_empty() { &chunks[..1] } else { chunks };
        let length = FILE_HEADER + chunks.iter().map(|(_, data)| CHUNK_HEADER + data.len()).sum::<usize>();
        let mut bytes = Vec::with_capacity(length);
        bytes.extend_from_slice(b"glTF");
        bytes.extend_from_slice(&2_u32.to_le_bytes());
        bytes.extend_from_slice(&check_length(length)?.to_le_bytes());
        for (kind, data) in chunks {
            bytes.extend_from_slice(&check_length(data.len())?.to_le_bytes());
            bytes.extend_from_slice(*kind);
            bytes.extend_from_slice(data);
        }
        Ok(bytes)
    }
}

fn insert_list(object: &mut Map<String, Value>, name: &str, list: Vec<Value>) {
    if !list.is_empty() {
        object.insert(name.into(), list.into());
    }
}

/// The point in the unit of glTF.
fn in_meters(point: &Point3, unit: Option<Unit>) -> Cow<'_, Point3> {
    let Some(unit) = unit.filter(|unit| *unit != Unit::Meter) else { return Cow::Borrowed(point) };
    let factor = unit.meters();
    let (numerator, denominator) = (factor.numerator(), factor.denominator());
    let [x, y, z, weight] = point.homogeneous();
    let scaled = [x, y, z].map(|coordinate: Integer| coordinate * &numerator);
    Cow::Owned(Point3::new(scaled, weight * &denominator).expect("the weight is positive"))
}

/// The lengths of the file and of its parts are 32-bit numbers.
fn check_length(length: usize) -> Result<u32, WriteError> {
    u32::try_from(length).map_err(|_| WriteError::TooMany { format: Format::Glb })
}
