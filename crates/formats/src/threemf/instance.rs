//! The meshes of all that is built, each as often as it is used.

use super::element::Element;
use super::outline::{Content, MeshPlace, Outline, Reference};
use super::transform::{self, Map};
use super::xml::Xml;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::{Object, ReadModel};
use crate::base::number::point;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use crate::base::words::{read_coordinate, read_index};
use crate::format::Format;
use std::ops::Range;

/// For the first use of an object: what it takes. There are as many as objects in the text, which is charged.
const FIRST_USE: u64 = 32;
/// For each further use: far more than it takes, so that few uses have a chance to take long.
const USE: u64 = 1024;
/// For each byte of a mesh that is read once more, in fourths: what it takes is time.
const AGAIN: u64 = 4;

/// Reads all that is built.
pub(super) fn read(text: &str, outline: &Outline, budget: &mut Budget) -> Result<ReadModel, Located> {
    budget.charge(2 * outline.objects.len() as u64)?;
    let mut builder = Builder {
        text,
        outline,
        maker: MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines()),
        objects: Vec::new(),
        was_used: vec![false; outline.objects.len()],
        is_open: vec![false; outline.objects.len()],
        open: Vec::new(),
    };
    for item in &outline.items {
        builder.item(item)?;
    }
    let Builder { maker, mut objects, .. } = builder;
    let mut read = maker.read_model(Format::ThreeMf)?;
    // Facets that belong to none say the same.
    if objects.first().is_some_and(|object| object.name.is_empty()) {
        objects.remove(0);
    }
    read.model.objects = objects;
    read.model.unit = Some(outline.unit);
    Ok(read)
}

struct Builder<'t, 'b> {
    text: &'t str,
    outline: &'t Outline,
    maker: MeshMaker<'b>,
    objects: Vec<Object>,
    /// The objects that have been used before.
    was_used: Vec<bool>,
    /// The objects whose components are being put together.
    is_open: Vec<bool>,
    open: Vec<Open>,
}

/// An object whose components are being put together.
struct Open {
    object: usize,
    /// The components that are left.
    rest: Range<usize>,
    map: Map,
}

impl Builder<'_, '_> {
    fn item(&mut self, item: &Reference) -> Result<(), Located> {
        let outline = self.outline;
        let vertices = self.maker.vertex_count();
        let first_facet = self.maker.facet_count();
        self.put(item.object, item.map.clone(), item.line)?;
        // Not by recursion: components may be nested as deep as the file is long.
        while let Some(open) = self.open.last_mut() {
            let Some(next) = open.rest.next() else {
                self.is_open[open.object] = false;
                self.open.pop();
                continue;
            };
            let component = &outline.components[next];
            let map = transform::compose(&component.map, &open.map, component.line)?;
            self.put(component.object, map, component.line)?;
        }
        if self.maker.vertex_count() > vertices {
            let name = &outline.objects[item.object].name;
            let bytes = 2 * size_of::<Object>() as u64 + name.len() as u64;
            self.maker.budget().charge(bytes).at_line(item.line)?;
            self.objects.push(Object { name: name.clone(), first_facet });
        }
        Ok(())
    }

    /// Reads the mesh of an object, or opens its components.
    fn put(&mut self, object: usize, map: Map, line: u32) -> Result<(), Located> {
        let outline = self.outline;
        let was_used = std::mem::replace(&mut self.was_used[object], true);
        let bytes = if was_used { USE } else { FIRST_USE } + map.as_ref().map_or(0, |map| map.bytes_of_use());
        self.maker.budget().charge(bytes).at_line(line)?;
        let used = &outline.objects[object];
        if used.is_support {
            return Ok(());
        }
        match &used.content {
            Content::Mesh(place) => {
                if was_used {
                    let length = place.bytes.len() as u64;
                    self.maker.budget().charge(length / AGAIN).at_line(line)?;
                }
                self.mesh(place, &map)
            }
            Content::Components(range) => {
                if self.is_open[object] {
                    let token = Token { bytes: b"component", line };
                    return Err(token.unexpected("an object that is no component of itself"));
                }
                self.is_open[object] = true;
                self.open.push(Open { object, rest: range.clone(), map });
                Ok(())
            }
            Content::Nothing => Err(Token { bytes: b"<object>", line: used.line }
                .unexpected("an object with a mesh or components")),
        }
    }

    fn mesh(&mut self, place: &MeshPlace, map: &Map) -> Result<(), Located> {
        let mut xml = Xml::at_element(self.text, place.bytes.start, place.line, &place.prefixes)?;
        let mesh = xml.root("mesh")?;
        let base = self.maker.vertex_count();
        if !mesh.has_content() {
            return Ok(());
        }
        while let Some(list) = xml.child()? {
            let (vertices, triangles) = (list.is("vertices"), list.is("triangles"));
            if !(vertices || triangles) || !list.has_content() {
                xml.skip(&list)?;
                continue;
            }
            while let Some(element) = xml.child()? {
                if vertices && element.is("vertex") {
                    self.vertex(&element, map)?;
                } else if triangles && element.is("triangle") {
                    self.triangle(&element, map, base)?;
                }
                xml.skip(&element)?;
            }
        }
        Ok(())
    }

    fn vertex(&mut self, element: &Element<'_>, map: &Map) -> Result<(), Located> {
        let [x, y, z] = element.required(["x", "y", "z"])?;
        let coordinates =
            [read_coordinate(x.token())?, read_coordinate(y.token())?, read_coordinate(z.token())?];
        let mut vertex = point(coordinates);
        if let Some(map) = map {
            self.maker.budget().charge(map.bytes_of_vertex()).at_line(element.line)?;
            vertex = map.map().apply(&vertex);
        }
        self.maker.vertex(vertex, Place::Line(element.line)).at_line(element.line)?;
        Ok(())
    }

    /// A facet; its indices count the vertices of its own mesh, which begin at `base`.
    fn triangle(&mut self, element: &Element<'_>, map: &Map, base: u32) -> Result<(), Located> {
        let values = element.required(["v1", "v2", "v3"])?;
        let vertices = self.maker.vertex_count() - base;
        let mut cycle = [0; 3];
        for (index, value) in cycle.iter_mut().zip(&values) {
            *index = read_index(value.token(), vertices, 0)?;
        }
        let [a, b, c] = cycle;
        if a == b || b == c || c == a {
            // Told here, where the number is still that of the file.
            let vertex = if b == c { b } else { a };
            return Err(Fault::RepeatedVertex { vertex, in_a_row: true }.at(Place::Line(element.line)));
        }
        let mirrors = map.as_ref().is_some_and(|map| map.mirrors());
        let cycle = if mirrors { [c, b, a] } else { [a, b, c] };
        let place = Place::Line(element.line);
        self.maker.facet(&cycle.map(|index| base + index), place, 0).at(place)
    }
}
