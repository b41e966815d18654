//! What can be wrong with a file.

use super::places::Place;
use crate::format::Format;
use std::fmt;

/// Why a file cannot be read: what is wrong, where, and what to do.
///
/// [`Display`](fmt::Display) begins with the place; [`sentence`](Self::sentence) leaves it out, for
/// callers that put the file's name and [`place`](Self::place) before it.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct ReadError {
    /// The format that the file was taken for.
    pub format: Option<Format>,
    /// The file within an archive that is at fault.
    pub part: Option<String>,
    /// The place at fault; `None` if it is the whole file.
    pub place: Option<Place>,
    /// What is wrong.
    pub fault: Fault,
}

/// What is wrong with a file.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Fault {
    /// There is nothing in the file but blank lines and comments.
    Empty,
    /// The file is of no format that is known.
    UnknownFormat {
        /// What it begins with.
        token: String,
    },
    /// The format is known, but not this part or variant of it.
    Unsupported {
        /// What cannot be read.
        what: String,
        /// What to do.
        instead: String,
    },
    /// Something else was expected.
    Syntax {
        /// What stands there.
        found: String,
        /// What was expected.
        expected: String,
    },
    /// A count is not a whole number, or is negative.
    BadCount {
        /// What stands there.
        token: String,
        /// What is counted.
        of: Count,
    },
    /// A count is 2^32 - 1 or more.
    CountTooLarge {
        /// What stands there.
        token: String,
        /// What is counted.
        of: Count,
    },
    /// There is no vertex.
    NoVertices,
    /// A coordinate is not a number.
    BadNumber {
        /// What stands there.
        token: String,
        /// What is wrong with it.
        fault: NumberFault,
    },
    /// A vertex index is not a whole number.
    BadIndex {
        /// What stands there.
        token: String,
        /// The index of the first vertex in this format.
        first: u32,
    },
    /// There is no vertex of that index.
    IndexOutOfRange {
        /// The index as written.
        index: String,
        /// The number of vertices there are.
        vertices: u32,
        /// The index of the first vertex in this format.
        first: u32,
    },
    /// A facet passes through a vertex twice.
    RepeatedVertex {
        /// The index of the vertex, as in the file.
        vertex: u32,
        /// Whether the two mentions follow each other in the cycle.
        in_a_row: bool,
    },
    /// A facet has no vertex, or one.
    SmallFacet {
        /// Its number of vertices.
        size: u32,
    },
    /// A facet has two vertices, and another has more.
    SegmentBesidePolygons,
    /// A line ends too early.
    LineEnds {
        /// What was expected there: a noun.
        expected: String,
    },
    /// A cell is against the rules of the format.
    Malformed {
        /// What is wrong and what to do: a sentence without its full stop.
        why: String,
    },
    /// The file ends too early.
    Truncated {
        /// What was expected there: a clause.
        expected: String,
    },
    /// Something follows where the file should end.
    AfterEnd {
        /// What stands there.
        token: String,
        /// What ends there: a noun with its circumstances.
        end: String,
    },
    /// Packed data cannot be unpacked.
    Packed {
        /// Why.
        why: String,
    },
    /// In a feature of a collection of GeoJSON, something is wrong.
    InFeature {
        /// The number of the feature, from 0.
        feature: usize,
        /// What is wrong.
        fault: Box<Self>,
    },
    /// Reading would take more memory than a file of this size may.
    TooMuchMemory {
        /// How many bytes it may take.
        allowed: u64,
    },
}

/// What a count in a file counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Count {
    /// The vertices of the file.
    Vertices,
    /// The facets of the file.
    Facets,
    /// The edges of the file.
    Edges,
    /// The vertices of one facet.
    Corners,
    /// The elements of any other kind.
    Elements,
}

/// What is wrong with a coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum NumberFault {
    /// Not an integer, a decimal or a fraction.
    Word,
    /// Infinite, or not a number.
    NotFinite,
    /// A fraction over zero.
    ZeroDenominator,
    /// A decimal exponent beyond [`exact::MAX_EXPONENT`] in magnitude.
    ExponentTooLarge,
    /// More than [`exact::MAX_DIGITS`] digits in an integer, a decimal or a part of a fraction.
    TooManyDigits,
}

impl Fault {
    /// The error of this fault at a place.
    pub(crate) fn at(self, place: Place) -> Located {
        Located { place: Some(place), fault: self }
    }
}

/// A fault with its place: what the readers return, before the format is added.
#[derive(Debug)]
pub(crate) struct Located {
    pub(crate) place: Option<Place>,
    pub(crate) fault: Fault,
}

/// A fault of the whole file.
impl From<Fault> for Located {
    fn from(fault: Fault) -> Self {
        Self { place: None, fault }
    }
}

impl Located {
    /// The same in a feature of a collection. That there is too little memory is a fault of the file.
    pub(crate) fn in_feature(self, feature: usize) -> Self {
        match self.fault {
            Fault::TooMuchMemory { .. } => self,
            fault => Self { fault: Fault::InFeature { feature, fault: Box::new(fault) }, ..self },
        }
    }

    pub(crate) fn of_format(self, format: Format) -> ReadError {
        ReadError { format: Some(format), part: None, place: self.place, fault: self.fault }
    }
}

/// Adds the place to a fault.
pub(crate) trait At<T> {
    fn at(self, place: Place) -> Result<T, Located>;
    fn at_line(self, line: u32) -> Result<T, Located>;
    fn at_byte(self, byte: u64) -> Result<T, Located>;
}

impl<T> At<T> for Result<T, Fault> {
    #[inline]
    fn at(self, place: Place) -> Result<T, Located> {
        self.map_err(|fault| fault.at(place))
    }

    #[inline]
    fn at_line(self, line: u32) -> Result<T, Located> {
        self.at(Place::Line(line))
    }

    #[inline]
    fn at_byte(self, byte: u64) -> Result<T, Located> {
        self.at(Place::Byte(byte))
    }
}

impl ReadError {
    /// What is wrong and what to do, without the place.
    pub fn sentence(&self) -> String {
        self.fault.to_string()
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(part) = &self.part {
            write!(f, "{part}: ")?;
        }
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        write!(f, "{}", self.fault)
    }
}

impl std::error::Error for ReadError {}

fn counted(count: u32, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("the file is empty; a model was expected"),
            Self::UnknownFormat { token } => write!(
                f,
                "no known format: the file begins with `{token}`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read"
            ),
            Self::Unsupported { what, instead } => write!(f, "{what} cannot be read; {instead}"),
            Self::Syntax { found, expected } => {
                write!(f, "`{found}` where {expected} was expected; correct it")
            }
            Self::BadCount { token, of } => {
                write!(f, "`{token}` is no number of {of}; write a whole number, 0 or larger")
            }
            Self::CountTooLarge { token, of } => {
                write!(f, "{token} {of} are too many; a mesh has at most {}", u32::MAX - 1)
            }
            Self::NoVertices => f.write_str("the mesh is empty: it has no vertex; at least one is needed"),
            Self::BadNumber { token, fault } => write!(f, "{}", WrongNumber { token, fault: *fault }),
            Self::BadIndex { token, first } => {
                write!(f, "`{token}` is no vertex index; write whole numbers counted from {first}")
            }
            Self::IndexOutOfRange { index, vertices: 0, .. } => {
                write!(f, "vertex index {index}, but there is no vertex; write the vertices first")
            }
            Self::IndexOutOfRange { index, vertices, first } => write!(
                f,
                "vertex index {index}, but there {} {}; indices run from {first} to {}",
                if *vertices == 1 { "is" } else { "are" },
                counted(*vertices, "vertex", "vertices"),
                u64::from(*vertices) + u64::from(*first) - 1
            ),
            Self::RepeatedVertex { vertex, in_a_row } => write!(
                f,
                "the facet has vertex {vertex} twice{}; name every vertex of a facet once",
                if *in_a_row { " in a row" } else { "" }
            ),
            Self::SmallFacet { size } => write!(
                f,
                "a facet of {}; a facet needs three, and a segment two",
                counted(*size, "vertex", "vertices")
            ),
            Self::SegmentBesidePolygons => {
                f.write_str("a facet of two vertices beside polygons; remove it, or give it a third vertex")
            }
            Self::LineEnds { expected } => {
                write!(f, "the line ends where {expected} was expected; complete it")
            }
            Self::Malformed { why } => f.write_str(why),
            Self::Truncated { expected } => {
                write!(f, "the file ends where {expected}; complete it")
            }
            Self::AfterEnd { token, end } => {
                write!(f, "`{token}` after the end of {end}; remove it")
            }
            Self::InFeature { feature, fault } => write!(f, "{fault} (in feature {feature}, counted from 0)"),
            Self::Packed { why } => write!(f, "the packed data is damaged: {why}; pack it again"),
            Self::TooMuchMemory { allowed } => write!(
                f,
                "reading it would take more than {} MiB, too much for a file of this size; split it, unpack it, or \
                 write it with fewer digits",
                allowed >> 20
            ),
        }
    }
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertices => "vertices",
            Self::Facets => "facets",
            Self::Edges => "edges",
            Self::Corners => "vertices of a facet",
            Self::Elements => "elements",
        })
    }
}

struct WrongNumber<'a> {
    token: &'a str,
    fault: NumberFault,
}

impl fmt::Display for WrongNumber<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let token = self.token;
        match self.fault {
            NumberFault::Word => {
                write!(f, "`{token}` is no number; write an integer, a decimal or a fraction p/q")
            }
            NumberFault::NotFinite => write!(f, "`{token}` is not finite; write a finite number"),
            NumberFault::ZeroDenominator => {
                write!(f, "`{token}` has the denominator zero; write a fraction p/q with q not zero")
            }
            NumberFault::ExponentTooLarge => write!(
                f,
                "the exponent of `{token}` is too large in magnitude; the largest allowed is {}",
                exact::MAX_EXPONENT
            ),
            NumberFault::TooManyDigits => write!(
                f,
                "`{token}` has too many digits; an integer, a decimal and each part of a fraction may have {}",
                exact::MAX_DIGITS
            ),
        }
    }
}
