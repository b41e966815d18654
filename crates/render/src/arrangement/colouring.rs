//! Colours for faces such that those that share an edge differ.
//!
//! 1. The face with the fewest neighbours is taken away, again and again: on a sphere it has at most five, on a torus six.
//! 2. Backwards, each face gets one of the first eight colours of the palette that none of these has, if possible of a hue that none of
//!    them has.
//!
//! # References
//! Matula and Beck, Smallest-last ordering and clustering and graph coloring algorithms, 1983.

use crate::colour::HUES;

/// The colours that are easy to tell apart.
const COLOURS: u32 = HUES.len() as u32;

/// For things that are numbered, given the pairs that should differ, the numbers of their colours. Pairs may be given several times; a
/// thing beside itself does not count. Without a need for another colour, a thing has that of its own number modulo eight.
///
/// # Complexity
/// O(n log n).
pub(super) fn colours(count: usize, pairs: impl Iterator<Item = [u32; 2]>) -> Vec<u32> {
    let mut beside: Vec<[u32; 2]> =
        pairs.filter(|[a, b]| a != b).flat_map(|[a, b]| [[a, b], [b, a]]).collect();
    beside.sort_unstable();
    beside.dedup();
    let starts: Vec<usize> =
        (0..=count).map(|thing| beside.partition_point(|[a, _]| (*a as usize) < thing)).collect();
    let neighbours = |thing: usize| beside[starts[thing]..starts[thing + 1]].iter().map(|&[_, b]| b as usize);

    let mut colours: Vec<Option<u32>> = vec![None; count];
    for &thing in smallest_last(count, neighbours).iter().rev() {
        let taken: Vec<u32> = neighbours(thing).filter_map(|other| colours[other]).collect();
        let first = thing as u32 % COLOURS;
        let hue = |colour: u32| HUES.get(colour as usize);
        let is_new = |colour: &u32| taken.iter().all(|&other| hue(other) != hue(*colour));
        let another = (first..COLOURS).chain(0..first).find(is_new);
        let free =
            || (first..COLOURS).chain(0..first).chain(COLOURS..).find(|colour| !taken.contains(colour));
        colours[thing] = another.or_else(free);
    }
    colours.into_iter().flatten().collect()
}

/// All things, each with the fewest neighbours among those after it and itself.
fn smallest_last<I: Iterator<Item = usize>>(count: usize, neighbours: impl Fn(usize) -> I) -> Vec<usize> {
    let mut degrees: Vec<usize> = (0..count).map(|thing| neighbours(thing).count()).collect();
    // By degree; a thing is in several, and counts in that of its degree.
    let mut waiting: Vec<Vec<usize>> = Vec::new();
    let put = |waiting: &mut Vec<Vec<usize>>, thing: usize, degree: usize| {
        if waiting.len() <= degree {
            waiting.resize(degree + 1, Vec::new());
        }
        waiting[degree].push(thing);
    };
    (0..count).rev().for_each(|thing| put(&mut waiting, thing, degrees[thing]));
    let mut is_gone = vec![false; count];
    let mut order = Vec::with_capacity(count);
    let mut degree = 0;
    while degree < waiting.len() {
        let Some(thing) = waiting[degree].pop() else {
            degree += 1;
            continue;
        };
        if is_gone[thing] || degrees[thing] != degree {
            continue;
        }
        is_gone[thing] = true;
        order.push(thing);
        for other in neighbours(thing).filter(|&other| !is_gone[other]) {
            degrees[other] -= 1;
            put(&mut waiting, other, degrees[other]);
        }
        degree = degree.saturating_sub(1);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(count: usize, pairs: &[[u32; 2]], most: u32) {
        let colours = colours(count, pairs.iter().copied());
        assert_eq!(colours.len(), count);
        for [a, b] in pairs.iter().filter(|[a, b]| a != b) {
            assert_ne!(colours[*a as usize], colours[*b as usize], "{a} {b}: {colours:?}");
        }
        assert!(colours.iter().all(|&colour| colour < most), "{colours:?}");
    }

    #[test]
    fn few_colours_suffice() {
        check(0, &[], 1);
        check(3, &[[1, 1]], 8);
        check(2, &[[1, 0], [0, 1], [0, 1]], 8);
        // A face with many around it, which are a cycle, and another outside of them.
        let wheel: Vec<[u32; 2]> =
            (1..30).flat_map(|k| [[0, k], [k, k % 29 + 1], [k, 30], [8, 16 + 8 * (k % 2)]]).collect();
        check(31, &wheel, 8);
        // The seven faces of a torus that all meet, and more of them than there are colours.
        let all = |n: u32| (0..n).flat_map(move |a| (0..a).map(move |b| [a, b])).collect::<Vec<_>>();
        check(7, &all(7), 8);
        check(8, &all(8), 8);
        check(11, &all(11), 11);
    }

    #[test]
    fn what_is_taken_away_has_few_neighbours_left() {
        // A triangulated strip, closed: each has four neighbours or less when it goes.
        let count = 500;
        let beside =
            |thing: usize| [1, 2, count - 2, count - 1].map(|step| (thing + step) % count).into_iter();
        let order = smallest_last(count, beside);
        let mut places = vec![0; count];
        order.iter().enumerate().for_each(|(place, &thing)| places[thing] = place);
        let later = |thing: usize| beside(thing).filter(|&other| places[other] > places[thing]).count();
        assert!((0..count).all(|thing| later(thing) <= 4));
        assert_eq!(order.len(), count);
        assert!(order.iter().skip(1).all(|&thing| later(thing) <= 3), "the strip is opened by the first");
    }
}
