//! What is different from one family of curves to the other: the surface and the curves, as text and as objects.

use super::course::Course;
use super::model::{
    LinearArrangement, PolycurveArrangement, StarArrangement, TorusArrangement, TorusPolycurveArrangement,
};
use crate::base::numerals::put;
use arrangement::models::polycurve::{Chain, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, TorusSegment, TorusSegmentTraits};
use arrangement::topology::{FlatTorus, Topology, UnboundedPlane};
use arrangement::traits::{CurveEnd, UMonotoneTraits};
use exact::planar::{Line2, Point2};
use exact::{Integer, Rational};

/// Curves that can be written and read.
pub(super) trait Family: UMonotoneTraits<Point = Point2> + Clone {
    type Surface: Topology<Self>;
    type Straight: Straight;

    /// The record of the surface.
    fn put_surface(&self, text: &mut Vec<u8>);

    /// The straight pieces of a curve, one or more, from its min to its max end.
    fn pieces(curve: &Self::UMonotoneCurve) -> &[Self::Straight];

    /// What stands behind the number of a curve, without a direction.
    fn put_course(course: &Course<'_>, text: &mut Vec<u8>);
}

/// A piece of a curve on one line.
pub(super) trait Straight {
    fn line(&self) -> &Line2;

    /// An end in the plane, or in the closed rectangle of a torus; `None` at infinity.
    fn place(&self, end: CurveEnd) -> Option<&Point2>;

    /// The vertex there.
    fn point(&self, end: CurveEnd) -> Option<&Point2>;
}

impl Straight for Linear {
    fn line(&self) -> &Line2 {
        self.supporting_line()
    }

    fn place(&self, end: CurveEnd) -> Option<&Point2> {
        self.ends()[end as usize].as_ref()
    }

    fn point(&self, end: CurveEnd) -> Option<&Point2> {
        self.place(end)
    }
}

impl Straight for TorusSegment {
    fn line(&self) -> &Line2 {
        self.supporting_line()
    }

    fn place(&self, end: CurveEnd) -> Option<&Point2> {
        Some(self.place(end))
    }

    fn point(&self, end: CurveEnd) -> Option<&Point2> {
        Some(self.point(end))
    }
}

/// An arrangement that [`write_arrangement`](crate::write_arrangement) can write: a [`StarArrangement`], or one of its variants.
pub trait StarText: sealed::Sealed {
    /// The text.
    #[doc(hidden)]
    fn star_text(&self) -> Vec<u8>;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! star_text {
    ($($arrangement:ty),*) => {$(
        impl sealed::Sealed for $arrangement {}

        impl StarText for $arrangement {
            fn star_text(&self) -> Vec<u8> {
                super::write::text(self)
            }
        }
    )*};
}

star_text!(LinearArrangement, PolycurveArrangement, TorusArrangement, TorusPolycurveArrangement);

impl sealed::Sealed for StarArrangement {}

impl StarText for StarArrangement {
    fn star_text(&self) -> Vec<u8> {
        match self {
            Self::Linear(arrangement) => arrangement.star_text(),
            Self::Polycurves(arrangement) => arrangement.star_text(),
            Self::Torus(arrangement) => arrangement.star_text(),
            Self::TorusPolycurves(arrangement) => arrangement.star_text(),
        }
    }
}

impl Family for LinearTraits {
    type Surface = UnboundedPlane;
    type Straight = Linear;

    fn put_surface(&self, text: &mut Vec<u8>) {
        put(text, format_args!("surface plane\n"));
    }

    fn pieces(curve: &Linear) -> &[Linear] {
        std::slice::from_ref(curve)
    }

    fn put_course(course: &Course<'_>, text: &mut Vec<u8>) {
        put_in_plane(course, text);
    }
}

impl Family for PolycurveTraits<LinearTraits> {
    type Surface = UnboundedPlane;
    type Straight = Linear;

    fn put_surface(&self, text: &mut Vec<u8>) {
        self.inner().put_surface(text);
    }

    fn pieces(curve: &Chain<Linear>) -> &[Linear] {
        curve.pieces()
    }

    fn put_course(course: &Course<'_>, text: &mut Vec<u8>) {
        put_in_plane(course, text);
    }
}

impl Family for TorusSegmentTraits {
    type Surface = FlatTorus;
    type Straight = TorusSegment;

    fn put_surface(&self, text: &mut Vec<u8>) {
        let [p, q] = self.period();
        put(text, format_args!("surface torus {p} {q}\n"));
    }

    fn pieces(curve: &TorusSegment) -> &[TorusSegment] {
        std::slice::from_ref(curve)
    }

    fn put_course(course: &Course<'_>, text: &mut Vec<u8>) {
        put_path(course, text);
    }
}

impl Family for PolycurveTraits<TorusSegmentTraits> {
    type Surface = FlatTorus;
    type Straight = TorusSegment;

    fn put_surface(&self, text: &mut Vec<u8>) {
        self.inner().put_surface(text);
    }

    fn pieces(curve: &Chain<TorusSegment>) -> &[TorusSegment] {
        curve.pieces()
    }

    fn put_course(course: &Course<'_>, text: &mut Vec<u8>) {
        put_path(course, text);
    }
}

/// Writes a segment, a ray, a line or a polyline.
fn put_in_plane(course: &Course<'_>, text: &mut Vec<u8>) {
    let Course { lines: [first, last], places: [min, max], bends, .. } = course;
    if bends.is_empty() {
        return put_linear(first, [*min, *max], text);
    }
    text.extend_from_slice(b"polyline");
    if min.is_none() {
        let [dx, dy] = direction(first);
        put(text, format_args!(" infinity {} {}", -dx, -dy));
    }
    min.iter().chain(bends).chain(max).for_each(|p| put_point(p, text));
    if max.is_none() {
        let [dx, dy] = direction(last);
        put(text, format_args!(" infinity {dx} {dy}"));
    }
}

/// Writes a path: the vertex where it begins, and how far each piece goes.
fn put_path(course: &Course<'_>, text: &mut Vec<u8>) {
    text.extend_from_slice(b"path");
    course.start.iter().for_each(|p| put_point(p, text));
    let [min, max] = &course.places;
    let places = || min.iter().chain(&course.bends).chain(max);
    for (from, to) in places().zip(places().skip(1)) {
        let ([x, y], [to_x, to_y]) = (from.coordinates(), to.coordinates());
        put(text, format_args!(" {} {}", to_x - x, to_y - y));
    }
}

/// Writes a segment, a ray or a line. Its second point, where it does not end, is one direction away from the first.
fn put_linear(line: &Line2, ends: [Option<&Point2>; 2], text: &mut Vec<u8>) {
    let [dx, dy] = direction(line).map(Rational::from);
    let (keyword, from, sign) = match ends {
        [Some(min), Some(max)] => {
            text.extend_from_slice(b"segment");
            put_point(min, text);
            return put_point(max, text);
        }
        [Some(min), None] => ("ray", min.coordinates(), 1),
        [None, Some(max)] => ("ray", max.coordinates(), -1),
        [None, None] => ("line", point_of(line), 1),
    };
    let [dx, dy] = if sign > 0 { [dx, dy] } else { [-dx, -dy] };
    put(text, format_args!("{keyword} {} {} {} {}", from[0], from[1], &from[0] + &dx, &from[1] + &dy));
}

/// The direction of a line to the right, or upwards if it is vertical: integers without a common factor.
fn direction(line: &Line2) -> [Integer; 2] {
    let [a, b, _] = line.coefficients();
    // b is positive, or zero and a negative.
    let divisor = a.gcd(&b);
    [b.div_exact(&divisor), (-a).div_exact(&divisor)]
}

/// Where a line crosses the axis x = 0, or y = 0 if it is vertical.
fn point_of(line: &Line2) -> [Rational; 2] {
    let [a, b, c] = line.coefficients();
    let quotient = |divisor| Rational::new(c.clone(), divisor).expect("a line has a normal");
    if b.is_zero() { [quotient(a), Rational::ZERO] } else { [Rational::ZERO, quotient(b)] }
}

pub(super) fn put_point(point: &Point2, text: &mut Vec<u8>) {
    let [x, y] = point.coordinates();
    put(text, format_args!(" {x} {y}"));
}
