//! The archive: which files it has, and which of them is the model.

use super::element::shown;
use super::xml::{self, Xml};
use crate::base::budget::Budget;
use crate::base::error::{Fault, Located, ReadError};
use crate::format::Format;
use crate::gzip::Unpacked;
use std::io::Cursor;
use zip::result::ZipError;
use zip::{CompressionMethod, ZipArchive};

/// The relationships of the whole package.
const RELATIONSHIPS: &str = "_rels/.rels";
/// Where the model is if no relationship says so.
const USUAL: &str = "3D/3dmodel.model";
const RELATIONSHIPS_NAMESPACE: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
/// The type of the relationship to the model.
const MODEL_TYPE: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
/// What the list of files takes at most, for each byte that it has in the archive.
const LIST: u64 = 16;

type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

/// Finds and unpacks the model; gives its name in the archive and its bytes.
pub(super) fn model_part(bytes: &[u8], budget: &mut Budget) -> Result<(String, Vec<u8>), ReadError> {
    let whole = |fault: Fault| Located::from(fault).of_format(Format::ThreeMf);
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| whole(archive_fault(&error)))?;
    let list = (bytes.len() as u64).saturating_sub(archive.central_directory_start());
    budget.charge(LIST * list).map_err(whole)?;
    let target = match find(&archive, RELATIONSHIPS) {
        Some(index) => {
            let (part, bytes) = unpack(&mut archive, index, budget)?;
            target(&bytes).map_err(|error| in_part(&part, error))?
        }
        None => None,
    };
    if let Some(index) = find(&archive, target.as_deref().unwrap_or(USUAL)) {
        return unpack(&mut archive, index, budget);
    }
    Err(match target {
        Some(target) => in_part(
            RELATIONSHIPS,
            Fault::Packed { why: format!("it says that the model is {}, which is missing", shown(&target)) }
                .into(),
        ),
        None => whole(Fault::Unsupported {
            what: "a zip archive without a 3MF model".into(),
            instead: format!("a 3MF file has it as {USUAL}; give other files unpacked"),
        }),
    })
}

/// Names are compared as the Open Packaging Conventions say: ASCII letters in any case.
fn find(archive: &Archive<'_>, name: &str) -> Option<usize> {
    let name = name.trim_start_matches('/').as_bytes();
    (0..archive.len()).find(|&index| {
        archive.by_index_data(index).is_ok_and(|entry| {
            let raw = entry.name_raw();
            raw.strip_prefix(b"/").unwrap_or(raw).eq_ignore_ascii_case(name)
        })
    })
}

/// The first relationship to a model.
fn target(bytes: &[u8]) -> Result<Option<String>, Located> {
    let text = xml::text(bytes)?;
    let mut xml = Xml::new(text, RELATIONSHIPS_NAMESPACE);
    let root = xml.root("Relationships")?;
    let mut target = None;
    if root.has_content() {
        while let Some(element) = xml.child()? {
            if target.is_none() && element.is("Relationship") {
                let [kind, place] = element.attributes(["Type", "Target"])?;
                if kind.is_some_and(|kind| kind.trimmed() == MODEL_TYPE) {
                    target = place.map(|place| place.trimmed().to_string());
                }
            }
            xml.skip(&element)?;
        }
    }
    xml.finish("relationships")?;
    Ok(target)
}

/// Unpacks a file of the archive; gives its name and its bytes.
fn unpack(
    archive: &mut Archive<'_>,
    index: usize,
    budget: &mut Budget,
) -> Result<(String, Vec<u8>), ReadError> {
    let raw = archive.by_index_data(index).map(|entry| entry.name_raw().to_vec());
    let part = shown(&String::from_utf8_lossy(&raw.unwrap_or_default()));
    match unpack_bytes(archive, index, budget) {
        Ok(bytes) => Ok((part, bytes)),
        Err(fault) => Err(in_part(&part, fault.into())),
    }
}

fn unpack_bytes(archive: &mut Archive<'_>, index: usize, budget: &mut Budget) -> Result<Vec<u8>, Fault> {
    let unsupported =
        |what: String| Fault::Unsupported { what, instead: "pack the archive again with deflate".into() };
    let entry = archive.by_index_data(index).map_err(|error| archive_fault(&error))?;
    if entry.encrypted() {
        return Err(unsupported("an encrypted file".into()));
    }
    let method = entry.compression();
    if method != CompressionMethod::Stored && method != CompressionMethod::Deflated {
        return Err(unsupported(format!("a file packed by the method {method}")));
    }
    let mut entry = archive.by_index(index).map_err(|error| archive_fault(&error))?;
    let mut unpacked = Unpacked::within(budget);
    unpacked.fill(&mut entry)?;
    unpacked.finish()
}

fn archive_fault(error: &ZipError) -> Fault {
    match error {
        ZipError::UnsupportedArchive(_) | ZipError::CompressionMethodNotSupported(_) => Fault::Unsupported {
            what: "a zip archive of this kind (encrypted, in several volumes, or packed by a rare method)"
                .into(),
            instead: "pack it again with deflate".into(),
        },
        _ => Fault::Packed { why: "the list of the files in the zip archive is wrong, or missing".into() },
    }
}

fn in_part(part: &str, error: Located) -> ReadError {
    ReadError { part: Some(part.into()), ..error.of_format(Format::ThreeMf) }
}
