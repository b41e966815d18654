use super::*;
use crate::Integer;
use crate::testing::Random;

fn random<const N: usize>(random: &mut Random) -> Fixed<N> {
    const EXTREMES: [u64; 6] = [0, 1, 2, u64::MAX, 1 << 63, (1 << 63) - 1];
    let kind = random.below(3);
    Fixed([(); N].map(|()| match kind {
        0 => random.next(),
        1 => EXTREMES[random.below(6) as usize],
        _ => [0, u64::MAX][random.below(2) as usize],
    }))
}

/// One sign bit and two bits to spare, so that sums of two do not overflow.
fn halved<const N: usize>(mut value: Fixed<N>) -> Fixed<N> {
    let top = value.0[N - 1] as i64;
    value.0[N - 1] = (top >> 2) as u64;
    value
}

fn check_product<const A: usize, const B: usize, const P: usize>(generator: &mut Random)
where
    Fixed<A>: Mul<Fixed<B>, Output = Fixed<P>>,
{
    for _ in 0..2000 {
        let (a, b) = (random::<A>(generator), random::<B>(generator));
        assert_eq!(Integer::from(&(a * b)), Integer::from(&a) * Integer::from(&b), "{a} * {b}");
    }
}

#[test]
fn products_of_all_widths_are_exact() {
    let mut random = Random::new(5);
    check_product::<1, 1, 2>(&mut random);
    check_product::<2, 1, 3>(&mut random);
    check_product::<1, 2, 3>(&mut random);
    check_product::<2, 2, 4>(&mut random);
    check_product::<3, 1, 4>(&mut random);
    check_product::<4, 1, 5>(&mut random);
    check_product::<3, 2, 5>(&mut random);
    check_product::<5, 1, 6>(&mut random);
    check_product::<4, 2, 6>(&mut random);
    check_product::<3, 3, 6>(&mut random);
}

fn check_sums<const N: usize>(generator: &mut Random) {
    for _ in 0..2000 {
        let (a, b) = (halved(random::<N>(generator)), halved(random::<N>(generator)));
        let (x, y) = (Integer::from(&a), Integer::from(&b));
        assert_eq!(Integer::from(&(a + b)), &x + &y, "{a} + {b}");
        assert_eq!(Integer::from(&(a - b)), &x - &y, "{a} - {b}");
        assert_eq!(Integer::from(&-a), -&x);
        assert_eq!(a.sign(), x.sign());
        let same = a;
        assert_eq!((a - same).sign(), Sign::Zero);
    }
}

#[test]
fn sums_negations_and_signs_are_exact() {
    let mut random = Random::new(6);
    check_sums::<1>(&mut random);
    check_sums::<2>(&mut random);
    check_sums::<3>(&mut random);
    check_sums::<4>(&mut random);
    check_sums::<5>(&mut random);
    check_sums::<6>(&mut random);
}

#[test]
fn machine_integers_come_in_unchanged() {
    for value in [0, 1, -1, i64::MAX, i64::MIN] {
        assert_eq!(Fixed::<1>::from(value).to_string(), value.to_string());
        assert_eq!(Fixed::<2>::from(value).to_string(), value.to_string());
    }
    for value in [0, -1, i128::MAX, i128::MIN, i128::from(i64::MIN) - 1, 1 << 64] {
        assert_eq!(Fixed::<2>::from(value).to_string(), value.to_string());
    }
}
