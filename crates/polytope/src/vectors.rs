//! The edge vectors and the facet normals of a polytope.
//!
//! Those of a sum are those of its summands, or cross products of them where two edges make a facet:
//! as wide as in the summands, however wide the coordinates of the sum are. The sum keeps where they
//! come from, and makes them when somebody asks.

use dcel::HalfedgeId;
use exact::Vector3;
use std::sync::{Arc, OnceLock};

/// Vectors in a list: three machine integers each as long as all are narrow.
///
/// Edges nearly always are, and a list of them is then a third as large.
#[derive(Debug)]
pub(crate) enum VectorList {
    Narrow(Vec<[i64; 3]>),
    Any(Vec<Vector3>),
}

impl VectorList {
    pub(crate) fn get(&self, index: usize) -> Vector3 {
        match self {
            Self::Narrow(list) => Vector3::from_i64(list[index]),
            Self::Any(list) => list[index].clone(),
        }
    }

    /// The cross product of two of the vectors.
    #[inline]
    pub(crate) fn cross(&self, first: usize, second: usize) -> Vector3 {
        match self {
            Self::Narrow(list) => Vector3::cross_of_i64(&list[first], &list[second]),
            Self::Any(list) => list[first].cross(&list[second]),
        }
    }

    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Narrow(list) => list.len(),
            Self::Any(list) => list.len(),
        }
    }

    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = Vector3> + '_ {
        (0..self.len()).map(|i| self.get(i))
    }
}

impl FromIterator<Vector3> for VectorList {
    fn from_iter<T: IntoIterator<Item = Vector3>>(vectors: T) -> Self {
        let mut vectors = vectors.into_iter();
        let mut narrow = Vec::with_capacity(vectors.size_hint().0);
        let wider = vectors.by_ref().find(|vector| match vector.as_narrow() {
            Some(coordinates) => {
                narrow.push(*coordinates);
                false
            }
            None => true,
        });
        match wider {
            None => Self::Narrow(narrow),
            Some(_) => {
                let before = narrow.into_iter().map(Vector3::from_i64);
                Self::Any(before.chain(wider).chain(vectors).collect())
            }
        }
    }
}

/// The vectors of a polytope.
#[derive(Debug)]
pub(crate) struct Vectors {
    /// A positive multiple of target minus source, for the even halfedge of each edge.
    pub(crate) edges: VectorList,
    /// An outer normal of each facet (none in dimension 1).
    pub(crate) normals: Vec<Vector3>,
}

impl Vectors {
    /// The vector of a halfedge of either parity.
    pub(crate) fn of_halfedge(&self, h: HalfedgeId) -> Vector3 {
        let vector = self.edges.get(h.edge());
        if h.0 & 1 == 0 { vector } else { -vector }
    }
}

/// Where an edge of a sum comes from: the summand and a halfedge of it, with the direction of the even
/// halfedge of the edge. In four bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EdgeOrigin(u32);

impl EdgeOrigin {
    const SECOND: u32 = 1 << 31;

    /// `summand` is 0 or 1.
    #[inline]
    pub(crate) fn new(summand: u32, halfedge: HalfedgeId) -> Self {
        assert!(halfedge.0 < Self::SECOND, "a summand has fewer than 2^31 halfedges");
        Self(halfedge.0 | summand << 31)
    }

    /// The same edge in the other direction.
    pub(crate) fn reversed(self) -> Self {
        Self(self.0 ^ 1)
    }

    fn vector(self, summands: &[Arc<Vectors>; 2]) -> Vector3 {
        summands[(self.0 >> 31) as usize].of_halfedge(HalfedgeId(self.0 & !Self::SECOND))
    }
}

/// Where a facet of a sum comes from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum FacetOrigin {
    /// A facet of the first summand (of the second too, perhaps).
    First(u32),
    /// A facet of the second summand.
    Second(u32),
    /// An edge of each: the outer normal is the cross product of these halfedges.
    Edges([HalfedgeId; 2]),
}

/// Where the vectors of a sum come from.
#[derive(Debug)]
pub(crate) struct Origins {
    pub(crate) summands: [Arc<Vectors>; 2],
    pub(crate) edges: Vec<EdgeOrigin>,
    pub(crate) facets: Vec<FacetOrigin>,
}

impl Origins {
    fn make(&self) -> Vectors {
        let [first, second] = &self.summands;
        let normal = |o: &FacetOrigin| match *o {
            FacetOrigin::First(f) => first.normals[f as usize].clone(),
            FacetOrigin::Second(f) => second.normals[f as usize].clone(),
            FacetOrigin::Edges([r, b]) => {
                let same = (r.0 ^ b.0) & 1 == 0;
                let (r, b) = (first.edges.get(r.edge()), second.edges.get(b.edge()));
                if same { r.cross(&b) } else { b.cross(&r) }
            }
        };
        Vectors {
            edges: self.edges.iter().map(|origin| origin.vector(&self.summands)).collect(),
            normals: self.facets.iter().map(normal).collect(),
        }
    }
}

/// Vectors that are there, or where they come from.
#[derive(Clone, Debug)]
pub(crate) struct LazyVectors {
    made: OnceLock<Arc<Vectors>>,
    origins: Option<Arc<Origins>>,
}

impl LazyVectors {
    pub(crate) fn given(edges: VectorList, normals: Vec<Vector3>) -> Self {
        Self { made: OnceLock::from(Arc::new(Vectors { edges, normals })), origins: None }
    }

    pub(crate) fn inherited(origins: Origins) -> Self {
        Self { made: OnceLock::new(), origins: Some(Arc::new(origins)) }
    }

    pub(crate) fn get(&self) -> &Arc<Vectors> {
        self.made.get_or_init(|| {
            let origins = self.origins.as_ref().expect("vectors that were not given are inherited");
            Arc::new(origins.make())
        })
    }
}
