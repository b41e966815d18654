//! VRML 2, written so that others read it too.

use crate::base::model::Kind;
use crate::base::numerals::{Numerals, Rounding, put, put_number, put_point};
use crate::write::{Body, Task, WriteError, too_large};
use exact::{Point3, Sign};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The definition of the node with exact coordinates, for readers that do not know it: a `Coordinate` with a
/// field more.
const EXACT_COORDINATE: &str = "PROTO ExactCoordinate [ exposedField MFVec3f point [] field MFString exact [] ] {\n  \
                                Coordinate { point IS point }\n}\n";

/// Writes a mesh as VRML 2: a `Shape` for each object, all with the same coordinates.
///
/// The coordinates are decimals in a `Coordinate`, or fractions in an `ExactCoordinate` if one of them is no
/// decimal of few digits. An object keeps its name if that may be a name in VRML; other names
/// are changed.
pub(crate) fn write(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let coordinates = coordinates(task)?;
    let mut bytes = b"#VRML V2.0 utf8\n".to_vec();
    bytes.reserve(coordinates.bytes.len() + 8 * mesh.facets.corners().len());
    if coordinates.exact {
        bytes.extend_from_slice(EXACT_COORDINATE.as_bytes());
    }
    // A point set has one run, without facets.
    let kind = Kind::of(mesh);
    let has_cells = |facets: &Range<usize>| kind == Kind::Points || !facets.is_empty();
    let runs: Vec<_> = task.runs().into_iter().filter(|(_, facets)| has_cells(facets)).collect();
    let names = identifiers(&runs);
    let shared = shared_name(&names);
    for (at, (name, (_, facets))) in names.iter().zip(&runs).enumerate() {
        if !name.is_empty() {
            put(&mut bytes, format_args!("DEF {name} "));
        }
        let geometry = match kind {
            Kind::Points => "PointSet",
            Kind::Segments => "IndexedLineSet",
            Kind::Polygon | Kind::Surface => "IndexedFaceSet",
        };
        put(
            &mut bytes,
            format_args!(
                "Shape {{\n  appearance Appearance {{ material Material {{}} }}\n  geometry {geometry} {{\n"
            ),
        );
        if kind.has_polygons() {
            let triangles = facets.clone().all(|facet| mesh.facets.get(facet).len() == 3);
            let [solid, convex] =
                [kind == Kind::Surface, triangles].map(|is| if is { "TRUE" } else { "FALSE" });
            put(&mut bytes, format_args!("    solid {solid}\n    convex {convex}\n"));
        }
        bytes.extend_from_slice(b"    coord ");
        match (at, runs.len()) {
            (0, 1) => bytes.extend_from_slice(&coordinates.bytes),
            (0, _) => {
                put(&mut bytes, format_args!("DEF {shared} "));
                bytes.extend_from_slice(&coordinates.bytes);
            }
            _ => put(&mut bytes, format_args!("USE {shared}\n")),
        }
        if kind != Kind::Points {
            bytes.extend_from_slice(b"    coordIndex [\n");
            for facet in facets.clone() {
                bytes.extend_from_slice(b"      ");
                for index in mesh.facets.get(facet) {
                    put(&mut bytes, format_args!("{index} "));
                }
                bytes.extend_from_slice(b"-1\n");
            }
            bytes.extend_from_slice(b"    ]\n");
        }
        bytes.extend_from_slice(b"  }\n}\n");
    }
    Ok(Body::new(bytes, coordinates.rounding))
}

/// A node with the coordinates of all vertices.
struct Coordinates {
    bytes: Vec<u8>,
    exact: bool,
    rounding: Rounding,
}

fn coordinates(task: &Task<'_>) -> Result<Coordinates, WriteError> {
    let points = &task.mesh.points;
    let mut rounding = Rounding::none();
    let numerals = task.numerals(Numerals::Decimals);
    let mut bytes = Vec::with_capacity(32 * points.len());
    bytes.extend_from_slice(b"Coordinate {\n      point [\n");
    for (vertex, point) in points.iter().enumerate() {
        bytes.extend_from_slice(LINE);
        let put = put_point(&mut bytes, point, numerals, &mut rounding);
        if !task.float && (put.is_err() || !rounding.0.is_zero()) {
            return Ok(exact_coordinates(points));
        }
        put.map_err(too_large(vertex))?;
        bytes.push(b'\n');
    }
    bytes.extend_from_slice(b"      ]\n    }\n");
    Ok(Coordinates { bytes, exact: false, rounding })
}

/// What stands before the coordinates of a vertex.
const LINE: &[u8] = b"        ";

fn exact_coordinates(points: &[Point3]) -> Coordinates {
    let mut bytes = Vec::with_capacity(64 * points.len());
    let mut rounding = Rounding::none();
    bytes.extend_from_slice(b"ExactCoordinate {\n      point [\n");
    for point in points {
        bytes.extend_from_slice(LINE);
        for (axis, number) in point.coordinates().iter().enumerate() {
            if axis > 0 {
                bytes.push(b' ');
            }
            if put_number(&mut bytes, number, Numerals::Floats, &mut rounding).is_err() {
                // There is no such float. The field is for viewers, whose floats have 32 bits anyway.
                let largest = if number.sign() == Sign::Negative { "-3e38" } else { "3e38" };
                bytes.extend_from_slice(largest.as_bytes());
            }
        }
        bytes.push(b'\n');
    }
    bytes.extend_from_slice(b"      ]\n      exact [\n");
    for point in points {
        bytes.extend_from_slice(LINE);
        bytes.push(b'"');
        put_point(&mut bytes, point, Numerals::Fractions, &mut rounding).expect("fractions have no limit");
        bytes.extend_from_slice(b"\"\n");
    }
    bytes.extend_from_slice(b"      ]\n    }\n");
    Coordinates { bytes, exact: true, rounding: Rounding::none() }
}

/// Names that VRML takes, one for each run: what is no identifier is made one; no name is no name.
fn identifiers(runs: &[(&str, Range<usize>)]) -> Vec<String> {
    let valid = runs.iter().map(|(name, _)| *name).filter(|name| is_identifier(name));
    let mut taken: BTreeSet<String> = valid.map(str::to_string).collect();
    // How often a name was made, so that many runs of one name are not many attempts each.
    let mut made: BTreeMap<String, u32> = BTreeMap::new();
    let mut identifier = |name: &str| {
        let letters = name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' });
        let base: String = std::iter::once('_').chain(letters).collect();
        let count = made.entry(base.clone()).or_insert(0);
        loop {
            *count += 1;
            let name = if *count == 1 { base.clone() } else { format!("{base}_{count}") };
            if taken.insert(name.clone()) {
                return name;
            }
        }
    };
    let names = runs.iter().map(|&(name, _)| {
        if name.is_empty() || is_identifier(name) { name.to_string() } else { identifier(name) }
    });
    names.collect()
}

/// A name for the coordinates that no object has.
fn shared_name(names: &[String]) -> String {
    let names: BTreeSet<&str> = names.iter().map(String::as_str).collect();
    let mut shared = "points".to_string();
    while names.contains(shared.as_str()) {
        shared.push('_');
    }
    shared
}

/// Whether an object keeps its name; no name is none.
pub(crate) fn takes_name(name: &str) -> bool {
    name.is_empty() || is_identifier(name)
}

/// Whether VRML takes it for a name.
fn is_identifier(name: &str) -> bool {
    const KEYWORDS: [&str; 14] = [
        "DEF",
        "EXTERNPROTO",
        "FALSE",
        "IS",
        "NULL",
        "PROTO",
        "ROUTE",
        "TO",
        "TRUE",
        "USE",
        "eventIn",
        "eventOut",
        "exposedField",
        "field",
    ];
    let never = |c: char| c <= ' ' || c == '\x7F' || "\"#',.[\\]{}".contains(c);
    let first = |c: char| c.is_ascii_digit() || c == '+' || c == '-';
    !name.is_empty() && !name.contains(never) && !name.starts_with(first) && !KEYWORDS.contains(&name)
}
