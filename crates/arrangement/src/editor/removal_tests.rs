//! What removals leave of the trapezoids.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use super::*;
use crate::insert::Pieces;
use crate::random::{
    Numbers, Scene, random_cylinder, random_globe, random_lines, random_paths, random_segments,
};
use crate::traits::ArrangementTraits;
use dcel::{EdgeId, EndFate};

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

fn on<G: ArrangementTraits + Clone, T: Topology<G>>(
    most: i64,
    draw: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
) {
    for seed in 1..100 {
        println!("seed {seed}");
        let mut numbers = Numbers::of_seed(seed);
        let scene = draw(&mut numbers, most);
        take_apart(scene.arrangement(), &mut numbers);
    }
}

#[test]
fn segments() {
    on(12, random_segments);
}

#[test]
fn lines_and_rays() {
    on(9, random_lines);
}

#[test]
fn paths_on_a_torus() {
    on(5, random_paths);
}

#[test]
fn paths_on_a_cylinder() {
    on(5, random_cylinder);
}

#[test]
fn arcs_on_a_sphere() {
    on(6, random_globe);
}
