//! All strategies of point location: the map follows the edits, landmarks are set anew.

use super::drawn::{Drawn, PointOf};
use super::steps::World;
use splitstar_arrangement::location::{Landmarks, Naive, PointLocation, VerticalRay, Walk};
use splitstar_arrangement::overlay::Cell;

/// A strategy, with its name.
type Named<'a, F> = (&'a str, &'a dyn PointLocation<<F as Drawn>::Traits, <F as Drawn>::Surface>);

impl<F: Drawn> World<F> {
    /// Checks that all strategies find the cells that a sweep found, one by one and together, and that rays find the same.
    pub(super) fn check_rays(&self, points: &[PointOf<F>], cells: &[Cell]) {
        let arrangement = self.editor.arrangement();
        let map = &self.editor.observers().2;
        let landmarks = Landmarks::new(arrangement);
        let strategies: [Named<'_, F>; 4] =
            [("naive", &Naive), ("walk", &Walk), ("landmarks", &landmarks), ("trapezoids", map)];
        for (name, strategy) in strategies {
            assert_eq!(
                strategy.locate_all(arrangement, points).as_deref(),
                Ok(cells),
                "{name} at {points:?}"
            );
        }
        for (point, cell) in points.iter().zip(cells) {
            let hits = VerticalRay::BOTH.map(|ray| Naive.shoot(arrangement, point, ray));
            for (name, strategy) in strategies {
                assert_eq!(strategy.locate(arrangement, point), Ok(*cell), "{name} at {point}");
                let found = VerticalRay::BOTH.map(|ray| strategy.shoot(arrangement, point, ray));
                assert_eq!(found, hits, "{name}, rays from {point}");
            }
        }
    }
}
