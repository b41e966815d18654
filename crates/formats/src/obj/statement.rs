//! The statements of an OBJ file and their words.

use crate::base::error::Located;
use crate::base::scan::{Scanner, Token};

/// Walks over the words of a text, statement by statement. A statement ends with its line, unless a backslash
/// stands at the end of the line.
pub(super) struct Statements<'a> {
    bytes: &'a [u8],
    scanner: Scanner<'a>,
    /// Where the last word begins, and where the statement does.
    word: usize,
    start: usize,
    line: u32,
}

impl<'a> Statements<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, scanner: Scanner::new(bytes), word: 0, start: 0, line: 1 }
    }

    /// Ignores what is left of the statement.
    #[inline]
    pub(super) fn finish(&mut self) {
        while self.word().is_some() {}
    }

    /// The first word of the next statement.
    #[inline]
    pub(super) fn next(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(word) = self.word() {
                (self.start, self.line) = (self.word, word.line);
                return Some(word);
            }
            if self.scanner.remaining() == 0 {
                return None;
            }
            self.scanner.skip_line();
        }
    }

    /// The next word of the statement.
    #[inline]
    pub(super) fn word(&mut self) -> Option<Token<'a>> {
        loop {
            let token = self.scanner.token_in_line()?;
            self.word = self.at() - token.bytes.len();
            let [bytes @ .., b'\\'] = token.bytes else { return Some(token) };
            if !matches!(self.bytes.get(self.at()), None | Some(b'\n' | b'\r')) {
                return Some(token);
            }
            self.scanner.skip_line();
            if !bytes.is_empty() {
                return Some(Token { bytes, line: token.line });
            }
        }
    }

    /// What is left of the line, without blanks around it: a name, in which a `#` behind a blank starts a
    /// comment.
    pub(super) fn name(&self) -> &'a [u8] {
        let rest = &self.bytes[self.at()..];
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let line = &rest[..end];
        let comment =
            (0..end).find(|&at| line[at] == b'#' && (at == 0 || line[at - 1].is_ascii_whitespace()));
        let name = line[..comment.unwrap_or(end)].trim_ascii();
        name.strip_suffix(b"\\").unwrap_or(name).trim_ascii_end()
    }

    /// Checks how many words are left in the statement.
    pub(super) fn count_words(&mut self, least: usize, most: usize, expected: &str) -> Result<(), Located> {
        let mut words = 0_usize;
        while self.word().is_some() {
            words += 1;
        }
        if (least..=most).contains(&words) { Ok(()) } else { Err(self.unexpected(expected)) }
    }

    /// A statement that was expected to be something else.
    #[cold]
    pub(super) fn unexpected(&self, expected: &str) -> Located {
        let text = &self.bytes[self.start..self.at()];
        let end = text.iter().position(|&byte| byte == b'#').unwrap_or(text.len());
        Token { bytes: text[..end].trim_ascii(), line: self.line }.unexpected(expected)
    }

    /// Where the next word is looked for.
    #[inline]
    fn at(&self) -> usize {
        self.bytes.len() - self.scanner.remaining()
    }
}
