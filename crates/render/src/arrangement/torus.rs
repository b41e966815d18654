//! Faces of a flat torus, unrolled into the plane.
//!
//! A face of a torus has either no CCB around the torus, and its CCBs are closed when unrolled; or two, which run around in
//! opposite directions, and the face is a strip. Of such a strip one period is made: along one of the CCBs, across, back along
//! the other, and across where the period began. Copies of it fit together at the cuts.
//!
//! Across to which copy of the other one? From one copy to the next the area grows by that of the torus, so exactly one of the
//! areas is the right one: positive, and at most that of the torus.

use crate::frame::{Frame, Point};

/// At most so many copies of a ring are made along each axis, and a CCB goes around at most so often.
const MANY: f64 = 100.0;

/// A CCB in the plane.
#[derive(Clone, Debug)]
pub(super) struct Unrolled {
    points: Vec<Point>,
    /// How often it goes around along each axis before it is back.
    turns: [f64; 2],
}

fn periods(rectangle: &Frame) -> [f64; 2] {
    [0, 1].map(|axis| rectangle.max()[axis] - rectangle.min()[axis])
}

/// Joins chains to one that does not jump at the seams.
pub(super) fn unroll(chains: impl IntoIterator<Item = Vec<Point>>, rectangle: &Frame) -> Unrolled {
    let periods = periods(rectangle);
    let turns_between =
        |from: Point, to: Point| {
            [0, 1].map(|axis| {
                if periods[axis] > 0.0 { ((from[axis] - to[axis]) / periods[axis]).round() } else { 0.0 }
            })
        };
    let mut points: Vec<Point> = Vec::new();
    for chain in chains {
        let turns = match (points.last(), chain.first()) {
            (Some(&last), Some(&first)) => turns_between(last, first),
            _ => [0.0; 2],
        };
        points.extend(chain.into_iter().map(|point| moved(point, turns, periods)));
    }
    let turns = match (points.first(), points.last()) {
        (Some(&first), Some(&last)) => turns_between(last, first),
        _ => [0.0; 2],
    };
    Unrolled { points, turns }
}

fn moved(point: Point, turns: [f64; 2], periods: [f64; 2]) -> Point {
    [point[0] + turns[0] * periods[0], point[1] + turns[1] * periods[1]]
}

/// The rings that enclose a face with these CCBs by the even-odd rule, with all copies that meet the rectangle. `None` if the
/// CCBs are not those of a face of a torus, or go around too often.
pub(super) fn rings(ccbs: Vec<Unrolled>, rectangle: &Frame) -> Option<Vec<Vec<Point>>> {
    let (closed, around): (Vec<Unrolled>, Vec<Unrolled>) =
        ccbs.into_iter().partition(|ccb| ccb.turns.iter().all(|t| t.abs() < 0.5));
    let mut rings: Vec<Vec<Point>> = closed.into_iter().map(|ccb| ccb.points).collect();
    match around.as_slice() {
        [] => {}
        [first, second] => rings.push(strip(first, second, periods(rectangle))?),
        _ => return None,
    }
    Some(rings.iter().flat_map(|ring| copies(ring, rectangle)).collect())
}

/// One period of the face between two CCBs that go around in opposite directions.
fn strip(first: &Unrolled, second: &Unrolled, periods: [f64; 2]) -> Option<Vec<Point>> {
    let [a, b] = first.turns;
    if a.abs() > MANY || b.abs() > MANY {
        return None;
    }
    let joined = |turns: [f64; 2]| -> Vec<Point> {
        let back = second.points.iter().map(|&point| moved(point, turns, periods));
        first.points.iter().copied().chain(back).collect()
    };
    let torus = periods[0] * periods[1];
    let [i, j] = step_across(a as i64, b as i64)?.map(|c| c as f64);
    // The least number of steps that makes the area positive; an area that is zero but for rounding is that of the torus.
    let steps = (1e-9 - area(&joined([0.0; 2])) / torus).ceil();
    Some(joined([steps * i, steps * j]))
}

/// Integers `i`, `j` with `a j - b i = 1`; `None` if there are none.
fn step_across(a: i64, b: i64) -> Option<[i64; 2]> {
    let (mut r, mut s, mut t) = ([a, b], [1, 0], [0, 1]);
    while r[1] != 0 {
        let q = r[0] / r[1];
        r = [r[1], r[0] - q * r[1]];
        s = [s[1], s[0] - q * s[1]];
        t = [t[1], t[0] - q * t[1]];
    }
    // Now a s + b t is the greatest common divisor, up to its sign.
    (r[0].abs() == 1).then(|| [-t[0] * r[0], s[0] * r[0]])
}

fn area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// The copies of a ring that meet the rectangle.
fn copies(ring: &[Point], rectangle: &Frame) -> Vec<Vec<Point>> {
    let Some(bounds) = Frame::around(ring.iter().copied()) else { return Vec::new() };
    let periods = periods(rectangle);
    let range = |axis: usize| {
        let (low, high) = (rectangle.min()[axis], rectangle.max()[axis]);
        if periods[axis] <= 0.0 {
            return vec![0.0];
        }
        let first = ((low - bounds.max()[axis]) / periods[axis]).ceil().max(-MANY);
        let last = ((high - bounds.min()[axis]) / periods[axis]).floor().min(MANY);
        std::iter::successors(Some(first), |step| Some(step + 1.0)).take_while(|&step| step <= last).collect()
    };
    let (us, vs): (Vec<f64>, Vec<f64>) = (range(0), range(1));
    us.iter()
        .flat_map(|&u| vs.iter().map(move |&v| [u, v]))
        .map(|turns| ring.iter().map(|&point| moved(point, turns, periods)).collect())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clip::clip_ring;

    fn torus() -> Frame {
        Frame::new([1.0, 2.0], [5.0, 4.0]).unwrap()
    }

    /// The area of the face in the rectangle.
    fn filled(ccbs: Vec<Vec<Vec<Point>>>) -> f64 {
        let torus = torus();
        let ccbs = ccbs.into_iter().map(|chains| unroll(chains, &torus)).collect();
        let rings = rings(ccbs, &torus).expect("CCBs of a face");
        rings.iter().map(|ring| area(&clip_ring(&torus, ring))).sum()
    }

    fn turned(chains: &[Vec<Point>]) -> Vec<Vec<Point>> {
        chains.iter().rev().map(|chain| chain.iter().rev().copied().collect()).collect()
    }

    #[test]
    fn steps_across_are_found() {
        for (a, b) in [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 5), (-7, 4), (2, -3), (1, 1)] {
            let [i, j] = step_across(a, b).unwrap();
            assert_eq!(a * j - b * i, 1, "{a} {b}");
        }
        assert_eq!(step_across(2, 4), None);
    }

    #[test]
    fn a_square_over_the_corner_is_whole() {
        // From -0.5 to 0.5 around the corner, in four parts.
        let chains = vec![
            vec![[4.5, 3.5], [5.0, 3.5]],
            vec![[1.0, 3.5], [1.5, 3.5], [1.5, 4.0]],
            vec![[1.5, 2.0], [1.5, 2.5], [1.0, 2.5]],
            vec![[5.0, 2.5], [4.5, 2.5], [4.5, 2.0]],
            vec![[4.5, 4.0], [4.5, 3.5]],
        ];
        assert!((filled(vec![chains.clone()]) - 1.0).abs() < 1e-9);
        let rectangle = [torus().corners().to_vec()];
        let outside = rings(vec![unroll(turned(&chains), &torus())], &torus()).unwrap();
        let hole: f64 = outside.iter().map(|ring| area(&clip_ring(&torus(), ring))).sum();
        assert!((area(&rectangle[0]) + hole - 7.0).abs() < 1e-9);
    }

    #[test]
    fn strips_are_between_their_ccbs() {
        let level = |v: f64| vec![vec![[1.0, v], [3.0, v + 0.1], [5.0, v]]];
        // Counterclockwise around the strip: to the right below, to the left above.
        for (below, above, area) in [(2.5, 3.0, 2.0), (3.5, 2.5, 4.0), (2.5, 2.5, 8.0)] {
            let found = filled(vec![level(below), turned(&level(above))]);
            assert!((found - area).abs() < 1e-9, "{below} {above}: {found}");
            let found = filled(vec![turned(&level(above)), level(below)]);
            assert!((found - area).abs() < 1e-9, "{below} {above}, exchanged: {found}");
        }
    }

    #[test]
    fn a_diagonal_leaves_one_strip() {
        let diagonal = vec![vec![[1.0, 3.0], [3.0, 4.0]], vec![[3.0, 2.0], [5.0, 3.0]]];
        assert!((filled(vec![diagonal.clone(), turned(&diagonal)]) - 8.0).abs() < 1e-9);
    }
}
