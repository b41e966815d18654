//! Curves on the sphere: their points, and the lines of our own grammar.

use super::lexer::Lexer;
use super::maker::{Chain, Maker, Surface, bits, fits, heap_bytes, number};
use super::model::SphereCurve;
use super::read::Known;
use super::{geojson, wkt};
use crate::base::error::{At, Fault, Located};
use crate::base::number::Number;
use crate::base::places::Place;
use crate::base::scan::Token;
use exact::spherical::geographic::from_degrees;
use exact::spherical::{Direction, GreatCircle, is_antipodal, side_of_circle};
use exact::{Integer, Rational, Sign, Vector3};
use std::fmt;

/// The sphere.
pub(super) struct Sphere;

/// Why there is no such curve on the sphere.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum SphereFault {
    /// Both ends of an arc are the same.
    SameEnds,
    /// The ends of an arc are antipodal, and no point between tells which way it goes.
    Antipodal,
    /// The point between the ends is one of them.
    ViaEnd,
    /// The point between the ends does not lie on the great circle through them.
    ViaBeside,
    /// A polyline has no point.
    Empty,
    /// Two points that follow each other in a polyline are antipodal.
    AntipodalStep,
}

const ANTIPODAL_STEP: &str = "the point is antipodal to the one before it, and every arc between them is as short; give a point between";

impl fmt::Display for SphereFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SameEnds => {
                "both ends of the arc are the same point; move one of them, or write `point x y z` or `circle nx ny nz`"
            }
            Self::Antipodal => {
                "the ends of the arc are antipodal, and every arc between them is as short; say through which point \
                 it goes: `via x y z`"
            }
            Self::ViaEnd => "the point behind `via` is an end of the arc; give one between the ends",
            Self::ViaBeside => {
                "the point behind `via` does not lie on the great circle through the ends of the arc; move it there, or \
                 leave it out"
            }
            Self::Empty => "a polyline without a point; give it two points or more",
            Self::AntipodalStep => ANTIPODAL_STEP,
        })
    }
}

/// Tells what is wrong with a curve, if it has no place in an arrangement.
pub(crate) fn check_sphere_curve(curve: &SphereCurve) -> Result<(), SphereFault> {
    match curve {
        SphereCurve::Arc([source, target]) if source == target => Err(SphereFault::SameEnds),
        SphereCurve::Arc([source, target]) if is_antipodal(source, target) => Err(SphereFault::Antipodal),
        SphereCurve::ArcVia(points) => check_via(points),
        SphereCurve::Polyline(points) if points.is_empty() => Err(SphereFault::Empty),
        SphereCurve::Polyline(points) => {
            match points.windows(2).any(|step| is_antipodal(&step[0], &step[1])) {
                true => Err(SphereFault::AntipodalStep),
                false => Ok(()),
            }
        }
        SphereCurve::Arc(_) | SphereCurve::Circle(_) | SphereCurve::Point(_) => Ok(()),
    }
}

fn check_via([source, via, target]: &[Direction; 3]) -> Result<(), SphereFault> {
    if source == target {
        return Err(SphereFault::SameEnds);
    }
    if via == source || via == target {
        return Err(SphereFault::ViaEnd);
    }
    // Through antipodal points there is a great circle with any third one.
    match GreatCircle::through(source, target) {
        Some(circle) if side_of_circle(via, &circle) != Sign::Zero => Err(SphereFault::ViaBeside),
        _ => Ok(()),
    }
}

impl Surface for Sphere {
    type Point = Direction;
    type Curve = SphereCurve;

    const INSTEAD: &'static str =
        "give `arc`, `circle`, `polyline` or `point`, or a POINT, LINESTRING or POLYGON of WKT";

    fn position(
        _: &mut Maker<'_, Self>,
        longitude: Token<'_>,
        latitude: Token<'_>,
    ) -> Result<Direction, Located> {
        let [east, north] = [number(longitude)?, number(latitude)?].map(Number::into_rational);
        from_degrees(&east, &north)
            .ok_or_else(|| latitude.unexpected("a latitude from -90 to 90 degrees behind the longitude"))
    }

    fn check_step(from: &Direction, to: &Direction) -> Result<(), &'static str> {
        if is_antipodal(from, to) { Err(ANTIPODAL_STEP) } else { Ok(()) }
    }

    fn of_point(point: Direction) -> SphereCurve {
        SphereCurve::Point(point)
    }

    fn of_chain(points: Vec<Direction>) -> SphereCurve {
        SphereCurve::Polyline(points)
    }

    fn into_point(curve: SphereCurve) -> Result<Direction, &'static str> {
        Err(match curve {
            SphereCurve::Point(point) => return Ok(point),
            SphereCurve::Arc(_) | SphereCurve::ArcVia(_) => "an arc",
            SphereCurve::Circle(_) => "a circle",
            SphereCurve::Polyline(_) => "a polyline",
        })
    }
}

/// Reads a record whose first word is read.
pub(super) fn record<'a>(
    word: Token<'a>,
    lexer: &mut Lexer<'a>,
    maker: &mut Maker<'_, Sphere>,
) -> Result<Known, Located> {
    let is = |keyword: &str| word.bytes.eq_ignore_ascii_case(keyword.as_bytes());
    if is("arc") {
        let curve = arc(lexer, maker)?;
        add(curve, word.line, maker)?;
    } else if is("polyline") {
        polyline(lexer, maker)?;
    } else if is("circle") && !wkt::follows(lexer) {
        let normal = vector(lexer, maker, "a circle of one normal (`circle nx ny nz`)")?;
        let circle = GreatCircle::new(&Vector3::new(normal)).expect("a normal of zeros is refused");
        add(SphereCurve::Circle(circle), word.line, maker)?;
    } else if is("point") && !wkt::follows(lexer) {
        let point = direction(lexer, maker, "a point of three coordinates (`point x y z`)")?;
        maker.point(point, word.line)?;
    } else if ["segment", "ray", "line", "period"].into_iter().any(is) {
        let (file, instead) = match maker.is_of_points() {
            true => ("points of the sphere", "give points as `x y z` or `point x y z`, or in WKT or GeoJSON"),
            false => (
                "the sphere",
                "give `arc`, `circle`, `polyline` or `point`, or arrange it without `--surface sphere`",
            ),
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

/// Reads a point whose first coordinate is read.
pub(super) fn bare_point<'a>(
    x: Token<'a>,
    lexer: &mut Lexer<'a>,
    maker: &mut Maker<'_, Sphere>,
) -> Result<Direction, Located> {
    direction_from(x, lexer, maker, "a point of three coordinates (`x y z`)")
}

fn add(curve: SphereCurve, line: u32, maker: &mut Maker<'_, Sphere>) -> Result<(), Located> {
    check_sphere_curve(&curve)
        .map_err(|fault| Fault::Malformed { why: fault.to_string() }.at(Place::Line(line)))?;
    maker.push(curve, line)
}

fn arc(lexer: &mut Lexer<'_>, maker: &mut Maker<'_, Sphere>) -> Result<SphereCurve, Located> {
    const TWO: &str = "an arc of two points (`arc x1 y1 z1 x2 y2 z2`)";
    let ends = [direction(lexer, maker, TWO)?, direction(lexer, maker, TWO)?];
    let Some(word) = lexer.token_in_line() else { return Ok(SphereCurve::Arc(ends)) };
    if !word.bytes.eq_ignore_ascii_case(b"via") {
        return Err(word.unexpected("`via` or the end of the line"));
    }
    let via = direction(lexer, maker, "a point of three coordinates (`via x y z`)")?;
    maker.charge_points(3, lexer.line())?;
    let [source, target] = ends;
    Ok(SphereCurve::ArcVia(Box::new([source, via, target])))
}

fn polyline(lexer: &mut Lexer<'_>, maker: &mut Maker<'_, Sphere>) -> Result<(), Located> {
    const TWO: &str = "a polyline of two points or more (`polyline x1 y1 z1 x2 y2 z2 ...`)";
    maker.begin_chain();
    for _ in 0..2 {
        let point = direction(lexer, maker, TWO)?;
        maker.extend_chain(point, lexer.line())?;
    }
    while let Some(x) = lexer.next_coordinate_in_line()? {
        let point = direction_from(x, lexer, maker, "all three coordinates of the last point")?;
        maker.extend_chain(point, x.line)?;
    }
    maker.end_chain(Chain::Open)
}

fn direction(
    lexer: &mut Lexer<'_>,
    maker: &mut Maker<'_, Sphere>,
    expected: &str,
) -> Result<Direction, Located> {
    let x = lexer.coordinate_in_line(expected)?;
    direction_from(x, lexer, maker, expected)
}

/// Reads a direction whose first coordinate is read.
#[inline]
fn direction_from(
    x: Token<'_>,
    lexer: &mut Lexer<'_>,
    maker: &mut Maker<'_, Sphere>,
    expected: &str,
) -> Result<Direction, Located> {
    let vector = vector_from(x, lexer, maker, expected)?;
    Ok(Direction::new(vector).expect("a vector of zeros is refused"))
}

fn vector(
    lexer: &mut Lexer<'_>,
    maker: &mut Maker<'_, Sphere>,
    expected: &str,
) -> Result<[Integer; 3], Located> {
    let x = lexer.coordinate_in_line(expected)?;
    vector_from(x, lexer, maker, expected)
}

/// Reads a vector whose first coordinate is read: a positive multiple of it in integers. What it takes on the heap is charged.
fn vector_from(
    x: Token<'_>,
    lexer: &mut Lexer<'_>,
    maker: &mut Maker<'_, Sphere>,
    expected: &str,
) -> Result<[Integer; 3], Located> {
    let (y, z) = (lexer.coordinate_in_line(expected)?, lexer.coordinate_in_line(expected)?);
    let vector = match [number(x)?, number(y)?, number(z)?] {
        [Number::Small(x, 1), Number::Small(y, 1), Number::Small(z, 1)]
            if [x, y, z].into_iter().all(fits) =>
        {
            [x, y, z].map(Integer::from)
        }
        numbers => {
            let coordinates = numbers.map(Number::into_rational);
            maker.budget.charge(wide_bytes(&coordinates)).at_line(x.line)?;
            let weight = coordinates.iter().fold(Integer::ONE, |weight, c| weight.lcm(&c.denominator()));
            coordinates.map(|c| c.numerator() * weight.div_exact(&c.denominator()))
        }
    };
    if vector.iter().all(Integer::is_zero) {
        let why = "the vector is zero, and so it has no direction; give one coordinate that is not 0".into();
        return Err(Fault::Malformed { why }.at(Place::Line(x.line)));
    }
    Ok(vector)
}

/// What the integers of a direction with these coordinates take on the heap at most.
fn wide_bytes(coordinates: &[Rational; 3]) -> u64 {
    let [[x, a], [y, b], [z, c]] = coordinates.each_ref().map(bits);
    heap_bytes([x + b + c, y + a + c, z + a + b])
}
