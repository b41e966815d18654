//! The tokens of VRML: words, strings and brackets.

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

/// What a token is. The bytes of a string include its quotes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Open,
    Close,
    String,
    /// It begins like a number.
    Number,
    Word,
}

impl Kind {
    #[inline]
    pub(super) fn of(token: Token<'_>) -> Self {
        match token.bytes.first() {
            Some(b'{' | b'[') => Self::Open,
            Some(b'}' | b']') => Self::Close,
            Some(b'"') => Self::String,
            Some(b'0'..=b'9' | b'+' | b'-' | b'.') => Self::Number,
            _ => Self::Word,
        }
    }
}

impl<'a> Lexer<'a> {
    /// Starts at the first line, behind a UTF-8 byte order mark.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 }, line: 1 }
    }

    /// How many bytes of the text are read.
    pub(super) fn offset(&self) -> usize {
        self.at
    }

    /// The next token; `None` at the end of the text. Commas are blanks, `#` starts a comment. A string that
    /// is not closed runs to the end.
    #[inline]
    pub(super) fn next(&mut self) -> Option<Token<'a>> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let line = self.line;
        let length = match rest.first()? {
            b'{' | b'}' | b'[' | b']' => 1,
            b'"' => {
                let length = string_length(rest).unwrap_or(rest.len());
                (0..length).for_each(|offset| self.count_line(self.at + offset));
                length
            }
            _ => rest.iter().position(|&byte| ends_word(byte)).unwrap_or(rest.len()),
        };
        self.at += length;
        Some(Token { bytes: &rest[..length], line })
    }

    /// The next token, which stays.
    #[inline]
    pub(super) fn peek(&self) -> Option<Token<'a>> {
        self.clone().next()
    }

    /// Whether the next token is this bracket or word.
    #[inline]
    pub(super) fn is_next(&self, token: &[u8]) -> bool {
        self.peek().is_some_and(|next| next.bytes == token)
    }

    /// The next token, which there must be.
    #[inline]
    pub(super) fn token(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        self.next().ok_or_else(|| self.truncated(format!("{expected} was expected")))
    }

    /// The next token, a word.
    pub(super) fn word(&mut self, expected: &str) -> Result<Token<'a>, Located> {
        let token = self.token(expected)?;
        if Kind::of(token) == Kind::Word { Ok(token) } else { Err(token.unexpected(expected)) }
    }

    /// The next token, this bracket.
    pub(super) fn bracket(&mut self, bracket: &str) -> Result<Token<'a>, Located> {
        let expected = format!("`{bracket}`");
        let token = self.token(&expected)?;
        if token.bytes == bracket.as_bytes() { Ok(token) } else { Err(token.unexpected(&expected)) }
    }

    /// The file ends too early.
    #[cold]
    pub(super) fn truncated(&self, expected: String) -> Located {
        let breaks = self.bytes.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r'));
        let line = if breaks { self.line.saturating_sub(1) } else { self.line };
        Fault::Truncated { expected }.at(Place::Line(line.max(1)))
    }

    /// Passes over everything up to the bracket that closes the last one.
    pub(super) fn skip_to_close(&mut self) -> Result<(), Located> {
        let mut depth = 1_usize;
        while depth > 0 {
            match Kind::of(self.token("a closing bracket")?) {
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                _ => {}
            }
        }
        Ok(())
    }

    /// Passes over the value of a field of any type.
    pub(super) fn skip_value(&mut self) -> Result<(), Located> {
        loop {
            let token = self.token("a value")?;
            match (Kind::of(token), token.bytes) {
                (Kind::Open, b"[") => return self.skip_to_close(),
                (Kind::Open | Kind::Close, _) => return Err(token.unexpected("a value")),
                (Kind::String, _) => return Ok(()),
                (Kind::Number, _) => {
                    while self.peek().is_some_and(|next| Kind::of(next) == Kind::Number) {
                        self.next();
                    }
                    return Ok(());
                }
                (Kind::Word, b"USE" | b"IS") => return self.word("a name").map(|_| ()),
                // A node follows.
                (Kind::Word, b"DEF") => self.word("a name").map(|_| ())?,
                (Kind::Word, _) => {
                    if self.is_next(b"{") {
                        self.next();
                        return self.skip_to_close();
                    }
                    return Ok(());
                }
            }
        }
    }

    /// Passes over a statement that is no node, if this is the first word of one.
    pub(super) fn skip_statement(&mut self, word: Token<'_>) -> Result<bool, Located> {
        match word.bytes {
            b"PROTO" | b"EXTERNPROTO" => {
                self.word("the name of a node type")?;
                self.bracket("[")?;
                self.skip_to_close()?;
                if word.bytes == b"EXTERNPROTO" {
                    self.skip_value()?;
                } else {
                    self.bracket("{")?;
                    self.skip_to_close()?;
                }
            }
            b"ROUTE" => {
                for expected in ["a field that a route begins at", "`TO`", "a field that a route ends at"] {
                    self.word(expected)?;
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Reads the fields of a node up to its closing bracket, and gives the places of the values of some.
    pub(super) fn fields<const N: usize>(
        &mut self,
        wanted: [&str; N],
    ) -> Result<[Option<Lexer<'a>>; N], Located> {
        let mut values = [None; N];
        loop {
            let token = self.token("a field or `}`")?;
            match Kind::of(token) {
                Kind::Close => return Ok(values),
                Kind::Word if self.skip_statement(token)? => continue,
                Kind::Word => {}
                _ => return Err(token.unexpected("a field or `}`")),
            }
            if let Some(at) = wanted.iter().position(|name| name.as_bytes() == token.bytes)
                && values[at].replace(*self).is_some()
            {
                return Err(token.unexpected("a field that the node does not yet have"));
            }
            self.skip_value()?;
        }
    }

    #[inline]
    fn skip_blanks(&mut self) {
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
                }
                0..=b' ' | b',' => {
                    self.count_line(self.at);
                    self.at += 1;
                }
                _ => break,
            }
        }
    }

    /// Counts the line break that this byte may be the end of.
    #[inline]
    fn count_line(&mut self, at: usize) {
        let ends = match self.bytes[at] {
            b'\n' => true,
            b'\r' => self.bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        };
        self.line = self.line.saturating_add(u32::from(ends));
    }
}

/// The length of a string with its quotes; `None` if it is not closed. A backslash takes away the meaning of
/// a quote.
pub(super) fn string_length(text: &[u8]) -> Option<usize> {
    let mut escaped = false;
    for (at, byte) in text.iter().enumerate().skip(1) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return Some(at + 1),
            _ => {}
        }
    }
    None
}

#[inline]
fn ends_word(byte: u8) -> bool {
    matches!(byte, 0..=b' ' | b',' | b'#' | b'"' | b'{' | b'}' | b'[' | b']')
}
