//! Identified sides, cut at the vertices and feet on them.

use super::super::records::NONE;
use super::super::walls::Step;
use super::super::{SiteId, VerticalDecomposition};
use super::columns::{LEFT, RIGHT};
use super::pieces::Pieces;
use super::{EdgeOrigin, VertexOrigin};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, Location};
use dcel::EdgeId;

/// An identified left side, which is the right one too.
#[derive(Debug)]
pub(super) struct Left {
    /// The lowest piece; the others follow.
    pub(super) first: u32,
    /// How many there are.
    pub(super) count: u32,
    /// For each site on the left or right side how many pieces are below; others are left out.
    places: Vec<u32>,
    /// How many sites are on the left side, and how many are on none.
    left_out: [usize; 2],
}

impl Left {
    /// The number of pieces below a site on either side.
    pub(super) fn place(&self, site: SiteId) -> u32 {
        let [left, out] = self.left_out;
        let site = site.index();
        self.places[if site < left { site } else { site - out }]
    }
}

/// An identified bottom side, which is the top one too.
#[derive(Debug)]
pub(super) struct Level {
    /// The leftmost piece; the others follow.
    pub(super) first: u32,
    pub(super) count: u32,
    /// For each column the number of pieces to the left of it.
    places: Vec<u32>,
    /// The vertices between pieces.
    vertices: Vec<u32>,
}

impl Level {
    /// The number of pieces to the left of a column.
    pub(super) fn place(&self, column: u32) -> u32 {
        if column == RIGHT { self.count } else { self.places[column as usize] }
    }

    /// The vertex in a column, if one is there.
    pub(super) fn vertex(&self, column: u32) -> u32 {
        self.vertices[self.place(column) as usize]
    }
}

impl Pieces {
    /// Cuts the identified sides.
    pub(super) fn add_identified_sides<G: BasicTraits, T: Topology<G>>(
        &mut self,
        decomposition: &VerticalDecomposition,
        arrangement: &Arrangement<G, T>,
    ) {
        let sides = arrangement.topology().sides();
        let [is_u, is_v] = [sides.is_u_identified(), sides.is_v_identified()];
        let mut corner = NONE;
        if is_u && is_v {
            let is_corner =
                |&site: &SiteId| decomposition.location(site) == Location { u: Along::Low, v: Along::Low };
            let site = decomposition.sites().next().filter(is_corner);
            corner = match site {
                Some(site) => self.vertex(decomposition, site),
                None => self.add_vertex(VertexOrigin::Corner),
            };
        }
        let ends = |i: usize| if corner == NONE { [self.sides[i], self.sides[i + 1]] } else { [corner; 2] };
        let (of_left, of_level) = (ends(2), ends(0));
        if is_u {
            self.left = Some(self.cut_left(decomposition, arrangement, of_left));
        }
        if is_v {
            self.level = Some(self.cut_level(decomposition, arrangement, of_level));
        }
    }

    /// Cuts the left side at the vertices on it, from bottom to top.
    fn cut_left<G: BasicTraits, T: Topology<G>>(
        &mut self,
        decomposition: &VerticalDecomposition,
        arrangement: &Arrangement<G, T>,
        ends: [u32; 2],
    ) -> Left {
        let is_at = |site: &SiteId, u: Along| decomposition.location(*site).u == u;
        let lefts: Vec<SiteId> = decomposition.sites().take_while(|site| is_at(site, Along::Low)).collect();
        let first_right = decomposition.sites().rev().take_while(|site| is_at(site, Along::High)).count();
        let first_right = decomposition.site_count() - first_right;
        let is_between = |site: &SiteId| decomposition.location(*site).v == Along::Inside;
        let between: Vec<SiteId> = lefts.iter().copied().filter(is_between).collect();
        let count = between.len() as u32 + 1;
        let place = |site: SiteId| match decomposition.location(site).v {
            Along::Low => 0,
            Along::High => count,
            Along::Inside => {
                let mut sites = decomposition.sites_of(decomposition.vertex(site));
                let home = sites.find(|home| is_at(home, Along::Low) && is_between(home));
                let home = home.expect("a vertex on an identified side has a site on the left");
                between.partition_point(|&other| other <= home) as u32
            }
        };
        let mut origins = vec![EdgeOrigin::Identification; count as usize];
        let mut along_left = |e: EdgeId| {
            let [from, to] = decomposition.ends(e);
            if self.columns.of(from) == LEFT && self.columns.of(to) == LEFT {
                origins[place(from) as usize..place(to) as usize].fill(EdgeOrigin::Edge(e));
            }
        };
        arrangement.dcel().edges().for_each(&mut along_left);
        // Sites on the right side come behind those on the left, as if no others were between.
        let rights = (first_right..decomposition.site_count()).map(|site| SiteId(site as u32));
        let places = lefts.iter().copied().chain(rights).map(place).collect();
        let first = self.edges.len() as u32;
        let mut last = ends[0];
        for (i, &origin) in origins.iter().enumerate() {
            let next = between.get(i).map_or(ends[1], |&site| self.vertex(decomposition, site));
            self.add_piece(origin, [last, next]);
            last = next;
        }
        Left { first, count, places, left_out: [lefts.len(), first_right - lefts.len()] }
    }

    /// Cuts the bottom side at the vertices on it, and where walls come to it from both sides; from left to right.
    fn cut_level<G: BasicTraits, T: Topology<G>>(
        &mut self,
        decomposition: &VerticalDecomposition,
        arrangement: &Arrangement<G, T>,
        ends: [u32; 2],
    ) -> Level {
        let bound = self.columns.bound();
        // For each column a vertex, and the sites whose walls come from below and above.
        let mut columns = vec![[NONE; 3]; bound];
        for site in decomposition.sites() {
            let Location { u, v } = decomposition.location(site);
            if u != Along::Inside {
                continue;
            }
            let column = &mut columns[self.columns.of(site) as usize];
            if v != Along::Inside {
                column[0] = self.vertex(decomposition, site);
            }
            if decomposition.step_up(site) == Step::Side {
                column[1] = site.0;
            }
            match decomposition.step_down(site) {
                Step::Side => column[2] = site.0,
                Step::Edge(e) if decomposition.is_along_bottom(e) => column[2] = site.0,
                _ => {}
            }
        }
        let mut count = 0;
        let is_cut = |column: &[u32; 3]| column.iter().any(|&what| what != NONE);
        let places: Vec<u32> = columns
            .iter()
            .map(|column| {
                count += u32::from(is_cut(column));
                count
            })
            .collect();
        let mut level =
            Level { first: self.edges.len() as u32, count: count + 1, places, vertices: Vec::new() };
        let mut along = vec![None; level.count as usize];
        for e in arrangement.dcel().edges().filter(|&e| decomposition.is_along_bottom(e)) {
            let [from, to] = decomposition.ends(e).map(|site| level.place(self.columns.of(site)));
            along[from as usize..to as usize].fill(Some(e));
        }
        level.vertices.push(ends[0]);
        for &[vertex, below, above] in columns.iter().filter(|&column| is_cut(column)) {
            let some = |site: u32| (site != NONE).then_some(SiteId(site));
            let next = level.vertices.len();
            level.vertices.push(if vertex == NONE {
                let edge = along[next].filter(|_| along[next - 1] == along[next]);
                self.add_vertex(VertexOrigin::Foot { below: some(below), above: some(above), edge })
            } else {
                vertex
            });
        }
        level.vertices.push(ends[1]);
        for (along, ends) in along.iter().zip(level.vertices.windows(2)) {
            let origin = along.map_or(EdgeOrigin::Identification, EdgeOrigin::Edge);
            self.add_piece(origin, [ends[0], ends[1]]);
        }
        level
    }
}
