//! The verbs and their options.

use std::ffi::OsStr;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Verb {
    Sum,
    Hull,
    Info,
    Convert,
    Distance,
    Arrange,
    Locate,
    Gauss,
}

impl Verb {
    pub(crate) const ALL: [Self; 8] = [
        Self::Sum,
        Self::Hull,
        Self::Info,
        Self::Convert,
        Self::Distance,
        Self::Arrange,
        Self::Locate,
        Self::Gauss,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Sum => "sum",
            Self::Hull => "hull",
            Self::Info => "info",
            Self::Convert => "convert",
            Self::Distance => "distance",
            Self::Arrange => "arrange",
            Self::Locate => "locate",
            Self::Gauss => "gauss",
        }
    }

    /// All names, the last one after a word.
    pub(super) fn names(and: &str) -> String {
        let names = Self::ALL.map(Self::name);
        let (last, others) = names.split_last().expect("there are verbs");
        format!("{} {and} {last}", others.join(", "))
    }

    /// Whether it needs `-o`.
    pub(super) fn needs_output(self) -> bool {
        matches!(self, Self::Sum | Self::Hull | Self::Convert)
    }

    pub(super) fn options(self) -> &'static [&'static str] {
        match self {
            Self::Sum => &["output", "format", "method", "hull", "triangulate", "float", "json", "quiet"],
            Self::Hull => &["output", "format", "float", "json", "quiet"],
            Self::Info => &["json", "quiet"],
            Self::Convert => &[
                "output",
                "format",
                "unit",
                "scale",
                "reflect",
                "rotate",
                "quat",
                "translate",
                "triangulate",
                "join",
                "lossy",
                "float",
                "json",
                "quiet",
            ],
            Self::Distance => &["move-b", "quat-b", "along", "path", "hull", "triangulate", "json", "quiet"],
            Self::Arrange => {
                &["output", "format", "surface", "period", "identification", "view", "json", "quiet"]
            }
            Self::Locate => &["output", "strategy", "ray", "json", "quiet"],
            Self::Gauss => &[
                "output",
                "format",
                "cubical",
                "identification",
                "view",
                "hull",
                "triangulate",
                "json",
                "quiet",
            ],
        }
    }

    pub(super) fn from_name(name: &OsStr) -> Option<Self> {
        Self::ALL.into_iter().find(|verb| name == verb.name())
    }
}
