//! The OFF format, read with exact coordinates.

use crate::error::{Count, ReadError, Record};
use crate::number::{parse_number, point};
use crate::scan::{Scanner, Token};
use polytope::{Facets, PolygonMesh};

/// A mesh with the lines of its file, so that a later message about a vertex or a facet can name them.
#[derive(Clone, Debug)]
pub struct ReadMesh {
    /// The points and polygons.
    pub mesh: PolygonMesh,
    /// The line on which each vertex begins, counted from 1.
    pub vertex_lines: Vec<u32>,
    /// The line on which each facet begins, counted from 1.
    pub facet_lines: Vec<u32>,
}

/// What the facets of a file make of its points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Kind {
    /// No facet: a point set, which stands for its hull.
    Points,
    /// All facets have two vertices: segments, normally one.
    Segments,
    /// One polygon: a polytope of dimension 2, if it is convex.
    Polygon,
    /// More than one polygon.
    Surface,
}

impl ReadMesh {
    /// What the facets make of the points.
    pub fn kind(&self) -> Kind {
        let facets = &self.mesh.facets;
        match facets.len() {
            0 => Kind::Points,
            // The reader refuses segments beside polygons: the first facet speaks for all.
            _ if facets.get(0).len() == 2 => Kind::Segments,
            1 => Kind::Polygon,
            _ => Kind::Surface,
        }
    }
}

/// Reads an ASCII OFF file.
///
/// The file begins with `OFF`, or with `COFF`, `NOFF`, `STOFF` or a combination of these prefixes.
/// Then follow the numbers of vertices, facets and edges (the last is ignored), the vertices with
/// three coordinates each, and the facets: their number of vertices, and the vertices counted from 0.
/// A coordinate is an integer, a decimal with or without exponent, or a fraction `p/q`; the point has
/// exactly the value that is written. Normals, colours and texture coordinates are ignored.
///
/// A record may be continued on the next line; what follows a complete record in its line is ignored.
/// `#` starts a comment anywhere.
///
/// A facet has three vertices or more, all different. If all facets have two vertices, the file is a
/// set of segments ([`ReadMesh::kind`]). Nothing else about the mesh is checked here.
///
/// # Errors
/// The first thing wrong with the file. Nothing is allocated by what a file promises: memory is
/// bounded by a constant times its length.
///
/// # Complexity
/// Linear in the length of the file, as long as coordinates have few digits.
///
/// ```
/// let read = splitstar_formats::read_off(b"OFF 1 0 0\n0.1 1e2 -1/3\n")?;
/// let coordinates = read.mesh.points[0].coordinates().map(|c| c.to_string());
/// assert_eq!(coordinates, ["1/10", "100", "-1/3"]);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_off(bytes: &[u8]) -> Result<ReadMesh, ReadError> {
    let mut scanner = Scanner::new(bytes);
    let vertex_tokens = read_keyword(&mut scanner)?;
    let counts = read_counts(&mut scanner)?;
    let (points, vertex_lines) = read_vertices(&mut scanner, &counts, vertex_tokens)?;
    let (facets, facet_lines) = read_facets(&mut scanner, &counts)?;
    refuse_lonely_segment(&facets, &facet_lines)?;
    if let Some(token) = scanner.token() {
        return Err(ReadError::AfterEnd { line: token.line, token: token.shown(), facets: counts.facets });
    }
    Ok(ReadMesh { mesh: PolygonMesh { points, facets }, vertex_lines, facet_lines })
}

struct Counts {
    vertices: u32,
    facets: u32,
}

/// Reads the first word, and gives the number of tokens that a vertex has at least.
fn read_keyword(scanner: &mut Scanner<'_>) -> Result<usize, ReadError> {
    let token = scanner.token().ok_or(ReadError::Empty)?;
    let unknown = || ReadError::UnknownFormat { line: token.line, token: token.shown() };
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
    let unsupported = |format: String| Err(ReadError::Unsupported { line: token.line, format });
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

fn read_counts(scanner: &mut Scanner<'_>) -> Result<Counts, ReadError> {
    let mut next = |of| match scanner.token() {
        Some(token) => Ok((read_count(token, of)?, token.line)),
        None => Err(ReadError::Truncated { line: scanner.last_line(), expected: Record::Counts }),
    };
    let (vertices, line) = next(Count::Vertices)?;
    let (facets, _) = next(Count::Facets)?;
    next(Count::Edges)?;
    // Catches the counts without edges, where the first coordinate was taken for a count.
    if let Some(token) = scanner.token_in_line() {
        return Err(ReadError::AfterCounts { line: token.line, token: token.shown() });
    }
    if vertices == 0 {
        return Err(ReadError::NoVertices { line });
    }
    Ok(Counts { vertices, facets })
}

fn read_count(token: Token<'_>, of: Count) -> Result<u32, ReadError> {
    let line = token.line;
    if !token.bytes.iter().all(u8::is_ascii_digit) {
        return Err(ReadError::BadCount { line, token: token.shown(), of });
    }
    match parse_u32(token.bytes) {
        Some(count) if count < u32::MAX => Ok(count),
        _ => Err(ReadError::CountTooLarge { line, token: token.shown(), of }),
    }
}

fn read_vertices(
    scanner: &mut Scanner<'_>,
    counts: &Counts,
    tokens: usize,
) -> Result<(Vec<exact::Point3>, Vec<u32>), ReadError> {
    // The shortest vertex is `0 0 0` and a line break.
    let room = (counts.vertices as usize).min(scanner.remaining() / 6 + 1);
    let mut points = Vec::with_capacity(room);
    let mut lines = Vec::with_capacity(room);
    for read in 0..counts.vertices {
        let mut next = || {
            scanner.token().ok_or_else(|| ReadError::Truncated {
                line: scanner.last_line(),
                expected: Record::Vertex { read, promised: counts.vertices },
            })
        };
        let first = next()?;
        let coordinates = [read_coordinate(first)?, read_coordinate(next()?)?, read_coordinate(next()?)?];
        for _ in 3..tokens {
            next()?;
        }
        points.push(point(coordinates));
        lines.push(first.line);
        scanner.skip_line();
    }
    Ok((points, lines))
}

fn read_coordinate(token: Token<'_>) -> Result<crate::number::Number, ReadError> {
    parse_number(token.bytes).map_err(|fault| ReadError::BadNumber {
        line: token.line,
        token: token.shown(),
        fault,
    })
}

fn read_facets(scanner: &mut Scanner<'_>, counts: &Counts) -> Result<(Facets, Vec<u32>), ReadError> {
    // The shortest facet is `2 0 1` and a line break.
    let room = (counts.facets as usize).min(scanner.remaining() / 6 + 1);
    let mut facets = Facets::with_capacity(room, (scanner.remaining() / 2).min(4 * room));
    let mut lines = Vec::with_capacity(room);
    let mut cycle = Vec::new();
    // For each vertex the last facet that has it, counted from 1, and its place in that facet.
    let mut seen = vec![(0_u32, 0_u32); counts.vertices as usize];
    for read in 0..counts.facets {
        let truncated = |scanner: &Scanner<'_>| ReadError::Truncated {
            line: scanner.last_line(),
            expected: Record::Facet { read, promised: counts.facets },
        };
        let first = scanner.token().ok_or_else(|| truncated(scanner))?;
        let size = read_count(first, Count::Corners)?;
        if size < 2 {
            return Err(ReadError::SmallFacet { line: first.line, size });
        }
        cycle.clear();
        for place in 0..size {
            let token = scanner.token().ok_or_else(|| truncated(scanner))?;
            let vertex = read_index(token, counts.vertices)?;
            let (facet, before) = seen[vertex as usize];
            if facet == read + 1 {
                let in_a_row = place - before == 1 || place - before == size - 1;
                return Err(ReadError::RepeatedVertex { line: token.line, vertex, in_a_row });
            }
            seen[vertex as usize] = (read + 1, place);
            cycle.push(vertex);
        }
        if facets.corners().len() + cycle.len() > u32::MAX as usize {
            return Err(ReadError::CountTooLarge {
                line: first.line,
                token: first.shown(),
                of: Count::Corners,
            });
        }
        facets.push(&cycle);
        lines.push(first.line);
        scanner.skip_line();
    }
    Ok((facets, lines))
}

#[inline]
fn read_index(token: Token<'_>, vertices: u32) -> Result<u32, ReadError> {
    if let Some(index) = parse_u32(token.bytes).filter(|&index| index < vertices) {
        return Ok(index);
    }
    let line = token.line;
    let digits = token.bytes.strip_prefix(b"-").unwrap_or(token.bytes);
    Err(if !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) {
        ReadError::IndexOutOfRange { line, index: token.shown(), vertices }
    } else {
        ReadError::BadIndex { line, token: token.shown() }
    })
}

/// A facet of two vertices is a segment, and has no place beside polygons.
fn refuse_lonely_segment(facets: &Facets, lines: &[u32]) -> Result<(), ReadError> {
    if facets.iter().all(|cycle| cycle.len() == 2) {
        return Ok(());
    }
    match facets.iter().position(|cycle| cycle.len() == 2) {
        Some(facet) => Err(ReadError::SegmentBesidePolygons { line: lines[facet] }),
        None => Ok(()),
    }
}

/// Decimal digits only; `None` if there is something else, or if the value does not fit.
#[inline]
fn parse_u32(digits: &[u8]) -> Option<u32> {
    if digits.is_empty() {
        return None;
    }
    digits.iter().try_fold(0_u32, |value, byte| {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value.checked_mul(10)?.checked_add(u32::from(digit))
    })
}
