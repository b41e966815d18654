//! What the history needs of the editor.

use super::Editor;
use crate::arrangement::{CurveId, Parts};
use crate::edit::{Edit, Observer, Operation};
use crate::topology::Topology;
use crate::traits::{Piece, UMonotoneTraits};
use crate::trapezoids::Trapezoids;
use dcel::{EdgeId, VertexId};

/// What came of a piece of a curve.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Came<'a> {
    /// It runs along edges, from its min to its max end.
    Curve {
        /// The piece, as it is stored.
        curve: CurveId,
        /// Of each end, whether it is there only because a longer curve was cut.
        is_artificial: [bool; 2],
        /// The edges, at least one.
        edges: &'a [EdgeId],
    },
    /// It is a point.
    Point(VertexId),
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts pieces of a curve, and tells the observers what came of each before the next one comes.
    pub(crate) fn insert_noting(
        &mut self,
        operation: Operation,
        pieces: impl IntoIterator<Item = Piece<G::Point, G::UMonotoneCurve>>,
        mut note: impl FnMut(&mut O, Came<'_>),
    ) {
        self.operate(operation, |editor| {
            let mut edges = Vec::new();
            for piece in pieces {
                match piece {
                    Piece::Curve { curve, is_artificial } => {
                        edges.clear();
                        let id = u32::try_from(editor.arrangement.curves().len());
                        let id = CurveId(id.expect("there are fewer than 2^32 curves"));
                        editor.run(curve, is_artificial, &mut edges);
                        note(&mut editor.observers, Came::Curve { curve: id, is_artificial, edges: &edges });
                    }
                    Piece::Point(point) => {
                        let v = editor.add_point(&point);
                        note(&mut editor.observers, Came::Point(v));
                    }
                }
            }
        });
    }

    /// Does an operation between the brackets that observers see.
    pub(crate) fn operate_on<R>(&mut self, operation: Operation, operate: impl FnOnce(&mut Self) -> R) -> R {
        self.operate(operation, operate)
    }

    /// Says whether a vertex is there only because a curve was cut.
    pub(crate) fn mark(&mut self, v: VertexId, is_artificial: bool) {
        if self.arrangement.is_artificial[v.index()] != is_artificial {
            self.arrangement.apply(Edit::SetArtificial { v, is_artificial }, &mut self.observers);
        }
    }

    /// Stores a curve.
    pub(crate) fn store_curve(&mut self, curve: G::UMonotoneCurve) -> CurveId {
        self.arrangement.apply(Edit::AddCurve { curve }, &mut self.observers).curve()
    }

    /// Puts an edge on another curve that runs through the same points between its ends.
    pub(crate) fn put_on(&mut self, e: EdgeId, curve: CurveId) {
        self.set_support(e, curve);
    }

    /// Replaces all cells; `renew` brings observers up to date that need to be told more than that.
    pub(crate) fn replace_all(&mut self, parts: Parts<G>, renew: impl FnOnce(&mut O)) {
        self.arrangement.apply_global(&mut self.observers, |arrangement| arrangement.set_parts(parts));
        self.trapezoids = Trapezoids::of(&self.arrangement);
        renew(&mut self.observers);
    }
}
