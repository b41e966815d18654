//! Curves of the plane and of a torus: their points, and the lines of our own grammar.

use super::geojson;
use super::lexer::Lexer;
use super::maker::{Chain, Maker, Surface, bits, fits, heap_bytes, number};
use super::model::{CurvePoint, InputCurve};
use super::read::Known;
use super::wkt;
use crate::base::error::{At, Fault, Located};
use crate::base::number::Number;
use crate::base::places::Place;
use crate::base::scan::Token;
use exact::planar::Point2;
use exact::{Rational, Sign};

/// The plane, or the torus of these periods.
#[derive(Default)]
pub(super) struct Plane {
    pub(super) period: Option<[Rational; 2]>,
}

impl Surface for Plane {
    type Point = CurvePoint;
    type Curve = InputCurve;

    const INSTEAD: &'static str =
        "give `segment`, `ray`, `line`, `polyline` or `point`, or a POINT, LINESTRING or POLYGON of WKT";

    #[inline]
    fn position(maker: &mut Maker<'_, Self>, x: Token<'_>, y: Token<'_>) -> Result<CurvePoint, Located> {
        maker.point_of(x, y)
    }

    #[inline]
    fn check_step(_: &CurvePoint, _: &CurvePoint) -> Result<(), &'static str> {
        Ok(())
    }

    fn of_point(point: CurvePoint) -> InputCurve {
        InputCurve::Point(point)
    }

    fn of_chain(points: Vec<CurvePoint>) -> InputCurve {
        InputCurve::Polyline(points)
    }

    fn into_point(curve: InputCurve) -> Result<CurvePoint, &'static str> {
        Err(match curve {
            InputCurve::Point(point) => return Ok(point),
            InputCurve::Segment(_) => "a segment",
            InputCurve::Ray(_) => "a ray",
            InputCurve::Line(_) => "a line",
            InputCurve::Polyline(_) => "a polyline",
        })
    }
}

impl Maker<'_, Plane> {
    /// Makes a point of its coordinates; what it takes on the heap is charged.
    #[inline]
    pub(super) fn point_of(&mut self, x: Token<'_>, y: Token<'_>) -> Result<CurvePoint, Located> {
        match (number(x)?, number(y)?) {
            (Number::Small(i, 1), Number::Small(j, 1)) if fits(i) && fits(j) => Ok(Point2::from_i64([i, j])),
            (i, j) => {
                let coordinates = [i, j].map(Number::into_rational);
                self.budget.charge(wide_bytes(&coordinates)).at_line(x.line)?;
                Ok(Point2::from_rationals(&coordinates))
            }
        }
    }

    /// Adds a segment, a ray or a line, whose points must be different.
    #[inline]
    pub(super) fn straight(&mut self, curve: InputCurve, line: u32) -> Result<(), Located> {
        let (ends, name) = match &curve {
            InputCurve::Segment(ends) => (ends, "segment"),
            InputCurve::Ray(ends) => (ends, "ray"),
            InputCurve::Line(ends) => (ends, "line"),
            _ => unreachable!("polylines and points are added by methods of their own"),
        };
        if ends[0] == ends[1] {
            return Err(same_ends(name, line));
        }
        if self.surface.period.is_some() && name != "segment" {
            let what = format!("a {name} on a torus");
            let instead = "it has no end there: give a segment, or remove `period`".into();
            return Err(Fault::Unsupported { what, instead }.at(Place::Line(line)));
        }
        self.push(curve, line)
    }
}

#[cold]
fn same_ends(name: &str, line: u32) -> Located {
    let why = if name == "segment" {
        "both ends of the segment are the same point; move one of them, or write `point x y`".into()
    } else {
        format!(
            "both points of the {name} are the same, so that it has no direction; give two different points"
        )
    };
    Fault::Malformed { why }.at(Place::Line(line))
}

/// Reads a record whose first word is read.
pub(super) fn record<'a>(
    word: Token<'a>,
    lexer: &mut Lexer<'a>,
    maker: &mut Maker<'_, Plane>,
    first: bool,
) -> Result<Known, Located> {
    let is = |keyword: &str| word.bytes.eq_ignore_ascii_case(keyword.as_bytes());
    if is("segment") {
        let ends = two_points(lexer, maker, "a segment of two points (`segment x1 y1 x2 y2`)")?;
        maker.straight(InputCurve::Segment(ends), word.line)?;
    } else if is("polyline") {
        polyline(lexer, maker)?;
    } else if is("ray") {
        let ends = two_points(lexer, maker, "a ray of two points (`ray x1 y1 x2 y2`)")?;
        maker.straight(InputCurve::Ray(ends), word.line)?;
    } else if is("line") {
        let ends = two_points(lexer, maker, "a line of two points (`line x1 y1 x2 y2`)")?;
        maker.straight(InputCurve::Line(ends), word.line)?;
    } else if is("point") && !wkt::follows(lexer) {
        let point = point(lexer, maker, "a point of two coordinates (`point x y`)")?;
        maker.point(point, word.line)?;
    } else if is("period") {
        if !first {
            let why = "`period` behind another record; make it the first one, and the only `period`".into();
            return Err(Fault::Malformed { why }.at(Place::Line(word.line)));
        }
        let period = [period(lexer)?, period(lexer)?];
        maker.surface.period = Some(period);
    } else if is("arc") || is("circle") && !wkt::follows(lexer) {
        let (file, instead) = match maker.is_of_points() {
            true => ("points of the plane", "give points as `x y` or `point x y`, or in WKT or GeoJSON"),
            false => ("the plane", "it is a curve of the sphere: arrange it with `--surface sphere`"),
        };
        return Err(word.fault(|word| Fault::Unsupported {
            what: format!("`{word}` in a file of {file}"),
            instead: instead.into(),
        }));
    } else if word.bytes == b"{" {
        geojson::read(word, lexer, maker)?;
    } else if wkt::begins_with(word) {
        wkt::read(word, lexer, maker)?;
    } else {
        return Ok(Known::No);
    }
    Ok(Known::Yes)
}

#[inline]
fn point(lexer: &mut Lexer<'_>, maker: &mut Maker<'_, Plane>, expected: &str) -> Result<CurvePoint, Located> {
    let x = lexer.coordinate_in_line(expected)?;
    let y = lexer.coordinate_in_line(expected)?;
    maker.point_of(x, y)
}

#[inline]
fn two_points(
    lexer: &mut Lexer<'_>,
    maker: &mut Maker<'_, Plane>,
    expected: &str,
) -> Result<[CurvePoint; 2], Located> {
    Ok([point(lexer, maker, expected)?, point(lexer, maker, expected)?])
}

fn polyline(lexer: &mut Lexer<'_>, maker: &mut Maker<'_, Plane>) -> Result<(), Located> {
    const TWO: &str = "a polyline of two points or more (`polyline x1 y1 x2 y2 ...`)";
    maker.begin_chain();
    for _ in 0..2 {
        let point = point(lexer, maker, TWO)?;
        maker.extend_chain(point, lexer.line())?;
    }
    while let Some(x) = lexer.next_coordinate_in_line()? {
        let y = lexer.coordinate_in_line("the second coordinate of the last point")?;
        let point = maker.point_of(x, y)?;
        maker.extend_chain(point, x.line)?;
    }
    maker.end_chain(Chain::Open)
}

fn period(lexer: &mut Lexer<'_>) -> Result<Rational, Located> {
    let token = lexer.coordinate_in_line("a pair of periods (`period P Q`)")?;
    let period = number(token)?.into_rational();
    if period.sign() == Sign::Positive { Ok(period) } else { Err(token.unexpected("a period larger than 0")) }
}

/// What the point of these coordinates takes on the heap at most: two numerators and their common denominator.
fn wide_bytes([x, y]: &[Rational; 2]) -> u64 {
    let ([x, x_weight], [y, y_weight]) = (bits(x), bits(y));
    heap_bytes([x + y_weight, y + x_weight, x_weight + y_weight])
}
