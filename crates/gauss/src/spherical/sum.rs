//! Minkowski sums and reflections.

use super::SphericalGaussianMap;
use arrangement::overlay::overlay_all;
use exact::{Adder, Point3};
use polytope::Polytope;
use std::borrow::Cow;

impl SphericalGaussianMap {
    /// Gives the Gaussian map of the Minkowski sum of two polytopes: the overlay of their maps. The vertex of a face is the sum of those of the
    /// two faces in which it lies.
    ///
    /// Degenerate: common normals, normals on arcs, arcs that overlap, summands of any dimension, and the same map twice are ordinary cases.
    ///
    /// The sum has the identification of the summand with more edges, of the first one if they have as many. The other one is
    /// [re-identified](Self::reidentified) before, if its identification is another one.
    ///
    /// # Complexity
    /// O((n + k) log n) for n edges of the summands and k vertices of the overlay.
    ///
    /// # References
    /// Thesis, section 3.2.
    pub fn minkowski_sum(&self, other: &Self) -> Self {
        Self::minkowski_sum_all(&[self, other])
    }

    /// Gives the Gaussian map of the Minkowski sum of any number of polytopes, by one overlay of all: see [`Self::minkowski_sum`]. The sum of none is
    /// the origin.
    ///
    /// # Complexity
    /// O((n + k) log n) for n edges of the summands and k vertices of the overlay, and O(m) sums of points for m vertices of the sum and each summand.
    ///
    /// ```
    /// use exact::{Adder, Point3};
    /// use polytope::Polytope;
    /// use splitstar_gauss::SphericalGaussianMap;
    /// let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| Polytope::segment(Point3::ORIGIN, Point3::from_i64(p)));
    /// let maps = axes.each_ref().map(SphericalGaussianMap::of_polytope);
    /// let cube = SphericalGaussianMap::minkowski_sum_all(&maps.each_ref());
    /// assert_eq!(cube.counts().to_array(), [8, 12, 6]);
    /// ```
    pub fn minkowski_sum_all(summands: &[&Self]) -> Self {
        // The first one of those with most edges.
        let edges = |map: &Self| map.arrangement.dcel().edge_count();
        let Some(largest) = summands.iter().rev().max_by_key(|map| edges(map)) else {
            return Self::of_polytope(&Polytope::point(Point3::ORIGIN));
        };
        let traits = largest.arrangement.traits();
        let aligned: Vec<Cow<'_, Self>> = summands
            .iter()
            .map(|map| match map.arrangement.traits() == traits {
                true => Cow::Borrowed(*map),
                false => Cow::Owned(map.reidentified(traits.clone())),
            })
            .collect();
        let operands: Vec<_> = aligned.iter().map(|map| &map.arrangement).collect();
        let (arrangement, provenance) = overlay_all(&operands);
        let mut adder = Adder::default();
        let sum_of = |f| {
            let faces = provenance.of_face(f).iter().zip(&aligned);
            let points = faces.map(|(&face, map)| Cow::Borrowed(map.point(face)));
            let sum = points.reduce(|a, b| Cow::Owned(adder.sum(&a, &b)));
            sum.expect("there are summands").into_owned()
        };
        let points = arrangement.dcel().faces().map(sum_of).collect();
        Self { arrangement, points }
    }

    /// Gives the Gaussian map of the polytope reflected through the origin, without a sweep. The identification becomes the opposite one.
    ///
    /// Ids of faces and edges stay as they are; those of the vertices, too, but for the poles, which are exchanged.
    ///
    /// # Complexity
    /// Linear.
    pub fn reflected(&self) -> Self {
        let points = self.points.iter().map(opposite).collect();
        Self { arrangement: self.arrangement.reflected(), points }
    }
}

fn opposite(p: &Point3) -> Point3 {
    let [x, y, z, weight] = p.homogeneous();
    Point3::new([-x, -y, -z], weight).expect("a weight is positive")
}
