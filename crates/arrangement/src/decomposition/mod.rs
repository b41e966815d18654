//! The vertical decomposition of an arrangement, made by one sweep: as a list, and as a cell complex.
//!
//! From every vertex a *wall* goes up and one goes down, each to the next edge. Walls and edges cut the parameter space into
//! *pseudo-trapezoids*, here called trapezoids for short. Vertices are ordered lexicographically, as if everything were sheared a little:
//! so no two walls are on one line, and a vertical edge has a side above it, which is its left, and one below. What the shear adds has no
//! width, and [`VerticalDecomposition::is_degenerate`] tells.
//!
//! | layer | files | role |
//! |---|---|---|
//! | the list | `mod`, `records` | trapezoids, sites, and which are next to one another |
//! | | `walls` | what is straight above and below each vertex |
//! | making it | `build`, `order` | a visitor of the sweep; trapezoids numbered along edges |
//! | the complex | `complex` | trapezoids, walls and pieces of edges as cells, with an example |
//!
//! A vertex of the surface has several places in the parameter space if sides are identified, and one for each edge if it stands for
//! a side. So walls begin at *sites*. They end at the sides of the parameter space at the latest, also where these are identified.
//!
//! The decomposition is a snapshot, without a search structure: it knows the state of the arrangement for which it was made. One that can be
//! searched, and follows edits, is [`TrapezoidalMap`](crate::location::TrapezoidalMap). An arrangement from which cells were removed has
//! holes in its ids: to the decomposition, the id of a cell that was not there then is no edge and no vertex.
//!
//! # Examples
//! A triangle under a segment:
//!
//! ```
//! use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
//! use splitstar_arrangement::models::{Segment, SegmentTraits};
//! use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
//!
//! let ends = [[[1, 0], [5, 0]], [[5, 0], [3, 3]], [[3, 3], [1, 0]], [[0, 5], [6, 5]]];
//! let segments = ends.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
//! let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments);
//! let decomposition = VerticalDecomposition::new(&arrangement);
//!
//! // One, and one more for each vertex and each edge.
//! assert_eq!(decomposition.trapezoid_count(), 1 + 5 + 4);
//! let inside = arrangement.dcel().faces().find(|&f| f != arrangement.corner_face()).expect("there is a triangle");
//! let mut in_triangle = 0;
//! for t in decomposition.trapezoids() {
//!     in_triangle += usize::from(decomposition.face_of(&arrangement, t)? == inside);
//! }
//! assert_eq!(in_triangle, 2);
//!
//! // The tip has the base below it, and the segment above.
//! let is_tip = |v: &_| arrangement.point(*v).is_some_and(|p| p.to_string() == "(3, 3)");
//! let tip = arrangement.vertices().find(is_tip).expect("it is a vertex");
//! let [below, above] = decomposition.walls_of(tip);
//! let (WallEnd::Edge(base), WallEnd::Edge(segment)) = (below, above) else { panic!("{below:?}, {above:?}") };
//! assert_eq!(arrangement.curve_of(base).max().to_string(), "(5, 0)");
//! assert_eq!(arrangement.curve_of(segment).max().to_string(), "(6, 5)");
//! # Ok::<(), splitstar_arrangement::edit::Stale>(())
//! ```
//!
//! # References
//! Thesis, sections 2.4.5 and 6.1.3; de Berg, Cheong, van Kreveld and Overmars, Computational Geometry, chapter 6.

mod build;
mod complex;
mod order;
mod records;
#[cfg(test)]
mod tests;
mod walls;

use crate::arrangement::Arrangement;
use crate::edit::{Stale, Stamp};
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, Location, UMonotoneTraits};
pub use complex::{DecompositionComplex, EdgeOrigin, VertexOrigin};
use dcel::{EdgeId, FaceId, VertexId};
use records::{NONE, SiteRecord, TrapezoidRecord};
pub use records::{SiteId, Trapezoid, TrapezoidId};
use std::ops::Range;
pub use walls::WallEnd;

/// The vertical decomposition of one state of an arrangement.
///
/// Laws:
/// 1. There is one trapezoid, and one more for each site and for each edge.
/// 2. Sites are numbered as a sweep meets them: from left to right, and for one u from bottom to top.
/// 3. Trapezoids are numbered by the edge below, and along it from left to right; those without an edge below come first.
///
/// # Complexity
/// 20 bytes a trapezoid, 28 a site, 4 a vertex and 8 an edge.
#[derive(Clone, Debug)]
pub struct VerticalDecomposition {
    stamp: Stamp,
    trapezoids: Vec<TrapezoidRecord>,
    /// For each edge the first of the trapezoids above it, and one more; before the edges what stands for none.
    first_above: Vec<u32>,
    /// The trapezoids below each edge, from left to right; before the edges those with none above.
    below: Vec<TrapezoidId>,
    first_below: Vec<u32>,
    sites: Vec<SiteRecord>,
    /// For each vertex its first site.
    first_site: Vec<u32>,
    /// The faces of trapezoids without edges, by their numbers.
    bare_faces: Vec<(TrapezoidId, FaceId)>,
    is_v_identified: bool,
}

impl VerticalDecomposition {
    /// Decomposes an arrangement.
    ///
    /// # Panics
    /// With 2^32 trapezoids or more.
    ///
    /// # Complexity
    /// O(n log n) for n cells.
    ///
    /// # References
    /// Thesis, section 2.4.1: one visitor of the sweep.
    pub fn new<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        build::build(arrangement)
    }

    /// The state of the arrangement that was decomposed.
    pub fn stamp(&self) -> Stamp {
        self.stamp
    }

    /// The number of trapezoids.
    #[inline]
    pub fn trapezoid_count(&self) -> usize {
        self.trapezoids.len()
    }

    /// All trapezoids.
    pub fn trapezoids(&self) -> impl ExactSizeIterator<Item = TrapezoidId> + DoubleEndedIterator + use<> {
        (0..self.trapezoids.len() as u32).map(TrapezoidId)
    }

    /// The boundary of a trapezoid.
    ///
    /// # Panics
    /// If there is no such trapezoid.
    #[inline]
    pub fn trapezoid(&self, t: TrapezoidId) -> Trapezoid {
        self.trapezoids[t.index()].make_trapezoid()
    }

    /// The number of sites.
    #[inline]
    pub fn site_count(&self) -> usize {
        self.sites.len()
    }

    /// All sites, as a sweep meets them.
    pub fn sites(&self) -> impl ExactSizeIterator<Item = SiteId> + DoubleEndedIterator + use<> {
        (0..self.sites.len() as u32).map(SiteId)
    }

    /// The sites of a vertex, as a sweep meets them. One that stands for a side has a site for each end of an edge there. There are none if
    /// there is no such vertex.
    pub fn sites_of(&self, v: VertexId) -> impl Iterator<Item = SiteId> + '_ {
        let first = self.first_site.get(v.index()).copied();
        let some = |site: u32| (site != NONE).then_some(SiteId(site));
        std::iter::successors(first.and_then(some), move |site| some(self.sites[site.index()].next))
    }

    /// The vertex of a site.
    ///
    /// # Panics
    /// If there is no such site.
    #[inline]
    pub fn vertex(&self, site: SiteId) -> VertexId {
        self.sites[site.index()].vertex
    }

    /// Where a site is in the parameter space.
    ///
    /// # Panics
    /// If there is no such site.
    #[inline]
    pub fn location(&self, site: SiteId) -> Location {
        self.sites[site.index()].location
    }

    /// The trapezoids that end at the walls of a site: the one below the edges that end there, and the one above. They are the same if no
    /// edge does. Trapezoids between two edges that end there are not among them.
    ///
    /// # Panics
    /// If there is no such site.
    #[inline]
    pub fn left_of(&self, site: SiteId) -> [TrapezoidId; 2] {
        self.sites[site.index()].left
    }

    /// The trapezoids that begin at the walls of a site: the one below the edges that begin there, and the one above.
    ///
    /// # Panics
    /// If there is no such site.
    #[inline]
    pub fn right_of(&self, site: SiteId) -> [TrapezoidId; 2] {
        self.sites[site.index()].right
    }

    /// The trapezoids above an edge, from left to right: their numbers, which are consecutive. With `None`, those that have no edge below.
    ///
    /// The left site of each is the right one of the one before. There is at least one, and none if there is no such edge.
    #[inline]
    pub fn above(&self, e: Option<EdgeId>) -> Range<u32> {
        order::row(&self.first_above, e)
    }

    /// The trapezoids below an edge, from left to right. With `None`, those that have no edge above.
    ///
    /// There is at least one, and none if there is no such edge.
    #[inline]
    pub fn below(&self, e: Option<EdgeId>) -> &[TrapezoidId] {
        let row = order::row(&self.first_below, e);
        &self.below[row.start as usize..row.end as usize]
    }

    /// Tells whether there is nothing in a trapezoid, because
    /// - its two walls have one u: it is there only because of the shear, or is a piece of the left or right side; or
    /// - it is between an identified bottom side and an edge along that: one that begins and ends there is taken for such an edge.
    ///
    /// # Panics
    /// If there is no such trapezoid.
    #[inline]
    pub fn is_degenerate(&self, t: TrapezoidId) -> bool {
        let TrapezoidRecord { below, above, .. } = self.trapezoids[t.index()];
        self.has_one_u(t) || below == NONE && above != NONE && self.is_along_bottom(EdgeId(above))
    }

    /// Tells whether the two walls of a trapezoid have one u.
    #[inline]
    fn has_one_u(&self, t: TrapezoidId) -> bool {
        let TrapezoidRecord { left, right, .. } = self.trapezoids[t.index()];
        match (left, right) {
            (NONE, NONE) => false,
            (NONE, right) => self.location(SiteId(right)).u == Along::Low,
            (left, NONE) => self.location(SiteId(left)).u == Along::High,
            (left, right) => left + 1 == right && self.sites[right as usize].has_last_u,
        }
    }

    /// Tells whether an edge runs along an identified bottom side. One that begins and ends there does.
    #[inline]
    fn is_along_bottom(&self, e: EdgeId) -> bool {
        self.is_v_identified && self.ends(e).into_iter().all(|site| self.location(site).v == Along::Low)
    }

    /// The sites where an edge begins and ends.
    ///
    /// # Panics
    /// If there is no such edge.
    #[inline]
    pub fn ends(&self, e: EdgeId) -> [SiteId; 2] {
        let above = self.above(Some(e));
        assert!(!above.is_empty(), "edge {} does not exist: only an edge begins and ends at sites", e.0);
        let (first, last) = (above.start as usize, above.end as usize - 1);
        [SiteId(self.trapezoids[first].left), SiteId(self.trapezoids[last].right)]
    }

    /// The face in which a trapezoid lies; that of a degenerate one lies next to it.
    ///
    /// # Errors
    /// If the decomposition is of another state of the arrangement, or of another arrangement.
    ///
    /// # Panics
    /// If there is no such trapezoid.
    pub fn face_of<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
    ) -> Result<FaceId, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        let dcel = arrangement.dcel();
        let Trapezoid { below, above, .. } = self.trapezoid(t);
        Ok(match (below, above) {
            (Some(below), _) => dcel.face(below.halfedge()),
            (None, Some(above)) => dcel.face(above.halfedge().twin()),
            (None, None) => {
                let place = self.bare_faces.binary_search_by_key(&t, |&(t, _)| t);
                self.bare_faces[place.expect("a trapezoid without edges has its face in the list")].1
            }
        })
    }
}
