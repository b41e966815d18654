//! The models, each with the surface that it serves, and how curves become its own.

use crate::curves::{Curve, P, Shape, rational};
use crate::family::{CurveOf, Family};
pub(crate) use crate::family::{Linears, MinimalSegments, Numbered, Polylinears, Polylines, Segments};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Pieces;
use splitstar_arrangement::models::polycurve::Polycurve;
use splitstar_arrangement::models::{
    Linear, LinearTraits, MinimalSegment, Segment, TorusPath, TorusSegmentTraits,
};
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::DirectionalTraits;
use splitstar_arrangement::wrappers::{DataSet, WithData};

/// A family whose curves are made of shapes and ends.
pub(crate) trait Model: Family {
    /// A curve of the family; `None` if it cannot carry such a one. `number` may become its data.
    fn curve(&self, shape: Shape, ends: [Point2; 2], number: u32) -> Option<CurveOf<Self>>;

    /// Where the surface has a place of the plane.
    fn place(&self, p: &P) -> P {
        p.clone()
    }

    /// The periods, if the surface is a torus.
    fn period(&self) -> Option<P> {
        None
    }

    /// The curves and the points; `None` if there are curves that it cannot carry.
    fn own(&self, curves: &[Curve]) -> Option<OwnCurves<Self>> {
        let (mut own, mut points) = (Vec::new(), Vec::new());
        for (number, curve) in (0..).zip(curves) {
            match curve {
                Curve::Point(p) => points.push(Point2::from_rationals(&self.place(p))),
                Curve::Straight(shape, ends) => {
                    own.push(self.curve(*shape, ends.each_ref().map(Point2::from_rationals), number)?);
                }
            }
        }
        Some((own, points))
    }

    /// The u-monotone curves and the points; `None` if there are curves that it cannot carry.
    fn pieces(&self, curves: &[Curve]) -> Option<Pieces<Self::Traits>> {
        let (own, points) = self.own(curves)?;
        let mut pieces = Pieces::of_curves(&self.traits(), &own);
        points.into_iter().for_each(|point| pieces.push_point(point));
        Some(pieces)
    }
}

/// Curves of a model, and points.
pub(crate) type OwnCurves<M> = (Vec<CurveOf<M>>, Vec<Point2>);

impl Model for Segments {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], _: u32) -> Option<Segment> {
        Segment::new(p, q).filter(|_| shape == Shape::Segment)
    }
}

impl Model for MinimalSegments {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], _: u32) -> Option<MinimalSegment> {
        MinimalSegment::new(p, q).filter(|_| shape == Shape::Segment)
    }
}

impl Model for Linears {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], _: u32) -> Option<Linear> {
        match shape {
            Shape::Segment => Linear::segment(p, q),
            Shape::Ray => Linear::ray(p, &q),
            Shape::Line => Linear::line(&p, &q),
        }
    }
}

/// The point between two others, at k quarters.
fn quarter(p: &Point2, q: &Point2, k: i64) -> Point2 {
    let ([x, y], [z, w]) = (p.coordinates(), q.coordinates());
    let mix = |a: Rational, b: Rational| &a + (&b - &a) * crate::curves::fraction(k, 4);
    Point2::from_rationals(&[mix(x, z), mix(y, w)])
}

/// Segments with joints, which nobody may see.
impl Model for Polylines {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], number: u32) -> Option<Polycurve<Point2, Segment>> {
        let joints = (1..=i64::from(number % 3)).map(|k| quarter(&p, &q, k)).collect::<Vec<_>>();
        let vertices = std::iter::once(p).chain(joints).chain([q]);
        let polyline = self.traits().make_polyline(vertices).expect("there are vertices");
        (shape == Shape::Segment).then_some(polyline)
    }
}

/// Segments, rays and lines with joints.
impl Model for Polylinears {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], _: u32) -> Option<Polycurve<Point2, Linear>> {
        let middle = quarter(&p, &q, 2);
        let first = match shape {
            Shape::Segment | Shape::Ray => Linear::segment(p.clone(), middle.clone()),
            Shape::Line => LinearTraits.opposite(&Linear::ray(middle.clone(), &p)?).into(),
        };
        let second = match shape {
            Shape::Segment => Linear::segment(middle, q),
            Shape::Ray | Shape::Line => Linear::ray(middle, &q),
        };
        Some(self.traits().make_polycurve([first?, second?]).expect("both pieces have the middle"))
    }
}

/// Each carries its number.
impl Model for Numbered {
    fn curve(&self, shape: Shape, [p, q]: [Point2; 2], number: u32) -> Option<CurveOf<Self>> {
        let segment = Segment::new(p, q).filter(|_| shape == Shape::Segment)?;
        Some(WithData::new(segment, DataSet::single(number)))
    }
}

/// A flat torus so wide that bounded curves do not come round; but seams may cut through them anywhere.
#[derive(Clone, Debug)]
pub(crate) struct WideTorus {
    pub(crate) traits: TorusSegmentTraits,
    pub(crate) shift: P,
}

impl WideTorus {
    pub(crate) fn new(period: [i64; 2], shift: P) -> Self {
        Self {
            traits: TorusSegmentTraits::new(period.map(rational)).expect("the periods are positive"),
            shift,
        }
    }
}

impl Family for WideTorus {
    type Traits = TorusSegmentTraits;
    type Surface = FlatTorus;

    fn traits(&self) -> TorusSegmentTraits {
        self.traits.clone()
    }

    fn surface(&self) -> FlatTorus {
        FlatTorus
    }
}

impl Model for WideTorus {
    fn curve(&self, shape: Shape, ends: [Point2; 2], _: u32) -> Option<TorusPath> {
        let [[x, y], [z, w]] = ends.map(|end| end.coordinates());
        let start = Point2::from_rationals(&[&x + &self.shift[0], &y + &self.shift[1]]);
        let path = self.traits.path(&start, &[z - x, w - y]).expect("the path is short");
        (shape == Shape::Segment).then_some(path)
    }
    fn period(&self) -> Option<P> {
        Some(self.traits.period().clone())
    }
    fn place(&self, p: &P) -> P {
        let moved = Point2::from_rationals(&[&p[0] + &self.shift[0], &p[1] + &self.shift[1]]);
        self.traits.point(&moved).coordinates()
    }
}
