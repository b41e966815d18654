//! The ways to a Minkowski sum.

use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::{Polytope, minkowski_sum, minkowski_sum_by_hull, minkowski_sum_by_lp};

use super::{Counts, counts_of};

/// How polytopes are added.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Method {
    /// A walk over both Gaussian maps.
    Walk,
    /// Gaussian maps as arrangements on the sphere.
    Sgm,
    /// The same on the sides of a cube.
    Cgm,
    /// Linear programs.
    Lp,
    /// The hull of all sums of vertices.
    Hull,
}

/// What a method adds.
pub(super) enum Operands<'a> {
    Polytopes(Vec<&'a Polytope>, fn(&[&Polytope]) -> Polytope),
    Spherical(Vec<SphericalGaussianMap>),
    Cubical(Vec<CubicalGaussianMap>),
}

/// What it gives.
pub(super) enum Sum {
    Polytope(Polytope),
    Spherical(Box<SphericalGaussianMap>),
    Cubical(Box<CubicalGaussianMap>),
}

impl Method {
    /// All, the fastest first.
    pub(crate) const ALL: [Self; 5] = [Self::Walk, Self::Sgm, Self::Cgm, Self::Lp, Self::Hull];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Walk => "walk",
            Self::Sgm => "SGM",
            Self::Cgm => "CGM",
            Self::Lp => "LP",
            Self::Hull => "hull",
        }
    }

    /// Makes the operands ready: Gaussian maps of them, where the method adds these.
    pub(super) fn operands(self, polytopes: &[Polytope]) -> Operands<'_> {
        let by = |sum| Operands::Polytopes(polytopes.iter().collect(), sum);
        match self {
            Self::Walk => by(minkowski_sum),
            Self::Sgm => {
                Operands::Spherical(polytopes.iter().map(SphericalGaussianMap::of_polytope).collect())
            }
            Self::Cgm => Operands::Cubical(polytopes.iter().map(CubicalGaussianMap::of_polytope).collect()),
            Self::Lp => by(minkowski_sum_by_lp),
            Self::Hull => by(minkowski_sum_by_hull),
        }
    }
}

impl Operands<'_> {
    pub(super) fn sum(&self) -> Sum {
        match self {
            Self::Polytopes(polytopes, sum) => Sum::Polytope(sum(polytopes)),
            Self::Spherical(maps) => {
                let sum = SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
                Sum::Spherical(Box::new(sum))
            }
            Self::Cubical(maps) => {
                let sum = CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
                Sum::Cubical(Box::new(sum))
            }
        }
    }
}

impl Sum {
    pub(super) fn counts(&self) -> Counts {
        counts_of(match self {
            Self::Polytope(polytope) => polytope.counts(),
            Self::Spherical(map) => map.counts(),
            Self::Cubical(map) => map.counts(),
        })
    }
}
