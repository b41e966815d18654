//! Are two arrangements the same?
//!
//! Compared is what a user sees: artificial vertices are collapsed, and neither ids nor the way in which curves were cut matter.
//!
//! 1. A [`Skeleton`] numbers the vertices in the order of their points, and the darts, which are edges of the user's view with a
//!    direction, around each vertex from one geometric direction on (`skeleton`). So the same arrangements have the same numbers.
//! 2. Then vertices, darts and faces are compared one by one, and the first difference is told.
//! 3. Under a map of the points, directions are unknown: in each component one dart is tried after the other, and it determines
//!    the rest (`mapped`).

mod mapped;
mod skeleton;

use super::Arrangement;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{FaceId, HalfedgeId, VertexId};
use skeleton::{FaceMap, Skeleton};
use std::fmt;

/// In what two arrangements differ; cells of the first one are named first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Difference {
    /// The numbers of vertices that are points.
    VertexCount([usize; 2]),
    /// The numbers of edges.
    EdgeCount([usize; 2]),
    /// The numbers of faces.
    FaceCount([usize; 2]),
    /// In the order of points, these are the first vertices that are not at the same point.
    Point(VertexId, VertexId),
    /// The vertices are at the same point and have different degrees.
    Degree(VertexId, VertexId),
    /// The halfedges leave the same point in the same direction and end in different vertices, or come from different directions.
    Edge(HalfedgeId, HalfedgeId),
    /// The halfedges leave the same point and have no piece there in common; or one that comes from infinity is another one.
    Curve(HalfedgeId, HalfedgeId),
    /// The halfedges are the same, but one lies on an outer CCB and the other on an inner one.
    CcbKind(HalfedgeId, HalfedgeId),
    /// These faces have a halfedge in common, or an isolated vertex; but other halfedges or vertices of one are not of the other.
    Face(FaceId, FaceId),
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexCount([a, b]) => write!(f, "{a} and {b} vertices"),
            Self::EdgeCount([a, b]) => write!(f, "{a} and {b} edges"),
            Self::FaceCount([a, b]) => write!(f, "{a} and {b} faces"),
            Self::Point(v, w) => write!(f, "vertices {} and {} are at different points", v.0, w.0),
            Self::Degree(v, w) => write!(f, "vertices {} and {} have different degrees", v.0, w.0),
            Self::Edge(h, i) => write!(f, "halfedges {} and {} begin alike and end differently", h.0, i.0),
            Self::Curve(h, i) => write!(f, "halfedges {} and {} begin on different curves", h.0, i.0),
            Self::CcbKind(h, i) => write!(f, "halfedges {} and {} lie on CCBs of different kinds", h.0, i.0),
            Self::Face(a, b) => {
                write!(f, "faces {} and {} have some of their boundary in common, not all", a.0, b.0)
            }
        }
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Tells whether another arrangement is the same one: the same points, connected by the same edges in the same order around
    /// them, and the same faces between. Of edges it is compared where they begin and end, and that they are the same curve there.
    ///
    /// # Complexity
    /// O(n log n) comparisons of points and curves for n cells.
    pub fn is_isomorphic(&self, other: &Self) -> bool {
        self.difference(other).is_none()
    }

    /// Tells in what another arrangement differs from this one; `None` if it is the same. See [`Arrangement::is_isomorphic`].
    ///
    /// # Complexity
    /// As of [`Arrangement::is_isomorphic`].
    pub fn difference(&self, other: &Self) -> Option<Difference> {
        let counts = [self, other].map(|arrangement| arrangement.counts());
        let pair = |count: fn(&super::Counts) -> usize| counts.each_ref().map(count);
        let [v, e, f] = [pair(|c| c.vertices), pair(|c| c.edges), pair(|c| c.faces)];
        if v[0] != v[1] {
            return Some(Difference::VertexCount(v));
        }
        let [a, b] = [self, other].map(Skeleton::new);
        for (&v, &w) in a.vertices.iter().zip(&b.vertices) {
            if self.compare_places(self.point(v), other.point(w)).is_ne() {
                return Some(Difference::Point(v, w));
            }
        }
        for i in 0..a.vertices.len() {
            if a.degree(i) != b.degree(i) {
                return Some(Difference::Degree(a.vertices[i], b.vertices[i]));
            }
        }
        if e[0] != e[1] {
            return Some(Difference::EdgeCount(e));
        }
        if let Some(dart) = (0..a.darts.len()).find(|&dart| a.twins[dart] != b.twins[dart]) {
            return Some(Difference::Edge(a.darts[dart], b.darts[dart]));
        }
        let mut starts = a.darts.iter().zip(&b.darts);
        if let Some((&h, &i)) = starts.find(|&(&h, &i)| !self.begins_alike(h, other, i)) {
            return Some(Difference::Curve(h, i));
        }
        if f[0] != f[1] {
            return Some(Difference::FaceCount(f));
        }
        self.difference_of_faces(other, &a, &b)
    }

    /// Tells whether two halfedges that leave one point have a piece there in common.
    fn begins_alike(&self, h: HalfedgeId, other: &Self, i: HalfedgeId) -> bool {
        let (site, other_site) = (self.start_site(h), other.start_site(i));
        let is_same_site = self.topology.compare_sites(&self.traits, &site, &other_site).is_eq();
        let Some(point) = site.point().filter(|_| is_same_site && h.is_even() == i.is_even()) else {
            // Ends at infinity are the same if the curves near them are.
            return is_same_site && site.point().is_none();
        };
        if h.is_even() {
            let [a, b] = [self.curve_of(h.edge_id()), other.curve_of(i.edge_id())];
            self.traits.compare_v_at_u_right(a, b, point).is_eq()
        } else if G::MEET_ONCE {
            let [a, b] = [self.curve_of(h.edge_id()), other.curve_of(i.edge_id())];
            self.traits.compare_v_at_u_left(a, b, point).is_eq()
        } else {
            let [a, b] = [self.make_edge_curve(h.edge_id()), other.make_edge_curve(i.edge_id())];
            self.traits.compare_v_at_u_left(&a, &b, point).is_eq()
        }
    }

    fn difference_of_faces(&self, other: &Self, a: &Skeleton, b: &Skeleton) -> Option<Difference> {
        let mut faces = FaceMap::new(self.dcel.face_bound(), other.dcel.face_bound());
        for dart in 0..a.darts.len() {
            if a.is_outer[dart] != b.is_outer[dart] {
                return Some(Difference::CcbKind(a.darts[dart], b.darts[dart]));
            }
            if !faces.connect(a.faces[dart], b.faces[dart]) {
                return Some(Difference::Face(a.faces[dart], b.faces[dart]));
            }
        }
        for (&v, &w) in a.vertices.iter().zip(&b.vertices) {
            if let (Some(f), Some(g)) = (self.dcel.isolated_face(v), other.dcel.isolated_face(w))
                && !faces.connect(f, g)
            {
                return Some(Difference::Face(f, g));
            }
        }
        None
    }
}
