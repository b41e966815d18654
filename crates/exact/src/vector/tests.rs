use super::*;
use crate::testing::{Random, WIDTHS};
use std::collections::HashSet;

fn power(bits: u32) -> Integer {
    Integer::ONE << bits
}

#[test]
fn the_width_is_the_least_that_holds_the_vector() {
    let rows = [
        (Integer::ZERO, Width::Narrow, 0),
        (power(62) - Integer::ONE, Width::Narrow, 62),
        (power(62), Width::Double, 63),
        (Integer::from(i64::MIN), Width::Double, 64),
        (power(126) - Integer::ONE, Width::Double, 126),
        (power(126), Width::Wide, 127),
        (power(127), Width::Wide, 128),
        (power(1100), Width::Wide, 1101),
    ];
    for (value, width, bits) in rows {
        for value in [value.clone(), -value] {
            for axis in 0..3 {
                let mut coordinates = [1, 0, 0].map(Integer::from);
                coordinates[axis] = value.clone();
                let vector = Vector3::new(coordinates.clone());
                let bits = if axis == 0 { bits } else { bits.max(1) };
                assert_eq!((vector.width(), vector.bits()), (width, bits), "{vector}");
                assert_eq!(vector.coordinates(), coordinates);
                assert_eq!(vector.sign(axis), value.sign());
                if let Some(machine) = vector.to_i128() {
                    assert_eq!(Vector3::from_i128(machine), vector);
                }
                if let [Some(x), Some(y), Some(z)] = coordinates.each_ref().map(Integer::to_i64) {
                    assert_eq!(Vector3::from_i64([x, y, z]), vector);
                }
            }
        }
    }
    assert_eq!(Vector3::from_i128([i128::MIN, 0, 0]).width(), Width::Wide);
}

#[test]
fn arithmetic_agrees_with_integers_at_every_width() {
    let mut random = Random::new(10);
    for bits in WIDTHS {
        for other_bits in WIDTHS {
            for _ in 0..8 {
                let (a, b) = (random.vector(bits), random.vector(other_bits));
                let (p, q) = (a.coordinates(), b.coordinates());
                let pairs = |f: &dyn Fn(&Integer, &Integer) -> Integer| {
                    Vector3::new([0, 1, 2].map(|axis: usize| f(&p[axis], &q[axis])))
                };
                assert_eq!(&a + &b, pairs(&|x, y| x + y));
                assert_eq!(&a - &b, pairs(&|x, y| x - y));
                assert_eq!(-&a, Vector3::new(p.clone().map(|x| -x)));
                assert_eq!(a.dot(&b), &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]);
                assert_eq!(a.scaled(&q[0]), Vector3::new(p.clone().map(|x| x * &q[0])));
                let product = Vector3::new(crate::predicate::cross(p.clone(), q.clone()));
                let cross = a.cross(&b);
                if product.width() == Width::Wide {
                    assert_eq!(cross, product.primitive());
                } else {
                    assert_eq!(cross, product);
                }
                for vector in [&a, &cross, &(&a - &b), &-&b] {
                    assert_approximation(vector);
                }
            }
        }
    }
}

/// The cached floats and the cached length are those of the coordinates.
fn assert_approximation(vector: &Vector3) {
    for axis in 0..3 {
        assert_eq!(
            vector.approx_f64()[axis].to_bits(),
            vector.coordinate(axis).approx_f64().to_bits(),
            "{vector}"
        );
    }
    assert_eq!(vector.bits(), vector.coordinates().iter().map(Integer::bit_len).max().unwrap());
}

#[test]
fn a_primitive_vector_has_coprime_coordinates() {
    let mut random = Random::new(11);
    for bits in WIDTHS {
        for factor_bits in [1, 3, 40, 62, 100, 300] {
            let vector = random.vector(bits);
            let factor = random.integer(factor_bits).abs() + Integer::ONE;
            let primitive = vector.primitive();
            assert_eq!(vector.scaled(&factor).primitive(), primitive);
            assert_eq!((-&vector).primitive(), -&primitive);
            assert_approximation(&primitive);
            let [x, y, z] = primitive.coordinates();
            let divisor = x.gcd(&y).gcd(&z);
            assert!(divisor == Integer::ONE || (vector.is_zero() && primitive.is_zero()));
        }
    }
}

#[test]
fn equal_values_are_equal_whatever_made_them() {
    let mut random = Random::new(12);
    let mut seen = HashSet::new();
    for bits in WIDTHS {
        let (a, b) = (random.vector(bits), random.vector(bits));
        let again = &(&a + &b) - &b;
        assert_eq!(again, a);
        assert_eq!(again.width(), a.width());
        seen.insert(a);
        assert!(seen.contains(&again));
        assert!(again != &again + &Vector3::from_i64([0, 0, 1]));
    }
    let zero = &Vector3::from_i64([5, 6, 7]) - &Vector3::from_i64([5, 6, 7]);
    assert!(zero.is_zero() && !Vector3::from_i64([0, 0, 1]).is_zero());
    assert_eq!(std::mem::size_of::<Vector3>(), 80);
}
