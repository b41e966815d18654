//! Six arrangements become one: a walk along the edges of the cube.

use crate::map::{At, CubicalArrangement, CubicalFaceId, Side, SideArrangement};
use crate::pieces::{border_of, side_behind};
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use exact::gnomonic::CubeSide;
use exact::planar::Point2;

/// One side, before it is stitched to the others.
#[derive(Debug)]
pub(crate) struct Patch {
    pub(crate) arrangement: SideArrangement,
    pub(crate) is_real_edge: Vec<bool>,
    /// For each vertex on the border, whether it is real without regard to what meets there.
    pub(crate) is_given: Vec<bool>,
}

/// The halfedges around the square, from the outside: clockwise.
pub(crate) fn border_cycle(arrangement: &SideArrangement) -> impl Iterator<Item = HalfedgeId> + '_ {
    let dcel = arrangement.dcel();
    let ccb = dcel.inner_ccbs(arrangement.corner_face()).next().expect("the square is a hole of the plane");
    dcel.ccb_cycle(ccb)
}

/// The four edges of a square: vertices and inner halfedges, from the lesser to the greater end.
struct Borders {
    vertices: [Vec<VertexId>; 4],
    edges: [Vec<EdgeId>; 4],
}

impl Borders {
    fn of(arrangement: &SideArrangement) -> Self {
        let dcel = arrangement.dcel();
        let corners = [[-1, -1], [-1, 1], [1, 1], [1, -1]].map(Point2::from_i64);
        let mut cycle: Vec<HalfedgeId> = border_cycle(arrangement).collect();
        let is_at = |h: HalfedgeId, corner: &Point2| arrangement.point(dcel.source(h)) == Some(corner);
        let first = cycle.iter().position(|&h| is_at(h, &corners[0])).expect("the square has corners");
        cycle.rotate_left(first);
        let mut borders = Self { vertices: Default::default(), edges: Default::default() };
        // Clockwise: u = -1 upwards, v = 1 to the right, u = 1 downwards, v = -1 to the left.
        let mut way = [0, 3, 1, 2].into_iter().zip([1, 2, 3, 0]);
        let (mut border, mut end) = way.next().expect("a square has four edges");
        for &h in &cycle {
            borders.vertices[border].push(dcel.source(h));
            borders.edges[border].push(h.edge_id());
            let target = dcel.next(h);
            if is_at(target, &corners[end]) {
                borders.vertices[border].push(dcel.source(target));
                if let Some(next) = way.next() {
                    (border, end) = next;
                }
            }
        }
        for border in [1, 2] {
            borders.vertices[border].reverse();
            borders.edges[border].reverse();
        }
        borders
    }

    /// The vertices at the corners: (-1, -1), (-1, 1), (1, -1), (1, 1).
    fn corners(&self) -> [VertexId; 4] {
        let ends = |border: usize| {
            let vertices = &self.vertices[border];
            [vertices[0], vertices[vertices.len() - 1]]
        };
        let [[a, b], [c, d]] = [ends(0), ends(1)];
        [a, b, c, d]
    }
}

/// Stitches six arrangements that have the same vertices along every edge of the cube.
pub(crate) fn stitch(patches: [Patch; 6]) -> CubicalArrangement {
    let borders = patches.each_ref().map(|patch| Borders::of(&patch.arrangement));
    let mut sides = patches.map(|Patch { arrangement, is_real_edge, is_given }| Side {
        next_copy: vec![None; arrangement.dcel().vertex_bound()],
        across: vec![None; arrangement.dcel().edge_bound()],
        corners: [VertexId(0); 4],
        faces: Vec::new(),
        is_real_vertex: is_given,
        is_real_edge,
        arrangement,
    });
    for side in CubeSide::ALL {
        for border in 0..4 {
            let other = side_behind(side, border);
            let [own, behind] = [(side, border), (other, border_of(other, side))];
            let vertices = |(side, border): (CubeSide, usize)| &borders[side.index()].vertices[border];
            let edges = |(side, border): (CubeSide, usize)| &borders[side.index()].edges[border];
            debug_assert_eq!(edges(own).len(), edges(behind).len(), "both sides have the same vertices");
            for (&e, &id) in edges(own).iter().zip(edges(behind)) {
                sides[side.index()].across[e.index()] = Some(At { side: other, id });
            }
            let inner = 1..vertices(own).len() - 1;
            for (&v, &id) in vertices(own)[inner.clone()].iter().zip(&vertices(behind)[inner]) {
                sides[side.index()].next_copy[v.index()] = Some(At { side: other, id });
            }
        }
        sides[side.index()].corners = borders[side.index()].corners();
    }
    for corner in 0..8 {
        stitch_corner(&mut sides, std::array::from_fn(|axis| corner >> axis & 1 == 1));
    }
    let mut map = CubicalArrangement { sides, face_count: 0, first_part: Vec::new() };
    map.find_real_border_vertices(&borders);
    map.join_faces();
    map
}

/// Chains the three vertices at a corner of the cube, clockwise seen from outside.
fn stitch_corner(sides: &mut [Side; 6], is_positive: [bool; 3]) {
    let copy = |axis: usize| {
        let side = CubeSide::new(axis, is_positive[axis]);
        let [u, v] = side.axes().map(|axis| usize::from(is_positive[axis]));
        At { side, id: sides[side.index()].corners[2 * u + v] }
    };
    let copies = [0, 1, 2].map(copy);
    // Around (1, 1, 1) the axes x, y, z are counterclockwise; each reflection turns that round.
    let is_counterclockwise = is_positive.iter().filter(|&&is| is).count() % 2 == 1;
    for i in 0..3 {
        let next = copies[if is_counterclockwise { (i + 2) % 3 } else { (i + 1) % 3 }];
        sides[copies[i].side.index()].next_copy[copies[i].id.index()] = Some(next);
    }
}

impl CubicalArrangement {
    /// Vertices within a side are real. One on an edge of the cube is if it was given on some side, or if more than two real edges meet there.
    ///
    /// # References
    /// Thesis, section 3.3.2, case 1.
    fn find_real_border_vertices(&mut self, borders: &[Borders; 6]) {
        for side in &mut self.sides {
            for v in side.arrangement.dcel().vertices() {
                if side.next_copy[v.index()].is_none() {
                    side.is_real_vertex[v.index()] = true;
                }
            }
        }
        for side in CubeSide::ALL {
            for &id in borders[side.index()].vertices.iter().flatten() {
                let v = At { side, id };
                if self.is_real_vertex(v)
                    || self.copies(v).any(|copy| self.is_real_vertex(copy))
                    || self.is_meeting(v)
                {
                    self.sides[side.index()].is_real_vertex[id.index()] = true;
                }
            }
        }
    }

    /// Tells whether more than two real edges meet at a vertex on an edge of the cube.
    fn is_meeting(&self, v: At<VertexId>) -> bool {
        // Edges along the border are on two sides.
        let halves: usize = self
            .copies(v)
            .flat_map(|copy| {
                let side = &self.sides[copy.side.index()];
                side.arrangement.dcel().around(copy.id).map(move |h| {
                    let weight = if side.across[h.edge()].is_some() { 1 } else { 2 };
                    if side.is_real_edge[h.edge()] { weight } else { 0 }
                })
            })
            .sum();
        halves > 4
    }

    /// Joins the faces of the sides across artificial edges.
    fn join_faces(&mut self) {
        let mut first = [0_u32; 7];
        for side in 0..6 {
            let faces = self.sides[side].arrangement.dcel().face_bound();
            first[side + 1] = first[side] + u32::try_from(faces).expect("fewer than 2^32 faces");
        }
        let number = |side: CubeSide, f: FaceId| first[side.index()] + f.0;
        let mut parents: Vec<u32> = (0..first[6]).collect();
        for side in CubeSide::ALL {
            let own = &self.sides[side.index()];
            for (e, across) in own.across.iter().enumerate() {
                let Some(other) = across.filter(|other| side < other.side && !own.is_real_edge[e]) else {
                    continue;
                };
                let faces = [At { side, id: EdgeId::new(e) }, other].map(|edge| {
                    let dcel = self.sides[edge.side.index()].arrangement.dcel();
                    number(edge.side, dcel.face(self.inner_halfedge(edge)))
                });
                let [a, b] = faces.map(|face| find(&mut parents, face));
                parents[a.max(b) as usize] = a.min(b);
            }
        }
        let mut faces = vec![CubicalFaceId::NONE; first[6] as usize];
        for side in CubeSide::ALL {
            let arrangement = &self.sides[side.index()].arrangement;
            for f in arrangement.dcel().faces().filter(|&f| f != arrangement.corner_face()) {
                let root = find(&mut parents, number(side, f)) as usize;
                if faces[root] == CubicalFaceId::NONE {
                    faces[root] = CubicalFaceId(self.face_count);
                    self.face_count += 1;
                    self.first_part.push(At { side, id: f });
                }
                faces[number(side, f) as usize] = faces[root];
            }
        }
        for side in CubeSide::ALL {
            let range = first[side.index()] as usize..first[side.index() + 1] as usize;
            self.sides[side.index()].faces = faces[range].to_vec();
        }
    }
}

fn find(parents: &mut [u32], mut face: u32) -> u32 {
    while parents[face as usize] != face {
        parents[face as usize] = parents[parents[face as usize] as usize];
        face = parents[face as usize];
    }
    face
}
