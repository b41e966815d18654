//! Arrangements that are no Gaussian maps.

use crate::features::{check, hull, identification};
use arrangement::Arrangement;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::overlay::Cell;
use arrangement::topology::Sphere;
use exact::Point3;
use exact::spherical::Direction;
use polytope::Polytope;
use splitstar_gauss::{GaussianViolation, SphericalGaussianMap};

fn tetrahedron() -> Polytope {
    hull(&[[0, 0, 0], [3, 0, 1], [1, 2, 0], [0, 1, 4]])
}

fn parts() -> (Arrangement<GeodesicTraits, Sphere>, Vec<Point3>) {
    SphericalGaussianMap::of_polytope(&tetrahedron()).into_parts()
}

fn violations(
    (arrangement, points): (Arrangement<GeodesicTraits, Sphere>, Vec<Point3>),
) -> Vec<GaussianViolation> {
    SphericalGaussianMap::try_from_parts(arrangement, points).expect_err("it is no Gaussian map")
}

#[test]
fn parts_put_together_again() {
    let (arrangement, points) = parts();
    let map = SphericalGaussianMap::try_from_parts(arrangement, points).expect("nothing was changed");
    check(&map, &tetrahedron(), "put together again");
}

#[test]
fn points_of_another_polytope() {
    let (arrangement, mut points) = parts();
    points[2] = points[2].plus(&Point3::from_i64([0, 0, 1]));
    let found = violations((arrangement, points));
    assert!(found.iter().all(|violation| matches!(violation, GaussianViolation::Edge(_))), "{found:?}");
    assert!(found.len() >= 3, "all edges of the vertex: {found:?}");
}

#[test]
fn a_reflected_polytope_turns_inside_out() {
    let (arrangement, points) = parts();
    let reflected = SphericalGaussianMap::of_polytope(&tetrahedron()).reflected();
    let edges = arrangement.dcel().edge_count();
    // The points of the reflection are right up to their sign, which every edge notes.
    assert_eq!(violations((arrangement, reflected.points().to_vec())).len(), edges);
    assert_eq!(violations((reflected.into_parts().0, points)).len(), edges);
}

#[test]
fn a_point_is_missing() {
    let (arrangement, mut points) = parts();
    points.pop();
    assert_eq!(violations((arrangement, points)), [GaussianViolation::Points]);
}

/// Inserts something and gives all faces the points that they had.
fn with(
    change: impl FnOnce(&mut Arrangement<GeodesicTraits, Sphere>) -> arrangement::overlay::Provenance,
) -> (Arrangement<GeodesicTraits, Sphere>, Vec<Point3>) {
    let (mut arrangement, points) = parts();
    let provenance = change(&mut arrangement);
    let old = |f| points[provenance.of_face(f)[0].index()].clone();
    let points = arrangement.dcel().faces().map(old).collect();
    (arrangement, points)
}

#[test]
fn a_vertex_too_many() {
    let in_a_face = Direction::from_i64([5, 1, 7]).expect("not zero");
    let found = violations(with(|arrangement| arrangement.insert_points([in_a_face])));
    assert!(matches!(found[..], [GaussianViolation::Vertex(_)]), "{found:?}");

    // A point of an arc, which stays one on both sides of it.
    let (arrangement, _) = parts();
    let dcel = arrangement.dcel();
    let inner = |e| {
        let [p, q] = dcel.ends(e).map(|v| arrangement.point(v).expect("on the sphere").coordinates());
        Direction::new([0, 1, 2].map(|i: usize| &p[i] + &q[i])).expect("not antipodal")
    };
    let e = dcel.edges().find(|&e| dcel.ends(e).iter().all(|&v| !arrangement.is_artificial(v)));
    let on_an_arc = inner(e.expect("some arc is not cut"));
    let found = violations(with(|arrangement| arrangement.insert_points([on_an_arc])));
    assert!(matches!(found[..], [GaussianViolation::Vertex(_)]), "{found:?}");
}

#[test]
fn an_arc_too_many() {
    let ends = [[5, 1, 7], [5, 2, 7]].map(|p| Direction::from_i64(p).expect("not zero"));
    let [p, q] = ends;
    let arc = Geodesic::arc(p, q).expect("neither equal nor antipodal");
    let found = violations(with(|arrangement| {
        let provenance = arrangement.insert_curves([&arc]);
        assert!(arrangement.dcel().edges().any(|e| matches!(provenance.of_edge(e), [Cell::Face(_)])));
        provenance
    }));
    let edges = found.iter().filter(|violation| matches!(violation, GaussianViolation::Edge(_)));
    assert!(edges.count() == 1 && found.len() == 3, "an edge and its ends: {found:?}");
}

#[test]
fn messages() {
    let (arrangement, mut points) = parts();
    points[0] = Point3::from_i64([100, 100, 100]);
    let found = violations((arrangement, points));
    let text = found[0].to_string();
    assert!(text.starts_with("the points of the faces beside edge "), "{text}");
}

#[test]
fn maps_with_another_identification_are_not_mixed_up() {
    let p = tetrahedron();
    let [a, b] = [[1, 0], [0, 1]].map(|d| SphericalGaussianMap::of_polytope_with(&p, identification(d)));
    let sum = a.minkowski_sum(&b);
    assert_eq!(sum.check_valid(), []);
    assert!([a, b].iter().any(|map| map.arrangement().traits() == sum.arrangement().traits()));
}
