//! Where cells of arrangements of the library are found for points one by one, and where arrangements are decomposed.
//!
//! As in `ours`, every function prepares its operands, does the operation once, and times that alone.

use arrangement::decomposition::{VerticalDecomposition, WallEnd};
use arrangement::location::{Landmarks, Naive, PointLocation, TrapezoidalMap, VerticalRay, Walk};
use arrangement::models::SegmentTraits;
use arrangement::overlay::Cell;
use arrangement::topology::BoundedPlane;
use exact::planar::Point2;

use super::once::{Found, Located, timed};
use super::ours::{Segments, found, located, of_segments};
use super::task::{Curves, Question, Strategy};
use crate::Failure;

/// What a strategy does before the first point, for an arrangement that is made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn prepare(curves: &Curves, strategy: Strategy) -> Result<Found, Failure> {
    let arrangement = of_segments(curves)?;
    let seconds = match strategy {
        Strategy::Naive => timed(|| Naive).1,
        Strategy::Walk => timed(|| Walk).1,
        Strategy::Landmarks => timed(|| Landmarks::new(&arrangement)).1,
        Strategy::Trapezoids => timed(|| TrapezoidalMap::new(&arrangement)).1,
    };
    Ok(found(&(arrangement, seconds)))
}

/// One point after the other, by a strategy that is made ready before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn ask(
    curves: &Curves,
    points: &[[i64; 2]],
    strategy: Strategy,
    question: Question,
) -> Result<Found, Failure> {
    let arrangement = of_segments(curves)?;
    let points: Vec<Point2> = points.iter().map(|&point| Point2::from_i64(point)).collect();
    let (cells, seconds) = match strategy {
        Strategy::Naive => answers(&Naive, &arrangement, &points, question),
        Strategy::Walk => answers(&Walk, &arrangement, &points, question),
        Strategy::Landmarks => answers(&Landmarks::new(&arrangement), &arrangement, &points, question),
        Strategy::Trapezoids => answers(&TrapezoidalMap::new(&arrangement), &arrangement, &points, question),
    };
    let located = located(&arrangement, &cells);
    Ok(Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) })
}

fn answers<S: PointLocation<SegmentTraits, BoundedPlane>>(
    strategy: &S,
    arrangement: &Segments,
    points: &[Point2],
    question: Question,
) -> (Vec<Cell>, f64) {
    let answer = |point| match question {
        Question::Cell => strategy.locate(arrangement, point),
        Question::Above => strategy.shoot(arrangement, point, VerticalRay::Up),
    };
    timed(|| points.iter().map(|point| answer(point).expect("the arrangement stays as it is")).collect())
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
