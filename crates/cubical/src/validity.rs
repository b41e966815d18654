//! What a map promises.

use crate::map::{At, CubicalArrangement};
use arrangement::Violation;
use dcel::{EdgeId, VertexId};
use exact::gnomonic::CubeSide;
use exact::spherical::GreatCircle;
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
    /// A vertex is real and should not be, or is not and should be: so is an artificial one where an arc does not run straight on.
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
        // Later steps walk along what earlier ones have checked.
        found.extend(self.vertices_of_sides().filter_map(|v| self.check_copies(v).err()));
        if found.is_empty() {
            found.extend(self.edges_of_sides().filter_map(|e| self.check_across(e).err()));
        }
        if found.is_empty() {
            found.extend(self.vertices_of_sides().filter_map(|v| self.check_vertex(v).err()));
            found.extend(self.edges_of_sides().filter_map(|e| self.check_edge(e).err()));
        }
        if found.is_empty() {
            let counts = self.counts();
            if counts.vertices + counts.faces != counts.edges + 1 + counts.components {
                found.push(CubicalViolation::Euler);
            }
        }
        found
    }

    fn vertices_of_sides(&self) -> impl Iterator<Item = At<VertexId>> + '_ {
        CubeSide::ALL
            .into_iter()
            .flat_map(|side| self.side(side).dcel().vertices().map(move |id| At { side, id }))
    }

    fn edges_of_sides(&self) -> impl Iterator<Item = At<EdgeId>> + '_ {
        CubeSide::ALL
            .into_iter()
            .flat_map(|side| self.side(side).dcel().edges().map(move |id| At { side, id }))
    }

    fn is_on_border(&self, v: At<VertexId>) -> bool {
        self.side(v.side).dcel().around(v.id).any(|id| self.is_outer(At { side: v.side, id }))
    }

    fn check_copies(&self, v: At<VertexId>) -> Result<(), CubicalViolation> {
        let direction = self.direction(v);
        let sides = CubeSide::of(&direction);
        if !sides.contains(v.side) || self.is_on_border(v) != (sides.count_sides() > 1) {
            return Err(CubicalViolation::Border(v));
        }
        // Three copies, and no more, before the first comes again.
        let copies: Vec<At<VertexId>> = self.copies(v).take(4).collect();
        let is_closed = copies.len() == 1 || copies.last().and_then(|&last| self.next_copy(last)) == Some(v);
        let has_all = copies.len() == sides.count_sides()
            && sides.into_iter().all(|side| copies.iter().any(|copy| copy.side == side));
        if !is_closed || !has_all || copies.iter().any(|&copy| self.direction(copy) != direction) {
            return Err(CubicalViolation::Copies(v));
        }
        Ok(())
    }

    fn check_across(&self, e: At<EdgeId>) -> Result<(), CubicalViolation> {
        let ends = |e: At<EdgeId>| {
            let vertices = self.side(e.side).dcel().ends(e.id).map(|id| At { side: e.side, id });
            vertices.map(|v| self.first_copy(v))
        };
        let is_along_border = [e.id.halfedge(), e.id.halfedge().twin()]
            .iter()
            .any(|&id| self.is_outer(At { side: e.side, id }));
        match self.across(e) {
            None if !is_along_border => Ok(()),
            Some(other) if is_along_border && self.across(other) == Some(e) && ends(e) == ends(other) => {
                Ok(())
            }
            _ => Err(CubicalViolation::Across(e)),
        }
    }

    fn check_vertex(&self, v: At<VertexId>) -> Result<(), CubicalViolation> {
        let (copies, is_on_border) = (self.copies(v).collect::<Vec<_>>(), self.is_on_border(v));
        // Around the vertex, clockwise, sides follow one another as the copies do.
        let mut around: Vec<CubeSide> = self.clockwise_around(v).map(|h| h.side).collect();
        around.dedup();
        if around.len() > 1 && around.first() == around.last() {
            around.pop();
        }
        if is_on_border && around != copies.iter().map(|copy| copy.side).collect::<Vec<_>>() {
            return Err(CubicalViolation::Copies(v));
        }
        let real: Vec<GreatCircle> = self.real_around(v).map(|h| self.circle(h)).collect();
        let is_real = self.is_real_vertex(v);
        // An arc that only passes leaves on both sides along the same circle, in opposite senses.
        let may_be_artificial = match &real[..] {
            [] => true,
            [one, other] => *one == other.opposite(),
            _ => false,
        };
        let must_be_real = !is_on_border || !may_be_artificial;
        if copies.iter().any(|&copy| self.is_real_vertex(copy) != is_real) || (must_be_real && !is_real) {
            return Err(CubicalViolation::RealVertex(v));
        }
        Ok(())
    }

    fn check_edge(&self, e: At<EdgeId>) -> Result<(), CubicalViolation> {
        let is_real = self.is_real_edge(e);
        // An edge within a side is real.
        if self.across(e).map_or(!is_real, |other| self.is_real_edge(other) != is_real) {
            return Err(CubicalViolation::RealEdge(e));
        }
        let h = At { side: e.side, id: self.inner_halfedge(e) };
        if !is_real && self.face(h) != self.face(self.twin(h)) {
            return Err(CubicalViolation::Face(e));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CubicalFaceId, CubicalPieces};
    use exact::spherical::Direction;

    /// A circle, and a point at a corner that is not on it.
    fn map() -> CubicalArrangement {
        let mut pieces = CubicalPieces::new();
        pieces.push_circle(&GreatCircle::from_i64([0, 0, 1]).expect("not zero"));
        pieces.push_point(&Direction::from_i64([1, 1, 1]).expect("not zero"));
        CubicalArrangement::of_pieces(pieces)
    }

    #[track_caller]
    fn assert_found(change: impl Fn(&mut CubicalArrangement), is_it: impl Fn(&CubicalViolation) -> bool) {
        let mut map = map();
        assert_eq!(map.check_valid(), []);
        change(&mut map);
        let found = map.check_valid();
        assert!(found.iter().any(is_it), "{found:?}");
        assert!(found.iter().all(|violation| !violation.to_string().is_empty()));
    }

    #[test]
    fn what_is_broken_is_found() {
        let side = CubeSide::new(0, true);
        let corner = |map: &CubicalArrangement| At { side, id: map.corners(side)[3] };
        let on_border = |map: &CubicalArrangement| {
            let dcel = map.side(side).dcel();
            let mut vertices = dcel.vertices().map(|id| At { side, id });
            vertices.find(|&v| map.place(v) == crate::Place::Edge).expect("the circle passes over an edge")
        };
        let edge = |map: &CubicalArrangement, is_real: bool| {
            let mut edges = map.side(side).dcel().edges().map(|id| At { side, id });
            edges.find(|&e| map.is_real_edge(e) == is_real).expect("there are both")
        };
        assert_found(
            |map| {
                let v = corner(map);
                map.sides[side.index()].is_real_vertex[v.id.index()] = false;
            },
            |found| matches!(found, CubicalViolation::RealVertex(_)),
        );
        assert_found(
            |map| {
                let v = on_border(map);
                map.sides[side.index()].next_copy[v.id.index()] = None;
            },
            |found| matches!(found, CubicalViolation::Copies(_)),
        );
        assert_found(
            |map| {
                let e = edge(map, false);
                map.sides[side.index()].across[e.id.index()] = None;
            },
            |found| matches!(found, CubicalViolation::Across(_)),
        );
        assert_found(
            |map| {
                let e = edge(map, true);
                map.sides[side.index()].is_real_edge[e.id.index()] = false;
            },
            |found| matches!(found, CubicalViolation::RealEdge(_)),
        );
        assert_found(
            |map| {
                let part = map.part(CubicalFaceId(0));
                map.sides[part.side.index()].faces[part.id.index()] = CubicalFaceId(1);
            },
            |found| matches!(found, CubicalViolation::Face(_)),
        );
        assert_found(|map| map.face_count += 1, |found| matches!(found, CubicalViolation::Euler));
    }

    /// An arc that ends where another one begins, on an edge of the cube, is not one that passes.
    #[test]
    fn an_artificial_vertex_at_a_bend_is_found() {
        let [p, bend, straight, q] =
            [[3, 1, 0], [1, 1, 0], [1, 3, 0], [1, 3, 1]].map(|p| Direction::from_i64(p).expect("not zero"));
        for (end, is_straight) in [(&straight, true), (&q, false)] {
            let mut pieces = CubicalPieces::new();
            for [from, to] in [[&p, &bend], [&bend, end]] {
                let circle = GreatCircle::through(from, to).expect("neither equal nor antipodal");
                assert_eq!(pieces.push_arc(&circle, from, to), Ok(()));
            }
            let mut map = CubicalArrangement::of_pieces(pieces);
            assert_eq!(map.check_valid(), []);
            let found: Vec<_> = map.vertices_of_sides().filter(|&v| map.direction(v) == bend).collect();
            assert_eq!(found.len(), 2, "on an edge of the cube");
            for v in &found {
                map.sides[v.side.index()].is_real_vertex[v.id.index()] = false;
            }
            let expected = found.into_iter().map(CubicalViolation::RealVertex);
            let expected: Vec<_> = if is_straight { Vec::new() } else { expected.collect() };
            assert_eq!(map.check_valid(), expected);
        }
    }

    #[test]
    fn three_copies_in_the_other_order_are_found() {
        let reverse = |map: &mut CubicalArrangement| {
            let side = CubeSide::new(0, true);
            let v = At { side, id: map.corners(side)[3] };
            let copies: Vec<At<VertexId>> = map.copies(v).collect();
            for (i, copy) in copies.iter().enumerate() {
                map.sides[copy.side.index()].next_copy[copy.id.index()] = Some(copies[(i + 2) % 3]);
            }
        };
        assert_found(reverse, |found| matches!(found, CubicalViolation::Copies(_)));
    }
}
