//! PLY: elements with properties, as text or binary in either byte order.
//!
//! | files | role |
//! |---|---|
//! | `double` | points to doubles |
//! | `scalar` | the types of numbers, and their bytes |
//! | `header` | which elements there are, and what a reader does at each of their properties |
//! | `ascii`, `binary` | the records of the elements |
//! | `write` | the three variants, written |

mod ascii;
mod binary;
mod double;
mod header;
mod scalar;
mod write;

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::model::ReadModel;
use crate::format::Format;

pub(crate) use write::write;

/// Reads a PLY file.
///
/// An element `vertex` has the points: its properties x, y and z, of any type and in any order. Behind it an
/// element `face` has the facets: its list `vertex_indices` or `vertex_index` of any integer type. Where
/// there is no facet, an element `edge` with `vertex1` and `vertex2` has segments; beside facets it is
/// decoration and skipped, as all other elements and properties are.
///
/// A binary float is the dyadic rational that it is. A number in a text is the rational number that is
/// written, be the type of its property what it may. In a text a record may be continued on the next line,
/// but a line has words of one record only.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let header = header::read(bytes, budget)?;
    match header.format {
        Format::PlyAscii => ascii::read(bytes, &header, budget),
        _ => binary::read(bytes, &header, budget),
    }
}
