//! General polycurves, and what makes them.

use super::{Chain, ConnectTraits, PieceTraits, PolycurveTraits};
use crate::models::{TorusPath, TorusSegmentTraits};
use crate::traits::{ArrangementTraits, Piece};
use exact::planar::Point2;
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

    /// The u-monotone chains in their order along the curve, or the one point that it is. A closed curve begins with a chain that has
    /// to begin there, if one has to, and not in the middle of one.
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
    /// The polycurve winds round a torus so often that it would be cut at more than [`TorusPath::MAX_PIECES`] places.
    TooManyPieces,
}

impl fmt::Display for PolycurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("a polycurve needs a vertex or a curve"),
            Self::NotConnected { curve } => {
                write!(f, "curve {curve} of the polycurve does not begin where the one before it ends")
            }
            Self::TooManyPieces => {
                write!(
                    f,
                    "the polycurve winds round the torus so often that it is cut at more than {} places",
                    TorusPath::MAX_PIECES
                )
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
    /// Makes a polyline: a polycurve that connects each vertex with the next. It is closed if it ends in the point where it begins.
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

impl PolycurveTraits<TorusSegmentTraits> {
    /// Makes a polyline on a torus from its vertices in the universal cover, consecutive ones of which straight paths connect.
    ///
    /// So the coordinates tell how often the polyline winds round. It is closed if it ends in the point of the torus where it
    /// begins; but one path alone, from a point back to it, has its ends there, as [`TorusSegmentTraits::path`] has.
    ///
    /// Degenerate: equal vertices that follow each other count once; if all are equal, the polyline is a point.
    ///
    /// # Errors
    /// [`PolycurveError::Empty`] if there is no vertex, and [`PolycurveError::TooManyPieces`].
    ///
    /// # Complexity
    /// Linear in the number of vertices and of times that the polyline comes to a side.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::Arrangement;
    /// use splitstar_arrangement::models::{TorusSegmentTraits, polycurve::PolycurveTraits};
    /// use splitstar_arrangement::topology::FlatTorus;
    ///
    /// let traits = PolycurveTraits::new(TorusSegmentTraits::new([6.into(), 5.into()])?);
    /// // Once round along u, with a corner on the seam: no end, so the one vertex that a closed curve needs.
    /// let vertices = [[3, 3], [6, 1], [9, 3]].map(Point2::from_i64);
    /// let wave = traits.make_cover_polyline(vertices)?;
    /// assert!(wave.is_closed());
    /// let arrangement = Arrangement::of_curves(traits, FlatTorus, [&wave]);
    /// let counts = arrangement.counts();
    /// assert_eq!([counts.vertices, counts.edges, counts.faces], [1, 1, 1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn make_cover_polyline(
        &self,
        vertices: impl IntoIterator<Item = Point2>,
    ) -> Result<PolycurveOf<TorusSegmentTraits>, PolycurveError> {
        let mut vertices = vertices.into_iter();
        let mut source = vertices.next().ok_or(PolycurveError::Empty)?;
        let (mut pieces, mut buffer) = (Vec::new(), Vec::new());
        let (mut paths, max_cuts) = (0, TorusPath::MAX_PIECES as usize);
        for target in vertices {
            if target == source {
                continue;
            }
            let [[a, b], [c, d]] = [&source, &target].map(Point2::coordinates);
            let path = self.pieces.path(&source, &[c - a, d - b]);
            self.pieces.make_u_monotone(&path.map_err(|_| PolycurveError::TooManyPieces)?, &mut buffer);
            pieces.extend(buffer.drain(..).map(|piece| (paths, piece)));
            paths += 1;
            if pieces.len() - paths > max_cuts {
                return Err(PolycurveError::TooManyPieces);
            }
            source = target;
        }
        if pieces.is_empty() {
            return Ok(Polycurve::new(vec![Piece::Point(self.pieces.point(&source))], false));
        }
        self.assemble(pieces)
    }
}

impl<S: PieceTraits> PolycurveTraits<S> {
    /// Makes a polycurve of u-monotone curves, each of which has an end where the one before it ends.
    ///
    /// It is closed if the last one ends where the first begins; a curve alone keeps the ends that it has. Where two curves have
    /// both ends in common and it does not matter for the rest, the first runs as it is directed, or from its `Min` to its `Max`
    /// end if curves of the model have no direction. So does a curve whose ends are one point.
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
