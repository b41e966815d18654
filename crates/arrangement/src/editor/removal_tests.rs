//! What removals leave of the trapezoids.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use super::*;
use crate::insert::Pieces;
use crate::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use crate::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use crate::traits::ArrangementTraits;
use dcel::{EdgeId, EndFate};
use exact::planar::Point2;

/// Numbers as good as random.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as i64
    }
}

/// The edges and isolated vertices of an arrangement, swept anew.
fn swept_again<G: UMonotoneTraits + Clone, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
) -> Arrangement<G, T> {
    let dcel = arrangement.dcel();
    let mut pieces = Pieces::<G>::new();
    for e in dcel.edges() {
        let is_artificial = dcel.ends(e).map(|v| arrangement.is_artificial(v));
        pieces.push_piece(arrangement.make_edge_curve(e), is_artificial);
    }
    for v in arrangement.vertices().filter(|&v| dcel.outgoing(v).is_none()) {
        pieces.push_point(arrangement.point(v).expect("it is a point").clone());
    }
    Arrangement::of_pieces(arrangement.traits().clone(), arrangement.topology().clone(), pieces)
}

fn check<G: ArrangementTraits + Clone, T: Topology<G>>(editor: &Editor<G, T>) {
    assert_eq!(editor.trapezoids.find_faults(&editor.arrangement), Vec::<String>::new());
    assert_eq!(editor.check_valid(), []);
    assert_eq!(editor.difference(&swept_again(editor)), None);
}

/// Removes and merges at random until nothing is left.
fn take_apart<G: ArrangementTraits + Clone, T: Topology<G>>(
    arrangement: Arrangement<G, T>,
    numbers: &mut Numbers,
) {
    let mut editor = Editor::new(arrangement);
    check(&editor);
    loop {
        let edges: Vec<EdgeId> = editor.dcel().edges().collect();
        let vertices: Vec<_> = editor.vertices().collect();
        let Some(&v) = vertices.get(numbers.below(vertices.len().max(1) as i64) as usize) else {
            // Whole lines have no vertices.
            let Some(&e) = edges.first() else { break };
            editor.remove_edge(e);
            check(&editor);
            continue;
        };
        match numbers.below(8) {
            0 => {
                editor.remove_vertex_with_edges(v).expect("it is a point");
            }
            1 | 2 => {
                let _ = editor.remove_vertex(v);
            }
            3 => {
                let _ = editor.merge_edges(v);
            }
            _ if edges.is_empty() => {
                editor.remove_vertex(v).expect("it is isolated");
            }
            _ => {
                let e = edges[numbers.below(edges.len() as i64) as usize];
                let fates =
                    [0; 2].map(|_| if numbers.below(4) == 0 { EndFate::Isolate } else { EndFate::Remove });
                editor.remove_edge_with(e, fates);
            }
        }
        check(&editor);
    }
    assert_eq!((editor.dcel().edge_count(), editor.dcel().face_count()), (0, 1));
    assert_eq!(editor.trapezoids.count(), 1);
}

#[test]
fn segments() {
    for seed in 1..100 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(12);
        let size = 3 + numbers.below(6);
        let segments: Vec<Segment> = (0..n)
            .filter_map(|_| {
                let mut point = || [numbers.below(size), numbers.below(size)];
                Segment::from_i64([point(), point()])
            })
            .collect();
        let points = [[0, 0], [1, 1], [1, 2], [7, 1]].map(Point2::from_i64);
        let arrangement = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &segments, points);
        take_apart(arrangement, &mut numbers);
    }
}

#[test]
fn lines_and_rays() {
    for seed in 1..100 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(9);
        let size = 2 + numbers.below(4);
        let curves: Vec<Linear> = (0..n)
            .filter_map(|_| {
                let mut point = || Point2::from_i64([numbers.below(size), numbers.below(size)]);
                let (p, q) = (point(), point());
                match numbers.below(3) {
                    0 => Linear::line(&p, &q),
                    1 => Linear::ray(p, &q),
                    _ => Linear::segment(p, q),
                }
            })
            .collect();
        let points = [[0, 0], [1, 1], [7, 1]].map(Point2::from_i64);
        let arrangement = Arrangement::of_curves_and_points(LinearTraits, UnboundedPlane, &curves, points);
        take_apart(arrangement, &mut numbers);
    }
}

#[test]
fn paths_on_a_torus() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    for seed in 1..100 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(5);
        let paths: Vec<_> = (0..n)
            .filter_map(|_| {
                let start = Point2::from_i64([numbers.below(4), numbers.below(4)]);
                let way = [numbers.below(9) - 4, numbers.below(9) - 4].map(exact::Rational::from);
                traits.path(&start, &way).ok()
            })
            .collect();
        let points = [[0, 0], [1, 1], [0, 3]].map(Point2::from_i64);
        let arrangement = Arrangement::of_curves_and_points(traits.clone(), FlatTorus, &paths, points);
        take_apart(arrangement, &mut numbers);
    }
}
