//! Curves one by one, and away again, against one sweep.

use crate::paths::{Curve, make};
use crate::random::{SIZE, random_curves};
use crate::strip::{Band, Strip};
use crate::tables::KINDS;
use splitstar_arrangement::edit::{Mirror, Undo};
use splitstar_arrangement::history::ArrangementWithHistory;
use splitstar_arrangement::traits::SideKind;
use splitstar_arrangement::{Arrangement, Editor};
use testkit::Rng;

type Watched<const M: bool> = Editor<Strip<M>, Band, (Mirror<Strip<M>>, Undo<Strip<M>>)>;

fn watch<const M: bool>(kinds: [SideKind; 2]) -> Watched<M> {
    let empty = Arrangement::new(Strip { size: SIZE, v: kinds }, Band(kinds));
    let observers = (Mirror::new(&empty), Undo::new(&empty));
    Editor::with_observers(empty, observers).unwrap()
}

fn check<const M: bool>(editor: &Watched<M>, context: &str) {
    assert_eq!(editor.check_valid(), [], "{context}");
    let is_shown_alike = |a: &_, b: &_| format!("{a:?}") == format!("{b:?}");
    assert_eq!(editor.observers().0.difference(editor, is_shown_alike), None, "{context}");
}

/// In one by one; the last half taken back; then edge by edge away.
fn edit<const M: bool>(rng: &mut Rng, kinds: [SideKind; 2], curves: &[Curve], context: &str) {
    let mut editor = watch::<M>(kinds);
    let mut counts = Vec::new();
    for (i, curve) in curves.iter().enumerate() {
        counts.push(editor.observers().1.operation_count());
        editor.insert_curve(curve);
        check(&editor, context);
        let swept = make::<M>(SIZE, kinds, &curves[..=i]);
        assert_eq!(editor.difference(&swept), None, "after curve {i}, {context}");
    }
    for i in (curves.len() / 2..curves.len()).rev() {
        // What changed nothing is no operation.
        while editor.observers().1.operation_count() > counts[i] {
            let last = editor.observers_mut().1.pop().unwrap();
            editor.take_back(last).unwrap();
        }
        check(&editor, context);
        let swept = make::<M>(SIZE, kinds, &curves[..i]);
        assert_eq!(editor.difference(&swept), None, "curve {i} taken back, {context}");
    }
    let mut edges: Vec<_> = editor.dcel().edges().collect();
    rng.shuffle(&mut edges);
    for e in edges {
        editor.remove_edge(e);
        check(&editor, context);
    }
    let isolated: Vec<_> = editor.vertices().collect();
    for v in isolated {
        editor.remove_vertex(v).unwrap();
    }
    check(&editor, context);
    assert_eq!(editor.difference(&make::<M>(SIZE, kinds, &[])), None, "{context}");
}

/// In and out by input.
fn remember<const M: bool>(rng: &mut Rng, kinds: [SideKind; 2], curves: &[Curve], context: &str) {
    let mut made = ArrangementWithHistory::new(Strip::<M> { size: SIZE, v: kinds }, Band(kinds));
    let (first, last) = curves.split_at(rng.index(curves.len() + 1));
    let mut inputs: Vec<_> = made.insert_curves(first).into_iter().zip(first.iter().copied()).collect();
    inputs.extend(last.iter().map(|curve| (made.insert(curve), *curve)));
    rng.shuffle(&mut inputs);
    while let Some((id, _)) = inputs.pop() {
        made.remove(id).unwrap();
        assert_eq!(made.check_valid(), [], "{context}");
        let left: Vec<Curve> = inputs.iter().map(|(_, curve)| *curve).collect();
        assert_eq!(made.difference(&make::<M>(SIZE, kinds, &left)), None, "{left:?} left, {context}");
    }
}

#[test]
fn curves_come_and_go() {
    for (number, kinds) in (0..).zip(KINDS) {
        let seed = 7001 + number;
        let mut rng = Rng::new(seed);
        for round in 0..60 {
            let curves = random_curves(&mut rng, kinds, 7);
            let context = format!("seed {seed}, round {round}, {kinds:?}: {curves:?}");
            edit::<true>(&mut rng, kinds, &curves, &context);
            edit::<false>(&mut rng, kinds, &curves, &context);
            remember::<true>(&mut rng, kinds, &curves, &context);
            remember::<false>(&mut rng, kinds, &curves, &context);
        }
    }
}

fn insert_all(kinds: [SideKind; 2], curves: &[Curve]) {
    let mut rng = Rng::new(1);
    let context = format!("{curves:?}");
    edit::<true>(&mut rng, kinds, curves, &context);
    edit::<false>(&mut rng, kinds, curves, &context);
    remember::<true>(&mut rng, kinds, curves, &context);
    remember::<false>(&mut rng, kinds, curves, &context);
}

/// The vertices at both ends of a cylinder are isolated in one face at first, and in two after that.
#[test]
fn an_isolated_vertex_of_a_side_gets_into_the_new_face() {
    insert_all([SideKind::Open, SideKind::Open], &[Curve::Parallel(3)]);
    insert_all([SideKind::Contracted, SideKind::Contracted], &[Curve::Parallel(1), Curve::Parallel(3)]);
}

/// A curve that winds round and was connected with the pole is no hole without it.
#[test]
fn what_loses_its_pole_may_wind_round() {
    let kinds = [SideKind::Closed, SideKind::Contracted];
    for meridian in [[[1, 3], [1, 4]], [[0, 3], [0, 4]]] {
        insert_all(kinds, &[Curve::Parallel(3), Curve::Path(meridian)]);
        insert_all(kinds, &[Curve::Path(meridian), Curve::Parallel(3), Curve::Parallel(1)]);
    }
}

/// They run together from the seam to the pole: that has no point at which they could part.
#[test]
fn two_curves_run_together_from_the_seam_to_a_pole() {
    let curve = Curve::Path([[1, 3], [9, 0]]);
    insert_all([SideKind::Contracted, SideKind::Open], &[curve, curve]);
}
