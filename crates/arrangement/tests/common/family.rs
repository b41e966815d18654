//! Families of curves, each on its surface: what tests of one kind and another add their curves to.

use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{LinearTraits, MinimalSegmentTraits, SegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, Topology, UnboundedPlane};
use splitstar_arrangement::traits::{ArrangementTraits, DirectionalTraits, LandmarkTraits};
use splitstar_arrangement::wrappers::ConsolidatedTraits;
use std::fmt::Debug;

/// A family of curves on a surface.
pub(crate) trait Family: Debug {
    type Traits: ArrangementTraits<Point = Point2, Curve: Debug, UMonotoneCurve: Debug>
        + DirectionalTraits
        + LandmarkTraits
        + Clone;
    type Surface: Topology<Self::Traits>;

    fn traits(&self) -> Self::Traits;
    fn surface(&self) -> Self::Surface;
}

pub(crate) type CurveOf<F> = <<F as Family>::Traits as ArrangementTraits>::Curve;

macro_rules! families {
    ($($(#[$what:meta])* $family:ident: $traits:ty = $made:expr, on $surface:ident;)*) => {
        $(
            $(#[$what])*
            #[derive(Debug)]
            pub(crate) struct $family;

            impl Family for $family {
                type Traits = $traits;
                type Surface = $surface;

                fn traits(&self) -> $traits {
                    $made
                }

                fn surface(&self) -> $surface {
                    $surface
                }
            }
        )*
    };
}

families! {
    Segments: SegmentTraits = SegmentTraits, on BoundedPlane;
    MinimalSegments: MinimalSegmentTraits = MinimalSegmentTraits, on BoundedPlane;
    Linears: LinearTraits = LinearTraits, on UnboundedPlane;
    Polylines: PolycurveTraits<SegmentTraits> = PolycurveTraits::new(SegmentTraits), on BoundedPlane;
    /// Polylines that may begin and end with rays.
    Polylinears: PolycurveTraits<LinearTraits> = PolycurveTraits::new(LinearTraits), on UnboundedPlane;
    /// Segments that carry numbers.
    Numbered: ConsolidatedTraits<SegmentTraits, u32> = ConsolidatedTraits::consolidated(SegmentTraits),
        on BoundedPlane;
}
