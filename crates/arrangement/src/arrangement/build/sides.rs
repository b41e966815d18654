//! Vertices on the sides of the parameter space, and how faces continue there.

use super::labels::Labels;
use super::rotation::link;
use crate::traits::{Along, Location, Sides};
use dcel::{Halfedge, HalfedgeId, VertexId};

/// What becomes of an event on a side.
pub(super) enum Place {
    /// A vertex without a point of its own, to which a side or several are closed.
    Special(VertexId),
    /// The place of a vertex on an identification that was not met before.
    New(usize),
    /// One that was met before, on the other side.
    Met(usize),
}

/// A vertex on an identification: the halfedges that leave it, in five sectors, counterclockwise.
///
/// Sectors: to the right into the lower half; to the right into the upper half; to the left into the upper half; to the left into
/// the lower half; along the left side downwards.
#[derive(Debug, Default)]
struct Seam {
    vertex: u32,
    sectors: [Vec<HalfedgeId>; 5],
}

/// The vertices on sides, while a sweep is under way.
#[derive(Debug)]
pub(super) struct SideVertices {
    sides: Sides,
    /// The special vertex of each side: left, right, bottom, top.
    special: [Option<VertexId>; 4],
    /// The halfedges that leave special vertices, along each side from left to right, or from bottom to top.
    ends: [Vec<HalfedgeId>; 4],
    /// How many of those on the top are not in its right corner, if one is.
    before_corner: Option<usize>,
    seams: Vec<Seam>,
    /// The vertices on the left side, from bottom to top, the corner twice; and how many of them were met on the right.
    left: Vec<usize>,
    met_right: usize,
    /// The vertex of the last event on the bottom.
    bottom: usize,
    corner: Option<usize>,
    /// The labels of the gaps next to the left side: below the first vertex on it, between, above the last. A gap that a curve along
    /// the side closes off is the one behind it. Curves in corners that are special vertices do not count.
    intervals: Vec<u32>,
    /// Whether the gap above the last vertex on the right side was joined to that on the left.
    is_last_joined: bool,
}

impl SideVertices {
    /// `special` has the vertex that stands for each side: see [`crate::topology::Topology::side_vertices`].
    pub(super) fn new(sides: Sides, special: [Option<u32>; 4]) -> Self {
        let special = special.map(|vertex| vertex.map(VertexId));
        Self {
            sides,
            special,
            ends: Default::default(),
            before_corner: None,
            seams: Vec::new(),
            left: Vec::new(),
            met_right: 0,
            bottom: 0,
            corner: None,
            intervals: Vec::new(),
            is_last_joined: false,
        }
    }

    /// Finds the vertex of an event on a side.
    pub(super) fn place(&mut self, location: Location) -> Place {
        for (side, is_there) in sides_of(location) {
            if let (true, Some(vertex)) = (is_there, self.special[side]) {
                return Place::Special(vertex);
            }
        }
        match location {
            Location { u: Along::High, .. } if self.sides.is_u_identified() => {
                let seam = self.left[self.met_right];
                self.met_right += 1;
                Place::Met(seam)
            }
            Location { u: Along::Low, v } if self.sides.is_u_identified() => {
                let is_corner = v != Along::Inside && self.sides.is_v_identified();
                let place = match self.corner.filter(|_| is_corner) {
                    Some(corner) => Place::Met(corner),
                    None => Place::New(self.seams.len()),
                };
                if let Place::New(seam) | Place::Met(seam) = place {
                    self.left.push(seam);
                    self.corner = self.corner.or(is_corner.then_some(seam));
                }
                place
            }
            Location { v: Along::High, .. } => Place::Met(self.bottom),
            _ => {
                self.bottom = self.seams.len();
                Place::New(self.seams.len())
            }
        }
    }

    /// Whether no side has a vertex.
    pub(super) fn is_empty(&self) -> bool {
        self.seams.is_empty() && self.special.iter().all(Option::is_none)
    }

    pub(super) fn add_seam(&mut self, vertex: VertexId) {
        self.seams.push(Seam { vertex: vertex.0, sectors: Default::default() });
    }

    pub(super) fn seam_vertex(&self, seam: usize) -> VertexId {
        VertexId(self.seams[seam].vertex)
    }

    /// Notes the halfedges that leave a vertex on an identification at one of its places: to the right from bottom to top, and to
    /// the left from top to bottom.
    pub(super) fn add_to_seam(
        &mut self,
        seam: usize,
        location: Location,
        right: &[HalfedgeId],
        left: &[HalfedgeId],
    ) {
        let is_top = location.v == Along::High;
        let right_sector = if is_top { 0 } else { 1 };
        let left_sector = match location {
            Location { u: Along::Low, .. } => 4,
            _ if is_top => 3,
            _ => 2,
        };
        let sectors = &mut self.seams[seam].sectors;
        sectors[right_sector].extend(right);
        sectors[left_sector].extend(left);
    }

    /// Notes the halfedges that leave a special vertex.
    pub(super) fn add_ends(&mut self, location: Location, leaving: impl Iterator<Item = HalfedgeId>) {
        if let Some((side, _)) =
            sides_of(location).into_iter().find(|&(side, is)| is && self.special[side].is_some())
        {
            let ends = &mut self.ends[side];
            // A corner is met as a part of the left or right side. There what is met first, because it is lower, may be further right.
            let at = match (side, location.u) {
                (2, Along::Low) => 0,
                (3, Along::High) => *self.before_corner.get_or_insert(ends.len()),
                _ => ends.len(),
            };
            ends.splice(at..at, leaving);
        }
    }

    /// The lowest interval of the left side ends; what is above all strands there has this label.
    #[inline]
    pub(super) fn end_first_interval(&mut self, top: u32) {
        if self.intervals.is_empty() {
            self.intervals.push(top);
        }
    }

    /// A vertex on the left side, above which the gap has this label.
    pub(super) fn begin_interval(&mut self, above: u32) {
        self.intervals.push(above);
    }

    /// The gap below an event on the right side continues on the left.
    pub(super) fn join_right(&self, labels: &mut Labels, below: u32) {
        // Below the lower corner there is nothing.
        let interval = self.met_right - 1;
        if !(interval == 0 && self.corner.is_some()) {
            labels.join(below, self.intervals[interval]);
        }
    }

    /// The gap above all vertices on the right side continues on the left. To be told when curves in the upper corner end, or at the
    /// end.
    pub(super) fn join_last(&mut self, labels: &mut Labels, above: u32) {
        let is_joined = std::mem::replace(&mut self.is_last_joined, true);
        if !is_joined
            && self.sides.is_u_identified()
            && self.corner.is_none()
            && let Some(&last) = self.intervals.last()
        {
            labels.join(above, last);
        }
    }

    /// For each special vertex, the gap in which it is if nothing comes to it, where `first` is the first gap of all, and the last ones
    /// below and above all strands are given.
    pub(super) fn gaps_of_special(&self, first: u32, bottom: u32, top: u32) -> Vec<(VertexId, u32)> {
        let mut gaps: Vec<(VertexId, u32)> = self
            .special
            .into_iter()
            .zip([first, bottom, first, top])
            .filter_map(|(v, gap)| Some((v?, gap)))
            .collect();
        gaps.sort_unstable();
        gaps.dedup_by_key(|(v, _)| *v);
        gaps
    }

    /// Links the halfedges around all vertices on sides, and gives one that leaves each.
    pub(super) fn link(self, halfedges: &mut [Halfedge]) -> Vec<(VertexId, HalfedgeId)> {
        let mut leaving = Vec::new();
        for Seam { vertex, sectors } in &self.seams {
            let around = sectors.concat();
            link(halfedges, &around);
            leaving.extend(around.first().map(|&h| (VertexId(*vertex), h)));
        }
        let [left, right, bottom, top] = self.ends;
        // Clockwise around a point to which sides are closed is counterclockwise along the sides.
        let clockwise = [
            (self.special[1], right.into_iter().collect::<Vec<_>>()),
            (self.special[3], top.into_iter().rev().collect()),
            (self.special[0], left.into_iter().rev().collect()),
            (self.special[2], bottom),
        ];
        let mut vertices: Vec<VertexId> = self.special.into_iter().flatten().collect();
        vertices.sort_unstable();
        vertices.dedup();
        for vertex in vertices {
            let ends = clockwise.iter().filter(|(v, _)| *v == Some(vertex));
            let mut around: Vec<HalfedgeId> = ends.flat_map(|(_, ends)| ends).copied().collect();
            around.reverse();
            let mut before = around.last().copied();
            for &h in &around {
                if let Some(b) = before.replace(h) {
                    halfedges[h.twin().index()].next = b;
                }
            }
            leaving.extend(around.first().map(|&h| (vertex, h)));
        }
        leaving
    }
}

fn sides_of(location: Location) -> [(usize, bool); 4] {
    [
        (2, location.v == Along::Low),
        (3, location.v == Along::High),
        (0, location.u == Along::Low),
        (1, location.u == Along::High),
    ]
}
