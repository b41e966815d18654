//! What a file says, whatever its format.

use crate::base::places::Places;
use crate::complex::Complex;
use crate::format::Format;
use exact::{Affine3, Integer, Point3, Rational};
use polytope::{Mended, PolygonMesh};
use std::fmt;

/// What is read from a file, and can be written to one.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Model {
    /// Points and cells.
    pub shape: Shape,
    /// The objects that the facets belong to, by their first facets in ascending order. Facets before
    /// the first object belong to none.
    pub objects: Vec<Object>,
    /// The unit of length, where the file has one.
    pub unit: Option<Unit>,
}

/// The cells of a model.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Points and polygons: what every mesh format can say.
    Mesh(PolygonMesh),
    /// Cells with marks, holes, directions: what only the native format can say.
    Complex(Complex),
}

/// A named run of facets.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Object {
    /// Its name, perhaps empty.
    pub name: String,
    /// The index of its first facet; it ends where the next object begins.
    pub first_facet: u32,
}

/// A unit of length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Unit {
    /// 1/1,000,000 meter.
    Micron,
    /// 1/1,000 meter.
    Millimeter,
    /// 1/100 meter.
    Centimeter,
    /// 127/5,000 meter.
    Inch,
    /// 381/1,250 meter.
    Foot,
    /// 1 meter.
    Meter,
}

/// A model with what is known of its file.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ReadModel {
    /// What the file says.
    pub model: Model,
    /// The format that was found.
    pub format: Format,
    /// Where the cells stand.
    pub places: Places,
    /// What of the file is not in the model.
    pub notes: Vec<ReadNote>,
}

/// What was left out of a model because it means nothing there.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ReadNote {
    /// STL has no indices: a facet with two corners at the same position is no facet.
    DegenerateDropped {
        /// The number of such facets.
        facets: usize,
    },
}

/// What the facets of a mesh make of its points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Kind {
    /// No facet: a point set, which stands for its hull.
    Points,
    /// All facets have two vertices: segments, normally one.
    Segments,
    /// One polygon: a polytope of dimension 2, if it is convex.
    Polygon,
    /// More than one polygon.
    Surface,
}

impl Kind {
    /// What the facets make of the points.
    pub fn of(mesh: &PolygonMesh) -> Self {
        let facets = &mesh.facets;
        match facets.len() {
            0 => Self::Points,
            // The readers refuse segments beside polygons: the first facet speaks for all.
            _ if facets.get(0).len() == 2 => Self::Segments,
            1 => Self::Polygon,
            _ => Self::Surface,
        }
    }
}

impl Model {
    /// A model of one mesh, without names and units.
    pub fn of_mesh(mesh: PolygonMesh) -> Self {
        Self { shape: Shape::Mesh(mesh), objects: Vec::new(), unit: None }
    }
}

impl Shape {
    /// What a mended mesh is: a mesh again, or a complex if its facets have holes.
    pub fn of_mended(mended: Mended) -> Self {
        if mended.holes.is_empty() {
            Self::Mesh(mended.mesh)
        } else {
            Self::Complex(Complex::of_mended(mended))
        }
    }

    /// The mesh, if it is one.
    pub fn mesh(&self) -> Option<&PolygonMesh> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            Self::Complex(_) => None,
        }
    }

    /// The points among its vertices, in order.
    pub fn points(&self) -> impl Iterator<Item = &Point3> {
        let (mesh, complex) = match self {
            Self::Mesh(mesh) => (Some(mesh), None),
            Self::Complex(complex) => (None, Some(complex)),
        };
        let of_mesh = mesh.into_iter().flat_map(|mesh| mesh.points.iter());
        of_mesh.chain(complex.into_iter().flat_map(Complex::points))
    }

    /// The same cells under an affine map; cycles are turned round if the map reflects.
    ///
    /// `None` if the map takes the direction of an unbounded cell to zero, as only maps do that flatten space.
    pub fn transformed(&self, map: &Affine3) -> Option<Self> {
        match self {
            Self::Mesh(mesh) => Some(Self::Mesh(mesh.transformed(map))),
            Self::Complex(complex) => complex.transformed(map).map(Self::Complex),
        }
    }

    /// The mesh, if it is one.
    pub fn into_mesh(self) -> Option<PolygonMesh> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            Self::Complex(_) => None,
        }
    }
}

impl Unit {
    /// All units, from small to large.
    pub const ALL: [Self; 6] =
        [Self::Micron, Self::Millimeter, Self::Centimeter, Self::Inch, Self::Foot, Self::Meter];

    /// Its name, as 3MF and the native format write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Micron => "micron",
            Self::Millimeter => "millimeter",
            Self::Centimeter => "centimeter",
            Self::Inch => "inch",
            Self::Foot => "foot",
            Self::Meter => "meter",
        }
    }

    /// The unit of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// How many meters it is, exactly.
    pub fn meters(self) -> Rational {
        let (numerator, denominator): (i64, i64) = match self {
            Self::Micron => (1, 1_000_000),
            Self::Millimeter => (1, 1_000),
            Self::Centimeter => (1, 100),
            Self::Inch => (127, 5_000),
            Self::Foot => (381, 1_250),
            Self::Meter => (1, 1),
        };
        Rational::new(Integer::from(numerator), Integer::from(denominator)).expect("no denominator is zero")
    }
}

impl fmt::Display for ReadNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DegenerateDropped { facets: 1 } => {
                f.write_str("1 facet has two corners at the same position: left out")
            }
            Self::DegenerateDropped { facets } => {
                write!(f, "{facets} facets have two corners at the same position: left out")
            }
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
