//! glTF 2, binary (`.glb`): written only.
//!
//! Every run of facets is a node with a mesh of its own. Positions are 32-bit floats; there are no normals,
//! so that the facets are shown flat. The unit of glTF is the meter: a model with a unit is scaled to it
//! exactly, before the coordinates are rounded; one without is written as it is. The axes are kept: what
//! shows the file takes y for up.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the numbers, run by run, and the file around them |
//! | `json` | the text that says where the numbers of each run stand |

mod json;

use crate::base::float::{is_collapsed, nearest_f32s};
use crate::base::model::{Kind, Unit};
use crate::base::numerals::Rounding;
use crate::format::Format;
use crate::write::{Body, Task, WriteError, too_large};
use exact::{Integer, Point3};
use json::{Mode, Run, Scene};
use std::borrow::Cow;

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
    let mut rounding = Rounding::none();
    let mut binary = Vec::new();
    let kind = Kind::of(mesh);
    if kind == Kind::Points {
        let name = task.objects.first().map_or("", |object| object.name.as_str());
        let all: Vec<u32> = (0..mesh.points.len() as u32).collect();
        let mut runs = Vec::new();
        if !all.is_empty() {
            let positions = add_positions(&mut binary, task, &all, &mut rounding)?;
            runs.push(Run::new(name, &positions, 0));
        }
        let scene = Scene { mode: Mode::Points, runs, binary: binary.len() };
        return Ok(Body::new(file(&scene, &binary)?, rounding));
    }
    let mut collapsed = 0;
    let mode = if kind == Kind::Segments { Mode::Lines } else { Mode::Triangles };
    let named = task.runs();
    let mut runs = Vec::with_capacity(named.len());
    // Where each vertex stands among those of its run; what other runs have left here is not looked at.
    let mut local = vec![0_u32; mesh.points.len()];
    for (name, run) in named {
        let corners: Vec<u32> = run.flat_map(|facet| mesh.facets.get(facet)).copied().collect();
        let mut used = corners.clone();
        used.sort_unstable();
        used.dedup();
        for (at, &vertex) in used.iter().enumerate() {
            local[vertex as usize] = at as u32;
        }
        let positions = add_positions(&mut binary, task, &used, &mut rounding)?;
        if mode == Mode::Triangles {
            let position = |vertex: u32| positions[local[vertex as usize] as usize];
            let triangles = corners.as_chunks::<3>().0;
            collapsed += triangles.iter().filter(|corners| is_collapsed(corners.map(position))).count();
        }
        check_length(binary.len() + 4 * corners.len())?;
        binary.extend(corners.iter().flat_map(|&vertex| local[vertex as usize].to_le_bytes()));
        runs.push(Run::new(name, &positions, corners.len() as u32));
    }
    let bytes = file(&Scene { mode, runs, binary: binary.len() }, &binary)?;
    Ok(Body { bytes, rounding, collapsed })
}

/// Appends the positions of some vertices, and gives them.
fn add_positions(
    binary: &mut Vec<u8>,
    task: &Task<'_>,
    vertices: &[u32],
    rounding: &mut Rounding,
) -> Result<Vec<[f32; 3]>, WriteError> {
    check_length(binary.len() + 12 * vertices.len())?;
    let mut positions = Vec::with_capacity(vertices.len());
    for &vertex in vertices {
        let vertex = vertex as usize;
        let point = in_meters(&task.mesh.points[vertex], task.unit);
        let floats = nearest_f32s(&point, rounding).map_err(too_large(vertex))?;
        binary.extend(floats.iter().flat_map(|float| float.to_le_bytes()));
        positions.push(floats);
    }
    Ok(positions)
}

/// The file: its header, a chunk of JSON and one of numbers, both of a length that 4 divides: that of the numbers
/// is, and the text is padded. Where there are no numbers there is no chunk of them.
fn file(scene: &Scene<'_>, binary: &[u8]) -> Result<Vec<u8>, WriteError> {
    let text = scene.length().next_multiple_of(4);
    let second = if binary.is_empty() { 0 } else { CHUNK_HEADER + binary.len() };
    let length = FILE_HEADER + CHUNK_HEADER + text + second;
    let mut bytes = Vec::new();
    let size = check_length(length)?;
    bytes.reserve_exact(length);
    bytes.extend_from_slice(b"glTF");
    bytes.extend_from_slice(&2_u32.to_le_bytes());
    bytes.extend_from_slice(&size.to_le_bytes());
    bytes.extend_from_slice(&check_length(text)?.to_le_bytes());
    bytes.extend_from_slice(b"JSON");
    scene.put(&mut bytes);
    bytes.resize(FILE_HEADER + CHUNK_HEADER + text, b' ');
    if !binary.is_empty() {
        bytes.extend_from_slice(&check_length(binary.len())?.to_le_bytes());
        bytes.extend_from_slice(b"BIN\0");
        bytes.extend_from_slice(binary);
    }
    Ok(bytes)
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
