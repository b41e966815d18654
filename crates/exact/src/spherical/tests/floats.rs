//! The floats of vectors whose coordinates differ much in size.

use super::*;

/// Bits of the greatest coordinate: around what machine words and floats hold, and far beyond.
const BITS: [u32; 10] = [63, 64, 126, 127, 200, 1022, 1023, 1024, 1025, 1500];

/// Coprime coordinates of a few bits, and then one with many.
fn uneven(bits: u32, [a, b]: [i64; 2]) -> [Vector; 3] {
    let great = || (Integer::ONE << (bits - 1)) + Integer::ONE;
    let [a, b] = [a, b].map(Integer::from);
    [[a.clone(), b.clone(), great()], [a.clone(), -great(), b.clone()], [-great(), a, b]]
}

#[test]
fn every_float_is_the_nearest_to_its_coordinate() {
    for bits in BITS {
        for vector in [[1, 0], [-3, 4], [(1 << 60) + 1, 1], [i64::MIN, 7]].map(|small| uneven(bits, small)) {
            for coordinates in vector {
                let p = Direction::new(coordinates.clone()).unwrap();
                assert_box(&p);
                let shift = coordinates.iter().map(Integer::bit_len).max().unwrap() - 62;
                let scale = Rational::new(Integer::ONE, Integer::ONE << shift).unwrap();
                let nearest =
                    coordinates.each_ref().map(|value| (Rational::from(value) * &scale).approx_f64());
                assert_eq!(p.approx, nearest, "{bits} bits: {p:?}");
                let circle = GreatCircle::new(&Vector3::new(coordinates)).unwrap();
                assert_eq!(circle.approx_box(), (nearest, p.error), "{bits} bits: {circle:?}");
                assert_eq!(circle.opposite().approx_box().0, nearest.map(|value| -value));
            }
        }
    }
}

/// A picture draws a point beside a pole where it is.
#[test]
fn points_beside_a_pole_have_their_longitudes() {
    let meridians = meridians(&[[-1, 0], [2, -7]]);
    for bits in BITS.into_iter().filter(|bits| *bits < 1100) {
        for [x, y] in [[1, 0], [0, -1], [3, 4], [-3, 4], [-5, -12], [1, -1]] {
            let [up, ..] = uneven(bits, [x, y]);
            let down = [up[0].clone(), up[1].clone(), -&up[2]];
            let on_equator = direction([x, y, 0]);
            for meridian in &meridians {
                let [expected, _] = meridian.approx_f64(&on_equator);
                for (beside, pole) in [(&up, Direction::NORTH), (&down, Direction::SOUTH)] {
                    let [u, v] = meridian.approx_f64(&Direction::new(beside.clone()).unwrap());
                    assert!((u - expected).abs() < 1e-14, "{bits} bits, {x} {y}: {u}, not {expected}");
                    assert!((v - meridian.approx_f64(&pole)[1]).abs() < 1e-14, "{bits} bits, {x} {y}: {v}");
                }
            }
        }
    }
}

#[test]
fn uneven_coordinates_agree_with_integers() {
    for bits in [63, 130, 1000, 1100, 2300] {
        let vectors: Vec<Vector> =
            [[1, 0], [-3, 4]].into_iter().flat_map(|pair| uneven(bits, pair)).collect();
        let mut points: Vec<_> = vectors.iter().cloned().map(|p| Direction::new(p).unwrap()).collect();
        points.extend(points.clone().iter().map(Direction::opposite));
        points.extend([[1, 0, 0], [-3, 4, 0], [0, 0, 1], [4, 3, -2]].map(direction));
        let mut circles: Vec<_> =
            vectors.iter().map(|n| GreatCircle::new(&Vector3::new(n.clone())).unwrap()).collect();
        circles.extend([[0, 0, 1], [4, 3, 0], [1, 1, 1]].map(circle));
        points.extend(circles.windows(2).filter_map(|pair| Direction::crossing(&pair[0], &pair[1])));
        let wide = [Integer::ONE << bits, Integer::from(-3)];
        let own: Vec<_> = meridians(&[[-1, 0], [3, -4]]).into_iter().chain(Meridian::new(wide)).collect();
        check(&points, &circles, &own);
    }
}
