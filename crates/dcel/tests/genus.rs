//! Arrangements on surfaces of genus 0, 1 and 2, by polygons whose sides are glued in pairs.

use splitstar_dcel::CcbKind::{Inner, Outer};
use splitstar_dcel::{
    CcbId, CcbSplit, Dcel, EdgeId, EndFate, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, Side, VertexId,
};

/// A polygon: its sides in order, a capital for a side that is glued to the other one of its letter the
/// other way round.
struct Scheme {
    word: &'static str,
    vertices: usize,
    genus: usize,
}

const SCHEMES: &[Scheme] = &[
    Scheme { word: "aA", vertices: 2, genus: 0 },
    Scheme { word: "abBA", vertices: 3, genus: 0 },
    Scheme { word: "aAbBcC", vertices: 4, genus: 0 },
    Scheme { word: "abAB", vertices: 1, genus: 1 },
    Scheme { word: "abcABC", vertices: 2, genus: 1 },
    Scheme { word: "abABcC", vertices: 2, genus: 1 },
    Scheme { word: "abABcdCD", vertices: 1, genus: 2 },
    Scheme { word: "abcdABCD", vertices: 1, genus: 2 },
    Scheme { word: "abcdeABCDE", vertices: 2, genus: 2 },
];

impl Scheme {
    fn sides(&self) -> Vec<HalfedgeId> {
        let side = |c: u8| HalfedgeId(2 * u32::from(c.to_ascii_lowercase() - b'a') + u32::from(c < b'a'));
        self.word.bytes().map(side).collect()
    }

    /// One face, whose boundary is the word.
    fn glue(&self) -> Dcel {
        let sides = self.sides();
        let n = sides.len();
        let none = Halfedge {
            next: HalfedgeId::NONE,
            prev: HalfedgeId::NONE,
            source: VertexId::NONE,
            ccb: CcbId(0),
        };
        let mut halfedges = vec![none; n];
        for i in 0..n {
            halfedges[sides[i].index()].next = sides[(i + 1) % n];
        }
        // Around a vertex clockwise: the twin, and the next of it.
        let mut outgoing = Vec::new();
        for &first in &sides {
            let mut h = first;
            while halfedges[h.index()].source == VertexId::NONE {
                halfedges[h.index()].source = VertexId(outgoing.len() as u32);
                h = halfedges[h.twin().index()].next;
            }
            outgoing.push(first);
            let is_new = halfedges[first.index()].source.index() == outgoing.len() - 1;
            outgoing.truncate(outgoing.len() - usize::from(!is_new));
        }
        let ccbs = vec![RawCcb { first: sides[0], face: FaceId(0), kind: Outer }];
        Dcel::from_parts(RawDcel { halfedges, outgoing, ccbs, face_count: 1, isolated: Vec::new() })
    }
}

#[test]
fn glued_polygons_have_their_genus() {
    for scheme in SCHEMES {
        let dcel = scheme.glue();
        assert_eq!(dcel.check_valid(), [], "{}", scheme.word);
        assert_eq!(dcel.vertex_count(), scheme.vertices, "{}", scheme.word);
        assert_eq!(dcel.genus_of_components(), [scheme.genus], "{}", scheme.word);
        assert_eq!(dcel.least_genus(), scheme.genus, "{}", scheme.word);
        assert_eq!(dcel.check_euler(scheme.genus), [], "{}", scheme.word);
        assert_eq!(dcel.check_euler(0).is_empty(), scheme.genus == 0, "{}", scheme.word);
    }
}

/// Opening a polygon side by side ends with nothing, and never needs a higher genus.
#[test]
fn glued_polygons_come_apart() {
    for scheme in SCHEMES {
        let mut dcel = scheme.glue();
        for e in dcel.edges().collect::<Vec<_>>() {
            dcel.remove_edge(e, [EndFate::Remove; 2], Side::Even);
            assert_eq!(dcel.check_euler(scheme.genus), [], "{}", scheme.word);
        }
        assert_eq!((dcel.vertex_count(), dcel.face_count(), dcel.ccb_count()), (0, 1, 0), "{}", scheme.word);
    }
}

/// Adds a handle at the vertex of `corner`: two loops that cross there.
fn add_handle(dcel: &mut Dcel, corner: HalfedgeId) -> [EdgeId; 2] {
    let a = dcel.insert_edge_between(corner, corner, CcbSplit { kinds: [Outer, Outer], new_face: None });
    // From the side where the loop is alone to its other side.
    let b = dcel.insert_edge_joining(a.half(Side::Even), a.half(Side::Odd), Outer);
    [a, b]
}

#[test]
fn handles_are_inserted_edge_by_edge() {
    // The torus: a first closed curve leaves the face in one piece, a second one joins its two sides.
    let mut dcel = Dcel::new();
    let v = dcel.add_isolated_vertex(FaceId(0));
    let a = dcel.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Outer], new_face: None });
    assert_eq!((dcel.outer_ccbs(FaceId(0)).count(), dcel.least_genus()), (2, 1));
    assert_eq!(dcel.genus_of_components(), [0]);
    let b = dcel.insert_edge_joining(a.half(Side::Even), a.half(Side::Odd), Outer);
    assert_eq!((dcel.outer_ccbs(FaceId(0)).count(), dcel.least_genus()), (1, 1));
    assert_eq!(dcel.genus_of_components(), [1]);
    let word = [a.half(Side::Even), b.half(Side::Even), a.half(Side::Odd), b.half(Side::Odd)];
    assert_eq!(dcel.cycle(word[0]).collect::<Vec<_>>(), word, "the square a b A B");
    // A diagonal: two triangles.
    let split = CcbSplit { kinds: [Outer, Outer], new_face: Some(Side::Odd) };
    let c = dcel.insert_edge_between(word[1], word[3], split);
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (1, 3, 2));
    assert_eq!(dcel.ccb_cycle(dcel.ccb(c.halfedge())).count(), 3);
    assert_eq!(dcel.check_euler(1), []);
    assert_eq!(dcel.degree(v), 6);

    // Two handles, in the plane of a circle.
    let mut dcel = Dcel::new();
    let v = dcel.add_vertex();
    let circle =
        dcel.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) });
    let [_, b] = add_handle(&mut dcel, circle.half(Side::Odd));
    assert_eq!((dcel.check_euler(1), dcel.least_genus()), (vec![], 1));
    add_handle(&mut dcel, b.half(Side::Odd));
    assert_eq!((dcel.check_euler(2), dcel.least_genus()), (vec![], 2));
    assert_eq!(dcel.genus_of_components(), [2]);
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (1, 5, 2));
}

/// Two parallel closed curves around a handle cut a torus into two annuli: two components that bound the
/// same two faces.
#[test]
fn parallel_curves_on_the_torus() {
    let mut dcel = Dcel::new();
    let v = dcel.add_vertex();
    let a = dcel.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Outer], new_face: None });
    let w = dcel.add_isolated_vertex(FaceId(0));
    let split = CcbSplit { kinds: [Outer, Outer], new_face: Some(Side::Even) };
    let b = dcel.insert_loop(w, FaceId(0), split);
    dcel.move_ccb(dcel.ccb(a.half(Side::Odd)), dcel.face(b.half(Side::Even)));
    assert_eq!((dcel.component_count(), dcel.face_count(), dcel.least_genus()), (2, 2, 1));
    assert_eq!(dcel.check_euler(1), []);
    for f in dcel.faces() {
        assert_eq!((dcel.outer_ccbs(f).count(), dcel.inner_ccbs(f).count()), (2, 0));
    }
    // An edge across one of the annuli.
    let bridge = dcel.insert_edge_joining(a.half(Side::Even), b.half(Side::Odd), Outer);
    assert_eq!((dcel.component_count(), dcel.least_genus()), (1, 1));
    assert_eq!(dcel.genus_of_components(), [0]);
    dcel.remove_edge(bridge, [EndFate::Isolate; 2], Side::Even);
    assert_eq!((dcel.component_count(), dcel.least_genus()), (2, 1));
}
