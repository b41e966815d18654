//! PLY, written as text or binary in either byte order.

use super::double::nearest_doubles;
use crate::base::model::Kind;
use crate::base::numerals::{Numerals, Rounding, put, put_point};
use crate::format::Format;
use crate::write::{Body, Task, WriteError, too_large};

/// The largest size of a facet for which lists are counted with a byte.
const SHORT: usize = u8::MAX as usize;

/// Writes a mesh as an element `vertex` and one of facets or, for segments, of edges.
///
/// Coordinates are doubles in the binary variants. The text has exact decimals where they end.
pub(crate) fn write(task: &Task<'_>, format: Format) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let kind = Kind::of(mesh);
    let short = mesh.facets.iter().all(|cycle| cycle.len() <= SHORT);
    let mut bytes = Vec::with_capacity(512 + 24 * mesh.points.len() + 5 * mesh.facets.corners().len());
    put_header(&mut bytes, task, format, kind, short);
    let mut rounding = Rounding::none();
    if format == Format::PlyAscii {
        let numerals = task.numerals(Numerals::Decimals);
        for (vertex, point) in mesh.points.iter().enumerate() {
            put_point(&mut bytes, point, numerals, &mut rounding).map_err(too_large(vertex))?;
            bytes.push(b'\n');
        }
        put_cycles_as_text(&mut bytes, task, kind);
        return Ok(Body::new(bytes, rounding));
    }
    let big_endian = format == Format::PlyBigEndian;
    for (vertex, point) in mesh.points.iter().enumerate() {
        let doubles = nearest_doubles(point, &mut rounding).map_err(too_large(vertex))?;
        for double in doubles {
            bytes.extend_from_slice(&if big_endian { double.to_be_bytes() } else { double.to_le_bytes() });
        }
    }
    let put_u32 = |bytes: &mut Vec<u8>, value: u32| {
        bytes.extend_from_slice(&if big_endian { value.to_be_bytes() } else { value.to_le_bytes() });
    };
    for cycle in mesh.facets.iter() {
        match (kind.has_polygons(), u8::try_from(cycle.len())) {
            (false, _) => {}
            (true, Ok(size)) if short => bytes.push(size),
            _ => put_u32(&mut bytes, cycle.len() as u32),
        }
        for &index in cycle {
            put_u32(&mut bytes, index);
        }
    }
    Ok(Body::new(bytes, rounding))
}

fn put_header(bytes: &mut Vec<u8>, task: &Task<'_>, format: Format, kind: Kind, short: bool) {
    let variant = match format {
        Format::PlyAscii => "ascii",
        Format::PlyBigEndian => "binary_big_endian",
        _ => "binary_little_endian",
    };
    let (points, facets) = (task.mesh.points.len(), task.mesh.facets.len());
    // Readers know `int` best; a larger index needs the sign bit.
    let index = if points <= i32::MAX as usize { "int" } else { "uint" };
    put(bytes, format_args!("ply\nformat {variant} 1.0\ncomment written by splitstar\n"));
    put(bytes, format_args!("element vertex {points}\n"));
    put(bytes, format_args!("property double x\nproperty double y\nproperty double z\n"));
    match kind {
        Kind::Points => {}
        Kind::Segments => {
            put(bytes, format_args!("element edge {facets}\n"));
            put(bytes, format_args!("property {index} vertex1\nproperty {index} vertex2\n"));
        }
        Kind::Polygon | Kind::Surface => {
            let count = if short { "uchar" } else { "uint" };
            put(bytes, format_args!("element face {facets}\n"));
            put(bytes, format_args!("property list {count} {index} vertex_indices\n"));
        }
    }
    put(bytes, format_args!("end_header\n"));
}

fn put_cycles_as_text(bytes: &mut Vec<u8>, task: &Task<'_>, kind: Kind) {
    for cycle in task.mesh.facets.iter() {
        let mut blank = "";
        if kind.has_polygons() {
            put(bytes, format_args!("{}", cycle.len()));
            blank = " ";
        }
        for index in cycle {
            put(bytes, format_args!("{blank}{index}"));
            blank = " ";
        }
        bytes.push(b'\n');
    }
}
