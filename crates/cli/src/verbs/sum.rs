//! `splitstar sum`.

use super::{Job, Outcome, Shape, used_points};
use crate::args::{Method, Run};
use crate::console::Console;
use crate::explain::{approx_root, mesh_error};
use crate::failure::Failure;
use crate::input::Operand;
use splitstar::polytope::{
    MeshError, Polytope, convex_hull, hull_depth, minkowski_sum, minkowski_sum_by_hull,
};

pub(crate) fn sum(run: &Run) -> Result<(), Failure> {
    let job = Job::start(run)?;
    let summands = job
        .operands
        .iter()
        .map(|operand| summand(operand, run.hull, &job.console))
        .collect::<Result<Vec<_>, _>>()?;
    let summands: Vec<&Polytope> = summands.iter().collect();
    let (polytope, method) = match run.method {
        Method::Overlay => (minkowski_sum(&summands), "overlay"),
        Method::Hull => (minkowski_sum_by_hull(&summands), "hull"),
    };
    job.finish(&Outcome { shape: Shape::Polytope(polytope), method, quaternion: None })
}

/// The polytope of a file; of a file that is not convex its hull, if that is wanted.
fn summand(operand: &Operand, take_hull: bool, console: &Console) -> Result<Polytope, Failure> {
    let mut notes = Vec::new();
    match Polytope::from_mesh(&operand.read.mesh, &mut notes) {
        Ok(polytope) => {
            for note in notes {
                console.note(&operand.name, None, &note.to_string());
            }
            Ok(polytope)
        }
        Err(_) if take_hull => {
            let points = used_points(&operand.read.mesh);
            let hull = convex_hull(&points).expect("a mesh that was read has a vertex");
            let depth = approx_root(&hull_depth(&points, &hull));
            let what = match hull.dimension() {
                3 => format!("the convex hull is taken; vertices of the mesh lie at most {depth} inside it"),
                dimension => format!("the convex hull is taken, which has dimension {dimension}"),
            };
            console.note(&operand.name, None, &what);
            Ok(hull)
        }
        Err(error) => {
            let (line, what) = mesh_error(&error, operand);
            Err(operand.failure(line, format!("{what}; {}", way_out(&error))))
        }
    }
}

fn way_out(error: &MeshError) -> &'static str {
    match error {
        MeshError::NonPlanar { .. } => {
            "`splitstar convert --triangulate` cuts it into triangles, and --hull takes the convex hull instead"
        }
        _ => "--hull takes the convex hull instead",
    }
}
