//! What scripts want of a family of curves.

use super::draw::Draw;
use super::scan::{P, Scan, Stroke};
use super::straight::Straight;
use exact::Rational;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{ArrangementTraits, BasicTraits, DirectionalTraits, LandmarkTraits};
use std::fmt::{Debug, Display};

/// A family whose curves bytes describe, on a surface.
pub(super) trait Drawn: Debug {
    type Traits: ArrangementTraits<Point: Display, Curve: Debug, UMonotoneCurve: Debug>
        + DirectionalTraits
        + LandmarkTraits
        + Clone;
    type Surface: Topology<Self::Traits>;

    /// A point in coordinates.
    type Place: Ord + Debug;

    /// A part of a curve in coordinates.
    type Stroke: PartialEq + Debug;

    fn traits(&self) -> Self::Traits;
    fn surface(&self) -> Self::Surface;

    /// A curve that bytes describe; `None` if they describe none.
    fn curve(&self, draw: &mut Draw<'_>) -> Option<CurveOf<Self>>;

    /// A point that bytes describe.
    fn point(&self, draw: &mut Draw<'_>) -> PointOf<Self>;

    /// The coordinates of a point.
    fn place(&self, point: &PointOf<Self>) -> Self::Place;

    /// The parts of a curve.
    fn strokes(&self, curve: &PieceOf<Self>) -> Vec<Self::Stroke>;

    /// A place in the interior of a curve.
    fn inner_point(&self, curve: &PieceOf<Self>, draw: &mut Draw<'_>) -> Option<PointOf<Self>>;

    /// The cells of points, found in coordinates without the predicates of the library; `None` where this is not told.
    fn scan(&self, arrangement: &Made<Self>, points: &[PointOf<Self>]) -> Vec<Option<Cell>>;

    /// What a curve carries.
    fn labels(&self, curve: &PieceOf<Self>) -> Vec<u32> {
        let _ = curve;
        Vec::new()
    }

    /// The same curve; it may carry something else.
    fn relabeled(&self, curve: PieceOf<Self>, label: u32) -> PieceOf<Self> {
        let _ = label;
        curve
    }
}

pub(super) type CurveOf<F> = <<F as Drawn>::Traits as ArrangementTraits>::Curve;
pub(super) type PieceOf<F> = <<F as Drawn>::Traits as BasicTraits>::UMonotoneCurve;
pub(super) type PointOf<F> = <<F as Drawn>::Traits as BasicTraits>::Point;
pub(super) type Made<F> = Arrangement<<F as Drawn>::Traits, <F as Drawn>::Surface>;

impl<F: Straight> Drawn for F {
    type Traits = F::Traits;
    type Surface = F::Surface;
    type Place = P;
    type Stroke = Stroke;

    fn traits(&self) -> F::Traits {
        F::traits(self)
    }
    fn surface(&self) -> F::Surface {
        F::surface(self)
    }
    fn curve(&self, draw: &mut Draw<'_>) -> Option<CurveOf<F>> {
        Straight::curve(self, draw)
    }
    fn point(&self, draw: &mut Draw<'_>) -> PointOf<F> {
        Straight::point(self, draw)
    }
    fn place(&self, point: &PointOf<F>) -> P {
        point.coordinates()
    }
    fn strokes(&self, curve: &PieceOf<F>) -> Vec<Stroke> {
        Straight::strokes(self, curve)
    }
    fn inner_point(&self, curve: &PieceOf<F>, draw: &mut Draw<'_>) -> Option<PointOf<F>> {
        let stroke = draw.choose(&Straight::strokes(self, curve))?;
        let times = Rational::from(1 + draw.below(3) as i64).checked_div(&Rational::from(4));
        Some(self.at(&stroke.at(&times.expect("4 is not zero"))))
    }
    fn scan(&self, arrangement: &Made<F>, points: &[PointOf<F>]) -> Vec<Option<Cell>> {
        let scan = Scan::new(self, arrangement);
        points.iter().map(|point| scan.locate(point)).collect()
    }
    fn labels(&self, curve: &PieceOf<F>) -> Vec<u32> {
        Straight::labels(self, curve)
    }
    fn relabeled(&self, curve: PieceOf<F>, label: u32) -> PieceOf<F> {
        Straight::relabeled(self, curve, label)
    }
}
