//! Table 3.1 of the thesis.

use splitstar_cubical::{At, CubeSide, CubicalArrangement};

/// For each side and each of its corners (0,0), (0,1), (1,0), (1,1): the next side, clockwise, and the number of the corner there.
const TABLE: [[(usize, usize); 4]; 6] = [
    [(1, 0), (2, 2), (5, 0), (4, 2)],
    [(2, 0), (0, 2), (3, 0), (5, 2)],
    [(0, 0), (1, 2), (4, 0), (3, 2)],
    [(2, 1), (1, 3), (4, 1), (5, 3)],
    [(0, 1), (2, 3), (5, 1), (3, 3)],
    [(1, 1), (0, 3), (3, 1), (4, 3)],
];

#[test]
fn corners_are_chained_as_in_the_thesis() {
    let map = CubicalArrangement::new();
    for side in CubeSide::ALL {
        for (corner, &(next, number)) in TABLE[side.index()].iter().enumerate() {
            let v = At { side, id: map.corners(side)[corner] };
            let copy = map.next_copy(v).expect("a corner has copies");
            let corners = map.corners(copy.side);
            let at = corners.iter().position(|&id| id == copy.id).expect("a corner");
            assert_eq!((copy.side.index(), at), (next, number), "side {side}, corner {corner}");
        }
    }
}
