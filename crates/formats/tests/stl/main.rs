//! STL, binary and as text: tables of files with the meshes or the errors that they must give, and the way back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]
// Floats are read and written exactly.
#![allow(clippy::float_cmp)]

mod bad;
mod changed;
mod good;
mod writing;

use splitstar_formats::ReadModel;

type Corners = [[f32; 3]; 3];

fn binary_with(header: &[u8], count: u32, triangles: &[Corners]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for corners in triangles {
        // The normal means nothing, and the attribute neither.
        bytes.extend([0xFF; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|float| float.to_le_bytes()));
        bytes.extend([0x1F, 0x80]);
    }
    bytes
}

fn binary(triangles: &[Corners]) -> Vec<u8> {
    binary_with(b"made by a test\0", triangles.len() as u32, triangles)
}

const A: [f32; 3] = [0.0, 0.0, 0.0];
const B: [f32; 3] = [1.5, 0.0, 0.0];
const C: [f32; 3] = [0.0, 0.1, 0.0];
const D: [f32; 3] = [0.0, 0.0, -1e30];
const TETRAHEDRON: [Corners; 4] = [[A, C, B], [A, B, D], [B, C, D], [C, A, D]];
const TETRAHEDRON_FACETS: [[u32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [2, 1, 3], [1, 0, 3]];

fn shown(read: &ReadModel) -> (Vec<String>, Vec<&[u32]>) {
    let mesh = read.model.shape.mesh().unwrap();
    let points = mesh.points.iter().map(|p| p.coordinates().map(|c| c.to_string()).join(" ")).collect();
    (points, mesh.facets.iter().collect())
}

fn objects(read: &ReadModel) -> Vec<(&str, u32)> {
    read.model.objects.iter().map(|object| (object.name.as_str(), object.first_facet)).collect()
}

/// The floats of a facet: its normal, and its corners.
fn floats(bytes: &[u8], facet: usize) -> Vec<f32> {
    let record = &bytes[84 + 50 * facet..][..48];
    record.chunks(4).map(|chunk| f32::from_le_bytes(chunk.try_into().unwrap())).collect()
}
