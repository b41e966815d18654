//! What a sweep sweeps over.

use super::status::NIL;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, BasicTraits, CurveEnd, Location};

/// A curve of no group: it may meet any other.
pub const NO_GROUP: u32 = u32::MAX;

/// A curve, or the part of it between two sites.
#[derive(Debug)]
pub(crate) struct InputCurve<'a, G: BasicTraits> {
    pub(crate) curve: &'a G::UMonotoneCurve,
    /// The sites of its ends.
    pub(crate) ends: [u32; 2],
    pub(crate) group: u32,
}

/// Sites and curves between them. Curves of one *group* are known to have disjoint interiors.
#[derive(Debug)]
pub struct SweepInput<'a, G: BasicTraits> {
    pub(super) sites: Vec<Site<'a, G>>,
    pub(super) curves: Vec<InputCurve<'a, G>>,
    /// For each site, the first of the curves that begin there, which are consecutive; one more at the end.
    pub(super) first_start: Vec<u32>,
    /// For each site, one of the curves that end there.
    pub(super) any_end: Vec<u32>,
    /// Whether the curves that begin at a site are given from bottom to top, and do not overlap.
    pub(super) is_sorted: bool,
}

impl<'a, G: BasicTraits> SweepInput<'a, G> {
    /// Free curves, and points of their own.
    ///
    /// The site of the `Min` end of curve i has number i, that of its `Max` end n + i with n curves, and the points follow.
    ///
    /// # Panics
    /// With 2^31 curves or more.
    pub fn of_curves<T: Topology<G>>(
        traits: &G,
        topology: &T,
        curves: impl IntoIterator<Item = &'a G::UMonotoneCurve>,
        points: impl IntoIterator<Item = &'a G::Point>,
    ) -> Self {
        let mut input = Self::empty();
        let curves: Vec<_> = curves.into_iter().collect();
        let count = number(curves.len());
        assert!(count < NIL / 2, "a sweep is over fewer than 2^31 curves");
        input.sites.reserve(2 * curves.len());
        for end in CurveEnd::BOTH {
            input.sites.extend(curves.iter().map(|curve| Site::of_end(topology, traits, curve, end)));
        }
        input.sites.extend(points.into_iter().map(|point| Site::of_point(topology, traits, point)));
        input.curves = (0..count)
            .zip(curves)
            .map(|(i, curve)| InputCurve { curve, ends: [i, count + i], group: NO_GROUP })
            .collect();
        input.first_start = (0..=input.sites.len()).map(|site| number(site).min(count)).collect();
        input.any_end = vec![NIL; input.sites.len()];
        for i in 0..count {
            input.any_end[(count + i) as usize] = i;
        }
        input.mirror(topology);
        input
    }

    /// No site and no curve.
    pub fn empty() -> Self {
        Self {
            sites: Vec::new(),
            curves: Vec::new(),
            first_start: vec![0],
            any_end: Vec::new(),
            is_sorted: false,
        }
    }

    /// The number of curves.
    pub fn curve_count(&self) -> usize {
        self.curves.len()
    }

    /// The number of sites.
    pub fn site_count(&self) -> usize {
        self.sites.len()
    }

    /// A curve by its number: its support.
    #[inline]
    pub fn curve(&self, curve: usize) -> &'a G::UMonotoneCurve {
        self.curves[curve].curve
    }

    /// The group of a curve, or [`NO_GROUP`].
    #[inline]
    pub fn group(&self, curve: usize) -> u32 {
        self.curves[curve].group
    }

    /// The numbers of the sites of both ends of a curve.
    #[inline]
    pub fn ends(&self, curve: usize) -> [usize; 2] {
        self.curves[curve].ends.map(|site| site as usize)
    }

    /// A site by its number.
    #[inline]
    pub fn site(&self, site: usize) -> Site<'a, G> {
        self.sites[site]
    }

    /// Adds, for each site on an identified side, the other places of its point. So a curve along the side is cut wherever
    /// another curve comes to it from the far side, and both sides are met at the same points.
    pub(super) fn mirror<T: Topology<G>>(&mut self, topology: &T) {
        let sides = topology.sides();
        if !sides.is_u_identified() && !sides.is_v_identified() {
            return;
        }
        let images = |along: Along, is_identified: bool| match (along, is_identified) {
            (Along::Low | Along::High, true) => [Some(Along::Low), Some(Along::High)],
            _ => [Some(along), None],
        };
        let mut mirrored = Vec::new();
        for site in &self.sites {
            if site.location.is_interior() || !matches!(site.at, SiteAt::Point(_)) {
                continue;
            }
            for u in images(site.location.u, sides.is_u_identified()).into_iter().flatten() {
                for v in images(site.location.v, sides.is_v_identified()).into_iter().flatten() {
                    let location = Location { u, v };
                    if location != site.location {
                        mirrored.push(Site { location, at: site.at });
                    }
                }
            }
        }
        for site in mirrored {
            self.push_site(site);
        }
    }

    /// Appends a site at which no curve begins yet.
    pub(super) fn push_site(&mut self, site: Site<'a, G>) -> u32 {
        let number = number(self.sites.len());
        self.sites.push(site);
        self.first_start.push(self.first_start[self.first_start.len() - 1]);
        self.any_end.push(NIL);
        number
    }

    /// Appends a curve that begins at the last site.
    pub(super) fn push_curve(&mut self, curve: InputCurve<'a, G>) {
        self.curves.push(curve);
        let last = self.first_start.len() - 1;
        self.first_start[last] += 1;
    }
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("a sweep is over fewer than 2^32 sites")
}
