//! Chains of arcs: joints are no vertices, and everything else is as without chains.

use crate::agree::assert_agree;
use crate::arcs::{Curve, around, circle, point, short, via};
use crate::graph::{Graph, Place};
use crate::own::{direction, own, traits_of};
use crate::random::random_point;
use crate::space::{P, at, cross, is_zero, opposite};
use crate::{cube, history, laws_of_decompositions};
use exact::spherical::Direction;
use splitstar_arrangement::models::polycurve::{Polycurve, PolycurveTraits};
use splitstar_arrangement::models::{GeodesicArc, GeodesicTraits};
use splitstar_arrangement::overlay::{Cell, overlay_all};
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::wrappers::CountingTraits;
use splitstar_arrangement::{Arrangement, Counts, Editor};
use testkit::Rng;

pub(crate) type Made = Arrangement<PolycurveTraits<GeodesicTraits>, Sphere>;
pub(crate) type Chain = Polycurve<Direction, GeodesicArc>;

pub(crate) fn chain(traits: &PolycurveTraits<GeodesicTraits>, arcs: &[Curve]) -> Chain {
    traits.make_polycurve_of(&own(arcs)).unwrap()
}

pub(crate) fn make(identification: [i64; 2], chains: &[Vec<Curve>], points: &[P]) -> Made {
    let traits = PolycurveTraits::new(traits_of(identification));
    let chains: Vec<Chain> = chains.iter().map(|arcs| chain(&traits, arcs)).collect();
    Arrangement::of_curves_and_points(traits, Sphere, &chains, points.iter().map(direction))
}

/// The points between the arcs of a chain, and its ends.
pub(crate) fn joints(chains: &[Vec<Curve>]) -> Vec<P> {
    chains.iter().flatten().flat_map(|curve| curve.arc().ends.into_iter().flatten()).collect()
}

fn seen(counts: Counts) -> [usize; 3] {
    [counts.vertices, counts.edges, counts.faces]
}

fn path(corners: &[[i64; 3]]) -> Vec<Curve> {
    corners.windows(2).map(|pair| short(pair[0], pair[1])).collect()
}

fn closed(corners: &[[i64; 3]]) -> Vec<Curve> {
    let first = corners.iter().take(1);
    path(&corners.iter().chain(first).copied().collect::<Vec<_>>())
}

/// A name, chains, and vertices, edges and faces.
type Row = (&'static str, Vec<Vec<Curve>>, [usize; 3]);

#[test]
fn chains_with_known_counts() {
    let (x, y, z) = ([1, 0, 0], [0, 1, 0], [0, 0, 1]);
    let minus = |p: [i64; 3]| p.map(|c| -c);
    let (w, s) = (minus(x), minus(z));
    let around_pole = closed(&[[3, 1, 5], [-2, 3, 5], [-2, -3, 6]]);
    let rows: Vec<Row> = vec![
        ("a triangle about a pole", vec![around_pole.clone()], [1, 1, 2]),
        ("a corner at a pole", vec![closed(&[z, [1, 1, 0], [1, 3, 1]])], [1, 1, 2]),
        ("corners at both poles", vec![closed(&[z, x, s, y])], [1, 1, 2]),
        ("an open path", vec![path(&[[1, 1, 1], [-1, 2, 0], [-3, -1, 1], [1, -1, -1]])], [2, 1, 1]),
        ("through a pole", vec![path(&[[1, 1, 1], z, [1, -1, 2]])], [2, 1, 1]),
        ("straight through a pole", vec![path(&[[1, 1, 1], z, [-1, -1, 2]])], [2, 1, 1]),
        ("round the equator", vec![closed(&[x, y, w, minus(y)])], [1, 1, 2]),
        ("round the identification", vec![closed(&[w, z, x, s])], [1, 1, 2]),
        ("a joint on the identification", vec![path(&[[-1, 1, 0], w, [-1, -2, 1]])], [2, 1, 1]),
        ("turned back at the identification", vec![path(&[[-1, 1, 0], w, [-1, 2, 1]])], [2, 1, 1]),
        ("down the identification and away", vec![path(&[[-1, 0, 2], w, [-1, 2, 1]])], [2, 1, 1]),
        ("half circles", vec![vec![via(x, y, w), via(w, z, x)]], [1, 1, 2]),
        ("a long arc", vec![vec![around(y, x, z), short(x, z)]], [2, 1, 1]),
        ("a loop", vec![path(&[[1, 0, 0], [1, 4, 0], [1, 2, 2], [1, 2, -3]])], [3, 3, 2]),
        ("an eight", vec![closed(&[[4, 1, 1], [4, -1, -1], [4, -1, 1], [4, 1, -1]])], [1, 2, 3]),
        ("there and back", vec![path(&[x, y, x])], [2, 1, 1]),
        ("there and half back", vec![path(&[x, y, [1, 1, 0]])], [3, 2, 1]),
        ("there and back at a pole", vec![path(&[x, z, x])], [2, 1, 1]),
        ("a meridian across", vec![around_pole.clone(), vec![via(s, [5, 2, 0], z)]], [3, 3, 2]),
        ("a meridian to a joint", vec![around_pole.clone(), vec![via(s, [3, 1, 0], z)]], [3, 3, 2]),
        ("a circle beside", vec![around_pole.clone(), vec![circle(z)]], [2, 2, 3]),
        ("a point on a joint", vec![around_pole.clone(), vec![point([3, 1, 5])]], [1, 1, 2]),
        (
            "points on two joints",
            vec![around_pole, vec![point([3, 1, 5])], vec![point([-2, 3, 5])]],
            [2, 2, 2],
        ),
    ];
    for (name, chains, expected) in rows {
        for identification in [[-1, 0], [1, 0], [0, 1], [3, 1], [-2, 3]] {
            let made = make(identification, &chains, &[]);
            assert_eq!(made.check_valid(), [], "{name}, {identification:?}");
            assert_eq!(seen(made.counts()), expected, "{name}, {identification:?}");
            let with_joints = make(identification, &chains, &joints(&chains));
            assert_eq!(with_joints.check_valid(), [], "{name}, {identification:?}");
            assert_eq!(
                with_joints.counts(),
                Graph::new(&chains.concat()).counts,
                "{name}, {identification:?}"
            );
        }
    }
}

/// Up to some arcs, each of which begins where the one before it ends; often at the beginning again.
fn random_chain(rng: &mut Rng, range: i64) -> Vec<Curve> {
    let mut corners = vec![random_point(rng, range)];
    for _ in 0..1 + rng.index(5) {
        corners.push(match rng.below(6) {
            0 => corners[0].clone(),
            1 => at([0, 0, if rng.one_in(2) { 1 } else { -1 }]),
            _ => random_point(rng, range),
        });
    }
    let mut arcs = Vec::new();
    let mut here = corners[0].clone();
    for corner in corners.drain(..).skip(1) {
        let normal = cross(&here, &corner);
        if is_zero(&normal) {
            continue;
        }
        let arc = match rng.below(5) {
            0 => Curve::Around(here, corner.clone(), opposite(&normal)),
            1 => {
                let beyond = opposite(&here);
                arcs.push(Curve::Via(here, corner.clone(), beyond.clone()));
                Curve::Short(beyond, corner.clone())
            }
            _ => Curve::Short(here, corner.clone()),
        };
        arcs.push(arc);
        here = corner;
    }
    if arcs.is_empty() { vec![Curve::Point(here)] } else { arcs }
}

/// Checks chains by every route, and away again; tells how many faces there were.
fn check(chains: &[Vec<Curve>], identification: [i64; 2], rng: &mut Rng, context: &str) -> usize {
    let expected = Graph::new(&chains.concat()).counts;
    let made = make(identification, chains, &[]);
    assert_eq!(made.check_valid(), [], "{context}");
    // To hide a joint takes a vertex and an edge.
    let found = made.counts();
    assert_eq!(
        [found.faces, found.isolated, found.components, found.edges + expected.vertices],
        [expected.faces, expected.isolated, expected.components, expected.edges + found.vertices],
        "{context}"
    );
    let with_joints = make(identification, chains, &joints(chains));
    assert_eq!(with_joints.check_valid(), [], "{context}");
    assert_eq!(with_joints.counts(), cube::counts(&chains.concat()), "{context}");
    let traits = made.traits();
    let mut own: Vec<Chain> = chains.iter().map(|arcs| chain(traits, arcs)).collect();
    rng.shuffle(&mut own);
    let empty = Arrangement::new(traits.clone(), Sphere);
    let mut editor = Editor::new(empty.clone());
    own.iter().for_each(|chain| drop(editor.insert_curve(chain)));
    assert_eq!(editor.check_valid(), [], "one by one, {context}");
    assert_eq!(editor.difference(&made), None, "one by one, {context}");
    let (first, last) = own.split_at(rng.index(own.len() + 1));
    let [a, b] = [first, last].map(|part| Arrangement::of_curves(traits.clone(), Sphere, part));
    let overlay = overlay_all(&[&a, &b]).0;
    assert_eq!(overlay.check_valid(), [], "overlay, {context}");
    assert_eq!(overlay.difference(&made), None, "overlay, {context}");
    let mut edges: Vec<_> = editor.dcel().edges().collect();
    rng.shuffle(&mut edges);
    for e in edges {
        editor.remove_edge(e);
        assert_eq!(editor.check_valid(), [], "{context}");
    }
    let isolated: Vec<_> = editor.vertices().collect();
    for v in isolated {
        assert!(editor.remove_vertex(v).is_ok(), "{context}");
    }
    assert_eq!(editor.difference(&empty), None, "{context}");
    check_places(&made, chains, rng, context);
    found.faces
}

/// All strategies find the same, and what lies on no chain is in a face.
fn check_places(made: &Made, chains: &[Vec<Curve>], rng: &mut Rng, context: &str) {
    let graph = Graph::new(&chains.concat());
    let places = graph.points(rng, 6);
    let points: Vec<Direction> = places.iter().map(direction).collect();
    for (p, answer) in places.iter().zip(assert_agree(made, &points, context)) {
        let is_in_face = matches!(graph.locate(p), Place::Face(_));
        assert_eq!(matches!(answer[0], Cell::Face(_)), is_in_face, "at {p:?}, {context}");
    }
    laws_of_decompositions::check(made, context);
}

pub(crate) fn random_chains(rng: &mut Rng, most: usize, range: i64) -> Vec<Vec<Curve>> {
    (0..1 + rng.index(most)).map(|_| random_chain(rng, range)).collect()
}

#[test]
fn random_chains_by_every_route() {
    let mut rng = Rng::new(61);
    let mut faces = 0;
    for case in 0..600 {
        let seed = rng.state();
        let chains = random_chains(&mut rng, 4, 1 + case % 2);
        let identification = *rng.choose(&[[-1, 0], [0, 1], [1, 1], [2, -1]]);
        let context = format!("case {case}, seed {seed}, {identification:?}: {chains:?}");
        faces += check(&chains, identification, &mut rng, &context);
    }
    assert!(faces > 2_500, "{faces}");
}

/// Chains come and go as inputs.
#[test]
fn chains_with_history() {
    let traits = PolycurveTraits::new(GeodesicTraits::new());
    let maker = traits.clone();
    for seed in 1..40 {
        let range = 1 + seed as i64 % 2;
        let curve = |rng: &mut Rng| chain(&maker, &random_chain(rng, range));
        let point = move |rng: &mut Rng| direction(&random_point(rng, range));
        let pool = history::Pool { traits: traits.clone(), curve: &curve, point: &point };
        history::play(Sphere, &pool, seed, 12, |_, _| {});
    }
}

/// The meridian comes from a pole, so its beginning does not tell at which piece of the chain it is.
#[test]
fn a_meridian_from_a_pole_meets_a_chain_in_its_middle() {
    let triangle = closed(&[[3, 1, 5], [-2, 3, 5], [-2, -3, 6]]);
    for meridian in [via([0, 0, -1], [5, 2, 0], [0, 0, 1]), via([0, 0, 1], [5, 2, 0], [0, 0, -1])] {
        let made = make([-1, 0], &[triangle.clone(), vec![meridian]], &[]);
        assert_eq!(made.check_valid(), []);
        let crossing = direction(&at([55, 22, 100]));
        assert!(made.vertices().any(|v| made.point(v) == Some(&crossing)));
    }
}

/// So it is for chains of arcs whose traits are wrapped.
#[test]
fn a_meridian_from_a_pole_meets_a_chain_of_wrapped_arcs() {
    let curves = [closed(&[[3, 1, 5], [-2, 3, 5], [-2, -3, 6]]), vec![via([0, 0, -1], [5, 2, 0], [0, 0, 1])]];
    let traits = PolycurveTraits::new(CountingTraits::new(GeodesicTraits::new()));
    let chains = curves.iter().map(|arcs| traits.make_polycurve_of(&own(arcs)).unwrap());
    let chains: Vec<_> = chains.collect();
    let made = Arrangement::of_curves(traits, Sphere, &chains);
    assert_eq!(made.check_valid(), []);
    assert_eq!(made.counts(), make([-1, 0], &curves, &[]).counts());
}
