//! Tables 3.2 and 3.3 of the thesis.

use cubical::CubeSide;
use polytope::Polytope;
use splitstar_gauss::CubicalGaussianMap;
use testkit::{hull, model, rotation};

/// Vertices, halfedges and faces of all sides, or of one.
fn stored(counts: arrangement::Counts) -> [usize; 3] {
    [counts.vertices, 2 * counts.edges, counts.faces]
}

/// A pyramid over a polygon of 16 sides with four vertices on axes; it is as high as these are far from the middle. So the normals of
/// the eight facets there have two coordinates of the same magnitude, and lie on edges of the cube.
fn dioctagonal_pyramid() -> Polytope {
    let quarter = [[10_000, 0], [9_239, 3_827], [7_071, 7_071], [3_827, 9_239]];
    let base = quarter.into_iter().flat_map(|[x, z]| [[x, z], [-z, x], [-x, -z], [z, -x]]);
    let points: Vec<[i64; 3]> = base.map(|[x, z]| [x, 0, z]).chain([[0, -10_000, 0]]).collect();
    hull(&points)
}

#[test]
fn sides_of_the_dioctagonal_pyramid() {
    let polytope = dioctagonal_pyramid();
    assert_eq!(polytope.counts().to_array(), [17, 32, 17]);
    let map = CubicalGaussianMap::of_polytope(&polytope);
    let sides = CubeSide::ALL.map(|side| stored(map.arrangement().side(side).counts_with_splits()));
    let others = [12, 32, 6];
    assert_eq!(sides, [others, [28, 80, 14], others, others, [21, 72, 17], others]);
}

#[test]
fn all_sides_of_all_models() {
    // As they are in the repository, or turned until they have the counts of the thesis.
    let turned = |name, quaternion| model(name).transformed(&rotation(quaternion));
    let rows = [
        ("tetrahedron", turned("convex/tetrahedron.off", [8, -1, -4, -4]), [42, 102, 21]),
        ("octahedron", model("convex/octahedron.off"), [24, 48, 12]),
        ("icosahedron", turned("convex/icosahedron.off", [7, -3, -4, -4]), [72, 192, 36]),
        ("DP", dioctagonal_pyramid(), [97, 280, 55]),
        ("PH", turned("convex/ph_snub_dodecahedron.off", [8, -1, -2, -4]), [200, 600, 112]),
        ("TI", turned("convex/truncated_icosidodecahedron.xoff", [6, -1, 3, -4]), [230, 840, 202]),
        ("GS4", model("convex/gs4.off"), [708, 2_124, 366]),
        ("El16", model("convex/el16.off"), [776, 2_752, 612]),
    ];
    for (name, polytope, counts) in rows {
        let map = CubicalGaussianMap::of_polytope(&polytope);
        assert_eq!(stored(map.arrangement().counts_with_artificial()), counts, "{name}");
        assert_eq!(map.counts(), polytope.counts(), "{name}");
    }
}
