//! An input goes.

use super::record::{Need, Place};
use super::{ArrangementWithHistory, History, Input, InputId};
use crate::arrangement::{CurveId, assemble::covers};
use crate::edit::{Observer, Operation};
use crate::editor::Editor;
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, Intersection, UMonotoneTraits};
use dcel::{EdgeId, EndFate, VertexId};

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> ArrangementWithHistory<G, T, O> {
    /// Removes an input, and gives it back; `None` if there is none of this id.
    ///
    /// Edges along which no other input runs go. So do vertices that are there for no other input, and the edges on both sides of such a
    /// vertex become one. A vertex at which the curves that are left were only cut becomes artificial again.
    ///
    /// # Complexity
    /// For each edge that goes, as of [`Editor::remove_edge`], and for each that is merged, as of [`Editor::merge_edges`]; and linear in
    /// the degrees of the vertices through which the input passes, because the next edge of a curve is found by going round the vertex. So
    /// to remove d curves one by one that pass through one vertex takes O(d^2) such steps in all, which compare nothing; if they end there, O(d).
    /// To find the next edge faster, each curve would need a list of its edges, which would be kept whenever an edge is split or merged. For
    /// traits whose [overlaps are not plain](crate::traits::BasicTraits::OVERLAPS_ARE_PLAIN), also the intersections of all curves that are
    /// left where the input overlapped several.
    pub fn remove(&mut self, id: InputId) -> Option<Input<G::Curve, G::Point>> {
        let input = self.inputs.get_mut(id.index())?.take()?;
        self.editor.operate_on(Operation::RemoveCurve, |editor| Removal { editor, overlap: None }.remove(id));
        self.free.push(id);
        Some(input)
    }
}

/// The removal of an input.
struct Removal<'e, G: UMonotoneTraits, T, O> {
    editor: &'e mut Editor<G, T, (History, O)>,
    /// Several pieces, and their common curve: where they overlapped last.
    overlap: Option<(Vec<u32>, CurveId)>,
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Removal<'_, G, T, O> {
    fn remove(mut self, id: InputId) {
        let (covered, mut touched) = self.take(id);
        for &(e, curve) in &covered {
            if self.is_bare(e) {
                let fates = self.editor.arrangement().dcel().ends(e).map(|v| self.fate(v));
                self.editor.take_out_edge(e, fates);
            } else {
                self.leave(e, curve);
            }
        }
        touched.sort_unstable();
        touched.dedup();
        for v in touched {
            let arrangement = self.editor.arrangement();
            if arrangement.dcel().has_vertex(v) && !arrangement.is_at_infinity(v) {
                self.settle(v);
            }
        }
    }

    /// Takes an input from the history. Gives the edges along which it ran, each once and with the curve of a piece, and the
    /// vertices on the way.
    fn take(&mut self, id: InputId) -> (Vec<(EdgeId, CurveId)>, Vec<VertexId>) {
        let (arrangement, history) = (self.editor.arrangement(), &self.editor.observers().0);
        let (mut covered, mut touched) = (Vec::new(), Vec::new());
        let mut points = Vec::new();
        for piece in history.pieces_of(id) {
            match history.piece(piece).place {
                Place::Curve { curve, .. } => {
                    for e in history.edges_of_piece(arrangement, piece) {
                        covered.push((e, piece, curve));
                        touched.extend(arrangement.dcel().ends(e));
                    }
                }
                Place::Point(v) => {
                    points.push((v, piece));
                    touched.push(v);
                }
                Place::Nowhere => {}
            }
        }
        let history = &mut self.editor.observers_mut().0;
        for &(e, piece, _) in &covered {
            history.take_from_edge(e, piece);
        }
        for &(v, piece) in &points {
            history.take_from_vertex(v, piece);
        }
        history.forget(id);
        let mut covered: Vec<_> = covered.into_iter().map(|(e, _, curve)| (e, curve)).collect();
        if covered.len() > 1 {
            // Pieces of one curve may overlap.
            covered.sort_unstable();
        }
        covered.dedup_by_key(|(e, _)| *e);
        (covered, touched)
    }

    fn history(&self) -> &History {
        &self.editor.observers().0
    }

    fn pieces(&self, e: EdgeId) -> &[u32] {
        self.history().of_edges.get(e.index())
    }

    fn is_bare(&self, e: EdgeId) -> bool {
        self.pieces(e).is_empty()
    }

    fn fate(&self, v: VertexId) -> EndFate {
        if self.history().has_point(v) { EndFate::Isolate } else { EndFate::Remove }
    }

    /// A vertex through which the input ran.
    fn settle(&mut self, v: VertexId) {
        let leaving = {
            let mut around = self.editor.arrangement().dcel().around(v);
            (around.next(), around.next(), around.next())
        };
        match leaving {
            (None, ..) if self.history().has_point(v) => self.editor.mark(v, false),
            (None, ..) => self.editor.take_out_isolated(v),
            (Some(a), Some(b), None) => match self.history().need(v, [a, b]) {
                Need::Ordinary => self.editor.mark(v, false),
                Need::Artificial => self.editor.mark(v, true),
                Need::Redundant => self.merge(v, [a, b].map(|h| h.edge_id())),
            },
            _ => self.editor.mark(v, false),
        }
    }

    /// A vertex that all pieces pass.
    fn merge(&mut self, v: VertexId, edges: [EdgeId; 2]) {
        let arrangement = self.editor.arrangement();
        let [before, after] =
            if arrangement.dcel().ends(edges[0])[1] == v { edges } else { [edges[1], edges[0]] };
        if arrangement.support(before) != arrangement.support(after) {
            let ends = [arrangement.dcel().ends(before)[0], arrangement.dcel().ends(after)[1]];
            if let Some(curve) = self.common_curve(before, ends) {
                self.editor.put_on(before, curve);
                self.editor.put_on(after, curve);
            }
        }
        let merged = self.editor.merge_redundant(v);
        debug_assert!(merged.is_ok(), "a curve passes, so the edges are one");
    }

    /// An edge along which a removed curve ran gets the others as its support.
    fn leave(&mut self, e: EdgeId, curve: CurveId) {
        let arrangement = self.editor.arrangement();
        if !G::OVERLAPS_ARE_PLAIN || arrangement.support(e) == curve {
            let ends = arrangement.dcel().ends(e);
            if let Some(curve) = self.common_curve(e, ends) {
                self.editor.put_on(e, curve);
            }
        }
    }

    /// A curve for an edge between two vertices, along which the pieces of an edge run: one of them, or what all have in common.
    fn common_curve(&mut self, e: EdgeId, ends: [VertexId; 2]) -> Option<CurveId> {
        let mut curves: Vec<CurveId> =
            self.pieces(e).iter().filter_map(|&piece| self.history().curve(piece)).collect();
        // Older curves come first.
        curves.sort_unstable();
        let (&first, others) = curves.split_first()?;
        if G::OVERLAPS_ARE_PLAIN || others.is_empty() {
            return Some(first);
        }
        let arrangement = self.editor.arrangement();
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let points = ends.map(|v| arrangement.inner_point(v));
        if let Some((pieces, curve)) = &self.overlap
            && pieces == self.pieces(e)
            && covers(traits, topology, arrangement.curve(*curve), points)
        {
            return Some(*curve);
        }
        let mut overlap = arrangement.curve(first).clone();
        for &other in others {
            let mut common = Vec::new();
            traits.intersect(&overlap, arrangement.curve(other), &mut common);
            overlap = common.into_iter().find_map(|intersection| match intersection {
                Intersection::Overlap(overlap) if covers(traits, topology, &overlap, points) => Some(overlap),
                _ => None,
            })?;
        }
        let curve = self.editor.store_curve(overlap);
        self.overlap = Some((self.pieces(e).to_vec(), curve));
        Some(curve)
    }
}
