//! Tokens of a text with their line numbers.

/// A word of the text and the line it stands in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'a> {
    pub(crate) bytes: &'a [u8],
    pub(crate) line: u32,
}

impl Token<'_> {
    /// The token as an error message shows it: at most 40 characters, nothing unprintable. Quotes and backslashes are as they are.
    pub(crate) fn shown(&self) -> String {
        const LONGEST: usize = 40;
        let mut text: String = match std::str::from_utf8(self.bytes) {
            Ok(text) => with_quotes(text.escape_debug()).take(LONGEST + 1).collect(),
            Err(_) => with_quotes(self.bytes.escape_ascii().map(char::from)).take(LONGEST + 1).collect(),
        };
        if let Some((cut, _)) = text.char_indices().nth(LONGEST) {
            text.truncate(cut);
            text.push_str("...");
        }
        text
    }
}

/// Takes the backslashes before quotes and backslashes out of an escaped text.
fn with_quotes(escaped: impl Iterator<Item = char>) -> impl Iterator<Item = char> {
    let mut escaped = escaped.peekable();
    std::iter::from_fn(move || match escaped.next()? {
        '\\' => escaped.next_if(|next| matches!(next, '"' | '\'' | '\\')).or(Some('\\')),
        other => Some(other),
    })
}

/// Walks over the words of a text. Lines end with LF, CR LF or CR; `#` starts a comment that runs to
/// the end of its line.
#[derive(Clone)]
pub(crate) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
}

impl<'a> Scanner<'a> {
    /// Starts at the first line. A UTF-8 byte order mark is skipped.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
        Self { bytes, at, line: 1 }
    }

    /// Starts at this byte, the first of this line.
    pub(crate) fn starting_at(bytes: &'a [u8], at: usize, line: u32) -> Self {
        Self { bytes, at, line }
    }

    /// The next token of the current line, if there is one. Stays in the line.
    #[inline]
    pub(crate) fn token_in_line(&mut self) -> Option<Token<'a>> {
        while let Some(byte) = self.bytes.get(self.at) {
            match byte {
                b' ' | b'\t' | 0x0B | 0x0C => self.at += 1,
                b'\n' | b'\r' => return None,
                b'#' => {
                    self.skip_to_line_end();
                    return None;
                }
                _ => {
                    let start = self.at;
                    let rest = &self.bytes[start..];
                    self.at += rest.iter().position(|b| ends_token(*b)).unwrap_or(rest.len());
                    return Some(Token { bytes: &self.bytes[start..self.at], line: self.line });
                }
            }
        }
        None
    }

    /// The next token, in this line or in a later one; `None` at the end of the text.
    #[inline]
    pub(crate) fn token(&mut self) -> Option<Token<'a>> {
        loop {
            if let Some(token) = self.token_in_line() {
                return Some(token);
            }
            if !self.next_line() {
                return None;
            }
        }
    }

    /// Ignores what is left of the current line.
    #[inline]
    pub(crate) fn skip_line(&mut self) {
        self.skip_to_line_end();
        self.next_line();
    }

    /// The number of bytes not yet read.
    pub(crate) fn remaining(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// The last line that has a byte: where a text that is too short ends.
    pub(crate) fn last_line(&self) -> u32 {
        let after_break = self.at > 0 && matches!(self.bytes[self.at - 1], b'\n' | b'\r');
        if after_break && self.at == self.bytes.len() { self.line - 1 } else { self.line }
    }

    #[inline]
    fn skip_to_line_end(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
    }

    /// Steps over a line break; false at the end of the text. Must stand at one of the two.
    #[inline]
    fn next_line(&mut self) -> bool {
        match self.bytes.get(self.at) {
            None => return false,
            Some(b'\r') if self.bytes.get(self.at + 1) == Some(&b'\n') => self.at += 2,
            Some(_) => self.at += 1,
        }
        self.line = self.line.saturating_add(1);
        true
    }
}

#[inline]
fn ends_token(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0B | 0x0C | b'#')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_know_their_lines() {
        let mut scanner = Scanner::new(b"\xEF\xBB\xBFa b#c\r\n\n  # only\rd\n");
        let mut seen = Vec::new();
        while let Some(token) = scanner.token() {
            seen.push((token.shown(), token.line));
        }
        assert_eq!(seen, [("a".into(), 1), ("b".into(), 1), ("d".into(), 4)]);
        assert_eq!(scanner.last_line(), 4);
    }

    #[test]
    fn long_and_unprintable_tokens_are_shown_short() {
        let shown = |bytes: &[u8]| Token { bytes, line: 1 }.shown();
        assert_eq!(shown(b"1\xFF\x00"), "1\\xff\\x00");
        assert_eq!(shown("1,5\u{e9}".as_bytes()), "1,5\u{e9}");
        assert_eq!(shown(&[b'7'; 1000]).len(), 43);
        assert_eq!(shown(br#""a\"'b\n""#), r#""a\"'b\n""#);
        assert_eq!(shown(b"\"\\\xFF\t\""), "\"\\\\xff\\t\"");
    }
}
