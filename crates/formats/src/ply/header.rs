//! The header of a PLY file.

use super::scalar::{NAMES, Scalar};
use crate::base::budget::Budget;
use crate::base::error::{At, Count, Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::read_count;
use crate::format::Format;

/// What a header says, checked: the elements with roles have what their roles need.
#[derive(Debug)]
pub(super) struct Header<'a> {
    pub(super) format: Format,
    /// In the order of the file. One has the role of the vertices; at most one behind it that of facets or
    /// segments.
    pub(super) elements: Vec<Element<'a>>,
    /// Where the body begins.
    pub(super) body: usize,
    /// The line in which it begins.
    pub(super) body_line: u32,
}

/// A list of records of one kind.
#[derive(Debug)]
pub(super) struct Element<'a> {
    name: Token<'a>,
    pub(super) role: Role,
    pub(super) count: u32,
    /// What to do along a record.
    pub(super) steps: Vec<Step>,
}

/// What the records of an element are to the mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    Vertices,
    Facets,
    Segments,
    /// Nothing: they are skipped.
    Other,
}

/// What to do along a record.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// Skip scalars: so many bytes in a binary file, so many words in a text.
    Skip { bytes: u64, words: u64 },
    /// Keep a scalar: coordinate 0, 1 or 2 of a vertex, or vertex 0 or 1 of a segment.
    Keep { slot: usize, scalar: Scalar },
    /// A list: the vertices of a facet, or one to skip.
    List { corners: bool, count: Scalar, item: Scalar },
}

impl Element<'_> {
    /// The bytes of a record, if all have the same number.
    pub(super) fn size(&self) -> Option<u64> {
        self.steps.iter().try_fold(0, |sum, step| match step {
            Step::Skip { bytes, .. } => Some(sum + bytes),
            Step::Keep { scalar, .. } => Some(sum + scalar.size() as u64),
            Step::List { .. } => None,
        })
    }

    /// What its lists count.
    pub(super) fn counted(&self) -> Count {
        if self.role == Role::Facets { Count::Corners } else { Count::Elements }
    }

    /// The file ends after so many records.
    #[cold]
    pub(super) fn truncated(&self, read: u64) -> Fault {
        let promised = self.count;
        let expected = match self.role {
            Role::Vertices => format!("a vertex was expected, after {read} of {promised} vertices"),
            Role::Facets => format!("a facet was expected, after {read} of {promised} facets"),
            Role::Segments => format!("an edge was expected, after {read} of {promised} edges"),
            Role::Other => {
                format!("an element `{}` was expected, after {read} of {promised}", self.name.shown())
            }
        };
        Fault::Truncated { expected }
    }

    /// Its records, as the end of one is named.
    pub(super) fn record(&self) -> String {
        match self.role {
            Role::Vertices => "a vertex".into(),
            Role::Facets => "a facet".into(),
            Role::Segments => "an edge".into(),
            Role::Other => format!("an element `{}`", self.name.shown()),
        }
    }

    fn is_named(&self, name: &[u8]) -> bool {
        self.name.bytes == name
    }

    fn has_slots(&self, slots: usize) -> bool {
        (0..slots).all(|wanted| self.has_slot(wanted))
    }

    fn has_slot(&self, wanted: usize) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::Keep { slot, .. } if *slot == wanted))
    }

    fn has_corners(&self) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::List { corners: true, .. }))
    }

    /// It cannot be read as it is.
    fn unsupported(&self, what: String, instead: &str) -> Located {
        Fault::Unsupported { what, instead: instead.into() }.at(Place::Line(self.name.line))
    }
}

/// The lines of a header. They end as the first one does: with LF (a CR before it is a blank) or with CR. So
/// in a binary file the first byte of the body is never taken for a part of a line end.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    end: u8,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
        let end = match bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')) {
            Some(first) if bytes[first] == b'\r' && bytes.get(first + 1) != Some(&b'\n') => b'\r',
            _ => b'\n',
        };
        Self { bytes, at, line: 0, end }
    }

    fn next(&mut self) -> Option<Token<'a>> {
        let rest = &self.bytes[self.at..];
        if rest.is_empty() {
            return None;
        }
        let length = rest.iter().position(|&byte| byte == self.end);
        let bytes = rest[..length.unwrap_or(rest.len())].trim_ascii();
        self.at += length.map_or(rest.len(), |length| length + 1);
        self.line = self.line.saturating_add(1);
        Some(Token { bytes, line: self.line })
    }
}

/// More words than any line of a header has; more of a line is not looked at.
const WORDS: usize = 6;

/// Reads and checks a header.
pub(super) fn read<'a>(bytes: &'a [u8], budget: &mut Budget) -> Result<Header<'a>, Located> {
    let mut lines = Lines::new(bytes);
    let first = lines.next().ok_or(Fault::Empty)?;
    if first.bytes != b"ply" {
        return Err(first.fault(|token| Fault::UnknownFormat { token }));
    }
    let mut format = None;
    let mut elements: Vec<Element<'a>> = Vec::new();
    let mut words = Vec::with_capacity(WORDS);
    let end = loop {
        let Some(line) = lines.next() else {
            let expected = "`end_header` was expected".into();
            return Err(Fault::Truncated { expected }.at(Place::Line(lines.line)));
        };
        words.clear();
        words.extend(
            line.bytes
                .split(u8::is_ascii_whitespace)
                .filter(|word| !word.is_empty())
                .take(WORDS)
                .map(|bytes| Token { bytes, line: line.line }),
        );
        match *words {
            [] => {}
            [keyword, ..] if matches!(keyword.bytes, b"comment" | b"obj_info") => {}
            [keyword, kind, version] if keyword.bytes == b"format" && format.is_none() => {
                format = Some(read_format(kind, version)?);
            }
            [keyword, name, count] if keyword.bytes == b"element" => {
                budget.charge(2 * size_of::<Element<'_>>() as u64).at_line(line.line)?;
                elements.push(read_element(name, count)?);
            }
            [keyword, ref property @ ..] if keyword.bytes == b"property" && !elements.is_empty() => {
                budget.charge(2 * size_of::<Step>() as u64).at_line(line.line)?;
                let element = elements.last_mut().expect("there is an element");
                read_property(line, property, element)?;
            }
            [keyword] if keyword.bytes == b"end_header" => break line,
            [keyword, ..] => return Err(line.unexpected(expected(keyword.bytes, format, &elements))),
        }
    };
    let format = format.ok_or_else(|| end.unexpected("a line `format ascii 1.0` (or binary)"))?;
    check(&mut elements, end)?;
    Ok(Header { format, elements, body: lines.at, body_line: lines.line.saturating_add(1) })
}

/// Instead of a second property of one meaning.
const NEW_PROPERTY: &str = "a property that the element does not have yet";

/// What a line that is wrong should have been.
fn expected(keyword: &[u8], format: Option<Format>, elements: &[Element<'_>]) -> &'static str {
    match keyword {
        b"format" if format.is_some() => "one line `format` only",
        b"format" => {
            "`format ascii 1.0`, `format binary_little_endian 1.0` or `format binary_big_endian 1.0`"
        }
        b"element" => "`element NAME COUNT`",
        b"property" if elements.is_empty() => "an element before its properties",
        b"end_header" => "`end_header` alone in its line",
        _ => "`format`, `comment`, `obj_info`, `element`, `property` or `end_header`",
    }
}

fn read_format(kind: Token<'_>, version: Token<'_>) -> Result<Format, Located> {
    if version.bytes != b"1.0" {
        let unsupported = |version| Fault::Unsupported {
            what: format!("PLY of version {version}"),
            instead: "write version 1.0".into(),
        };
        return Err(version.fault(unsupported));
    }
    match kind.bytes {
        b"ascii" => Ok(Format::PlyAscii),
        b"binary_little_endian" => Ok(Format::Ply),
        b"binary_big_endian" => Ok(Format::PlyBigEndian),
        _ => Err(kind.unexpected("`ascii`, `binary_little_endian` or `binary_big_endian`")),
    }
}

fn read_element<'a>(name: Token<'a>, count: Token<'_>) -> Result<Element<'a>, Located> {
    let (role, of) = match name.bytes {
        b"vertex" => (Role::Vertices, Count::Vertices),
        b"face" => (Role::Facets, Count::Facets),
        b"edge" => (Role::Segments, Count::Edges),
        _ => (Role::Other, Count::Elements),
    };
    Ok(Element { name, role, count: read_count(count, of)?, steps: Vec::new() })
}

fn read_property(line: Token<'_>, words: &[Token<'_>], element: &mut Element<'_>) -> Result<(), Located> {
    let scalar = |name: Token<'_>| Scalar::from_name(name.bytes).ok_or_else(|| name.unexpected(NAMES));
    match *words {
        [list, count, item, name] if list.bytes == b"list" => {
            let step = list_step(element, name, [count, item], [scalar(count)?, scalar(item)?])?;
            element.steps.push(step);
        }
        [kind, name] if kind.bytes != b"list" => {
            let scalar = scalar(kind)?;
            let size = scalar.size() as u64;
            if let Some(slot) = slot(element.role, name, kind, scalar)? {
                if element.has_slot(slot) {
                    return Err(name.unexpected(NEW_PROPERTY));
                }
                element.steps.push(Step::Keep { slot, scalar });
            } else if let Some(Step::Skip { bytes, words }) = element.steps.last_mut() {
                *bytes += size;
                *words += 1;
            } else {
                element.steps.push(Step::Skip { bytes: size, words: 1 });
            }
        }
        _ => {
            return Err(line.unexpected("`property TYPE NAME` or `property list COUNTTYPE TYPE NAME`"));
        }
    }
    Ok(())
}

/// What a scalar property is to an element of this role.
fn slot(role: Role, name: Token<'_>, kind: Token<'_>, scalar: Scalar) -> Result<Option<usize>, Located> {
    match (role, name.bytes) {
        (Role::Vertices, b"x") => Ok(Some(0)),
        (Role::Vertices, b"y") => Ok(Some(1)),
        (Role::Vertices, b"z") => Ok(Some(2)),
        (Role::Segments, b"vertex1" | b"vertex2") if !scalar.is_integer() => {
            Err(kind.unexpected("an integer type for vertex indices"))
        }
        (Role::Segments, b"vertex1") => Ok(Some(0)),
        (Role::Segments, b"vertex2") => Ok(Some(1)),
        (Role::Facets, b"vertex_indices" | b"vertex_index") => {
            Err(kind.unexpected("`list` (a facet has a list of vertices)"))
        }
        _ => Ok(None),
    }
}

fn list_step(
    element: &Element<'_>,
    name: Token<'_>,
    [count_name, item_name]: [Token<'_>; 2],
    [count, item]: [Scalar; 2],
) -> Result<Step, Located> {
    if !count.is_integer() {
        return Err(count_name.unexpected("an integer type for the length of a list"));
    }
    let corners = match (element.role, name.bytes) {
        (Role::Facets, b"vertex_indices" | b"vertex_index") => true,
        (Role::Vertices, b"x" | b"y" | b"z") => {
            return Err(name.unexpected("a coordinate that is a number, not a list"));
        }
        _ => false,
    };
    if corners && element.has_corners() {
        return Err(name.unexpected(NEW_PROPERTY));
    }
    if corners && !item.is_integer() {
        return Err(item_name.unexpected("an integer type for vertex indices"));
    }
    Ok(Step::List { corners, count, item })
}

/// Checks the elements together, and takes the roles from those that are skipped.
fn check(elements: &mut [Element<'_>], end: Token<'_>) -> Result<(), Located> {
    for element in elements.iter().filter(|element| element.count > 0) {
        if element.steps.is_empty() {
            let what = format!("the element `{}` without properties", element.name.shown());
            return Err(element.unsupported(what, "give it properties, or remove it"));
        }
        if element.is_named(b"tristrips") {
            let instead = "write the facets one by one, as an element `face`";
            return Err(element.unsupported("an element `tristrips` (strips of triangles)".into(), instead));
        }
    }
    for role in [Role::Vertices, Role::Facets, Role::Segments] {
        if let Some(second) = elements.iter().filter(|element| element.role == role).nth(1) {
            let what = format!("a second element `{}`", second.name.shown());
            return Err(second.unsupported(what, "put all its records into the first"));
        }
    }
    let position = |role| elements.iter().position(|element| element.role == role);
    let present = |role| position(role).filter(|&at| elements[at].count > 0);
    let vertices = position(Role::Vertices).ok_or_else(|| end.fault(|_| Fault::NoVertices))?;
    let vertex = &elements[vertices];
    if vertex.count == 0 {
        return Err(vertex.name.fault(|_| Fault::NoVertices));
    }
    if let Some(missing) = (0..3).find(|&axis| !vertex.has_slot(axis)) {
        let what = format!("an element `vertex` without a property `{}`", ["x", "y", "z"][missing]);
        return Err(vertex.unsupported(what, "give every vertex x, y and z"));
    }
    let cells = present(Role::Facets).or_else(|| present(Role::Segments));
    if let Some(at) = cells {
        let element = &elements[at];
        if element.role == Role::Facets && !element.has_corners() {
            let what = "an element `face` without a list `vertex_indices`".into();
            return Err(element.unsupported(what, "give every facet its vertices"));
        }
        if element.role == Role::Segments && !element.has_slots(2) {
            let what = "an element `edge` without properties `vertex1` and `vertex2`".into();
            return Err(element.unsupported(what, "give every edge its two vertices"));
        }
        if at < vertices {
            let what = format!("an element `{}` before the element `vertex`", element.name.shown());
            return Err(element.unsupported(what, "put the vertices first"));
        }
    }
    for (at, element) in elements.iter_mut().enumerate() {
        if at != vertices && Some(at) != cells {
            element.role = Role::Other;
        }
    }
    Ok(())
}
