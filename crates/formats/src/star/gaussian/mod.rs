//! Gaussian maps as text: the kind `gaussian` of the native format.
//!
//! | file | role |
//! |---|---|
//! | this one | the maps that a file can say |
//! | `write` | the one text of a map |
//! | `cube` | the sides of a cube |
//! | `read` | the door: the points of the faces, the map of their hull, and whether its text is that of the file |

mod cube;
mod read;
mod write;

pub use read::read_gaussian_map;
pub(super) use read::read_polytope;
pub use write::write_gaussian_map;

use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::Polytope;

/// A Gaussian map of any kind that a star file can hold.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum StarGaussianMap {
    /// On the sphere.
    Spherical(Box<SphericalGaussianMap>),
    /// On the sides of a cube.
    Cubical(Box<CubicalGaussianMap>),
}

impl StarGaussianMap {
    /// Makes the polytope.
    pub fn make_polytope(&self) -> Polytope {
        match self {
            Self::Spherical(map) => map.make_polytope(),
            Self::Cubical(map) => map.make_polytope(),
        }
    }
}

impl From<SphericalGaussianMap> for StarGaussianMap {
    fn from(map: SphericalGaussianMap) -> Self {
        Self::Spherical(Box::new(map))
    }
}

impl From<CubicalGaussianMap> for StarGaussianMap {
    fn from(map: CubicalGaussianMap) -> Self {
        Self::Cubical(Box::new(map))
    }
}
