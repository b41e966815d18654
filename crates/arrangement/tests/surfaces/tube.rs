//! Strips with u and v exchanged: bottom and top are glued, left and right are open or contracted.

use crate::paths::Curve;
use crate::strip::{Piece as StripPiece, Strip};
use exact::planar::{Point2, compare_y};
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::{Site, SiteAt, Topology};
use splitstar_arrangement::traits::{
    Along, ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, ContractedLeftRightTraits, CurveEnd,
    IdentifiedBottomTopTraits, Intersection, LandmarkTraits, Location, Meeting, Multiplicity,
    NearLeftRightTraits, OpenLeftRightTraits, Piece, SideKind, Sides, UMonotoneTraits, Window,
};
use std::cmp::Ordering;

/// The segments of a strip, mirrored at the diagonal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transposed {
    pub(crate) strip: Strip<true>,
}

/// A segment between places in the closed rectangle.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) segment: Segment,
    locations: [Location; 2],
    points: [Option<Point2>; 2],
}

fn transposed(p: &Point2) -> Point2 {
    let [u, v] = p.coordinates();
    Point2::from_rationals(&[v, u])
}

impl Transposed {
    fn part(&self, segment: Segment) -> Part {
        let places = [segment.min(), segment.max()].map(transposed);
        let locations = places.each_ref().map(|place| {
            let Location { u, v } = self.strip.location(place);
            Location { u: v, v: u }
        });
        let points = places.each_ref().map(|p| self.strip.point_of_place(p).map(|p| transposed(&p)));
        Part { segment, locations, points }
    }

    fn height(&self) -> i64 {
        self.strip.size[0]
    }

    fn places(&self, p: &Point2) -> Vec<Point2> {
        let mut places = vec![p.clone()];
        if self.is_on_bottom_top(p) {
            places.push(p.translated(&[0.into(), self.height().into()]));
        }
        places
    }
}

impl Part {
    fn place(&self, end: CurveEnd) -> &Point2 {
        [self.segment.min(), self.segment.max()][end as usize]
    }
}

impl BasicTraits for Transposed {
    type Point = Point2;
    type UMonotoneCurve = Part;

    const MEET_ONCE: bool = true;
    const OVERLAPS_ARE_PLAIN: bool = true;

    fn compare_u(&self, p: &Point2, q: &Point2) -> Ordering {
        SegmentTraits.compare_u(p, q)
    }

    fn compare_uv(&self, p: &Point2, q: &Point2) -> Ordering {
        SegmentTraits.compare_uv(p, q)
    }

    fn end_point<'a>(&self, curve: &'a Part, end: CurveEnd) -> Option<&'a Point2> {
        curve.points[end as usize].as_ref()
    }

    fn is_vertical(&self, curve: &Part) -> bool {
        SegmentTraits.is_vertical(&curve.segment)
    }

    fn compare_v_at_u(&self, p: &Point2, curve: &Part) -> Ordering {
        SegmentTraits.compare_v_at_u(p, &curve.segment)
    }

    fn compare_v_at_u_right(&self, a: &Part, b: &Part, p: &Point2) -> Ordering {
        SegmentTraits.compare_v_at_u_right(&a.segment, &b.segment, p)
    }

    fn compare_v_at_u_left(&self, a: &Part, b: &Part, p: &Point2) -> Ordering {
        SegmentTraits.compare_v_at_u_left(&a.segment, &b.segment, p)
    }

    fn is_in_u_range(&self, p: &Point2, curve: &Part) -> bool {
        SegmentTraits.is_in_u_range(p, &curve.segment)
    }

    fn is_on_curve(&self, p: &Point2, curve: &Part) -> bool {
        let is_end = curve.points.iter().flatten().any(|end| end == p);
        is_end || self.places(p).iter().any(|place| SegmentTraits.is_on_curve(place, &curve.segment))
    }
}

impl UMonotoneTraits for Transposed {
    fn intersect(&self, a: &Part, b: &Part, out: &mut Vec<Intersection<Point2, Part>>) {
        let mut places = Vec::new();
        SegmentTraits.intersect(&a.segment, &b.segment, &mut places);
        let first = out.len();
        out.extend(places.into_iter().filter_map(|common| match common {
            Intersection::Point(place, multiplicity) => {
                let point = self.strip.point_of_place(&transposed(&place))?;
                Some(Intersection::Point(transposed(&point), multiplicity))
            }
            Intersection::Overlap(segment) => Some(Intersection::Overlap(self.part(segment))),
        }));
        for (curve, other) in [(a, b), (b, a)] {
            for point in curve.points.iter().flatten().filter(|point| self.is_on_bottom_top(point)) {
                let is_known = |common: &Intersection<Point2, Part>| match common {
                    Intersection::Point(p, _) => p == point,
                    Intersection::Overlap(part) => self.is_on_curve(point, part),
                };
                if self.is_on_curve(point, other) && !out[first..].iter().any(is_known) {
                    out.push(Intersection::Point(point.clone(), Multiplicity::Unknown));
                }
            }
        }
        out[first..].sort_by(|x, y| {
            let [x, y] = [x, y].map(|common| match common {
                Intersection::Point(point, _) => point,
                Intersection::Overlap(part) => part.place(CurveEnd::Min),
            });
            self.compare_uv(x, y)
        });
    }

    fn split(&self, curve: &Part, p: &Point2) -> [Part; 2] {
        SegmentTraits.split(&curve.segment, p).map(|part| self.part(part))
    }

    fn next_meeting(&self, below: &Part, above: &Part, window: Window<'_, Point2>) -> Meeting<Point2> {
        let first = [below, above][window.first_to_end];
        let is_along_bottom = first.locations.iter().all(|location| location.v == Along::Low);
        if window.until.is_none() && is_along_bottom {
            return Meeting::Never;
        }
        let until = window.until.unwrap_or(first.place(CurveEnd::Max));
        match SegmentTraits.next_meeting(
            &below.segment,
            &above.segment,
            Window { until: Some(until), ..window },
        ) {
            Meeting::AtEnd if self.strip.location(&transposed(until)).v != Along::Inside => Meeting::Never,
            meeting => meeting,
        }
    }
}

impl ArrangementTraits for Transposed {
    type Curve = Curve;

    fn make_u_monotone(&self, curve: &Curve, out: &mut Vec<Piece<Point2, Part>>) {
        let mut pieces: Vec<Piece<Point2, StripPiece>> = Vec::new();
        self.strip.make_u_monotone(curve, &mut pieces);
        out.extend(pieces.into_iter().map(|piece| match piece {
            Piece::Point(point) => Piece::Point(transposed(&point)),
            Piece::Curve { curve, is_artificial: [min, max] } => {
                let places = CurveEnd::BOTH.map(|end| transposed(curve.place(end)));
                let is_turned = self.compare_uv(&places[0], &places[1]).is_gt();
                let [source, target] = places;
                let segment = Segment::new(source, target).unwrap();
                let is_artificial = if is_turned { [max, min] } else { [min, max] };
                Piece::Curve { curve: self.part(segment), is_artificial }
            }
        }));
    }
}

impl ApproxTraits for Transposed {
    fn approx_point(&self, p: &Point2) -> [f64; 2] {
        p.approx_f64()
    }

    fn approx_curve(
        &self,
        curve: &Part,
        _: Option<&Point2>,
        _: Option<&Point2>,
        _: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        out.extend(CurveEnd::BOTH.map(|end| curve.place(end).approx_f64()));
    }
}

impl LandmarkTraits for Transposed {
    fn approx_to_point(&self, [u, v]: [f64; 2]) -> Option<Point2> {
        self.strip.approx_to_point([v, u]).map(|p| transposed(&p))
    }
}

impl BoundaryTraits for Transposed {
    fn end_location(&self, curve: &Part, end: CurveEnd) -> Location {
        curve.locations[end as usize]
    }
}

impl NearLeftRightTraits for Transposed {
    fn compare_v_near_side(&self, a: &Part, b: &Part, end: CurveEnd) -> Ordering {
        compare_y(a.place(end), b.place(end)).then_with(|| {
            let by_slope = SegmentTraits.compare_v_at_u_right(&a.segment, &b.segment, a.place(end));
            if end == CurveEnd::Min { by_slope } else { by_slope.reverse() }
        })
    }
}

impl OpenLeftRightTraits for Transposed {}
impl ContractedLeftRightTraits for Transposed {}

impl IdentifiedBottomTopTraits for Transposed {
    fn is_on_bottom_top(&self, p: &Point2) -> bool {
        self.strip.is_on_seam(&transposed(p))
    }

    fn compare_u_on_bottom_top(&self, p: &Point2, q: &Point2) -> Ordering {
        self.compare_u(p, q)
    }
}

/// A cylinder that lies, or a sphere, by the kinds of left and right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tube(pub(crate) [SideKind; 2]);

impl<G: OpenLeftRightTraits + ContractedLeftRightTraits + IdentifiedBottomTopTraits> Topology<G> for Tube {
    fn sides(&self) -> Sides {
        Sides { u: self.0, v: [SideKind::Identified; 2] }
    }

    fn genus(&self) -> u32 {
        0
    }

    fn end_location(&self, traits: &G, curve: &G::UMonotoneCurve, end: CurveEnd) -> Location {
        traits.end_location(curve, end)
    }

    fn point_location(&self, traits: &G, point: &G::Point) -> Location {
        let v = if traits.is_on_bottom_top(point) { Along::Low } else { Along::Inside };
        Location { u: Along::Inside, v }
    }

    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let (here, there) = (a.location, b.location);
        here.u.cmp(&there.u).then_with(|| match (a.at, b.at) {
            (SiteAt::End(curve_a, end), SiteAt::End(curve_b, _)) => {
                traits.compare_v_near_side(curve_a, curve_b, end)
            }
            (SiteAt::Point(p), SiteAt::Point(q)) => {
                let by_side = || here.v.cmp(&there.v);
                let by_v = || if here.v == Along::Inside { traits.compare_uv(p, q) } else { Ordering::Equal };
                traits.compare_u(p, q).then_with(by_side).then_with(by_v)
            }
            _ => unreachable!("no point is on a side that is not glued"),
        })
    }
}
