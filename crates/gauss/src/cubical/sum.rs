//! Minkowski sums by overlay, and reflections.

use super::CubicalGaussianMap;
use cubical::{CubicalArrangement, overlay_all};
use exact::{Adder, Point3};
use polytope::Polytope;

impl CubicalGaussianMap {
    /// Makes the Gaussian map of the Minkowski sum of two polytopes, by six overlays of their maps. The vertex of a face is the sum of those of the
    /// two faces in which it lies.
    ///
    /// Degenerate: common normals, normals on arcs and on edges of the cube, arcs that overlap, summands of any dimension, and the same map twice are ordinary
    /// cases.
    ///
    /// # Complexity
    /// O((n + k) log n) for n edges of the summands and k vertices of the overlay.
    ///
    /// # References
    /// Thesis, section 3.3.2.
    pub fn minkowski_sum(&self, other: &Self) -> Self {
        Self::minkowski_sum_all(&[self, other])
    }

    /// Makes the Gaussian map of the Minkowski sum of any number of polytopes, by one overlay a side: see [`Self::minkowski_sum`]. The sum of none is
    /// the origin.
    ///
    /// # Complexity
    /// O((n + k) log n) for n edges of the summands and k vertices of the overlay, and O(m) sums of points for m vertices of the sum and each summand.
    ///
    /// ```
    /// use exact::Point3;
    /// use polytope::Polytope;
    /// use splitstar_gauss::CubicalGaussianMap;
    /// let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| Polytope::segment(Point3::ORIGIN, Point3::from_i64(p)));
    /// let maps = axes.each_ref().map(CubicalGaussianMap::of_polytope);
    /// let cube = CubicalGaussianMap::minkowski_sum_all(&maps.each_ref());
    /// assert_eq!(cube.counts().to_array(), [8, 12, 6]);
    /// ```
    pub fn minkowski_sum_all(summands: &[&Self]) -> Self {
        match summands {
            [] => return Self::of_polytope(&Polytope::point(Point3::ORIGIN)),
            [only] => return (*only).clone(),
            _ => {}
        }
        let operands: Vec<&CubicalArrangement> = summands.iter().map(|map| &map.arrangement).collect();
        let (arrangement, provenance) = overlay_all(&operands);
        let mut adder = Adder::default();
        let sum_of_face = |face| {
            let of_operands = provenance.of_face(&arrangement, &operands, face);
            sum_of(summands.iter().zip(of_operands).map(|(map, face)| map.point(face)), &mut adder)
        };
        let points = arrangement.faces().map(sum_of_face).collect();
        Self { arrangement, points }
    }

    /// Makes the Gaussian map of the polytope reflected through the origin, from the map itself.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// ```
    /// use exact::Point3;
    /// use polytope::convex_hull;
    /// use splitstar_gauss::CubicalGaussianMap;
    /// let corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]].map(Point3::from_i64);
    /// let tetrahedron = convex_hull(&corners).expect("there are points");
    /// let reflected = CubicalGaussianMap::of_polytope(&tetrahedron).reflected();
    /// assert!(reflected.make_polytope().same_set(&tetrahedron.reflected()));
    /// ```
    pub fn reflected(&self) -> Self {
        let points = self.points.iter().map(opposite).collect();
        Self { arrangement: self.arrangement.reflected(), points }
    }
}

fn sum_of<'a>(mut points: impl Iterator<Item = &'a Point3>, adder: &mut Adder) -> Point3 {
    let first = points.next().expect("there are summands").clone();
    points.fold(first, |sum, point| adder.sum(&sum, point))
}

fn opposite(p: &Point3) -> Point3 {
    let [x, y, z, weight] = p.homogeneous();
    Point3::new([-x, -y, -z], weight).expect("a weight is positive")
}
