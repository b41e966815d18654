//! Ids of cells that are not there.

use dcel::{EdgeId, VertexId};
use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::{Arrangement, Editor};

/// Three bars, of which one was removed, and its id.
fn with_a_hole(hole: usize) -> (Arrangement<SegmentTraits, BoundedPlane>, EdgeId, [VertexId; 2]) {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let bars = [0, 2, 4].map(|v| Segment::from_i64([[v, v], [9 - v, v]]).unwrap());
    let edges: Vec<EdgeId> = bars.iter().flat_map(|bar| editor.insert_curve(bar)).collect();
    let e = edges[hole];
    let ends = editor.dcel().ends(e);
    editor.remove_edge(e);
    (editor.finish().0, e, ends)
}

#[test]
fn a_removed_edge_has_nothing_beside_it() {
    for hole in 0..3 {
        let (arrangement, e, ends) = with_a_hole(hole);
        let made = VerticalDecomposition::new(&arrangement);
        assert_eq!(made.trapezoid_count(), 1 + 4 + 2);
        for e in [e, EdgeId(3), EdgeId(4), EdgeId(u32::MAX - 1), EdgeId(u32::MAX)] {
            assert!(made.above(Some(e)).is_empty(), "above {e:?}");
            assert!(made.below(Some(e)).is_empty(), "below {e:?}");
        }
        for v in ends.into_iter().chain([VertexId(6), VertexId(u32::MAX)]) {
            assert_eq!(made.sites_of(v).count(), 0, "{v:?}");
            assert_eq!(made.walls_of(v), [WallEnd::Nothing; 2], "{v:?}");
        }
        for e in arrangement.dcel().edges() {
            assert!(!made.above(Some(e)).is_empty() && !made.below(Some(e)).is_empty(), "{e:?}");
            assert_eq!(made.ends(e).map(|site| made.vertex(site)), arrangement.dcel().ends(e), "{e:?}");
        }
        assert!(made.complex(&arrangement).is_ok());
    }
}

/// It would be the sites of other edges.
#[test]
#[should_panic(expected = "edge 1 does not exist")]
fn the_ends_of_a_removed_edge() {
    let (arrangement, e, _) = with_a_hole(1);
    VerticalDecomposition::new(&arrangement).ends(e);
}

#[test]
#[should_panic(expected = "edge 0 does not exist")]
fn the_ends_of_the_first_edge_when_it_was_removed() {
    let (arrangement, e, _) = with_a_hole(0);
    VerticalDecomposition::new(&arrangement).ends(e);
}

#[test]
#[should_panic(expected = "edge 4294967295 does not exist")]
fn the_ends_of_the_greatest_id() {
    let (arrangement, ..) = with_a_hole(2);
    VerticalDecomposition::new(&arrangement).ends(EdgeId(u32::MAX));
}
