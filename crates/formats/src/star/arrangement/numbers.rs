//! Numbers that records declare, ascending, and the lines of these records.

use crate::base::error::Located;
use crate::base::scan::Token;
use crate::base::words::parse_u32;

/// The records of one kind.
#[derive(Debug, Default)]
pub(super) struct Numbers {
    ids: Vec<u32>,
    lines: Vec<u32>,
}

/// What a number takes: both lists may grow to twice their size.
pub(super) const OF_NUMBER: u64 = 2 * (4 + 4);

impl Numbers {
    /// Declares the number that a word says, `of` one of these records.
    pub(super) fn declare(&mut self, token: Token<'_>, of: &str) -> Result<(), Located> {
        // Halfedges have numbers below 2^31, two for each edge.
        const LEAST_NOT: u32 = 1 << 30;
        let id = parse_u32(token.bytes).filter(|&id| id < LEAST_NOT);
        let id =
            id.ok_or_else(|| token.unexpected(&format!("the number of the {of}, below {LEAST_NOT},")))?;
        if let Some(&last) = self.ids.last().filter(|&&last| id <= last) {
            return Err(token.unexpected(&format!("a number above {last}, the one before,")));
        }
        self.ids.push(id);
        self.lines.push(token.line);
        Ok(())
    }

    /// The index of the record with the number that digits say.
    pub(super) fn find(&self, digits: &[u8]) -> Option<u32> {
        let id = parse_u32(digits)?;
        // Numbers that begin with 0 and leave none out are indices.
        if self.ids.get(id as usize) == Some(&id) {
            return Some(id);
        }
        self.ids.binary_search(&id).ok().map(|index| index as u32)
    }

    /// All numbers, in the order of the records.
    pub(super) fn into_ids(self) -> Vec<u32> {
        self.ids
    }

    /// How many records there are.
    pub(super) fn len(&self) -> usize {
        self.ids.len()
    }

    /// The number of the record at an index.
    pub(super) fn id(&self, index: usize) -> u32 {
        self.ids[index]
    }

    /// The line of the record at an index.
    pub(super) fn line(&self, index: usize) -> u32 {
        self.lines[index]
    }
}
