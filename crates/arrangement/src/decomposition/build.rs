//! The sweep that decomposes an arrangement.
//!
//! The gaps of the status line are the trapezoids that have begun. At a site, those below, between and above the edges that end there
//! end, and as many begin as edges do, and one.

use super::order::{firsts, number_by_below, shift_back};
use super::records::{NONE, SiteRecord, TrapezoidRecord, key};
use super::{TrapezoidId, VerticalDecomposition};
use crate::arrangement::Arrangement;
use crate::sweep::{Around, CellNumbers, Event, SweepInput, SweepVisitor, sweep};
use crate::topology::{Site, Topology};
use crate::traits::{Along, BasicTraits, Location, UMonotoneTraits};
use dcel::{EdgeId, FaceId, VertexId};
use std::ops::ControlFlow;

pub(super) fn build<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
) -> VerticalDecomposition {
    let swept = sweep_over(arrangement);
    number(arrangement, swept)
}

/// What the sweep found: trapezoids in the order in which they begin.
struct Swept {
    trapezoids: Vec<TrapezoidRecord>,
    sites: Vec<SiteRecord>,
    bare_faces: Vec<(TrapezoidId, FaceId)>,
}

fn sweep_over<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Swept {
    let (input, numbers) = SweepInput::of_arrangement(arrangement, []);
    let dcel = arrangement.dcel();
    let site_count = input.site_count();
    let corner = arrangement.corner_face();
    let count = 1 + site_count + dcel.edge_count();
    assert!(u32::try_from(count).is_ok(), "a decomposition has fewer than 2^32 trapezoids");
    let mut trapezoids = Vec::with_capacity(count);
    trapezoids.push(TrapezoidRecord { left: NONE, right: NONE, below: NONE, above: NONE });
    let mut decomposer = Decomposer {
        arrangement,
        input: &input,
        numbers,
        over: vec![NONE; dcel.edge_bound()],
        bottom: 0,
        bare_face: corner,
        last: None,
        swept: Swept {
            trapezoids,
            sites: Vec::with_capacity(site_count),
            bare_faces: vec![(TrapezoidId(0), corner)],
        },
    };
    let _ = sweep(arrangement.traits(), arrangement.topology(), &input, &mut decomposer);
    decomposer.swept
}

/// Numbers trapezoids by the edge below, and lists them by the one above.
fn number<G: BasicTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    swept: Swept,
) -> VerticalDecomposition {
    let Swept { trapezoids: raw, mut sites, mut bare_faces } = swept;
    let dcel = arrangement.dcel();
    let (numbers, first_above) = number_by_below(&raw, dcel.edge_bound());
    let renumber = |t: &mut TrapezoidId| t.0 = numbers[t.index()];
    let mut trapezoids = vec![raw[0]; raw.len()];
    let mut first_below = firsts(raw.iter().map(|t| t.above), dcel.edge_bound());
    let mut below = vec![TrapezoidId(NONE); raw.len()];
    for (t, &number) in raw.iter().zip(&numbers) {
        trapezoids[number as usize] = *t;
        let next = &mut first_below[key(t.above)];
        below[*next as usize] = TrapezoidId(number);
        *next += 1;
    }
    shift_back(&mut first_below);
    // Those without edges have no edge below, and their order stays.
    bare_faces.iter_mut().for_each(|(t, _)| renumber(t));
    let mut first_site = vec![NONE; dcel.vertex_bound()];
    for (number, site) in (0..sites.len() as u32).zip(&mut sites).rev() {
        site.left.iter_mut().for_each(renumber);
        site.right.iter_mut().for_each(renumber);
        site.next = std::mem::replace(&mut first_site[site.vertex.index()], number);
    }
    VerticalDecomposition {
        stamp: arrangement.stamp(),
        trapezoids,
        first_above,
        below,
        first_below,
        sites,
        first_site,
        bare_faces,
        is_v_identified: arrangement.topology().sides().is_v_identified(),
    }
}

struct Decomposer<'a, 'i, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    input: &'i SweepInput<'a, G>,
    numbers: CellNumbers,
    /// For each edge on the status line, the trapezoid above it.
    over: Vec<u32>,
    /// The trapezoid below all edges.
    bottom: u32,
    /// The face of the last trapezoid without edges.
    bare_face: FaceId,
    /// The last site.
    last: Option<Site<'a, G>>,
    swept: Swept,
}

impl<G: BasicTraits, T: Topology<G>> Decomposer<'_, '_, G, T> {
    /// The vertex that has a site where an event is; `None` if it is only an image of one, of a vertex that has its sites elsewhere.
    ///
    /// A vertex has a site wherever one of its edges ends, and where its point is: on identified sides, the low one.
    #[inline]
    fn vertex(&self, event: &Event<'_, G>) -> Option<VertexId> {
        let vertices = &self.numbers.vertices;
        let mut sites = event.input_sites.iter().map(|&site| site as usize);
        if let Some(site) = sites.clone().find(|&site| site < vertices.len()) {
            return Some(vertices[site]);
        }
        let point = event.site.point()?;
        let home = self.arrangement.topology().point_location(self.arrangement.traits(), point);
        let image = sites.next().filter(|_| home == event.site.location)?;
        Some(vertices[self.input.original_site(image)])
    }

    /// A trapezoid ends.
    #[inline]
    fn end(&mut self, t: u32, site: u32) -> TrapezoidId {
        self.swept.trapezoids[t as usize].right = site;
        TrapezoidId(t)
    }

    /// A trapezoid begins, above an edge or none.
    #[inline]
    fn begin(&mut self, site: u32, below: u32, above: u32) -> TrapezoidId {
        let t = self.swept.trapezoids.len() as u32;
        self.swept.trapezoids.push(TrapezoidRecord { left: site, right: NONE, below, above });
        match below {
            NONE => self.bottom = t,
            _ => self.over[below as usize] = t,
        }
        TrapezoidId(t)
    }

    /// The trapezoid that has begun above an edge or none.
    #[inline]
    fn over(&self, below: u32) -> u32 {
        if below == NONE { self.bottom } else { self.over[below as usize] }
    }

    /// The face of a trapezoid without edges that begins at a site where these end, from bottom to top.
    fn face_behind(&self, vertex: VertexId, location: Location, ended: [Option<EdgeId>; 2]) -> FaceId {
        let dcel = self.arrangement.dcel();
        if let Some(face) = dcel.isolated_face(vertex) {
            return face;
        }
        let [Some(lowest), Some(highest)] = ended else { return self.bare_face };
        // On the left and on the top side only the lower wall is on the surface.
        match location {
            Location { u: Along::Low, .. } | Location { u: Along::Inside, v: Along::High } => {
                dcel.face(lowest.halfedge().twin())
            }
            _ => dcel.face(highest.halfedge()),
        }
    }
}

impl<G: BasicTraits, T: Topology<G>> SweepVisitor<G> for Decomposer<'_, '_, G, T> {
    /// The edge; a strand is one edge.
    type Tag = Option<EdgeId>;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, Self::Tag>) -> ControlFlow<()> {
        let Some(vertex) = self.vertex(event) else {
            debug_assert!(
                around.left.is_empty() && around.right.is_empty(),
                "no edge passes through a vertex"
            );
            return ControlFlow::Continue(());
        };
        let location = event.site.location;
        let is_bare = around.left.is_empty() && around.right.is_empty();
        if is_bare && self.arrangement.contraction_at(location).is_some() {
            // A point that was given where a side is contracted is nowhere in the parameter space.
            return ControlFlow::Continue(());
        }
        let site = self.swept.sites.len() as u32;
        let input_site = self.input.site(event.input_sites[0] as usize);
        let edge = |tag: Option<Option<EdgeId>>| tag.flatten().map_or(NONE, |e| e.0);
        let (lowest, highest) = (edge(around.below), edge(around.above));

        let mut left = [self.end(self.over(lowest), site); 2];
        for strand in around.left {
            left[1] = self.end(self.over(edge(Some(strand.tag))), site);
        }

        let mut below = lowest;
        let mut right = [TrapezoidId(NONE); 2];
        for strand in around.right.iter_mut() {
            let e = self.numbers.edges[strand.curve()];
            strand.tag = Some(e);
            let t = self.begin(site, below, e.0);
            if below == lowest {
                right[0] = t;
            }
            below = e.0;
        }
        right[1] = self.begin(site, below, highest);
        if below == lowest {
            right[0] = right[1];
        }
        if below == NONE && highest == NONE {
            let ended = [around.left.first(), around.left.last()].map(|strand| strand.and_then(|s| s.tag));
            self.bare_face = self.face_behind(vertex, location, ended);
            self.swept.bare_faces.push((right[1], self.bare_face));
        }
        let has_last_u = self.last.is_some_and(|last| self.is_same_u(&last, &input_site));
        self.last = Some(input_site);
        self.swept.sites.push(SiteRecord { left, right, vertex, next: NONE, location, has_last_u });
        ControlFlow::Continue(())
    }
}

impl<G: BasicTraits, T: Topology<G>> Decomposer<'_, '_, G, T> {
    /// Tells whether two sites have the same u, of which `a` comes first.
    fn is_same_u(&self, a: &Site<'_, G>, b: &Site<'_, G>) -> bool {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        if a.location.u != Along::Inside || b.location.u != Along::Inside {
            return a.location.u == b.location.u;
        }
        // For one u, the bottom side comes first and the top side last: so what lies between both ends of a vertical line has its u.
        match (a.location.v, b.location.v) {
            (Along::Inside, Along::Inside) => match (a.point(), b.point()) {
                (Some(p), Some(q)) => traits.compare_u(p, q).is_eq(),
                _ => false,
            },
            (Along::Low, Along::Inside | Along::High) => {
                topology.compare_sites(traits, b, &moved(a, Along::High)).is_le()
            }
            (Along::Inside, Along::High) => topology.compare_sites(traits, &moved(b, Along::Low), a).is_le(),
            _ => false,
        }
    }
}

/// The site on the bottom or top side that has the u of another.
fn moved<'a, G: BasicTraits>(site: &Site<'a, G>, v: Along) -> Site<'a, G> {
    Site { location: Location { u: Along::Inside, v }, at: site.at }
}
