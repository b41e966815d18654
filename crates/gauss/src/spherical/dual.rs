//! The map of a solid, read off its mesh without a sweep.
//!
//! | mesh | cells |
//! |---|---|
//! | facet | vertex |
//! | halfedge h, with the facets L on its left and R on its right | chain of halfedges from the normal of L to that of R; the face of its target on the left |
//! | vertex | face, with one CCB: the chains of the halfedges that come to it, `prev(twin(h))` after h |
//!
//! An arc is one chain of pieces, cut at the identification and at the poles; the chain of the twin is the same in the other direction.
//!
//! 1. Arcs are cut, and all vertices are put in the order of a sweep, which the overlay likes.
//! 2. Halfedges are linked along the chains, and from chain to chain.
//! 3. A pole to which no arc comes lies in the face of the lowest or the highest vertex.

use arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::{ArrangementTraits, BasicTraits, CurveEnd, Piece};
use arrangement::{Arrangement, Parts};
use dcel::{CcbId, CcbKind, Dcel, EdgeId, FaceId, Halfedge, HalfedgeId, Mesh, RawCcb, RawDcel, VertexId};
use exact::spherical::Direction;
use exact::{Point3, Sign};
use polytope::Polytope;

/// The vertices that are the poles.
const POLES: [VertexId; 2] = [VertexId(0), VertexId(1)];

/// The arrangement of the map of a polytope of dimension 3, in which each face has the id of its vertex.
///
/// # Complexity
/// Linear, but for the order of the vertices: O(n log n).
pub(super) fn arrangement_of_solid(
    polytope: &Polytope,
    traits: GeodesicTraits,
    normals: &[Direction],
    arcs: impl Iterator<Item = Geodesic>,
) -> Arrangement<GeodesicTraits, Sphere> {
    let mesh = polytope.mesh();
    let chains = Chains::new(&traits, arcs, mesh.edge_count());
    let vertices = Vertices::new(&traits, normals, &chains.cuts);
    let mut halfedges = chains.link(mesh);
    let mut outgoing = vec![HalfedgeId::NONE; 2 + vertices.points.len()];
    for h in mesh.halfedges() {
        let chain = chains.of(h);
        let mut source = vertices.of_facet[mesh.facet(h).index()];
        for (i, halfedge) in chain.enumerate() {
            if i > 0 {
                source = vertices.of_joint(chains.joint_before(h, i));
            }
            halfedges[halfedge.index()].source = source;
            outgoing[source.index()] = halfedge;
        }
    }
    let ccb = |v: VertexId| RawCcb {
        first: chains.first(mesh.outgoing(v).twin()),
        face: FaceId(v.0),
        // A face is convex: it lies on the left of a cycle that turns left, or goes round a pole.
        kind: CcbKind::Outer,
    };
    let isolated = POLES.into_iter().filter(|pole| outgoing[pole.index()] == HalfedgeId::NONE);
    let dcel = Dcel::from_parts(RawDcel {
        ccbs: mesh.vertices().map(ccb).collect(),
        face_count: mesh.vertex_count(),
        isolated: isolated.map(|pole| (pole, FaceId(extreme(polytope.points(), pole)))).collect(),
        halfedges,
        outgoing,
    });
    let Chains { curves, .. } = chains;
    let corner_face = traits.corner_face(&dcel, |e: EdgeId| &curves[e.index()], CurveEnd::Min);
    let parts = Parts {
        dcel,
        points: [None, None].into_iter().chain(vertices.points.into_iter().map(Some)).collect(),
        is_artificial: vertices.is_artificial,
        supports: (0..curves.len() as u32).collect(),
        curves,
        corner_face,
    };
    Arrangement::from_trusted_parts(traits, Sphere, parts)
}

/// The lowest vertex for the south pole, the highest one for the north pole.
fn extreme(points: &[Point3], pole: VertexId) -> u32 {
    let height = |&a: &u32, &b: &u32| points[a as usize].compare_coordinate(&points[b as usize], 2);
    let all = 0..points.len() as u32;
    let found = if pole == POLES[0] { all.min_by(height) } else { all.max_by(height) };
    found.expect("a polytope has a vertex")
}

/// Where an arc is cut.
#[derive(Clone, Copy)]
enum Joint {
    Pole(VertexId),
    /// The number of a place on the identification.
    Cut(u32),
}

/// The arcs, cut: the pieces of an arc are edges with consecutive numbers, from its source to its target.
struct Chains {
    curves: Vec<GeodesicArc>,
    /// For each arc, its first piece; one more at the end.
    starts: Vec<u32>,
    /// For each piece, where it begins, if that is not where its arc does.
    joints: Vec<Option<Joint>>,
    cuts: Vec<Direction>,
}

impl Chains {
    fn new(traits: &GeodesicTraits, arcs: impl Iterator<Item = Geodesic>, count: usize) -> Self {
        let mut chains = Self {
            curves: Vec::with_capacity(count),
            starts: Vec::with_capacity(count + 1),
            joints: Vec::with_capacity(count),
            cuts: Vec::new(),
        };
        let mut pieces = Vec::new();
        for arc in arcs {
            chains.starts.push(chains.curves.len() as u32);
            traits.make_u_monotone(&arc, &mut pieces);
            for (i, piece) in pieces.drain(..).enumerate() {
                if let Piece::Curve { curve, .. } = piece {
                    let joint = if i == 0 { None } else { Some(chains.joint_at(curve.source())) };
                    chains.joints.push(joint);
                    chains.curves.push(curve);
                }
            }
        }
        chains.starts.push(chains.curves.len() as u32);
        chains
    }

    fn joint_at(&mut self, p: &Direction) -> Joint {
        match p.pole_sign() {
            Sign::Negative => Joint::Pole(POLES[0]),
            Sign::Positive => Joint::Pole(POLES[1]),
            Sign::Zero => {
                self.cuts.push(p.clone());
                Joint::Cut(self.cuts.len() as u32 - 1)
            }
        }
    }

    fn pieces(&self, h: HalfedgeId) -> std::ops::Range<u32> {
        self.starts[h.edge()]..self.starts[h.edge() + 1]
    }

    /// The halfedge along a piece, from the source to the target of its arc.
    fn along(&self, piece: u32) -> HalfedgeId {
        let h = EdgeId(piece).halfedge();
        if self.curves[piece as usize].is_directed_right() { h } else { h.twin() }
    }

    /// The halfedge at some place of the chain of a halfedge of the mesh.
    fn at(&self, h: HalfedgeId, place: u32) -> HalfedgeId {
        let pieces = self.pieces(h);
        if h.is_even() { self.along(pieces.start + place) } else { self.along(pieces.end - 1 - place).twin() }
    }

    /// The chain of a halfedge of the mesh.
    fn of(&self, h: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        (0..self.pieces(h).len() as u32).map(move |place| self.at(h, place))
    }

    fn first(&self, h: HalfedgeId) -> HalfedgeId {
        self.at(h, 0)
    }

    /// What is before a place of the chain of a halfedge of the mesh that is not the first one.
    fn joint_before(&self, h: HalfedgeId, place: usize) -> Joint {
        let pieces = self.pieces(h);
        let piece = if h.is_even() { pieces.start as usize + place } else { pieces.end as usize - place };
        self.joints[piece].expect("a piece that is not the first one begins at a joint")
    }

    /// The halfedges, without sources.
    fn link(&self, mesh: &Mesh) -> Vec<Halfedge> {
        let none = Halfedge {
            next: HalfedgeId::NONE,
            prev: HalfedgeId::NONE,
            source: VertexId::NONE,
            ccb: CcbId::NONE,
        };
        let mut halfedges = vec![none; 2 * self.curves.len()];
        for h in mesh.halfedges() {
            let ccb = CcbId(mesh.target(h).0);
            let mut before: Option<HalfedgeId> = None;
            for halfedge in self.of(h) {
                halfedges[halfedge.index()].ccb = ccb;
                if let Some(before) = before.replace(halfedge) {
                    halfedges[before.index()].next = halfedge;
                }
            }
            if let Some(last) = before {
                halfedges[last.index()].next = self.first(mesh.prev(h.twin()));
            }
        }
        halfedges
    }
}

/// The vertices of the map: the poles, and then all others in the order of a sweep.
struct Vertices {
    /// Without the poles.
    points: Vec<Direction>,
    of_facet: Vec<VertexId>,
    of_cut: Vec<VertexId>,
    is_artificial: Vec<bool>,
}

impl Vertices {
    fn new(traits: &GeodesicTraits, normals: &[Direction], cuts: &[Direction]) -> Self {
        let place = |i: usize| normals.get(i).unwrap_or_else(|| &cuts[i - normals.len()]);
        let mut numbers = vec![POLES[0]; normals.len() + cuts.len()];
        let mut is_artificial = vec![true; 2];
        let mut order: Vec<(u64, u32)> = Vec::with_capacity(numbers.len());
        for (i, number) in numbers.iter_mut().enumerate() {
            let p = place(i);
            let pole = match p.pole_sign() {
                Sign::Zero => {
                    order.push((traits.order_key(p), i as u32));
                    continue;
                }
                Sign::Negative => POLES[0],
                Sign::Positive => POLES[1],
            };
            *number = pole;
            is_artificial[pole.index()] = false;
        }
        // Different keys that are not zero tell the order.
        order.sort_unstable_by(|&(a, i), &(b, j)| match a != b && a != 0 && b != 0 {
            true => a.cmp(&b),
            false => traits.compare_uv(place(i as usize), place(j as usize)),
        });
        let mut points = Vec::with_capacity(order.len());
        for (_, i) in order {
            let i = i as usize;
            numbers[i] = VertexId::new(2 + points.len());
            points.push(place(i).clone());
            is_artificial.push(i >= normals.len());
        }
        let of_cut = numbers.split_off(normals.len());
        Self { points, of_facet: numbers, of_cut, is_artificial }
    }

    fn of_joint(&self, joint: Joint) -> VertexId {
        match joint {
            Joint::Pole(pole) => pole,
            Joint::Cut(cut) => self.of_cut[cut as usize],
        }
    }
}
