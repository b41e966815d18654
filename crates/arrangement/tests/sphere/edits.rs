//! Curves come and go, one by one: against sweeps, copies that observers keep, and what was before.

use crate::arcs::Curve;
use crate::families::rows;
use crate::free_edits;
use crate::graph::Graph;
use crate::history;
use crate::matching::Matching;
use crate::own::{Globe, own, sweep, sweep_with, traits_of};
use crate::random::{random_curve, random_curves, random_point};
use crate::swept_again::swept_again;
use splitstar_arrangement::edit::{Mirror, Undo};
use splitstar_arrangement::location::TrapezoidalMap;
use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::{Arrangement, Editor};
use testkit::Rng;

pub(crate) type Observers = (Mirror<GeodesicTraits>, Undo<GeodesicTraits>, TrapezoidalMap<GeodesicTraits>);
pub(crate) type Watched = Editor<GeodesicTraits, Sphere, Observers>;

fn watch(globe: Globe) -> Watched {
    let observers = (Mirror::new(&globe), Undo::new(&globe), TrapezoidalMap::new(&globe));
    Editor::with_observers(globe, observers).unwrap()
}

fn empty(traits: &GeodesicTraits) -> Globe {
    Arrangement::new(traits.clone(), Sphere)
}

fn check(editor: &Watched, context: &str) {
    assert_eq!(editor.check_valid(), [], "{context}");
    let is_shown_alike = |a: &_, b: &_| format!("{a:?}") == format!("{b:?}");
    assert_eq!(editor.observers().0.difference(editor, is_shown_alike), None, "{context}");
}

/// What is drawn is what a sweep over the same curves draws.
fn check_curves(editor: &Watched, curves: &[Curve], context: &str) {
    check(editor, context);
    assert_eq!(editor.difference(&sweep_with(editor.traits(), curves)), None, "{context}");
}

/// Nothing is there, not even at the poles.
fn check_empty(editor: &Watched, context: &str) {
    check(editor, context);
    assert_eq!(editor.difference(&empty(editor.traits())), None, "{context}");
    assert_eq!(
        (editor.vertices().count(), editor.dcel().edge_count(), editor.dcel().face_count()),
        (0, 0, 1)
    );
    assert!([0, 1].iter().all(|&pole| editor.is_absent(dcel::VertexId(pole))), "{context}");
    Matching::new(&Graph::new(&[]), editor, context);
}

/// In one by one, the last half taken back and in again; then edge by edge away.
fn come_and_go(traits: &GeodesicTraits, curves: &[Curve], rng: &mut Rng, context: &str) {
    let mut editor = watch(empty(traits));
    let mut counts = Vec::new();
    for (i, curve) in curves.iter().enumerate() {
        counts.push(editor.observers().1.operation_count());
        editor.insert_curve(&curve.own());
        check_curves(&editor, &curves[..=i], &format!("after curve {i}, {context}"));
    }
    for i in (curves.len() / 2..curves.len()).rev() {
        // What changed nothing is no operation.
        while editor.observers().1.operation_count() > counts[i] {
            let last = editor.observers_mut().1.pop().unwrap();
            editor.take_back(last).unwrap();
        }
        check_curves(&editor, &curves[..i], &format!("curve {i} taken back, {context}"));
    }
    editor.insert_curves(&own(&curves[curves.len() / 2..]));
    check_curves(&editor, curves, &format!("in again, {context}"));
    Matching::new(&Graph::new(curves), &editor, context);
    let mut edges: Vec<_> = editor.dcel().edges().collect();
    rng.shuffle(&mut edges);
    for e in edges {
        editor.remove_edge(e);
        check(&editor, context);
        if rng.one_in(8) {
            assert_eq!(editor.difference(&swept_again(&editor)), None, "{context}");
        }
    }
    let isolated: Vec<_> = editor.vertices().collect();
    for v in isolated {
        assert!(editor.remove_vertex(v).is_ok(), "{context}");
        check(&editor, context);
    }
    check_empty(&editor, context);
    editor.compact();
    check_empty(&editor, context);
}

/// In by input, and out by input in another order.
fn remember(traits: &GeodesicTraits, curves: &[Curve], rng: &mut Rng, context: &str) {
    let mut made = history::Made::with_observers(traits.clone(), Sphere, Mirror::new).unwrap();
    let (first, last) = curves.split_at(rng.index(curves.len() + 1));
    let mut inputs: Vec<_> = made.insert_curves(&own(first)).into_iter().zip(first.to_vec()).collect();
    for curve in last {
        // A point may come as a point.
        let id = match curve {
            Curve::Point(p) if rng.one_in(2) => made.insert_point(&crate::own::direction(p)),
            curve => made.insert(&curve.own()),
        };
        inputs.push((id, curve.clone()));
    }
    history::check(&made, context);
    rng.shuffle(&mut inputs);
    while let Some((id, _)) = inputs.pop() {
        made.remove(id).unwrap();
        let left: Vec<Curve> = inputs.iter().map(|(_, curve)| curve.clone()).collect();
        let context = format!("{left:?} left, {context}");
        history::check(&made, &context);
        assert_eq!(made.difference(&sweep_with(traits, &left)), None, "{context}");
        assert_eq!(made.counts(), Graph::new(&left).counts, "{context}");
    }
}

#[test]
fn families_come_and_go() {
    let mut rng = Rng::new(21);
    for row in rows() {
        let context = format!("{}, seed {}: {:?}", row.name, rng.state(), row.curves);
        let mut curves = row.curves;
        rng.shuffle(&mut curves);
        if curves.len() < 30 {
            come_and_go(&GeodesicTraits::new(), &curves, &mut rng, &context);
            remember(&GeodesicTraits::new(), &curves, &mut rng, &context);
        }
    }
}

#[test]
fn random_curves_come_and_go() {
    let mut rng = Rng::new(22);
    for case in 0..300 {
        let context = format!("case {case}, seed {}", rng.state());
        let curves = random_curves(&mut rng, 1 + case % 8, 1 + case as i64 % 3);
        let context = format!("{context}: {curves:?}");
        let traits = traits_of(*rng.choose(&[[-1, 0], [0, 1], [1, 1], [2, -1]]));
        come_and_go(&traits, &curves, &mut rng, &context);
        remember(&traits, &curves, &mut rng, &context);
    }
}

/// Random scripts of inputs that come and go.
#[test]
fn scripts_of_inputs() {
    for seed in 1..40 {
        let range = 1 + seed as i64 % 2;
        let curve = move |rng: &mut Rng| random_curve(rng, range).own();
        let point = move |rng: &mut Rng| crate::own::direction(&random_point(rng, range));
        let pool = history::Pool { traits: GeodesicTraits::new(), curve: &curve, point: &point };
        history::play(Sphere, &pool, seed, 15, |_, _| {});
    }
}

/// One edit of an editor, drawn at random.
fn edit(editor: &mut Watched, rng: &mut Rng) -> String {
    let edges: Vec<_> = editor.dcel().edges().collect();
    let vertices: Vec<_> = editor.vertices().collect();
    let is_full = edges.len() > 30;
    match rng.below(22) {
        0..5 if !is_full => {
            let curve = random_curve(rng, 2);
            let mut expected = editor.arrangement().clone();
            expected.insert_curves([&curve.own()]);
            editor.insert_curve(&curve.own());
            assert_eq!(editor.difference(&expected), None, "{curve:?}");
            format!("insert {curve:?}")
        }
        5 => {
            let point = crate::own::direction(&random_point(rng, 2));
            let v = editor.insert_point(&point);
            assert_eq!(editor.locate(&point), Cell::Vertex(v));
            format!("insert point {point:?}")
        }
        6 if !is_full => {
            let curves: Vec<Geodesic> = (0..3).map(|_| random_curve(rng, 2).own()).collect();
            editor.insert_curves(&curves);
            "insert several".into()
        }
        7..10 if !edges.is_empty() => {
            let e = *rng.choose(&edges);
            editor.remove_edge(e);
            format!("remove {e:?}")
        }
        10 if !vertices.is_empty() => {
            let v = *rng.choose(&vertices);
            format!("remove {v:?}: {:?}", editor.remove_vertex(v).is_ok())
        }
        11 if !vertices.is_empty() => {
            let v = *rng.choose(&vertices);
            format!("remove {v:?} with edges: {:?}", editor.remove_vertex_with_edges(v).is_ok())
        }
        12 => {
            let mergeable = vertices.iter().copied().filter(|&v| editor.check_mergeable(v).is_ok());
            let mergeable: Vec<_> = mergeable.collect();
            if mergeable.is_empty() {
                return "nothing to merge".into();
            }
            let v = *rng.choose(&mergeable);
            editor.merge_edges(v).unwrap();
            format!("merge at {v:?}")
        }
        13 if rng.one_in(3) => {
            editor.compact();
            "compact".into()
        }
        15 | 16 if !is_full => free_edits::insert_free(editor, rng),
        17 if !edges.is_empty() => free_edits::split(editor, *rng.choose(&edges), rng),
        18 if !edges.is_empty() => free_edits::modify(editor, *rng.choose(&edges), rng),
        19 if !edges.is_empty() => free_edits::remove(editor, &edges, rng),
        14 if rng.one_in(8) => {
            editor.clear();
            check_empty(editor, "cleared");
            "clear".into()
        }
        _ => match editor.observers_mut().1.pop() {
            Some(last) => {
                editor.take_back(last).unwrap();
                "take back".into()
            }
            None => "nothing to take back".into(),
        },
    }
}

/// Edits of all kinds; after each, everything is valid, the copy is the same, and a sweep over the cells gives them again.
#[test]
fn scripts_of_edits() {
    for seed in 1..160 {
        let mut rng = Rng::new(seed);
        let traits = traits_of(*rng.choose(&[[-1, 0], [0, 1], [1, 1], [-2, 1]]));
        let mut editor = watch(empty(&traits));
        let mut log = vec![format!("seed {seed}, {:?}", traits.identification())];
        for _ in 0..30 {
            log.push(edit(&mut editor, &mut rng));
            let context = log.join("\n");
            check(&editor, &context);
            assert_eq!(editor.difference(&swept_again(&editor)), None, "{context}");
            let points: Vec<_> = (0..4).map(|_| crate::own::direction(&random_point(&mut rng, 2))).collect();
            for point in &points {
                let cell = splitstar_arrangement::locate_all(&editor, std::slice::from_ref(point))[0];
                assert_eq!(editor.locate(point), cell, "{point:?}, {context}");
            }
        }
    }
}

/// Poles come and go as vertices: with the ends of arcs, with points, and with arcs that pass through.
#[test]
fn a_pole_is_there_as_long_as_something_is() {
    use crate::arcs::{circle, point, short};
    let mut editor = watch(empty(&GeodesicTraits::new()));
    let north = dcel::VertexId(1);
    let through = short([1, 0, 1], [-1, 0, 1]);
    let edges = editor.insert_curve(&through.own());
    assert!(!editor.is_absent(north) && editor.is_artificial(north) && editor.counts().vertices == 2);
    let end = short([0, 0, 1], [0, 1, 1]);
    let to_pole = editor.insert_curve(&end.own());
    assert!(!editor.is_artificial(north));
    check_curves(&editor, &[through.clone(), end], "with an end");
    editor.remove_edges(&to_pole);
    check(&editor, "without the end");
    // Nobody knows whether it was given, too: it stays an ordinary vertex.
    assert_eq!((editor.is_artificial(north), editor.counts().vertices, editor.counts().edges), (false, 3, 2));
    editor.remove_edges(&edges);
    check_empty(&editor, "without the arc through the pole");
    editor.insert_curve(&point([0, 0, 1]).own());
    assert_eq!((editor.is_absent(north), editor.counts().isolated), (false, 1));
    editor.insert_curve(&circle([1, 0, 0]).own());
    check_curves(&editor, &[point([0, 0, 1]), circle([1, 0, 0])], "with a circle");
    assert_eq!(sweep(&[circle([1, 0, 0]), point([0, 0, 1])]).counts().vertices, 1);
}
