//! The vertices and edges of the complex, and where along edges, walls and sides they are.

use super::super::records::NONE;
use super::super::walls::Step;
use super::super::{SiteId, TrapezoidId, VerticalDecomposition};
use super::columns::{Closure, Columns, LEFT, closures};
use super::sides::{Left, Level};
use super::{EdgeOrigin, VertexOrigin};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{EdgeId, VertexId};

/// All pieces, and what trapezoids have along edges.
#[derive(Debug)]
pub(super) struct Pieces {
    pub(super) columns: Columns,
    pub(super) vertices: Vec<VertexOrigin>,
    pub(super) edges: Vec<EdgeOrigin>,
    /// For each edge the vertices where it begins and ends.
    pub(super) ends: Vec<[u32; 2]>,
    /// For each vertex of the arrangement, its number here.
    pub(super) vertex_of: Vec<u32>,
    /// The vertices that stand for the sides left, right, bottom and top; none if these are identified.
    pub(super) sides: [u32; 4],
    /// For each edge of the arrangement its first piece; the others follow. None if it runs along an identified side.
    pub(super) first_piece: Vec<u32>,
    /// For each trapezoid the pieces of the edge below, first and behind the last, and of the one above.
    pub(super) along: Vec<[[u32; 2]; 2]>,
    /// For each site its walls, down and up.
    pub(super) walls: Vec<[u32; 2]>,
    /// For each site the feet of its walls, down and up, on edges.
    pub(super) feet: Vec<[u32; 2]>,
    /// The identified left side.
    pub(super) left: Option<Left>,
    /// The identified bottom side.
    pub(super) level: Option<Level>,
}

impl Pieces {
    pub(super) fn new<G: BasicTraits, T: Topology<G>>(
        decomposition: &VerticalDecomposition,
        arrangement: &Arrangement<G, T>,
    ) -> Self {
        let dcel = arrangement.dcel();
        let mut vertex_of = vec![NONE; dcel.vertex_bound()];
        let mut vertices = Vec::with_capacity(dcel.vertex_count());
        for v in dcel.vertices() {
            vertex_of[v.index()] = vertices.len() as u32;
            vertices.push(VertexOrigin::Vertex(v));
        }
        let closures = closures(arrangement.topology());
        let new = closures.iter().filter_map(|closure| match closure {
            Closure::New(number) => Some(number + 1),
            _ => None,
        });
        let first_new = vertices.len() as u32;
        vertices.extend((0..new.max().unwrap_or(0)).map(|_| VertexOrigin::Infinity));
        let sides = closures.map(|closure| match closure {
            Closure::Vertex(v) => vertex_of[v as usize],
            Closure::New(number) => first_new + number,
            Closure::None => NONE,
        });
        let mut pieces = Self {
            columns: Columns::new(decomposition),
            vertices,
            edges: Vec::new(),
            ends: Vec::new(),
            vertex_of,
            sides,
            first_piece: vec![NONE; dcel.edge_bound()],
            along: vec![[[0; 2]; 2]; decomposition.trapezoid_count()],
            walls: vec![[NONE; 2]; decomposition.site_count()],
            feet: vec![[NONE; 2]; decomposition.site_count()],
            left: None,
            level: None,
        };
        pieces.add_identified_sides(decomposition, arrangement);
        let mut cuts = Vec::new();
        for e in dcel.edges() {
            if !pieces.is_along_side(decomposition, e) {
                pieces.add_edge(decomposition, e, &mut cuts);
            }
        }
        for site in decomposition.sites() {
            pieces.add_walls(decomposition, site);
        }
        pieces
    }

    /// Whether an edge runs along an identified side.
    pub(super) fn is_along_side(&self, decomposition: &VerticalDecomposition, e: EdgeId) -> bool {
        let [from, to] = decomposition.ends(e).map(|site| self.columns.of(site));
        from == LEFT && to == LEFT || decomposition.is_along_bottom(e)
    }

    pub(super) fn add_vertex(&mut self, origin: VertexOrigin) -> u32 {
        self.vertices.push(origin);
        self.vertices.len() as u32 - 1
    }

    pub(super) fn add_piece(&mut self, origin: EdgeOrigin, ends: [u32; 2]) -> u32 {
        debug_assert!(ends.iter().all(|&end| end != NONE), "a piece has two ends");
        self.edges.push(origin);
        self.ends.push(ends);
        self.edges.len() as u32 - 1
    }

    /// The number of the vertex of a site.
    pub(super) fn vertex(&self, decomposition: &VerticalDecomposition, site: SiteId) -> u32 {
        let VertexId(v) = decomposition.vertex(site);
        self.vertex_of[v as usize]
    }

    /// Cuts an edge at the feet of walls on both sides of it, and notes what trapezoids have along it.
    fn add_edge(&mut self, decomposition: &VerticalDecomposition, e: EdgeId, cuts: &mut Vec<Cut>) {
        let ends = decomposition.ends(e);
        let [from, to] = ends.map(|site| self.columns.of(site));
        let above = decomposition.above(Some(e)).map(TrapezoidId);
        let below = decomposition.below(Some(e)).iter().copied();
        cuts.clear();
        for (t, side) in below.clone().map(|t| (t, 0)).chain(above.clone().map(|t| (t, 1))) {
            let trapezoid = decomposition.trapezoid(t);
            let columns = self.columns.of_trapezoid(&trapezoid);
            if decomposition.is_degenerate(t) {
                continue;
            }
            // From above comes the wall of the lowest site, where a trapezoid ends; from below that of the highest, where one begins.
            let (column, site) =
                if side == 1 { (columns[1], trapezoid.right) } else { (columns[0], trapezoid.left) };
            if let Some(site) = site.filter(|_| from < column && column < to) {
                cuts.push(Cut { column, side, site });
            }
        }
        cuts.sort_unstable_by_key(|cut| (cut.column, cut.side));
        let first = self.edges.len() as u32;
        self.first_piece[e.index()] = first;
        let mut last = self.vertex(decomposition, ends[0]);
        for walls in cuts.chunk_by(|a, b| a.column == b.column) {
            let site = |side| walls.iter().find(|cut| cut.side == side).map(|cut| cut.site);
            let [below, above] = [site(0), site(1)];
            let foot = self.add_vertex(VertexOrigin::Foot { below, above, edge: Some(e) });
            for cut in walls {
                // The wall of a site below goes up.
                self.feet[cut.site.index()][1 - cut.side] = foot;
            }
            self.add_piece(EdgeOrigin::Edge(e), [last, foot]);
            last = foot;
        }
        let end = self.vertex(decomposition, ends[1]);
        self.add_piece(EdgeOrigin::Edge(e), [last, end]);
        cuts.dedup_by_key(|cut| cut.column);
        for (t, place) in below.map(|t| (t, 1)).chain(above.map(|t| (t, 0))) {
            let [from, to] = self.columns.of_trapezoid(&decomposition.trapezoid(t));
            let begin = cuts.partition_point(|cut| cut.column <= from) as u32;
            let end = cuts.partition_point(|cut| cut.column < to) as u32 + 1;
            self.along[t.index()][place] = [first + begin, first + end];
        }
    }

    /// Makes the walls of a site; one between two sites is made with the lower one.
    fn add_walls(&mut self, decomposition: &VerticalDecomposition, site: SiteId) {
        let here = self.vertex(decomposition, site);
        let at_side = |pieces: &Self, side: usize| match &pieces.level {
            Some(level) => level.vertex(pieces.columns.of(site)),
            None => pieces.sides[side],
        };
        let foot = match decomposition.step_down(site) {
            Step::Edge(e) if !decomposition.is_along_bottom(e) => self.feet[site.index()][0],
            Step::Edge(_) | Step::Side => at_side(self, 2),
            Step::Site(_) | Step::Along(..) | Step::Out => NONE,
        };
        if foot != NONE {
            let origin = EdgeOrigin::Wall { below: None, above: Some(site) };
            self.walls[site.index()][0] = self.add_piece(origin, [foot, here]);
        }
        let (end, above) = match decomposition.step_up(site) {
            Step::Site(other) => (self.vertex(decomposition, other), Some(other)),
            Step::Edge(_) => (self.feet[site.index()][1], None),
            Step::Side => (at_side(self, 3), None),
            Step::Along(..) | Step::Out => return,
        };
        let wall = self.add_piece(EdgeOrigin::Wall { below: Some(site), above }, [here, end]);
        self.walls[site.index()][1] = wall;
        if let Some(above) = above {
            self.walls[above.index()][0] = wall;
        }
    }
}

/// Where a wall meets an edge, from below (0) or above (1).
#[derive(Clone, Copy, Debug)]
struct Cut {
    column: u32,
    side: usize,
    site: SiteId,
}
