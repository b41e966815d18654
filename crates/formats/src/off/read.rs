//! The OFF format, read with exact coordinates.

use crate::base::budget::Budget;
use crate::base::error::{At, Count, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::ReadModel;
use crate::base::number::point;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Scanner;
use crate::base::words::{read_coordinate, read_count, read_index};
use crate::format::Format;

/// Reads an ASCII OFF file.
///
/// The file begins with `OFF`, or with `COFF`, `NOFF`, `STOFF` or a combination of these prefixes.
/// Then follow the numbers of vertices, facets and edges (the last is ignored), the vertices with
/// three coordinates each, and the facets: their number of vertices, and the vertices counted from 0.
/// Normals, colours and texture coordinates are ignored.
///
/// A record may be continued on the next line; what follows a complete record in its line is ignored.
/// `#` starts a comment anywhere.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let mut scanner = Scanner::new(bytes);
    let vertex_tokens = read_keyword(&mut scanner)?;
    let counts = read_counts(&mut scanner)?;
    let mut maker = MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines());
    read_vertices(&mut scanner, &counts, vertex_tokens, &mut maker)?;
    read_facets(&mut scanner, &counts, &mut maker)?;
    let read = maker.read_model(Format::Off)?;
    if let Some(token) = scanner.token() {
        let facets = counts.facets;
        let noun = if facets == 1 { "facet" } else { "facets" };
        let end = format!("the mesh, whose counts promise {facets} {noun}");
        return Err(Fault::AfterEnd { token: token.shown(), end }.at(Place::Line(token.line)));
    }
    Ok(read)
}

struct Counts {
    vertices: u32,
    facets: u32,
}

/// Reads the first word, and gives the number of tokens that a vertex has at least.
fn read_keyword(scanner: &mut Scanner<'_>) -> Result<usize, Located> {
    let token = scanner.token().ok_or(Fault::Empty)?;
    let unknown = || token.fault(|token| Fault::UnknownFormat { token });
    let prefix = token.bytes.strip_suffix(b"OFF").ok_or_else(unknown)?;
    let mut rest = prefix;
    let mut normals = false;
    let mut other_dimension = false;
    while !rest.is_empty() {
        rest = match rest {
            [b'S', b'T', tail @ ..] | [b'C', tail @ ..] => tail,
            [b'N', tail @ ..] => {
                normals = true;
                tail
            }
            [b'4' | b'n', tail @ ..] => {
                other_dimension = true;
                tail
            }
            _ => return Err(unknown()),
        };
    }
    let unsupported = |what: String| {
        let instead = "write the mesh as ASCII OFF with three coordinates a vertex".into();
        Err(Fault::Unsupported { what, instead }.at(Place::Line(token.line)))
    };
    if other_dimension {
        return unsupported(format!("{} (coordinates that are not three)", token.shown()));
    }
    let mut ahead = scanner.clone();
    if ahead.token_in_line().is_some_and(|next| next.bytes == b"BINARY") {
        return unsupported(format!("{} BINARY", token.shown()));
    }
    // A normal may stand on a line of its own. Colours vary in number and stand behind the rest.
    Ok(if normals { 6 } else { 3 })
}

fn read_counts(scanner: &mut Scanner<'_>) -> Result<Counts, Located> {
    let mut next = |of| match scanner.token() {
        Some(token) => Ok((read_count(token, of)?, token.line)),
        None => Err(truncated(scanner, "the numbers of vertices, facets and edges were expected".into())),
    };
    let (vertices, line) = next(Count::Vertices)?;
    let (facets, _) = next(Count::Facets)?;
    next(Count::Edges)?;
    // Catches the counts without edges, where the first coordinate was taken for a count.
    if let Some(token) = scanner.token_in_line() {
        let expected = "the end of the line with the three counts (of vertices, facets and edges)".into();
        return Err(token.fault(|found| Fault::Syntax { found, expected }));
    }
    if vertices == 0 {
        return Err(Fault::NoVertices.at(Place::Line(line)));
    }
    Ok(Counts { vertices, facets })
}

fn truncated(scanner: &Scanner<'_>, expected: String) -> Located {
    Fault::Truncated { expected }.at(Place::Line(scanner.last_line()))
}

fn read_vertices(
    scanner: &mut Scanner<'_>,
    counts: &Counts,
    tokens: usize,
    maker: &mut MeshMaker<'_>,
) -> Result<(), Located> {
    let promised = counts.vertices;
    for read in 0..promised {
        let mut next = || {
            scanner.token().ok_or_else(|| {
                truncated(scanner, format!("a vertex was expected, after {read} of {promised} vertices"))
            })
        };
        let first = next()?;
        let coordinates = [read_coordinate(first)?, read_coordinate(next()?)?, read_coordinate(next()?)?];
        for _ in 3..tokens {
            next()?;
        }
        let place = Place::Line(first.line);
        maker.vertex(point(coordinates), place).at(place)?;
        scanner.skip_line();
    }
    Ok(())
}

fn read_facets(scanner: &mut Scanner<'_>, counts: &Counts, maker: &mut MeshMaker<'_>) -> Result<(), Located> {
    let promised = counts.facets;
    let mut cycle = Vec::new();
    for read in 0..promised {
        let ends = |scanner: &Scanner<'_>| {
            truncated(scanner, format!("a facet was expected, after {read} of {promised} facets"))
        };
        let first = scanner.token().ok_or_else(|| ends(scanner))?;
        let place = Place::Line(first.line);
        let size = read_count(first, Count::Corners)?;
        if size < 2 {
            return Err(Fault::SmallFacet { size }.at(place));
        }
        cycle.clear();
        for _ in 0..size {
            let token = scanner.token().ok_or_else(|| ends(scanner))?;
            cycle.push(read_index(token, counts.vertices, 0)?);
        }
        maker.facet(&cycle, place, 0).at(place)?;
        scanner.skip_line();
    }
    Ok(())
}
