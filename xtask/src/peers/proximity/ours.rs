//! Our side: one query after the other, each from where the last one has ended if the placements are coherent.

use std::hint::black_box;

use polytope::Polytope;
use proximity::{RelativePlacement, Translation};

use super::placements::Place;
use super::rows::{Order, Query};
use crate::peers::arrangements::timed;
use crate::peers::pairs::Operand;
use crate::{Failure, library};

/// What we measured.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ours {
    /// Median processor nanoseconds of a query.
    pub(super) nanoseconds: f64,
    pub(super) fastest: f64,
    pub(super) repetitions: usize,
    /// All distances or depths, or how often the polytopes meet: what other programs give, too.
    pub(super) sum: f64,
}

/// The polytopes of two operands.
///
/// # Errors
/// If a file is missing or not convex.
pub(super) fn polytopes(operands: [Operand; 2]) -> Result<[Polytope; 2], Failure> {
    let [a, b] = operands.map(|operand| {
        let mesh = library::read(&operand.path())?;
        Ok::<_, Failure>(Polytope::from_mesh(&mesh, &mut Vec::new())?)
    });
    Ok([a?, b?])
}

pub(super) fn translations(places: &[Place]) -> Vec<Translation> {
    places.iter().map(|place| Translation::from_f64(*place).expect("the numbers are finite")).collect()
}

/// Measures at least `least` passes over all placements, and for about `budget` seconds.
pub(super) fn measured(
    sum: &RelativePlacement,
    query: Query,
    order: Order,
    places: &[Place],
    least: usize,
    budget: f64,
) -> Ours {
    let translations = translations(places);
    let mut times: Vec<f64> = Vec::new();
    while times.len() < least.max(1) || (times.iter().sum::<f64>() < budget && times.len() < 2_000) {
        let ((), seconds) = timed(|| pass(sum, query, order, &translations));
        times.push(seconds);
    }
    times.sort_by(f64::total_cmp);
    let median = f64::midpoint(times[(times.len() - 1) / 2], times[times.len() / 2]);
    let a_query = |seconds: f64| seconds * 1e9 / places.len() as f64;
    Ours {
        nanoseconds: a_query(median),
        fastest: a_query(times[0]),
        repetitions: times.len(),
        sum: translations.iter().map(|s| answer(sum, query, s)).sum(),
    }
}

/// Asks about all placements. Numbers are not made: nobody asks for them.
fn pass(sum: &RelativePlacement, query: Query, order: Order, translations: &[Translation]) {
    let mut last = None;
    for s in translations {
        let hint = if order == Order::Coherent { last } else { None };
        let witness = match query {
            Query::Distance => {
                let separation = black_box(sum.separation(black_box(s), hint));
                Some(separation.witness())
            }
            Query::Relation => Some(black_box(sum.relation(black_box(s), hint)).1),
            Query::Penetration => black_box(sum.minimum_penetration(black_box(s), hint))
                .map(|penetration| penetration.witness()),
        };
        last = witness.or(last);
    }
}

/// The answer as other programs give it, rounded.
fn answer(sum: &RelativePlacement, query: Query, s: &Translation) -> f64 {
    match query {
        Query::Distance => sum.separation(s, None).squared_distance().approx_f64().sqrt(),
        Query::Relation => match sum.relation(s, None).0 {
            proximity::Relation::Disjoint => 0.0,
            _ => 1.0,
        },
        Query::Penetration => {
            let penetration = sum.minimum_penetration(s, None);
            penetration.map_or(0.0, |penetration| penetration.squared_depth().approx_f64().sqrt())
        }
    }
}
