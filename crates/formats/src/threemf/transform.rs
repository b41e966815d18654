//! Transforms of objects: exact, and composed on the way down.

use super::element::{Element, Value};
use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::read_coordinate;
use exact::{Affine3, Linear3, MAX_DIGITS, Rational, Sign};
use std::rc::Rc;

/// An invertible map, and how long its numbers are.
#[derive(Debug)]
pub(super) struct Transform {
    map: Affine3,
    mirrors: bool,
    /// The bits of all numbers that it was made of, which bound those of its entries.
    bits: u64,
}

/// No transform is the identity.
pub(super) type Map = Option<Rc<Transform>>;

/// Longer numbers cost time at every vertex.
const LONG: u64 = 2048;
/// The longest that are applied: as many digits as a few of the longest numbers have.
const LONGEST: u64 = 16 * MAX_DIGITS as u64;

/// Reads the attribute of a component or an item: twelve numbers, the rows of a matrix by which a row (x, y, z, 1)
/// is multiplied.
pub(super) fn read(value: Option<Value<'_>>, element: &Element<'_>) -> Result<Map, Located> {
    let Some(value) = value else { return Ok(None) };
    let mut numbers = Vec::with_capacity(12);
    for token in value.tokens() {
        if numbers.len() == 12 {
            return Err(wrong(&value, "a transform of 12 numbers"));
        }
        numbers.push(read_coordinate(token)?.into_rational());
    }
    let Ok(numbers) = <[Rational; 12]>::try_from(numbers) else {
        return Err(wrong(&value, "a transform of 12 numbers"));
    };
    let bits =
        numbers.iter().map(|n| u64::from(n.numerator().bit_len()) + u64::from(n.denominator().bit_len()));
    let bits = bits.sum();
    let column = |index: usize| [0, 3, 6].map(|row| numbers[row + index].clone());
    let linear = Linear3::from_rationals(&[0, 1, 2].map(column));
    let mirrors = match linear.determinant_sign() {
        Sign::Zero => return Err(wrong(&value, "a transform whose determinant is not zero")),
        sign => sign == Sign::Negative,
    };
    let map = Affine3::new(linear, [9, 10, 11].map(|index: usize| numbers[index].clone()));
    if map == Affine3::identity() {
        return Ok(None);
    }
    Transform { map, mirrors, bits }.checked(element.line)
}

fn wrong(value: &Value<'_>, expected: &str) -> Located {
    let token: Token<'_> = value.token();
    token.unexpected(expected)
}

/// The map that applies `first` and then `second`. The error is at a line.
pub(super) fn compose(first: &Map, second: &Map, line: u32) -> Result<Map, Located> {
    match (first, second) {
        (Some(first), Some(second)) => {
            let bits = first.bits + second.bits;
            if bits > LONGEST {
                return Err(too_long(line));
            }
            let mirrors = first.mirrors != second.mirrors;
            Ok(Some(Rc::new(Transform { map: first.map.then(&second.map), mirrors, bits })))
        }
        (first, None) => Ok(first.clone()),
        (None, second) => Ok(second.clone()),
    }
}

impl Transform {
    fn checked(self, line: u32) -> Result<Map, Located> {
        if self.bits > LONGEST { Err(too_long(line)) } else { Ok(Some(Rc::new(self))) }
    }

    pub(super) fn map(&self) -> &Affine3 {
        &self.map
    }

    /// Whether it turns the outside in.
    pub(super) fn mirrors(&self) -> bool {
        self.mirrors
    }

    /// What it takes.
    pub(super) fn bytes(&self) -> u64 {
        size_of::<Self>() as u64 + self.bits
    }

    /// What to charge for each use of an object by it, which may compose it: with long numbers that takes long.
    pub(super) fn bytes_of_use(&self) -> u64 {
        if self.bits > LONG { 4 * self.bits } else { 0 }
    }

    /// What to charge for each vertex, beside the vertex: with long numbers even a short result takes long.
    pub(super) fn bytes_of_vertex(&self) -> u64 {
        if self.bits > LONG { self.bits / 4 } else { 0 }
    }
}

fn too_long(line: u32) -> Located {
    let what = "transforms with so many digits".into();
    Fault::Unsupported { what, instead: "write them with fewer digits".into() }.at(Place::Line(line))
}
