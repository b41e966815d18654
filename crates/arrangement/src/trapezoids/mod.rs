//! The vertical decomposition of an arrangement, kept while the arrangement changes, with a search structure.
//!
//! From every vertex a *wall* goes up and one goes down, each to the next edge. Walls and edges cut the parameter space into
//! *trapezoids*. Vertices are ordered lexicographically, as if everything were sheared a little: so no two walls are on one line, and a
//! vertical edge has a side above it, which is its left, and one below.
//!
//! | file | role |
//! |---|---|
//! | `mod` | records |
//! | `structure` | the search structure |
//! | `search` | the trapezoid of a place; the side of a curve on which a place lies |
//! | `locate` | the cell of a point |
//! | `insert`, `remove` | vertices and edges come and go |
//! | `rails` | edges are split and merged |
//! | `faces` | the face of a trapezoid, and trapezoids that are next to one another |
//! | `ends` | the ends of curves on sides, in their order |
//! | `seams` | those that are so across identified sides |
//! | `build` | the decomposition of an arrangement, edges in random order |
//! | `check` | every broken promise, for tests |
//!
//! A vertex of the surface has several places in the parameter space if sides are identified, and one for each edge if it stands for
//! a side. So walls begin at *sites*. What a trapezoid has below and above are *rails*: a rail is an edge under a number that the
//! longer part keeps when the edge is split.
//!
//! The search structure is the history of the decomposition: a trapezoid that is no more has become a comparison with a site or a curve.
//! With edges in random order, its depth is expected to be logarithmic; an order that gives a longer path than that is not taken. Each
//! search counts its steps; when those beyond the logarithm add up to the cost of building all anew, the next edit does that. So an
//! adverse order of edits costs no more than O(sqrt(n) log n) for each of these searches, amortized. Searches that only read count as
//! well, but build nothing.
//!
//! # References
//! Thesis, section 2.4.5 and 2.4.4 (zone); de Berg, Cheong, van Kreveld and Overmars, Computational Geometry, chapter 6.

mod build;
#[cfg(test)]
mod check;
mod ends;
mod faces;
mod follow;
mod insert;
mod locate;
mod rails;
mod remove;
mod seams;
mod search;
mod structure;
#[cfg(test)]
mod tests;

use crate::arrangement::Arrangement;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{BasicTraits, CurveEnd, Location};
use dcel::{EdgeId, VertexId};
pub(crate) use follow::Follower;
pub(crate) use insert::{NewRail, NewSite};
pub(crate) use search::{Found, Toward, compare_right, side};
use std::cmp::Ordering;
use structure::{Branch, Node, OrderRange, Structure};

macro_rules! number {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub(crate) struct $name(pub(crate) u32);

        impl $name {
            /// None of them.
            pub(crate) const NONE: Self = Self(u32::MAX);

            #[inline]
            fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("an arrangement has fewer than 2^32 cells"))
            }

            #[inline]
            fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

number!(
    /// A place in the parameter space where walls begin.
    SiteId
);
number!(
    /// An edge, as far as trapezoids know it.
    RailId
);
number!(
    /// A trapezoid.
    TrapezoidId
);

impl SiteId {
    #[inline]
    pub(crate) fn is_none(self) -> bool {
        self == Self::NONE
    }
}

impl RailId {
    #[inline]
    pub(crate) fn is_none(self) -> bool {
        self == Self::NONE
    }
}

/// A trapezoid: two sites between whose walls it lies, and the rails below and above. [`SiteId::NONE`] and [`RailId::NONE`] stand for
/// the sides of the parameter space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Trapezoid {
    pub(crate) left: SiteId,
    pub(crate) right: SiteId,
    pub(crate) below: RailId,
    pub(crate) above: RailId,
    /// Where the search structure leads on if the trapezoid is no more.
    became: Branch,
}

impl Trapezoid {
    #[inline]
    pub(crate) fn rail(&self, side: Side) -> RailId {
        match side {
            Side::Below => self.below,
            Side::Above => self.above,
        }
    }

    #[inline]
    fn rail_mut(&mut self, side: Side) -> &mut RailId {
        match side {
            Side::Below => &mut self.below,
            Side::Above => &mut self.above,
        }
    }
}

/// Below or above.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Side {
    Below,
    Above,
}

impl Side {
    #[inline]
    pub(crate) fn opposite(self) -> Self {
        match self {
            Self::Below => Self::Above,
            Self::Above => Self::Below,
        }
    }

    /// How what lies on this side compares with what lies between.
    #[inline]
    fn order(self) -> Ordering {
        match self {
            Self::Below => Ordering::Less,
            Self::Above => Ordering::Greater,
        }
    }
}

/// What a site is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum SiteKind {
    /// A place of a vertex that is a point.
    Vertex,
    /// The end of a curve on a side, where there is no point.
    End(CurveEnd),
    /// A place of a vertex that is no more: only the search structure knows it.
    Gone,
    /// An end that is no more.
    GoneEnd(CurveEnd),
}

/// A site: the four trapezoids at its two walls.
///
/// Those on the left have it as their right site, those on the right as their left one. Below and above are the same trapezoid if no
/// edge is between them. Trapezoids between two edges that begin here, or end here, are not among them.
#[derive(Clone, Copy, Debug)]
struct SiteRecord {
    /// To the left, below and above.
    left: [TrapezoidId; 2],
    /// To the right, below and above.
    right: [TrapezoidId; 2],
    /// The curve of an end, or the position among points that are no more.
    at: u32,
    vertex: VertexId,
    kind: SiteKind,
    location: Location,
    /// The next site of the same vertex.
    next: SiteId,
}

/// An edge, as far as trapezoids know it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rail {
    pub(crate) edge: EdgeId,
    pub(crate) curve: u32,
    pub(crate) ends: [SiteId; 2],
    /// The first trapezoids along it, below and above.
    pub(crate) first: [TrapezoidId; 2],
}

impl Rail {
    const FREE: Self =
        Self { edge: EdgeId::NONE, curve: u32::MAX, ends: [SiteId::NONE; 2], first: [TrapezoidId::NONE; 2] };
}

/// The vertical decomposition of an arrangement.
#[derive(Clone, Debug)]
pub(crate) struct Trapezoids<G: BasicTraits> {
    trapezoids: Vec<Trapezoid>,
    sites: Vec<SiteRecord>,
    rails: Vec<Rail>,
    rail_of: Vec<RailId>,
    first_site: Vec<SiteId>,
    structure: Structure,
    gone: Vec<G::Point>,
    /// For each vertex without a point the ends there, counterclockwise.
    ends: Vec<Vec<SiteId>>,
    /// How many trapezoids there are: of those that are no more, the search structure may know some still.
    count: usize,
    free_rails: Vec<RailId>,
    visits: faces::Visits,
}

impl<G: BasicTraits> Trapezoids<G> {
    /// One trapezoid, without walls and rails.
    fn empty() -> Self {
        let all = Trapezoid {
            left: SiteId::NONE,
            right: SiteId::NONE,
            below: RailId::NONE,
            above: RailId::NONE,
            became: Branch::NONE,
        };
        Self {
            trapezoids: vec![all],
            sites: Vec::new(),
            rails: Vec::new(),
            rail_of: Vec::new(),
            first_site: Vec::new(),
            structure: Structure::new(TrapezoidId(0)),
            count: 1,
            gone: Vec::new(),
            ends: Vec::new(),
            free_rails: Vec::new(),
            visits: faces::Visits::default(),
        }
    }

    /// The number of trapezoids.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    #[inline]
    pub(crate) fn trapezoid(&self, t: TrapezoidId) -> &Trapezoid {
        &self.trapezoids[t.index()]
    }

    #[inline]
    pub(crate) fn rail(&self, rail: RailId) -> &Rail {
        &self.rails[rail.index()]
    }

    #[inline]
    pub(crate) fn rail_of(&self, e: EdgeId) -> RailId {
        self.rail_of[e.index()]
    }

    /// Says of which edge a rail is.
    pub(crate) fn set_edge(&mut self, rail: RailId, e: EdgeId) {
        if e.index() >= self.rail_of.len() {
            self.rail_of.resize(e.index() + 1, RailId::NONE);
        }
        self.rail_of[e.index()] = rail;
        self.rails[rail.index()].edge = e;
    }

    /// Says that an edge has another curve, which runs through the same points between its ends.
    pub(crate) fn set_curve(&mut self, e: EdgeId, curve: u32) {
        let rail = self.rail_of(e);
        self.rails[rail.index()].curve = curve;
    }

    /// The trapezoids next to a site, on the right: below and above what begins there.
    #[inline]
    pub(crate) fn right_of(&self, site: SiteId) -> [TrapezoidId; 2] {
        self.sites[site.index()].right
    }

    /// The trapezoids next to a site, on the left: below and above what ends there.
    #[inline]
    pub(crate) fn left_of(&self, site: SiteId) -> [TrapezoidId; 2] {
        self.sites[site.index()].left
    }

    #[inline]
    pub(crate) fn location(&self, site: SiteId) -> Location {
        self.sites[site.index()].location
    }

    /// The vertex of a site.
    #[inline]
    pub(crate) fn vertex(&self, site: SiteId) -> VertexId {
        self.sites[site.index()].vertex
    }

    /// The sites of a vertex that is a point.
    pub(crate) fn sites_of(&self, v: VertexId) -> impl Iterator<Item = SiteId> + '_ {
        let first = self.first_site.get(v.index()).copied().filter(|site| !site.is_none());
        std::iter::successors(first, |site| {
            Some(self.sites[site.index()].next).filter(|next| !next.is_none())
        })
    }

    /// The site of a vertex at one location.
    pub(crate) fn site_at(&self, v: VertexId, location: Location) -> Option<SiteId> {
        self.sites_of(v).find(|&site| self.location(site) == location)
    }

    /// Where a site is.
    #[inline]
    pub(crate) fn place<'a, T: Topology<G>>(
        &'a self,
        arrangement: &'a Arrangement<G, T>,
        site: SiteId,
    ) -> Site<'a, G> {
        let record = &self.sites[site.index()];
        let at = match record.kind {
            SiteKind::Vertex => SiteAt::Point(
                arrangement.inner_point(record.vertex).expect("a vertex with sites by its name is a point"),
            ),
            SiteKind::Gone => SiteAt::Point(&self.gone[record.at as usize]),
            SiteKind::End(end) | SiteKind::GoneEnd(end) => {
                SiteAt::End(&arrangement.curves()[record.at as usize], end)
            }
        };
        Site { location: record.location, at }
    }

    fn is_gone(&self, site: SiteId) -> bool {
        matches!(self.sites[site.index()].kind, SiteKind::Gone | SiteKind::GoneEnd(_))
    }

    fn new_trapezoid(&mut self, trapezoid: Trapezoid) -> TrapezoidId {
        debug_assert!(trapezoid.became == Branch::NONE, "a trapezoid that was cut is cut again");
        self.count += 1;
        self.trapezoids.push(trapezoid);
        TrapezoidId::new(self.trapezoids.len() - 1)
    }

    /// A trapezoid is no more: the search structure leads on from there.
    fn end_trapezoid(&mut self, t: TrapezoidId, became: Branch) {
        debug_assert!(became != Branch::NONE, "the place is found still");
        self.trapezoids[t.index()].became = became;
        self.count -= 1;
    }

    fn new_rail(&mut self, rail: Rail) -> RailId {
        if let Some(id) = self.free_rails.pop() {
            self.rails[id.index()] = rail;
            return id;
        }
        self.rails.push(rail);
        RailId::new(self.rails.len() - 1)
    }

    fn free_rail(&mut self, rail: RailId) {
        self.rails[rail.index()] = Rail::FREE;
        self.free_rails.push(rail);
    }

    /// A node that compares with a site.
    fn split_at<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        site: SiteId,
        branches: [Branch; 2],
    ) -> Node {
        let range = OrderRange::of(arrangement.traits(), &self.place(arrangement, site));
        Node::split(site, range, branches)
    }
}
