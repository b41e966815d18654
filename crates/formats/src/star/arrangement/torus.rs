//! Straight paths on a flat torus, written and read.

use super::course::Course;
use super::curves::{check_room, malformed, read_number, read_pair};
use super::family::Base;
use super::model::{StarArrangement, TorusArrangement, TorusPolycurveArrangement};
use super::plane::put_point;
use super::special::Special;
use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::number::Number;
use crate::base::numerals::put;
use crate::star::line::Line;
use arrangement::models::{LinearTraits, TorusSegment, TorusSegmentTraits};
use arrangement::topology::FlatTorus;
use arrangement::traits::{ArrangementTraits, CurveEnd, Piece};
use exact::planar::{Line2, Point2};
use exact::{Rational, Sign};

impl Base for TorusSegmentTraits {
    type Surface = FlatTorus;
    type Line = Line2;

    const SPECIAL: Special = Special::Nothing;
    const TURNS_BACK: &'static str = LinearTraits::TURNS_BACK;
    const CORNER: &'static str = LinearTraits::CORNER;

    fn read_surface(line: &mut Line<'_>, budget: &mut Budget) -> Result<Self, Located> {
        let period = read_pair(line, budget, "one of two periods")?.map(Number::into_rational);
        Self::new(period).map_err(|error| malformed(line.number, format!("{error}; give one that is")))
    }

    /// Coordinates must be below the periods.
    fn read_point(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Point2, Located> {
        let point = read_pair(line, budget, "one of two coordinates")?.map(Number::into_rational);
        let is_below =
            |(value, period): (&Rational, &Rational)| value.sign() != Sign::Negative && value < period;
        if !point.iter().zip(self.period()).all(is_below) {
            let why = "a coordinate is negative, or not below its period; add or subtract periods".into();
            return Err(malformed(line.number, why));
        }
        Ok(Point2::from_rationals(&point))
    }

    /// A path: its pieces, one for each displacement.
    fn read_pieces(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Vec<TorusSegment>, Located> {
        const PATH: &str = "`path`, the only curve on a torus,";
        const LENGTH: &str = "one of two lengths along x and y";
        let word = line.expect(PATH)?;
        if word.bytes != b"path" {
            return Err(word.unexpected(PATH));
        }
        let mut start = self.read_point(line, budget)?;
        let mut pieces = Vec::new();
        let mut next = Some(line.expect(LENGTH)?);
        while let Some(dx) = next {
            check_room::<Self>(pieces.len(), line, budget)?;
            let dx = read_number(dx, budget)?;
            let dy = read_number(line.expect(LENGTH)?, budget)?;
            let displacement = [dx, dy].map(Number::into_rational);
            pieces.push(path_piece(self, &start, &displacement, line.number)?);
            next = line.word();
            if next.is_some() {
                start = self.point(&start.translated(&displacement));
            }
        }
        Ok(pieces)
    }

    fn put_surface(&self, text: &mut Vec<u8>) {
        let [p, q] = self.period();
        put(text, format_args!("surface torus {p} {q}\n"));
    }

    fn put_point(point: &Point2, text: &mut Vec<u8>) {
        put_point(point, text);
    }

    /// The vertex where it begins, and how far each piece goes.
    fn put_course(course: &Course<'_, Self>, text: &mut Vec<u8>) {
        text.extend_from_slice(b"path");
        course.start.iter().for_each(|p| put_point(p, text));
        let [min, max] = &course.places;
        let places = || min.iter().chain(course.bends.iter().map(|(bend, _)| bend)).chain(max);
        for (from, to) in places().zip(places().skip(1)) {
            let ([x, y], [to_x, to_y]) = (from.coordinates(), to.coordinates());
            put(text, format_args!(" {} {}", to_x - x, to_y - y));
        }
    }

    fn line(curve: &TorusSegment) -> &Line2 {
        curve.supporting_line()
    }

    fn place(curve: &TorusSegment, end: CurveEnd) -> Option<&Point2> {
        Some(curve.place(end))
    }

    /// Not on the right or the upper side.
    fn goes_on(&self, curve: &TorusSegment, end: CurveEnd) -> bool {
        curve.place(end) == curve.point(end)
    }

    fn crossing(lines: [&Line2; 2], point: &Point2) -> Option<Point2> {
        LinearTraits::crossing(lines, point)
    }

    fn of_single(arrangement: TorusArrangement) -> StarArrangement {
        StarArrangement::Torus(arrangement)
    }

    fn of_chains(arrangement: TorusPolycurveArrangement) -> StarArrangement {
        StarArrangement::TorusPolycurves(arrangement)
    }
}

/// A path that must not leave the rectangle.
fn path_piece(
    traits: &TorusSegmentTraits,
    start: &Point2,
    displacement: &[Rational; 2],
    line: u32,
) -> Result<TorusSegment, Located> {
    let fits = displacement.iter().zip(traits.period()).all(|(length, period)| length.abs() <= *period);
    let mut pieces = Vec::new();
    if fits && let Ok(path) = traits.path(start, displacement) {
        traits.make_u_monotone(&path, &mut pieces);
    }
    match (pieces.pop(), pieces.is_empty()) {
        (Some(Piece::Curve { curve, .. }), true) => Ok(curve),
        (Some(Piece::Point(_)), _) => {
            Err(malformed(line, "a piece of the path has no length; remove it".into()))
        }
        _ => {
            let why = "the path leaves the rectangle of the periods; cut it there into paths of their own";
            Err(malformed(line, why.into()))
        }
    }
}
