use super::*;
use crate::testing::{Random, WIDTHS};

fn number(text: &str) -> Rational {
    text.parse().unwrap()
}

fn random_map(random: &mut Random, bits: u32) -> Affine3 {
    let mut value =
        || Rational::new(random.integer(bits), random.integer(bits.min(64)).abs() + Integer::ONE).unwrap();
    let rows = [(); 3].map(|()| [(); 3].map(|()| value()));
    Affine3::new(Linear3::from_rationals(&rows), [(); 3].map(|()| value()))
}

fn random_point(random: &mut Random, bits: u32) -> Point3 {
    let weight = random.integer(bits.min(60)).abs() + Integer::ONE;
    Point3::new(random.vector(bits).coordinates(), weight).unwrap()
}

#[test]
fn images_are_those_of_rational_arithmetic() {
    let mut random = Random::new(30);
    for bits in WIDTHS {
        for map_bits in [1, 5, 20, 40, 61, 62, 63, 200] {
            let map = random_map(&mut random, map_bits);
            let point = random_point(&mut random, bits);
            let x = point.coordinates();
            let image = [0, 1, 2].map(|row| {
                let sum: Rational = (0..3).map(|column| map.linear().entry(row, column) * &x[column]).sum();
                sum + &map.translation[row]
            });
            assert_eq!(map.apply(&point), Point3::from_rationals(&image), "{map:?} {point}");
        }
    }
}

#[test]
fn maps_compose_in_order() {
    let mut random = Random::new(31);
    for bits in [3, 20, 62, 100] {
        for _ in 0..20 {
            let (f, g, h) =
                (random_map(&mut random, bits), random_map(&mut random, bits), random_map(&mut random, bits));
            let p = random_point(&mut random, bits);
            assert_eq!(f.then(&g).apply(&p), g.apply(&f.apply(&p)));
            assert_eq!(f.then(&g).then(&h), f.then(&g.then(&h)));
            assert_eq!(f.then(&Affine3::identity()), f);
            assert_eq!(Affine3::identity().then(&f), f);
            let sign = f.determinant_sign() * g.determinant_sign();
            assert_eq!(f.then(&g).determinant_sign(), sign);
            let (a, b) = (random_point(&mut random, 20), random_point(&mut random, 20));
            let (image, direct) =
                (f.apply(&a).direction_to(&f.apply(&b)), f.linear().apply(&a.direction_to(&b)));
            assert!(image.cross(&direct).is_zero() && image.dot(&direct).sign() >= Sign::Zero);
        }
    }
}

#[test]
fn the_named_maps_do_what_they_say() {
    let p = Point3::from_i64([1, -2, 3]);
    let rows = [
        (Affine3::identity(), "(1, -2, 3)", Sign::Positive),
        (Affine3::reflection(), "(-1, 2, -3)", Sign::Negative),
        (Affine3::scaling(&number("1/2")), "(1/2, -1, 3/2)", Sign::Positive),
        (Affine3::scaling(&number("-2")), "(-2, 4, -6)", Sign::Negative),
        (Affine3::scaling(&Rational::ZERO), "(0, 0, 0)", Sign::Zero),
        (Affine3::translation(&["0.1", "2", "-3"].map(number)), "(11/10, 0, 0)", Sign::Positive),
    ];
    for (map, shown, sign) in rows {
        assert_eq!(map.apply(&p).to_string(), shown);
        assert_eq!(map.determinant_sign(), sign);
    }
}

#[test]
fn rotations_keep_lengths_and_orientation() {
    let mut random = Random::new(32);
    for _ in 0..50 {
        let components = [(); 4].map(|()| random.integer(20));
        let Some(quaternion) = Quaternion::new(components) else { continue };
        let map = Affine3::rotation(&quaternion);
        assert_eq!(map.determinant_sign(), Sign::Positive);
        let p = random_point(&mut random, 30);
        let square = |p: &Point3| p.coordinates().iter().map(|x| x * x).sum::<Rational>();
        assert_eq!(square(&map.apply(&p)), square(&p));
    }
    // i j = k: a quarter turn about x, then one about y.
    let turn = |w, x, y, z| Affine3::rotation(&Quaternion::new([w, x, y, z].map(Integer::from)).unwrap());
    let p = Point3::from_i64([1, 2, 3]);
    assert_eq!(turn(1, 1, 0, 0).apply(&p), Point3::from_i64([1, -3, 2]));
    assert_eq!(turn(1, 0, 1, 0).apply(&p), Point3::from_i64([3, 2, -1]));
    assert_eq!(turn(1, 0, 0, 1).apply(&p), Point3::from_i64([-2, 1, 3]));
    assert_eq!(turn(1, 1, 1, 1).apply(&p), Point3::from_i64([3, 1, 2]));
}

#[test]
fn narrow_images_of_one_mesh_share_a_weight() {
    let axis = ["0", "0", "1"].map(number);
    let quaternion = Quaternion::nearest(axis, number("31.4")).unwrap();
    let map = Affine3::rotation(&quaternion);
    let mut random = Random::new(33);
    let weights: Vec<Integer> = (0..100)
        .map(|_| {
            let [x, y, z] = [(); 3].map(|()| random.around_zero(30_000));
            let image = map.apply(&Point3::from_i64([x, y, z]));
            assert!(image.as_narrow().is_some());
            image.weight()
        })
        .collect();
    assert!(weights.iter().all(|weight| *weight == weights[0]));
}
