//! Input for tests, and the means to compare results.
//!
//! | module | what |
//! |---|---|
//! | `random` | [`Rng`]: the same numbers on every machine |
//! | `hulls` | random polytopes of every dimension, many of them degenerate |
//! | `families` | prisms, bipyramids, geodesic spheres, zonotopes |
//! | `meshes` | meshes as programs write them: floats, triangles, defects |
//! | `curves` | the segments, lines and polylines of published measurements, number by number |
//! | `motions` | exact rotations and other affine maps |
//! | `models` | the model files of the repository and what is known of them |
//! | `compare` | are two polytopes the same? |
//!
//! Used from `tests/` folders only: in a unit test it would bring a second copy of the crate's own types.

mod compare;
mod curves;
mod families;
mod hulls;
mod meshes;
mod models;
mod motions;
mod random;

pub use compare::{assert_same, difference, facet_planes, isomorphic};
pub use curves::{
    COORDINATE_BITS, Drawn, LinearKind, POLYLINE_VERTICES, geodesic_arcs, lines, long_segments, mixed_curves,
    polylines, query_directions, query_points, short_segments,
};
pub use families::{
    antiprism, bipyramid, geodesic_sphere, prism, rational_circle, segment, spread_generators,
    zonotope_volume,
};
pub use hulls::{
    around, collinear_points, flat_points, hull, hull_of_dimension, mixed_width_hull, points_in_box,
    random_hull, weighted_hull, wide_hull,
};
pub use meshes::{cube_mesh, fan_triangulated, mesh, soup, stl_like_mesh};
pub use models::{SumRow, expected, model, model_mesh, model_names, repository};
pub use motions::{quaternion, random_rotation, rotation, scaling, translation};
pub use random::{Rng, mutate};
