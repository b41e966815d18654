//! Tests of the structure made in one go.

use super::{Ccb, CcbKind, Dcel, EndFate, Face, Halfedge, Isolated, RawCcb, RawDcel, Side, VertexCell};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

fn halfedge(source: u32, next: u32, ccb: u32) -> Halfedge {
    Halfedge { next: HalfedgeId(next), prev: HalfedgeId::NONE, source: VertexId(source), ccb: CcbId(ccb) }
}

/// A triangle in the plane, with an isolated vertex inside and one outside.
fn triangle() -> Dcel {
    Dcel::from_parts(RawDcel {
        halfedges: vec![
            halfedge(0, 2, 1),
            halfedge(1, 5, 0),
            halfedge(1, 4, 1),
            halfedge(2, 1, 0),
            halfedge(2, 0, 1),
            halfedge(0, 3, 0),
        ],
        outgoing: vec![HalfedgeId(0), HalfedgeId(2), HalfedgeId(4), HalfedgeId::NONE, HalfedgeId::NONE],
        ccbs: vec![
            RawCcb { first: HalfedgeId(1), face: FaceId(0), kind: CcbKind::Inner },
            RawCcb { first: HalfedgeId(0), face: FaceId(1), kind: CcbKind::Outer },
        ],
        face_count: 2,
        isolated: vec![(VertexId(3), FaceId(1)), (VertexId(4), FaceId(0))],
    })
}

#[test]
fn nothing_is_one_face() {
    let dcel = Dcel::new();
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (0, 0, 1));
    assert_eq!(dcel.face_ccbs(FaceId(0)).count() + dcel.isolated_vertices(FaceId(0)).count(), 0);
}

#[test]
fn a_triangle_made_in_one_go_is_read_back() {
    let dcel = triangle();
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (5, 3, 2));
    assert_eq!((dcel.halfedge_count(), dcel.ccb_count(), dcel.isolated_vertex_count()), (6, 2, 2));
    for h in dcel.halfedges() {
        assert_eq!(dcel.prev(dcel.next(h)), h);
        assert_eq!(dcel.target(h), dcel.source(dcel.next(h)));
        assert_eq!(dcel.face(h), FaceId(u32::from(h.is_even())));
    }
    assert_eq!(dcel.outer_ccbs(FaceId(1)).collect::<Vec<_>>(), [CcbId(1)]);
    assert_eq!(dcel.inner_ccbs(FaceId(0)).collect::<Vec<_>>(), [CcbId(0)]);
    assert_eq!(dcel.isolated_vertices(FaceId(1)).collect::<Vec<_>>(), [VertexId(3)]);
    assert_eq!(dcel.isolated_face(VertexId(4)), Some(FaceId(0)));
    assert_eq!(dcel.isolated_face(VertexId(0)), None);
    assert_eq!(dcel.around(VertexId(1)).collect::<Vec<_>>(), [HalfedgeId(2), HalfedgeId(1)]);
    assert_eq!((dcel.degree(VertexId(1)), dcel.degree(VertexId(3))), (2, 0));
    assert_eq!(dcel.ccb_cycle(CcbId(0)).collect::<Vec<_>>(), [1, 5, 3].map(HalfedgeId));
    assert_eq!(dcel.ends(EdgeId(2)), [VertexId(2), VertexId(0)]);
}

#[test]
fn what_a_face_has_moves() {
    let mut dcel = triangle();
    let v = dcel.add_isolated_vertex(FaceId(1));
    assert_eq!(dcel.isolated_vertices(FaceId(1)).collect::<Vec<_>>(), [VertexId(3), v]);
    dcel.move_isolated_vertex(VertexId(3), FaceId(0));
    assert_eq!(dcel.isolated_vertices(FaceId(0)).collect::<Vec<_>>(), [VertexId(4), VertexId(3)]);
    dcel.remove_isolated_vertex(v);
    assert_eq!(dcel.isolated_vertices(FaceId(1)).count(), 0);
    dcel.set_ccb_kind(CcbId(1), CcbKind::Inner);
    dcel.merge_faces(FaceId(1), FaceId(0));
    assert_eq!(dcel.inner_ccbs(FaceId(1)).collect::<Vec<_>>(), [CcbId(1), CcbId(0)]);
    assert_eq!(dcel.isolated_vertices(FaceId(1)).collect::<Vec<_>>(), [VertexId(4), VertexId(3)]);
    assert_eq!(dcel.split_face(CcbId(0)), FaceId(0));
    assert_eq!(dcel.inner_ccbs(FaceId(0)).collect::<Vec<_>>(), [CcbId(0)]);
    assert_eq!(dcel.add_vertex(), v);
}

#[test]
fn ccbs_are_walked_one_by_one() {
    let walk = |dcel: &Dcel, f| {
        std::iter::successors(dcel.first_ccb(f), |&ccb| dcel.next_ccb(ccb)).collect::<Vec<_>>()
    };
    let mut dcel = triangle();
    assert_eq!(Dcel::new().first_ccb(FaceId(0)), None);
    assert_eq!((walk(&dcel, FaceId(0)), walk(&dcel, FaceId(1))), (vec![CcbId(0)], vec![CcbId(1)]));
    // Three edges in the triangle, of which two are outer CCBs, as on a surface with handles they may be.
    let kinds = [CcbKind::Inner, CcbKind::Outer, CcbKind::Inner];
    for kind in kinds {
        let [v, w] = [(); 2].map(|()| dcel.add_vertex());
        dcel.insert_edge_in_face(v, w, FaceId(1), kind);
    }
    assert_eq!(walk(&dcel, FaceId(1)), [1, 3, 2, 4].map(CcbId));
    assert!(dcel.face_ccbs(FaceId(1)).eq(walk(&dcel, FaceId(1))));
    // Only inner ones; only outer ones.
    for kind in [CcbKind::Inner, CcbKind::Outer] {
        (1..5).for_each(|ccb| dcel.set_ccb_kind(CcbId(ccb), kind));
        assert_eq!(walk(&dcel, FaceId(1)).len(), 4);
        assert!(dcel.face_ccbs(FaceId(1)).eq(walk(&dcel, FaceId(1))));
    }
    dcel.merge_faces(FaceId(0), FaceId(1));
    assert!(walk(&dcel, FaceId(1)).is_empty(), "the face is gone");
    assert!(walk(&dcel, FaceId(0)).len() == 5 && dcel.face_ccbs(FaceId(0)).eq(walk(&dcel, FaceId(0))));
}

#[test]
fn a_mirror_image_has_left_and_right_exchanged() {
    let mut dcel = triangle();
    // An edge in the triangle, one out of a corner of it, and something free.
    let [v, w, x, y] = [(); 4].map(|()| dcel.add_vertex());
    dcel.insert_edge_in_face(v, w, FaceId(1), CcbKind::Inner);
    let pendant = dcel.insert_edge_from(HalfedgeId(5), x);
    dcel.insert_edge_from(HalfedgeId(4), y);
    dcel.remove_edge(pendant, [EndFate::Remove; 2], Side::Even);
    assert_eq!(dcel.check_euler(0), []);
    let mirrored = dcel.mirrored();
    assert_eq!(mirrored.check_euler(0), []);
    for h in dcel.halfedges() {
        assert_eq!(mirrored.source(h), dcel.source(h));
        assert_eq!(mirrored.face(h), dcel.face(h.twin()));
        assert_eq!(mirrored.ccb(h), dcel.ccb(h.twin()));
        assert_eq!(mirrored.next(h), dcel.prev(h.twin()).twin());
    }
    for v in dcel.vertices() {
        let mut around: Vec<_> = mirrored.around(v).collect();
        around.get_mut(1..).into_iter().for_each(<[_]>::reverse);
        assert_eq!(around, dcel.around(v).collect::<Vec<_>>());
        assert_eq!(mirrored.isolated_face(v), dcel.isolated_face(v));
    }
    let again = mirrored.mirrored();
    assert_eq!(again.halfedges, dcel.halfedges);
    assert_eq!(again.ccbs, dcel.ccbs);
}

#[test]
fn vertices_exchange_their_ids() {
    let dcel = triangle();
    let all = [0, 1, 2, 3, 4].map(VertexId);
    for (v, w) in all.into_iter().flat_map(|v| all.map(|w| (v, w))) {
        let mut exchanged = dcel.clone();
        exchanged.exchange_vertices(v, w);
        assert_eq!(exchanged.check_euler(0), []);
        let name = |u| {
            if u == v {
                w
            } else if u == w {
                v
            } else {
                u
            }
        };
        assert!(dcel.halfedges().all(|h| exchanged.source(h) == name(dcel.source(h))));
        assert!(all.iter().all(|&u| exchanged.isolated_face(name(u)) == dcel.isolated_face(u)));
    }
}

#[test]
fn records_are_as_small_as_promised() {
    assert_eq!(size_of::<Halfedge>(), 16);
    assert_eq!(size_of::<Ccb>(), 16);
    assert_eq!(size_of::<Face>(), 12);
    assert_eq!((size_of::<VertexCell>(), size_of::<Isolated>()), (4, 16));
}

#[test]
fn what_is_handed_over_stays_where_it_is() {
    let raw = RawDcel {
        halfedges: vec![halfedge(0, 1, 0), halfedge(1, 0, 0)],
        outgoing: vec![HalfedgeId(0), HalfedgeId(1)],
        ccbs: vec![RawCcb { first: HalfedgeId(0), face: FaceId(0), kind: CcbKind::Inner }],
        face_count: 1,
        isolated: Vec::new(),
    };
    let places = (raw.halfedges.as_ptr().addr(), raw.outgoing.as_ptr().addr());
    let dcel = Dcel::from_parts(raw);
    assert_eq!((dcel.halfedges.as_ptr().addr(), dcel.vertices.as_ptr().addr()), places);
    assert_eq!(dcel.check_euler(0), []);
}
