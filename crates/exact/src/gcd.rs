//! Greatest common divisors of machine integers, by halving and subtracting (no division).

/// The greatest common divisor; `gcd(0, n) = n`.
pub(crate) fn gcd_u64(mut a: u64, mut b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    while b != 0 {
        b >>= b.trailing_zeros();
        let difference = a.abs_diff(b);
        a = a.min(b);
        b = difference;
    }
    a << shift
}

/// The greatest common divisor; `gcd(0, n) = n`. Goes on in one word as soon as both fit.
pub(crate) fn gcd_u128(mut a: u128, mut b: u128) -> u128 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let shift = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while (a | b) >> 64 != 0 {
        if a.min(b) >> 64 == 0 {
            // One division saves up to 64 steps, and leaves one word.
            let small = a.min(b);
            let rest = a.max(b) % small;
            return u128::from(gcd_u64(small as u64, rest as u64)) << shift;
        }
        let difference = a.abs_diff(b);
        if difference == 0 {
            return a << shift;
        }
        a = a.min(b);
        b = difference >> difference.trailing_zeros();
    }
    u128::from(gcd_u64(a as u64, b as u64)) << shift
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn machine_gcds_agree_with_euclid() {
        let euclid = |mut a: u128, mut b: u128| {
            while b != 0 {
                (a, b) = (b, a % b);
            }
            a
        };
        let values =
            [0, 1, 2, 3, 12, 18, 97, 1 << 40, (1 << 40) * 3, u64::MAX as u128, 6 << 100, 15 << 90, u128::MAX];
        for a in values {
            for b in values {
                assert_eq!(gcd_u128(a, b), euclid(a, b), "{a} {b}");
                if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
                    assert_eq!(u128::from(gcd_u64(a, b)), euclid(a.into(), b.into()), "{a} {b}");
                }
            }
        }
    }
}
