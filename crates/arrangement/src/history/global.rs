//! All is numbered anew, or dropped.

use super::{ArrangementWithHistory, History};
use crate::edit::{Observer, Operation};
use crate::editor::Renumbering;
use crate::topology::Topology;
use crate::traits::ArrangementTraits;
use std::collections::BTreeMap;

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> ArrangementWithHistory<G, T, O> {
    /// Makes the ids of all kinds of cells dense again, and drops curves that are of no input any more. Gives the new ids. Inputs keep
    /// theirs.
    ///
    /// # Complexity
    /// As of [`Editor::compact`](crate::Editor::compact).
    pub fn compact(&mut self) -> Renumbering {
        let mut is_used = vec![false; self.curves().len()];
        for e in self.dcel().edges() {
            is_used[self.support(e).index()] = true;
        }
        // Where others overlap it everywhere, a piece may be nowhere the support.
        let (history, arrangement) = (self.history(), self.arrangement());
        let pieces =
            (0..history.piece_bound() as u32).filter_map(|piece| Some((piece, history.curve(piece)?)));
        let unused = pieces.filter(|(_, curve)| !is_used[curve.index()]);
        let mut unused: BTreeMap<u32, _> =
            unused.map(|(piece, curve)| (piece, arrangement.curve(curve).clone())).collect();
        let renumbering = self.editor.compact();
        self.editor.operate_on(Operation::Modify, |editor| {
            let mut history = std::mem::take(&mut editor.observers_mut().0);
            history.renumber(&renumbering, |piece| {
                editor.store_curve(unused.remove(&piece).expect("the curve of a piece was kept"))
            });
            editor.observers_mut().0 = history;
        });
        renumbering
    }

    /// Removes all inputs. Ids begin at 0 again.
    ///
    /// # Complexity
    /// Linear, to drop what was there.
    pub fn clear(&mut self) {
        self.editor.clear();
        self.editor.observers_mut().0 = History::default();
        self.inputs.clear();
        self.free.clear();
    }
}
