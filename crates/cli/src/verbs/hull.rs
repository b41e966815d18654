//! `splitstar hull`.

use super::{Job, Outcome, Shape};
use crate::args::Run;
use crate::failure::Failure;
use splitstar::polytope::convex_hull;

pub(crate) fn hull(run: &Run) -> Result<(), Failure> {
    let job = Job::start(run)?;
    let mut points = Vec::new();
    for operand in &job.operands {
        points.extend_from_slice(&operand.read.mesh.points);
    }
    let hull = convex_hull(&points).expect("a mesh that was read has a vertex");
    job.finish(&Outcome { shape: Shape::Polytope(hull), method: "hull", quaternion: None })
}
