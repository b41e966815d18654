//! Curves on the sphere.

use super::{CurveError, CurveFault, collect, fault_of};
use crate::curves::{SphereCurve, SphereFault, check_sphere_curve};
use crate::star::StarArrangement;
use arrangement::models::polycurve::PolycurveTraits;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::sweep::Progress;
use arrangement::topology::Sphere;
use arrangement::traits::ArrangementTraits;
use arrangement::{Arrangement, Pieces};
use std::ops::ControlFlow;

impl From<SphereFault> for CurveFault {
    fn from(fault: SphereFault) -> Self {
        match fault {
            SphereFault::SameEnds | SphereFault::Empty => Self::Degenerate,
            SphereFault::Antipodal | SphereFault::AntipodalStep => Self::Antipodal,
            SphereFault::ViaEnd | SphereFault::ViaBeside => Self::Via,
        }
    }
}

impl StarArrangement {
    /// Makes the arrangement of curves on the sphere. The traits say where it is cut open; that does not matter for what is counted.
    ///
    /// If no curve is a polyline, the result is [`Sphere`](Self::Sphere), else [`SpherePolycurves`](Self::SpherePolycurves).
    ///
    /// Degenerate: points on curves are vertices of these, others are isolated vertices. Curves may overlap. Joints of polylines are no
    /// vertices, unless something else happens there. A polyline whose points are all the same is a point.
    ///
    /// # Errors
    /// The first curve that is none: see [`CurveFault`]. Curves that were read have no such fault.
    ///
    /// # Complexity
    /// That of [`sweep`](arrangement::sweep::sweep).
    ///
    /// ```
    /// use arrangement::models::GeodesicTraits;
    /// use splitstar_formats::{StarArrangement, read_sphere_curves};
    ///
    /// // The equator, and a meridian from pole to pole.
    /// let file = read_sphere_curves(b"circle 0 0 1\narc 0 0 1  0 0 -1  via 1 0 0\n", None)?;
    /// let arrangement = StarArrangement::of_sphere_curves(file.curves, GeodesicTraits::new())?;
    /// let counts = arrangement.counts();
    /// assert_eq!([counts.vertices, counts.edges, counts.faces], [3, 3, 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_sphere_curves(curves: Vec<SphereCurve>, traits: GeodesicTraits) -> Result<Self, CurveError> {
        Self::of_sphere_curves_with(curves, traits, |_| ControlFlow::Continue(()))
            .map(|arrangement| arrangement.expect("nobody stops the sweep"))
    }

    /// Makes the arrangement of curves on the sphere; now and then `watch` is told how far the sweep has come, and may stop it. Then there is no
    /// arrangement.
    ///
    /// # Errors
    /// As for [`StarArrangement::of_sphere_curves`].
    ///
    /// # Complexity
    /// That of [`sweep`](arrangement::sweep::sweep). `watch` is called once in about a thousand events.
    pub fn of_sphere_curves_with(
        curves: Vec<SphereCurve>,
        traits: GeodesicTraits,
        watch: impl FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Option<Self>, CurveError> {
        if curves.iter().any(|curve| matches!(curve, SphereCurve::Polyline(_))) {
            let traits = PolycurveTraits::new(traits);
            let pieces = collect(curves, |curve, pieces| add_polycurve(curve, &traits, pieces))?;
            let made = Arrangement::of_pieces_with(traits, Sphere, pieces, watch);
            return Ok(made.map(Self::SpherePolycurves));
        }
        let pieces = collect(curves, |curve, pieces| add(curve, &traits, pieces))?;
        Ok(Arrangement::of_pieces_with(traits, Sphere, pieces, watch).map(Self::Sphere))
    }
}

/// The curve, unless it is a polyline.
fn geodesic(curve: SphereCurve) -> Result<Geodesic, CurveFault> {
    check_sphere_curve(&curve)?;
    Ok(match curve {
        SphereCurve::Arc([source, target]) => Geodesic::arc(source, target).expect(CHECKED),
        SphereCurve::ArcVia(points) => {
            let [source, via, target] = *points;
            Geodesic::arc_via(source, &via, target).expect(CHECKED)
        }
        SphereCurve::Circle(circle) => Geodesic::circle(circle),
        SphereCurve::Point(point) => Geodesic::point(point),
        SphereCurve::Polyline(_) => unreachable!("polylines make other traits"),
    })
}

const CHECKED: &str = "arcs without a course were refused";

fn add(
    curve: SphereCurve,
    traits: &GeodesicTraits,
    pieces: &mut Pieces<GeodesicTraits>,
) -> Result<(), CurveFault> {
    let mut parts = Vec::new();
    traits.make_u_monotone(&geodesic(curve)?, &mut parts);
    pieces.extend(parts);
    Ok(())
}

fn add_polycurve(
    curve: SphereCurve,
    traits: &PolycurveTraits<GeodesicTraits>,
    pieces: &mut Pieces<PolycurveTraits<GeodesicTraits>>,
) -> Result<(), CurveFault> {
    let polycurve = match curve {
        SphereCurve::Polyline(_) => {
            check_sphere_curve(&curve)?;
            let SphereCurve::Polyline(points) = curve else { unreachable!("it is a polyline") };
            traits.make_polyline(points)
        }
        other => traits.make_polycurve_of([&geodesic(other)?]),
    };
    pieces.extend(polycurve.map_err(fault_of)?.parts().iter().cloned());
    Ok(())
}
