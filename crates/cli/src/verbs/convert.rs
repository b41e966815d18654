//! `splitstar convert`.

use super::{Job, Outcome};
use crate::args::{Motion, Rotation, Run};
use crate::console::Console;
use crate::explain::{mesh_error, triangles_error};
use crate::failure::Failure;
use crate::input::Operand;
use splitstar::exact::{Affine3, Quaternion, Rational};
use splitstar::formats::{self, Complex, Model, Object, Shape, Unit};
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
        Shape::Complex(complex) => complex_shape(complex, &mut model.objects, operand, run)?,
    };
    if let Some(map) = affine(units, &run.motion, quaternion.as_ref()) {
        model.shape = model.shape.transformed(&map).expect("no step of a motion flattens space");
    }
    model.unit = run.unit.or(model.unit);
    job.finish(&Outcome { model, polytope: None, method: "convert", quaternion })
}

/// A mesh mended, joined and cut into triangles, as is wanted. Objects move with their facets.
fn mesh_shape(
    filed: PolygonMesh,
    objects: &mut [Object],
    operand: &Operand,
    run: &Run,
    console: &Console,
) -> Result<Shape, Failure> {
    let mut notes = Vec::new();
    // Facets of two objects do not become one.
    let labels = labels(objects, filed.facets.len());
    let what = if run.join { Mending::joining().within(&labels) } else { Mending::new() };
    // Triangles are the way out for facets that are not planar, and these cannot be joined.
    let triangles_first = run.triangulate && !run.join;
    let mended = if triangles_first {
        let triangles = triangulated(&filed, operand)?;
        formats::objects_of_triangles(objects, &filed);
        triangles.mended(what, &mut notes).map_err(|error| triangles_error(&error, operand, &filed))
    } else {
        filed.mended(what, &mut notes).map_err(|error| mesh_error(&error, operand))
    };
    let mended = mended.map_err(|(place, what)| {
        operand.failure(place, format!("{what}; --triangulate cuts it into triangles"))
    })?;
    for note in notes {
        console.note(&operand.name, None, &note.to_string());
    }
    move_objects(objects, &mended.facet_origin);
    if !(run.join && run.triangulate) {
        return Ok(Shape::of_mended(mended));
    }
    let joined_origin = mended.facet_origin.clone();
    let cut = mended.without_holes().map_err(|(facet, error)| {
        let place = operand.facet_place(joined_origin[facet as usize] as usize);
        operand.failure(place, format!("what is joined with this facet cannot be cut: {error}; correct it"))
    })?;
    // The objects are those of the facets before they were cut.
    let cut_origin = positions_of(&cut.facet_origin, &joined_origin);
    move_objects(objects, &cut_origin);
    formats::objects_of_triangles(objects, &cut.mesh);
    triangulated(&cut.mesh, operand).map(Shape::Mesh)
}

/// For each facet the number of objects that begin before it or at it.
fn labels(objects: &[Object], facets: usize) -> Vec<u32> {
    let mut labels = vec![0; facets];
    for object in objects {
        if let Some(label) = labels.get_mut(object.first_facet as usize) {
            *label += 1;
        }
    }
    let mut objects = 0;
    for label in &mut labels {
        objects += *label;
        *label = objects;
    }
    labels
}

/// For each entry of a list its place in another one; both ascend, and the second has all entries of the first.
fn positions_of(entries: &[u32], among: &[u32]) -> Vec<u32> {
    entries.iter().map(|entry| among.partition_point(|other| other < entry) as u32).collect()
}

/// A mesh cut into triangles; a failure names the facet.
pub(super) fn triangulated(mesh: &PolygonMesh, operand: &Operand) -> Result<PolygonMesh, Failure> {
    mesh.triangulated().map_err(|error| {
        let what = match error {
            TriangulateError::NoArea { .. } => "the facet encloses no area; remove it",
            _ => "the boundary of the facet crosses or touches itself; cut it by hand",
        };
        operand.failure(operand.facet_place(error.facet()), what)
    })
}

/// A complex of cells, cut into triangles if that is wanted. What is a mesh then becomes one.
fn complex_shape(
    complex: Complex,
    objects: &mut [Object],
    operand: &Operand,
    run: &Run,
) -> Result<Shape, Failure> {
    if run.join {
        return Err(
            operand.failure(None, "--join is for meshes, and this is a complex of cells; leave it out")
        );
    }
    if !run.triangulate {
        return Ok(Shape::Complex(complex));
    }
    let (complex, origin) = complex.triangulated().map_err(|(facet, error)| {
        operand.failure(operand.facet_place(facet), format!("the facet cannot be cut: {error}; correct it"))
    })?;
    move_objects(objects, &origin);
    Ok(complex.as_mesh().map_or(Shape::Complex(complex), Shape::Mesh))
}

/// Moves objects to facets that were made from others, which are given in ascending order.
fn move_objects(objects: &mut [Object], origin: &[u32]) {
    for object in objects {
        object.first_facet = origin.partition_point(|&facet| facet < object.first_facet) as u32;
    }
}

/// The factor that takes lengths in one unit to another.
fn unit_scale(from: Unit, to: Unit) -> Rational {
    &from.meters() * &to.meters().recip().expect("no unit is zero")
}

fn quaternion(rotation: &Rotation) -> Result<Quaternion, Failure> {
    match rotation {
        Rotation::Axis { axis, degrees } => Quaternion::nearest(axis.clone(), degrees.clone())
            .map_err(|error| Failure::usage(format!("convert: {error}"))),
        Rotation::Quaternion(components) => Quaternion::from_rationals(components)
            .ok_or_else(|| Failure::usage("convert: the quaternion of `--quat` is zero")),
    }
}

/// Converts units, scales, reflects, rotates, moves, in this order; `None` if nothing of it is asked for.
fn affine(units: Option<Rational>, motion: &Motion, quaternion: Option<&Quaternion>) -> Option<Affine3> {
    let steps = [
        units.as_ref().map(Affine3::scaling),
        motion.scale.as_ref().map(Affine3::scaling),
        motion.reflect.then(Affine3::reflection),
        quaternion.map(Affine3::rotation),
        motion.translate.as_ref().map(Affine3::translation),
    ];
    steps.into_iter().flatten().reduce(|map, next| map.then(&next))
}
