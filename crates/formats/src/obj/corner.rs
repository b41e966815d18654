//! The corners of OBJ elements: `v`, `v/vt`, `v//vn` or `v/vt/vn`.

use crate::base::error::{Fault, Located};
use crate::base::scan::Token;
use crate::base::words::{bad_index, parse_u32};

/// What a corner looks like, for messages.
const FORMS: &str = "a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`";

/// Reads a corner, and gives the index of its vertex from 0 where so many vertices are known.
///
/// The other indices need only be whole numbers: nothing is done with what they name. Some programs leave
/// them out behind a slash, or write 0.
#[inline]
pub(super) fn read_corner(token: Token<'_>, vertices: u32) -> Result<u32, Located> {
    let Some(slash) = token.bytes.iter().position(|&byte| byte == b'/') else {
        return read_vertex(token, vertices);
    };
    let (vertex, others) = token.bytes.split_at(slash);
    let mut others = others[1..].split(|&byte| byte == b'/');
    let well_formed = others.by_ref().take(2).all(is_integer_or_nothing);
    if !well_formed || others.next().is_some() {
        return Err(token.unexpected(FORMS));
    }
    read_vertex(Token { bytes: vertex, line: token.line }, vertices)
}

/// From 1 on, or from -1 down for the last vertices so far.
#[inline]
fn read_vertex(token: Token<'_>, vertices: u32) -> Result<u32, Located> {
    let (digits, from_end) = match token.bytes {
        [b'-', digits @ ..] => (digits, true),
        digits => (digits, false),
    };
    let index = parse_u32(digits).filter(|&index| index <= vertices);
    match index {
        Some(0) => Err(token.fault(|token| Fault::BadIndex { token, first: 1 })),
        Some(index) if from_end => Ok(vertices - index),
        Some(index) => Ok(index - 1),
        None => Err(bad_index(token, vertices, 1)),
    }
}

fn is_integer_or_nothing(word: &[u8]) -> bool {
    match word {
        [] => true,
        [b'-', digits @ ..] => !digits.is_empty() && digits.iter().all(u8::is_ascii_digit),
        digits => digits.iter().all(u8::is_ascii_digit),
    }
}
