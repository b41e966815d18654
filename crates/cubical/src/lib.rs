//! Planar arrangements on the six sides of a cube, stitched to one map of all directions.
//!
//! Geodesic arcs, great circles and points of the sphere are projected from the center to the sides of the cube [-1, 1]^3. There they are segments and
//! points of six ordinary planar arrangements. Each has the four edges of its square besides, so that it has something to be stitched by even if
//! nothing else is there. The map knows which vertices and edges of two sides are the same, which of them are *real*, and which are *artificial*:
//! there only because the sphere was cut along the edges of the cube. Faces of the sphere are classes of faces of the sides, joined across artificial edges.
//!
//! It knows nothing of polytopes: environment maps, horizons, or maps of the Earth may be kept in it as well.
//!
//! | module | what |
//! |---|---|
//! | `pieces` | [`CubicalPieces`]: arcs, circles and points, cut along the edges of the cube |
//! | `map` | [`CubicalArrangement`]: six arrangements, and how they are next to one another |
//! | `build`, `stitch` | how it is made: six sweeps, then one walk along the edges of the cube |
//! | `connected` | the arrangement of a side whose cells are known, without a sweep |
//! | `view` | [`RealView`]: edges of the sphere, without artificial vertices; [counts](CubicalArrangement::counts) |
//! | `overlay` | [`overlay_all`]: six overlays, with provenance |
//! | `reflect` | [`CubicalArrangement::reflected`] |
//! | `locate` | [`CubicalArrangement::locate`] |
//! | `validity` | [`CubicalArrangement::check_valid`] |
//!
//! # Examples
//! Three great circles, which cut the sphere into eight triangles:
//!
//! ```
//! use exact::spherical::{Direction, GreatCircle};
//! use splitstar_cubical::{CubicalArrangement, CubicalPieces};
//! let mut pieces = CubicalPieces::new();
//! for normal in [[1, 0, 0], [0, 1, 0], [0, 0, 1]] {
//!     pieces.push_circle(&GreatCircle::from_i64(normal).expect("not zero"));
//! }
//! let map = CubicalArrangement::of_pieces(pieces);
//! let counts = map.counts();
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (6, 12, 8));
//! // On each side a cross in a square: 9 vertices, 12 edges, 4 faces and the unbounded one.
//! let stored = map.counts_with_artificial();
//! assert_eq!((stored.vertices, stored.edges, stored.faces), (6 * 9, 6 * 12, 6 * 5));
//! ```
//!
//! # References
//! Thesis, section 3.3.

mod build;
mod connected;
mod locate;
mod map;
mod overlay;
mod pieces;
mod reflect;
mod stitch;
mod validity;
mod view;

pub use exact::gnomonic::{CubeSide, SideSet};
pub use locate::CubicalCell;
pub use map::{At, CubicalArrangement, CubicalFaceId, Place, SideArrangement};
pub use overlay::{CubicalProvenance, overlay_all};
pub use pieces::{ArcEnd, CubicalPieces};
pub use validity::CubicalViolation;
pub use view::RealView;
