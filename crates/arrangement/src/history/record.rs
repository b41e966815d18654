//! What runs where: kept by watching.

use super::InputId;
use super::sets::{NONE, Sets};
use crate::arrangement::{Arrangement, CurveId};
use crate::edit::{Done, Edit, EditOf, Observer};
use crate::editor::{Came, Renumbering};
use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd};
use dcel::{EdgeId, HalfedgeId, VertexId};

/// After so many edges of a vertex it is asked whether a piece ends there.
const MANY_EDGES: usize = 4;

/// A piece of an input: a u-monotone curve, or a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) input: InputId,
    /// The next piece of the same input, or the next free place.
    next: u32,
    pub(super) place: Place,
}

/// Where a piece is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// It runs from edge to edge.
    Curve {
        /// The curve, all of it.
        curve: CurveId,
        /// The edge at its min end. When edges are split or merged, the one at the min end keeps its id.
        first: EdgeId,
        /// Of each end, whether it is there only because a longer curve was cut.
        is_artificial: [bool; 2],
    },
    /// It is a point.
    Point(VertexId),
    /// It is no more.
    Nowhere,
}

/// Why there is a vertex of degree 2.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Need {
    /// An input begins or ends there, or has a point.
    Ordinary,
    /// Curves had to be cut there.
    Artificial,
    /// There is no reason.
    Redundant,
}

/// Keeps, for each edge of an arrangement, the pieces of curves that run along it, and for each piece its first edge.
///
/// It watches an [`ArrangementWithHistory`](super::ArrangementWithHistory), which also tells it what edits do not show: which piece comes,
/// and along which edges that are there already.
///
/// # Complexity
/// A piece takes 24 bytes, an edge 4. An edge with several pieces takes 4 bytes for each of them and 24 more. When an edge is split, its
/// pieces are copied.
#[derive(Clone, Debug)]
pub struct History {
    pieces: Vec<Piece>,
    first_free: u32,
    /// For each input, its first and its last piece.
    chains: Vec<[u32; 2]>,
    pub(super) of_edges: Sets,
    /// The pieces that are points.
    pub(super) of_vertices: Sets,
}

impl Default for History {
    fn default() -> Self {
        let (of_edges, of_vertices) = (Sets::default(), Sets::default());
        Self { pieces: Vec::new(), first_free: NONE, chains: Vec::new(), of_edges, of_vertices }
    }
}

impl History {
    /// The same pieces, and no cells that have them.
    pub(super) fn without_cells(&self) -> Self {
        let (of_edges, of_vertices) = (Sets::default(), Sets::default());
        let Self { pieces, first_free, chains, .. } = self;
        Self {
            pieces: pieces.clone(),
            first_free: *first_free,
            chains: chains.clone(),
            of_edges,
            of_vertices,
        }
    }

    /// Gives edges, vertices and curves new ids. A piece whose curve has no new one is named to `store`, which stores the curve again.
    pub(super) fn renumber(&mut self, to: &Renumbering, mut store: impl FnMut(u32) -> CurveId) {
        let vertex = |v| to.vertex(v).expect("the vertex of a point stays");
        let edge = |e| to.edge(e).expect("an edge stays along which a piece runs");
        for (piece, record) in (0..).zip(&mut self.pieces) {
            match &mut record.place {
                Place::Curve { curve, first, .. } => {
                    *first = edge(*first);
                    *curve = to.curve(*curve).unwrap_or_else(|| store(piece));
                }
                Place::Point(v) => *v = vertex(*v),
                Place::Nowhere => {}
            }
        }
        self.of_edges.renumber(|e| edge(EdgeId::new(e)).index());
        self.of_vertices.renumber(|v| vertex(VertexId::new(v)).index());
    }

    /// Begins an input that has no piece yet.
    pub(super) fn begin(&mut self, input: InputId) {
        if input.index() >= self.chains.len() {
            self.chains.resize(input.index() + 1, [NONE; 2]);
        }
        self.chains[input.index()] = [NONE; 2];
    }

    /// Adds a piece to an input; nothing has it yet.
    pub(super) fn add_piece(&mut self, input: InputId, place: Place) -> u32 {
        let new = Piece { input, next: NONE, place };
        let piece = if self.first_free == NONE {
            self.pieces.push(new);
            u32::try_from(self.pieces.len() - 1).expect("there are fewer than 2^31 pieces")
        } else {
            let piece = self.first_free;
            self.first_free = self.pieces[piece as usize].next;
            self.pieces[piece as usize] = new;
            piece
        };
        let [first, last] = &mut self.chains[input.index()];
        if *last == NONE {
            *first = piece;
        } else {
            self.pieces[*last as usize].next = piece;
        }
        *last = piece;
        piece
    }

    /// Notes what came of a piece of an input.
    pub(super) fn note(&mut self, input: InputId, came: Came<'_>) {
        match came {
            Came::Curve { curve, is_artificial, edges } => {
                let piece = self.add_piece(input, Place::Curve { curve, first: edges[0], is_artificial });
                for &e in edges {
                    self.add_to_edge(e, piece);
                }
            }
            Came::Point(v) => {
                let piece = self.add_piece(input, Place::Point(v));
                self.add_to_vertex(v, piece);
            }
        }
    }

    pub(super) fn add_to_edge(&mut self, e: EdgeId, piece: u32) {
        let pieces = &self.pieces;
        self.of_edges.add(e.index(), piece, |piece| key(pieces, piece));
    }

    pub(super) fn add_to_vertex(&mut self, v: VertexId, piece: u32) {
        let pieces = &self.pieces;
        self.of_vertices.add(v.index(), piece, |piece| key(pieces, piece));
    }

    /// Takes a piece from an edge, and tells whether the edge has none left.
    pub(super) fn take_from_edge(&mut self, e: EdgeId, piece: u32) -> bool {
        let pieces = &self.pieces;
        self.of_edges.take(e.index(), piece, |piece| key(pieces, piece))
    }

    /// Takes a piece from a vertex.
    pub(super) fn take_from_vertex(&mut self, v: VertexId, piece: u32) {
        let pieces = &self.pieces;
        self.of_vertices.take(v.index(), piece, |piece| key(pieces, piece));
    }

    /// Forgets an input whose pieces nothing has any more.
    pub(super) fn forget(&mut self, input: InputId) {
        let [mut piece, _] = std::mem::replace(&mut self.chains[input.index()], [NONE; 2]);
        while piece != NONE {
            let record = &mut self.pieces[piece as usize];
            record.place = Place::Nowhere;
            let next = std::mem::replace(&mut record.next, self.first_free);
            self.first_free = piece;
            piece = next;
        }
    }

    /// A piece.
    #[inline]
    pub(super) fn piece(&self, piece: u32) -> &Piece {
        &self.pieces[piece as usize]
    }

    /// The number of places for pieces.
    pub(super) fn piece_bound(&self) -> usize {
        self.pieces.len()
    }

    /// Moves a piece.
    pub(super) fn set_place(&mut self, piece: u32, place: Place) {
        self.pieces[piece as usize].place = place;
    }

    /// The pieces of an input, in the order in which the traits gave them.
    pub(super) fn pieces_of(&self, input: InputId) -> impl Iterator<Item = u32> + '_ {
        let first = self.chains.get(input.index()).map_or(NONE, |chain| chain[0]);
        let some = |piece: u32| (piece != NONE).then_some(piece);
        std::iter::successors(some(first), move |&piece| some(self.pieces[piece as usize].next))
    }

    /// The stored curve of a piece that is one.
    pub(super) fn curve(&self, piece: u32) -> Option<CurveId> {
        match self.pieces[piece as usize].place {
            Place::Curve { curve, .. } => Some(curve),
            Place::Point(_) | Place::Nowhere => None,
        }
    }

    fn first(&self, piece: u32) -> Option<EdgeId> {
        match self.pieces[piece as usize].place {
            Place::Curve { first, .. } => Some(first),
            Place::Point(_) | Place::Nowhere => None,
        }
    }

    fn is_artificial(&self, piece: u32, end: CurveEnd) -> bool {
        match self.pieces[piece as usize].place {
            Place::Curve { is_artificial, .. } => is_artificial[end as usize],
            Place::Point(_) | Place::Nowhere => false,
        }
    }

    fn has(&self, e: EdgeId, piece: u32) -> bool {
        self.of_edges.has(e.index(), piece, |piece| key(&self.pieces, piece))
    }

    /// Tells whether a piece is a point at a vertex.
    pub(super) fn has_point(&self, v: VertexId) -> bool {
        !self.of_vertices.get(v.index()).is_empty()
    }

    /// The edges along which a piece runs, from its min to its max end.
    ///
    /// # Complexity
    /// Linear in the degrees of the vertices on the way. That at which the piece ends takes constant time.
    pub(super) fn edges_of_piece<'a, G: BasicTraits, T: Topology<G>>(
        &'a self,
        arrangement: &'a Arrangement<G, T>,
        piece: u32,
    ) -> impl Iterator<Item = EdgeId> + 'a {
        let (dcel, first) = (arrangement.dcel(), self.first(piece));
        std::iter::successors(first, move |&e| {
            let start = e.halfedge();
            if arrangement.stands_for_side(dcel.target(start)) {
                return None;
            }
            let mut h = dcel.next(start);
            for step in 0.. {
                let next = h.edge_id();
                // A closed curve comes back to where it began.
                if h.is_even() && Some(next) != first && self.has(next, piece) {
                    return Some(next);
                }
                // That is asked only where it may save something.
                let is_many = step == MANY_EDGES && self.ends_at(arrangement, piece, dcel.target(start));
                if is_many || h == start.twin() {
                    return None;
                }
                h = dcel.next(h.twin());
            }
            None
        })
    }

    /// Tells whether a piece has its max end at a vertex that is a point.
    fn ends_at<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        piece: u32,
        v: VertexId,
    ) -> bool {
        let (traits, curve) = (arrangement.traits(), self.curve(piece));
        let end = curve.and_then(|curve| traits.end_point(arrangement.curve(curve), CurveEnd::Max));
        end.zip(arrangement.inner_point(v)).is_some_and(|(end, point)| traits.is_same_point(end, point))
    }

    /// Tells why there is a vertex from which these two halfedges leave.
    ///
    /// # Complexity
    /// O(k log k), if k pieces run there.
    pub(super) fn need(&self, v: VertexId, leaving: [HalfedgeId; 2]) -> Need {
        if self.has_point(v) {
            return Need::Ordinary;
        }
        // A piece that leaves on another edge than its first one has come from somewhere.
        let passes = |h: HalfedgeId, piece| {
            h.is_even() && self.first(piece) != Some(h.edge_id()) && self.has(h.edge_id(), piece)
        };
        let mut need = Need::Redundant;
        for h in leaving {
            for &piece in self.of_edges.get(h.edge()) {
                if leaving.iter().any(|&h| passes(h, piece)) {
                    continue;
                }
                let end = if h.is_even() { CurveEnd::Min } else { CurveEnd::Max };
                if !self.is_artificial(piece, end) {
                    return Need::Ordinary;
                }
                need = Need::Artificial;
            }
        }
        need
    }
}

/// Pieces of one input come together, in sets.
fn key(pieces: &[Piece], piece: u32) -> (InputId, u32) {
    (pieces[piece as usize].input, piece)
}

impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for History {
    fn after(&mut self, _: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        match (edit, done) {
            (&Edit::SplitEdge { e, kept, .. }, &Done::Edge(new)) => {
                self.of_edges.copy(e.index(), new.index());
                if kept == CurveEnd::Max {
                    self.replace_first(e, new);
                }
            }
            (_, &Done::Edge(new)) => self.of_edges.begin(new.index()),
            (&Edit::RemoveEdge { e, .. }, _) => self.of_edges.clear(e.index()),
            (&Edit::MergeEdges { kept, .. }, &Done::Merged(gone)) => {
                self.replace_first(gone, kept);
                self.of_edges.clear(gone.index());
            }
            _ => {}
        }
    }
}

impl History {
    /// Of pieces that begin with the edge `e`, the first edge is `new`.
    fn replace_first(&mut self, e: EdgeId, new: EdgeId) {
        for &piece in self.of_edges.get(e.index()) {
            if let Place::Curve { first, .. } = &mut self.pieces[piece as usize].place
                && *first == e
            {
                *first = new;
            }
        }
    }
}
