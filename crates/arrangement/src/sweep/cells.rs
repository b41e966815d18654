//! The cells of an arrangement as input of a sweep.

use super::input::{InputCurve, SweepInput};
use crate::arrangement::Arrangement;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, CurveEnd, Location, UMonotoneTraits};
use dcel::{EdgeId, HalfedgeId, VertexId};

/// Which cells of an arrangement the sites and curves of an input are: see [`SweepInput::of_arrangement`].
#[derive(Clone, Debug, Default)]
pub struct CellNumbers {
    /// The first site, and the vertex of each site from there on.
    pub(crate) first_site: usize,
    pub(crate) vertices: Vec<VertexId>,
    /// The first curve, and the edge of each curve from there on.
    pub(crate) first_curve: usize,
    pub(crate) edges: Vec<EdgeId>,
}

impl CellNumbers {
    /// The vertex of a site; `None` if the site is none of the arrangement, but of a point besides. A vertex may have several sites.
    pub fn vertex(&self, site: usize) -> Option<VertexId> {
        self.vertices.get(site.checked_sub(self.first_site)?).copied()
    }

    /// The edge of a curve; `None` if the curve is none of the arrangement.
    pub fn edge(&self, curve: usize) -> Option<EdgeId> {
        self.edges.get(curve.checked_sub(self.first_curve)?).copied()
    }
}

impl<'a, G: UMonotoneTraits> SweepInput<'a, G> {
    /// The vertices and edges of an arrangement, and points besides; tells which sites and curves are which cells.
    ///
    /// The curves are the edges, which are known not to meet: a group of their own. The sites of the points are the last ones but for images
    /// on identified sides, in the order of the points; [`SweepInput::original_site`] leads from an image to the site that it is one of.
    ///
    /// # Panics
    /// With 2^32 sites or more.
    ///
    /// # Examples
    /// The edges over a point, from bottom to top:
    ///
    /// ```
    /// use dcel::EdgeId;
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::models::{Segment, SegmentTraits};
    /// use splitstar_arrangement::sweep::{Around, CellNumbers, Event, SweepInput, SweepVisitor, sweep};
    /// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
    /// use std::ops::ControlFlow;
    ///
    /// struct Below<'n> {
    ///     numbers: &'n CellNumbers,
    ///     edge: Option<EdgeId>,
    /// }
    ///
    /// impl SweepVisitor<SegmentTraits> for Below<'_> {
    ///     type Tag = Option<EdgeId>;
    ///
    ///     fn event(&mut self, event: &Event<'_, SegmentTraits>, around: &mut Around<'_, Self::Tag>) -> ControlFlow<()> {
    ///         if event.input_sites.iter().all(|&site| self.numbers.vertex(site as usize).is_none()) {
    ///             self.edge = around.below.flatten();
    ///             return ControlFlow::Break(());
    ///         }
    ///         for strand in around.right.iter_mut() {
    ///             strand.tag = self.numbers.edge(strand.curve());
    ///         }
    ///         ControlFlow::Continue(())
    ///     }
    /// }
    ///
    /// let segments = [[[0, 0], [4, 0]], [[0, 2], [4, 2]]].map(|ends| Segment::from_i64(ends).expect("the ends are different"));
    /// let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments);
    /// let point = Point2::from_i64([2, 1]);
    /// let (input, numbers) = SweepInput::of_arrangement(&arrangement, [&point]);
    /// let mut below = Below { numbers: &numbers, edge: None };
    /// assert!(sweep(&SegmentTraits, &BoundedPlane, &input, &mut below).is_break());
    /// let edge = below.edge.expect("there is one");
    /// assert_eq!(arrangement.curve_of(edge).min(), &Point2::from_i64([0, 0]));
    /// ```
    pub fn of_arrangement<T: Topology<G>>(
        arrangement: &'a Arrangement<G, T>,
        points: impl IntoIterator<Item = &'a G::Point>,
    ) -> (Self, CellNumbers) {
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let mut input = Self::empty();
        let numbers = input.push_arrangement(arrangement, 0);
        for point in points {
            input.push_site(Site::of_point(topology, traits, point));
        }
        input.mirror(topology);
        (input, numbers)
    }

    /// Appends the vertices and edges of an arrangement. Their interiors are disjoint: so they are one group.
    pub(crate) fn push_arrangement<T: Topology<G>>(
        &mut self,
        arrangement: &'a Arrangement<G, T>,
        group: u32,
    ) -> CellNumbers {
        let dcel = arrangement.dcel();
        self.reserve(dcel.vertex_count(), dcel.edge_count());
        Pusher {
            arrangement,
            group,
            numbers: CellNumbers {
                first_site: self.site_count(),
                first_curve: self.curve_count(),
                vertices: Vec::with_capacity(dcel.vertex_count()),
                edges: Vec::with_capacity(dcel.edge_count()),
            },
            sites_of: vec![[u32::MAX; 2]; arrangement.dcel().edge_bound()],
            curve_of: vec![u32::MAX; arrangement.dcel().edge_bound()],
            input: self,
        }
        .push()
    }
}

struct Pusher<'i, 'a, G: UMonotoneTraits, T> {
    input: &'i mut SweepInput<'a, G>,
    arrangement: &'a Arrangement<G, T>,
    group: u32,
    numbers: CellNumbers,
    /// For each edge, the sites of its ends.
    sites_of: Vec<[u32; 2]>,
    curve_of: Vec<u32>,
}

impl<'a, G: UMonotoneTraits, T: Topology<G>> Pusher<'_, 'a, G, T> {
    fn push(mut self) -> CellNumbers {
        let (arrangement, dcel) = (self.arrangement, self.arrangement.dcel());
        let mut starts = Vec::new();
        for v in dcel.vertices() {
            starts.clear();
            match arrangement.inner_point(v) {
                None => self.push_side_vertex(v),
                Some(point) => {
                    let site = Site::of_point(arrangement.topology(), arrangement.traits(), point);
                    if site.location.is_interior() {
                        self.starts_upwards(v, point, &mut starts);
                        let number = self.push_site(v, site, &starts);
                        for h in dcel.around(v).filter(|h| !h.is_even()) {
                            self.sites_of[h.edge()][1] = number;
                        }
                    } else {
                        self.push_vertex_on_side(v, point, site.location);
                    }
                }
            }
        }
        for e in dcel.edges() {
            self.input.end_curve(self.curve_of[e.index()], self.sites_of[e.index()][1]);
        }
        self.numbers
    }

    /// Appends a site, and the edges that begin there, from bottom to top.
    fn push_site(&mut self, v: VertexId, site: Site<'a, G>, starts: &[HalfedgeId]) -> u32 {
        let number = self.input.push_site(site);
        self.numbers.vertices.push(v);
        for h in starts {
            let edge = h.edge_id();
            self.curve_of[edge.index()] = self.input.curve_count() as u32;
            self.sites_of[edge.index()][0] = number;
            self.numbers.edges.push(edge);
            let curve = self.arrangement.curve_of(edge);
            self.input.push_curve(InputCurve {
                curve,
                ends: [number, u32::MAX],
                group: self.group,
                next_end: u32::MAX,
            });
        }
        number
    }

    /// The halfedges that leave a vertex to the right, from bottom to top.
    fn starts_upwards(&self, v: VertexId, point: &G::Point, starts: &mut Vec<HalfedgeId>) {
        let dcel = self.arrangement.dcel();
        starts.extend(dcel.around(v).filter(|h| h.is_even()));
        let has_left = starts.len() < dcel.degree(v);
        let lowest = if has_left {
            // The first one whose clockwise neighbour leaves to the left.
            starts.iter().position(|&h| !dcel.next(h.twin()).is_even())
        } else {
            let compare = |&a: &usize, &b: &usize| {
                let curve = |i: usize| self.arrangement.curve_of(starts[i].edge_id());
                self.arrangement.traits().compare_v_at_u_right(curve(a), curve(b), point)
            };
            if starts.len() > 1 { (0..starts.len()).min_by(compare) } else { None }
        };
        starts.rotate_left(lowest.unwrap_or(0));
    }

    /// A vertex on an identification has a site wherever one of its edges ends.
    fn push_vertex_on_side(&mut self, v: VertexId, point: &'a G::Point, location: Location) {
        let dcel = self.arrangement.dcel();
        let mut ends: Vec<(Location, HalfedgeId)> =
            dcel.around(v).map(|h| (self.end_location(h, point, location), h)).collect();
        // Several times the same site would do no harm, but its edges must be together.
        ends.sort_by_key(|&(location, h)| (location, !h.is_even()));
        if ends.is_empty() {
            self.push_site(v, Site { location, at: SiteAt::Point(point) }, &[]);
        }
        for group in ends.chunk_by(|a, b| a.0 == b.0) {
            let mut starts: Vec<HalfedgeId> = group.iter().map(|&(_, h)| h).filter(|h| h.is_even()).collect();
            starts.sort_by(|a, b| {
                let [a, b] = [a, b].map(|h| self.arrangement.curve_of(h.edge_id()));
                self.arrangement.traits().compare_v_at_u_right(a, b, point)
            });
            let number = self.push_site(v, Site { location: group[0].0, at: SiteAt::Point(point) }, &starts);
            for (_, h) in group.iter().filter(|(_, h)| !h.is_even()) {
                self.sites_of[h.edge()][1] = number;
            }
        }
    }

    /// Where the end of an edge at a vertex on a side lies: where its support ends, if it ends there, else on the low side, because
    /// only a curve along a side has interior points on it.
    fn end_location(&self, h: HalfedgeId, point: &G::Point, low: Location) -> Location {
        let (arrangement, curve) = (self.arrangement, self.arrangement.curve_of(h.edge_id()));
        let end = if h.is_even() { CurveEnd::Min } else { CurveEnd::Max };
        let ends_here = arrangement
            .traits()
            .end_point(curve, end)
            .is_some_and(|end_point| arrangement.traits().is_same_point(end_point, point));
        if ends_here { arrangement.topology().end_location(arrangement.traits(), curve, end) } else { low }
    }

    /// Every edge that comes from a side has a site of its own. So has a point that was given where a side is contracted.
    fn push_side_vertex(&mut self, v: VertexId) {
        let arrangement = self.arrangement;
        if arrangement.dcel().outgoing(v).is_none()
            && !arrangement.is_absent(v)
            && let Some(point) = arrangement.point(v)
        {
            let site = Site::of_point(arrangement.topology(), arrangement.traits(), point);
            self.push_site(v, site, &[]);
        }
        for h in arrangement.dcel().around(v) {
            let end = if h.is_even() { CurveEnd::Min } else { CurveEnd::Max };
            let curve = arrangement.curve_of(h.edge_id());
            let location = arrangement.topology().end_location(arrangement.traits(), curve, end);
            let site = Site { location, at: SiteAt::End(curve, end) };
            debug_assert!(
                location.u != Along::Inside || location.v != Along::Inside,
                "an end without a point"
            );
            if h.is_even() {
                self.push_site(v, site, &[h]);
            } else {
                let number = self.push_site(v, site, &[]);
                self.sites_of[h.edge()][1] = number;
            }
        }
    }
}
