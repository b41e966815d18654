//! Arcs of small coordinates.

use crate::agree::{assert_agrees, direction, map_of};
use arrangement::models::Geodesic;
use exact::spherical::GreatCircle;
use testkit::{Rng, geodesic_arcs};

fn vector(rng: &mut Rng, range: i64) -> [i64; 3] {
    loop {
        let vector = std::array::from_fn(|_| rng.within(range));
        if vector != [0; 3] {
            return vector;
        }
    }
}

/// An arc, a long one, half a circle, a circle with a vertex or without, or a point.
pub(crate) fn geodesic(rng: &mut Rng, range: i64) -> Geodesic {
    let [p, q, r] = [(); 3].map(|()| direction(vector(rng, range)));
    let kind = rng.below(8);
    if kind == 0 {
        return Geodesic::point(p);
    }
    let (Some(circle), Some(other)) = (GreatCircle::through(&p, &q), GreatCircle::through(&p, &r)) else {
        return geodesic(rng, range);
    };
    let arc = |source, target, circle| Geodesic::arc_around(source, target, circle).expect("on the circle");
    match kind {
        1 => Geodesic::circle(circle),
        2 => arc(p.clone(), p, circle),
        3 => arc(p.clone(), p.opposite(), other),
        4 => arc(p, q, circle.opposite()),
        _ => arc(p, q, circle),
    }
}

#[test]
fn arcs_of_small_coordinates() {
    let mut rng = Rng::new(0x0c0b_e0ac);
    for round in 0..600 {
        let seed = rng.state();
        let (count, range) = (1 + rng.below(7), 1 + round % 4);
        let geodesics: Vec<Geodesic> = (0..count).map(|_| geodesic(&mut rng, range)).collect();
        assert_agrees(&map_of(&geodesics), &geodesics, &format!("seed {seed}"));
    }
}

/// An arc with a wide normal and an end at a corner of the cube or on an edge of it.
fn wide_from_border(rng: &mut Rng, range: i64) -> Geodesic {
    loop {
        let size = 1 + rng.below(range as u64) as i64;
        let mut end = [(); 3].map(|()| if rng.one_in(2) { size } else { -size });
        if rng.one_in(2) {
            end[rng.below(3) as usize] = rng.within(size);
        }
        let [end, other] = [end, vector(rng, range)].map(direction);
        let Some(circle) = GreatCircle::through(&end, &other) else { continue };
        let [source, target] = if rng.one_in(2) { [end, other] } else { [other, end] };
        let circle = if rng.one_in(2) { circle.opposite() } else { circle };
        return Geodesic::arc_around(source, target, circle).expect("on the circle");
    }
}

const WIDE: [i64; 4] = [1 << 20, 1 << 31, 1 << 45, i64::MAX / 4];

#[test]
fn wide_arcs() {
    let mut rng = Rng::new(0x0c0b_e31d);
    for round in 0..200 {
        let (seed, range) = (rng.state(), WIDE[round % 4]);
        let geodesics: Vec<Geodesic> = (0..6).map(|_| geodesic(&mut rng, range)).collect();
        assert_agrees(&map_of(&geodesics), &geodesics, &format!("seed {seed}, range {range}"));
    }
}

#[test]
fn wide_arcs_from_edges_and_corners_of_the_cube() {
    let mut rng = Rng::new(0x0c0b_e31e);
    for round in 0..200 {
        let (seed, range) = (rng.state(), WIDE[round % 4]);
        let mut geodesics: Vec<Geodesic> = (0..4).map(|_| wide_from_border(&mut rng, range)).collect();
        // Several at one place.
        let [p, r] = [0, 1].map(|i: usize| geodesics[i].source().expect("an arc has ends").clone());
        if let Ok(arc) = Geodesic::arc(p, r) {
            geodesics.push(arc);
        }
        assert_agrees(&map_of(&geodesics), &geodesics, &format!("seed {seed}, range {range}"));
    }
}

#[test]
fn many_arcs() {
    let arcs: Vec<Geodesic> = geodesic_arcs(60, 1)
        .objects
        .into_iter()
        .map(|[a, b, c, d, e, f]| {
            Geodesic::arc(direction([a, b, c]), direction([d, e, f])).expect("not opposite")
        })
        .collect();
    assert_agrees(&map_of(&arcs), &arcs, "60 arcs");
}
