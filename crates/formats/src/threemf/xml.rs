//! XML, element by element with its line; no tree of it is kept.

use super::CORE;
use super::element::{Element, is_blank, shown};
use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;
use quick_xml::NsReader;
use quick_xml::errors::{Error, IllFormedError};
use quick_xml::events::Event;
use quick_xml::name::{Namespace, NamespaceError, PrefixDeclaration, QName, ResolveResult};

/// Elements within elements. A model has seven levels; the rest is for what is skipped.
const DEEPEST: usize = 64;

/// Walks over the elements of a text.
pub(super) struct Xml<'t> {
    text: &'t str,
    /// The namespace of the elements that are known.
    namespace: &'static str,
    reader: NsReader<&'t [u8]>,
    /// Where the reader's text begins in `text`.
    base: usize,
    /// How much of the text has been counted, and the line that it ends in.
    counted: usize,
    line: u32,
    /// Where the elements begin that are open.
    open: Vec<usize>,
}

/// The text of a part: UTF-8, without its byte order mark.
pub(super) fn text(bytes: &[u8]) -> Result<&str, Located> {
    const WIDE: [&[u8]; 4] = [b"\xFE\xFF", b"\xFF\xFE", b"\0<", b"<\0"];
    if WIDE.iter().any(|mark| bytes.starts_with(mark)) {
        return Err(encoding("UTF-16", 1));
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        let (before, after) = bytes.split_at(error.valid_up_to());
        let end = error.error_len().unwrap_or(after.len());
        let line = 1_u32.saturating_add(line_breaks(before, after));
        Token { bytes: &after[..end], line }.unexpected("text in UTF-8")
    })
}

fn encoding(name: &str, line: u32) -> Located {
    let what = format!("a text in {name}");
    Fault::Unsupported { what, instead: "write it in UTF-8".into() }.at(Place::Line(line))
}

/// LF, CR LF and CR end lines. `next` is what follows, if a CR is the last byte.
fn line_breaks(bytes: &[u8], next: &[u8]) -> u32 {
    let feeds = bytes.iter().filter(|&&byte| byte == b'\n').count();
    let mut returns = 0;
    if bytes.contains(&b'\r') {
        let followed = |at: usize| bytes.get(at + 1).or(next.first()) == Some(&b'\n');
        returns = (0..bytes.len()).filter(|&at| bytes[at] == b'\r' && !followed(at)).count();
    }
    u32::try_from(feeds + returns).unwrap_or(u32::MAX)
}

impl<'t> Xml<'t> {
    pub(super) fn new(text: &'t str, namespace: &'static str) -> Self {
        let reader = NsReader::from_str(text);
        Self { text, namespace, reader, base: 0, counted: 0, line: 1, open: Vec::new() }
    }

    /// Begins at an element within a text, where these prefixes are bound to the namespace of the model.
    pub(super) fn at_element(
        text: &'t str,
        at: usize,
        line: u32,
        prefixes: &[String],
    ) -> Result<Self, Located> {
        let mut reader = NsReader::from_str(&text[at..]);
        for prefix in prefixes {
            let declaration = match prefix.as_str() {
                "" => PrefixDeclaration::Default,
                named => PrefixDeclaration::Named(named),
            };
            let added = reader.resolver_mut().add(declaration, Namespace(CORE));
            added.map_err(|_| too_many_namespaces().at(Place::Line(line)))?;
        }
        Ok(Self { text, namespace: CORE, reader, base: at, counted: at, line, open: Vec::new() })
    }

    /// The prefixes that are bound to the namespace of the model; an empty one if it is the default.
    pub(super) fn core_prefixes(&self) -> Vec<String> {
        let core = |(prefix, namespace)| match (prefix, namespace) {
            (PrefixDeclaration::Default, Namespace(CORE)) => Some(String::new()),
            (PrefixDeclaration::Named(prefix), Namespace(CORE)) => Some(prefix.to_string()),
            _ => None,
        };
        self.reader.resolver().bindings().filter_map(core).collect()
    }

    /// The namespace that a prefix is bound to.
    pub(super) fn namespace_of(&self, prefix: &str) -> Option<String> {
        match self.reader.resolver().resolve_attribute(QName(&format!("{prefix}:_"))).0 {
            ResolveResult::Bound(Namespace(namespace)) => Some(namespace.to_string()),
            _ => None,
        }
    }

    /// Whether an element has an attribute of this local name and namespace; gives its name as written.
    pub(super) fn attribute_of(
        &self,
        element: &Element<'t>,
        local: &str,
        namespace: &str,
    ) -> Result<Option<String>, Located> {
        for attribute in element.start.attributes().with_checks(false) {
            let attribute = attribute.map_err(|_| element.bad_attributes())?;
            let key = attribute.key;
            let (found, name) = self.reader.resolver().resolve_attribute(key);
            if name.as_ref() == local && found == ResolveResult::Bound(Namespace(namespace)) {
                return Ok(Some(key.as_ref().to_string()));
            }
        }
        Ok(None)
    }

    /// How much of the text has been read.
    pub(super) fn position(&self) -> usize {
        let position = usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX);
        self.text.len().min(self.base.saturating_add(position))
    }

    /// The line of a position. Positions only grow.
    fn line_at(&mut self, at: usize) -> u32 {
        if at > self.counted {
            let bytes = self.text.as_bytes();
            self.line = self.line.saturating_add(line_breaks(&bytes[self.counted..at], &bytes[at..]));
            self.counted = at;
        }
        self.line
    }

    /// The first word behind a position.
    fn word_at(&mut self, at: usize) -> Token<'t> {
        let rest = self.text[at..].trim_start();
        let line = self.line_at(self.text.len() - rest.len());
        Token { bytes: rest.split_whitespace().next().unwrap_or_default().as_bytes(), line }
    }

    /// The first element, which must have this name.
    pub(super) fn root(&mut self, name: &str) -> Result<Element<'t>, Located> {
        loop {
            let at = self.position();
            let element = match self.event(at)? {
                Some(Step::Start(element)) => element,
                Some(Step::Text) if self.text[at..self.position()].trim().is_empty() => continue,
                Some(Step::Other) => continue,
                Some(Step::Text | Step::End) => {
                    let word = self.word_at(at);
                    return Err(word.unexpected(&format!("<{name}>")));
                }
                None => return Err(self.truncated(&format!("`<{name}>` was expected"))),
            };
            if element.is(name) {
                return Ok(element);
            }
            return Err(element.unexpected(&format!("<{name}> of the namespace {}", self.namespace)));
        }
    }

    /// The next element within the one that was opened last; `None` at its end. An element that is given has to be
    /// walked through, or skipped, unless it is empty.
    pub(super) fn child(&mut self) -> Result<Option<Element<'t>>, Located> {
        loop {
            let at = self.position();
            match self.event(at)? {
                Some(Step::Start(element)) => return Ok(Some(element)),
                Some(Step::End) => return Ok(None),
                Some(Step::Text | Step::Other) => {}
                None => {
                    let open = self.open.last().map_or("", |&start| name_at(&self.text[start..]));
                    let expected = format!("`</{}>` was expected", shown(open));
                    return Err(self.truncated(&expected));
                }
            }
        }
    }

    /// Goes behind the end of an element, whatever it has.
    pub(super) fn skip(&mut self, element: &Element<'t>) -> Result<(), Located> {
        if !element.has_content() {
            return Ok(());
        }
        let depth = self.open.len();
        while self.open.len() >= depth {
            self.child()?;
        }
        Ok(())
    }

    /// Makes sure that nothing follows the first element, which is called so.
    pub(super) fn finish(&mut self, end: &str) -> Result<(), Located> {
        loop {
            let at = self.position();
            match self.event(at)? {
                None => return Ok(()),
                Some(Step::Other) => {}
                Some(Step::Text) if self.text[at..self.position()].trim().is_empty() => {}
                Some(_) => {
                    let word = self.word_at(at);
                    return Err(word.fault(|token| Fault::AfterEnd { token, end: format!("the {end}") }));
                }
            }
        }
    }

    /// The next event, which begins at `at`; `None` at the end of the text.
    fn event(&mut self, at: usize) -> Result<Option<Step<'t>>, Located> {
        let event = match self.reader.read_event() {
            Ok(event) => event,
            Err(error) => return Err(self.wrong(at, &error)),
        };
        let (start, empty) = match event {
            Event::Start(start) => (start, false),
            Event::Empty(start) => (start, true),
            Event::End(_) => {
                self.open.pop();
                return Ok(Some(Step::End));
            }
            Event::Eof => return Ok(None),
            Event::Text(_) | Event::CData(_) => return Ok(Some(Step::Text)),
            Event::Comment(_) | Event::PI(_) => return Ok(Some(Step::Other)),
            Event::Decl(declaration) => {
                let line = self.line_at(at);
                return match declaration.encoding() {
                    Some(Ok(name)) if !is_utf8(&name) => Err(encoding(&shown(&name), line)),
                    _ => Ok(Some(Step::Other)),
                };
            }
            Event::DocType(_) => {
                return Err(self.unsupported(at, "a document type (DTD)".into(), "remove it"));
            }
            Event::GeneralRef(reference) => {
                let known = matches!(&*reference, "lt" | "gt" | "amp" | "apos" | "quot")
                    || matches!(reference.resolve_char_ref(), Ok(Some(_)));
                if known {
                    return Ok(Some(Step::Text));
                }
                let what = format!("the entity `&{};`", shown(&reference));
                return Err(self.unsupported(at, what, "write what it stands for"));
            }
        };
        if !empty {
            if self.open.len() == DEEPEST {
                let what = format!("a text with more than {DEEPEST} elements within each other");
                return Err(self.unsupported(at, what, "export the model again"));
            }
            self.open.push(at);
        }
        let found = self.reader.resolver().resolve_element(start.name()).0;
        let known = found == ResolveResult::Bound(Namespace(self.namespace));
        Ok(Some(Step::Start(Element { start, known, empty, at, line: self.line_at(at) })))
    }

    fn unsupported(&mut self, at: usize, what: String, instead: &str) -> Located {
        Fault::Unsupported { what, instead: instead.into() }.at(Place::Line(self.line_at(at)))
    }

    /// The text ends too early, in its last line that has something.
    fn truncated(&mut self, expected: &str) -> Located {
        let line = self.line_at(self.text.trim_end().len());
        Fault::Truncated { expected: expected.into() }.at(Place::Line(line))
    }

    fn wrong(&mut self, at: usize, error: &Error) -> Located {
        let line = self.line_at(at);
        let token = |bytes| Token { bytes, line };
        match error {
            Error::Syntax(_) | Error::IllFormed(IllFormedError::UnclosedReference)
                if !self.text[at..].starts_with("<!") || self.text[at..].starts_with("<!--") =>
            {
                self.truncated("the end of a tag or a comment was expected")
            }
            Error::IllFormed(IllFormedError::MismatchedEndTag { expected, found }) => {
                token(format!("</{found}>").as_bytes()).unexpected(&format!("</{}>", shown(expected)))
            }
            Error::IllFormed(IllFormedError::UnmatchedEndTag(found)) => {
                token(format!("</{found}>").as_bytes()).unexpected("the end of the text")
            }
            Error::Namespace(NamespaceError::TooManyBindings(_)) => {
                too_many_namespaces().at(Place::Line(line))
            }
            _ => {
                let tag = self.text[at..].split_inclusive('>').next().unwrap_or_default();
                token(tag.as_bytes()).unexpected("well-formed XML")
            }
        }
    }
}

fn too_many_namespaces() -> Fault {
    Fault::Unsupported {
        what: "a text with so many namespaces".into(),
        instead: "export the model again".into(),
    }
}

/// What was read, as far as it matters.
enum Step<'t> {
    Start(Element<'t>),
    End,
    Text,
    /// A comment or an instruction.
    Other,
}

fn is_utf8(name: &str) -> bool {
    ["UTF-8", "UTF8", "US-ASCII", "ASCII"].iter().any(|known| name.eq_ignore_ascii_case(known))
}

/// The name of a tag.
fn name_at(tag: &str) -> &str {
    let name = tag.strip_prefix('<').unwrap_or(tag);
    name.split(|c: char| is_blank(c) || c == '/' || c == '>').next().unwrap_or_default()
}
