//! One placement after the other.

use crate::{Pair, RelativePlacement, Separation, Translation, Witness};
use exact::Quaternion;

/// Where Q is: turned about the origin, then moved.
#[derive(Clone, Debug)]
pub struct Placement {
    /// The rotation; `None` for none.
    pub rotation: Option<Quaternion>,
    /// The translation after it.
    pub translation: Translation,
}

/// The answers for a list of placements, each found from where the last one has ended.
#[derive(Clone, Debug)]
pub struct Motion<'a> {
    of: Of<'a>,
    last: Option<Witness>,
}

#[derive(Clone, Debug)]
enum Of<'a> {
    Sum(&'a RelativePlacement, std::slice::Iter<'a, Translation>),
    Pair(&'a Pair<'a>, std::slice::Iter<'a, Placement>),
}

impl<'a> Motion<'a> {
    /// Q is only moved.
    pub fn of_translations(of: &'a RelativePlacement, translations: &'a [Translation]) -> Self {
        Self { of: Of::Sum(of, translations.iter()), last: None }
    }

    /// Q is turned and moved.
    pub fn of_placements(of: &'a Pair<'a>, placements: &'a [Placement]) -> Self {
        Self { of: Of::Pair(of, placements.iter()), last: None }
    }
}

impl<'a> Iterator for Motion<'a> {
    type Item = Separation<'a>;

    fn next(&mut self) -> Option<Separation<'a>> {
        let separation = match &mut self.of {
            Of::Sum(of, translations) => of.separation(translations.next()?, self.last),
            Of::Pair(of, placements) => {
                let placement = placements.next()?;
                of.separation(&placement.translation, placement.rotation.as_ref(), self.last)
            }
        };
        self.last = Some(separation.witness());
        Some(separation)
    }
}
