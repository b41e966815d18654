//! Location by a walk along the vertical line through the point.

use super::over::{Bar, Column, Reach};
use super::{PointLocation, VerticalRay};
use crate::arrangement::Arrangement;
use crate::edit::Stale;
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{EdgeId, FaceId};
use std::cmp::Ordering;
use std::collections::HashMap;

/// Walks along the vertical line through the point, from face to face. Nothing is prepared.
///
/// The walk begins at the first edge that is found to have the u of the point, and goes towards the point: it looks for what the line
/// meets next on the boundary of the face, crosses it, and so on until the point is not behind that.
///
/// # Complexity
/// To find the beginning, about n / k edges are looked at if k of n have the u of the point. Then it takes a number
/// linear in the sizes of the faces that are passed, each counted once, and O(log k) for each step.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::location::{Naive, PointLocation, VerticalRay, Walk};
/// use splitstar_arrangement::models::{Linear, LinearTraits};
/// use splitstar_arrangement::{Arrangement, topology::UnboundedPlane};
///
/// let [p, q, r] = [[0, 0], [1, 1], [1, 0]].map(Point2::from_i64);
/// let lines = [Linear::line(&p, &q), Linear::line(&p, &r), Linear::line(&q, &r)].map(|line| line.expect("points are different"));
/// let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines);
/// for point in [[5, 2], [5, 5], [5, 0], [1, 1], [1, 7]].map(Point2::from_i64) {
///     assert_eq!(Walk.locate(&arrangement, &point), Naive.locate(&arrangement, &point));
///     for ray in VerticalRay::BOTH {
///         assert_eq!(Walk.shoot(&arrangement, &point, ray), Naive.shoot(&arrangement, &point, ray));
///     }
/// }
/// ```
///
/// # References
/// Thesis, section 2.4.5, "walk along a line".
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Walk;

/// What of the boundary of a face is on the line, in its order from below.
fn boundary<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    column: &Column<'_, G, T>,
    face: FaceId,
) -> Vec<Bar> {
    let dcel = arrangement.dcel();
    let mut bars = Vec::new();
    for h in dcel.face_ccbs(face).flat_map(|ccb| dcel.ccb_cycle(ccb)) {
        bars.extend(Some(dcel.source(h)).filter(|&v| column.has_vertex(v)).map(Bar::Vertex));
        bars.extend(Some(h.edge_id()).filter(|&e| column.has_edge(e)).map(Bar::Edge));
    }
    bars.extend(dcel.isolated_vertices(face).filter(|&v| column.has_vertex(v)).map(Bar::Vertex));
    bars.sort_unstable_by(|&a, &b| column.compare(a, b));
    // Both halves of an edge may be on the boundary, and a vertex at several corners of it.
    bars.dedup();
    bars
}

/// The bar next to one of a face, in the direction of a ray.
fn next<G: UMonotoneTraits, T: Topology<G>>(
    column: &Column<'_, G, T>,
    bars: &[Bar],
    last: Bar,
    ray: VerticalRay,
) -> Option<Bar> {
    match ray {
        VerticalRay::Up => bars[bars.partition_point(|&bar| column.compare(bar, last).is_le())..].first(),
        VerticalRay::Down => bars[..bars.partition_point(|&bar| column.compare(bar, last).is_lt())].last(),
    }
    .copied()
}

/// Where a walk begins.
enum Start {
    /// On the line.
    Bar(Bar),
    /// At the point.
    There(Cell),
}

/// All numbers below a bound, each once, such that the first few are scattered evenly: edges that a sweep made are in the order of u.
fn scattered(bound: usize) -> impl Iterator<Item = u32> {
    let bound = bound as u64;
    let are_coprime = |mut a: u64, mut b: u64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a == 1
    };
    // Multiples of the golden ratio leave no large gap.
    let step = (bound * 618 / 1000..bound).find(|&step| are_coprime(step, bound)).unwrap_or(1);
    (0..bound).scan(0, move |at, _| {
        let number = *at as u32;
        *at = (*at + step) % bound;
        Some(number)
    })
}

fn start<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    column: &Column<'_, G, T>,
) -> Option<Start> {
    let dcel = arrangement.dcel();
    let mut edges = scattered(dcel.edge_bound()).map(EdgeId).filter(|&e| dcel.has_edge(e));
    let at_edge = edges.find_map(|e| match column.reach(e) {
        Reach::Beside => None,
        Reach::Across => Some(Start::Bar(Bar::Edge(e))),
        Reach::Along if column.is_on(e) => Some(Start::There(Cell::Edge(e))),
        Reach::Along => {
            dcel.ends(e).into_iter().find(|&v| column.has_vertex(v)).map(|v| Start::Bar(Bar::Vertex(v)))
        }
    });
    at_edge.or_else(|| dcel.vertices().find(|&v| column.has_vertex(v)).map(|v| Start::Bar(Bar::Vertex(v))))
}

fn walk<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    column: &Column<'_, G, T>,
) -> Cell {
    if let Some(cell) = column.at_contraction() {
        return cell;
    }
    let mut bar = match start(arrangement, column) {
        None => return Cell::Face(column.bottom_face()),
        Some(Start::There(cell)) => return cell,
        Some(Start::Bar(bar)) => bar,
    };
    // A line may pass a face with many holes many times.
    let mut known: HashMap<FaceId, Vec<Bar>> = HashMap::new();
    let ray = if column.compare_with_point(bar).is_lt() { VerticalRay::Up } else { VerticalRay::Down };
    let behind = if ray == VerticalRay::Up { Ordering::Greater } else { Ordering::Less };
    while column.compare_with_point(bar).is_ne() {
        let along = match bar {
            Bar::Vertex(v) => column.along(v, ray),
            Bar::Edge(_) => None,
        };
        if let Some(e) = along {
            if column.is_on(e) {
                return Cell::Edge(e);
            }
            let [min, max] = arrangement.dcel().ends(e);
            bar = Bar::Vertex(if ray == VerticalRay::Up { max } else { min });
        } else {
            let face = column.face_beside(bar.cell(), ray);
            let bars = known.entry(face).or_insert_with(|| boundary(arrangement, column, face));
            match next(column, bars, bar, ray) {
                // Behind the point: it is in between.
                Some(next) if column.compare_with_point(next) == behind => return Cell::Face(face),
                Some(next) => bar = next,
                None => return Cell::Face(face),
            }
        }
    }
    bar.cell()
}

impl<G: UMonotoneTraits, T: Topology<G>> PointLocation<G, T> for Walk {
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale> {
        Ok(walk(arrangement, &Column::new(arrangement, point)))
    }

    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale> {
        let column = Column::new(arrangement, point);
        let cell = walk(arrangement, &column);
        Ok(column.shoot(cell, |face| boundary(arrangement, &column, face).into_iter(), ray))
    }
}
