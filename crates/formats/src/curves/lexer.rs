//! The tokens of a file of curves: words, strings and punctuation, in one line or across lines.

use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;

/// A place in the text, from which tokens are read. A copy of it comes back to the same place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lexer<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
}

/// What a byte does to a word that comes before it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    /// It goes on.
    Word,
    /// It ends.
    Blank,
    /// It ends, and the byte is a token by itself.
    Mark,
    /// It ends at a line break, a comment or a string.
    Other,
}

const CLASSES: [Class; 256] = {
    let mut classes = [Class::Word; 256];
    let sets: [(&[u8], Class); 3] =
        [(b" \t\x0B\x0C", Class::Blank), (b"(),;:[]{}", Class::Mark), (b"\n\r#\"", Class::Other)];
    let mut set = 0;
    while set < sets.len() {
        let mut at = 0;
        while at < sets[set].0.len() {
            classes[sets[set].0[at] as usize] = sets[set].1;
            at += 1;
        }
        set += 1;
    }
    classes
};

#[inline]
fn class(byte: u8) -> Class {
    CLASSES[usize::from(byte)]
}

impl<'a> Lexer<'a> {
    /// Starts at the first line, behind a UTF-8 byte order mark.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 }, line: 1 }
    }

    /// The line of the token that was read last, if none of a later line was looked at.
    pub(super) fn line(&self) -> u32 {
        self.line
    }

    /// The next token of the current line, if there is one. Stays in the line. A string that is not closed there runs
    /// to the end of the line; see [`text_of`].
    #[inline]
    pub(super) fn token_in_line(&mut self) -> Option<Token<'a>> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let first = *rest.first()?;
        let length = match class(first) {
            Class::Word => rest.iter().position(|&byte| class(byte) != Class::Word).unwrap_or(rest.len()),
            Class::Mark => 1,
            _ if first == b'"' => string_length(rest),
            _ => return None,
        };
        self.at += length;
        Some(Token { bytes: &rest[..length], line: self.line })
    }

    /// The next token, in this line or in a later one; `None` at the end of the text.
    #[inline]
    pub(super) fn token(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(token) = self.token_in_line() {
                return Some(token);
            }
            match self.bytes.get(self.at)? {
                b'\r' if self.bytes.get(self.at + 1) == Some(&b'\n') => self.at += 2,
                _ => self.at += 1,
            }
            self.line = self.line.saturating_add(1);
        }
    }

    /// The next token of the current line, which stays.
    pub(super) fn peek_in_line(&self) -> Option<Token<'a>> {
        self.clone().token_in_line()
    }

    /// The next token of the current line, which must be there: `expected` is a noun.
    #[inline]
    pub(super) fn expect_in_line(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        self.token_in_line()
            .ok_or_else(|| Fault::LineEnds { expected: expected.into() }.at(Place::Line(self.line)))
    }

    /// The next coordinate of a record of our own words, which must be there: `expected` is a noun.
    #[inline]
    pub(super) fn coordinate_in_line(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        let token = self.expect_in_line(expected)?;
        if is_separator(token) { Err(separated(token)) } else { Ok(token) }
    }

    /// The next coordinate of a record of our own words, if there is one.
    #[inline]
    pub(super) fn next_coordinate_in_line(&mut self) -> Result<Option<Token<'a>>, Located> {
        match self.token_in_line() {
            Some(token) if is_separator(token) => Err(separated(token)),
            token => Ok(token),
        }
    }

    /// The next token, in this line or in a later one, which must be there: `expected` is a noun.
    #[inline]
    pub(super) fn expect(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        self.token().ok_or_else(|| self.truncated(expected))
    }

    /// Nothing but a comment may follow in the line.
    #[inline]
    pub(super) fn end_line(&mut self) -> Result<(), Located> {
        match self.token_in_line() {
            None => Ok(()),
            Some(token) => Err(token.unexpected("the end of the line")),
        }
    }

    #[cold]
    fn truncated(&self, expected: &str) -> Located {
        let breaks = matches!(self.bytes.last(), Some(b'\n' | b'\r'));
        let line = if breaks { self.line.saturating_sub(1) } else { self.line };
        let expected = format!("{expected} was expected");
        Fault::Truncated { expected }.at(Place::Line(line.max(1)))
    }

    /// Skips blanks and a comment, up to the end of the line at most.
    #[inline]
    fn skip_blanks(&mut self) {
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b' ' | b'\t' | 0x0B | 0x0C => self.at += 1,
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
                }
                _ => return,
            }
        }
    }
}

/// What stands between the quotes of a string, escapes as they are; `None` if the token is none, or is not closed.
pub(super) fn text_of(token: Token<'_>) -> Option<&[u8]> {
    let [b'"', text @ .., b'"'] = token.bytes else { return None };
    // A quote behind a backslash is no end, unless that is behind another.
    let backslashes = text.iter().rev().take_while(|&&byte| byte == b'\\').count();
    backslashes.is_multiple_of(2).then_some(text)
}

#[inline]
fn is_separator(token: Token<'_>) -> bool {
    matches!(token.bytes, b"," | b";" | b":")
}

#[cold]
fn separated(token: Token<'_>) -> Located {
    token.fault(|mark| Fault::Malformed {
        why: format!("`{mark}` between coordinates; write a blank instead"),
    })
}

/// Whether a token is punctuation.
pub(super) fn is_mark(token: Token<'_>) -> bool {
    token.bytes.first().is_some_and(|&byte| class(byte) == Class::Mark)
}

/// The length of the string that a text begins with, up to the end of the line if it is not closed there.
fn string_length(text: &[u8]) -> usize {
    string_end(text)
        .unwrap_or_else(|| text.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(text.len()))
}

/// The place behind the quote that closes a string in its line. A backslash takes away the meaning of a quote.
fn string_end(text: &[u8]) -> Option<usize> {
    let mut escaped = false;
    for (at, byte) in text.iter().enumerate().skip(1) {
        match byte {
            b'\n' | b'\r' => return None,
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return Some(at + 1),
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(text: &[u8]) -> Vec<(String, u32)> {
        let mut lexer = Lexer::new(text);
        std::iter::from_fn(|| lexer.token()).map(|token| (token.shown(), token.line)).collect()
    }

    #[test]
    fn tokens_know_their_lines() {
        let seen = tokens(b"\xEF\xBB\xBFa(1,-2);#c (\r\n\r{\"k\":\n[]}# x");
        let seen: Vec<_> = seen.iter().map(|(text, line)| (text.as_str(), *line)).collect();
        let first = ["a", "(", "1", ",", "-2", ")", ";"].map(|text| (text, 1));
        let rest = [("{", 3), ("\"k\"", 3), (":", 3), ("[", 4), ("]", 4), ("}", 4)];
        assert_eq!(seen, [first.as_slice(), &rest].concat());
    }

    #[test]
    fn strings_end_in_their_line() {
        let rows = [
            ("\"a#b\" c", Some("a#b"), 5),
            ("\"\"", Some(""), 2),
            ("\"a\\\"b\"", Some("a\\\"b"), 6),
            ("\"a\\\\\"", Some("a\\\\"), 5),
            ("\"a\nb\"", None, 2),
            ("\"a\\\"", None, 4),
            ("\"", None, 1),
        ];
        for (text, inside, length) in rows {
            let token = Lexer::new(text.as_bytes()).token().unwrap();
            let found = (text_of(token), token.bytes.len());
            assert_eq!(found, (inside.map(str::as_bytes), length), "{text}");
        }
    }
}
