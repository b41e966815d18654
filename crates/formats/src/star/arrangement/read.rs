//! The door, and the grammar of records.

use super::cells::{self, Cells};
use super::curves::{List, malformed};
use super::family::Base;
use super::finish::finish;
use super::model::{CellNumbers, StarArrangement};
use super::numbers::{Numbers, OF_NUMBER};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, ReadError};
use crate::base::scan::Token;
use crate::star::door::read_star;
use crate::star::first::{StarKind, read_first_line};
use crate::star::line::{Line, Lines};
use arrangement::models::{GeodesicTraits, LinearTraits, TorusSegmentTraits};
use dcel::{CcbKind, HalfedgeId, VertexId};

/// Reads an arrangement from a file of the native format, kind `arrangement`: see `docs/star.md`. Gzip may be around it.
///
/// Nothing is believed: that edges lie on their curves, follow one another around vertices and meet nowhere else, and that everything
/// is in the face in which it is said to be, is checked. What can be read is an arrangement as if it had been made of curves.
///
/// # Errors
/// The first thing wrong with the file, with its line. A file that would take more than 64 times its length, as it is stored, and
/// 64 MiB, is refused.
///
/// # Complexity
/// O(n log n) for n bytes, unpacked, as long as coordinates have few digits.
///
/// ```
/// use splitstar_formats::{StarArrangement, read_arrangement};
///
/// let text = b"star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 1\nedge 0 infinity infinity curve 0\n\
///     face 0\nouter -0\nface 1\nouter +0\nend\n";
/// let arrangement = read_arrangement(text, None)?;
/// assert!(matches!(arrangement, StarArrangement::Linear(_)));
/// assert_eq!(arrangement.counts().faces, 2);
///
/// let twice = b"star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 1\nedge 0 infinity infinity curve 0\n\
///     face 0\nouter -0\nouter +0\nend\n";
/// assert!(read_arrangement(twice, None).is_err());
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_arrangement(bytes: &[u8], file_name: Option<&str>) -> Result<StarArrangement, ReadError> {
    read_numbered_arrangement(bytes, file_name).map(|(arrangement, _)| arrangement)
}

/// Reads an arrangement as [`read_arrangement`] does, and tells which numbers its cells have in the file.
///
/// # Errors
/// As for [`read_arrangement`].
///
/// # Complexity
/// That of [`read_arrangement`].
///
/// ```
/// use splitstar_formats::{StarArrangement, read_numbered_arrangement};
///
/// let text = b"star 1 arrangement\nsurface plane\nvertex 5 0 0\nvertex 7 1 2\nface 3\nisolated 5\nisolated 7\nend\n";
/// let (arrangement, numbers) = read_numbered_arrangement(text, None)?;
/// let StarArrangement::Linear(arrangement) = arrangement else { panic!("it has no polyline") };
/// let of_vertices: Vec<_> = arrangement.vertices().map(|v| numbers.vertex(v)).collect();
/// assert_eq!(of_vertices, [Some(5), Some(7)]);
/// assert_eq!(numbers.face(arrangement.corner_face()), 3);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_numbered_arrangement(
    bytes: &[u8],
    file_name: Option<&str>,
) -> Result<(StarArrangement, CellNumbers), ReadError> {
    read_star(bytes, file_name, StarKind::Arrangement, read_text)
}

const RECORD: &str = "a record or `end` was expected";
const KEYWORD: &str = "`curve`, `vertex`, `edge`, `face`, `outer`, `inner`, `isolated`, `end` or a comment";
const VERTEX: &str = "the number of a vertex declared above";
const HALFEDGE: &str = "an edge declared above with its sign, as `+0` or `-0`,";

fn read_text(bytes: &[u8], budget: &mut Budget) -> Result<(StarArrangement, CellNumbers), Located> {
    let mut lines = Lines::new(bytes);
    read_first_line(&mut lines, &[StarKind::Arrangement])?;
    let surface = lines.next_record();
    let Some((word, mut line)) = surface else {
        return Err(Fault::Truncated { expected: "`surface` was expected".into() }.at(lines.last()));
    };
    if word.bytes != b"surface" {
        return Err(
            word.unexpected("the second line `surface plane`, `surface torus P Q` or `surface sphere DX DY`")
        );
    }
    const SURFACE: &str = "`plane`, `torus` or `sphere`";
    let name = line.expect(SURFACE)?;
    match name.bytes {
        b"plane" => read_records::<LinearTraits>(line, lines, budget),
        b"torus" => read_records::<TorusSegmentTraits>(line, lines, budget),
        b"sphere" => read_records::<GeodesicTraits>(line, lines, budget),
        _ => Err(name.unexpected(SURFACE)),
    }
}

/// Reads what follows the name of the surface.
fn read_records<B: Base>(
    mut line: Line<'_>,
    mut lines: Lines<'_>,
    budget: &mut Budget,
) -> Result<(StarArrangement, CellNumbers), Located> {
    let base = B::read_surface(&mut line, budget)?;
    line.end()?;
    let mut reader = Reader {
        budget,
        base,
        curve_numbers: Numbers::default(),
        curves: List::Single(Vec::new()),
        cells: Cells::new(B::SPECIAL),
        points: vec![None; B::SPECIAL.count()],
        cycle: Vec::new(),
    };
    let end = loop {
        let Some((word, mut line)) = lines.next_record() else {
            return Err(Fault::Truncated { expected: RECORD.into() }.at(lines.last()));
        };
        if word.bytes == b"end" {
            line.end()?;
            break word.line;
        }
        reader.record(word, &mut line)?;
    };
    if let Some((word, _)) = lines.next_record() {
        return Err(word.fault(|token| Fault::AfterEnd { token, end: "the arrangement".into() }));
    }
    let Reader { base, curves, curve_numbers, points, mut cells, .. } = reader;
    let arrangement = finish(base, curves, &curve_numbers, points, &mut cells, end)?;
    Ok((arrangement, cells.into_numbers()))
}

struct Reader<'b, B: Base> {
    budget: &'b mut Budget,
    base: B,
    curve_numbers: Numbers,
    curves: List<B::UMonotoneCurve>,
    cells: Cells,
    /// The points of the vertices.
    points: Vec<Option<B::Point>>,
    /// The boundary that is being read.
    cycle: Vec<HalfedgeId>,
}

impl<B: Base> Reader<'_, B> {
    fn record(&mut self, keyword: Token<'_>, line: &mut Line<'_>) -> Result<(), Located> {
        match keyword.bytes {
            b"curve" => self.curve(line),
            b"vertex" => self.vertex(line),
            b"edge" => self.edge(line),
            b"face" => self.face(line),
            b"outer" => self.boundary(CcbKind::Outer, keyword, line),
            b"inner" => self.boundary(CcbKind::Inner, keyword, line),
            b"isolated" => self.isolated(keyword, line),
            b"surface" => {
                Err(keyword.fault(|_| Fault::Malformed { why: "a second surface; remove one".into() }))
            }
            _ => Err(keyword.unexpected(KEYWORD)),
        }
    }

    fn charge(&mut self, bytes: u64, line: &Line<'_>) -> Result<(), Located> {
        self.budget.charge(bytes).at_line(line.number)
    }

    fn curve(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        self.charge(OF_NUMBER, line)?;
        self.curve_numbers.declare(line.expect("the number of the curve")?, "curve")?;
        let pieces = self.base.read_pieces(line, self.budget)?;
        self.curves.push(&self.base, pieces, line.number, self.budget)
    }

    fn vertex(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        self.charge(OF_NUMBER + cells::of_vertex::<B::Point>(), line)?;
        self.cells.vertices.declare(line.expect("the number of the vertex")?, "vertex")?;
        let point = self.base.read_point(line, self.budget)?;
        let is_artificial = match line.word() {
            None => false,
            Some(word) if word.bytes == b"artificial" => true,
            Some(word) => return Err(word.unexpected("`artificial` or the end of the line")),
        };
        line.end()?;
        let special = self.base.special_of(&point);
        self.cells.push_vertex(special, is_artificial, line.number)?;
        match special {
            Some(v) => self.points[v.index()] = Some(point),
            None => self.points.push(Some(point)),
        }
        Ok(())
    }

    fn edge(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        const CURVE: &str = "the number of a curve declared above";
        self.charge(OF_NUMBER + cells::OF_EDGE + self.curves.bytes_of_part::<B>(), line)?;
        self.cells.edges.declare(line.expect("the number of the edge")?, "edge")?;
        let ends = [self.end(line)?, self.end(line)?];
        let word = line.expect("`curve`")?;
        if word.bytes != b"curve" {
            return Err(word.unexpected("`curve`"));
        }
        let curve = line.expect(CURVE)?;
        let support = self.curve_numbers.find(curve.bytes).ok_or_else(|| curve.unexpected(CURVE))?;
        line.end()?;
        self.cells.push_edge(ends, support);
        Ok(())
    }

    /// An end of an edge.
    fn end(&self, line: &mut Line<'_>) -> Result<VertexId, Located> {
        let has_infinity = self.cells.special.is_infinity();
        let expected =
            if has_infinity { "the number of a vertex declared above, or `infinity`," } else { VERTEX };
        let token = line.expect(expected)?;
        if has_infinity && token.bytes == b"infinity" {
            return Ok(VertexId(0));
        }
        self.cells.vertex(token.bytes).ok_or_else(|| token.unexpected(expected))
    }

    fn face(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        self.charge(OF_NUMBER + cells::OF_FACE, line)?;
        self.cells.faces.declare(line.expect("the number of the face")?, "face")?;
        line.end()
    }

    /// There must be a face to which the record belongs.
    fn check_face(&self, keyword: Token<'_>) -> Result<(), Located> {
        if self.cells.faces.len() > 0 {
            return Ok(());
        }
        let why =
            format!("`{}` before the first face; write `face` and its number before it", keyword.shown());
        Err(malformed(keyword.line, why))
    }

    fn boundary(&mut self, kind: CcbKind, keyword: Token<'_>, line: &mut Line<'_>) -> Result<(), Located> {
        self.check_face(keyword)?;
        self.charge(cells::OF_CCB, line)?;
        self.cycle.clear();
        let mut word = line.expect(HALFEDGE)?;
        loop {
            let halfedge = self.halfedge(word)?;
            self.cycle.push(halfedge);
            match line.word() {
                Some(next) => word = next,
                None => break,
            }
            // A boundary has each halfedge once.
            if self.cycle.len() > self.cells.halfedges.len() {
                return Err(malformed(
                    line.number,
                    "the boundary has more members than there are; each stands once".into(),
                ));
            }
        }
        self.cells.push_ccb(kind, &self.cycle, line.number)
    }

    fn halfedge(&self, token: Token<'_>) -> Result<HalfedgeId, Located> {
        let found = match token.bytes {
            [b'+', digits @ ..] => self.cells.edges.find(digits).map(|edge| HalfedgeId(2 * edge)),
            [b'-', digits @ ..] => self.cells.edges.find(digits).map(|edge| HalfedgeId(2 * edge + 1)),
            _ => None,
        };
        found.ok_or_else(|| token.unexpected(HALFEDGE))
    }

    fn isolated(&mut self, keyword: Token<'_>, line: &mut Line<'_>) -> Result<(), Located> {
        self.check_face(keyword)?;
        self.charge(cells::OF_ISOLATED, line)?;
        let token = line.expect(VERTEX)?;
        let vertex = self.cells.vertex(token.bytes).ok_or_else(|| token.unexpected(VERTEX))?;
        line.end()?;
        self.cells.push_isolated(vertex, line.number);
        Ok(())
    }
}
