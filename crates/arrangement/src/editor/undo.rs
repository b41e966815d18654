//! Operations are taken back.

use super::Editor;
use crate::edit::{Observer, Recorded, Stale};
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use crate::trapezoids::Follower;

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Takes an operation back that an [`Undo`](crate::edit::Undo) recorded.
    ///
    /// # Errors
    /// If the arrangement is not in the state to which the operation led it. Then nothing is changed.
    ///
    /// # Complexity
    /// That of the operation, and a search for each edge that comes back.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::edit::Undo;
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let empty = Arrangement::new(SegmentTraits, BoundedPlane);
    /// let undo = Undo::new(&empty);
    /// let mut editor = Editor::with_observers(empty, undo)?;
    /// for ends in [[[0, 0], [2, 2]], [[0, 2], [2, 0]]] {
    ///     editor.insert_curve(&Segment::from_i64(ends).expect("the ends are different"));
    /// }
    /// assert_eq!(editor.arrangement().counts().edges, 4);
    /// let last = editor.observers_mut().pop().expect("two operations were recorded");
    /// editor.take_back(last)?;
    /// assert_eq!(editor.arrangement().counts().edges, 1);
    /// # Ok::<(), splitstar_arrangement::edit::Stale>(())
    /// ```
    pub fn take_back(&mut self, operation: Recorded<G>) -> Result<(), Stale> {
        let Self { arrangement, trapezoids, observers } = self;
        operation.take_back(arrangement, &mut (Follower(trapezoids), observers))?;
        self.renew_if_worn();
        Ok(())
    }
}
