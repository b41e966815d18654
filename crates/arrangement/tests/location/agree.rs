//! All strategies against the naive one.

use splitstar_arrangement::location::{
    LandmarkGenerator, Landmarks, Naive, PointLocation, TrapezoidalMap, VerticalRay, Walk,
};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{LandmarkTraits, UMonotoneTraits};
use splitstar_arrangement::{Arrangement, locate_all, locate_by_sweep};

/// The cell of a point, and what rays up and down from it meet.
pub(crate) type Answer = [Cell; 3];

fn answer<G: UMonotoneTraits, T: Topology<G>>(
    strategy: &dyn PointLocation<G, T>,
    arrangement: &Arrangement<G, T>,
    point: &G::Point,
) -> Answer {
    let [up, down] = VerticalRay::BOTH.map(|ray| strategy.shoot(arrangement, point, ray));
    [strategy.locate(arrangement, point), up, down].map(|cell| cell.expect("it is for this arrangement"))
}

/// Checks that all strategies answer alike, and gives their answers.
pub(crate) fn assert_agree<G: UMonotoneTraits + LandmarkTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    points: &[G::Point],
    context: &str,
) -> Vec<Answer> {
    let map = TrapezoidalMap::new(arrangement);
    let landmarks = Landmarks::new(arrangement);
    let few = Landmarks::with_generator(arrangement, LandmarkGenerator::Halton { count: Some(3) });
    let strategies: [(&str, &dyn PointLocation<G, T>); 4] =
        [("walk", &Walk), ("landmarks", &landmarks), ("few landmarks", &few), ("trapezoids", &map)];
    let expected: Vec<Answer> = points.iter().map(|point| answer(&Naive, arrangement, point)).collect();
    for (name, strategy) in strategies {
        for (point, expected) in points.iter().zip(&expected) {
            let found = answer(strategy, arrangement, point);
            assert_eq!(found, *expected, "{name} at {point:?}, {context}");
        }
    }
    let cells: Vec<Cell> = expected.iter().map(|answer| answer[0]).collect();
    for (name, strategy) in strategies {
        assert_eq!(
            strategy.locate_all(arrangement, points).as_ref(),
            Ok(&cells),
            "{name} together, {context}"
        );
    }
    assert_eq!(locate_all(arrangement, points), cells, "as their numbers say, {context}");
    for ((point, [expected, ..]), found) in
        points.iter().zip(&expected).zip(locate_by_sweep(arrangement, points))
    {
        assert_eq!(found, *expected, "one sweep at {point:?}, {context}");
    }
    expected
}
