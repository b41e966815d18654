//! The arrangements that a file can say.

use arrangement::models::polycurve::PolycurveTraits;
use arrangement::models::{GeodesicTraits, LinearTraits, TorusSegmentTraits};
use arrangement::topology::{FlatTorus, Sphere, UnboundedPlane};
use arrangement::{Arrangement, Counts};
use dcel::{EdgeId, FaceId, VertexId};

/// An arrangement of segments, rays and lines in the plane.
pub type LinearArrangement = Arrangement<LinearTraits, UnboundedPlane>;
/// An arrangement of chains of segments, rays and lines in the plane, polylines among them.
pub type PolycurveArrangement = Arrangement<PolycurveTraits<LinearTraits>, UnboundedPlane>;
/// An arrangement of straight paths on a flat torus.
pub type TorusArrangement = Arrangement<TorusSegmentTraits, FlatTorus>;

/// An arrangement of chains of straight paths on a flat torus.
pub type TorusPolycurveArrangement = Arrangement<PolycurveTraits<TorusSegmentTraits>, FlatTorus>;

/// An arrangement of geodesic arcs on the sphere.
pub type SphereArrangement = Arrangement<GeodesicTraits, Sphere>;

/// An arrangement of chains of geodesic arcs on the sphere.
pub type SpherePolycurveArrangement = Arrangement<PolycurveTraits<GeodesicTraits>, Sphere>;

/// An arrangement of any family of curves that a star file can hold.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum StarArrangement {
    /// Segments, rays and lines in the plane.
    Linear(LinearArrangement),
    /// Chains of segments, rays and lines in the plane.
    Polycurves(PolycurveArrangement),
    /// Straight paths on a flat torus.
    Torus(TorusArrangement),
    /// Chains of straight paths on a flat torus.
    TorusPolycurves(TorusPolycurveArrangement),
    /// Geodesic arcs on the sphere.
    Sphere(SphereArrangement),
    /// Chains of geodesic arcs on the sphere.
    SpherePolycurves(SpherePolycurveArrangement),
}

/// The numbers that a file has for the cells of the arrangement that was read from it. They ascend with the ids, but for those of
/// vertices that stand for sides, and may leave some out.
#[derive(Clone, Debug)]
pub struct CellNumbers {
    /// Those of the vertices that stand for sides, which come first: none for infinity, nor for a pole at which nothing is.
    pub(super) special: Vec<Option<u32>>,
    /// Those of the other vertices.
    pub(super) vertices: Vec<u32>,
    pub(super) edges: Vec<u32>,
    pub(super) faces: Vec<u32>,
}

impl CellNumbers {
    /// The number of a vertex; `None` at infinity, and for a pole at which nothing is.
    ///
    /// # Panics
    /// If the arrangement, as it was read, has no such vertex.
    pub fn vertex(&self, v: VertexId) -> Option<u32> {
        match v.index().checked_sub(self.special.len()) {
            Some(index) => Some(self.vertices[index]),
            None => self.special[v.index()],
        }
    }

    /// The number of an edge.
    ///
    /// # Panics
    /// If the arrangement, as it was read, has no such edge.
    pub fn edge(&self, e: EdgeId) -> u32 {
        self.edges[e.index()]
    }

    /// The number of a face.
    ///
    /// # Panics
    /// If the arrangement, as it was read, has no such face.
    pub fn face(&self, f: FaceId) -> u32 {
        self.faces[f.index()]
    }
}

impl StarArrangement {
    /// The numbers of cells as a user sees them: see [`Arrangement::counts`].
    pub fn counts(&self) -> Counts {
        match self {
            Self::Linear(arrangement) => arrangement.counts(),
            Self::Polycurves(arrangement) => arrangement.counts(),
            Self::Torus(arrangement) => arrangement.counts(),
            Self::TorusPolycurves(arrangement) => arrangement.counts(),
            Self::Sphere(arrangement) => arrangement.counts(),
            Self::SpherePolycurves(arrangement) => arrangement.counts(),
        }
    }

    /// The numbers of cells as they are stored: see [`Arrangement::counts_with_splits`].
    pub fn counts_with_splits(&self) -> Counts {
        match self {
            Self::Linear(arrangement) => arrangement.counts_with_splits(),
            Self::Polycurves(arrangement) => arrangement.counts_with_splits(),
            Self::Torus(arrangement) => arrangement.counts_with_splits(),
            Self::TorusPolycurves(arrangement) => arrangement.counts_with_splits(),
            Self::Sphere(arrangement) => arrangement.counts_with_splits(),
            Self::SpherePolycurves(arrangement) => arrangement.counts_with_splits(),
        }
    }
}

impl From<LinearArrangement> for StarArrangement {
    fn from(arrangement: LinearArrangement) -> Self {
        Self::Linear(arrangement)
    }
}

impl From<PolycurveArrangement> for StarArrangement {
    fn from(arrangement: PolycurveArrangement) -> Self {
        Self::Polycurves(arrangement)
    }
}

impl From<TorusArrangement> for StarArrangement {
    fn from(arrangement: TorusArrangement) -> Self {
        Self::Torus(arrangement)
    }
}

impl From<TorusPolycurveArrangement> for StarArrangement {
    fn from(arrangement: TorusPolycurveArrangement) -> Self {
        Self::TorusPolycurves(arrangement)
    }
}

impl From<SphereArrangement> for StarArrangement {
    fn from(arrangement: SphereArrangement) -> Self {
        Self::Sphere(arrangement)
    }
}

impl From<SpherePolycurveArrangement> for StarArrangement {
    fn from(arrangement: SpherePolycurveArrangement) -> Self {
        Self::SpherePolycurves(arrangement)
    }
}
