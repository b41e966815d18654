//! Exact computational geometry: convex hulls, Minkowski sums and distances of polytopes, arrangements of curves, with every decision
//! exact.
//!
//! This crate has no code of its own. It joins the crates of the project under one name, each as a module, and
//! offers the names that most programs need in [`prelude`].
//!
//! | module | what it has |
//! |---|---|
//! | [`exact`] | integers, rationals, vectors, points, planes, rotations, predicates |
//! | [`dcel`] | halfedge connectivity: what is next to what |
//! | [`arrangement`] | arrangements of curves in the plane, on a torus and on the sphere: traits, sweep, overlay, editing, zones, history |
//! | [`cubical`] | arrangements of geodesic arcs on the sides of a cube |
//! | [`polytope`] | polytopes and meshes, convex hulls, Minkowski sums |
//! | [`gauss`] | Gaussian maps as arrangements, on the sphere and on the sides of a cube |
//! | [`proximity`] | whether two polytopes overlap, how far apart they are, how deep they overlap |
//! | [`formats`] | files of models (OFF, OBJ, STL, PLY, 3MF, VRML, glTF, star), of curves (text, WKT, GeoJSON) and of arrangements (star), read and written; placements, read |
//! | [`render`] | pictures, as SVG |
//! | [`graph`] | arrangements and their duals as graphs of `petgraph` |
//!
//! Each crate is also one of its own, and the examples in its documentation, and those of `docs/write-your-own-curve.md`, name it so:
//! `splitstar_arrangement::`, `exact::` and so on. In a program that depends on this crate alone,
//!
//! ```toml
//! [dependencies]
//! splitstar = { path = "splitstar/crates/splitstar" }
//! ```
//!
//! these are `splitstar::arrangement::`, `splitstar::exact::`, `splitstar::dcel::`, `splitstar::polytope::`, `splitstar::cubical::`, `splitstar::gauss::`, `splitstar::proximity::`, `splitstar::formats::`, `splitstar::render::` and `splitstar::graph::`.
//!
//! # A convex hull
//!
//! Points may be repeated, collinear or coplanar; the result has the dimension that they span.
//!
//! ```
//! use splitstar::prelude::*;
//!
//! let points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3], [1, 1, 1]].map(Point3::from_i64);
//! let hull = convex_hull(&points).expect("there are points");
//! assert_eq!(hull.counts().to_array(), [4, 6, 4]);
//! assert_eq!(hull.volume(), Rational::new(9.into(), 2.into()).expect("two is not zero"));
//!
//! let flat = convex_hull(&points[..3]).expect("there are points");
//! assert_eq!(flat.dimension(), 2);
//! ```
//!
//! # A Minkowski sum
//!
//! Summands may have any dimension from 0 to 3, and there may be any number of them.
//!
//! ```
//! use splitstar::prelude::*;
//!
//! let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
//! let tetrahedron = convex_hull(&corners).expect("there are points");
//! let difference = minkowski_sum(&[&tetrahedron, &tetrahedron.reflected()]);
//! assert_eq!(difference.counts().to_array(), [12, 24, 14]);
//! assert_eq!(difference.volume().to_string(), "10/3");
//!
//! // Turned by 30 degrees about the z-axis, as nearly as 1e-12, and exactly from then on.
//! let axis = [0, 0, 1].map(Rational::from);
//! let turn = Affine3::rotation(&Quaternion::nearest(axis, Rational::from(30))?);
//! let sum = minkowski_sum(&[&tetrahedron, &tetrahedron.transformed(&turn)]);
//! assert!(sum.check_valid().is_empty());
//! # Ok::<(), splitstar::exact::ZeroAxis>(())
//! ```
//!
//! # How far apart
//!
//! Two polytopes, the second moved: disjoint, touching or overlapping, at an exact distance or depth.
//!
//! ```
//! use splitstar::prelude::*;
//! use splitstar::proximity::{Relation, RelativePlacement, Translation};
//!
//! let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
//! let tetrahedron = convex_hull(&corners).expect("there are points");
//! let both = RelativePlacement::new(&tetrahedron, &tetrahedron);
//!
//! let apart = Translation::from_i64([1, 1, 1]);
//! let separation = both.separation(&apart, None);
//! assert_eq!(separation.relation(), Relation::Disjoint);
//! assert_eq!(separation.squared_distance().to_string(), "4/3");
//!
//! // From where the last question has ended.
//! let inside = Translation::new(&["0.25".parse()?, "0".parse()?, "0".parse()?]);
//! let depth = both.minimum_penetration(&inside, Some(separation.witness())).expect("they overlap");
//! assert_eq!(depth.squared_depth().to_string(), "3/16");
//! # Ok::<(), splitstar::exact::ParseNumberError>(())
//! ```
//!
//! # An arrangement
//!
//! Curves cut a surface into vertices, edges and faces. They may overlap, meet in one point, be vertical or unbounded.
//!
//! ```
//! use splitstar::prelude::*;
//!
//! let [a, b, c, d] = [[0, 0], [4, 0], [0, 3], [1, 1]].map(Point2::from_i64);
//! let curves = [Linear::line(&a, &b), Linear::line(&a, &c), Linear::segment(b, c), Linear::ray(d, &a)];
//! let curves: Vec<Linear> = curves.into_iter().collect::<Option<_>>().expect("the points are different");
//! let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &curves);
//!
//! let counts = arrangement.counts();
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (4, 9, 6));
//! // The ray begins in the triangle and leaves it by a corner.
//! let bounded = arrangement.dcel().faces().filter(|&face| !arrangement.is_unbounded(face));
//! assert_eq!(bounded.count(), 1);
//!
//! let picture = Scene::of_arrangement(&arrangement, None)?.to_svg(&SvgOptions::default());
//! assert!(picture.starts_with("<svg "));
//! # Ok::<(), splitstar::render::RenderError>(())
//! ```
//!
//! # Reading and writing
//!
//! Libraries take and give bytes; where they come from is the business of the program. The format is found by the
//! content. `0.1` in a text is one tenth.
//!
//! ```
//! use splitstar::prelude::*;
//!
//! let read = formats::read(b"OFF\n4 1 4\n0 0 0\n0.1 0 0\n0.1 1/3 0\n0 1/3 0\n4 0 1 2 3\n", None)?;
//! let mut notes = Vec::new(); // what had to be mended: nothing here
//! let mesh = read.model.shape.into_mesh().expect("what OFF can say is a mesh");
//! let rectangle = Polytope::from_mesh(&mesh, &mut notes)?;
//! let up = Polytope::segment(Point3::ORIGIN, Point3::from_i64([0, 0, 2]));
//!
//! let block = minkowski_sum(&[&rectangle, &up]);
//! assert_eq!(block.volume().to_string(), "1/15");
//! let written = formats::write(&Model::of_mesh(block.to_mesh()), &WriteOptions::new(Format::Off))?;
//! assert!(written.bytes.starts_with(b"OFF\n8 6 12\n"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Promises
//!
//! Every decision is the mathematically true one for the input as given; nothing is rounded except by methods
//! called `approx_*` and by writing floats on request. Degenerate input is no error. Malformed input is an error
//! that names the place, and no input panics, unless the documentation of the function says so.

// The examples of the README and of the page on Gaussian maps are tests of this crate.
#![cfg_attr(doctest, doc = include_str!("../../../README.md"))]
#![cfg_attr(doctest, doc = include_str!("../../../docs/gauss.md"))]

pub use {arrangement, cubical, dcel, exact, formats, gauss, graph, polytope, proximity, render};

/// The names that most programs need: `use splitstar::prelude::*`.
///
/// ```
/// use splitstar::prelude::*;
///
/// let segment = Polytope::segment(Point3::ORIGIN, Point3::from_i64([1, 2, 2]));
/// let triple = minkowski_sum(&[&segment, &segment, &segment]);
/// assert!(triple.same_set(&segment.transformed(&Affine3::scaling(&Rational::from(3)))));
/// ```
pub mod prelude {
    pub use arrangement::history::ArrangementWithHistory;
    pub use arrangement::models::polycurve::PolycurveTraits;
    pub use arrangement::models::{
        Geodesic, GeodesicTraits, Linear, LinearTraits, Segment, SegmentTraits, TorusPath, TorusSegmentTraits,
    };
    pub use arrangement::overlay::{Cell, overlay_all};
    pub use arrangement::topology::{BoundedPlane, FlatTorus, Sphere, UnboundedPlane};
    pub use arrangement::{Arrangement, Editor, Pieces, locate_all};
    pub use exact::planar::{Line2, Point2};
    pub use exact::{Affine3, Integer, Plane, Point3, Quaternion, Rational, Sign, Vector3};
    pub use formats::{self, Format, InputCurve, Model, Object, ReadError, Shape, Unit, WriteOptions};
    pub use polytope::{
        Bounds, Counts, FacetId, Facets, HalfedgeId, Mended, Mending, MeshError, MeshSummary, Note,
        PolygonMesh, Polytope, VertexId, convex_hull, minkowski_sum,
    };
    pub use render::{Scene, SvgOptions};
}
