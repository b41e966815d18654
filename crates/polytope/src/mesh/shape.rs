//! What the corners of a facet span: a plane, only a line, or more than a plane.

use crate::measure::twice_area;
use crate::polytope::nonzero_axis;
use exact::{Point3, Rational, Sign, Vector3, predicate};

/// What the corners of a facet span.
pub(super) enum Shape {
    Plane(FacetPlane),
    /// A line or a point: the facet has no area, whatever its cycle.
    Line,
    /// Two corners only.
    Edge,
    /// They do not lie in one plane.
    Bent {
        /// A corner off the plane of the first three corners that span one.
        vertex: u32,
        squared_distance: Rational,
    },
}

pub(super) struct FacetPlane {
    /// To the side from which the area of the facet is positive.
    pub(super) normal: Vector3,
    /// The place in the cycle of the first of three consecutive corners that are not collinear.
    pub(super) witness: u32,
    /// Whether all corners turn left, seen from that side.
    pub(super) corners_turn_left: bool,
}

impl Shape {
    /// Looks at a facet of two corners or more: convex or not, with straight corners or without.
    pub(super) fn of(points: &[Point3], cycle: &[u32]) -> Self {
        let k = cycle.len();
        let point = |i: usize| &points[cycle[i % k] as usize];
        let side = |i: usize| point(i).direction_to(point(i + 1));
        let turn = |i: usize| side(i).cross(&side(i + 1));
        if k == 2 {
            return Self::Edge;
        }
        if k == 3 {
            let normal = turn(0);
            let plane = FacetPlane { normal, witness: 0, corners_turn_left: true };
            return if plane.normal.is_zero() { Self::Line } else { Self::Plane(plane) };
        }
        let first = (0..k).map(|i| (i, turn(i))).find(|(_, normal)| !normal.is_zero());
        let Some((witness, plane)) = first else { return Self::Line };
        let on = point(0);
        let off = (1..k).find(|&i| predicate::plane_side(&plane, on, point(i)) != Sign::Zero);
        if let Some(i) = off {
            let squared_distance = squared_distance(&plane, on, point(i));
            return Self::Bent { vertex: cycle[i], squared_distance };
        }
        let axis = nonzero_axis(&plane);
        let corners_turn_left = (0..k).all(|i| turn(i).sign(axis) == plane.sign(axis));
        let outwards = corners_turn_left || area_sign(points, cycle, axis) == plane.sign(axis);
        let normal = if outwards { plane } else { -plane };
        Self::Plane(FacetPlane { normal, witness: witness as u32, corners_turn_left })
    }
}

/// The sign of the area of a planar cycle, seen along an axis.
pub(super) fn area_sign(points: &[Point3], cycle: &[u32], axis: usize) -> Sign {
    let corners: Vec<&Point3> = cycle.iter().map(|&v| &points[v as usize]).collect();
    twice_area(&corners, axis).sign()
}

/// The square of the distance of `p` from the plane through `on` with that normal.
pub(crate) fn squared_distance(normal: &Vector3, on: &Point3, p: &Point3) -> Rational {
    let height = (0..3).fold(Rational::from(0), |sum, axis| {
        sum + (p.coordinate(axis) - on.coordinate(axis)) * Rational::from(normal.coordinate(axis))
    });
    let square = height.clone() * height;
    square.checked_div(&Rational::from(normal.dot(normal))).expect("a normal is not zero")
}
