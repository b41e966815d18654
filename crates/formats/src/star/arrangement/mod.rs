//! Arrangements as text: the kind `arrangement` of the native format.
//!
//! | file | role |
//! |---|---|
//! | `model` | the arrangements that a file can say |
//! | `family` | what differs from one family of curves to the other |
//! | `plane`, `torus`, `sphere` | the curves of each surface, written and read |
//! | `special` | vertices that stand for sides of the parameter space |
//! | `course` | what the text has as one curve |
//! | `write` | the one text of an arrangement |
//! | `read` | the door, and the grammar of records |
//! | `numbers` | numbers that are declared, and their lines |
//! | `curves` | curves as they are read, and the numbers in their records |
//! | `cells` | vertices, edges and boundaries, and whether they fit together |
//! | `around` | what is around a vertex, before it is known to be right |
//! | `finish` | an arrangement of them, or what is wrong with it, in numbers of the file |

mod around;
mod cells;
mod course;
mod curves;
mod family;
mod finish;
mod model;
mod numbers;
mod plane;
mod read;
mod special;
mod sphere;
mod torus;
mod write;

pub use family::StarText;
pub use model::{
    CellNumbers, LinearArrangement, PolycurveArrangement, SphereArrangement, SpherePolycurveArrangement,
    StarArrangement, TorusArrangement, TorusPolycurveArrangement,
};
pub use read::{read_arrangement, read_numbered_arrangement};
pub(super) use write::put_boundaries;
pub use write::write_arrangement;

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::star::line::Line;
use ::arrangement::models::GeodesicTraits;
use dcel::FaceId;

/// Writes the surface and the cells of an arrangement on the sphere, with what `put_of_face` writes behind the number of each face.
pub(super) fn put_sphere(
    arrangement: &SphereArrangement,
    text: &mut Vec<u8>,
    put_of_face: impl FnMut(&mut Vec<u8>, FaceId),
) {
    write::put_records::<GeodesicTraits, _>(arrangement, text, put_of_face);
}

/// Reads what follows `surface sphere`.
pub(super) fn read_sphere(line: &mut Line<'_>, budget: &mut Budget) -> Result<GeodesicTraits, Located> {
    <GeodesicTraits as family::Base>::read_surface(line, budget)
}
