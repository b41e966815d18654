//! STL, written with 32-bit floats or as text.

use crate::base::float::{is_collapsed, nearest_f32s};
use crate::base::numerals::{Numerals, Rounding, put, put_point};
use crate::format::Format;
use crate::write::{Body, Task, WriteError, too_large};
use polytope::PolygonMesh;

/// What stands at the begin of the header; `solid` would be taken for a text.
const TITLE: &[u8] = b"binary STL by splitstar";
const HEADER: usize = 80;

/// Writes binary STL: each coordinate is rounded to the nearest 32-bit float.
pub(crate) fn write_binary(task: &Task<'_>) -> Result<Body, WriteError> {
    let (mesh, format) = (task.mesh, Format::Stl);
    let count = u32::try_from(mesh.facets.len()).map_err(|_| WriteError::TooMany { format })?;
    let mut rounding = Rounding::none();
    let mut positions = Vec::with_capacity(mesh.points.len());
    for (vertex, used) in used_vertices(mesh).into_iter().enumerate() {
        positions.push(if used {
            nearest_f32s(&mesh.points[vertex], &mut rounding).map_err(too_large(vertex))?
        } else {
            [0.0; 3]
        });
    }
    let mut collapsed = 0;
    let mut bytes = Vec::with_capacity(84 + 50 * mesh.facets.len());
    bytes.extend_from_slice(TITLE);
    bytes.resize(HEADER, 0);
    bytes.extend_from_slice(&count.to_le_bytes());
    for cycle in mesh.facets.iter() {
        let corners = triangle(cycle, Format::Stl)?.map(|vertex| positions[vertex as usize]);
        collapsed += usize::from(is_collapsed(corners));
        let normal = approx_normal(corners.map(|corner| corner.map(f64::from)));
        for vector in [normal, corners[0], corners[1], corners[2]] {
            for float in vector {
                bytes.extend_from_slice(&float.to_le_bytes());
            }
        }
        bytes.extend_from_slice(&[0, 0]);
    }
    Ok(Body { bytes, rounding, collapsed })
}

/// Writes STL as text: one solid, with the name of the object if there is one only. Coordinates are decimals; the normals are short ones, and only tell
/// which way a facet looks.
pub(crate) fn write_ascii(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let mut rounding = Rounding::none();
    let numerals = task.numerals(Numerals::Decimals);
    // A vertex is written once for each facet around it.
    let mut texts = Vec::with_capacity(24 * mesh.points.len());
    let mut ends = Vec::with_capacity(mesh.points.len());
    let mut positions = Vec::with_capacity(mesh.points.len());
    for (vertex, used) in used_vertices(mesh).into_iter().enumerate() {
        if used {
            let point = &mesh.points[vertex];
            put_point(&mut texts, point, numerals, &mut rounding).map_err(too_large(vertex))?;
            positions.push(point.approx_f64());
        } else {
            positions.push([0.0; 3]);
        }
        ends.push(texts.len());
    }
    let text_of = |vertex: usize| {
        let start = if vertex == 0 { 0 } else { ends[vertex - 1] };
        &texts[start..ends[vertex]]
    };
    let mut bytes = Vec::with_capacity(240 * mesh.facets.len() + 64);
    let name = name_in_line(if let [object] = task.objects { &object.name } else { "" });
    let blank = if name.is_empty() { "" } else { " " };
    put(&mut bytes, format_args!("solid{blank}{name}\n"));
    for cycle in mesh.facets.iter() {
        let corners = triangle(cycle, Format::StlAscii)?.map(|vertex| vertex as usize);
        bytes.extend_from_slice(b"facet normal");
        for component in approx_normal(corners.map(|vertex| positions[vertex])) {
            put_short(&mut bytes, component);
        }
        bytes.extend_from_slice(b"\n  outer loop\n");
        for vertex in corners {
            bytes.extend_from_slice(b"    vertex ");
            bytes.extend_from_slice(text_of(vertex));
            bytes.push(b'\n');
        }
        bytes.extend_from_slice(b"  endloop\nendfacet\n");
    }
    put(&mut bytes, format_args!("endsolid{blank}{name}\n"));
    Ok(Body::new(bytes, rounding))
}

/// Vertices without a facet cannot be written, and what they would lose does not count.
fn used_vertices(mesh: &PolygonMesh) -> Vec<bool> {
    let mut used = vec![false; mesh.points.len()];
    for &corner in mesh.facets.corners() {
        used[corner as usize] = true;
    }
    used
}

/// The corners of a facet. Larger ones have been cut; a segment beside triangles is no facet.
fn triangle(cycle: &[u32], format: Format) -> Result<[u32; 3], WriteError> {
    cycle.try_into().map_err(|_| WriteError::NoFacets { format })
}

/// A name that ends with its line: a blank for each control character, and none at the ends.
fn name_in_line(name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    name.trim_ascii().to_string()
}

/// Whether the name of a solid comes back as it is.
pub(crate) fn takes_name(name: &str) -> bool {
    name_in_line(name) == name
}

fn put_short(text: &mut Vec<u8>, component: f32) {
    if component == 0.0 || component.abs() >= 1e-4 {
        put(text, format_args!(" {component}"));
    } else {
        put(text, format_args!(" {component:e}"));
    }
}

/// About the unit normal of a triangle; zero if there is none, or if the floats do not tell.
fn approx_normal([a, b, c]: [[f64; 3]; 3]) -> [f32; 3] {
    // Scaled so that no product is too large or too small.
    let direction = |to: [f64; 3]| {
        let difference = [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let largest = difference.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        difference.map(|value| value / largest)
    };
    let (u, v) = (direction(b), direction(c));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]).sqrt();
    if length > 0.0 && length.is_finite() {
        normal.map(|value| (value / length) as f32 + 0.0)
    } else {
        [0.0; 3]
    }
}
