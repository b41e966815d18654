//! Every violation of what an arrangement promises.
//!
//! 1. The cells are asked whether they fit together ([`dcel::Dcel::check_valid`]) and what surface they make.
//! 2. Each edge is compared with its support and its vertices, and the order around each vertex with the geometric one.
//! 3. Each CCB must be outer or inner as its turns say (`kinds`).
//! 4. If all that is right, a sweep over the edges as curves of their own finds vertices at one point, edges that meet, and cells in
//!    wrong faces (`embedding`). Nothing is believed of what the arrangement says.

mod embedding;
mod kinds;
#[cfg(test)]
mod tests;

use super::Arrangement;
use super::build::special_count;
use crate::topology::Topology;
use crate::traits::{Along, CurveEnd, UMonotoneTraits};
use dcel::{CcbId, DcelViolation, EdgeId, FaceId, HalfedgeId, VertexId};
use std::cmp::Ordering;
use std::fmt;

/// A broken promise of an arrangement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Violation {
    /// The cells do not fit together.
    Cells(DcelViolation),
    /// There are not as many points as vertices, or not as many supports as edges, or a vertex is missing that stands for a side.
    Records,
    /// The vertex has no point, and does not stand for a side.
    PointMissing(VertexId),
    /// The vertex stands for a side of the parameter space, and has a point.
    PointOnSide(VertexId),
    /// The traits know the point of the vertex by other coordinates: see
    /// [`BasicTraits::is_canonical`](crate::traits::BasicTraits::is_canonical).
    NotCanonical(VertexId),
    /// The vertex is marked as one at which curves were cut, but does not join two edges, nor is it a pole where nothing is.
    Artificial(VertexId),
    /// The edge has a support that is not there.
    Support(EdgeId),
    /// The support of the edge is no curve of these traits: see
    /// [`BasicTraits::is_own_curve`](crate::traits::BasicTraits::is_own_curve).
    ForeignSupport(EdgeId),
    /// The vertex of the edge does not lie on its support.
    OffSupport(VertexId, EdgeId),
    /// The min vertex of the edge is not less than its max vertex.
    EndOrder(EdgeId),
    /// The halfedges around the vertex are not in counterclockwise order.
    Rotation(VertexId),
    /// The CCB is said to be an outer one and is an inner one, or the other way round.
    Kind(CcbId),
    /// Both vertices are at one point.
    SamePoint(VertexId, VertexId),
    /// The vertex lies in the interior of the edge.
    VertexOnEdge(VertexId, EdgeId),
    /// The edges meet at a point that is no vertex.
    Crossing(EdgeId, EdgeId),
    /// The edges have a piece in common.
    Overlap(EdgeId, EdgeId),
    /// What is at or beside the vertex lies in the first face by the cells, and in the second one by the geometry.
    WrongFace(VertexId, FaceId, FaceId),
    /// The face is said to be the [corner face](Arrangement::corner_face), and is none or does not have the corner.
    CornerFace(FaceId),
    /// The sweep did not come to the vertex, or not with its edges.
    Unseen(VertexId),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cells(violation) => violation.fmt(f),
            Self::Records => {
                write!(
                    f,
                    "there is not one point for each vertex, one support for each edge, and a vertex for each side"
                )
            }
            Self::PointMissing(v) => write!(f, "vertex {} has no point", v.0),
            Self::PointOnSide(v) => write!(f, "vertex {} stands for a side, and has a point", v.0),
            Self::NotCanonical(v) => {
                write!(f, "the point of vertex {} does not have the coordinates of the surface", v.0)
            }
            Self::Artificial(v) => write!(f, "vertex {} is artificial, and does not join two edges", v.0),
            Self::Support(e) => write!(f, "the support of edge {} does not exist", e.0),
            Self::ForeignSupport(e) => write!(f, "the support of edge {} is a curve of another surface", e.0),
            Self::OffSupport(v, e) => write!(f, "vertex {} is not on the support of its edge {}", v.0, e.0),
            Self::EndOrder(e) => write!(f, "the min vertex of edge {} is not less than its max vertex", e.0),
            Self::Rotation(v) => write!(f, "the halfedges around vertex {} are not in order", v.0),
            Self::Kind(c) => write!(f, "CCB {} is outer and said to be inner, or the other way round", c.0),
            Self::SamePoint(v, w) => write!(f, "vertices {} and {} are at one point", v.0, w.0),
            Self::VertexOnEdge(v, e) => write!(f, "vertex {} lies in the interior of edge {}", v.0, e.0),
            Self::Crossing(d, e) => write!(f, "edges {} and {} meet where there is no vertex", d.0, e.0),
            Self::Overlap(d, e) => write!(f, "edges {} and {} have a piece in common", d.0, e.0),
            Self::WrongFace(v, by_cells, found) => {
                write!(f, "at vertex {} face {} is said to be where face {} is", v.0, by_cells.0, found.0)
            }
            Self::CornerFace(face) => write!(f, "face {} does not have the corner of the surface", face.0),
            Self::Unseen(v) => write!(f, "a sweep does not come to vertex {} with its edges", v.0),
        }
    }
}

impl std::error::Error for Violation {}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Lists every violation of what an arrangement promises; none for a valid one.
    ///
    /// What it promises: the cells fit together, and make the surface; edges lie on their supports between their vertices, the
    /// lesser one first; around each vertex they are in counterclockwise order; no two vertices are at one point, and edges meet
    /// only in vertices; and everything lies in the face in which it says it does. Where an earlier promise is broken, those that
    /// can be stated only if it is kept are not looked at.
    ///
    /// # Complexity
    /// That of a sweep over the edges.
    pub fn check_valid(&self) -> Vec<Violation> {
        self.find_violations(usize::MAX)
    }

    /// As [`Arrangement::check_valid`], but the sweep stops when there are as many as the limit says: of what is far from valid, there
    /// could be as many as pairs of edges.
    pub(super) fn find_violations(&self, limit: usize) -> Vec<Violation> {
        let genus = self.topology.genus() as usize;
        let mut found: Vec<Violation> =
            self.dcel.check_euler(genus).into_iter().map(Violation::Cells).collect();
        let are_complete = self.points.len() >= self.dcel.vertex_bound()
            && self.is_artificial.len() >= self.dcel.vertex_bound()
            && self.supports.len() >= self.dcel.edge_bound()
            && (0..special_count(&self.topology)).all(|v| self.dcel.has_vertex(VertexId::new(v)));
        if !are_complete {
            found.push(Violation::Records);
        }
        if !self.dcel.has_face(self.corner_face) {
            found.push(Violation::CornerFace(self.corner_face));
        }
        if !found.is_empty() {
            return found;
        }
        self.check_records(&mut found);
        if found.is_empty() {
            self.check_edges(&mut found);
        }
        // What follows takes the parts of one support to be disjoint: together they are no longer than it.
        if found.is_empty() {
            self.check_supports(&mut found);
        }
        if found.is_empty() {
            self.check_rotations(&mut found);
            if found.is_empty() {
                self.check_kinds(&mut found);
            }
            self.check_embedding(limit, &mut found);
        }
        found
    }

    fn check_records(&self, found: &mut Vec<Violation>) {
        let special = special_count(&self.topology);
        for v in self.dcel.vertices() {
            match (v.index() < special, self.stands_for_side(v)) {
                (true, false) => found.push(Violation::PointOnSide(v)),
                (false, true) => found.push(Violation::PointMissing(v)),
                _ => {}
            }
            if self.inner_point(v).is_some_and(|point| !self.traits.is_canonical(point)) {
                found.push(Violation::NotCanonical(v));
            }
            if self.is_artificial[v.index()] && self.dcel.degree(v) < 2 && !self.is_absent(v) {
                found.push(Violation::Artificial(v));
            }
        }
        // Each curve is asked once: a chain of many pieces may have many edges.
        let mut is_own = vec![None; self.curves.len()];
        for e in self.dcel.edges() {
            let support = self.supports[e.index()] as usize;
            match self.curves.get(support) {
                None => found.push(Violation::Support(e)),
                Some(curve) => {
                    if !*is_own[support].get_or_insert_with(|| self.traits.is_own_curve(curve)) {
                        found.push(Violation::ForeignSupport(e));
                    }
                }
            }
        }
    }

    fn check_edges(&self, found: &mut Vec<Violation>) {
        for e in self.dcel.edges() {
            let halfedges = [e.halfedge(), e.halfedge().twin()];
            let mut is_on_support = true;
            for h in halfedges {
                let v = self.dcel.source(h);
                if !self.is_on_support(v, e, Self::end_of(h)) {
                    found.push(Violation::OffSupport(v, e));
                    is_on_support = false;
                }
            }
            if is_on_support {
                let [min, max] = halfedges.map(|h| self.start_site(h));
                if self.topology.compare_sites(&self.traits, &min, &max) != Ordering::Less {
                    found.push(Violation::EndOrder(e));
                }
            }
        }
    }

    /// Edges on one support follow one another.
    fn check_supports(&self, found: &mut Vec<Violation>) {
        let mut edges: Vec<(u32, EdgeId)> =
            self.dcel.edges().map(|e| (self.supports[e.index()], e)).collect();
        let compare = |a: HalfedgeId, b: HalfedgeId| {
            self.topology.compare_sites(&self.traits, &self.start_site(a), &self.start_site(b))
        };
        edges.sort_by(|a, b| a.0.cmp(&b.0).then_with(|| compare(a.1.halfedge(), b.1.halfedge())));
        for pair in edges.windows(2) {
            let [(support, before), (other, after)] = [pair[0], pair[1]];
            if support == other && compare(before.halfedge().twin(), after.halfedge()).is_gt() {
                found.push(Violation::Overlap(before, after));
            }
        }
    }

    /// Tells whether a vertex lies where an end of an edge can be.
    fn is_on_support(&self, v: VertexId, e: EdgeId, end: CurveEnd) -> bool {
        let curve = self.curve_of(e);
        let end_point = self.traits.end_point(curve, end);
        let location = |end| self.topology.end_location(&self.traits, curve, end);
        let Some(point) = self.inner_point(v) else {
            // There may be several: the poles of a sphere.
            return crate::zone::side_vertex(self, location(end)) == Some(v);
        };
        if end_point.is_some_and(|end_point| self.traits.is_same_point(end_point, point)) {
            return true;
        }
        let here = self.topology.point_location(&self.traits, point);
        // Only a curve along a side has interior points there.
        let is_along = |here: Along, of: fn(crate::traits::Location) -> Along| {
            here == Along::Inside || CurveEnd::BOTH.into_iter().all(|end| of(location(end)) == here)
        };
        is_along(here.u, |location| location.u)
            && is_along(here.v, |location| location.v)
            && self.traits.is_on_curve(point, curve)
    }

    fn check_rotations(&self, found: &mut Vec<Violation>) {
        for v in self.dcel.vertices() {
            let sorted = self.sorted_around(v);
            let Some(&first) = sorted.first() else { continue };
            let around = self.dcel.around(v);
            let before = self.dcel.around(v).take_while(|&h| h != first);
            let from_first = around.skip_while(|&h| h != first).chain(before);
            let is_strict = sorted.is_sorted_by(|&a, &b| self.compare_around(a, b).is_lt());
            if !is_strict || !sorted.iter().copied().eq(from_first) {
                found.push(Violation::Rotation(v));
            }
        }
    }
}
