//! Where something happens in a sweep: a point, or the end of a curve that has none.

use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd, Location};

/// What a site is.
#[derive(Debug)]
pub enum SiteAt<'a, G: BasicTraits> {
    /// A point.
    Point(&'a G::Point),
    /// The end of a curve on an open or contracted side: how curves come there says in which order they do.
    End(&'a G::UMonotoneCurve, CurveEnd),
}

impl<G: BasicTraits> Clone for SiteAt<'_, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G: BasicTraits> Copy for SiteAt<'_, G> {}

/// A place in the closed parameter space. One point of the surface has several if sides are identified.
#[derive(Debug)]
pub struct Site<'a, G: BasicTraits> {
    /// On which side it is, if on any.
    pub location: Location,
    /// What is there.
    pub at: SiteAt<'a, G>,
}

impl<G: BasicTraits> Clone for Site<'_, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G: BasicTraits> Copy for Site<'_, G> {}

impl<'a, G: BasicTraits> Site<'a, G> {
    /// A point in the interior.
    #[inline]
    pub fn interior(point: &'a G::Point) -> Self {
        Self { location: Location::INTERIOR, at: SiteAt::Point(point) }
    }

    /// A point, wherever it is.
    ///
    /// # Panics
    /// In debug builds, if the traits do not know the point by its coordinates: [`BasicTraits::is_canonical`].
    pub fn of_point<T: Topology<G>>(topology: &T, traits: &G, point: &'a G::Point) -> Self {
        debug_assert!(traits.is_canonical(point), "the traits know {point:?} by other coordinates");
        Self { location: topology.point_location(traits, point), at: SiteAt::Point(point) }
    }

    /// The end of a curve. On a contracted side it is no point here, even if the traits have one for the side.
    pub fn of_end<T: Topology<G>>(
        topology: &T,
        traits: &G,
        curve: &'a G::UMonotoneCurve,
        end: CurveEnd,
    ) -> Self {
        let location = topology.end_location(traits, curve, end);
        let at = match traits.end_point(curve, end) {
            Some(point) if location.is_interior() || !topology.sides().is_contracted(location) => {
                SiteAt::Point(point)
            }
            _ => SiteAt::End(curve, end),
        };
        Self { location, at }
    }

    /// The point, if there is one.
    #[inline]
    pub fn point(&self) -> Option<&'a G::Point> {
        match self.at {
            SiteAt::Point(point) => Some(point),
            SiteAt::End(..) => None,
        }
    }
}

/// Tells whether a curve ends on a side, in a point that the traits have for that end.
pub(crate) fn ends_on_side<G: BasicTraits, T: Topology<G>>(
    topology: &T,
    traits: &G,
    curve: &G::UMonotoneCurve,
    point: &G::Point,
) -> bool {
    !topology.end_location(traits, curve, CurveEnd::Max).is_interior()
        && traits.end_point(curve, CurveEnd::Max).is_some_and(|end| traits.is_same_point(end, point))
}
