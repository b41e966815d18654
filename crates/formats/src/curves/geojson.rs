//! GeoJSON (RFC 7946): geometries, features and collections of them.
//!
//! What is not needed (`properties`, `bbox`, `crs`, `id`, members of other programs) is passed over: brackets, commas,
//! colons and the quotes of strings are checked there, and nothing else.

use super::DEPTH;
use super::lexer::{Lexer, is_mark, text_of};
use super::maker::{Chain, Maker, Surface};
use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;

/// What the member `type` names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Point,
    MultiPoint,
    LineString,
    MultiLineString,
    Polygon,
    MultiPolygon,
    GeometryCollection,
    Feature,
    FeatureCollection,
}

/// Which objects may stand in a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Role {
    Record,
    Feature,
    Geometry,
}

const KINDS: [(&[u8], Kind); 9] = [
    (b"Point", Kind::Point),
    (b"MultiPoint", Kind::MultiPoint),
    (b"LineString", Kind::LineString),
    (b"MultiLineString", Kind::MultiLineString),
    (b"Polygon", Kind::Polygon),
    (b"MultiPolygon", Kind::MultiPolygon),
    (b"GeometryCollection", Kind::GeometryCollection),
    (b"Feature", Kind::Feature),
    (b"FeatureCollection", Kind::FeatureCollection),
];

/// A member with what an object is made of.
struct Content {
    name: &'static str,
    /// The type of the object, if only one has this member.
    kind: Option<Kind>,
}

const CONTENTS: [Content; 4] = [
    Content { name: "coordinates", kind: None },
    Content { name: "geometries", kind: Some(Kind::GeometryCollection) },
    Content { name: "geometry", kind: Some(Kind::Feature) },
    Content { name: "features", kind: Some(Kind::FeatureCollection) },
];

const COMMA_OR_CLOSE: &str = "`,` or `]`";

impl Kind {
    /// The name of the member that it has of [`CONTENTS`].
    fn content(self) -> &'static str {
        let own = CONTENTS.iter().find(|content| content.kind == Some(self));
        own.map_or("coordinates", |content| content.name)
    }

    fn may_be(self, role: Role) -> bool {
        match role {
            Role::Record => true,
            Role::Feature => self == Self::Feature,
            Role::Geometry => !matches!(self, Self::Feature | Self::FeatureCollection),
        }
    }
}

impl Role {
    fn expected(self) -> &'static str {
        match self {
            Self::Record => "a GeoJSON object",
            Self::Feature => "a feature",
            Self::Geometry => "a geometry",
        }
    }
}

/// Reads an object whose opening bracket is read.
pub(super) fn read<'a, S: Surface>(
    open: Token<'a>,
    lexer: &mut Lexer<'a>,
    maker: &mut Maker<'_, S>,
) -> Result<(), Located> {
    let mut reader = Reader { lexer: *lexer, maker, depth: 1 };
    reader.members(open, Role::Record)?;
    *lexer = reader.lexer;
    Ok(())
}

struct Reader<'a, 'm, 'b, S: Surface> {
    lexer: Lexer<'a>,
    maker: &'m mut Maker<'b, S>,
    /// The number of brackets that are open.
    depth: u32,
}

impl<'a, S: Surface> Reader<'a, '_, '_, S> {
    fn object(&mut self, role: Role) -> Result<(), Located> {
        let open = self.open("{", role.expected())?;
        self.members(open, role)
    }

    /// Reads an object behind its opening bracket. Coordinates that come before the type are passed over, and read
    /// when the type is known; the other contents tell the type themselves, and no object has two.
    fn members(&mut self, open: Token<'a>, role: Role) -> Result<(), Located> {
        let (mut kind, mut content, mut later) = (None, None, None);
        let mut first = true;
        while let Some(name) = self.next_name(first)? {
            first = false;
            let text = text_of(name);
            if text == Some(b"type") {
                if kind.is_some() {
                    return Err(name.unexpected("a member that the object does not yet have"));
                }
                kind = Some(self.kind(role, content)?);
                continue;
            }
            let Some(member) = CONTENTS.iter().find(|member| Some(member.name.as_bytes()) == text) else {
                self.skip_value()?;
                continue;
            };
            let fits = kind.is_none_or(|kind: Kind| kind.content() == member.name);
            if !fits || content.replace(member.name).is_some() {
                return Err(name.unexpected("a member that fits to the others"));
            }
            match kind.or(member.kind) {
                Some(kind) => self.content(kind)?,
                None => {
                    later = Some(self.lexer);
                    self.skip_value()?;
                }
            }
        }
        let missing = |member: &str| {
            let why = format!("{} without the member `{member}`; add it", role.expected());
            Fault::Malformed { why }.at(Place::Line(open.line))
        };
        let kind = kind.ok_or_else(|| missing("type"))?;
        if content.is_none() {
            return Err(missing(kind.content()));
        }
        if let Some(coordinates) = later {
            let end = std::mem::replace(&mut self.lexer, coordinates);
            self.depth += 1;
            self.content(kind)?;
            self.depth -= 1;
            self.lexer = end;
        }
        Ok(())
    }

    /// The name of the next member, behind its colon; `None` behind the bracket that closes the object.
    fn next_name(&mut self, first: bool) -> Result<Option<Token<'a>>, Located> {
        let expected = if first { "a name in quotes or `}`" } else { "`,` or `}`" };
        let mut token = self.lexer.expect(expected)?;
        if token.bytes == b"}" {
            self.depth -= 1;
            return Ok(None);
        }
        if !first {
            if token.bytes != b"," {
                return Err(token.unexpected(expected));
            }
            token = self.lexer.expect("a name in quotes")?;
        }
        if text_of(token).is_none() {
            return Err(token.unexpected("a name in quotes"));
        }
        let colon = self.lexer.expect("`:`")?;
        if colon.bytes == b":" { Ok(Some(token)) } else { Err(colon.unexpected("`:`")) }
    }

    /// The value of the member `type` of an object that may have its content already.
    fn kind(&mut self, role: Role, content: Option<&str>) -> Result<Kind, Located> {
        const TYPE: &str = "the type of a GeoJSON object in quotes";
        let token = self.lexer.expect(TYPE)?;
        let text = text_of(token).ok_or_else(|| token.unexpected(TYPE))?;
        let known = KINDS.iter().find(|(name, _)| *name == text);
        let Some(&(_, kind)) = known else {
            return Err(Token { bytes: text, line: token.line }.fault(|name| Fault::Unsupported {
                what: format!("an object of type `{name}`"),
                instead: "give GeoJSON: a geometry, a feature or a collection of features".into(),
            }));
        };
        if !kind.may_be(role) {
            return Err(token.unexpected(role.expected()));
        }
        match content {
            Some(member) if member != kind.content() => {
                Err(token.unexpected(&format!("the type of an object with the member `{member}`")))
            }
            _ => Ok(kind),
        }
    }

    /// Reads what an object of this type is made of.
    fn content(&mut self, kind: Kind) -> Result<(), Located> {
        match kind {
            Kind::Point => match self.position()? {
                Some((point, line)) => self.maker.point(point, line)?,
                None => self.maker.count_empty(),
            },
            Kind::MultiPoint => self.array("points", |reader| {
                let (point, line) = reader.finite_position()?;
                reader.maker.point(point, line)
            })?,
            Kind::LineString => self.chain(Chain::Open)?,
            Kind::MultiLineString => self.array("lists of points", |reader| reader.chain(Chain::Open))?,
            Kind::Polygon => self.polygon()?,
            Kind::MultiPolygon => self.array("polygons", Self::polygon)?,
            Kind::GeometryCollection => self.array("geometries", |reader| reader.object(Role::Geometry))?,
            Kind::FeatureCollection => {
                let mut number = 0;
                self.array("features", |reader| {
                    let feature = number;
                    number += 1;
                    reader.maker.set_feature(Some(feature));
                    reader.object(Role::Feature).map_err(|error| error.in_feature(feature))
                })?;
                self.maker.set_feature(None);
            }
            Kind::Feature if self.lexer.clone().expect("a geometry")?.bytes == b"null" => {
                self.lexer.expect("a geometry")?;
                self.maker.count_empty();
            }
            Kind::Feature => self.object(Role::Geometry)?,
        }
        Ok(())
    }

    fn polygon(&mut self) -> Result<(), Located> {
        self.array("rings", |reader| reader.chain(Chain::Ring))
    }

    fn chain(&mut self, kind: Chain) -> Result<(), Located> {
        self.maker.begin_chain();
        let mut any = false;
        self.array("points", |reader| {
            any = true;
            let (point, line) = reader.finite_position()?;
            reader.maker.extend_chain(point, line)
        })?;
        if any { self.maker.end_chain(kind) } else { Ok(()) }
    }

    /// Reads an array of such things. One without any is an empty geometry.
    fn array(
        &mut self,
        things: &str,
        mut item: impl FnMut(&mut Self) -> Result<(), Located>,
    ) -> Result<(), Located> {
        self.open_array(things)?;
        if self.is_next(b"]") {
            self.maker.count_empty();
            return self.close();
        }
        loop {
            item(self)?;
            let token = self.lexer.expect(COMMA_OR_CLOSE)?;
            match token.bytes {
                b"," => {}
                b"]" => break,
                _ => return Err(token.unexpected(COMMA_OR_CLOSE)),
            }
        }
        self.depth -= 1;
        Ok(())
    }

    /// A point with the line where it begins.
    #[inline]
    fn finite_position(&mut self) -> Result<(S::Point, u32), Located> {
        let bracket = self.lexer;
        match self.position()? {
            Some(position) => Ok(position),
            None => {
                let mut after = bracket;
                after.token();
                Err(after.expect("a coordinate")?.unexpected("a coordinate"))
            }
        }
    }

    /// A point with the line where it begins; `None` if it has no coordinates.
    #[inline]
    fn position(&mut self) -> Result<Option<(S::Point, u32)>, Located> {
        self.open_array("coordinates")?;
        let first = self.lexer.expect("a coordinate")?;
        if first.bytes == b"]" {
            self.depth -= 1;
            return Ok(None);
        }
        if is_mark(first) {
            return Err(first.unexpected("a coordinate"));
        }
        let comma = self.lexer.expect("`,` and a second coordinate")?;
        if comma.bytes != b"," {
            return Err(comma.unexpected("`,` and a second coordinate"));
        }
        let second = self.lexer.expect("a second coordinate")?;
        let point = S::position(self.maker, first, second)?;
        let mut dropped = false;
        loop {
            let token = self.lexer.expect(COMMA_OR_CLOSE)?;
            match token.bytes {
                b"]" => break,
                b"," => {
                    let extra = self.lexer.expect("a coordinate")?;
                    self.maker.extra_coordinate(extra)?;
                    dropped = true;
                }
                _ => return Err(token.unexpected(COMMA_OR_CLOSE)),
            }
        }
        self.depth -= 1;
        if dropped {
            self.maker.count_dropped();
        }
        Ok(Some((point, first.line)))
    }

    #[inline]
    fn open_array(&mut self, things: &str) -> Result<(), Located> {
        let token = self.lexer.expect("`[`")?;
        if token.bytes != b"[" {
            return Err(token.unexpected(&format!("`[` with {things}")));
        }
        self.deeper(token)
    }

    fn open(&mut self, bracket: &str, expected: &str) -> Result<Token<'a>, Located> {
        let token = self.lexer.expect(expected)?;
        if token.bytes != bracket.as_bytes() {
            return Err(token.unexpected(&format!("{expected}, which begins with `{bracket}`,")));
        }
        self.deeper(token)?;
        Ok(token)
    }

    #[inline]
    fn deeper(&mut self, open: Token<'_>) -> Result<(), Located> {
        self.depth += 1;
        if self.depth <= DEPTH {
            return Ok(());
        }
        let what = format!("brackets nested more than {DEPTH} deep");
        Err(Fault::Unsupported { what, instead: "nest them less".into() }.at(Place::Line(open.line)))
    }

    /// Passes over the bracket that closes an array, which is next.
    fn close(&mut self) -> Result<(), Located> {
        self.lexer.expect("`]`")?;
        self.depth -= 1;
        Ok(())
    }

    fn is_next(&self, token: &[u8]) -> bool {
        let mut ahead = self.lexer;
        ahead.token().is_some_and(|next| next.bytes == token)
    }

    /// Passes over a value of any kind.
    fn skip_value(&mut self) -> Result<(), Located> {
        const VALUE: &str = "a value";
        let token = self.lexer.expect(VALUE)?;
        match token.bytes {
            b"{" => {
                self.deeper(token)?;
                let mut first = true;
                while self.next_name(first)?.is_some() {
                    first = false;
                    self.skip_value()?;
                }
                Ok(())
            }
            b"[" => {
                self.deeper(token)?;
                if self.is_next(b"]") {
                    return self.close();
                }
                loop {
                    self.skip_value()?;
                    let token = self.lexer.expect(COMMA_OR_CLOSE)?;
                    match token.bytes {
                        b"," => {}
                        b"]" => break,
                        _ => return Err(token.unexpected(COMMA_OR_CLOSE)),
                    }
                }
                self.depth -= 1;
                Ok(())
            }
            [b'"', ..] if text_of(token).is_none() => Err(token.unexpected("a text in quotes")),
            [b'(' | b')' | b',' | b';' | b':' | b']' | b'}'] => Err(token.unexpected(VALUE)),
            _ => Ok(()),
        }
    }
}
