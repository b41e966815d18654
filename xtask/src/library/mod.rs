//! The one place where the tasks call the library on polytopes.
//!
//! | file | role |
//! |---|---|
//! | this one | models, and their sums, measured |
//! | `method` | the ways to a sum |
//! | `maps` | cells of Gaussian maps |

mod maps;
mod method;

pub(crate) use maps::{MapCounts, cubical_counts, cubical_side_counts, spherical_counts};
pub(crate) use method::Method;

use std::path::{Path, PathBuf};
use std::time::Instant;

use exact::{Affine3, Integer, Point3, Quaternion};
use polytope::{PolygonMesh, Polytope, convex_hull, minkowski_sum};

use crate::Failure;

/// Vertices, edges and facets of a polytope, coplanar facets merged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) vertices: usize,
    pub(crate) edges: usize,
    pub(crate) facets: usize,
}

impl Counts {
    /// V + E + F.
    pub(crate) fn features(self) -> usize {
        self.vertices + self.edges + self.facets
    }
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}/{}", self.vertices, self.edges, self.facets)
    }
}

/// A sum that was measured.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    /// Counts of each operand.
    pub(crate) operands: Vec<Counts>,
    pub(crate) sum: Counts,
    /// Median over the repetitions, from the parsed meshes to the finished result with exact coordinates.
    pub(crate) seconds: f64,
    /// The fastest repetition: far below the median on a machine that is busy.
    pub(crate) fastest: f64,
    /// Medians of its parts: making the polytopes of the operands, making maps of them where the method adds these, and the sum.
    pub(crate) phases: [f64; 3],
    pub(crate) repetitions: usize,
}

/// Counts of the sum of the models in these files, or of the one model.
///
/// # Errors
/// If a file is not a convex mesh.
pub(crate) fn sum_counts(paths: &[PathBuf]) -> Result<Counts, Failure> {
    Ok(measured_sum(paths, 1, 0.0)?.sum)
}

/// Sums the models in these files again and again in this process, at least `least` times and for about `budget` seconds.
///
/// # Errors
/// If a file is not a convex mesh.
pub(crate) fn measured_sum(paths: &[PathBuf], least: usize, budget: f64) -> Result<Measured, Failure> {
    measured_sum_by(Method::Walk, paths, least, budget)
}

/// The same by another method. What is measured ends with the Gaussian map of the sum, where the method makes one.
///
/// # Errors
/// If a file is not a convex mesh.
pub(crate) fn measured_sum_by(
    method: Method,
    paths: &[PathBuf],
    least: usize,
    budget: f64,
) -> Result<Measured, Failure> {
    let meshes = paths.iter().map(|path| read(path)).collect::<Result<Vec<_>, _>>()?;
    let mut times: Vec<[f64; 3]> = Vec::new();
    let start = Instant::now();
    loop {
        let begin = Instant::now();
        let polytopes = meshes.iter().map(polytope).collect::<Result<Vec<_>, _>>()?;
        let built = Instant::now();
        let operands = method.operands(&polytopes);
        let ready = Instant::now();
        let sum = operands.sum();
        let end = Instant::now();
        times.push([built - begin, ready - built, end - ready].map(|time| time.as_secs_f64()));
        if times.len() >= least.max(1) && (start.elapsed().as_secs_f64() >= budget || times.len() == 20_000) {
            let totals: Vec<f64> = times.iter().map(|phases| phases.iter().sum()).collect();
            return Ok(Measured {
                operands: polytopes.iter().map(counts).collect(),
                sum: sum.counts(),
                fastest: totals.iter().copied().fold(f64::INFINITY, f64::min),
                seconds: median(totals),
                phases: [0, 1, 2].map(|part| median(times.iter().map(|phases| phases[part]).collect())),
                repetitions: times.len(),
            });
        }
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 { values[middle] } else { f64::midpoint(values[middle - 1], values[middle]) }
}

/// Reads a mesh file.
///
/// # Errors
/// If the file is missing or is not a mesh.
pub(crate) fn read(path: &Path) -> Result<PolygonMesh, Failure> {
    let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let read = formats::read(&bytes, None).map_err(|error| format!("{}: {error}", path.display()))?;
    let mesh = read.model.shape.into_mesh();
    mesh.ok_or_else(|| format!("{}: it is no mesh", path.display()).into())
}

/// The polytope of a convex mesh.
fn polytope(mesh: &PolygonMesh) -> Result<Polytope, Failure> {
    Ok(Polytope::from_mesh(mesh, &mut Vec::new())?)
}

fn counts(polytope: &Polytope) -> Counts {
    counts_of(polytope.counts())
}

fn counts_of(counts: polytope::Counts) -> Counts {
    Counts { vertices: counts.vertices, edges: counts.edges, facets: counts.facets }
}

/// The polytopes of these files.
///
/// # Errors
/// If a file is not a convex mesh.
pub(crate) fn polytopes(paths: &[PathBuf]) -> Result<Vec<Polytope>, Failure> {
    paths.iter().map(|path| polytope(&read(path)?)).collect()
}

/// A polytope turned exactly by the quaternion w, x, y, z, of any length but zero.
pub(crate) fn turned(polytope: &Polytope, by: [i64; 4]) -> Polytope {
    let quaternion = Quaternion::new(by.map(Integer::from)).expect("a rotation is not zero");
    polytope.transformed(&Affine3::rotation(&quaternion))
}

/// The hull of points.
pub(crate) fn hull(points: &[[i64; 3]]) -> Polytope {
    let points: Vec<Point3> = points.iter().map(|&point| Point3::from_i64(point)).collect();
    convex_hull(&points).expect("there are points")
}

/// The sum of polytopes.
pub(crate) fn sum(polytopes: &[Polytope]) -> Polytope {
    minkowski_sum(&polytopes.iter().collect::<Vec<_>>())
}
