//! The families of curves that are straight in the parameter space.

use super::draw::Draw;
use super::scan::{P, Stroke};
use crate::family::{CurveOf, Family, Linears, MinimalSegments, Numbered, Polylinears, Polylines, Segments};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::{Chain, Polycurve, PolycurveTraits};
use splitstar_arrangement::models::{
    Linear, MinimalSegment, Segment, TorusPath, TorusSegment, TorusSegmentTraits,
};
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::{BasicTraits, CurveEnd};
use splitstar_arrangement::wrappers::{DataSet, WithData};

/// A family of straight curves that bytes describe.
pub(super) trait Straight: Family {
    /// A curve that bytes describe; `None` if they describe none.
    fn curve(&self, draw: &mut Draw<'_>) -> Option<CurveOf<Self>>;

    /// A point that bytes describe, with the coordinates by which the traits know it.
    fn point(&self, draw: &mut Draw<'_>) -> Point2 {
        draw.point()
    }

    /// The point of the surface at a place of the parameter space.
    fn at(&self, place: &P) -> Point2 {
        Point2::from_rationals(place)
    }

    /// The straight parts of a curve.
    fn strokes(&self, curve: &PieceOf<Self>) -> Vec<Stroke>;

    /// What a curve carries.
    fn labels(&self, curve: &PieceOf<Self>) -> Vec<u32> {
        let _ = curve;
        Vec::new()
    }

    /// The same curve; it may carry something else.
    fn relabeled(&self, curve: PieceOf<Self>, label: u32) -> PieceOf<Self> {
        let _ = label;
        curve
    }

    /// The periods, if the surface is a torus.
    fn period(&self) -> Option<P> {
        None
    }
}

type PieceOf<F> = <<F as Family>::Traits as BasicTraits>::UMonotoneCurve;

fn stroke_between(p: &Point2, q: &Point2) -> Stroke {
    Stroke::new([p.coordinates(), q.coordinates()], [false; 2])
}

fn linear_stroke(curve: &Linear) -> Stroke {
    let [a, b, c] = curve.supporting_line().coefficients().map(Rational::from);
    let ends = curve.ends().each_ref().map(|end| end.as_ref().map(Point2::coordinates));
    let is_open = ends.each_ref().map(Option::is_none);
    // To the right, or up.
    let way =
        if (&b, &-&a) > (&Rational::ZERO, &Rational::ZERO) { [b.clone(), -&a] } else { [-&b, a.clone()] };
    let along = |p: &P, times: i64| [0, 1].map(|i| &p[i] + Rational::from(times) * &way[i]);
    let nearest = || {
        let factor = c.checked_div(&(&a * &a + &b * &b)).expect("a line has a direction");
        [&a * &factor, &b * &factor]
    };
    let ends = match ends {
        [Some(p), Some(q)] => [p, q],
        [Some(p), None] => [p.clone(), along(&p, 1)],
        [None, Some(q)] => [along(&q, -1), q],
        [None, None] => [nearest(), along(&nearest(), 1)],
    };
    Stroke::new(ends, is_open)
}

fn torus_stroke(curve: &TorusSegment) -> Stroke {
    stroke_between(curve.place(CurveEnd::Min), curve.place(CurveEnd::Max))
}

impl Straight for Segments {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Segment> {
        Segment::new(draw.point(), draw.point())
    }
    fn strokes(&self, curve: &Segment) -> Vec<Stroke> {
        vec![stroke_between(curve.min(), curve.max())]
    }
}

impl Straight for MinimalSegments {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<MinimalSegment> {
        MinimalSegment::new(draw.point(), draw.point())
    }
    fn strokes(&self, curve: &MinimalSegment) -> Vec<Stroke> {
        let [p, q] = curve.ends();
        vec![stroke_between(p, q)]
    }
}

impl Straight for Numbered {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<CurveOf<Self>> {
        let segment = Segments.curve(draw)?;
        Some(WithData::new(segment, DataSet::single(draw.below(4) as u32)))
    }
    fn strokes(&self, curve: &PieceOf<Self>) -> Vec<Stroke> {
        Segments.strokes(&curve.curve)
    }
    fn labels(&self, curve: &PieceOf<Self>) -> Vec<u32> {
        curve.data.iter().copied().collect()
    }
    fn relabeled(&self, mut curve: PieceOf<Self>, label: u32) -> PieceOf<Self> {
        curve.data = DataSet::single(label);
        curve
    }
}

impl Straight for Linears {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Linear> {
        let (p, q) = (draw.point(), draw.point());
        match draw.below(4) {
            0 => Linear::line(&p, &q),
            1 => Linear::ray(p, &q),
            _ => Linear::segment(p, q),
        }
    }
    fn strokes(&self, curve: &Linear) -> Vec<Stroke> {
        vec![linear_stroke(curve)]
    }
}

/// Some of them are closed.
impl Straight for Polylines {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Polycurve<Point2, Segment>> {
        let count = 2 + draw.below(4);
        let vertices: Vec<Point2> = (0..count).map(|_| draw.point()).collect();
        if draw.one_in(4) {
            self.traits().make_polygon(vertices).ok()
        } else {
            self.traits().make_polyline(vertices).ok()
        }
    }
    fn strokes(&self, curve: &Chain<Segment>) -> Vec<Stroke> {
        curve.pieces().iter().flat_map(|piece| Segments.strokes(piece)).collect()
    }
}

impl Straight for Polylinears {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Polycurve<Point2, Linear>> {
        let [p, q, r] = [draw.point(), draw.point(), draw.point()];
        let kind = draw.below(8);
        if kind == 0 {
            return self.traits().make_polycurve([Linear::line(&p, &q)?]).ok();
        }
        let middle = Linear::segment(p.clone(), q.clone())?;
        let first = [3, 6].contains(&kind).then(|| Linear::ray(p, &draw.point())).flatten();
        let last = if kind < 4 { Linear::segment(q, r) } else { Linear::ray(q, &r) };
        self.traits().make_polycurve(first.into_iter().chain([middle]).chain(last)).ok()
    }
    fn strokes(&self, curve: &Chain<Linear>) -> Vec<Stroke> {
        curve.pieces().iter().map(linear_stroke).collect()
    }
}

/// Paths on a small torus.
#[derive(Debug)]
pub(super) struct Torus {
    traits: TorusSegmentTraits,
}

impl Torus {
    pub(super) fn new(period: [i64; 2]) -> Self {
        let traits = TorusSegmentTraits::new(period.map(Rational::from));
        Self { traits: traits.expect("the periods are positive") }
    }
}

impl Family for Torus {
    type Traits = TorusSegmentTraits;
    type Surface = FlatTorus;

    fn traits(&self) -> TorusSegmentTraits {
        self.traits.clone()
    }
    fn surface(&self) -> FlatTorus {
        FlatTorus
    }
}

impl Straight for Torus {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<TorusPath> {
        let start = self.point(draw);
        if draw.one_in(4) {
            let winding = [0; 2].map(|_| draw.below(5) as i64 - 2);
            return self.traits.closed_path(&start, winding).ok();
        }
        let mut way = draw.vector();
        match draw.below(4) {
            0 => way[0] = Rational::ZERO,
            1 => way[1] = Rational::ZERO,
            _ => {}
        }
        self.traits.path(&start, &way).ok()
    }
    fn point(&self, draw: &mut Draw<'_>) -> Point2 {
        self.traits.point(&draw.point())
    }
    fn at(&self, place: &P) -> Point2 {
        self.traits.point(&Point2::from_rationals(place))
    }
    fn strokes(&self, curve: &TorusSegment) -> Vec<Stroke> {
        vec![torus_stroke(curve)]
    }
    fn period(&self) -> Option<P> {
        Some(self.traits.period().clone())
    }
}

/// Polylines on a small torus.
#[derive(Debug)]
pub(super) struct TorusPolylines {
    torus: Torus,
}

impl TorusPolylines {
    pub(super) fn new(period: [i64; 2]) -> Self {
        Self { torus: Torus::new(period) }
    }
}

impl Family for TorusPolylines {
    type Traits = PolycurveTraits<TorusSegmentTraits>;
    type Surface = FlatTorus;

    fn traits(&self) -> Self::Traits {
        PolycurveTraits::new(self.torus.traits())
    }
    fn surface(&self) -> FlatTorus {
        FlatTorus
    }
}

impl Straight for TorusPolylines {
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Polycurve<Point2, TorusSegment>> {
        let mut place = draw.point().coordinates();
        let mut vertices = vec![Point2::from_rationals(&place)];
        for _ in 0..1 + draw.below(3) {
            let way = draw.vector();
            place = [0, 1].map(|i| &place[i] + &way[i]);
            vertices.push(Point2::from_rationals(&place));
        }
        self.traits().make_cover_polyline(vertices).ok()
    }
    fn point(&self, draw: &mut Draw<'_>) -> Point2 {
        self.torus.point(draw)
    }
    fn at(&self, place: &P) -> Point2 {
        self.torus.at(place)
    }
    fn strokes(&self, curve: &Chain<TorusSegment>) -> Vec<Stroke> {
        curve.pieces().iter().map(torus_stroke).collect()
    }
    fn period(&self) -> Option<P> {
        self.torus.period()
    }
}
