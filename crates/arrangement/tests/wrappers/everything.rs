//! A model that has every refinement and overrides every method: points and curves are numbers, and every method has an answer of
//! its own, which a forgotten method of a wrapper would not give.

use splitstar_arrangement::models::polycurve::{ConnectTraits, PieceTraits};
use splitstar_arrangement::traits::*;
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// A curve is a number, and has its neighbours as ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Line(pub(crate) [i32; 2]);

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Everything;

impl BasicTraits for Everything {
    type Point = i32;
    type UMonotoneCurve = Line;

    const MEET_ONCE: bool = true;

    fn order_key(&self, p: &i32) -> u64 {
        u64::from(p.unsigned_abs())
    }

    fn order_range(&self, p: &i32) -> (u64, u32) {
        (u64::from(p.unsigned_abs()), 81)
    }

    fn side_key(&self, curve: &Line) -> [u32; 3] {
        [82, curve.0[0].unsigned_abs(), curve.0[1].unsigned_abs()]
    }

    fn compare_v_at_u_by_key(&self, p: &i32, key: &[u32; 3]) -> Option<Ordering> {
        (*p == 83 && *key == [1, 2, 84]).then_some(Greater)
    }

    fn compare_u(&self, p: &i32, q: &i32) -> Ordering {
        p.cmp(q)
    }

    fn compare_uv(&self, p: &i32, q: &i32) -> Ordering {
        q.cmp(p)
    }

    fn is_canonical(&self, p: &i32) -> bool {
        *p == 79
    }

    fn is_own_curve(&self, curve: &Line) -> bool {
        curve.0[0] == 2
    }

    fn end_point<'a>(&self, curve: &'a Line, end: CurveEnd) -> Option<&'a i32> {
        Some(&curve.0[end as usize])
    }

    fn is_vertical(&self, _: &Line) -> bool {
        true
    }

    fn compare_v_at_u(&self, _: &i32, _: &Line) -> Ordering {
        Less
    }

    fn compare_v_at_u_right(&self, _: &Line, _: &Line, _: &i32) -> Ordering {
        Greater
    }

    fn compare_v_at_u_left(&self, _: &Line, _: &Line, _: &i32) -> Ordering {
        Less
    }

    // Not what the provided versions say.
    fn is_same_point(&self, p: &i32, q: &i32) -> bool {
        p != q
    }

    fn is_in_u_range(&self, p: &i32, _: &Line) -> bool {
        *p == 77
    }

    fn is_on_curve(&self, p: &i32, _: &Line) -> bool {
        *p == 78
    }
}

impl UMonotoneTraits for Everything {
    fn intersect(&self, a: &Line, _: &Line, out: &mut Vec<Intersection<i32, Line>>) {
        out.push(Intersection::Point(7, Multiplicity::Even));
        out.push(Intersection::Overlap(a.clone()));
    }

    fn split(&self, curve: &Line, p: &i32) -> [Line; 2] {
        [Line([curve.0[0], *p]), Line([*p, curve.0[1]])]
    }

    fn merge(&self, a: &Line, b: &Line) -> Option<Line> {
        Some(Line([a.0[0], b.0[1]]))
    }

    fn is_mergeable(&self, a: &Line, _: &Line) -> bool {
        a.0[0] == 1
    }

    fn next_meeting(&self, _: &Line, _: &Line, window: Window<'_, i32>) -> Meeting<i32> {
        Meeting::At(window.until.copied().unwrap_or(0) + 100, Multiplicity::Even)
    }

    fn end_of_overlap(&self, a: &Line, _: &Line, p: Option<&i32>) -> Option<i32> {
        p.map(|p| p + 200 + a.0[0])
    }

    fn trim(&self, _: &Line, _: Option<&i32>, _: Option<&i32>) -> Line {
        Line([55, 66])
    }
}

impl ArrangementTraits for Everything {
    type Curve = i32;

    fn make_u_monotone(&self, curve: &i32, out: &mut Vec<Piece<i32, Line>>) {
        out.push(Piece::Curve { curve: Line([*curve, 9]), is_artificial: [true, false] });
        out.push(Piece::Point(*curve));
    }
}

impl DirectionalTraits for Everything {
    fn is_directed_right(&self, _: &Line) -> bool {
        true
    }

    fn opposite(&self, curve: &Line) -> Line {
        Line([curve.0[1], curve.0[0]])
    }

    fn source<'a>(&self, curve: &'a Line) -> Option<&'a i32> {
        Some(&curve.0[1])
    }

    fn target<'a>(&self, _: &'a Line) -> Option<&'a i32> {
        None
    }
}

impl ApproxTraits for Everything {
    fn approx_point(&self, p: &i32) -> [f64; 2] {
        [f64::from(*p), 0.5]
    }

    fn approx_curve(
        &self,
        curve: &Line,
        _: Option<&i32>,
        _: Option<&i32>,
        window: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        out.push([f64::from(curve.0[0]), window[3]]);
    }
}

impl LandmarkTraits for Everything {
    fn approx_to_point(&self, [u, _]: [f64; 2]) -> Option<i32> {
        (u > 0.5).then_some(6)
    }
}

impl BoundaryTraits for Everything {
    fn end_location(&self, _: &Line, end: CurveEnd) -> Location {
        Location { u: Along::High, v: if end == CurveEnd::Min { Along::Low } else { Along::Inside } }
    }
}

impl NearLeftRightTraits for Everything {
    fn compare_v_near_side(&self, _: &Line, _: &Line, _: CurveEnd) -> Ordering {
        Greater
    }
}

impl NearBottomTopTraits for Everything {
    fn compare_u_near_end(&self, _: &i32, _: &Line, _: CurveEnd) -> Ordering {
        Greater
    }

    fn compare_u_of_ends(&self, a: (&Line, CurveEnd), b: (&Line, CurveEnd)) -> Ordering {
        a.0.0.cmp(&b.0.0).then(a.1.cmp(&b.1))
    }
}

impl IdentifiedLeftRightTraits for Everything {
    fn is_on_left_right(&self, p: &i32) -> bool {
        *p == 1
    }

    fn compare_v_on_left_right(&self, _: &i32, _: &i32) -> Ordering {
        Less
    }
}

impl IdentifiedBottomTopTraits for Everything {
    fn is_on_bottom_top(&self, p: &i32) -> bool {
        *p == 2
    }

    fn compare_u_on_bottom_top(&self, _: &i32, _: &i32) -> Ordering {
        Equal
    }
}

impl PieceTraits for Everything {
    fn is_joint_allowed(&self, p: &i32) -> bool {
        *p == 3
    }

    fn is_foldback_on_side(&self, a: &Line, b: &Line, end: CurveEnd) -> bool {
        a == b && end == CurveEnd::Max
    }

    fn compare_u_to_end(&self, p: &i32, curve: &Line, end: CurveEnd) -> Option<Ordering> {
        (curve.0[0] == 1 || end == CurveEnd::Max).then(|| p.cmp(&85))
    }

    fn direction(&self, curve: &Line) -> Option<bool> {
        Some(curve.0[0] < curve.0[1])
    }
}

impl ConnectTraits for Everything {
    fn connect(&self, source: &i32, target: &i32, out: &mut Vec<Piece<i32, Line>>) {
        out.push(Piece::Curve { curve: Line([*source, *target]), is_artificial: [false; 2] });
    }
}

impl BoundedTraits for Everything {}
impl ClosedLeftRightTraits for Everything {}
impl ClosedBottomTopTraits for Everything {}
impl OpenLeftRightTraits for Everything {}
impl OpenBottomTopTraits for Everything {}
impl ContractedLeftRightTraits for Everything {}

impl ContractedBottomTopTraits for Everything {
    fn contraction_bottom_top(&self, side: CurveEnd) -> i32 {
        20 + side as i32
    }
}

/// What a model with every refinement is.
pub(crate) trait All:
    ArrangementTraits
    + DirectionalTraits
    + ApproxTraits
    + LandmarkTraits
    + BoundedTraits
    + ClosedLeftRightTraits
    + ClosedBottomTopTraits
    + OpenLeftRightTraits
    + OpenBottomTopTraits
    + ContractedLeftRightTraits
    + ContractedBottomTopTraits
    + IdentifiedLeftRightTraits
    + IdentifiedBottomTopTraits
    + PieceTraits
{
}

impl<G> All for G where
    G: ArrangementTraits
        + DirectionalTraits
        + ApproxTraits
        + LandmarkTraits
        + BoundedTraits
        + ClosedLeftRightTraits
        + ClosedBottomTopTraits
        + OpenLeftRightTraits
        + OpenBottomTopTraits
        + ContractedLeftRightTraits
        + ContractedBottomTopTraits
        + IdentifiedLeftRightTraits
        + IdentifiedBottomTopTraits
        + PieceTraits
{
}

/// Calls each method of all traits but `ConnectTraits` once, and tells the answers as text. `bare` is the text of a curve without
/// what a wrapper puts around it.
pub(crate) fn call_each<G: All<Point = i32>>(
    traits: &G,
    curve: &G::Curve,
    a: &G::UMonotoneCurve,
    b: &G::UMonotoneCurve,
    bare: impl Fn(&G::UMonotoneCurve) -> String,
) -> Vec<String> {
    let mut text = vec![
        format!("{:?}", G::MEET_ONCE),
        format!("{:?}", traits.compare_u(&1, &2)),
        format!("{:?}", traits.order_key(&3)),
        format!("{:?}", traits.order_range(&3)),
        format!("{:?}", traits.side_key(a)),
        format!("{:?}", traits.compare_v_at_u_by_key(&83, &[1, 2, 84])),
        format!("{:?}", traits.compare_uv(&1, &2)),
        format!("{:?}", traits.is_canonical(&79)),
        format!("{:?}", traits.is_own_curve(a)),
        format!("{:?}", traits.end_point(a, CurveEnd::Max)),
        format!("{:?}", traits.is_vertical(a)),
        format!("{:?}", traits.compare_v_at_u(&1, a)),
        format!("{:?}", traits.compare_v_at_u_right(a, b, &1)),
        format!("{:?}", traits.compare_v_at_u_left(a, b, &1)),
        format!("{:?}", traits.is_same_point(&1, &2)),
        format!("{:?}", traits.is_in_u_range(&77, a)),
        format!("{:?}", traits.is_on_curve(&78, a)),
        format!("{:?}", traits.split(a, &5).each_ref().map(&bare)),
        format!("{:?}", traits.merge(a, b).as_ref().map(&bare)),
        format!("{:?}", traits.is_mergeable(a, b)),
        bare(&traits.trim(a, Some(&1), None)),
        format!("{:?}", traits.is_directed_right(a)),
        bare(&traits.opposite(a)),
        format!("{:?}", traits.source(a)),
        format!("{:?}", traits.target(a)),
        format!("{:?}", traits.approx_point(&4)),
        format!("{:?}", traits.approx_to_point([1.0, 2.0])),
        format!("{:?}", traits.end_location(a, CurveEnd::Min)),
        format!("{:?}", traits.compare_v_near_side(a, b, CurveEnd::Min)),
        format!("{:?}", traits.compare_u_near_end(&1, a, CurveEnd::Min)),
        format!("{:?}", traits.compare_u_of_ends((a, CurveEnd::Min), (b, CurveEnd::Max))),
        format!("{:?}", traits.is_on_left_right(&1)),
        format!("{:?}", traits.compare_v_on_left_right(&1, &2)),
        format!("{:?}", traits.is_on_bottom_top(&2)),
        format!("{:?}", traits.compare_u_on_bottom_top(&1, &2)),
        format!("{:?}", traits.is_joint_allowed(&3)),
        format!("{:?}", traits.is_foldback_on_side(a, a, CurveEnd::Max)),
        format!("{:?}", traits.compare_u_to_end(&86, a, CurveEnd::Max)),
        format!("{:?}", traits.direction(a)),
        format!("{:?}", traits.contraction_bottom_top(CurveEnd::Min)),
        format!("{:?}", traits.contracted_bottom_top(&20)),
    ];
    let window = Window { after: Some(&1), until: Some(&6), first_to_end: 1 };
    text.push(format!("{:?}", traits.next_meeting(a, b, window)));
    text.push(format!("{:?}", traits.end_of_overlap(a, b, Some(&1))));
    // What is in the buffers before stays.
    let mut common = vec![Intersection::Point(1000, Multiplicity::Odd)];
    traits.intersect(a, b, &mut common);
    text.extend(common.iter().map(|intersection| match intersection {
        Intersection::Point(p, multiplicity) => format!("{p} {multiplicity:?}"),
        Intersection::Overlap(curve) => bare(curve),
    }));
    let mut pieces = vec![Piece::Point(2000)];
    traits.make_u_monotone(curve, &mut pieces);
    text.extend(pieces.iter().map(|piece| match piece {
        Piece::Point(p) => format!("{p}"),
        Piece::Curve { curve, is_artificial } => format!("{} {is_artificial:?}", bare(curve)),
    }));
    let mut points = vec![[0.0, 0.0]];
    traits.approx_curve(a, None, Some(&2), [1.0, 2.0, 3.0, 4.0], &mut points);
    text.push(format!("{points:?}"));
    text
}
