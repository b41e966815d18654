//! Kinds of CCBs, compared with what a sweep says.

use super::scenes::{OnTorus, plane, random_plane, random_torus, random_whole_plane, torus};
use super::{Rng, Snapshot, is_shown_alike};
use crate::arrangement::Arrangement;
use crate::edit::turns::SettledInsertion;
use crate::edit::{Edit, EditOf, Mirror, Observer, Operation, Undo};
use crate::insert::Pieces;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{CcbKind, EdgeId, EndFate, Side};
use exact::planar::Point2;

/// What the tests want of a model.
trait Traits: UMonotoneTraits<Point = Point2> + Clone + std::fmt::Debug {}
impl<G: UMonotoneTraits<Point = Point2> + Clone + std::fmt::Debug> Traits for G {}

fn check_turns<G: Traits, T: Topology<G>>(arrangement: &Arrangement<G, T>, context: &str) -> [usize; 4] {
    let mut met = [0; 4];
    let dcel = arrangement.dcel();
    for ccb in dcel.ccbs() {
        let turns = arrangement.turns_of(dcel.ccb_halfedge(ccb));
        for h in dcel.ccb_cycle(ccb) {
            assert_eq!(arrangement.turns_of(h), turns, "from wherever one begins, {context}");
        }
        let is_inner = dcel.ccb_kind(ccb) == CcbKind::Inner;
        assert_eq!(turns == Some(-1), is_inner, "{ccb:?}, {turns:?}, {context}");
        met[turns.map_or(3, |turns| (turns + 1) as usize)] += 1;
    }
    met
}

#[test]
fn turns_are_those_that_the_sweep_counted() {
    let mut met = [[0; 4]; 3];
    let mut rng = Rng(20_261_122);
    for _ in 0..400 {
        let context = format!("seed {}", rng.0);
        let found = [
            check_turns(&random_plane(&mut rng), &context),
            check_turns(&random_whole_plane(&mut rng), &context),
            check_turns(&random_torus(&mut rng), &context),
        ];
        for (met, found) in met.iter_mut().flatten().zip(found.into_iter().flatten()) {
            *met += found;
        }
    }
    assert!(met[0][0] > 100 && met[0][2] > 100, "{met:?}");
    assert!(met[1][0] > 50 && met[1][3] > 100, "{met:?}");
    assert!(met[2].iter().take(3).all(|&count| count > 50), "{met:?}");
}

/// The same points and edges, swept again.
fn swept_again<G: Traits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Arrangement<G, T> {
    let mut pieces = Pieces::new();
    let dcel = arrangement.dcel();
    dcel.edges().for_each(|e| pieces.push_curve(arrangement.make_edge_curve(e)));
    let isolated = arrangement.vertices().filter(|&v| dcel.isolated_face(v).is_some());
    isolated.filter_map(|v| arrangement.point(v)).for_each(|point| pieces.push_point(point.clone()));
    Arrangement::of_pieces(arrangement.traits().clone(), arrangement.topology().clone(), pieces)
}

/// The edit that inserts an edge that `before` has and `after` not.
fn insertion<G: Traits, T: Topology<G>>(
    before: &Arrangement<G, T>,
    after: &Arrangement<G, T>,
    e: EdgeId,
) -> EditOf<G> {
    let support = before.support(e);
    let ends = before.dcel().ends(e);
    let prevs = [e.halfedge(), e.halfedge().twin()].map(|h| before.dcel().prev(h));
    let [is_even_alone, is_odd_alone] = prevs.map(|h| h.edge_id() == e);
    let lies_in = |i: usize| after.dcel().isolated_face(ends[i]);
    match (lies_in(0), lies_in(1)) {
        (Some(face), _) if ends[0] == ends[1] => {
            Edit::InsertLoop { v: ends[0], face, kinds: [CcbKind::Inner; 2], support }
        }
        (Some(face), Some(_)) => Edit::InsertEdgeInFace { ends, face, kind: CcbKind::Inner, support },
        (Some(_), None) => Edit::InsertEdgeTo { v: ends[0], prev: prevs[1], support },
        (None, Some(_)) => Edit::InsertEdgeFrom { prev: prevs[0], v: ends[1], support },
        _ if is_even_alone => Edit::InsertEdgeBetween { prevs: [prevs[1]; 2], is_reversed: false, support },
        _ if is_odd_alone => Edit::InsertEdgeBetween { prevs: [prevs[0]; 2], is_reversed: true, support },
        _ if after.dcel().ccb(prevs[0]) == after.dcel().ccb(prevs[1]) => {
            Edit::InsertEdgeBetween { prevs, is_reversed: false, support }
        }
        _ => Edit::InsertEdgeJoining { prevs, kind: after.joined_kind(prevs), support },
    }
}

/// An edge that was removed is inserted again: its CCBs must have the kinds that they had.
fn check_insertion<G: Traits, T: Topology<G>>(
    before: &Arrangement<G, T>,
    after: &Arrangement<G, T>,
    e: EdgeId,
    context: &str,
) -> usize {
    let mut again = after.clone();
    let edit = insertion(before, after, e);
    let mut mirror = Mirror::new(&again);
    assert_eq!(again.apply(edit.clone(), &mut mirror).edge(), e, "{context}");
    let SettledInsertion { kinds, splits_face, shorter } = again.settle_insertion(e, &mut mirror);
    assert_eq!(mirror.difference(&again, is_shown_alike), None, "{context}");
    let halves = [e.halfedge(), e.halfedge().twin()];
    let kind_in = |of: &Arrangement<G, T>| halves.map(|h| of.dcel().ccb_kind(of.dcel().ccb(h)));
    assert_eq!([kinds, kind_in(&again)], [kind_in(before); 2], "{edit:?}, {context}");
    let [even, odd] = halves.map(|h| before.dcel().face(h));
    assert_eq!(splits_face, even != odd, "{edit:?}, {context}");
    let [length, other] = [e.half(shorter), e.half(shorter).twin()].map(|h| before.dcel().cycle(h).count());
    assert!(length <= other || !splits_face, "{context}");
    usize::from(splits_face)
}

/// Removes all edges in random order, and takes all back; gives how often a face was split when an edge was inserted again.
fn remove_all<G: Traits, T: Topology<G>>(mut arrangement: Arrangement<G, T>, rng: &mut Rng) -> usize {
    let seed = rng.0;
    let vertices: Vec<_> = arrangement.vertices().collect();
    for v in vertices {
        arrangement.apply(Edit::SetArtificial { v, is_artificial: false }, &mut ());
    }
    let mut observers = (Mirror::new(&arrangement), Undo::new(&arrangement));
    let mut states = vec![Snapshot::of(&arrangement)];
    let mut splits = 0;
    loop {
        let edges: Vec<EdgeId> = arrangement.dcel().edges().collect();
        let Some(e) = rng.choose(&edges) else { break };
        let context = format!("edge {} of {}, seed {seed}", e.0, edges.len());
        let before = arrangement.clone();
        let fates = arrangement.dcel().ends(e).map(|v| {
            let stays = arrangement.is_at_infinity(v) || rng.below(3) > 0;
            if stays { EndFate::Isolate } else { EndFate::Remove }
        });
        observers.begin_operation(&arrangement, Operation::RemoveEdge);
        arrangement.remove_and_settle(e, fates, &mut observers);
        observers.end_operation(&arrangement, Operation::RemoveEdge);
        assert_eq!(arrangement.check_valid(), [], "{context}");
        let difference = arrangement.difference(&swept_again(&arrangement));
        assert_eq!(difference, None, "{context}");
        assert_eq!(observers.0.difference(&arrangement, is_shown_alike), None, "{context}");
        assert!(arrangement.dcel().has_face(arrangement.corner_face()), "{context}");
        if fates == [EndFate::Isolate; 2] {
            splits += check_insertion(&before, &arrangement, e, &context);
        }
        states.push(Snapshot::of(&arrangement));
    }
    assert_eq!(arrangement.dcel().face_count(), 1);
    let (mut mirror, mut undo) = observers;
    while let Some(state) = states.pop() {
        assert_eq!(Snapshot::of(&arrangement), state, "seed {seed}");
        assert_eq!(arrangement.check_valid(), [], "seed {seed}");
        assert_eq!(undo.take_back(&mut arrangement, &mut mirror), Ok(!states.is_empty()), "seed {seed}");
        assert_eq!(mirror.difference(&arrangement, is_shown_alike), None, "seed {seed}");
    }
    splits
}

#[test]
fn removing_all_edges_of_the_plane() {
    let mut rng = Rng(1);
    let splits: usize = (0..250).map(|_| remove_all(random_plane(&mut rng), &mut rng)).sum();
    assert!(splits > 100, "{splits}");
}

#[test]
fn removing_all_edges_of_the_unbounded_plane() {
    let mut rng = Rng(2);
    let splits: usize = (0..60).map(|_| remove_all(random_whole_plane(&mut rng), &mut rng)).sum();
    assert!(splits > 100, "{splits}");
}

#[test]
fn removing_all_edges_of_a_torus() {
    let mut rng = Rng(3);
    let splits: usize = (0..150).map(|_| remove_all(random_torus(&mut rng), &mut rng)).sum();
    assert!(splits > 100, "{splits}");
}

/// Curves that wind round a torus, alone, beside and across one another, with something in the faces.
#[test]
fn removing_what_winds_round_a_torus() {
    use OnTorus::{Closed, Path, Point};
    let square = [Path([1, 1], [1, 0]), Path([2, 1], [0, 1]), Path([2, 2], [-1, 0]), Path([1, 2], [0, -1])];
    let scenes: [&[OnTorus]; 9] = [
        &[Closed([0, 0], [1, 0])],
        &[Closed([0, 0], [0, 1]), Point([2, 2])],
        &[Closed([0, 0], [1, 0]), Closed([0, 1], [1, 0]), Path([1, 2], [1, 0])],
        &[Closed([0, 0], [1, 0]), Closed([0, 1], [1, 0]), Closed([0, 2], [-1, 0])],
        &[Closed([0, 0], [1, 0]), Closed([0, 0], [0, 1])],
        &[Closed([0, 0], [1, 1]), Closed([0, 0], [1, -1]), Point([2, 0])],
        &[Closed([0, 0], [1, 0]), Path([1, 0], [0, 2]), Path([2, 0], [0, 3])],
        &square,
        &[square[0], square[1], square[2], square[3], Closed([0, 0], [2, 1]), Path([1, 1], [-3, 0])],
    ];
    let mut rng = Rng(4);
    for scene in scenes {
        for _ in 0..20 {
            remove_all(torus(scene), &mut rng);
        }
    }
}

/// Two squares side by side, with points in them: the face with more in it survives. The outer one has one CCB.
#[test]
fn the_face_with_more_in_it_survives() {
    let squares =
        [[0, 0, 4, 0], [4, 0, 8, 0], [0, 4, 4, 4], [4, 4, 8, 4], [0, 0, 0, 4], [4, 0, 4, 4], [8, 0, 8, 4]];
    for (points, is_left) in [(&[[1, 1], [1, 2], [6, 2]], true), (&[[1, 1], [6, 1], [6, 2]], false)] {
        let arrangement = plane(&squares, points);
        let dcel = arrangement.dcel();
        let sides = |e: EdgeId| [Side::Even, Side::Odd].map(|side| dcel.face(e.half(side)));
        for e in dcel.edges() {
            let survivor = dcel.face(e.half(arrangement.survivor_of(e)));
            if let Some(inner) = sides(e).into_iter().position(|f| f == arrangement.corner_face()) {
                let inner = sides(e)[1 - inner];
                assert_eq!(survivor, inner, "it has a point, and the corner face has none");
                let mut edited = arrangement.clone();
                edited.remove_and_settle(e, [EndFate::Remove; 2], &mut ());
                assert_eq!(edited.corner_face(), inner);
                assert_eq!(edited.check_valid(), []);
            } else {
                // The edge between the squares runs up: the left one is on its even side.
                assert_eq!(survivor, sides(e)[usize::from(!is_left)], "{points:?}");
            }
        }
    }
}
