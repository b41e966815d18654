//! Proximity of polytopes: relation, separation distance and penetration depth, exactly.
//!
//! Two polytopes P and Q meet, with Q moved by s, exactly if s lies in the Minkowski sum M of P and the reflection of Q. So
//! questions about a placement are questions about one point and one convex polytope.
//!
//! | module | what it does |
//! |---|---|
//! | `relative` | [`RelativePlacement`]: keeps M, and answers for any translation |
//! | `cells`, `grid` | M in flat arrays; where a walk over its facets begins |
//! | `voronoi` | the closest feature of M, by a walk over its Voronoi regions |
//! | `hierarchy` | the nearest facet plane, by branch and bound |
//! | `pair` | [`Pair`]: the same answers without M, for Q turned by any exact rotation |
//! | `bodies`, `simplex`, `expansion` | its parts: extreme vertices, the closest point, a hull that grows where it must |
//! | `contact` | the points and the features where two faces meet |
//! | `motion` | [`Motion`]: one placement after the other |

mod answer;
mod bodies;
mod cells;
mod contact;
mod expansion;
mod grid;
mod hierarchy;
mod motion;
mod pair;
mod relative;
mod simplex;
mod translation;
mod voronoi;

pub use answer::{DirectionalPenetration, Feature, Penetration, Relation, Separation, Witness};
pub use motion::{Motion, Placement};
pub use pair::Pair;
pub use relative::RelativePlacement;
pub use translation::Translation;

pub use polytope::{FacetId, HalfedgeId, VertexId};

#[cfg(test)]
mod tests;
