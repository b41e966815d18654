//! Curves of the plane, of a flat torus or of the sphere, as text: what an arrangement is made of.
//!
//! | files | role |
//! |---|---|
//! | `model` | the curves, the notes |
//! | `lexer` | tokens, in one line or across lines |
//! | `maker` | points and curves within the budget; repeated points |
//! | `read` | the doors, for curves and for points alone |
//! | `plane`, `sphere` | points, and the lines of our own grammar |
//! | `wkt`, `geojson` | the two other grammars that may stand in a line |
//! | `write` | the way out |
//!
//! The grammar is in `docs/curves.md`. A file has one record after the other, each of which begins a line; geometries of
//! WKT may go on in the next line while a parenthesis is open, and so may GeoJSON objects. So a file that is one GeoJSON
//! object is no case of its own.
//!
//! GeoJSON is read by a small reader of our own and not by `serde_json`: coordinates have to be exact, errors and curves
//! need their lines, and what is skipped must take no memory.

mod geojson;
mod lexer;
mod maker;
mod model;
mod plane;
mod read;
mod sphere;
mod wkt;
mod write;

pub(crate) use read::{of_no_format, read_packed, unsupported};
pub(crate) use sphere::{SphereFault, check_sphere_curve};

pub use model::{
    CurveFile, CurveNote, CurvePoint, InputCurve, PointFile, SphereCurve, SphereCurveFile, SpherePointFile,
};
pub use read::{read_curves, read_points, read_sphere_curves, read_sphere_points};
pub use write::{write_curves, write_periodic_curves, write_sphere_curves};

/// How deep brackets of WKT and GeoJSON may be nested.
const DEPTH: u32 = 64;
