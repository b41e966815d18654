//! Where landmarks are put.

/// Where landmarks are put. All but [`Vertices`](Self::Vertices) spread them over the least upright rectangle around the vertices.
///
/// A count that is not given is the number of vertices: then a walk is expected to be short wherever the landmarks are as dense as what is
/// to be passed. Vertices are so by themselves, so they are the choice for most arrangements. Spread landmarks take no notice of where
/// the cells are: they serve arrangements of which the greater part is a few vertices with very many edges, and comparisons.
///
/// # References
/// Haran and Halperin, An experimental study of point location in planar arrangements in CGAL, J. Exp. Algorithmics 13, 2008.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum LandmarkGenerator {
    /// At all vertices that are points.
    #[default]
    Vertices,
    /// In the middle of the cells of a grid with as many columns as rows.
    Grid {
        /// How many at most; the greatest square that is not greater is taken.
        count: Option<u32>,
    },
    /// At random, the same way for one seed.
    Random {
        /// How many.
        count: Option<u32>,
        /// Chooses the numbers.
        seed: u64,
    },
    /// On the Halton sequence of bases 2 and 3, which is evener than chance.
    Halton {
        /// How many.
        count: Option<u32>,
    },
}

impl LandmarkGenerator {
    /// Positions in the unit square, if an arrangement has so many vertices; none if the landmarks are the vertices.
    pub(super) fn positions(self, vertices: usize) -> Vec<[f64; 2]> {
        let or_vertices = |count: Option<u32>| count.unwrap_or(u32::try_from(vertices).unwrap_or(u32::MAX));
        match self {
            Self::Vertices => Vec::new(),
            Self::Grid { count } => {
                let side = or_vertices(count).isqrt();
                let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(side);
                (0..side).flat_map(|i| (0..side).map(move |j| [middle(i), middle(j)])).collect()
            }
            Self::Random { count, seed } => {
                let mut state = seed;
                (0..or_vertices(count)).map(|_| [(); 2].map(|()| random(&mut state))).collect()
            }
            Self::Halton { count } => (0..or_vertices(count))
                .map(|i| [2, 3].map(|base| radical_inverse(u64::from(i) + 1, base)))
                .collect(),
        }
    }
}

/// A number of at least 0 and below 1.
///
/// # References
/// Steele, Lea and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014 (SplitMix64).
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^= mixed >> 31;
    // 53 bits are exact.
    (mixed >> 11) as f64 / (1_u64 << 53) as f64
}

/// The number whose digits behind the point are those of `i`, the last one first.
fn radical_inverse(mut i: u64, base: u64) -> f64 {
    let (mut value, mut weight) = (0.0, 1.0);
    while i > 0 {
        weight /= base as f64;
        value += (i % base) as f64 * weight;
        i /= base;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_are_in_the_unit_square_and_as_many_as_asked() {
        for (generator, count) in [
            (LandmarkGenerator::Vertices, 0),
            (LandmarkGenerator::Grid { count: None }, 9),
            (LandmarkGenerator::Grid { count: Some(5) }, 4),
            (LandmarkGenerator::Grid { count: Some(0) }, 0),
            (LandmarkGenerator::Random { count: None, seed: 1 }, 10),
            (LandmarkGenerator::Random { count: Some(1000), seed: u64::MAX }, 1000),
            (LandmarkGenerator::Halton { count: None }, 10),
            (LandmarkGenerator::Halton { count: Some(1000) }, 1000),
        ] {
            let mut positions = generator.positions(10);
            assert_eq!(positions.len(), count, "{generator:?}");
            assert!(positions.iter().flatten().all(|value| (0.0..1.0).contains(value)), "{generator:?}");
            positions.sort_by(|p, q| p.partial_cmp(q).unwrap());
            positions.dedup();
            assert_eq!(positions.len(), count, "{generator:?}: all are different");
        }
    }

    #[test]
    fn the_halton_sequence_begins_as_it_does() {
        let text: Vec<String> = LandmarkGenerator::Halton { count: Some(4) }
            .positions(0)
            .iter()
            .map(|[x, y]| format!("{x:.3} {y:.3}"))
            .collect();
        assert_eq!(text, ["0.500 0.333", "0.250 0.667", "0.750 0.111", "0.125 0.444"]);
    }
}
