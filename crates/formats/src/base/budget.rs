//! The limit on memory.
//!
//! A file promises things (counts, exponents, the size of what it unpacks to) that cost it nothing. So nothing is
//! allocated by a promise, and what is allocated is charged to a budget in proportion to the file as it is stored. What
//! is done with a model after it is read takes memory too, in proportion to the model: that is reserved, so that a file
//! which could be read and not be worked on is refused by its reader.

use super::error::Fault;

/// How much memory may still be taken.
#[derive(Debug)]
pub(crate) struct Budget {
    whole: u64,
    /// What is there until the model is no longer needed.
    held: u64,
    /// What is there only while the file is read.
    text: u64,
    /// What is there only afterwards.
    reserved: u64,
}

/// Bytes of memory for each byte of the file, as it is stored.
const PER_BYTE: u64 = 62;
/// Bytes of memory for any file, however short.
const BASE: u64 = 58 << 20;

impl Budget {
    /// For a file of so many bytes: what the program may take in all, 64 times the file and 64 MiB, but for the file
    /// itself and the program.
    pub(crate) fn of_file(bytes: usize) -> Self {
        Self { whole: PER_BYTE * bytes as u64 + BASE, held: 0, text: 0, reserved: 0 }
    }

    /// How many more bytes may be charged.
    pub(crate) fn left(&self) -> u64 {
        self.whole - self.held - self.text.max(self.reserved)
    }

    /// Takes some bytes for what stays.
    #[inline]
    pub(crate) fn charge(&mut self, bytes: u64) -> Result<(), Fault> {
        if bytes > self.left() {
            return Err(self.exceeded());
        }
        self.held += bytes;
        Ok(())
    }

    /// Takes some bytes for what is unpacked, and gone when the file is read.
    pub(crate) fn charge_text(&mut self, bytes: u64) -> Result<(), Fault> {
        if bytes > self.whole - self.held - self.text {
            return Err(self.exceeded());
        }
        self.text += bytes;
        Ok(())
    }

    /// Takes some bytes for what is done with the model when it is read.
    #[inline]
    pub(crate) fn reserve(&mut self, bytes: u64) -> Result<(), Fault> {
        if bytes > self.whole - self.held - self.reserved {
            return Err(self.exceeded());
        }
        self.reserved += bytes;
        Ok(())
    }

    /// What is said when it does not suffice.
    #[cold]
    pub(crate) fn exceeded(&self) -> Fault {
        Fault::TooMuchMemory { allowed: self.whole }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_reserve_are_not_there_at_the_same_time() {
        let mut budget = Budget::of_file(0);
        assert!(budget.charge_text(BASE - 10).is_ok() && budget.reserve(BASE - 20).is_ok());
        assert_eq!(budget.left(), 10);
        assert!(budget.charge_text(11).is_err() && budget.reserve(21).is_err() && budget.charge(11).is_err());
        assert!(budget.charge(10).is_ok() && budget.charge(1).is_err());
        assert!(budget.reserve(11).is_err() && budget.reserve(10).is_ok());
    }
}
