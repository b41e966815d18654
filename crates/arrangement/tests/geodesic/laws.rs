//! Laws of single arcs.

use crate::arcs::{arcs_of, grid, identifications, pieces_of, random_arcs, random_geodesic, sample};
use crate::oracle::{
    HALF, NEARLY, QUARTER, height_at, is_on_arc, is_on_geodesic, is_pole, longitude_of, place, range_of, sign,
};
use exact::Integer;
use exact::spherical::Direction;
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::traits::{
    Along, ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, ContractedBottomTopTraits, CurveEnd,
    DirectionalTraits, IdentifiedLeftRightTraits, LandmarkTraits, NearBottomTopTraits, Piece,
    UMonotoneTraits,
};
use std::cmp::Ordering;
use std::f64::consts::TAU;
use testkit::Rng;

#[test]
fn curves_are_cut_into_what_they_are() {
    let mut rng = Rng::new(101);
    eprintln!("seed {}", rng.state());
    let points = sample();
    for _ in 0..400 {
        let curve = random_geodesic(&mut rng, 2);
        for traits in identifications() {
            check_pieces(&traits, &curve, &points);
        }
    }
}

fn check_pieces(traits: &GeodesicTraits, curve: &Geodesic, points: &[Direction]) {
    let pieces = pieces_of(traits, curve);
    assert!((1..=3).contains(&pieces.len()), "{curve:?}");
    let mut arcs = Vec::new();
    for piece in &pieces {
        match piece {
            Piece::Point(p) => assert_eq!(Some(p), curve.as_point()),
            Piece::Curve { curve: arc, is_artificial } => arcs.push((arc, is_artificial)),
        }
    }
    for p in points {
        let is_on = arcs.iter().any(|(arc, _)| is_on_arc(p, arc)) || curve.as_point() == Some(p);
        assert_eq!(is_on, is_on_geodesic(p, curve), "{p} and {curve:?}");
    }
    let Some((first, _)) = arcs.first() else { return };
    let (last, _) = arcs.last().unwrap();
    if let (Some(source), Some(target)) = (curve.source(), curve.target()) {
        assert_eq!((first.source(), last.target()), (source, target), "{curve:?}");
    } else {
        assert_eq!(first.source(), last.target(), "{curve:?}");
    }
    for pair in arcs.windows(2) {
        assert_eq!(pair[0].0.target(), pair[1].0.source(), "{curve:?}");
    }
    // The ends that are real are those of the curve.
    let real: Vec<&Direction> = arcs
        .iter()
        .flat_map(|(arc, is_artificial)| {
            CurveEnd::BOTH.map(|end| (arc.end(end), is_artificial[end as usize]))
        })
        .filter_map(|(p, is_artificial)| (!is_artificial).then_some(p))
        .collect();
    let ends: Vec<&Direction> = curve.source().into_iter().chain(curve.target()).collect();
    assert_eq!(real.len(), ends.len(), "{curve:?}");
    assert!(real.iter().all(|p| ends.contains(p)), "{curve:?}");
    for (arc, _) in arcs {
        assert!(traits.is_own_curve(arc), "{arc:?}");
        check_locations(traits, arc);
        let again = arcs_of(traits, &arc.make_geodesic());
        assert_eq!(again.len(), 1, "{arc:?}");
        assert_eq!(again[0].circle(), arc.circle());
        assert_eq!(again[0].is_directed_right(), arc.is_directed_right());
        for end in CurveEnd::BOTH {
            let [here, there] = [arc, &again[0]].map(|arc| (arc.end(end), arc.location(end)));
            assert_eq!(here, there, "{arc:?}");
        }
    }
}

fn check_locations(traits: &GeodesicTraits, arc: &GeodesicArc) {
    let is_along = arc.is_meridian() && sign(longitude_of(traits, arc)).is_eq();
    assert_eq!(arc.is_along_side(), is_along, "{arc:?}");
    for end in CurveEnd::BOTH {
        let (p, location) = (arc.end(end), traits.end_location(arc, end));
        assert_eq!(is_pole(p), location.v != Along::Inside, "{arc:?}");
        assert_eq!(traits.contracted_bottom_top(p), is_pole(p).then_some(end), "{arc:?}");
        let is_on_side = is_along || traits.is_on_left_right(p);
        assert_eq!(is_on_side, location.u != Along::Inside, "{arc:?}");
        assert!(!traits.is_on_left_right(p) || sign(place(traits, p)[0]).is_eq());
    }
    let [low, high] = range_of(traits, arc);
    assert!(arc.is_meridian() || low + NEARLY < high, "{arc:?}");
}

#[test]
fn arcs_of_another_identification_are_strange() {
    let mut rng = Rng::new(102);
    eprintln!("seed {}", rng.state());
    let all = identifications();
    for _ in 0..300 {
        let curve = random_geodesic(&mut rng, 2);
        for (i, traits) in all.iter().enumerate() {
            for other in &all[..i] {
                for arc in arcs_of(traits, &curve) {
                    // What would be cut otherwise, or ends on the other side, is not its own.
                    let is_same = arcs_of(other, &curve).iter().any(|own| {
                        own.circle() == arc.circle()
                            && CurveEnd::BOTH.iter().all(|&end| {
                                own.end(end) == arc.end(end) && own.location(end) == arc.location(end)
                            })
                    });
                    let is_piece = arcs_of(other, &curve).iter().any(|own| {
                        own.circle() == arc.circle()
                            && CurveEnd::BOTH.iter().all(|&end| is_on_arc(arc.end(end), own))
                    });
                    if is_same {
                        assert!(other.is_own_curve(&arc), "{arc:?}");
                    } else if !is_piece {
                        assert!(!other.is_own_curve(&arc), "{arc:?} of {:?}", other.identification());
                    }
                }
            }
        }
    }
}

#[test]
fn points_and_arcs() {
    let mut rng = Rng::new(103);
    eprintln!("seed {}", rng.state());
    let points = grid(2);
    for traits in identifications() {
        for arc in random_arcs(&traits, &mut rng, 150, 2) {
            for p in &points {
                check_point(&traits, &arc, p);
            }
        }
    }
}

fn check_point(traits: &GeodesicTraits, arc: &GeodesicArc, p: &Direction) {
    let is_on = is_on_arc(p, arc);
    assert_eq!(traits.is_on_curve(p, arc), is_on, "{p} on {arc:?}");
    if is_pole(p) {
        return;
    }
    let [u, v] = place(traits, p);
    let [low, high] = range_of(traits, arc);
    // A point on the identification has two longitudes.
    let places = if u == 0.0 { vec![0.0, TAU] } else { vec![u] };
    let is_in = places.iter().any(|&u| low - NEARLY < u && u < high + NEARLY);
    assert_eq!(traits.is_in_u_range(p, arc), is_in, "{p} and {arc:?}");
    if !is_in {
        return;
    }
    let expected = if arc.is_meridian() {
        let [min, max] = CurveEnd::BOTH.map(|end| place(traits, arc.end(end))[1]);
        if sign(v - min).is_lt() {
            Ordering::Less
        } else if sign(v - max).is_gt() {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    } else {
        sign(v - height_at(traits, arc.circle(), u))
    };
    assert_eq!(traits.compare_v_at_u(p, arc), expected, "{p} and {arc:?}");
    let by_key = traits.compare_v_at_u_by_key(p, &traits.side_key(arc));
    assert!(by_key.is_none_or(|by_key| by_key == expected), "{p} and {arc:?}");
    let is_end = CurveEnd::BOTH.into_iter().any(|end| arc.end(end) == p);
    if is_on && !is_end && (!traits.is_on_left_right(p) || arc.is_along_side()) {
        check_split(traits, arc, p);
    }
}

fn check_split(traits: &GeodesicTraits, arc: &GeodesicArc, p: &Direction) {
    let parts = traits.split(arc, p);
    assert_eq!((parts[0].end(CurveEnd::Max), parts[1].end(CurveEnd::Min)), (p, p));
    for part in &parts {
        assert!(traits.is_own_curve(part), "{part:?}");
        assert_eq!(part.is_directed_right(), arc.is_directed_right());
    }
    for (a, b) in [(&parts[0], &parts[1]), (&parts[1], &parts[0])] {
        let merged = traits.merge(a, b).unwrap();
        assert!(traits.is_mergeable(a, b));
        for end in CurveEnd::BOTH {
            assert_eq!((merged.end(end), merged.location(end)), (arc.end(end), arc.location(end)));
        }
    }
    assert!(traits.merge(&parts[0], &parts[0]).is_none() && !traits.is_mergeable(arc, &parts[1]));
    for (min, max, part) in [(None, Some(p), &parts[0]), (Some(p), None, &parts[1])] {
        for is_given in [false, true] {
            // An end that is given cuts nothing.
            let [given_min, given_max] = CurveEnd::BOTH.map(|end| is_given.then(|| arc.end(end)));
            let trimmed = traits.trim(arc, min.or(given_min), max.or(given_max));
            for end in CurveEnd::BOTH {
                assert_eq!((trimmed.end(end), trimmed.location(end)), (part.end(end), part.location(end)));
            }
        }
    }
    let opposite = traits.opposite(arc);
    assert_eq!((opposite.source(), opposite.target()), (arc.target(), arc.source()));
}

#[test]
fn arcs_that_touch_on_sides_are_not_merged() {
    let mut rng = Rng::new(104);
    eprintln!("seed {}", rng.state());
    for traits in identifications() {
        for _ in 0..100 {
            let curve = random_geodesic(&mut rng, 2);
            // A circle may have a vertex elsewhere.
            let arcs = if curve.is_full() { Vec::new() } else { arcs_of(&traits, &curve) };
            for pair in arcs.windows(2) {
                assert!(traits.merge(&pair[0], &pair[1]).is_none(), "{pair:?}");
                assert!(!traits.is_mergeable(&pair[1], &pair[0]), "{pair:?}");
            }
        }
    }
}

#[test]
fn ends_at_poles_are_ordered_by_longitude() {
    let mut rng = Rng::new(105);
    eprintln!("seed {}", rng.state());
    let points = grid(2);
    for traits in identifications() {
        let arcs = random_arcs(&traits, &mut rng, 300, 2);
        let ends: Vec<_> = arcs
            .iter()
            .flat_map(|arc| CurveEnd::BOTH.map(|end| (arc, end)))
            .filter(|(arc, end)| arc.location(*end).v != Along::Inside)
            .collect();
        assert!(ends.len() > 30);
        for &(a, end_a) in &ends {
            let u = longitude_of(&traits, a);
            for p in points.iter().filter(|p| !is_pole(p)) {
                let expected = sign(place(&traits, p)[0] - u);
                assert_eq!(traits.compare_u_near_end(p, a, end_a), expected, "{p} and {a:?}");
            }
            for &(b, end_b) in &ends {
                let expected = sign(u - longitude_of(&traits, b));
                assert_eq!(traits.compare_u_of_ends((a, end_a), (b, end_b)), expected, "{a:?} and {b:?}");
            }
        }
    }
}

#[test]
fn pictures_follow_the_arcs() {
    let mut rng = Rng::new(106);
    eprintln!("seed {}", rng.state());
    for traits in identifications() {
        for arc in random_arcs(&traits, &mut rng, 200, 3) {
            let mut line = Vec::new();
            traits.approx_curve(&arc, None, None, [0.0, -QUARTER, TAU, QUARTER], &mut line);
            let [low, high] = range_of(&traits, &arc);
            let [first, last] = [line[0], line[line.len() - 1]];
            assert!((first[0] - low).abs() < 1e-6 && (last[0] - high).abs() < 1e-6, "{arc:?}: {line:?}");
            for (end, [_, v]) in CurveEnd::BOTH.into_iter().zip([first, last]) {
                assert!((v - place(&traits, arc.end(end))[1]).abs() < 1e-6, "{arc:?}");
            }
            if arc.is_meridian() {
                continue;
            }
            for pair in line.windows(2) {
                let [u, v] = [0, 1].map(|i: usize| pair[1][i] - pair[0][i]);
                assert!((-1e-9..0.04).contains(&u) && v.abs() < 0.04, "{arc:?}: {pair:?}");
            }
            for &[u, v] in &line {
                assert!((v - height_at(&traits, arc.circle(), u)).abs() < 1e-6, "{arc:?} at {u}");
            }
        }
    }
}

/// Floats do not tell the longitude of a point that is nearer to a pole than they can say.
#[test]
fn pictures_of_arcs_from_beside_a_pole_have_few_points() {
    let target = Direction::from_i64([-1, 3, 0]).unwrap();
    for exponent in 0..400 {
        let height = Integer::from(10).pow(exponent);
        let start = Direction::new([Integer::ONE, Integer::ZERO, height]).unwrap();
        let arc = Geodesic::arc(start, target.clone()).unwrap();
        for traits in identifications() {
            let mut pieces = Vec::new();
            traits.make_u_monotone(&arc, &mut pieces);
            for piece in pieces {
                let Piece::Curve { curve, .. } = piece else { continue };
                let mut line = Vec::new();
                traits.approx_curve(&curve, None, None, [0.0, -QUARTER, TAU, QUARTER], &mut line);
                assert!(line.len() < 400, "10^{exponent}: {} points", line.len());
                assert!(line.iter().flatten().all(|value| value.is_finite()), "10^{exponent}");
            }
        }
    }
}

#[test]
fn points_near_parameters() {
    for traits in identifications() {
        for i in 0..40 {
            for j in -9..=9 {
                let [u, v] = [f64::from(i) * TAU / 40.0, f64::from(j) * HALF / 20.0];
                let p = traits.approx_to_point([u, v]).unwrap();
                let [near_u, near_v] = traits.approx_point(&p);
                let turns = (near_u - u).rem_euclid(TAU);
                assert!(
                    turns.min(TAU - turns) < 1e-6 && (near_v - v).abs() < 1e-6,
                    "{u} {v}: {near_u} {near_v}"
                );
            }
        }
        for bad in [[f64::NAN, 0.0], [0.0, f64::INFINITY], [1.0, QUARTER], [1.0, -2.0]] {
            assert!(traits.approx_to_point(bad).is_none(), "{bad:?}");
        }
    }
}
