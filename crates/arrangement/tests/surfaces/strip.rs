//! Segments in a strip, and the strip.

use exact::planar::{Point2, compare_x, compare_y};
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::{Site, SiteAt, Topology};
use splitstar_arrangement::traits::{
    Along, ApproxTraits, BasicTraits, BoundaryTraits, ClosedBottomTopTraits, ContractedBottomTopTraits,
    CurveEnd, IdentifiedLeftRightTraits, Intersection, LandmarkTraits, Location, Meeting, Multiplicity,
    NearBottomTopTraits, NearLeftRightTraits, OpenBottomTopTraits, SideKind, Sides, UMonotoneTraits, Window,
};
use std::cmp::Ordering;

/// The strip [0, width] x [0, height]. It is its own topology and the traits of segments in it.
///
/// Curves that `MEET_ONCE` or not are the same ones; the sweep does not know it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strip<const MEET_ONCE: bool> {
    pub(crate) size: [i64; 2],
    /// Bottom and top: open, closed or contracted.
    pub(crate) v: [SideKind; 2],
}

/// A segment in the closed strip; if it lies on the left or right side, on the left one.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) segment: Segment,
    pub(crate) locations: [Location; 2],
    /// The points of the ends, if they are points.
    points: [Option<Point2>; 2],
}

impl Piece {
    pub(crate) fn place(&self, end: CurveEnd) -> &Point2 {
        match end {
            CurveEnd::Min => self.segment.min(),
            CurveEnd::Max => self.segment.max(),
        }
    }

    fn is_along_left(&self) -> bool {
        self.locations.iter().all(|location| location.u == Along::Low)
    }

    fn is_only_on_right(&self) -> bool {
        self.locations[1].u == Along::High && self.locations[0].u != Along::Low
    }
}

impl<const MEET_ONCE: bool> Strip<MEET_ONCE> {
    /// Where a place in the closed strip is.
    pub(crate) fn location(&self, place: &Point2) -> Location {
        let along = |at: &Point2, compare: fn(&Point2, &Point2) -> Ordering| {
            if compare(at, &Point2::from_i64([0, 0])).is_eq() {
                Along::Low
            } else if compare(at, &Point2::from_i64(self.size)).is_eq() {
                Along::High
            } else {
                Along::Inside
            }
        };
        let v = match along(place, compare_y) {
            Along::Low if self.v[0] == SideKind::Closed => Along::Inside,
            Along::High if self.v[1] == SideKind::Closed => Along::Inside,
            v => v,
        };
        Location { u: along(place, compare_x), v }
    }

    /// The point that a contracted side is: one outside the strip, because none inside is like another.
    fn pole(&self, side: usize) -> Option<Point2> {
        let pole = Point2::from_i64([-1, [0, self.size[1]][side]]);
        (self.v[side] == SideKind::Contracted).then_some(pole)
    }

    pub(crate) fn point_of_place(&self, place: &Point2) -> Option<Point2> {
        match self.location(place) {
            Location { v: Along::Low, .. } => self.pole(0),
            Location { v: Along::High, .. } => self.pole(1),
            Location { u: Along::High, .. } => Some(place.translated(&[(-self.size[0]).into(), 0.into()])),
            _ => Some(place.clone()),
        }
    }

    pub(crate) fn is_on_seam(&self, p: &Point2) -> bool {
        compare_x(p, &Point2::from_i64([0, 0])).is_eq()
    }

    pub(crate) fn piece(&self, segment: Segment) -> Piece {
        let places = [segment.min(), segment.max()];
        let locations = places.map(|place| self.location(place));
        let points = places.map(|place| self.point_of_place(place));
        Piece { segment, locations, points }
    }

    fn places(&self, p: &Point2) -> Vec<Point2> {
        let mut places = vec![p.clone()];
        if self.is_on_left_right(p) {
            places.push(p.translated(&[self.size[0].into(), 0.into()]));
        }
        places
    }
}

impl<const MEET_ONCE: bool> BasicTraits for Strip<MEET_ONCE> {
    type Point = Point2;
    type UMonotoneCurve = Piece;

    const MEET_ONCE: bool = MEET_ONCE;
    const OVERLAPS_ARE_PLAIN: bool = MEET_ONCE;

    fn compare_u(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_x(p, q)
    }

    fn compare_uv(&self, p: &Point2, q: &Point2) -> Ordering {
        SegmentTraits.compare_uv(p, q)
    }

    fn end_point<'a>(&self, curve: &'a Piece, end: CurveEnd) -> Option<&'a Point2> {
        curve.points[end as usize].as_ref()
    }

    fn is_vertical(&self, curve: &Piece) -> bool {
        SegmentTraits.is_vertical(&curve.segment)
    }

    fn compare_v_at_u(&self, p: &Point2, curve: &Piece) -> Ordering {
        if curve.is_only_on_right() && self.is_on_left_right(p) {
            return compare_y(p, curve.place(CurveEnd::Max));
        }
        SegmentTraits.compare_v_at_u(p, &curve.segment)
    }

    fn compare_v_at_u_right(&self, a: &Piece, b: &Piece, p: &Point2) -> Ordering {
        SegmentTraits.compare_v_at_u_right(&a.segment, &b.segment, p)
    }

    fn compare_v_at_u_left(&self, a: &Piece, b: &Piece, p: &Point2) -> Ordering {
        SegmentTraits.compare_v_at_u_left(&a.segment, &b.segment, p)
    }

    fn is_in_u_range(&self, p: &Point2, curve: &Piece) -> bool {
        self.places(p).iter().any(|place| SegmentTraits.is_in_u_range(place, &curve.segment))
    }

    fn is_on_curve(&self, p: &Point2, curve: &Piece) -> bool {
        let is_end = curve.points.iter().flatten().any(|end| end == p);
        is_end || self.places(p).iter().any(|place| SegmentTraits.is_on_curve(place, &curve.segment))
    }
}

impl<const MEET_ONCE: bool> ApproxTraits for Strip<MEET_ONCE> {
    fn approx_point(&self, p: &Point2) -> [f64; 2] {
        p.approx_f64()
    }

    fn approx_curve(
        &self,
        curve: &Self::UMonotoneCurve,
        _: Option<&Point2>,
        _: Option<&Point2>,
        _: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        out.extend(CurveEnd::BOTH.map(|end| curve.place(end).approx_f64()));
    }
}

impl<const MEET_ONCE: bool> LandmarkTraits for Strip<MEET_ONCE> {
    fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Point2> {
        Point2::from_f64s(parameters).filter(|place| self.point_of_place(place).as_ref() == Some(place))
    }
}

impl<const MEET_ONCE: bool> UMonotoneTraits for Strip<MEET_ONCE> {
    fn intersect(&self, a: &Piece, b: &Piece, out: &mut Vec<Intersection<Point2, Piece>>) {
        let mut places = Vec::new();
        SegmentTraits.intersect(&a.segment, &b.segment, &mut places);
        let first = out.len();
        out.extend(places.into_iter().filter_map(|common| match common {
            // On a side that is no row of points, every end is by itself.
            Intersection::Point(place, _) if self.location(&place).v != Along::Inside => None,
            Intersection::Point(place, multiplicity) => {
                self.point_of_place(&place).map(|point| Intersection::Point(point, multiplicity))
            }
            Intersection::Overlap(segment) => Some(Intersection::Overlap(self.piece(segment))),
        }));
        for (curve, other) in [(a, b), (b, a)] {
            for point in curve.points.iter().flatten().filter(|point| self.is_on_left_right(point)) {
                let is_known = |common: &Intersection<Point2, Piece>| match common {
                    Intersection::Point(p, _) => p == point,
                    Intersection::Overlap(piece) => self.is_on_curve(point, piece),
                };
                if self.is_on_curve(point, other) && !out[first..].iter().any(is_known) {
                    out.push(Intersection::Point(point.clone(), Multiplicity::Unknown));
                }
            }
        }
        out[first..].sort_by(|x, y| {
            let [x, y] = [x, y].map(|common| match common {
                Intersection::Point(point, _) => point,
                Intersection::Overlap(piece) => piece.place(CurveEnd::Min),
            });
            self.compare_uv(x, y)
        });
    }

    fn split(&self, curve: &Piece, p: &Point2) -> [Piece; 2] {
        SegmentTraits.split(&curve.segment, p).map(|part| self.piece(part))
    }

    fn next_meeting(&self, below: &Piece, above: &Piece, window: Window<'_, Point2>) -> Meeting<Point2> {
        let first = [below, above][window.first_to_end];
        if window.until.is_none() && first.is_along_left() {
            return Meeting::Never;
        }
        let until = window.until.unwrap_or(first.place(CurveEnd::Max));
        let window = Window { until: Some(until), ..window };
        match SegmentTraits.next_meeting(&below.segment, &above.segment, window) {
            // On a side that is no row of points, every end is by itself.
            Meeting::AtEnd if self.location(until).v != Along::Inside => Meeting::Never,
            meeting => meeting,
        }
    }
}

impl<const MEET_ONCE: bool> BoundaryTraits for Strip<MEET_ONCE> {
    fn end_location(&self, curve: &Piece, end: CurveEnd) -> Location {
        curve.locations[end as usize]
    }
}

impl<const MEET_ONCE: bool> NearLeftRightTraits for Strip<MEET_ONCE> {
    /// Only ends in corners are asked for: the others are points.
    fn compare_v_near_side(&self, a: &Piece, b: &Piece, end: CurveEnd) -> Ordering {
        let corner = a.locations[end as usize];
        let by_slope = SegmentTraits.compare_v_at_u_right(&a.segment, &b.segment, a.place(end));
        match (corner, self.is_vertical(a), self.is_vertical(b)) {
            (Location { u: Along::High, .. }, ..) => by_slope.reverse(),
            // From the upper corner, the vertical goes straight down.
            (Location { v: Along::High, .. }, a, b) if a || b => b.cmp(&a),
            _ => by_slope,
        }
    }
}

impl<const MEET_ONCE: bool> Strip<MEET_ONCE> {
    /// From which side a curve comes to its end on the bottom or top: from the left, straight, or from the right.
    fn approach(&self, curve: &Piece, end: CurveEnd) -> i32 {
        match (self.is_vertical(curve), end) {
            (true, _) => 0,
            (false, CurveEnd::Max) => -1,
            (false, CurveEnd::Min) => 1,
        }
    }
}

impl<const MEET_ONCE: bool> NearBottomTopTraits for Strip<MEET_ONCE> {
    fn compare_u_near_end(&self, p: &Point2, curve: &Piece, end: CurveEnd) -> Ordering {
        compare_x(p, curve.place(end)).then(0.cmp(&self.approach(curve, end)))
    }

    fn compare_u_of_ends(&self, (a, end_a): (&Piece, CurveEnd), (b, end_b): (&Piece, CurveEnd)) -> Ordering {
        let by_place = compare_x(a.place(end_a), b.place(end_b));
        let by_approach = || self.approach(a, end_a).cmp(&self.approach(b, end_b));
        let [low_a, low_b] =
            [(a, end_a), (b, end_b)].map(|(c, end)| c.locations[end as usize].v == Along::Low);
        by_place.then_with(by_approach).then_with(|| {
            let by_slope = SegmentTraits.compare_v_at_u_right(&a.segment, &b.segment, a.place(end_a));
            match (low_a, low_b) {
                // The flatter, the further from the place near the bottom.
                (true, true) => by_slope.reverse(),
                (false, false) => by_slope,
                _ => Ordering::Equal,
            }
        })
    }
}

impl<const MEET_ONCE: bool> ClosedBottomTopTraits for Strip<MEET_ONCE> {}
impl<const MEET_ONCE: bool> OpenBottomTopTraits for Strip<MEET_ONCE> {}
impl<const MEET_ONCE: bool> ContractedBottomTopTraits for Strip<MEET_ONCE> {
    fn contraction_bottom_top(&self, side: CurveEnd) -> Point2 {
        self.pole(side as usize).expect("the side is contracted")
    }
}

impl<const MEET_ONCE: bool> IdentifiedLeftRightTraits for Strip<MEET_ONCE> {
    fn is_on_left_right(&self, p: &Point2) -> bool {
        self.is_on_seam(p)
    }

    fn compare_v_on_left_right(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_y(p, q)
    }
}

/// A cylinder or a sphere, by the kinds of bottom and top.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Band(pub(crate) [SideKind; 2]);

impl<G> Topology<G> for Band
where
    G: IdentifiedLeftRightTraits
        + NearLeftRightTraits
        + ClosedBottomTopTraits
        + OpenBottomTopTraits
        + ContractedBottomTopTraits,
{
    fn sides(&self) -> Sides {
        Sides { u: [SideKind::Identified; 2], v: self.0 }
    }

    fn genus(&self) -> u32 {
        0
    }

    fn end_location(&self, traits: &G, curve: &G::UMonotoneCurve, end: CurveEnd) -> Location {
        traits.end_location(curve, end)
    }

    fn point_location(&self, traits: &G, point: &G::Point) -> Location {
        let u = if traits.is_on_left_right(point) { Along::Low } else { Along::Inside };
        Location { u, v: Along::Inside }
    }

    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let (here, there) = (a.location, b.location);
        if here.u != there.u {
            return here.u.cmp(&there.u);
        }
        if here.u != Along::Inside {
            // Ends without a point are in the corners.
            return here.v.cmp(&there.v).then_with(|| match (a.at, b.at) {
                (SiteAt::Point(p), SiteAt::Point(q)) => traits.compare_v_on_left_right(p, q),
                (SiteAt::End(curve_a, end), SiteAt::End(curve_b, _)) => {
                    traits.compare_v_near_side(curve_a, curve_b, end)
                }
                _ => unreachable!("a corner is no point"),
            });
        }
        let by_u = match (a.at, b.at) {
            (SiteAt::Point(p), SiteAt::Point(q)) => return traits.compare_uv(p, q),
            (SiteAt::Point(p), SiteAt::End(curve, end)) => traits.compare_u_near_end(p, curve, end),
            (SiteAt::End(curve, end), SiteAt::Point(p)) => traits.compare_u_near_end(p, curve, end).reverse(),
            (SiteAt::End(curve_a, end_a), SiteAt::End(curve_b, end_b)) => {
                traits.compare_u_of_ends((curve_a, end_a), (curve_b, end_b))
            }
        };
        by_u.then_with(|| here.v.cmp(&there.v))
    }
}
