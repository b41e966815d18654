//! The families of the plane, carried over by central projection: what is straight there is an arc here.

use crate::arcs::Curve;
use crate::curves::{self, Shape};
use crate::families::Row;
use crate::space::{Matrix, P, image, matrix, opposite};
use exact::{Integer, Rational};

/// The direction of a point at a height above a center.
fn lift([x, y]: &curves::P, [a, b]: &curves::P, height: i64) -> P {
    let (x, y) = (x - a, y - b);
    let weight = x.denominator() * y.denominator();
    [x.numerator() * y.denominator(), y.numerator() * x.denominator(), weight * Integer::from(height)]
}

/// The curve on the sphere; lines are half circles, and rays end on the horizon.
fn carried(curve: &curves::Curve, center: &curves::P, height: i64, map: &Matrix) -> Curve {
    let place = |p: &curves::P| image(map, &lift(p, center, height));
    match curve {
        curves::Curve::Point(p) => Curve::Point(place(p)),
        curves::Curve::Straight(Shape::Segment, [p, q]) => Curve::Short(place(p), place(q)),
        curves::Curve::Straight(shape, [p, q]) => {
            let [x, y] = [0, 1].map(|i| &q[i] - &p[i]);
            let to = image(map, &lift(&[x, y], &[Rational::ZERO, Rational::ZERO], 0));
            match shape {
                Shape::Line => Curve::Via(opposite(&to), place(p), to),
                _ => Curve::Short(place(p), to),
            }
        }
    }
}

/// Where the plane touches the sphere: at a pole, on the identification, and elsewhere; and how high.
fn placements() -> [(i64, Matrix); 4] {
    [
        (4, matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])),
        (3, matrix([[0, 0, -1], [-1, 0, 0], [0, 1, 0]])),
        (-5, matrix([[0, 1, 0], [1, 0, 0], [0, 0, 1]])),
        (2, matrix([[1, 2, 0], [-1, 1, 3], [2, 0, 1]])),
    ]
}

/// All rows of the plane, about one of the points from which they are drawn, at all placements.
pub(crate) fn all_rows() -> Vec<Row> {
    placements().iter().flat_map(carried_rows).collect()
}

fn carried_rows((height, map): &(i64, Matrix)) -> Vec<Row> {
    let zero = [Rational::ZERO, Rational::ZERO];
    let carry = |row: crate::rows::Row| {
        let center = match row.curves.first() {
            None => zero.clone(),
            Some(curves::Curve::Point(p) | curves::Curve::Straight(_, [p, _])) => p.clone(),
        };
        let are_bounded = row.curves.iter().all(curves::Curve::is_bounded);
        let curves: Vec<Curve> =
            row.curves.iter().map(|curve| carried(curve, &center, *height, map)).collect();
        let counts = if are_bounded { row.counts } else { counts_of(&curves) };
        Row { name: format!("{}, from the plane at {height}", row.name), curves, counts }
    };
    crate::rows::rows().into_iter().map(carry).collect()
}

/// Those that are found: lines end on the horizon, where they do not in the plane.
fn counts_of(curves: &[Curve]) -> [usize; 5] {
    let counts = crate::cube::counts(curves);
    [counts.vertices, counts.edges, counts.faces, counts.isolated, counts.components]
}
