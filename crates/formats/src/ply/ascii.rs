//! The body of a PLY file that is a text.

use super::header::{Element, Header, Role, Step};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::ReadModel;
use crate::base::number::point;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::{Scanner, Token};
use crate::base::words::{read_coordinate, read_count, read_index};

/// Reads the elements behind a header.
pub(super) fn read(bytes: &[u8], header: &Header<'_>, budget: &mut Budget) -> Result<ReadModel, Located> {
    let scanner = Scanner::starting_at(bytes, header.body, header.body_line);
    let mut body = Body { scanner, cycle: Vec::new() };
    let mut maker = MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines());
    for element in &header.elements {
        body.read_element(element, &mut maker)?;
    }
    let read = maker.read_model(header.format)?;
    if let Some(token) = body.scanner.token() {
        let end = "the last element that the header promises".into();
        return Err(token.fault(|token| Fault::AfterEnd { token, end }));
    }
    Ok(read)
}

struct Body<'a> {
    scanner: Scanner<'a>,
    /// The vertices of the facet that was read last.
    cycle: Vec<u32>,
}

/// The words of a record that are kept, and where it begins.
struct Record<'a> {
    fields: [Token<'a>; 3],
    place: Place,
}

impl<'a> Body<'a> {
    fn read_element(&mut self, element: &Element<'_>, maker: &mut MeshMaker<'_>) -> Result<(), Located> {
        for read in 0..element.count {
            let vertices = maker.vertex_count();
            let Record { fields: [x, y, z], place } = self.record(element, read, vertices)?;
            match element.role {
                Role::Vertices => {
                    let coordinates = [read_coordinate(x)?, read_coordinate(y)?, read_coordinate(z)?];
                    maker.vertex(point(coordinates), place).at(place)?;
                }
                Role::Facets => maker.facet(&self.cycle, place, 0).at(place)?,
                Role::Segments => {
                    let cycle = [read_index(x, vertices, 0)?, read_index(y, vertices, 0)?];
                    maker.facet(&cycle, place, 0).at(place)?;
                }
                Role::Other => {}
            }
        }
        Ok(())
    }

    /// Reads a record, of which there were so many before.
    #[inline]
    fn record(&mut self, element: &Element<'_>, read: u32, vertices: u32) -> Result<Record<'a>, Located> {
        let mut fields = [Token { bytes: b"", line: 0 }; 3];
        let mut first_line = None;
        let scanner = &mut self.scanner;
        let mut next = || {
            let token = scanner
                .token()
                .ok_or_else(|| element.truncated(u64::from(read)).at(Place::Line(scanner.last_line())))?;
            first_line.get_or_insert(token.line);
            Ok::<_, Located>(token)
        };
        for step in &element.steps {
            match *step {
                Step::Skip { words, .. } => {
                    for _ in 0..words {
                        next()?;
                    }
                }
                Step::Keep { slot, .. } => fields[slot] = next()?,
                Step::List { corners, .. } => {
                    let size = read_count(next()?, element.counted())?;
                    let corners = corners && element.role == Role::Facets;
                    if corners {
                        self.cycle.clear();
                    }
                    for _ in 0..size {
                        let word = next()?;
                        if corners {
                            self.cycle.push(read_index(word, vertices, 0)?);
                        }
                    }
                }
            }
        }
        let line = first_line.expect("an element with records has properties");
        if let Some(token) = self.scanner.token_in_line() {
            return Err(token.unexpected(&format!("the end of the line, after {},", element.record())));
        }
        Ok(Record { fields, place: Place::Line(line) })
    }
}
