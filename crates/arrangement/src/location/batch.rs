//! Many points at once.

use super::{Naive, PointLocation, TrapezoidalMap};
use crate::arrangement::Arrangement;
use crate::overlay::Cell;
use crate::queries::locate_by_sweep;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;

/// How many points are located together where nothing is prepared.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BatchStrategy {
    /// One by one, by looking at every cell: [`Naive`].
    Naive,
    /// By one sweep over the cells and the points.
    Sweep,
    /// By a [`TrapezoidalMap`] that is made for them.
    Trapezoids,
}

/// Up to so many points are found before a sweep has begun to be of use.
const FEW: usize = 2;

/// From about so many points for each vertex on, a sweep costs more than a search structure: it sorts them.
const MANY: usize = 8;

impl BatchStrategy {
    /// Chooses by the numbers of points and cells.
    ///
    /// Measured on short and long segments: a sweep costs about as much as three points by [`Naive`], and from about eight points for each
    /// vertex on more than it takes to make a map and search in it.
    pub fn choose<G: UMonotoneTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        points: usize,
    ) -> Self {
        let vertices = arrangement.dcel().vertex_count().max(1);
        if points <= FEW {
            Self::Naive
        } else if points / MANY <= vertices {
            Self::Sweep
        } else {
            Self::Trapezoids
        }
    }
}

/// Tells for each of many points in which cell of an arrangement it lies, in the order of the points. How, is chosen by the numbers of
/// points and cells: [`BatchStrategy::choose`].
///
/// Whoever has prepared a strategy asks that: [`PointLocation::locate_all`].
///
/// # Preconditions
/// Those of [`PointLocation`] on points.
///
/// # Panics
/// In debug builds, if a point has other coordinates than the traits know it by:
/// [`BasicTraits::is_canonical`](crate::traits::BasicTraits::is_canonical).
///
/// # Complexity
/// Expected O((n + m) log (n + m)) predicates for n cells and m points.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, locate_all, models::TorusSegmentTraits, topology::FlatTorus};
///
/// let traits = TorusSegmentTraits::new([4.into(), 4.into()])?;
/// let path = traits.closed_path(&Point2::from_i64([1, 1]), [1, 0])?;
/// let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, [&path]);
/// // (6, 5) is (2, 1), which lies on the path.
/// let point = traits.point(&Point2::from_i64([6, 5]));
/// assert!(matches!(locate_all(&arrangement, &[point])[..], [Cell::Edge(_)]));
/// # Ok::<(), splitstar_arrangement::models::TorusError>(())
/// ```
pub fn locate_all<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    points: &[G::Point],
) -> Vec<Cell> {
    let cells = match BatchStrategy::choose(arrangement, points.len()) {
        BatchStrategy::Naive => Naive.locate_all(arrangement, points),
        BatchStrategy::Sweep => return locate_by_sweep(arrangement, points),
        BatchStrategy::Trapezoids => TrapezoidalMap::new(arrangement).locate_all(arrangement, points),
    };
    cells.expect("nobody has edited the arrangement")
}
