//! Files of placements: how a model is turned and moved, one placement a line.

use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, ReadError};
use crate::base::maker::wide_bytes;
use crate::base::number::{Number, point};
use crate::base::scan::{Scanner, Token};
use crate::base::words::read_coordinate;
use crate::curves::{of_no_format, read_packed, unsupported};
use exact::{Point3, Quaternion};

/// One placement of a file: turned about the origin first, then moved.
#[derive(Clone, Debug, PartialEq)]
pub struct FilePlacement {
    /// Where the origin comes to.
    pub translation: Point3,
    /// The rotation, if the line has one.
    pub rotation: Option<Box<Quaternion>>,
}

/// What a line may be.
const TRANSLATION: &str = "a translation (`x y z`, or `x y z w x y z` with a quaternion)";
const QUATERNION: &str = "a quaternion behind the translation (`x y z w x y z`)";

/// Reads a file of placements: one a line, as a translation `x y z`, or as a translation with a rotation, `x y z w x y z`, where `w x y z`
/// is a quaternion of any length.
///
/// Numbers are integers, decimals or fractions, and count exactly as written. `#` starts a comment, and blank lines are passed over. Gzip
/// may be around the file, whose name is not looked at.
///
/// # Errors
/// The first thing wrong with the file, with its line: another number of numbers, words that are none, a quaternion that is zero. A file
/// that would take more than 64 times its length, as it is stored, and 64 MiB, is refused.
///
/// # Complexity
/// O(n) for n bytes, unpacked, as long as numbers have few digits.
///
/// ```
/// use exact::Point3;
/// use splitstar_formats::read_placements;
///
/// let placements = read_placements(b"# a step, and a quarter of a turn\n0.5 0 0\n1 0 0  1 0 0 1\n", None)?;
/// assert_eq!(placements.len(), 2);
/// assert_eq!(placements[1].translation, Point3::from_i64([1, 0, 0]));
/// assert!(placements[0].rotation.is_none() && placements[1].rotation.is_some());
///
/// let error = read_placements(b"0 0\n", None).expect_err("a number is missing");
/// assert!(error.to_string().starts_with("line 1: the line ends where a translation"), "{error}");
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_placements(bytes: &[u8], file_name: Option<&str>) -> Result<Vec<FilePlacement>, ReadError> {
    read_packed(bytes, file_name, read_unpacked).map_err(of_no_format)
}

fn read_unpacked(
    bytes: &[u8],
    _file_name: Option<&str>,
    budget: &mut Budget,
) -> Result<Vec<FilePlacement>, Located> {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(unsupported("a text in UTF-16", "write it in UTF-8").into());
    }
    let mut scanner = Scanner::new(bytes);
    let mut placements = Vec::new();
    while let Some(first) = scanner.token() {
        placements.push(placement(first, &mut scanner, budget)?);
    }
    Ok(placements)
}

/// The placement of a line, from its first word on.
fn placement<'a>(
    first: Token<'a>,
    scanner: &mut Scanner<'a>,
    budget: &mut Budget,
) -> Result<FilePlacement, Located> {
    if !matches!(first.bytes.first(), Some(b'0'..=b'9' | b'+' | b'-' | b'.')) {
        return Err(first.unexpected(TRANSLATION));
    }
    let line = first.line;
    let next = |scanner: &mut Scanner<'a>, expected: &str| {
        let token = scanner.token_in_line();
        read_coordinate(token.ok_or_else(|| Fault::LineEnds { expected: expected.into() }).at_line(line)?)
    };
    let (x, y) = (read_coordinate(first)?, next(scanner, TRANSLATION)?);
    let translation = point([x, y, next(scanner, TRANSLATION)?]);
    let mut rotation = None;
    if let Some(w) = scanner.token_in_line() {
        let mut components =
            [read_coordinate(w)?, Number::Small(0, 1), Number::Small(0, 1), Number::Small(0, 1)];
        for component in &mut components[1..] {
            *component = next(scanner, QUATERNION)?;
        }
        if let Some(more) = scanner.token_in_line() {
            return Err(more.unexpected("the end of the line"));
        }
        let quaternion = Quaternion::from_rationals(&components.map(Number::into_rational));
        let why = "the quaternion is zero; 1 0 0 0 does not rotate";
        let quaternion = quaternion.ok_or_else(|| Fault::Malformed { why: why.into() }).at_line(line)?;
        rotation = Some(Box::new(quaternion));
    }
    budget.charge(memory(&translation, rotation.as_deref())).at_line(line)?;
    Ok(FilePlacement { translation, rotation })
}

/// What a placement takes, in a list that grows and has room for three times as many.
fn memory(translation: &Point3, rotation: Option<&Quaternion>) -> u64 {
    const ENTRY: u64 = 3 * size_of::<FilePlacement>() as u64;
    let wide = if translation.as_narrow().is_some() { 0 } else { wide_bytes(translation) };
    let turned = rotation.map_or(0, |q| size_of::<Quaternion>() as u64 + 16 + u64::from(q.bits()));
    ENTRY + wide + turned
}
