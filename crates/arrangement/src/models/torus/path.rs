//! Straight paths in the universal cover, and how they are cut where they leave the rectangle.

use super::TorusError;
use super::segment::{Torus, TorusSegment};
use crate::traits::Piece;
use exact::planar::{Line2, Point2};
use exact::{Rational, Sign};
use std::cmp::Ordering;
use std::sync::Arc;

/// A straight path on a flat torus, made by [`TorusSegmentTraits`](super::TorusSegmentTraits). It may wind round the torus many
/// times, and lie upon itself.
#[derive(Clone, Debug)]
pub struct TorusPath {
    torus: Arc<Torus>,
    /// In the rectangle; on the left or the bottom side if the path is closed.
    start: [Rational; 2],
    displacement: [Rational; 2],
    is_closed: bool,
}

impl TorusPath {
    /// The greatest number of pieces into which a path may have to be cut.
    pub const MAX_PIECES: u32 = 1 << 20;

    pub(super) fn new(
        torus: &Arc<Torus>,
        start: &Point2,
        displacement: [Rational; 2],
        is_closed: bool,
    ) -> Result<Self, TorusError> {
        let mut rounds = Rational::ZERO;
        for (length, period) in displacement.iter().zip(&torus.period) {
            rounds += length.abs().checked_div(period).expect("a period is positive");
        }
        // One more cut along each axis than whole rounds, and one more piece than cuts.
        if rounds > Rational::from(i64::from(Self::MAX_PIECES) - 3) {
            return Err(TorusError::TooManyPieces);
        }
        let mut start = torus.reduce(start.coordinates());
        if is_closed {
            start = torus.reduce(slide_to_side(start, &displacement));
        }
        Ok(Self { torus: Arc::clone(torus), start, displacement, is_closed })
    }

    /// The point where the path begins, with coordinates below the periods.
    pub fn start(&self) -> Point2 {
        Point2::from_rationals(&self.start)
    }

    /// The vector from the beginning to the end of the path.
    pub fn displacement(&self) -> &[Rational; 2] {
        &self.displacement
    }

    /// Tells whether the path is a closed geodesic, without ends.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Appends the pieces in the order along the path.
    pub(super) fn cut(&self, out: &mut Vec<Piece<Point2, TorusSegment>>) {
        let [x, y] = &self.start;
        let [dx, dy] = &self.displacement;
        let Some(line) = Line2::from_coefficients(dy, &-dx, &(dy * x - dx * y)) else {
            out.push(Piece::Point(self.start()));
            return;
        };
        let axis = |i: usize| Axis::new(&self.start[i], &self.displacement[i], &self.torus.period[i]);
        let mut axes = [axis(0), axis(1)];
        let mut source = self.start.clone();
        let mut is_source_artificial = self.is_closed;
        loop {
            let next = axes.each_ref().map(Axis::next_wall);
            let is_last = next.iter().all(Option::is_none);
            let is_cut = match &next {
                [Some(by_u), Some(by_v)] => [by_u <= by_v, by_v <= by_u],
                [by_u, by_v] => [by_u.is_some(), by_v.is_some()],
            };
            let target = match next {
                [Some(time), _] if is_cut[0] => self.at(&time),
                [_, Some(time)] => self.at(&time),
                _ => self.at(&Rational::ONE),
            };
            let back = axes.each_ref().map(|axis| -axis.origin());
            let place = |[u, v]: &[Rational; 2]| Point2::from_rationals(&[u + &back[0], v + &back[1]]);
            let curve =
                TorusSegment::new(&self.torus, line.translated(&back), place(&source), place(&target));
            let is_target_artificial = !is_last || self.is_closed;
            let is_artificial = match source.cmp(&target) {
                Ordering::Less => [is_source_artificial, is_target_artificial],
                _ => [is_target_artificial, is_source_artificial],
            };
            out.push(Piece::Curve { curve, is_artificial });
            if is_last {
                return;
            }
            for (axis, is_cut) in axes.iter_mut().zip(is_cut) {
                axis.cell += if is_cut { axis.step } else { 0 };
            }
            source = target;
            is_source_artificial = true;
        }
    }

    /// The place in the cover at a time between 0 and 1.
    fn at(&self, time: &Rational) -> [Rational; 2] {
        [0, 1].map(|i| &self.start[i] + &self.displacement[i] * time)
    }
}

/// The point where a closed path has come from the left or the bottom side, in the cover. To begin there spares a cut.
fn slide_to_side(start: [Rational; 2], displacement: &[Rational; 2]) -> [Rational; 2] {
    let Some(axis) = (0..2).find(|&axis| !displacement[axis].is_zero()) else {
        return start;
    };
    let time = start[axis].checked_div(&displacement[axis]).expect("the path moves along this axis");
    [0, 1].map(|i| &start[i] - &displacement[i] * &time)
}

/// The walk along one axis, from one copy of the rectangle to the next.
struct Axis<'a> {
    start: &'a Rational,
    length: &'a Rational,
    period: &'a Rational,
    /// The number of the copy: the walk is between `cell` and `cell` + 1 periods.
    cell: i64,
    step: i64,
}

impl<'a> Axis<'a> {
    fn new(start: &'a Rational, length: &'a Rational, period: &'a Rational) -> Self {
        let step = length.sign() as i64;
        // A walk that goes down from a side is in the copy below.
        let cell = if step < 0 && start.is_zero() { -1 } else { 0 };
        Self { start, length, period, cell, step }
    }

    /// The coordinate where the copy begins.
    fn origin(&self) -> Rational {
        Rational::from(self.cell) * self.period
    }

    /// The time when the walk leaves the copy, if that is before its end.
    fn next_wall(&self) -> Option<Rational> {
        let wall = match self.length.sign() {
            Sign::Zero => return None,
            Sign::Positive => self.origin() + self.period,
            Sign::Negative => self.origin(),
        };
        (wall - self.start).checked_div(self.length).filter(|time| *time < Rational::ONE)
    }
}
