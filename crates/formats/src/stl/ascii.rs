//! STL as text, read exactly.

use super::weld::Welder;
use super::{add_facet, note_dropped};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::{Object, ReadModel};
use crate::base::number::point;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::{Scanner, Token};
use crate::base::words::read_coordinate;
use crate::format::Format;
use exact::{Point3, PointKey};
use std::collections::HashMap;

/// Reads STL as text: solids, each with a name that runs to the end of its line and may be missing, of facets with a
/// normal and three vertices.
///
/// Each solid is an object, unless the file has one without a name. Keywords may be in any case, and line breaks
/// anywhere but in the lines of `solid` and `endsolid`. Vertices at the same position are one, in the order of their
/// first mention.
pub(super) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let welder = Welder::new(0, budget)?;
    let maker = MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines());
    let mut reader = Reader {
        bytes,
        scanner: Scanner::new(bytes),
        maker,
        texts: HashMap::new(),
        welder,
        wide: HashMap::new(),
        objects: Vec::new(),
        dropped: 0,
    };
    let mut token = reader.next("`solid`")?;
    loop {
        if !is(token, b"solid") {
            return Err(token.unexpected("`solid`, or the end of the file,"));
        }
        reader.solid(token)?;
        match reader.scanner.token() {
            Some(next) => token = next,
            None => break,
        }
    }
    let Reader { mut maker, objects, dropped, .. } = reader;
    note_dropped(&mut maker, dropped);
    let mut read = maker.read_model(Format::StlAscii)?;
    if objects.len() > 1 || objects.iter().any(|object| !object.name.is_empty()) {
        read.model.objects = objects;
    }
    Ok(read)
}

fn is(token: Token<'_>, keyword: &[u8]) -> bool {
    token.bytes.eq_ignore_ascii_case(keyword)
}

/// What an entry of the table of texts takes: a growing table has up to 16 places for 7 entries, and the one before it.
const TEXT: u64 = 4 * size_of::<(&[u8], u32)>() as u64;

struct Reader<'a, 'b> {
    bytes: &'a [u8],
    scanner: Scanner<'a>,
    maker: MeshMaker<'b>,
    /// The vertices by what is written for them.
    texts: HashMap<&'a [u8], u32>,
    /// The vertices that are narrow points.
    welder: Welder<[i64; 4]>,
    /// The others.
    wide: HashMap<PointKey, u32>,
    objects: Vec<Object>,
    dropped: usize,
}

impl<'a> Reader<'a, '_> {
    fn next(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        self.scanner.token().ok_or_else(|| {
            let expected = format!("{expected} was expected");
            Fault::Truncated { expected }.at(Place::Line(self.scanner.last_line()))
        })
    }

    fn keyword(&mut self, keyword: &[u8], expected: &str) -> Result<Token<'a>, Located> {
        let token = self.next(expected)?;
        if is(token, keyword) { Ok(token) } else { Err(token.unexpected(expected)) }
    }

    /// Reads a solid, behind its first word.
    fn solid(&mut self, solid: Token<'a>) -> Result<(), Located> {
        let rest = &self.bytes[self.bytes.len() - self.scanner.remaining()..];
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let name = rest[..end].trim_ascii();
        // Up to three bytes for each that is not UTF-8.
        let charge = 2 * size_of::<Object>() as u64 + 3 * name.len() as u64;
        self.maker.budget().charge(charge).at_line(solid.line)?;
        let name = String::from_utf8_lossy(name).into_owned();
        self.objects.push(Object { name, first_facet: self.maker.facet_count() });
        self.scanner.skip_line();
        loop {
            let expected = "`facet` or `endsolid`";
            let token = self.next(expected)?;
            if is(token, b"endsolid") {
                self.scanner.skip_line();
                return Ok(());
            }
            if !is(token, b"facet") {
                return Err(token.unexpected(expected));
            }
            self.facet(token)?;
        }
    }

    /// Reads a facet, behind its first word.
    fn facet(&mut self, facet: Token<'a>) -> Result<(), Located> {
        self.keyword(b"normal", "`normal`")?;
        for _ in 0..3 {
            let expected = "a normal of three numbers";
            let number = self.next(expected)?;
            // Its value means nothing here, and is often wrong.
            if is(number, b"outer") {
                return Err(number.unexpected(expected));
            }
        }
        self.keyword(b"outer", "`outer loop`")?;
        self.keyword(b"loop", "`outer loop`")?;
        let mut cycle = [0; 3];
        let names = ["the first `vertex`", "the second `vertex`", "the third `vertex`"];
        for (index, name) in cycle.iter_mut().zip(names) {
            let vertex = self.keyword(b"vertex", name)?;
            *index = self.vertex(vertex.line)?;
        }
        self.keyword(b"endloop", "`endloop` behind three vertices")?;
        self.keyword(b"endfacet", "`endfacet`")?;
        if !add_facet(&mut self.maker, cycle, Place::Line(facet.line)).at_line(facet.line)? {
            self.dropped += 1;
        }
        Ok(())
    }

    /// Reads a position, and gives the index of its vertex.
    fn vertex(&mut self, line: u32) -> Result<u32, Located> {
        let expected = "a coordinate";
        let first = self.next(expected)?;
        let start = self.bytes.len() - self.scanner.remaining() - first.bytes.len();
        let tokens = [first, self.next(expected)?, self.next(expected)?];
        let text = &self.bytes[start..self.bytes.len() - self.scanner.remaining()];
        // Each vertex is mentioned by each facet around it, mostly in the same words.
        if let Some(&index) = self.texts.get(text) {
            return Ok(index);
        }
        let [x, y, z] = tokens;
        let point = point([read_coordinate(x)?, read_coordinate(y)?, read_coordinate(z)?]);
        self.maker.budget().charge(TEXT).at_line(line)?;
        let index = self.vertex_at(point, line)?;
        self.texts.insert(text, index);
        Ok(index)
    }

    fn vertex_at(&mut self, point: Point3, line: u32) -> Result<u32, Located> {
        // The coordinates are over their least common denominator: the point is canonical.
        let Some(&key) = point.as_narrow() else { return self.wide_vertex_at(point, line) };
        match self.welder.find(&key) {
            Ok(index) => Ok(index),
            Err(free) => {
                let index = self.maker.vertex(point, Place::Line(line)).at_line(line)?;
                self.welder.enter(free, key, index, self.maker.budget()).at_line(line)?;
                Ok(index)
            }
        }
    }

    fn wide_vertex_at(&mut self, point: Point3, line: u32) -> Result<u32, Located> {
        let key = point.canonical_key();
        if let Some(&index) = self.wide.get(&key) {
            return Ok(index);
        }
        let bytes = 256 + u64::from(point.bits()) / 2;
        self.maker.budget().charge(bytes).at_line(line)?;
        let index = self.maker.vertex(point, Place::Line(line)).at_line(line)?;
        self.wide.insert(key, index);
        Ok(index)
    }
}
