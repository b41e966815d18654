//! All strategies of point location: the map follows the edits, landmarks are set anew.

use super::drawn::Drawn;
use super::steps::World;
use crate::family::Family;
use exact::planar::Point2;
use splitstar_arrangement::location::{Landmarks, Naive, PointLocation, VerticalRay, Walk};

/// A strategy, with its name.
type Named<'a, F> = (&'a str, &'a dyn PointLocation<<F as Family>::Traits, <F as Family>::Surface>);

impl<F: Drawn> World<F> {
    /// Checks that all strategies find the same, and that rays do.
    pub(super) fn check_rays(&self, points: &[Point2]) {
        let arrangement = self.editor.arrangement();
        let map = &self.editor.observers().2;
        let landmarks = Landmarks::new(arrangement);
        let strategies: [Named<'_, F>; 3] = [("walk", &Walk), ("landmarks", &landmarks), ("trapezoids", map)];
        for point in points {
            let cell = Naive.locate(arrangement, point);
            let hits = VerticalRay::BOTH.map(|ray| Naive.shoot(arrangement, point, ray));
            for (name, strategy) in strategies {
                assert_eq!(strategy.locate(arrangement, point), cell, "{name} at {point}");
                let found = VerticalRay::BOTH.map(|ray| strategy.shoot(arrangement, point, ray));
                assert_eq!(found, hits, "{name}, rays from {point}");
            }
        }
    }
}
