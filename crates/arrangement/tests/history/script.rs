//! Random insertions and removals, each followed by all checks.

use splitstar_arrangement::Arrangement;
use splitstar_arrangement::edit::Mirror;
use splitstar_arrangement::history::{ArrangementWithHistory, Input, InputId};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{ArrangementTraits, Intersection, Piece};
use testkit::Rng;

/// A watched arrangement.
pub(crate) type Made<G, T> = ArrangementWithHistory<G, T, Mirror<G>>;

/// The arrangement that a sweep makes of the inputs.
pub(crate) fn swept<G: ArrangementTraits + Clone, T: Topology<G>>(made: &Made<G, T>) -> Arrangement<G, T> {
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    for (_, input) in made.inputs() {
        match input {
            Input::Curve(curve) => curves.push(curve),
            Input::Point(point) => points.push(point.clone()),
        }
    }
    Arrangement::of_curves_and_points(made.traits().clone(), made.topology().clone(), curves, points)
}

/// The inputs along which each edge lies are those that overlap it.
fn check_inputs<G: ArrangementTraits, T: Topology<G>>(made: &Made<G, T>, context: &str) {
    let (traits, dcel) = (made.traits(), made.dcel());
    let mut pieces = Vec::new();
    for (id, input) in made.inputs() {
        let mut cut = Vec::new();
        match input {
            Input::Curve(curve) => traits.make_u_monotone(curve, &mut cut),
            Input::Point(point) => cut.push(Piece::Point(point.clone())),
        }
        let points = cut.iter().filter(|piece| matches!(piece, Piece::Point(_))).count();
        let vertices: Vec<_> = made.points_of(id).collect();
        assert_eq!(vertices.len(), points, "{context}");
        for &v in &vertices {
            assert!(made.curves_at(v).contains(&id), "{context}");
        }
        pieces.push((id, cut));
    }
    let mut common = Vec::new();
    for e in dcel.edges() {
        let edge = made.make_edge_curve(e);
        let mut expected = Vec::new();
        for (id, cut) in &pieces {
            common.clear();
            for piece in cut {
                if let Piece::Curve { curve, .. } = piece {
                    traits.intersect(&edge, curve, &mut common);
                }
            }
            let count = common.iter().filter(|x| matches!(x, Intersection::Overlap(_))).count();
            assert_eq!(
                made.edges_of(*id).filter(|&other| other == e).count(),
                count,
                "{context}: {id:?} {e:?}"
            );
            if count > 0 {
                expected.push(*id);
            }
        }
        assert_eq!(made.curves_of(e).collect::<Vec<_>>(), expected, "{context}: {e:?}");
        assert!(!expected.is_empty(), "{context}: {e:?} is nobody's");
        for v in dcel.ends(e) {
            let at = made.curves_at(v);
            assert!(expected.iter().all(|id| at.contains(id)), "{context}");
        }
    }
}

/// Everything that has to hold.
pub(crate) fn check<G: ArrangementTraits + Clone, T: Topology<G>>(made: &Made<G, T>, context: &str) {
    assert_eq!(made.check_valid(), [], "{context}");
    assert_eq!(made.observers().difference(made, |_, _| true), None, "{context}");
    let swept = swept(made);
    assert_eq!(made.counts(), swept.counts(), "{context}");
    assert_eq!(made.counts_with_splits(), swept.counts_with_splits(), "{context}");
    assert_eq!(made.difference(&swept), None, "{context}");
    check_inputs(made, context);
}

/// What a script may insert.
pub(crate) struct Pool<'p, G: ArrangementTraits> {
    pub(crate) traits: G,
    pub(crate) curve: &'p dyn Fn(&mut Rng) -> G::Curve,
    pub(crate) point: &'p dyn Fn(&mut Rng) -> G::Point,
}

/// Inserts and removes at random, and removes all in the end.
pub(crate) fn play<G: ArrangementTraits + Clone, T: Topology<G>>(
    topology: T,
    pool: &Pool<'_, G>,
    seed: u64,
    steps: usize,
    look: impl Fn(&Made<G, T>, &str),
) {
    let mut rng = Rng::new(seed);
    let mut made =
        Made::with_observers(pool.traits.clone(), topology, Mirror::new).expect("the mirror is new");
    let mut inputs: Vec<InputId> = Vec::new();
    for step in 0..steps {
        let action = rng.below(14);
        let context = format!("seed {seed}, step {step}, action {action}");
        match action {
            0..=4 => inputs.push(made.insert(&(pool.curve)(&mut rng))),
            5 => inputs.push(made.insert_point(&(pool.point)(&mut rng))),
            6 => {
                let curves: Vec<_> = (0..rng.index(5)).map(|_| (pool.curve)(&mut rng)).collect();
                let points: Vec<_> = (0..rng.index(3)).map(|_| (pool.point)(&mut rng)).collect();
                inputs.extend(made.insert_curves_and_points(&curves, points));
            }
            8 => {
                let places: Vec<_> = inputs.iter().flat_map(|&id| made.edges_of(id)).collect();
                let renumbering = made.compact();
                let places = places.into_iter().map(|e| renumbering.edge(e).expect("edges stay"));
                assert!(places.eq(inputs.iter().flat_map(|&id| made.edges_of(id))), "{context}");
                assert_eq!(made.dcel().edge_bound(), made.dcel().edge_count());
            }
            // The same once more.
            7 if !inputs.is_empty() => {
                match made.input(*rng.choose(&inputs)).expect("inputs stay").clone() {
                    Input::Curve(curve) => inputs.push(made.insert(&curve)),
                    Input::Point(point) => inputs.push(made.insert_point(&point)),
                };
            }
            _ if !inputs.is_empty() => {
                let id = inputs.swap_remove(rng.index(inputs.len()));
                assert!(made.remove(id).is_some(), "{context}");
                assert!(made.remove(id).is_none() && made.edges_of(id).next().is_none(), "{context}");
            }
            _ => {}
        }
        assert_eq!(made.input_count(), inputs.len());
        check(&made, &context);
        look(&made, &context);
    }
    rng.shuffle(&mut inputs);
    for (i, id) in inputs.into_iter().enumerate() {
        made.remove(id);
        check(&made, &format!("seed {seed}, removal {i}"));
    }
    assert_eq!((made.dcel().edge_count(), made.dcel().face_count(), made.vertices().count()), (0, 1, 0));
}
