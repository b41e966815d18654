//! Location of many points by one sweep.

use crate::arrangement::Arrangement;
use crate::overlay::Cell;
use crate::sweep::{Around, CellNumbers, Event, Progress, SweepInput, SweepVisitor, Watched, sweep};
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, UMonotoneTraits};
use dcel::{EdgeId, FaceId};
use std::ops::ControlFlow;

/// Tells by one sweep for each of many points in which cell of an arrangement it lies, in the order of the points.
///
/// # Preconditions
/// Where sides of the parameter space are identified, points have the coordinates by which the traits know them: on a torus, those
/// that [`TorusSegmentTraits::point`](crate::models::TorusSegmentTraits::point) gives. The answer for another point is wrong.
///
/// # Panics
/// In debug builds, if a point has other coordinates: [`BasicTraits::is_canonical`].
///
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, locate_by_sweep, models::TorusSegmentTraits, topology::FlatTorus};
///
/// let traits = TorusSegmentTraits::new([4.into(), 4.into()])?;
/// let path = traits.closed_path(&Point2::from_i64([1, 1]), [1, 0])?;
/// let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, [&path]);
/// // (6, 5) is (2, 1), which lies on the path.
/// let point = traits.point(&Point2::from_i64([6, 5]));
/// assert!(matches!(locate_by_sweep(&arrangement, &[point])[..], [Cell::Edge(_)]));
/// # Ok::<(), splitstar_arrangement::models::TorusError>(())
/// ```
///
/// # Complexity
/// O((n + m) log (n + m)) predicates for n cells and m points.
///
/// # References
/// Thesis, section 2.4.1.
pub fn locate_by_sweep<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    points: &[G::Point],
) -> Vec<Cell> {
    locate_by_sweep_with(arrangement, points, |_| ControlFlow::Continue(())).expect("nobody stops the sweep")
}

/// Does what [`locate_by_sweep`] does; now and then `watch` is told how far the sweep has come, and may stop it. Then there is no answer.
///
/// # Preconditions
/// Those of [`locate_by_sweep`].
///
/// # Complexity
/// That of [`locate_by_sweep`]. `watch` is called once in about a thousand events.
pub fn locate_by_sweep_with<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    points: &[G::Point],
    watch: impl FnMut(Progress) -> ControlFlow<()>,
) -> Option<Vec<Cell>> {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let (input, numbers) = SweepInput::of_arrangement(arrangement, points);
    let first_query = numbers.vertices.len();
    let face = arrangement.corner_face();
    let locator = Locator {
        arrangement,
        input: &input,
        numbers,
        first_query,
        cells: vec![Cell::Face(face); points.len()],
        bottom: face,
    };
    let mut watched = Watched::new(locator, input.site_count(), watch);
    let swept = sweep(traits, topology, &input, &mut watched);
    swept.is_continue().then(|| watched.into_inner().cells)
}

struct Locator<'a, 'i, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    input: &'i SweepInput<'a, G>,
    numbers: CellNumbers,
    first_query: usize,
    cells: Vec<Cell>,
    /// The face below all strands.
    bottom: FaceId,
}

impl<G: BasicTraits, T: Topology<G>> Locator<'_, '_, G, T> {
    fn edge(&self, curve: usize) -> EdgeId {
        self.numbers.edges[curve]
    }

    /// The cell of an event, if no vertex is there.
    fn cell(&self, around: &Around<'_, Option<EdgeId>>) -> Cell {
        let through = around.left.first().or(around.right.first());
        match (through, around.below.flatten()) {
            (Some(strand), _) => Cell::Edge(self.edge(strand.curve())),
            (None, Some(below)) => Cell::Face(self.arrangement.dcel().face(below.halfedge())),
            (None, None) => Cell::Face(self.bottom),
        }
    }
}

impl<G: BasicTraits, T: Topology<G>> SweepVisitor<G> for Locator<'_, '_, G, T> {
    type Tag = Option<EdgeId>;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, Self::Tag>) -> ControlFlow<()> {
        let queries = self.first_query..self.first_query + self.cells.len();
        let mut cell = None;
        for site in event.input_sites.iter().map(|&site| site as usize).filter(|site| queries.contains(site))
        {
            let found = *cell.get_or_insert_with(|| {
                // A vertex on an identified side may have its sites at other places of its point: then an image is here.
                let mut originals =
                    event.input_sites.iter().map(|&site| self.input.original_site(site as usize));
                let vertex = originals.find_map(|site| self.numbers.vertices.get(site));
                let at_contraction = self.arrangement.cell_at_contraction(event.site.location);
                let at_vertex = at_contraction.or(vertex.map(|&v| Cell::Vertex(v)));
                at_vertex.unwrap_or_else(|| self.cell(around))
            });
            self.cells[site - self.first_query] = found;
        }
        for strand in around.right.iter_mut() {
            strand.tag = Some(self.edge(strand.curve()));
        }
        if event.site.location.v == Along::Low && event.site.location.u == Along::Inside {
            let dcel = self.arrangement.dcel();
            match (around.right.first(), around.left.last()) {
                (Some(first), _) => self.bottom = dcel.face(self.edge(first.curve()).halfedge().twin()),
                (None, Some(last)) => self.bottom = dcel.face(self.edge(last.curve()).halfedge()),
                (None, None) => {}
            }
        }
        ControlFlow::Continue(())
    }
}
