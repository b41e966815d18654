//! The number types of PLY.

/// A type of numbers, with the byte order of the file left out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Scalar {
    Char,
    Uchar,
    Short,
    Ushort,
    Int,
    Uint,
    Float,
    Double,
}

/// The names of the types, as a message lists them.
pub(super) const NAMES: &str = "a type (char, uchar, short, ushort, int, uint, float, double)";

impl Scalar {
    /// The type of that name; both generations of names are in use.
    pub(super) fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::Char,
            b"uchar" | b"uint8" => Self::Uchar,
            b"short" | b"int16" => Self::Short,
            b"ushort" | b"uint16" => Self::Ushort,
            b"int" | b"int32" => Self::Int,
            b"uint" | b"uint32" => Self::Uint,
            b"float" | b"float32" => Self::Float,
            b"double" | b"float64" => Self::Double,
            _ => return None,
        })
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::Float | Self::Double)
    }

    /// The number of bytes.
    #[inline]
    pub(super) fn size(self) -> usize {
        match self {
            Self::Char | Self::Uchar => 1,
            Self::Short | Self::Ushort => 2,
            Self::Int | Self::Uint | Self::Float => 4,
            Self::Double => 8,
        }
    }

    /// The value of the bytes, of which there are as many as the type has. No type loses anything.
    #[inline]
    pub(super) fn float(self, bytes: &[u8], big_endian: bool) -> f64 {
        match self {
            Self::Float => f64::from(f32::from_bits(unsigned(bytes, big_endian) as u32)),
            Self::Double => f64::from_bits(unsigned(bytes, big_endian)),
            // At most 32 bits.
            _ => self.integer(bytes, big_endian) as f64,
        }
    }

    /// The value of the bytes, of which there are as many as the type has: one of the integer types.
    #[inline]
    pub(super) fn integer(self, bytes: &[u8], big_endian: bool) -> i64 {
        let bits = unsigned(bytes, big_endian);
        match self {
            Self::Char => i64::from(bits as u8 as i8),
            Self::Short => i64::from(bits as u16 as i16),
            Self::Int => i64::from(bits as u32 as i32),
            _ => bits as i64,
        }
    }
}

/// The unsigned integer of 1, 2, 4 or 8 bytes.
#[inline]
fn unsigned(bytes: &[u8], big_endian: bool) -> u64 {
    match *bytes {
        [a] => u64::from(a),
        [a, b] if big_endian => u64::from(u16::from_be_bytes([a, b])),
        [a, b] => u64::from(u16::from_le_bytes([a, b])),
        [a, b, c, d] if big_endian => u64::from(u32::from_be_bytes([a, b, c, d])),
        [a, b, c, d] => u64::from(u32::from_le_bytes([a, b, c, d])),
        [a, b, c, d, e, f, g, h] if big_endian => u64::from_be_bytes([a, b, c, d, e, f, g, h]),
        [a, b, c, d, e, f, g, h] => u64::from_le_bytes([a, b, c, d, e, f, g, h]),
        _ => unreachable!("a scalar has 1, 2, 4 or 8 bytes"),
    }
}
