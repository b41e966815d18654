//! Families of curves.
//!
//! Which model implements which refinement of [`crate::traits::BasicTraits`]; all implement
//! [`UMonotoneTraits`](crate::traits::UMonotoneTraits), [`ArrangementTraits`](crate::traits::ArrangementTraits),
//! [`DirectionalTraits`](crate::traits::DirectionalTraits) and [`ApproxTraits`](crate::traits::ApproxTraits), compare to the left and
//! merge.
//!
//! | model | curves | refinements | meet once |
//! |---|---|---|---|
//! | [`SegmentTraits`] | [`Segment`]: the line and both ends | bounded; closed left, right, bottom, top | yes |
//! | [`MinimalSegmentTraits`] | [`MinimalSegment`]: both ends only | bounded; closed left, right, bottom, top | yes |
//! | [`LinearTraits`] | [`Linear`]: segments, rays and lines | open left, right, bottom, top | yes |
//! | [`TorusSegmentTraits`] | [`TorusPath`], cut into [`TorusSegment`]s | identified left to right, bottom to top | yes |
//! | [`GeodesicTraits`] | [`Geodesic`]s, cut into [`GeodesicArc`]s | identified left to right, contracted bottom and top | no |
//! | [`PolycurveTraits`](polycurve::PolycurveTraits) | chains of the curves of another model, polylines among them | those of the other model | no |

pub mod geodesic;
pub mod linear;
pub mod minimal;
pub mod polycurve;
pub mod segments;
mod straight;
pub mod torus;

pub use geodesic::{Geodesic, GeodesicArc, GeodesicError, GeodesicTraits};
pub use linear::{Linear, LinearTraits};
pub use minimal::{MinimalSegment, MinimalSegmentTraits};
pub use segments::{Segment, SegmentTraits};
pub use torus::{TorusError, TorusPath, TorusSegment, TorusSegmentTraits};
