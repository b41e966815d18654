//! Our files: every model in every format, read back by us, and listed for the other readers.

use std::fs;
use std::path::Path;

use exact::{Point3, Rational};
use formats::{Encoding, Format, Model, Object, Shape, Unit, WriteOptions};
use polytope::{MeshSummary, PolygonMesh};
use serde_json::{Value, json};

use super::table::{Cell, Row};
use crate::{Failure, library, shell};

/// Small integers, fractions of many digits, non-convex facets, holes through the solid, a void.
const MODELS: [&str; 11] = [
    "convex/cube.off",
    "convex/dp.off",
    "convex/odp.xoff",
    "convex/gs4.off",
    "convex/pentagonal_hexecontahedron.xoff",
    "nonconvex/star.off",
    "nonconvex/ring.off",
    "nonconvex/mushroom.off",
    "nonconvex/l_shape.off",
    "nonconvex/void_cube.off",
    "nonconvex/stellated_rhombic_dodecahedron.off",
];

/// This one is also written with gzip around every format.
const PACKED: &str = "dp";

/// Formats in which some programs read facets of few corners only, or only facets of the same number of corners.
const FOR_TRIANGLES: [Format; 3] = [Format::Off, Format::Ply, Format::PlyBigEndian];

/// The file that lists the others.
pub(super) const MANIFEST: &str = "manifest.json";

/// A model with its facts.
struct Subject {
    name: String,
    model: Model,
    formats: &'static [Format],
    triangles: usize,
    volume: f64,
}

/// Writes all files into `folder`, with a manifest for the other readers, and reads each of them.
///
/// # Errors
/// If a model of the repository cannot be read, or a file not be written to the disk. What is wrong with a format is
/// in the rows.
pub(super) fn write(folder: &Path) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::new();
    let mut manifest = Vec::new();
    for subject in subjects()? {
        for &format in subject.formats {
            let mut encodings = vec![Encoding { format, gzip: false }];
            if subject.name == PACKED {
                encodings.push(Encoding { format, gzip: true });
            }
            for encoding in encodings {
                let mut options = WriteOptions::new(encoding);
                loop {
                    let file = file_name(&subject.name, &options);
                    let (cell, alone) = match subject.write(folder, &file, &options) {
                        Ok(entry) => {
                            let alone = entry["alone"].is_string();
                            manifest.push(entry);
                            (Cell::Passed, alone)
                        }
                        Err(failure) => (Cell::Failed(failure.to_string()), false),
                    };
                    rows.push(Row::new(&file, &encoding_name(encoding), "splitstar", cell));
                    // What is exact and for us alone is written once more for everybody.
                    if !alone || options.float || format == Format::Star {
                        break;
                    }
                    options.float = true;
                }
            }
        }
    }
    fs::write(folder.join(MANIFEST), serde_json::to_string_pretty(&manifest)?)?;
    Ok(rows)
}

fn subjects() -> Result<Vec<Subject>, Failure> {
    let mut subjects = Vec::new();
    for path in MODELS {
        let mesh = library::read(&shell::root().join("models").join(path))?;
        let stem = Path::new(path).file_stem().unwrap_or_default().to_string_lossy();
        if mesh.facets.iter().any(|cycle| cycle.len() != 3) {
            let triangles = Model::of_mesh(mesh.triangulated()?);
            subjects.push(Subject::new(&format!("{stem}.triangles"), triangles, &FOR_TRIANGLES)?);
        }
        subjects.push(Subject::new(&stem, Model::of_mesh(mesh), &Format::ALL)?);
    }
    subjects.push(Subject::new("two_boxes", two_boxes()?, &Format::ALL)?);
    Ok(subjects)
}

/// Two objects with a unit.
fn two_boxes() -> Result<Model, Failure> {
    let read = |name: &str| library::read(&shell::root().join("models/convex").join(name));
    let (mut mesh, other) = (read("box_x.off")?, read("box_y.off")?);
    let (vertices, facets) = (mesh.points.len() as u32, mesh.facets.len() as u32);
    let away = Point3::from_i64([100, 0, 0]);
    mesh.points.extend(other.points.iter().map(|point| point.plus(&away)));
    for cycle in other.facets.iter() {
        mesh.facets.push(&cycle.iter().map(|corner| corner + vertices).collect::<Vec<_>>());
    }
    let mut model = Model::of_mesh(mesh);
    let object = |name: &str, first_facet| Object { name: name.to_owned(), first_facet };
    model.objects = vec![object("first box", 0), object("second", facets)];
    model.unit = Some(Unit::Centimeter);
    Ok(model)
}

/// The model's name and the usual ending.
fn file_name(model: &str, options: &WriteOptions) -> String {
    let ending = match options.encoding.format {
        Format::StlAscii => "ascii.stl",
        Format::PlyAscii => "ascii.ply",
        Format::PlyBigEndian => "big.ply",
        other => other.name(),
    };
    let float = if options.float { ".float" } else { "" };
    format!("{model}{float}.{ending}{}", if options.encoding.gzip { ".gz" } else { "" })
}

/// The line of the table that a file belongs to.
fn encoding_name(encoding: Encoding) -> String {
    if encoding.gzip { "gzip around any".to_owned() } else { encoding.format.name().to_owned() }
}

/// Why others cannot read the file of an exact format, if so.
fn alone(format: Format, bytes: &[u8]) -> Option<&'static str> {
    let has = |word: &[u8]| bytes.windows(word.len()).any(|window| window == word);
    match format {
        Format::Star => Some("the native format is read by this project only"),
        Format::Off if has(b"/") => Some("coordinates are fractions; others read the file with floats"),
        Format::Vrml if has(b"ExactCoordinate") => {
            Some("coordinates are in a PROTO with exact numbers; most others read the file with floats")
        }
        _ => None,
    }
}

/// Formats that hold triangles only.
fn has_only_triangles(format: Format) -> bool {
    matches!(format, Format::Stl | Format::StlAscii | Format::ThreeMf | Format::Glb)
}

impl Subject {
    fn new(name: &str, model: Model, formats: &'static [Format]) -> Result<Self, Failure> {
        let mesh = model.shape.mesh().ok_or("a model of the repository is a mesh")?;
        let volume =
            MeshSummary::of(mesh).volume.ok_or_else(|| format!("{name}: a model has a volume"))?.approx_f64();
        let triangles = mesh.facets.iter().map(|cycle| cycle.len() - 2).sum();
        Ok(Self { name: name.to_owned(), model, formats, triangles, volume })
    }

    /// Writes a file, reads it, compares, and describes it for the others.
    fn write(&self, folder: &Path, file: &str, options: &WriteOptions) -> Result<Value, Failure> {
        let Encoding { format, gzip } = options.encoding;
        let written = formats::write(&self.model, options)?;
        fs::write(folder.join(file), &written.bytes)?;
        let exact = matches!(format, Format::Off | Format::Vrml | Format::Star) && !options.float;
        if exact && !written.largest_rounding.is_zero() {
            return Err(format!("an exact format rounds by {}", written.largest_rounding).into());
        }
        if format != Format::Glb {
            let read = formats::read(&written.bytes, Some(file))?;
            self.compare(format, &read.model, &written.largest_rounding)?;
        }
        let mesh = self.model.shape.mesh().ok_or("a model of the repository is a mesh")?;
        // The unit of glTF is the meter.
        let scale = match self.model.unit {
            Some(unit) if format == Format::Glb => unit.meters().approx_f64(),
            _ => 1.0,
        };
        let mut unpacked = options.clone();
        unpacked.encoding.gzip = false;
        let alone = alone(format, &formats::write(&self.model, &unpacked)?.bytes);
        let corners = || mesh.facets.iter().map(<[u32]>::len);
        Ok(json!({
            "file": file,
            "format": format.name(),
            "row": encoding_name(options.encoding),
            "gzip": gzip,
            "vertices": mesh.points.len(),
            "corners": [corners().min(), corners().max()],
            "triangles": self.triangles,
            "volume": self.volume * scale.powi(3),
            "rounding": written.largest_rounding.approx_f64(),
            "unit": self.model.unit.map(Unit::name),
            "alone": alone,
        }))
    }

    /// Compares corner by corner: the largest difference is what the writer stated, which is nothing for an exact file.
    fn compare(&self, format: Format, read: &Model, stated: &Rational) -> Result<(), Failure> {
        let wanted = self.model.shape.mesh().ok_or("a model of the repository is a mesh")?;
        let triangulated;
        let wanted = if has_only_triangles(format) {
            triangulated = wanted.triangulated()?;
            &triangulated
        } else {
            wanted
        };
        let Shape::Mesh(read_mesh) = &read.shape else { return Err("read back as something else".into()) };
        let largest = largest_difference(wanted, read_mesh)?;
        if largest != *stated {
            return Err(format!("read back with a difference of {largest}, stated is {stated}").into());
        }
        let keeps_unit = matches!(format, Format::ThreeMf | Format::Star) && self.model.unit.is_some();
        if keeps_unit && read.unit != self.model.unit {
            return Err(format!("the unit is read back as {:?}", read.unit).into());
        }
        let keeps_objects = matches!(format, Format::Obj | Format::ThreeMf | Format::Vrml | Format::Star);
        if keeps_objects && !self.model.objects.is_empty() {
            // VRML takes identifiers only, and makes one of other names.
            let in_format = |name: &str| match format {
                Format::Vrml if name.contains(' ') => format!("_{}", name.replace(' ', "_")),
                _ => name.to_owned(),
            };
            let names = |model: &Model| model.objects.iter().map(|o| in_format(&o.name)).collect::<Vec<_>>();
            if names(&self.model) != names(read) {
                return Err(format!("the objects are read back as {:?}", names(read)).into());
            }
            let starts = |model: &Model| model.objects.iter().map(|o| o.first_facet).collect::<Vec<_>>();
            if !has_only_triangles(format) && starts(read) != starts(&self.model) {
                return Err("the objects begin elsewhere".into());
            }
        }
        Ok(())
    }
}

/// The largest difference of a coordinate between two meshes of the same facets.
fn largest_difference(wanted: &PolygonMesh, read: &PolygonMesh) -> Result<Rational, Failure> {
    let counts = |mesh: &PolygonMesh| (mesh.points.len(), mesh.facets.len());
    if counts(wanted) != counts(read) {
        let (vertices, facets) = counts(read);
        return Err(format!("read back with {vertices} vertices and {facets} facets").into());
    }
    let mut largest = Rational::from(0);
    for (at, (a, b)) in wanted.facets.iter().zip(read.facets.iter()).enumerate() {
        if a.len() != b.len() {
            return Err(format!("facet {at} is read back with {} corners", b.len()).into());
        }
        for (&p, &q) in a.iter().zip(b) {
            let (p, q) = (&wanted.points[p as usize], &read.points[q as usize]);
            for axis in 0..3 {
                let difference = (p.coordinate(axis) - q.coordinate(axis)).abs();
                if difference > largest {
                    largest = difference;
                }
            }
        }
    }
    Ok(largest)
}
