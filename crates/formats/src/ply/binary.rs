//! The body of a binary PLY file.

use super::header::{Element, Header, Role, Step};
use super::scalar::Scalar;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, NumberFault};
use crate::base::maker::MeshMaker;
use crate::base::model::ReadModel;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use crate::format::Format;
use exact::Point3;

/// Reads the elements behind a header.
pub(super) fn read(bytes: &[u8], header: &Header<'_>, budget: &mut Budget) -> Result<ReadModel, Located> {
    let mut cursor = Cursor { bytes, at: header.body, big_endian: header.format == Format::PlyBigEndian };
    let is_vertices = |element: &Element<'_>| element.role == Role::Vertices;
    let vertices = header.elements.iter().position(is_vertices).expect("the header has vertices");
    for element in &header.elements[..vertices] {
        cursor.skip(element)?;
    }
    let first = cursor.at as u64;
    let places = header.elements[vertices].size().map(|size| PlaceList::stride(first, size));
    let mut maker = MeshMaker::new(budget, places.unwrap_or_else(PlaceList::bytes), PlaceList::bytes());
    cursor.read_vertices(&header.elements[vertices], &mut maker)?;
    for element in &header.elements[vertices + 1..] {
        match element.role {
            Role::Facets => cursor.read_facets(element, &mut maker)?,
            Role::Segments => cursor.read_segments(element, &mut maker)?,
            Role::Vertices | Role::Other => cursor.skip(element)?,
        }
    }
    let read = maker.read_model(header.format)?;
    let rest = cursor.rest();
    if !rest.is_empty() {
        let token = Token { bytes: rest, line: 0 }.shown();
        let end = "the last element that the header promises".into();
        return Err(Fault::AfterEnd { token, end }.at(Place::Byte(cursor.at as u64)));
    }
    Ok(read)
}

struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    big_endian: bool,
}

/// Where the parts of a record stand that are kept.
struct Record {
    fields: [(usize, Scalar); 3],
    corners: Corners,
}

/// A list of vertices of a facet.
#[derive(Clone, Copy)]
struct Corners {
    at: usize,
    size: usize,
    item: Scalar,
}

impl<'a> Cursor<'a> {
    fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Steps over so many bytes, and gives where they begin; `None` if there are not so many.
    #[inline]
    fn step(&mut self, bytes: u64) -> Option<usize> {
        let start = self.at;
        if bytes > (self.bytes.len() - start) as u64 {
            return None;
        }
        self.at += bytes as usize;
        Some(start)
    }

    #[inline]
    fn integer(&self, at: usize, scalar: Scalar) -> i64 {
        scalar.integer(&self.bytes[at..at + scalar.size()], self.big_endian)
    }

    #[cold]
    fn truncated(&self, element: &Element<'_>, read: u64) -> Located {
        element.truncated(read).at(Place::Byte(self.bytes.len() as u64))
    }

    /// Refuses at once what records of one size cannot be behind here.
    fn check_size(&self, element: &Element<'_>) -> Result<(), Located> {
        let Some(size) = element.size() else { return Ok(()) };
        match (self.rest().len() as u64).checked_div(size) {
            Some(records) if records < u64::from(element.count) => Err(self.truncated(element, records)),
            _ => Ok(()),
        }
    }

    /// Steps over an element.
    fn skip(&mut self, element: &Element<'_>) -> Result<(), Located> {
        self.check_size(element)?;
        match element.size() {
            Some(size) => self.at += (size * u64::from(element.count)) as usize,
            None => {
                for read in 0..element.count {
                    self.record(element, read)?;
                }
            }
        }
        Ok(())
    }

    /// Steps over a record, of which there were so many before.
    #[inline]
    fn record(&mut self, element: &Element<'_>, read: u32) -> Result<Record, Located> {
        let mut record = Record {
            fields: [(0, Scalar::Uchar); 3],
            corners: Corners { at: 0, size: 0, item: Scalar::Uchar },
        };
        for step in &element.steps {
            let whole = match *step {
                Step::Skip { bytes, .. } => self.step(bytes).is_some(),
                Step::Keep { slot, scalar } => {
                    self.step(scalar.size() as u64).map(|at| record.fields[slot] = (at, scalar)).is_some()
                }
                Step::List { corners, count, item } => match self.list(element, count, item)? {
                    Some(list) if corners => {
                        record.corners = list;
                        true
                    }
                    list => list.is_some(),
                },
            };
            if !whole {
                return Err(self.truncated(element, u64::from(read)));
            }
        }
        Ok(record)
    }

    /// Steps over a list; `None` if the file ends before it does.
    #[inline]
    fn list(
        &mut self,
        element: &Element<'_>,
        count: Scalar,
        item: Scalar,
    ) -> Result<Option<Corners>, Located> {
        let Some(at) = self.step(count.size() as u64) else { return Ok(None) };
        let size = self.integer(at, count);
        let Ok(length) = u64::try_from(size) else {
            let fault = Fault::BadCount { token: size.to_string(), of: element.counted() };
            return Err(fault.at(Place::Byte(at as u64)));
        };
        let start = self.step(length * item.size() as u64);
        Ok(start.map(|at| Corners { at, size: length as usize, item }))
    }

    fn read_vertices(&mut self, element: &Element<'_>, maker: &mut MeshMaker<'_>) -> Result<(), Located> {
        self.check_size(element)?;
        for read in 0..element.count {
            let place = Place::Byte(self.at as u64);
            let record = self.record(element, read)?;
            let floats = record
                .fields
                .map(|(at, scalar)| scalar.float(&self.bytes[at..at + scalar.size()], self.big_endian));
            let Some(point) = Point3::from_f64s(floats) else {
                return Err(not_finite(&record, floats));
            };
            maker.vertex(point, place).at(place)?;
        }
        Ok(())
    }

    fn read_facets(&mut self, element: &Element<'_>, maker: &mut MeshMaker<'_>) -> Result<(), Located> {
        self.check_size(element)?;
        let vertices = maker.vertex_count();
        let mut cycle = Vec::new();
        for read in 0..element.count {
            let place = Place::Byte(self.at as u64);
            let Corners { at, size, item } = self.record(element, read)?.corners;
            cycle.clear();
            for corner in 0..size {
                cycle.push(self.index(at + corner * item.size(), item, vertices)?);
            }
            maker.facet(&cycle, place, 0).at(place)?;
        }
        Ok(())
    }

    fn read_segments(&mut self, element: &Element<'_>, maker: &mut MeshMaker<'_>) -> Result<(), Located> {
        self.check_size(element)?;
        let vertices = maker.vertex_count();
        for read in 0..element.count {
            let place = Place::Byte(self.at as u64);
            let [source, target, _] = self.record(element, read)?.fields;
            let [source, target] = [source, target].map(|(at, scalar)| self.index(at, scalar, vertices));
            maker.facet(&[source?, target?], place, 0).at(place)?;
        }
        Ok(())
    }

    #[inline]
    fn index(&self, at: usize, scalar: Scalar, vertices: u32) -> Result<u32, Located> {
        let index = self.integer(at, scalar);
        match u32::try_from(index) {
            Ok(index) if index < vertices => Ok(index),
            _ => {
                let fault = Fault::IndexOutOfRange { index: index.to_string(), vertices, first: 0 };
                Err(fault.at(Place::Byte(at as u64)))
            }
        }
    }
}

/// Some coordinate is infinite, or not a number.
#[cold]
fn not_finite(record: &Record, floats: [f64; 3]) -> Located {
    let axis = floats.iter().position(|float| !float.is_finite()).expect("one is not finite");
    let fault = Fault::BadNumber { token: floats[axis].to_string(), fault: NumberFault::NotFinite };
    fault.at(Place::Byte(record.fields[axis].0 as u64))
}
