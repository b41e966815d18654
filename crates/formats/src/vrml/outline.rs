//! One walk over the whole text, before anything is made of it.

use super::lexer::{Kind, Lexer, string_length};
use crate::base::budget::Budget;
use crate::base::error::{At, Located};
use std::collections::BTreeMap;

/// The nodes that have names, in a text whose brackets and strings are closed.
pub(super) struct Outline<'a> {
    /// By name and by the offset of the node: a name may be given again.
    nodes: BTreeMap<(&'a [u8], usize), Lexer<'a>>,
}

/// What an entry of the map takes, at most.
const ENTRY: u64 = 128;

impl<'a> Outline<'a> {
    /// Checks brackets and strings, and notes the places of `DEF`. Names within a `PROTO` are its own, and
    /// stay there.
    pub(super) fn of_text(mut lexer: Lexer<'a>, budget: &mut Budget) -> Result<Self, Located> {
        let mut nodes = BTreeMap::new();
        let mut open: Vec<(u8, u32)> = Vec::new();
        // How many brackets are open around the outermost PROTO.
        let mut proto: Option<usize> = None;
        while let Some(token) = lexer.next() {
            match (Kind::of(token), token.bytes) {
                (Kind::Open, bracket) => {
                    if open.len() == open.capacity() {
                        budget.charge(16 * (open.len() as u64 + 4)).at_line(token.line)?;
                    }
                    open.push((bracket[0], token.line));
                }
                (Kind::Close, bracket) => {
                    let opening = if bracket == b"}" { b'{' } else { b'[' };
                    match open.pop() {
                        Some((last, _)) if last == opening => {}
                        Some((last, line)) => {
                            let close = closing(last);
                            return Err(token.unexpected(&format!(
                                "`{close}`, for the `{}` of line {line},",
                                char::from(last)
                            )));
                        }
                        None => return Err(token.unexpected("a node")),
                    }
                    if bracket == b"}" && proto == Some(open.len()) {
                        proto = None;
                    }
                }
                (Kind::String, string) if string_length(string) != Some(string.len()) => {
                    return Err(lexer.truncated(format!(
                        "the `\"` was expected that closes the string of line {}",
                        token.line
                    )));
                }
                (Kind::Word, b"PROTO") => proto = proto.or(Some(open.len())),
                (Kind::Word, b"DEF") => {
                    let name = lexer.word("a name")?;
                    if proto.is_none() {
                        budget.charge(ENTRY).at_line(token.line)?;
                        nodes.insert((name.bytes, lexer.offset()), lexer);
                    }
                }
                _ => {}
            }
        }
        if let Some((last, line)) = open.pop() {
            let close = closing(last);
            return Err(lexer.truncated(format!(
                "`{close}` was expected, for the `{}` of line {line}",
                char::from(last)
            )));
        }
        Ok(Self { nodes })
    }

    /// The place of the node that had this name last, before an offset.
    pub(super) fn find(&self, name: &'a [u8], before: usize) -> Option<Lexer<'a>> {
        let (_, node) = self.nodes.range((name, 0)..(name, before)).next_back()?;
        Some(*node)
    }
}

fn closing(open: u8) -> char {
    if open == b'{' { '}' } else { ']' }
}
