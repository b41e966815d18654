//! Ends on sides of the parameter space, and chains that come to them.

use super::{GeodesicArc, GeodesicTraits};
use crate::models::polycurve::{ConnectTraits, PieceTraits};
use crate::models::{Geodesic, GeodesicError};
use crate::traits::{
    Along, ArrangementTraits, BasicTraits, BoundaryTraits, ContractedBottomTopTraits, CurveEnd,
    IdentifiedLeftRightTraits, Location, NearBottomTopTraits, NearLeftRightTraits, Piece,
};
use exact::Sign;
use exact::spherical::{Direction, compare_height};
use std::cmp::Ordering;

impl BoundaryTraits for GeodesicTraits {
    #[inline]
    fn end_location(&self, curve: &GeodesicArc, end: CurveEnd) -> Location {
        curve.location(end)
    }
}

impl NearLeftRightTraits for GeodesicTraits {
    /// By the heights of the ends; if they are equal, by the curves beside the side.
    fn compare_v_near_side(&self, a: &GeodesicArc, b: &GeodesicArc, end: CurveEnd) -> Ordering {
        let (p, q) = (a.end(end), b.end(end));
        compare_height(p, q).then_with(|| match a.location(end).u {
            Along::High => self.compare_v_at_u_left(a, b, p),
            Along::Low | Along::Inside => self.compare_v_at_u_right(a, b, p),
        })
    }
}

impl NearBottomTopTraits for GeodesicTraits {
    fn compare_u_near_end(&self, p: &Direction, curve: &GeodesicArc, _: CurveEnd) -> Ordering {
        self.meridian().compare_u_to_half(p, curve.circle())
    }

    fn compare_u_of_ends(
        &self,
        (a, _): (&GeodesicArc, CurveEnd),
        (b, _): (&GeodesicArc, CurveEnd),
    ) -> Ordering {
        self.meridian().compare_u_of_halves(a.circle(), b.circle())
    }
}

impl ContractedBottomTopTraits for GeodesicTraits {
    fn contraction_bottom_top(&self, side: CurveEnd) -> Direction {
        match side {
            CurveEnd::Min => Direction::SOUTH,
            CurveEnd::Max => Direction::NORTH,
        }
    }

    #[inline]
    fn contracted_bottom_top(&self, p: &Direction) -> Option<CurveEnd> {
        match p.pole_sign() {
            Sign::Negative => Some(CurveEnd::Min),
            Sign::Zero => None,
            Sign::Positive => Some(CurveEnd::Max),
        }
    }
}

impl IdentifiedLeftRightTraits for GeodesicTraits {
    #[inline]
    fn is_on_left_right(&self, p: &Direction) -> bool {
        self.meridian().contains(p)
    }

    #[inline]
    fn compare_v_on_left_right(&self, p: &Direction, q: &Direction) -> Ordering {
        compare_height(p, q)
    }
}

impl PieceTraits for GeodesicTraits {
    fn is_joint_allowed(&self, p: &Direction) -> bool {
        self.is_interior(p)
    }

    /// Near an end on a side, arcs are one curve if they come from the same side along the same circle, or half meridian.
    fn is_foldback_on_side(&self, a: &GeodesicArc, b: &GeodesicArc, end: CurveEnd) -> bool {
        a.location(end) == b.location(end) && a.circle() == b.circle()
    }

    /// An end at a pole has the longitude of its half meridian. What ends on the right side is behind all points of the interior.
    fn compare_u_to_end(&self, p: &Direction, curve: &GeodesicArc, end: CurveEnd) -> Option<Ordering> {
        let location = curve.location(end);
        Some(match (location.u, location.v) {
            (Along::Low, _) => Ordering::Greater,
            (Along::High, _) => Ordering::Less,
            (Along::Inside, Along::Inside) => self.compare_u(p, curve.end(end)),
            (Along::Inside, _) => self.compare_u_near_end(p, curve, end),
        })
    }

    /// Once around the sphere, an arc has its ends in one point.
    fn direction(&self, curve: &GeodesicArc) -> Option<bool> {
        Some(curve.is_directed_right())
    }
}

impl ConnectTraits for GeodesicTraits {
    /// Two points are connected by the shorter arc. Antipodal points are not: they are appended as points, so that a chain in which they follow each other
    /// is not connected.
    fn connect(&self, source: &Direction, target: &Direction, out: &mut Vec<Piece<Direction, GeodesicArc>>) {
        match Geodesic::arc(source.clone(), target.clone()) {
            Ok(arc) => self.make_u_monotone(&arc, out),
            Err(GeodesicError::EndsEqual) => {}
            Err(_) => out.extend([source, target].map(|p| Piece::Point(p.clone()))),
        }
    }
}
