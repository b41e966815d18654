//! Every violation provoked: a valid structure, broken at one place, and all that must be found then.

use super::lists::{Links, NONE};
use super::{
    Ccb, CcbKind::Inner, CcbKind::Outer, CcbSplit, Dcel, DcelViolation as D, EndFate, Face, FaceList,
    Halfedge, Isolated, Side, VertexCell,
};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

/// A path of edges 0 and 1, edge 2 closing it to a triangle with face 1 inside, an isolated vertex 3 in
/// face 1 and 4 and 5 in face 0, and one free cell of each kind: edge 3, vertices 6 and 7, CCB 2, face 2 and
/// record 3.
fn sample() -> Dcel {
    let mut dcel = Dcel::new();
    let [a, b, c] = [dcel.add_vertex(), dcel.add_vertex(), dcel.add_vertex()];
    let ab = dcel.insert_edge_in_face(a, b, FaceId(0), Inner).halfedge();
    let bc = dcel.insert_edge_from(ab, c).halfedge();
    let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
    let ca = dcel.insert_edge_between(bc, ab.twin(), split);
    assert_eq!(dcel.ccb(ca.halfedge()), dcel.ccb(ab));
    dcel.add_isolated_vertex(FaceId(1));
    dcel.add_isolated_vertex(FaceId(0));
    dcel.add_isolated_vertex(FaceId(0));
    let [v, w] = [dcel.add_isolated_vertex(FaceId(0)), dcel.add_isolated_vertex(FaceId(0))];
    dcel.remove_isolated_vertex(w);
    let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
    dcel.insert_loop(v, FaceId(0), split);
    dcel.remove_edge(EdgeId(3), [EndFate::Isolate; 2], Side::Odd);
    dcel.remove_isolated_vertex(v);
    assert_eq!(dcel.check_euler(0), []);
    dcel
}

fn broken(damage: impl FnOnce(&mut Dcel)) -> Vec<D> {
    let mut dcel = sample();
    damage(&mut dcel);
    let found = dcel.check_valid();
    assert_eq!(dcel.check_euler(0), found);
    assert!(found.iter().all(|violation| !violation.to_string().is_empty()));
    found
}

const H: fn(u32) -> HalfedgeId = HalfedgeId;
const V: fn(u32) -> VertexId = VertexId;
const C: fn(u32) -> CcbId = CcbId;
const F: fn(u32) -> FaceId = FaceId;

#[test]
fn violations_of_halfedges() {
    // The triangle: 0 -> 2 -> 4 inside, 1 -> 5 -> 3 outside.
    let found = broken(|d| d.halfedges[0].prev = H(2));
    assert_eq!(found, [D::NextPrev(H(0)), D::NextPrev(H(4)), D::VertexCycle(V(0))]);
    let found = broken(|d| d.halfedges[0].next = H(99));
    assert_eq!(found, [D::NextPrev(H(0)), D::NextPrev(H(2)), D::CcbCycle(crate::CcbId(inside()))]);
    let found = broken(|d| d.halfedges[0].next = H(0));
    assert_eq!(found, [D::NextPrev(H(0)), D::NextPrev(H(2)), D::Chain(H(0)), D::CcbCycle(C(inside()))]);
    // Two cycles made one, and one made two.
    let found = broken(|d| {
        d.link(H(0), H(5));
        d.link(H(1), H(2));
    });
    assert_eq!(
        found,
        [
            D::Chain(H(0)),
            D::Chain(H(1)),
            D::CcbOfNext(H(0)),
            D::CcbOfNext(H(1)),
            D::CcbCycle(C(0)),
            D::CcbCycle(C(1)),
            D::VertexCycle(V(0)),
            D::VertexCycle(V(1)),
        ]
    );
    let found = broken(|d| d.halfedges[2].source = V(0));
    assert_eq!(found, [D::Chain(H(0)), D::Chain(H(3)), D::VertexCycle(V(0)), D::VertexCycle(V(1))]);
    for nobody in [3, 6, 99] {
        let found = broken(|d| d.halfedges[1].source = V(nobody));
        assert!(found.contains(&D::Source(H(1))), "{found:?}");
    }
    let found = broken(|d| d.halfedges[1] = Halfedge::FREE);
    assert!(found.contains(&D::Twin(EdgeId(0))) && found.contains(&D::NextPrev(H(5))), "{found:?}");
    let found = broken(|d| d.halfedges[0] = Halfedge::FREE);
    assert!(found.contains(&D::Twin(EdgeId(0))) && found.contains(&D::FreeEdge(EdgeId(0))), "{found:?}");
}

/// The CCB inside the triangle.
fn inside() -> u32 {
    sample().ccb(H(0)).0
}

#[test]
fn violations_of_ccbs() {
    let [inside, outside] = [C(inside()), C(1 - inside())];
    for nobody in [2, 99] {
        let found = broken(|d| d.halfedges[0].ccb = C(nobody));
        let mut expected = vec![D::Ccb(H(0)), D::CcbOfNext(H(0)), D::CcbOfNext(H(4)), D::CcbCycle(inside)];
        if sample().ccb_halfedge(inside) == H(0) {
            expected[3] = D::CcbHalfedge(inside);
        }
        assert_eq!(found, expected);
    }
    let found = broken(|d| d.ccbs[inside.index()].first = H(1));
    assert_eq!(found, [D::CcbHalfedge(inside)]);
    let found = broken(|d| d.ccbs[inside.index()].first = H(6));
    assert_eq!(found, [D::CcbHalfedge(inside)]);
    for nobody in [2, 99] {
        let found = broken(|d| d.ccbs[inside.index()].face_and_kind = nobody);
        assert_eq!(found, [D::CcbFace(inside), D::CcbUnlisted(inside), D::List(F(1), FaceList::Outer)]);
    }
    // The other kind, and the lists not told.
    let found = broken(|d| d.ccbs[outside.index()].face_and_kind = 0);
    assert_eq!(found, [D::CcbUnlisted(outside), D::List(F(0), FaceList::Inner)]);
    let found = broken(|d| d.faces[0].inner = NONE);
    assert_eq!(found, [D::CcbUnlisted(outside)]);
    let found = broken(|d| d.faces[1].outer = 99);
    assert_eq!(found, [D::CcbUnlisted(inside), D::List(F(1), FaceList::Outer)]);
    let found = broken(|d| d.faces[1].inner = outside.0);
    assert_eq!(found, [D::List(F(1), FaceList::Inner)]);
    for links in [Links::NONE, Links { prev: inside.0, next: outside.0 }] {
        let found = broken(|d| d.ccbs[inside.index()].links = links);
        assert_eq!(found, [D::List(F(1), FaceList::Outer)]);
    }
    // Two cycles in one CCB: the one that its halfedge does not reach.
    let found = broken(|d| {
        for h in [1, 3, 5] {
            d.halfedges[h].ccb = inside;
        }
        d.remove_ccb(outside);
    });
    assert_eq!(found, [D::CcbCycle(inside)]);
}

#[test]
fn violations_of_vertices() {
    let found = broken(|d| d.vertices[0] = VertexCell(2));
    assert_eq!(found, [D::Outgoing(V(0))]);
    let found = broken(|d| d.vertices[0] = VertexCell(6));
    assert_eq!(found, [D::Outgoing(V(0))]);
    let found = broken(|d| d.vertices[0] = VertexCell::BARE);
    assert_eq!(found, [D::Source(H(0)), D::Source(H(5)), D::Bare(V(0))]);
    // Isolated and attached.
    let found = broken(|d| {
        d.vertices[0] = VertexCell::BARE;
        d.isolate(V(0), F(0));
    });
    assert_eq!(found, [D::Source(H(0)), D::Source(H(5))]);
    let found = broken(|d| d.vertices[0] = VertexCell::FREE);
    assert_eq!(found, [D::Source(H(0)), D::Source(H(5)), D::FreeVertex(V(0))]);
    for nobody in [0, 99] {
        let found = broken(|d| d.vertices[4] = VertexCell::isolated(nobody));
        assert_eq!(found, [D::Place(V(4)), D::PlaceUnused(1)]);
    }
    let found = broken(|d| d.isolated[1].vertex = V(99));
    assert_eq!(found, [D::Place(V(4)), D::PlaceUnused(1)]);
    for nobody in [2, 99] {
        let found = broken(|d| d.isolated[1].face = F(nobody));
        let unlisted = [D::IsolatedUnlisted(V(4)), D::IsolatedUnlisted(V(5))];
        let [first, second] = unlisted;
        let list = D::List(F(0), FaceList::Isolated);
        assert_eq!(found, [list, D::IsolatedFace(V(4)), first, second]);
    }
    let found = broken(|d| d.isolated[2].links.prev = 2);
    assert_eq!(found, [D::List(F(0), FaceList::Isolated), D::IsolatedUnlisted(V(5))]);
    let found = broken(|d| d.faces[1].isolated = NONE);
    assert_eq!(found, [D::IsolatedUnlisted(V(3))]);
    // A loop and another one at one vertex that do not know each other.
    let found = broken(|d| {
        let v = d.add_vertex();
        let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
        d.insert_loop(v, F(0), split);
        d.vertices[v.index()] = VertexCell::BARE;
        d.insert_loop(v, F(0), split);
    });
    assert_eq!(found.len(), 1);
    assert!(matches!(found[0], D::VertexCycle(_)), "{found:?}");
}

#[test]
fn violations_of_free_cells() {
    let dcel = sample();
    let [edge, ccb, face] = [dcel.free_edges[0], dcel.free_ccbs[0], dcel.free_faces[0]];
    let [vertex, place] = [dcel.free_vertices[0], dcel.free_isolated[0]];
    assert_eq!(broken(|d| d.free_edges.clear()), [D::FreeEdge(EdgeId(edge))]);
    assert_eq!(broken(|d| d.free_edges.push(0)), [D::FreeEdge(EdgeId(0))]);
    assert_eq!(broken(|d| d.free_edges.push(99)), [D::FreeEdge(EdgeId(99))]);
    assert_eq!(broken(|d| d.free_edges.push(edge)), [D::FreeEdge(EdgeId(edge))]);
    assert_eq!(broken(|d| d.free_vertices.push(vertex)), [D::FreeVertex(V(vertex))]);
    assert_eq!(broken(|d| d.free_ccbs.push(ccb)), [D::FreeCcb(C(ccb))]);
    assert_eq!(broken(|d| d.free_faces.push(face)), [D::FreeFace(F(face))]);
    assert_eq!(broken(|d| d.free_isolated.push(place)), [D::FreePlace(place)]);
    let found = broken(|d| d.ccbs[0] = Ccb::FREE);
    assert!(found.contains(&D::FreeCcb(C(0))) && found.contains(&D::Ccb(sample().ccb_halfedge(C(0)))));
    let found = broken(|d| d.faces[1] = Face::FREE);
    let inside = C(inside());
    let expected = [
        D::CcbFace(inside),
        D::CcbUnlisted(inside),
        D::IsolatedFace(V(3)),
        D::IsolatedUnlisted(V(3)),
        D::FreeFace(F(1)),
    ];
    assert_eq!(found, expected);
    let found = broken(|d| d.isolated[0] = Isolated::FREE);
    assert_eq!(found, [D::List(F(1), FaceList::Isolated), D::Place(V(3)), D::FreePlace(0)]);
}

#[test]
fn several_violations_are_found_at_once() {
    let found = broken(|d| {
        d.halfedges[2].source = V(0);
        d.ccbs[1].first = H(99);
        d.faces[0].isolated = NONE;
        d.free_vertices.push(0);
    });
    let expected = [
        D::Chain(H(0)),
        D::Chain(H(3)),
        D::CcbHalfedge(C(1)),
        D::VertexCycle(V(0)),
        D::VertexCycle(V(1)),
        D::IsolatedUnlisted(V(4)),
        D::IsolatedUnlisted(V(5)),
        D::FreeVertex(V(0)),
    ];
    assert_eq!(found, expected);
}

#[test]
fn violations_of_eulers_relation() {
    // A hole of face 0 moved to a face of its own: nothing leads there.
    let mut dcel = sample();
    let v = dcel.add_vertex();
    let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
    let e = dcel.insert_loop(v, FaceId(0), split);
    dcel.split_face(dcel.ccb(e.half(Side::Odd)));
    let euler = D::Euler { characteristic: 7 - 4 + 4, components: 5 };
    assert_eq!(dcel.check_euler(0), [D::Pieces(2), euler]);
    assert_eq!(dcel.check_euler(1), [D::Pieces(2)]);
    assert_eq!(euler.to_string(), "V - E + F is 7, with 5 components");

    let mut dcel = Dcel::new();
    let v = dcel.add_vertex();
    dcel.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Outer], new_face: None });
    let euler = D::Euler { characteristic: 1, components: 1 };
    assert_eq!(dcel.check_euler(0), [D::Genus { least: 1, given: 0 }, euler]);
}
