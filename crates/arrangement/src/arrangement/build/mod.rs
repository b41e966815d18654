//! The cells of an arrangement, made by a sweep.
//!
//! 1. Every event is a vertex, every strand an edge; halfedges are linked around their vertices at once (`rotation`), those of
//!    vertices on sides at the end (`sides`).
//! 2. Every gap of the status line has a *label*. A gap that opens between two strands that begin at one event gets a fresh one;
//!    where all strands between two gaps end, their labels are joined (`labels`); and gaps on both sides of an identification
//!    are joined. Labels that are joined are one face, on every surface.
//! 3. Cycles of halfedges are traced. Each is a CCB of the face of its label. It is an outer one if it turns to the left once,
//!    an inner one if it turns to the right once; on a torus it may also not turn at all, and is outer then (`cycles`).
//!
//! # Complexity
//! Linear in the number of cells, up to the inverse of Ackermann's function, beside the sweep.

mod cycles;
mod labels;
mod rotation;
mod sides;

use crate::sweep::{Around, Event, Strand, SweepVisitor};
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, Sides};
use dcel::{CcbId, Dcel, FaceId, Halfedge, HalfedgeId, VertexId};
use labels::Labels;
use sides::{Place, SideVertices};
use std::ops::ControlFlow;

/// Marks a halfedge before which a cycle turns by half a turn to the right; beside a label in the place of a CCB.
const WRAP: u32 = 1 << 31;

/// What the builder attaches to a subcurve.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BuildTag {
    /// The edge.
    pub(crate) edge: u32,
    /// The label of the gap above.
    above: u32,
}

/// A visitor that makes cells.
#[derive(Debug)]
pub(crate) struct Builder<'s, P> {
    /// For each site of the input, whether it is there only because a curve was cut.
    is_artificial_site: &'s [bool],
    halfedges: Vec<Halfedge>,
    outgoing: Vec<HalfedgeId>,
    pub(crate) points: Vec<Option<P>>,
    pub(crate) is_artificial: Vec<bool>,
    /// For each edge, one of the curves of the input that run there.
    pub(crate) edge_curves: Vec<u32>,
    /// Edges along which several curves run, with all of these.
    pub(crate) overlaps: Vec<(u32, Vec<u32>)>,
    keeps_overlaps: bool,
    isolated: Vec<(VertexId, u32)>,
    labels: Labels,
    /// The gap below all strands, and the one above all.
    bottom: u32,
    top: u32,
    is_before_interior: bool,
    sides: Sides,
    on_sides: SideVertices,
    around: Vec<HalfedgeId>,
    /// The vertex of the last event.
    pub(crate) last_vertex: VertexId,
}

/// The [corner face](crate::Arrangement::corner_face) of what a sweep made: that of the first gap.
pub(crate) const CORNER_FACE: FaceId = FaceId(0);

/// The cells that a sweep made.
#[derive(Debug)]
pub(crate) struct Built<P> {
    pub(crate) dcel: Dcel,
    pub(crate) points: Vec<Option<P>>,
    pub(crate) is_artificial: Vec<bool>,
    pub(crate) edge_curves: Vec<u32>,
    pub(crate) overlaps: Vec<(u32, Vec<u32>)>,
}

impl<'s, P: Clone> Builder<'s, P> {
    /// A builder of an empty surface; `is_artificial_site` tells for each site of the input whether a curve was only cut there.
    pub(crate) fn new<G: BasicTraits<Point = P>, T: Topology<G>>(
        traits: &G,
        topology: &T,
        is_artificial_site: &'s [bool],
    ) -> Self {
        let mut labels = Labels::new();
        let first = labels.fresh();
        let special = special_count(topology);
        let on_sides = SideVertices::new(topology.sides(), topology.side_vertices());
        Self {
            is_artificial_site,
            halfedges: Vec::new(),
            outgoing: vec![HalfedgeId::NONE; special],
            points: vec![None; special],
            // As long as nothing is there but cuts.
            is_artificial: contractions(traits, topology).iter().map(Option::is_some).collect(),
            edge_curves: Vec::new(),
            overlaps: Vec::new(),
            keeps_overlaps: !G::OVERLAPS_ARE_PLAIN,
            isolated: Vec::new(),
            labels,
            bottom: first,
            top: first,
            is_before_interior: true,
            sides: topology.sides(),
            on_sides,
            around: Vec::new(),
            last_vertex: VertexId(0),
        }
    }

    /// Keeps, for every edge along which several curves run, all of them.
    pub(crate) fn keep_overlaps(&mut self) {
        self.keeps_overlaps = true;
    }

    #[inline]
    fn add_vertex(&mut self, point: Option<P>, is_artificial: bool) -> VertexId {
        let vertex = VertexId::new(self.outgoing.len());
        self.outgoing.push(HalfedgeId::NONE);
        self.points.push(point);
        self.is_artificial.push(is_artificial);
        vertex
    }

    /// Begins the edges to the right of a vertex, between two gaps.
    #[inline]
    fn begin_edges(
        &mut self,
        vertex: VertexId,
        around: &mut Around<'_, BuildTag>,
        [mut below, above]: [u32; 2],
    ) {
        let count = around.right.len();
        for i in 0..count {
            let label = if i + 1 == count { above } else { self.labels.fresh() };
            let edge = self.edge_curves.len() as u32;
            let none = HalfedgeId::NONE;
            let halfedge = |source, label| Halfedge { next: none, prev: none, source, ccb: CcbId(label) };
            self.halfedges.push(halfedge(vertex, label));
            self.halfedges.push(halfedge(VertexId::NONE, below));
            if self.keeps_overlaps && around.is_overlap(i) {
                self.overlaps.push((edge, around.curves_of(i).map(|curve| curve as u32).collect()));
            }
            self.edge_curves.push(around.right[i].curve() as u32);
            around.right[i].tag = BuildTag { edge, above: label };
            below = label;
        }
    }

    #[inline]
    fn end_edges(&mut self, vertex: VertexId, left: &[Strand<BuildTag>]) {
        for strand in left {
            self.halfedges[2 * strand.tag.edge as usize + 1].source = vertex;
        }
    }

    fn interior_event(&mut self, vertex: VertexId, around: &mut Around<'_, BuildTag>) {
        let below = around.below.map_or(self.bottom, |tag| tag.above);
        let above = around.left.last().map_or(below, |strand| strand.tag.above);
        self.begin_edges(vertex, around, [below, above]);
        self.end_edges(vertex, around.left);
        if around.right.is_empty() {
            if around.left.is_empty() {
                self.isolated.push((vertex, below));
                return;
            }
            self.labels.join(below, above);
        }
        let mut leaving = std::mem::take(&mut self.around);
        leaving.clear();
        leaving.extend(leaving_right(around.right));
        leaving.extend(leaving_left(around.left));
        self.outgoing[vertex.index()] = leaving[0];
        rotation::link(&mut self.halfedges, &leaving);
        self.around = leaving;
    }

    /// An event on a side: see the design note for what the gaps do there.
    fn side_event<G: BasicTraits<Point = P>>(
        &mut self,
        event: &Event<'_, G>,
        is_artificial: bool,
        around: &mut Around<'_, BuildTag>,
    ) -> VertexId {
        let location = event.site.location;
        if location.u != Along::Low {
            self.leave_left_side();
        }
        let place = self.on_sides.place(location);
        let vertex = match place {
            Place::Special(vertex) => vertex,
            Place::Met(seam) => self.on_sides.seam_vertex(seam),
            Place::New(_) => {
                let vertex = self.add_vertex(event.site.point().cloned(), is_artificial);
                self.on_sides.add_seam(vertex);
                vertex
            }
        };
        if let Place::Met(_) | Place::Special(_) = place {
            self.is_artificial[vertex.index()] &= is_artificial;
        }
        let is_special = matches!(place, Place::Special(_));
        let (below, above) = self.gaps_on_side(event, around, is_special);
        self.begin_edges(vertex, around, [below, above]);
        self.end_edges(vertex, around.left);
        match place {
            Place::Special(_) => {
                let leaving = leaving_right(around.right).chain(leaving_left(around.left));
                self.on_sides.add_ends(location, leaving);
            }
            Place::New(seam) | Place::Met(seam) => {
                let right: Vec<_> = leaving_right(around.right).collect();
                let left: Vec<_> = leaving_left(around.left).collect();
                if let Place::New(_) = place {
                    // Isolated until an edge is found.
                    self.isolated.push((vertex, below));
                }
                self.on_sides.add_to_seam(seam, location, &right, &left);
            }
        }
        vertex
    }

    /// The labels below the lowest and above the highest edge that begins at an event on a side; updates what is below and above
    /// all strands.
    fn gaps_on_side<G: BasicTraits>(
        &mut self,
        event: &Event<'_, G>,
        around: &Around<'_, BuildTag>,
        is_special: bool,
    ) -> (u32, u32) {
        let location = event.site.location;
        let (left_above, is_right_empty) =
            (around.left.last().map(|strand| strand.tag.above), around.right.is_empty());
        let below_left = around.below.map_or(self.bottom, |tag| tag.above);
        match (location.u, location.v) {
            (Along::Low, v) => {
                let below = below_left;
                // What begins in the lower corner is below all of the side, and what is in the upper one above.
                if !is_special || v != Along::Low {
                    self.on_sides.end_first_interval(self.top);
                }
                if is_special && is_right_empty {
                    // A curve along the side ends in the corner: what is right of it is above all, then.
                    self.top = below;
                    return (below, below);
                }
                let above = self.labels.fresh();
                if !is_special {
                    self.on_sides.begin_interval(above);
                }
                self.top = above;
                if is_right_empty {
                    self.labels.join(below, above);
                }
                (below, above)
            }
            (Along::High, v) => {
                if !is_special {
                    self.on_sides.join_right(&mut self.labels, self.bottom);
                } else if v == Along::High {
                    self.on_sides.join_last(&mut self.labels, self.bottom);
                }
                self.bottom = left_above.unwrap_or(self.bottom);
                (self.bottom, self.bottom)
            }
            (_, Along::Low) => {
                let above = left_above.unwrap_or(self.bottom);
                self.bottom = if is_right_empty { above } else { self.labels.fresh() };
                (self.bottom, above)
            }
            (_, _) => {
                let below = if around.left.is_empty() { self.top } else { below_left };
                self.top = if is_right_empty { below } else { self.labels.fresh() };
                let gaps = (below, self.top);
                if self.sides.is_v_identified() {
                    self.labels.join(self.bottom, self.top);
                }
                gaps
            }
        }
    }

    /// Once all events on the left side are over, bottom and top are one gap if they are glued together.
    #[inline]
    fn leave_left_side(&mut self) {
        if self.is_before_interior {
            self.is_before_interior = false;
            self.on_sides.end_first_interval(self.top);
            if self.sides.is_v_identified() {
                self.labels.join(self.bottom, self.top);
            }
        }
    }

    /// Makes the cells.
    pub(crate) fn finish<G: BasicTraits<Point = P>, T: Topology<G>>(mut self, topology: &T) -> Built<P> {
        self.leave_left_side();
        self.on_sides.join_last(&mut self.labels, self.top);
        let gaps_of_special = self.on_sides.gaps_of_special(0, self.bottom, self.top);
        let special = special_count(topology);
        let mut is_attached = vec![false; if self.on_sides.is_empty() { 0 } else { self.outgoing.len() }];
        for (vertex, leaving) in self.on_sides.link(&mut self.halfedges) {
            self.outgoing[vertex.index()] = leaving;
            is_attached[vertex.index()] = true;
        }
        let (faces, face_count) = self.labels.into_faces();
        let mut isolated: Vec<(VertexId, FaceId)> = gaps_of_special
            .into_iter()
            .filter(|(v, _)| self.outgoing[v.index()] == HalfedgeId::NONE)
            .map(|(v, gap)| (v, FaceId(faces[gap as usize])))
            .collect();
        for (vertex, label) in self.isolated {
            if !is_attached.get(vertex.index()).is_some_and(|&is| is) {
                isolated.push((vertex, FaceId(faces[label as usize])));
            }
        }
        let raw = cycles::Raw {
            halfedges: self.halfedges,
            outgoing: self.outgoing,
            isolated,
            faces: &faces,
            face_count,
            special,
        };
        let dcel = cycles::assemble(raw, |turns| topology.ccb_kind(turns));
        // As soon as anything else happens at a cut, it is an ordinary vertex.
        let mut is_artificial = self.is_artificial;
        for (v, is) in is_artificial.iter_mut().enumerate().filter(|(_, is)| **is) {
            let degree = dcel.degree(VertexId::new(v));
            *is = degree == 2 || v < special && degree == 0;
        }
        Built {
            dcel,
            points: self.points,
            is_artificial,
            edge_curves: self.edge_curves,
            overlaps: self.overlaps,
        }
    }
}

/// The number of vertices that stand for sides; they come first.
pub(crate) fn special_count<G: BasicTraits, T: Topology<G>>(topology: &T) -> usize {
    topology.side_vertices().into_iter().flatten().max().map_or(0, |last| last as usize + 1)
}

/// For each vertex that stands for a side, the point to which that is contracted.
pub(crate) fn contractions<G: BasicTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
) -> Vec<Option<G::Point>> {
    let mut points = vec![None; special_count(topology)];
    for (side, v) in topology.side_vertices().into_iter().enumerate() {
        if let Some(v) = v {
            points[v as usize] = topology.contraction(traits, side);
        }
    }
    points
}

fn leaving_right(right: &[Strand<BuildTag>]) -> impl Iterator<Item = HalfedgeId> + '_ {
    right.iter().map(|strand| HalfedgeId(2 * strand.tag.edge))
}

fn leaving_left(left: &[Strand<BuildTag>]) -> impl Iterator<Item = HalfedgeId> + '_ {
    left.iter().rev().map(|strand| HalfedgeId(2 * strand.tag.edge + 1))
}

impl<G: BasicTraits> SweepVisitor<G> for Builder<'_, G::Point> {
    type Tag = BuildTag;

    #[inline]
    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, BuildTag>) -> ControlFlow<()> {
        let is_artificial = !event.is_meeting
            && event
                .input_sites
                .iter()
                .all(|&site| self.is_artificial_site.get(site as usize) == Some(&true));
        self.last_vertex = if event.site.location.is_interior() {
            self.leave_left_side();
            let vertex = self.add_vertex(event.site.point().cloned(), is_artificial);
            self.interior_event(vertex, around);
            vertex
        } else {
            self.side_event(event, is_artificial, around)
        };
        ControlFlow::Continue(())
    }
}
