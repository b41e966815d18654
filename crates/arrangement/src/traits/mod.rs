//! The geometry traits: what the engine asks of a family of curves.
//!
//! The hierarchy is that of the thesis (2.5); derived operations are provided methods.
//!
//! | trait | what it adds |
//! |---|---|
//! | [`BasicTraits`] | points, u-monotone curves, order and sides; enough for curves with disjoint interiors |
//! | [`UMonotoneTraits`] | intersections, splitting, merging |
//! | [`ArrangementTraits`] | general curves, cut into u-monotone pieces |
//! | [`DirectionalTraits`] | source and target |
//! | [`ApproxTraits`] | floats, for pictures |
//! | [`LandmarkTraits`] | points near floats, from where to start |
//! | [`BoundedTraits`] | nothing: a promise that curves have two end points in the interior |
//! | [`ClosedLeftRightTraits`], [`ClosedBottomTopTraits`] | nothing: a promise that points on closed sides are points like others |
//! | [`BoundaryTraits`] | ends on sides of the parameter space; refined by kind and axis of the side |

mod basic;
mod boundary;
mod landmark;
mod location;
mod meeting;

pub use basic::BasicTraits;
pub use boundary::{
    BoundaryTraits, BoundedTraits, ClosedBottomTopTraits, ClosedLeftRightTraits, ContractedBottomTopTraits,
    ContractedLeftRightTraits, IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, NearBottomTopTraits,
    NearLeftRightTraits, OpenBottomTopTraits, OpenLeftRightTraits,
};
pub use landmark::LandmarkTraits;
pub use location::{Along, CurveEnd, Location, SideKind, Sides};
pub use meeting::{
    ApproxTraits, ArrangementTraits, DirectionalTraits, Intersection, Meeting, Multiplicity, Piece,
    UMonotoneTraits, Window,
};
