//! The curves of files as those of a model, and their arrangement.

use crate::console::Console;
use crate::curves::{CurveOperand, Ground};
use crate::failure::Failure;
use splitstar::arrangement::models::polycurve::PolycurveTraits;
use splitstar::arrangement::models::{Linear, LinearTraits, TorusPath, TorusSegmentTraits};
use splitstar::arrangement::sweep::Progress;
use splitstar::arrangement::topology::{FlatTorus, Topology, UnboundedPlane};
use splitstar::arrangement::traits::ArrangementTraits;
use splitstar::arrangement::{Arrangement, Pieces};
use splitstar::exact::planar::Point2;
use splitstar::formats::{InputCurve, StarArrangement};
use std::ops::ControlFlow;

/// A sweep takes fewer pieces than this.
const PIECES: usize = 1 << 30;

/// The arrangement of the curves of all files.
pub(super) fn arrangement(
    operands: Vec<CurveOperand>,
    ground: Ground,
    console: &Console,
) -> Result<StarArrangement, Failure> {
    match ground {
        Ground::Torus(period) if operands.iter().any(has_polyline) => {
            let paths = TorusSegmentTraits::new(period).expect(POSITIVE);
            let traits = PolycurveTraits::new(paths);
            let pieces = collect(operands, |curve, pieces| as_torus_polycurve(curve, &traits, pieces))?;
            Ok(StarArrangement::TorusPolycurves(swept(traits, FlatTorus, pieces, console)))
        }
        Ground::Torus(period) => {
            let traits = TorusSegmentTraits::new(period).expect(POSITIVE);
            let pieces = collect(operands, |curve, pieces| on_torus(curve, &traits, pieces))?;
            Ok(StarArrangement::Torus(swept(traits, FlatTorus, pieces, console)))
        }
        Ground::Plane if operands.iter().any(has_polyline) => {
            let traits = PolycurveTraits::new(LinearTraits);
            let pieces = collect(operands, |curve, pieces| as_polycurve(curve, &traits, pieces))?;
            Ok(StarArrangement::Polycurves(swept(traits, UnboundedPlane, pieces, console)))
        }
        Ground::Plane => {
            let pieces = collect(operands, as_linear)?;
            Ok(StarArrangement::Linear(swept(LinearTraits, UnboundedPlane, pieces, console)))
        }
    }
}

/// The arrangement of pieces; the console is told how far it has come.
fn swept<G: ArrangementTraits, T: Topology<G>>(
    traits: G,
    topology: T,
    pieces: Pieces<G>,
    console: &Console,
) -> Arrangement<G, T> {
    let tell = |progress: Progress| {
        console.step_at("arrange", progress.sites_met, progress.sites);
        ControlFlow::Continue(())
    };
    Arrangement::of_pieces_with(traits, topology, pieces, tell).expect("nobody stops the sweep")
}

fn has_polyline(operand: &CurveOperand) -> bool {
    operand.file.curves.iter().any(|curve| matches!(curve, InputCurve::Polyline(_)))
}

/// Adds all curves with `add`, of which a message is that of a failure at the curve.
fn collect<G: ArrangementTraits>(
    operands: Vec<CurveOperand>,
    mut add: impl FnMut(InputCurve, &mut Pieces<G>) -> Result<(), String>,
) -> Result<Pieces<G>, Failure> {
    let mut pieces = Pieces::new();
    for mut operand in operands {
        for (place, curve) in std::mem::take(&mut operand.file.curves).into_iter().enumerate() {
            add(curve, &mut pieces).map_err(|sentence| operand.failure(place, sentence))?;
            if pieces.curves().len() + pieces.points().len() >= PIECES {
                let sentence = format!(
                    "up to here the curves have {PIECES} pieces, and a sweep takes fewer; remove some"
                );
                return Err(operand.failure(place, sentence));
            }
        }
    }
    Ok(pieces)
}

const POSITIVE: &str = "the periods of a torus are positive";
const DIFFERENT: &str = "the points of a curve that was read are different";

/// The segment, ray or line; `None` if it is none of them.
fn linear(curve: InputCurve) -> Option<Linear> {
    match curve {
        InputCurve::Segment([source, target]) => Some(Linear::segment(source, target).expect(DIFFERENT)),
        InputCurve::Ray([source, through]) => Some(Linear::ray(source, &through).expect(DIFFERENT)),
        InputCurve::Line([p, q]) => Some(Linear::line(&p, &q).expect(DIFFERENT)),
        _ => None,
    }
}

fn as_linear(curve: InputCurve, pieces: &mut Pieces<LinearTraits>) -> Result<(), String> {
    if let InputCurve::Point(point) = curve {
        pieces.push_point(point);
        return Ok(());
    }
    let curve = linear(curve).ok_or("it is not a segment, a ray, a line or a point")?;
    pieces.push_curve(curve);
    Ok(())
}

fn as_polycurve(
    curve: InputCurve,
    traits: &PolycurveTraits<LinearTraits>,
    pieces: &mut Pieces<PolycurveTraits<LinearTraits>>,
) -> Result<(), String> {
    let polycurve = match curve {
        InputCurve::Point(point) => {
            pieces.push_point(point);
            return Ok(());
        }
        InputCurve::Polyline(vertices) => traits.make_polyline(vertices),
        other => traits.make_polycurve([
            linear(other).ok_or("it is not a segment, a ray, a line, a polyline or a point")?
        ]),
    };
    let polycurve = polycurve.map_err(|error| error.to_string())?;
    pieces.extend(polycurve.parts().iter().cloned());
    Ok(())
}

fn path(traits: &TorusSegmentTraits, [from, to]: &[Point2; 2]) -> Result<TorusPath, String> {
    let [[a, b], [c, d]] = [from.coordinates(), to.coordinates()];
    traits.path(from, &[c - a, d - b]).map_err(|error| shorter(&error))
}

fn shorter(error: &dyn std::error::Error) -> String {
    format!("{error}; give larger periods, or a shorter curve")
}

/// A segment is the path between its points in the universal cover.
fn on_torus(
    curve: InputCurve,
    traits: &TorusSegmentTraits,
    pieces: &mut Pieces<TorusSegmentTraits>,
) -> Result<(), String> {
    match curve {
        InputCurve::Point(point) => pieces.push_point(traits.point(&point)),
        InputCurve::Segment(ends) => {
            let mut cut = Vec::new();
            traits.make_u_monotone(&path(traits, &ends)?, &mut cut);
            pieces.extend(cut);
        }
        _ => return Err("it is not a segment or a point".into()),
    }
    Ok(())
}

/// The same with polylines, whose vertices are in the universal cover, too.
fn as_torus_polycurve(
    curve: InputCurve,
    traits: &PolycurveTraits<TorusSegmentTraits>,
    pieces: &mut Pieces<PolycurveTraits<TorusSegmentTraits>>,
) -> Result<(), String> {
    let polycurve = match curve {
        InputCurve::Point(point) => {
            pieces.push_point(traits.inner().point(&point));
            return Ok(());
        }
        InputCurve::Polyline(vertices) => traits.make_cover_polyline(vertices),
        InputCurve::Segment(ends) => traits.make_cover_polyline(ends),
        _ => return Err("it is not a segment, a polyline or a point".into()),
    };
    let polycurve = polycurve.map_err(|error| shorter(&error))?;
    pieces.extend(polycurve.parts().iter().cloned());
    Ok(())
}
