//! Six arrangements that are no Gaussian map.

use crate::features::check;
use arrangement::models::Geodesic;
use cubical::{At, CubeSide, CubicalArrangement, CubicalPieces, Place, overlay_all};
use exact::spherical::Direction;
use exact::{Affine3, Point3};
use polytope::Polytope;
use splitstar_gauss::{CubicalGaussianMap, CubicalGaussianViolation};
use testkit::hull;

fn tetrahedron() -> Polytope {
    hull(&[[0, 0, 0], [3, 0, 1], [1, 2, 0], [0, 1, 4]])
}

fn parts() -> (CubicalArrangement, Vec<Point3>) {
    CubicalGaussianMap::of_polytope(&tetrahedron()).into_parts()
}

fn violations((arrangement, points): (CubicalArrangement, Vec<Point3>)) -> Vec<CubicalGaussianViolation> {
    CubicalGaussianMap::try_from_parts(arrangement, points).expect_err("it is no Gaussian map")
}

fn edges(found: &[CubicalGaussianViolation]) -> usize {
    found.iter().filter(|violation| matches!(violation, CubicalGaussianViolation::Edge(_))).count()
}

fn vertices(found: &[CubicalGaussianViolation]) -> usize {
    found.iter().filter(|violation| matches!(violation, CubicalGaussianViolation::Vertex(_))).count()
}

/// Real edges of all sides; one along an edge of the cube counts twice.
fn real_edges(map: &CubicalArrangement) -> usize {
    let of_side = |side| map.side(side).dcel().edges().map(move |id| At { side, id });
    CubeSide::ALL.into_iter().flat_map(of_side).filter(|&e| map.is_real_edge(e)).count()
}

#[test]
fn parts_put_together_again() {
    let (arrangement, points) = parts();
    let map = CubicalGaussianMap::try_from_parts(arrangement, points).expect("nothing was changed");
    check(&map, &tetrahedron(), "put together again");
}

#[test]
fn points_of_another_polytope() {
    let (arrangement, mut points) = parts();
    points[2] = points[2].plus(&Point3::from_i64([0, 0, 1]));
    let found = violations((arrangement, points));
    assert!(edges(&found) == found.len() && found.len() >= 3, "all edges of the vertex: {found:?}");
}

#[test]
fn a_reflected_polytope_turns_inside_out() {
    let (arrangement, points) = parts();
    // The points of the reflection are right up to their sign, which every edge notes.
    let negated = points.iter().map(|p| Affine3::reflection().apply(p)).collect();
    let count = real_edges(&arrangement);
    let found = violations((arrangement, negated));
    assert_eq!((edges(&found), found.len()), (count, count));
    let (reflected, of_reflected) = CubicalGaussianMap::of_polytope(&tetrahedron()).reflected().into_parts();
    let negated = of_reflected.iter().map(|p| Affine3::reflection().apply(p)).collect();
    let found = violations((reflected, negated));
    assert_eq!((edges(&found), found.len()), (count, count));
}

#[test]
fn a_point_is_missing_or_too_many() {
    let (arrangement, mut points) = parts();
    points.push(points[0].clone());
    assert_eq!(violations((arrangement.clone(), points.clone())), [CubicalGaussianViolation::Points]);
    points.truncate(3);
    assert_eq!(violations((arrangement, points)), [CubicalGaussianViolation::Points]);
}

/// The map with something more; all faces have the points that they had.
fn with(map: &CubicalGaussianMap, geodesic: &Geodesic) -> (CubicalArrangement, Vec<Point3>) {
    let mut pieces = CubicalPieces::new();
    pieces.push_geodesic(geodesic);
    let operands = [map.arrangement(), &CubicalArrangement::of_pieces(pieces)];
    let (arrangement, provenance) = overlay_all(&operands);
    let old = |face| provenance.of_face(&arrangement, &operands, face).next().expect("there are operands");
    let points = arrangement.faces().map(|face| map.point(old(face)).clone()).collect();
    (arrangement, points)
}

fn direction(p: [i64; 3]) -> Direction {
    Direction::from_i64(p).expect("not zero")
}

/// Inside of a side, on an edge of the cube, and at a corner.
const PLACES: [([i64; 3], Place); 3] =
    [([5, 1, 7], Place::Side), ([7, 1, 7], Place::Edge), ([1, 1, 1], Place::Corner)];

#[test]
fn a_vertex_too_many_in_a_face() {
    let map = CubicalGaussianMap::of_polytope(&tetrahedron());
    for (at, place) in PLACES {
        let (arrangement, points) = with(&map, &Geodesic::point(direction(at)));
        let new = arrangement.real_vertices().find(|&v| arrangement.direction(v) == direction(at));
        let new = new.expect("a point becomes a vertex");
        assert_eq!(arrangement.place(new), place);
        assert_eq!(violations((arrangement, points)), [CubicalGaussianViolation::Vertex(new)]);
    }
}

/// A place where an arc passes over an edge of the cube.
fn passage(map: &CubicalArrangement) -> Direction {
    let of_side = |side| map.side(side).dcel().vertices().map(move |id| At { side, id });
    let mut vertices = CubeSide::ALL.into_iter().flat_map(of_side);
    let passage = vertices.find(|&v| !map.is_real_vertex(v) && map.real_around(v).next().is_some());
    map.direction(passage.expect("some arc passes over an edge of the cube"))
}

#[test]
fn a_vertex_too_many_on_an_arc() {
    let octahedron = hull(&[[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]);
    let segment = hull(&[[0, 0, 0], [1, -1, 0]]);
    for (polytope, at, place) in [
        (&tetrahedron(), None, Place::Edge),
        // Its arcs run along all edges of the cube.
        (&octahedron, Some([2, 2, 1]), Place::Edge),
        // Its circle runs along two edges of the cube, and through four corners.
        (&segment, Some([2, 2, 1]), Place::Edge),
        (&segment, Some([1, 1, 1]), Place::Corner),
        (&segment, Some([1, 1, 3]), Place::Side),
    ] {
        let map = CubicalGaussianMap::of_polytope(polytope);
        let at = at.map_or_else(|| passage(map.arrangement()), direction);
        let (arrangement, points) = with(&map, &Geodesic::point(at.clone()));
        let new = arrangement.real_vertices().find(|&v| arrangement.direction(v) == at);
        let new = new.expect("a point becomes a vertex");
        assert_eq!((arrangement.place(new), arrangement.real_around(new).count()), (place, 2));
        assert_eq!(violations((arrangement, points)), [CubicalGaussianViolation::Vertex(new)]);
    }
}

#[test]
fn an_arc_too_many() {
    let map = CubicalGaussianMap::of_polytope(&tetrahedron());
    // In a face: within a side, across an edge of the cube, along one, over a corner and on along an edge.
    for (ends, stored) in [
        ([[5, 1, 7], [5, 2, 7]], 1),
        ([[6, -4, 7], [7, -4, 6]], 2),
        ([[7, 1, 7], [7, 2, 7]], 2),
        ([[7, 8, 8], [8, 7, 7]], 3),
    ] {
        let [p, q] = ends.map(direction);
        let arc = Geodesic::arc(p, q).expect("neither equal nor antipodal");
        let (arrangement, points) = with(&map, &arc);
        assert_eq!(points.len(), 4, "{ends:?}: the arc lies in a face");
        let found = violations((arrangement, points));
        assert_eq!(
            (edges(&found), vertices(&found), found.len()),
            (stored, 2, stored + 2),
            "{ends:?}: {found:?}"
        );
    }
}

#[test]
fn messages() {
    let (arrangement, mut points) = parts();
    points[0] = Point3::from_i64([100, 100, 100]);
    let text = violations((arrangement, points))[0].to_string();
    assert!(text.contains("the points of the faces beside edge "), "{text}");
    let map = CubicalGaussianMap::of_polytope(&tetrahedron());
    let text = violations(with(&map, &Geodesic::point(direction([1, 1, 1]))))[0].to_string();
    assert!(text.ends_with("does not join three arcs"), "{text}");
}
