//! Many points at once, and a map that follows an adverse order of edits.

use super::*;
use crate::arrangement::Arrangement;
use crate::edit::{Done, EditOf, Observer};
use crate::editor::Editor;
use crate::models::polycurve::PolycurveTraits;
use crate::models::{Segment, SegmentTraits};
use crate::random::{Numbers, Scene, random_lines, random_paths, random_segments};
use crate::topology::{BoundedPlane, Topology};
use crate::traits::{ArrangementTraits, UMonotoneTraits};
use exact::Rational;
use exact::planar::Point2;

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).expect("the ends are different")
}

/// The points of a square, one row after another.
fn square(count: usize) -> Vec<Point2> {
    (0..count as i64).map(|i| Point2::from_i64([i % 7 - 1, i / 7 % 7 - 1])).collect()
}

#[test]
fn each_way_to_locate_many_begins_at_its_threshold() {
    let triangle = [[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]].map(segment);
    let cross = [[[0, 0], [4, 4]], [[0, 4], [4, 0]]].map(segment);
    // An empty arrangement counts as one of one vertex.
    for (curves, vertices) in [(&[][..], 1), (&triangle[..1], 2), (&triangle[..], 3), (&cross[..], 5)] {
        let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, curves);
        assert_eq!(arrangement.dcel().vertex_count().max(1), vertices);
        let rows = [
            (0, BatchStrategy::Naive),
            (1, BatchStrategy::Naive),
            (2, BatchStrategy::Naive),
            (3, BatchStrategy::Sweep),
            (8 * vertices + 7, BatchStrategy::Sweep),
            (8 * vertices + 8, BatchStrategy::Trapezoids),
            (50 * vertices, BatchStrategy::Trapezoids),
        ];
        for (count, expected) in rows {
            let context = format!("{count} points, {vertices} vertices");
            assert_eq!(BatchStrategy::choose(&arrangement, count), expected, "{context}");
            let points = square(count);
            let single: Result<Vec<Cell>, Stale> =
                points.iter().map(|point| Naive.locate(&arrangement, point)).collect();
            assert_eq!(Ok(locate_all(&arrangement, &points)), single, "{context}");
        }
        assert_eq!(BatchStrategy::choose(&arrangement, usize::MAX), BatchStrategy::Trapezoids);
    }
}

/// As many as are searched for at the same time.
const GROUP: usize = 16;

/// Draws points of all kinds and finds them in groups and one by one; gives how many groups had all kinds of cells in them, and on how many
/// of these points lay on a side.
fn check_groups<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    seeds: u64,
    draw: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
    home: impl Fn(&G, Point2) -> Point2,
) -> [usize; 2] {
    let mut with_all = [0, 0];
    for seed in 1..=seeds {
        let mut numbers = Numbers::of_seed(seed);
        let scene = draw(&mut numbers, 6);
        let arrangement = scene.arrangement();
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let vertices: Vec<Point2> =
            arrangement.vertices().filter_map(|v| arrangement.point(v).cloned()).collect();
        let points: Vec<Point2> = (0..3 * GROUP + 1)
            .map(|_| match numbers.below(3) {
                0 if !vertices.is_empty() => vertices[numbers.below(vertices.len() as i64) as usize].clone(),
                _ => {
                    let mut half = || Rational::new(numbers.below(14).into(), 2.into()).expect("2 is not 0");
                    let point = [half(), half()];
                    home(traits, Point2::from_rationals(&point))
                }
            })
            .collect();
        let map = TrapezoidalMap::new(&arrangement);
        let single: Vec<Cell> = points
            .iter()
            .map(|point| {
                let cell = Naive.locate(&arrangement, point);
                assert_eq!(map.locate(&arrangement, point), cell, "seed {seed}, {point}");
                cell.expect("nobody edits")
            })
            .collect();
        for count in [0, 1, GROUP - 1, GROUP, GROUP + 1, 2 * GROUP, points.len()] {
            let found = map.locate_all(&arrangement, &points[..count]);
            assert_eq!(found.as_deref(), Ok(&single[..count]), "seed {seed}, {points:?}");
        }
        for (cells, points) in single.chunks(GROUP).zip(points.chunks(GROUP)) {
            let has = |is: fn(&Cell) -> bool| cells.iter().any(is);
            if has(|cell| matches!(cell, Cell::Vertex(_)))
                && has(|cell| matches!(cell, Cell::Edge(_)))
                && has(|cell| matches!(cell, Cell::Face(_)))
            {
                with_all[0] += 1;
                let is_on_side = |point| !topology.point_location(traits, point).is_interior();
                with_all[1] += usize::from(points.iter().any(is_on_side));
            }
        }
    }
    with_all
}

#[test]
fn groups_of_searches_on_the_plane() {
    let [with_all, _] = check_groups(150, random_segments, |_, point| point);
    assert!(with_all > 100, "{with_all}");
    let [with_all, _] = check_groups(150, random_lines, |_, point| point);
    assert!(with_all > 100, "{with_all}");
}

#[test]
fn groups_of_searches_on_a_torus() {
    let [with_all, with_sides] = check_groups(300, random_paths, |traits, point| traits.point(&point));
    assert!(with_all > 300 && with_sides > 300, "{with_all}, {with_sides}");
}

/// Follows edits and is never built anew.
#[derive(Clone)]
struct Untidy<G: UMonotoneTraits>(TrapezoidalMap<G>);

impl<G: UMonotoneTraits, T: Topology<G>> Observer<G, T> for Untidy<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        self.0.before(arrangement, edit);
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        self.0.after(arrangement, edit, done);
    }
}

/// Edits in an order that makes searches long: a map that follows is built anew, and right all the while.
fn check_worn(edit: impl Fn(&mut Editor<SegmentTraits, BoundedPlane, Observers>, i64)) {
    let empty = Arrangement::new(SegmentTraits, BoundedPlane);
    let map = TrapezoidalMap::new(&empty);
    let observers = (map.clone(), Untidy(map));
    let mut editor = Editor::with_observers(empty, observers).expect("both begin there");
    for i in 0..400 {
        edit(&mut editor, i);
        let (map, _) = editor.observers();
        assert!(!map.is_worn(), "after edit {i}");
        if i % 50 == 49 {
            let points: Vec<Point2> =
                (0..40).map(|j| Point2::from_i64([j * 20 + i % 7, (j * 31 + i) % (i + 3)])).collect();
            let expected = Naive.locate_all(editor.arrangement(), &points);
            for (name, map) in [("tidy", map), ("untidy", &editor.observers().1.0)] {
                assert_eq!(map.locate_all(editor.arrangement(), &points), expected, "{name}, edit {i}");
                for point in &points {
                    for ray in VerticalRay::BOTH {
                        let met = Naive.shoot(editor.arrangement(), point, ray);
                        assert_eq!(
                            map.shoot(editor.arrangement(), point, ray),
                            met,
                            "{name}, {ray:?}, {point}"
                        );
                    }
                }
            }
        }
    }
    assert!(editor.observers().1.0.is_worn(), "the order is not adverse");
}

type Observers = (TrapezoidalMap<SegmentTraits>, Untidy<SegmentTraits>);

#[test]
fn a_map_that_follows_segments_side_by_side_is_built_anew() {
    check_worn(|editor, i| {
        editor.insert_curve(&segment([[i, i], [1600 - i, i]]));
    });
}

#[test]
fn a_map_that_follows_points_in_their_order_is_built_anew() {
    check_worn(|editor, i| {
        editor.insert_point(&Point2::from_i64([i, 0]));
    });
}

/// Edges come and go, and nodes that nobody needs stay.
#[test]
fn a_map_that_follows_one_edge_to_and_fro_is_built_anew() {
    check_worn(|editor, i| {
        let old = editor.dcel().edges().next();
        if let Some(e) = old {
            editor.remove_edge(e);
        }
        editor.insert_curve(&segment([[0, i], [9, i + 1]]));
    });
}

/// Chains gave no ranges, and searches of maps of polylines compared all points exactly.
#[test]
fn vertices_of_polylines_have_ranges() {
    let traits = PolycurveTraits::new(SegmentTraits);
    for [x, y] in [[0, 0], [3, 1], [-5, 2], [1 << 40, 9]] {
        let point = Point2::from_i64([x, y]);
        assert_eq!(traits.order_range(&point), SegmentTraits.order_range(&point));
        assert_eq!(traits.order_range(&point).1, 0, "an integer is a float");
    }
}

/// A map that was away while the arrangement was edited, and comes back as an observer.
#[test]
fn a_map_that_missed_edits_is_made_anew() {
    let sides = [[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]].map(segment);
    let triangle = Arrangement::of_curves(SegmentTraits, BoundedPlane, &sides);
    for next in [[[20, 0], [21, 7]], [[12, 1], [12, 3]], [[0, 1], [4, 1]]] {
        let old = TrapezoidalMap::new(&triangle);
        let mut editor =
            Editor::with_observers(triangle.clone(), None::<TrapezoidalMap<_>>).expect("it is new");
        editor.insert_curve(&segment([[10, 2], [15, 2]]));
        assert!(old.locate(&editor, &Point2::from_i64([12, 2])).is_err(), "it missed an edit");
        *editor.observers_mut() = Some(old);
        editor.insert_curve(&segment(next));
        let map = editor.observers().as_ref().expect("it was put there");
        for point in (-1..23).flat_map(|x| (-1..8).map(move |y| Point2::from_i64([x, y]))) {
            assert_eq!(map.locate(&editor, &point), Naive.locate(&editor, &point), "{point}, {next:?}");
        }
    }
}
