//! The limit on what reading may allocate.
//!
//! A file promises things (counts, exponents, the size of what it unpacks to) that cost it nothing. So nothing is
//! allocated by a promise, and what is allocated is charged to a budget in proportion to the file.

use super::error::Fault;

/// How much memory reading may still take.
#[derive(Debug)]
pub(crate) struct Budget {
    left: u64,
    whole: u64,
}

/// Bytes of memory for each byte of the file, as it is stored.
const PER_BYTE: u64 = 32;
/// Bytes of memory for any file, however short.
const BASE: u64 = 32 << 20;

impl Budget {
    /// For a file of so many bytes. Half of what the program may take in all: 64 times the file and 64 MiB.
    pub(crate) fn of_file(bytes: usize) -> Self {
        let whole = PER_BYTE * bytes as u64 + BASE;
        Self { left: whole, whole }
    }

    /// How many more bytes may be allocated.
    pub(crate) fn left(&self) -> u64 {
        self.left
    }

    /// Takes some bytes from the budget.
    #[inline]
    pub(crate) fn charge(&mut self, bytes: u64) -> Result<(), Fault> {
        if bytes > self.left {
            return Err(self.exceeded());
        }
        self.left -= bytes;
        Ok(())
    }

    /// What is said when it does not suffice.
    #[cold]
    pub(crate) fn exceeded(&self) -> Fault {
        Fault::TooMuchMemory { allowed: self.whole }
    }
}
