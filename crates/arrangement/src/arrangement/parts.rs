//! An arrangement taken apart, and put together again by somebody who knows its cells.

use super::build::contractions;
use super::{Arrangement, Violation};
use crate::edit::Stamp;
use crate::topology::Topology;
use crate::traits::{BasicTraits, UMonotoneTraits};
use dcel::{Dcel, FaceId};

/// How many violations are enough to refuse parts.
const ENOUGH: usize = 64;

/// What an arrangement consists of, beside traits and topology.
///
/// What [`Arrangement::from_parts`] asks of them is what [`Arrangement::into_parts`] gives: vertices that stand for sides come first
/// (one in the unbounded plane, none in the bounded plane and on a torus, two on a sphere). The min vertex of edge e is the source of
/// halfedge 2 e.
#[derive(Clone, Debug)]
pub struct Parts<G: BasicTraits> {
    /// The cells.
    pub dcel: Dcel,
    /// For each vertex its point; `None` if it stands for a side.
    pub points: Vec<Option<G::Point>>,
    /// For each vertex, whether it is there only because a curve was cut; for one that stands for a contracted side, also if nothing is
    /// there.
    pub is_artificial: Vec<bool>,
    /// The curves on which edges lie.
    pub curves: Vec<G::UMonotoneCurve>,
    /// For each edge, the position of its curve.
    pub supports: Vec<u32>,
    /// The [corner face](Arrangement::corner_face).
    pub corner_face: FaceId,
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Puts an arrangement together, whatever the parts are.
    ///
    /// Points and curves must be of this surface, which is looked at, too: on a torus, coordinates of points are at least zero and below
    /// the periods, and curves are those of a torus with the same periods; on a sphere, curves are cut at the same identification.
    ///
    /// # Errors
    /// What [`Arrangement::check_valid`] finds; of edges that meet and cells in wrong faces only the first few.
    ///
    /// # Complexity
    /// That of a sweep over edges that do not meet: O(n log n).
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::models::{Linear, LinearTraits};
    /// use splitstar_arrangement::{Arrangement, topology::UnboundedPlane};
    ///
    /// let [p, q] = [[0, 0], [2, 1]].map(Point2::from_i64);
    /// let line = Linear::line(&p, &q).expect("the points are different");
    /// let whole = Arrangement::of_curves(LinearTraits, UnboundedPlane, &[line]);
    /// let mut parts = whole.into_parts();
    /// let again = Arrangement::from_parts(LinearTraits, UnboundedPlane, parts.clone()).expect("nothing was changed");
    /// assert_eq!(again.counts().faces, 2);
    /// parts.supports[0] = 1;
    /// assert!(Arrangement::from_parts(LinearTraits, UnboundedPlane, parts).is_err());
    /// ```
    pub fn from_parts(traits: G, topology: T, parts: Parts<G>) -> Result<Self, Vec<Violation>> {
        let arrangement = Self::of_valid_parts(traits, topology, parts);
        let violations = arrangement.find_violations(ENOUGH);
        if violations.is_empty() { Ok(arrangement) } else { Err(violations) }
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Puts an arrangement together from parts of which the caller knows that they fit, as if they came from [`Arrangement::into_parts`]. Parts from anywhere
    /// else are for [`Arrangement::from_parts`].
    ///
    /// # Panics
    /// In debug builds, if they do not fit. In others the arrangement is not valid then, and may panic later.
    ///
    /// # Complexity
    /// Constant; in debug builds that of [`Arrangement::from_parts`].
    ///
    /// ```
    /// use splitstar_arrangement::{Arrangement, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = Segment::from_i64([[0, 0], [2, 1]]).expect("the ends are different");
    /// let whole = Arrangement::of_curves(SegmentTraits, BoundedPlane, &[segment]);
    /// let again = Arrangement::from_trusted_parts(SegmentTraits, BoundedPlane, whole.clone().into_parts());
    /// assert!(again.is_isomorphic(&whole));
    /// ```
    pub fn from_trusted_parts(traits: G, topology: T, parts: Parts<G>) -> Self {
        let arrangement = Self::of_valid_parts(traits, topology, parts);
        debug_assert_eq!(arrangement.find_violations(ENOUGH), [], "the parts fit");
        arrangement
    }
}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// Puts an arrangement together from parts that are known to fit.
    pub(crate) fn of_valid_parts(traits: G, topology: T, parts: Parts<G>) -> Self {
        let Parts { dcel, points, is_artificial, curves, supports, corner_face } = parts;
        let contractions = contractions(&traits, &topology);
        let stamp = Stamp::fresh();
        Self {
            traits,
            topology,
            dcel,
            points,
            is_artificial,
            curves,
            supports,
            corner_face,
            contractions,
            stamp,
        }
    }

    /// Replaces all cells by others.
    pub(crate) fn set_parts(&mut self, parts: Parts<G>) {
        let Parts { dcel, points, is_artificial, curves, supports, corner_face } = parts;
        self.dcel = dcel;
        self.points = points;
        self.is_artificial = is_artificial;
        self.curves = curves;
        self.supports = supports;
        self.corner_face = corner_face;
        self.stamp = Stamp::fresh();
    }

    /// Takes the arrangement apart.
    pub fn into_parts(self) -> Parts<G> {
        let Self { dcel, points, is_artificial, curves, supports, corner_face, .. } = self;
        Parts { dcel, points, is_artificial, curves, supports, corner_face }
    }
}
