//! Editing an arrangement: curves and points come and go one by one.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the editor: the arrangement, its decomposition, and those who watch |
//! | `place` | vertices where curves begin, end and meet |
//! | `edge` | an edge comes, its place around its vertices, and what becomes of the face |
//! | `rotation` | after which halfedges a new one comes |
//! | `curve` | a curve comes, wherever it runs |
//! | `local`, `modify` | edits whose neighbours are known; what changes where nothing moves |
//! | `remove`, `merge` | edges and vertices go; two edges become one |
//! | `hooks` | what the history needs |
//! | `global` | all is numbered anew, dropped, or swept again |

mod curve;
mod edge;
mod global;
mod hooks;
mod local;
mod merge;
mod modify;
mod place;
#[cfg(test)]
mod removal_tests;
mod remove;
mod rotation;
#[cfg(test)]
mod tests;
mod undo;

use crate::arrangement::Arrangement;
use crate::edit::{Observer, Operation, Stale};
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::UMonotoneTraits;
use crate::trapezoids::{Found, Toward, Trapezoids, side};
pub use global::Renumbering;
pub(crate) use hooks::Came;
pub use merge::{MergedEdges, VertexNeed, VertexNeeded};
pub use modify::SplitParts;
use std::ops::Deref;

/// An arrangement that is edited, with what finds places in it, and observers.
///
/// It reads as the [`Arrangement`] that it has.
#[derive(Clone, Debug)]
pub struct Editor<G: UMonotoneTraits, T, O = ()> {
    arrangement: Arrangement<G, T>,
    trapezoids: Trapezoids<G>,
    observers: O,
}

impl<G: UMonotoneTraits, T, O> Deref for Editor<G, T, O> {
    type Target = Arrangement<G, T>;

    fn deref(&self) -> &Arrangement<G, T> {
        &self.arrangement
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Editor<G, T> {
    /// Begins to edit an arrangement.
    ///
    /// # Complexity
    /// Expected O(n log n), for n cells.
    pub fn new(arrangement: Arrangement<G, T>) -> Self {
        let trapezoids = Trapezoids::of(&arrangement);
        Self { arrangement, trapezoids, observers: () }
    }
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Begins to edit an arrangement that is watched.
    ///
    /// # Errors
    /// If an observer is up to date with another state of the arrangement, or with another arrangement.
    ///
    /// # Complexity
    /// Expected O(n log n), for n cells.
    pub fn with_observers(arrangement: Arrangement<G, T>, observers: O) -> Result<Self, Stale> {
        observers.check_stamp(arrangement.stamp())?;
        let trapezoids = Trapezoids::of(&arrangement);
        Ok(Self { arrangement, trapezoids, observers })
    }

    /// The arrangement, as it is now.
    pub fn arrangement(&self) -> &Arrangement<G, T> {
        &self.arrangement
    }

    /// Its decomposition.
    pub(crate) fn trapezoids(&self) -> &Trapezoids<G> {
        &self.trapezoids
    }

    /// Those who watch.
    pub fn observers(&self) -> &O {
        &self.observers
    }

    /// Those who watch, to be changed.
    pub fn observers_mut(&mut self) -> &mut O {
        &mut self.observers
    }

    /// Ends editing.
    pub fn finish(self) -> (Arrangement<G, T>, O) {
        (self.arrangement, self.observers)
    }

    /// Finds the cell in which a point lies.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order.
    pub fn locate(&self, point: &G::Point) -> Cell {
        let arrangement = &self.arrangement;
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        match self.trapezoids.search(arrangement, &place, &Toward::Here).0 {
            Found::Site(site) => Cell::Vertex(self.trapezoids.vertex(site)),
            Found::Within(t) => {
                let below = self.trapezoids.trapezoid(t).below;
                if !below.is_none() {
                    let rail = self.trapezoids.rail(below);
                    if side(arrangement, &place, &arrangement.curves()[rail.curve as usize]).is_eq() {
                        return Cell::Edge(rail.edge);
                    }
                }
                Cell::Face(self.trapezoids.face_of(arrangement, t))
            }
        }
    }

    /// Does an operation of a user between the brackets that observers see.
    fn operate<R>(&mut self, operation: Operation, operate: impl FnOnce(&mut Self) -> R) -> R {
        self.observers.begin_operation(&self.arrangement, operation);
        let result = operate(self);
        self.renew_if_worn();
        self.observers.end_operation(&self.arrangement, operation);
        result
    }

    /// Builds the decomposition anew if searches take too long.
    fn renew_if_worn(&mut self) {
        if self.trapezoids.is_worn() {
            self.trapezoids = Trapezoids::of(&self.arrangement);
        }
    }
}
