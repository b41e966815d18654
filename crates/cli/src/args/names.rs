//! Places and their names, and what is written by the ending of a name.

use super::Place;
use splitstar::formats::{Encoding, Format};

/// What an arrangement is written as.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum CellFormat {
    /// The native text format.
    Star,
    /// A picture.
    Svg,
}

impl CellFormat {
    pub(super) fn from_name(name: &str) -> Option<Self> {
        match name {
            "star" => Some(Self::Star),
            "svg" => Some(Self::Svg),
            _ => None,
        }
    }
}

impl Place {
    /// The name that messages give it.
    pub(crate) fn shown(&self) -> String {
        match self {
            Self::Standard => "-".to_string(),
            Self::File(path) => path.to_string_lossy().into_owned(),
        }
    }

    /// The name of a file in its folder.
    pub(crate) fn file_name(&self) -> Option<String> {
        match self {
            Self::Standard => None,
            Self::File(path) => path.file_name().map(|name| name.to_string_lossy().into_owned()),
        }
    }
}

/// What an arrangement is written as by the ending of a name; star where a name has no ending.
pub(super) fn cells_of_name(output: &Place) -> Result<CellFormat, String> {
    let name = output.file_name().unwrap_or_default();
    let Some((_, ending)) = name.rsplit_once('.') else { return Ok(CellFormat::Star) };
    CellFormat::from_name(&ending.to_ascii_lowercase()).ok_or_else(|| {
        format!("an arrangement is not written as `.{ending}`; use .star or .svg, or --format: star or svg")
    })
}

/// The format by the ending of a name; OFF where a name has no ending.
pub(super) fn encoding_of_name(output: &Place) -> Result<Encoding, String> {
    let name = output.file_name().unwrap_or_default();
    let Some((_, ending)) = name.rsplit_once('.') else { return Ok(Format::Off.into()) };
    Encoding::from_file_name(&name).ok_or_else(|| {
        format!("`.{ending}` is the ending of no format; use another, or --format: {}", format_names())
    })
}

pub(super) fn format_names() -> String {
    format!("{}, each also with .gz", Format::ALL.map(Format::name).join(", "))
}
