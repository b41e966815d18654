//! Volume, centroid, bounds.

use crate::{Facets, Polytope};
use exact::{Integer, Point3, Rational};

impl Polytope {
    /// The volume: zero in dimensions 0 to 2.
    ///
    /// # Complexity
    /// Linear.
    pub fn volume(&self) -> Rational {
        match self.dimension {
            3 => signed_volume(&self.points, &self.to_mesh().facets),
            _ => Rational::from(0),
        }
    }

    /// The centroid of the set, in its own dimension: of the solid, the polygon, the segment or the
    /// point.
    ///
    /// ```
    /// use exact::Point3;
    /// let segment = splitstar_polytope::Polytope::segment(Point3::ORIGIN, Point3::from_i64([1, 2, 4]));
    /// assert_eq!(segment.centroid().to_string(), "(1/2, 1, 2)");
    /// ```
    ///
    /// # Complexity
    /// Linear.
    pub fn centroid(&self) -> Point3 {
        match self.dimension {
            3 => {
                let apex = self.points[0].coordinates();
                weighted_mean(self.triangles().into_iter().map(|triangle| {
                    // Six times the volume of the tetrahedron from the first vertex.
                    let weight = determinant(&triangle.clone().map(|p| difference(&p, &apex)));
                    (weight, [&triangle[..], std::slice::from_ref(&apex)].concat())
                }))
            }
            2 => {
                // Areas are compared in a projection along an axis that the plane is not parallel to.
                let axis = crate::polytope::nonzero_axis(&self.vectors().normals[0]);
                weighted_mean(self.triangles().into_iter().map(|[a, b, c]| {
                    let (p, q) = (difference(&b, &a), difference(&c, &a));
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    (&p[i] * &q[j] - &p[j] * &q[i], vec![a, b, c])
                }))
            }
            _ => {
                let points = self.points.iter().map(Point3::coordinates).collect();
                weighted_mean([(Rational::from(1), points)])
            }
        }
    }

    /// The lowest and the highest coordinate along each axis.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(&self.points).expect("a polytope has a vertex")
    }

    /// The triangles of a fan of each facet (of the front, for a polygon).
    fn triangles(&self) -> Vec<[[Rational; 3]; 3]> {
        let mesh = self.to_mesh();
        let mut triangles = Vec::new();
        for cycle in mesh.facets.iter() {
            let corner = |i: usize| mesh.points[cycle[i] as usize].coordinates();
            triangles.extend((2..cycle.len()).map(|i| [corner(0), corner(i - 1), corner(i)]));
        }
        triangles
    }
}

/// An axis-parallel box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// The lowest coordinates.
    pub min: [Rational; 3],
    /// The highest coordinates.
    pub max: [Rational; 3],
}

impl Bounds {
    /// The smallest box around points; `None` around none.
    pub fn of(points: &[Point3]) -> Option<Self> {
        let first = points.first()?.coordinates();
        let mut bounds = Self { min: first.clone(), max: first };
        for point in &points[1..] {
            for (axis, c) in point.coordinates().into_iter().enumerate() {
                if c < bounds.min[axis] {
                    bounds.min[axis] = c;
                } else if c > bounds.max[axis] {
                    bounds.max[axis] = c;
                }
            }
        }
        Some(bounds)
    }
}

/// The signed volume enclosed by a closed surface of planar facets: positive if they are
/// counterclockwise seen from outside.
///
/// Points over one weight are added up as integers; other ones get the least common weight first, in
/// groups, so that a sum of many different denominators stays a balanced tree.
pub(crate) fn signed_volume(points: &[Point3], facets: &Facets) -> Rational {
    let Some(origin) = points.first() else { return Rational::from(0) };
    let mut terms: Vec<Rational> = Vec::new();
    let mut run: Option<(Integer, Integer)> = None; // sum of determinants over the same weights
    for cycle in facets.iter() {
        for i in 2..cycle.len() {
            let corners = [cycle[0], cycle[i - 1], cycle[i]].map(|p| &points[p as usize]);
            let (det, weight) = tetrahedron(origin, corners);
            run = match run {
                Some((sum, w)) if w == weight => Some((sum + det, w)),
                other => {
                    terms.extend(other.and_then(|(sum, w)| Rational::new(sum, w)));
                    Some((det, weight))
                }
            };
        }
    }
    terms.extend(run.and_then(|(sum, w)| Rational::new(sum, w)));
    balanced_sum(terms) * Rational::new(Integer::from(1), Integer::from(6)).expect("six is not zero")
}

/// Twice the signed area of a polygon seen along an axis.
pub(crate) fn twice_area(corners: &[&Point3], axis: usize) -> Rational {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let next = corners.iter().cycle().skip(1);
    let terms = corners
        .iter()
        .zip(next)
        .map(|(p, q)| p.coordinate(i) * q.coordinate(j) - p.coordinate(j) * q.coordinate(i));
    balanced_sum(terms.collect())
}

/// Six times the signed volume of a tetrahedron as a fraction that is not reduced.
fn tetrahedron(apex: &Point3, corners: [&Point3; 3]) -> (Integer, Integer) {
    let w = apex.weight();
    let common = corners.iter().all(|p| p.weight() == w);
    let [a, b, c] = corners.map(|p| {
        std::array::from_fn::<_, 3, _>(|i| {
            if common {
                p.numerator(i) - apex.numerator(i)
            } else {
                p.numerator(i) * &w - apex.numerator(i) * &p.weight()
            }
        })
    });
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    let det = &a[0] * &minor(1, 2) + &a[1] * &minor(2, 0) + &a[2] * &minor(0, 1);
    let cube = w.pow(3);
    let weight = if common { cube } else { corners.iter().fold(cube, |product, p| product * &p.weight()) };
    (det, weight)
}

/// Adds neighbours first: denominators stay small as long as they can.
fn balanced_sum(mut terms: Vec<Rational>) -> Rational {
    while terms.len() > 1 {
        terms = terms
            .chunks(2)
            .map(|pair| pair.iter().cloned().reduce(|a, b| a + b).unwrap_or_default())
            .collect();
    }
    terms.pop().unwrap_or_default()
}

fn difference(a: &[Rational; 3], b: &[Rational; 3]) -> [Rational; 3] {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn determinant([a, b, c]: &[[Rational; 3]; 3]) -> Rational {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * &minor(1, 2) + &a[1] * &minor(2, 0) + &a[2] * &minor(0, 1)
}

/// The mean of the means of groups of points, weighted.
fn weighted_mean(groups: impl IntoIterator<Item = (Rational, Vec<[Rational; 3]>)>) -> Point3 {
    let mut total = Vec::new();
    let mut sums: [Vec<Rational>; 3] = Default::default();
    for (weight, points) in groups {
        let share = weight.checked_div(&Rational::from(points.len() as i64)).expect("a group has points");
        for (axis, sum) in sums.iter_mut().enumerate() {
            sum.push(balanced_sum(points.iter().map(|p| p[axis].clone()).collect()) * share.clone());
        }
        total.push(weight);
    }
    let total = balanced_sum(total);
    let mean = sums.map(|sum| balanced_sum(sum).checked_div(&total).expect("the total weight is positive"));
    Point3::from_rationals(&mean)
}
