//! The start of an element and its attributes.

use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;
use quick_xml::escape::unescape;
use quick_xml::events::BytesStart;
use std::borrow::Cow;

/// The start of an element.
pub(super) struct Element<'t> {
    pub(super) start: BytesStart<'t>,
    /// Whether it is of the namespace that is read.
    pub(super) known: bool,
    pub(super) empty: bool,
    pub(super) at: usize,
    pub(super) line: u32,
}

/// The value of an attribute, with the line of its element.
pub(super) struct Value<'e> {
    text: Cow<'e, str>,
    line: u32,
}

impl Element<'_> {
    /// Whether it has this name and is of the namespace that is read.
    pub(super) fn is(&self, name: &str) -> bool {
        self.known && self.start.local_name().as_ref() == name
    }

    /// Whether something stands between its start and its end, if only blanks.
    pub(super) fn has_content(&self) -> bool {
        !self.empty
    }

    /// The attributes of these names, none of which may be there twice.
    pub(super) fn attributes<const N: usize>(
        &self,
        names: [&str; N],
    ) -> Result<[Option<Value<'_>>; N], Located> {
        let mut values = [const { None }; N];
        for attribute in self.start.attributes().with_checks(false) {
            let attribute = attribute.map_err(|_| self.bad_attributes())?;
            let key = attribute.key.as_ref();
            let Some(index) = names.iter().position(|name| *name == key) else { continue };
            if values[index].is_some() {
                let expected = format!("<{}> with one attribute {key}", shown(self.start.name().as_ref()));
                return Err(self.unexpected(&expected));
            }
            values[index] = Some(Value { text: self.unescaped(attribute.value)?, line: self.line });
        }
        Ok(values)
    }

    /// The attributes of these names, all of which must be there.
    pub(super) fn required<const N: usize>(&self, names: [&str; N]) -> Result<[Value<'_>; N], Located> {
        let values = self.attributes(names)?;
        if let Some(missing) = values.iter().position(Option::is_none) {
            return Err(self.lacks(names[missing]));
        }
        Ok(values.map(|value| value.expect("none is missing")))
    }

    /// An attribute is missing.
    pub(super) fn lacks(&self, name: &str) -> Located {
        self.unexpected(&format!("<{}> with the attribute {name}", shown(self.start.name().as_ref())))
    }

    /// References in a value are replaced; only those that XML knows by itself.
    fn unescaped<'e>(&self, value: Cow<'e, str>) -> Result<Cow<'e, str>, Located> {
        if !value.contains('&') {
            return Ok(value);
        }
        match unescape(&value) {
            Ok(text) => Ok(Cow::Owned(text.into_owned())),
            Err(_) => {
                let what = format!("the entity in `{}`", shown(&value));
                let instead = "write what it stands for".into();
                Err(Fault::Unsupported { what, instead }.at(Place::Line(self.line)))
            }
        }
    }

    pub(super) fn bad_attributes(&self) -> Located {
        let name = shown(self.start.name().as_ref());
        self.unexpected(&format!("<{name}> with attributes written as name=\"value\""))
    }

    /// Something else was expected than this element.
    pub(super) fn unexpected(&self, expected: &str) -> Located {
        let name = format!("<{}>", self.start.name().as_ref());
        Token { bytes: name.as_bytes(), line: self.line }.unexpected(expected)
    }
}

impl Value<'_> {
    /// The value as it is, references replaced.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The value without blanks around it.
    pub(super) fn trimmed(&self) -> &str {
        self.text.trim_matches(is_blank)
    }

    /// The value as a word of a text.
    pub(super) fn token(&self) -> Token<'_> {
        Token { bytes: self.trimmed().as_bytes(), line: self.line }
    }

    /// The words of a list.
    pub(super) fn tokens(&self) -> impl Iterator<Item = Token<'_>> {
        let words = self.text.split(is_blank).filter(|word| !word.is_empty());
        words.map(|word| Token { bytes: word.as_bytes(), line: self.line })
    }
}

pub(super) fn is_blank(character: char) -> bool {
    matches!(character, ' ' | '\t' | '\n' | '\r')
}

/// A word as messages show it.
pub(super) fn shown(text: &str) -> String {
    Token { bytes: text.as_bytes(), line: 0 }.shown()
}
