//! Pieces of grids, and any cycles.

use super::*;
use testkit::{Rng, random_rotation};

/// A piece of a grid: cells that hang together along edges. Its cycles, simple ones, the outer one first.
fn piece(rng: &mut Rng, size: i64, odds: u64) -> Option<Vec<Vec<Place>>> {
    let cells: BTreeSet<Place> =
        (0..size).flat_map(|x| (0..size).map(move |y| [x, y])).filter(|_| rng.below(100) < odds).collect();
    let mut piece = BTreeSet::new();
    let mut open = vec![*cells.iter().nth(cells.len() / 2)?];
    while let Some([x, y]) = open.pop() {
        if cells.contains(&[x, y]) && piece.insert([x, y]) {
            open.extend([[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]]);
        }
    }
    // Edges with the piece on their left, by their starts.
    let mut edges: BTreeMap<Place, Vec<Place>> = BTreeMap::new();
    for &[x, y] in &piece {
        for ([a, b], beyond) in [
            ([[x, y], [x + 1, y]], [x, y - 1]),
            ([[x + 1, y], [x + 1, y + 1]], [x + 1, y]),
            ([[x + 1, y + 1], [x, y + 1]], [x, y + 1]),
            ([[x, y + 1], [x, y]], [x - 1, y]),
        ] {
            if !piece.contains(&beyond) {
                edges.entry(a).or_default().push(b);
            }
        }
    }
    let mut cycles = Vec::new();
    while let Some((&start, _)) = edges.iter().next() {
        // A walk that closes a cycle whenever it comes to a place again. Where the piece touches itself it
        // turns left: around the piece, and not over to the other side.
        let mut path = vec![start];
        while let Some(&at) = path.last() {
            let Some(next) = edges.get_mut(&at) else { break };
            let left = |to: &Place| match path.len() {
                0 | 1 => 0,
                n => cross(path[n - 2], at, *to),
            };
            let best =
                (0..next.len()).max_by_key(|&i| left(&next[i])).expect("edges of a place are not empty");
            let to = next.swap_remove(best);
            if next.is_empty() {
                edges.remove(&at);
            }
            if let Some(first) = path.iter().position(|place| *place == to) {
                cycles.push(path.split_off(first));
            }
            path.push(to);
        }
    }
    let area = |cycle: &[Place]| -> i64 {
        (0..cycle.len()).map(|i| cross([0, 0], cycle[i], cycle[(i + 1) % cycle.len()])).sum()
    };
    cycles.sort_by_key(|cycle| area(cycle) < 0);
    assert_eq!(cycles.iter().filter(|cycle| area(cycle) > 0).count(), 1, "one outer cycle");
    Some(cycles)
}

/// Leaves out some of the straight corners at which no other cycle needs a vertex.
fn thinned(rng: &mut Rng, cycles: &[Vec<Place>], odds: u64) -> Vec<Vec<Place>> {
    let mut uses: BTreeMap<Place, usize> = BTreeMap::new();
    cycles.iter().flatten().for_each(|place| *uses.entry(*place).or_default() += 1);
    let thin = |cycle: &Vec<Place>| {
        let n = cycle.len();
        let straight = |i: usize| cross(cycle[(i + n - 1) % n], cycle[i], cycle[(i + 1) % n]) == 0;
        let kept = (0..n).filter(|&i| !straight(i) || uses[&cycle[i]] > 1 || rng.below(100) >= odds);
        kept.map(|i| cycle[i]).collect()
    };
    cycles.iter().map(thin).collect()
}

#[test]
fn pieces_of_grids() {
    const SEED: u64 = 0x401e_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let (mut holes, mut touching) = (0, 0);
    for case in 0..1500 {
        let size = 2 + rng.below(7) as i64;
        let odds = 55 + rng.below(40);
        let Some(cycles) = piece(&mut rng, size, odds) else { continue };
        let odds = rng.below(101);
        let thin = thinned(&mut rng, &cycles, odds);
        let (mut places, indices) = indexed(&thin.iter().map(|cycle| &cycle[..]).collect::<Vec<_>>());
        let corners = thin.iter().map(Vec::len).sum::<usize>();
        let expected = corners + 2 * thin.len() - 4 - 2 * (corners - places.len());
        check(&format!("case {case}"), &places, &indices, expected);
        // Turned in space: wide coordinates, of different weights.
        let map = random_rotation(&mut rng, 4);
        let turn = |&place: &Place| map.apply(&Point3::from_i64(PLANES[case % PLANES.len()](place)));
        let points: Vec<Point3> = places.iter().map(turn).collect();
        let inner: Vec<&[u32]> = indices[1..].iter().map(|hole| &hole[..]).collect();
        let triangles = triangulate_with_holes(&points, &indices[0], &inner).expect("it could be cut before");
        check_triangles(&format!("case {case}, turned"), &places, &indices, &triangles);
        holes += thin.len() - 1;
        touching += corners - places.len();
        // In general position: every corner is moved a little, and all straight ones are there.
        let (mut moved, indices) = indexed(&cycles.iter().map(|cycle| &cycle[..]).collect::<Vec<_>>());
        for place in &mut moved {
            *place = place.map(|c| 10 * c + rng.below(5) as i64 - 2);
        }
        std::mem::swap(&mut places, &mut moved);
        let corners = cycles.iter().map(Vec::len).sum::<usize>();
        check(
            &format!("case {case}, moved"),
            &places,
            &indices,
            corners + 2 * cycles.len() - 4 - 2 * (corners - places.len()),
        );
    }
    println!("{holes} holes, {touching} touching corners");
    assert!(holes > 1000 && touching > 500, "{holes} holes, {touching} touching corners");
}

/// Any cycles over few places: they are cut into triangles that pass all checks, or refused.
#[test]
fn any_cycles() {
    const SEED: u64 = 0x401e_0002;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let (mut done, mut refused) = (0, 0);
    for case in 0..40_000 {
        let size = 2 + rng.below(4);
        let places: Vec<Place> =
            (0..3 + rng.below(9)).map(|_| [rng.below(size) as i64, rng.below(size) as i64]).collect();
        let mut cycle = |least: u64, more: u64| -> Vec<u32> {
            (0..least + rng.below(more)).map(|_| rng.below(places.len() as u64) as u32).collect()
        };
        let mut cycles = vec![cycle(3, 5)];
        for _ in 0..case % 3 {
            cycles.push(cycle(1, 4));
        }
        let lift = PLANES[case % PLANES.len()];
        match cut(&places, &cycles, lift) {
            Err(_) => refused += 1,
            // Seen from the front, which the outer cycle decides.
            Ok(triangles) => {
                if doubled_area(&places, &cycles[0]) < 0 {
                    cycles.iter_mut().for_each(|cycle| cycle.reverse());
                    let turned: Vec<[u32; 3]> = triangles.iter().map(|&[a, b, c]| [c, b, a]).collect();
                    check_triangles(&format!("case {case}"), &places, &cycles, &turned);
                } else {
                    check_triangles(&format!("case {case}"), &places, &cycles, &triangles);
                }
                done += 1;
            }
        }
    }
    println!("{done} cut, {refused} refused");
    assert!(done > 1000 && refused > 2000, "{done} cut, {refused} refused");
}
