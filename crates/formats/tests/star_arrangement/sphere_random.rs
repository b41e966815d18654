//! Random arrangements on the sphere come back, their texts do not depend on the order of curves, and changed texts are read or refused.

use super::random::{Numbers, changed};
use super::sphere::{Arc, IDENTIFICATIONS, chains, sphere, traits};
use super::{comes_back, read, write};
use arrangement::Arrangement;
use arrangement::models::Geodesic;
use arrangement::topology::Sphere;
use arrangement::traits::CurveEnd;
use splitstar_formats::{StarArrangement, read_arrangement};

/// Directions of small integers: everything degenerate happens.
fn small(numbers: &mut Numbers, bound: i64) -> [i64; 3] {
    loop {
        let p = [0; 3].map(|_: i64| numbers.below(2 * bound as u64 + 1) as i64 - bound);
        if p != [0; 3] {
            return p;
        }
    }
}

fn random_arcs(numbers: &mut Numbers) -> Vec<Arc> {
    let bound = 1 + numbers.below(2) as i64;
    let count = numbers.below(8);
    let arc = |numbers: &mut Numbers| {
        let [p, q, r] = [0; 3].map(|_| small(numbers, bound));
        match numbers.below(12) {
            0..4 => Arc::Short(p, q),
            4 | 5 => Arc::Via(p, q, r),
            6 => Arc::Via(p, q, p.map(|x| -x)),
            7 => Arc::Circle(p),
            8 => Arc::Full(p, q),
            9 => Arc::Point(p),
            _ => Arc::Polyline((0..2 + numbers.below(5)).map(|_| small(numbers, bound)).collect()),
        }
    };
    (0..count).map(|_| arc(numbers)).collect()
}

fn turned(arc: &Arc) -> Arc {
    match arc {
        Arc::Short(p, q) => Arc::Short(*q, *p),
        Arc::Via(p, r, q) => Arc::Via(*q, *r, *p),
        Arc::Circle(n) => Arc::Circle(n.map(|x| -x)),
        Arc::Full(p, n) => Arc::Full(*p, n.map(|x| -x)),
        Arc::Polyline(points) => Arc::Polyline(points.iter().rev().copied().collect()),
        Arc::Point(p) if p.iter().all(|x| x.abs() < 1 << 60) => Arc::Point(p.map(|x| 3 * x)),
        Arc::Point(p) => Arc::Point(*p),
    }
}

#[test]
fn texts_come_back_and_do_not_depend_on_the_order() {
    let mut numbers = Numbers::new(21);
    for (name, make) in [("arcs", sphere as fn([i64; 2], &[Arc]) -> StarArrangement), ("chains", chains)] {
        let mut longest = 0;
        for case in 0..800 {
            let mut arcs = random_arcs(&mut numbers);
            let identification = IDENTIFICATIONS[numbers.below(6) as usize];
            println!("{name} {case} {identification:?} {arcs:?}");
            let text = comes_back(&make(identification, &arcs));
            longest = longest.max(text.len());
            numbers.shuffle(&mut arcs);
            let again: Vec<Arc> = arcs.iter().map(turned).collect();
            assert_eq!(write(&make(identification, &again)), text, "{name} {case}: {arcs:?}");
            // Nobody sees where the parameter space is cut.
            let other = make(IDENTIFICATIONS[case % 6], &arcs).counts();
            assert_eq!(make(identification, &arcs).counts(), other, "{name} {case}: {arcs:?}");
        }
        assert!(longest > 1000, "{name}: {longest}");
    }
}

/// Coordinates of many digits, and crossings of what has them.
#[test]
fn large_coordinates_come_back() {
    let mut numbers = Numbers::new(25);
    for (case, bits) in (0..60).zip([20, 34, 45, 62].into_iter().cycle()) {
        let large = |numbers: &mut Numbers| {
            [0; 3].map(|_: i64| numbers.next() as i64 >> (63 - bits)).map(|x| if x == 0 { 1 } else { x })
        };
        let arcs: Vec<Arc> = (0..8)
            .map(|i| match i {
                0 => Arc::Circle(large(&mut numbers)),
                1 => Arc::Point(large(&mut numbers)),
                2 => Arc::Polyline((0..4).map(|_| large(&mut numbers)).collect()),
                _ => Arc::Short(large(&mut numbers), large(&mut numbers)),
            })
            .collect();
        let identification = IDENTIFICATIONS[case % 6];
        let make = if case % 8 < 4 { sphere } else { chains };
        let text = comes_back(&make(identification, &arcs));
        let again: Vec<Arc> = arcs.iter().rev().map(turned).collect();
        assert_eq!(write(&make(identification, &again)), text, "{case}: {arcs:?}");
    }
}

/// Arcs, and the same as chains of one piece; and once more each edge as a curve of its own.
#[test]
fn texts_do_not_depend_on_what_curves_the_cells_come_from() {
    let mut numbers = Numbers::new(22);
    for case in 0..400 {
        let mut arcs = random_arcs(&mut numbers);
        arcs.retain(|arc| !matches!(arc, Arc::Polyline(_)));
        println!("{case} {arcs:?}");
        let identification = IDENTIFICATIONS[case % 6];
        let made = sphere(identification, &arcs);
        let text = write(&made);
        assert_eq!(write(&chains(identification, &arcs)), text, "{case}: {arcs:?}");
        let StarArrangement::Sphere(made) = made else { panic!("arcs") };
        let edges = made.dcel().edges().map(|e| made.make_edge_curve(e));
        let edges = edges.map(|arc| {
            let [min, max] = CurveEnd::BOTH.map(|end| arc.end(end).clone());
            Geodesic::arc_around(min, max, arc.circle().clone()).unwrap()
        });
        let points = made.vertices().filter_map(|v| made.point(v).cloned()).map(Geodesic::point);
        let curves: Vec<Geodesic> = edges.chain(points).collect();
        let again = Arrangement::of_curves(traits(identification), Sphere, &curves);
        // All vertices are given as points.
        assert_eq!(write(&again.into()), text.replace(" artificial", ""), "{case}: {arcs:?}");
    }
}

/// Whatever is changed in a text, it is read, and then is an arrangement, or it is refused with a short message and a line.
#[test]
fn changed_texts_are_read_or_refused() {
    let mut numbers = Numbers::new(23);
    let (mut read_back, mut refused) = (0, 0);
    for case in 0..1000 {
        let arcs = random_arcs(&mut numbers);
        let identification = [[-1, 0], [1, 1], [0, 1]][case % 3];
        let text =
            write(&if case % 2 == 0 { sphere(identification, &arcs) } else { chains(identification, &arcs) });
        for _ in 0..8 {
            let changed = changed(&text, &mut numbers);
            match read_arrangement(changed.as_bytes(), None) {
                Ok(arrangement) => {
                    comes_back(&arrangement);
                    read_back += 1;
                }
                Err(error) => {
                    let message = error.to_string();
                    assert!(message.len() < 400 && !message.contains(char::is_control), "{message}");
                    assert!(message.starts_with("line "), "{case}: {message}\n{changed}");
                    refused += 1;
                }
            }
        }
    }
    println!("{read_back} read, {refused} refused");
    assert!(read_back > 100 && refused > 2000, "{read_back} {refused}");
}

#[test]
fn prefixes_are_refused() {
    let mut numbers = Numbers::new(24);
    for case in 0..4 {
        let arcs = random_arcs(&mut numbers);
        let text = write(&if case % 2 == 0 { sphere([-1, 0], &arcs) } else { chains([-1, 0], &arcs) });
        for length in 0..text.len() - 1 {
            assert!(read_arrangement(&text.as_bytes()[..length], None).is_err(), "{case} {length}");
        }
        read(&text[..text.len() - 1]);
    }
}
