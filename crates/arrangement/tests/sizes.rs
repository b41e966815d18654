//! The bytes of `docs/arrangement.md`: what a cell takes, and what a cut copy of a curve would.

use dcel::{CcbId, EdgeId, FaceId, Halfedge, HalfedgeId, VertexId};
use exact::planar::{Line2, Point2};
use splitstar_arrangement::models::{Linear, Segment};

/// The rows of the table that are types of their own, each with what the page says. `dcel` tests its own records.
#[test]
fn records_are_as_large_as_the_page_says() {
    let page = include_str!("../../../docs/arrangement.md");
    let says = |row: &str, bytes: usize| {
        let line = page.lines().find(|line| line.starts_with(&format!("| {row}")));
        let line = line.unwrap_or_else(|| panic!("no row {row}"));
        assert!(line.ends_with(&format!("| {bytes} |")), "{bytes} bytes: {line}");
    };
    assert_eq!(size_of::<Point2>(), size_of::<Option<Point2>>());
    says("point of the linear models", size_of::<Point2>());
    says("line", size_of::<Line2>());
    assert_eq!(size_of::<Segment>(), size_of::<Linear>());
    says("cut copy of a segment", size_of::<Segment>());
    says("vertex", size_of::<HalfedgeId>() + size_of::<bool>());
    says("edge", 2 * size_of::<Halfedge>() + size_of::<u32>());
    let ids = [size_of::<VertexId>(), size_of::<EdgeId>(), size_of::<CcbId>(), size_of::<FaceId>()];
    assert_eq!(ids, [4; 4]);
}

/// As the page counts it.
#[test]
fn so_much_do_the_cells_of_3000_long_segments_take() {
    let [vertices, edges, faces] = [1_034_374_usize, 2_059_748, 1_025_377];
    // The vertex and its point, the edge, the face and its CCB.
    let bytes = vertices * (size_of::<Option<Point2>>() + 5) + edges * 36 + faces * (12 + 16);
    assert_eq!(bytes / 1_000_000, 207);
}
