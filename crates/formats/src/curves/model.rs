//! The curves of a file.

use crate::base::places::PlaceList;
use exact::Rational;
use exact::planar::Point2;
use exact::spherical::{Direction, GreatCircle};
use std::fmt;

/// A point of the plane, as arrangements take it.
pub type CurvePoint = Point2;

/// A curve as it is given to an arrangement.
///
/// What [`read_curves`](crate::read_curves) gives is not degenerate: points that follow each other are different.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum InputCurve {
    /// The segment between two points. On a torus the straight path from the first to the second in the universal
    /// cover, so that its ends may be the same point there.
    Segment([CurvePoint; 2]),
    /// The ray from the first point through the second.
    Ray([CurvePoint; 2]),
    /// The line through two points.
    Line([CurvePoint; 2]),
    /// Segments one after the other, through two points or more.
    Polyline(Vec<CurvePoint>),
    /// An isolated point.
    Point(CurvePoint),
}

/// A curve on the sphere as it is given to an arrangement: an arc of a great circle, or several of them.
///
/// What [`read_sphere_curves`](crate::read_sphere_curves) gives has a place in an arrangement: arcs are defined, and points that follow
/// each other in a polyline are different and not antipodal.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum SphereCurve {
    /// The shorter arc between two points.
    Arc([Direction; 2]),
    /// The arc from the first point through the second to the third. It may be longer than half a circle.
    ArcVia(Box<[Direction; 3]>),
    /// A great circle.
    Circle(GreatCircle),
    /// Arcs one after the other, through two points or more; each is the shorter one.
    Polyline(Vec<Direction>),
    /// An isolated point.
    Point(Direction),
}

/// What a file of curves says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct CurveFile {
    /// The curves, in the order of the file.
    pub curves: Vec<InputCurve>,
    /// The line of each curve. A geometry that has several curves gives to each the line where its coordinates begin.
    pub places: PlaceList,
    /// The periods of the torus in u and v, both positive, if the file is one of a torus.
    pub period: Option<[Rational; 2]>,
    /// What of the file is not in the curves.
    pub notes: Vec<CurveNote>,
}

/// What a file of points says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PointFile {
    /// The points, in the order of the file.
    pub points: Vec<CurvePoint>,
    /// The line of each point.
    pub places: PlaceList,
    /// The periods of the torus in u and v, both positive, if the file is one of a torus.
    pub period: Option<[Rational; 2]>,
    /// What of the file is not in the points.
    pub notes: Vec<CurveNote>,
}

/// What a file of curves on the sphere says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SphereCurveFile {
    /// The curves, in the order of the file.
    pub curves: Vec<SphereCurve>,
    /// The line of each curve. A geometry that has several curves gives to each the line where its coordinates begin.
    pub places: PlaceList,
    /// What of the file is not in the curves.
    pub notes: Vec<CurveNote>,
}

/// What a file of points on the sphere says.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SpherePointFile {
    /// The points, in the order of the file.
    pub points: Vec<Direction>,
    /// The line of each point.
    pub places: PlaceList,
    /// What of the file is not in the points.
    pub notes: Vec<CurveNote>,
}

/// What was changed or left out, because it means nothing for curves.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum CurveNote {
    /// Altitudes and measures of WKT and GeoJSON were left out.
    CoordinatesDropped {
        /// The number of points that had any.
        points: usize,
        /// The feature of a collection where the first one is, from 0.
        feature: Option<usize>,
    },
    /// Points of a polyline that are the same as the point before them were left out.
    RepeatedPoints {
        /// The number of points left out.
        points: usize,
        /// The feature of a collection where the first one is, from 0.
        feature: Option<usize>,
    },
    /// Polylines all of whose points are the same became points.
    Collapsed {
        /// The number of such polylines.
        polylines: usize,
        /// The feature of a collection where the first one is, from 0.
        feature: Option<usize>,
    },
    /// Geometries of WKT and GeoJSON had no coordinates.
    EmptyGeometries {
        /// The number of such geometries.
        geometries: usize,
        /// The feature of a collection where the first one is, from 0.
        feature: Option<usize>,
    },
    /// Geometries of WKT and GeoJSON in a file of points had no coordinates.
    EmptyPoints {
        /// The number of such geometries.
        geometries: usize,
        /// The feature of a collection where the first one is, from 0.
        feature: Option<usize>,
    },
    /// The file has no curve.
    NoCurves,
    /// The file, which is one of points, has none.
    NoPoints,
}

impl fmt::Display for CurveNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (count, feature, [one, many]) = match *self {
            Self::CoordinatesDropped { points, feature } => (
                points,
                feature,
                [
                    "point has more than two coordinates: the others are left out",
                    "points have more than two coordinates: the others are left out",
                ],
            ),
            Self::RepeatedPoints { points, feature } => (
                points,
                feature,
                [
                    "point of a polyline is the same as the one before it: left out",
                    "points of polylines are the same as the ones before them: left out",
                ],
            ),
            Self::Collapsed { polylines, feature } => (
                polylines,
                feature,
                [
                    "polyline has only one point, several times: it is read as a point",
                    "polylines have only one point, several times: they are read as points",
                ],
            ),
            Self::EmptyGeometries { geometries, feature } => (
                geometries,
                feature,
                ["geometry is empty: it has no curve", "geometries are empty: they have no curve"],
            ),
            Self::EmptyPoints { geometries, feature } => (
                geometries,
                feature,
                [
                    "geometry is empty: it has no point, and gets no answer",
                    "geometries are empty: they have no point, and get no answer",
                ],
            ),
            Self::NoCurves => return f.write_str("the file has no curve"),
            Self::NoPoints => return f.write_str("the file has no point"),
        };
        write!(f, "{count} {}", if count == 1 { one } else { many })?;
        match feature {
            Some(feature) if count == 1 => write!(f, " (in feature {feature}, counted from 0)"),
            Some(feature) => write!(f, " (the first in feature {feature}, counted from 0)"),
            None => Ok(()),
        }
    }
}
