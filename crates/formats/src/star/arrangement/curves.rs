//! The records of curves.

use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located};
use crate::base::number::Number;
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::base::words::read_coordinate;
use crate::star::line::Line;
use arrangement::models::polycurve::{Chain, PieceTraits, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, TorusSegment, TorusSegmentTraits};
use arrangement::traits::{ArrangementTraits, Piece};
use exact::planar::Point2;
use exact::{Rational, Sign};

/// The surface, and the curves on it.
#[derive(Debug)]
pub(super) enum Curves {
    Plane(List<Linear>),
    Torus(TorusSegmentTraits, List<TorusSegment>),
}

/// Curves as long as each is one piece, and then chains.
#[derive(Debug)]
pub(super) enum List<C> {
    Single(Vec<C>),
    Chains(Vec<Chain<C>>),
}

/// What a piece of this size takes in growing lists; that of a torus has two points on the heap.
const fn of_piece<C>() -> u64 {
    2 * (size_of::<C>() + size_of::<Point2>()) as u64
}

/// What it takes in a chain, and in that of a part of it.
const fn of_chained<C>() -> u64 {
    3 * (size_of::<C>() + size_of::<Point2>()) as u64
}

/// What it takes to put a piece into a chain, as long as that lasts.
const PUTTING_PIECE: u64 = 4 * (size_of::<TorusSegment>() + 2 * size_of::<Point2>()) as u64;
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

impl Curves {
    /// Reads what follows `surface`.
    pub(super) fn of_surface(line: &mut Line<'_>, budget: &mut Budget) -> Result<Self, Located> {
        const SURFACE: &str = "`plane` or `torus`";
        let word = line.expect(SURFACE)?;
        let curves = match word.bytes {
            b"plane" => Self::Plane(List::Single(Vec::new())),
            b"torus" => {
                let period = read_pair(line, budget, "one of two periods")?.map(Number::into_rational);
                let traits = TorusSegmentTraits::new(period);
                let traits = traits.map_err(|error| malformed(line.number, error.to_string()))?;
                Self::Torus(traits, List::Single(Vec::new()))
            }
            _ => return Err(word.unexpected(SURFACE)),
        };
        line.end()?;
        Ok(curves)
    }

    pub(super) fn traits_of_torus(&self) -> Option<&TorusSegmentTraits> {
        match self {
            Self::Torus(traits, _) => Some(traits),
            Self::Plane(_) => None,
        }
    }

    /// What the part of a curve for one edge takes, while edges are checked.
    pub(super) fn bytes_of_part(&self) -> u64 {
        match self {
            Self::Plane(list) => list.bytes_of_part(),
            Self::Torus(_, list) => list.bytes_of_part(),
        }
    }

    /// Reads what follows the number of a curve.
    pub(super) fn read(&mut self, line: &mut Line<'_>, budget: &mut Budget) -> Result<(), Located> {
        match self {
            Self::Torus(traits, list) => {
                let pieces = read_path(traits, line, budget)?;
                list.push(PolycurveTraits::new(traits.clone()), pieces, line.number, budget)
            }
            Self::Plane(list) => {
                const KINDS: &str = "`segment`, `ray`, `line` or `polyline`";
                let word = line.expect(KINDS)?;
                let pieces = match word.bytes {
                    b"polyline" => read_polyline(line, budget)?,
                    b"segment" | b"ray" | b"line" => vec![read_straight(word, line, budget)?],
                    _ => return Err(word.unexpected(KINDS)),
                };
                list.push(PolycurveTraits::new(LinearTraits), pieces, line.number, budget)
            }
        }
    }
}

impl<C: Clone> List<C> {
    fn bytes_of_part(&self) -> u64 {
        match self {
            Self::Single(_) => of_piece::<C>() / 2,
            Self::Chains(_) => of_chained::<C>(),
        }
    }

    /// Appends a curve of one piece or more, which must be one chain.
    fn push<S: PieceTraits<UMonotoneCurve = C>>(
        &mut self,
        traits: PolycurveTraits<S>,
        mut pieces: Vec<C>,
        line: u32,
        budget: &mut Budget,
    ) -> Result<(), Located> {
        if let Self::Single(curves) = self {
            if pieces.len() == 1 {
                budget.charge(of_piece::<C>()).at_line(line)?;
                curves.append(&mut pieces);
                return Ok(());
            }
            // Those that came before become chains.
            budget.charge((of_chained::<C>() + OF_CHAIN) * curves.len() as u64).at_line(line)?;
            let chains = std::mem::take(curves).into_iter();
            let chains = chains.map(|curve| chain_of(&traits, vec![curve]).expect("one piece is a chain"));
            *self = Self::Chains(chains.collect());
        }
        let Self::Chains(chains) = self else { unreachable!("the curves have become chains") };
        budget.charge(OF_CHAIN + of_chained::<C>() * pieces.len() as u64).at_line(line)?;
        chains.push(chain_of(&traits, pieces).ok_or_else(|| {
            let why = "the curve turns back in x, or is vertical in part only; cut it there into curves of their own";
            malformed(line, why.into())
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

pub(super) fn malformed(line: u32, why: String) -> Located {
    Fault::Malformed { why }.at(Place::Line(line))
}

fn read_straight(keyword: Token<'_>, line: &mut Line<'_>, budget: &mut Budget) -> Result<Linear, Located> {
    const COORDINATE: &str = "one of four coordinates";
    let p = make_point(read_pair(line, budget, COORDINATE)?);
    let q = make_point(read_pair(line, budget, COORDINATE)?);
    line.end()?;
    let curve = match keyword.bytes {
        b"segment" => Linear::segment(p, q),
        b"ray" => Linear::ray(p, &q),
        _ => Linear::line(&p, &q),
    };
    curve.ok_or_else(|| {
        let why = format!("both points of the {} are the same; give two different ones", keyword.shown());
        malformed(line.number, why)
    })
}

/// Reads what follows `polyline`.
fn read_polyline(line: &mut Line<'_>, budget: &mut Budget) -> Result<Vec<Linear>, Located> {
    let mut word = line.word();
    let mut from_infinity = None;
    if word.is_some_and(|word| word.bytes == b"infinity") {
        from_infinity = Some(read_direction(line, budget)?);
        word = line.word();
    }
    let mut points: Vec<Point2> = Vec::new();
    let mut to_infinity = None;
    while let Some(x) = word {
        if x.bytes == b"infinity" && !points.is_empty() {
            to_infinity = Some(read_direction(line, budget)?);
            line.end()?;
            break;
        }
        let y = line.expect("the second coordinate of the last point")?;
        check_room(points.len(), line, budget)?;
        points.push(make_point([read_number(x, budget)?, read_number(y, budget)?]));
        word = line.word();
    }
    let mut pieces = Vec::with_capacity(points.len() + 1);
    if let (Some(direction), Some(first)) = (from_infinity, points.first()) {
        pieces.push(Linear::ray(first.clone(), &first.translated(&direction)));
    }
    pieces.extend(points.windows(2).map(|pair| Linear::segment(pair[0].clone(), pair[1].clone())));
    if let (Some(direction), Some(last)) = (to_infinity, points.last()) {
        pieces.push(Linear::ray(last.clone(), &last.translated(&direction)));
    }
    if pieces.is_empty() {
        let why = "the polyline has no piece; give it two points, or a point and `infinity dx dy`".into();
        return Err(malformed(line.number, why));
    }
    pieces.into_iter().collect::<Option<Vec<Linear>>>().ok_or_else(|| {
        let why = "a point of the polyline is the same as the one before it; remove one".into();
        malformed(line.number, why)
    })
}

/// Whether so many pieces can be put into a chain.
fn check_room(pieces: usize, line: &Line<'_>, budget: &Budget) -> Result<(), Located> {
    if PUTTING_PIECE * pieces as u64 > budget.left() {
        return Err(budget.exceeded()).at_line(line.number);
    }
    Ok(())
}

/// Reads what follows `infinity`.
fn read_direction(line: &mut Line<'_>, budget: &mut Budget) -> Result<[Rational; 2], Located> {
    let direction =
        read_pair(line, budget, "one of two coordinates of a direction")?.map(Number::into_rational);
    if direction.iter().all(Rational::is_zero) {
        return Err(malformed(line.number, "the direction is zero; give one that is not".into()));
    }
    Ok(direction)
}

/// Reads a path: its pieces, one for each displacement.
fn read_path(
    traits: &TorusSegmentTraits,
    line: &mut Line<'_>,
    budget: &mut Budget,
) -> Result<Vec<TorusSegment>, Located> {
    const PATH: &str = "`path`, the only curve on a torus,";
    const LENGTH: &str = "one of two lengths along x and y";
    let word = line.expect(PATH)?;
    if word.bytes != b"path" {
        return Err(word.unexpected(PATH));
    }
    let mut start = read_torus_point(traits, line, budget)?;
    let mut pieces = Vec::new();
    let mut next = Some(line.expect(LENGTH)?);
    while let Some(dx) = next {
        check_room(pieces.len(), line, budget)?;
        let dx = read_number(dx, budget)?;
        let dy = read_number(line.expect(LENGTH)?, budget)?;
        let displacement = [dx, dy].map(Number::into_rational);
        pieces.push(path_piece(traits, &start, &displacement, line.number)?);
        next = line.word();
        if next.is_some() {
            start = traits.point(&start.translated(&displacement));
        }
    }
    Ok(pieces)
}

/// A path that must not leave the rectangle.
fn path_piece(
    traits: &TorusSegmentTraits,
    start: &Point2,
    displacement: &[Rational; 2],
    line: u32,
) -> Result<TorusSegment, Located> {
    let fits = displacement.iter().zip(traits.period()).all(|(length, period)| length.abs() <= *period);
    let mut pieces = Vec::new();
    if fits && let Ok(path) = traits.path(start, displacement) {
        traits.make_u_monotone(&path, &mut pieces);
    }
    match (pieces.pop(), pieces.is_empty()) {
        (Some(Piece::Curve { curve, .. }), true) => Ok(curve),
        (Some(Piece::Point(_)), _) => {
            Err(malformed(line, "a piece of the path has no length; remove it".into()))
        }
        _ => {
            let why = "the path leaves the rectangle of the periods; cut it there into paths of their own";
            Err(malformed(line, why.into()))
        }
    }
}

/// Reads a point, whose coordinates must be below the periods.
pub(super) fn read_torus_point(
    traits: &TorusSegmentTraits,
    line: &mut Line<'_>,
    budget: &mut Budget,
) -> Result<Point2, Located> {
    let point = read_pair(line, budget, "one of two coordinates")?.map(Number::into_rational);
    let is_below = |(value, period): (&Rational, &Rational)| value.sign() != Sign::Negative && value < period;
    if !point.iter().zip(traits.period()).all(is_below) {
        let why = "a coordinate is negative, or not below its period; add or subtract periods".into();
        return Err(malformed(line.number, why));
    }
    Ok(Point2::from_rationals(&point))
}
