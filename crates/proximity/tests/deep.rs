//! A thousand deep overlaps of two spheres of 162 vertices, where programs with floats report too small a depth: ours is the least over
//! all facets of the sum, exactly. That sum is a convex hull of all differences of vertices, and no other code is shared with the tested one.

#![allow(clippy::print_stdout, reason = "tests print their seeds")]

use exact::{Integer, Rational};
use polytope::{Polytope, minkowski_sum_by_hull};
use splitstar_proximity::{Pair, RelativePlacement, Translation};
use testkit::{Rng, around, geodesic_sphere, quaternion, rotation};

const SEED: u64 = 1;
const COUNT: usize = 1_000;
const DIAMETER: f64 = 2.0;
const TURN: [i64; 4] = [7, 1, 2, 3];

/// From 0 to 1.
fn fraction(rng: &mut Rng) -> f64 {
    (rng.bits() >> 11) as f64 / (1_u64 << 53) as f64
}

fn length(place: [f64; 3]) -> f64 {
    place.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// A translation deep inside, as the comparison with other programs draws it: more of them near the middle.
fn deep(rng: &mut Rng) -> [f64; 3] {
    let way = loop {
        let way = [0.0; 3].map(|_: f64| 2.0 * fraction(rng) - 1.0);
        if (0.1..=1.0).contains(&length(way)) {
            break way;
        }
    };
    let distance = 0.35 * DIAMETER * fraction(rng);
    way.map(|x| distance * (x / length(way)))
}

/// The planes of the facets of a solid: integers normal, height and weight, such that normal . x weight <= height, and the squared
/// length of the normal times the squared weight.
struct Planes(Vec<([Integer; 3], Integer, Integer)>);

impl Planes {
    fn new(solid: &Polytope) -> Self {
        let plane = |f| {
            let corner = &solid.points()[solid.facet_cycle(f).next().expect("a facet has vertices").index()];
            let normal = solid.facet_normal(f).coordinates();
            let height = dot(&normal, &[0, 1, 2].map(|axis| corner.numerator(axis)));
            let normal = normal.map(|c| c * corner.weight());
            let squared_length = dot(&normal, &normal);
            (normal, height, squared_length)
        };
        Self(solid.mesh().facets().map(plane).collect())
    }

    /// The least squared distance of a point inside to a plane, one plane after the other.
    fn least(&self, s: &[Rational; 3]) -> Rational {
        let weight = s.iter().fold(Integer::from(1), |weight, c| weight.lcm(&c.denominator()));
        let s = s.each_ref().map(|c| (c * &Rational::from(&weight)).numerator());
        let squares = self.0.iter().map(|(normal, height, squared_length)| {
            let slack = height * &weight - dot(normal, &s);
            assert!(slack > Integer::from(0), "the point is inside");
            (&slack * &slack, squared_length)
        });
        let least = squares.reduce(|a, b| if &b.0 * a.1 < &a.0 * b.1 { b } else { a });
        let (square, squared_length) = least.expect("a solid has facets");
        Rational::new(square, squared_length * &weight * &weight).expect("a normal is not zero")
    }
}

fn dot(a: &[Integer; 3], b: &[Integer; 3]) -> Integer {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

#[test]
fn a_thousand_deep_overlaps_have_the_least_depth_of_all_facets() {
    let sphere = around(&geodesic_sphere(4, 6).points);
    let turned = sphere.transformed(&rotation(TURN));
    assert_eq!(sphere.points().len(), 162);
    let planes = Planes::new(&minkowski_sum_by_hull(&[&sphere, &turned.reflected()]));
    let (sum, pair, turn) =
        (RelativePlacement::new(&sphere, &turned), Pair::new(&sphere, &sphere), quaternion(TURN));
    println!("seed {SEED}, {} facets", planes.0.len());
    let mut rng = Rng::new(SEED);
    let mut witness = None;
    let begin = std::time::Instant::now();
    for number in 0..COUNT {
        let place = deep(&mut rng);
        let s = Translation::from_f64(place).expect("the numbers are finite");
        let least = planes.least(&s.coordinates());
        let case = format!("placement {number}: {place:?}");
        for hint in [None, witness] {
            let found = sum.minimum_penetration(&s, hint).unwrap_or_else(|| panic!("no overlap: {case}"));
            assert_eq!(found.squared_depth(), least, "{case}");
            witness = Some(found.witness());
        }
        let found = pair.minimum_penetration(&s, Some(&turn), None);
        assert_eq!(found.map(|found| found.squared_depth()), Some(least), "without the sum, {case}");
    }
    println!("{:?}", begin.elapsed());
}

/// Translations with a coordinate next to nothing: their weights are beyond the range of floats.
#[test]
fn dust_on_a_translation_of_many_facets() {
    let sphere = around(&geodesic_sphere(4, 6).points);
    let turned = sphere.transformed(&rotation(TURN));
    let planes = Planes::new(&minkowski_sum_by_hull(&[&sphere, &turned.reflected()]));
    let sum = RelativePlacement::new(&sphere, &turned);
    for place in [[0.25, 1e-310, -0.5], [-1e-320, 0.75, 1e-300], [f64::from_bits(1), 0.0, 0.0], [1e-295; 3]] {
        let s = Translation::from_f64(place).expect("the numbers are finite");
        let found = sum.minimum_penetration(&s, None).unwrap_or_else(|| panic!("no overlap: {place:?}"));
        assert_eq!(found.squared_depth(), planes.least(&s.coordinates()), "{place:?}");
        let clean = Translation::from_f64(place.map(|c| if c.abs() < 1e-290 { 0.0 } else { c }));
        let clean = clean.expect("the numbers are finite");
        assert_eq!(sum.relation(&s, None).0, sum.relation(&clean, None).0);
    }
    let apart = Translation::from_f64([3.0, 1e-310, -0.5]).expect("the numbers are finite");
    let separation = sum.separation(&apart, None);
    let [a, b] = separation.closest_points();
    let square: Rational = [0, 1, 2].map(|i: usize| &a[i] - &b[i]).iter().map(|c| c * c).sum();
    assert_eq!(square, separation.squared_distance());
    let pair = Pair::new(&sphere, &turned);
    assert_eq!(pair.separation(&apart, None, None).squared_distance(), square);
}
