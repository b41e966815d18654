//! The placements of a row, the same for everybody: doubles, drawn from a fixed seed.

use std::fmt::Write as _;

use proximity::{Relation, RelativePlacement, Translation};
use testkit::Rng;

use super::rows::{Order, Query};

/// How many placements a row has.
const COUNT: usize = 10_000;
/// The diameter of the spheres.
const DIAMETER: f64 = 2.0;
const STEP: f64 = DIAMETER / 1_000.0;
/// No placement is farther from the origin.
const FARTHEST: f64 = 1.5 * DIAMETER;
const SEED: u64 = 1;

pub(super) type Place = [f64; 3];

/// Draws the placements of a row.
pub(super) fn draw(query: Query, order: Order, sum: &RelativePlacement) -> Vec<Place> {
    let mut rng = Rng::new(SEED);
    let fits = |place: &Place| {
        let s = Translation::from_f64(*place).expect("the numbers are finite");
        let wanted = match query {
            Query::Distance => Relation::Disjoint,
            Query::Relation => return length(place) <= FARTHEST,
            Query::Penetration => Relation::Overlapping,
        };
        length(place) <= FARTHEST && sum.relation(&s, None).0 == wanted
    };
    let mut places = Vec::with_capacity(COUNT);
    match order {
        Order::Random => {
            while places.len() < COUNT {
                let place = in_ball(&mut rng, FARTHEST);
                if fits(&place) {
                    places.push(place);
                }
            }
        }
        Order::Coherent => {
            let mut place = in_ball(&mut rng, FARTHEST);
            while !fits(&place) {
                place = in_ball(&mut rng, FARTHEST);
            }
            let mut way = unit(&mut rng);
            while places.len() < COUNT {
                let bent = unit(&mut rng);
                let next = normalized([0, 1, 2].map(|i| way[i] + 0.05 * bent[i]));
                let there = [0, 1, 2].map(|i| place[i] + STEP * next[i]);
                if fits(&there) {
                    (place, way) = (there, next);
                    places.push(place);
                } else {
                    way = unit(&mut rng);
                }
            }
        }
    }
    places
}

/// Translations deep inside, where programs with floats are known to find too small a depth: more of them near the middle.
pub(super) fn deep(count: usize) -> Vec<Place> {
    let mut rng = Rng::new(SEED);
    (0..count)
        .map(|_| {
            let way = unit(&mut rng);
            let distance = 0.35 * DIAMETER * fraction(&mut rng);
            way.map(|x| distance * x)
        })
        .collect()
}

/// The file of placements: shortest decimals that give the doubles back.
pub(super) fn text(places: &[Place]) -> String {
    let mut text = String::new();
    for [x, y, z] in places {
        writeln!(text, "{x:?} {y:?} {z:?}").expect("writing to a string succeeds");
    }
    text
}

/// The hash of the bits of all numbers in order, as every driver makes it.
pub(super) fn hash(places: &[Place]) -> String {
    let fold = |hash: u64, x: &f64| (hash ^ x.to_bits()).wrapping_mul(0x0100_0000_01B3);
    format!("{:016x}", places.iter().flatten().fold(0xCBF2_9CE4_8422_2325, fold))
}

/// From 0 to 1.
fn fraction(rng: &mut Rng) -> f64 {
    (rng.bits() >> 11) as f64 / (1_u64 << 53) as f64
}

fn in_ball(rng: &mut Rng, radius: f64) -> Place {
    loop {
        let place = [0.0; 3].map(|_: f64| radius * (2.0 * fraction(rng) - 1.0));
        if length(&place) <= radius {
            return place;
        }
    }
}

fn unit(rng: &mut Rng) -> Place {
    loop {
        let way = in_ball(rng, 1.0);
        if length(&way) > 0.1 {
            return normalized(way);
        }
    }
}

fn normalized(way: Place) -> Place {
    let length = length(&way);
    way.map(|x| x / length)
}

fn length(place: &Place) -> f64 {
    place.iter().map(|x| x * x).sum::<f64>().sqrt()
}
