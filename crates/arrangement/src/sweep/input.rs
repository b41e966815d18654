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
    /// The next one of the curves that end at the same site.
    pub(crate) next_end: u32,
}

/// Sites and curves between them. Curves of one *group* are known to have disjoint interiors.
#[derive(Debug)]
pub struct SweepInput<'a, G: BasicTraits> {
    pub(super) sites: Vec<Site<'a, G>>,
    pub(super) curves: Vec<InputCurve<'a, G>>,
    /// For each site, the first of the curves that begin there; one more at the end. They are consecutive, from bottom to top, and
    /// do not overlap.
    pub(super) first_start: Vec<u32>,
    /// For each site, the first of the curves that end there; they are a list.
    pub(super) first_end: Vec<u32>,
    /// The sites of which the last ones are images on other sides.
    mirrored_from: Vec<u32>,
}

impl<'a, G: BasicTraits> SweepInput<'a, G> {
    /// Free curves, and points of their own.
    ///
    /// The site of the `Min` end of curve i has number i, that of its `Max` end n + i with n curves, and the points follow.
    ///
    /// # Panics
    /// With 2^32 sites or more: two a curve, one a point.
    pub fn of_curves<T: Topology<G>>(
        traits: &G,
        topology: &T,
        curves: impl IntoIterator<Item = &'a G::UMonotoneCurve>,
        points: impl IntoIterator<Item = &'a G::Point>,
    ) -> Self {
        let mut input = Self::empty();
        input.push_free(traits, topology, curves, points);
        input.mirror(topology);
        input
    }

    /// Appends free curves, and points of their own: first the sites of the `Min` ends, then those of the `Max` ends, then the
    /// points.
    pub(crate) fn push_free<T: Topology<G>>(
        &mut self,
        traits: &G,
        topology: &T,
        curves: impl IntoIterator<Item = &'a G::UMonotoneCurve>,
        points: impl IntoIterator<Item = &'a G::Point>,
    ) {
        let first_curve = self.curves.len();
        for curve in curves {
            debug_assert!(traits.is_own_curve(curve), "the curve is one of these traits");
            let min = self.push_site(Site::of_end(topology, traits, curve, CurveEnd::Min));
            self.push_curve(InputCurve { curve, ends: [min, NIL], group: NO_GROUP, next_end: NIL });
        }
        for i in first_curve..self.curves.len() {
            let max = self.push_site(Site::of_end(topology, traits, self.curves[i].curve, CurveEnd::Max));
            self.end_curve(number(i), max);
        }
        for point in points {
            self.push_site(Site::of_point(topology, traits, point));
        }
    }

    /// No site and no curve.
    pub(crate) fn empty() -> Self {
        Self {
            sites: Vec::new(),
            curves: Vec::new(),
            first_start: vec![0],
            first_end: Vec::new(),
            mirrored_from: Vec::new(),
        }
    }

    /// Makes room for sites and curves.
    pub(super) fn reserve(&mut self, sites: usize, curves: usize) {
        self.sites.reserve(sites);
        self.first_start.reserve(sites);
        self.first_end.reserve(sites);
        self.curves.reserve(curves);
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

    /// The number of the site of which this one is an image on another side; its own number if it is none.
    #[inline]
    pub fn original_site(&self, site: usize) -> usize {
        let originals = self.sites.len() - self.mirrored_from.len();
        if site < originals { site } else { self.mirrored_from[site - originals] as usize }
    }

    /// Adds, for each site on an identified side, the other places of its point. So a curve along the side is cut wherever
    /// another curve comes to it from the far side, and both sides are met at the same points. Nothing may be added afterwards.
    pub(crate) fn mirror<T: Topology<G>>(&mut self, topology: &T) {
        let sides = topology.sides();
        if !sides.is_u_identified() && !sides.is_v_identified() {
            return;
        }
        let images = |along: Along, is_identified: bool| match (along, is_identified) {
            (Along::Low | Along::High, true) => [Some(Along::Low), Some(Along::High)],
            _ => [Some(along), None],
        };
        let mut mirrored = Vec::new();
        for (original, site) in (0..).zip(&self.sites) {
            let is_on_identification = !site.location.is_interior() && !sides.is_contracted(site.location);
            if !is_on_identification || !matches!(site.at, SiteAt::Point(_)) {
                continue;
            }
            for u in images(site.location.u, sides.is_u_identified()).into_iter().flatten() {
                for v in images(site.location.v, sides.is_v_identified()).into_iter().flatten() {
                    let location = Location { u, v };
                    if location != site.location {
                        self.mirrored_from.push(original);
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
    pub(crate) fn push_site(&mut self, site: Site<'a, G>) -> u32 {
        let number = number(self.sites.len());
        assert!(number < NIL, "a sweep is over fewer than 2^32 sites");
        self.sites.push(site);
        self.first_start.push(number_of_starts(&self.first_start));
        self.first_end.push(NIL);
        number
    }

    /// Appends a curve that begins at the last site.
    pub(crate) fn push_curve(&mut self, curve: InputCurve<'a, G>) {
        self.curves.push(curve);
        let last = self.first_start.len() - 1;
        self.first_start[last] += 1;
    }

    /// Says where a curve ends.
    pub(crate) fn end_curve(&mut self, curve: u32, site: u32) {
        let first = std::mem::replace(&mut self.first_end[site as usize], curve);
        let ended = &mut self.curves[curve as usize];
        ended.ends[1] = site;
        ended.next_end = first;
    }
}

/// The number of curves that begin at the sites so far.
fn number_of_starts(first_start: &[u32]) -> u32 {
    first_start.last().copied().unwrap_or(0)
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("a sweep is over fewer than 2^32 sites")
}
