//! Readers and writers of meshes, curves and arrangements with exact coordinates.
//!
//! A decimal in a file is the rational number that is written there, not the nearest float: `0.1` is
//! one tenth. Integers, decimals, exponents and fractions `p/q` may be mixed. A binary float is the dyadic rational
//! that it is. Nothing is rounded on the way in; on the way out only where the format has no exact numbers, and then
//! the largest rounding is reported.
//!
//! | layer | files | role |
//! |---|---|---|
//! | ground | `base` | models, places, errors, numbers, words, and the limit on memory |
//! | cells | `complex` | what only the native format can say |
//! | formats | `off`, `obj`, `stl`, `ply`, `threemf`, `gltf`, `vrml`, `star`, `gzip` | one folder each |
//! | arrangements | `star` | the native format, kind `arrangement`: [`read_arrangement`], [`read_numbered_arrangement`], [`write_arrangement`] |
//! | Gaussian maps | `star` | the native format, kind `gaussian`: [`read_gaussian_map`], [`write_gaussian_map`]; [`read`] gives the polytope |
//! | curves | `curves` | curves of the plane or of a torus, for arrangements: own text, WKT, GeoJSON; [`read_curves`], [`write_curves`]; points to ask about: [`read_points`]; on the sphere: [`read_sphere_curves`], [`read_sphere_points`], [`write_sphere_curves`] |
//! | placements | `placements` | rotations and translations of a model, one placement a line: [`read_placements`] |
//! | from the ones to the others | `arrange` | [`StarArrangement::of_curves`] |
//! | doors | `format`, `read`, `write` | which format a model has, and the way there and back |
//!
//! [`read`] takes files of models only: curves and arrangements have doors of their own. [`pack_gzip`] packs what any of the
//! writers gives; all readers unpack by themselves.
//!
//! The crate takes and gives bytes; it opens no file.
//!
//! ```
//! use splitstar_formats::{Format, Kind, WriteOptions, read, write};
//!
//! let text = b"OFF # a triangle\n3 1 3\n0 0 0\n0.5 0 0\n0 1/3 0\n3 0 1 2\n";
//! let model = read(text, None)?.model;
//! assert_eq!(model.shape.mesh().map(Kind::of), Some(Kind::Polygon));
//! let written = write(&model, &WriteOptions::new(Format::Off))?;
//! assert_eq!(written.bytes, b"OFF\n3 1 3\n0 0 0\n1/2 0 0\n0 1/3 0\n3 0 1 2\n");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arrange;
mod base;
mod complex;
mod curves;
mod format;
mod gltf;
mod gzip;
mod obj;
mod off;
mod placements;
mod ply;
mod read;
mod star;
mod stl;
mod threemf;
mod vrml;
mod write;

pub use arrange::{CurveError, CurveFault};
pub use base::error::{Count, Fault, NumberFault, ReadError};
pub use base::model::{Kind, Model, Object, ReadModel, ReadNote, Shape, Unit};
pub use base::places::{Place, PlaceList, Places};
pub use complex::{
    Cell, Complex, ComplexSummary, Edge, Facet, Loss, Malformed, Position, Rule, UnmarkedCells, Vertex,
};
pub use curves::{
    CurveFile, CurveNote, CurvePoint, InputCurve, PointFile, SphereCurve, SphereCurveFile, SpherePointFile,
    read_curves, read_points, read_sphere_curves, read_sphere_points, write_curves, write_periodic_curves,
    write_sphere_curves,
};
pub use format::{Encoding, Format};
pub use gzip::pack as pack_gzip;
pub use placements::{FilePlacement, read_placements};
pub use read::{check_start, read};
pub use star::{
    CellNumbers, LinearArrangement, PolycurveArrangement, SphereArrangement, SpherePolycurveArrangement,
    StarArrangement, StarGaussianMap, StarText, TorusArrangement, TorusPolycurveArrangement,
    read_arrangement, read_gaussian_map, read_numbered_arrangement, write_arrangement, write_gaussian_map,
};
pub use write::{WriteError, WriteNote, WriteOptions, Written, objects_of_triangles, write};
