//! Files of other programs, read by us.

use std::fs;
use std::path::Path;

use polytope::MeshSummary;
use serde_json::Value;

use super::table::{Cell, Row};
use crate::Failure;

/// Volumes agree up to this part: others write coordinates of 32 bits, or few digits.
const PART: f64 = 1e-6;

/// Reads every file that the manifest in `folder` lists.
///
/// # Errors
/// If the manifest is missing or lists nothing. What is wrong with a file is in its row.
pub(super) fn read(folder: &Path) -> Result<Vec<Row>, Failure> {
    let manifest: Value = serde_json::from_str(&fs::read_to_string(folder.join("manifest.json"))?)?;
    let entries = manifest.as_array().filter(|entries| !entries.is_empty());
    let mut rows = Vec::new();
    for entry in entries.ok_or("the other programs wrote no file")? {
        let text = |key: &str| entry[key].as_str().unwrap_or_default();
        let cell = match check(folder, entry) {
            Ok(()) => Cell::Passed,
            Err(failure) => Cell::Failed(failure.to_string()),
        };
        let file = format!("{} of {}", text("file"), text("writer"));
        rows.push(Row::new(&file, text("format"), "theirs, by us", cell));
    }
    Ok(rows)
}

fn check(folder: &Path, entry: &Value) -> Result<(), Failure> {
    let file = entry["file"].as_str().ok_or("a file has a name")?;
    let bytes = fs::read(folder.join(file))?;
    let read = formats::read(&bytes, Some(file))?;
    let mesh = read.model.shape.into_mesh().ok_or("it is no mesh")?;
    let facts = MeshSummary::of(&mesh);
    let volume = facts.volume.as_ref().ok_or("the surface is not closed")?.approx_f64();
    let wanted = entry["volume"].as_f64().ok_or("a file has a volume")?;
    if (volume - wanted).abs() > PART * wanted.abs() {
        return Err(format!("the volume is {volume}, not {wanted}").into());
    }
    for (what, count, key) in [
        ("triangles", mesh.facets.len(), "triangles"),
        ("vertices without flat edges", facts.vertices, "vertices"),
        ("facets without flat edges", facts.facets, "facets"),
    ] {
        if let Some(wanted) = entry[key].as_u64()
            && wanted != count as u64
        {
            return Err(format!("{count} {what}, not {wanted}").into());
        }
    }
    if !facts.convex {
        return Err("it is not convex".into());
    }
    Ok(())
}
