//! Lines of a star file, their words and quoted names.

use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;

/// Walks over the lines of a text, which end with LF, CR LF or CR.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    /// The number of the last line that was given.
    number: u32,
}

/// A line, or what is left of it.
pub(super) struct Line<'a> {
    rest: &'a [u8],
    pub(super) number: u32,
}

impl<'a> Lines<'a> {
    /// A UTF-8 byte order mark is skipped.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes), number: 0 }
    }

    /// The next line; `None` behind the last break.
    pub(super) fn next(&mut self) -> Option<Line<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let length = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(length);
        self.rest = match rest {
            [b'\r', b'\n', rest @ ..] | [_, rest @ ..] => rest,
            [] => rest,
        };
        self.number = self.number.saturating_add(1);
        Some(Line { rest: line, number: self.number })
    }

    /// The next line that has a word, and this word.
    pub(super) fn next_record(&mut self) -> Option<(Token<'a>, Line<'a>)> {
        loop {
            let mut line = self.next()?;
            if let Some(word) = line.word() {
                return Some((word, line));
            }
        }
    }

    /// The place where a file that is too short ends.
    pub(super) fn last(&self) -> Place {
        Place::Line(self.number)
    }
}

impl<'a> Line<'a> {
    fn skip_blanks(&mut self) {
        let blanks = self.rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t' | 0x0B | 0x0C)).count();
        self.rest = &self.rest[blanks..];
        if self.rest.first() == Some(&b'#') {
            self.rest = &[];
        }
    }

    /// The next word, which is never empty. A comment is none.
    pub(super) fn word(&mut self) -> Option<Token<'a>> {
        self.skip_blanks();
        let ends_word = |byte: &u8| matches!(byte, b' ' | b'\t' | 0x0B | 0x0C | b'#');
        let length = self.rest.iter().position(ends_word).unwrap_or(self.rest.len());
        let (bytes, rest) = self.rest.split_at(length);
        self.rest = rest;
        (length > 0).then_some(Token { bytes, line: self.number })
    }

    /// The next word, which must be there.
    pub(super) fn expect(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        self.word().ok_or_else(|| self.ends_before(expected))
    }

    /// Nothing but a comment may follow.
    pub(super) fn end(&mut self) -> Result<(), Located> {
        match self.word() {
            None => Ok(()),
            Some(word) => Err(word.unexpected("the end of the line")),
        }
    }

    #[cold]
    fn ends_before(&self, expected: &str) -> Located {
        Fault::LineEnds { expected: expected.into() }.at(Place::Line(self.number))
    }

    /// A name in quotes.
    pub(super) fn name(&mut self) -> Result<String, Located> {
        const NAME: &str = "a name in quotes";
        self.skip_blanks();
        let [b'"', body @ ..] = self.rest else {
            let word = self.expect(NAME)?;
            return Err(word.unexpected(NAME));
        };
        let mut escaped = false;
        let end = body.iter().position(|&byte| {
            let ends = byte == b'"' && !escaped;
            escaped = byte == b'\\' && !escaped;
            ends
        });
        let end = end.ok_or_else(|| self.ends_before("the quote `\"` that ends the name"))?;
        let quoted = Token { bytes: &self.rest[..end + 2], line: self.number };
        self.rest = &body[end + 1..];
        let text = std::str::from_utf8(&body[..end]).map_err(|_| quoted.unexpected("a name in UTF-8"))?;
        unescaped(text)
            .ok_or_else(|| quoted.unexpected("a name with the escapes `\\\"`, `\\\\`, `\\n`, `\\u{..}` only"))
    }
}

fn unescaped(text: &str) -> Option<String> {
    let mut name = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((plain, escape)) = rest.split_once('\\') {
        name.push_str(plain);
        let mut after = escape.chars();
        match after.next()? {
            'n' => name.push('\n'),
            same @ ('"' | '\\') => name.push(same),
            'u' => {
                let (digits, tail) = after.as_str().strip_prefix('{')?.split_once('}')?;
                if !(1..=6).contains(&digits.len()) || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
                    return None;
                }
                name.push(char::from_u32(u32::from_str_radix(digits, 16).ok()?)?);
                after = tail.chars();
            }
            _ => return None,
        }
        rest = after.as_str();
    }
    name.push_str(rest);
    Some(name)
}

/// Writes a name in quotes. Control characters are escaped, so that it stays in its line.
pub(super) fn put_name(text: &mut Vec<u8>, name: &str) {
    text.push(b'"');
    for character in name.chars() {
        match character {
            '"' => text.extend_from_slice(b"\\\""),
            '\\' => text.extend_from_slice(b"\\\\"),
            '\n' => text.extend_from_slice(b"\\n"),
            other if other.is_control() => {
                crate::base::numerals::put(text, format_args!("{}", other.escape_unicode()))
            }
            other => text.extend_from_slice(other.encode_utf8(&mut [0; 4]).as_bytes()),
        }
    }
    text.push(b'"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back() {
        for name in ["", "a b", "# \"x\" \\ y\n", "\r\t\u{85}\u{1F600}\0", "\\u{41}", "e\u{301}"] {
            let mut text = Vec::new();
            put_name(&mut text, name);
            text.extend_from_slice(b" next");
            let mut lines = Lines::new(&text);
            let mut line = lines.next().unwrap();
            assert_eq!(line.name().unwrap(), name);
            assert_eq!(line.word().unwrap().bytes, b"next");
            assert!(lines.next().is_none());
        }
    }

    #[test]
    fn lines_end_in_three_ways() {
        let mut lines = Lines::new(b"\xEF\xBB\xBFa\r\n\rb#c\n d");
        let mut seen = Vec::new();
        while let Some((word, line)) = lines.next_record() {
            seen.push((word.shown(), line.number));
        }
        assert_eq!(seen, [("a".into(), 1), ("b".into(), 3), ("d".into(), 4)]);
        assert_eq!(lines.last(), Place::Line(4));
    }
}
