//! Arrangements put together from parts: what was taken apart comes back, and whatever else is given is refused without a panic.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use dcel::{CcbId, CcbKind, Dcel, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, VertexId};
use exact::planar::Point2;
use splitstar_arrangement::models::{GeodesicTraits, Linear, LinearTraits};
use splitstar_arrangement::topology::{Sphere, UnboundedPlane};
use splitstar_arrangement::traits::BasicTraits;
use splitstar_arrangement::{Arrangement, Parts, Pieces, Violation};

type Plane = Arrangement<LinearTraits, UnboundedPlane>;

struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }

    fn point(&mut self) -> Point2 {
        Point2::from_i64([self.below(5) as i64, self.below(5) as i64])
    }

    fn arrangement(&mut self) -> Plane {
        let mut pieces = Pieces::default();
        for _ in 0..1 + self.below(5) {
            let (p, q) = (self.point(), self.point());
            let curve = match self.below(5) {
                0 => Linear::line(&p, &q),
                1 => Linear::ray(p.clone(), &q),
                _ => Linear::segment(p.clone(), q),
            };
            match curve {
                Some(curve) => {
                    pieces.push_curve(curve);
                }
                None => pieces.push_point(p),
            }
        }
        Arrangement::of_pieces(LinearTraits, UnboundedPlane, pieces)
    }
}

/// The cells with all their ids.
fn raw(dcel: &Dcel) -> RawDcel {
    let halfedge =
        |h| Halfedge { next: dcel.next(h), prev: dcel.prev(h), source: dcel.source(h), ccb: dcel.ccb(h) };
    let ccb = |c| RawCcb { first: dcel.ccb_halfedge(c), face: dcel.ccb_face(c), kind: dcel.ccb_kind(c) };
    let isolated = |v| dcel.isolated_face(v).map(|face| (v, face));
    RawDcel {
        halfedges: dcel.halfedges().map(halfedge).collect(),
        outgoing: dcel.vertices().map(|v| dcel.outgoing(v).unwrap_or(HalfedgeId::NONE)).collect(),
        ccbs: dcel.ccbs().map(ccb).collect(),
        face_count: dcel.face_count(),
        isolated: dcel.vertices().filter_map(isolated).collect(),
    }
}

fn put_together(parts: Parts<LinearTraits>) -> Result<Plane, Vec<Violation>> {
    Arrangement::from_parts(LinearTraits, UnboundedPlane, parts)
}

/// Changes one record, within the bounds that the cells themselves ask for.
fn change(raw: &mut RawDcel, parts: &mut Parts<LinearTraits>, numbers: &mut Numbers) {
    let (halfedges, vertices) = (raw.halfedges.len(), raw.outgoing.len());
    let any = numbers.below(halfedges);
    // Ids that there are, and some that there are not.
    let mut id = |bound: usize| numbers.below(bound + 2) as u32;
    let (h, v, f, c) = (id(halfedges), id(vertices), id(raw.face_count), id(raw.ccbs.len()));
    let points = parts.points.len() as u32;
    match numbers.below(13) {
        0 if halfedges > 0 => raw.halfedges[any].source = VertexId(v),
        1 if halfedges > 0 => raw.halfedges[any].next = HalfedgeId(h % halfedges as u32),
        2 if halfedges > 0 => raw.halfedges[any].ccb = CcbId(c),
        3 if !raw.ccbs.is_empty() => {
            let ccb = numbers.below(raw.ccbs.len());
            raw.ccbs[ccb].face = FaceId(f % raw.face_count as u32);
        }
        4 if !raw.ccbs.is_empty() => {
            let ccb = numbers.below(raw.ccbs.len());
            let ccb = &mut raw.ccbs[ccb];
            ccb.kind = if ccb.kind == CcbKind::Outer { CcbKind::Inner } else { CcbKind::Outer };
        }
        5 => raw.outgoing[v as usize % vertices] = HalfedgeId(h),
        6 if any / 2 < parts.supports.len() => parts.supports[any / 2] = id_of(numbers, parts.curves.len()),
        7 if v < points => parts.points[v as usize] = Some(numbers.point()),
        8 if v < points => parts.points.swap(v as usize, any % points as usize),
        9 => parts.is_artificial[v as usize % vertices] ^= true,
        10 => drop(parts.points.pop()),
        11 => parts.corner_face = FaceId(f),
        _ => drop(parts.supports.pop()),
    }
}

fn id_of(numbers: &mut Numbers, bound: usize) -> u32 {
    numbers.below(bound + 2) as u32
}

#[test]
fn parts_come_back_or_are_refused() {
    let mut numbers = Numbers(5);
    println!("seed 5");
    let (mut accepted, mut refused) = (0, 0);
    for case in 0..4000 {
        let arrangement = numbers.arrangement();
        let mut raw = raw(arrangement.dcel());
        let mut parts = arrangement.clone().into_parts();
        let same = put_together(parts.clone()).unwrap_or_else(|found| panic!("{case}: {found:?}"));
        assert_eq!(same.counts_with_splits(), arrangement.counts_with_splits(), "{case}");
        for _ in 0..1 + numbers.below(2) {
            change(&mut raw, &mut parts, &mut numbers);
        }
        parts.dcel = Dcel::from_parts(raw);
        match put_together(parts) {
            Ok(changed) => {
                assert!(changed.check_valid().is_empty(), "{case}");
                accepted += 1;
            }
            Err(violations) => {
                assert!(!violations.is_empty() && !violations[0].to_string().is_empty());
                refused += 1;
            }
        }
    }
    println!("{accepted} accepted, {refused} refused");
    assert!(accepted > 100 && refused > 1000, "{accepted} {refused}");
}

#[test]
fn kinds_of_boundaries_are_checked() {
    let [p, q] = [[0, 0], [1, 1]].map(Point2::from_i64);
    let segment = Linear::segment(p, q).unwrap();
    let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &[segment]);
    let mut raw = raw(arrangement.dcel());
    raw.ccbs[0].kind = CcbKind::Outer;
    let mut parts = arrangement.into_parts();
    parts.dcel = Dcel::from_parts(raw);
    assert_eq!(put_together(parts).unwrap_err(), [Violation::Kind(CcbId(0))]);
}

/// Two edges of one curve that have a piece in common, with cells as if they had not.
#[test]
fn edges_on_one_support_follow_one_another() {
    let segment = |y: i64| Linear::segment(Point2::from_i64([0, y]), Point2::from_i64([9, y])).unwrap();
    let mut parts =
        Arrangement::of_curves(LinearTraits, UnboundedPlane, &[segment(0), segment(1)]).into_parts();
    parts.supports = vec![0, 0];
    let mut x = [0, 1, 2, 3].into_iter();
    for point in parts.points.iter_mut().flatten() {
        *point = Point2::from_i64([x.next().unwrap(), 0]);
    }
    let violations = put_together(parts).unwrap_err();
    assert!(matches!(violations[..], [Violation::Overlap(..)]), "{violations:?}");
}

fn bare<G: BasicTraits>() -> Parts<G> {
    Parts {
        dcel: Dcel::new(),
        points: Vec::new(),
        is_artificial: Vec::new(),
        curves: Vec::new(),
        supports: Vec::new(),
        corner_face: FaceId(0),
    }
}

/// The vertices that stand for sides are asked for before anything is looked up at them.
#[test]
fn parts_without_the_vertices_of_sides_are_refused() {
    let refused = Arrangement::from_parts(LinearTraits, UnboundedPlane, bare());
    assert_eq!(refused.unwrap_err(), [Violation::Records]);
    let refused = Arrangement::from_parts(GeodesicTraits::new(), Sphere, bare());
    assert_eq!(refused.unwrap_err(), [Violation::Records]);
    let mut south_only = Arrangement::new(GeodesicTraits::new(), Sphere).into_parts();
    south_only.dcel.remove_isolated_vertex(VertexId(1));
    let refused = Arrangement::from_parts(GeodesicTraits::new(), Sphere, south_only);
    assert_eq!(refused.unwrap_err(), [Violation::Records]);
}
