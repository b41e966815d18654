//! One placement after the other.

use crate::{Pair, RelativePlacement, Separation, Translation, Witness};
use exact::Quaternion;

/// Where Q is: turned about the origin, then moved.
///
/// ```
/// use exact::{Point3, Quaternion};
/// use polytope::convex_hull;
/// use splitstar_proximity::{Motion, Pair, Placement, Relation, Translation};
/// let corners: Vec<_> = (0..8).map(|i| Point3::from_i64([i >> 2, i >> 1 & 1, i & 1])).collect();
/// let cube = convex_hull(&corners).expect("there are points");
/// let pair = Pair::new(&cube, &cube);
/// // A quarter turn about the z-axis puts the second cube from -1 to 0 along x.
/// let quarter = Quaternion::new([1, 0, 0, 1].map(Into::into)).expect("not all are zero");
/// let translation = Translation::from_i64([0, 0, 0]);
/// let placements = [
///     Placement { rotation: None, translation: translation.clone() },
///     Placement { rotation: Some(quarter), translation },
/// ];
/// let relations: Vec<_> = Motion::of_placements(&pair, &placements).map(|found| found.relation()).collect();
/// assert_eq!(relations, [Relation::Overlapping, Relation::Touching]);
/// ```
#[derive(Clone, Debug)]
pub struct Placement {
    /// The rotation; `None` for none.
    pub rotation: Option<Quaternion>,
    /// The translation after it.
    pub translation: Translation,
}

/// The answers for a list of placements, each found from where the last one has ended.
///
/// # Complexity
/// That of one separation for each placement: of [`RelativePlacement::separation`], or of [`Pair::separation`].
///
/// ```
/// use exact::Point3;
/// use polytope::convex_hull;
/// use splitstar_proximity::{Motion, RelativePlacement, Translation};
/// let corners: Vec<_> = (0..8).map(|i| Point3::from_i64([i >> 2, i >> 1 & 1, i & 1])).collect();
/// let cube = convex_hull(&corners).expect("there are points");
/// let cubes = RelativePlacement::new(&cube, &cube);
/// let path = [-3, -1, 0, 2].map(|x| Translation::from_i64([x, 0, 0]));
/// let distances: Vec<_> =
///     Motion::of_translations(&cubes, &path).map(|found| found.squared_distance().to_string()).collect();
/// assert_eq!(distances, ["4", "0", "0", "1"]);
/// ```
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
