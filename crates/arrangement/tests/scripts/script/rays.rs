//! Strategies of point location that need no preparation, and those that follow edits.

use super::family::Family;
use super::steps::World;
use exact::planar::Point2;
use splitstar_arrangement::location::{Naive, PointLocation, VerticalRay, Walk};

impl<F: Family> World<F> {
    /// Checks that all strategies find the same, and that rays do.
    pub(super) fn check_rays(&self, points: &[Point2]) {
        let arrangement = self.editor.arrangement();
        let map = &self.editor.observers().2;
        let strategies: [(&str, &dyn PointLocation<F::Traits, F::Surface>); 2] =
            [("walk", &Walk), ("trapezoids", map)];
        for point in points {
            let cell = Naive.locate(arrangement, point);
            let hits = VerticalRay::BOTH.map(|ray| Naive.shoot(arrangement, point, ray));
            for (name, strategy) in strategies {
                assert_eq!(strategy.locate(arrangement, point), cell, "{name} at {point}");
                if name == "trapezoids" {
                    continue;
                }
                let found = VerticalRay::BOTH.map(|ray| strategy.shoot(arrangement, point, ray));
                assert_eq!(found, hits, "{name}, rays from {point}");
            }
        }
    }
}
