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

#[cfg(test)]
mod corner_tests;
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
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use crate::trapezoids::Trapezoids;
pub use global::Renumbering;
pub(crate) use hooks::Came;
pub use merge::{MergedEdges, VertexNeed, VertexNeeded};
pub use modify::SplitParts;
use std::ops::Deref;

/// An arrangement that is edited, with what finds places in it, and observers.
///
/// It reads as the [`Arrangement`] that it has. Ids of cells that an edit does not remove stay: of an edge that is split, the part at the
/// min end keeps the id; of a face that is split, the larger part as the decomposition has it, and the other one is new, be it the
/// [corner face](Arrangement::corner_face) or not. Ids of removed cells are used again. [`Editor::compact`] and aggregated insertion give new ids
/// to all.
///
/// A curve that was inserted stays stored when its edges are removed, until [`compact`](Self::compact): an editor that lives long, with
/// curves that come and go, should be compacted now and then.
///
/// # Preconditions
/// Points and curves that are given to it are of the traits of the arrangement. On a torus, points have the coordinates that
/// [`TorusSegmentTraits::point`](crate::models::TorusSegmentTraits::point) gives, and curves are made by traits with the same periods; on a
/// sphere, curves are cut by traits with the same identification.
/// With others, answers are wrong, the arrangement is not valid then, and a method may panic.
///
/// # Complexity
/// It keeps the vertical decomposition of the arrangement: at most three trapezoids for each vertex, and a search structure of expected
/// linear size. A step of a curve from a trapezoid to the next costs a constant number of predicates, however many edges and
/// holes the face has.
///
/// When an edge splits a face, the trapezoids of both parts are visited in step. That is linear in the number of trapezoids of the smaller
/// part, and the holes and isolated vertices in it move in constant time each, however many the larger part has. If the face has no holes
/// and is not the corner face, nothing is visited. When an edge is removed between two faces, the CCBs and isolated vertices of the one that
/// has fewer move.
///
/// To find a place takes expected O(log n) steps if curves came in random order, as they do after [`Editor::new`]. After an adverse
/// order of edits it is O(sqrt(n) log n) for those that edit, amortized: when searches were too long, the next edit builds all anew. Searches that
/// only read count as well, but cannot do that; [`Editor::compact`] does.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, Editor, topology::BoundedPlane};
///
/// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
/// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
/// let first = editor.insert_curve(&segment([[0, 0], [4, 4]]));
/// let second = editor.insert_curve(&segment([[0, 4], [4, 0]]));
/// assert_eq!((first.len(), second.len()), (1, 2), "the second one is cut where it crosses the first");
/// assert_eq!(editor.counts().edges, 4);
///
/// // Where they cross, and on the part of the first that kept its id.
/// let Cell::Vertex(crossing) = editor.locate(&Point2::from_i64([2, 2])) else { panic!("it is a vertex") };
/// assert_eq!(editor.locate(&Point2::from_i64([1, 1])), Cell::Edge(first[0]));
///
/// for e in second {
///     editor.remove_edge(e);
/// }
/// editor.remove_vertex(crossing)?;
/// assert_eq!(editor.counts().edges, 1);
/// # Ok::<(), splitstar_arrangement::VertexNeeded>(())
/// ```
///
/// # References
/// Thesis, sections 2.3.2 and 2.4.3.
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
    ///
    /// One that is put in place of another is not asked whether it is up to date.
    pub fn observers_mut(&mut self) -> &mut O {
        &mut self.observers
    }

    /// Ends editing.
    pub fn finish(self) -> (Arrangement<G, T>, O) {
        (self.arrangement, self.observers)
    }

    /// Finds the cell in which a point lies.
    ///
    /// # Preconditions
    /// Those of [`Editor`] on points. The answer for another point is wrong.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order. A face is named by an edge of its boundary, so holes cost nothing; on identified
    /// sides it may take a step for each vertex there from which no edge goes to the right.
    pub fn locate(&self, point: &G::Point) -> Cell {
        self.trapezoids.locate(&self.arrangement, point)
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
