//! Arcs whose ends are not where they should be.

use crate::agree::direction;
use arrangement::models::GeodesicError;
use exact::spherical::GreatCircle;
use splitstar_cubical::{CubicalArrangement, CubicalPieces};

/// Circles, a point of each, and points that are not on it: on other sides, on the same one, and at a corner.
fn rows() -> Vec<([i64; 3], [i64; 3], [i64; 3])> {
    vec![
        ([0, 0, 1], [1, 0, 0], [0, 0, 1]),
        ([0, 0, 1], [1, 0, 0], [5, 1, 1]),
        ([0, 0, 1], [1, 0, 0], [0, 5, 1]),
        ([0, 0, 1], [1, 1, 0], [1, 1, 1]),
        ([0, 0, 1], [1, 1, 0], [2, 2, -1]),
        ([1, -1, 0], [1, 1, 1], [1, -1, 1]),
        ([1, -1, 0], [2, 2, 1], [3, 2, 2]),
        ([i64::MAX, 1, 0], [0, 0, 1], [1, i64::MAX, 1]),
    ]
}

/// Such a walk went round the cube for ever, or put a segment on a line on which it does not end.
#[test]
fn arcs_with_an_end_off_the_circle_are_refused() {
    for (normal, on, off) in rows() {
        let circle = GreatCircle::from_i64(normal).expect("not zero");
        let [on, off] = [on, off].map(direction);
        for [source, target] in [[&on, &off], [&off, &on], [&off, &off]] {
            let mut pieces = CubicalPieces::new();
            assert_eq!(pieces.push_arc(&circle, source, target), Err(GeodesicError::NotOnCircle));
            assert_eq!(pieces.arc_count(), 0);
            let counts = CubicalArrangement::of_pieces(pieces).counts();
            assert_eq!((counts.vertices, counts.faces), (0, 1), "nothing was appended");
        }
        let mut pieces = CubicalPieces::new();
        assert_eq!(pieces.push_arc(&circle, &on, &on), Ok(()));
        let counts = CubicalArrangement::of_pieces(pieces).counts();
        assert_eq!((counts.vertices, counts.edges, counts.faces), (1, 1, 2));
    }
}

#[test]
#[should_panic = "both ends of an arc lie on its circle"]
fn ends_off_the_circle_panic() {
    let circle = GreatCircle::from_i64([0, 0, 1]).expect("not zero");
    let mut pieces = CubicalPieces::new();
    let [source, target] = [[1, 0, 0], [0, 0, 1]].map(|p| pieces.add_end(&direction(p)));
    pieces.push_arc_between(&circle, source, target);
}
