//! Laws of pairs of arcs.

use crate::arcs::{identifications, random_arcs, sample};
use crate::oracle::{cross, height_at, is_on_arc, is_pole, longitude_of, place, range_of, sign};
use exact::spherical::Direction;
use splitstar_arrangement::models::{GeodesicArc, GeodesicTraits};
use splitstar_arrangement::traits::{
    Along, BasicTraits, CurveEnd, Intersection, Meeting, Multiplicity, NearLeftRightTraits, UMonotoneTraits,
    Window,
};
use std::cmp::Ordering;
use testkit::Rng;

type Common = Vec<Intersection<Direction, GeodesicArc>>;

fn common(traits: &GeodesicTraits, a: &GeodesicArc, b: &GeodesicArc) -> Common {
    let mut out = Vec::new();
    traits.intersect(a, b, &mut out);
    out
}

#[test]
fn what_two_arcs_have_in_common() {
    let mut rng = Rng::new(201);
    eprintln!("seed {}", rng.state());
    let points = sample();
    let mut found = [0; 3];
    for traits in identifications() {
        for size in [1, 2] {
            let arcs = random_arcs(&traits, &mut rng, 70, size);
            for a in &arcs {
                for b in &arcs {
                    check_intersections(&traits, a, b, &points, &mut found);
                }
            }
        }
    }
    // Two points, overlaps, and overlaps with a point besides.
    assert!(found[0] > 200 && found[1] > 200 && found[2] > 3, "{found:?}");
}

fn check_intersections(
    traits: &GeodesicTraits,
    a: &GeodesicArc,
    b: &GeodesicArc,
    points: &[Direction],
    found: &mut [usize; 3],
) {
    let out = common(traits, a, b);
    let is_overlap = |common: &Intersection<_, _>| matches!(common, Intersection::Overlap(_));
    found[0] += usize::from(out.len() == 2 && !out.iter().any(is_overlap));
    found[1] += usize::from(out.len() == 1 && out.iter().any(is_overlap));
    found[2] += usize::from(out.len() == 2 && out.iter().any(is_overlap));
    let mut candidates: Vec<Direction> = points.to_vec();
    let product = cross(&a.circle().coordinates(), &b.circle().coordinates());
    let opposite = product.each_ref().map(|value| -value);
    candidates.extend([product, opposite].into_iter().filter_map(Direction::new));
    candidates
        .extend(CurveEnd::BOTH.map(|end| [a.end(end).clone(), b.end(end).clone()]).into_iter().flatten());
    for p in candidates.iter().filter(|p| !is_pole(p)) {
        let is_common = is_on_arc(p, a) && is_on_arc(p, b);
        let told = out.iter().filter(|common| match common {
            Intersection::Point(q, _) => p == q,
            Intersection::Overlap(piece) => is_on_arc(p, piece),
        });
        assert_eq!(told.count(), usize::from(is_common), "{p} of {a:?} and {b:?}: {out:?}");
    }
    let starts: Vec<&Direction> = out
        .iter()
        .map(|common| match common {
            Intersection::Point(p, _) => p,
            Intersection::Overlap(piece) => {
                assert!(traits.is_own_curve(piece), "{piece:?}");
                piece.end(CurveEnd::Min)
            }
        })
        .collect();
    assert!(starts.is_sorted_by(|p, q| traits.compare_uv(p, q).is_lt()), "{a:?} and {b:?}: {out:?}");
    for common in &out {
        let Intersection::Point(p, multiplicity) = common else { continue };
        assert!(!is_pole(p), "{a:?} and {b:?}");
        let is_end = CurveEnd::BOTH.into_iter().any(|end| a.end(end) == p || b.end(end) == p);
        assert_eq!(*multiplicity == Multiplicity::Unknown, is_end, "{a:?} and {b:?}: {out:?}");
        check_order_beside(traits, a, b, p);
    }
}

/// The height of an arc beside a place; a vertical one is above all others to the right, and below all to the left.
fn beside(traits: &GeodesicTraits, arc: &GeodesicArc, u: f64, step: f64) -> f64 {
    if arc.is_meridian() { 9.0 * step.signum() } else { height_at(traits, arc.circle(), u + step) }
}

fn check_order_beside(traits: &GeodesicTraits, a: &GeodesicArc, b: &GeodesicArc, p: &Direction) {
    let [u, _] = place(traits, p);
    for (step, ended) in [(1e-4, CurveEnd::Max), (-1e-4, CurveEnd::Min)] {
        let is_over = |arc: &GeodesicArc| arc.end(ended) == p && !(arc.is_full());
        if is_over(a) || is_over(b) {
            continue;
        }
        let expected = sign(beside(traits, a, u, step) - beside(traits, b, u, step));
        let told = if step > 0.0 {
            traits.compare_v_at_u_right(a, b, p)
        } else {
            traits.compare_v_at_u_left(a, b, p)
        };
        assert_eq!(told, expected, "{a:?} and {b:?} beside {p}, {step}");
    }
}

#[test]
fn the_order_on_the_sides() {
    let mut rng = Rng::new(202);
    eprintln!("seed {}", rng.state());
    for traits in identifications() {
        let arcs = random_arcs(&traits, &mut rng, 200, 2);
        for (end, side) in [(CurveEnd::Min, Along::Low), (CurveEnd::Max, Along::High)] {
            let reaching: Vec<_> = arcs
                .iter()
                .filter(|arc| arc.location(end).u == side && arc.location(end).v == Along::Inside)
                .collect();
            assert!(reaching.len() > 20);
            let u = if end == CurveEnd::Min { 0.0 } else { std::f64::consts::TAU };
            let step = if end == CurveEnd::Min { 1e-4 } else { -1e-4 };
            for a in &reaching {
                for b in &reaching {
                    let [v, w] = [a, b].map(|arc| place(&traits, arc.end(end))[1]);
                    let expected = sign(v - w)
                        .then_with(|| sign(beside(&traits, a, u, step) - beside(&traits, b, u, step)));
                    assert_eq!(traits.compare_v_near_side(a, b, end), expected, "{a:?} and {b:?}");
                }
            }
        }
    }
}

/// Where an arc ends in a sweep: on the right side, or by u and v.
fn end_of(traits: &GeodesicTraits, arc: &GeodesicArc) -> (bool, f64, f64) {
    let location = arc.location(CurveEnd::Max);
    let u = if arc.is_meridian() { longitude_of(traits, arc) } else { range_of(traits, arc)[1] };
    (location.u == Along::High, u, place(traits, arc.end(CurveEnd::Max))[1])
}

fn compare_ends(a: (bool, f64, f64), b: (bool, f64, f64)) -> Ordering {
    a.0.cmp(&b.0).then(sign(a.1 - b.1)).then(sign(a.2 - b.2))
}

/// What the provided version of `next_meeting` finds, without points on the left and right side.
fn expected_meeting(
    traits: &GeodesicTraits,
    [below, above]: [&GeodesicArc; 2],
    window: Window<'_, Direction>,
) -> Meeting<Direction> {
    for intersection in common(traits, below, above) {
        let point = match intersection {
            Intersection::Point(point, _) => point,
            Intersection::Overlap(piece) => piece.end(CurveEnd::Min).clone(),
        };
        let is_passed = window.after.is_some_and(|after| traits.compare_uv(&point, after).is_le());
        if is_passed || traits.meridian().contains(&point) {
            continue;
        }
        return match window.until.map_or(Ordering::Less, |until| traits.compare_uv(&point, until)) {
            Ordering::Less => Meeting::At(point, Multiplicity::Unknown),
            Ordering::Equal => Meeting::AtEnd,
            Ordering::Greater => Meeting::Never,
        };
    }
    Meeting::Never
}

#[derive(Default, Debug)]
struct Met {
    never: usize,
    at: usize,
    at_end: usize,
    long: usize,
}

fn check_meeting(
    traits: &GeodesicTraits,
    pair: [&GeodesicArc; 2],
    window: Window<'_, Direction>,
    met: &mut Met,
) {
    let [below, above] = pair;
    let expected = expected_meeting(traits, pair, window);
    let told = traits.next_meeting(below, above, window);
    match (&told, &expected) {
        (Meeting::Never, Meeting::Never) => met.never += 1,
        (Meeting::AtEnd, Meeting::AtEnd) => met.at_end += 1,
        (Meeting::At(p, _), Meeting::At(q, _)) if p == q => met.at += 1,
        _ => panic!("{below:?} below {above:?} in {window:?}: {told:?}, not {expected:?}"),
    }
    let is_long = |arc: &GeodesicArc| {
        let [low, high] = range_of(traits, arc);
        high - low > crate::oracle::HALF + 0.1
    };
    met.long += usize::from(is_long(below) && is_long(above));
}

#[test]
fn the_next_meeting_is_the_first_one_in_the_window() {
    let mut rng = Rng::new(203);
    eprintln!("seed {}", rng.state());
    let points = sample();
    let mut met = Met::default();
    for traits in identifications() {
        for size in [1, 2] {
            let arcs = random_arcs(&traits, &mut rng, 60, size);
            for a in &arcs {
                for b in &arcs {
                    if a.is_along_side() || b.is_along_side() || a.circle() == b.circle() {
                        continue;
                    }
                    check_from_everywhere(&traits, [a, b], &points, &mut met);
                }
            }
        }
    }
    assert!(met.never > 1000 && met.at > 200 && met.at_end > 200 && met.long > 200, "{met:?}");
}

/// All windows in which `pair` are neighbours in this order.
fn check_from_everywhere(
    traits: &GeodesicTraits,
    pair: [&GeodesicArc; 2],
    points: &[Direction],
    met: &mut Met,
) {
    let [a, b] = pair;
    let ends = pair.map(|arc| end_of(traits, arc));
    let first_to_end = usize::from(compare_ends(ends[0], ends[1]).is_gt());
    let first = pair[first_to_end];
    let is_inside = first.location(CurveEnd::Max) == splitstar_arrangement::traits::Location::INTERIOR;
    let until = is_inside.then(|| first.end(CurveEnd::Max));
    let mut starts: Vec<Option<Direction>> = Vec::new();
    // From the left side.
    if pair.iter().all(|arc| !arc.is_meridian() && arc.location(CurveEnd::Min).u == Along::Low)
        && traits.compare_v_near_side(a, b, CurveEnd::Min).is_lt()
    {
        starts.push(None);
    }
    let mut inner: Vec<Direction> = points.to_vec();
    inner.extend(common(traits, a, b).into_iter().filter_map(|common| match common {
        Intersection::Point(p, _) => Some(p),
        Intersection::Overlap(_) => None,
    }));
    inner.retain(|p| !is_pole(p) && !traits.meridian().contains(p));
    // From a point of one of them at which they are neighbours in this order: on both, or with the other above or below it.
    for p in &inner {
        let [on_a, on_b] = pair.map(|arc| is_on_arc(p, arc));
        let goes_on = pair.iter().all(|arc| arc.is_full() || arc.end(CurveEnd::Max) != p);
        let is_start = goes_on
            && match (on_a, on_b) {
                (true, true) => traits.compare_v_at_u_right(a, b, p).is_lt(),
                (true, false) => is_over(traits, p, b) && traits.compare_v_at_u(p, b).is_lt(),
                (false, true) => is_over(traits, p, a) && traits.compare_v_at_u(p, a).is_gt(),
                (false, false) => false,
            };
        if is_start {
            starts.push(Some(p.clone()));
        }
    }
    for start in &starts {
        let after = start.as_ref();
        check_meeting(traits, pair, Window { after, until, first_to_end }, met);
        // The first may be an edge, which ends earlier.
        for (i, arc) in pair.into_iter().enumerate() {
            let other = pair[1 - i];
            for q in inner.iter().filter(|q| is_on_arc(q, arc)) {
                let is_later = after.is_none_or(|after| traits.compare_uv(after, q).is_lt());
                let at = (false, place(traits, q)[0], place(traits, q)[1]);
                let is_before_end = compare_ends(at, end_of(traits, other)).is_le();
                if is_later && is_before_end {
                    check_meeting(traits, pair, Window { after, until: Some(q), first_to_end: i }, met);
                }
            }
        }
    }
}

/// Whether a curve goes on to the right above or below a point, so that it is on the status line there.
fn is_over(traits: &GeodesicTraits, p: &Direction, arc: &GeodesicArc) -> bool {
    let [low, high] = range_of(traits, arc);
    let [u, _] = place(traits, p);
    !arc.is_meridian() && low < u - 1e-9 && u + 1e-9 < high
}

#[test]
fn overlaps_end_where_one_of_the_arcs_does() {
    let mut rng = Rng::new(204);
    eprintln!("seed {}", rng.state());
    let mut overlaps = 0;
    for traits in identifications() {
        let arcs = random_arcs(&traits, &mut rng, 120, 1);
        for a in &arcs {
            for b in &arcs {
                let piece = common(&traits, a, b).into_iter().find_map(|common| match common {
                    Intersection::Overlap(piece) => Some(piece),
                    Intersection::Point(..) => None,
                });
                let Some(piece) = piece else { continue };
                overlaps += 1;
                let location = piece.location(CurveEnd::Max);
                let is_point =
                    location.v == Along::Inside && (location.u == Along::Inside || piece.is_along_side());
                let expected = is_point.then(|| piece.end(CurveEnd::Max).clone());
                let start = Some(piece.end(CurveEnd::Min));
                assert_eq!(traits.end_of_overlap(a, b, start), expected, "{a:?} and {b:?}");
            }
        }
    }
    assert!(overlaps > 300, "{overlaps}");
}
