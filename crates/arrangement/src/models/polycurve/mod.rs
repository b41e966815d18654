//! Polycurves: chains of curves of another model. With segments, these are polylines.
//!
//! | layer | files | role |
//! |---|---|---|
//! | what the other model must tell | `piece` | where chains may have joints; what connects two points |
//! | curves | `chain`, `curve`, `cut` | u-monotone chains; general polycurves, cut into chains as they are made |
//! | traits | `basic`, `meet`, `boundary` | predicates, intersections, and what is known of ends |
//!
//! # How it works
//! 1. A u-monotone chain is a list of u-monotone pieces, each of which begins where the one before it ends. Either no piece of it
//!    is vertical, or all are. So the pieces of one chain are in lexicographic order, and so are their joints.
//! 2. A polycurve is cut where it turns back along u, where it begins or ceases to be vertical, and on the sides of the parameter
//!    space. These cuts are artificial: results do not show them. So is the start of a closed polycurve. The tip of a foldback,
//!    where it returns upon itself, is an end like others, and not artificial.
//!    On a side, what returns has to come back in the same place of the parameter space to be a foldback.
//! 3. Joints inside a chain are no vertices of an arrangement.
//! 4. A question about a chain at a point is one about a piece, which is found by binary search. Two chains are compared along
//!    the u-range that they share by walking along both.
//!
//! Chains share their pieces: a copy costs nothing.

mod basic;
mod boundary;
mod chain;
mod curve;
mod cut;
mod meet;
mod piece;

pub use chain::Chain;
pub use curve::{Polycurve, PolycurveError};
pub use piece::{ConnectTraits, PieceTraits};

/// Chains of curves of the model `S`.
///
/// It has every refinement that `S` has. It is directional, whether `S` is or not: a chain runs as the polycurve that it was cut
/// from.
///
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::Arrangement;
/// use splitstar_arrangement::models::{SegmentTraits, polycurve::PolycurveTraits};
/// use splitstar_arrangement::topology::BoundedPlane;
///
/// let traits = PolycurveTraits::new(SegmentTraits);
/// let polyline = |vertices: &[[i64; 2]]| traits.make_polyline(vertices.iter().copied().map(Point2::from_i64));
/// let triangle = polyline(&[[0, 0], [4, 0], [2, 3], [0, 0]])?;
/// let zigzag = polyline(&[[0, 1], [1, 2], [2, 1], [3, 2], [4, 1]])?;
/// let arrangement = Arrangement::of_curves(traits, BoundedPlane, [&triangle, &zigzag]);
/// // Both ends of the zigzag, and two crossings: corners and joints are no vertices.
/// assert_eq!(arrangement.counts().vertices, 4);
/// assert_eq!(arrangement.counts().faces, 3);
/// # Ok::<(), splitstar_arrangement::models::polycurve::PolycurveError>(())
/// ```
///
/// # Complexity
/// Every predicate takes a predicate of `S`, and O(log m) comparisons of points for chains of m pieces.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct PolycurveTraits<S> {
    pieces: S,
}

impl<S> PolycurveTraits<S> {
    /// Chains of the curves of a model.
    pub fn new(pieces: S) -> Self {
        Self { pieces }
    }

    /// The traits of the pieces.
    pub fn inner(&self) -> &S {
        &self.pieces
    }
}
