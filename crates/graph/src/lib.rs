//! Arrangements as graphs of `petgraph`.
//!
//! An arrangement and its dual, seen through the visit traits of [`petgraph`](https://docs.rs/petgraph), so that its algorithms run on
//! them: search, components, shortest ways, spanning trees. Nothing is copied: the adaptors borrow the arrangement.
//!
//! | item | what |
//! |---|---|
//! | [`Primal`] | vertices and edges |
//! | [`Dual`] | faces, and edges between the faces on both sides |
//! | [`Way`] | undirected, along halfedges, or from min to max vertex |
//! | [`Weights`] | ids by default; any function that can be copied, and so any property map that it reads |
//! | [`Numbered`] | the same with nodes numbered without gaps |
//!
//! The filters and adaptors of `petgraph` work on all of them: `EdgeFiltered`, `NodeFiltered`, `Reversed`. Which algorithm wants what:
//!
//! | algorithm | takes |
//! |---|---|
//! | `Bfs`, `Dfs`, `dijkstra`, `astar`, `is_bipartite_undirected`, `min_spanning_tree`, `tarjan_scc`, `has_path_connecting` | [`Primal`] or [`Dual`], by value |
//! | `toposort` | a directed one, such as [`Primal`] when [`ascending`](CellGraph::ascending) |
//! | `connected_components`, `is_isomorphic`, `floyd_warshall` | a reference to [`Numbered`] |
//! | those that want `DataMap`, such as `ford_fulkerson` | a copy: weights are made when asked for, and have no place |
//!
//! # Examples
//!
//! The faces that can be reached from a face without crossing a wall. The walls are a square; a segment across it is open:
//!
//! ```
//! use petgraph::visit::{Dfs, EdgeFiltered, EdgeRef};
//! use arrangement::{Arrangement, models::{Segment, SegmentTraits}, topology::BoundedPlane};
//! use splitstar_graph::Dual;
//!
//! let ends = [[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [0, 4]], [[0, 4], [0, 0]], [[0, 1], [4, 2]]];
//! let segments = ends.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
//! let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments);
//! let dual = Dual::new(&arrangement);
//! let is_open = |e| arrangement.curve_of(e) == &segments[4];
//! let open = EdgeFiltered::from_fn(dual, |edge| is_open(edge.id()));
//!
//! let inside = arrangement.dcel().faces().find(|&f| f != arrangement.corner_face()).expect("there are three faces");
//! let mut search = Dfs::new(&open, inside);
//! let reached = std::iter::from_fn(|| search.next(&open)).count();
//! assert_eq!(reached, 2);
//! ```
//!
//! Lines divide the plane into faces that can be coloured with two colours:
//!
//! ```
//! use petgraph::algo::is_bipartite_undirected;
//! use arrangement::traits::BasicTraits;
//! use arrangement::{Arrangement, models::{Linear, LinearTraits}, topology::UnboundedPlane};
//! use splitstar_graph::Dual;
//!
//! type Point = <LinearTraits as BasicTraits>::Point;
//!
//! let points = [[0, 0], [3, 1], [1, 4], [5, 5]].map(Point::from_i64);
//! let lines = (0..4).map(|i| Linear::line(&points[i], &points[(i + 1) % 4]).expect("the points are different"));
//! let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines.collect::<Vec<_>>());
//! assert!(is_bipartite_undirected(Dual::new(&arrangement), arrangement.corner_face()));
//! ```
//!
//! # References
//! The manual of CGAL, "2D Arrangements", "Adapting to Boost Graphs": adaptors of the same purpose.

mod cells;
mod graph;
mod iter;
mod numbered;
mod references;
mod visited;
mod way;
mod weights;

pub use cells::{Cells, Faces, Vertices};
pub use graph::{CellGraph, Dual, Primal};
pub use iter::{EdgeReferences, Edges, Neighbors, NodeReferences, Nodes};
pub use numbered::Numbered;
pub use references::{EdgeReference, NodeReference};
pub use visited::{Adjacency, NodeSet};
pub use way::{Ascending, Way};
pub use weights::{Ids, Weights};
