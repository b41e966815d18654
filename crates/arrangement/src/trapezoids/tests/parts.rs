//! What is connected: the smaller of two parts, and what lies in it.

use super::*;
use crate::models::{Segment, SegmentTraits, TorusSegmentTraits};
use crate::topology::{BoundedPlane, FlatTorus};
use dcel::FaceId;
use exact::planar::Point2;

fn sorted(mut trapezoids: Vec<TrapezoidId>) -> Vec<TrapezoidId> {
    trapezoids.sort_unstable();
    trapezoids
}

/// The trapezoids below and above an edge where it begins, and the faces there.
fn sides_of<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    e: EdgeId,
) -> [(TrapezoidId, FaceId); 2] {
    let rail = trapezoids.rail_of(e);
    let h = e.halfedge();
    [(Side::Below, h.twin()), (Side::Above, h)]
        .map(|(side, h)| (trapezoids.rail(rail).first[side as usize], arrangement.dcel().face(h)))
}

/// At each edge, the smaller part is one of the two parts, and has all that its face has.
fn smaller_parts_are_parts<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    _: &mut Numbers,
    seed: u64,
) {
    let dcel = arrangement.dcel();
    let mut trapezoids = Trapezoids::of(arrangement);
    for e in dcel.edges() {
        let sides = sides_of(arrangement, &trapezoids, e);
        let starts = sides.map(|(start, _)| start);
        let (smaller, part) = trapezoids.smaller_part(arrangement, starts);
        let part = sorted(part);
        let parts = starts.map(|start| sorted(trapezoids.part(arrangement, start)));
        assert_eq!(part, parts[smaller], "seed {seed}, {e:?}");
        assert!(part.is_sorted_by(|a, b| a < b), "each once; seed {seed}, {e:?}");
        assert!(part.len() <= parts[1 - smaller].len(), "seed {seed}, {e:?}");
        if sides[0].1 == sides[1].1 {
            assert_eq!((smaller, &parts[0]), (0, &parts[1]), "seed {seed}, {e:?}");
        }
        for (part, (_, face)) in parts.iter().zip(sides) {
            let contents = trapezoids.contents(arrangement, part);
            let mut ccbs: Vec<_> = dcel.face_ccbs(face).collect();
            ccbs.sort_unstable();
            assert_eq!(contents.ccbs, ccbs, "seed {seed}, {face:?}");
            let mut isolated: Vec<_> = dcel.isolated_vertices(face).collect();
            isolated.sort_unstable();
            assert_eq!(contents.isolated, isolated, "seed {seed}, {face:?}");
        }
    }
}

#[test]
fn smaller_parts_of_random_arrangements() {
    on(60, 12, random_segments, smaller_parts_are_parts);
    on(60, 8, random_lines, smaller_parts_are_parts);
    on(150, 5, random_paths, smaller_parts_are_parts);
    on(100, 5, random_cylinder, smaller_parts_are_parts);
    on(150, 6, random_globe, smaller_parts_are_parts);
}

/// A closed chain of segments through points.
fn polygon(corners: &[[i64; 2]]) -> impl Iterator<Item = Segment> + '_ {
    (0..corners.len()).filter_map(|i| Segment::from_i64([corners[i], corners[(i + 1) % corners.len()]]))
}

#[test]
fn two_sides_of_a_polygon_with_holes() {
    let outline = [[0, 0], [30, 0], [30, 30], [20, 30], [20, 10], [10, 10], [10, 30], [0, 30]];
    let inside = [
        vec![[2, 2], [4, 2], [3, 5]],
        // A ring: what lies in it is of neither side.
        vec![[12, 1], [20, 1], [20, 9], [12, 9]],
        vec![[25, 20], [27, 20], [25, 27]],
    ];
    let in_ring = vec![[14, 3], [16, 3], [15, 6]];
    let outside = [vec![[14, 12], [16, 12], [15, 20]], vec![[-9, 3], [-5, 4], [-6, 8]]];
    let segments: Vec<Segment> = polygon(&outline)
        .chain(inside.iter().flat_map(|corners| polygon(corners)))
        .chain(outside.iter().flat_map(|corners| polygon(corners)))
        .chain(polygon(&in_ring))
        .collect();
    // Two inside, three outside, one in the ring, one in a hole.
    let points = [[1, 20], [22, 15], [15, 30], [31, 31], [-1, -1], [18, 5], [3, 3]].map(Point2::from_i64);
    let arrangement = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &segments, points);
    let mut trapezoids = Trapezoids::of(&arrangement);
    smaller_parts_are_parts(&arrangement, &mut Numbers(1), 0);
    let unbounded = arrangement.corner_face();
    let mut visited = 0;
    for e in arrangement.dcel().edges() {
        let is_of_outline = arrangement.dcel().ends(e).iter().all(|&v| {
            let point = arrangement.point(v).expect("in the bounded plane every vertex is a point");
            outline.iter().any(|&corner| *point == Point2::from_i64(corner))
        });
        if !is_of_outline {
            continue;
        }
        visited += 1;
        for (start, face) in sides_of(&arrangement, &trapezoids, e) {
            let part = trapezoids.part(&arrangement, start);
            let contents = trapezoids.contents(&arrangement, &part);
            let expected = if face == unbounded { (3, 3) } else { (4, 2) };
            assert_eq!((contents.ccbs.len(), contents.isolated.len()), expected, "{face:?}");
        }
    }
    assert_eq!(visited, outline.len());
}

#[test]
fn one_loop_around_a_torus_has_one_part_on_both_sides() {
    let traits = TorusSegmentTraits::new([8.into(), 8.into()]).expect("the periods are positive");
    for (winding, count) in [([1, 0], 1), ([0, 1], 1), ([1, 2], 1), ([1, 0], 2), ([0, 1], 2), ([2, 3], 2)] {
        for first in 0..3 {
            let paths: Vec<_> = (0..count)
                .map(|i| {
                    let through = Point2::from_i64([first + i; 2]);
                    traits.closed_path(&through, winding).expect("the path is short")
                })
                .collect();
            let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, &paths);
            let mut trapezoids = Trapezoids::of(&arrangement);
            for e in arrangement.dcel().edges() {
                let sides = sides_of(&arrangement, &trapezoids, e);
                let [below, above] = sides.map(|(start, _)| sorted(trapezoids.part(&arrangement, start)));
                assert_eq!(below == above, count == 1, "{count} of {winding:?} through {first}");
            }
        }
    }
}

#[test]
fn marks_of_visits_are_wiped_out_when_their_numbers_are_used_up() {
    let mut numbers = Numbers::of_seed(7);
    let arrangement = random_segments(&mut numbers, 12).arrangement();
    let mut trapezoids = Trapezoids::of(&arrangement);
    let t = trapezoids.sites[0].left[0];
    let part = sorted(trapezoids.part(&arrangement, t));
    trapezoids.visits.last = u32::MAX - 3;
    for _ in 0..5 {
        assert_eq!(sorted(trapezoids.part(&arrangement, t)), part);
    }
}
