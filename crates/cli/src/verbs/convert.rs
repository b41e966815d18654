//! `splitstar convert`.

use super::{Job, Outcome, Shape};
use crate::args::{Motion, Rotation, Run};
use crate::failure::Failure;
use splitstar::exact::{Affine3, Quaternion};
use splitstar::polytope::TriangulateError;

pub(crate) fn convert(run: &Run) -> Result<(), Failure> {
    let quaternion = run.motion.rotation.as_ref().map(quaternion).transpose()?;
    let job = Job::start(run)?;
    let operand = &job.operands[0];
    if let Some(quaternion) = &quaternion {
        job.console.note(&operand.name, None, &format!("turned by the quaternion {quaternion}"));
    }
    let mesh = &operand.read.mesh;
    let mut mesh = match affine(&run.motion, quaternion.as_ref()) {
        Some(map) => mesh.transformed(&map),
        None => mesh.clone(),
    };
    if run.triangulate {
        mesh = mesh.triangulated().map_err(|error| {
            let what = match error {
                TriangulateError::NoArea { .. } => "the facet encloses no area; remove it",
                _ => "the boundary of the facet crosses or touches itself; cut it by hand",
            };
            operand.failure(operand.facet_line(error.facet()), what)
        })?;
    }
    job.finish(&Outcome { shape: Shape::Mesh(mesh), method: "convert", quaternion })
}

fn quaternion(rotation: &Rotation) -> Result<Quaternion, Failure> {
    match rotation {
        Rotation::Axis { axis, degrees } => Quaternion::nearest(axis.clone(), degrees.clone())
            .map_err(|error| Failure::usage(format!("convert: {error}"))),
        Rotation::Quaternion(components) => Quaternion::from_rationals(components)
            .ok_or_else(|| Failure::usage("convert: the quaternion of `--quat` is zero")),
    }
}

/// Scales, reflects, rotates, moves, in this order; `None` if nothing of it is asked for.
fn affine(motion: &Motion, quaternion: Option<&Quaternion>) -> Option<Affine3> {
    let steps = [
        motion.scale.as_ref().map(Affine3::scaling),
        motion.reflect.then(Affine3::reflection),
        quaternion.map(Affine3::rotation),
        motion.translate.as_ref().map(Affine3::translation),
    ];
    steps.into_iter().flatten().reduce(|map, next| map.then(&next))
}
