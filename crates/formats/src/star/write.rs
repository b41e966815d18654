//! The star format, written: the same model gives the same bytes.

use super::line::put_name;
use crate::base::model::{Kind, Model, Object, Unit};
use crate::base::numerals::{Numerals, Rounding, put, put_point};
use crate::complex::{Complex, Position, distinct_segments};
use crate::write::{Body, Task, WriteError, WriteOptions, too_large};
use exact::Point3;

/// Writes a complex: unit, vertices, volumes, facets with their objects, edges. What the defaults say is left out, and
/// what is a mesh is written as one.
pub(crate) fn write_complex(
    complex: &Complex,
    model: &Model,
    options: &WriteOptions,
) -> Result<Body, WriteError> {
    complex.check().map_err(WriteError::Malformed)?;
    // What reads back as a mesh is written as one, so that it has one text.
    if let Ok(mesh) = complex.as_mesh() {
        let (objects, unit) = (&model.objects, model.unit);
        return write_mesh(&Task { mesh: &mesh, objects, unit, float: options.float });
    }
    let mut text = Text::new(model.unit, if options.float { Numerals::Floats } else { Numerals::Fractions });
    for (id, vertex) in complex.vertices.iter().enumerate() {
        match &vertex.position {
            Position::Point(point) => {
                put(&mut text.bytes, format_args!("vertex {id} "));
                text.point(point, id)?;
                text.mark(vertex.marked);
            }
            Position::Direction(direction) => {
                let [x, y, z] = direction.primitive().coordinates();
                put(&mut text.bytes, format_args!("direction {id} {x} {y} {z}\n"));
            }
        }
    }
    for (&volume, &marked) in &complex.volumes {
        let default = Complex::default_mark(volume);
        if volume > 1 || marked != default {
            put(&mut text.bytes, format_args!("volume {volume}"));
            if marked && !default {
                text.bytes.extend_from_slice(b" marked");
            }
            text.mark(marked || !default);
        }
    }
    let mut objects = model.objects.iter().peekable();
    for (index, facet) in complex.facets.iter().enumerate() {
        text.objects(&mut objects, index);
        text.bytes.extend_from_slice(b"facet");
        text.ids(&facet.outer);
        for hole in &facet.holes {
            text.bytes.extend_from_slice(b" hole");
            text.ids(hole);
        }
        text.through(facet.through.as_ref(), &facet.outer)?;
        if facet.sides != [0, 1] {
            put(&mut text.bytes, format_args!(" sides {} {}", facet.sides[0], facet.sides[1]));
        }
        text.mark(facet.marked);
    }
    if !complex.facets.is_empty() {
        text.objects(&mut objects, usize::MAX);
    }
    let are_sides = complex.are_sides();
    for (index, (edge, is_side)) in complex.edges.iter().zip(are_sides).enumerate() {
        if edge.marked && is_side {
            continue;
        }
        text.objects(&mut objects, index);
        text.bytes.extend_from_slice(b"edge");
        text.ids(&edge.ends);
        text.through(edge.through.as_ref(), &edge.ends)?;
        text.mark(edge.marked);
    }
    text.objects(&mut objects, usize::MAX);
    Ok(text.end())
}

/// Writes a mesh: points as vertices, segments as edges, one polygon as a facet with nothing behind it, other facets
/// as the surface of volume 1. Vertices without a facet would be points of the set, and are left out where there are
/// facets; the others are numbered without them. A segment that is there twice is written once.
pub(crate) fn write_mesh(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let kind = Kind::of(mesh);
    let mut used = vec![kind == Kind::Points; mesh.points.len()];
    mesh.facets.corners().iter().for_each(|&corner| used[corner as usize] = true);
    let mut ids = vec![0_u32; mesh.points.len()];
    for (id, vertex) in (0..).zip((0..used.len()).filter(|&vertex| used[vertex])) {
        ids[vertex] = id;
    }
    let mut text = Text::new(task.unit, task.numerals(Numerals::Fractions));
    text.bytes.reserve(24 * mesh.points.len() + 8 * mesh.facets.corners().len());
    for (vertex, point) in mesh.points.iter().enumerate().filter(|&(vertex, _)| used[vertex]) {
        put(&mut text.bytes, format_args!("vertex {} ", ids[vertex]));
        text.point(point, vertex)?;
        text.bytes.push(b'\n');
    }
    let mut objects = task.objects.iter().peekable();
    let segments = if kind == Kind::Segments { distinct_segments(&mesh.facets) } else { Vec::new() };
    for (index, cycle) in mesh.facets.iter().enumerate() {
        text.objects(&mut objects, index);
        if kind == Kind::Segments && segments.binary_search(&(index as u32)).is_err() {
            continue;
        }
        text.bytes.extend_from_slice(if cycle.len() == 2 { b"edge" } else { b"facet" });
        cycle.iter().for_each(|&vertex| put(&mut text.bytes, format_args!(" {}", ids[vertex as usize])));
        text.bytes.extend_from_slice(if kind == Kind::Polygon { b" sides 0 0\n" } else { b"\n" });
    }
    text.objects(&mut objects, usize::MAX);
    Ok(text.end())
}

struct Text {
    bytes: Vec<u8>,
    numerals: Numerals,
    rounding: Rounding,
}

impl Text {
    fn new(unit: Option<Unit>, numerals: Numerals) -> Self {
        let mut bytes = b"star 1 complex\n".to_vec();
        if let Some(unit) = unit {
            put(&mut bytes, format_args!("unit {unit}\n"));
        }
        Self { bytes, numerals, rounding: Rounding::none() }
    }

    fn point(&mut self, point: &Point3, vertex: usize) -> Result<(), WriteError> {
        put_point(&mut self.bytes, point, self.numerals, &mut self.rounding).map_err(too_large(vertex))
    }

    /// The error names the first of the directions, as the point has no number.
    fn through(&mut self, point: Option<&Point3>, vertices: &[u32]) -> Result<(), WriteError> {
        let Some(point) = point else { return Ok(()) };
        self.bytes.extend_from_slice(b" through ");
        self.point(point, vertices.first().map_or(0, |&vertex| vertex as usize))
    }

    fn ids(&mut self, ids: &[u32]) {
        ids.iter().for_each(|id| put(&mut self.bytes, format_args!(" {id}")));
    }

    /// Ends a record whose default is marked.
    fn mark(&mut self, marked: bool) {
        self.bytes.extend_from_slice(if marked { b"\n" } else { b" unmarked\n" });
    }

    /// The objects that begin before a facet, or an edge.
    fn objects<'a>(
        &mut self,
        objects: &mut std::iter::Peekable<impl Iterator<Item = &'a Object>>,
        before: usize,
    ) {
        while let Some(object) = objects.next_if(|object| object.first_facet as usize <= before) {
            self.bytes.extend_from_slice(b"object ");
            put_name(&mut self.bytes, &object.name);
            self.bytes.push(b'\n');
        }
    }

    fn end(mut self) -> Body {
        self.bytes.extend_from_slice(b"end\n");
        Body::new(self.bytes, self.rounding)
    }
}
