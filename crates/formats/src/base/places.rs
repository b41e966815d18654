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

    /// Appends a place of the kind that the list has. Records of one size become offsets when one is not where the
    /// next should be; a reader that skips records charges for them.
    #[inline]
    pub(crate) fn push(&mut self, place: Place) {
        match (self, place) {
            (Self::Lines(lines), Place::Line(line)) => lines.push(line),
            (Self::Bytes(bytes), Place::Byte(byte)) => bytes.push(byte),
            (Self::Stride { first, step, count }, Place::Byte(byte))
                if byte == *first + *step * *count as u64 =>
            {
                *count += 1;
            }
            (list @ Self::Stride { .. }, Place::Byte(byte)) => list.push_beside(byte),
            _ => unreachable!("a reader gives places of one kind"),
        }
    }

    #[cold]
    fn push_beside(&mut self, byte: u64) {
        if let Self::Stride { first, step, count } = *self {
            let mut bytes: Vec<u64> = (0..count as u64).map(|index| first + step * index).collect();
            bytes.push(byte);
            *self = Self::Bytes(bytes);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_of_one_size_take_no_room_until_one_is_missing() {
        let mut places = PlaceList::stride(84, 50);
        for byte in [84, 134, 184] {
            places.push(Place::Byte(byte));
        }
        assert_eq!(places, PlaceList::Stride { first: 84, step: 50, count: 3 });
        for byte in [284, 334] {
            places.push(Place::Byte(byte));
        }
        assert_eq!(places, PlaceList::Bytes(vec![84, 134, 184, 284, 334]));
        assert_eq!(places.get(4), Some(Place::Byte(334)));
        assert_eq!(places.get(5), None);
    }
}
