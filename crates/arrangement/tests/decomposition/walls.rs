//! Walls of vertices against vertical rays, where sides are glued or contracted.

use crate::paths::{Curve, make};
use crate::strips::{KINDS, SIZE, random_curve};
use dcel::VertexId;
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
use splitstar_arrangement::location::{Naive, PointLocation, VerticalRay};
use splitstar_arrangement::models::TorusSegmentTraits;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::{FlatTorus, Topology};
use splitstar_arrangement::traits::SideKind::Contracted;
use splitstar_arrangement::traits::{Along, UMonotoneTraits};
use testkit::Rng;

/// Compares the walls of every vertex with the rays from it, and gives the number of walls that meet a cell.
fn check<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, context: &str) -> usize {
    let made = VerticalDecomposition::new(arrangement);
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let is_round = topology.sides().is_v_identified();
    let mut met_count = 0;
    for v in arrangement.dcel().vertices() {
        let walls = made.walls_of(v);
        let of_sites: Vec<_> = made.sites_of(v).map(|site| made.walls(site)).collect();
        for (way, wall) in walls.into_iter().enumerate() {
            let first = of_sites.iter().map(|walls| walls[way]).find(|&wall| wall != WallEnd::Nothing);
            assert_eq!(wall, first.unwrap_or(WallEnd::Nothing), "{context}: {v:?}");
        }
        let Some(point) = arrangement.point(v) else { continue };
        let home = topology.point_location(traits, point);
        if home.u != Along::Inside {
            assert_eq!(walls, [WallEnd::Nothing; 2], "{context}: {v:?}");
            continue;
        }
        let has_top_site = made.sites_of(v).any(|site| made.location(site).v == Along::High);
        for (ray, wall) in [VerticalRay::Down, VerticalRay::Up].into_iter().zip(walls) {
            let met = Naive.shoot(arrangement, point, ray).unwrap();
            let context = format!("{context}: {ray:?} from {v:?}, {wall:?} and {met:?}");
            met_count += usize::from(matches!(wall, WallEnd::Edge(_) | WallEnd::Vertex(_)));
            match wall {
                WallEnd::Edge(e) => assert_eq!(met, Cell::Edge(e), "{context}"),
                WallEnd::Vertex(w) => assert_eq!(met, Cell::Vertex(w), "{context}"),
                WallEnd::Side if is_round => {}
                WallEnd::Side => {
                    let is_pole = |w| arrangement.is_at_infinity(w);
                    assert!(
                        matches!(met, Cell::Face(_)) || matches!(met, Cell::Vertex(w) if is_pole(w)),
                        "{context}"
                    );
                }
                WallEnd::Nothing if ray == VerticalRay::Down && home.v == Along::Low && !has_top_site => {}
                WallEnd::Nothing => {
                    let is_vertical = |e| traits.is_vertical(arrangement.curve_of(e));
                    assert!(matches!(met, Cell::Edge(e) if is_vertical(e)), "{context}");
                }
            }
        }
    }
    met_count
}

fn torus(size: [i64; 2]) -> TorusSegmentTraits {
    TorusSegmentTraits::new(size.map(Into::into)).unwrap()
}

/// The vertex at a point.
fn vertex_at<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    place: [i64; 2],
) -> VertexId {
    let place = Point2::from_i64(place);
    arrangement.vertices().find(|&v| arrangement.point(v) == Some(&place)).unwrap()
}

/// The vertex that stands for the top.
fn top_vertex<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> VertexId {
    VertexId(arrangement.topology().side_vertices()[3].unwrap())
}

/// At (2, 0), where an edge ends on the top, and one begins on the bottom; between them is a bar.
#[test]
fn a_vertex_on_the_bottom_and_top_of_a_torus() {
    let traits = torus([4, 4]);
    let path =
        |from, step: [i64; 2]| traits.path(&Point2::from_i64(from), &step.map(Rational::from)).unwrap();
    let bar = path([1, 2], [2, 0]);
    let through = path([1, 3], [2, 2]);
    let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, [&bar, &through]);
    check(&arrangement, "through the sides");
    let made = VerticalDecomposition::new(&arrangement);
    let v = vertex_at(&arrangement, [2, 0]);
    let sides: Vec<Along> = made.sites_of(v).map(|site| made.location(site).v).collect();
    assert_eq!(sides, [Along::Low, Along::High]);
    let bar_edge = arrangement.dcel().outgoing(vertex_at(&arrangement, [1, 2])).unwrap().edge_id();
    assert_eq!(made.walls_of(v), [WallEnd::Edge(bar_edge); 2], "down from the top, up from the bottom");
    // Only from above: there is no site on the top, and nothing is below.
    let from_bottom = path([2, 0], [1, 1]);
    let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, [&bar, &from_bottom]);
    check(&arrangement, "from the bottom");
    let v = vertex_at(&arrangement, [2, 0]);
    let [below, above] = VerticalDecomposition::new(&arrangement).walls_of(v);
    assert!(below == WallEnd::Nothing && matches!(above, WallEnd::Edge(_)), "{below:?}, {above:?}");
}

#[test]
fn random_paths_on_tori() {
    let mut rng = Rng::new(1_106);
    let mut met = 0;
    for round in 0..400 {
        let seed = rng.state();
        let size = [1 + rng.index(5) as i64, 1 + rng.index(5) as i64];
        let traits = torus(size);
        let mut context = format!("seed {seed}, round {round}, {size:?}:");
        let mut paths = Vec::new();
        for _ in 0..1 + rng.index(6) {
            let from = size.map(|length| rng.index(length as usize) as i64);
            let step = match rng.index(4) {
                0 => [0, rng.within(6)],
                1 => [rng.within(6), 0],
                _ => [rng.within(6), rng.within(6)],
            };
            context += &format!(" {from:?} by {step:?}");
            paths.extend(traits.path(&Point2::from_i64(from), &step.map(Rational::from)).ok());
        }
        met += check(&Arrangement::of_curves(traits, FlatTorus, &paths), &context);
    }
    assert!(met > 1000, "{met}");
}

/// The walls of a pole are of the ends of edges there, and `walls_of` gives those of the first that has some.
#[test]
fn the_vertex_of_a_contracted_side() {
    let kinds = [Contracted, Contracted];
    let meridian = Curve::Path([[1, 2], [1, 4]]);
    let slope = Curve::Path([[2, 3], [4, 4]]);
    let alone = make::<true>(SIZE, kinds, &[meridian]);
    check(&alone, "a meridian");
    let top = top_vertex(&alone);
    assert_eq!(VerticalDecomposition::new(&alone).walls_of(top), [WallEnd::Nothing; 2], "the edge is below");
    let both = make::<true>(SIZE, kinds, &[meridian, slope]);
    check(&both, "a meridian and a slope");
    let made = VerticalDecomposition::new(&both);
    let top = top_vertex(&both);
    assert_eq!(made.sites_of(top).count(), 2);
    let slope_end =
        both.dcel().edges().find(|&e| both.dcel().ends(e)[0] == vertex_at(&both, [2, 3])).unwrap();
    assert_eq!(made.vertex(made.ends(slope_end)[1]), top);
    assert_eq!(
        made.walls_of(top),
        [WallEnd::Side, WallEnd::Nothing],
        "below the end of the slope is the other pole"
    );
    assert_eq!(made.walls_of(vertex_at(&both, [1, 2])), [WallEnd::Side, WallEnd::Nothing]);
    assert_eq!(made.walls_of(vertex_at(&both, [2, 3])), [WallEnd::Side; 2]);
}

#[test]
fn random_curves_on_strips() {
    let mut met = 0;
    for (number, kinds) in (0..).zip(KINDS) {
        let seed = 8001 + number;
        let mut rng = Rng::new(seed);
        for round in 0..200 {
            let curves: Vec<Curve> = (0..1 + rng.index(8)).map(|_| random_curve(&mut rng, kinds)).collect();
            let context = format!("seed {seed}, round {round}, {kinds:?}: {curves:?}");
            met += check(&make::<true>(SIZE, kinds, &curves), &context);
        }
    }
    assert!(met > 1000, "{met}");
}
