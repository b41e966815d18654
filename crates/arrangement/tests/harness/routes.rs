//! The ways in which an arrangement can be made.

use crate::curves::{Curve, P};
use crate::family::Family;
use crate::models::Model;
use crate::oracle::{Cells, cells_of};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::overlay_all;
use testkit::Rng;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Route {
    /// One sweep.
    Sweep,
    /// One sweep over a part, and the rest inserted.
    Halves,
    /// One curve after the other.
    OneByOne,
    /// The overlay of two parts.
    OverlayOfTwo,
    /// The overlay of three parts.
    OverlayOfThree,
}

pub(crate) type Made<M> = Arrangement<<M as Family>::Traits, <M as Family>::Surface>;

impl Route {
    pub(crate) const ALL: [Self; 5] =
        [Self::Sweep, Self::Halves, Self::OneByOne, Self::OverlayOfTwo, Self::OverlayOfThree];

    /// Makes the arrangement; `None` if the model cannot carry the curves.
    pub(crate) fn build<M: Model>(self, model: &M, curves: &[Curve], rng: &mut Rng) -> Option<Made<M>> {
        let of = |curves: &[Curve]| {
            Some(Arrangement::of_pieces(model.traits(), model.surface(), model.pieces(curves)?))
        };
        let mut arrangement = match self {
            Self::Sweep => return of(curves),
            Self::OneByOne => Arrangement::new(model.traits(), model.surface()),
            Self::Halves => {
                let [first, second] = split(curves, rng);
                let mut arrangement = of(&first)?;
                arrangement.insert_pieces(model.pieces(&second)?);
                return Some(arrangement);
            }
            Self::OverlayOfTwo => {
                let [a, b] = split::<2>(curves, rng);
                return Some(overlay_all(&[&of(&a)?, &of(&b)?]).0);
            }
            Self::OverlayOfThree => {
                let [a, b, c] = split::<3>(curves, rng);
                return Some(overlay_all(&[&of(&a)?, &of(&b)?, &of(&c)?]).0);
            }
        };
        for curve in curves {
            arrangement.insert_pieces(model.pieces(std::slice::from_ref(curve))?);
        }
        Some(arrangement)
    }
}

/// Deals curves out to some hands.
fn split<const N: usize>(curves: &[Curve], rng: &mut Rng) -> [Vec<Curve>; N] {
    let mut parts = [const { Vec::new() }; N];
    for curve in curves {
        parts[rng.index(N)].push(curve.clone());
    }
    parts
}

/// Makes an arrangement by some routes, and checks each result: it is valid, has the cells that brute force found, and is the same as
/// the others. Gives the first one; `None` if the model cannot carry the curves.
pub(crate) fn check<M: Model>(
    model: &M,
    curves: &[Curve],
    routes: &[Route],
    cells: &Cells,
    rng: &mut Rng,
) -> Option<Made<M>> {
    let mut first: Option<Made<M>> = None;
    for &route in routes {
        let seed = rng.state();
        let arrangement = route.build(model, curves, rng)?;
        let context = || format!("{model:?} by {route:?}, seed {seed}: {curves:?}");
        let violations = arrangement.check_valid();
        assert!(violations.is_empty(), "{violations:?}, {}", context());
        assert_eq!(arrangement.counts(), cells.counts, "{}", context());
        let (vertices, mut edges) = cells_of(&arrangement);
        let places = cells.vertices.iter().map(|p| model.place(p)).collect();
        assert_eq!(vertices, places, "{}", context());
        let ends = |ends: &[Option<P>; 2]| {
            let mut ends = ends.each_ref().map(|end| end.as_ref().map(|p| model.place(p)));
            ends.sort();
            ends
        };
        let mut expected: Vec<_> = cells.edges.iter().map(|(pair, _)| ends(pair)).collect();
        expected.sort();
        edges.sort();
        assert_eq!(edges, expected, "{}", context());
        match &first {
            None => first = Some(arrangement),
            Some(first) => {
                let difference = first.difference(&arrangement);
                assert!(difference.is_none(), "{difference:?}, {}", context());
            }
        }
    }
    first
}
