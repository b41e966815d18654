//! The laws of each predicate, on pairs of curves, against sets of nodes.

use super::Random;
use super::lattice::{self, Node};
use super::own_curve::{Arc, Curve, Point, TaxicabTraits, next_meeting};
use splitstar_arrangement::Pieces;
use splitstar_arrangement::traits::{
    BasicTraits, CurveEnd, Intersection, Meeting, Multiplicity, UMonotoneTraits, Window,
};
use std::cmp::Ordering;
use std::collections::BTreeSet;

fn node(p: &Point) -> Node {
    (p.u, p.v)
}

/// The nodes of an arc, by its own predicates.
fn nodes(arc: &Arc) -> Vec<Node> {
    let [min, max] = CurveEnd::BOTH.map(|end| *TaxicabTraits.end_point(arc, end).unwrap());
    let on =
        |u: i64| (-60..60).map(|v| Point { u, v }).filter(|p| TaxicabTraits.is_on_curve(p, arc)).collect();
    (min.u..=max.u)
        .map(on)
        .map(|at: Vec<Point>| if let [p] = at[..] { node(&p) } else { panic!("{at:?}") })
        .collect()
}

/// The v-coordinate of a path one step from a node, if it goes there.
fn beside(path: &[Node], u: i64, step: i64) -> Option<i64> {
    path.iter().find(|p| p.0 == u + step).map(|p| p.1)
}

fn check_pair(a: (&Arc, &[Node]), b: (&Arc, &[Node]), seed: u64) {
    let mut common = Vec::new();
    TaxicabTraits.intersect(a.0, b.0, &mut common);
    let expected: Vec<Node> = a.1.iter().filter(|p| b.1.contains(p)).copied().collect();
    let mut found = Vec::new();
    for intersection in &common {
        match intersection {
            Intersection::Point(p, multiplicity) => {
                let gap = |step| Some(beside(a.1, p.u, step)?.cmp(&beside(b.1, p.u, step)?));
                let sides = match (gap(-1), gap(1)) {
                    (Some(left), Some(right)) if left == right => Multiplicity::Even,
                    (Some(_), Some(_)) => Multiplicity::Odd,
                    _ => Multiplicity::Unknown,
                };
                assert_eq!(*multiplicity, sides, "seed {seed}: {a:?} {b:?}");
                found.push(node(p));
            }
            Intersection::Overlap(arc) => {
                assert!(nodes(arc).len() > 1);
                found.extend(nodes(arc));
            }
        }
    }
    assert_eq!(found, expected, "seed {seed}: in order, each once: {a:?} {b:?}");
    for &(u, v) in &expected {
        let p = Point { u, v };
        if let (Some(left), Some(right)) = (beside(a.1, u, -1), beside(b.1, u, -1)) {
            assert_eq!(TaxicabTraits.compare_v_at_u_left(a.0, b.0, &p), left.cmp(&right), "seed {seed}");
        }
        let (Some(in_a), Some(in_b)) = (beside(a.1, u, 1), beside(b.1, u, 1)) else { continue };
        assert_eq!(TaxicabTraits.compare_v_at_u_right(a.0, b.0, &p), in_a.cmp(&in_b), "seed {seed}");
        if in_a < in_b {
            check_next_meeting(a.0, b.0, Some(&p), seed);
        }
    }
    let (p, above) = (a.1[0], b.1.iter().find(|q| q.0 == a.1[0].0));
    if above.is_some_and(|q| p.1 < q.1) {
        check_next_meeting(a.0, b.0, Some(&Point { u: p.0, v: p.1 }), seed);
    }
}

/// The quick version against the provided one.
fn check_next_meeting(below: &Arc, above: &Arc, after: Option<&Point>, seed: u64) {
    let [a, b] = [below, above].map(|arc| TaxicabTraits.end_point(arc, CurveEnd::Max).unwrap());
    let (until, first_to_end) = if a <= b { (a, 0) } else { (b, 1) };
    let window = Window { after, until: Some(until), first_to_end };
    let provided = TaxicabTraits.next_meeting(below, above, window);
    let quick = next_meeting(below, above, window);
    match (&provided, &quick) {
        // It is always right not to know.
        (Meeting::At(p, _), Meeting::At(q, Multiplicity::Unknown)) => assert_eq!(p, q, "seed {seed}"),
        _ => assert_eq!(provided, quick, "seed {seed}: {below:?} {above:?} {window:?}"),
    }
}

#[test]
fn the_model_keeps_the_laws() {
    for seed in 0..300 {
        let curves = Random(seed).curves(5, 7);
        let paths: Vec<Vec<Node>> = curves
            .iter()
            .flat_map(lattice::pieces)
            .map(|(path, _)| path)
            .filter(|path| path.len() > 1)
            .collect();
        let arcs = Pieces::of_curves(&TaxicabTraits, &curves).curves().to_vec();
        assert_eq!(arcs.iter().map(nodes).collect::<Vec<_>>(), paths, "seed {seed}: {curves:?}");
        for (a, path_a) in arcs.iter().zip(&paths) {
            for (b, path_b) in arcs.iter().zip(&paths) {
                check_pair((a, path_a), (b, path_b), seed);
            }
            for (i, &(u, v)) in path_a.iter().enumerate() {
                for (rise, order) in [(-1, Ordering::Less), (0, Ordering::Equal), (1, Ordering::Greater)] {
                    assert_eq!(TaxicabTraits.compare_v_at_u(&Point { u, v: v + rise }, a), order);
                }
                if i == 0 || i + 1 == path_a.len() {
                    continue;
                }
                let [smaller, greater] = TaxicabTraits.split(a, &Point { u, v });
                assert_eq!((nodes(&smaller), nodes(&greater)), (path_a[..=i].to_vec(), path_a[i..].to_vec()));
                for [a, b] in [[&smaller, &greater], [&greater, &smaller]] {
                    assert_eq!(nodes(&TaxicabTraits.merge(a, b).unwrap()), *path_a, "seed {seed}");
                }
            }
        }
        check_merges(&arcs, seed);
    }
}

/// Two arcs that share an end are merged if and only if together they have one tip at most.
fn check_merges(arcs: &[Arc], seed: u64) {
    for a in arcs {
        for b in arcs {
            let (left, right) = (nodes(a), nodes(b));
            let merged = TaxicabTraits.merge(a, b).map(|arc| nodes(&arc));
            if left.last() != right.first() {
                assert!(merged.is_none() || right.last() == left.first(), "seed {seed}: {a:?} {b:?}");
                continue;
            }
            let both = [&left[..], &right[1..]].concat();
            let turns: BTreeSet<i64> = both.windows(3).filter(|w| w[2].1 == w[0].1).map(|w| w[1].0).collect();
            assert_eq!(merged, (turns.len() < 2).then_some(both), "seed {seed}: {a:?} {b:?}");
        }
    }
}

#[test]
fn the_greatest_coordinates_do_not_overflow() {
    let mut curves = Vec::new();
    for x in [i32::MIN, i32::MAX] {
        for y in [i32::MIN, i32::MAX] {
            curves.push(Curve::Circle { centre: [x, y], radius: u32::MAX });
            curves.extend([false, true].map(|opens_up| Curve::Arc {
                tip: [x, y],
                opens_up,
                range: [i32::MIN, i32::MAX],
            }));
        }
    }
    let arcs = Pieces::of_curves(&TaxicabTraits, &curves).curves().to_vec();
    for a in &arcs {
        for b in &arcs {
            TaxicabTraits.intersect(a, b, &mut Vec::new());
            let _ = TaxicabTraits.merge(a, b);
        }
    }
}
