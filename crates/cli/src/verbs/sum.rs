//! `splitstar sum`.

use super::convert::triangulated;
use super::{Job, Outcome, common_unit, used_points};
use crate::approx::approx_root;
use crate::args::{Method, Run};
use crate::console::Console;
use crate::explain::{mesh_error, triangles_error};
use crate::failure::Failure;
use crate::input::Operand;
use splitstar::gauss::{CubicalGaussianMap, SphericalGaussianMap};
use splitstar::polytope::{
    MeshError, Polytope, convex_hull, hull_depth, minkowski_sum, minkowski_sum_by_hull, minkowski_sum_by_lp,
};

pub(crate) fn sum(run: &Run) -> Result<(), Failure> {
    let job = Job::start(run)?;
    let unit = common_unit(&job.operands)?;
    let summands = job
        .operands
        .iter()
        .map(|operand| convex(operand, run, &job.console))
        .collect::<Result<Vec<_>, _>>()?;
    let summands: Vec<&Polytope> = summands.iter().collect();
    if run.method == Method::Hull {
        check_hull_size(&summands, &job.operands)?;
    }
    let polytope = match run.method {
        Method::Overlay => minkowski_sum(&summands),
        Method::Sgm => {
            let maps: Vec<_> =
                summands.iter().map(|summand| SphericalGaussianMap::of_polytope(summand)).collect();
            SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>()).make_polytope()
        }
        Method::Cgm => {
            let maps: Vec<_> =
                summands.iter().map(|summand| CubicalGaussianMap::of_polytope(summand)).collect();
            CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>()).make_polytope()
        }
        Method::Lp => minkowski_sum_by_lp(&summands),
        Method::Hull => minkowski_sum_by_hull(&summands),
    };
    job.finish(&Outcome::of_polytope(polytope, unit, run.method.name()))
}

/// The convex hull takes fewer points than this.
const HULL_POINTS: u128 = 1 << 28;

/// Refuses summands whose sums of vertices are too many for a convex hull.
///
/// A sum has no fewer vertices than each summand, and the two largest summands are at last in two sums that are
/// added; so what is refused here can never be done. For two summands the check is complete. For more it is not: the
/// numbers of vertices of the sums in between are not known yet.
fn check_hull_size(summands: &[&Polytope], operands: &[Operand]) -> Result<(), Failure> {
    let vertices: Vec<usize> = summands.iter().map(|polytope| polytope.points().len()).collect();
    let [a, b] = two_largest(&vertices);
    if !too_many_sums(vertices[a], vertices[b]) {
        return Ok(());
    }
    Err(operands[b].failure(
        None,
        format!(
            "its {} vertices times the {} of {} are too many points for a convex hull, which takes fewer than \
             {HULL_POINTS}; use --method overlay, the default",
            vertices[b], vertices[a], operands[a].name
        ),
    ))
}

/// The places of the two largest numbers of two or more, in ascending order.
fn two_largest(numbers: &[usize]) -> [usize; 2] {
    let mut places: Vec<usize> = (0..numbers.len()).collect();
    places.sort_by_key(|&place| std::cmp::Reverse(numbers[place]));
    [places[0].min(places[1]), places[0].max(places[1])]
}

fn too_many_sums(a: usize, b: usize) -> bool {
    a as u128 * b as u128 >= HULL_POINTS
}

/// The polytope of a file, cut into triangles if that is wanted; of a file that is not convex its hull, if that is wanted.
pub(super) fn convex(operand: &Operand, run: &Run, console: &Console) -> Result<Polytope, Failure> {
    let filed = operand.mesh()?;
    let triangles = run.triangulate.then(|| triangulated(filed, operand)).transpose()?;
    let mesh = triangles.as_ref().unwrap_or(filed);
    let mut notes = Vec::new();
    match Polytope::from_mesh(mesh, &mut notes) {
        Ok(polytope) => {
            for note in notes {
                console.note(&operand.name, None, &note.to_string());
            }
            Ok(polytope)
        }
        Err(_) if run.hull => {
            let points = used_points(mesh);
            let hull = convex_hull(&points).expect("a mesh that was read has a vertex");
            // The depth may take long where there are many points and facets: only if somebody reads it.
            if console.speaks() {
                let depth = approx_root(&hull_depth(&points, &hull));
                let what = match hull.dimension() {
                    3 => "the convex hull is taken".to_owned(),
                    dimension => format!("the convex hull is taken, which has dimension {dimension}"),
                };
                let what = format!("{what}; vertices of the mesh lie at most {depth} inside it");
                console.note(&operand.name, None, &what);
            }
            Ok(hull)
        }
        Err(error) => {
            let (place, what) = match &triangles {
                Some(_) => triangles_error(&error, operand, filed),
                None => mesh_error(&error, operand),
            };
            Err(operand.failure(place, format!("{what}; {}", way_out(&error))))
        }
    }
}

fn way_out(error: &MeshError) -> &'static str {
    match error {
        MeshError::NonPlanar { .. } => {
            "--triangulate cuts it into triangles, and --hull takes the convex hull instead"
        }
        _ => "--hull takes the convex hull instead",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_of_a_hull_is_known_beforehand() {
        assert!(!too_many_sums(16_384, 16_383));
        assert!(too_many_sums(16_384, 16_384));
        assert!(!too_many_sums(1, (1 << 28) - 1));
        assert!(too_many_sums(usize::MAX, usize::MAX));
        assert_eq!(two_largest(&[5, 5]), [0, 1]);
        assert_eq!(two_largest(&[7, 2, 9, 8]), [2, 3]);
        assert_eq!(two_largest(&[9, 2, 3]), [0, 2]);
    }
}
