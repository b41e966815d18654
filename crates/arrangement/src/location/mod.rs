//! Point location and vertical ray shooting: in which cell a point lies, and what is straight above or below it.
//!
//! One trait, [`PointLocation`], and strategies that differ in what they prepare. All give the same answers.
//!
//! | strategy | prepares | a query | follows edits |
//! |---|---|---|---|
//! | [`Naive`] | nothing | O(n) | as it prepares nothing |
//! | [`Walk`] | nothing | sizes of the faces along a vertical line | as it prepares nothing |
//! | [`Landmarks`] | O(n log n) | a k-d tree, and a walk that is expected to be short | no: made anew |
//! | [`TrapezoidalMap`] | expected O(n log n) | expected O(log n) | as an observer |
//!
//! For many points at once, [`locate_all`] chooses between one sweep and a structure. An [`Editor`](crate::Editor) keeps a trapezoidal map
//! for itself, and locates without another.
//!
//! # References
//! Thesis, sections 2.4.5 and 6.1.3.

mod batch;
mod landmarks;
mod naive;
mod over;
#[cfg(test)]
mod tests;
mod trapezoidal;
mod walk;

use crate::arrangement::Arrangement;
use crate::edit::Stale;
use crate::overlay::Cell;
use crate::traits::BasicTraits;
pub use batch::{BatchStrategy, locate_all};
pub use landmarks::{LandmarkGenerator, Landmarks};
pub use naive::Naive;
pub use trapezoidal::TrapezoidalMap;
pub use walk::Walk;

/// Which way a vertical ray goes: v grows, or falls, and u stays.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum VerticalRay {
    /// To greater v.
    Up,
    /// To lesser v.
    Down,
}

impl VerticalRay {
    /// Up and down.
    pub const BOTH: [Self; 2] = [Self::Up, Self::Down];
}

/// Finds the cell in which a point lies, and what a vertical ray from there meets.
///
/// A strategy that prepared something knows for which state of which arrangement, and says so if it is asked about another: an answer is
/// never that of cells that are no more.
///
/// # Preconditions
/// Points are of the traits of the arrangement. Where sides of the parameter space are identified, they have the coordinates by which the
/// traits know them: on a torus, those that [`TorusSegmentTraits::point`](crate::models::TorusSegmentTraits::point) gives. The answer for
/// another point is wrong.
pub trait PointLocation<G: BasicTraits, T> {
    /// Finds the vertex, edge or face in which a point lies.
    ///
    /// # Errors
    /// If the strategy is for another state of the arrangement, or for another arrangement.
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale>;

    /// Finds the cells in which points lie, in the order of the points.
    ///
    /// Where nothing is prepared, the function [`locate_all`] is the better way.
    ///
    /// # Errors
    /// As [`locate`](Self::locate).
    fn locate_all(&self, arrangement: &Arrangement<G, T>, points: &[G::Point]) -> Result<Vec<Cell>, Stale> {
        points.iter().map(|point| self.locate(arrangement, point)).collect()
    }

    /// Finds the vertex or edge that a vertical ray meets first; if there is none, the face through which it leaves.
    ///
    /// The point from which the ray starts does not count, nor does a vertex or an edge that it leaves at once. But a vertical edge along
    /// which the ray begins is met: at once.
    ///
    /// The ray ends at sides of the parameter space: where it comes to a contracted one at whose vertex curves end, or where a point was
    /// given, the answer is that vertex. From the point to which a side is contracted no ray goes: the answer is the cell of the point.
    /// Where bottom and top are identified it goes on, on the other side: what lies on these sides comes first, and then what is next to
    /// the opposite one. If it comes back to where it started, that is what it meets: the vertex or edge there; or nothing, and the face is
    /// the answer. Where left and right are identified, a ray from there runs along the seam, and meets the vertices and edges on it.
    ///
    /// From a vertex that nothing is above, the face is the one straight above it, and so downwards.
    ///
    /// # Errors
    /// As [`locate`](Self::locate).
    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale>;
}
