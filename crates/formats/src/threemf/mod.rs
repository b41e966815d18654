//! 3MF: a zip archive with a model in XML.
//!
//! | layer | files | role |
//! |---|---|---|
//! | archive | `package` | the files within the archive, and which of them is the model |
//! | text | `xml`, `element` | elements and attributes with their lines, read one after the other |
//! | model | `outline`, `transform` | which objects there are, and how they are put together |
//! | mesh | `instance` | the vertices and facets of all that is built |
//! | way back | `write` | the archive of a mesh |
//!
//! 1. The part with the model is found and unpacked.
//! 2. Its outline is read: for every object where its mesh stands or which components it has, and what is built.
//! 3. For every item of the build, the meshes that it is made of are read where they stand, straight into the model.
//!
//! The text of a mesh is read once for the outline and once for each of its instances, so that a large file takes no
//! memory beside its text and its mesh.

mod element;
mod instance;
mod outline;
mod package;
mod transform;
mod write;
mod xml;

use crate::base::budget::Budget;
use crate::base::error::{Located, ReadError};
use crate::base::model::ReadModel;
use crate::format::Format;

pub(crate) use write::{DEFAULT_UNIT, takes_name, write};

/// The namespace of the model.
const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";

/// Reads a 3MF file: all that its build has, in its unit.
///
/// Each item of the build is an object of the model, with the name of the object that it refers to, or else the part
/// number; the facets of a first item without either belong to no object. Transforms are applied exactly; where one mirrors, the facets are turned round. Objects that are not
/// built are not read, nor are supports. A file that builds nothing gives all objects that are no component of
/// others. Materials and other properties are skipped. An extension that the file requires and that changes shapes
/// is refused.
///
/// Decimals are exact; a fraction `p/q`, which the standard does not know, is read as well.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, ReadError> {
    let (part, text) = package::model_part(bytes, budget)?;
    match read_part(&text, budget) {
        Ok(mut read) => {
            read.places.part = Some(part);
            Ok(read)
        }
        Err(error) => Err(ReadError { part: Some(part), ..error.of_format(Format::ThreeMf) }),
    }
}

fn read_part(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let text = xml::text(bytes)?;
    let outline = outline::read(text, budget)?;
    instance::read(text, &outline, budget)
}
