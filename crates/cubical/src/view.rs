//! Cells of the sphere without artificial vertices and edges, and how many there are.

use crate::map::{At, CubicalArrangement};
use arrangement::Counts;
use dcel::{HalfedgeId, VertexId};
use exact::gnomonic::CubeSide;

/// The map as a user sees it: real edges that meet in an artificial vertex are one.
///
/// A closed curve without a real vertex keeps one of its artificial ones. Faces are those of the map, with their ids.
#[derive(Clone, Debug)]
pub struct RealView<'a> {
    map: &'a CubicalArrangement,
    /// For each edge the halfedges that leave its ends.
    edges: Vec<[At<HalfedgeId>; 2]>,
    /// The vertices that closed curves keep, by their first copies.
    kept: Vec<At<VertexId>>,
}

impl CubicalArrangement {
    /// The real cells.
    ///
    /// # Complexity
    /// Linear.
    pub fn real_view(&self) -> RealView<'_> {
        let mut is_seen = CubeSide::ALL.map(|side| vec![false; self.side(side).dcel().edge_bound()]);
        let mut edges = Vec::new();
        let mut kept = Vec::new();
        // Edges that end in real vertices first; what is left are closed curves.
        for v in self.real_vertices() {
            for h in self.real_around(v) {
                if !is_seen[h.side.index()][h.id.edge()] {
                    edges.push([h, self.twin(self.see_chain(h, &mut is_seen))]);
                }
            }
        }
        for side in CubeSide::ALL {
            for e in self.side(side).dcel().edges() {
                let h = At { side, id: self.inner_halfedge(At { side, id: e }) };
                if self.is_real(h) && !is_seen[side.index()][e.index()] {
                    edges.push([h, self.twin(self.see_chain(h, &mut is_seen))]);
                    kept.push(self.first_copy(self.source(h)));
                }
            }
        }
        RealView { map: self, edges, kept }
    }

    /// Marks the edges from a halfedge on, and gives the last one.
    fn see_chain(&self, first: At<HalfedgeId>, is_seen: &mut [Vec<bool>; 6]) -> At<HalfedgeId> {
        let mut last = first;
        for h in self.chain(first) {
            for h in [h, self.twin(h)] {
                is_seen[h.side.index()][h.id.edge()] = true;
            }
            last = h;
        }
        last
    }

    /// The real halfedges from one on along its arc, up to the first real vertex, or once around a closed curve.
    pub fn chain(&self, first: At<HalfedgeId>) -> impl Iterator<Item = At<HalfedgeId>> + '_ {
        std::iter::successors(Some(first), move |&h| self.real_after(h).filter(|&next| next != first))
    }

    /// The real halfedge that continues one past an artificial vertex; `None` if it ends at a real one.
    fn real_after(&self, h: At<HalfedgeId>) -> Option<At<HalfedgeId>> {
        let target = self.target(h);
        if self.is_real_vertex(target) {
            return None;
        }
        let back = self.twin(h);
        let around = std::iter::successors(Some(back), |&h| Some(self.next(self.twin(h)))).skip(1);
        let next = around.take_while(|&other| other != back).find(|&other| self.is_real(other));
        Some(next.expect("an arc does not end in an artificial vertex"))
    }

    /// Counts real cells: vertices, edges, faces of the sphere, isolated vertices, and components of what is drawn.
    ///
    /// A closed curve without a real vertex counts as one vertex and one edge: see [`CubicalArrangement::real_view`]. Euler's relation holds: v - e + f = 1 + c.
    ///
    /// # Complexity
    /// Linear.
    pub fn counts(&self) -> Counts {
        let view = self.real_view();
        let vertices: Vec<At<VertexId>> = view.vertices().collect();
        let isolated = vertices.iter().filter(|&&v| self.real_around(v).next().is_none()).count();
        let number = |v: At<VertexId>| {
            vertices.binary_search(&self.first_copy(v)).expect("edges end in vertices of the view")
        };
        let mut parents: Vec<usize> = (0..vertices.len()).collect();
        let mut components = vertices.len();
        for edge in 0..view.edge_count() {
            let [a, b] = view.ends(edge).map(|v| find(&mut parents, number(v)));
            if a != b {
                parents[a] = b;
                components -= 1;
            }
        }
        Counts {
            vertices: vertices.len(),
            edges: view.edge_count(),
            faces: self.face_count(),
            isolated,
            components,
        }
    }

    /// Counts all cells of the six sides, artificial ones, copies and unbounded faces too. The tables of the thesis count so, but halfedges instead of edges.
    ///
    /// # References
    /// Thesis, tables 3.2 and 3.3.
    pub fn counts_with_artificial(&self) -> Counts {
        CubeSide::ALL.map(|side| self.side(side).counts_with_splits()).into_iter().fold(
            Counts::default(),
            |all, counts| Counts {
                vertices: all.vertices + counts.vertices,
                edges: all.edges + counts.edges,
                faces: all.faces + counts.faces,
                isolated: all.isolated + counts.isolated,
                components: all.components + counts.components,
            },
        )
    }
}

impl<'a> RealView<'a> {
    /// The map that is seen.
    pub fn map(&self) -> &'a CubicalArrangement {
        self.map
    }

    /// The vertices, each by its first copy, in order.
    pub fn vertices(&self) -> impl Iterator<Item = At<VertexId>> + use<> {
        let mut vertices: Vec<At<VertexId>> =
            self.map.real_vertices().chain(self.kept.iter().copied()).collect();
        vertices.sort_unstable();
        vertices.into_iter()
    }

    /// The artificial vertices that closed curves keep, by their first copies.
    pub fn kept_vertices(&self) -> &[At<VertexId>] {
        &self.kept
    }

    /// The number of edges; they are counted from 0.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The halfedges that leave the two ends of an edge along it. For a closed curve both leave the one vertex that it has.
    ///
    /// # Panics
    /// If there are not so many edges.
    pub fn end_halfedges(&self, edge: usize) -> [At<HalfedgeId>; 2] {
        self.edges[edge]
    }

    /// The vertices of an edge, by their first copies, in the order of [`RealView::end_halfedges`].
    ///
    /// # Panics
    /// If there are not so many edges.
    pub fn ends(&self, edge: usize) -> [At<VertexId>; 2] {
        self.edges[edge].map(|h| self.map.first_copy(self.map.source(h)))
    }

    /// The halfedges along an edge, from the first of its ends to the second.
    ///
    /// # Panics
    /// If there are not so many edges.
    pub fn halfedges(&self, edge: usize) -> impl Iterator<Item = At<HalfedgeId>> + 'a {
        self.map.chain(self.edges[edge][0])
    }
}

fn find(parents: &mut [usize], mut vertex: usize) -> usize {
    while parents[vertex] != vertex {
        parents[vertex] = parents[parents[vertex]];
        vertex = parents[vertex];
    }
    vertex
}
