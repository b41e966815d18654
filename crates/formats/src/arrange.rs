//! From the curves of a file to their arrangement.

use crate::curves::{CurveFile, CurvePoint, InputCurve};
use crate::star::StarArrangement;
use arrangement::models::polycurve::{PolycurveError, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, TorusPath, TorusSegmentTraits};
use arrangement::sweep::Progress;
use arrangement::topology::{FlatTorus, UnboundedPlane};
use arrangement::traits::ArrangementTraits;
use arrangement::{Arrangement, Pieces};
use exact::{Rational, Sign};
use std::fmt;
use std::ops::ControlFlow;

mod sphere;

/// Why curves have no arrangement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum CurveFault {
    /// A period is not positive. Then there is no curve at fault, and its number is 0.
    Period,
    /// A ray on a torus.
    Ray,
    /// A line on a torus.
    Line,
    /// The two points of a ray or a line are the same, or those of an arc; or a polyline has no point.
    Degenerate,
    /// On the sphere, two points that an arc should join are antipodal.
    Antipodal,
    /// On the sphere, the point between the ends of an arc is none.
    Via,
    /// Together with those before it, the curve goes around the torus more often than [`StarArrangement::MAX_TURNS`].
    TooManyTurns,
    /// Together with those before it, the curve has more pieces than a sweep takes.
    TooManyPieces,
}

/// The first curve that has no place in an arrangement, and why.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CurveError {
    /// The number of the curve, from 0.
    pub curve: usize,
    /// What is wrong with it.
    pub fault: CurveFault,
}

impl fmt::Display for CurveFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Period => f.write_str("a period of the torus is not positive"),
            Self::Ray => f.write_str("a ray has no end on a torus; give a segment, or arrange in the plane"),
            Self::Line => {
                f.write_str("a line has no end on a torus; give a segment, or arrange in the plane")
            }
            Self::Degenerate => f.write_str("the points of the curve are the same, or it has none"),
            Self::Antipodal => f.write_str(
                "the points are antipodal, and every arc between them is as short; give one between",
            ),
            Self::Via => f.write_str("the point between the ends of the arc is not between them"),
            Self::TooManyTurns => write!(
                f,
                "up to here the curves go around the torus more than {} times, and are cut there; give larger \
                 periods, or fewer or shorter curves",
                StarArrangement::MAX_TURNS
            ),
            Self::TooManyPieces => {
                write!(f, "up to here the curves have {PIECES} pieces, and a sweep takes fewer; remove some")
            }
        }
    }
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "curve {}: {}", self.curve, self.fault)
    }
}

impl std::error::Error for CurveError {}

const BOUNDED: &str = "rays and lines were refused, and polylines make other traits";

/// A sweep takes fewer pieces than this.
const PIECES: usize = 1 << 30;

// So a path alone is not refused.
const _: () = assert!(TorusPath::MAX_PIECES as u64 > 2 * StarArrangement::MAX_TURNS as u64);

impl StarArrangement {
    /// How often all curves together go around a torus at most, along x and along y: they are cut there, and a short line of a file may
    /// ask for any number of pieces.
    pub const MAX_TURNS: i64 = 1 << 17;

    /// Makes the arrangement of the curves of a file: on the torus of its periods, or in the plane if it has none.
    ///
    /// Degenerate: a segment or polyline whose points are all the same is a point. Points on curves are vertices of these, others are
    /// isolated vertices. Curves may overlap.
    ///
    /// # Errors
    /// The first curve that a torus cannot have, or that is too much: see [`CurveFault`]. Curves of the plane that were read have none.
    ///
    /// # Complexity
    /// That of [`sweep`](arrangement::sweep::sweep).
    ///
    /// ```
    /// use splitstar_formats::{StarArrangement, read_curves, write_arrangement};
    ///
    /// let file = read_curves(b"segment 0 0 2 0\nsegment 1 0 3 0\nline 1 -1 1 1\n", None)?;
    /// let arrangement = StarArrangement::of_curves(&file)?;
    /// let counts = arrangement.counts();
    /// assert_eq!([counts.vertices, counts.edges, counts.faces], [4, 5, 2]);
    /// assert!(write_arrangement(&arrangement).starts_with(b"star 1 arrangement\nsurface plane\n"));
    ///
    /// // On a torus the segment goes around, and comes back to its beginning.
    /// let file = read_curves(b"period 2 1\nsegment 0 0 2 0\n", None)?;
    /// let arrangement = StarArrangement::of_curves(&file)?;
    /// assert!(matches!(arrangement, StarArrangement::Torus(_)));
    /// assert_eq!(arrangement.counts().faces, 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_curves(file: &CurveFile) -> Result<Self, CurveError> {
        Self::of_curves_with(file.curves.clone(), file.period.clone(), |_| ControlFlow::Continue(()))
            .map(|arrangement| arrangement.expect("nobody stops the sweep"))
    }

    /// Makes the arrangement of curves on the torus of given periods, or in the plane; now and then `watch` is told how far the sweep
    /// has come, and may stop it. Then there is no arrangement.
    ///
    /// If no curve is a polyline, the result is [`Linear`](Self::Linear) or [`Torus`](Self::Torus).
    ///
    /// # Errors
    /// As for [`StarArrangement::of_curves`].
    ///
    /// # Complexity
    /// That of [`sweep`](arrangement::sweep::sweep). `watch` is called once in about a thousand events.
    pub fn of_curves_with(
        curves: Vec<InputCurve>,
        period: Option<[Rational; 2]>,
        watch: impl FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Option<Self>, CurveError> {
        let has_polyline = curves.iter().any(|curve| matches!(curve, InputCurve::Polyline(_)));
        let Some(period) = period else {
            return match has_polyline {
                true => {
                    let traits = PolycurveTraits::new(LinearTraits);
                    let pieces = collect(curves, |curve, pieces| add_polycurve(curve, &traits, pieces))?;
                    let made = Arrangement::of_pieces_with(traits, UnboundedPlane, pieces, watch);
                    Ok(made.map(Self::Polycurves))
                }
                false => {
                    let pieces = collect(curves, add_straight)?;
                    let made = Arrangement::of_pieces_with(LinearTraits, UnboundedPlane, pieces, watch);
                    Ok(made.map(Self::Linear))
                }
            };
        };
        let traits = TorusSegmentTraits::new(period);
        let traits = traits.map_err(|_| CurveError { curve: 0, fault: CurveFault::Period })?;
        check_bounded(&curves)?;
        check_turns(&curves, traits.period())?;
        if has_polyline {
            let traits = PolycurveTraits::new(traits);
            let pieces = collect(curves, |curve, pieces| add_torus_polycurve(curve, &traits, pieces))?;
            let made = Arrangement::of_pieces_with(traits, FlatTorus, pieces, watch);
            Ok(made.map(Self::TorusPolycurves))
        } else {
            let pieces = collect(curves, |curve, pieces| add_path(curve, &traits, pieces))?;
            Ok(Arrangement::of_pieces_with(traits, FlatTorus, pieces, watch).map(Self::Torus))
        }
    }
}

/// A torus has no rays and lines.
fn check_bounded(curves: &[InputCurve]) -> Result<(), CurveError> {
    for (curve, input) in curves.iter().enumerate() {
        let fault = match input {
            InputCurve::Ray(_) => CurveFault::Ray,
            InputCurve::Line(_) => CurveFault::Line,
            _ => continue,
        };
        return Err(CurveError { curve, fault });
    }
    Ok(())
}

/// A curve that goes around a torus is cut there, into so many pieces. What all of them may be together is limited.
fn check_turns(curves: &[InputCurve], period: &[Rational; 2]) -> Result<(), CurveError> {
    let mut left = StarArrangement::MAX_TURNS;
    for (curve, input) in curves.iter().enumerate() {
        let points: &[CurvePoint] = match input {
            InputCurve::Segment(ends) => ends,
            InputCurve::Polyline(points) => points,
            _ => continue,
        };
        for ends in points.windows(2) {
            let turns = turns(&ends[0], &ends[1], period);
            left = turns.and_then(|turns| left.checked_sub(turns)).unwrap_or(-1);
            if left < 0 {
                return Err(CurveError { curve, fault: CurveFault::TooManyTurns });
            }
        }
    }
    Ok(())
}

/// How many whole periods there are between two points, in both directions together, if that is a small number.
fn turns(p: &CurvePoint, q: &CurvePoint, period: &[Rational; 2]) -> Option<i64> {
    let (p, q) = (p.coordinates(), q.coordinates());
    let along = |axis: usize| {
        debug_assert_eq!(period[axis].sign(), Sign::Positive);
        (&q[axis] - &p[axis]).abs().checked_div(&period[axis])?.floor().to_i64()
    };
    along(0)?.checked_add(along(1)?)
}

/// Adds all curves with `add`.
fn collect<C, G: ArrangementTraits>(
    curves: Vec<C>,
    mut add: impl FnMut(C, &mut Pieces<G>) -> Result<(), CurveFault>,
) -> Result<Pieces<G>, CurveError> {
    let mut pieces = Pieces::new();
    for (curve, input) in curves.into_iter().enumerate() {
        let added = add(input, &mut pieces);
        let is_full = pieces.curves().len() + pieces.points().len() >= PIECES;
        let added = if is_full { added.and(Err(CurveFault::TooManyPieces)) } else { added };
        added.map_err(|fault| CurveError { curve, fault })?;
    }
    Ok(pieces)
}

/// The segment, ray or line, or the point that it is.
fn straight(curve: InputCurve) -> Result<Result<Linear, CurvePoint>, CurveFault> {
    let curve = match curve {
        InputCurve::Point(point) => return Ok(Err(point)),
        InputCurve::Segment([source, target]) if source == target => return Ok(Err(source)),
        InputCurve::Segment([source, target]) => Linear::segment(source, target),
        InputCurve::Ray([source, through]) => Linear::ray(source, &through),
        InputCurve::Line([p, q]) => Linear::line(&p, &q),
        InputCurve::Polyline(_) => None,
    };
    curve.map(Ok).ok_or(CurveFault::Degenerate)
}

fn add_straight(curve: InputCurve, pieces: &mut Pieces<LinearTraits>) -> Result<(), CurveFault> {
    match straight(curve)? {
        Ok(curve) => pieces.push_curve(curve),
        Err(point) => pieces.push_point(point),
    }
    Ok(())
}

fn fault_of(error: PolycurveError) -> CurveFault {
    match error {
        PolycurveError::TooManyPieces => CurveFault::TooManyTurns,
        _ => CurveFault::Degenerate,
    }
}

fn add_polycurve(
    curve: InputCurve,
    traits: &PolycurveTraits<LinearTraits>,
    pieces: &mut Pieces<PolycurveTraits<LinearTraits>>,
) -> Result<(), CurveFault> {
    let polycurve = match curve {
        InputCurve::Polyline(vertices) => traits.make_polyline(vertices),
        other => match straight(other)? {
            Ok(curve) => traits.make_polycurve([curve]),
            Err(point) => traits.make_polyline([point]),
        },
    };
    pieces.extend(polycurve.map_err(fault_of)?.parts().iter().cloned());
    Ok(())
}

/// A segment is the path between its points in the universal cover.
fn add_path(
    curve: InputCurve,
    traits: &TorusSegmentTraits,
    pieces: &mut Pieces<TorusSegmentTraits>,
) -> Result<(), CurveFault> {
    match curve {
        InputCurve::Point(point) => pieces.push_point(traits.point(&point)),
        InputCurve::Segment([from, to]) => {
            let [[a, b], [c, d]] = [from.coordinates(), to.coordinates()];
            let path = traits.path(&from, &[c - a, d - b]).map_err(|_| CurveFault::TooManyTurns)?;
            let mut cut = Vec::new();
            traits.make_u_monotone(&path, &mut cut);
            pieces.extend(cut);
        }
        _ => unreachable!("{BOUNDED}"),
    }
    Ok(())
}

/// The same with polylines, whose vertices are in the universal cover, too.
fn add_torus_polycurve(
    curve: InputCurve,
    traits: &PolycurveTraits<TorusSegmentTraits>,
    pieces: &mut Pieces<PolycurveTraits<TorusSegmentTraits>>,
) -> Result<(), CurveFault> {
    let polycurve = match curve {
        InputCurve::Point(point) => traits.make_cover_polyline([point]),
        InputCurve::Segment(ends) => traits.make_cover_polyline(ends),
        InputCurve::Polyline(vertices) => traits.make_cover_polyline(vertices),
        InputCurve::Ray(_) | InputCurve::Line(_) => unreachable!("{BOUNDED}"),
    };
    pieces.extend(polycurve.map_err(fault_of)?.parts().iter().cloned());
    Ok(())
}
