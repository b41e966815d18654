//! The 3MF format, written with decimals.

use super::CORE;
use crate::base::model::Unit;
use crate::base::numerals::{Numerals, Rounding, put, put_number};
use crate::format::Format;
use crate::write::{Body, Task, WriteError, too_large};
use std::io::{Cursor, Write};
use std::ops::Range;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipWriter};

const CONTENT_TYPES: &str = "\
<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">
<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>
<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>
</Types>
";

const RELATIONSHIPS: &str = "\
<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">
<Relationship Id=\"model\" Target=\"/3D/3dmodel.model\" \
Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>
</Relationships>
";

/// The unit that is written where the model has none: the one that the standard assumes too.
pub(crate) const DEFAULT_UNIT: Unit = Unit::Millimeter;
/// What the standard allows in one mesh.
const MOST: usize = (1 << 31) - 1;
/// How much text is gathered before it is packed.
const CHUNK: usize = 1 << 16;
/// Vertices and facets together, from which the text may be longer than the plain zip format has room for.
const LARGE: usize = 1 << 24;

/// Writes a mesh as 3MF: each object that has a facet as an object with the vertices that it uses, built once. The
/// unit is the millimeter where the model has none.
pub(crate) fn write(task: &Task<'_>) -> Result<Body, WriteError> {
    let large = task.mesh.points.len() + task.mesh.facets.len() > LARGE;
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default())
        .system(System::Unix)
        .unix_permissions(0o644);
    let mut archive = Archive { zip: ZipWriter::new(Cursor::new(Vec::new())), text: Vec::new() };
    archive.file("[Content_Types].xml", options)?;
    archive.text.extend_from_slice(CONTENT_TYPES.as_bytes());
    archive.file("_rels/.rels", options)?;
    archive.text.extend_from_slice(RELATIONSHIPS.as_bytes());
    archive.file("3D/3dmodel.model", options.large_file(large))?;
    let rounding = put_model(task, &mut archive)?;
    Ok(Body::new(archive.finish()?, rounding))
}

fn put_model(task: &Task<'_>, archive: &mut Archive) -> Result<Rounding, WriteError> {
    let unit = task.unit.unwrap_or(DEFAULT_UNIT);
    put(
        &mut archive.text,
        format_args!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <model unit=\"{unit}\" xml:lang=\"en-US\" xmlns=\"{CORE}\">\n<resources>\n"
        ),
    );
    let mut rounding = Rounding::none();
    let mut runs = task.runs();
    runs.retain(|(_, facets)| !facets.is_empty());
    let mut places = vec![0; task.mesh.points.len()];
    for (number, (name, facets)) in runs.iter().enumerate() {
        put(&mut archive.text, format_args!("<object id=\"{}\" type=\"model\"", number + 1));
        if !name.is_empty() {
            put(&mut archive.text, format_args!(" name=\"{}\"", escaped(name)));
        }
        archive.text.extend_from_slice(b">\n");
        put_mesh(task, facets.clone(), &mut places, archive, &mut rounding)?;
        archive.text.extend_from_slice(b"</object>\n");
    }
    archive.text.extend_from_slice(b"</resources>\n<build>\n");
    for number in 1..=runs.len() {
        put(&mut archive.text, format_args!("<item objectid=\"{number}\"/>\n"));
    }
    archive.text.extend_from_slice(b"</build>\n</model>\n");
    Ok(rounding)
}

/// `places` has room for the place of each vertex in this mesh.
fn put_mesh(
    task: &Task<'_>,
    facets: Range<usize>,
    places: &mut [u32],
    archive: &mut Archive,
    rounding: &mut Rounding,
) -> Result<(), WriteError> {
    if facets.len() > MOST {
        return Err(too_many());
    }
    let numerals = task.numerals(Numerals::Decimals);
    let cycles = || facets.clone().map(|facet| task.mesh.facets.get(facet));
    let mut used: Vec<u32> = cycles().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    archive.text.extend_from_slice(b"<mesh>\n<vertices>\n");
    for (place, &vertex) in (0..).zip(&used) {
        let vertex = vertex as usize;
        places[vertex] = place;
        let point = &task.mesh.points[vertex];
        archive.text.extend_from_slice(b"<vertex");
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            put(&mut archive.text, format_args!(" {name}=\""));
            put_number(&mut archive.text, &point.coordinate(axis), numerals, rounding)
                .map_err(too_large(vertex))?;
            archive.text.push(b'"');
        }
        archive.text.extend_from_slice(b"/>\n");
        archive.pack_chunk()?;
    }
    archive.text.extend_from_slice(b"</vertices>\n<triangles>\n");
    for cycle in cycles() {
        archive.text.extend_from_slice(b"<triangle");
        for (corner, &vertex) in cycle.iter().enumerate() {
            put(&mut archive.text, format_args!(" v{}=\"{}\"", corner + 1, places[vertex as usize]));
        }
        archive.text.extend_from_slice(b"/>\n");
        archive.pack_chunk()?;
    }
    archive.text.extend_from_slice(b"</triangles>\n</mesh>\n");
    Ok(())
}

/// An archive that is being written, with text of its last file that is not yet packed.
struct Archive {
    zip: ZipWriter<Cursor<Vec<u8>>>,
    text: Vec<u8>,
}

impl Archive {
    /// Begins the next file.
    fn file(&mut self, name: &str, options: SimpleFileOptions) -> Result<(), WriteError> {
        self.pack()?;
        self.zip.start_file(name, options).map_err(|_| too_many())
    }

    fn pack(&mut self) -> Result<(), WriteError> {
        // Writing to memory fails only where a size has no room in the archive.
        self.zip.write_all(&self.text).map_err(|_| too_many())?;
        self.text.clear();
        Ok(())
    }

    fn pack_chunk(&mut self) -> Result<(), WriteError> {
        if self.text.len() >= CHUNK { self.pack() } else { Ok(()) }
    }

    fn finish(mut self) -> Result<Vec<u8>, WriteError> {
        self.pack()?;
        Ok(self.zip.finish().map_err(|_| too_many())?.into_inner())
    }
}

fn too_many() -> WriteError {
    WriteError::TooMany { format: Format::ThreeMf }
}

/// A name as the value of an attribute, without what XML has no way to write.
fn escaped(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    for character in name.chars() {
        match character {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            _ if is_left_out(character) => {}
            _ => text.push(character),
        }
    }
    text
}

/// Whether the name of an object comes back as it is.
pub(crate) fn takes_name(name: &str) -> bool {
    !name.contains(is_left_out)
}

fn is_left_out(character: char) -> bool {
    character.is_control() || matches!(character, '\u{FFFE}' | '\u{FFFF}')
}
