//! Where a shape stands: the transforms around it, composed exactly.

use super::lexer::Lexer;
use crate::base::error::{Fault, Located};
use crate::base::places::Place;
use crate::base::words::read_coordinate;
use exact::{Affine3, Linear3, MAX_DIGITS, Point3, Rational, Sign};
use std::array::from_fn;

/// A scale along the axes, then a translation: all that is rational of the transforms of VRML.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    scale: [Rational; 3],
    shift: [Rational; 3],
    map: Option<Affine3>,
}

impl PartialEq for Frame {
    fn eq(&self, other: &Self) -> bool {
        self.scale == other.scale && self.shift == other.shift
    }
}

/// The places of the fields of a `Transform`.
pub(super) struct TransformFields<'a> {
    pub(super) center: Option<Lexer<'a>>,
    pub(super) rotation: Option<Lexer<'a>>,
    pub(super) scale: Option<Lexer<'a>>,
    pub(super) scale_orientation: Option<Lexer<'a>>,
    pub(super) translation: Option<Lexer<'a>>,
}

impl Frame {
    pub(super) fn identity() -> Self {
        Self { scale: from_fn(|_| Rational::ONE), shift: from_fn(|_| Rational::ZERO), map: None }
    }

    /// The frame within a `Transform` of this one, which begins in this line.
    ///
    /// A rotation is given by an angle in radians, whose sine and cosine are irrational for every decimal but
    /// zero: only zero is read.
    pub(super) fn within(&self, fields: TransformFields<'_>, line: u32) -> Result<Self, Located> {
        let scale = vector(fields.scale, Rational::ONE)?;
        let [shift, center] =
            [vector(fields.translation, Rational::ZERO)?, vector(fields.center, Rational::ZERO)?];
        let uniform = scale[0] == scale[1] && scale[1] == scale[2];
        let scale_orientation = fields.scale_orientation.filter(|_| !uniform);
        for (rotation, field) in [(fields.rotation, "rotation"), (scale_orientation, "scaleOrientation")] {
            let Some(mut value) = rotation else { continue };
            let Some(at) = value.peek() else { continue };
            if !numbers::<4>(&mut value)?[3].is_zero() {
                let what = format!("a {field} by an angle that is not 0");
                let instead = "apply the rotation before export".into();
                return Err(Fault::Unsupported { what, instead }.at(Place::Line(at.line)));
            }
        }
        if let Some(value) = fields.scale
            && scale.iter().any(Rational::is_zero)
        {
            let expected = "a scale without 0".into();
            let found = value.peek().map(|token| token.shown()).unwrap_or_default();
            return Err(Fault::Syntax { found: format!("{found} ..."), expected }.at(Place::Line(line)));
        }
        // The scale fixes the center: x goes to scale * (x - center) + center + shift.
        let shift: [Rational; 3] = from_fn(|i| &shift[i] + &center[i] - &(&scale[i] * &center[i]));
        let composed = Self {
            shift: from_fn(|i| &self.scale[i] * &shift[i] + &self.shift[i]),
            scale: from_fn(|i| &self.scale[i] * &scale[i]),
            map: None,
        };
        composed.with_map(line)
    }

    fn with_map(mut self, line: u32) -> Result<Self, Located> {
        // log2(10) < 10/3: numbers of more digits are not read either.
        let most = MAX_DIGITS as usize * 10 / 3;
        let is_long = |number: &Rational| {
            number.numerator().bit_len() as usize > most || number.denominator().bit_len() as usize > most
        };
        if self.scale.iter().chain(&self.shift).any(is_long) {
            let what = format!("a Transform that makes numbers of more than {MAX_DIGITS} digits");
            let instead = "write it with fewer digits".into();
            return Err(Fault::Unsupported { what, instead }.at(Place::Line(line)));
        }
        let rows = from_fn(|row| {
            from_fn(|column| if row == column { self.scale[row].clone() } else { Rational::ZERO })
        });
        let is_identity = self == Self::identity();
        self.map = (!is_identity).then(|| Affine3::new(Linear3::from_rationals(&rows), self.shift.clone()));
        Ok(self)
    }

    /// How much memory it takes, at most.
    pub(super) fn bytes(&self) -> u64 {
        let bits = |number: &Rational| {
            u64::from(number.numerator().bit_len()) + u64::from(number.denominator().bit_len())
        };
        // The 24 numbers of the map are over common denominators.
        4 * self.scale.iter().chain(&self.shift).map(bits).sum::<u64>() + size_of::<Self>() as u64
    }

    /// The point where it stands in the scene.
    pub(super) fn apply(&self, point: Point3) -> Point3 {
        match &self.map {
            Some(map) => map.apply(&point),
            None => point,
        }
    }

    /// Whether it turns what is left to the right.
    pub(super) fn reflects(&self) -> bool {
        self.map.as_ref().is_some_and(|map| map.determinant_sign() == Sign::Negative)
    }
}

fn vector(value: Option<Lexer<'_>>, default: Rational) -> Result<[Rational; 3], Located> {
    match value {
        Some(mut value) => numbers(&mut value),
        None => Ok(from_fn(|_| default.clone())),
    }
}

/// Reads so many numbers.
pub(super) fn numbers<const N: usize>(lexer: &mut Lexer<'_>) -> Result<[Rational; N], Located> {
    let mut numbers = from_fn(|_| Rational::ZERO);
    for number in &mut numbers {
        *number = read_coordinate(lexer.token("a number")?)?.into_rational();
    }
    Ok(numbers)
}
