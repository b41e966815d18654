//! Curves as they are read, and the numbers in their records.

use super::family::Base;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::number::Number;
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::read_coordinate;
use crate::star::line::Line;
use arrangement::models::polycurve::{Chain, PieceTraits, PolycurveTraits};
use arrangement::traits::Piece;
use exact::planar::Point2;

/// Curves as long as each is one piece, and then chains.
#[derive(Debug)]
pub(super) enum List<C> {
    Single(Vec<C>),
    Chains(Vec<Chain<C>>),
}

/// What a piece takes in growing lists; it may have two points on the heap.
const fn of_piece<S: PieceTraits>() -> u64 {
    2 * (size_of::<S::UMonotoneCurve>() + size_of::<S::Point>()) as u64
}

/// What it takes in a chain, and in that of a part of it.
const fn of_chained<S: PieceTraits>() -> u64 {
    3 * (size_of::<S::UMonotoneCurve>() + size_of::<S::Point>()) as u64
}

/// What it takes to put a piece into a chain, as long as that lasts.
const fn of_putting_piece<S: PieceTraits>() -> u64 {
    4 * (size_of::<S::UMonotoneCurve>() + 2 * size_of::<S::Point>()) as u64
}

const OF_CHAIN: u64 = 64;
/// Numbers with so many digits or less take no memory of their own, in points and lines that have no more.
const SHORT: usize = 9;
/// What a digit takes of another number: in a point, in lines through it, and in copies of these.
const OF_DIGIT: u64 = 40;

/// Reads a number, and charges for its digits.
pub(super) fn read_number(token: Token<'_>, budget: &mut Budget) -> Result<Number, Located> {
    let number = read_coordinate(token)?;
    if token.bytes.len() > SHORT {
        budget.charge(OF_DIGIT * token.bytes.len() as u64).at_line(token.line)?;
        // An exponent has more digits than it shows.
        if let Number::Large(number) = &number {
            let bits = number.numerator().bit_len() + number.denominator().bit_len();
            let hidden = u64::from(bits) * 3 / 10;
            budget.charge(OF_DIGIT * hidden.saturating_sub(token.bytes.len() as u64)).at_line(token.line)?;
        }
    }
    Ok(number)
}

/// Makes a point of two numbers.
pub(super) fn make_point(coordinates: [Number; 2]) -> Point2 {
    match coordinates {
        // Of less than 61 bits.
        [Number::Small(x, 1), Number::Small(y, 1)] => Point2::from_i64([x, y]),
        coordinates => Point2::from_rationals(&coordinates.map(Number::into_rational)),
    }
}

pub(super) fn read_pair(
    line: &mut Line<'_>,
    budget: &mut Budget,
    expected: &str,
) -> Result<[Number; 2], Located> {
    let first = read_number(line.expect(expected)?, budget)?;
    Ok([first, read_number(line.expect(expected)?, budget)?])
}

impl<C: Clone> List<C> {
    /// What the part of a curve for one edge takes, while edges are checked.
    pub(super) fn bytes_of_part<S: PieceTraits<UMonotoneCurve = C>>(&self) -> u64 {
        match self {
            Self::Single(_) => of_piece::<S>() / 2,
            Self::Chains(_) => of_chained::<S>(),
        }
    }

    /// Appends a curve of one piece or more, which must be one chain.
    pub(super) fn push<S: Base<UMonotoneCurve = C>>(
        &mut self,
        traits: &S,
        mut pieces: Vec<C>,
        line: u32,
        budget: &mut Budget,
    ) -> Result<(), Located> {
        if let Self::Single(curves) = self
            && pieces.len() == 1
        {
            budget.charge(of_piece::<S>()).at_line(line)?;
            curves.append(&mut pieces);
            return Ok(());
        }
        let traits = PolycurveTraits::new(traits.clone());
        if let Self::Single(curves) = self {
            // Those that came before become chains.
            budget.charge((of_chained::<S>() + OF_CHAIN) * curves.len() as u64).at_line(line)?;
            let chains = std::mem::take(curves).into_iter();
            let chains = chains.map(|curve| chain_of(&traits, vec![curve]).expect("one piece is a chain"));
            *self = Self::Chains(chains.collect());
        }
        let Self::Chains(chains) = self else { unreachable!("the curves have become chains") };
        budget.charge(OF_CHAIN + of_chained::<S>() * pieces.len() as u64).at_line(line)?;
        chains.push(chain_of(&traits, pieces).ok_or_else(|| {
            let why = format!(
                "the curve {}, or is vertical in part only; cut it there into curves of their own",
                S::TURNS_BACK
            );
            malformed(line, why)
        })?);
        Ok(())
    }
}

/// A chain of pieces; `None` if they make several.
fn chain_of<S: PieceTraits>(
    traits: &PolycurveTraits<S>,
    pieces: Vec<S::UMonotoneCurve>,
) -> Option<Chain<S::UMonotoneCurve>> {
    let polycurve = traits.make_polycurve(pieces).ok()?;
    match polycurve.parts() {
        [Piece::Curve { curve, .. }] => Some(curve.clone()),
        _ => None,
    }
}

/// Whether so many pieces can be put into a chain.
pub(super) fn check_room<S: PieceTraits>(
    pieces: usize,
    line: &Line<'_>,
    budget: &Budget,
) -> Result<(), Located> {
    if of_putting_piece::<S>() * pieces as u64 > budget.left() {
        return Err(budget.exceeded()).at_line(line.number);
    }
    Ok(())
}

pub(super) fn malformed(line: u32, why: String) -> Located {
    Fault::Malformed { why }.at(Place::Line(line))
}
