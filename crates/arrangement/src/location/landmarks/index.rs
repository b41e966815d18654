//! The landmark nearest to a point, by floats.

use crate::decomposition::{SiteId, TrapezoidId};
use sif_kdtree::{KdTree, Object};

/// Where a walk begins.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Start {
    /// At a site, in one of the trapezoids at its walls.
    Site(SiteId),
    /// In a trapezoid.
    Trapezoid(TrapezoidId),
}

#[derive(Clone, Copy, Debug)]
struct Landmark {
    at: [f64; 2],
    start: Start,
}

impl Object for Landmark {
    type Point = [f64; 2];

    fn position(&self) -> &[f64; 2] {
        &self.at
    }
}

/// Landmarks in a k-d tree.
///
/// Coordinates are scaled, the same along both axes, so that the greatest is about 1: squares of distances do not overflow, nor vanish.
/// Those that are not finite are left out. Of several landmarks at one place one is enough, and no search goes through heaps of
/// them.
#[derive(Clone, Debug)]
pub(super) struct Index {
    tree: KdTree<Landmark>,
    scale: f64,
}

impl Index {
    /// Landmarks at places, of which the first of each counts.
    pub(super) fn new(places: impl Iterator<Item = ([f64; 2], Start)>) -> Self {
        let is_finite = |at: &[f64; 2]| at.iter().all(|value| value.is_finite());
        let mut landmarks: Vec<Landmark> =
            places.filter(|(at, _)| is_finite(at)).map(|(at, start)| Landmark { at, start }).collect();
        let greatest = landmarks
            .iter()
            .flat_map(|landmark| landmark.at)
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let scale = if greatest > 0.0 { greatest.recip().clamp(f64::MIN_POSITIVE, f64::MAX) } else { 1.0 };
        for landmark in &mut landmarks {
            // Adding zero makes the negative zero positive.
            landmark.at = landmark.at.map(|value| value * scale + 0.0);
        }
        landmarks.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
        landmarks.dedup_by(|a, b| a.at.map(f64::to_bits) == b.at.map(f64::to_bits));
        Self { tree: KdTree::new(landmarks.into_boxed_slice()), scale }
    }

    /// The landmark nearest to a place: any, if the place is not finite; `None` if there is no landmark.
    pub(super) fn nearest(&self, place: [f64; 2]) -> Option<Start> {
        // What is so far away has all landmarks in about the same distance.
        const FAR: f64 = (1_u32 << 20) as f64;
        let place = place.map(|value| (value * self.scale).clamp(-FAR, FAR));
        self.tree.nearest(&place).or(self.tree.first()).map(|landmark| landmark.start)
    }

    /// The number of places.
    pub(super) fn len(&self) -> usize {
        self.tree.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn index_of(places: &[[f64; 2]]) -> Index {
        Index::new(places.iter().enumerate().map(|(i, &at)| (at, Start::Site(SiteId(i as u32)))))
    }

    #[track_caller]
    fn assert_nearest(index: &Index, place: [f64; 2], expected: u32) {
        assert_eq!(index.nearest(place), Some(Start::Site(SiteId(expected))), "{place:?}");
    }

    #[test]
    fn the_nearest_is_found() {
        let index = index_of(&[[0.0, 0.0], [10.0, 0.0], [0.0, 10.0], [10.0, 11.0]]);
        assert_nearest(&index, [1.0, 2.0], 0);
        assert_nearest(&index, [9.0, 2.0], 1);
        assert_nearest(&index, [-500.0, 9.0], 2);
        assert_nearest(&index, [1e300, 1e300], 3);
    }

    #[test]
    fn a_hundred_thousand_landmarks_at_one_place_are_one() {
        let mut places = vec![[3.0, 4.0]; 100_000];
        places.push([5.0, 4.0]);
        let index = index_of(&places);
        assert_eq!(index.len(), 2);
        assert_nearest(&index, [-1.0, 9.0], 0);
        assert_nearest(&index, [4.5, 4.0], 100_000);
    }

    #[test]
    fn a_hundred_thousand_landmarks_in_a_column_are_searched() {
        let places: Vec<[f64; 2]> = (0..100_000).map(|i| [7.0, f64::from(i)]).collect();
        let index = index_of(&places);
        for i in (0..100_000).step_by(100) {
            assert_nearest(&index, [f64::from(i) - 50_000.0, f64::from(i) + 0.25], i);
        }
    }

    #[test]
    fn huge_tiny_and_no_coordinates_are_harmless() {
        let infinities = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        let mut places: Vec<[f64; 2]> = infinities.iter().flat_map(|&x| [[x, 0.0], [1.0, x]]).collect();
        assert_eq!(index_of(&places).nearest([0.0, 0.0]), None);
        places.extend([[f64::MAX, -f64::MAX], [-f64::MAX, 0.0], [0.0, -0.0], [-0.0, 0.0]]);
        let index = index_of(&places);
        assert_nearest(&index, [1e308, -1e308], 6);
        assert_nearest(&index, [-1e308, 1e307], 7);
        for &x in &infinities {
            assert!(index.nearest([x, x]).is_some() && index.nearest([x, 1.0]).is_some());
        }
        let index = index_of(&[[1e-310, 0.0], [0.0, 1e-320], [-1e-310, 0.0]]);
        assert_nearest(&index, [-2e-310, 0.0], 2);
        assert_nearest(&index, [1.0, -1.0], 0);
        assert_eq!(index_of(&[]).nearest([0.0, 0.0]), None);
        assert_nearest(&index_of(&[[0.0, 0.0]]), [f64::NAN, 3.0], 0);
    }
}
