//! What turns and mirrors the sphere, or moves the identification, changes nothing.

use crate::arcs::{Curve, mapped};
use crate::families::{Row, rows};
use crate::graph::Graph;
use crate::matching::Matching;
use crate::own::{Globe, direction, sweep, sweep_with, traits_of};
use crate::planar;
use crate::random::random_curves;
use crate::space::{Matrix, P, at, image, is_pole, matrix, random_rotation, rotation};
use exact::spherical::Direction;
use splitstar_arrangement::models::GeodesicTraits;
use splitstar_arrangement::overlay::overlay_all;
use std::collections::BTreeMap;
use testkit::Rng;

/// Families by their names: the same at several places is one.
fn families(rows: Vec<Row>) -> BTreeMap<String, Vec<Vec<Curve>>> {
    let mut families: BTreeMap<String, Vec<Vec<Curve>>> = BTreeMap::new();
    for row in rows {
        families.entry(row.name).or_default().push(row.curves);
    }
    families
}

fn point_reflection() -> Matrix {
    matrix([[-1, 0, 0], [0, -1, 0], [0, 0, -1]])
}

/// Checks that the image is the arrangement of the images.
fn assert_image(globe: &Globe, other: &Globe, map: &Matrix, is_mirrored: bool, context: &str) {
    assert_eq!(other.check_valid(), [], "{context}");
    assert_eq!(globe.counts(), other.counts(), "{context}");
    let of_point = |p: &Direction| direction(&image(map, &p.coordinates()));
    assert!(globe.is_isomorphic_under(other, of_point, is_mirrored), "{context}");
}

/// Rotations for each family, two hundred and more: each of its members has some of them. Rotation i comes with identification i mod 20,
/// so that each of these has ten rotations.
fn turn(families: &BTreeMap<String, Vec<Vec<Curve>>>, seed: u64) {
    let mut rng = Rng::new(seed);
    for (name, members) in families {
        let rounds = ROTATIONS.div_ceil(members.len());
        let mut count = 0;
        for curves in members {
            let globe = sweep(curves);
            let places = Places::new(curves, &mut rng);
            for _ in 0..rounds {
                let context = format!("{name}, rotation {count}, seed {}: {curves:?}", rng.state());
                // Once in eight times, so that no coordinate fits a machine word.
                let range = if rng.one_in(8) { 1 << 30 } else { 4 };
                let map = random_rotation(&mut rng, range);
                let traits = places.turned(count % PLACES, &map);
                let other = sweep_with(&traits, &mapped(curves, &map));
                let context = format!("{:?}, {context}", traits.identification());
                assert_image(&globe, &other, &map, false, &context);
                count += 1;
            }
        }
        assert!(count >= ROTATIONS && count / PLACES >= 10, "{name}: {count}");
    }
}

#[test]
fn families_of_the_sphere_turned() {
    turn(&families(rows()), 1);
}

/// At all placements it is one family.
fn families_of_the_plane() -> BTreeMap<String, Vec<Vec<Curve>>> {
    let rows = planar::all_rows().into_iter().map(|mut row| {
        row.name = row.name.split(", from").next().unwrap_or_default().to_owned();
        row
    });
    families(rows.collect())
}

#[test]
fn families_of_the_plane_turned() {
    turn(&families_of_the_plane(), 2);
}

/// How often each family is turned at least.
const ROTATIONS: usize = 200;

/// In how many places it has the identification.
const PLACES: usize = 20;

/// Twenty places of the identification for some curves: ten of them through vertices, if there are so many.
struct Places {
    vertices: Vec<P>,
    fixed: Vec<[i64; 2]>,
}

impl Places {
    fn new(curves: &[Curve], rng: &mut Rng) -> Self {
        const FIXED: [[i64; 2]; 13] = [
            [-1, 0],
            [1, 0],
            [0, 1],
            [0, -1],
            [1, 1],
            [-1, 1],
            [-1, -1],
            [1, -1],
            [2, 1],
            [-3, 1],
            [-1000, 1],
            [-1000, -1],
            [1 << 40, 1],
        ];
        let mut vertices: Vec<P> = Graph::new(curves).vertices;
        rng.shuffle(&mut vertices);
        vertices.truncate(PLACES / 2);
        let mut fixed = FIXED.to_vec();
        while vertices.len() + fixed.len() < PLACES {
            let place = [0; 2].map(|_: i64| rng.within(20));
            if place != [0, 0] {
                fixed.push(place);
            }
        }
        Self { vertices, fixed }
    }

    fn at(&self, i: usize) -> GeodesicTraits {
        self.turned(i, &rotation([1, 0, 0, 0]))
    }

    /// That of number i, through the image of a vertex. Where this is a pole, it is another one.
    fn turned(&self, i: usize, map: &Matrix) -> GeodesicTraits {
        let through = self.vertices.get(i).map(|v| image(map, v)).filter(|p| !is_pole(p));
        match through {
            Some([x, y, _]) => GeodesicTraits::with_identification([x, y]).expect("it is no pole"),
            None => {
                // Those that come after the vertices; instead of a vertex, the last ones.
                let place = match i.checked_sub(self.vertices.len()) {
                    Some(k) => self.fixed[k],
                    None => self.fixed[self.fixed.len() - 1 - i],
                };
                traits_of(place)
            }
        }
    }
}

/// The arrangement with the identification at twenty other places, for each family: with few members, each has some more.
fn move_identification(families: &BTreeMap<String, Vec<Vec<Curve>>>, seed: u64) {
    let mut rng = Rng::new(seed);
    for (name, members) in families {
        let rounds = PLACES.div_ceil(members.len());
        let mut count = 0;
        for curves in members {
            let (graph, globe) = (Graph::new(curves), sweep(curves));
            let places = Places::new(curves, &mut rng);
            for _ in 0..rounds {
                let traits = places.at(count % PLACES);
                count += 1;
                let context = format!("{name}, {:?}: {curves:?}", traits.identification());
                let other = sweep_with(&traits, curves);
                assert_eq!(other.check_valid(), [], "{context}");
                Matching::new(&graph, &other, &context);
                assert!(globe.is_isomorphic_under(&other, Direction::clone, false), "{context}");
            }
        }
        assert!(count >= PLACES, "{name}: {count}");
    }
}

#[test]
fn families_with_the_identification_elsewhere() {
    move_identification(&families(rows()), 3);
    move_identification(&families(planar::all_rows()), 4);
}

#[test]
fn families_mirrored_in_the_middle() {
    for row in rows() {
        let map = point_reflection();
        let other = sweep(&mapped(&row.curves, &map));
        assert_image(&sweep(&row.curves), &other, &map, true, &format!("{}: {:?}", row.name, row.curves));
    }
}

/// The reflected arrangement is the one that a sweep over the reflected curves makes on the opposite sphere, corner by corner and kind by kind.
fn check_reflected(traits: &GeodesicTraits, curves: &[Curve], context: &str) {
    let globe = sweep_with(traits, curves);
    let reflected = globe.reflected();
    assert_eq!(reflected.check_valid(), [], "{context}");
    let images = sweep_with(&traits.reflected(), &mapped(curves, &point_reflection()));
    assert_eq!(reflected.difference(&images), None, "{context}");
    assert_eq!(reflected.counts_with_splits(), images.counts_with_splits(), "{context}");
    let again = reflected.reflected();
    assert_eq!(again.check_valid(), [], "{context}");
    assert_eq!((again.traits(), again.difference(&globe)), (traits, None), "{context}");
    assert_eq!(again.corner_face(), globe.corner_face(), "{context}");
    let (dcel, other) = (globe.dcel(), again.dcel());
    let record =
        |dcel: &dcel::Dcel, h| (dcel.next(h), dcel.prev(h), dcel.source(h), dcel.ccb(h), dcel.face(h));
    assert!(dcel.halfedges().all(|h| record(dcel, h) == record(other, h)), "{context}");
    // It is an arrangement as others: it can be overlaid with its reflection.
    let opposite = sweep_with(&traits.reflected(), curves);
    let (overlay, _) = overlay_all(&[&opposite, &reflected]);
    assert_eq!(overlay.check_valid(), [], "{context}");
    let all = [curves, &mapped(curves, &point_reflection())].concat();
    assert_eq!(overlay.difference(&sweep_with(&traits.reflected(), &all)), None, "{context}");
}

#[test]
fn families_reflected_in_place() {
    for row in rows() {
        for d in [[-1, 0], [1, 0], [0, 1], [2, -1]] {
            check_reflected(&traits_of(d), &row.curves, &format!("{}, {d:?}: {:?}", row.name, row.curves));
        }
    }
}

#[test]
fn random_curves_reflected_in_place() {
    for seed in 0..400 {
        let mut rng = Rng::new(seed);
        let curves = random_curves(&mut rng, 7, 2);
        let d = *rng.choose(&[[-1, 0], [-1, 0], [1, 0], [0, 1], [2, -1]]);
        check_reflected(&traits_of(d), &curves, &format!("seed {seed}, {d:?}: {curves:?}"));
    }
}

/// An overlay is the arrangement of all curves.
fn check_overlay(parts: &[&[Curve]], context: &str) {
    let operands: Vec<Globe> = parts.iter().map(|part| sweep(part)).collect();
    let all: Vec<Curve> = parts.concat();
    let (overlay, _) = overlay_all(&operands.iter().collect::<Vec<_>>());
    assert_eq!(overlay.check_valid(), [], "{context}");
    assert_eq!(overlay.difference(&sweep(&all)), None, "{context}");
    Matching::new(&Graph::new(&all), &overlay, context);
}

#[test]
fn overlays_with_images() {
    let mut rng = Rng::new(5);
    for row in rows() {
        let context = format!("{}, seed {}: {:?}", row.name, rng.state(), row.curves);
        let curves = &row.curves[..];
        let globe = sweep(curves);
        let twice = overlay_all(&[&globe, &globe]).0;
        assert_eq!(twice.difference(&globe), None, "{context}");
        check_overlay(&[curves, &mapped(curves, &point_reflection())], &format!("mirrored, {context}"));
        let turned = [2, 3].map(|range| mapped(curves, &random_rotation(&mut rng, range)));
        if curves.len() < 14 {
            check_overlay(&[curves, &turned[0]], &format!("turned, {context}"));
        }
        if curves.len() < 6 {
            check_overlay(&[curves, &turned[0], &turned[1]], &format!("turned twice, {context}"));
        }
        if curves.len() < 3 {
            let half = rotation([0, 0, 0, 1]);
            let four = [&turned[0][..], curves, &turned[1], &mapped(curves, &half)];
            check_overlay(&four, &format!("overlay of four, {context}"));
        }
    }
}

/// The known rotations of the cube bring its mirrors to themselves.
#[test]
fn mirrors_of_the_cube_turned_by_its_rotations() {
    let row = rows().into_iter().find(|row| row.name == "mirrors of the cube").expect("there is the row");
    let globe = sweep(&row.curves);
    for quaternion in [[1, 1, 0, 0], [1, 1, 1, 1], [0, 1, 1, 0], [1, 0, 0, 1], [0, 0, 0, 1]] {
        let map = rotation(quaternion);
        let other = sweep(&mapped(&row.curves, &map));
        assert_eq!(other.difference(&globe), None, "{quaternion:?}");
        assert_image(&globe, &globe, &map, false, &format!("{quaternion:?}"));
    }
}

#[test]
fn random_curves_turned_mirrored_and_cut_elsewhere() {
    let mut rng = Rng::new(6);
    for case in 0..150 {
        let seed = rng.state();
        let curves = random_curves(&mut rng, 2 + case % 8, 2);
        let context = format!("seed {seed}: {curves:?}");
        let globe = sweep(&curves);
        for range in [1, 3, 1 << 28] {
            let map = random_rotation(&mut rng, range);
            assert_image(&globe, &sweep(&mapped(&curves, &map)), &map, false, &context);
        }
        let map = point_reflection();
        assert_image(&globe, &sweep(&mapped(&curves, &map)), &map, true, &context);
        let places = Places::new(&curves, &mut rng);
        for i in [0, 1, 2].into_iter().chain(PLACES / 2..PLACES) {
            let traits = places.at(i);
            let other = sweep_with(&traits, &curves);
            let context = format!("{:?}, {context}", traits.identification());
            assert_eq!(other.check_valid(), [], "{context}");
            Matching::new(&Graph::new(&curves), &other, &context);
            assert!(globe.is_isomorphic_under(&other, Direction::clone, false), "{context}");
        }
    }
    assert_eq!(image(&point_reflection(), &at([1, 2, 3])), at([-1, -2, -3]));
}
