//! Where in a file something stands.

use std::fmt;

/// A place in a file: a line of text, or an offset into bytes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Place {
    /// A line, counted from 1.
    Line(u32),
    /// An offset, counted from 0.
    Byte(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// The places of the vertices or of the facets of a file, in order.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum PlaceList {
    /// Lines of a text.
    Lines(Vec<u32>),
    /// Offsets into bytes.
    Bytes(Vec<u64>),
    /// Records of one size: the first begins at `first`, each `step` bytes after the one before it.
    Stride {
        /// The offset of the first record.
        first: u64,
        /// The size of a record.
        step: u64,
        /// How many there are.
        count: usize,
    },
}

impl PlaceList {
    /// The place of one of them; `None` if there are not so many.
    pub fn get(&self, index: usize) -> Option<Place> {
        match self {
            Self::Lines(lines) => lines.get(index).copied().map(Place::Line),
            Self::Bytes(bytes) => bytes.get(index).copied().map(Place::Byte),
            Self::Stride { first, step, count } => {
                (index < *count).then(|| Place::Byte(first + step * index as u64))
            }
        }
    }

    /// An empty list of lines.
    pub(crate) fn lines() -> Self {
        Self::Lines(Vec::new())
    }

    /// An empty list of offsets.
    pub(crate) fn bytes() -> Self {
        Self::Bytes(Vec::new())
    }

    /// An empty list of records of one size.
    pub(crate) fn stride(first: u64, step: u64) -> Self {
        Self::Stride { first, step, count: 0 }
    }

    /// How many bytes a place takes.
    #[inline]
    pub(crate) fn bytes_each(&self) -> u64 {
        match self {
            Self::Lines(_) => 4,
            Self::Bytes(_) => 8,
            Self::Stride { .. } => 0,
        }
    }

    /// Appends a place of the kind that the list has.
    #[inline]
    pub(crate) fn push(&mut self, place: Place) {
        match (self, place) {
            (Self::Lines(lines), Place::Line(line)) => lines.push(line),
            (Self::Bytes(bytes), Place::Byte(byte)) => bytes.push(byte),
            (Self::Stride { count, .. }, Place::Byte(_)) => *count += 1,
            _ => unreachable!("a reader gives places of one kind"),
        }
    }
}

/// Where the cells of a model stand in its file.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Places {
    /// The file within an archive that has them.
    pub part: Option<String>,
    /// The vertices, in their order in the model.
    pub vertices: PlaceList,
    /// The facets, in their order in the model.
    pub facets: PlaceList,
}
