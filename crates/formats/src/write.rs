//! A model to bytes, in any format that can hold it.

use crate::base::model::{Kind, Model, Object, Shape, Unit};
use crate::base::numerals::{Numerals, Rounding, TooLarge};
use crate::complex::{Loss, Malformed};
use crate::format::{Encoding, Format};
use crate::{gltf, gzip, obj, off, ply, star, stl, threemf, vrml};
use exact::Rational;
use polytope::{HoleError, PolygonMesh, TriangulateError};
use std::borrow::Cow;
use std::fmt;

/// How a model is written.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct WriteOptions {
    /// The format, and whether gzip is put around it.
    pub encoding: Encoding,
    /// Whether text formats round each coordinate to the nearest double (ties to even), written as the shortest
    /// decimal that reads back as this double. Facets are in general no longer planar.
    pub float: bool,
    /// Whether what the format cannot hold may be left out: the regular part is written, with notes.
    pub lossy: bool,
}

impl WriteOptions {
    /// Exact where the format can be, and nothing left out.
    pub fn new(encoding: impl Into<Encoding>) -> Self {
        Self { encoding: encoding.into(), float: false, lossy: false }
    }
}

/// A file, and what it does not say of the model.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Written {
    /// The file.
    pub bytes: Vec<u8>,
    /// The largest difference between a coordinate and the number written for it; zero where all are exact.
    pub largest_rounding: Rational,
    /// What had to be changed or left out.
    pub notes: Vec<WriteNote>,
}

/// What had to be changed or left out for a format.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum WriteNote {
    /// The format has triangles only.
    Triangulated {
        /// The numbers of facets before and after.
        from: usize,
        /// The number of triangles.
        to: usize,
    },
    /// The format has no unit.
    NoUnit(Unit),
    /// The format needs a unit, and the model has none.
    UnitAssumed(Unit),
    /// The format has no objects: this many were made one, without names.
    NoObjects(usize),
    /// The format does not take so many names of objects as they are: characters of them were replaced or left out.
    NamesChanged(usize),
    /// The format has no objects without facets, and so many have none: they were left out.
    ObjectsDropped(usize),
    /// The format has no vertices beside facets, and so many are in no facet: they were left out.
    UnusedVertices(usize),
    /// So many facets have two corners at the same position once these are rounded.
    Collapsed(usize),
    /// Left out, because it was allowed.
    LeftOut(Loss),
    /// The format has no holes, and cutting facets was allowed.
    CutHoles {
        /// The number of facets with holes.
        from: usize,
        /// The number of triangles.
        to: usize,
    },
}

/// Why a model cannot be written as asked.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum WriteError {
    /// A coordinate lies beyond the largest float of the format.
    TooLargeForFloat {
        /// The index of the vertex.
        vertex: usize,
    },
    /// The format has facets only.
    NoFacets {
        /// The format.
        format: Format,
    },
    /// The format cannot hold this.
    Loses {
        /// The format.
        format: Format,
        /// What would be lost, all of it.
        losses: Vec<Loss>,
    },
    /// What is left is not bounded, so that no mesh can hold it.
    Unbounded,
    /// Nothing is left: the set has no inner points, and a mesh can hold nothing else of it.
    NothingLeft,
    /// A cell is against the rules of a complex.
    Malformed(Malformed),
    /// A facet of a complex does not lie in one plane.
    NotPlanar {
        /// The index of the facet.
        facet: usize,
        /// A corner off the plane of the first three corners that span one.
        vertex: u32,
        /// The square of its distance from that plane.
        squared_distance: Rational,
    },
    /// A facet with holes cannot be cut into triangles.
    CutHoles {
        /// The index of the facet.
        facet: usize,
        /// Why.
        error: HoleError,
    },
    /// A facet cannot be cut into triangles, and the format has nothing else.
    Triangulate(TriangulateError),
    /// There is no vertex.
    NoVertices,
    /// A corner of a facet is no vertex.
    NoSuchVertex {
        /// The index of the facet.
        facet: usize,
        /// The index of its corner.
        index: u32,
    },
    /// A facet has no corner, or one.
    SmallFacet {
        /// The index of the facet.
        facet: usize,
    },
    /// An object begins behind the last facet, or the objects do not ascend.
    BadObject {
        /// The index of the object.
        object: usize,
    },
    /// A count has no room in the format.
    TooMany {
        /// The format.
        format: Format,
    },
}

/// A mesh on its way into a file of some format.
pub(crate) struct Task<'a> {
    pub(crate) mesh: &'a PolygonMesh,
    pub(crate) objects: &'a [Object],
    pub(crate) unit: Option<Unit>,
    pub(crate) float: bool,
}

/// A file with the largest rounding.
pub(crate) struct Body {
    pub(crate) bytes: Vec<u8>,
    pub(crate) rounding: Rounding,
    /// The number of facets of which two corners became one by rounding.
    pub(crate) collapsed: usize,
}

impl Body {
    pub(crate) fn new(bytes: Vec<u8>, rounding: Rounding) -> Self {
        Self { bytes, rounding, collapsed: 0 }
    }
}

impl Task<'_> {
    /// For formats whose text can be exact.
    pub(crate) fn numerals(&self, exact: Numerals) -> Numerals {
        if self.float { Numerals::Floats } else { exact }
    }

    /// The names of the runs of facets, with their ranges, and a nameless one for facets before the first object.
    pub(crate) fn runs(&self) -> Vec<(&str, std::ops::Range<usize>)> {
        let end = self.mesh.facets.len();
        let first = self.objects.first().map_or(end, |object| object.first_facet as usize);
        let mut runs = Vec::with_capacity(self.objects.len() + 1);
        if first > 0 || self.objects.is_empty() {
            runs.push(("", 0..first));
        }
        for (at, object) in self.objects.iter().enumerate() {
            let next = self.objects.get(at + 1).map_or(end, |object| object.first_facet as usize);
            runs.push((object.name.as_str(), object.first_facet as usize..next));
        }
        runs
    }
}

/// Adds the vertex to what has no room in a float.
pub(crate) fn too_large(vertex: usize) -> impl FnOnce(TooLarge) -> WriteError {
    move |TooLarge| WriteError::TooLargeForFloat { vertex }
}

/// Writes a model. The same model gives the same bytes.
///
/// Exact are OFF, VRML and star; decimal formats (OBJ, 3MF, PLY and STL as text) are exact for decimals of at most
/// 40 digits and round other numbers to the nearest double; binary PLY rounds to doubles, binary STL and glTF to
/// 32-bit floats. The largest rounding is returned.
///
/// # Errors
/// What the format cannot hold, unless it may be left out; a coordinate beyond the floats of the format.
///
/// # Complexity
/// O(n log n) for n vertices, corners of facets and objects, as long as coordinates have few digits, and
/// facets that have to be cut few corners.
///
/// ```
/// use splitstar_formats::{Format, WriteOptions, read, write};
///
/// let model = read(b"OFF\n3 1 0\n0 0 0\n1/3 0 0\n0 1 0\n3 0 1 2\n", None)?.model;
/// let written = write(&model, &WriteOptions::new(Format::Obj))?;
/// assert_eq!(written.bytes, b"v 0 0 0\nv 0.3333333333333333 0 0\nv 0 1 0\nf 1 2 3\n");
/// assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(model: &Model, options: &WriteOptions) -> Result<Written, WriteError> {
    let Encoding { format, gzip } = options.encoding;
    let mut notes = Vec::new();
    let body = match &model.shape {
        Shape::Complex(complex) if format == Format::Star => star::write_complex(complex, model, options)?,
        Shape::Mesh(mesh) => write_mesh(mesh, &model.objects, model.unit, options, &mut notes)?,
        Shape::Complex(complex) => {
            let (mesh, objects) = complex.to_mesh(&model.objects, format, options.lossy, &mut notes)?;
            write_mesh(&mesh, &objects, model.unit, options, &mut notes)?
        }
    };
    if body.collapsed > 0 {
        notes.push(WriteNote::Collapsed(body.collapsed));
    }
    let bytes = if gzip { gzip::pack(&body.bytes) } else { body.bytes };
    Ok(Written { bytes, largest_rounding: body.rounding.0, notes })
}

/// A mesh that a program made may be anything.
fn check_indices(mesh: &PolygonMesh, objects: &[Object]) -> Result<(), WriteError> {
    if mesh.points.is_empty() {
        return Err(WriteError::NoVertices);
    }
    let (vertices, facets) = (mesh.points.len(), mesh.facets.len());
    for (facet, cycle) in mesh.facets.iter().enumerate() {
        if let Some(&index) = cycle.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(WriteError::NoSuchVertex { facet, index });
        }
        if cycle.len() < 2 {
            return Err(WriteError::SmallFacet { facet });
        }
    }
    let in_order = objects.is_sorted_by_key(|object| object.first_facet);
    match objects.iter().position(|object| object.first_facet as usize > facets) {
        None if in_order => Ok(()),
        object => Err(WriteError::BadObject { object: object.unwrap_or(0) }),
    }
}

fn write_mesh(
    mesh: &PolygonMesh,
    named: &[Object],
    unit: Option<Unit>,
    options: &WriteOptions,
    notes: &mut Vec<WriteNote>,
) -> Result<Body, WriteError> {
    check_indices(mesh, named)?;
    let format = options.encoding.format;
    let can = format.abilities();
    let polygons = Kind::of(mesh).has_polygons();
    if !can.points && !polygons {
        return Err(WriteError::NoFacets { format });
    }
    let mut mesh = Cow::Borrowed(mesh);
    let mut objects = Cow::Borrowed(named);
    if !can.polygons && polygons && mesh.facets.iter().any(|cycle| cycle.len() > 3) {
        let triangles = mesh.triangulated().map_err(WriteError::Triangulate)?;
        notes.push(WriteNote::Triangulated { from: mesh.facets.len(), to: triangles.facets.len() });
        objects_of_triangles(objects.to_mut(), &mesh);
        mesh = Cow::Owned(triangles);
    }
    notes_on_objects(&mesh, &objects, format, notes);
    if let (false, Some(unit)) = (can.unit, unit) {
        notes.push(WriteNote::NoUnit(unit));
    }
    if format == Format::ThreeMf && unit.is_none() {
        notes.push(WriteNote::UnitAssumed(threemf::DEFAULT_UNIT));
    }
    if !can.unused_vertices && !mesh.facets.is_empty() {
        let mut used = vec![false; mesh.points.len()];
        mesh.facets.corners().iter().for_each(|&corner| used[corner as usize] = true);
        let unused = used.iter().filter(|used| !**used).count();
        if unused > 0 {
            notes.push(WriteNote::UnusedVertices(unused));
        }
    }
    let task = Task { mesh: &mesh, objects: &objects, unit, float: options.float };
    match format {
        Format::Off => off::write(&task),
        Format::Obj => obj::write(&task),
        Format::Stl => stl::write_binary(&task),
        Format::StlAscii => stl::write_ascii(&task),
        Format::Ply | Format::PlyBigEndian | Format::PlyAscii => ply::write(&task, format),
        Format::ThreeMf => threemf::write(&task),
        Format::Glb => gltf::write(&task),
        Format::Vrml => vrml::write(&task),
        Format::Star => star::write_mesh(&task),
    }
}

/// Counts the objects that the format does not have, and the names that it does not take.
fn notes_on_objects(mesh: &PolygonMesh, objects: &[Object], format: Format, notes: &mut Vec<WriteNote>) {
    let takes: fn(&str) -> bool = match format {
        Format::Obj => obj::takes_name,
        Format::StlAscii => stl::takes_name,
        Format::ThreeMf => threemf::takes_name,
        Format::Vrml => vrml::takes_name,
        _ => |_| true,
    };
    // A solid of STL as text has a name, but there is one only.
    let has_objects = format.abilities().objects || (format == Format::StlAscii && objects.len() == 1);
    if !has_objects {
        if objects.len() > 1 || objects.iter().any(|object| !object.name.is_empty()) {
            notes.push(WriteNote::NoObjects(objects.len()));
        }
        return;
    }
    let has_facets = |at: usize| {
        let end = objects.get(at + 1).map_or(mesh.facets.len(), |next| next.first_facet as usize);
        (objects[at].first_facet as usize) < end
    };
    let is_kept = |at: usize| match format {
        Format::Obj | Format::ThreeMf => has_facets(at),
        // Points are shapes.
        Format::Vrml => mesh.facets.is_empty() || has_facets(at),
        Format::Glb => !mesh.facets.is_empty() || at == 0,
        _ => true,
    };
    let (mut dropped, mut changed) = (0, 0);
    for (at, object) in objects.iter().enumerate() {
        if !is_kept(at) {
            dropped += 1;
        } else if !takes(&object.name) {
            changed += 1;
        }
    }
    if changed > 0 {
        notes.push(WriteNote::NamesChanged(changed));
    }
    if dropped > 0 {
        notes.push(WriteNote::ObjectsDropped(dropped));
    }
}

/// Moves objects to the triangles that [`PolygonMesh::triangulated`] makes of the facets of a mesh: k - 2 of k corners.
pub fn objects_of_triangles(objects: &mut [Object], mesh: &PolygonMesh) {
    let mut starts = Vec::with_capacity(mesh.facets.len() + 1);
    let mut start = 0;
    for cycle in mesh.facets.iter() {
        starts.push(start);
        start += cycle.len().max(3) as u32 - 2;
    }
    starts.push(start);
    for object in objects {
        object.first_facet = starts.get(object.first_facet as usize).copied().unwrap_or(start);
    }
}

impl fmt::Display for WriteNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Triangulated { from, to } => {
                write!(f, "the format has triangles only: {} cut into {to}", facets(*from))
            }
            Self::NoUnit(unit) => write!(f, "the format has no unit: {unit} is not written"),
            Self::UnitAssumed(unit) => {
                write!(f, "the format needs a unit, and the model has none: {unit} is written")
            }
            Self::NoObjects(1) => f.write_str("the format has no objects: one is written without its name"),
            Self::NoObjects(objects) => {
                write!(f, "the format has no objects: {objects} are written as one, without their names")
            }
            Self::NamesChanged(names) => {
                let names = counted(*names, "name of an object", "names of objects");
                write!(f, "the format does not take all names as they are: {names} changed")
            }
            Self::ObjectsDropped(objects) => {
                let objects = counted(*objects, "object", "objects");
                write!(f, "the format has no objects without facets: {objects} left out")
            }
            Self::UnusedVertices(vertices) => {
                let vertices = counted(*vertices, "vertex", "vertices");
                write!(f, "the format has no vertices beside facets: {vertices} left out")
            }
            Self::Collapsed(number) => {
                let have = if *number == 1 { "has" } else { "have" };
                write!(f, "{} {have} two corners at the same position once rounded", facets(*number))
            }
            Self::LeftOut(loss) => write!(f, "left out: {loss}"),
            Self::CutHoles { from, to } => {
                write!(f, "the format has no holes: {} with holes cut into {to} triangles", facets(*from))
            }
        }
    }
}

fn facets(number: usize) -> String {
    counted(number, "facet", "facets")
}

fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLargeForFloat { vertex } => write!(
                f,
                "vertex {vertex} has a coordinate beyond the largest float; write OFF or star with exact coordinates, \
                 or scale down"
            ),
            Self::NoFacets { format } => write!(
                f,
                "{format} has facets only, and there is none of three vertices; write OFF, OBJ, PLY or star"
            ),
            Self::Loses { format, losses } => {
                write!(f, "{format} cannot hold ")?;
                for (at, loss) in losses.iter().enumerate() {
                    let joint = if at == 0 { "" } else { ", and " };
                    write!(f, "{joint}{loss}")?;
                }
                let way_out = match losses[..] {
                    [Loss::Holes(_)] => "; write star, or cut the facets into triangles",
                    _ => "; write star, or allow it to be left out",
                };
                f.write_str(way_out)
            }
            Self::NoVertices => f.write_str("there is no vertex; at least one is needed"),
            Self::NoSuchVertex { facet, index } => {
                write!(f, "facet {facet} has the vertex {index}, which does not exist; correct the facet")
            }
            Self::SmallFacet { facet } => {
                write!(f, "facet {facet} has fewer than two vertices; a facet needs three, and a segment two")
            }
            Self::BadObject { object } => write!(
                f,
                "object {object} is not where it should be: objects ascend, and begin with facets of the model"
            ),
            Self::Unbounded => {
                f.write_str("the set is unbounded, and only star can hold it; write star, or cut it off")
            }
            Self::NothingLeft => {
                f.write_str("the set has no inner points, so that no mesh is left of it; write star")
            }
            Self::Malformed(malformed) => write!(f, "{malformed}"),
            Self::NotPlanar { facet, vertex, squared_distance } => write!(
                f,
                "facet {facet} is not planar: vertex {vertex} is off its plane, the square of the distance is \
                 {squared_distance}; move the vertex, or write star"
            ),
            Self::CutHoles { facet, error } => {
                write!(f, "the format has no holes, and facet {facet} cannot be cut: {error}; write star")
            }
            Self::Triangulate(error) => {
                write!(f, "the format has triangles only, and {error}; write OFF, OBJ, PLY or star")
            }
            Self::TooMany { format } => {
                write!(f, "the model is too large for {format}; write OFF or PLY")
            }
        }
    }
}

impl std::error::Error for WriteError {}
