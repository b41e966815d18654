//! One walk over the whole text, before anything is made of it.

use super::lexer::{Kind, Lexer, string_length};
use crate::base::budget::Budget;
use crate::base::error::{At, Located};
use crate::base::scan::Token;
use std::collections::BTreeMap;

/// The nodes that have names, and the types of nodes with shapes, in a text whose brackets and strings are closed.
pub(super) struct Outline<'a> {
    /// By name and by the offset of the node: a name may be given again.
    nodes: BTreeMap<(&'a [u8], usize), Lexer<'a>>,
    prototypes: Prototypes<'a>,
}

/// The types of nodes that the file defines and that have shapes in them, or may have.
type Prototypes<'a> = BTreeMap<&'a [u8], Content>;

/// What is behind the name of such a type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Content {
    /// The definition, or the default of one of its fields, has shapes in it, or nodes that have.
    Shapes,
    /// The definition stands in another file.
    Elsewhere,
}

/// The type that is read even if another file defines it.
const KNOWN: &[u8] = b"ExactCoordinate";

/// What an entry of the map takes, at most.
const ENTRY: u64 = 128;

impl<'a> Outline<'a> {
    /// Checks brackets and strings, and notes the places of `DEF`. Names within a `PROTO` are its own, and
    /// stay there.
    pub(super) fn of_text(mut lexer: Lexer<'a>, budget: &mut Budget) -> Result<Self, Located> {
        let mut nodes = BTreeMap::new();
        let mut prototypes = Prototypes::new();
        let mut open: Vec<(u8, u32)> = Vec::new();
        // The outermost PROTO around this place, and how many brackets are open around it.
        let mut proto: Option<(usize, Token<'a>)> = None;
        let mut has_shapes = false;
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
                    if let Some((_, name)) =
                        proto.filter(|(depth, _)| bracket == b"}" && *depth == open.len())
                    {
                        if has_shapes {
                            budget.charge(ENTRY).at_line(token.line)?;
                            prototypes.insert(name.bytes, Content::Shapes);
                        }
                        (proto, has_shapes) = (None, false);
                    }
                }
                (Kind::String, string) if string_length(string) != Some(string.len()) => {
                    return Err(lexer.truncated(format!(
                        "the `\"` was expected that closes the string of line {}",
                        token.line
                    )));
                }
                (Kind::Word, b"PROTO") if proto.is_none() => {
                    let name = lexer.word("the name of a node type")?;
                    proto = Some((open.len(), name));
                }
                (Kind::Word, b"EXTERNPROTO") => {
                    let name = lexer.word("the name of a node type")?;
                    if name.bytes != KNOWN {
                        budget.charge(ENTRY).at_line(token.line)?;
                        prototypes.insert(name.bytes, Content::Elsewhere);
                    }
                }
                (Kind::Word, b"DEF") => {
                    let name = lexer.word("a name")?;
                    if proto.is_none() {
                        budget.charge(ENTRY).at_line(token.line)?;
                        nodes.insert((name.bytes, lexer.offset()), lexer);
                    }
                }
                (Kind::Word, word) if proto.is_some() && !has_shapes => {
                    has_shapes = (is_shape(word) || prototypes.contains_key(word)) && lexer.is_next(b"{");
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
        Ok(Self { nodes, prototypes })
    }

    /// The place of the node that had this name last, before an offset.
    pub(super) fn find(&self, name: &'a [u8], before: usize) -> Option<Lexer<'a>> {
        let (_, node) = self.nodes.range((name, 0)..(name, before)).next_back()?;
        Some(*node)
    }

    /// What is lost if a node of this type is passed over.
    pub(super) fn prototype(&self, kind: &[u8]) -> Option<Content> {
        self.prototypes.get(kind).copied()
    }
}

/// Whether this is the type of a node that shows something, or takes in another file.
fn is_shape(kind: &[u8]) -> bool {
    const TYPES: [&[u8]; 8] =
        [b"Shape", b"Inline", b"Box", b"Cone", b"Cylinder", b"ElevationGrid", b"Extrusion", b"Sphere"];
    kind.ends_with(b"Set") || kind == b"Text" || TYPES.contains(&kind)
}

fn closing(open: u8) -> char {
    if open == b'{' { '}' } else { ']' }
}
