//! What one sweep answers: where curves meet, and into which pieces they cut each other.

use crate::arcs::{Arc, Curve};
use crate::families::rows;
use crate::graph::{EdgeKey, edges_along, vertices_of};
use crate::own::{direction, normal_of, own, sweep_with, traits_of};
use crate::random::random_curves;
use crate::space::{P, cross, is_zero};
use exact::spherical::Direction;
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::traits::CurveEnd;
use splitstar_arrangement::{CommonEnds, do_any_meet, intersections, subcurves};
use testkit::Rng;

/// The points that curves have in common, as `intersections` says it, and whether any two meet.
fn meetings(curves: &[Curve], do_ends_count: bool) -> (Vec<P>, bool) {
    let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
    let vertices = vertices_of(&arcs);
    let (mut given, mut is_met) = (Vec::new(), false);
    for p in &vertices {
        let through: Vec<&Arc> = arcs.iter().filter(|arc| arc.has(p)).collect();
        let ending = through.iter().filter(|arc| !arc.has_inside(p)).count();
        if through.len() < 2 || (ending == through.len() && !do_ends_count) {
            continue;
        }
        is_met = true;
        let is_alike = |arc: &&Arc| is_zero(&cross(&arc.normal, &through[0].normal));
        if ending > 0 || !through.iter().all(is_alike) {
            given.push(p.clone());
        }
    }
    // An edge along which two run.
    let along = arcs.iter().filter(|arc| !arc.is_point()).flat_map(|arc| edges_along(arc, &vertices));
    let mut along: Vec<EdgeKey> = along.collect();
    let count = along.len();
    along.sort();
    along.dedup();
    (given, is_met || along.len() < count)
}

type Part = (P, [P; 2]);

fn parts<'a>(arcs: impl Iterator<Item = &'a GeodesicArc>) -> Vec<Part> {
    let part = |arc: &GeodesicArc| (normal_of(arc), CurveEnd::BOTH.map(|end| arc.end(end).coordinates()));
    let mut parts: Vec<Part> = arcs.map(part).collect();
    parts.sort();
    parts
}

/// Tells how many meetings there were.
fn check(traits: &GeodesicTraits, curves: &[Curve], context: &str) -> usize {
    let is_point = |curve: &&Curve| matches!(curve, Curve::Point(_));
    let points: Vec<Direction> =
        curves.iter().filter(is_point).map(|curve| direction(&curve.arc().start())).collect();
    let rest: Vec<Curve> = curves.iter().filter(|curve| !is_point(curve)).cloned().collect();
    let (own, all): (Vec<Geodesic>, Vec<Geodesic>) = (own(&rest), own(curves));
    let mut count = 0;
    for mode in [CommonEnds::Count, CommonEnds::Ignore] {
        let context = format!("{mode:?}, {context}");
        let (given, is_met) = meetings(curves, mode == CommonEnds::Count);
        // Points as such, or among the curves.
        for (curves, points) in [(&own, &points[..]), (&all, &[])] {
            let found = intersections(traits, &Sphere, curves, points, mode);
            let mut found: Vec<P> = found.iter().map(Direction::coordinates).collect();
            found.sort();
            assert_eq!(found, given, "{context}");
            assert_eq!(do_any_meet(traits, &Sphere, curves, points, mode), is_met, "{context}");
        }
        count += given.len();
    }
    let globe = sweep_with(traits, curves);
    let edges: Vec<GeodesicArc> = globe.dcel().edges().map(|e| globe.make_edge_curve(e)).collect();
    let cut = subcurves(traits, &Sphere, &own, &points);
    assert_eq!(parts(cut.iter()), parts(edges.iter()), "{context}");
    count
}

#[test]
fn meetings_in_families() {
    let mut rng = Rng::new(51);
    let mut count = 0;
    for row in rows() {
        let traits = traits_of(*rng.choose(&[[-1, 0], [0, 1], [1, 2], [1, 0]]));
        let context = format!("{}, {:?}: {:?}", row.name, traits.identification(), row.curves);
        count += check(&traits, &row.curves, &context);
    }
    assert!(count > 1_000, "{count}");
}

#[test]
fn meetings_of_random_curves() {
    let mut rng = Rng::new(52);
    let mut count = 0;
    for case in 0..1000 {
        let seed = rng.state();
        let traits = traits_of(*rng.choose(&[[-1, 0], [0, 1], [1, 2]]));
        let curves = random_curves(&mut rng, case % 9, 1 + case as i64 % 3);
        let context = format!("case {case}, seed {seed}, {:?}: {curves:?}", traits.identification());
        count += check(&traits, &curves, &context);
    }
    assert!(count > 2_000, "{count}");
}
