use super::*;
use crate::testing::Random;
use crate::tier::{Start, force};
use crate::{Integer, Quaternion, Rational, Sign, Vector3};
use std::cmp::Ordering;

mod floats;
mod keys;
mod stages;

const ALL_STARTS: [Start; 5] = [Start::Usual, Start::Float, Start::Fixed, Start::Interval, Start::Big];

type Vector = [Integer; 3];

fn direction(coordinates: [i64; 3]) -> Direction {
    Direction::from_i64(coordinates).unwrap()
}

fn circle(normal: [i64; 3]) -> GreatCircle {
    GreatCircle::from_i64(normal).unwrap()
}

fn dot(a: &Vector, b: &Vector) -> Integer {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross([a, b, c]: &Vector, [d, e, f]: &Vector) -> Vector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn is_zero(vector: &Vector) -> bool {
    vector.iter().all(Integer::is_zero)
}

fn is_same(p: &Vector, q: &Vector) -> bool {
    is_zero(&cross(p, q)) && dot(p, q).sign() == Sign::Positive
}

/// The height as a signed square, in plain rationals.
fn height(p: &Vector) -> Rational {
    let square = Rational::new(&p[2] * &p[2], dot(p, p)).unwrap();
    if p[2].sign() == Sign::Negative { -square } else { square }
}

/// Longitude in the frame of a meridian: the part of the full turn, counted in half turns, and the coordinates in the frame.
fn longitude([x, y, _]: &Vector, [a, b, _]: &Vector) -> (i32, Integer, Integer) {
    let (along, across) = (x * a + y * b, y * a - x * b);
    let half = match (across.sign(), along.sign()) {
        (Sign::Zero, Sign::Zero) => 9,
        (Sign::Positive, _) | (Sign::Zero, Sign::Positive) => 0,
        _ => 1,
    };
    (half, along, across)
}

fn pole(p: &Vector) -> i32 {
    if p[0].is_zero() && p[1].is_zero() { p[2].sign() as i32 } else { 0 }
}

/// The order by longitude, poles first and last.
fn oracle_u(p: &Vector, q: &Vector, from: &Vector) -> Ordering {
    let ((half, a, b), (other_half, c, d)) = (longitude(p, from), longitude(q, from));
    pole(p).cmp(&pole(q)).then(half.cmp(&other_half)).then_with(|| (b * c).cmp(&(a * d)))
}

/// What a box promises.
fn assert_box(p: &Direction) {
    let multiple = p.multiple();
    let bits = multiple.iter().map(Integer::bit_len).max().unwrap();
    let shift = if matches!(p.repr, direction::Repr::Wide(_)) { bits.saturating_sub(62) } else { 0 };
    let scale = Rational::new(Integer::ONE, Integer::ONE << shift).unwrap();
    let bound = Rational::try_from(p.error).unwrap() * Rational::new(4.into(), 5.into()).unwrap();
    for (approx, exact) in p.approx.iter().zip(&multiple) {
        let error = (Rational::try_from(*approx).unwrap() - Rational::from(exact) * &scale).abs();
        assert!(error <= bound, "{p}: {approx:e} +- {:e}", p.error);
    }
    let unit = p.approx_f64();
    let length: f64 = unit.iter().map(|value| value * value).sum();
    assert!((length - 1.0).abs() < 1e-12, "{p}: {unit:?}");
}

/// How often keys were asked, and told something: that of which they tell nothing passes every check.
#[derive(Default, Debug)]
struct Told {
    points: u32,
    keys: u32,
    ranges: u32,
    sides: u32,
    known_sides: u32,
}

/// Checks every predicate on every pair, from every stage, against integers.
fn check(points: &[Direction], circles: &[GreatCircle], meridians: &[Meridian]) -> Told {
    let mut told = Told::default();
    let exact: Vec<Vector> = points.iter().map(Direction::coordinates).collect();
    let heights: Vec<Rational> = exact.iter().map(height).collect();
    points.iter().for_each(assert_box);
    for start in ALL_STARTS {
        let _guard = force(start);
        for (i, (p, x)) in points.iter().zip(&exact).enumerate() {
            for (axis, value) in x.iter().enumerate() {
                assert_eq!(coordinate_sign(p, axis), value.sign(), "{p}, {start:?}");
            }
            assert_eq!(p.pole_sign() as i32, pole(x), "{p}");
            for (j, (q, y)) in points.iter().zip(&exact).enumerate() {
                let product = cross(x, y);
                assert_eq!(turn(p, q), product[2].sign(), "{p}, {q}, {start:?}");
                assert_eq!(p == q, is_same(x, y), "{p}, {q}, {start:?}");
                let antipode = y.each_ref().map(|value| -value);
                assert_eq!(is_antipodal(p, q), is_same(x, &antipode), "{p}, {q}, {start:?}");
                let is_on_half =
                    product[2].is_zero() && (&x[0] * &y[0] + &x[1] * &y[1]).sign() != Sign::Negative;
                if is_on_half {
                    assert_eq!(compare_height(p, q), heights[i].cmp(&heights[j]), "{p}, {q}, {start:?}");
                }
            }
            for circle in circles {
                let sign = dot(x, &circle.coordinates()).sign();
                assert_eq!(side_of_circle(p, circle), sign, "{p}, {circle}, {start:?}");
                let by_key = side_of_key(p, &circle.side_key());
                assert!(by_key.is_none_or(|by_key| by_key == sign), "{p} by the key of {circle}, {start:?}");
                if !sign.is_zero() && matches!(start, Start::Usual | Start::Float) {
                    told.sides += 1;
                    told.known_sides += u32::from(by_key.is_some());
                }
                if circle.is_meridian() && sign.is_zero() {
                    let [a, b, _] = circle.coordinates();
                    let up = &x[1] * &a - &x[0] * &b;
                    assert_eq!(rises_at(p, circle), up.sign(), "{p}, {circle}, {start:?}");
                }
            }
        }
        for meridian in meridians {
            check_meridian(meridian, points, (&exact, &heights), circles, &mut told);
        }
        for m in circles {
            for n in circles {
                check_crossing(m, n);
            }
        }
    }
    told
}

fn check_crossing(m: &GreatCircle, n: &GreatCircle) {
    let product = cross(&m.coordinates(), &n.coordinates());
    assert_eq!(m.is_same_set(n), is_zero(&product));
    let Some(p) = Direction::crossing(m, n) else {
        return assert!(is_zero(&product), "{m}, {n}");
    };
    assert!(is_same(&p.coordinates(), &product), "{m}, {n}");
    assert_box(&p);
    for (p, sign) in [(&p, Sign::Positive), (&p.opposite(), Sign::Negative)] {
        assert_eq!(crossing_side(m, n, p), sign, "{m}, {n}");
        assert_eq!(crossing_side(n, m, p), -sign, "{m}, {n}");
        assert_eq!(crossing_side(n, n, p), Sign::Zero, "{m}, {n}");
        assert_eq!(crossing_side(n, &n.opposite(), p), Sign::Zero, "{m}, {n}");
    }
}

fn check_meridian(
    meridian: &Meridian,
    points: &[Direction],
    (exact, heights): (&[Vector], &[Rational]),
    circles: &[GreatCircle],
    told: &mut Told,
) {
    let from = meridian.direction().coordinates();
    assert_eq!(meridian.circle().ascending_node().as_ref(), Some(meridian.direction()));
    for (i, (p, x)) in points.iter().zip(exact).enumerate() {
        let is_on = pole(x) == 0 && oracle_u(x, &from, &from).is_eq();
        assert_eq!(meridian.contains(p), is_on, "{p} from {meridian:?}");
        let (key, (low, spread)) = (meridian.order_key(p), meridian.order_range(p));
        if !is_on && pole(x) == 0 {
            told.points += u32::from(!crate::stage::are_boxes_skipped());
            told.keys += u32::from(key != 0);
            told.ranges += u32::from(spread != u32::MAX);
        } else {
            assert_eq!((key, spread), (0, u32::MAX), "{p} from {meridian:?}");
        }
        for (j, (q, y)) in points.iter().zip(exact).enumerate() {
            let by_u = oracle_u(x, y, &from);
            assert_eq!(meridian.compare_u(p, q), by_u, "{p}, {q} from {meridian:?}");
            let by_uv = by_u.then_with(|| heights[i].cmp(&heights[j]));
            assert_eq!(meridian.compare_uv(p, q), by_uv, "{p}, {q} from {meridian:?}");
            let other = meridian.order_key(q);
            if key != 0 && other != 0 && key != other {
                assert_eq!(key.cmp(&other), by_uv, "{p}, {q} from {meridian:?}");
            }
            let (other_low, other_spread) = meridian.order_range(q);
            if spread != u32::MAX && other_spread != u32::MAX && other_low > low + u64::from(spread) {
                assert_eq!(by_uv, Ordering::Less, "{p}, {q} from {meridian:?}");
            }
        }
        let halves: Vec<_> = circles.iter().filter(|circle| circle.is_meridian()).collect();
        for half in &halves {
            let node = half.ascending_node().unwrap().coordinates();
            let by_u = oracle_u(x, &node, &from);
            assert_eq!(meridian.compare_u_to_half(p, half), by_u, "{p}, {half} from {meridian:?}");
        }
    }
    for m in circles.iter().filter(|circle| circle.is_meridian()) {
        for n in circles.iter().filter(|circle| circle.is_meridian()) {
            let [p, q] = [m, n].map(|circle| circle.ascending_node().unwrap().coordinates());
            assert_eq!(meridian.compare_u_of_halves(m, n), oracle_u(&p, &q, &from), "{m}, {n}");
        }
    }
}

fn meridians(horizontals: &[[i64; 2]]) -> Vec<Meridian> {
    horizontals.iter().map(|&[x, y]| Meridian::new([x.into(), y.into()]).unwrap()).collect()
}

/// All directions with coordinates up to a size, each once.
fn grid(size: i64) -> Vec<[i64; 3]> {
    let range = || -size..=size;
    let all = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    all.filter(|&p| circle::reduced(p) == Some(p)).collect()
}

/// A crossing, as it is kept, of two circles through a point; they are among those around vectors with small coordinates.
fn as_crossing(p: [i64; 3], random: &mut Random) -> Direction {
    let _guard = force(Start::Fixed);
    loop {
        let through = |random: &mut Random| {
            let other = [(); 3].map(|()| random.around_zero(3));
            GreatCircle::through(&direction(p), &Direction::from_i64(other)?)
        };
        if let (Some(m), Some(n)) = (through(random), through(random))
            && let Some(crossing) = Direction::crossing(&m, &n)
        {
            return if crossing == direction(p) { crossing } else { crossing.opposite() };
        }
    }
}

#[test]
fn small_directions_agree_with_integers_in_every_form() {
    let mut random = Random::new(71);
    let mut points: Vec<_> = grid(2).into_iter().map(direction).collect();
    let crossings = grid(1).into_iter().chain([[1, 2, 0], [-1, 2, 2], [2, 0, 1], [-2, 0, -1]]);
    points.extend(crossings.map(|p| as_crossing(p, &mut random)));
    let kept = points.iter().filter(|p| !p.is_explicit()).count();
    assert!(kept > 20, "{kept} crossings: poles are explicit");
    let circles: Vec<_> = grid(1).into_iter().map(circle).collect();
    let told = check(&points, &circles, &meridians(&[[-1, 0], [0, 1], [1, 1], [2, -1]]));
    assert!(told.keys * 20 > told.points * 19 && told.ranges * 20 > told.points * 19, "{told:?}");
    assert!(told.known_sides * 100 > told.sides * 99, "{told:?}");
}

#[test]
fn random_directions_agree_with_integers_at_every_width() {
    let mut random = Random::new(72);
    for bits in [3, 8, 20, 29, 30, 31, 32, 40, 41, 42, 53, 60, 61, 62, 63, 64, 100, 200, 1100] {
        let mut points: Vec<_> =
            (0..7).filter_map(|_| Direction::new([(); 3].map(|()| random.integer(bits)))).collect();
        let mut circles: Vec<_> =
            points.windows(2).filter_map(|pair| GreatCircle::through(&pair[0], &pair[1])).collect();
        circles.extend((0..3).filter_map(|_| GreatCircle::new(&random.vector(bits))));
        let flat = |random: &mut Random| [random.integer(bits), random.integer(bits), Integer::ZERO];
        circles.extend((0..3).filter_map(|_| GreatCircle::new(&Vector3::new(flat(&mut random)))));
        let crossings: Vec<_> = circles
            .iter()
            .enumerate()
            .flat_map(|(i, m)| circles[..i].iter().filter_map(|n| Direction::crossing(m, n)))
            .collect();
        points.extend(crossings);
        points.extend(points[..3].to_vec().iter().map(Direction::opposite));
        let own: Vec<_> = (0..2)
            .filter_map(|_| Meridian::new([random.integer(bits), random.integer(bits)]))
            .chain([Meridian::default()])
            .collect();
        let told = check(&points, &circles, &own);
        assert!(told.known_sides * 2 > told.sides && told.ranges * 2 > told.points, "{bits} bits: {told:?}");
    }
}

/// Circles through one point, and circles that miss it by a little.
#[test]
fn circles_through_a_point_and_near_it() {
    let mut random = Random::new(73);
    for bits in [4, 14, 20, 29, 58] {
        for miss in [0, 1] {
            let center = [(); 3].map(|()| random.around_zero((1 << bits) - 1));
            let Some(center) = Direction::from_i64(center) else { continue };
            let circles: Vec<_> = (0..6)
                .filter_map(|_| {
                    let other = direction([random.around_zero(3), random.around_zero(3), 4]);
                    let circle = GreatCircle::through(&center, &other)?;
                    let moved =
                        circle.coordinates().map(|value| value + Integer::from(random.around_zero(miss)));
                    GreatCircle::new(&Vector3::new(moved))
                })
                .collect();
            let mut points = vec![center.clone(), center.opposite()];
            for (i, m) in circles.iter().enumerate() {
                points.extend(circles[..i].iter().filter_map(|n| Direction::crossing(m, n)));
            }
            let flat = meridians(&[[-1, 0], [3, 2]]);
            let through_center = center.coordinates();
            let own = Meridian::new([through_center[0].clone(), through_center[1].clone()]);
            check(&points, &circles, &flat.into_iter().chain(own).collect::<Vec<_>>());
        }
    }
}

#[test]
fn extreme_coordinates() {
    let values = [0, 1, -1, i64::MIN, i64::MAX, 1 << 62, (1 << 62) - 1, -(1 << 61), (1 << 53) + 1];
    let all: Vec<[i64; 3]> = (0..60)
        .map(|i: usize| [values[i % 9], values[(i * 5 + i / 9) % 9], values[(i * 7 + i / 4) % 9]])
        .filter(|p| *p != [0; 3])
        .collect();
    let points: Vec<_> = all.iter().map(|&p| direction(p)).collect();
    let circles: Vec<_> = all.iter().step_by(4).map(|&n| circle(n)).collect();
    check(&points[..30], &circles, &meridians(&[[i64::MIN, 1], [i64::MAX, i64::MIN]]));
    assert_eq!(direction([i64::MIN, 0, 0]).to_string(), "(-1, 0, 0)");
    assert_eq!(direction([i64::MIN; 3]), direction([-1; 3]));
    assert_eq!(circle([i64::MIN, 0, i64::MIN]).to_string(), "(-1, 0, -1)");
    assert!(Direction::from_i64([0; 3]).is_none() && GreatCircle::from_i64([0; 3]).is_none());
    assert!(Direction::new([(); 3].map(|()| Integer::ZERO)).is_none());
    assert!(Meridian::new([Integer::ZERO, Integer::ZERO]).is_none());
}

#[test]
fn circles_have_one_form() {
    let mut random = Random::new(74);
    for bits in [3, 20, 31, 32, 61, 62, 63, 150] {
        for _ in 0..30 {
            let [p, q] = [(); 2].map(|()| [(); 3].map(|()| random.integer(bits)));
            let (Some(p), Some(q)) = (Direction::new(p), Direction::new(q)) else { continue };
            let product = cross(&p.coordinates(), &q.coordinates());
            let Some(circle) = GreatCircle::through(&p, &q) else {
                assert!(is_zero(&product));
                continue;
            };
            let [x, y, z] = circle.coordinates();
            assert_eq!(x.gcd(&y).gcd(&z), Integer::ONE, "{circle}");
            assert!(is_same(&[x, y, z], &product));
            assert_eq!(GreatCircle::new(&Vector3::new(product)), Some(circle.clone()));
            assert_eq!(circle.opposite().opposite(), circle);
            assert_eq!(GreatCircle::through(&q, &p), Some(circle.opposite()));
            assert_eq!(circle.normal(), circle.pole().vector());
            assert_eq!(circle.is_meridian(), circle.coordinates()[2].is_zero());
            assert!(GreatCircle::through(&p, &p.opposite()).is_none());
        }
    }
}

#[test]
fn the_order_around_a_circle() {
    for start in ALL_STARTS {
        let _guard = force(start);
        for normal in [[0, 0, 1], [0, 0, -1], [1, -1, 0], [1, 2, -3]] {
            let circle = circle(normal);
            // Sixteen points or less, counterclockwise from one of them.
            let mut on: Vec<_> =
                grid(3).into_iter().map(direction).filter(|p| side_of_circle(p, &circle).is_zero()).collect();
            let first = on.swap_remove(0);
            on.sort_by(|p, q| match is_between(&circle, &first, p, q) {
                true => Ordering::Less,
                false => is_between(&circle, &first, q, p).cmp(&false),
            });
            on.insert(0, first);
            for i in 0..on.len() {
                for j in 0..on.len() {
                    for k in 0..on.len() {
                        // The steps from i; none to i itself means the whole circle.
                        let steps = |j: usize| match (j + on.len() - i) % on.len() {
                            0 => on.len(),
                            steps => steps,
                        };
                        let expected = j != i && j != k && steps(j) < steps(k);
                        assert_eq!(
                            is_between(&circle, &on[i], &on[j], &on[k]),
                            expected,
                            "{circle}: {i} {j} {k}"
                        );
                    }
                }
            }
            // That they are counterclockwise: neighbours turn by less than half a circle.
            for pair in on.windows(2) {
                let product = cross(&pair[0].coordinates(), &pair[1].coordinates());
                assert!(dot(&product, &circle.coordinates()).sign() == Sign::Positive, "{circle}");
            }
        }
    }
}

#[test]
fn rotations_keep_predicates() {
    let mut random = Random::new(75);
    let rotations: Vec<_> = (0..6)
        .filter_map(|i| Quaternion::new([(); 4].map(|()| random.around_zero(1 << (3 * i)).into())))
        .collect();
    let circles: Vec<_> = grid(1).into_iter().step_by(3).map(circle).collect();
    let _guard = force(Start::Fixed);
    let mut points: Vec<_> = grid(1).into_iter().map(direction).collect();
    points.extend(circles.windows(2).filter_map(|pair| Direction::crossing(&pair[0], &pair[1])));
    for rotation in &rotations {
        for p in &points {
            let moved = p.turned(rotation);
            assert_box(&moved);
            for q in &points {
                assert_eq!(moved == q.turned(rotation), p == q);
                assert_eq!(is_antipodal(&moved, &q.turned(rotation)), is_antipodal(p, q));
            }
            for circle in &circles {
                assert_eq!(side_of_circle(&moved, &circle.turned(rotation)), side_of_circle(p, circle));
            }
        }
    }
    let quarter = Quaternion::new([1, 0, 0, 1].map(Integer::from)).unwrap();
    assert_eq!(direction([1, 0, 5]).turned(&quarter), direction([0, 1, 5]));
}

#[test]
fn directions_and_circles_are_small_and_can_be_sent() {
    fn sent<T: Clone + Send + Sync + std::fmt::Debug>() {}
    sent::<Direction>();
    sent::<GreatCircle>();
    sent::<Meridian>();
    assert!(size_of::<Direction>() <= 96 && size_of::<GreatCircle>() <= 32);
}
