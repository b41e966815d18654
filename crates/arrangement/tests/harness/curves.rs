//! Curves as data.

use exact::Rational;
use std::fmt;

/// Coordinates.
pub(crate) type P = [Rational; 2];

/// What of the line through two points belongs to a curve.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Shape {
    Segment,
    Ray,
    Line,
}

/// A curve of the plane, or a point.
#[derive(Clone, PartialEq)]
pub(crate) enum Curve {
    Point(P),
    /// From the first point towards the second, which are different.
    Straight(Shape, [P; 2]),
}

impl fmt::Debug for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Point([x, y]) => write!(f, "point {x} {y}"),
            Self::Straight(shape, [[x, y], [z, w]]) => write!(f, "{shape:?} {x} {y} {z} {w}"),
        }
    }
}

pub(crate) fn rational(n: i64) -> Rational {
    Rational::from(n)
}

pub(crate) fn fraction(n: i64, d: i64) -> Rational {
    rational(n).checked_div(&rational(d)).expect("a denominator is not zero")
}

pub(crate) fn at(x: i64, y: i64) -> P {
    [rational(x), rational(y)]
}

pub(crate) fn point(x: i64, y: i64) -> Curve {
    Curve::Point(at(x, y))
}

pub(crate) fn straight(shape: Shape, [x, y, z, w]: [i64; 4]) -> Curve {
    Curve::Straight(shape, [at(x, y), at(z, w)])
}

pub(crate) fn segment(ends: [i64; 4]) -> Curve {
    straight(Shape::Segment, ends)
}

pub(crate) fn ray(from_through: [i64; 4]) -> Curve {
    straight(Shape::Ray, from_through)
}

pub(crate) fn line(through: [i64; 4]) -> Curve {
    straight(Shape::Line, through)
}

impl Curve {
    pub(crate) fn mapped(&self, map: impl Fn(&P) -> P) -> Self {
        match self {
            Self::Point(p) => Self::Point(map(p)),
            Self::Straight(shape, ends) => Self::Straight(*shape, ends.each_ref().map(map)),
        }
    }

    /// The other way round; a ray has only one.
    pub(crate) fn swapped(&self) -> Self {
        match self {
            Self::Straight(shape, [p, q]) if *shape != Shape::Ray => {
                Self::Straight(*shape, [q.clone(), p.clone()])
            }
            other => other.clone(),
        }
    }

    pub(crate) fn is_bounded(&self) -> bool {
        matches!(self, Self::Point(_) | Self::Straight(Shape::Segment, _))
    }
}

/// Reads `segment x y x y`, `ray ..`, `line ..`, `point x y`, separated by commas.
pub(crate) fn parse(text: &str) -> Vec<Curve> {
    text.split(',')
        .map(str::trim)
        .filter(|item| !item.is_empty())
        .map(|item| {
            let mut words = item.split_whitespace();
            let kind = words.next().expect("a curve has a kind");
            let numbers: Vec<i64> =
                words.map(|word| word.parse().expect("a coordinate is an integer")).collect();
            match (kind, &numbers[..]) {
                ("point", &[x, y]) => point(x, y),
                ("segment", &[x, y, z, w]) => segment([x, y, z, w]),
                ("ray", &[x, y, z, w]) => ray([x, y, z, w]),
                ("line", &[x, y, z, w]) => line([x, y, z, w]),
                _ => panic!("not a curve: {item}"),
            }
        })
        .collect()
}
