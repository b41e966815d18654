//! The first line: the version and the kind.

use super::line::Lines;
use crate::base::error::{Fault, Located};
use crate::base::scan::Scanner;

/// What a star file holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum StarKind {
    Complex,
    Arrangement,
}

impl StarKind {
    const ALL: [Self; 2] = [Self::Complex, Self::Arrangement];

    fn name(self) -> &'static str {
        match self {
            Self::Complex => "complex",
            Self::Arrangement => "arrangement",
        }
    }

    /// What is said of an empty file.
    fn missing(self) -> Fault {
        match self {
            Self::Complex => Fault::Empty,
            Self::Arrangement => Fault::Malformed {
                why: "the file is empty; an arrangement was expected, as `splitstar arrange CURVES -o OUT.star` writes it"
                    .into(),
            },
        }
    }

    /// What is said to somebody who gives a file of this kind where the other one was expected.
    fn instead_of_other(self) -> Fault {
        let (what, instead) = match self {
            Self::Complex => (
                "a mesh (star kind `complex`) as an arrangement",
                "give a file that begins with `star 1 arrangement`, or curves",
            ),
            Self::Arrangement => (
                "an arrangement (star kind `arrangement`) as a mesh",
                "it has curves of a surface and no facets: give a mesh",
            ),
        };
        Fault::Unsupported { what: what.into(), instead: instead.into() }
    }
}

/// Tells whether a text begins as an arrangement does.
pub(crate) fn is_arrangement(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes);
    let words = [scanner.token(), scanner.token_in_line(), scanner.token_in_line()];
    words.map(|word| word.map_or(&b""[..], |word| word.bytes)) == [&b"star"[..], b"1", b"arrangement"]
}

/// Reads the first line, which must name version 1 and this kind.
pub(super) fn read_first_line(lines: &mut Lines<'_>, wanted: StarKind) -> Result<(), Located> {
    let name = wanted.name();
    let (word, mut line) = lines.next_record().ok_or_else(|| wanted.missing())?;
    if word.bytes != b"star" {
        return Err(word.unexpected(&format!("the first line `star 1 {name}`")));
    }
    let version = line.expect("the version, `1`,")?;
    if version.bytes != b"1" {
        if !version.bytes.iter().all(u8::is_ascii_digit) {
            return Err(version.unexpected("the version, `1`,"));
        }
        return Err(version.fault(|version| Fault::Unsupported {
            what: format!("star version {version}"),
            instead: "this program knows version 1 only: update it".into(),
        }));
    }
    let kind = line.expect(&format!("the kind, `{name}`,"))?;
    match StarKind::ALL.into_iter().find(|known| known.name().as_bytes() == kind.bytes) {
        Some(found) if found == wanted => line.end(),
        Some(found) => Err(kind.fault(|_| found.instead_of_other())),
        None => Err(kind.fault(|kind| Fault::Unsupported {
            what: format!("star kind `{kind}`"),
            instead: "this program knows the kinds `complex` and `arrangement` only: update it, or correct the kind"
                .into(),
        })),
    }
}
