//! What a map promises.

use crate::map::{At, CubicalArrangement};
use arrangement::Violation;
use dcel::{EdgeId, VertexId};
use exact::gnomonic::CubeSide;
use std::error::Error;
use std::fmt;

/// A broken promise of a map.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum CubicalViolation {
    /// The arrangement of a side is not valid.
    Side(CubeSide, Box<Violation>),
    /// A vertex of the unbounded face is not on the border of the square, or a vertex on the border is not one of the unbounded face.
    Border(At<VertexId>),
    /// The copies of a vertex are not those that it has to have, in this order, or not the same point.
    Copies(At<VertexId>),
    /// An edge and the same one on the other side do not have the same ends.
    Across(At<EdgeId>),
    /// Some copies of a cell are real, and others are not.
    RealEdge(At<EdgeId>),
    /// A vertex is real and should not be, or is not and should be.
    RealVertex(At<VertexId>),
    /// The two faces next to an artificial edge are different ones of the sphere.
    Face(At<EdgeId>),
    /// Euler's relation does not hold for the real cells.
    Euler,
}

impl fmt::Display for CubicalViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Side(side, violation) => write!(f, "side {side}: {violation}"),
            Self::Border(v) => {
                write!(f, "side {}: vertex {} is on the wrong side of the border", v.side, v.id.0)
            }
            Self::Copies(v) => write!(f, "side {}: vertex {} has wrong copies", v.side, v.id.0),
            Self::Across(e) => write!(f, "side {}: edge {} is not the one on the other side", e.side, e.id.0),
            Self::RealEdge(e) => write!(f, "side {}: edge {} is real on one side only", e.side, e.id.0),
            Self::RealVertex(v) => {
                write!(f, "side {}: vertex {} is wrongly real or artificial", v.side, v.id.0)
            }
            Self::Face(e) => write!(f, "side {}: artificial edge {} divides two faces", e.side, e.id.0),
            Self::Euler => write!(f, "the numbers of real cells do not fit"),
        }
    }
}

impl Error for CubicalViolation {}

impl CubicalArrangement {
    /// Finds what is wrong with a map: nothing, if only functions of this crate made it.
    ///
    /// If the arrangement of a side is not valid by itself, only that is told.
    ///
    /// # Complexity
    /// That of checking six planar arrangements: O(n log n).
    pub fn check_valid(&self) -> Vec<CubicalViolation> {
        let of_side = |side| {
            self.side(side)
                .check_valid()
                .into_iter()
                .map(move |found| CubicalViolation::Side(side, Box::new(found)))
        };
        let mut found: Vec<_> = CubeSide::ALL.into_iter().flat_map(of_side).collect();
        if !found.is_empty() {
            return found;
        }
        for side in CubeSide::ALL {
            let dcel = self.side(side).dcel();
            found.extend(dcel.vertices().filter_map(|id| self.check_vertex(At { side, id }).err()));
            found.extend(dcel.edges().filter_map(|id| self.check_edge(At { side, id }).err()));
        }
        if found.is_empty() {
            let counts = self.counts();
            if counts.vertices + counts.faces != counts.edges + 1 + counts.components {
                found.push(CubicalViolation::Euler);
            }
        }
        found
    }

    fn check_vertex(&self, v: At<VertexId>) -> Result<(), CubicalViolation> {
        let direction = self.direction(v);
        let sides = CubeSide::of(&direction);
        let is_on_border =
            self.side(v.side).dcel().around(v.id).any(|id| self.is_outer(At { side: v.side, id }));
        if !sides.contains(v.side) || is_on_border != (sides.count_sides() > 1) {
            return Err(CubicalViolation::Border(v));
        }
        // Three copies, and no more, before the first comes again.
        let copies: Vec<At<VertexId>> = self.copies(v).take(4).collect();
        let has_all = copies.len() == sides.count_sides()
            && sides.into_iter().all(|side| copies.iter().any(|copy| copy.side == side));
        if !has_all || copies.iter().any(|&copy| self.direction(copy) != direction) {
            return Err(CubicalViolation::Copies(v));
        }
        // Around the vertex, clockwise, sides follow one another as the copies do.
        let mut around: Vec<CubeSide> = self.clockwise_around(v).map(|h| h.side).collect();
        around.dedup();
        if around.len() > 1 && around.first() == around.last() {
            around.pop();
        }
        if is_on_border && around != copies.iter().map(|copy| copy.side).collect::<Vec<_>>() {
            return Err(CubicalViolation::Copies(v));
        }
        let real = self.real_around(v).count();
        let is_real = self.is_real_vertex(v);
        let must_be_real = !is_on_border || real > 2 || real == 1;
        if copies.iter().any(|&copy| self.is_real_vertex(copy) != is_real) || (must_be_real && !is_real) {
            return Err(CubicalViolation::RealVertex(v));
        }
        Ok(())
    }

    fn check_edge(&self, e: At<EdgeId>) -> Result<(), CubicalViolation> {
        let ends = |e: At<EdgeId>| {
            let vertices = self.side(e.side).dcel().ends(e.id).map(|id| At { side: e.side, id });
            vertices.map(|v| self.first_copy(v))
        };
        let h = At { side: e.side, id: self.inner_halfedge(e) };
        let is_on_border = [e.id.halfedge(), e.id.halfedge().twin()]
            .iter()
            .any(|&id| self.is_outer(At { side: e.side, id }));
        match self.across(e) {
            None if is_on_border => return Err(CubicalViolation::Across(e)),
            None => {}
            Some(other) => {
                if !is_on_border || self.across(other) != Some(e) || ends(e) != ends(other) {
                    return Err(CubicalViolation::Across(e));
                }
                if self.is_real_edge(e) != self.is_real_edge(other) {
                    return Err(CubicalViolation::RealEdge(e));
                }
            }
        }
        let is_real = self.is_real_edge(e);
        if !is_real && !is_on_border {
            return Err(CubicalViolation::RealEdge(e));
        }
        if !is_real && self.face(h) != self.face(self.twin(h)) {
            return Err(CubicalViolation::Face(e));
        }
        Ok(())
    }
}
