//! Polytopes of which everything is known.

use crate::around;
use exact::{Integer, Point3, Rational};
use polytope::{PolygonMesh, Polytope};
use std::collections::HashMap;

fn fraction(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into()).expect("a denominator is not zero")
}

/// `n` points exactly on the unit circle, counterclockwise, near the corners of the regular polygon.
///
/// The point of parameter t is ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)); t is the tangent of half the
/// angle, rounded to a multiple of 2^-k, where 2^k is about 64 n. So the denominators have about
/// 2k bits, and most of them are different.
///
/// # Panics
/// If `n` is not from 3 to 100,000.
pub fn rational_circle(n: usize) -> Vec<[Rational; 2]> {
    assert!((3..=100_000).contains(&n), "the circle has 3 to 100,000 points");
    let grid = (64 * n).next_power_of_two() as i64;
    let point = |i: usize| {
        // Angles from -90 to 90 degrees, and the mirror images of the others: |t| stays at most 1.
        let quarter = 0.25 * n as f64;
        let mirrored = i as f64 > 2.0 * quarter;
        let turn = (i as f64 - if mirrored { 3.0 * quarter } else { quarter }) / n as f64;
        let t = fraction(((std::f64::consts::PI * turn).tan() * grid as f64).round() as i64, grid);
        let square = &t * &t;
        let one = Rational::from(1);
        let divide = |a: Rational| a.checked_div(&(one.clone() + &square)).expect("a sum of squares");
        let (c, s) = (divide(one.clone() - &square), divide(t * Rational::from(2)));
        if mirrored { [-c, -s] } else { [c, s] }
    };
    (0..n).map(point).collect()
}

/// The points of a polygon at a height.
fn lifted(circle: &[[Rational; 2]], height: i64) -> impl Iterator<Item = Point3> + '_ {
    circle.iter().map(move |[x, y]| Point3::from_rationals(&[x.clone(), y.clone(), Rational::from(height)]))
}

/// The prism over `n` points of the circle, from height 0 to `height`: 2n vertices, n + 2 facets.
///
/// # Panics
/// See [`rational_circle`].
pub fn prism(n: usize, height: i64) -> Polytope {
    let circle = rational_circle(n);
    around(&lifted(&circle, 0).chain(lifted(&circle, height)).collect::<Vec<_>>())
}

/// The hull of the polygon at height 0 and its reflection at height 1: 2n vertices; for odd n 2n
/// triangles and two n-gons.
///
/// # Panics
/// See [`rational_circle`].
pub fn antiprism(n: usize) -> Polytope {
    let circle = rational_circle(n);
    let opposite: Vec<_> = circle.iter().map(|[x, y]| [-x.clone(), -y.clone()]).collect();
    around(&lifted(&circle, 0).chain(lifted(&opposite, 1)).collect::<Vec<_>>())
}

/// The bipyramid over `n` points of the circle with apices at plus and minus `height`: n + 2 vertices,
/// 2n facets; two vertices of degree n.
///
/// # Panics
/// See [`rational_circle`].
pub fn bipyramid(n: usize, height: i64) -> Polytope {
    let mut points: Vec<Point3> = lifted(&rational_circle(n), 0).collect();
    points.extend([height, -height].map(|z| Point3::from_i64([0, 0, z])));
    around(&points)
}

/// The geodesic sphere that cuts every edge of an icosahedron in `frequency` parts, as a mesh of
/// triangles: 10 f^2 + 2 vertices, 20 f^2 facets. The radius is one; coordinates are the decimals with
/// so many digits nearest to the floats, so they are over one power of ten.
///
/// Convex if there are digits enough: 6 do up to some ten thousand vertices.
///
/// # Panics
/// If `frequency` is zero or `digits` above 15.
pub fn geodesic_sphere(frequency: usize, digits: u32) -> PolygonMesh {
    assert!(frequency > 0 && digits <= 15, "an edge has parts, and a float has 15 digits");
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let squared = |p: [f64; 3], q: [f64; 3]| (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>();
    let near = |i: usize, j: usize| squared(corners[i], corners[j]) < 4.5;
    let mut sphere = Sphere { frequency, scale: 10f64.powi(digits as i32), ..Sphere::default() };
    sphere.weight = Integer::from(10).pow(digits);
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(i, k) {
                    let [p, q, r] = [corners[i], corners[j], corners[k]];
                    let det = p[0] * (q[1] * r[2] - q[2] * r[1])
                        + p[1] * (q[2] * r[0] - q[0] * r[2])
                        + p[2] * (q[0] * r[1] - q[1] * r[0]);
                    sphere.face(&corners, if det > 0.0 { [i, j, k] } else { [i, k, j] });
                }
            }
        }
    }
    sphere.mesh
}

#[derive(Default)]
struct Sphere {
    frequency: usize,
    scale: f64,
    weight: Integer,
    mesh: PolygonMesh,
    /// Vertices by their corners and parts, so that those on edges are made once.
    named: HashMap<Vec<(usize, usize)>, u32>,
}

impl Sphere {
    /// Cuts one face of the icosahedron.
    fn face(&mut self, corners: &[[f64; 3]], face: [usize; 3]) {
        let f = self.frequency;
        let mut at = |i: usize, j: usize| self.vertex(corners, face, [f - i - j, i, j]);
        let mut triangles = Vec::with_capacity(f * f);
        for i in 0..f {
            for j in 0..f - i {
                triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 2 <= f {
                    triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
        triangles.iter().for_each(|triangle| self.mesh.facets.push(triangle));
    }

    fn vertex(&mut self, corners: &[[f64; 3]], face: [usize; 3], parts: [usize; 3]) -> u32 {
        let mut name: Vec<_> = face.into_iter().zip(parts).filter(|&(_, part)| part > 0).collect();
        name.sort_unstable();
        if let Some(&v) = self.named.get(&name) {
            return v;
        }
        // In the order of the name, so that the float does not depend on the face.
        let sum: [f64; 3] =
            std::array::from_fn(|i| name.iter().map(|&(c, part)| part as f64 * corners[c][i]).sum());
        let length = sum.iter().map(|c| c * c).sum::<f64>().sqrt();
        let grid = sum.map(|c| Integer::from((c / length * self.scale).round() as i64));
        let v = self.mesh.points.len() as u32;
        self.mesh.points.push(Point3::new(grid, self.weight.clone()).expect("a power of ten is positive"));
        self.named.insert(name, v);
        v
    }
}

/// The segment from the origin to a point.
pub fn segment(to: [i64; 3]) -> Polytope {
    Polytope::segment(Point3::from_i64([0, 0, 0]), Point3::from_i64(to))
}

/// `k` generators no three of which are coplanar: points (1, i, i^2) of the moment curve.
pub fn spread_generators(k: i64) -> Vec<[i64; 3]> {
    (0..k).map(|i| [1, i, i * i]).collect()
}

/// The volume of the sum of the segments from the origin to the generators: the sum of the absolute
/// determinants of all triples.
pub fn zonotope_volume(generators: &[[i64; 3]]) -> Rational {
    let mut volume = 0;
    for (i, a) in generators.iter().enumerate() {
        for (j, b) in generators.iter().enumerate().skip(i + 1) {
            for c in &generators[j + 1..] {
                let det = a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]);
                volume += det.abs();
            }
        }
    }
    Rational::from(volume)
}
