//! Solids made by formula, for measurements: exact coordinates over one denominator, and their text.

use std::collections::HashMap;
use std::fmt::Write as _;

/// A solid with the coordinates `points[i] / denominator`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Solid {
    pub(crate) points: Vec<[i128; 3]>,
    pub(crate) denominator: i128,
    pub(crate) facets: Vec<Vec<usize>>,
}

/// The rotation used for every "turned" operand: a quaternion w, x, y, z far from all symmetries of the sphere.
pub(crate) const TURN: [i128; 4] = [5, 1, 2, 3];

/// A rotation about the z axis alone, by an angle that is no multiple of the angle of any polygon used here.
pub(crate) const TURN_ABOUT_Z: [i128; 4] = [5, 0, 0, 1];

/// Decimals of the coordinates of [`geodesic_sphere`].
const SPHERE_SCALE: i128 = 1_000_000_000_000;

/// The faces of the icosahedron over the corners `(0, ±1, ±φ)` and its cyclic shifts.
const ICOSAHEDRON: [[usize; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// The class I geodesic sphere: every edge of the icosahedron in `frequency` parts, corners lifted to the unit sphere and
/// rounded to twelve decimals. It has `10 f² + 2` vertices and is convex for every frequency used here.
pub(crate) fn geodesic_sphere(frequency: usize) -> Solid {
    let golden = f64::midpoint(1.0, 5_f64.sqrt());
    let radius = (1.0 + golden * golden).sqrt();
    let (s, g) = (1.0 / radius, golden / radius);
    let corners = [
        [-s, g, 0.0],
        [s, g, 0.0],
        [-s, -g, 0.0],
        [s, -g, 0.0],
        [0.0, -s, g],
        [0.0, s, g],
        [0.0, -s, -g],
        [0.0, s, -g],
        [g, 0.0, -s],
        [g, 0.0, s],
        [-g, 0.0, -s],
        [-g, 0.0, s],
    ];
    let mut known: HashMap<[i128; 3], usize> = HashMap::new();
    let mut solid = Solid { points: Vec::new(), denominator: SPHERE_SCALE, facets: Vec::new() };
    for [a, b, c] in ICOSAHEDRON {
        let mut row_starts = Vec::new();
        let mut indices = Vec::new();
        for i in 0..=frequency {
            row_starts.push(indices.len());
            for j in 0..=frequency - i {
                let weights = [frequency - i - j, i, j].map(|w| w as f64);
                let blend = |axis: usize| {
                    let sum = corners[a][axis] * weights[0]
                        + corners[b][axis] * weights[1]
                        + corners[c][axis] * weights[2];
                    sum / frequency as f64
                };
                let point = on_sphere([blend(0), blend(1), blend(2)]);
                let next = solid.points.len();
                let index = *known.entry(point).or_insert(next);
                if index == next {
                    solid.points.push(point);
                }
                indices.push(index);
            }
        }
        let at = |i: usize, j: usize| indices[row_starts[i] + j];
        for i in 0..frequency {
            for j in 0..frequency - i {
                solid.facets.push(vec![at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < frequency {
                    solid.facets.push(vec![at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    solid
}

/// The point on the unit sphere in that direction, rounded to twelve decimals as printing does it.
fn on_sphere(direction: [f64; 3]) -> [i128; 3] {
    let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    direction.map(|x| {
        let digits: String = format!("{:.12}", x / length).chars().filter(|&c| c != '.').collect();
        digits.parse().expect("a sign and digits")
    })
}

/// The bipyramid over an n-gon with integer coordinates of 40 bits; enough for a strictly convex polygon of 10^5 corners.
pub(crate) fn bipyramid(n: usize) -> Solid {
    let radius = (1_u64 << 40) as f64;
    let corner = |k: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
        [(radius * cosine).round() as i128, (radius * sine).round() as i128, 0]
    };
    let mut points: Vec<[i128; 3]> = (0..n).map(corner).collect();
    points.extend([[0, 0, 1 << 40], [0, 0, -(1 << 40)]]);
    let sides = (0..n).flat_map(|k| {
        let next = (k + 1) % n;
        [vec![k, next, n], vec![next, k, n + 1]]
    });
    Solid { points, denominator: 1, facets: sides.collect() }
}

impl Solid {
    /// The solid turned exactly by the integer quaternion w, x, y, z.
    pub(crate) fn turned(&self, [w, x, y, z]: [i128; 4]) -> Solid {
        let rows = [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ];
        let turn = |p: &[i128; 3]| rows.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2]);
        Solid {
            points: self.points.iter().map(turn).collect(),
            denominator: self.denominator * (w * w + x * x + y * y + z * z),
            facets: self.facets.clone(),
        }
    }

    /// The solid as an OFF file with coordinates `p/q` in lowest terms.
    pub(crate) fn off(&self) -> String {
        let mut text = format!("OFF\n{} {} 0\n", self.points.len(), self.facets.len());
        for point in &self.points {
            let words = point.map(|x| {
                let divisor = gcd(x.unsigned_abs(), self.denominator.unsigned_abs()).cast_signed();
                match self.denominator / divisor {
                    1 => (x / divisor).to_string(),
                    q => format!("{}/{q}", x / divisor),
                }
            });
            text += &words.join(" ");
            text.push('\n');
        }
        for facet in &self.facets {
            write!(text, "{}", facet.len()).expect("writing to a string succeeds");
            for index in facet {
                write!(text, " {index}").expect("writing to a string succeeds");
            }
            text.push('\n');
        }
        text
    }
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_follow_euler() {
        for (solid, vertices, facets) in [
            (geodesic_sphere(1), 12, 20),
            (geodesic_sphere(4), 162, 320),
            (geodesic_sphere(16), 2562, 5120),
            (bipyramid(7), 9, 14),
        ] {
            assert_eq!((solid.points.len(), solid.facets.len()), (vertices, facets));
            let edges: usize = solid.facets.iter().map(Vec::len).sum::<usize>() / 2;
            assert_eq!(vertices + facets, edges + 2);
        }
    }

    #[test]
    fn every_facet_has_the_origin_behind_it() {
        for solid in [geodesic_sphere(3), bipyramid(100), bipyramid(100).turned(TURN)] {
            for facet in &solid.facets {
                let [a, b, c] = [0, 1, 2].map(|k| solid.points[facet[k]].map(|x| x as f64));
                let volume = a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]);
                assert!(volume > 0.0, "{facet:?}");
            }
        }
    }

    #[test]
    fn a_turn_keeps_lengths() {
        let solid = geodesic_sphere(2);
        let turned = solid.turned(TURN);
        let squared = |p: &[i128; 3]| p.iter().map(|x| x * x).sum::<i128>();
        for (before, after) in solid.points.iter().zip(&turned.points) {
            assert_eq!(squared(before) * 39 * 39, squared(after));
        }
        assert_eq!(turned.denominator, SPHERE_SCALE * 39);
    }

    #[test]
    fn text_is_in_lowest_terms() {
        let solid = Solid { points: vec![[3, -6, 0]], denominator: 6, facets: vec![vec![0, 0]] };
        assert_eq!(solid.off(), "OFF\n1 1 0\n1/2 -1 0\n2 0 0\n");
    }
}
