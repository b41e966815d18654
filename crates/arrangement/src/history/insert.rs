//! An input comes.

use super::{ArrangementWithHistory, Input, InputId, InputOf};
use crate::edit::{Observer, Operation};
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, Piece};

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> ArrangementWithHistory<G, T, O> {
    /// Inserts a general curve.
    ///
    /// # Complexity
    /// That of [`Editor::insert_curve`](crate::Editor::insert_curve), and linear in the number of pairs of an edge that is split or runs
    /// along the curve and an input on it.
    pub fn insert(&mut self, curve: &G::Curve) -> InputId {
        let mut pieces = Vec::new();
        self.traits().make_u_monotone(curve, &mut pieces);
        let id = self.put(Input::Curve(curve.clone()));
        self.editor
            .insert_noting(Operation::InsertCurve, pieces, |(history, _), came| history.note(id, came));
        id
    }

    /// Inserts a point: an isolated vertex in a face, or a vertex that divides an edge, or one that is there already.
    ///
    /// # Preconditions
    /// Those of [`Editor`](crate::Editor) on points.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order, and linear in the number of inputs on the edge that is split.
    pub fn insert_point(&mut self, point: &G::Point) -> InputId {
        let id = self.put(Input::Point(point.clone()));
        let piece = [Piece::Point(point.clone())];
        self.editor.insert_noting(Operation::InsertPoint, piece, |(history, _), came| history.note(id, came));
        id
    }

    /// Gives an input an id, and begins its history.
    pub(super) fn put(&mut self, input: InputOf<G>) -> InputId {
        let id = self.free.pop().unwrap_or_else(|| {
            self.inputs.push(None);
            InputId(u32::try_from(self.inputs.len() - 1).expect("there are fewer than 2^31 inputs"))
        });
        self.inputs[id.index()] = Some(input);
        self.editor.observers_mut().0.begin(id);
        id
    }
}
