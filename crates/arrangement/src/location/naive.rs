//! Location that looks at every cell.

use super::over::{Bar, Column};
use super::{PointLocation, VerticalRay};
use crate::arrangement::Arrangement;
use crate::edit::Stale;
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;

/// Looks at every vertex and edge. Nothing is prepared, so it is good for a few points only, and to check others.
///
/// # Complexity
/// A query takes O(n) predicates.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::location::{Naive, PointLocation, VerticalRay};
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
///
/// let bars = [[[0, 0], [4, 0]], [[1, 2], [3, 2]], [[2, 2], [2, 5]]];
/// let bars = bars.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
/// let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &bars);
/// let point = Point2::from_i64([2, 1]);
/// let Cell::Vertex(above) = Naive.shoot(&arrangement, &point, VerticalRay::Up)? else { panic!("a vertex is at (2, 2)") };
/// assert!(matches!(Naive.shoot(&arrangement, &point, VerticalRay::Down)?, Cell::Edge(_)));
/// // From the vertex, the ray begins along an edge.
/// let point = arrangement.point(above).expect("it is not at infinity");
/// assert!(matches!(Naive.shoot(&arrangement, point, VerticalRay::Up)?, Cell::Edge(_)));
/// // Beside all, it leaves through a face.
/// let point = Point2::from_i64([9, 1]);
/// let face = Cell::Face(arrangement.corner_face());
/// assert_eq!(Naive.shoot(&arrangement, &point, VerticalRay::Up)?, face);
/// # Ok::<(), splitstar_arrangement::edit::Stale>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Naive;

impl Naive {
    /// All that is on the line.
    fn bars<'a, G: UMonotoneTraits, T: Topology<G>>(
        arrangement: &'a Arrangement<G, T>,
        column: &'a Column<'_, G, T>,
    ) -> impl Iterator<Item = Bar> + 'a {
        let dcel = arrangement.dcel();
        let vertices = dcel.vertices().filter(|&v| column.has_vertex(v)).map(Bar::Vertex);
        vertices.chain(dcel.edges().filter(|&e| column.has_edge(e)).map(Bar::Edge))
    }

    fn cell<G: UMonotoneTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        column: &Column<'_, G, T>,
    ) -> Cell {
        if let Some(cell) = column.at_contraction() {
            return cell;
        }
        let dcel = arrangement.dcel();
        let vertex = dcel.vertices().find(|&v| column.is_at(v)).map(Cell::Vertex);
        let at = vertex.or_else(|| dcel.edges().find(|&e| column.is_on(e)).map(Cell::Edge));
        column.cell(at, || column.first(Self::bars(arrangement, column), VerticalRay::Down))
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> PointLocation<G, T> for Naive {
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale> {
        Ok(Self::cell(arrangement, &Column::new(arrangement, point)))
    }

    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale> {
        let column = Column::new(arrangement, point);
        let cell = Self::cell(arrangement, &column);
        Ok(column.shoot(cell, |_| Self::bars(arrangement, &column), ray))
    }
}
