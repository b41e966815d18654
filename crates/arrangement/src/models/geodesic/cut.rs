//! Curves cut into u-monotone arcs: at the identification, and at the poles.

use super::curve::Kind;
use super::{Geodesic, GeodesicArc, GeodesicTraits};
use crate::traits::{Along, ArrangementTraits, BasicTraits, CurveEnd, Location, Piece};
use exact::Sign;
use exact::spherical::{Direction, GreatCircle, compare_height, rises_at};

type ArcPiece = Piece<Direction, GeodesicArc>;

const LEFT: Location = Location { u: Along::Low, v: Along::Inside };
const RIGHT: Location = Location { u: Along::High, v: Along::Inside };

/// The end of a piece: where it is on the sphere and in the parameter space, and whether it is an end of the curve.
struct End {
    point: Direction,
    location: Location,
    is_real: bool,
}

impl ArrangementTraits for GeodesicTraits {
    type Curve = Geodesic;

    /// An arc is cut where it crosses the identification, and at poles: into three pieces at most.
    ///
    /// A great circle without ends has no end that is not artificial.
    fn make_u_monotone(&self, curve: &Geodesic, out: &mut Vec<ArcPiece>) {
        match curve.kind() {
            Kind::Point(p) => out.push(Piece::Point(p.clone())),
            Kind::Circle(circle) if circle.is_meridian() => {
                for half in [circle.clone(), circle.opposite()] {
                    let is_up = half == *circle;
                    let [south, north] = CurveEnd::BOTH.map(|end| self.pole_of(&half, end, false));
                    out.push(piece(half, [south, north], is_up));
                }
            }
            Kind::Circle(circle) => {
                let (upper, is_right) = upper(circle);
                let ends = [LEFT, RIGHT].map(|side| self.cut_of(&upper, side));
                out.push(piece(upper, ends, is_right));
            }
            Kind::Arc { circle, source, target } if circle.is_meridian() => {
                self.cut_meridian(circle, source, target, out);
            }
            Kind::Arc { circle, source, target } => {
                let (upper, is_right) = upper(circle);
                let ends = if is_right { [source, target] } else { [target, source] };
                self.cut_to_right(upper, ends, is_right, out);
            }
        }
    }
}

/// The same circle, run through to the right, and whether it was so before.
fn upper(circle: &GreatCircle) -> (GreatCircle, bool) {
    let is_right = circle.sign(2).is_positive();
    (if is_right { circle.clone() } else { circle.opposite() }, is_right)
}

fn piece(circle: GreatCircle, ends: [End; 2], is_directed_right: bool) -> ArcPiece {
    let is_artificial = ends.each_ref().map(|end| !end.is_real);
    let places = ends.map(|end| (end.point, end.location));
    Piece::Curve { curve: GeodesicArc::new(circle, places, is_directed_right), is_artificial }
}

impl GeodesicTraits {
    /// Where a circle that is run through to the right crosses the identification, as an end on one of the sides.
    fn cut_of(&self, upper: &GreatCircle, location: Location) -> End {
        // With normals n and d x z, the crossing is d (n . z) - z (n . d): on the half meridian of d.
        let point =
            Direction::crossing(upper, self.meridian.circle()).expect("only one of them is a meridian");
        End { point, location, is_real: false }
    }

    /// Cuts an arc from the left to the right end around a circle that is no meridian.
    fn cut_to_right(
        &self,
        circle: GreatCircle,
        ends: [&Direction; 2],
        is_right: bool,
        out: &mut Vec<ArcPiece>,
    ) {
        let is_on = ends.map(|p| self.meridian.contains(p));
        let end = |i: usize, side| {
            let location = if is_on[i] { side } else { Location::INTERIOR };
            End { point: ends[i].clone(), location, is_real: true }
        };
        let (min, max) = (end(0, LEFT), end(1, RIGHT));
        let is_whole = is_on != [false; 2] || self.compare_u(ends[0], ends[1]).is_lt();
        if is_whole {
            out.push(piece(circle, [min, max], is_right));
            return;
        }
        let before = piece(circle.clone(), [min, self.cut_of(&circle, RIGHT)], is_right);
        let left = self.cut_of(&circle, LEFT);
        let after = piece(circle, [left, max], is_right);
        out.extend(if is_right { [before, after] } else { [after, before] });
    }

    /// A pole as an end of a half meridian.
    fn pole_of(&self, half: &GreatCircle, end: CurveEnd, is_real: bool) -> End {
        let (point, v) = match end {
            CurveEnd::Min => (Direction::SOUTH, Along::Low),
            CurveEnd::Max => (Direction::NORTH, Along::High),
        };
        End { point, location: Location { u: self.side_of_half(half), v }, is_real }
    }

    /// On which side the half meridian is along which a circle goes up.
    fn side_of_half(&self, half: &GreatCircle) -> Along {
        if half == self.meridian.circle() { Along::Low } else { Along::Inside }
    }

    /// Cuts an arc of a meridian, half by half.
    fn cut_meridian(
        &self,
        circle: &GreatCircle,
        source: &Direction,
        target: &Direction,
        out: &mut Vec<ArcPiece>,
    ) {
        // At a pole, the next half is what counts: after the south pole it goes up.
        let mut is_up = match rises_at(source, circle) {
            Sign::Zero => source.pole_sign().is_negative(),
            sign => sign.is_positive(),
        };
        let mut start = source.clone();
        let mut is_start_real = true;
        // Once around, there are three halves, the first of which is the last.
        for round in 0..3 {
            let half = if is_up { circle.clone() } else { circle.opposite() };
            let exit = if is_up { CurveEnd::Max } else { CurveEnd::Min };
            let pole = self.pole_of(&half, exit, false);
            // In the first half, a target before the start, or at it, is met when the curve comes round.
            let is_ahead = |order: std::cmp::Ordering| if is_up { order.is_lt() } else { order.is_gt() };
            let is_target_here = (*target == pole.point || rises_at(target, &half).is_positive())
                && (round > 0 || is_ahead(compare_height(&start, target)));
            let place = |point: Direction, is_real| match point.pole_sign() {
                Sign::Negative => self.pole_of(&half, CurveEnd::Min, is_real),
                Sign::Positive => self.pole_of(&half, CurveEnd::Max, is_real),
                Sign::Zero => {
                    let location = Location { u: self.side_of_half(&half), v: Along::Inside };
                    End { point, location, is_real }
                }
            };
            let from = place(start, is_start_real);
            let to = if is_target_here { place(target.clone(), true) } else { pole };
            start = to.point.clone();
            is_start_real = false;
            let ends = if is_up { [from, to] } else { [to, from] };
            out.push(piece(half, ends, is_up));
            if is_target_here {
                return;
            }
            is_up = !is_up;
        }
    }
}
