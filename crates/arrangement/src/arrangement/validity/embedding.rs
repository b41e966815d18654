//! Are the cells where they say they are? A sweep over the edges, each a curve of its own.

use super::Violation;
use crate::arrangement::Arrangement;
use crate::sweep::{Around, Event, SweepInput, SweepVisitor, sweep};
use crate::topology::Topology;
use crate::traits::{Along, Location, UMonotoneTraits};
use dcel::{Dcel, EdgeId, FaceId, VertexId};
use std::ops::ControlFlow;

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Looks for cells that are not where they say, and stops when there are as many violations as the limit says. Each edge must
    /// lie on its support.
    pub(super) fn check_embedding(&self, limit: usize, found: &mut Vec<Violation>) {
        let edges: Vec<EdgeId> = self.dcel.edges().collect();
        let curves: Vec<G::UMonotoneCurve> = edges.iter().map(|&e| self.make_edge_curve(e)).collect();
        let isolated: Vec<VertexId> = self.vertices().filter(|&v| self.dcel.outgoing(v).is_none()).collect();
        let points = isolated.iter().filter_map(|&v| self.point(v));
        let input = SweepInput::of_curves(&self.traits, &self.topology, &curves, points);
        // The vertices of the sites, by the ends of the curves; those that are images of others are not among them.
        let mut vertices: Vec<Option<VertexId>> = vec![None; input.site_count()];
        for (i, &e) in edges.iter().enumerate() {
            for (site, v) in input.ends(i).into_iter().zip(self.dcel.ends(e)) {
                vertices[site] = Some(v);
            }
        }
        let free = vertices.iter_mut().skip(2 * edges.len());
        for (site, &v) in free.zip(&isolated) {
            *site = Some(v);
        }
        let mut visitor = Checker {
            dcel: &self.dcel,
            edges: &edges,
            vertices: &vertices,
            is_special: self.points.iter().map(Option::is_none).collect(),
            corner: self.corner_face(),
            bottom: self.corner_face(),
            is_first: true,
            met: vec![0; self.dcel.vertex_bound()],
            on_images: Vec::new(),
            limit,
            found,
        };
        let flow = sweep(&self.traits, &self.topology, &input, &mut visitor);
        let Checker { met, on_images, corner: first, bottom: last, .. } = visitor;
        for (site, e) in on_images {
            let is_there = |v: &VertexId| match (self.inner_point(*v), input.site(site as usize).point()) {
                (Some(p), Some(q)) => self.traits.is_same_point(p, q),
                _ => false,
            };
            found.extend(self.vertices().find(is_there).map(|v| Violation::VertexOnEdge(v, e)));
        }
        if flow.is_break() {
            return;
        }
        // A side to which nothing comes is in the first face of all, or in the last one.
        let [left, right, bottom, top] = self.topology.side_vertices();
        for (side, face) in [(left, first), (right, last), (bottom, first), (top, last)] {
            let Some(v) = side.map(VertexId) else { continue };
            if let Some(by_cells) = self.dcel.isolated_face(v).filter(|&by_cells| by_cells != face) {
                found.push(Violation::WrongFace(v, by_cells, face));
            }
        }
        for v in self.dcel.vertices() {
            if found.len() >= limit {
                return;
            }
            let degree = self.dcel.degree(v) as u32;
            if met[v.index()] != degree && !found.iter().any(is_meeting) {
                found.push(Violation::Unseen(v));
            }
        }
    }
}

/// Tells whether a violation makes the sweep take ends of edges for those of others.
fn is_meeting(violation: &Violation) -> bool {
    use Violation as V;
    matches!(violation, V::Crossing(..) | V::Overlap(..) | V::VertexOnEdge(..) | V::SamePoint(..))
}

struct Checker<'a> {
    dcel: &'a Dcel,
    /// The edge of each curve, and the vertex of each site.
    edges: &'a [EdgeId],
    vertices: &'a [Option<VertexId>],
    is_special: Vec<bool>,
    /// The corner face: as the arrangement says, or after the first event as that says.
    corner: FaceId,
    /// The face below all strands.
    bottom: FaceId,
    /// Whether nothing was met so far.
    is_first: bool,
    /// For each vertex, how many ends of edges were met there.
    met: Vec<u32>,
    /// Images of vertices on other sides through which an edge passes.
    on_images: Vec<(u32, EdgeId)>,
    /// How many violations are enough.
    limit: usize,
    found: &'a mut Vec<Violation>,
}

impl Checker<'_> {
    /// The face above an edge: left of its halfedge to the right.
    fn above(&self, e: EdgeId) -> FaceId {
        self.dcel.face(e.halfedge())
    }

    fn below(&self, e: EdgeId) -> FaceId {
        self.dcel.face(e.halfedge().twin())
    }

    fn expect_face(&mut self, v: VertexId, by_cells: FaceId, found: FaceId) {
        if by_cells != found {
            self.found.push(Violation::WrongFace(v, by_cells, found));
        }
    }

    /// The one vertex of an event, if there is one; notes if there are several.
    fn vertex(&mut self, sites: &[u32]) -> Option<VertexId> {
        let mut vertices = sites.iter().filter_map(|&site| self.vertices[site as usize]);
        let first = vertices.next()?;
        for other in vertices {
            let violation = Violation::SamePoint(first, other);
            if other != first && !self.found.contains(&violation) {
                self.found.push(violation);
            }
        }
        Some(first)
    }

    /// Compares strands that follow each other upwards with the faces between them; the lowest lies on `below`. Gives the face above.
    fn check_gaps(&mut self, v: VertexId, edges: impl Iterator<Item = EdgeId>, below: FaceId) -> FaceId {
        edges.fold(below, |below, e| {
            self.expect_face(v, self.below(e), below);
            self.above(e)
        })
    }

    /// The face at the corner, as the first of all vertices says, if it can.
    fn face_at_corner(&self, v: VertexId, location: Location, right: &[EdgeId]) -> Option<FaceId> {
        let is_bottom = location.u == Along::Inside && location.v == Along::Low;
        match right {
            [] => self.dcel.isolated_face(v),
            // What is left of a curve that rises from the bottom side is above it.
            [.., last] if is_bottom => Some(self.above(*last)),
            [first, ..] => Some(self.below(*first)),
        }
    }

    /// The faces around an event, as the strands next to it say.
    fn check_faces(&mut self, v: VertexId, location: Location, strands: &Strands) {
        if std::mem::take(&mut self.is_first)
            && let Some(face) = self.face_at_corner(v, location, &strands.right)
            && face != self.corner
        {
            self.found.push(Violation::CornerFace(self.corner));
            (self.corner, self.bottom) = (face, face);
        }
        let below = strands.below.map_or(self.bottom, |e| self.above(e));
        let after_left = self.check_gaps(v, strands.left.iter().copied(), below);
        let is_bottom = location.u == Along::Inside && location.v == Along::Low;
        if is_bottom && let Some(&first) = strands.right.first() {
            // A new face comes in below the lowest strand.
            self.bottom = self.below(first);
        } else if is_bottom || location.u == Along::High {
            self.bottom = after_left;
        }
        let below_right = if is_bottom { self.bottom } else { below };
        let after_right = self.check_gaps(v, strands.right.iter().copied(), below_right);
        // Beyond a vertex on another side than the bottom one, another face may begin.
        if location.is_interior() || is_bottom {
            let is_left_only = strands.right.is_empty();
            if !strands.right.is_empty() {
                self.expect_face(v, after_right, after_left);
            }
            let after = if is_left_only { after_left } else { after_right };
            if is_left_only && !is_bottom {
                self.expect_face(v, after_left, below);
            }
            if let Some(above) = strands.above {
                self.expect_face(v, self.below(above), after);
            }
        }
        if let Some(face) = self.dcel.isolated_face(v) {
            self.expect_face(v, face, below);
        }
    }
}

/// The edges around an event.
#[derive(Default)]
struct Strands {
    below: Option<EdgeId>,
    above: Option<EdgeId>,
    left: Vec<EdgeId>,
    right: Vec<EdgeId>,
}

impl<G: UMonotoneTraits> SweepVisitor<G> for Checker<'_> {
    /// The number of a curve, and one more: 0 is none.
    type Tag = u32;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, u32>) -> ControlFlow<()> {
        let edge = |curve: usize| self.edges[curve];
        let of_tag = |tag: Option<u32>| tag.map(|tag| edge(tag as usize - 1));
        let strands = Strands {
            below: of_tag(around.below),
            above: of_tag(around.above),
            left: around.left.iter().map(|strand| edge(strand.curve())).collect(),
            right: around.right.iter().map(|strand| edge(strand.curve())).collect(),
        };
        for i in 0..around.right.len() {
            around.right[i].tag = around.right[i].curve() as u32 + 1;
            if around.is_overlap(i) {
                let mut members = around.curves_of(i);
                if let (Some(a), Some(b)) = (members.next(), members.next()) {
                    self.found.push(Violation::Overlap(self.edges[a], self.edges[b]));
                }
            }
        }
        let has_sites = !event.input_sites.is_empty();
        match self.vertex(event.input_sites) {
            Some(v) => {
                let location = event.site.location;
                let before = self.found.len();
                let strangers = |edges: &[EdgeId], end: usize| -> Vec<EdgeId> {
                    edges.iter().copied().filter(|&e| self.dcel.ends(e)[end] != v).collect()
                };
                let mut passing = strangers(&strands.left, 1);
                passing.extend(strangers(&strands.right, 0));
                passing.sort_unstable();
                passing.dedup();
                // At one point with another vertex is another violation.
                let are_at_one_point = self
                    .found
                    .iter()
                    .any(|violation| matches!(violation, Violation::SamePoint(a, _) if *a == v));
                if !are_at_one_point {
                    self.found.extend(passing.into_iter().map(|e| Violation::VertexOnEdge(v, e)));
                }
                self.met[v.index()] += (strands.left.len() + strands.right.len()) as u32;
                if before == self.found.len() && !(self.is_special[v.index()] && location.is_interior()) {
                    self.check_faces(v, location, &strands);
                }
            }
            // The image on another side of a vertex: no edge may pass through it.
            None if has_sites => {
                let site = event.input_sites[0];
                self.on_images.extend(strands.left.iter().map(|&e| (site, e)));
            }
            None => {
                if let [a, b, ..] = strands.left[..] {
                    self.found.push(Violation::Crossing(a, b));
                } else if let ([a], [b, ..]) = (&strands.left[..], &strands.right[..]) {
                    self.found.push(Violation::Crossing(*a, *b));
                }
            }
        }
        if self.found.len() + self.on_images.len() >= self.limit {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}
