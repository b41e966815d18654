//! Where arrangements of the library are edited.
//!
//! As in `ours`, every function prepares its operands, does the operation once, and times that alone.

use arrangement::edit::Observer;
use arrangement::history::ArrangementWithHistory;
use arrangement::models::{GeodesicTraits, Segment, SegmentTraits};
use arrangement::topology::{BoundedPlane, Sphere, Topology};
use arrangement::traits::{ArrangementTraits, BoundedTraits};
use arrangement::{Arrangement, Editor};
use testkit::Rng;

use super::once::{Found, timed};
use super::ours::{NO_CURVES, Surface, arcs, found, located, of_segments, segments};
use super::task::Curves;
use crate::Failure;

/// Width of a square of the grid that has one hole in each.
const SQUARE: i64 = 1_024;

/// Insertion of all curves one by one into an empty arrangement.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn insert(curves: &Curves) -> Result<Found, Failure> {
    match curves {
        Curves::Segments(ends) => Ok(insert_on(SegmentTraits, BoundedPlane, &segments(ends)?)),
        Curves::Arcs(ends) => Ok(insert_on(GeodesicTraits::new(), Sphere, &arcs(ends)?)),
        _ => Err(NO_CURVES.into()),
    }
}

fn insert_on<G: ArrangementTraits, T: Topology<G> + Surface>(
    traits: G,
    topology: T,
    curves: &[G::Curve],
) -> Found {
    let (editor, seconds) = timed(|| {
        let mut editor = Editor::new(Arrangement::new(traits, topology));
        for curve in curves {
            editor.insert_curve(curve);
        }
        editor
    });
    found(&(editor.finish().0, seconds))
}

/// Aggregated insertion of all curves into an arrangement that is then made ready to be edited.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn make_ready(curves: &Curves) -> Result<Found, Failure> {
    let Curves::Segments(ends) = curves else { return Err(NO_CURVES.into()) };
    let curves = segments(ends)?;
    let (editor, seconds) =
        timed(|| Editor::new(Arrangement::of_curves(SegmentTraits, BoundedPlane, &curves)));
    Ok(found(&(editor.finish().0, seconds)))
}

/// Aggregated insertion of all curves into an arrangement with history, which is ready to be edited.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn build_with_history(curves: &Curves) -> Result<Found, Failure> {
    let Curves::Segments(ends) = curves else { return Err(NO_CURVES.into()) };
    let curves = segments(ends)?;
    let (arrangement, seconds) =
        timed(|| ArrangementWithHistory::of_curves(SegmentTraits, BoundedPlane, &curves));
    Ok(found(&(arrangement.finish().0, seconds)))
}

/// Insertion of all curves one by one into an empty arrangement with history.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn insert_with_history(curves: &Curves) -> Result<Found, Failure> {
    let Curves::Segments(ends) = curves else { return Err(NO_CURVES.into()) };
    let curves = segments(ends)?;
    let (arrangement, seconds) = timed(|| {
        let mut arrangement = ArrangementWithHistory::new(SegmentTraits, BoundedPlane);
        for curve in &curves {
            arrangement.insert(curve);
        }
        arrangement
    });
    Ok(found(&(arrangement.finish().0, seconds)))
}

/// The cells that curves meet in an arrangement that is made ready before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn zone(curves: &Curves, crossing: &Curves) -> Result<Found, Failure> {
    let Curves::Segments(ends) = crossing else { return Err(NO_CURVES.into()) };
    let crossing = segments(ends)?;
    let editor = Editor::new(of_segments(curves)?);
    let (cells, seconds) =
        timed(|| crossing.iter().flat_map(|curve| editor.zone_cells_of(curve)).collect::<Vec<_>>());
    let arrangement = editor.finish().0;
    let located = located(&arrangement, &cells);
    Ok(Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) })
}

/// Removal of all edges in random order, and with them of all vertices, from an arrangement that is made before the clock starts and
/// whose cells are counted.
///
/// # Errors
/// If the library refuses the curves, or something is left.
pub(super) fn remove(curves: &Curves) -> Result<Found, Failure> {
    let full = of_segments(curves)?;
    let counted = found(&(full.clone(), 0.0));
    let mut editor = Editor::new(full);
    let mut edges: Vec<_> = editor.arrangement().dcel().edges().collect();
    Rng::new(1).shuffle(&mut edges);
    let ((), seconds) = timed(|| {
        for e in edges {
            editor.remove_edge(e);
        }
    });
    let left = editor.arrangement().counts_with_splits();
    if (left.vertices, left.edges, left.faces) == (0, 0, 1) {
        Ok(Found { seconds, ..counted })
    } else {
        Err(format!("{left:?} are left when all edges are removed").into())
    }
}

/// A face with many holes, and what splits small faces off it.
pub(crate) struct Holes {
    /// The holes, each a segment, and the rectangle around them.
    pub(crate) segments: Vec<Segment>,
    /// Quadrilaterals around one hole each, edge by edge: the last edge splits off a small face with a hole in it.
    pub(crate) rings: Vec<Vec<Segment>>,
}

impl Holes {
    /// So many holes, and quadrilaterals around so many of them, drawn at random.
    ///
    /// # Errors
    /// If there are fewer holes than quadrilaterals.
    pub(crate) fn new(holes: usize, steps: usize) -> Result<Self, Failure> {
        if holes < steps {
            return Err(format!("there are no {steps} rings around {holes} holes").into());
        }
        let side = (1_i64..).find(|side| side * side >= holes as i64).expect("a number has a root");
        let mut rng = Rng::new(1);
        let mut near =
            |[x, y]: [i64; 2], [dx, dy]: [i64; 2]| [x + dx + rng.within(40), y + dy + rng.within(40)];
        let corners: Vec<[i64; 2]> =
            (0..holes as i64).map(|i| [i % side, i / side].map(|k| k * SQUARE)).collect();
        let mut ends: Vec<[i64; 4]> = corners
            .iter()
            .map(|&corner| {
                let [[a, b], [c, d]] = [near(corner, [400, 500]), near(corner, [600, 500])];
                [a, b, c, d]
            })
            .collect();
        let [low, high] = [-1, side * SQUARE + 1];
        ends.extend([
            [low, low, high, low],
            [high, low, high, high],
            [low, high, high, high],
            [low, low, low, high],
        ]);
        let mut around: Vec<[[i64; 2]; 4]> = corners
            .iter()
            .map(|&corner| [[200, 200], [800, 200], [800, 800], [200, 800]].map(|by| near(corner, by)))
            .collect();
        rng.shuffle(&mut around);
        let ring = |ring: &[[i64; 2]; 4]| {
            let edge = |i: usize| [ring[i][0], ring[i][1], ring[(i + 1) % 4][0], ring[(i + 1) % 4][1]];
            segments(&[0, 1, 2, 3].map(edge))
        };
        let rings = around.iter().take(steps).map(ring).collect::<Result<_, _>>()?;
        Ok(Self { segments: segments(&ends)?, rings })
    }

    /// Inserts all rings.
    ///
    /// # Errors
    /// If there are other faces in the end than there must be.
    pub(crate) fn insert<G, O>(&self, editor: &mut Editor<G, BoundedPlane, O>) -> Result<(), Failure>
    where
        G: ArrangementTraits<Curve = Segment> + BoundedTraits,
        O: Observer<G, BoundedPlane>,
    {
        self.rings.iter().flatten().for_each(|edge| drop(editor.insert_curve(edge)));
        let faces = editor.arrangement().counts().faces;
        if faces == self.rings.len() + 2 {
            Ok(())
        } else {
            Err(format!("{} rings make {faces} faces", self.rings.len()).into())
        }
    }
}

/// Splits so many small faces off one with so many holes. Gives the seconds of all steps.
///
/// # Errors
/// Those of [`Holes`].
pub(crate) fn split_off_faces(holes: usize, steps: usize) -> Result<f64, Failure> {
    let holes = Holes::new(holes, steps)?;
    let mut editor = Editor::new(Arrangement::of_curves(SegmentTraits, BoundedPlane, &holes.segments));
    let (made, seconds) = timed(|| holes.insert(&mut editor));
    made.map(|()| seconds)
}
