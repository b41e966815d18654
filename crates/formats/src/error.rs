//! What can be wrong with a mesh file.

use std::fmt;

/// Why a file is not a mesh. Every message says what is wrong and what to do.
///
/// [`Display`](fmt::Display) begins with the line; [`sentence`](Self::sentence) leaves it out, for
/// callers that put the file's name and [`line`](Self::line) before it.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ReadError {
    /// There is nothing in the file but blank lines and comments.
    Empty,
    /// The file begins with something that is no format of ours.
    UnknownFormat {
        /// The line of the first token.
        line: u32,
        /// The first token.
        token: String,
    },
    /// The format is known, and is not one that can be read: binary, or not of dimension 3.
    Unsupported {
        /// The line of the keyword.
        line: u32,
        /// The name of the format.
        format: String,
    },
    /// A count is not a whole number, or is negative.
    BadCount {
        /// The line of the count.
        line: u32,
        /// What stands there.
        token: String,
        /// What is counted.
        of: Count,
    },
    /// A count is 2^32 - 1 or more.
    CountTooLarge {
        /// The line of the count.
        line: u32,
        /// What stands there.
        token: String,
        /// What is counted.
        of: Count,
    },
    /// Something follows the three counts in their line.
    AfterCounts {
        /// The line of the counts.
        line: u32,
        /// The fourth token.
        token: String,
    },
    /// The counts say that there is no vertex.
    NoVertices {
        /// The line of the counts.
        line: u32,
    },
    /// A coordinate is not a number.
    BadNumber {
        /// The line of the coordinate.
        line: u32,
        /// What stands there.
        token: String,
        /// What is wrong with it.
        fault: NumberFault,
    },
    /// A vertex index in a facet is not a whole number.
    BadIndex {
        /// The line of the index.
        line: u32,
        /// What stands there.
        token: String,
    },
    /// A facet has a vertex index that is negative, or not below the number of vertices.
    IndexOutOfRange {
        /// The line of the index.
        line: u32,
        /// The index as written.
        index: String,
        /// The number of vertices of the file.
        vertices: u32,
    },
    /// A facet passes through a vertex twice.
    RepeatedVertex {
        /// The line of the second mention.
        line: u32,
        /// The index of the vertex.
        vertex: u32,
        /// Whether the two mentions follow each other in the cycle.
        in_a_row: bool,
    },
    /// A facet has no vertex, or one.
    SmallFacet {
        /// The line of the facet.
        line: u32,
        /// Its number of vertices.
        size: u32,
    },
    /// A facet has two vertices, and another has more.
    SegmentBesidePolygons {
        /// The line of the facet with two vertices.
        line: u32,
    },
    /// The file ends before all records that its counts promise.
    Truncated {
        /// The last line.
        line: u32,
        /// What was expected there.
        expected: Record,
    },
    /// Something follows the last facet (or the last vertex, if there is no facet).
    AfterEnd {
        /// The line of the first token too many.
        line: u32,
        /// The token.
        token: String,
        /// The number of facets that the counts promise.
        facets: u32,
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

/// The record that was expected where a file ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Record {
    /// The line of counts, or a part of it.
    Counts,
    /// A vertex.
    Vertex {
        /// How many complete vertices there are.
        read: u32,
        /// How many the counts promise.
        promised: u32,
    },
    /// A facet.
    Facet {
        /// How many complete facets there are.
        read: u32,
        /// How many the counts promise.
        promised: u32,
    },
}

impl ReadError {
    /// The line at fault, counted from 1; `None` for an empty file.
    pub fn line(&self) -> Option<u32> {
        match self {
            Self::Empty => None,
            Self::UnknownFormat { line, .. }
            | Self::Unsupported { line, .. }
            | Self::BadCount { line, .. }
            | Self::CountTooLarge { line, .. }
            | Self::AfterCounts { line, .. }
            | Self::NoVertices { line }
            | Self::BadNumber { line, .. }
            | Self::BadIndex { line, .. }
            | Self::IndexOutOfRange { line, .. }
            | Self::RepeatedVertex { line, .. }
            | Self::SmallFacet { line, .. }
            | Self::SegmentBesidePolygons { line }
            | Self::Truncated { line, .. }
            | Self::AfterEnd { line, .. } => Some(*line),
        }
    }

    /// What is wrong and what to do, without the line.
    pub fn sentence(&self) -> String {
        match self {
            Self::Empty => "the file is empty; an OFF file was expected".into(),
            Self::UnknownFormat { token, .. } => {
                format!(
                    "no known format: the file begins with `{token}`; an OFF file begins with the word OFF"
                )
            }
            Self::Unsupported { format, .. } => {
                format!(
                    "{format} cannot be read; write the mesh as ASCII OFF with three coordinates a vertex"
                )
            }
            Self::BadCount { token, of, .. } => {
                format!("`{token}` is no number of {of}; write a whole number, 0 or larger")
            }
            Self::CountTooLarge { token, of, .. } => {
                format!("{token} {of} are too many; a mesh has at most {}", u32::MAX - 1)
            }
            Self::AfterCounts { token, .. } => format!(
                "`{token}` after the three counts; write the numbers of vertices, facets and edges, \
                 and begin the vertices on a line of their own"
            ),
            Self::NoVertices { .. } => "the mesh is empty: it has no vertex; at least one is needed".into(),
            Self::BadNumber { token, fault, .. } => format!("{}", Fault { token, fault: *fault }),
            Self::BadIndex { token, .. } => {
                format!("`{token}` is no vertex index; write whole numbers counted from 0")
            }
            Self::IndexOutOfRange { index, vertices, .. } => format!(
                "vertex index {index}, but the file has {vertices} {}; indices run from 0 to {}",
                if *vertices == 1 { "vertex" } else { "vertices" },
                vertices.saturating_sub(1)
            ),
            Self::RepeatedVertex { vertex, in_a_row, .. } => format!(
                "the facet has vertex {vertex} twice{}; name every vertex of a facet once",
                if *in_a_row { " in a row" } else { "" }
            ),
            Self::SmallFacet { size, .. } => format!(
                "a facet of {size} {}; a facet needs three, and a segment two",
                if *size == 1 { "vertex" } else { "vertices" }
            ),
            Self::SegmentBesidePolygons { .. } => {
                "a facet of two vertices beside polygons; remove it, or give it a third vertex".into()
            }
            Self::Truncated { expected, .. } => {
                format!("the file ends where {expected}; complete it, or correct the counts")
            }
            Self::AfterEnd { token, facets, .. } => format!(
                "`{token}` after the end of the mesh, whose counts promise {facets} {}; \
                 remove it, or correct the counts",
                if *facets == 1 { "facet" } else { "facets" }
            ),
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line() {
            write!(f, "line {line}: ")?;
        }
        f.write_str(&self.sentence())
    }
}

impl std::error::Error for ReadError {}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertices => "vertices",
            Self::Facets => "facets",
            Self::Edges => "edges",
            Self::Corners => "vertices of a facet",
        })
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Counts => f.write_str("the numbers of vertices, facets and edges were expected"),
            Self::Vertex { read, promised } => {
                write!(f, "a vertex was expected, after {read} of {promised} vertices")
            }
            Self::Facet { read, promised } => {
                write!(f, "a facet was expected, after {read} of {promised} facets")
            }
        }
    }
}

struct Fault<'a> {
    token: &'a str,
    fault: NumberFault,
}

impl fmt::Display for Fault<'_> {
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
