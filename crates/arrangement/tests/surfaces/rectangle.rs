//! A closed rectangle: curves come to all of its sides, and run along them.

use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, Site, Topology};
use splitstar_arrangement::traits::{
    ArrangementTraits, BoundedTraits, ClosedBottomTopTraits, ClosedLeftRightTraits, CurveEnd, Location, Sides,
};
use splitstar_arrangement::wrappers::CountingTraits;
use splitstar_arrangement::{Arrangement, Counts};
use std::cmp::Ordering;

#[derive(Clone, Copy, Debug)]
struct Rectangle;

impl<G: ClosedLeftRightTraits + ClosedBottomTopTraits> Topology<G> for Rectangle {
    fn sides(&self) -> Sides {
        Sides::CLOSED
    }

    fn genus(&self) -> u32 {
        0
    }

    fn end_location(&self, _: &G, _: &G::UMonotoneCurve, _: CurveEnd) -> Location {
        Location::INTERIOR
    }

    fn point_location(&self, _: &G, _: &G::Point) -> Location {
        Location::INTERIOR
    }

    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        traits.compare_uv(a.point().unwrap(), b.point().unwrap())
    }
}

/// The counts in the rectangle; in the plane they are the same.
fn counts<G>(traits: impl Fn() -> G, curves: &[G::Curve]) -> Counts
where
    G: ArrangementTraits + BoundedTraits + ClosedLeftRightTraits + ClosedBottomTopTraits,
{
    let arrangement = Arrangement::of_curves(traits(), Rectangle, curves);
    assert_eq!(arrangement.check_valid(), []);
    let plane = Arrangement::of_curves(traits(), BoundedPlane, curves);
    assert_eq!(arrangement.counts(), plane.counts());
    arrangement.counts()
}

/// In the rectangle from (0, 0) to (4, 4): a part of each side, a curve from side to side, and one from corner to corner.
const CURVES: [[[i64; 2]; 2]; 6] = [
    [[0, 1], [0, 3]],
    [[4, 0], [4, 2]],
    [[1, 0], [3, 0]],
    [[0, 4], [4, 4]],
    [[0, 2], [4, 1]],
    [[0, 0], [4, 4]],
];

#[test]
fn curves_come_to_all_sides() {
    let segments = CURVES.map(|ends| Segment::from_i64(ends).unwrap());
    let of_segments = counts(|| SegmentTraits, &segments);
    // Of 12 ends, those at (4, 4) coincide; and two curves cross.
    assert_eq!((of_segments.vertices, of_segments.edges, of_segments.faces), (12, 10, 1));
    let minimal = CURVES.map(|ends| {
        let [p, q] = ends.map(Point2::from_i64);
        MinimalSegment::new(p, q).unwrap()
    });
    assert_eq!(counts(|| MinimalSegmentTraits, &minimal), of_segments);
    let traits = || PolycurveTraits::new(SegmentTraits);
    let chains = segments.map(|segment| traits().make_polycurve([segment]).unwrap());
    assert_eq!(counts(|| CountingTraits::new(traits()), &chains), of_segments);
}

#[test]
fn the_rim_separates_what_is_beyond() {
    let rim = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]].map(Point2::from_i64);
    let traits = || PolycurveTraits::new(SegmentTraits);
    let rim = traits().make_polyline(rim).unwrap();
    let diagonal = traits().make_polyline([[0, 0], [4, 4]].map(Point2::from_i64)).unwrap();
    let counts = counts(traits, &[rim, diagonal]);
    assert_eq!((counts.vertices, counts.edges, counts.faces), (2, 3, 3));
}
