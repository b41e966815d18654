//! Random placements: anywhere, deep inside, and exact touches of every kind.

use crate::number::{Number, Triple, minus, negated, plus};
use crate::planes::Brute;
use crate::solid::Solid;
use exact::{Integer, Rational};
use splitstar_proximity::Feature;
use std::collections::BTreeMap;
use testkit::Rng;

/// Coordinates of placements are multiples of this fraction of the grid of the vertices.
pub(crate) const PARTS: i64 = 16;

/// What is known of a placement by the way it was made.
#[derive(Clone, Copy, PartialEq, Eq, Debug, PartialOrd, Ord)]
pub(crate) enum Made {
    Anywhere,
    Deep,
    /// Features of these dimensions touch, and their edges, if so many are there, are parallel or not.
    Touch {
        dimensions: [usize; 2],
        is_parallel: bool,
    },
}

/// A translation over the scale of the brute force, and what is known of it.
#[derive(Clone, Debug)]
pub(crate) struct Placement<N> {
    pub(crate) s: Triple<N>,
    pub(crate) made: Made,
}

/// What the placements of a pair were.
#[derive(Default, Debug)]
pub(crate) struct Census {
    /// How often each kind was made.
    made: BTreeMap<Made, usize>,
    /// How often the features that were told to touch had these dimensions: the least ones that contain the whole contact.
    told: BTreeMap<[usize; 2], usize>,
}

impl Census {
    pub(crate) fn note(&mut self, made: Made) {
        *self.made.entry(made).or_default() += 1;
    }

    pub(crate) fn note_contact(&mut self, features: [Feature; 2]) {
        let dimensions = features.map(|feature| match feature {
            Feature::Vertex(_) => 0,
            Feature::Edge(_) => 1,
            Feature::Facet(_) => 2,
        });
        *self.told.entry(dimensions).or_default() += 1;
    }

    pub(crate) fn add(&mut self, other: Self) {
        other.made.into_iter().for_each(|(made, count)| *self.made.entry(made).or_default() += count);
        other.told.into_iter().for_each(|(told, count)| *self.told.entry(told).or_default() += count);
    }

    /// Whether extreme points of these dimensions were put together.
    pub(crate) fn has_touch(&self, dimensions: [usize; 2], is_parallel: bool) -> bool {
        self.made.contains_key(&Made::Touch { dimensions, is_parallel })
    }

    /// How often features of these dimensions were told to touch.
    pub(crate) fn contacts(&self, dimensions: [usize; 2]) -> usize {
        self.told.get(&dimensions).copied().unwrap_or(0)
    }
}

/// A translation as it is.
pub(crate) fn rational<N: Number>(s: &Triple<N>, scale: &Integer) -> [Rational; 3] {
    s.each_ref().map(|c| Rational::new(c.integer(), scale.clone()).expect("a scale is not zero"))
}

/// The placement of that number: a third of each of anywhere, deep, and touching. The scale of `brute` is a multiple of [`PARTS`], and its
/// vertices are multiples of `PARTS`.
pub(crate) fn placement<N: Number>(brute: &Brute<N>, number: usize, rng: &mut Rng) -> Placement<N> {
    match number % 3 {
        0 => Placement { s: anywhere(brute, rng), made: Made::Anywhere },
        1 => {
            let s = minus(&mean_of_vertices(&brute.p, rng), &mean_of_vertices(&brute.q, rng));
            Placement { s, made: Made::Deep }
        }
        _ => touch(brute, rng),
    }
}

fn small<N: Number>(value: i64) -> N {
    N::of(&Integer::from(value))
}

fn scaled<N: Number>(vector: &Triple<N>, factor: i64) -> Triple<N> {
    vector.each_ref().map(|c| c.mul(&small(factor)))
}

/// A mean of sixteen vertices, chosen with repetition.
fn mean_of_vertices<N: Number>(solid: &Solid<N>, rng: &mut Rng) -> Triple<N> {
    let chosen: Vec<usize> = (0..PARTS).map(|_| rng.index(solid.vertices.len())).collect();
    mean(solid, &chosen)
}

/// The mean of sixteen vertices.
fn mean<N: Number>(solid: &Solid<N>, chosen: &[usize]) -> Triple<N> {
    let zero = [0; 3].map(small::<N>);
    let sum = chosen.iter().fold(zero, |sum, &v| plus(&sum, &solid.vertices[v]));
    sum.map(|c| c.div_exact(&small(PARTS)))
}

/// In the box of all differences, made twice as large; once in four times by a whole number of units of the grid of vertices.
fn anywhere<N: Number>(brute: &Brute<N>, rng: &mut Rng) -> Triple<N> {
    let ends = |solid: &Solid<N>, axis: usize| {
        let values = || solid.vertices.iter().map(|v| v[axis].clone());
        let (least, most) =
            (values().min_by(|a, b| a.sub(b).sign()), values().max_by(|a, b| a.sub(b).sign()));
        [least, most].map(|value| value.expect("there are vertices").integer())
    };
    let unit = Integer::from(PARTS);
    let is_whole = rng.one_in(4);
    [0, 1, 2].map(|axis: usize| {
        let ([low_p, high_p], [low_q, high_q]) = (ends(&brute.p, axis), ends(&brute.q, axis));
        let (low, high) = (&low_p - &high_q, &high_p - &low_q);
        let width = &high - &low + &unit * Integer::from(4);
        let random = (&width * Integer::from(rng.below(1 << 20) as i64)) >> 19_u32;
        let value = low - &unit * Integer::from(2) - (width >> 1_u32) + random;
        N::of(&if is_whole { value.div_floor(&unit) * unit.clone() } else { value })
    })
}

/// A direction, the extreme points of both in it, and a point in the relative interior of some of each that come to the same place.
fn touch<N: Number>(brute: &Brute<N>, rng: &mut Rng) -> Placement<N> {
    let n = direction(brute, rng);
    let (_, of_p) = brute.p.extreme(&n);
    let (_, of_q) = brute.q.extreme(&negated(&n));
    let is_parallel = are_parallel(brute, &of_p, &of_q);
    let dimensions = [brute.p.dimension_of(&of_p), brute.q.dimension_of(&of_q)];
    let s = minus(&point_of(&brute.p, &of_p, rng), &point_of(&brute.q, &of_q, rng));
    Placement { s, made: Made::Touch { dimensions, is_parallel } }
}

/// Whether two edges have the same direction; of other features, whether an edge of the first is parallel to one of the second.
fn are_parallel<N: Number>(brute: &Brute<N>, of_p: &[usize], of_q: &[usize]) -> bool {
    let edges = |solid: &Solid<N>, vertices: &[usize]| -> Vec<Triple<N>> {
        let is_in = |edge: &&[usize; 2]| edge.iter().all(|v| vertices.contains(v));
        solid.edges.iter().filter(is_in).map(|&edge| solid.edge_vector(edge)).collect()
    };
    let (of_p, of_q) = (edges(&brute.p, of_p), edges(&brute.q, of_q));
    of_p.iter().any(|u| of_q.iter().any(|v| crate::number::is_zero(&crate::number::cross(u, v))))
}

/// A point of the hull of vertices: of all, or of some only.
fn point_of<N: Number>(solid: &Solid<N>, vertices: &[usize], rng: &mut Rng) -> Triple<N> {
    let parts = PARTS as usize;
    let mut chosen = vertices.to_vec();
    if rng.one_in(3) || chosen.len() > parts {
        rng.shuffle(&mut chosen);
        chosen.truncate(1 + rng.index(chosen.len().min(parts)));
    }
    while chosen.len() < parts {
        chosen.push(chosen[rng.index(chosen.len())]);
    }
    mean(solid, &chosen)
}

/// A direction in which points of both are extreme: of a facet of the set of all differences, between two of them, in the fan of an edge
/// of either, or any.
fn direction<N: Number>(brute: &Brute<N>, rng: &mut Rng) -> Triple<N> {
    let any = |rng: &mut Rng| loop {
        let n = [0; 3].map(|_: i64| rng.within(9));
        if n != [0; 3] {
            return n.map(small::<N>);
        }
    };
    let candidates = &brute.candidates;
    if candidates.is_empty() {
        return in_flat(brute, rng).unwrap_or_else(|| any(rng));
    }
    let between = |a: &Triple<N>, b: &Triple<N>, rng: &mut Rng| {
        let factors = [0; 2].map(|_: i64| rng.between(1, 3) as i64);
        plus(&scaled(a, factors[0]), &scaled(b, factors[1]))
    };
    let n = match rng.below(6) {
        0..=2 => rng.choose(candidates).normal.clone(),
        3 => between(&rng.choose(candidates).normal.clone(), &rng.choose(candidates).normal.clone(), rng),
        4 => {
            let is_p = rng.one_in(2);
            let solid = if is_p { &brute.p } else { &brute.q };
            let around: Vec<&Triple<N>> = match solid.edges.is_empty() {
                true => Vec::new(),
                false => {
                    let edge = rng.choose(&solid.edges);
                    let has = |cycle: &[usize]| edge.iter().all(|v| cycle.contains(v));
                    solid.facets.iter().filter(|(cycle, _)| has(cycle)).map(|(_, normal)| normal).collect()
                }
            };
            match around[..] {
                [a, b] => {
                    let n = between(a, b, rng);
                    if is_p { n } else { negated(&n) }
                }
                _ => any(rng),
            }
        }
        _ => any(rng),
    };
    if crate::number::is_zero(&n) { any(rng) } else { n }
}

/// A direction perpendicular to an edge of either, in the plane of both.
fn in_flat<N: Number>(brute: &Brute<N>, rng: &mut Rng) -> Option<Triple<N>> {
    let solids = [&brute.p, &brute.q];
    let solid = solids[rng.index(2)];
    let (_, normal) = solids.iter().find_map(|solid| solid.facets.first())?;
    if solid.edges.is_empty() || rng.one_in(4) {
        return None;
    }
    let n = crate::number::cross(normal, &solid.edge_vector(*rng.choose(&solid.edges)));
    let n = if rng.one_in(2) { n } else { negated(&n) };
    Some(if crate::number::is_zero(&n) { normal.clone() } else { n })
}
