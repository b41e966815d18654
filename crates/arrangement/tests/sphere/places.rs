//! Location and rays along meridians: all strategies against one another, and against brute force. The vertical decomposition.

use crate::agree::assert_agree;
use crate::arcs::Curve;
use crate::families::rows;
use crate::graph::{Graph, Place};
use crate::laws_of_decompositions;
use crate::matching::Matching;
use crate::own::{Globe, direction, sweep_with, traits_of};
use crate::random::random_curves;
use crate::space::{P, is_pole};
use splitstar_arrangement::Editor;
use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
use splitstar_arrangement::location::{Naive, PointLocation, VerticalRay};
use splitstar_arrangement::models::GeodesicTraits;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{Along, BasicTraits};
use testkit::Rng;

/// What has been found: vertices, edges and faces in which points lie, and those that rays meet.
type Seen = [[usize; 3]; 2];

fn count(seen: &mut [usize; 3], place: Place) {
    seen[match place {
        Place::Vertex(_) => 0,
        Place::Edge(_) => 1,
        Place::Face(_) => 2,
    }] += 1;
}

fn check(traits: &GeodesicTraits, curves: &[Curve], rng: &mut Rng, seen: &mut Seen, context: &str) {
    let graph = Graph::new(curves);
    let globe = sweep_with(traits, curves);
    let matching = Matching::new(&graph, &globe, context);
    let places = graph.points(rng, 16);
    let points: Vec<_> = places.iter().map(direction).collect();
    let answers = assert_agree(&globe, &points, context);
    let editor = Editor::new(globe.clone());
    for ((p, point), answer) in places.iter().zip(&points).zip(answers) {
        let context = format!("at {p:?}, {context}");
        assert_eq!(editor.locate(point), answer[0], "{context}");
        let found = matching.place(answer[0]);
        assert_eq!(found, graph.locate(p), "{context}");
        count(&mut seen[0], found);
        for (is_up, cell) in [(true, answer[1]), (false, answer[2])] {
            if let Some(expected) = graph.shoot(p, is_up) {
                assert_eq!(matching.place(cell), expected, "up: {is_up}, {context}");
                count(&mut seen[1], expected);
            }
        }
    }
    laws_of_decompositions::check(&globe, context);
    check_walls(&globe, context);
}

/// The walls of vertices are what rays from there meet.
fn check_walls(globe: &Globe, context: &str) {
    let made = VerticalDecomposition::new(globe);
    for v in globe.vertices() {
        let point = globe.point(v).expect("vertices are points");
        let p: P = point.coordinates();
        let is_inside = globe.topology().point_location(globe.traits(), point).u == Along::Inside;
        if is_pole(&p) || !is_inside {
            continue;
        }
        for (ray, wall) in [VerticalRay::Down, VerticalRay::Up].into_iter().zip(made.walls_of(v)) {
            let met = Naive.shoot(globe, point, ray).unwrap();
            let is_right = match wall {
                WallEnd::Edge(e) => met == Cell::Edge(e),
                WallEnd::Vertex(w) => met == Cell::Vertex(w),
                WallEnd::Side => matches!(met, Cell::Face(_)) || matches!(met, Cell::Vertex(w) if w.0 < 2),
                WallEnd::Nothing => {
                    matches!(met, Cell::Edge(e) if globe.traits().is_vertical(globe.curve_of(e)))
                }
            };
            assert!(is_right, "{ray:?} from {p:?}: {wall:?}, {met:?}, {context}");
        }
    }
}

#[test]
fn places_in_families() {
    let mut rng = Rng::new(41);
    let mut seen = Seen::default();
    for row in rows() {
        let traits = traits_of(*rng.choose(&[[-1, 0], [-1, 0], [0, 1], [1, 2], [1, 0]]));
        let context =
            format!("{}, {:?}, seed {}: {:?}", row.name, traits.identification(), rng.state(), row.curves);
        check(&traits, &row.curves, &mut rng, &mut seen, &context);
    }
    assert!(seen.iter().flatten().all(|&count| count > 1_000), "{seen:?}");
}

#[test]
fn places_among_random_curves() {
    let mut rng = Rng::new(42);
    let mut seen = Seen::default();
    for case in 0..400 {
        let seed = rng.state();
        let traits = traits_of(*rng.choose(&[[-1, 0], [-1, 0], [0, 1], [1, 2]]));
        let curves = random_curves(&mut rng, case % 11, 1 + case as i64 % 3);
        let context = format!("case {case}, seed {seed}, {:?}: {curves:?}", traits.identification());
        check(&traits, &curves, &mut rng, &mut seen, &context);
    }
    assert!(seen.iter().flatten().all(|&count| count > 1_000), "{seen:?}");
}

/// Nothing ends at such a vertex, so no edge tells where it is.
#[test]
fn a_pole_that_is_an_isolated_vertex() {
    use crate::arcs::{circle, point, short};
    let mut rng = Rng::new(43);
    let poles = [point([0, 0, 1]), point([0, 0, -1])];
    let more = [circle([0, 0, 1]), short([1, 2, 2], [2, -1, 3]), short([-1, 0, 3], [-1, 0, 1])];
    for count in 0..=more.len() {
        for poles in [&poles[..1], &poles[1..], &poles] {
            let curves = [poles, &more[..count]].concat();
            check(&GeodesicTraits::new(), &curves, &mut rng, &mut Seen::default(), &format!("{curves:?}"));
        }
    }
}
