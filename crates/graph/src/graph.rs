//! The graph of an arrangement, and that of its dual.

use crate::iter::{Base, EdgeReferences, Edges, Neighbors, NodeReferences, Nodes};
use crate::{
    Adjacency, Ascending, Cells, EdgeReference, Faces, Ids, NodeReference, NodeSet, Vertices, Way, Weights,
};
use arrangement::Arrangement;
use arrangement::topology::Topology;
use arrangement::traits::BasicTraits;
use dcel::VertexId;
use petgraph::visit::{
    Data, EdgeCount, EdgeIndexable, GetAdjacencyMatrix, GraphBase, GraphProp, GraphRef, IntoEdgeReferences,
    IntoEdges, IntoEdgesDirected, IntoNeighbors, IntoNeighborsDirected, IntoNodeIdentifiers,
    IntoNodeReferences, NodeCount, NodeIndexable, Visitable,
};
use petgraph::{Directed, Direction, Undirected};
use std::marker::PhantomData;

/// The vertices of an arrangement as nodes, and its edges as edges.
///
/// Nodes are the vertices that are points: isolated ones included, and artificial ones, too. The vertex at infinity of the unbounded
/// plane is none, unless [`with_infinity`](CellGraph::with_infinity) asks for it, and an edge that has an end there is not in the
/// graph: who walks along curves does not come back from infinity on another one, and lines that are parallel are not connected,
/// as in [`Arrangement::counts`].
pub type Primal<'a, D = Undirected, N = Ids, E = Ids> = CellGraph<'a, Vertices, D, N, E>;

/// The faces of an arrangement as nodes, and as edges those of the arrangement, each between the faces on its two sides.
///
/// An edge with one face on both sides is a loop, and faces may have several edges in common. Holes need no care: an edge of an
/// inner CCB leads to the face inside. The dual is connected. Isolated vertices are nowhere in it.
pub type Dual<'a, D = Undirected, N = Ids, E = Ids> = CellGraph<'a, Faces, D, N, E>;

/// An arrangement as a graph of `petgraph`: [`Primal`] or [`Dual`].
///
/// It borrows the arrangement, copies nothing, and is made in constant time. It is small and can be copied, so it is given to algorithms
/// by value. Parameters: what is a node (`C`), what is an edge (`D`: [`Undirected`], [`Directed`] or [`Ascending`], see [`Way`]), and what
/// gives [weights](Weights) to nodes (`N`) and edges (`E`): by default the weight of a cell is its id.
///
/// Ids are those of the arrangement: [`VertexId`](dcel::VertexId) and [`FaceId`](dcel::FaceId) of nodes, [`EdgeId`](dcel::EdgeId) of
/// edges, and [`HalfedgeId`](dcel::HalfedgeId) of edges that are directed both ways. They need not be dense: vertices at infinity are no
/// nodes, and edits leave gaps. Algorithms that want
/// [`NodeCompactIndexable`](petgraph::visit::NodeCompactIndexable) take [`Numbered`](crate::Numbered). A node that is not there has neither
/// neighbours nor edges.
///
/// # Complexity
///
/// | what | costs |
/// |---|---|
/// | neighbours or edges of a node, all of them | linear in its degree, in the dual in the length of its CCBs; no allocation |
/// | all nodes, all edges | linear in the bound of their ids |
/// | `node_count` | constant |
/// | `edge_count` | constant, but for the primal graph of an arrangement with ends at infinity: linear in their number |
/// | `visit_map` | a bit for each id |
/// | `adjacency_matrix` | a hash table of as many pairs as there are pairs of neighbours |
/// | a weight | a call of the function that gives it, at every visit |
///
/// # Examples
/// Shortest ways along the edges of a square with a diagonal, which has a greater weight:
///
/// ```
/// use dcel::{EdgeId, EdgeMap};
/// use petgraph::algo::dijkstra;
/// use petgraph::visit::EdgeRef;
/// use arrangement::{Arrangement, models::{Segment, SegmentTraits}, topology::BoundedPlane};
/// use splitstar_graph::Primal;
///
/// let ends = [[[0, 0], [2, 0]], [[2, 0], [2, 2]], [[2, 2], [0, 2]], [[0, 2], [0, 0]], [[0, 0], [2, 2]]];
/// let segments = ends.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
/// let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments);
/// // A property map; a curve that is neither horizontal nor vertical weighs 5, others 2.
/// let weight = |e: EdgeId| if arrangement.curve_of(e) == &segments[4] { 5 } else { 2 };
/// let weights = EdgeMap::from_fn(arrangement.dcel(), weight);
///
/// let graph = Primal::new(&arrangement).with_edge_weights(|e| weights[e]);
/// let corner = |at: &str| arrangement.vertices().find(|&v| arrangement.point(v).is_some_and(|p| p.to_string() == at));
/// let [from, to] = ["(0, 0)", "(2, 2)"].map(|at| corner(at).expect("it is a corner"));
/// let ways = dijkstra(graph, from, None, |edge| *edge.weight());
/// assert_eq!(ways[&to], 4);
/// ```
pub struct CellGraph<'a, C, D = Undirected, N = Ids, E = Ids> {
    base: Base<'a, C>,
    node_weights: N,
    edge_weights: E,
    way: PhantomData<fn() -> D>,
}

impl<C: Copy, D, N: Copy, E: Copy> Clone for CellGraph<'_, C, D, N, E> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C: Copy, D, N: Copy, E: Copy> Copy for CellGraph<'_, C, D, N, E> {}

impl<'a> CellGraph<'a, Vertices> {
    /// The graph of an arrangement: undirected, without infinity, the weight of a cell is its id.
    pub fn new<G: BasicTraits, T: Topology<G>>(arrangement: &'a Arrangement<G, T>) -> Self {
        // Vertices that stand for sides are the first ones.
        let (mut at_infinity, mut absent) = (0, 0);
        for v in arrangement.topology().side_vertices().into_iter().flatten() {
            at_infinity |= u8::from(arrangement.is_at_infinity(VertexId(v))) << v;
            absent |= u8::from(arrangement.is_absent(VertexId(v))) << v;
        }
        Self::of(arrangement, Vertices { at_infinity, absent })
    }
}

impl<'a> CellGraph<'a, Faces> {
    /// The dual of an arrangement: undirected, the weight of a cell is its id.
    pub fn new<G: BasicTraits, T: Topology<G>>(arrangement: &'a Arrangement<G, T>) -> Self {
        Self::of(arrangement, Faces)
    }
}

impl<'a, D, N, E> CellGraph<'a, Vertices, D, N, E> {
    /// The same with the vertices that stand for open sides of the parameter space as nodes: with the vertex at infinity, and all edges. It
    /// is there even if no curve is unbounded.
    ///
    /// Where no side is open, as in the bounded plane, on a torus and on a sphere, nothing changes: a pole is a point, and no node while
    /// nothing is there.
    pub fn with_infinity(mut self) -> Self {
        self.base.cells.at_infinity = 0;
        self
    }
}

impl<'a, C: Cells> CellGraph<'a, C> {
    fn of<G: BasicTraits, T: Topology<G>>(arrangement: &'a Arrangement<G, T>, cells: C) -> Self {
        let base = Base { dcel: arrangement.dcel(), cells };
        Self { base, node_weights: Ids, edge_weights: Ids, way: PhantomData }
    }
}

/// Edges get their weights last: a function of edges is none of halfedges.
impl<'a, C: Cells, N> CellGraph<'a, C, Undirected, N> {
    /// The same with each edge in both directions, named by halfedges.
    pub fn directed(self) -> CellGraph<'a, C, Directed, N> {
        self.with_way()
    }

    /// The same with each edge from its min to its max vertex only.
    pub fn ascending(self) -> CellGraph<'a, C, Ascending, N> {
        self.with_way()
    }

    fn with_way<D>(self) -> CellGraph<'a, C, D, N> {
        let Self { base, node_weights, edge_weights, .. } = self;
        CellGraph { base, node_weights, edge_weights, way: PhantomData }
    }
}

impl<'a, C: Cells, D: Way, N, E> CellGraph<'a, C, D, N, E> {
    /// The same with other weights of nodes.
    ///
    /// A weight that cannot be copied is given by reference.
    ///
    /// ```
    /// use petgraph::visit::{IntoNodeReferences, NodeRef};
    /// use arrangement::traits::BasicTraits;
    /// use arrangement::{Arrangement, models::{Linear, LinearTraits}, topology::UnboundedPlane};
    /// use splitstar_graph::Primal;
    ///
    /// type Point = <LinearTraits as BasicTraits>::Point;
    ///
    /// let [p, q, r] = [[0, 0], [1, 0], [0, 1]].map(Point::from_i64);
    /// let lines = [Linear::line(&p, &q), Linear::line(&p, &r)].map(|line| line.expect("the points are different"));
    /// let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines);
    /// let graph = Primal::new(&arrangement).with_node_weights(|v| arrangement.point(v));
    /// let points: Vec<_> = graph.node_references().filter_map(|node| *node.weight()).collect();
    /// assert_eq!(points, [&p]);
    /// ```
    pub fn with_node_weights<W: Copy, F: Fn(C::Id) -> W + Copy>(
        self,
        weights: F,
    ) -> CellGraph<'a, C, D, F, E> {
        let Self { base, edge_weights, way, .. } = self;
        CellGraph { base, node_weights: weights, edge_weights, way }
    }

    /// The same with other weights of edges.
    pub fn with_edge_weights<W: Copy, F: Fn(D::EdgeId) -> W + Copy>(
        self,
        weights: F,
    ) -> CellGraph<'a, C, D, N, F> {
        let Self { base, node_weights, way, .. } = self;
        CellGraph { base, node_weights, edge_weights: weights, way }
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> GraphBase for CellGraph<'_, C, D, N, E> {
    type NodeId = C::Id;
    type EdgeId = D::EdgeId;
}

impl<C: Cells, D: Way, N: Copy, E: Copy> GraphRef for CellGraph<'_, C, D, N, E> {}

impl<C: Cells, D: Way, N: Copy, E: Copy> GraphProp for CellGraph<'_, C, D, N, E> {
    type EdgeType = D::EdgeType;
}

impl<C: Cells, D: Way, N: Weights<C::Id>, E: Weights<D::EdgeId>> Data for CellGraph<'_, C, D, N, E> {
    type NodeWeight = N::Weight;
    type EdgeWeight = E::Weight;
}

impl<C: Cells, D: Way, N: Copy, E: Copy> NodeCount for CellGraph<'_, C, D, N, E> {
    fn node_count(&self) -> usize {
        self.base.cells.count(self.base.dcel)
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> EdgeCount for CellGraph<'_, C, D, N, E> {
    fn edge_count(&self) -> usize {
        D::EDGES * self.base.cells.edge_count(self.base.dcel)
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> NodeIndexable for CellGraph<'_, C, D, N, E> {
    fn node_bound(&self) -> usize {
        self.base.cells.bound(self.base.dcel)
    }

    fn to_index(&self, id: C::Id) -> usize {
        C::index(id)
    }

    fn from_index(&self, i: usize) -> C::Id {
        C::from_index(i)
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> EdgeIndexable for CellGraph<'_, C, D, N, E> {
    fn edge_bound(&self) -> usize {
        D::bound(self.base.dcel)
    }

    fn to_index(&self, id: D::EdgeId) -> usize {
        D::index(id)
    }

    fn from_index(&self, i: usize) -> D::EdgeId {
        D::from_index(i)
    }
}

impl<'a, C: Cells, D: Way, N: Copy, E: Copy> IntoNodeIdentifiers for CellGraph<'a, C, D, N, E> {
    type NodeIdentifiers = Nodes<'a, C>;

    fn node_identifiers(self) -> Nodes<'a, C> {
        self.base.nodes()
    }
}

impl<'a, C: Cells, D: Way, N: Weights<C::Id>, E: Weights<D::EdgeId>> IntoNodeReferences
    for CellGraph<'a, C, D, N, E>
{
    type NodeRef = NodeReference<C::Id, N::Weight>;
    type NodeReferences = NodeReferences<'a, C, N>;

    fn node_references(self) -> NodeReferences<'a, C, N> {
        NodeReferences { nodes: self.base.nodes(), weights: self.node_weights }
    }
}

impl<'a, C: Cells, D: Way, N: Copy, E: Copy> IntoNeighbors for CellGraph<'a, C, D, N, E> {
    type Neighbors = Neighbors<'a, C, D>;

    fn neighbors(self, id: C::Id) -> Neighbors<'a, C, D> {
        self.neighbors_directed(id, Direction::Outgoing)
    }
}

impl<'a, C: Cells, D: Way, N: Copy, E: Copy> IntoNeighborsDirected for CellGraph<'a, C, D, N, E> {
    type NeighborsDirected = Neighbors<'a, C, D>;

    fn neighbors_directed(self, id: C::Id, direction: Direction) -> Neighbors<'a, C, D> {
        Neighbors { arcs: self.base.arcs(id, direction) }
    }
}

impl<'a, C: Cells, D: Way, N: Weights<C::Id>, E: Weights<D::EdgeId>> IntoEdgeReferences
    for CellGraph<'a, C, D, N, E>
{
    type EdgeRef = EdgeReference<C::Id, D::EdgeId, E::Weight>;
    type EdgeReferences = EdgeReferences<'a, C, D, E>;

    fn edge_references(self) -> EdgeReferences<'a, C, D, E> {
        EdgeReferences { arcs: self.base.all_arcs(), weights: self.edge_weights }
    }
}

impl<'a, C: Cells, D: Way, N: Weights<C::Id>, E: Weights<D::EdgeId>> IntoEdges for CellGraph<'a, C, D, N, E> {
    type Edges = Edges<'a, C, D, E>;

    fn edges(self, id: C::Id) -> Edges<'a, C, D, E> {
        self.edges_directed(id, Direction::Outgoing)
    }
}

impl<'a, C: Cells, D: Way, N: Weights<C::Id>, E: Weights<D::EdgeId>> IntoEdgesDirected
    for CellGraph<'a, C, D, N, E>
{
    type EdgesDirected = Edges<'a, C, D, E>;

    fn edges_directed(self, id: C::Id, direction: Direction) -> Edges<'a, C, D, E> {
        Edges { arcs: self.base.arcs(id, direction), weights: self.edge_weights }
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> Visitable for CellGraph<'_, C, D, N, E> {
    type Map = NodeSet<C>;

    fn visit_map(&self) -> NodeSet<C> {
        NodeSet::new(self.node_bound())
    }

    fn reset_map(&self, map: &mut NodeSet<C>) {
        map.reset(self.node_bound());
    }
}

impl<C: Cells, D: Way, N: Copy, E: Copy> GetAdjacencyMatrix for CellGraph<'_, C, D, N, E> {
    type AdjMatrix = Adjacency<C::Id>;

    fn adjacency_matrix(&self) -> Adjacency<C::Id> {
        let neighbors = |id| self.neighbors(id).map(move |other| (id, other));
        Adjacency { pairs: self.node_identifiers().flat_map(neighbors).collect() }
    }

    fn is_adjacent(&self, matrix: &Adjacency<C::Id>, a: C::Id, b: C::Id) -> bool {
        matrix.pairs.contains(&(a, b))
    }
}
