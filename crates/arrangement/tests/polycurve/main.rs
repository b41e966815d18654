//! Polycurves over the rational segments of the tests.

#![allow(clippy::unwrap_used)]

#[path = "../common/rational_segments.rs"]
mod rational_segments;

mod laws;
mod models;
mod overlaps;
mod tables;
mod torus;

use rational_segments::{Point, RationalSegments, Segment, point};
use splitstar_arrangement::models::polycurve::{Chain, Polycurve, PolycurveTraits};
use splitstar_arrangement::traits::Piece;

pub(crate) type Traits = PolycurveTraits<RationalSegments>;
pub(crate) type Curve = Polycurve<Point, Segment>;

pub(crate) const TRAITS: fn() -> Traits = || PolycurveTraits::new(RationalSegments);

/// A polyline, from the text of its coordinates.
pub(crate) fn polyline(text: &str) -> Curve {
    let numbers: Vec<i64> = text.split_whitespace().map(|word| word.parse().unwrap()).collect();
    polyline_of(numbers.chunks(2).map(|pair| [pair[0], pair[1]]))
}

pub(crate) fn polyline_of(vertices: impl IntoIterator<Item = [i64; 2]>) -> Curve {
    TRAITS().make_polyline(vertices.into_iter().map(point)).unwrap()
}

/// The u-monotone chain that a polyline is.
pub(crate) fn chain(text: &str) -> Chain<Segment> {
    match polyline(text).parts() {
        [Piece::Curve { curve, .. }] => curve.clone(),
        parts => panic!("{text} is not u-monotone: {parts:?}"),
    }
}

/// The points of a chain as text.
pub(crate) fn text(chain: &Chain<Segment>) -> String {
    let first = format!("{:?}", chain.pieces()[0].0[0]);
    chain.pieces().iter().fold(first, |text, piece| format!("{text} {:?}", piece.0[1]))
}
