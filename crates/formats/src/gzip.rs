//! Gzip around a file of any format, and how packed data is unpacked within a budget.

use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use flate2::bufread::GzDecoder;
use flate2::{Compression, GzBuilder};
use std::io::{self, Read, Write};

/// The first two bytes of a member.
const MAGIC: &[u8] = b"\x1F\x8B";
/// The system that a file says it was packed on: unknown, so that all systems write the same.
const UNKNOWN_SYSTEM: u8 = 255;
/// The least that is allocated at a time.
const STEP: usize = 1 << 16;

/// Unpacks a file: all its members, one after the other. What it unpacks to is charged to the budget.
///
/// Zeros behind the last member are the padding of tapes, and ignored.
///
/// # Errors
/// Data that is damaged, at the byte where its member begins; or so much that no mesh of it would fit.
pub(crate) fn unpack(bytes: &[u8], budget: &mut Budget) -> Result<Vec<u8>, Located> {
    let mut unpacked = Unpacked::within(budget);
    let mut rest = bytes;
    while rest.len() == bytes.len() || rest.iter().any(|&byte| byte != 0) {
        let start = (bytes.len() - rest.len()) as u64;
        if start > 0 && !rest.starts_with(MAGIC) {
            let why = "something that is not gzip follows the end".into();
            return Err(Fault::Packed { why }).at_byte(start);
        }
        let mut member = GzDecoder::new(rest);
        unpacked.fill(&mut member).at_byte(start)?;
        rest = member.into_inner();
    }
    Ok(unpacked.finish()?)
}

/// Packs a file: the same bytes for the same bytes.
pub(crate) fn pack(bytes: &[u8]) -> Vec<u8> {
    let header = GzBuilder::new().mtime(0).operating_system(UNKNOWN_SYSTEM);
    let mut packer = header.write(Vec::new(), Compression::default());
    packer.write_all(bytes).expect("writing to memory does not fail");
    packer.finish().expect("writing to memory does not fail")
}

/// Bytes that grow as far as half of a budget goes: the other half is for what is made of them.
pub(crate) struct Unpacked<'b> {
    bytes: Vec<u8>,
    limit: usize,
    budget: &'b mut Budget,
}

impl<'b> Unpacked<'b> {
    pub(crate) fn within(budget: &'b mut Budget) -> Self {
        let limit = usize::try_from(budget.left() / 2).unwrap_or(usize::MAX);
        Self { bytes: Vec::new(), limit, budget }
    }

    /// Appends all that a decoder gives, however much it said that would be.
    pub(crate) fn fill(&mut self, decoder: &mut impl Read) -> Result<(), Fault> {
        loop {
            let start = self.bytes.len();
            if start == self.limit {
                // Nothing may follow.
                return match read_some(decoder, &mut [0])? {
                    0 => Ok(()),
                    _ => Err(self.budget.exceeded()),
                };
            }
            if start == self.bytes.capacity() {
                // Moving takes the old and the new memory at once: at most 5/3 of half of the budget.
                let more = (start / 2).max(STEP).min(self.limit - start);
                self.bytes.reserve_exact(more);
            }
            let end = self.bytes.capacity().min(start + STEP).min(self.limit);
            self.bytes.resize(end, 0);
            let read = read_some(decoder, &mut self.bytes[start..]);
            self.bytes.truncate(start + *read.as_ref().unwrap_or(&0));
            if read? == 0 {
                return Ok(());
            }
        }
    }

    /// The bytes, charged to the budget.
    pub(crate) fn finish(mut self) -> Result<Vec<u8>, Fault> {
        self.bytes.shrink_to_fit();
        self.budget.charge_text(self.bytes.capacity() as u64)?;
        Ok(self.bytes)
    }
}

fn read_some(decoder: &mut impl Read, buffer: &mut [u8]) -> Result<usize, Fault> {
    loop {
        match decoder.read(buffer) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            result => return result.map_err(|error| Fault::Packed { why: plain(&error) }),
        }
    }
}

/// The sentence of a decoder in plain words.
fn plain(error: &io::Error) -> String {
    let text = error.to_string().to_ascii_lowercase();
    let why = if error.kind() == io::ErrorKind::UnexpectedEof {
        "it ends too early"
    } else if text.contains("checksum") || text.contains("crc") {
        "what it unpacks to is not what was packed, by its checksum"
    } else if text.contains("header") {
        "its header is wrong"
    } else {
        "it is not what a packer writes"
    };
    why.into()
}
