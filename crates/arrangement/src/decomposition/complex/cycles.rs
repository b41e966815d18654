//! The boundary of each face.

use super::super::records::NONE;
use super::super::walls::Step;
use super::super::{SiteId, Trapezoid, TrapezoidId, VerticalDecomposition};
use super::DecompositionComplex;
use super::columns::{LEFT, RIGHT};
use super::pieces::Pieces;
use crate::arrangement::Arrangement;
use crate::edit::Stale;
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits};
use dcel::{CcbId, CcbKind, Dcel, EdgeId, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, VertexId};

/// Puts pieces together around each trapezoid.
pub(super) fn link<G: BasicTraits, T: Topology<G>>(
    decomposition: &VerticalDecomposition,
    arrangement: &Arrangement<G, T>,
    pieces: Pieces,
) -> Result<DecompositionComplex, Stale> {
    let mut linker = Linker { decomposition, pieces: &pieces, boundary: Vec::new() };
    let mut halfedges = Vec::with_capacity(2 * pieces.ends.len());
    let mut outgoing = vec![HalfedgeId::NONE; pieces.vertices.len()];
    for source in pieces.ends.iter().flatten().map(|&source| VertexId(source)) {
        outgoing[source.index()] = HalfedgeId::new(halfedges.len());
        halfedges.push(Halfedge { next: HalfedgeId::NONE, prev: HalfedgeId::NONE, source, ccb: CcbId::NONE });
    }
    let (mut faces, mut ccbs) = (Vec::new(), Vec::new());
    for t in decomposition.trapezoids().filter(|&t| !decomposition.is_degenerate(t)) {
        linker.boundary.clear();
        linker.walk(t);
        let face = FaceId::new(faces.len());
        faces.push((t, decomposition.face_of(arrangement, t)?));
        let Some((&first, &last)) = linker.boundary.first().zip(linker.boundary.last()) else { continue };
        let ccb = CcbId::new(ccbs.len());
        ccbs.push(RawCcb { first, face, kind: CcbKind::Outer });
        let mut before = last;
        for &h in &linker.boundary {
            halfedges[before.index()].next = h;
            halfedges[h.index()].ccb = ccb;
            before = h;
        }
    }
    // Without curves and points, there is one face around the vertex at infinity.
    let is_isolated = |v: &VertexId| outgoing[v.index()] == HalfedgeId::NONE;
    let isolated =
        (0..outgoing.len()).map(VertexId::new).filter(is_isolated).map(|v| (v, FaceId(0))).collect();
    let raw = RawDcel { halfedges, face_count: faces.len(), ccbs, isolated, outgoing };
    let Pieces { vertices, edges, .. } = pieces;
    let stamp = decomposition.stamp();
    Ok(DecompositionComplex { stamp, dcel: Dcel::from_parts(raw), vertices, edges, faces })
}

struct Linker<'p> {
    decomposition: &'p VerticalDecomposition,
    pieces: &'p Pieces,
    /// The halfedges around the present trapezoid, counterclockwise.
    boundary: Vec<HalfedgeId>,
}

impl Linker<'_> {
    /// Goes around a trapezoid: below to the right, upwards, above to the left, and downwards.
    fn walk(&mut self, t: TrapezoidId) {
        let trapezoid = self.decomposition.trapezoid(t);
        // What is above an edge along the bottom is above the bottom.
        let is_bottom = trapezoid.below.is_none_or(|e| self.decomposition.is_along_bottom(e));
        let below = trapezoid.below.filter(|_| !is_bottom);
        let columns = self.pieces.columns.of_trapezoid(&trapezoid);
        let [along_below, along_above] = self.pieces.along[t.index()];
        let level = self.along_level(columns);
        let [from, to] = if is_bottom { level } else { along_below };
        self.boundary.extend((from..to).map(|piece| EdgeId(piece).halfedge()));
        let trapezoid = Trapezoid { below, ..trapezoid };
        self.go_up(&trapezoid, columns[1]);
        let [from, to] = if trapezoid.above.is_none() { level } else { along_above };
        self.boundary.extend((from..to).rev().map(|piece| EdgeId(piece).halfedge().twin()));
        self.go_down(&trapezoid, columns[0]);
    }

    /// The pieces of an identified bottom or top side between two columns.
    fn along_level(&self, columns: [u32; 2]) -> [u32; 2] {
        let place = |level: &super::sides::Level, column| level.first + level.place(column);
        self.pieces.level.as_ref().map_or([0; 2], |level| columns.map(|column| place(level, column)))
    }

    /// The pieces of an identified left or right side between the ends of two edges.
    fn along_left(&self, below: Option<SiteId>, above: Option<SiteId>) -> std::ops::Range<u32> {
        let Some(left) = &self.pieces.left else { return 0..0 };
        let from = below.map_or(0, |site| left.place(site));
        let to = above.map_or(left.count, |site| left.place(site));
        left.first + from..left.first + to
    }

    fn push(&mut self, piece: u32, is_up: bool) {
        debug_assert!(piece != NONE, "a wall that is met was made");
        let h = EdgeId(piece).halfedge();
        self.boundary.push(if is_up { h } else { h.twin() });
    }

    /// Appends what is on the right of a trapezoid.
    fn go_up(&mut self, t: &Trapezoid, column: u32) {
        let Self { decomposition, pieces, .. } = *self;
        let end = |e: Option<EdgeId>| e.map(|e| decomposition.ends(e)[1]);
        let [below, above] = [end(t.below), end(t.above)];
        if column == RIGHT {
            let along = self.along_left(below, above);
            return self.boundary.extend(along.map(|piece| EdgeId(piece).halfedge()));
        }
        let mut site = match (below.filter(|&site| pieces.columns.of(site) == column), t.right) {
            (Some(site), _) => site,
            (None, Some(site)) => {
                if decomposition.location(site).v != Along::Low {
                    self.push(pieces.walls[site.index()][0], true);
                }
                site
            }
            (None, None) => return,
        };
        while above != Some(site) {
            let step = decomposition.step_up(site);
            match step {
                Step::Out => return,
                Step::Along(e, _) => self.push(pieces.first_piece[e.index()], true),
                Step::Site(_) | Step::Edge(_) | Step::Side => self.push(pieces.walls[site.index()][1], true),
            }
            match step {
                Step::Site(next) | Step::Along(_, next) => site = next,
                Step::Edge(_) | Step::Side | Step::Out => return,
            }
        }
    }

    /// Appends what is on the left of a trapezoid.
    fn go_down(&mut self, t: &Trapezoid, column: u32) {
        let Self { decomposition, pieces, .. } = *self;
        let end = |e: Option<EdgeId>| e.map(|e| decomposition.ends(e)[0]);
        let [below, above] = [end(t.below), end(t.above)];
        if column == LEFT {
            let along = self.along_left(below, above);
            return self.boundary.extend(along.rev().map(|piece| EdgeId(piece).halfedge().twin()));
        }
        let mut site = match (above.filter(|&site| pieces.columns.of(site) == column), t.left) {
            (Some(site), _) => site,
            (None, Some(site)) => {
                if decomposition.location(site).v != Along::High {
                    self.push(pieces.walls[site.index()][1], false);
                }
                site
            }
            (None, None) => return,
        };
        while below != Some(site) {
            let step = decomposition.step_down(site);
            match step {
                Step::Out => return,
                Step::Along(e, _) => self.push(pieces.first_piece[e.index()], false),
                Step::Site(_) | Step::Edge(_) | Step::Side => self.push(pieces.walls[site.index()][0], false),
            }
            match step {
                Step::Site(next) | Step::Along(_, next) => site = next,
                Step::Edge(_) | Step::Side | Step::Out => return,
            }
        }
    }
}
