//! The OBJ format, written with decimals.

use crate::base::model::Kind;
use crate::base::numerals::{Numerals, Rounding, put, put_point};
use crate::write::{Body, Task, WriteError, too_large};

/// Writes a mesh as OBJ: the vertices, then the facets of each object under its name. A point set is written
/// with `p`, segments with `l`.
///
/// A name stands in one line: its line breaks become blanks. Blanks around it are left out, and what would
/// end it (a `#` behind a blank, a backslash at its end) becomes `_`.
pub(crate) fn write(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let mut bytes = Vec::with_capacity(24 * mesh.points.len() + 8 * mesh.facets.corners().len());
    let mut rounding = Rounding::none();
    let numerals = task.numerals(Numerals::Decimals);
    for (vertex, point) in mesh.points.iter().enumerate() {
        bytes.extend_from_slice(b"v ");
        put_point(&mut bytes, point, numerals, &mut rounding).map_err(too_large(vertex))?;
        bytes.push(b'\n');
    }
    if Kind::of(mesh) == Kind::Points {
        for vertex in 1..=mesh.points.len() {
            put(&mut bytes, format_args!("p {vertex}\n"));
        }
    }
    for (at, (name, facets)) in task.runs().into_iter().filter(|(_, facets)| !facets.is_empty()).enumerate() {
        let name = one_line(name);
        if at > 0 || !name.is_empty() {
            put(&mut bytes, format_args!("{}\n", format!("o {name}").trim_ascii_end()));
        }
        for facet in facets {
            let cycle = mesh.facets.get(facet);
            bytes.push(if cycle.len() == 2 { b'l' } else { b'f' });
            for index in cycle {
                put(&mut bytes, format_args!(" {}", u64::from(*index) + 1));
            }
            bytes.push(b'\n');
        }
    }
    Ok(Body::new(bytes, rounding))
}

/// A name that comes back when it is read, if it has no line break.
fn one_line(name: &str) -> String {
    let blanks = name.replace(|c: char| c.is_control(), " ");
    let mut line = blanks.trim_matches(|c: char| c.is_ascii_whitespace()).to_string();
    if line.starts_with('#') {
        line.replace_range(..1, "_");
    }
    if line.ends_with('\\') {
        line.replace_range(line.len() - 1.., "_");
    }
    line.replace(" #", " _")
}

/// Whether the name of an object comes back as it is.
pub(crate) fn takes_name(name: &str) -> bool {
    one_line(name) == name
}
