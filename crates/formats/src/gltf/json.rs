//! The JSON of a glTF file, written as a stream: many objects take no more than their text.
//!
//! Keys are in alphabetical order. The specification forbids empty lists and empty buffers: they are left out.

use serde_json::to_writer;
use std::io::{self, Write};

// The numbers of the specification for types and uses.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// What the vertices or indices of a mesh are; the numbers are those of the specification.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Mode {
    Points = 0,
    Lines = 1,
    Triangles = 4,
}

/// A node with its mesh. The numbers of the runs follow each other: of each its positions, and then its
/// indices if it has any.
pub(super) struct Run<'a> {
    name: &'a str,
    /// Without vertices there is no mesh.
    vertices: u32,
    indices: u32,
    min: [f32; 3],
    max: [f32; 3],
}

/// All that the text says.
pub(super) struct Scene<'a> {
    pub(super) mode: Mode,
    pub(super) runs: Vec<Run<'a>>,
    /// The bytes of all numbers.
    pub(super) binary: usize,
}

impl<'a> Run<'a> {
    pub(super) fn new(name: &'a str, positions: &[[f32; 3]], indices: u32) -> Self {
        let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for position in positions {
            for axis in 0..3 {
                min[axis] = min[axis].min(position[axis]);
                max[axis] = max[axis].max(position[axis]);
            }
        }
        Self { name, vertices: positions.len() as u32, indices, min, max }
    }
}

impl Scene<'_> {
    /// How many bytes the text has.
    pub(super) fn length(&self) -> usize {
        let mut counter = Counter(0);
        self.put_to(&mut counter).expect("counting does not fail");
        counter.0
    }

    /// Appends the text.
    pub(super) fn put(&self, bytes: &mut Vec<u8>) {
        self.put_to(bytes).expect("writing to memory does not fail");
    }

    fn put_to(&self, out: &mut impl Write) -> io::Result<()> {
        let meshes = || self.runs.iter().filter(|run| run.vertices > 0);
        out.write_all(b"{")?;
        if self.binary > 0 {
            out.write_all(b"\"accessors\":")?;
            let mut accessor = 0;
            put_list(out, meshes(), |out, run| put_accessors(out, run, &mut accessor))?;
            out.write_all(b",")?;
        }
        out.write_all(b"\"asset\":{\"generator\":\"splitstar\",\"version\":\"2.0\"}")?;
        if self.binary > 0 {
            out.write_all(b",\"bufferViews\":")?;
            let mut offset = 0;
            put_list(out, meshes(), |out, run| put_views(out, run, &mut offset))?;
            write!(out, ",\"buffers\":[{{\"byteLength\":{}}}],\"meshes\":", self.binary)?;
            let mut accessor = 0;
            put_list(out, meshes(), |out, run| put_mesh(out, run, self.mode, &mut accessor))?;
        }
        if !self.runs.is_empty() {
            out.write_all(b",\"nodes\":")?;
            let mut mesh = 0;
            put_list(out, self.runs.iter(), |out, run| put_node(out, run, &mut mesh))?;
        }
        out.write_all(b",\"scene\":0,\"scenes\":[{")?;
        if !self.runs.is_empty() {
            out.write_all(b"\"nodes\":")?;
            put_list(out, 0..self.runs.len(), |out, node| write!(out, "{node}"))?;
        }
        out.write_all(b"}]}")
    }
}

fn put_list<W: Write, T>(
    out: &mut W,
    items: impl Iterator<Item = T>,
    mut put: impl FnMut(&mut W, T) -> io::Result<()>,
) -> io::Result<()> {
    let mut before = b"[";
    for item in items {
        out.write_all(before)?;
        put(out, item)?;
        before = b",";
    }
    out.write_all(b"]")
}

/// The next number.
fn next(number: &mut usize) -> usize {
    *number += 1;
    *number - 1
}

/// The accessors of a run. Each has the view of its own number.
fn put_accessors(out: &mut impl Write, run: &Run<'_>, accessor: &mut usize) -> io::Result<()> {
    let (view, vertices) = (next(accessor), run.vertices);
    write!(out, "{{\"bufferView\":{view},\"componentType\":{FLOAT},\"count\":{vertices},\"max\":")?;
    to_writer(&mut *out, &run.max.map(f64::from))?;
    out.write_all(b",\"min\":")?;
    to_writer(&mut *out, &run.min.map(f64::from))?;
    out.write_all(b",\"type\":\"VEC3\"}")?;
    if run.indices > 0 {
        let (view, indices) = (next(accessor), run.indices);
        write!(
            out,
            ",{{\"bufferView\":{view},\"componentType\":{UNSIGNED_INT},\"count\":{indices},\"type\":\"SCALAR\"}}"
        )?;
    }
    Ok(())
}

fn put_views(out: &mut impl Write, run: &Run<'_>, offset: &mut usize) -> io::Result<()> {
    put_view(out, 12 * run.vertices as usize, ARRAY_BUFFER, offset)?;
    if run.indices > 0 {
        out.write_all(b",")?;
        put_view(out, 4 * run.indices as usize, ELEMENT_ARRAY_BUFFER, offset)?;
    }
    Ok(())
}

fn put_view(out: &mut impl Write, length: usize, target: u32, offset: &mut usize) -> io::Result<()> {
    write!(out, "{{\"buffer\":0,\"byteLength\":{length},\"byteOffset\":{offset},\"target\":{target}}}")?;
    *offset += length;
    Ok(())
}

/// A mesh of one primitive.
fn put_mesh(out: &mut impl Write, run: &Run<'_>, mode: Mode, accessor: &mut usize) -> io::Result<()> {
    out.write_all(b"{")?;
    if !run.name.is_empty() {
        out.write_all(b"\"name\":")?;
        to_writer(&mut *out, run.name)?;
        out.write_all(b",")?;
    }
    write!(out, "\"primitives\":[{{\"attributes\":{{\"POSITION\":{}}}", next(accessor))?;
    if run.indices > 0 {
        write!(out, ",\"indices\":{}", next(accessor))?;
    }
    write!(out, ",\"mode\":{}}}]}}", mode as u32)
}

fn put_node(out: &mut impl Write, run: &Run<'_>, mesh: &mut usize) -> io::Result<()> {
    out.write_all(b"{")?;
    let has_mesh = run.vertices > 0;
    if has_mesh {
        write!(out, "\"mesh\":{}", next(mesh))?;
    }
    if !run.name.is_empty() {
        out.write_all(if has_mesh { b",\"name\":" } else { b"\"name\":" })?;
        to_writer(&mut *out, run.name)?;
    }
    out.write_all(b"}")
}

/// Takes bytes and only counts them.
struct Counter(usize);

impl Write for Counter {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
