//! Shapes to vertices and facets.

use super::frame::{Frame, numbers};
use super::lexer::{Kind, Lexer};
use super::scene::{Scene, unsupported};
use crate::base::error::{At, Fault, Located};
use crate::base::number::point;
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::{read_coordinate, read_index};
use exact::{Point3, Rational, Sign};
use std::rc::Rc;

/// The vertices that the coordinates of a node have become.
pub(super) struct Shared {
    frame: Rc<Frame>,
    vertices: Vertices,
}

/// A run of vertices.
#[derive(Clone, Copy, Default)]
struct Vertices {
    first: u32,
    count: u32,
}

/// What an entry of the map of shared vertices takes, at most.
const ENTRY: u64 = 128;

impl<'a> Scene<'a, '_> {
    /// Reads the geometry of a shape.
    pub(super) fn geometry(&mut self, lexer: &mut Lexer<'a>, frame: &Rc<Frame>) -> Result<(), Located> {
        let Some(mut node) = self.enter(lexer)? else { return Ok(()) };
        let kind = node.kind;
        match kind.bytes {
            b"IndexedFaceSet" => {
                let [coord, index, ccw] = node.body.fields(["coord", "coordIndex", "ccw"])?;
                let vertices = self.coordinates(coord, frame)?;
                let clockwise = ccw.map_or(Ok(false), is_false)?;
                self.facets(index, vertices, clockwise != frame.reflects())?;
            }
            b"IndexedLineSet" => {
                let [coord, index] = node.body.fields(["coord", "coordIndex"])?;
                let vertices = self.coordinates(coord, frame)?;
                self.lines(index, vertices)?;
            }
            b"PointSet" => {
                let [coord] = node.body.fields(["coord"])?;
                if self.coordinates(coord, frame)?.count > 0 {
                    self.point_set.get_or_insert(kind.line);
                }
            }
            b"Box" => {
                let [size] = node.body.fields(["size"])?;
                self.cuboid(size, frame, kind)?;
            }
            _ => {
                let what = format!("the geometry `{}`", kind.shown());
                let instead = "turn it into an IndexedFaceSet before export, or remove it";
                return Err(unsupported(kind, what, instead));
            }
        }
        self.leave(&node, lexer)
    }

    /// The vertices of a node with coordinates, appended to the mesh where they are not yet.
    fn coordinates(&mut self, value: Option<Lexer<'a>>, frame: &Rc<Frame>) -> Result<Vertices, Located> {
        let Some(mut lexer) = value else { return Ok(Vertices::default()) };
        let Some(mut node) = self.enter(&mut lexer)? else { return Ok(Vertices::default()) };
        let exact = match node.kind.bytes {
            b"Coordinate" => false,
            b"ExactCoordinate" => true,
            _ => return Err(node.kind.unexpected("a Coordinate")),
        };
        let [points, strings] = node.body.fields(["point", "exact"])?;
        let shared = self.shared.get(&node.offset).filter(|shared| shared.frame == *frame);
        let vertices = match shared {
            Some(shared) => shared.vertices,
            None => {
                let first = self.maker.vertex_count();
                let strings = strings.filter(|strings| exact && !is_empty_list(*strings));
                match strings {
                    Some(strings) => self.exact_points(strings, frame)?,
                    None => self.points(points, frame)?,
                }
                let vertices = Vertices { first, count: self.maker.vertex_count() - first };
                self.maker.budget().charge(ENTRY).at_line(node.kind.line)?;
                let shared = || Shared { frame: Rc::clone(frame), vertices };
                self.shared.entry(node.offset).or_insert_with(shared);
                vertices
            }
        };
        self.leave(&node, &mut lexer)?;
        Ok(vertices)
    }

    fn points(&mut self, value: Option<Lexer<'a>>, frame: &Rc<Frame>) -> Result<(), Located> {
        const EXPECTED: &str = "a coordinate";
        let Some(mut lexer) = value else { return Ok(()) };
        let list = lexer.is_next(b"[");
        if list {
            lexer.next();
        }
        loop {
            let x = lexer.token(EXPECTED)?;
            if list && x.bytes == b"]" {
                return Ok(());
            }
            let y = lexer.token(EXPECTED)?;
            let z = if y.bytes == b"]" { y } else { lexer.token(EXPECTED)? };
            if z.bytes == b"]" {
                return Err(z.unexpected("another coordinate, the number of which is divisible by three,"));
            }
            self.point([x, y, z], frame)?;
            if !list {
                return Ok(());
            }
        }
    }

    /// A string for each point, with its three coordinates.
    fn exact_points(&mut self, mut lexer: Lexer<'a>, frame: &Rc<Frame>) -> Result<(), Located> {
        const EXPECTED: &str = "the three coordinates of a point in quotes";
        let list = lexer.is_next(b"[");
        if list {
            lexer.next();
        }
        loop {
            let token = lexer.token(EXPECTED)?;
            if list && token.bytes == b"]" {
                return Ok(());
            }
            let (Kind::String, [b'"', text @ .., b'"']) = (Kind::of(token), token.bytes) else {
                return Err(token.unexpected(EXPECTED));
            };
            let blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == b',';
            let mut words = text.split(blank).filter(|word| !word.is_empty());
            let (Some(x), Some(y), Some(z), None) = (words.next(), words.next(), words.next(), words.next())
            else {
                return Err(token.unexpected(EXPECTED));
            };
            self.point([x, y, z].map(|bytes| Token { bytes, line: token.line }), frame)?;
            if !list {
                return Ok(());
            }
        }
    }

    #[inline]
    fn point(&mut self, [x, y, z]: [Token<'_>; 3], frame: &Rc<Frame>) -> Result<(), Located> {
        let coordinates = [read_coordinate(x)?, read_coordinate(y)?, read_coordinate(z)?];
        self.vertex(point(coordinates), frame, x.line)
    }

    #[inline]
    fn vertex(&mut self, point: Point3, frame: &Rc<Frame>, line: u32) -> Result<(), Located> {
        self.maker.vertex(frame.apply(point), Place::Line(line)).at_line(line)?;
        Ok(())
    }

    fn facets(&mut self, value: Option<Lexer<'a>>, vertices: Vertices, turned: bool) -> Result<(), Located> {
        cycles(value, vertices, |cycle, line| {
            if turned {
                // The first vertex stays the first.
                cycle[1..].reverse();
            }
            self.facet(cycle, vertices, line)
        })
    }

    fn lines(&mut self, value: Option<Lexer<'a>>, vertices: Vertices) -> Result<(), Located> {
        cycles(value, vertices, |line_string, line| {
            if line_string.len() < 2 {
                return Err(Fault::SmallFacet { size: 1 }).at_line(line);
            }
            line_string.windows(2).try_for_each(|pair| self.facet(pair, vertices, line))
        })
    }

    #[inline]
    fn facet(&mut self, cycle: &[u32], vertices: Vertices, line: u32) -> Result<(), Located> {
        let result = self.maker.facet(cycle, Place::Line(line), 0);
        result
            .map_err(|fault| match fault {
                // As the indices of the node count them.
                Fault::RepeatedVertex { vertex, in_a_row } => {
                    Fault::RepeatedVertex { vertex: vertex - vertices.first, in_a_row }
                }
                fault => fault,
            })
            .at_line(line)
    }

    /// A box about the origin, with its edges along the axes.
    fn cuboid(&mut self, size: Option<Lexer<'a>>, frame: &Rc<Frame>, kind: Token<'a>) -> Result<(), Located> {
        // Corner 0 is the lowest in all coordinates; bit 0 of a number means high x, bit 1 high y, bit 2 high
        // z.
        const FACETS: [[u32; 4]; 6] =
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let size = match size {
            Some(mut value) => numbers::<3>(&mut value)?,
            None => [2, 2, 2].map(Rational::from),
        };
        if size.iter().any(|length| length.sign() != Sign::Positive) {
            let found = size.map(|length| length.to_string()).join(" ");
            let token = Token { bytes: found.as_bytes(), line: kind.line };
            return Err(token.unexpected("a size of three positive numbers"));
        }
        let first = self.maker.vertex_count();
        let line = kind.line;
        for corner in 0..8_usize {
            let half = |axis: usize| {
                let doubled = if corner >> axis & 1 == 1 { 2 } else { -2 };
                size[axis].checked_div(&Rational::from(doubled)).expect("the divisor is not zero")
            };
            self.vertex(Point3::from_rationals(&[half(0), half(1), half(2)]), frame, line)?;
        }
        for mut cycle in FACETS {
            if frame.reflects() {
                cycle[1..].reverse();
            }
            self.facet(&cycle.map(|corner| first + corner), Vertices { first, count: 8 }, line)?;
        }
        Ok(())
    }
}

fn is_false(mut value: Lexer<'_>) -> Result<bool, Located> {
    let token = value.token("TRUE or FALSE")?;
    match token.bytes {
        b"TRUE" => Ok(false),
        b"FALSE" => Ok(true),
        _ => Err(token.unexpected("TRUE or FALSE")),
    }
}

fn is_empty_list(mut value: Lexer<'_>) -> bool {
    value.next().is_some_and(|token| token.bytes == b"[") && value.is_next(b"]")
}

/// Reads a list of indices, in which -1 ends each cycle but perhaps the last. Cycles come with the lines of
/// their first indices, and with the vertices of the mesh.
fn cycles(
    value: Option<Lexer<'_>>,
    vertices: Vertices,
    mut cycle_in_line: impl FnMut(&mut [u32], u32) -> Result<(), Located>,
) -> Result<(), Located> {
    let Some(mut lexer) = value else { return Ok(()) };
    if lexer.is_next(b"[") {
        lexer.next();
    } else {
        // One index without brackets is no cycle.
        let token = lexer.token("`[`")?;
        return if token.bytes == b"-1" { Ok(()) } else { Err(token.unexpected("`[`")) };
    }
    let mut cycle = Vec::new();
    let mut line = 0;
    loop {
        let token = lexer.token("an index or `]`")?;
        let last = token.bytes == b"]";
        if !last && token.bytes != b"-1" {
            if cycle.is_empty() {
                line = token.line;
            }
            cycle.push(vertices.first + read_index(token, vertices.count, 0)?);
        } else if !cycle.is_empty() {
            cycle_in_line(&mut cycle, line)?;
            cycle.clear();
        } else if !last {
            return Err(Fault::SmallFacet { size: 0 }).at_line(token.line);
        }
        if last {
            return Ok(());
        }
    }
}
