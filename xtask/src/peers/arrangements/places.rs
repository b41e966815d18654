//! Where cells of arrangements of the library are found for points one by one, and where arrangements are decomposed.
//!
//! As in `ours`, every function prepares its operands, does the operation once, and times that alone.

use arrangement::Arrangement;
use arrangement::decomposition::{VerticalDecomposition, WallEnd};
use arrangement::location::{Landmarks, Naive, PointLocation, TrapezoidalMap, VerticalRay, Walk};
use arrangement::models::{GeodesicTraits, SegmentTraits};
use arrangement::overlay::Cell;
use arrangement::topology::{BoundedPlane, Sphere, Topology};
use arrangement::traits::{ApproxTraits, ArrangementTraits, UMonotoneTraits};
use arrangement::wrappers::CountingTraits;

use super::once::{Found, Located, timed};
use super::ours::{
    NO_CURVES, Surface, arcs, directions, found, located, of_arcs, of_segments, planar_points, segments,
};
use super::task::{Curves, Family, Operation, Question, Strategy, Task};
use crate::Failure;

/// What it costs to find cells one by one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Search {
    pub(crate) strategy: Strategy,
    /// Seconds before the first point.
    pub(crate) prepare: f64,
    /// Seconds for a point.
    pub(crate) query: f64,
    /// Predicates that are asked of the traits for a point.
    pub(crate) calls: f64,
    /// Comparisons on the longest path of a search structure.
    pub(crate) path: Option<u32>,
}

/// A strategy that is ready.
type Ready<G, T> = Box<dyn PointLocation<G, T>>;

fn ready<G, T>(strategy: Strategy, arrangement: &Arrangement<G, T>) -> Ready<G, T>
where
    G: UMonotoneTraits + ApproxTraits + 'static,
    T: Topology<G>,
{
    match strategy {
        Strategy::Naive => Box::new(Naive),
        Strategy::Walk => Box::new(Walk),
        Strategy::Landmarks => Box::new(Landmarks::new(arrangement)),
        Strategy::Trapezoids => Box::new(TrapezoidalMap::new(arrangement)),
    }
}

/// What a strategy does before the first point, for an arrangement that is made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn prepare(curves: &Curves, strategy: Strategy) -> Result<Found, Failure> {
    let arrangement = of_segments(curves)?;
    let (_ready, seconds) = timed(|| ready(strategy, &arrangement));
    Ok(found(&(arrangement, seconds)))
}

/// One point after the other, or all together, by a strategy that is made ready before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn ask(
    curves: &Curves,
    points: &Curves,
    strategy: Strategy,
    question: Question,
) -> Result<Found, Failure> {
    if let Curves::Arcs(_) = curves {
        Ok(ask_in(of_arcs(curves)?, &directions(points)?, strategy, question))
    } else {
        Ok(ask_in(of_segments(curves)?, &planar_points(points)?, strategy, question))
    }
}

fn ask_in<G, T>(
    arrangement: Arrangement<G, T>,
    points: &[G::Point],
    strategy: Strategy,
    question: Question,
) -> Found
where
    G: UMonotoneTraits + ApproxTraits + 'static,
    T: Topology<G> + Surface,
{
    let ready = ready(strategy, &arrangement);
    let (cells, seconds) = timed(|| answers(&ready, &arrangement, points, question));
    let located = located(&arrangement, &cells);
    Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) }
}

fn answers<G: UMonotoneTraits, T: Topology<G>>(
    ready: &Ready<G, T>,
    arrangement: &Arrangement<G, T>,
    points: &[G::Point],
    question: Question,
) -> Vec<Cell> {
    let cells = match question {
        Question::Cell => points.iter().map(|point| ready.locate(arrangement, point)).collect(),
        Question::Cells => ready.locate_all(arrangement, points),
        Question::Above => {
            points.iter().map(|point| ready.shoot(arrangement, point, VerticalRay::Up)).collect()
        }
    };
    cells.expect("the arrangement stays as it is")
}

/// The vertical decomposition of an arrangement that is made before the clock starts. Located are what is straight below and above each
/// vertex; where a vertical edge is, there is nothing.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn decompose(curves: &Curves) -> Result<Found, Failure> {
    let arrangement = of_segments(curves)?;
    let (decomposition, seconds) = timed(|| VerticalDecomposition::new(&arrangement));
    let mut located = Located::default();
    for wall in arrangement.dcel().vertices().flat_map(|v| decomposition.walls_of(v)) {
        match wall {
            WallEnd::Vertex(_) => located.vertices += 1,
            WallEnd::Edge(_) => located.edges += 1,
            WallEnd::Side => located.faces += 1,
            WallEnd::Nothing => {}
        }
    }
    Ok(Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) })
}

/// What each of some strategies costs in an arrangement, and how many cells that has; the curves are those of the table, and the times are
/// medians of three runs.
///
/// # Errors
/// If the library refuses the curves, or two strategies give different answers.
pub(crate) fn searches(
    family: Family,
    count: usize,
    strategies: &[Strategy],
) -> Result<(usize, Vec<Search>), Failure> {
    let operands = |strategy| {
        let operation = Operation::Ask(strategy, Question::Cell);
        Task { operation, family, count }.operands()
    };
    match &operands(Strategy::Trapezoids)[0].curves {
        Curves::Segments(ends) => {
            let points = |strategy| planar_points(&operands(strategy)[1].curves);
            searches_on(SegmentTraits, BoundedPlane, &segments(ends)?, strategies, points)
        }
        Curves::Arcs(ends) => {
            let points = |strategy| directions(&operands(strategy)[1].curves);
            searches_on(GeodesicTraits::new(), Sphere, &arcs(ends)?, strategies, points)
        }
        _ => Err(NO_CURVES.into()),
    }
}

fn searches_on<G, T>(
    traits: G,
    topology: T,
    curves: &[G::Curve],
    strategies: &[Strategy],
    points: impl Fn(Strategy) -> Result<Vec<G::Point>, Failure>,
) -> Result<(usize, Vec<Search>), Failure>
where
    G: ArrangementTraits + ApproxTraits + Clone + 'static,
    T: Topology<G> + Topology<CountingTraits<G>>,
{
    let arrangement = Arrangement::of_curves(traits.clone(), topology.clone(), curves);
    let counted = Arrangement::of_curves(CountingTraits::new(traits), topology, curves);
    let mut known: Vec<Cell> = Vec::new();
    let mut searches = Vec::new();
    for &strategy in strategies {
        let points = points(strategy)?;
        let (ready_plain, prepare) = timed(|| ready(strategy, &arrangement));
        let run = |_| timed(|| answers(&ready_plain, &arrangement, &points, Question::Cell));
        let mut runs = [0, 1, 2].map(run);
        runs.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        let [_, (cells, seconds), _] = runs;
        let ready_counted = ready(strategy, &counted);
        counted.traits().counters().reset();
        let again = answers(&ready_counted, &counted, &points, Question::Cell);
        let calls = counted.traits().counters().total();
        // Fewer points are the first of many.
        let common = known.len().min(cells.len());
        if cells != again || cells[..common] != known[..common] {
            return Err(format!("{strategy:?} gives other answers than the strategies before it").into());
        }
        if cells.len() > known.len() {
            known = cells;
        }
        let per_point = |amount: f64| amount / points.len() as f64;
        let (query, calls) = (per_point(seconds), per_point(calls as f64));
        let path =
            (strategy == Strategy::Trapezoids).then(|| TrapezoidalMap::new(&arrangement).longest_path());
        searches.push(Search { strategy, prepare, query, calls, path });
    }
    let counts = arrangement.counts_with_splits();
    Ok((counts.vertices + counts.edges + counts.faces, searches))
}
