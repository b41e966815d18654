//! The first line: the version and the kind.

use super::line::Lines;
use crate::base::error::{Fault, Located};
use crate::base::scan::Scanner;

/// What a star file holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum StarKind {
    Complex,
    Arrangement,
    Gaussian,
}

impl StarKind {
    const ALL: [Self; 3] = [Self::Complex, Self::Arrangement, Self::Gaussian];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Complex => "complex",
            Self::Arrangement => "arrangement",
            Self::Gaussian => "gaussian",
        }
    }

    /// What is said of an empty file.
    fn missing(self) -> Fault {
        match self {
            Self::Arrangement => Fault::Malformed {
                why: "the file is empty; an arrangement was expected, as `splitstar arrange CURVES -o OUT.star` writes it"
                    .into(),
            },
            Self::Complex | Self::Gaussian => Fault::Empty,
        }
    }

    /// What a file of it is, with an article.
    pub(super) fn indefinite(self) -> &'static str {
        match self {
            Self::Complex => "a mesh",
            Self::Arrangement => "an arrangement",
            Self::Gaussian => "a Gaussian map",
        }
    }

    /// What is said to somebody who gives a file of this kind where another one was expected.
    fn instead_of(self, wanted: Self) -> Fault {
        let what = format!("{} (star kind `{}`) as {}", self.indefinite(), self.name(), wanted.indefinite());
        let instead = match (self, wanted) {
            (Self::Arrangement, Self::Complex) => "it has curves of a surface and no facets: give a mesh",
            (_, Self::Complex) => "give a mesh",
            (Self::Gaussian, Self::Arrangement) => {
                "it stands for a polytope: give a file that begins with `star 1 arrangement`, or curves"
            }
            (_, Self::Arrangement) => "give a file that begins with `star 1 arrangement`, or curves",
            (_, Self::Gaussian) => "give a file that begins with `star 1 gaussian`",
        };
        Fault::Unsupported { what, instead: instead.into() }
    }
}

/// Tells whether a text begins as an arrangement does.
pub(crate) fn is_arrangement(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes);
    let words = [scanner.token(), scanner.token_in_line(), scanner.token_in_line()];
    words.map(|word| word.map_or(&b""[..], |word| word.bytes)) == [&b"star"[..], b"1", b"arrangement"]
}

/// Reads the first line, which must name version 1 and one of these kinds; messages name the first of them.
pub(super) fn read_first_line(lines: &mut Lines<'_>, wanted: &[StarKind]) -> Result<StarKind, Located> {
    let first = wanted[0];
    let name = first.name();
    let (word, mut line) = lines.next_record().ok_or_else(|| first.missing())?;
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
        Some(found) if wanted.contains(&found) => line.end().map(|()| found),
        Some(found) => Err(kind.fault(|_| found.instead_of(first))),
        None => Err(kind.fault(|kind| Fault::Unsupported {
            what: format!("star kind `{kind}`"),
            instead: "this program knows the kinds `complex`, `arrangement` and `gaussian` only: update it, or correct \
                      the kind"
                .into(),
        })),
    }
}
