//! General polycurves, and what makes them.

use super::{Chain, ConnectTraits, PieceTraits, PolycurveTraits};
use crate::traits::{ArrangementTraits, Piece};
use std::error::Error;
use std::fmt;
use std::sync::Arc;

/// A polycurve: chains, each of which begins where the one before it ends, or a point.
///
/// A copy costs nothing: the chains are shared.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Polycurve<P, C> {
    parts: Arc<[Piece<P, Chain<C>>]>,
    is_closed: bool,
}

impl<P, C> Polycurve<P, C> {
    pub(super) fn new(parts: Vec<Piece<P, Chain<C>>>, is_closed: bool) -> Self {
        Self { parts: parts.into(), is_closed }
    }

    /// The u-monotone chains in their order along the curve, or the one point that it is.
    pub fn parts(&self) -> &[Piece<P, Chain<C>>] {
        &self.parts
    }

    /// Tells whether the curve ends where it begins.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }
}

/// Why curves are no polycurve.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum PolycurveError {
    /// There is no vertex, and no curve.
    Empty,
    /// The curve of this number does not begin where the one before it ends.
    NotConnected {
        /// The number of the curve, from 0.
        curve: usize,
    },
}

impl fmt::Display for PolycurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("a polycurve needs a vertex or a curve"),
            Self::NotConnected { curve } => {
                write!(f, "curve {curve} of the polycurve does not begin where the one before it ends")
            }
        }
    }
}

impl Error for PolycurveError {}

/// A polycurve of pieces of the model `S`.
pub(super) type PolycurveOf<S> =
    Polycurve<<S as crate::traits::BasicTraits>::Point, <S as crate::traits::BasicTraits>::UMonotoneCurve>;

/// Pieces of curves, each with the number of its curve.
pub(super) type Numbered<S> = Vec<(
    usize,
    Piece<<S as crate::traits::BasicTraits>::Point, <S as crate::traits::BasicTraits>::UMonotoneCurve>,
)>;

impl<S: ConnectTraits> PolycurveTraits<S> {
    /// Makes a polyline: a polycurve that connects each vertex with the next. It is closed if its last vertex is its first one.
    ///
    /// Degenerate: equal vertices that follow each other count once; if all are equal, the polyline is a point.
    ///
    /// # Errors
    /// [`PolycurveError::Empty`] if there is no vertex.
    ///
    /// # Complexity
    /// Linear in the number of vertices.
    pub fn make_polyline(
        &self,
        vertices: impl IntoIterator<Item = S::Point>,
    ) -> Result<PolycurveOf<S>, PolycurveError> {
        let mut vertices = vertices.into_iter();
        let mut source = vertices.next().ok_or(PolycurveError::Empty)?;
        let (mut pieces, mut buffer) = (Vec::new(), Vec::new());
        for (number, target) in vertices.enumerate() {
            if !self.pieces.is_same_point(&source, &target) {
                self.pieces.connect(&source, &target, &mut buffer);
                pieces.extend(buffer.drain(..).map(|piece| (number, piece)));
                source = target;
            }
        }
        if pieces.is_empty() {
            return Ok(Polycurve::new(vec![Piece::Point(source)], false));
        }
        self.assemble(pieces)
    }

    /// Makes a closed polyline, whose last vertex is connected with the first one.
    ///
    /// # Errors
    /// [`PolycurveError::Empty`] if there is no vertex.
    pub fn make_polygon(
        &self,
        vertices: impl IntoIterator<Item = S::Point>,
    ) -> Result<PolycurveOf<S>, PolycurveError> {
        let mut vertices = vertices.into_iter().peekable();
        let first = vertices.peek().cloned();
        self.make_polyline(vertices.chain(first))
    }
}

impl<S: PieceTraits> PolycurveTraits<S> {
    /// Makes a polycurve of u-monotone curves, each of which has an end where the one before it ends.
    ///
    /// It is closed if the last one ends where the first begins. Where two curves have both ends in common and it does not matter
    /// for the rest, the first runs from its `Min` to its `Max` end.
    ///
    /// # Errors
    /// [`PolycurveError`] if there is no curve, or if they are not connected.
    ///
    /// # Complexity
    /// Linear in the number of curves.
    pub fn make_polycurve(
        &self,
        curves: impl IntoIterator<Item = S::UMonotoneCurve>,
    ) -> Result<PolycurveOf<S>, PolycurveError> {
        let whole = |curve| Piece::Curve { curve, is_artificial: [false; 2] };
        self.assemble(curves.into_iter().map(whole).enumerate().collect())
    }

    /// Makes a polycurve of general curves, each of which has an end where the one before it ends.
    ///
    /// # Errors
    /// [`PolycurveError`] if there is no curve, or if they are not connected.
    ///
    /// # Complexity
    /// Linear in the number of u-monotone pieces.
    pub fn make_polycurve_of<'c>(
        &self,
        curves: impl IntoIterator<Item = &'c S::Curve>,
    ) -> Result<PolycurveOf<S>, PolycurveError>
    where
        S: ArrangementTraits<Curve: 'c>,
    {
        let (mut pieces, mut buffer) = (Vec::new(), Vec::new());
        for (number, curve) in curves.into_iter().enumerate() {
            self.pieces.make_u_monotone(curve, &mut buffer);
            pieces.extend(buffer.drain(..).map(|piece| (number, piece)));
        }
        self.assemble(pieces)
    }
}

impl<S: PieceTraits> ArrangementTraits for PolycurveTraits<S> {
    type Curve = Polycurve<S::Point, S::UMonotoneCurve>;

    /// Appends the chains of a polycurve, which was cut when it was made.
    fn make_u_monotone(&self, curve: &Self::Curve, out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>) {
        out.extend_from_slice(curve.parts());
    }
}
