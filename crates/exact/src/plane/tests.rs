use super::*;
use crate::predicate::plane_side;
use crate::testing::{Random, WIDTHS};

#[test]
fn a_plane_agrees_with_the_predicate_and_contains_its_points() {
    let mut random = Random::new(8);
    for bits in WIDTHS {
        for _ in 0..20 {
            let mut point = || {
                let weight = random.integer(bits.min(40)).abs() + Integer::ONE;
                Point3::new(random.vector(bits).coordinates(), weight).unwrap()
            };
            let [a, b, c, p] = [(); 4].map(|()| point());
            let Some(plane) = Plane::through(&a, &b, &c) else {
                assert!(a.direction_to(&b).cross(&a.direction_to(&c)).is_zero());
                continue;
            };
            assert_eq!(plane.normal, plane.normal.primitive());
            for on in [&a, &b, &c] {
                assert_eq!(plane.side(on), Sign::Zero);
            }
            assert_eq!(plane.side(&p), plane_side(&plane.normal, &a, &p));
            assert_eq!(plane.side(&p), plane.height(&p).sign());
            assert_eq!(plane.opposite().side(&p), -plane.side(&p));
            assert_eq!(Plane::through(&b, &c, &a), Some(plane.clone()));
            assert_eq!(Plane::through(&c, &b, &a), Some(plane.opposite()));
        }
    }
}

#[test]
fn collinear_points_and_zero_normals_make_no_plane() {
    let [a, b, c] = [[0, 0, 0], [1, 1, 1], [3, 3, 3]].map(Point3::from_i64);
    assert_eq!(Plane::through(&a, &b, &c), None);
    assert_eq!(Plane::through(&a, &a, &b), None);
    assert_eq!(Plane::new(&Vector3::from_i64([0, 0, 0]), &a), None);
    let plane = Plane::new(&Vector3::from_i64([0, 0, -4]), &"1/3".parse().map(at_height).unwrap()).unwrap();
    assert_eq!(plane.to_string(), "(0, 0, -1) . p = -1/3");
}

fn at_height(z: Rational) -> Point3 {
    Point3::from_rationals(&[Rational::ZERO, Rational::ZERO, z])
}
