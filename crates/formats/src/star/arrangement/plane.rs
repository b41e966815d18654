//! Segments, rays, lines and polylines of the plane, written and read.

use super::course::Course;
use super::curves::{check_room, make_point, malformed, read_number, read_pair};
use super::family::Base;
use super::model::{LinearArrangement, PolycurveArrangement, StarArrangement};
use super::special::Special;
use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::number::Number;
use crate::base::numerals::put;
use crate::base::scan::Token;
use crate::star::line::Line;
use arrangement::models::{Linear, LinearTraits};
use arrangement::topology::UnboundedPlane;
use arrangement::traits::CurveEnd;
use exact::planar::{Line2, Point2};
use exact::{Integer, Rational};

impl Base for LinearTraits {
    type Surface = UnboundedPlane;
    type Line = Line2;

    const SPECIAL: Special = Special::Infinity;
    const TURNS_BACK: &'static str = "turns back in x";
    const CORNER: &'static str = "at the lower left";

    fn read_surface(_: &mut Line<'_>, _: &mut Budget) -> Result<Self, Located> {
        Ok(Self)
    }

    fn read_point(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Point2, Located> {
        Ok(make_point(read_pair(line, budget, "one of two coordinates")?))
    }

    fn read_pieces(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Vec<Linear>, Located> {
        const KINDS: &str = "`segment`, `ray`, `line` or `polyline`";
        let word = line.expect(KINDS)?;
        match word.bytes {
            b"polyline" => read_polyline(line, budget),
            b"segment" | b"ray" | b"line" => Ok(vec![read_straight(word, line, budget)?]),
            _ => Err(word.unexpected(KINDS)),
        }
    }

    fn put_surface(&self, text: &mut Vec<u8>) {
        put(text, format_args!("surface plane\n"));
    }

    fn put_point(point: &Point2, text: &mut Vec<u8>) {
        put_point(point, text);
    }

    fn put_course(course: &Course<'_, Self>, text: &mut Vec<u8>) {
        let Course { line: first, places: [min, max], bends, .. } = course;
        let Some((_, last)) = bends.last() else { return put_linear(first, [*min, *max], text) };
        text.extend_from_slice(b"polyline");
        if min.is_none() {
            let [dx, dy] = direction(first);
            put(text, format_args!(" infinity {} {}", -dx, -dy));
        }
        min.iter().chain(bends.iter().map(|(bend, _)| bend)).chain(max).for_each(|p| put_point(p, text));
        if max.is_none() {
            let [dx, dy] = direction(last);
            put(text, format_args!(" infinity {dx} {dy}"));
        }
    }

    fn line(curve: &Linear) -> &Line2 {
        curve.supporting_line()
    }

    fn place(curve: &Linear, end: CurveEnd) -> Option<&Point2> {
        curve.ends()[end as usize].as_ref()
    }

    fn goes_on(&self, curve: &Linear, end: CurveEnd) -> bool {
        Self::place(curve, end).is_some()
    }

    fn crossing([l, m]: [&Line2; 2], point: &Point2) -> Option<Point2> {
        Point2::crossing(l, m).filter(|crossing| crossing == point)
    }

    fn of_single(arrangement: LinearArrangement) -> StarArrangement {
        StarArrangement::Linear(arrangement)
    }

    fn of_chains(arrangement: PolycurveArrangement) -> StarArrangement {
        StarArrangement::Polycurves(arrangement)
    }
}

/// Writes a segment, a ray or a line. Its second point, where it does not end, is one direction away from the first.
fn put_linear(line: &Line2, ends: [Option<&Point2>; 2], text: &mut Vec<u8>) {
    let [dx, dy] = direction(line).map(Rational::from);
    let (keyword, from, sign) = match ends {
        [Some(min), Some(max)] => {
            text.extend_from_slice(b"segment");
            put_point(min, text);
            return put_point(max, text);
        }
        [Some(min), None] => ("ray", min.coordinates(), 1),
        [None, Some(max)] => ("ray", max.coordinates(), -1),
        [None, None] => ("line", point_of(line), 1),
    };
    let [dx, dy] = if sign > 0 { [dx, dy] } else { [-dx, -dy] };
    put(text, format_args!("{keyword} {} {} {} {}", from[0], from[1], &from[0] + &dx, &from[1] + &dy));
}

/// The direction of a line to the right, or upwards if it is vertical: integers without a common factor.
fn direction(line: &Line2) -> [Integer; 2] {
    let [a, b, _] = line.coefficients();
    // b is positive, or zero and a negative.
    let divisor = a.gcd(&b);
    [b.div_exact(&divisor), (-a).div_exact(&divisor)]
}

/// Where a line crosses the axis x = 0, or y = 0 if it is vertical.
fn point_of(line: &Line2) -> [Rational; 2] {
    let [a, b, c] = line.coefficients();
    let quotient = |divisor| Rational::new(c.clone(), divisor).expect("a line has a normal");
    if b.is_zero() { [quotient(a), Rational::ZERO] } else { [Rational::ZERO, quotient(b)] }
}

pub(super) fn put_point(point: &Point2, text: &mut Vec<u8>) {
    let [x, y] = point.coordinates();
    put(text, format_args!(" {x} {y}"));
}

fn read_straight(keyword: Token<'_>, line: &mut Line<'_>, budget: &mut Budget) -> Result<Linear, Located> {
    const COORDINATE: &str = "one of four coordinates";
    let p = make_point(read_pair(line, budget, COORDINATE)?);
    let q = make_point(read_pair(line, budget, COORDINATE)?);
    line.end()?;
    let curve = match keyword.bytes {
        b"segment" => Linear::segment(p, q),
        b"ray" => Linear::ray(p, &q),
        _ => Linear::line(&p, &q),
    };
    curve.ok_or_else(|| {
        let why = format!("both points of the {} are the same; give two different ones", keyword.shown());
        malformed(line.number, why)
    })
}

/// Reads what follows `polyline`.
fn read_polyline(line: &mut Line<'_>, budget: &mut Budget) -> Result<Vec<Linear>, Located> {
    let mut word = line.word();
    let mut from_infinity = None;
    if word.is_some_and(|word| word.bytes == b"infinity") {
        from_infinity = Some(read_direction(line, budget)?);
        word = line.word();
    }
    let mut points: Vec<Point2> = Vec::new();
    let mut to_infinity = None;
    while let Some(x) = word {
        if x.bytes == b"infinity" && !points.is_empty() {
            to_infinity = Some(read_direction(line, budget)?);
            line.end()?;
            break;
        }
        let y = line.expect("the second coordinate of the last point")?;
        check_room::<LinearTraits>(points.len(), line, budget)?;
        points.push(make_point([read_number(x, budget)?, read_number(y, budget)?]));
        word = line.word();
    }
    let mut pieces = Vec::with_capacity(points.len() + 1);
    if let (Some(direction), Some(first)) = (from_infinity, points.first()) {
        pieces.push(Linear::ray(first.clone(), &first.translated(&direction)));
    }
    pieces.extend(points.windows(2).map(|pair| Linear::segment(pair[0].clone(), pair[1].clone())));
    if let (Some(direction), Some(last)) = (to_infinity, points.last()) {
        pieces.push(Linear::ray(last.clone(), &last.translated(&direction)));
    }
    if pieces.is_empty() {
        let why = "the polyline has no piece; give it two points, or a point and `infinity dx dy`".into();
        return Err(malformed(line.number, why));
    }
    pieces.into_iter().collect::<Option<Vec<Linear>>>().ok_or_else(|| {
        let why = "a point of the polyline is the same as the one before it; remove one".into();
        malformed(line.number, why)
    })
}

/// Reads what follows `infinity`.
fn read_direction(line: &mut Line<'_>, budget: &mut Budget) -> Result<[Rational; 2], Located> {
    let direction =
        read_pair(line, budget, "one of two coordinates of a direction")?.map(Number::into_rational);
    if direction.iter().all(Rational::is_zero) {
        return Err(malformed(line.number, "the direction is zero; give one that is not".into()));
    }
    Ok(direction)
}
