//! Laws, on random polylines with small coordinates, which are full of degenerate cases; the oracle is every pair of pieces.

use super::{Curve, TRAITS, polyline_of};
use crate::rational_segments::{Point, RationalSegments, Segment};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::polycurve::Chain;
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::traits::{
    BasicTraits, CurveEnd, Intersection, Meeting, Multiplicity, Piece, UMonotoneTraits, Window,
};
use std::cmp::Ordering;
use testkit::Rng;

fn random_polyline(rng: &mut Rng, size: i64) -> Curve {
    let count = 2 + rng.index(7);
    let mut vertices: Vec<[i64; 2]> = (0..count).map(|_| [rng.within(size), rng.within(size)]).collect();
    if rng.one_in(6) {
        vertices.push(vertices[0]);
    }
    if rng.one_in(6) {
        let last = vertices.len() - 2;
        vertices.push(vertices[last]);
    }
    polyline_of(vertices)
}

/// A chain of many pieces.
fn random_chain(rng: &mut Rng, size: i64) -> Chain<Segment> {
    let vertical = rng.one_in(8);
    let start = rng.within(size);
    let count = 1 + rng.below(6) as i64;
    let mut across = start;
    let vertices = (0..=count).map(|_| {
        across += 1 + rng.within(1).abs();
        if vertical { [start, across] } else { [across, rng.within(size)] }
    });
    let vertices: Vec<_> = vertices.collect();
    match polyline_of(vertices).parts() {
        [Piece::Curve { curve, .. }] => curve.clone(),
        parts => panic!("a chain is one part: {parts:?}"),
    }
}

fn points_of(chain: &Chain<Segment>) -> impl Iterator<Item = &Point> {
    chain.pieces().iter().flat_map(|piece| &piece.0)
}

/// Common points of all pairs of pieces, and the ends of common pieces; and the common pieces.
fn brute_force(a: &Chain<Segment>, b: &Chain<Segment>) -> (Vec<Point>, Vec<Segment>) {
    let mut found = Vec::new();
    for p in a.pieces() {
        for q in b.pieces() {
            RationalSegments.intersect(p, q, &mut found);
        }
    }
    let (mut points, mut overlaps) = (Vec::new(), Vec::new());
    for intersection in found {
        match intersection {
            Intersection::Point(point, _) => points.push(point),
            Intersection::Overlap(segment) => overlaps.push(segment),
        }
    }
    points.sort();
    points.dedup();
    points.retain(|p| !overlaps.iter().any(|segment| RationalSegments.is_on_curve(p, segment)));
    overlaps.sort();
    (points, overlaps)
}

#[test]
fn intersections_are_those_of_the_pieces() {
    let seed = 2001;
    let mut rng = Rng::new(seed);
    let traits = TRAITS();
    let (mut met, mut overlapped) = (0, 0);
    for round in 0..6000 {
        let [a, b] = [(); 2].map(|()| random_chain(&mut rng, 3));
        let mut found = Vec::new();
        traits.intersect(&a, &b, &mut found);
        let (points, overlaps) = brute_force(&a, &b);
        let context = format!("seed {seed}, round {round}: {a:?} and {b:?} give {found:?}");
        let (mut found_points, mut found_overlaps, mut last) = (Vec::new(), Vec::new(), None::<Point>);
        for intersection in &found {
            let [from, to] = match intersection {
                Intersection::Point(p, multiplicity) => {
                    found_points.push(p.clone());
                    check_multiplicity(&a, &b, p, *multiplicity, &context);
                    [p, p]
                }
                Intersection::Overlap(chain) => {
                    assert!(chain.pieces().windows(2).all(|pair| pair[0].0[1] == pair[1].0[0]), "{context}");
                    found_overlaps.extend_from_slice(chain.pieces());
                    CurveEnd::BOTH.map(|end| traits.end_point(chain, end).unwrap())
                }
            };
            // In order, nothing twice, and overlaps that touch are one.
            assert!(last.is_none_or(|last| last < *from), "{context}");
            last = Some(to.clone());
        }
        assert_eq!(found_points, points, "{context}");
        assert_eq!(found_overlaps, overlaps, "{context}");
        met += points.len();
        overlapped += overlaps.len();
        let mut exchanged = Vec::new();
        traits.intersect(&b, &a, &mut exchanged);
        let directed = |list: Vec<Intersection<Point, Chain<Segment>>>| format!("{list:?}");
        assert_eq!(directed(found), directed(exchanged), "seed {seed}, round {round}: exchanged");
    }
    assert!(met > 1000 && overlapped > 100, "{met} points, {overlapped} common pieces");
}

/// A known multiplicity is that which the order on both sides tells.
fn check_multiplicity(a: &Chain<Segment>, b: &Chain<Segment>, p: &Point, told: Multiplicity, context: &str) {
    let traits = TRAITS();
    let is_end = [a, b].iter().any(|c| CurveEnd::BOTH.iter().any(|&e| traits.end_point(c, e) == Some(p)));
    let is_joint = [a, b].iter().any(|c| points_of(c).any(|q| q == p));
    if is_end || is_joint {
        return assert_eq!(told, Multiplicity::Unknown, "{context}");
    }
    let sides = [traits.compare_v_at_u_left(a, b, p), traits.compare_v_at_u_right(a, b, p)];
    let expected = if sides[0] == sides[1] { Multiplicity::Even } else { Multiplicity::Odd };
    assert_eq!(told, expected, "{context}");
}

/// The provided version, which asks for all intersections.
fn next_by_intersect(a: &Chain<Segment>, b: &Chain<Segment>, window: Window<'_, Point>) -> Meeting<Point> {
    let traits = TRAITS();
    let mut common = Vec::new();
    traits.intersect(a, b, &mut common);
    for intersection in common {
        let (point, multiplicity) = match intersection {
            Intersection::Point(point, multiplicity) => (point, multiplicity),
            Intersection::Overlap(chain) => (chain.pieces()[0].0[0].clone(), Multiplicity::Unknown),
        };
        if window.after.is_some_and(|after| point <= *after) {
            continue;
        }
        return match point.cmp(window.until.unwrap()) {
            Ordering::Less => Meeting::At(point, multiplicity),
            Ordering::Equal => Meeting::AtEnd,
            Ordering::Greater => Meeting::Never,
        };
    }
    Meeting::Never
}

#[test]
fn the_next_meeting_is_the_first_intersection_in_the_window() {
    let seed = 2002;
    let mut rng = Rng::new(seed);
    let traits = TRAITS();
    let (mut asked, mut met) = (0, 0);
    for round in 0..3000 {
        let [a, b] = [(); 2].map(|()| random_chain(&mut rng, 3));
        if traits.is_vertical(&a) || traits.is_vertical(&b) {
            continue;
        }
        let mut critical: Vec<Point> = points_of(&a).chain(points_of(&b)).cloned().collect();
        let (points, _) = brute_force(&a, &b);
        critical.extend(points);
        critical.sort();
        critical.dedup();
        let starts = [&a, &b].map(|c| c.pieces()[0].0[0].clone());
        let ends = [&a, &b].map(|c| c.pieces()[c.pieces().len() - 1].0[1].clone());
        let first_end = ends.iter().min().unwrap();
        for (i, after) in critical.iter().enumerate() {
            // The last critical point of its u, so that the order halfway to the next u is that right of it.
            let Some(next) = critical.get(i + 1).filter(|next| next.u > after.u) else { continue };
            if starts.iter().any(|start| start > after) || ends.iter().any(|end| end <= after) {
                continue;
            }
            let middle = &(&after.u + &next.u) * &exact::Rational::from(2).recip().unwrap();
            let height = |chain: &Chain<Segment>| {
                let piece = chain.pieces().iter().find(|piece| piece.0[1].u > middle).unwrap();
                let [p, q] = &piece.0;
                let slope = (&q.v - &p.v).checked_div(&(&q.u - &p.u)).unwrap();
                &p.v + &(slope * (&middle - &p.u))
            };
            let (below, above) = match height(&a).cmp(&height(&b)) {
                Ordering::Less => (&a, &b),
                Ordering::Greater => (&b, &a),
                Ordering::Equal => continue,
            };
            // The end of a curve, and any vertex on the one that ends: an edge of an arrangement may end there.
            let on_below = points_of(below).map(|p| (p, 0));
            let on_above = points_of(above).map(|p| (p, 1));
            for (until, first_to_end) in on_below.chain(on_above) {
                if until <= after || until > first_end {
                    continue;
                }
                let window = Window { after: Some(after), until: Some(until), first_to_end };
                let found = traits.next_meeting(below, above, window);
                let expected = next_by_intersect(below, above, window);
                assert_eq!(
                    found, expected,
                    "seed {seed}, round {round}: {below:?} below {above:?}, {window:?}"
                );
                asked += 1;
                met += usize::from(found != Meeting::Never);
            }
        }
    }
    assert!(asked > 10_000 && met > 3000, "{asked} questions, {met} meetings");
}

#[test]
fn splitting_changes_no_answer() {
    let seed = 2003;
    let mut rng = Rng::new(seed);
    let traits = TRAITS();
    for round in 0..1500 {
        let [a, b] = [(); 2].map(|()| random_chain(&mut rng, 4));
        let (points, _) = brute_force(&a, &b);
        for p in points.iter().chain(points_of(&b)) {
            let context = format!("seed {seed}, round {round}: {a:?} at {p:?}");
            assert_eq!(
                traits.is_on_curve(p, &a),
                a.pieces().iter().any(|piece| RationalSegments.is_on_curve(p, piece)),
                "{context}"
            );
            let [min, max] = CurveEnd::BOTH.map(|end| traits.end_point(&a, end).unwrap());
            if !traits.is_on_curve(p, &a) || p == min || p == max {
                continue;
            }
            let [lower, upper] = traits.split(&a, p);
            // At a joint between collinear pieces it makes one of them.
            let merged = traits.merge(&upper, &lower).unwrap();
            let is_joint = points_of(&a).any(|joint| joint == p);
            assert!(merged == a || is_joint && merged.pieces().len() + 1 == a.pieces().len(), "{context}");
            assert_eq!(traits.trim(&a, None, Some(p)), lower, "{context}");
            assert_eq!(traits.trim(&a, Some(p), None), upper, "{context}");
            for q in points_of(&b).chain(points_of(&a)) {
                let parts = [&lower, &upper];
                for part in parts.into_iter().filter(|part| traits.is_in_u_range(q, part)) {
                    if !traits.is_vertical(&a) {
                        assert_eq!(traits.compare_v_at_u(q, part), traits.compare_v_at_u(q, &a), "{context}");
                    }
                }
                let on_parts = parts.iter().any(|part| traits.is_on_curve(q, part));
                assert_eq!(on_parts, traits.is_on_curve(q, &a), "{context}");
            }
        }
    }
}

/// The arrangement of polylines has the faces and the components of the arrangement of their pieces, and lacks only vertices of
/// degree 2.
#[test]
fn arrangements_are_those_of_the_pieces() {
    let seed = 2004;
    let mut rng = Rng::new(seed);
    for round in 0..400 {
        let count = 1 + rng.index(6);
        let curves: Vec<Curve> = (0..count).map(|_| random_polyline(&mut rng, 4)).collect();
        let mut pieces: Vec<Segment> = Vec::new();
        for part in curves.iter().flat_map(|curve| curve.parts()) {
            if let Piece::Curve { curve, .. } = part {
                pieces.extend_from_slice(curve.pieces());
            }
        }
        let [a, b] = [
            Arrangement::of_curves(TRAITS(), BoundedPlane, &curves).counts_with_splits(),
            Arrangement::of_curves(RationalSegments, BoundedPlane, &pieces).counts_with_splits(),
        ];
        let context = format!("seed {seed}, round {round}: {a:?} and {b:?}");
        assert_eq!(a.faces, b.faces, "{context}");
        if curves.iter().all(|curve| matches!(curve.parts()[0], Piece::Curve { .. })) {
            assert_eq!((a.components, a.isolated), (b.components, b.isolated), "{context}");
            assert_eq!(b.vertices - a.vertices, b.edges - a.edges, "{context}");
        }
    }
}
