//! The cells of a solid M in flat arrays.

use crate::answer::Cell;
use crate::contact::Foot;
use dcel::{FacetId, HalfedgeId};
use exact::proximity::{PlaneFloats, QueryPoint, side_of_ray};
use exact::{Point3, Rational, Sign, Vector3, predicate};
use polytope::Polytope;

/// The facets of M and their halfedges, numbered by facets: those of one facet follow each other counterclockwise. A halfedge is
/// called by that number here, and a facet by its index.
///
/// For every facet and halfedge, planes as floats; the filter reads nothing else. The exact planes are made from M where that does
/// not suffice.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    /// A point in the interior of M.
    center: Point3,
    /// Where the halfedges of each facet start, and the number of all.
    starts: Vec<u32>,
    links: Vec<Link>,
    /// The planes of the facets, with normals outwards.
    facets: Vec<PlaneFloats>,
    /// For every halfedge the plane through it and the center; positive is the side of its facet.
    cones: Vec<PlaneFloats>,
    sides: Vec<Side>,
}

#[derive(Clone, Copy, Debug)]
struct Link {
    facet: u32,
    twin: u32,
    halfedge: HalfedgeId,
}

/// The planes through the source of a halfedge that bound Voronoi regions.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// Through the halfedge, perpendicular to its facet; the normal points out of the facet.
    out: PlaneFloats,
    /// Perpendicular to the halfedge; the normal points along it.
    along: PlaneFloats,
}

impl Cells {
    /// Those of a polytope of dimension 3.
    pub(crate) fn new(sum: &Polytope) -> Self {
        let mesh = sum.mesh();
        let mut starts = Vec::with_capacity(mesh.facet_count() + 1);
        let mut order = Vec::with_capacity(mesh.halfedge_count());
        let mut number = vec![0; mesh.halfedge_count()];
        for f in mesh.facets() {
            starts.push(order.len() as u32);
            for h in mesh.facet_cycle(f) {
                number[h.index()] = order.len() as u32;
                order.push(h);
            }
        }
        starts.push(order.len() as u32);
        let link =
            |&h: &HalfedgeId| Link { facet: mesh.facet(h).0, twin: number[h.twin().index()], halfedge: h };
        let source = |f: FacetId| &sum.points()[mesh.source(mesh.boundary(f)).index()];
        let mut cells = Self {
            center: Point3::ORIGIN,
            starts,
            links: order.iter().map(link).collect(),
            facets: mesh.facets().map(|f| PlaneFloats::new(sum.facet_normal(f), source(f))).collect(),
            cones: Vec::new(),
            sides: Vec::new(),
        };
        cells.center = cells.interior_point(sum);
        let numbers = 0..cells.links.len() as u32;
        let plane = |(normal, on): (Vector3, &Point3)| PlaneFloats::new(&normal, on);
        cells.cones = numbers.clone().map(|k| plane(cells.exact_cone(sum, k))).collect();
        cells.sides = numbers
            .map(|k| Side { out: plane(cells.exact_out(sum, k)), along: plane(cells.exact_along(sum, k)) })
            .collect();
        cells
    }

    /// A point in the interior, of few digits if there is one near the mean of the vertices.
    fn interior_point(&self, sum: &Polytope) -> Point3 {
        let (mut mean, mut greatest) = ([0.0; 3], 0.0_f64);
        for point in sum.points() {
            for (m, c) in mean.iter_mut().zip(point.approx_f64()) {
                *m += c / sum.points().len() as f64;
                greatest = greatest.max(c.abs());
            }
        }
        for digits in [2, 5, 10, 20, 40] {
            // A power of two: the exponent of the greatest coordinate, less so many. It is the same on every machine.
            let exponent = (greatest.to_bits() >> 52) + 1;
            let Some(exponent @ 1..2047) = exponent.checked_sub(digits) else { break };
            let grid = f64::from_bits(exponent << 52);
            let rounded = mean.map(|value| (value / grid).round() * grid);
            if let Some(point) = QueryPoint::from_f64(rounded)
                && (0..self.facet_count()).all(|f| self.side_of_facet(sum, f, &point) == Sign::Negative)
            {
                return point.point().clone();
            }
        }
        // The mean of four vertices that are not coplanar: three of a facet, and one that is not in its plane.
        let corners: Vec<&Point3> =
            sum.facet_cycle(FacetId(0)).take(3).map(|v| &sum.points()[v.index()]).collect();
        let normal = sum.facet_normal(FacetId(0));
        let below = |p: &&Point3| predicate::plane_side(normal, corners[0], p) == Sign::Negative;
        let apex = sum.points().iter().find(below).expect("a solid has a vertex below a facet");
        let quarter = Rational::new(1.into(), 4.into()).expect("four is not zero");
        let coordinate = |axis: usize| {
            let sum: Rational = corners.iter().chain([&apex]).map(|p| p.coordinate(axis)).sum();
            sum * &quarter
        };
        Point3::from_rationals(&[0, 1, 2].map(coordinate))
    }

    pub(crate) fn center(&self) -> &Point3 {
        &self.center
    }

    #[inline]
    pub(crate) fn facet_count(&self) -> u32 {
        self.starts.len() as u32 - 1
    }

    #[inline]
    pub(crate) fn halfedge_count(&self) -> u32 {
        self.links.len() as u32
    }

    /// The halfedges of a facet.
    #[inline]
    pub(crate) fn halfedges(&self, facet: u32) -> std::ops::Range<u32> {
        self.starts[facet as usize]..self.starts[facet as usize + 1]
    }

    #[inline]
    pub(crate) fn facet(&self, k: u32) -> u32 {
        self.links[k as usize].facet
    }

    #[inline]
    pub(crate) fn twin(&self, k: u32) -> u32 {
        self.links[k as usize].twin
    }

    #[inline]
    pub(crate) fn next(&self, k: u32) -> u32 {
        let range = self.halfedges(self.facet(k));
        if k + 1 == range.end { range.start } else { k + 1 }
    }

    #[inline]
    pub(crate) fn prev(&self, k: u32) -> u32 {
        let range = self.halfedges(self.facet(k));
        if k == range.start { range.end - 1 } else { k - 1 }
    }

    fn edge_vector(&self, sum: &Polytope, k: u32) -> Vector3 {
        sum.edge_vector(self.links[k as usize].halfedge)
    }

    /// The point where a halfedge starts.
    fn source_point<'s>(&self, sum: &'s Polytope, k: u32) -> &'s Point3 {
        &sum.points()[sum.mesh().source(self.links[k as usize].halfedge).index()]
    }

    /// A vertex of a facet.
    pub(crate) fn corner<'s>(&self, sum: &'s Polytope, facet: u32) -> &'s Point3 {
        self.source_point(sum, self.starts[facet as usize])
    }

    fn exact_cone<'s>(&self, sum: &'s Polytope, k: u32) -> (Vector3, &'s Point3) {
        let source = self.source_point(sum, k);
        (self.center.direction_to(source).cross(&self.edge_vector(sum, k)), source)
    }

    fn exact_out<'s>(&self, sum: &'s Polytope, k: u32) -> (Vector3, &'s Point3) {
        let normal = sum.facet_normal(FacetId(self.facet(k)));
        (self.edge_vector(sum, k).cross(normal), self.source_point(sum, k))
    }

    fn exact_along<'s>(&self, sum: &'s Polytope, k: u32) -> (Vector3, &'s Point3) {
        (self.edge_vector(sum, k), self.source_point(sum, k))
    }

    /// The side of the plane of a facet on which a point lies: positive outside.
    #[inline]
    pub(crate) fn side_of_facet(&self, sum: &Polytope, facet: u32, s: &QueryPoint) -> Sign {
        self.facets[facet as usize].side(s).unwrap_or_else(|| {
            exactly((sum.facet_normal(FacetId(facet)).clone(), self.corner(sum, facet)), s)
        })
    }

    /// Whether a point lies on the side of the facet of a halfedge, seen from the center: negative beyond the halfedge.
    #[inline]
    pub(crate) fn side_of_cone(&self, sum: &Polytope, k: u32, s: &QueryPoint) -> Sign {
        self.cones[k as usize].side(s).unwrap_or_else(|| exactly(self.exact_cone(sum, k), s))
    }

    /// Whether the projection of a point to the plane of the facet of a halfedge lies beyond the halfedge: positive if it does.
    #[inline]
    pub(crate) fn beyond(&self, sum: &Polytope, k: u32, s: &QueryPoint) -> Sign {
        self.sides[k as usize].out.side(s).unwrap_or_else(|| exactly(self.exact_out(sum, k), s))
    }

    /// Whether the projection of a point to the line of a halfedge lies ahead of its source: positive if it does.
    #[inline]
    pub(crate) fn ahead(&self, sum: &Polytope, k: u32, s: &QueryPoint) -> Sign {
        self.sides[k as usize].along.side(s).unwrap_or_else(|| exactly(self.exact_along(sum, k), s))
    }

    /// The facet that the ray from the center through a point stabs, found from another one.
    ///
    /// The walk leaves a facet across an edge beyond which the point lies, seen from the center. Facets are the places where their
    /// linear functions, scaled to the same value at the center, are the greatest: that value increases with each step.
    pub(crate) fn stab(&self, sum: &Polytope, s: &QueryPoint, start: u32) -> u32 {
        self.walk(sum, s, start, |_| false).0
    }

    /// A facet that has a point above it, if there is one; else the facet stabbed, and the side of it on which the point lies.
    #[inline]
    pub(crate) fn locate(&self, sum: &Polytope, s: &QueryPoint, start: u32) -> (u32, Sign) {
        let mut side = Sign::Zero;
        let (facet, _) = self.walk(sum, s, start, |facet| {
            side = self.side_of_facet(sum, facet, s);
            side == Sign::Positive
        });
        (facet, side)
    }

    /// Walks towards the facet stabbed; ends before if `is_done`.
    #[inline(always)]
    fn walk(
        &self,
        sum: &Polytope,
        s: &QueryPoint,
        start: u32,
        mut is_done: impl FnMut(u32) -> bool,
    ) -> (u32, bool) {
        let (mut facet, mut entered) = (start, u32::MAX);
        loop {
            if is_done(facet) {
                return (facet, true);
            }
            let is_exit = |&k: &u32| k != entered && self.side_of_cone(sum, k, s) == Sign::Negative;
            match self.halfedges(facet).find(is_exit) {
                Some(k) => (facet, entered) = (self.facet(self.twin(k)), self.twin(k)),
                None => return (facet, false),
            }
        }
    }

    /// The facet through which a ray from a point in the interior leaves M, found from another one.
    pub(crate) fn exit(&self, sum: &Polytope, s: &Point3, ray: &Vector3, start: u32) -> u32 {
        let mut facet = start;
        let is_beyond = |k: &u32| {
            let edge = self.edge_vector(sum, *k);
            side_of_ray(s, ray, &edge, self.source_point(sum, *k)) == Sign::Negative
        };
        while let Some(k) = self.halfedges(facet).find(is_beyond) {
            facet = self.facet(self.twin(k));
        }
        facet
    }

    /// The point of a feature closest to s, for a feature that has s in its Voronoi region.
    pub(crate) fn foot(&self, sum: &Polytope, cell: Cell, s: &Point3) -> Foot {
        match cell {
            Cell::Facet(f) => Foot::on_plane(sum.facet_normal(FacetId(f)), self.corner(sum, f), s),
            Cell::Edge(k) => Foot::on_line(&self.edge_vector(sum, k), self.source_point(sum, k), s),
            Cell::Vertex(k) => Foot::at(self.source_point(sum, k), s),
        }
    }
}

/// Rare, and kept out of the walks.
#[cold]
#[inline(never)]
fn exactly((normal, on): (Vector3, &Point3), s: &QueryPoint) -> Sign {
    predicate::plane_side(&normal, on, s.point())
}
