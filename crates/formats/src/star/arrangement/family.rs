//! What is different from one family of curves to the other: the surface and the curves, as text and as objects.

use super::model::{
    LinearArrangement, PolycurveArrangement, StarArrangement, TorusArrangement, TorusPolycurveArrangement,
};
use crate::base::numerals::put;
use arrangement::models::polycurve::{Chain, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, TorusSegment, TorusSegmentTraits};
use arrangement::topology::{FlatTorus, Topology, UnboundedPlane};
use arrangement::traits::{CurveEnd, UMonotoneTraits};
use exact::planar::{Line2, Point2, compare_xy};
use exact::{Integer, Rational};

/// Curves that can be written and read.
pub(super) trait Family: UMonotoneTraits<Point = Point2> + Clone {
    type Surface: Topology<Self>;

    /// The record of the surface.
    fn put_surface(&self, text: &mut Vec<u8>);

    /// What stands behind the number of a curve, without a direction.
    fn put_curve(&self, curve: &Self::UMonotoneCurve, text: &mut Vec<u8>);

    /// The line of a curve at one of its points, and the ends of this piece of it.
    fn line_at<'a>(curve: &'a Self::UMonotoneCurve, p: &Point2) -> (&'a Line2, [Option<&'a Point2>; 2]);
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

    fn put_surface(&self, text: &mut Vec<u8>) {
        put(text, format_args!("surface plane\n"));
    }

    fn put_curve(&self, curve: &Linear, text: &mut Vec<u8>) {
        put_linear(curve.supporting_line(), curve.ends().each_ref().map(Option::as_ref), text);
    }

    fn line_at<'a>(curve: &'a Linear, _: &Point2) -> (&'a Line2, [Option<&'a Point2>; 2]) {
        (curve.supporting_line(), curve.ends().each_ref().map(Option::as_ref))
    }
}

impl Family for PolycurveTraits<LinearTraits> {
    type Surface = UnboundedPlane;

    fn put_surface(&self, text: &mut Vec<u8>) {
        self.inner().put_surface(text);
    }

    /// Pieces on one line that follow each other are one.
    fn put_curve(&self, curve: &Chain<Linear>, text: &mut Vec<u8>) {
        let pieces = curve.pieces();
        let joints = pieces.windows(2).filter(|pair| pair[0].supporting_line() != pair[1].supporting_line());
        let joints: Vec<Option<&Point2>> = joints.map(|pair| pair[1].ends()[0].as_ref()).collect();
        let [first, last] = [&pieces[0], &pieces[pieces.len() - 1]];
        let [min, max] = [first.ends()[0].as_ref(), last.ends()[1].as_ref()];
        if joints.is_empty() {
            return put_linear(first.supporting_line(), [min, max], text);
        }
        text.extend_from_slice(b"polyline");
        if min.is_none() {
            let [dx, dy] = direction(first.supporting_line());
            put(text, format_args!(" infinity {} {}", -dx, -dy));
        }
        min.into_iter().chain(joints.into_iter().flatten()).chain(max).for_each(|p| put_point(p, text));
        if max.is_none() {
            let [dx, dy] = direction(last.supporting_line());
            put(text, format_args!(" infinity {dx} {dy}"));
        }
    }

    fn line_at<'a>(curve: &'a Chain<Linear>, p: &Point2) -> (&'a Line2, [Option<&'a Point2>; 2]) {
        LinearTraits::line_at(piece_at(curve, p, |piece| piece.ends()[1].as_ref()), p)
    }
}

/// The first piece of a chain that does not end before a point.
fn piece_at<'a, C>(chain: &'a Chain<C>, p: &Point2, max: fn(&C) -> Option<&Point2>) -> &'a C {
    let pieces = chain.pieces();
    let count = pieces.partition_point(|piece| max(piece).is_some_and(|max| compare_xy(max, p).is_lt()));
    &pieces[count.min(pieces.len() - 1)]
}

impl Family for TorusSegmentTraits {
    type Surface = FlatTorus;

    fn put_surface(&self, text: &mut Vec<u8>) {
        let [p, q] = self.period();
        put(text, format_args!("surface torus {p} {q}\n"));
    }

    fn put_curve(&self, curve: &TorusSegment, text: &mut Vec<u8>) {
        put_path(std::slice::from_ref(curve), text);
    }

    /// The line is that in the rectangle.
    fn line_at<'a>(curve: &'a TorusSegment, _: &Point2) -> (&'a Line2, [Option<&'a Point2>; 2]) {
        (curve.supporting_line(), CurveEnd::BOTH.map(|end| Some(curve.point(end))))
    }
}

impl Family for PolycurveTraits<TorusSegmentTraits> {
    type Surface = FlatTorus;

    fn put_surface(&self, text: &mut Vec<u8>) {
        self.inner().put_surface(text);
    }

    fn put_curve(&self, curve: &Chain<TorusSegment>, text: &mut Vec<u8>) {
        put_path(curve.pieces(), text);
    }

    fn line_at<'a>(curve: &'a Chain<TorusSegment>, p: &Point2) -> (&'a Line2, [Option<&'a Point2>; 2]) {
        TorusSegmentTraits::line_at(piece_at(curve, p, |piece| Some(piece.place(CurveEnd::Max))), p)
    }
}

/// Writes a path: where it begins, and how far each piece goes. Pieces on one line that follow each other are one.
fn put_path(pieces: &[TorusSegment], text: &mut Vec<u8>) {
    text.extend_from_slice(b"path");
    put_point(pieces[0].point(CurveEnd::Min), text);
    for run in pieces.chunk_by(|a, b| a.supporting_line() == b.supporting_line()) {
        let [from, to] = [run[0].place(CurveEnd::Min), run[run.len() - 1].place(CurveEnd::Max)];
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
