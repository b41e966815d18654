//! Bytes to a model, whatever their format.

use crate::base::budget::Budget;
use crate::base::error::{Fault, Located, ReadError};
use crate::base::model::ReadModel;
use crate::base::places::Place;
use crate::base::scan::Scanner;
use crate::format::{Content, Encoding, Format};
use crate::{gzip, obj, off, ply, star, stl, threemf, vrml};

/// Reads a file of any format.
///
/// The format is found by the content; where that can be of any, by the ending of the file's name. A file without a
/// known ending is taken for binary STL, so that the error tells what is wrong with it, if it has a zero byte in its
/// first 1024 and is at least half and at most twice as long as such a header promises. Nothing is rounded: a
/// decimal is the rational number that is written, a binary float is the dyadic rational that it is.
///
/// What a facet may be is checked (three vertices or more, all different, each one of the file), but not what the
/// facets form together. A file whose facets all have two vertices is a set of segments, one without facets a set of
/// points.
///
/// # Errors
/// The first thing wrong with the file. Nothing is allocated by what a file promises: what it takes to read a file
/// and to work on it is bounded by 64 times its length, as it is stored, and 64 MiB; a file that needs more is refused.
///
/// # Complexity
/// O(n) for n bytes, unpacked, and O(n log n) for star and for names and shared coordinates of VRML, as long as
/// coordinates have few digits.
///
/// ```
/// use splitstar_formats::{Format, read};
///
/// let triangle = b"v 0 0 0\nv 0.1 0 0\nv 0 1e2 0\nf 1 2 -1\n";
/// let read = read(triangle, None)?;
/// assert_eq!(read.format, Format::Obj);
/// let mesh = read.model.shape.mesh().expect("what OBJ can say is a mesh");
/// assert_eq!(mesh.points[1].coordinates()[0].to_string(), "1/10");
/// assert_eq!(mesh.facets.get(0), [0, 1, 2]);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read(bytes: &[u8], file_name: Option<&str>) -> Result<ReadModel, ReadError> {
    let by_name = file_name.and_then(Encoding::from_file_name).map(|encoding| encoding.format);
    let mut budget = Budget::of_file(bytes.len());
    if Format::of_content(bytes, bytes.len()) != Content::Gzip {
        return read_unpacked(bytes, by_name, &mut budget);
    }
    let unpacked = gzip::unpack(bytes, &mut budget).map_err(|Located { place, fault }| ReadError {
        format: None,
        part: None,
        place,
        fault,
    })?;
    read_unpacked(&unpacked, by_name, &mut budget)
}

fn read_unpacked(bytes: &[u8], by_name: Option<Format>, budget: &mut Budget) -> Result<ReadModel, ReadError> {
    let whole_file = |fault| ReadError { format: None, part: None, place: None, fault };
    let content = Format::of_content(bytes, bytes.len());
    let format = match (content, by_name) {
        (Content::Known(format), _) => format,
        (Content::Gzip, _) => {
            return Err(whole_file(Fault::Unsupported {
                what: "gzip within gzip".into(),
                instead: "unpack it once".into(),
            }));
        }
        (Content::Unknown | Content::Unlikely(_), _) if is_utf16(bytes) => {
            return Err(whole_file(Fault::Unsupported {
                what: "a text in UTF-16".into(),
                instead: "write it in UTF-8".into(),
            }));
        }
        (Content::Unknown | Content::Unlikely(_), Some(format)) => format,
        (Content::Unknown | Content::Unlikely(_), None) if stl::is_broken_binary(bytes) => Format::Stl,
        (Content::Unlikely(format), None) => format,
        (Content::Unknown | Content::Xml | Content::Json, _) => return Err(unknown(bytes, content)),
    };
    let result = match format {
        Format::Off => off::read(bytes, budget),
        Format::Obj => obj::read(bytes, budget),
        Format::Stl => stl::read_binary(bytes, budget),
        Format::StlAscii => stl::read_ascii(bytes, budget),
        Format::Ply | Format::PlyBigEndian | Format::PlyAscii => ply::read(bytes, budget),
        // Its errors name the file within the archive.
        Format::ThreeMf => return threemf::read(bytes, budget),
        Format::Glb => Err(Located::from(Fault::Unsupported {
            what: "glTF".into(),
            instead: "it is written only; give OBJ, STL, PLY or 3MF".into(),
        })),
        Format::Vrml => vrml::read(bytes, budget),
        Format::Star => star::read(bytes, budget),
    };
    result.map_err(|error| error.of_format(format))
}

/// Whether a text begins with the byte order mark of UTF-16.
fn is_utf16(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF")
}

/// Whether a file may be of some format, as far as its first bytes tell: 64 KiB of them, or all of a shorter file.
/// A program that reads a stream asks before it reads on: a stream may have no end.
///
/// # Errors
/// As [`read`] for a file that begins like this, if it is of no format.
pub fn check_start(start: &[u8], file_name: Option<&str>) -> Result<(), ReadError> {
    let content = Format::of_content(start, start.len());
    let known = matches!(content, Content::Known(_) | Content::Unlikely(_) | Content::Gzip)
        || (content == Content::Unknown && file_name.and_then(Encoding::from_file_name).is_some());
    if known || stl::may_be_binary(start) || stl::is_broken_binary(start) {
        Ok(())
    } else {
        Err(unknown(start, content))
    }
}

fn unknown(bytes: &[u8], content: Content) -> ReadError {
    let error = |place, fault| ReadError { format: None, part: None, place, fault };
    let unsupported = |what: &str, instead: &str| {
        error(Some(Place::Line(1)), Fault::Unsupported { what: what.into(), instead: instead.into() })
    };
    match (content, Scanner::new(bytes).token()) {
        (_, None) => error(None, Fault::Empty),
        (Content::Xml, _) => unsupported("bare XML (X3D, COLLADA, AMF, SVG)", "give OBJ, STL, PLY or 3MF"),
        (Content::Json, _) => unsupported("JSON (glTF as text)", "give OBJ, STL, PLY or 3MF"),
        (_, Some(token)) => {
            error(Some(Place::Line(token.line)), Fault::UnknownFormat { token: token.shown() })
        }
    }
}
