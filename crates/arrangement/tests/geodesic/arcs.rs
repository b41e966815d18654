//! Curves with small coordinates, so that everything degenerate happens.

use crate::oracle::direction;
use exact::spherical::{Direction, GreatCircle};
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::traits::{ArrangementTraits, Piece};
use testkit::Rng;

pub(crate) fn identifications() -> Vec<GeodesicTraits> {
    [[-1, 0], [0, 1], [1, 1], [2, -1], [1, 0]]
        .into_iter()
        .map(|[x, y]| GeodesicTraits::with_identification([x.into(), y.into()]).unwrap())
        .collect()
}

/// All directions with coordinates up to a size; some several times.
pub(crate) fn grid(size: i64) -> Vec<Direction> {
    let range = || -size..=size;
    let all = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    let mut grid: Vec<Direction> = Vec::new();
    for p in all.filter_map(Direction::from_i64) {
        if !grid.contains(&p) {
            grid.push(p);
        }
    }
    grid
}

pub(crate) fn random_direction(rng: &mut Rng, size: i64) -> Direction {
    loop {
        // Often on a pole, or beside one.
        let xy = if rng.one_in(6) { 0 } else { size };
        if let Some(p) = Direction::from_i64([rng.within(xy), rng.within(xy), rng.within(size)]) {
            return p;
        }
    }
}

pub(crate) fn random_circle(rng: &mut Rng, size: i64) -> GreatCircle {
    let p = random_direction(rng, size);
    // Often a meridian.
    let q = if rng.one_in(4) { Direction::NORTH } else { random_direction(rng, size) };
    GreatCircle::through(&p, &q).unwrap_or_else(|| GreatCircle::new(&p.vector()).unwrap())
}

/// An arc of any kind, a circle or now and then a point.
pub(crate) fn random_geodesic(rng: &mut Rng, size: i64) -> Geodesic {
    loop {
        let [p, q, r] = [(); 3].map(|()| random_direction(rng, size));
        let made = match rng.index(8) {
            0 => Ok(Geodesic::circle(random_circle(rng, size))),
            1 => {
                let circle = random_circle(rng, size);
                let other = GreatCircle::new(&p.vector()).unwrap();
                let Some(on) = Direction::crossing(&circle, &other) else { continue };
                Geodesic::arc_around(on.clone(), if rng.one_in(2) { on.opposite() } else { on }, circle)
            }
            2 => Geodesic::arc_via(p.clone(), &r, p.opposite()),
            3 | 4 => match Geodesic::arc(p.clone(), q.clone()) {
                // The other way round.
                Ok(arc) => Geodesic::arc_around(p, q, arc.great_circle().unwrap().opposite()),
                error => error,
            },
            5 if rng.one_in(4) => Ok(Geodesic::point(p)),
            _ => Geodesic::arc(p, q),
        };
        if let Ok(curve) = made {
            return curve;
        }
    }
}

pub(crate) fn pieces_of(traits: &GeodesicTraits, curve: &Geodesic) -> Vec<Piece<Direction, GeodesicArc>> {
    let mut pieces = Vec::new();
    traits.make_u_monotone(curve, &mut pieces);
    pieces
}

pub(crate) fn arcs_of(traits: &GeodesicTraits, curve: &Geodesic) -> Vec<GeodesicArc> {
    let arc = |piece| match piece {
        Piece::Curve { curve, .. } => Some(curve),
        Piece::Point(_) => None,
    };
    pieces_of(traits, curve).into_iter().filter_map(arc).collect()
}

pub(crate) fn random_arcs(
    traits: &GeodesicTraits,
    rng: &mut Rng,
    count: usize,
    size: i64,
) -> Vec<GeodesicArc> {
    let mut arcs = Vec::new();
    while arcs.len() < count {
        arcs.extend(arcs_of(traits, &random_geodesic(rng, size)));
    }
    arcs
}

/// Points in and beside the curves that are drawn here.
pub(crate) fn sample() -> Vec<Direction> {
    let mut sample = grid(1);
    sample.extend(
        [[2, 1, 0], [-2, 1, 1], [-1, 0, 2], [1, 2, -2], [-2, -1, 0], [2, -1, 1], [-3, 0, 1]].map(direction),
    );
    sample
}
