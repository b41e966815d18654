//! What the library makes of curves.

use crate::arcs::{Arc, Curve};
use crate::space::P;
use dcel::{EdgeId, VertexId};
use exact::Vector3;
use exact::spherical::{Direction, GreatCircle};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::traits::CurveEnd;

pub(crate) type Globe = Arrangement<GeodesicTraits, Sphere>;

impl Curve {
    /// As the library has it.
    pub(crate) fn own(&self) -> Geodesic {
        let made = match self {
            Self::Point(p) => Ok(Geodesic::point(direction(p))),
            Self::Short(p, q) => Geodesic::arc(direction(p), direction(q)),
            Self::Via(p, r, q) => Geodesic::arc_via(direction(p), &direction(r), direction(q)),
            Self::Around(p, q, n) => Geodesic::arc_around(direction(p), direction(q), great_circle(n)),
            Self::Circle(n) => Ok(Geodesic::circle(great_circle(n))),
        };
        made.unwrap_or_else(|error| panic!("{self:?}: {error}"))
    }
}

fn great_circle(normal: &P) -> GreatCircle {
    GreatCircle::new(&Vector3::new(normal.clone())).expect("a normal is not zero")
}

pub(crate) fn direction(p: &P) -> Direction {
    Direction::new(p.clone()).expect("a direction is not zero")
}

pub(crate) fn own(curves: &[Curve]) -> Vec<Geodesic> {
    curves.iter().map(Curve::own).collect()
}

pub(crate) fn traits_of([x, y]: [i64; 2]) -> GeodesicTraits {
    GeodesicTraits::with_identification([x.into(), y.into()]).expect("a direction is not zero")
}

pub(crate) fn sweep_with(traits: &GeodesicTraits, curves: &[Curve]) -> Globe {
    Arrangement::of_curves(traits.clone(), Sphere, &own(curves))
}

pub(crate) fn sweep(curves: &[Curve]) -> Globe {
    sweep_with(&GeodesicTraits::new(), curves)
}

/// The normal round which a piece goes counterclockwise from its min to its max end.
pub(crate) fn normal_of(arc: &GeodesicArc) -> P {
    arc.circle().coordinates()
}

pub(crate) fn coordinates(globe: &Globe, v: VertexId) -> P {
    globe.point(v).expect("every vertex on a sphere is a point").coordinates()
}

/// The arc of an edge, round its normal from the min to the max end.
pub(crate) fn arc_of(globe: &Globe, e: EdgeId) -> Arc {
    let curve = globe.make_edge_curve(e);
    let ends = CurveEnd::BOTH.map(|end| curve.end(end).coordinates());
    Arc { normal: normal_of(&curve), ends: Some(ends) }
}
