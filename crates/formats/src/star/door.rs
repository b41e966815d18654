//! The way to the text of a kind that has a door of its own: unpacked, and refused by name if it is another format.

use super::first::StarKind;
use crate::base::budget::Budget;
use crate::base::error::{Fault, Located, ReadError};
use crate::base::places::Place;
use crate::base::scan::{Scanner, Token};
use crate::format::{Content, Encoding, Format};
use crate::gzip;

/// Reads a text of this kind, which begins with the word `star`, by `read_text`. Gzip may be around it.
pub(super) fn read_star<T>(
    bytes: &[u8],
    file_name: Option<&str>,
    kind: StarKind,
    read_text: impl FnOnce(&[u8], &mut Budget) -> Result<T, Located>,
) -> Result<T, ReadError> {
    read_packed(bytes, file_name, kind, read_text).map_err(|error| error.of_format(Format::Star))
}

fn read_packed<T>(
    bytes: &[u8],
    file_name: Option<&str>,
    kind: StarKind,
    read_text: impl FnOnce(&[u8], &mut Budget) -> Result<T, Located>,
) -> Result<T, Located> {
    let mut budget = Budget::of_file(bytes.len());
    if Format::of_content(bytes, bytes.len()) != Content::Gzip {
        check_unpacked(bytes, file_name, kind)?;
        return read_text(bytes, &mut budget);
    }
    let unpacked = gzip::unpack(bytes, &mut budget)?;
    if Format::of_content(&unpacked, unpacked.len()) == Content::Gzip {
        return Err(unsupported("gzip within gzip", "unpack it once").into());
    }
    check_unpacked(&unpacked, file_name, kind)?;
    read_text(&unpacked, &mut budget)
}

fn unsupported(what: &str, instead: &str) -> Fault {
    Fault::Unsupported { what: what.into(), instead: instead.into() }
}

fn check_unpacked(bytes: &[u8], file_name: Option<&str>, kind: StarKind) -> Result<(), Located> {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(unsupported("a text in UTF-16", "write it in UTF-8").into());
    }
    match Scanner::new(bytes).token().filter(|word| word.bytes != b"star") {
        Some(word) => Err(other_format(word, bytes, file_name, kind)),
        None => Ok(()),
    }
}

/// The file begins with another word than `star`.
#[cold]
fn other_format(word: Token<'_>, bytes: &[u8], file_name: Option<&str>, kind: StarKind) -> Located {
    let place = Place::Line(word.line);
    let by_name = file_name.and_then(Encoding::from_file_name).map(|encoding| encoding.format);
    let refused = |what: &str| {
        let what = format!("{what} as {}", kind.indefinite());
        let instead = format!("give a star file, which begins with `star 1 {}`", kind.name());
        Fault::Unsupported { what, instead }.at(place)
    };
    let format = match Format::of_content(bytes, bytes.len()) {
        Content::Known(format) => Some(format),
        Content::Unlikely(format) => Some(by_name.unwrap_or(format)),
        Content::Xml => return refused("XML"),
        Content::Json => return refused("JSON"),
        Content::Gzip | Content::Unknown => by_name,
    };
    match format.filter(|&format| format != Format::Star) {
        Some(format) => refused(&format!("a file of {format}")),
        None => word.unexpected(&format!("the first line `star 1 {}`", kind.name())),
    }
}
