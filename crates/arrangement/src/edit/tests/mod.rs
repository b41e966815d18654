//! Primitive changes: on swept arrangements of all surfaces, and at random on cells that mean nothing.

mod observers;
mod primitives;
mod scenes;
mod script;
mod turns;

use super::{MirrorDifference, mirror::difference_of_cells};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{CcbKind, EdgeId, FaceId, HalfedgeId, VertexId};
use exact::planar::Point2;

/// splitmix64, as in the crate for tests.
struct Rng(u64);

impl Rng {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound.max(1) as u64) as usize
    }

    fn within(&mut self, range: i64) -> i64 {
        self.below(2 * range as usize + 1) as i64 - range
    }

    fn choose<X: Copy>(&mut self, of: &[X]) -> Option<X> {
        (!of.is_empty()).then(|| of[self.below(of.len())])
    }
}

/// All of an arrangement but the ids of CCBs, their first halfedges and the order of lists.
#[derive(PartialEq, Eq, Debug)]
struct Snapshot {
    halfedges: Vec<(HalfedgeId, HalfedgeId, VertexId, CcbKind, FaceId)>,
    vertices: Vec<(VertexId, Option<Point2>, bool, Option<FaceId>)>,
    faces: Vec<FaceId>,
    supports: Vec<(EdgeId, u32)>,
    corner_face: FaceId,
    ccb_count: usize,
}

impl Snapshot {
    fn of<G: BasicTraits<Point = Point2>, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        let dcel = arrangement.dcel();
        let vertex = |v: VertexId| {
            (v, arrangement.point(v).cloned(), arrangement.is_artificial[v.index()], dcel.isolated_face(v))
        };
        let halfedge = |h| (h, dcel.next(h), dcel.source(h), dcel.ccb_kind(dcel.ccb(h)), dcel.face(h));
        Self {
            halfedges: dcel.halfedges().map(halfedge).collect(),
            vertices: dcel.vertices().map(vertex).collect(),
            faces: dcel.faces().collect(),
            supports: dcel.edges().map(|e| (e, arrangement.supports[e.index()])).collect(),
            corner_face: arrangement.corner_face(),
            ccb_count: dcel.ccb_count(),
        }
    }
}

/// Curves of one model are the same if they are shown alike.
fn is_shown_alike<C: std::fmt::Debug>(a: &C, b: &C) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

#[test]
fn differences_of_cells_are_found() {
    let a = scenes::plane(&[[0, 0, 4, 0], [0, 0, 0, 4]], &[[1, 1]]);
    let mut b = a.dcel().clone();
    assert_eq!(difference_of_cells(a.dcel(), &b), None);
    b.add_vertex();
    let Some(MirrorDifference::Vertex(_)) = difference_of_cells(a.dcel(), &b) else { panic!("one more") };
    let mut b = a.dcel().clone();
    b.reverse_edge(EdgeId(1));
    assert!(difference_of_cells(a.dcel(), &b).is_some());
    let mut b = a.dcel().clone();
    b.set_ccb_kind(b.ccb(HalfedgeId(0)), CcbKind::Outer);
    let Some(MirrorDifference::Ccb(_)) = difference_of_cells(a.dcel(), &b) else { panic!("another kind") };
}
