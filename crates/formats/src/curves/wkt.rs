//! Geometries in well-known text (WKT) of ISO 19125, with the dimensions of ISO 13249 and the SRID of PostGIS.

use super::DEPTH;
use super::lexer::{Lexer, is_mark};
use super::maker::{Chain, Maker, Surface};
use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;

/// What a geometry is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Point,
    LineString,
    Polygon,
    MultiPoint,
    MultiLineString,
    MultiPolygon,
    Collection,
    /// Known to WKT, but not made of straight pieces in the plane.
    Other,
}

/// How many coordinates a point has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Dimension {
    /// Two to four: many programs write three without a word for it.
    Unsaid,
    Exactly(usize),
}

const NAMES: [(&str, Kind); 17] = [
    ("POINT", Kind::Point),
    ("LINESTRING", Kind::LineString),
    ("LINEARRING", Kind::LineString),
    ("POLYGON", Kind::Polygon),
    ("TRIANGLE", Kind::Polygon),
    ("MULTIPOINT", Kind::MultiPoint),
    ("MULTILINESTRING", Kind::MultiLineString),
    ("MULTIPOLYGON", Kind::MultiPolygon),
    ("GEOMETRYCOLLECTION", Kind::Collection),
    ("CIRCULARSTRING", Kind::Other),
    ("COMPOUNDCURVE", Kind::Other),
    ("CURVEPOLYGON", Kind::Other),
    ("MULTICURVE", Kind::Other),
    ("MULTISURFACE", Kind::Other),
    ("POLYHEDRALSURFACE", Kind::Other),
    ("TIN", Kind::Other),
    ("CIRCLE", Kind::Other),
];

const SRID: &[u8] = b"SRID=";
const GEOMETRY: &str = "a geometry of WKT";
const COORDINATE: &str = "a coordinate";
const COMMA_OR_CLOSE: &str = "`,` or `)`";

/// Whether a record that begins with this word is one of WKT.
pub(super) fn begins_with(word: Token<'_>) -> bool {
    is_srid(word) || kind_of(word).is_some()
}

/// Whether what follows the word `point` makes it one of WKT: a parenthesis or a word that is no number.
pub(super) fn follows(lexer: &Lexer<'_>) -> bool {
    let is_tag = |token: Token<'_>| dimension_of(token).is_some() || is(token, "EMPTY");
    lexer.peek_in_line().is_some_and(|token| token.bytes == b"(" || is_tag(token))
}

/// Reads a geometry whose first word is read.
pub(super) fn read<'a, S: Surface>(
    word: Token<'a>,
    lexer: &mut Lexer<'a>,
    maker: &mut Maker<'_, S>,
) -> Result<(), Located> {
    let mut word = word;
    if is_srid(word) {
        let number = &word.bytes[SRID.len()..];
        if number.is_empty() || !number.iter().all(u8::is_ascii_digit) {
            return Err(word.unexpected("`SRID=` and a whole number"));
        }
        let semicolon = lexer.expect_in_line("`;` behind the SRID")?;
        if semicolon.bytes != b";" {
            return Err(semicolon.unexpected("`;` behind the SRID"));
        }
        word = lexer.expect_in_line(GEOMETRY)?;
    }
    Reader { lexer, maker, depth: 0 }.geometry(word)
}

fn is(token: Token<'_>, word: &str) -> bool {
    token.bytes.eq_ignore_ascii_case(word.as_bytes())
}

fn is_srid(word: Token<'_>) -> bool {
    word.bytes.get(..SRID.len()).is_some_and(|start| start.eq_ignore_ascii_case(SRID))
}

/// What the first word of a geometry names, perhaps with the dimension as its end (`POINTZ`).
fn kind_of(word: Token<'_>) -> Option<(Kind, Dimension)> {
    NAMES.iter().find_map(|&(name, kind)| {
        let (start, end) = word.bytes.split_at_checked(name.len())?;
        let dimension = match end {
            [] => Dimension::Unsaid,
            end => dimension_of(Token { bytes: end, line: word.line })?,
        };
        start.eq_ignore_ascii_case(name.as_bytes()).then_some((kind, dimension))
    })
}

fn dimension_of(token: Token<'_>) -> Option<Dimension> {
    if is(token, "Z") || is(token, "M") {
        Some(Dimension::Exactly(3))
    } else {
        is(token, "ZM").then_some(Dimension::Exactly(4))
    }
}

struct Reader<'a, 'l, 'm, 'b, S: Surface> {
    lexer: &'l mut Lexer<'a>,
    maker: &'m mut Maker<'b, S>,
    /// The number of collections that are open.
    depth: u32,
}

impl<'a, S: Surface> Reader<'a, '_, '_, '_, S> {
    fn geometry(&mut self, word: Token<'a>) -> Result<(), Located> {
        let (kind, mut dimension) = kind_of(word).ok_or_else(|| word.unexpected(GEOMETRY))?;
        if kind == Kind::Other {
            return Err(word.fault(|what| Fault::Unsupported {
                what: format!("a geometry `{what}`"),
                instead: S::INSTEAD.into(),
            }));
        }
        let expected = "`(` or `EMPTY`";
        let mut open = self.after_name(expected)?;
        if let (Dimension::Unsaid, Some(said)) = (dimension, dimension_of(open)) {
            dimension = said;
            open = self.after_name(expected)?;
        }
        if is(open, "EMPTY") {
            self.maker.count_empty();
            return Ok(());
        }
        if open.bytes != b"(" {
            return Err(open.unexpected(expected));
        }
        match kind {
            Kind::Point => {
                let (point, line) = self.position(None, dimension)?;
                self.close()?;
                self.maker.point(point, line)
            }
            Kind::LineString => self.chain(Chain::Open, dimension),
            Kind::Polygon => self.chains(Chain::Ring, dimension),
            Kind::MultiLineString => self.chains(Chain::Open, dimension),
            Kind::MultiPoint => self.list(|reader| reader.point_of_many(dimension)),
            Kind::MultiPolygon => {
                self.list(|reader| reader.part(|reader| reader.chains(Chain::Ring, dimension)))
            }
            Kind::Collection => {
                self.depth += 1;
                if self.depth > DEPTH {
                    let what = format!("collections nested more than {DEPTH} deep");
                    return Err(Fault::Unsupported { what, instead: "nest them less".into() }
                        .at(Place::Line(open.line)));
                }
                self.list(|reader| {
                    let word = reader.lexer.expect(GEOMETRY)?;
                    reader.geometry(word)
                })?;
                self.depth -= 1;
                Ok(())
            }
            Kind::Other => unreachable!("these are refused above"),
        }
    }

    /// The token behind a name, which stands in the line of the name unless a parenthesis is open.
    fn after_name(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        if self.depth > 0 { self.lexer.expect(expected) } else { self.lexer.expect_in_line(expected) }
    }

    /// Reads what stands between parentheses, the first of which is read, with commas between.
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), Located>) -> Result<(), Located> {
        loop {
            item(self)?;
            let token = self.lexer.expect(COMMA_OR_CLOSE)?;
            match token.bytes {
                b"," => {}
                b")" => return Ok(()),
                _ => return Err(token.unexpected(COMMA_OR_CLOSE)),
            }
        }
    }

    /// Reads a part of a geometry: what stands between its parentheses, or `EMPTY`.
    fn part(&mut self, inside: impl FnOnce(&mut Self) -> Result<(), Located>) -> Result<(), Located> {
        let expected = "`(` or `EMPTY`";
        let token = self.lexer.expect(expected)?;
        match token.bytes {
            b"(" => inside(self),
            _ if is(token, "EMPTY") => {
                self.maker.count_empty();
                Ok(())
            }
            _ => Err(token.unexpected(expected)),
        }
    }

    fn chains(&mut self, kind: Chain, dimension: Dimension) -> Result<(), Located> {
        self.list(|reader| reader.part(|reader| reader.chain(kind, dimension)))
    }

    fn chain(&mut self, kind: Chain, dimension: Dimension) -> Result<(), Located> {
        self.maker.begin_chain();
        self.list(|reader| {
            let (point, line) = reader.position(None, dimension)?;
            reader.maker.extend_chain(point, line)
        })?;
        self.maker.end_chain(kind)
    }

    /// A point of a `MULTIPOINT`, with or without parentheses.
    fn point_of_many(&mut self, dimension: Dimension) -> Result<(), Located> {
        let token = self.lexer.expect("a point")?;
        if is(token, "EMPTY") {
            self.maker.count_empty();
            return Ok(());
        }
        let (point, line) = if token.bytes == b"(" {
            let position = self.position(None, dimension)?;
            self.close()?;
            position
        } else {
            self.position(Some(token), dimension)?
        };
        self.maker.point(point, line)
    }

    fn close(&mut self) -> Result<(), Located> {
        let token = self.lexer.expect("`)`")?;
        if token.bytes == b")" { Ok(()) } else { Err(token.unexpected("`)`")) }
    }

    /// Reads a point and the line where it begins; its first coordinate may be read already.
    #[inline]
    fn position(
        &mut self,
        first: Option<Token<'a>>,
        dimension: Dimension,
    ) -> Result<(S::Point, u32), Located> {
        let first = first.map_or_else(|| self.lexer.expect(COORDINATE), Ok)?;
        if is_mark(first) {
            return Err(first.unexpected(COORDINATE));
        }
        let second = self.lexer.expect(COORDINATE)?;
        let point = S::position(self.maker, first, second)?;
        let (least, most) = match dimension {
            Dimension::Unsaid => (2, 4),
            Dimension::Exactly(number) => (number, number),
        };
        let mut number = 2;
        while number < most {
            if number >= least {
                let ahead = self.lexer.clone().expect(COMMA_OR_CLOSE)?;
                if matches!(ahead.bytes, b"," | b")") {
                    break;
                }
            }
            let extra = self.lexer.expect(COORDINATE)?;
            self.maker.extra_coordinate(extra)?;
            number += 1;
        }
        if number > 2 {
            self.maker.count_dropped();
        }
        Ok((point, first.line))
    }
}
