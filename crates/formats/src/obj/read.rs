//! The OBJ format, read with exact coordinates.

use super::corner::read_corner;
use super::statement::Statements;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::{Object, ReadModel, Shape};
use crate::base::number::point;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use crate::base::words::read_coordinate;
use crate::format::Format;

/// Reads an OBJ file.
///
/// - `v` gives a vertex: three coordinates. A weight and a colour behind them are ignored; the weight is one
///   for rational curves, not for meshes.
/// - `f` (and its old form `fo`) gives a facet, `l` a polyline, each pair of neighbours in it being a
///   segment, and `p` points. Vertices are counted from 1, or by negative numbers from the last one so far.
///   Lines and points have no place beside facets. Where there are only points, the vertices that `p` does
///   not name are left out.
/// - `o` begins an object; where there is no `o`, a group `g` does. An object without facets is left out.
/// - Normals, texture coordinates, materials and statements of other programs are ignored; free-form curves
///   and surfaces are refused.
///
/// A backslash at the end of a line continues the statement in the next line. `#` starts a comment anywhere
/// but within a word of a name.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let maker = MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines());
    let mut statements = Statements::new(bytes);
    let mut reader =
        Reader { maker, objects: Names::default(), groups: Names::default(), named: None, cycle: Vec::new() };
    let mut empty = true;
    while let Some(word) = statements.next() {
        empty = false;
        reader.statement(word, &mut statements)?;
        statements.finish();
    }
    if empty {
        return Err(Fault::Empty.into());
    }
    reader.finish()
}

struct Reader<'a, 'b> {
    maker: MeshMaker<'b>,
    objects: Names<'a>,
    groups: Names<'a>,
    named: Option<Named>,
    /// The facet that is being read.
    cycle: Vec<u32>,
}

/// The runs of facets that `o` or `g` names.
#[derive(Default)]
struct Names<'a> {
    list: Vec<Object>,
    /// The name that the next facet will be the first to have.
    next: Option<&'a [u8]>,
}

/// The vertices that `p` names.
struct Named {
    line: u32,
    vertices: Vec<bool>,
}

impl<'a> Reader<'a, '_> {
    fn statement(&mut self, word: Token<'a>, statements: &mut Statements<'a>) -> Result<(), Located> {
        match word.bytes {
            b"v" => self.vertex(word, statements),
            b"f" | b"fo" => self.facet(word, statements),
            b"l" => self.polyline(word, statements),
            b"p" => self.points(word, statements),
            b"o" => {
                self.objects.next = Some(statements.name());
                Ok(())
            }
            b"g" => {
                self.groups.next = Some(statements.name());
                Ok(())
            }
            b"vn" => statements.count_words(3, 3, "a normal of three numbers"),
            b"vt" => statements.count_words(1, 3, "a texture vertex of one to three numbers"),
            b"vp" => statements.count_words(1, 3, "a parameter point of one to three numbers"),
            b"curv" | b"curv2" | b"surf" | b"bzp" | b"bsp" | b"cdc" | b"cdp" => Err(unsupported(
                word.line,
                format!("free-form geometry (`{}`)", word.shown()),
                "turn it into polygons before export",
            )),
            b"call" => Err(unsupported(
                word.line,
                "a statement that takes in another file (`call`)".into(),
                "put the content of that file in its place",
            )),
            [first, ..] if first.is_ascii_alphabetic() => Ok(()),
            _ => Err(word.unexpected("a statement (`v`, `f`, `o` or another word)")),
        }
    }

    #[inline]
    fn vertex(&mut self, word: Token<'_>, statements: &mut Statements<'_>) -> Result<(), Located> {
        let mut next = || match statements.word() {
            Some(token) => read_coordinate(token),
            None => Err(statements.unexpected("a vertex of three coordinates (`v x y z`)")),
        };
        let coordinates = [next()?, next()?, next()?];
        // A weight, a colour, or both.
        let mut others = 0;
        while let Some(token) = statements.word() {
            others += 1;
            if others > 4 {
                return Err(token.unexpected("the end of a vertex of three to seven numbers"));
            }
            read_coordinate(token)?;
        }
        let place = Place::Line(word.line);
        self.maker.vertex(point(coordinates), place).at(place)?;
        Ok(())
    }

    #[inline]
    fn facet(&mut self, word: Token<'_>, statements: &mut Statements<'_>) -> Result<(), Located> {
        self.cycle.clear();
        while let Some(token) = statements.word() {
            self.cycle.push(read_corner(token, self.maker.vertex_count())?);
        }
        self.begin_run().at_line(word.line)?;
        self.maker.facet(&self.cycle, Place::Line(word.line), 1).at_line(word.line)
    }

    fn polyline(&mut self, word: Token<'_>, statements: &mut Statements<'_>) -> Result<(), Located> {
        let mut last = None;
        let mut size = 0;
        while let Some(token) = statements.word() {
            let vertex = read_corner(token, self.maker.vertex_count())?;
            if let Some(last) = last.replace(vertex) {
                self.begin_run().at_line(word.line)?;
                self.maker.facet(&[last, vertex], Place::Line(word.line), 1).at_line(word.line)?;
            }
            size = u32::min(size + 1, 2);
        }
        if size < 2 { Err(Fault::SmallFacet { size }).at_line(word.line) } else { Ok(()) }
    }

    fn points(&mut self, word: Token<'_>, statements: &mut Statements<'_>) -> Result<(), Located> {
        let vertices = self.maker.vertex_count();
        let named = self.named.get_or_insert_with(|| Named { line: word.line, vertices: Vec::new() });
        let more = (vertices as usize).saturating_sub(named.vertices.len());
        self.maker.budget().charge(2 * more as u64).at_line(word.line)?;
        named.vertices.resize(vertices as usize, false);
        while let Some(token) = statements.word() {
            named.vertices[read_corner(token, vertices)? as usize] = true;
        }
        Ok(())
    }

    /// The next facet belongs to what was named last.
    #[inline]
    fn begin_run(&mut self) -> Result<(), Fault> {
        for names in [&mut self.objects, &mut self.groups] {
            if let Some(name) = names.next.take() {
                // Invalid bytes become three each.
                self.maker.budget().charge(2 * size_of::<Object>() as u64 + 3 * name.len() as u64)?;
                let name = String::from_utf8_lossy(name).into_owned();
                names.list.push(Object { name, first_facet: self.maker.facet_count() });
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<ReadModel, Located> {
        let Self { maker, objects, groups, named, .. } = self;
        let beside = named.as_ref().filter(|_| maker.facet_count() > 0);
        if let Some(named) = beside {
            return Err(unsupported(
                named.line,
                "points beside facets or lines".into(),
                "remove them, or put them into a file of their own",
            ));
        }
        let mut read = maker.read_model(Format::Obj)?;
        if let Some(named) = named {
            keep_points(&mut read, &named.vertices)?;
        }
        let mut objects = if objects.list.is_empty() { groups.list } else { objects.list };
        // Facets that belong to none say the same.
        if objects.first().is_some_and(|object| object.name.is_empty()) {
            objects.remove(0);
        }
        read.model.objects = objects;
        Ok(read)
    }
}

/// Of a point set, leaves out the vertices that no `p` names.
fn keep_points(read: &mut ReadModel, named: &[bool]) -> Result<(), Located> {
    let Shape::Mesh(mesh) = &mut read.model.shape else { return Ok(()) };
    let is_named = |at: usize| named.get(at).copied().unwrap_or(false);
    let mut at = 0..;
    mesh.points.retain(|_| at.next().is_some_and(is_named));
    if let PlaceList::Lines(lines) = &mut read.places.vertices {
        let mut at = 0..;
        lines.retain(|_| at.next().is_some_and(is_named));
    }
    if mesh.points.is_empty() { Err(Fault::NoVertices.into()) } else { Ok(()) }
}

fn unsupported(line: u32, what: String, instead: &str) -> Located {
    Fault::Unsupported { what, instead: instead.into() }.at(Place::Line(line))
}
