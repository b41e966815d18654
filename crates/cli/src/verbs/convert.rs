//! `splitstar convert`.

use super::{Job, Outcome};
use crate::args::{Motion, Rotation, Run};
use crate::explain::mesh_error;
use crate::failure::Failure;
use crate::input::Operand;
use splitstar::exact::{Affine3, Quaternion, Rational};
use splitstar::formats::{Complex, Model, Shape, Unit};
use splitstar::polytope::{Mending, PolygonMesh, TriangulateError};

pub(crate) fn convert(run: &Run) -> Result<(), Failure> {
    let quaternion = run.motion.rotation.as_ref().map(quaternion).transpose()?;
    let mut job = Job::start(run)?;
    let operand = &mut job.operands[0];
    // The model is taken, not copied: it may be large.
    let mut model = std::mem::replace(&mut operand.read.model, Model::of_mesh(PolygonMesh::default()));
    let operand = &job.operands[0];
    if let Some(quaternion) = &quaternion {
        job.console.note(&operand.name, None, &format!("turned by the quaternion {quaternion}"));
    }
    let units = run.unit.zip(model.unit).map(|(to, from)| unit_scale(from, to));
    model.shape = match model.shape {
        Shape::Mesh(mesh) => mesh_shape(mesh, &mut model.objects, operand, run, &job.console)?,
        Shape::Complex(complex) => complex_shape(complex, operand, run)?,
    };
    if let Some(map) = affine(units, &run.motion, quaternion.as_ref()) {
        model.shape = model.shape.transformed(&map);
    }
    model.unit = run.unit.or(model.unit);
    job.finish(&Outcome { model, polytope: None, method: "convert", quaternion })
}
