//! `splitstar hull`.

use super::{Job, Outcome, common_unit};
use crate::args::Run;
use crate::failure::Failure;
use splitstar::formats::Shape;
use splitstar::polytope::convex_hull;

pub(crate) fn hull(run: &Run) -> Result<(), Failure> {
    let job = Job::start(run)?;
    let unit = common_unit(&job.operands)?;
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
    let hull = convex_hull(&points).ok_or_else(|| {
        job.operands[0].failure(None, "there is no vertex, and so there is no hull; give points")
    })?;
    job.finish(&Outcome::of_polytope(hull, unit, "hull"))
}
