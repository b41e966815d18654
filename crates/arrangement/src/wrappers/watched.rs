//! Traits that let somebody watch what is asked of them.

use super::Method;
use super::forward::forward_traits;
use crate::models::polycurve::{ConnectTraits, PieceTraits};
use crate::traits::{
    ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, BoundedTraits, ClosedBottomTopTraits,
    ClosedLeftRightTraits, ContractedBottomTopTraits, ContractedLeftRightTraits, CurveEnd, DirectionalTraits,
    IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Intersection, LandmarkTraits, Location, Meeting,
    NearBottomTopTraits, NearLeftRightTraits, OpenBottomTopTraits, OpenLeftRightTraits, Piece,
    UMonotoneTraits, Window,
};
use std::cmp::Ordering;
use std::fmt::{self, Debug};

/// One who is told of every call of a method.
pub trait Watch: Send + Sync {
    /// A method was called with some arguments, and gave an answer.
    ///
    /// For methods that append to a buffer the answer is what was appended, and the buffer is no argument.
    fn watch(&self, method: Method, arguments: &[&dyn Debug], answer: &dyn Debug);
}

/// The traits of any model, watched.
///
/// A call is told of after it has been answered. What the methods of the model ask of each other is not told.
#[derive(Clone, Copy, Debug, Default)]
pub struct WatchedTraits<G, W> {
    pub(super) traits: G,
    pub(super) watch: W,
}

impl<G, W: Watch> WatchedTraits<G, W> {
    /// Wraps the traits of a model.
    pub fn with_watch(traits: G, watch: W) -> Self {
        Self { traits, watch }
    }

    /// The traits of the model.
    pub fn inner(&self) -> &G {
        &self.traits
    }

    /// The one who watches.
    pub fn watch(&self) -> &W {
        &self.watch
    }

    /// Gives back the traits of the model and the one who watched.
    pub fn into_parts(self) -> (G, W) {
        (self.traits, self.watch)
    }
}

/// An argument that has no text.
struct Untold;

impl Debug for Untold {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("_")
    }
}

macro_rules! watched {
    ($self:ident, $method:ident, $name:ident($($kind:ident $argument:ident),*) appends $out:ident) => {{
        let from = $out.len();
        $self.traits.$name($($argument,)* $out);
        $self.watch.watch(Method::$method, &[$(told!($kind $argument)),*], &&$out[from..]);
    }};
    ($self:ident, $method:ident, $name:ident($($kind:ident $argument:ident),*)) => {{
        let answer = $self.traits.$name($($argument),*);
        $self.watch.watch(Method::$method, &[$(told!($kind $argument)),*], &answer);
        answer
    }};
}

macro_rules! told {
    (untold $argument:ident) => {
        &Untold
    };
    ($kind:ident $argument:ident) => {
        &$argument
    };
}

forward_traits!([W: Watch] WatchedTraits<G, W>, G::UMonotoneCurve, watched, G::OVERLAPS_ARE_PLAIN);

impl<G: UMonotoneTraits, W: Watch> UMonotoneTraits for WatchedTraits<G, W> {
    fn intersect(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        out: &mut Vec<Intersection<Self::Point, Self::UMonotoneCurve>>,
    ) {
        watched!(self, Intersect, intersect(curve a, curve b) appends out)
    }

    fn split(&self, curve: &Self::UMonotoneCurve, p: &Self::Point) -> [Self::UMonotoneCurve; 2] {
        watched!(self, Split, split(curve curve, plain p))
    }

    fn merge(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> Option<Self::UMonotoneCurve> {
        watched!(self, Merge, merge(curve a, curve b))
    }

    fn is_mergeable(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> bool {
        watched!(self, IsMergeable, is_mergeable(curve a, curve b))
    }

    #[inline]
    fn next_meeting(
        &self,
        below: &Self::UMonotoneCurve,
        above: &Self::UMonotoneCurve,
        window: Window<'_, Self::Point>,
    ) -> Meeting<Self::Point> {
        watched!(self, NextMeeting, next_meeting(curve below, curve above, plain window))
    }

    #[inline]
    fn end_of_overlap(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: Option<&Self::Point>,
    ) -> Option<Self::Point> {
        watched!(self, EndOfOverlap, end_of_overlap(curve a, curve b, plain p))
    }

    fn trim(
        &self,
        curve: &Self::UMonotoneCurve,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
    ) -> Self::UMonotoneCurve {
        watched!(self, Trim, trim(curve curve, plain min, plain max))
    }
}

impl<G: ArrangementTraits, W: Watch> ArrangementTraits for WatchedTraits<G, W> {
    type Curve = G::Curve;

    fn make_u_monotone(&self, curve: &Self::Curve, out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>) {
        watched!(self, MakeUMonotone, make_u_monotone(untold curve) appends out)
    }
}

impl<G: DirectionalTraits, W: Watch> DirectionalTraits for WatchedTraits<G, W> {
    fn is_directed_right(&self, curve: &Self::UMonotoneCurve) -> bool {
        watched!(self, IsDirectedRight, is_directed_right(curve curve))
    }

    fn opposite(&self, curve: &Self::UMonotoneCurve) -> Self::UMonotoneCurve {
        watched!(self, Opposite, opposite(curve curve))
    }

    fn source<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        watched!(self, Source, source(curve curve))
    }

    fn target<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        watched!(self, Target, target(curve curve))
    }
}

impl<G: ConnectTraits, W: Watch> ConnectTraits for WatchedTraits<G, W> {
    fn connect(
        &self,
        source: &Self::Point,
        target: &Self::Point,
        out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>,
    ) {
        watched!(self, Connect, connect(plain source, plain target) appends out)
    }
}
