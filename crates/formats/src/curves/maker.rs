//! How curves are made: coordinate by coordinate, within the budget.

use super::lexer::is_mark;
use super::model::CurveNote;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, NumberFault};
use crate::base::number::{Number, parse_number};
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use exact::Rational;

/// What curves lie on: what the numbers and the lists of points of a file become there.
pub(super) trait Surface: Sized {
    type Point: PartialEq;
    type Curve;

    /// What is said to somebody who gives a geometry that is none of these curves.
    const INSTEAD: &'static str;

    /// Makes a point of the two numbers of a position in WKT or GeoJSON.
    fn position(maker: &mut Maker<'_, Self>, x: Token<'_>, y: Token<'_>) -> Result<Self::Point, Located>;

    /// Tells why there is no curve from one point of a polyline to the next, which is another one.
    fn check_step(from: &Self::Point, to: &Self::Point) -> Result<(), &'static str>;

    fn of_point(point: Self::Point) -> Self::Curve;

    fn of_chain(points: Vec<Self::Point>) -> Self::Curve;

    /// The point that a curve is, or what it is.
    fn into_point(curve: Self::Curve) -> Result<Self::Point, &'static str>;
}

/// Collects curves with their lines, and charges them to the budget.
pub(super) struct Maker<'b, S: Surface> {
    pub(super) surface: S,
    curves: Vec<S::Curve>,
    places: PlaceList,
    pub(super) budget: &'b mut Budget,
    /// What a file of points has; `None` for a file of curves.
    points: Option<Vec<S::Point>>,
    /// The feature of a collection that is being read, from 0.
    feature: Option<usize>,
    /// The polyline that is being read, without repeated points.
    chain: Vec<S::Point>,
    /// How many points the file gives for it.
    given: usize,
    /// The line where it begins.
    chain_line: u32,
    /// For how many points of it memory is charged.
    charged: usize,
    dropped: Tally,
    repeated: Tally,
    collapsed: Tally,
    empty: Tally,
}

/// How often something was noticed, and in which feature first.
#[derive(Clone, Copy, Default)]
struct Tally {
    count: usize,
    feature: Option<usize>,
}

impl Tally {
    fn add(&mut self, count: usize, feature: Option<usize>) {
        if self.count == 0 && count > 0 {
            self.feature = feature;
        }
        self.count += count;
    }
}

/// What a polyline may be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Chain {
    /// Its ends may be anywhere.
    Open,
    /// It ends where it begins.
    Ring,
}

/// What was collected.
pub(super) struct Collected<S, T> {
    pub(super) surface: S,
    pub(super) items: Vec<T>,
    pub(super) places: PlaceList,
    pub(super) notes: Vec<CurveNote>,
}

/// A growing list takes up to twice the size of what it holds.
const GROWTH: u64 = 2;

impl<'b, S: Surface> Maker<'b, S> {
    const CURVE: u64 = GROWTH * (size_of::<S::Curve>() as u64 + 4);
    const POINT: u64 = size_of::<S::Point>() as u64;

    /// For a file of curves.
    pub(super) fn new(surface: S, budget: &'b mut Budget) -> Self {
        Self {
            surface,
            curves: Vec::new(),
            points: None,
            places: PlaceList::lines(),
            budget,
            feature: None,
            chain: Vec::new(),
            given: 0,
            chain_line: 0,
            charged: 0,
            dropped: Tally::default(),
            repeated: Tally::default(),
            collapsed: Tally::default(),
            empty: Tally::default(),
        }
    }

    /// For a file of points: other curves are refused.
    pub(super) fn of_points(surface: S, budget: &'b mut Budget) -> Self {
        Self { points: Some(Vec::new()), ..Self::new(surface, budget) }
    }

    pub(super) fn is_of_points(&self) -> bool {
        self.points.is_some()
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
        self.dropped.add(1, self.feature);
    }

    /// A geometry had no point.
    pub(super) fn count_empty(&mut self) {
        self.empty.add(1, self.feature);
    }

    /// Remembers which feature of a collection is read, from 0.
    pub(super) fn set_feature(&mut self, feature: Option<usize>) {
        self.feature = feature;
    }

    /// Adds an isolated point.
    pub(super) fn point(&mut self, point: S::Point, line: u32) -> Result<(), Located> {
        self.push(S::of_point(point), line)
    }

    /// Begins a polyline.
    pub(super) fn begin_chain(&mut self) {
        self.chain.clear();
        self.given = 0;
    }

    /// Appends a point to the polyline; where it repeats the last one, it is only counted.
    #[inline]
    pub(super) fn extend_chain(&mut self, point: S::Point, line: u32) -> Result<(), Located> {
        if self.given == 0 {
            self.chain_line = line;
        }
        self.given += 1;
        if let Some(last) = self.chain.last() {
            if *last == point {
                return Ok(());
            }
            if let Err(why) = S::check_step(last, &point) {
                return Err(Fault::Malformed { why: why.into() }.at(Place::Line(line)));
            }
        }
        if self.chain.len() == self.charged {
            self.budget.charge(GROWTH * Self::POINT).at_line(line)?;
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
            self.collapsed.add(1, self.feature);
            let point = self.chain.pop().expect("a polyline has a point");
            return self.point(point, line);
        }
        self.repeated.add(repeated, self.feature);
        self.budget.charge(Self::POINT * self.chain.len() as u64).at_line(line)?;
        let points = self.chain.drain(..).collect();
        self.push(S::of_chain(points), line)
    }

    /// Charges points that a curve keeps in a place of their own.
    pub(super) fn charge_points(&mut self, count: u64, line: u32) -> Result<(), Located> {
        self.budget.charge(Self::POINT * count).at_line(line)
    }

    #[inline]
    pub(super) fn push(&mut self, curve: S::Curve, line: u32) -> Result<(), Located> {
        self.budget.charge(Self::CURVE).at_line(line)?;
        if self.curves.len() >= u32::MAX as usize - 1 {
            let why = format!("more than {} curves; split the file", u32::MAX - 1);
            return Err(Fault::Malformed { why }.at(Place::Line(line)));
        }
        match &mut self.points {
            None => self.curves.push(curve),
            Some(points) => points.push(S::into_point(curve).map_err(|name| not_a_point(name, line))?),
        }
        self.places.push(Place::Line(line));
        Ok(())
    }

    /// Adds a point that stands in a line of its own, in a file of points: it takes less than a curve.
    #[inline]
    pub(super) fn bare_point(&mut self, point: S::Point, line: u32) -> Result<(), Located> {
        self.budget.charge(GROWTH * (Self::POINT + 4)).at_line(line)?;
        self.points.get_or_insert_default().push(point);
        self.places.push(Place::Line(line));
        Ok(())
    }

    pub(super) fn finish(self) -> Collected<S, S::Curve> {
        let mut notes = self.notes();
        notes.extend(self.curves.is_empty().then_some(CurveNote::NoCurves));
        Collected { surface: self.surface, items: self.curves, places: self.places, notes }
    }

    /// What a file of points has.
    pub(super) fn finish_points(self) -> Collected<S, S::Point> {
        let mut notes = self.notes();
        let points = self.points.unwrap_or_default();
        notes.extend(points.is_empty().then_some(CurveNote::NoPoints));
        Collected { surface: self.surface, items: points, places: self.places, notes }
    }

    fn notes(&self) -> Vec<CurveNote> {
        let made = |tally: Tally, note: fn(usize, Option<usize>) -> CurveNote| {
            (tally.count > 0).then(|| note(tally.count, tally.feature))
        };
        let of_empty: fn(usize, Option<usize>) -> CurveNote = match self.is_of_points() {
            false => |geometries, feature| CurveNote::EmptyGeometries { geometries, feature },
            true => |geometries, feature| CurveNote::EmptyPoints { geometries, feature },
        };
        let notes = [
            made(self.dropped, |points, feature| CurveNote::CoordinatesDropped { points, feature }),
            made(self.repeated, |points, feature| CurveNote::RepeatedPoints { points, feature }),
            made(self.collapsed, |polylines, feature| CurveNote::Collapsed { polylines, feature }),
            made(self.empty, of_empty),
        ];
        notes.into_iter().flatten().collect()
    }
}

#[cold]
fn not_a_point(name: &str, line: u32) -> Located {
    let why = format!("{name} in a file of points; remove it, or give the points that are asked about");
    Fault::Malformed { why }.at(Place::Line(line))
}

#[cold]
fn no_number(token: Token<'_>, fault: NumberFault) -> Located {
    if is_mark(token) {
        return token.unexpected("a coordinate");
    }
    token.fault(|token| Fault::BadNumber { token, fault })
}

/// Reads a coordinate or a period.
#[inline]
pub(super) fn number(token: Token<'_>) -> Result<Number, Located> {
    parse_number(token.bytes).map_err(|fault| no_number(token, fault))
}

/// Bits of integers that a point holds without an allocation.
const NARROW_BITS: u64 = 61;

/// Whether a point has this integer without an allocation.
#[inline]
pub(super) fn fits(integer: i64) -> bool {
    integer.unsigned_abs() >> NARROW_BITS == 0
}

/// What a point of three integers of so many bits takes on the heap at most: the integers, and the digits of those that are longer than two
/// machine words.
pub(super) fn heap_bytes(bits: [u64; 3]) -> u64 {
    if bits.iter().all(|&bits| bits <= NARROW_BITS) {
        return 0;
    }
    let digits = |bits: u64| if bits <= 128 { 0 } else { bits * 9 / 64 + 40 };
    96 + bits.into_iter().map(digits).sum::<u64>()
}

/// The bits of numerator and denominator.
pub(super) fn bits(number: &Rational) -> [u64; 2] {
    [number.numerator(), number.denominator()].map(|part| u64::from(part.bit_len()))
}
