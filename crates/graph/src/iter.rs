//! The iterators over nodes, neighbours and edges.

use crate::{Cells, EdgeReference, NodeReference, Way, Weights};
use dcel::{Dcel, HalfedgeId};
use petgraph::Direction;
use std::marker::PhantomData;
use std::ops::Range;

/// The cells, and which of them are nodes.
#[derive(Clone, Copy)]
pub(crate) struct Base<'a, C> {
    pub(crate) dcel: &'a Dcel,
    pub(crate) cells: C,
}

impl<'a, C: Cells> Base<'a, C> {
    fn source(self, arc: HalfedgeId) -> C::Id {
        C::cell_of(self.dcel, arc)
    }

    fn target(self, arc: HalfedgeId) -> C::Id {
        C::cell_of(self.dcel, arc.twin())
    }

    pub(crate) fn has(self, id: C::Id) -> bool {
        self.cells.has(self.dcel, id)
    }

    pub(crate) fn nodes(self) -> Nodes<'a, C> {
        Nodes { base: self, range: 0..self.cells.bound(self.dcel) }
    }

    pub(crate) fn arcs<D>(self, id: C::Id, direction: Direction) -> Arcs<'a, C, D> {
        let star = self.has(id).then(|| C::star(self.dcel, id));
        Arcs { base: self, star, direction, way: PhantomData }
    }

    pub(crate) fn all_arcs<D: Way>(self) -> AllArcs<'a, C, D> {
        AllArcs { base: self, range: 0..D::bound(self.dcel), way: PhantomData }
    }

    fn reference<D: Way, E: Weights<D::EdgeId>>(
        self,
        arc: HalfedgeId,
        weights: &E,
    ) -> EdgeReference<C::Id, D::EdgeId, E::Weight> {
        let id = D::id(arc);
        EdgeReference {
            source: self.source(arc),
            target: self.target(arc),
            arc,
            id,
            weight: weights.weight(id),
        }
    }
}

/// All nodes, in the order of their ids.
#[derive(Clone)]
pub struct Nodes<'a, C> {
    base: Base<'a, C>,
    range: Range<usize>,
}

impl<C: Cells> Iterator for Nodes<'_, C> {
    type Item = C::Id;

    fn next(&mut self) -> Option<C::Id> {
        let base = self.base;
        self.range.by_ref().map(C::from_index).find(|&id| base.has(id))
    }
}

/// All nodes with their weights, in the order of their ids.
#[derive(Clone)]
pub struct NodeReferences<'a, C, N> {
    pub(crate) nodes: Nodes<'a, C>,
    pub(crate) weights: N,
}

impl<C: Cells, N: Weights<C::Id>> Iterator for NodeReferences<'_, C, N> {
    type Item = NodeReference<C::Id, N::Weight>;

    fn next(&mut self) -> Option<Self::Item> {
        self.nodes.next().map(|id| NodeReference { id, weight: self.weights.weight(id) })
    }
}

/// The arcs at a node that the graph has, each in the direction of the edge.
pub(crate) struct Arcs<'a, C: Cells, D> {
    base: Base<'a, C>,
    star: Option<C::Star<'a>>,
    direction: Direction,
    way: PhantomData<D>,
}

impl<C: Cells, D: Way> Iterator for Arcs<'_, C, D> {
    type Item = HalfedgeId;

    fn next(&mut self) -> Option<HalfedgeId> {
        let (base, direction) = (self.base, self.direction);
        let arc = |h: HalfedgeId| if direction == Direction::Outgoing { h } else { h.twin() };
        // Cells are compared only where an answer depends on it.
        let has = |arc| D::has(arc, false) && (D::has(arc, true) || base.source(arc) != base.target(arc));
        self.star.as_mut()?.map(arc).find(|&arc| base.cells.has_edge(base.dcel, arc) && has(arc))
    }
}

/// The neighbours of a node, once for each edge.
pub struct Neighbors<'a, C: Cells, D> {
    pub(crate) arcs: Arcs<'a, C, D>,
}

impl<C: Cells, D: Way> Iterator for Neighbors<'_, C, D> {
    type Item = C::Id;

    fn next(&mut self) -> Option<C::Id> {
        let (base, direction) = (self.arcs.base, self.arcs.direction);
        let other = |arc| if direction == Direction::Outgoing { base.target(arc) } else { base.source(arc) };
        self.arcs.next().map(other)
    }
}

/// The edges of a node.
pub struct Edges<'a, C: Cells, D, E> {
    pub(crate) arcs: Arcs<'a, C, D>,
    pub(crate) weights: E,
}

impl<C: Cells, D: Way, E: Weights<D::EdgeId>> Iterator for Edges<'_, C, D, E> {
    type Item = EdgeReference<C::Id, D::EdgeId, E::Weight>;

    fn next(&mut self) -> Option<Self::Item> {
        let base = self.arcs.base;
        self.arcs.next().map(|arc| base.reference::<D, E>(arc, &self.weights))
    }
}

/// An arc of each edge of the graph, in the order of their ids.
#[derive(Clone)]
pub(crate) struct AllArcs<'a, C, D> {
    base: Base<'a, C>,
    range: Range<usize>,
    way: PhantomData<D>,
}

impl<C: Cells, D: Way> Iterator for AllArcs<'_, C, D> {
    type Item = HalfedgeId;

    fn next(&mut self) -> Option<HalfedgeId> {
        let Base { dcel, cells } = self.base;
        let is_there = |&h: &HalfedgeId| dcel.has_halfedge(h) && cells.has_edge(dcel, h);
        self.range.by_ref().map(|i| D::arc(D::from_index(i))).find(is_there)
    }
}

/// All edges of the graph, in the order of their ids.
pub struct EdgeReferences<'a, C, D, E> {
    pub(crate) arcs: AllArcs<'a, C, D>,
    pub(crate) weights: E,
}

impl<C: Cells, D: Way, E: Weights<D::EdgeId>> Iterator for EdgeReferences<'_, C, D, E> {
    type Item = EdgeReference<C::Id, D::EdgeId, E::Weight>;

    fn next(&mut self) -> Option<Self::Item> {
        let base = self.arcs.base;
        self.arcs.next().map(|arc| base.reference::<D, E>(arc, &self.weights))
    }
}
