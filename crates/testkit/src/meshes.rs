//! Meshes as programs write them.

use crate::Rng;
use exact::{Point3, Rational};
use polytope::{Facets, PolygonMesh};

/// A mesh of small integer points and cycles.
pub fn mesh(points: &[[i64; 3]], cycles: &[&[u32]]) -> PolygonMesh {
    let mut facets = Facets::new();
    cycles.iter().for_each(|cycle| facets.push(cycle));
    PolygonMesh { points: points.iter().map(|&p| Point3::from_i64(p)).collect(), facets }
}

/// The cube from 0 to 2 as six quadrilaterals; vertex `4x + 2y + z` has the coordinates `2x, 2y, 2z`.
pub fn cube_mesh() -> PolygonMesh {
    let points: Vec<_> = (0..8).map(|v| [2 * (v >> 2), 2 * (v >> 1 & 1), 2 * (v & 1)]).collect();
    let sides: [&[u32]; 6] =
        [&[0, 1, 3, 2], &[4, 6, 7, 5], &[0, 4, 5, 1], &[2, 3, 7, 6], &[0, 2, 6, 4], &[1, 5, 7, 3]];
    mesh(&points, &sides)
}

/// The mesh with every facet cut into a fan of triangles from its first corner: right for convex facets.
pub fn fan_triangulated(mesh: &PolygonMesh) -> PolygonMesh {
    let mut facets = Facets::new();
    for cycle in mesh.facets.iter() {
        cycle[1..].windows(2).for_each(|pair| facets.push(&[cycle[0], pair[0], pair[1]]));
    }
    PolygonMesh { points: mesh.points.clone(), facets }
}

/// The mesh with its own vertices for every facet, as in an STL file.
pub fn soup(mesh: &PolygonMesh) -> PolygonMesh {
    let mut points = Vec::new();
    let mut facets = Facets::new();
    for cycle in mesh.facets.iter() {
        let first = points.len() as u32;
        points.extend(cycle.iter().map(|&v| mesh.points[v as usize].clone()));
        facets.push(&(first..points.len() as u32).collect::<Vec<_>>());
    }
    PolygonMesh { points, facets }
}

/// A convex mesh with float coordinates, as in an STL file: the hull of `count` points near an ellipsoid
/// whose axes have magnitudes spread over so many powers of two, up to 2^20 axes away from the origin,
/// triangulated, every facet with vertices of its own.
///
/// Clearing the denominators of such coordinates needs about `53 + spread` bits.
///
/// # Panics
/// If `count` is below 4.
pub fn stl_like_mesh(rng: &mut Rng, count: u64, spread: u64) -> PolygonMesh {
    assert!(count >= 4, "a solid has four vertices");
    let half = spread / 2;
    let axes = [0; 3].map(|_: u8| 2f64.powi(rng.between(0, spread) as i32 - half as i32));
    let centre = axes.map(|axis| axis * 2f64.powi(rng.below(21) as i32));
    loop {
        let mut unit = || (rng.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        let points: Vec<Point3> = (0..count)
            .map(|_| {
                let direction = [0; 3].map(|_: u8| unit());
                let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
                let coordinate = |i: usize| centre[i] + axes[i] * direction[i] / length;
                let exact = |i: usize| Rational::try_from(coordinate(i)).expect("the value is finite");
                Point3::from_rationals(&[0, 1, 2].map(exact))
            })
            .collect();
        let hull = crate::around(&points);
        if hull.dimension() == 3 {
            return soup(&fan_triangulated(&hull.to_mesh()));
        }
    }
}
