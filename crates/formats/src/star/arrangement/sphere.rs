//! Geodesic arcs and great circles of the sphere, and chains of arcs, written and read.

use super::around::Around;
use super::course::Course;
use super::curves::{check_room, malformed, read_number, read_pair};
use super::family::Base;
use super::model::{SphereArrangement, SpherePolycurveArrangement, StarArrangement};
use super::special::Special;
use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::number::Number;
use crate::base::numerals::put;
use crate::base::scan::Token;
use crate::star::line::Line;
use arrangement::models::{Geodesic, GeodesicArc, GeodesicError, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::{
    Along, ArrangementTraits, BasicTraits, CurveEnd, IdentifiedLeftRightTraits, Piece,
};
use dcel::{FaceId, VertexId};
use exact::spherical::{Direction, GreatCircle};
use exact::{Integer, Rational, Sign};

const SOUTH: VertexId = VertexId(0);
const NORTH: VertexId = VertexId(1);

const COORDINATE: &str = "one of three coordinates";

impl Base for GeodesicTraits {
    type Surface = Sphere;
    type Line = GreatCircle;

    const SPECIAL: Special = Special::Poles([None; 2]);
    const TURNS_BACK: &'static str = "turns back in longitude";
    const CORNER: &'static str = "at the south pole, next to the identification arc";

    /// The direction of the identification arc.
    fn read_surface(line: &mut Line<'_>, budget: &mut Budget) -> Result<Self, Located> {
        const HORIZONTAL: &str = "one of two coordinates of the identification arc";
        let [x, y] = read_pair(line, budget, HORIZONTAL)?.map(Number::into_rational);
        let direction = Direction::from_rationals(&[x, y, Rational::ZERO]);
        let traits = direction.and_then(|direction| {
            let [x, y, _] = direction.coordinates();
            Self::with_identification([x, y])
        });
        traits.ok_or_else(|| {
            malformed(
                line.number,
                "the direction of the identification arc is zero; give one that is not".into(),
            )
        })
    }

    fn read_point(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Direction, Located> {
        read_direction(line.expect(COORDINATE)?, line, budget)
    }

    fn read_pieces(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Vec<GeodesicArc>, Located> {
        const KINDS: &str = "`arc`, `circle` or `polyline`";
        let word = line.expect(KINDS)?;
        match word.bytes {
            b"circle" => {
                let normal = read_normal(line, budget)?;
                line.end()?;
                Ok(vec![one_piece(self, &Geodesic::circle(normal), line)?])
            }
            b"arc" => {
                let (pieces, next) = read_arcs(self, line, budget, 1)?;
                match next {
                    None => Ok(pieces),
                    Some(word) => Err(word.unexpected("`around` or the end of the line")),
                }
            }
            b"polyline" => Ok(read_arcs(self, line, budget, usize::MAX)?.0),
            _ => Err(word.unexpected(KINDS)),
        }
    }

    fn special_of(&self, point: &Direction) -> Option<VertexId> {
        match point.pole_sign() {
            Sign::Negative => Some(SOUTH),
            Sign::Zero => None,
            Sign::Positive => Some(NORTH),
        }
    }

    /// Nothing is between the north pole and the uppermost vertex on the identification arc, nor, if there is none, between it and the corner.
    fn face_around(&self, v: VertexId, around: &Around<'_, Self>) -> FaceId {
        let vertices = around.points.iter().enumerate().skip(Self::SPECIAL.count());
        let on_arc = vertices.filter_map(|(v, point)| Some((VertexId::new(v), point.as_ref()?)));
        let on_arc = on_arc.filter(|(_, point)| self.is_on_left_right(point));
        let top = on_arc.max_by(|(_, p), (_, q)| self.compare_v_on_left_right(p, q));
        match top.filter(|_| v == NORTH) {
            Some((top, point)) => face_above(self, top, point, around),
            None => FaceId(0),
        }
    }

    fn put_surface(&self, text: &mut Vec<u8>) {
        let [x, y, _] = self.identification().coordinates();
        put(text, format_args!("surface sphere {x} {y}\n"));
    }

    fn put_point(point: &Direction, text: &mut Vec<u8>) {
        put_vector(&point.coordinates(), text);
    }

    /// A circle that begins and ends on the identification arc has no ends.
    fn put_course(course: &Course<'_, Self>, text: &mut Vec<u8>) {
        let Course { line, places: [min, max], bends, .. } = course;
        let (Some(mut from), Some(max)) = (*min, *max) else { unreachable!("arcs have two ends") };
        if bends.is_empty() && from == max {
            text.extend_from_slice(b"circle");
            return put_vector(&line.coordinates(), text);
        }
        text.extend_from_slice(if bends.is_empty() { b"arc" } else { b"polyline" });
        Self::put_point(from, text);
        let mut circle = *line;
        for (to, next) in bends.iter().copied().chain([(max, *line)]) {
            Self::put_point(to, text);
            if GreatCircle::through(from, to).as_ref() != Some(circle) {
                text.extend_from_slice(b" around");
                put_vector(&circle.coordinates(), text);
            }
            (from, circle) = (to, next);
        }
    }

    fn line(curve: &GeodesicArc) -> &GreatCircle {
        curve.circle()
    }

    fn place(curve: &GeodesicArc, end: CurveEnd) -> Option<&Direction> {
        Some(curve.end(end))
    }

    /// Not on a pole, nor on the right side.
    fn goes_on(&self, curve: &GeodesicArc, end: CurveEnd) -> bool {
        let location = curve.location(end);
        location.v == Along::Inside && location.u != Along::High
    }

    fn crossing([m, n]: [&GreatCircle; 2], point: &Direction) -> Option<Direction> {
        let mut crossings = [(m, n), (n, m)].into_iter().filter_map(|(m, n)| Direction::crossing(m, n));
        crossings.find(|crossing| crossing == point)
    }

    fn of_single(arrangement: SphereArrangement) -> StarArrangement {
        StarArrangement::Sphere(arrangement)
    }

    fn of_chains(arrangement: SpherePolycurveArrangement) -> StarArrangement {
        StarArrangement::SpherePolycurves(arrangement)
    }
}

/// Reads arcs that follow one another, up to so many of them, and the word behind them.
fn read_arcs<'a>(
    traits: &GeodesicTraits,
    line: &mut Line<'a>,
    budget: &mut Budget,
    limit: usize,
) -> Result<(Vec<GeodesicArc>, Option<Token<'a>>), Located> {
    let mut from = read_direction(line.expect(COORDINATE)?, line, budget)?;
    let mut pieces = Vec::new();
    let mut next = Some(line.expect(COORDINATE)?);
    while pieces.len() < limit
        && let Some(first) = next
    {
        check_room::<GeodesicTraits>(pieces.len(), line, budget)?;
        let to = read_direction(first, line, budget)?;
        next = line.word();
        let arc = match next {
            Some(word) if word.bytes == b"around" => {
                let normal = read_normal(line, budget)?;
                next = line.word();
                Geodesic::arc_around(from, to.clone(), normal)
            }
            _ => Geodesic::arc(from, to.clone()),
        };
        let arc = arc.map_err(|error| malformed(line.number, sentence(error).into()))?;
        pieces.push(one_piece(traits, &arc, line)?);
        from = to;
    }
    Ok((pieces, next))
}

/// The face above a vertex on the identification arc, if nothing on that arc is above it.
fn face_above(
    traits: &GeodesicTraits,
    v: VertexId,
    point: &Direction,
    around: &Around<'_, GeodesicTraits>,
) -> FaceId {
    if let Some(face) = around.face_of_isolated(v) {
        return face;
    }
    // The uppermost of the arcs that leave the vertex to the right, or else of those that come to it from the left: the face above it is
    // that on the left of the halfedge from its min end.
    let uppermost = |end: CurveEnd| {
        let side = if end == CurveEnd::Min { Along::Low } else { Along::High };
        let arcs = around.leaving(v).filter(|h| h.is_even() == (end == CurveEnd::Min)).filter_map(|h| {
            let pieces = (around.pieces)(h.edge());
            let arc = if end == CurveEnd::Min { pieces.first() } else { pieces.last() };
            let ends_here = |arc: &&GeodesicArc| {
                !arc.is_meridian() && arc.location(end).u == side && arc.end(end) == point
            };
            arc.filter(ends_here).map(|arc| (arc, h))
        });
        let uppermost = arcs.max_by(|(a, _), (b, _)| match end {
            CurveEnd::Min => traits.compare_v_at_u_right(a, b, point),
            CurveEnd::Max => traits.compare_v_at_u_left(a, b, point),
        });
        uppermost.map(|(_, h)| if h.is_even() { h } else { h.twin() })
    };
    let found = uppermost(CurveEnd::Min).or_else(|| uppermost(CurveEnd::Max));
    // Else nothing but an arc from below is there.
    found.or_else(|| around.leaving(v).next()).map_or(FaceId(0), |h| around.face_of(h))
}

fn put_vector(vector: &[Integer; 3], text: &mut Vec<u8>) {
    let [x, y, z] = vector;
    put(text, format_args!(" {x} {y} {z}"));
}

/// Reads a direction, of whose coordinates the first word has been read.
fn read_direction(first: Token<'_>, line: &mut Line<'_>, budget: &mut Budget) -> Result<Direction, Located> {
    let x = read_number(first, budget)?;
    let [y, z] = read_pair(line, budget, COORDINATE)?;
    let direction = match [x, y, z] {
        [Number::Small(x, 1), Number::Small(y, 1), Number::Small(z, 1)] => Direction::from_i64([x, y, z]),
        coordinates => Direction::from_rationals(&coordinates.map(Number::into_rational)),
    };
    direction.ok_or_else(|| malformed(line.number, "the direction is zero; give one that is not".into()))
}

/// Reads the normal of a great circle.
fn read_normal(line: &mut Line<'_>, budget: &mut Budget) -> Result<GreatCircle, Located> {
    let normal = read_direction(line.expect("one of three coordinates of a normal")?, line, budget)?;
    Ok(GreatCircle::new(&normal.vector()).expect("a direction is not zero"))
}

/// What is wrong with an arc.
fn sentence(error: GeodesicError) -> &'static str {
    match error {
        GeodesicError::EndsEqual => "both ends of the arc are the same; give two different ones",
        GeodesicError::EndsAntipodal => {
            "the ends of the arc are opposite to each other; add `around` and the normal of its circle"
        }
        _ => "an end of the arc is not on the circle around its normal; correct one of them",
    }
}

/// The arc that a curve is, which must not be cut.
fn one_piece(traits: &GeodesicTraits, curve: &Geodesic, line: &Line<'_>) -> Result<GeodesicArc, Located> {
    let mut pieces = Vec::new();
    traits.make_u_monotone(curve, &mut pieces);
    match (pieces.pop(), pieces.is_empty()) {
        (Some(Piece::Curve { curve, .. }), true) => Ok(curve),
        _ => {
            let why = "the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own";
            Err(malformed(line.number, why.into()))
        }
    }
}
