//! The formats: their names, what each can hold, and how they are told apart.

use crate::base::scan::Scanner;
use std::fmt;

/// A file format, with the variant where it has several.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Format {
    /// OFF, as text; coordinates may be fractions.
    Off,
    /// Wavefront OBJ.
    Obj,
    /// STL, binary: triangles with 32-bit floats.
    Stl,
    /// STL, as text.
    StlAscii,
    /// PLY, binary, little-endian.
    Ply,
    /// PLY, binary, big-endian.
    PlyBigEndian,
    /// PLY, as text.
    PlyAscii,
    /// 3MF: a zip archive with a model in XML.
    ThreeMf,
    /// glTF 2, binary: written only.
    Glb,
    /// VRML 2, with exact coordinates where floats do not do.
    Vrml,
    /// The native text format.
    Star,
}

/// What a format can hold of a mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Abilities {
    pub(crate) polygons: bool,
    /// Points without facets, and segments.
    pub(crate) points: bool,
    pub(crate) objects: bool,
    pub(crate) unit: bool,
    /// Vertices that are in no facet, where there are facets.
    pub(crate) unused_vertices: bool,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 11] = [
        Self::Off,
        Self::Obj,
        Self::Stl,
        Self::StlAscii,
        Self::Ply,
        Self::PlyBigEndian,
        Self::PlyAscii,
        Self::ThreeMf,
        Self::Glb,
        Self::Vrml,
        Self::Star,
    ];

    /// Its name on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::StlAscii => "stl-ascii",
            Self::Ply => "ply",
            Self::PlyBigEndian => "ply-big-endian",
            Self::PlyAscii => "ply-ascii",
            Self::ThreeMf => "3mf",
            Self::Glb => "glb",
            Self::Vrml => "wrl",
            Self::Star => "star",
        }
    }

    /// The format of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// The format that files with this ending of their name have, in any case; without the point.
    pub fn from_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "off" | "xoff" | "coff" | "noff" => Some(Self::Off),
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "ply" => Some(Self::Ply),
            "3mf" => Some(Self::ThreeMf),
            "glb" => Some(Self::Glb),
            "wrl" | "vrml" => Some(Self::Vrml),
            "star" => Some(Self::Star),
            _ => None,
        }
    }

    /// The index that files of this format give the first vertex.
    pub fn first_index(self) -> u32 {
        u32::from(self == Self::Obj)
    }

    pub(crate) fn abilities(self) -> Abilities {
        let mesh =
            Abilities { polygons: true, points: true, objects: false, unit: false, unused_vertices: true };
        match self {
            Self::Off | Self::Ply | Self::PlyBigEndian | Self::PlyAscii => mesh,
            Self::Obj | Self::Vrml => Abilities { objects: true, ..mesh },
            // A text may have several solids, but many programs read the first one only.
            Self::Stl | Self::StlAscii => {
                Abilities { polygons: false, points: false, unused_vertices: false, ..mesh }
            }
            Self::ThreeMf => Abilities {
                polygons: false,
                points: false,
                objects: true,
                unit: true,
                unused_vertices: false,
            },
            // Its unit is the meter: a model with a unit is scaled.
            Self::Glb => {
                Abilities { polygons: false, objects: true, unit: true, unused_vertices: false, ..mesh }
            }
            // There they would be points of the set.
            Self::Star => Abilities { objects: true, unit: true, unused_vertices: false, ..mesh },
        }
    }

    /// The format of a file, by what it begins with; `None` if it may be of any.
    ///
    /// `length` is that of the whole file, of which `start` has the first bytes.
    pub(crate) fn of_content(start: &[u8], length: usize) -> Content {
        if start.starts_with(b"\x1F\x8B") {
            return Content::Gzip;
        }
        if start.starts_with(b"PK\x03\x04") || start.starts_with(b"PK\x05\x06") {
            return Content::Known(Self::ThreeMf);
        }
        if start.starts_with(b"glTF") {
            return Content::Known(Self::Glb);
        }
        if start.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(start).starts_with(b"ply")
            && matches!(
                start.iter().find(|byte| !b"\xEF\xBB\xBFply".contains(byte)),
                Some(b'\n' | b'\r' | b' ' | b'\t')
            )
        {
            return Content::Known(Self::Ply);
        }
        if crate::stl::is_binary(start, length) {
            return Content::Known(Self::Stl);
        }
        let content = Self::of_text(start);
        // Binary STL that is cut short may have a header that begins like any text.
        match content {
            Content::Known(Self::StlAscii) => content,
            Content::Known(format) if crate::stl::has_zero(start) => Content::Unlikely(format),
            Content::Xml | Content::Json if crate::stl::has_zero(start) => Content::Unknown,
            _ => content,
        }
    }

    /// The format of a text, by its first line or word.
    fn of_text(start: &[u8]) -> Content {
        if start.starts_with(b"#VRML") || start.starts_with(b"\xEF\xBB\xBF#VRML") {
            return Content::Known(Self::Vrml);
        }
        let Some(word) = Scanner::new(start).token() else { return Content::Unknown };
        match word.bytes {
            b"star" => Content::Known(Self::Star),
            word if word.eq_ignore_ascii_case(b"solid") => Content::Known(Self::StlAscii),
            b"v" | b"vn" | b"vt" | b"vp" | b"f" | b"fo" | b"l" | b"p" | b"o" | b"g" | b"s" | b"lod"
            | b"mtllib" | b"usemtl" | b"usemap" | b"cstype" => Content::Known(Self::Obj),
            word if word.ends_with(b"OFF") => Content::Known(Self::Off),
            word if word.starts_with(b"<") => Content::Xml,
            word if word.starts_with(b"{") => Content::Json,
            _ => Content::Unknown,
        }
    }
}

/// What the first bytes of a file tell of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Content {
    Known(Format),
    /// It begins as a text of this format, but has zero bytes, as no text has: the ending decides, if there is one.
    Unlikely(Format),
    Gzip,
    /// No format of ours is bare XML or JSON, but people will try.
    Xml,
    Json,
    Unknown,
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Off => "OFF",
            Self::Obj => "OBJ",
            Self::Stl | Self::StlAscii => "STL",
            Self::Ply | Self::PlyBigEndian | Self::PlyAscii => "PLY",
            Self::ThreeMf => "3MF",
            Self::Glb => "glTF",
            Self::Vrml => "VRML",
            Self::Star => "star",
        })
    }
}

/// A format, perhaps packed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Encoding {
    /// The format.
    pub format: Format,
    /// Whether gzip is around it.
    pub gzip: bool,
}

impl Encoding {
    /// The encoding that the ending of a file's name asks for, as `cube.off` or `cube.stl.gz`; an ending alone will do.
    pub fn from_file_name(name: &str) -> Option<Self> {
        let (stem, gzip) = without_gz(name);
        let extension = stem.rsplit_once('.').map_or(stem, |(_, extension)| extension);
        Some(Self { format: Format::from_extension(extension)?, gzip })
    }

    /// The encoding of that name: the name of a format, perhaps with `.gz` behind it.
    pub fn from_name(name: &str) -> Option<Self> {
        let (stem, gzip) = without_gz(name);
        Some(Self { format: Format::from_name(stem)?, gzip })
    }
}

impl From<Format> for Encoding {
    fn from(format: Format) -> Self {
        Self { format, gzip: false }
    }
}

fn without_gz(name: &str) -> (&str, bool) {
    match name.len().checked_sub(3).and_then(|at| Some((name.get(..at)?, name.get(at..)?))) {
        Some((stem, ending)) if ending.eq_ignore_ascii_case(".gz") => (stem, true),
        _ => (name, false),
    }
}
