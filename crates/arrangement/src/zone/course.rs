//! A u-monotone curve from its first to its last cell.

use super::{Hit, Next, On, Passage, Walk, ZonePlace, ZoneVisitor, next, side_vertex};
use crate::arrangement::Arrangement;
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::{Along, CurveEnd, Location, SideKind, UMonotoneTraits};
use crate::trapezoids::{Found, RailId, SiteId, Toward, TrapezoidId, Trapezoids, side};
use dcel::VertexId;
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// A curve on its way through an arrangement.
pub(super) struct Course<'z, G: UMonotoneTraits, T> {
    arrangement: &'z Arrangement<G, T>,
    trapezoids: &'z Trapezoids<G>,
    curve: &'z G::UMonotoneCurve,
    ends: [Site<'z, G>; 2],
}

/// Where a curve has come to.
struct Stand<P> {
    spot: Spot<P>,
    cell: Cell,
    on: On,
}

/// A place on the curve.
enum Spot<P> {
    End(CurveEnd),
    Site(SiteId),
    Point(P, Location),
}

/// How a curve leaves a place or comes to it: in which cell, and on which side of the edge, if the place is in one.
#[derive(Clone, Copy)]
struct Way {
    cell: Cell,
    side: Ordering,
}

impl<P> Stand<P> {
    fn is_end(&self) -> bool {
        matches!(self.spot, Spot::End(CurveEnd::Max))
    }
}

impl<'z, G: UMonotoneTraits, T: Topology<G>> Course<'z, G, T> {
    pub(super) fn new(
        arrangement: &'z Arrangement<G, T>,
        trapezoids: &'z Trapezoids<G>,
        curve: &'z G::UMonotoneCurve,
    ) -> Self {
        debug_assert!(
            arrangement.traits().is_own_curve(curve),
            "the curve is one of the traits of the arrangement"
        );
        let of_end = |end| Site::of_end(arrangement.topology(), arrangement.traits(), curve, end);
        Self { arrangement, trapezoids, curve, ends: CurveEnd::BOTH.map(of_end) }
    }

    /// Goes from the first cell to the last.
    pub(super) fn run<V: ZoneVisitor<G> + ?Sized>(&self, visitor: &mut V) -> ControlFlow<()> {
        let (mut here, mut first) = self.start();
        let mut before = None;
        visitor.begins(&self.place(&here))?;
        loop {
            let place = self.place(&here);
            let next = next(self.arrangement, self.trapezoids, self.curve, (&place.site, here.on), first);
            let way = self.way(&next, here.on, first);
            self.tell(visitor, &place, Passage { before, after: Some(way) })?;
            let (there, came) = match (next, way.cell) {
                (Next::Along(rail, until), _) => {
                    let there = self.along(rail, until);
                    let e = self.trapezoids.rail(rail).edge;
                    visitor.along(e, [&place, &self.place(&there)])?;
                    (there, way)
                }
                (Next::Through, Cell::Face(face)) => {
                    visitor.enters_face(face, &place)?;
                    let mut walk =
                        Walk::new(self.arrangement, self.trapezoids, self.curve, &place.site, first);
                    let hit = walk.run();
                    let (there, side) = self.stand_at(hit, walk.at(), way.cell);
                    visitor.leaves_face(face, [&place, &self.place(&there)])?;
                    (there, Way { cell: way.cell, side })
                }
                (Next::Through, _) => unreachable!("a curve that does not run along an edge is in a face"),
            };
            before = Some(came);
            if there.is_end() {
                let place = self.place(&there);
                self.tell(visitor, &place, Passage { before, after: None })?;
                return visitor.ends(&place);
            }
            first = self.first_from(&there);
            here = there;
        }
    }

    fn site<'s>(&'s self, spot: &'s Spot<G::Point>) -> Site<'s, G> {
        match spot {
            Spot::End(end) => self.ends[*end as usize],
            Spot::Site(site) => self.trapezoids.place(self.arrangement, *site),
            Spot::Point(point, location) => {
                Site { location: *location, at: crate::topology::SiteAt::Point(point) }
            }
        }
    }

    fn place<'s>(&'s self, stand: &'s Stand<G::Point>) -> ZonePlace<'s, G> {
        ZonePlace { site: self.site(&stand.spot), cell: stand.cell }
    }

    /// Tells of a place that is not in a face.
    fn tell<V: ZoneVisitor<G> + ?Sized>(
        &self,
        visitor: &mut V,
        place: &ZonePlace<'_, G>,
        Passage { before, after }: Passage<Way>,
    ) -> ControlFlow<()> {
        match place.cell {
            Cell::Vertex(_) if self.is_open(place.site.location) => ControlFlow::Continue(()),
            Cell::Vertex(v) => {
                let cell = |way: Way| way.cell;
                visitor.vertex(v, place, Passage { before: before.map(cell), after: after.map(cell) })
            }
            Cell::Edge(e) => {
                let side = |way: Way| way.side;
                visitor.edge(e, place, Passage { before: before.map(side), after: after.map(side) })
            }
            Cell::Face(_) => ControlFlow::Continue(()),
        }
    }

    /// Tells whether a place is on an open side.
    fn is_open(&self, location: Location) -> bool {
        if location.is_interior() {
            return false;
        }
        let sides = self.arrangement.topology().sides();
        let is = |along, [low, high]: [SideKind; 2]| match along {
            Along::Low => low == SideKind::Open,
            Along::Inside => false,
            Along::High => high == SideKind::Open,
        };
        is(location.u, sides.u) || is(location.v, sides.v)
    }

    /// How the curve leaves a place, from which it goes on in the trapezoid `first`.
    fn way(&self, next: &Next<G::Point>, on: On, first: TrapezoidId) -> Way {
        match next {
            Next::Along(rail, _) => {
                Way { cell: Cell::Edge(self.trapezoids.rail(*rail).edge), side: Ordering::Equal }
            }
            Next::Through => {
                let side = match on {
                    On::Rail(rail) => self.side_of(first, rail),
                    // If it begins on an identified side, the edge is on the low one and the curve comes from the high one.
                    On::Site(_) | On::Face => Ordering::Less,
                };
                Way { cell: Cell::Face(self.trapezoids.face_of(self.arrangement, first)), side }
            }
        }
    }

    /// On which side of a rail a trapezoid next to it is.
    fn side_of(&self, t: TrapezoidId, rail: RailId) -> Ordering {
        if self.trapezoids.trapezoid(t).below == rail { Ordering::Greater } else { Ordering::Less }
    }

    /// The place where the curve begins, and the trapezoid in which it leaves it.
    fn start(&self) -> (Stand<G::Point>, TrapezoidId) {
        let (arrangement, trapezoids) = (self.arrangement, self.trapezoids);
        let place = self.ends[0];
        let stand = |cell, on| Stand { spot: Spot::End(CurveEnd::Min), cell, on };
        let elsewhere = |site: Option<SiteId>| match site {
            Some(site) => (On::Site(site), self.first_at(site)),
            None => (On::Face, self.search_right(&place)),
        };
        if let Some(v) = side_vertex(arrangement, place.location) {
            let (on, first) = elsewhere(match trapezoids.search(arrangement, &place, &Toward::Here).0 {
                Found::Site(site) => Some(site),
                Found::Within(_) => None,
            });
            return (stand(self.cell_on_side(v), on), first);
        }
        let home = self.home(&place);
        let is_home = home.location == place.location;
        match trapezoids.search(arrangement, &home, &Toward::Here).0 {
            Found::Site(site) => {
                let v = trapezoids.vertex(site);
                let site = if is_home { Some(site) } else { trapezoids.site_at(v, place.location) };
                let (on, first) = elsewhere(site);
                (stand(Cell::Vertex(v), on), first)
            }
            Found::Within(t) => match self.rail_at(&home, t) {
                Some(rail) => {
                    let on = if is_home { On::Rail(rail) } else { On::Face };
                    (stand(Cell::Edge(trapezoids.rail(rail).edge), on), self.search_right(&place))
                }
                None => {
                    let first = if is_home { t } else { self.search_right(&place) };
                    (stand(Cell::Face(trapezoids.face_of(arrangement, t)), On::Face), first)
                }
            },
        }
    }

    /// The cell at the vertex that stands for a side.
    fn cell_on_side(&self, v: VertexId) -> Cell {
        self.arrangement.face_of_absent(v).map_or(Cell::Vertex(v), Cell::Face)
    }

    /// The place of a point where an arrangement keeps it: on the lower one of two identified sides.
    fn home<'s>(&self, place: &Site<'s, G>) -> Site<'s, G> {
        match place.point() {
            Some(point) if !place.location.is_interior() => {
                Site::of_point(self.arrangement.topology(), self.arrangement.traits(), point)
            }
            _ => *place,
        }
    }

    /// The rail that a place is on, which was found above it.
    fn rail_at(&self, place: &Site<'_, G>, t: TrapezoidId) -> Option<RailId> {
        let below = self.trapezoids.trapezoid(t).below;
        let is_on = |rail: RailId| {
            let support = &self.arrangement.curves()[self.trapezoids.rail(rail).curve as usize];
            side(self.arrangement, place, support).is_eq()
        };
        (!below.is_none() && is_on(below)).then_some(below)
    }

    /// The trapezoid in which the curve leaves a place that is no site; above, if it runs along an edge.
    fn search_right(&self, place: &Site<'_, G>) -> TrapezoidId {
        let toward = Toward::Right(self.curve, crate::trapezoids::Side::Above);
        match self.trapezoids.search(self.arrangement, place, &toward).0 {
            Found::Within(t) => t,
            Found::Site(_) => unreachable!("only the place itself is looked for at a site"),
        }
    }

    /// The trapezoid in which the curve leaves a site.
    fn first_at(&self, site: SiteId) -> TrapezoidId {
        let [below, above] = self.trapezoids.right_of(site);
        if below == above {
            return above;
        }
        self.search_right(&self.trapezoids.place(self.arrangement, site))
    }

    /// The trapezoid in which the curve goes on from a place at which it does not begin.
    fn first_from(&self, stand: &Stand<G::Point>) -> TrapezoidId {
        match stand.on {
            On::Site(site) => self.first_at(site),
            On::Rail(_) | On::Face => self.search_right(&self.site(&stand.spot)),
        }
    }

    /// A vertex to which the curve has come.
    fn stand_at_site(&self, site: SiteId, is_end: bool) -> Stand<G::Point> {
        let cell = Cell::Vertex(self.trapezoids.vertex(site));
        let spot = if is_end { Spot::End(CurveEnd::Max) } else { Spot::Site(site) };
        Stand { spot, cell, on: On::Site(site) }
    }

    /// Where the curve is after it has run along a rail.
    fn along(&self, rail: RailId, until: Option<G::Point>) -> Stand<G::Point> {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        let is_end = |place: &Site<'_, G>| topology.compare_sites(traits, place, &self.ends[1]).is_eq();
        let Some(point) = until else {
            let site = self.trapezoids.rail(rail).ends[1];
            return self.stand_at_site(site, is_end(&self.trapezoids.place(self.arrangement, site)));
        };
        let place = Site::of_point(topology, traits, &point);
        let (is_end, location) = (is_end(&place), place.location);
        let spot = if is_end { Spot::End(CurveEnd::Max) } else { Spot::Point(point, location) };
        Stand { spot, cell: Cell::Edge(self.trapezoids.rail(rail).edge), on: On::Rail(rail) }
    }

    /// Where the curve is after it has come through a face, and on which side of the edge it came, if it is on one. `t` is the last
    /// trapezoid.
    fn stand_at(&self, hit: Hit<G::Point>, t: TrapezoidId, face: Cell) -> (Stand<G::Point>, Ordering) {
        let at_end = |cell, on| Stand { spot: Spot::End(CurveEnd::Max), cell, on };
        let edge = |rail: RailId| Cell::Edge(self.trapezoids.rail(rail).edge);
        match hit {
            Hit::Site { site, is_end } => (self.stand_at_site(site, is_end), Ordering::Equal),
            Hit::Edge { rail, point } => {
                let spot = Spot::Point(point, Location::INTERIOR);
                (Stand { spot, cell: edge(rail), on: On::Rail(rail) }, self.side_of(t, rail))
            }
            Hit::End { on: Some(rail) } => (at_end(edge(rail), On::Rail(rail)), self.side_of(t, rail)),
            Hit::End { on: None } => {
                let (cell, side) = self.cell_at_end(face);
                (at_end(cell, On::Face), side)
            }
        }
    }

    /// The cell in which the curve ends, if it meets nothing there on its own side of the parameter space; and if that is an edge, from
    /// which side the curve comes to it.
    fn cell_at_end(&self, face: Cell) -> (Cell, Ordering) {
        let (arrangement, trapezoids) = (self.arrangement, self.trapezoids);
        let place = self.ends[1];
        if let Some(v) = side_vertex(arrangement, place.location) {
            return (self.cell_on_side(v), Ordering::Equal);
        }
        let home = self.home(&place);
        if home.location == place.location {
            return (face, Ordering::Equal);
        }
        match trapezoids.search(arrangement, &home, &Toward::Here).0 {
            Found::Site(site) => {
                let v = trapezoids.vertex(site);
                (Cell::Vertex(v), Ordering::Equal)
            }
            Found::Within(t) => match self.rail_at(&home, t) {
                Some(rail) => {
                    // An edge along the left side has on its left, which is above it, what comes from the right side.
                    let is_from_right = place.location.u == Along::High;
                    let side = if is_from_right { Ordering::Greater } else { Ordering::Less };
                    (Cell::Edge(trapezoids.rail(rail).edge), side)
                }
                None => (face, Ordering::Equal),
            },
        }
    }
}
