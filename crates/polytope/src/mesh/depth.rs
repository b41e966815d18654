//! How far inside its convex hull a mesh goes.

use super::shape::squared_distance;
use crate::Polytope;
use dcel::FacetId;
use exact::{Point3, Rational, Vector3};
use std::collections::HashSet;

/// How far inside the hull a point of the mesh lies at most, within the dimension of the hull: the
/// square of its distance from the boundary (from the sides of a polygon, from the ends of a segment).
/// Zero if every point is on the boundary.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::{convex_hull, hull_depth};
/// let points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, 0]].map(Point3::from_i64);
/// let triangle = convex_hull(&points).expect("there are points");
/// assert_eq!(hull_depth(&points, &triangle).to_string(), "1");
/// ```
///
/// # Complexity
/// Points that are no vertices of the hull times facets, for a guess in floats, which only orders the
/// work; then one exact distance for nearly every such point, and one for every facet for the few that
/// may be the deepest.
pub fn hull_depth(points: &[Point3], hull: &Polytope) -> Rational {
    let mut deepest = Rational::from(0);
    let walls = walls(hull);
    let vertices: HashSet<_> = hull.points.iter().map(Point3::canonical_key).collect();
    // The nearest wall of each point, and about how near; the deepest first.
    let mut guesses: Vec<(f64, usize, &Point3)> = points
        .iter()
        .filter(|point| !vertices.contains(&point.canonical_key()))
        .filter_map(|point| {
            let at = point.approx_f64();
            let distances = walls.iter().enumerate().map(|(w, wall)| (wall.guess(at), w));
            let (depth, wall) = distances.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some((depth, wall, point))
        })
        .collect();
    guesses.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (_, guess, point) in guesses {
        if walls[guess].squared_distance(point) > deepest {
            let depth = walls.iter().map(|wall| wall.squared_distance(point)).min();
            deepest = deepest.max(depth.expect("a point was guessed to be near a wall"));
        }
    }
    deepest
}

/// What bounds the hull within its dimension: its facets, the sides of a polygon, the ends of a segment.
fn walls(hull: &Polytope) -> Vec<Wall<'_>> {
    let mesh = &hull.mesh;
    let source = |h| &hull.points[mesh.source(h).index()];
    match hull.dimension {
        3 => {
            mesh.facets().map(|f| Wall::new(hull.facet_normal(f).clone(), source(mesh.boundary(f)))).collect()
        }
        2 => {
            let front = hull.facet_normal(FacetId(0));
            let side = |h| Wall::new(hull.edge_vector(h).cross(front), source(h));
            mesh.facet_cycle(FacetId(0)).map(side).collect()
        }
        1 => {
            let [a, b] = [&hull.points[0], &hull.points[1]];
            vec![Wall::new(b.direction_to(a), a), Wall::new(a.direction_to(b), b)]
        }
        _ => Vec::new(),
    }
}

/// A plane that bounds the hull.
struct Wall<'h> {
    /// Outwards.
    normal: Vector3,
    on: &'h Point3,
    /// A unit normal and the offset, about.
    unit: [f64; 3],
    offset: f64,
}

impl<'h> Wall<'h> {
    fn new(normal: Vector3, on: &'h Point3) -> Self {
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
        squared_distance(&self.normal, self.on, point)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
