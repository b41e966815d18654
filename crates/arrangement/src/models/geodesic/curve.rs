//! Arcs of great circles, whole ones, and points.

use exact::Quaternion;
use exact::spherical::{Direction, GreatCircle, is_antipodal, is_between, side_of_circle};
use std::error::Error;
use std::fmt;

/// A directed arc of a great circle with two different ends, a great circle, or a point.
///
/// It does not depend on the identification of the sphere.
///
/// ```
/// use exact::spherical::{Direction, GreatCircle};
/// use splitstar_arrangement::models::{Geodesic, GeodesicError};
/// let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| Direction::from_i64(p).expect("not zero"));
/// let quarter = Geodesic::arc(x.clone(), y.clone())?;
/// let rest = Geodesic::arc_via(x.clone(), &y.opposite(), y.clone())?;
/// assert_eq!(rest.great_circle(), quarter.great_circle().map(GreatCircle::opposite).as_ref());
/// // Antipodal ends need another point, or a circle.
/// assert_eq!(Geodesic::arc(x.clone(), x.opposite()), Err(GeodesicError::EndsAntipodal));
/// let over_the_pole = Geodesic::arc_via(x.clone(), &z, x.opposite())?;
/// assert_eq!(over_the_pole.source(), Some(&x));
/// # Ok::<(), GeodesicError>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Geodesic(Kind);

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Point(Direction),
    /// Without any end.
    Circle(GreatCircle),
    /// Counterclockwise around the normal of the circle. If the ends are equal, the whole circle, with a vertex.
    Arc {
        circle: GreatCircle,
        source: Direction,
        target: Direction,
    },
}

/// Why points are no geodesic arc.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum GeodesicError {
    /// The ends are equal, and no circle is given.
    EndsEqual,
    /// The ends are antipodal: the shorter arc is not defined.
    EndsAntipodal,
    /// The point between is an end, or not on a great circle with both.
    NotBetween,
    /// An end is not on the circle.
    NotOnCircle,
}

impl fmt::Display for GeodesicError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::EndsEqual => "the ends of the arc are the same point",
            Self::EndsAntipodal => {
                "the ends of the arc are antipodal: a point between them is needed, or a great circle"
            }
            Self::NotBetween => "the point between is an end, or not on a great circle with both ends",
            Self::NotOnCircle => "an end of the arc is not on its great circle",
        })
    }
}

impl Error for GeodesicError {}

impl Geodesic {
    /// Makes the shorter arc from one point to another.
    ///
    /// # Errors
    /// [`GeodesicError::EndsEqual`], [`GeodesicError::EndsAntipodal`].
    pub fn arc(source: Direction, target: Direction) -> Result<Self, GeodesicError> {
        match GreatCircle::through(&source, &target) {
            Some(circle) => Ok(Self(Kind::Arc { circle, source, target })),
            None if source == target => Err(GeodesicError::EndsEqual),
            None => Err(GeodesicError::EndsAntipodal),
        }
    }

    /// Makes the arc from one point to another that passes through a third: shorter or longer than half a circle, or just half of one.
    ///
    /// # Errors
    /// [`GeodesicError::EndsEqual`]; [`GeodesicError::NotBetween`] if the third point is one of the others, or not on a great circle with them.
    pub fn arc_via(source: Direction, via: &Direction, target: Direction) -> Result<Self, GeodesicError> {
        if source == target {
            return Err(GeodesicError::EndsEqual);
        }
        if *via == source || *via == target {
            return Err(GeodesicError::NotBetween);
        }
        // Via may be antipodal to the source; then the target is not.
        let circle = GreatCircle::through(&source, via)
            .or_else(|| GreatCircle::through(&source, &target))
            .filter(|circle| side_of_circle(&target, circle).is_zero());
        let circle = circle.ok_or(GeodesicError::NotBetween)?;
        let is_on_way = is_between(&circle, &source, via, &target);
        let circle = if is_on_way { circle } else { circle.opposite() };
        Ok(Self(Kind::Arc { circle, source, target }))
    }

    /// Makes the arc from one point to another counterclockwise around the normal of a great circle. If they are equal, it is the whole circle, and
    /// the point is a vertex.
    ///
    /// # Errors
    /// [`GeodesicError::NotOnCircle`].
    pub fn arc_around(
        source: Direction,
        target: Direction,
        circle: GreatCircle,
    ) -> Result<Self, GeodesicError> {
        let is_on_circle = [&source, &target].into_iter().all(|p| side_of_circle(p, &circle).is_zero());
        if is_on_circle {
            Ok(Self(Kind::Arc { circle, source, target }))
        } else {
            Err(GeodesicError::NotOnCircle)
        }
    }

    /// An arc whose ends are known to be on the circle.
    pub(super) fn along(source: Direction, target: Direction, circle: GreatCircle) -> Self {
        Self(Kind::Arc { circle, source, target })
    }

    /// Makes a whole great circle. It has no end, and no vertex of its own.
    pub fn circle(circle: GreatCircle) -> Self {
        Self(Kind::Circle(circle))
    }

    /// Makes a point.
    pub fn point(p: Direction) -> Self {
        Self(Kind::Point(p))
    }

    pub(super) fn kind(&self) -> &Kind {
        &self.0
    }

    /// The circle, run through in the direction of the arc; `None` for a point.
    pub fn great_circle(&self) -> Option<&GreatCircle> {
        match &self.0 {
            Kind::Point(_) => None,
            Kind::Circle(circle) | Kind::Arc { circle, .. } => Some(circle),
        }
    }

    /// The end at which the arc begins, or the point; `None` for a circle without ends.
    pub fn source(&self) -> Option<&Direction> {
        match &self.0 {
            Kind::Point(p) => Some(p),
            Kind::Circle(_) => None,
            Kind::Arc { source, .. } => Some(source),
        }
    }

    /// The end at which the arc stops, or the point; `None` for a circle without ends.
    pub fn target(&self) -> Option<&Direction> {
        match &self.0 {
            Kind::Point(p) => Some(p),
            Kind::Circle(_) => None,
            Kind::Arc { target, .. } => Some(target),
        }
    }

    /// The point, if it is one.
    pub fn as_point(&self) -> Option<&Direction> {
        match &self.0 {
            Kind::Point(p) => Some(p),
            _ => None,
        }
    }

    /// Tells whether this is a whole great circle, with a vertex or without.
    pub fn is_full(&self) -> bool {
        match &self.0 {
            Kind::Point(_) => false,
            Kind::Circle(_) => true,
            Kind::Arc { source, target, .. } => source == target,
        }
    }

    /// Tells whether it is longer than half a circle.
    pub fn is_long(&self) -> bool {
        match &self.0 {
            Kind::Point(_) => false,
            Kind::Circle(_) => true,
            Kind::Arc { circle, source, target } => {
                source == target
                    || (!is_antipodal(source, target)
                        && GreatCircle::through(source, target).as_ref() != Some(circle))
            }
        }
    }

    /// Gives the curve in the other direction.
    pub fn reversed(&self) -> Self {
        Self(match &self.0 {
            Kind::Point(p) => Kind::Point(p.clone()),
            Kind::Circle(circle) => Kind::Circle(circle.opposite()),
            Kind::Arc { circle, source, target } => {
                Kind::Arc { circle: circle.opposite(), source: target.clone(), target: source.clone() }
            }
        })
    }

    /// Gives the curve reflected through the center of the sphere.
    pub fn antipodal(&self) -> Self {
        self.mapped(GreatCircle::clone, Direction::opposite)
    }

    /// Gives the curve turned by a rotation.
    pub fn turned(&self, rotation: &Quaternion) -> Self {
        self.mapped(|circle| circle.turned(rotation), |p| p.turned(rotation))
    }

    fn mapped(
        &self,
        circle_of: impl Fn(&GreatCircle) -> GreatCircle,
        point_of: impl Fn(&Direction) -> Direction,
    ) -> Self {
        Self(match &self.0 {
            Kind::Point(p) => Kind::Point(point_of(p)),
            Kind::Circle(circle) => Kind::Circle(circle_of(circle)),
            Kind::Arc { circle, source, target } => {
                Kind::Arc { circle: circle_of(circle), source: point_of(source), target: point_of(target) }
            }
        })
    }
}
