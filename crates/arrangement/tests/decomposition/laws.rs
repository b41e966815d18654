//! What is true of the complex of every decomposition. Unit tests use it too.

use super::{
    Arrangement, DecompositionComplex, EdgeOrigin, Topology, UMonotoneTraits, VertexOrigin,
    VerticalDecomposition,
};
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use std::collections::BTreeMap;

pub(crate) fn check<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, context: &str) {
    let made = VerticalDecomposition::new(arrangement);
    let complex = made.complex(arrangement).expect("the arrangement was not changed");
    let dcel = complex.dcel();
    let genus = arrangement.topology().genus();
    assert_eq!(dcel.check_euler(genus as usize), [], "{context}");
    let [v, e, f] = [dcel.vertex_count(), dcel.edge_count(), dcel.face_count()].map(|n| n as i64);
    assert_eq!(v - e + f, 2 - 2 * i64::from(genus), "{context}: {v} vertices, {e} edges, {f} faces");
    assert_eq!(dcel.component_count(), 1, "{context}");
    let trapezoids: Vec<_> = made.trapezoids().filter(|&t| !made.is_degenerate(t)).collect();
    let of_faces: Vec<_> = dcel.faces().map(|f| complex.trapezoid(f)).collect();
    assert_eq!(of_faces, trapezoids, "{context}");
    for f in dcel.faces() {
        let t = complex.trapezoid(f);
        assert_eq!(complex.face_of(t), Some(f), "{context}");
        assert_eq!(made.face_of(arrangement, t), Ok(complex.arrangement_face(f)), "{context}");
        // Each face is a disc: it has one boundary, or is all but a point.
        let boundaries = dcel.face_ccbs(f).count() + dcel.isolated_vertices(f).count();
        assert_eq!(boundaries, 1, "{context}: {f:?}");
        if let Some(below) = made.trapezoid(t).below {
            let is_below =
                |h: HalfedgeId| h.is_even() && complex.edge_origin(h.edge_id()) == EdgeOrigin::Edge(below);
            assert!(dcel.face_ccbs(f).any(|ccb| dcel.ccb_cycle(ccb).any(is_below)), "{context}: {t:?}");
        }
    }
    check_edges(arrangement, &complex, context);
    check_vertices(arrangement, &complex, context);
    check_faces(arrangement, &complex, context);
}

/// The pieces of an edge are a path from its min to its max vertex, between its faces; a wall is in one face.
fn check_edges<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    complex: &DecompositionComplex,
    context: &str,
) {
    let dcel = complex.dcel();
    let mut pieces: BTreeMap<EdgeId, Vec<EdgeId>> = BTreeMap::new();
    for piece in dcel.edges() {
        let sides =
            [piece.halfedge(), piece.halfedge().twin()].map(|h| complex.arrangement_face(dcel.face(h)));
        match complex.edge_origin(piece) {
            EdgeOrigin::Edge(e) => {
                let expected = [e.halfedge(), e.halfedge().twin()].map(|h| arrangement.dcel().face(h));
                assert_eq!(sides, expected, "{context}: piece {piece:?} of {e:?}");
                pieces.entry(e).or_default().push(piece);
            }
            EdgeOrigin::Wall { below, above } => {
                assert_eq!(sides[0], sides[1], "{context}: wall {below:?} {above:?}");
                assert!(below.is_some() || above.is_some(), "{context}: a wall is of a vertex");
            }
            EdgeOrigin::Identification => assert_eq!(sides[0], sides[1], "{context}: {piece:?}"),
        }
    }
    let edges: Vec<EdgeId> = arrangement.dcel().edges().collect();
    assert_eq!(pieces.keys().copied().collect::<Vec<_>>(), edges, "{context}");
    for (e, pieces) in pieces {
        let [min, max] = arrangement.dcel().ends(e).map(VertexOrigin::Vertex);
        let mut at = min;
        for (i, &piece) in pieces.iter().enumerate() {
            let [from, to] = dcel.ends(piece).map(|v| complex.vertex_origin(v));
            assert_eq!(from, at, "{context}: piece {i} of {e:?}");
            at = to;
            let is_last = i + 1 == pieces.len();
            let is_foot = matches!(to, VertexOrigin::Foot { edge, .. } if edge == Some(e));
            assert!(is_last || is_foot, "{context}: piece {i} of {e:?} ends in {to:?}");
        }
        assert_eq!(at, max, "{context}: {e:?}");
    }
}

/// All vertices are there, and around each the edges come in the same order.
fn check_vertices<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    complex: &DecompositionComplex,
    context: &str,
) {
    let dcel = complex.dcel();
    let mut of_vertex: BTreeMap<VertexId, VertexId> = BTreeMap::new();
    for v in dcel.vertices() {
        let walls = |is_up: bool| {
            let is_wall =
                |h: &HalfedgeId| matches!(complex.edge_origin(h.edge_id()), EdgeOrigin::Wall { .. });
            dcel.around(v).filter(|h| is_wall(h) && h.is_even() == is_up).count()
        };
        match complex.vertex_origin(v) {
            VertexOrigin::Vertex(old) => assert_eq!(of_vertex.insert(old, v), None, "{context}: {old:?}"),
            VertexOrigin::Foot { below, above, edge } => {
                let expected = [usize::from(above.is_some()), usize::from(below.is_some())];
                assert_eq!([walls(true), walls(false)], expected, "{context}: {v:?}");
                assert_eq!(
                    dcel.degree(v),
                    2 + expected[0] + expected[1],
                    "{context}: foot {v:?} on {edge:?}"
                );
            }
            VertexOrigin::Corner | VertexOrigin::Infinity => {}
        }
    }
    let vertices: Vec<VertexId> = arrangement.dcel().vertices().collect();
    assert_eq!(of_vertex.keys().copied().collect::<Vec<_>>(), vertices, "{context}");
    for (old, v) in of_vertex {
        let edges = dcel.around(v).filter_map(|h| match complex.edge_origin(h.edge_id()) {
            EdgeOrigin::Edge(e) if h.is_even() => Some(e.halfedge()),
            EdgeOrigin::Edge(e) => Some(e.halfedge().twin()),
            _ => None,
        });
        let edges: Vec<HalfedgeId> = edges.collect();
        let mut expected: Vec<HalfedgeId> = arrangement.dcel().around(old).collect();
        if let Some(place) = edges.first().and_then(|first| expected.iter().position(|h| h == first)) {
            expected.rotate_left(place);
        }
        assert_eq!(edges, expected, "{context}: around {old:?}");
    }
}

/// Past walls and identified sides, a face of the arrangement is connected.
fn check_faces<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    complex: &DecompositionComplex,
    context: &str,
) {
    let dcel = complex.dcel();
    let mut is_seen = vec![false; dcel.face_bound()];
    let mut parts = Vec::new();
    for f in dcel.faces() {
        if std::mem::replace(&mut is_seen[f.index()], true) {
            continue;
        }
        parts.push(complex.arrangement_face(f));
        let mut stack = vec![f];
        while let Some(f) = stack.pop() {
            for h in dcel.face_ccbs(f).flat_map(|ccb| dcel.ccb_cycle(ccb)) {
                let next = dcel.face(h.twin());
                let is_open = !matches!(complex.edge_origin(h.edge_id()), EdgeOrigin::Edge(_));
                if is_open && !std::mem::replace(&mut is_seen[next.index()], true) {
                    stack.push(next);
                }
            }
        }
    }
    parts.sort_unstable();
    let faces: Vec<FaceId> = arrangement.dcel().faces().collect();
    assert_eq!(parts, faces, "{context}");
}
