//! What is compared: vertices and darts by numbers that do not depend on how the arrangement was made.

use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{CcbKind, FaceId, HalfedgeId, VertexId};

/// The user's view of an arrangement in numbers.
#[derive(Clone, Debug)]
pub(super) struct Skeleton {
    /// The vertices: those at infinity first, then the others in the order of their points.
    pub(super) vertices: Vec<VertexId>,
    /// For each vertex, its first dart; one more at the end.
    pub(super) first_darts: Vec<u32>,
    /// For each dart the halfedge with which it begins. The darts of a vertex are consecutive, counterclockwise.
    pub(super) darts: Vec<HalfedgeId>,
    /// For each dart its vertex.
    pub(super) sources: Vec<u32>,
    /// The darts in the opposite direction.
    pub(super) twins: Vec<u32>,
    /// The faces on the left, and whether they are there on an outer CCB.
    pub(super) faces: Vec<FaceId>,
    pub(super) is_outer: Vec<bool>,
    /// How many vertices are at infinity.
    pub(super) special_count: usize,
}

impl Skeleton {
    pub(super) fn new<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        let (view, dcel) = (arrangement.user_view(), arrangement.dcel());
        let is_seen = |v: &VertexId| !view.is_hidden(*v) && !arrangement.is_absent(*v);
        let mut vertices: Vec<VertexId> = dcel.vertices().filter(is_seen).collect();
        vertices.sort_by(|&v, &w| arrangement.compare_vertices(v, w));
        let special_count = vertices.iter().filter(|&&v| arrangement.is_at_infinity(v)).count();
        let (mut first_darts, mut darts, mut sources) = (vec![0], Vec::new(), Vec::new());
        let mut dart_of = vec![u32::MAX; dcel.halfedge_bound()];
        for (i, &v) in vertices.iter().enumerate() {
            let start = dcel.around(v).min_by(|&a, &b| arrangement.compare_around(a, b));
            let from_start = start.into_iter().flat_map(|start| {
                let around = dcel.around(v);
                let before = dcel.around(v).take_while(move |&h| h != start);
                around.skip_while(move |&h| h != start).chain(before)
            });
            for h in from_start {
                dart_of[h.index()] = darts.len() as u32;
                darts.push(h);
                sources.push(i as u32);
            }
            first_darts.push(darts.len() as u32);
        }
        let mut twins = vec![u32::MAX; darts.len()];
        for edge in view.edges() {
            let [a, b] = view.end_halfedges(edge).map(|h| dart_of[h.index()]);
            twins[a as usize] = b;
            twins[b as usize] = a;
        }
        let faces = darts.iter().map(|&h| dcel.face(h)).collect();
        let is_outer = darts.iter().map(|&h| dcel.ccb_kind(dcel.ccb(h)) == CcbKind::Outer).collect();
        Self { vertices, first_darts, darts, sources, twins, faces, is_outer, special_count }
    }

    pub(super) fn degree(&self, vertex: usize) -> usize {
        (self.first_darts[vertex + 1] - self.first_darts[vertex]) as usize
    }

    /// The dart that follows counterclockwise around its vertex.
    pub(super) fn around(&self, dart: usize) -> usize {
        let vertex = self.sources[dart] as usize;
        let [first, end] = [0, 1].map(|i| self.first_darts[vertex + i] as usize);
        if dart + 1 == end { first } else { dart + 1 }
    }

    /// The same seen from the other side of the surface.
    pub(super) fn mirror(&mut self) {
        self.faces = self.twins.iter().map(|&t| self.faces[t as usize]).collect();
        self.is_outer = self.twins.iter().map(|&t| self.is_outer[t as usize]).collect();
        // Dart d of a vertex becomes the one that is as far from its end.
        let place = |d: usize| {
            let vertex = self.sources[d] as usize;
            (self.first_darts[vertex] + self.first_darts[vertex + 1] - 1) as usize - d
        };
        let places: Vec<usize> = (0..self.darts.len()).map(place).collect();
        self.darts = places.iter().map(|&d| self.darts[d]).collect();
        self.twins = places.iter().map(|&d| places[self.twins[d] as usize] as u32).collect();
        self.faces = places.iter().map(|&d| self.faces[d]).collect();
        self.is_outer = places.iter().map(|&d| self.is_outer[d]).collect();
    }
}

/// Which face of one arrangement is which of the other, as far as it is known.
#[derive(Debug)]
pub(super) struct FaceMap {
    images: [Vec<FaceId>; 2],
    /// What was connected, to take it back.
    log: Vec<[FaceId; 2]>,
}

impl FaceMap {
    pub(super) fn new(bound_a: usize, bound_b: usize) -> Self {
        Self { images: [vec![FaceId::NONE; bound_a], vec![FaceId::NONE; bound_b]], log: Vec::new() }
    }

    /// Notes that two faces are the same; `false` if one of them is the same as another one already.
    pub(super) fn connect(&mut self, a: FaceId, b: FaceId) -> bool {
        match (self.images[0][a.index()], self.images[1][b.index()]) {
            (FaceId::NONE, FaceId::NONE) => {
                self.images[0][a.index()] = b;
                self.images[1][b.index()] = a;
                self.log.push([a, b]);
                true
            }
            (image, _) => image == b,
        }
    }

    /// How much is known: to be given to [`FaceMap::forget`].
    pub(super) fn len(&self) -> usize {
        self.log.len()
    }

    /// Takes back all that was connected since then.
    pub(super) fn forget(&mut self, len: usize) {
        for [a, b] in self.log.drain(len..) {
            self.images[0][a.index()] = FaceId::NONE;
            self.images[1][b.index()] = FaceId::NONE;
        }
    }
}
