//! How far inside its convex hull a mesh goes.

use super::strict::squared_distance;
use crate::Polytope;
use exact::{Point3, Rational, Vector3};

/// How far below the boundary of the hull a point of the mesh lies at most: the square of that
/// distance, zero if every point is on the boundary or the hull has a dimension below 3.
///
/// # Complexity
/// Points times facets for a guess in floats, which only orders the work; then one exact distance for
/// nearly every point, and one for every facet for the few points that may be the deepest.
pub fn hull_depth(points: &[Point3], hull: &Polytope) -> Rational {
    let mut deepest = Rational::from(0);
    if hull.dimension != 3 {
        return deepest;
    }
    let planes: Vec<Facet<'_>> = hull
        .mesh
        .facets()
        .map(|f| {
            Facet::new(hull.facet_normal(f), &hull.points[hull.mesh.source(hull.mesh.boundary(f)).index()])
        })
        .collect();
    // The nearest facet of each point, and about how near; the deepest first.
    let mut guesses: Vec<(f64, usize, &Point3)> = points
        .iter()
        .map(|point| {
            let at = point.approx_f64();
            let nearest = (0..planes.len()).map(|f| (planes[f].guess(at), f));
            let (depth, f) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)).expect("a solid has facets");
            (depth, f, point)
        })
        .collect();
    guesses.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (_, guess, point) in guesses {
        let bound = planes[guess].squared_distance(point);
        if bound > deepest {
            let depth = planes.iter().map(|facet| facet.squared_distance(point)).min();
            deepest = deepest.max(depth.expect("a solid has facets"));
        }
    }
    deepest
}

struct Facet<'h> {
    normal: &'h Vector3,
    on: &'h Point3,
    /// A unit normal and the offset, about.
    unit: [f64; 3],
    offset: f64,
}

impl<'h> Facet<'h> {
    fn new(normal: &'h Vector3, on: &'h Point3) -> Self {
        let [x, y, z] = normal.approx_f64();
        let length = x.hypot(y).hypot(z);
        let unit = [x / length, y / length, z / length];
        let offset = dot(unit, on.approx_f64());
        Self { normal, on, unit, offset }
    }

    fn guess(&self, point: [f64; 3]) -> f64 {
        self.offset - dot(self.unit, point)
    }

    fn squared_distance(&self, point: &Point3) -> Rational {
        squared_distance(self.normal, self.on, point)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
