//! What is different from one family of curves to the other: the surface and the curves, as text and as objects.

use super::around::Around;
use super::course::Course;
use super::model::{
    LinearArrangement, PolycurveArrangement, SphereArrangement, SpherePolycurveArrangement, StarArrangement,
    TorusArrangement, TorusPolycurveArrangement,
};
use super::special::Special;
use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::star::line::Line;
use arrangement::Arrangement;
use arrangement::models::polycurve::{Chain, PieceTraits, PolycurveTraits};
use arrangement::models::{GeodesicTraits, LinearTraits, TorusSegmentTraits};
use arrangement::topology::Topology;
use arrangement::traits::{CurveEnd, UMonotoneTraits};
use dcel::{FaceId, VertexId};
use std::hash::Hash;

/// Curves each of which lies on one line or circle, and of which chains are made: what a surface has as text.
pub(super) trait Base:
    PieceTraits<Point: PartialEq + 'static, UMonotoneCurve: 'static> + Clone + 'static
{
    /// The surface on which they lie.
    type Surface: Topology<Self> + Topology<PolycurveTraits<Self>> + Default;
    /// What a curve lies on; two that go on in each other have the same.
    type Line: Eq + Hash + 'static;

    /// The vertices that stand for sides.
    const SPECIAL: Special;
    /// What is wrong with pieces that are no chain.
    const TURNS_BACK: &'static str;
    /// Where the corner is whose face comes first.
    const CORNER: &'static str;

    /// Reads what follows the name of the surface.
    fn read_surface(line: &mut Line<'_>, budget: &mut Budget) -> Result<Self, Located>;

    /// Reads the coordinates of a vertex.
    fn read_point(&self, line: &mut Line<'_>, budget: &mut Budget) -> Result<Self::Point, Located>;

    /// Reads what follows the number of a curve: its pieces, one or more.
    fn read_pieces(
        &self,
        line: &mut Line<'_>,
        budget: &mut Budget,
    ) -> Result<Vec<Self::UMonotoneCurve>, Located>;

    /// The vertex that stands for a side and is this point.
    fn special_of(&self, point: &Self::Point) -> Option<VertexId> {
        let _ = point;
        None
    }

    /// The face around a vertex that stands for a side, if nothing is there. What is around it may contradict itself; then any face will
    /// do.
    fn face_around(&self, v: VertexId, around: &Around<'_, Self>) -> FaceId {
        let _ = (v, around);
        FaceId(0)
    }

    /// The record of the surface.
    fn put_surface(&self, text: &mut Vec<u8>);

    /// The coordinates of a point, with a blank before each.
    fn put_point(point: &Self::Point, text: &mut Vec<u8>);

    /// What stands behind the number of a curve, without a direction.
    fn put_course(course: &Course<'_, Self>, text: &mut Vec<u8>);

    fn line(curve: &Self::UMonotoneCurve) -> &Self::Line;

    /// Where an end is: in the plane, in the closed rectangle of a torus, on the sphere; `None` at infinity.
    fn place(curve: &Self::UMonotoneCurve, end: CurveEnd) -> Option<&Self::Point>;

    /// Whether a curve that begins at this end on the same line continues it, or was begun on another side of the parameter space.
    fn goes_on(&self, curve: &Self::UMonotoneCurve, end: CurveEnd) -> bool;

    /// A point, if it is a crossing of two lines.
    fn crossing(lines: [&Self::Line; 2], point: &Self::Point) -> Option<Self::Point>;

    fn of_single(arrangement: Arrangement<Self, Self::Surface>) -> StarArrangement;

    fn of_chains(arrangement: Arrangement<PolycurveTraits<Self>, Self::Surface>) -> StarArrangement;
}

/// Curves that can be written and read: those of a base, or chains of them.
pub(super) trait Family<B: Base>: UMonotoneTraits<Point = B::Point> + Clone {
    type Surface: Topology<Self> + Default;

    fn base(&self) -> &B;

    /// The pieces of a curve, one or more, from its min to its max end.
    fn pieces(curve: &Self::UMonotoneCurve) -> &[B::UMonotoneCurve];
}

impl<B: Base> Family<B> for B {
    type Surface = B::Surface;

    fn base(&self) -> &B {
        self
    }

    fn pieces(curve: &B::UMonotoneCurve) -> &[B::UMonotoneCurve] {
        std::slice::from_ref(curve)
    }
}

impl<B: Base> Family<B> for PolycurveTraits<B> {
    type Surface = B::Surface;

    fn base(&self) -> &B {
        self.inner()
    }

    fn pieces(curve: &Chain<B::UMonotoneCurve>) -> &[B::UMonotoneCurve] {
        curve.pieces()
    }
}

/// An arrangement that [`write_arrangement`](crate::write_arrangement) can write: a [`StarArrangement`], or one of its variants.
pub trait StarText: sealed::Sealed {
    /// The text.
    #[doc(hidden)]
    fn star_text(&self) -> Vec<u8>;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! star_text {
    ($($arrangement:ty, $base:ty;)*) => {$(
        impl sealed::Sealed for $arrangement {}

        impl StarText for $arrangement {
            fn star_text(&self) -> Vec<u8> {
                super::write::text::<$base, _>(self)
            }
        }
    )*};
}

star_text! {
    LinearArrangement, LinearTraits;
    PolycurveArrangement, LinearTraits;
    TorusArrangement, TorusSegmentTraits;
    TorusPolycurveArrangement, TorusSegmentTraits;
    SphereArrangement, GeodesicTraits;
    SpherePolycurveArrangement, GeodesicTraits;
}

impl sealed::Sealed for StarArrangement {}

impl StarText for StarArrangement {
    fn star_text(&self) -> Vec<u8> {
        match self {
            Self::Linear(arrangement) => arrangement.star_text(),
            Self::Polycurves(arrangement) => arrangement.star_text(),
            Self::Torus(arrangement) => arrangement.star_text(),
            Self::TorusPolycurves(arrangement) => arrangement.star_text(),
            Self::Sphere(arrangement) => arrangement.star_text(),
            Self::SpherePolycurves(arrangement) => arrangement.star_text(),
        }
    }
}
