//! Curves that carry data.

use super::forward::forward_traits;
use crate::models::polycurve::PieceTraits;
use crate::traits::{
    ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, BoundedTraits, ClosedBottomTopTraits,
    ClosedLeftRightTraits, ContractedBottomTopTraits, ContractedLeftRightTraits, CurveEnd, DirectionalTraits,
    IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Intersection, LandmarkTraits, Location, Meeting,
    NearBottomTopTraits, NearLeftRightTraits, OpenBottomTopTraits, OpenLeftRightTraits, Piece,
    UMonotoneTraits, Window,
};
use std::cmp::Ordering;
use std::fmt::Debug;
use std::marker::PhantomData;

/// A curve, u-monotone or general, and what it carries.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct WithData<C, D> {
    /// The curve.
    pub curve: C,
    /// What it carries.
    pub data: D,
}

impl<C, D> WithData<C, D> {
    /// Puts data on a curve.
    pub fn new(curve: C, data: D) -> Self {
        Self { curve, data }
    }
}

/// What becomes of data where two curves become one.
pub trait DataRule<D>: Send + Sync {
    /// The data of the common piece of two curves.
    fn overlap(&self, a: &D, b: &D) -> D;

    /// The data of a curve that two are merged to; `None` if they must not be merged.
    fn merge(&self, a: &D, b: &D) -> Option<D>;
}

/// A common piece takes the data of the first curve; only curves of equal data are merged.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct FirstData;

impl<D: Clone + PartialEq> DataRule<D> for FirstData {
    fn overlap(&self, a: &D, _: &D) -> D {
        a.clone()
    }

    fn merge(&self, a: &D, b: &D) -> Option<D> {
        (a == b).then(|| a.clone())
    }
}

/// A rule made of two functions.
#[derive(Clone, Copy, Debug)]
pub struct RuleOf<O, M> {
    /// Gives the data of a common piece, from those of both curves.
    pub overlap: O,
    /// Gives the data of a merged curve, or `None` if the two must stay apart.
    pub merge: M,
}

impl<D, O, M> DataRule<D> for RuleOf<O, M>
where
    O: Fn(&D, &D) -> D + Send + Sync,
    M: Fn(&D, &D) -> Option<D> + Send + Sync,
{
    fn overlap(&self, a: &D, b: &D) -> D {
        (self.overlap)(a, b)
    }

    fn merge(&self, a: &D, b: &D) -> Option<D> {
        (self.merge)(a, b)
    }
}

/// The traits of any model, for curves that carry data.
///
/// Laws:
/// 1. Whatever is cut from a curve carries its data: u-monotone pieces, both halves, parts, the opposite curve.
/// 2. A common piece and a merged curve carry what the [`DataRule`] says.
/// 3. Predicates do not look at data.
///
/// ```
/// use splitstar_arrangement::traits::UMonotoneTraits;
/// use splitstar_arrangement::wrappers::{CurveDataTraits, WithData};
///
/// fn halves<G: UMonotoneTraits>(traits: G, curve: G::UMonotoneCurve, p: &G::Point) {
///     let traits = CurveDataTraits::new(traits);
///     let [lower, upper] = traits.split(&WithData::new(curve, "river"), p);
///     assert_eq!([lower.data, upper.data], ["river", "river"]);
/// }
/// ```
#[derive(Debug, Default)]
pub struct CurveDataTraits<G, D, R = FirstData> {
    traits: G,
    rule: R,
    data: PhantomData<fn(&D) -> D>,
}

impl<G: Clone, D, R: Clone> Clone for CurveDataTraits<G, D, R> {
    fn clone(&self) -> Self {
        Self::with_rule(self.traits.clone(), self.rule.clone())
    }
}

impl<G: Copy, D, R: Copy> Copy for CurveDataTraits<G, D, R> {}

impl<G, D: Clone + PartialEq> CurveDataTraits<G, D> {
    /// Wraps the traits of a model. A common piece takes the data of the first curve; only curves of equal data are merged.
    pub fn new(traits: G) -> Self {
        Self::with_rule(traits, FirstData)
    }
}

impl<G, D, R> CurveDataTraits<G, D, R> {
    /// Wraps the traits of a model, with a rule for what becomes of data where two curves become one.
    pub fn with_rule(traits: G, rule: R) -> Self {
        Self { traits, rule, data: PhantomData }
    }

    /// The traits of the model.
    pub fn inner(&self) -> &G {
        &self.traits
    }

    /// The rule.
    pub fn rule(&self) -> &R {
        &self.rule
    }
}

macro_rules! bare {
    ($self:ident, $method:ident, $name:ident($($kind:ident $argument:ident),*) appends $out:ident) => {
        $self.traits.$name($(bare_argument!($kind $argument),)* $out)
    };
    ($self:ident, $method:ident, $name:ident($($kind:ident $argument:ident),*)) => {
        $self.traits.$name($(bare_argument!($kind $argument)),*)
    };
}

macro_rules! bare_argument {
    (curve $argument:ident) => {
        &$argument.curve
    };
    (end $argument:ident) => {
        (&$argument.0.curve, $argument.1)
    };
    (plain $argument:ident) => {
        $argument
    };
}

forward_traits!(
    [D: Clone + Debug + Send + Sync, R: DataRule<D>] CurveDataTraits<G, D, R>,
    WithData<G::UMonotoneCurve, D>,
    bare,
    false
);

impl<G, D, R> UMonotoneTraits for CurveDataTraits<G, D, R>
where
    G: UMonotoneTraits,
    D: Clone + Debug + Send + Sync,
    R: DataRule<D>,
{
    fn intersect(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        out: &mut Vec<Intersection<Self::Point, Self::UMonotoneCurve>>,
    ) {
        let mut common = Vec::new();
        self.traits.intersect(&a.curve, &b.curve, &mut common);
        out.extend(common.into_iter().map(|intersection| match intersection {
            Intersection::Point(point, multiplicity) => Intersection::Point(point, multiplicity),
            Intersection::Overlap(curve) => {
                Intersection::Overlap(WithData { curve, data: self.rule.overlap(&a.data, &b.data) })
            }
        }));
    }

    fn split(&self, curve: &Self::UMonotoneCurve, p: &Self::Point) -> [Self::UMonotoneCurve; 2] {
        self.traits.split(&curve.curve, p).map(|half| WithData { curve: half, data: curve.data.clone() })
    }

    fn merge(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> Option<Self::UMonotoneCurve> {
        let data = self.rule.merge(&a.data, &b.data)?;
        let curve = self.traits.merge(&a.curve, &b.curve)?;
        Some(WithData { curve, data })
    }

    fn is_mergeable(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> bool {
        self.traits.is_mergeable(&a.curve, &b.curve) && self.rule.merge(&a.data, &b.data).is_some()
    }

    #[inline]
    fn next_meeting(
        &self,
        below: &Self::UMonotoneCurve,
        above: &Self::UMonotoneCurve,
        window: Window<'_, Self::Point>,
    ) -> Meeting<Self::Point> {
        self.traits.next_meeting(&below.curve, &above.curve, window)
    }

    #[inline]
    fn end_of_overlap(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: Option<&Self::Point>,
    ) -> Option<Self::Point> {
        self.traits.end_of_overlap(&a.curve, &b.curve, p)
    }

    fn trim(
        &self,
        curve: &Self::UMonotoneCurve,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
    ) -> Self::UMonotoneCurve {
        WithData { curve: self.traits.trim(&curve.curve, min, max), data: curve.data.clone() }
    }
}

impl<G, D, R> ArrangementTraits for CurveDataTraits<G, D, R>
where
    G: ArrangementTraits,
    D: Clone + Debug + Send + Sync,
    R: DataRule<D>,
{
    type Curve = WithData<G::Curve, D>;

    fn make_u_monotone(&self, curve: &Self::Curve, out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>) {
        let mut pieces = Vec::new();
        self.traits.make_u_monotone(&curve.curve, &mut pieces);
        out.extend(pieces.into_iter().map(|piece| match piece {
            Piece::Curve { curve: bare, is_artificial } => {
                Piece::Curve { curve: WithData { curve: bare, data: curve.data.clone() }, is_artificial }
            }
            Piece::Point(point) => Piece::Point(point),
        }));
    }
}

impl<G, D, R> DirectionalTraits for CurveDataTraits<G, D, R>
where
    G: DirectionalTraits,
    D: Clone + Debug + Send + Sync,
    R: DataRule<D>,
{
    fn is_directed_right(&self, curve: &Self::UMonotoneCurve) -> bool {
        self.traits.is_directed_right(&curve.curve)
    }

    fn opposite(&self, curve: &Self::UMonotoneCurve) -> Self::UMonotoneCurve {
        WithData { curve: self.traits.opposite(&curve.curve), data: curve.data.clone() }
    }

    fn source<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        self.traits.source(&curve.curve)
    }

    fn target<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        self.traits.target(&curve.curve)
    }
}
