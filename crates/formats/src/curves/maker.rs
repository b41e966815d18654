//! How curves are made: coordinate by coordinate, within the budget.

use super::lexer::is_mark;
use super::model::{CurveFile, CurveNote, CurvePoint, InputCurve, PointFile};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, NumberFault};
use crate::base::number::{Number, parse_number};
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use exact::Rational;
use exact::planar::Point2;

/// Collects curves with their lines, and charges them to the budget.
pub(super) struct Maker<'b> {
    curves: Vec<InputCurve>,
    places: PlaceList,
    period: Option<[Rational; 2]>,
    budget: &'b mut Budget,
    /// The polyline that is being read, without repeated points.
    chain: Vec<CurvePoint>,
    /// How many points the file gives for it.
    given: usize,
    /// The line where it begins.
    chain_line: u32,
    /// For how many points of it memory is charged.
    charged: usize,
    dropped: usize,
    repeated: usize,
    collapsed: usize,
    empty: usize,
}

/// What a polyline may be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Chain {
    /// Its ends may be anywhere.
    Open,
    /// It ends where it begins.
    Ring,
}

/// A growing list takes up to twice the size of what it holds.
const GROWTH: u64 = 2;
const CURVE: u64 = GROWTH * (size_of::<InputCurve>() as u64 + 4);
const POINT: u64 = size_of::<CurvePoint>() as u64;

impl<'b> Maker<'b> {
    pub(super) fn new(budget: &'b mut Budget) -> Self {
        Self {
            curves: Vec::new(),
            places: PlaceList::lines(),
            period: None,
            budget,
            chain: Vec::new(),
            given: 0,
            chain_line: 0,
            charged: 0,
            dropped: 0,
            repeated: 0,
            collapsed: 0,
            empty: 0,
        }
    }

    /// Makes a point of its coordinates; what it takes on the heap is charged.
    #[inline]
    pub(super) fn point_of(&mut self, x: Token<'_>, y: Token<'_>) -> Result<CurvePoint, Located> {
        match (number(x)?, number(y)?) {
            (Number::Small(i, 1), Number::Small(j, 1)) if fits(i) && fits(j) => Ok(Point2::from_i64([i, j])),
            (i, j) => {
                let coordinates = [i, j].map(Number::into_rational);
                self.budget.charge(wide_bytes(&coordinates)).at_line(x.line)?;
                Ok(Point2::from_rationals(&coordinates))
            }
        }
    }

    /// Passes over a third or a later coordinate. What is left out need not be finite.
    pub(super) fn extra_coordinate(&mut self, token: Token<'_>) -> Result<(), Located> {
        match parse_number(token.bytes) {
            Ok(_) | Err(NumberFault::NotFinite) => Ok(()),
            Err(fault) => Err(no_number(token, fault)),
        }
    }

    /// A point had more than two coordinates.
    pub(super) fn count_dropped(&mut self) {
        self.dropped += 1;
    }

    /// A geometry had no point.
    pub(super) fn count_empty(&mut self) {
        self.empty += 1;
    }

    /// The file is one of a torus.
    pub(super) fn set_period(&mut self, period: [Rational; 2]) {
        self.period = Some(period);
    }

    /// Adds a segment, a ray or a line, whose points must be different.
    #[inline]
    pub(super) fn straight(&mut self, curve: InputCurve, line: u32) -> Result<(), Located> {
        let (ends, name) = match &curve {
            InputCurve::Segment(ends) => (ends, "segment"),
            InputCurve::Ray(ends) => (ends, "ray"),
            InputCurve::Line(ends) => (ends, "line"),
            _ => unreachable!("polylines and points are added by methods of their own"),
        };
        if ends[0] == ends[1] {
            return Err(same_ends(name, line));
        }
        if self.period.is_some() && name != "segment" {
            let what = format!("a {name} on a torus");
            let instead = "it has no end there: give a segment, or remove `period`".into();
            return Err(Fault::Unsupported { what, instead }.at(Place::Line(line)));
        }
        self.push(curve, line)
    }

    /// Adds an isolated point.
    pub(super) fn point(&mut self, point: CurvePoint, line: u32) -> Result<(), Located> {
        self.push(InputCurve::Point(point), line)
    }

    /// Begins a polyline.
    pub(super) fn begin_chain(&mut self) {
        self.chain.clear();
        self.given = 0;
    }

    /// Appends a point to the polyline; where it repeats the last one, it is only counted.
    #[inline]
    pub(super) fn extend_chain(&mut self, point: CurvePoint, line: u32) -> Result<(), Located> {
        if self.given == 0 {
            self.chain_line = line;
        }
        self.given += 1;
        if self.chain.last() == Some(&point) {
            return Ok(());
        }
        if self.chain.len() == self.charged {
            self.budget.charge(GROWTH * POINT).at_line(line)?;
            self.charged += 1;
        }
        self.chain.push(point);
        Ok(())
    }

    /// Adds the polyline, which must have two points, be they the same.
    pub(super) fn end_chain(&mut self, kind: Chain) -> Result<(), Located> {
        let line = self.chain_line;
        let malformed = |why: &str| Err(Fault::Malformed { why: why.into() }.at(Place::Line(line)));
        if self.given < 2 {
            return malformed("a polyline of one point; give it a second one, or make it a point");
        }
        if kind == Chain::Ring && self.chain.first() != self.chain.last() {
            return malformed("the ring of a polygon is not closed; repeat its first point at its end");
        }
        let repeated = self.given - self.chain.len();
        if self.chain.len() == 1 {
            self.collapsed += 1;
            let point = self.chain.pop().expect("a polyline has a point");
            return self.point(point, line);
        }
        self.repeated += repeated;
        self.budget.charge(POINT * self.chain.len() as u64).at_line(line)?;
        let points = self.chain.drain(..).collect();
        self.push(InputCurve::Polyline(points), line)
    }

    #[inline]
    fn push(&mut self, curve: InputCurve, line: u32) -> Result<(), Located> {
        self.budget.charge(CURVE).at_line(line)?;
        if self.curves.len() >= u32::MAX as usize - 1 {
            let why = format!("more than {} curves; split the file", u32::MAX - 1);
            return Err(Fault::Malformed { why }.at(Place::Line(line)));
        }
        self.curves.push(curve);
        self.places.push(Place::Line(line));
        Ok(())
    }

    /// Adds a point to those that were taken out: what stands in a line of its own takes less than a curve.
    #[inline]
    pub(super) fn bare_point(
        &mut self,
        x: Token<'_>,
        y: Token<'_>,
        points: &mut Vec<CurvePoint>,
    ) -> Result<(), Located> {
        let point = self.point_of(x, y)?;
        self.budget.charge(GROWTH * (POINT + 4)).at_line(x.line)?;
        points.push(point);
        self.places.push(Place::Line(x.line));
        Ok(())
    }

    /// Takes the curves out that were added since the last call, which must be points.
    #[inline]
    pub(super) fn take_points(&mut self, into: &mut Vec<CurvePoint>) -> Result<(), Located> {
        for curve in self.curves.drain(..) {
            let name = match curve {
                InputCurve::Point(point) => {
                    into.push(point);
                    continue;
                }
                InputCurve::Segment(_) => "segment",
                InputCurve::Ray(_) => "ray",
                InputCurve::Line(_) => "line",
                InputCurve::Polyline(_) => "polyline",
            };
            return Err(not_a_point(name, self.places.get(into.len())));
        }
        Ok(())
    }

    pub(super) fn finish(self) -> CurveFile {
        let mut notes = self.notes();
        notes.extend(self.curves.is_empty().then_some(CurveNote::NoCurves));
        CurveFile { curves: self.curves, places: self.places, period: self.period, notes }
    }

    /// A file of the points that were taken out.
    pub(super) fn finish_points(self, points: Vec<CurvePoint>) -> PointFile {
        let mut notes = self.notes();
        notes.extend(points.is_empty().then_some(CurveNote::NoPoints));
        PointFile { points, places: self.places, period: self.period, notes }
    }

    fn notes(&self) -> Vec<CurveNote> {
        let &Self { dropped, repeated, collapsed, empty, .. } = self;
        let notes = [
            (dropped > 0).then_some(CurveNote::CoordinatesDropped { points: dropped }),
            (repeated > 0).then_some(CurveNote::RepeatedPoints { points: repeated }),
            (collapsed > 0).then_some(CurveNote::Collapsed { polylines: collapsed }),
            (empty > 0).then_some(CurveNote::EmptyGeometries { geometries: empty }),
        ];
        notes.into_iter().flatten().collect()
    }
}

#[cold]
fn not_a_point(name: &str, place: Option<Place>) -> Located {
    let why = format!("a {name} in a file of points; remove it, or give the points that are asked about");
    Located { place, fault: Fault::Malformed { why } }
}

#[cold]
fn no_number(token: Token<'_>, fault: NumberFault) -> Located {
    if is_mark(token) {
        return token.unexpected("a coordinate");
    }
    token.fault(|token| Fault::BadNumber { token, fault })
}

#[cold]
fn same_ends(name: &str, line: u32) -> Located {
    let why = if name == "segment" {
        "both ends of the segment are the same point; move one of them, or write `point x y`".into()
    } else {
        format!(
            "both points of the {name} are the same, so that it has no direction; give two different points"
        )
    };
    Fault::Malformed { why }.at(Place::Line(line))
}

/// Reads a coordinate or a period.
#[inline]
pub(super) fn number(token: Token<'_>) -> Result<Number, Located> {
    parse_number(token.bytes).map_err(|fault| no_number(token, fault))
}

/// Bits of integers that a point holds without an allocation.
const NARROW_BITS: u32 = 61;

#[inline]
fn fits(integer: i64) -> bool {
    integer.unsigned_abs() >> NARROW_BITS == 0
}

/// What the point of these coordinates takes on the heap at most: two numerators and their common denominator, and the
/// digits of those that are longer than two machine words.
fn wide_bytes([x, y]: &[Rational; 2]) -> u64 {
    let bits =
        |number: &Rational| [number.numerator(), number.denominator()].map(|part| u64::from(part.bit_len()));
    let ([x, x_weight], [y, y_weight]) = (bits(x), bits(y));
    let bits = [x + y_weight, y + x_weight, x_weight + y_weight];
    if bits.iter().all(|&bits| bits <= u64::from(NARROW_BITS)) {
        return 0;
    }
    let digits = |bits: u64| if bits <= 128 { 0 } else { bits * 9 / 64 + 40 };
    96 + bits.into_iter().map(digits).sum::<u64>()
}
