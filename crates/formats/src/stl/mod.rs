//! STL: triangles without indices, binary or as text.
//!
//! Corners at the same position are one vertex: there is no other way to tell which facets meet. Positions are equal
//! only if they are so exactly. Normals, attributes and the text of a binary header are ignored.
//!
//! | file | role |
//! |---|---|
//! | `mod` | which of the two a file is |
//! | `binary`, `ascii` | the readers |
//! | `weld` | the table of positions |
//! | `write` | the writers |

mod ascii;
mod binary;
mod weld;
mod write;

use crate::base::budget::Budget;
use crate::base::error::{Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::{ReadModel, ReadNote};
use crate::base::places::Place;
use crate::base::scan::Scanner;
pub(crate) use write::{takes_name, write_ascii, write_binary};

/// The bytes that tell a text from a binary file.
const START: usize = 1024;

/// Whether a file is binary STL: its length is the one that its header promises, and it is not the text.
///
/// `length` is that of the whole file, of which `start` has the first bytes.
pub(crate) fn is_binary(start: &[u8], length: usize) -> bool {
    binary::promised(start).is_some_and(|(_, promised)| promised == length as u64) && !begins_as_text(start)
}

/// Whether a longer file that begins like this may be binary STL: the header promises more, and so far every
/// corner is finite, or no facet has attributes.
pub(crate) fn may_be_binary(start: &[u8]) -> bool {
    let promises_more = binary::promised(start).is_some_and(|(_, promised)| promised > start.len() as u64);
    promises_more
        && has_zero(start)
        && (binary::corners_are_finite(start) || binary::attributes_are_zero(start))
}

/// Whether a file without a known name is binary STL of the wrong length rather than anything else: it has a zero
/// byte in its first 1024, and the length that its header promises for some facets is at least half of its own
/// and at most the double of it.
pub(crate) fn is_broken_binary(bytes: &[u8]) -> bool {
    let length = bytes.len() as u64;
    let is_near =
        |(count, promised): (u32, u64)| count > 0 && promised <= 2 * length && length <= 2 * promised;
    has_zero(bytes) && binary::promised(bytes).is_some_and(is_near)
}

/// Reads a file that is binary STL, or should be by its name.
pub(crate) fn read_binary(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    if is_binary(bytes, bytes.len()) || !is_text(bytes) {
        return binary::read(bytes, budget);
    }
    match Scanner::new(bytes).token() {
        None => Err(Fault::Empty.into()),
        Some(word) if word.bytes.eq_ignore_ascii_case(b"solid") => ascii::read(bytes, budget),
        Some(word) => Err(word.unexpected("`solid`, or the header of binary STL,")),
    }
}

/// Reads a file that begins with `solid`: the text, or a binary file whose header begins so.
pub(crate) fn read_ascii(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    if is_text(bytes) { ascii::read(bytes, budget) } else { binary::read(bytes, budget) }
}

fn is_text(bytes: &[u8]) -> bool {
    !has_zero(bytes)
}

/// Whether there is a zero byte at the start. Binary files have zeros: in the padding of their header, in their
/// attributes, in round numbers.
pub(crate) fn has_zero(bytes: &[u8]) -> bool {
    bytes[..bytes.len().min(START)].contains(&0)
}

/// Whether the second line of a file that begins with `solid` begins as in the text.
fn begins_as_text(start: &[u8]) -> bool {
    let mut scanner = Scanner::new(&start[..start.len().min(START)]);
    let is = |word: &[u8], keyword: &[u8]| word.eq_ignore_ascii_case(keyword);
    if !scanner.token().is_some_and(|token| is(token.bytes, b"solid")) {
        return false;
    }
    scanner.skip_line();
    scanner.token().is_some_and(|token| is(token.bytes, b"facet") || is(token.bytes, b"endsolid"))
}

/// Appends a facet, unless two of its corners are the same; gives whether it did.
#[inline]
fn add_facet(maker: &mut MeshMaker<'_>, cycle: [u32; 3], place: Place) -> Result<bool, Fault> {
    let [a, b, c] = cycle;
    if a == b || b == c || c == a {
        return Ok(false);
    }
    maker.facet(&cycle, place, 0)?;
    Ok(true)
}

fn note_dropped(maker: &mut MeshMaker<'_>, facets: usize) {
    if facets > 0 {
        maker.note(ReadNote::DegenerateDropped { facets });
    }
}
