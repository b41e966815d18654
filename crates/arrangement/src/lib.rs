//! Exact arrangements of curves on surfaces.
//!
//! Curves cut a surface into vertices, edges and faces. This crate finds these cells and which is next to which, for any family of curves
//! that implements its traits, and on any surface that they can lie on. Degenerate input is no error: overlaps, many curves through
//! one point, ends on other curves, vertical curves and isolated points are ordinary cases, and no decision is rounded.
//!
//! | module | what |
//! |---|---|
//! | [`traits`] | what the engine asks of a family of curves |
//! | [`topology`] | what it asks of a surface: bounded plane, unbounded plane, flat torus, sphere |
//! | [`models`] | families: segments, rays and lines, polycurves, paths on a torus, geodesic arcs on the sphere |
//! | [`wrappers`] | traits around traits: they count or trace calls, or carry data along curves |
//! | [`sweep`] | the algorithm: events from left to right, told to a visitor that may stop it |
//! | [`overlay`] | all cells of several arrangements cut by one another, with provenance |
//! | [`Editor`] | an arrangement to which curves and points come and from which they go one by one; location |
//! | [`edit`] | the primitive changes of an arrangement, and those who watch them: observers, stamps, undo |
//! | [`location`] | in which cell a point lies, and what is straight above or below it: one trait, several strategies |
//! | [`decomposition`] | the vertical decomposition: pseudo-trapezoids as a list and as a cell complex, and what is straight above and below each vertex |
//! | [`zone`] | the cells that a curve meets, in their order |
//! | [`history`] | arrangements that know which input runs along which edge, and from which inputs can be removed |
//! | [`Arrangement`] | the cells: [`Arrangement::of_curves`], [`Arrangement::insert_curves`], [`Arrangement::counts`] |
//! | [`Pieces`] | u-monotone curves and points, for [`Arrangement::of_pieces`]; with curves that are to be cut, [`Arrangement::of_curves_and_points`], [`Arrangement::insert_points`] |
//! | [`Arrangement::user_view`], [`Arrangement::check_valid`], [`Arrangement::is_isomorphic`] | cells without artificial vertices; violations; comparison |
//! | [`locate_all`] | in which cells many points lie |
//! | [`locate_by_sweep`], [`intersections`], [`subcurves`], [`do_any_meet`] | questions that one sweep answers |
//!
//! How a new family is written, `docs/write-your-own-curve.md` shows; why things are as they are, `docs/arrangement.md`.
//!
//! # Examples
//!
//! Segments, which cross in a point that is not an integer:
//!
//! ```
//! use splitstar_arrangement::{Arrangement, models::{Segment, SegmentTraits}, topology::BoundedPlane};
//!
//! let segments = [[[0, 0], [3, 1]], [[0, 1], [3, 0]]].map(|ends| Segment::from_i64(ends).expect("the ends are different"));
//! let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments);
//! let counts = arrangement.counts();
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (5, 4, 1));
//! let crossing = arrangement.vertices().find(|&v| arrangement.dcel().degree(v) == 4);
//! let point = arrangement.point(crossing.expect("they cross")).expect("in the bounded plane every vertex has a point");
//! assert_eq!(point.to_string(), "(3/2, 1/2)");
//! ```
//!
//! Lines in the whole plane, whose ends meet in a vertex at infinity that is not counted:
//!
//! ```
//! use exact::planar::Point2;
//! use splitstar_arrangement::{Arrangement, models::{Linear, LinearTraits}, topology::UnboundedPlane};
//!
//! let lines = [[[0, 0], [1, 0]], [[0, 0], [0, 1]], [[1, 0], [0, 1]]].map(|points| {
//!     let [p, q] = points.map(Point2::from_i64);
//!     Linear::line(&p, &q).expect("the points are different")
//! });
//! let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines);
//! let counts = arrangement.counts();
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (3, 9, 7));
//! assert_eq!(arrangement.ends_at_infinity(), 6);
//! assert_eq!(arrangement.dcel().faces().filter(|&f| arrangement.is_unbounded(f)).count(), 6);
//! ```
//!
//! Two closed curves on a torus, one along each side. They meet once, and do not divide it. The vertices where they cross the sides of
//! the rectangle are artificial:
//!
//! ```
//! use exact::planar::Point2;
//! use splitstar_arrangement::{Arrangement, models::TorusSegmentTraits, topology::FlatTorus};
//!
//! let traits = TorusSegmentTraits::new([4.into(), 4.into()])?;
//! let through = Point2::from_i64([1, 1]);
//! let paths = [traits.closed_path(&through, [1, 0])?, traits.closed_path(&through, [0, 1])?];
//! let arrangement = Arrangement::of_curves(traits, FlatTorus, &paths);
//! let [counts, stored] = [arrangement.counts(), arrangement.counts_with_splits()];
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (1, 2, 1));
//! assert_eq!((stored.vertices, stored.edges, stored.faces), (3, 4, 1));
//! # Ok::<(), splitstar_arrangement::models::TorusError>(())
//! ```
//!
//! The overlay of two squares, and from where its cells come; then in which cells of it some points lie:
//!
//! ```
//! use exact::planar::Point2;
//! use splitstar_arrangement::overlay::{Cell, overlay_all};
//! use splitstar_arrangement::{Arrangement, locate_all, models::{Segment, SegmentTraits}, topology::BoundedPlane};
//!
//! let square = |a, b| {
//!     let corners = [[a, a], [b, a], [b, b], [a, b]];
//!     let side = |i: usize| Segment::from_i64([corners[i], corners[(i + 1) % 4]]).expect("corners are different");
//!     Arrangement::of_curves(SegmentTraits, BoundedPlane, &[0, 1, 2, 3].map(side))
//! };
//! let (red, blue) = (square(0, 2), square(1, 3));
//! let (overlay, provenance) = overlay_all(&[&red, &blue]);
//! let counts = overlay.counts();
//! assert_eq!((counts.vertices, counts.edges, counts.faces), (10, 12, 4));
//! let outside = [red.corner_face(), blue.corner_face()];
//! let is_in_both = |&f: &_| provenance.of_face(f).iter().zip(&outside).all(|(face, outside)| face != outside);
//! let in_both: Vec<_> = overlay.dcel().faces().filter(is_in_both).collect();
//! assert_eq!(in_both.len(), 1);
//!
//! let points = [[1, 2], [2, 0], [1, 0], [9, 9]].map(Point2::from_i64);
//! let cells = locate_all(&overlay, &points);
//! let [Cell::Vertex(crossing), Cell::Vertex(corner), Cell::Edge(side), Cell::Face(far)] = cells[..] else { panic!("{cells:?}") };
//! assert!(matches!(provenance.of_vertex(crossing), [Cell::Edge(_), Cell::Edge(_)]));
//! assert!(matches!(provenance.of_vertex(corner), [Cell::Vertex(_), Cell::Face(_)]));
//! assert!(matches!(provenance.of_edge(side), [Cell::Edge(_), Cell::Face(f)] if *f == blue.corner_face()));
//! assert_eq!(far, overlay.corner_face());
//! # let middle = Point2::from_rationals(&["3/2", "3/2"].map(|text| text.parse().expect("a number")));
//! # assert_eq!(locate_all(&overlay, &[middle]), [Cell::Face(in_both[0])]);
//! ```
//!
//! A visitor that stops the sweep at the first meeting:
//!
//! ```
//! use exact::planar::Point2;
//! use splitstar_arrangement::models::{Segment, SegmentTraits};
//! use splitstar_arrangement::sweep::{Around, Event, SweepInput, SweepVisitor, sweep};
//! use splitstar_arrangement::topology::BoundedPlane;
//! use std::ops::ControlFlow;
//!
//! #[derive(Default)]
//! struct FirstMeeting {
//!     events: usize,
//!     point: Option<Point2>,
//! }
//!
//! impl SweepVisitor<SegmentTraits> for FirstMeeting {
//!     type Tag = ();
//!
//!     fn event(&mut self, event: &Event<'_, SegmentTraits>, _: &mut Around<'_, ()>) -> ControlFlow<()> {
//!         self.events += 1;
//!         if event.is_meeting {
//!             self.point = event.site.point().cloned();
//!             return ControlFlow::Break(());
//!         }
//!         ControlFlow::Continue(())
//!     }
//! }
//!
//! let ends = [[[0, 0], [4, 4]], [[0, 4], [4, 0]], [[0, 1], [4, 1]]];
//! let segments = ends.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
//! let input = SweepInput::of_curves(&SegmentTraits, &BoundedPlane, &segments, &[]);
//! let mut first = FirstMeeting::default();
//! assert!(sweep(&SegmentTraits, &BoundedPlane, &input, &mut first).is_break());
//! assert_eq!(first.events, 4, "three left ends, and the meeting");
//! assert_eq!(first.point, Some(Point2::from_i64([1, 1])));
//! ```

mod arrangement;
pub mod decomposition;
pub mod edit;
mod editor;
pub mod history;
mod insert;
pub mod location;
pub mod models;
pub mod overlay;
mod queries;
#[cfg(test)]
mod random;
pub mod sweep;
pub mod topology;
pub mod traits;
mod trapezoids;
pub mod wrappers;
pub mod zone;

pub use arrangement::{
    Arrangement, CellOrder, Counts, CurveId, Difference, Parts, UserEdgeId, UserView, Violation,
};
pub use editor::{Editor, MergedEdges, Renumbering, SplitParts, VertexNeed, VertexNeeded};
pub use insert::Pieces;
pub use location::locate_all;
pub use queries::{CommonEnds, do_any_meet, intersections, locate_by_sweep, locate_by_sweep_with, subcurves};
