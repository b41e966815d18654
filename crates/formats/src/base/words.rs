//! Words of a text that are numbers, counts or indices.

use super::error::{At, Count, Fault, Located};
use super::number::{Number, parse_number};
use super::places::Place;
use super::scan::Token;

impl Token<'_> {
    /// A fault with this word in it, at its line.
    #[cold]
    pub(crate) fn fault(&self, fault: impl FnOnce(String) -> Fault) -> Located {
        fault(self.shown()).at(Place::Line(self.line))
    }

    /// Something else was expected.
    pub(crate) fn unexpected(&self, expected: &str) -> Located {
        self.fault(|found| Fault::Syntax { found, expected: expected.into() })
    }
}

/// Reads an integer, a decimal or a fraction.
#[inline]
pub(crate) fn read_coordinate(token: Token<'_>) -> Result<Number, Located> {
    parse_number(token.bytes)
        .map_err(|fault| Fault::BadNumber { token: token.shown(), fault })
        .at_line(token.line)
}

/// Reads a number of things.
pub(crate) fn read_count(token: Token<'_>, of: Count) -> Result<u32, Located> {
    if !token.bytes.iter().all(u8::is_ascii_digit) {
        return Err(token.fault(|token| Fault::BadCount { token, of }));
    }
    match parse_u32(token.bytes) {
        Some(count) if count < u32::MAX => Ok(count),
        _ => Err(token.fault(|token| Fault::CountTooLarge { token, of })),
    }
}

/// Reads the index of one of `vertices` vertices, where the format gives the first of them the index `first`; the
/// result counts from 0.
#[inline]
pub(crate) fn read_index(token: Token<'_>, vertices: u32, first: u32) -> Result<u32, Located> {
    let index = parse_u32(token.bytes).and_then(|index| index.checked_sub(first));
    index.filter(|&index| index < vertices).ok_or_else(|| bad_index(token, vertices, first))
}

/// What is wrong with a word that is no index.
#[cold]
pub(crate) fn bad_index(token: Token<'_>, vertices: u32, first: u32) -> Located {
    let digits = token.bytes.strip_prefix(b"-").unwrap_or(token.bytes);
    token.fault(|index| {
        if !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) {
            Fault::IndexOutOfRange { index, vertices, first }
        } else {
            Fault::BadIndex { token: index, first }
        }
    })
}

/// Decimal digits only; `None` if there is something else, or if the value does not fit.
#[inline]
pub(crate) fn parse_u32(digits: &[u8]) -> Option<u32> {
    if digits.is_empty() {
        return None;
    }
    digits.iter().try_fold(0_u32, |value, byte| {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value.checked_mul(10)?.checked_add(u32::from(digit))
    })
}
