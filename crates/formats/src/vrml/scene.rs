//! The walk over the nodes of a scene.

use super::frame::{Frame, TransformFields};
use super::geometry::Shared;
use super::lexer::{Kind, Lexer};
use super::outline::{Content, Outline};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::maker::MeshMaker;
use crate::base::model::{Object, ReadModel};
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use crate::format::Format;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Nodes may be nested so deep, counted through `USE`.
const DEEPEST: usize = 64;

/// What `USE` is charged beside the node that it repeats, so that many small ones end soon.
const USE: u64 = 64;

/// Reads a VRML 2 file.
///
/// - Each `Shape` gives an object, under the name (`DEF`) of the shape or of the nearest group around it that
///   has one: the facets of an `IndexedFaceSet` or of a `Box`, the segments of an `IndexedLineSet`, or points
///   of a `PointSet`. Round primitives and other geometry are refused.
/// - `Coordinate` may have fractions; `ExactCoordinate` has them in its field `exact` (see the module), or as
///   words in its field `point` where there is no other. Shapes that share coordinates by `USE` share the
///   vertices of the first of them, where they stand in the same place.
/// - `Group`, `Anchor`, `Billboard`, `Collision` and `Transform` are walked, of a `LOD` the finest level, of
///   a `Switch` the choice. A `Transform` may not rotate. Nodes of types that the file defines (`PROTO`) are
///   passed over if neither they nor the definition have a shape in them, and refused otherwise, and so are
///   those that another file defines (`EXTERNPROTO`), and `Inline`.
/// - Facets are turned round where `ccw` is `FALSE`, and within transforms that reflect.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let mut lexer = Lexer::new(bytes);
    check_header(&bytes[lexer.offset()..], lexer)?;
    let outline = Outline::of_text(lexer, budget)?;
    let mut scene = Scene {
        maker: MeshMaker::new(budget, PlaceList::lines(), PlaceList::lines()),
        outline,
        open: Vec::new(),
        objects: Vec::new(),
        shared: BTreeMap::new(),
        point_set: None,
    };
    let frame = Rc::new(Frame::identity());
    while let Some(token) = lexer.peek() {
        let mut behind = lexer;
        behind.next();
        if behind.skip_statement(token)? {
            lexer = behind;
        } else {
            scene.node(&mut lexer, &frame, b"")?;
        }
    }
    scene.finish()
}

fn check_header(text: &[u8], mut lexer: Lexer<'_>) -> Result<(), Located> {
    if text.starts_with(b"#VRML V2.0") {
        return Ok(());
    }
    if text.starts_with(b"#VRML") {
        let end = text.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(text.len());
        let header = Token { bytes: text[1..end].trim_ascii(), line: 1 };
        let instead = "convert it to VRML 2 (VRML97)".into();
        return Err(header.fault(|what| Fault::Unsupported { what, instead }));
    }
    match lexer.next() {
        Some(token) => Err(token.unexpected("`#VRML V2.0 utf8` in the first line")),
        None => Err(Fault::Empty.into()),
    }
}

/// What has been read of a scene.
pub(super) struct Scene<'a, 'b> {
    pub(super) maker: MeshMaker<'b>,
    pub(super) outline: Outline<'a>,
    /// The nodes around the current one, by their offsets.
    open: Vec<usize>,
    objects: Vec<Object>,
    /// The vertices of coordinates, by the offsets of their nodes.
    pub(super) shared: BTreeMap<usize, Shared>,
    /// The line of the first set of points.
    pub(super) point_set: Option<u32>,
}

/// A node that is being read.
pub(super) struct Node<'a> {
    pub(super) name: &'a [u8],
    pub(super) kind: Token<'a>,
    pub(super) offset: usize,
    /// Behind the opening bracket, and behind the closing one in the end.
    pub(super) body: Lexer<'a>,
    /// Where to go on, if the node stands elsewhere.
    used: Option<Lexer<'a>>,
}

impl<'a> Scene<'a, '_> {
    /// Begins a node: by its type, with `DEF`, or elsewhere by `USE`. `None` for the word `NULL`.
    pub(super) fn enter(&mut self, lexer: &mut Lexer<'a>) -> Result<Option<Node<'a>>, Located> {
        const NODE: &str = "a node";
        let mut body = *lexer;
        let mut offset = body.offset();
        let mut kind = body.word(NODE)?;
        let (mut name, mut used): (&[u8], _) = (b"", None);
        match kind.bytes {
            b"NULL" => {
                *lexer = body;
                return Ok(None);
            }
            b"USE" => {
                let token = body.word("a name")?;
                used = Some(body);
                let Some(node) = self.outline.find(token.bytes, body.offset()) else {
                    return Err(token.unexpected("a name that `DEF` has given before"));
                };
                if self.open.contains(&node.offset()) {
                    return Err(token.unexpected("the name of a node that does not contain this place"));
                }
                (name, body) = (token.bytes, node);
            }
            b"DEF" => name = body.word("a name")?.bytes,
            _ => {}
        }
        if !name.is_empty() {
            offset = body.offset();
            kind = body.word("a type of node")?;
        }
        if self.open.len() == DEEPEST {
            let what = format!("nodes nested more than {DEEPEST} deep");
            return Err(unsupported(kind, what, "take groups apart"));
        }
        body.bracket("{")?;
        self.open.push(offset);
        Ok(Some(Node { name, kind, offset, body, used }))
    }

    /// Ends a node whose body has been read. What `USE` repeats is charged as if it stood there.
    pub(super) fn leave(&mut self, node: &Node<'a>, lexer: &mut Lexer<'a>) -> Result<(), Located> {
        self.open.pop();
        *lexer = node.body;
        if let Some(used) = node.used {
            let repeated = node.body.offset() - node.offset;
            self.maker.budget().charge(USE + repeated as u64).at_line(node.kind.line)?;
            *lexer = used;
        }
        Ok(())
    }

    /// Walks over a node, within a frame and a group of some name.
    fn node(&mut self, lexer: &mut Lexer<'a>, frame: &Rc<Frame>, group: &'a [u8]) -> Result<(), Located> {
        let Some(mut node) = self.enter(lexer)? else { return Ok(()) };
        let name = if node.name.is_empty() { group } else { node.name };
        let line = node.kind.line;
        match node.kind.bytes {
            b"Shape" => {
                let first_facet = self.maker.facet_count();
                if let [Some(mut geometry)] = node.body.fields(["geometry"])? {
                    self.geometry(&mut geometry, frame)?;
                }
                if self.maker.facet_count() > first_facet {
                    // Invalid bytes become three each.
                    let bytes = 2 * size_of::<Object>() + 3 * name.len();
                    self.maker.budget().charge(bytes as u64).at_line(line)?;
                    let name = String::from_utf8_lossy(name).into_owned();
                    self.objects.push(Object { name, first_facet });
                }
            }
            b"Group" | b"Anchor" | b"Billboard" | b"Collision" => {
                let [children] = node.body.fields(["children"])?;
                self.nodes(children, frame, name)?;
            }
            b"Transform" => {
                let [center, rotation, scale, scale_orientation, translation, children] = node
                    .body
                    .fields(["center", "rotation", "scale", "scaleOrientation", "translation", "children"])?;
                let fields = TransformFields { center, rotation, scale, scale_orientation, translation };
                let frame = Rc::new(frame.within(fields, line)?);
                self.nodes(children, &frame, name)?;
                if Rc::strong_count(&frame) > 1 {
                    // Shared vertices keep it.
                    self.maker.budget().charge(frame.bytes()).at_line(line)?;
                }
            }
            b"LOD" => {
                let [levels] = node.body.fields(["level"])?;
                self.one_of(levels, 0, frame, name)?;
            }
            b"Switch" => {
                let [choices, which] = node.body.fields(["choice", "whichChoice"])?;
                if let Some(mut which) = which {
                    let token = which.token("a number")?;
                    if token.bytes != b"-1" {
                        let number = crate::base::words::parse_u32(token.bytes);
                        let number = number.ok_or_else(|| token.unexpected("the number of a choice"))?;
                        self.one_of(choices, number, frame, name)?;
                    }
                }
            }
            b"Inline" => {
                let what = "a node that takes in another file (`Inline`)".into();
                return Err(unsupported(node.kind, what, "put the content of that file in its place"));
            }
            _ => self.skip_unknown(&mut node)?,
        }
        self.leave(&node, lexer)
    }

    /// Walks over a list of nodes, or over one without brackets.
    fn nodes(&mut self, list: Option<Lexer<'a>>, frame: &Rc<Frame>, group: &'a [u8]) -> Result<(), Located> {
        let Some(mut lexer) = list else { return Ok(()) };
        if !lexer.is_next(b"[") {
            return self.node(&mut lexer, frame, group);
        }
        lexer.next();
        while !lexer.is_next(b"]") {
            self.node(&mut lexer, frame, group)?;
        }
        Ok(())
    }

    /// Walks over one node of a list; there may be none of that number.
    fn one_of(
        &mut self,
        list: Option<Lexer<'a>>,
        number: u32,
        frame: &Rc<Frame>,
        group: &'a [u8],
    ) -> Result<(), Located> {
        let Some(mut lexer) = list else { return Ok(()) };
        if lexer.is_next(b"[") {
            lexer.next();
        } else if number > 0 {
            return Ok(());
        }
        for _ in 0..number {
            if lexer.is_next(b"]") {
                return Ok(());
            }
            lexer.skip_value()?;
        }
        if lexer.is_next(b"]") { Ok(()) } else { self.node(&mut lexer, frame, group) }
    }

    /// Passes over a node of a type that means nothing here, as long as nothing is lost by it.
    fn skip_unknown(&self, node: &mut Node<'a>) -> Result<(), Located> {
        self.check_prototype(node.kind)?;
        let kind = node.kind.shown();
        if node.kind.bytes.ends_with(b"Set") {
            let what = format!("`{kind}` outside of a Shape");
            return Err(unsupported(node.kind, what, "put a Shape around it"));
        }
        let mut depth = 1_usize;
        while depth > 0 {
            let token = node.body.token("a closing bracket")?;
            match Kind::of(token) {
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                Kind::Word if node.body.is_next(b"{") => {
                    if matches!(token.bytes, b"Shape" | b"Inline") {
                        let what = format!("a node of the type `{kind}` with a {} in it", token.shown());
                        return Err(unsupported(node.kind, what, "make it a Group or a Transform"));
                    }
                    self.check_prototype(token)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Refuses a node of a type that the file defines, if shapes may be in it.
    fn check_prototype(&self, kind: Token<'a>) -> Result<(), Located> {
        let name = kind.shown();
        let what = match self.outline.prototype(kind.bytes) {
            None => return Ok(()),
            Some(Content::Shapes) => format!("an instance of the PROTO `{name}`, which has shapes in it,"),
            Some(Content::Elsewhere) => format!("an instance of `{name}`, whose PROTO is in another file,"),
        };
        Err(unsupported(
            kind,
            what,
            "write the nodes of the PROTO in its place, or remove it if it has no shapes",
        ))
    }

    fn finish(self) -> Result<ReadModel, Located> {
        let Self { maker, mut objects, point_set, .. } = self;
        if let Some(line) = point_set.filter(|_| maker.facet_count() > 0) {
            let what = "a PointSet beside facets or lines".into();
            let instead = "remove it, or put it into a file of its own".into();
            return Err(Fault::Unsupported { what, instead }.at(Place::Line(line)));
        }
        let mut read = maker.read_model(Format::Vrml)?;
        // Facets that belong to none say the same.
        if objects.first().is_some_and(|object| object.name.is_empty()) {
            objects.remove(0);
        }
        read.model.objects = objects;
        Ok(read)
    }
}

pub(super) fn unsupported(token: Token<'_>, what: String, instead: &str) -> Located {
    Fault::Unsupported { what, instead: instead.into() }.at(Place::Line(token.line))
}
