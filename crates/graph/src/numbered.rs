//! Nodes numbered without gaps.

use petgraph::Direction;
use petgraph::visit::{
    Data, EdgeCount, EdgeIndexable, GetAdjacencyMatrix, GraphBase, GraphProp, IntoEdgeReferences, IntoEdges,
    IntoEdgesDirected, IntoNeighbors, IntoNeighborsDirected, IntoNodeIdentifiers, IntoNodeReferences,
    NodeCompactIndexable, NodeCount, NodeIndexable, Visitable,
};

/// A graph, with its nodes numbered from 0 without gaps.
///
/// Ids stay as they are; only the index of a node is another one, its place among all nodes. It is for algorithms that
/// want [`NodeCompactIndexable`]. They take a reference to it.
///
/// # Complexity
/// Two tables of numbers are made once, in linear time: 4 bytes for each possible index, and an id for each node.
///
/// # Examples
/// ```
/// use petgraph::algo::connected_components;
/// use arrangement::traits::BasicTraits;
/// use arrangement::{Arrangement, models::{Linear, LinearTraits}, topology::UnboundedPlane};
/// use splitstar_graph::{Dual, Numbered, Primal};
///
/// type Point = <LinearTraits as BasicTraits>::Point;
///
/// // Two lines that cross, and a segment elsewhere.
/// let [p, q, r, s] = [[0, 0], [1, 0], [0, 1], [1, 1]].map(Point::from_i64);
/// let curves = [Linear::line(&p, &q), Linear::line(&p, &r), Linear::segment(s, Point::from_i64([2, 3]))];
/// let curves = curves.map(|curve| curve.expect("the points are different"));
/// let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &curves);
/// assert_eq!(connected_components(&Numbered::new(Primal::new(&arrangement))), 2);
/// assert_eq!(connected_components(&Numbered::new(Dual::new(&arrangement))), 1);
/// ```
#[derive(Clone)]
pub struct Numbered<G: GraphBase> {
    graph: G,
    nodes: Vec<G::NodeId>,
    /// For each index of the graph, the place of its node.
    places: Vec<u32>,
}

impl<G: IntoNodeIdentifiers + NodeIndexable> Numbered<G> {
    /// Numbers the nodes of a graph.
    ///
    /// # Panics
    /// If there are 2^32 nodes or more.
    pub fn new(graph: G) -> Self {
        let nodes: Vec<_> = graph.node_identifiers().collect();
        let mut places = vec![u32::MAX; graph.node_bound()];
        for (place, &node) in nodes.iter().enumerate() {
            places[graph.to_index(node)] = u32::try_from(place).expect("there are fewer than 2^32 nodes");
        }
        Self { graph, nodes, places }
    }

    /// The graph itself.
    pub fn graph(&self) -> G {
        self.graph
    }

    /// The nodes, in the order of their numbers.
    pub fn nodes(&self) -> &[G::NodeId] {
        &self.nodes
    }
}

impl<G: GraphBase> GraphBase for Numbered<G> {
    type NodeId = G::NodeId;
    type EdgeId = G::EdgeId;
}

impl<G: NodeIndexable> NodeIndexable for Numbered<G> {
    fn node_bound(&self) -> usize {
        self.nodes.len()
    }

    /// # Panics
    /// If it is no node of the graph and its index is above those of all nodes.
    fn to_index(&self, id: G::NodeId) -> usize {
        self.places[self.graph.to_index(id)] as usize
    }

    /// # Panics
    /// If there are not so many nodes.
    fn from_index(&self, i: usize) -> G::NodeId {
        self.nodes[i]
    }
}

impl<G: NodeIndexable> NodeCompactIndexable for Numbered<G> {}

impl<G: GraphBase> NodeCount for Numbered<G> {
    fn node_count(&self) -> usize {
        self.nodes.len()
    }
}

impl<G: EdgeCount> EdgeCount for Numbered<G> {
    fn edge_count(&self) -> usize {
        self.graph.edge_count()
    }
}

impl<G: EdgeIndexable> EdgeIndexable for Numbered<G> {
    fn edge_bound(&self) -> usize {
        self.graph.edge_bound()
    }

    fn to_index(&self, id: G::EdgeId) -> usize {
        self.graph.to_index(id)
    }

    fn from_index(&self, i: usize) -> G::EdgeId {
        self.graph.from_index(i)
    }
}

impl<G: GraphProp> GraphProp for Numbered<G> {
    type EdgeType = G::EdgeType;
}

impl<G: Data> Data for Numbered<G> {
    type NodeWeight = G::NodeWeight;
    type EdgeWeight = G::EdgeWeight;
}

impl<G: Visitable> Visitable for Numbered<G> {
    type Map = G::Map;

    fn visit_map(&self) -> G::Map {
        self.graph.visit_map()
    }

    fn reset_map(&self, map: &mut G::Map) {
        self.graph.reset_map(map);
    }
}

impl<G: GetAdjacencyMatrix> GetAdjacencyMatrix for Numbered<G> {
    type AdjMatrix = G::AdjMatrix;

    fn adjacency_matrix(&self) -> G::AdjMatrix {
        self.graph.adjacency_matrix()
    }

    fn is_adjacent(&self, matrix: &G::AdjMatrix, a: G::NodeId, b: G::NodeId) -> bool {
        self.graph.is_adjacent(matrix, a, b)
    }
}

impl<G: IntoNodeIdentifiers> IntoNodeIdentifiers for &Numbered<G> {
    type NodeIdentifiers = G::NodeIdentifiers;

    fn node_identifiers(self) -> G::NodeIdentifiers {
        self.graph.node_identifiers()
    }
}

impl<G: IntoNodeReferences> IntoNodeReferences for &Numbered<G> {
    type NodeRef = G::NodeRef;
    type NodeReferences = G::NodeReferences;

    fn node_references(self) -> G::NodeReferences {
        self.graph.node_references()
    }
}

impl<G: IntoNeighbors> IntoNeighbors for &Numbered<G> {
    type Neighbors = G::Neighbors;

    fn neighbors(self, id: G::NodeId) -> G::Neighbors {
        self.graph.neighbors(id)
    }
}

impl<G: IntoNeighborsDirected> IntoNeighborsDirected for &Numbered<G> {
    type NeighborsDirected = G::NeighborsDirected;

    fn neighbors_directed(self, id: G::NodeId, direction: Direction) -> G::NeighborsDirected {
        self.graph.neighbors_directed(id, direction)
    }
}

impl<G: IntoEdgeReferences> IntoEdgeReferences for &Numbered<G> {
    type EdgeRef = G::EdgeRef;
    type EdgeReferences = G::EdgeReferences;

    fn edge_references(self) -> G::EdgeReferences {
        self.graph.edge_references()
    }
}

impl<G: IntoEdges> IntoEdges for &Numbered<G> {
    type Edges = G::Edges;

    fn edges(self, id: G::NodeId) -> G::Edges {
        self.graph.edges(id)
    }
}

impl<G: IntoEdgesDirected> IntoEdgesDirected for &Numbered<G> {
    type EdgesDirected = G::EdgesDirected;

    fn edges_directed(self, id: G::NodeId, direction: Direction) -> G::EdgesDirected {
        self.graph.edges_directed(id, direction)
    }
}
