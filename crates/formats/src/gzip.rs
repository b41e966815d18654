//! Gzip around a file of any format, and how packed data is unpacked within a budget.

use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use flate2::{Compression, Crc, Decompress, FlushDecompress, GzBuilder, Status};
use std::io::{self, Read, Write};

/// The first two bytes of a member.
const MAGIC: &[u8] = b"\x1F\x8B";
/// The system that a file says it was packed on: unknown, so that all systems write the same.
const UNKNOWN_SYSTEM: u8 = 255;
/// What each member after the first is charged: to begin one takes time, and one without data has 20 bytes.
const MEMBER: u64 = 2048;
/// The least that is allocated at a time.
const STEP: usize = 1 << 16;

/// Unpacks a file: all its members, one after the other. What it unpacks to is charged to the budget.
///
/// Zeros behind the last member are the padding of tapes, and ignored.
///
/// # Errors
/// Data that is damaged, at the byte where its member begins; or so much that no mesh of it would fit, or so many
/// members.
pub(crate) fn unpack(bytes: &[u8], budget: &mut Budget) -> Result<Vec<u8>, Located> {
    let mut unpacked = Unpacked::within(budget);
    let mut members =
        Members { rest: bytes, inflater: Decompress::new(false), crc: Crc::new(), ended: false };
    while members.rest.len() == bytes.len() || members.rest.iter().any(|&byte| byte != 0) {
        let start = (bytes.len() - members.rest.len()) as u64;
        if start > 0 && !members.rest.starts_with(MAGIC) {
            let why = "something that is not gzip follows the end".into();
            return Err(Fault::Packed { why }).at_byte(start);
        }
        if start > 0 {
            unpacked.budget.charge(MEMBER).at_byte(start)?;
        }
        members.begin().map_err(|error| Fault::Packed { why: plain(&error) }).at_byte(start)?;
        unpacked.fill(&mut members).at_byte(start)?;
    }
    Ok(unpacked.finish()?)
}

/// The members of a file, of which one at a time is read. All use the same decoder: there may be a great many.
struct Members<'a> {
    rest: &'a [u8],
    inflater: Decompress,
    crc: Crc,
    /// Whether the data of the member is read to its end.
    ended: bool,
}

impl Members<'_> {
    /// Reads the header of the next member: magic, method, flags, six bytes of time and system, and what the flags
    /// announce.
    fn begin(&mut self) -> io::Result<()> {
        const DEFLATE: u8 = 8;
        let [has_crc, has_extra, has_name, has_comment, reserved] = [2, 4, 8, 16, 0xE0];
        let whole = self.rest;
        let fixed: [u8; 10] = self.take()?;
        let flags = fixed[3];
        if !fixed.starts_with(MAGIC) || fixed[2] != DEFLATE || flags & reserved != 0 {
            return Err(wrong("header"));
        }
        if flags & has_extra != 0 {
            let length = usize::from(u16::from_le_bytes(self.take()?));
            self.rest = self.rest.get(length..).ok_or(io::ErrorKind::UnexpectedEof)?;
        }
        for text in [has_name, has_comment] {
            if flags & text != 0 {
                let end = self.rest.iter().position(|&byte| byte == 0);
                self.rest = &self.rest[end.ok_or(io::ErrorKind::UnexpectedEof)? + 1..];
            }
        }
        self.crc.reset();
        if flags & has_crc != 0 {
            self.crc.update(&whole[..whole.len() - self.rest.len()]);
            if u32::from(u16::from_le_bytes(self.take()?)) != self.crc.sum() & 0xFFFF {
                return Err(wrong("header"));
            }
            self.crc.reset();
        }
        self.inflater.reset(false);
        self.ended = false;
        Ok(())
    }

    fn take<const N: usize>(&mut self) -> io::Result<[u8; N]> {
        let (taken, rest) = self.rest.split_first_chunk().ok_or(io::ErrorKind::UnexpectedEof)?;
        self.rest = rest;
        Ok(*taken)
    }

    /// The checksum and the length of what was packed.
    fn check_end(&mut self) -> io::Result<()> {
        let [sum, length] = [self.take()?, self.take()?].map(u32::from_le_bytes);
        if sum == self.crc.sum() && length == self.crc.amount() { Ok(()) } else { Err(wrong("checksum")) }
    }
}

/// Gives the data of the member that has begun, and reads its end with it.
impl Read for Members<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while !self.ended && !buffer.is_empty() {
            let (taken, given) = (self.inflater.total_in(), self.inflater.total_out());
            let status = self.inflater.decompress(self.rest, buffer, FlushDecompress::None)?;
            let taken = (self.inflater.total_in() - taken) as usize;
            let given = (self.inflater.total_out() - given) as usize;
            self.rest = &self.rest[taken..];
            self.crc.update(&buffer[..given]);
            if status == Status::StreamEnd {
                self.ended = true;
                self.check_end()?;
            } else if taken == 0 && given == 0 {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            if given > 0 {
                return Ok(given);
            }
        }
        Ok(0)
    }
}

fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}

/// Packs a file with gzip: the same bytes for the same bytes.
///
/// All readers of this crate take what is packed as it is.
///
/// ```
/// use splitstar_formats::{pack_gzip, read_curves};
/// let packed = pack_gzip(b"segment 0 0 1 1\n");
/// assert_eq!(read_curves(&packed, None)?.curves.len(), 1);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn pack(bytes: &[u8]) -> Vec<u8> {
    let header = GzBuilder::new().mtime(0).operating_system(UNKNOWN_SYSTEM);
    let mut packer = header.write(Vec::new(), Compression::default());
    packer.write_all(bytes).expect("writing to memory does not fail");
    packer.finish().expect("writing to memory does not fail")
}

/// Bytes that grow as far as half of a budget goes: the other half is for what is made of them.
pub(crate) struct Unpacked<'b> {
    /// What there is, and room behind it.
    bytes: Vec<u8>,
    filled: usize,
    limit: usize,
    budget: &'b mut Budget,
}

impl<'b> Unpacked<'b> {
    pub(crate) fn within(budget: &'b mut Budget) -> Self {
        let limit = usize::try_from(budget.left() / 2).unwrap_or(usize::MAX);
        Self { bytes: Vec::new(), filled: 0, limit, budget }
    }

    /// Appends all that a decoder gives, however much it said that would be.
    pub(crate) fn fill(&mut self, decoder: &mut impl Read) -> Result<(), Fault> {
        loop {
            if self.filled == self.limit {
                // Nothing may follow.
                return match read_some(decoder, &mut [0])? {
                    0 => Ok(()),
                    _ => Err(self.budget.exceeded()),
                };
            }
            if self.filled == self.bytes.len() {
                self.make_room();
            }
            match read_some(decoder, &mut self.bytes[self.filled..])? {
                0 => return Ok(()),
                read => self.filled += read,
            }
        }
    }

    fn make_room(&mut self) {
        if self.filled == self.bytes.capacity() {
            // Moving takes the old and the new memory at once: at most 5/3 of half of the budget.
            let more = (self.filled / 2).max(STEP).min(self.limit - self.filled);
            self.bytes.reserve_exact(more);
        }
        // Step by step, so that memory that is never filled is never touched.
        let end = self.bytes.capacity().min(self.filled + STEP).min(self.limit);
        self.bytes.resize(end, 0);
    }

    /// The bytes, charged to the budget.
    pub(crate) fn finish(mut self) -> Result<Vec<u8>, Fault> {
        self.bytes.truncate(self.filled);
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
