//! Places and other values of options and their names, and what is written by the ending of a name.

use super::Place;
use splitstar::formats::{Encoding, Format};

/// What an arrangement is written as, and whether gzip is put around it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct CellEncoding {
    pub(crate) format: CellFormat,
    pub(crate) gzip: bool,
}

/// What an arrangement is written as.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum CellFormat {
    /// The native text format.
    Star,
    /// A picture.
    Svg,
}

impl CellEncoding {
    /// Without an ending: star, not packed.
    pub(super) const DEFAULT: Self = Self { format: CellFormat::Star, gzip: false };

    /// What `star`, `svg`, `star.gz` and `svg.gz` stand for.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        let (name, gzip) = name.strip_suffix(".gz").map_or((name, false), |name| (name, true));
        let format = match name {
            "star" => CellFormat::Star,
            "svg" => CellFormat::Svg,
            _ => return None,
        };
        Some(Self { format, gzip })
    }
}

/// How polytopes are added.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum Method {
    /// A walk over both Gaussian maps.
    #[default]
    Overlay,
    /// Gaussian maps as arrangements on the sphere.
    Sgm,
    /// The same on the sides of a cube.
    Cgm,
    /// Linear programs.
    Lp,
    /// The convex hull of all sums of vertices.
    Hull,
}

impl Method {
    pub(super) const ALL: [Self; 5] = [Self::Overlay, Self::Sgm, Self::Cgm, Self::Lp, Self::Hull];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Overlay => "overlay",
            Self::Sgm => "sgm",
            Self::Cgm => "cgm",
            Self::Lp => "lp",
            Self::Hull => "hull",
        }
    }

    pub(super) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| name == method.name())
    }
}

/// What curves lie on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Surface {
    Plane,
    Torus,
    Sphere,
}

impl Surface {
    pub(super) fn from_name(name: &str) -> Option<Self> {
        match name {
            "plane" => Some(Self::Plane),
            "torus" => Some(Self::Torus),
            "sphere" => Some(Self::Sphere),
            _ => None,
        }
    }
}

/// How a picture shows the sphere.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum View {
    /// Two hemispheres.
    Globe,
    /// Longitude and latitude.
    Unfolded,
}

impl View {
    pub(super) fn from_name(name: &str) -> Option<Self> {
        match name {
            "globe" => Some(Self::Globe),
            "unfolded" => Some(Self::Unfolded),
            _ => None,
        }
    }
}

/// How the cells of points are found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Strategy {
    Naive,
    Walk,
    Landmarks,
    Trapezoids,
    Sweep,
}

impl Strategy {
    pub(super) const ALL: [Self; 5] =
        [Self::Naive, Self::Walk, Self::Landmarks, Self::Trapezoids, Self::Sweep];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Naive => "naive",
            Self::Walk => "walk",
            Self::Landmarks => "landmarks",
            Self::Trapezoids => "trapezoids",
            Self::Sweep => "sweep",
        }
    }

    pub(super) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|strategy| name == strategy.name())
    }
}

/// Where a vertical ray goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Ray {
    Up,
    Down,
}

impl Ray {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
        }
    }

    pub(super) fn from_name(name: &str) -> Option<Self> {
        [Self::Up, Self::Down].into_iter().find(|ray| name == ray.name())
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

    /// Whether the ending of the name is that of gzip.
    pub(crate) fn is_packed(&self) -> bool {
        let name = self.file_name().unwrap_or_default();
        name.rsplit_once('.').is_some_and(|(_, ending)| ending.eq_ignore_ascii_case("gz"))
    }

    /// The name of a file in its folder.
    pub(crate) fn file_name(&self) -> Option<String> {
        match self {
            Self::Standard => None,
            Self::File(path) => path.file_name().map(|name| name.to_string_lossy().into_owned()),
        }
    }
}

/// What an arrangement or a map is written as by the ending of a name; star where a name has no ending.
pub(super) fn cells_of_name(output: &Place, what: &str) -> Result<CellEncoding, String> {
    let name = output.file_name().unwrap_or_default();
    let Some((stem, last)) = name.rsplit_once('.') else { return Ok(CellEncoding::DEFAULT) };
    let ending = match stem.rsplit_once('.') {
        Some((_, before)) if last.eq_ignore_ascii_case("gz") => &name[name.len() - before.len() - 3..],
        _ => last,
    };
    CellEncoding::from_name(&ending.to_ascii_lowercase()).ok_or_else(|| {
        format!(
            "{what} is not written as `.{ending}`; use .star or .svg, each also with .gz, or --format: star or svg"
        )
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
