//! `splitstar hull`.

use super::{Job, Outcome};
use crate::args::Run;
use crate::failure::Failure;
use splitstar::formats::Shape;
use splitstar::polytope::convex_hull;

pub(crate) fn hull(run: &Run) -> Result<(), Failure> {
    let job = Job::start(run)?;
    let unit = job.unit()?;
    let mut points = Vec::new();
    for operand in &job.operands {
        if let Shape::Complex(complex) = &operand.read.model.shape
            && complex.has_directions()
        {
            return Err(operand
                .failure(None, "it has vertices at infinity, and a convex hull is bounded; remove them"));
        }
        points.extend(operand.read.model.shape.points().cloned());
    }
    let hull = convex_hull(&points).expect("a model that was read has a vertex");
    job.finish(&Outcome::of_polytope(hull, unit, "hull"))
}
