//! What a model is made of: where its meshes stand, and how they are put together.

use super::CORE;
use super::element::{Element, Value};
use super::transform::{self, Map};
use super::xml::Xml;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::model::Unit;
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::parse_u32;
use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

/// Extensions that do not change shapes, or of which what does is refused where it stands.
const HARMLESS: [&str; 4] = [CORE, MATERIALS, PRODUCTION, TRIANGLE_SETS];
const MATERIALS: &str = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
const TRIANGLE_SETS: &str = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";

/// An entry of a table of numbers.
const TABLE_ENTRY: u64 = 32;

/// The objects of a model and what is built of them.
pub(super) struct Outline {
    pub(super) unit: Unit,
    pub(super) objects: Vec<Object>,
    /// The components of all objects.
    pub(super) components: Vec<Reference>,
    /// What is built, in order.
    pub(super) items: Vec<Reference>,
}

/// An object that can be built.
pub(super) struct Object {
    /// Its name, or else its part number.
    pub(super) name: String,
    /// Supports hold an object while it is made, and are no part of it.
    pub(super) is_support: bool,
    pub(super) line: u32,
    pub(super) content: Content,
}

/// What an object is made of.
pub(super) enum Content {
    Nothing,
    Mesh(MeshPlace),
    /// A range of the components of all objects.
    Components(Range<usize>),
}

/// Where a mesh stands.
pub(super) struct MeshPlace {
    /// From the start of its first tag to the end of its last.
    pub(super) bytes: Range<usize>,
    pub(super) line: u32,
    /// The prefixes that stand for the namespace of the model there.
    pub(super) prefixes: Rc<Vec<String>>,
}

/// An object that is used.
pub(super) struct Reference {
    /// Its number among the objects.
    pub(super) object: usize,
    pub(super) map: Map,
    pub(super) line: u32,
}

/// Reads all of a model but the meshes, which are only looked through.
pub(super) fn read(text: &str, budget: &mut Budget) -> Result<Outline, Located> {
    let mut xml = Xml::new(text, CORE);
    let root = xml.root("model")?;
    let [unit, required] = root.attributes(["unit", "requiredextensions"])?;
    if let Some(required) = required {
        check_extensions(&xml, &required)?;
    }
    let outline =
        Outline { unit: read_unit(unit)?, objects: Vec::new(), components: Vec::new(), items: Vec::new() };
    let mut reader = Reader { xml, budget, outline, numbers: HashMap::new(), prefixes: Rc::default() };
    if root.has_content() {
        reader.model()?;
    }
    reader.xml.finish("model")?;
    reader.resolved()
}

fn read_unit(unit: Option<Value<'_>>) -> Result<Unit, Located> {
    let Some(unit) = unit else { return Ok(Unit::Millimeter) };
    Unit::from_name(unit.trimmed()).ok_or_else(|| {
        let names = Unit::ALL.map(Unit::name);
        let (last, others) = names.split_last().expect("there are units");
        unit.token().unexpected(&format!("a unit ({} or {last})", others.join(", ")))
    })
}

/// Refuses what a reader must understand that this one does not.
fn check_extensions(xml: &Xml<'_>, required: &Value<'_>) -> Result<(), Located> {
    for token in required.tokens() {
        let prefix = std::str::from_utf8(token.bytes).expect("a part of a text, cut at blanks");
        let Some(namespace) = xml.namespace_of(prefix) else {
            return Err(token.unexpected("the prefix of a namespace"));
        };
        if !HARMLESS.contains(&namespace.as_str()) {
            // The end of a namespace tells more than its beginning.
            let start = namespace.rmatch_indices('/').nth(2).map_or(0, |(at, _)| at + 1);
            let end = Token { bytes: &namespace.as_bytes()[start..], line: token.line };
            return Err(token.fault(|prefix| Fault::Unsupported {
                what: format!("a model that requires the extension `{prefix}` ({}) of 3MF", end.shown()),
                instead: "export it without extensions, as plain triangles".into(),
            }));
        }
    }
    Ok(())
}

struct Reader<'t, 'b> {
    xml: Xml<'t>,
    budget: &'b mut Budget,
    outline: Outline,
    /// The place of an object among the objects, by its number in the file.
    numbers: HashMap<u32, usize>,
    prefixes: Rc<Vec<String>>,
}

impl<'t> Reader<'t, '_> {
    fn model(&mut self) -> Result<(), Located> {
        while let Some(part) = self.xml.child()? {
            if !part.has_content() {
                continue;
            }
            if part.is("resources") {
                while let Some(resource) = self.xml.child()? {
                    if resource.is("object") {
                        self.object(&resource)?;
                    } else {
                        self.xml.skip(&resource)?;
                    }
                }
            } else if part.is("build") {
                while let Some(item) = self.xml.child()? {
                    if item.is("item") {
                        let item = self.reference(&item)?;
                        self.outline.items.push(item);
                    } else {
                        self.xml.skip(&item)?;
                    }
                }
            } else {
                self.xml.skip(&part)?;
            }
        }
        Ok(())
    }

    fn object(&mut self, element: &Element<'t>) -> Result<(), Located> {
        let [id, kind, name, part] = element.attributes(["id", "type", "name", "partnumber"])?;
        let id = id.ok_or_else(|| element.lacks("id"))?;
        let number = read_number(&id)?;
        let is_support = match kind.as_ref().map(Value::trimmed) {
            None | Some("model" | "surface" | "other") => false,
            Some("support" | "solidsupport") => true,
            Some(_) => {
                let kind = kind.expect("there is one");
                return Err(kind
                    .token()
                    .unexpected("a type (model, solidsupport, support, surface or other)"));
            }
        };
        let name = name.or(part).map(|name| name.text().to_string()).unwrap_or_default();
        let bytes = 2 * size_of::<Object>() as u64 + TABLE_ENTRY + name.len() as u64;
        self.budget.charge(bytes).at_line(element.line)?;
        if self.numbers.insert(number, self.outline.objects.len()).is_some() {
            return Err(id.token().unexpected("the id of only one object"));
        }
        let mut content = Content::Nothing;
        if element.has_content() {
            while let Some(child) = self.xml.child()? {
                let found = if child.is("mesh") {
                    Content::Mesh(self.mesh(&child)?)
                } else if child.is("components") {
                    Content::Components(self.components(&child)?)
                } else {
                    self.xml.skip(&child)?;
                    continue;
                };
                if !matches!(content, Content::Nothing) {
                    return Err(child.unexpected("one mesh, or components"));
                }
                content = found;
            }
        }
        self.outline.objects.push(Object { name, is_support, line: element.line, content });
        Ok(())
    }

    fn mesh(&mut self, element: &Element<'t>) -> Result<MeshPlace, Located> {
        let prefixes = self.xml.core_prefixes();
        if prefixes != *self.prefixes {
            // They are shared by the meshes that have the same.
            let bytes = prefixes.iter().map(|prefix| 64 + prefix.len() as u64).sum();
            self.budget.charge(bytes).at_line(element.line)?;
            self.prefixes = Rc::new(prefixes);
        }
        self.xml.skip(element)?;
        let bytes = element.at..self.xml.position();
        Ok(MeshPlace { bytes, line: element.line, prefixes: Rc::clone(&self.prefixes) })
    }

    fn components(&mut self, element: &Element<'t>) -> Result<Range<usize>, Located> {
        let first = self.outline.components.len();
        if element.has_content() {
            while let Some(child) = self.xml.child()? {
                if child.is("component") {
                    let component = self.reference(&child)?;
                    self.outline.components.push(component);
                } else {
                    self.xml.skip(&child)?;
                }
            }
        }
        Ok(first..self.outline.components.len())
    }

    /// An item or a component. Its object is still the number in the file.
    fn reference(&mut self, element: &Element<'t>) -> Result<Reference, Located> {
        if let Some(path) = self.xml.attribute_of(element, "path", PRODUCTION)? {
            let what =
                format!("a model in several parts (`{}`)", Token { bytes: path.as_bytes(), line: 0 }.shown());
            let instead = "export it as one part".into();
            return Err(Fault::Unsupported { what, instead }.at(Place::Line(element.line)));
        }
        let [object, map] = element.attributes(["objectid", "transform"])?;
        let object = object.ok_or_else(|| element.lacks("objectid"))?;
        let object = read_number(&object)? as usize;
        let map = transform::read(map, element)?;
        let bytes = 2 * size_of::<Reference>() as u64 + map.as_ref().map_or(0, |map| map.bytes());
        self.budget.charge(bytes).at_line(element.line)?;
        self.xml.skip(element)?;
        Ok(Reference { object, map, line: element.line })
    }

    /// References by place instead of number; and what is built if the model does not say.
    fn resolved(self) -> Result<Outline, Located> {
        let Self { mut outline, numbers, budget, .. } = self;
        for reference in outline.components.iter_mut().chain(&mut outline.items) {
            let number = u32::try_from(reference.object).expect("a number of the file has 32 bits");
            reference.object = *numbers.get(&number).ok_or_else(|| {
                let token = number.to_string();
                Token { bytes: token.as_bytes(), line: reference.line }.unexpected("the id of an object")
            })?;
        }
        if outline.items.is_empty() {
            let count = outline.objects.len();
            budget.charge((2 * size_of::<Reference>() as u64 + 1) * count as u64)?;
            let mut used = vec![false; count];
            for component in &outline.components {
                used[component.object] = true;
            }
            let unused = (0..count).filter(|&object| !used[object]);
            let item = |object: usize| Reference { object, map: None, line: outline.objects[object].line };
            outline.items = unused.map(item).collect();
        }
        Ok(outline)
    }
}

fn read_number(id: &Value<'_>) -> Result<u32, Located> {
    let token = id.token();
    parse_u32(token.bytes).ok_or_else(|| token.unexpected("the number of an object"))
}
