//! The curves of files as those of a model, and their arrangement.

use crate::console::Console;
use crate::curves::{CurveOperand, Ground};
use crate::failure::Failure;
use splitstar::arrangement::models::polycurve::PolycurveTraits;
use splitstar::arrangement::models::{Linear, LinearTraits, TorusPath, TorusSegmentTraits};
use splitstar::arrangement::sweep::Progress;
use splitstar::arrangement::topology::{FlatTorus, Topology, UnboundedPlane};
use splitstar::arrangement::traits::{ArrangementTraits, DirectionalTraits, Piece};
use splitstar::arrangement::{Arrangement, Pieces};
use splitstar::exact::Sign;
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
        Ground::Torus(period) => {
            let traits = TorusSegmentTraits::new(period).expect("the periods of a torus are positive");
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
    let mut pieces = Pieces::default();
    for mut operand in operands {
        for (place, curve) in std::mem::take(&mut operand.file.curves).into_iter().enumerate() {
            add(curve, &mut pieces).map_err(|sentence| operand.failure(place, sentence))?;
            if pieces.curves.len() + pieces.points.len() >= PIECES {
                let sentence = format!(
                    "up to here the curves have {PIECES} pieces, and a sweep takes fewer; remove some"
                );
                return Err(operand.failure(place, sentence));
            }
        }
    }
    Ok(pieces)
}

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
        pieces.points.push(point);
        return Ok(());
    }
    let curve = linear(curve).ok_or("it is not a segment, a ray, a line or a point")?;
    pieces.curves.push(curve);
    pieces.is_artificial.push([false; 2]);
    Ok(())
}

fn as_polycurve(
    curve: InputCurve,
    traits: &PolycurveTraits<LinearTraits>,
    pieces: &mut Pieces<PolycurveTraits<LinearTraits>>,
) -> Result<(), String> {
    let polycurve = match curve {
        InputCurve::Point(point) => {
            pieces.points.push(point);
            return Ok(());
        }
        InputCurve::Polyline(vertices) => traits.make_polyline(vertices),
        other => traits.make_polycurve([
            linear(other).ok_or("it is not a segment, a ray, a line, a polyline or a point")?
        ]),
    };
    let polycurve = polycurve.map_err(|error| error.to_string())?;
    polycurve.parts().iter().cloned().for_each(|piece| push(piece, pieces));
    Ok(())
}

/// A segment is the path between its points, and so is each piece of a polyline; its joints are not vertices.
fn on_torus(
    curve: InputCurve,
    traits: &TorusSegmentTraits,
    pieces: &mut Pieces<TorusSegmentTraits>,
) -> Result<(), String> {
    let points = match curve {
        InputCurve::Segment(ends) => ends.to_vec(),
        InputCurve::Polyline(points) => points,
        InputCurve::Point(point) => {
            pieces.points.push(traits.point(&point));
            return Ok(());
        }
        _ => return Err("it is not a segment, a polyline or a point".into()),
    };
    let paths: Vec<TorusPath> =
        points.windows(2).map(|ends| path(traits, &ends[0], &ends[1])).collect::<Result<_, _>>()?;
    let ends = [&points[0], &points[points.len() - 1]].map(|point| traits.point(point));
    // One straight path that comes back to its beginning has a vertex there.
    let is_closed = paths.len() > 1 && ends[0] == ends[1];
    let count = paths.len();
    let is_joint = |number: usize| {
        let is_inner = (1..count).contains(&number) || is_closed;
        is_inner && !turns_back(&paths[(number + count - 1) % count], &paths[number % count])
    };
    for (number, path) in paths.iter().enumerate() {
        push_path(path, traits, [number, number + 1].map(is_joint), pieces);
    }
    Ok(())
}

fn path(traits: &TorusSegmentTraits, from: &Point2, to: &Point2) -> Result<TorusPath, String> {
    let [[a, b], [c, d]] = [from.coordinates(), to.coordinates()];
    traits
        .path(from, &[c - a, d - b])
        .map_err(|error| format!("{error}; give larger periods, or a shorter curve"))
}

/// Whether a path returns upon the one before it: such a joint is an end, and a vertex.
fn turns_back(before: &TorusPath, path: &TorusPath) -> bool {
    let ([a, b], [c, d]) = (before.displacement(), path.displacement());
    a * d == b * c && (a * c + b * d).sign() == Sign::Negative
}

/// Adds the pieces of a path, of which the source, the target or both may be joints.
fn push_path(
    path: &TorusPath,
    traits: &TorusSegmentTraits,
    [from_joint, to_joint]: [bool; 2],
    pieces: &mut Pieces<TorusSegmentTraits>,
) {
    let mut cut = Vec::new();
    traits.make_u_monotone(path, &mut cut);
    let last = cut.len().saturating_sub(1);
    for (number, mut piece) in cut.into_iter().enumerate() {
        if let Piece::Curve { curve, is_artificial } = &mut piece {
            let [source, target] = if traits.is_directed_right(curve) { [0, 1] } else { [1, 0] };
            is_artificial[source] |= number == 0 && from_joint;
            is_artificial[target] |= number == last && to_joint;
        }
        push(piece, pieces);
    }
}

fn push<G: ArrangementTraits>(piece: Piece<G::Point, G::UMonotoneCurve>, pieces: &mut Pieces<G>) {
    match piece {
        Piece::Curve { curve, is_artificial } => {
            pieces.curves.push(curve);
            pieces.is_artificial.push(is_artificial);
        }
        Piece::Point(point) => pieces.points.push(point),
    }
}
