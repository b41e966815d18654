//! Is each CCB outer or inner as it says? That depends on how often it turns, and on nothing else.

use super::Violation;
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{CcbId, CcbKind};

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Compares the kinds of CCBs with their turns. The halfedges around each vertex must be in order.
    ///
    /// Along a cycle, the direction changes between right and left at a vertex by half a turn to the left, or, if the corner contains
    /// the whole other side of the vertex, to the right. A CCB turns once to the left, once to the right, or, where it winds round the
    /// surface, not at all; it is an inner one if it turns to the right. What passes through a side is an outer one.
    pub(super) fn check_kinds(&self, found: &mut Vec<Violation>) {
        // The halfedges that leave a vertex behind a corner with a whole side in it.
        let mut is_wrap = vec![false; self.dcel.halfedge_bound()];
        for v in self.vertices() {
            let around = self.sorted_around(v);
            if let (Some(first), Some(last)) = (around.first(), around.last())
                && first.is_even() == last.is_even()
            {
                is_wrap[last.index()] = true;
            }
        }
        let kind = |c: CcbId| {
            let (mut half_turns, mut is_through_side) = (0_i64, false);
            for h in self.dcel.ccb_cycle(c) {
                half_turns += i64::from(self.dcel.next(h).is_even() != h.is_even());
                half_turns -= 2 * i64::from(is_wrap[h.index()]);
                is_through_side |= self.stands_for_side(self.dcel.source(h));
            }
            if half_turns < 0 && !is_through_side { CcbKind::Inner } else { CcbKind::Outer }
        };
        found.extend(self.dcel.ccbs().filter(|&c| kind(c) != self.dcel.ccb_kind(c)).map(Violation::Kind));
    }
}
