//! What the cells are, found by brute force: all pairs of curves, in exact arithmetic, with formulas of its own.

use crate::curves::{Curve, P, Shape, rational};
use exact::planar::Point2;
use exact::{Rational, Sign};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::UMonotoneTraits;
use splitstar_arrangement::{Arrangement, Counts};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// The cells of an arrangement, as far as they can be told in coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    pub(crate) counts: Counts,
    pub(crate) vertices: BTreeSet<P>,
    /// The edges: ends, `None` where they are unbounded, and the direction of their line.
    pub(crate) edges: BTreeSet<EdgeKey>,
}

/// The lesser and the greater end of an edge, and the line: direction (1, slope) or (0, 1), and where it meets the axis.
pub(crate) type EdgeKey = ([Option<P>; 2], LineKey);
pub(crate) type LineKey = (Option<Rational>, Rational);

pub(crate) fn cross([a, b]: &P, [c, d]: &P) -> Rational {
    a * d - b * c
}

pub(crate) fn minus([a, b]: &P, [c, d]: &P) -> P {
    [a - c, b - d]
}

pub(crate) fn line_key(p: &P, q: &P) -> LineKey {
    let [dx, dy] = minus(q, p);
    match dy.checked_div(&dx) {
        Some(slope) => {
            let height = &p[1] - &slope * &p[0];
            (Some(slope), height)
        }
        None => (None, p[0].clone()),
    }
}

/// The line of a curve that is no point.
pub(crate) fn line_of(curve: &Curve) -> Option<LineKey> {
    match curve {
        Curve::Point(_) => None,
        Curve::Straight(_, [p, q]) => Some(line_key(p, q)),
    }
}

/// Tells whether a curve has a point.
pub(crate) fn has_point(curve: &Curve, r: &P) -> bool {
    match curve {
        Curve::Point(p) => p == r,
        Curve::Straight(shape, [p, q]) => {
            let (d, to_r) = (minus(q, p), minus(r, p));
            let along = &d[0] * &to_r[0] + &d[1] * &to_r[1];
            let whole = &d[0] * &d[0] + &d[1] * &d[1];
            cross(&d, &to_r).is_zero()
                && (*shape == Shape::Line || along.sign() != Sign::Negative)
                && (*shape != Shape::Segment || along <= whole)
        }
    }
}

/// The one common point of two curves on different lines.
pub(crate) fn crossing(a: &Curve, b: &Curve) -> Option<P> {
    let (Curve::Straight(_, [p, q]), Curve::Straight(_, [r, s])) = (a, b) else { return None };
    let (d, e) = (minus(q, p), minus(s, r));
    let time = cross(&minus(r, p), &e).checked_div(&cross(&d, &e))?;
    let point = [&p[0] + &d[0] * &time, &p[1] + &d[1] * &time];
    (has_point(a, &point) && has_point(b, &point)).then_some(point)
}

/// The ends of a curve that are points.
pub(crate) fn ends(curve: &Curve) -> &[P] {
    match curve {
        Curve::Point(p) => std::slice::from_ref(p),
        Curve::Straight(Shape::Segment, ends) => ends,
        Curve::Straight(Shape::Ray, ends) => &ends[..1],
        Curve::Straight(Shape::Line, _) => &[],
    }
}

/// Finds the cells of an arrangement of curves in the plane.
pub(crate) fn brute_force(curves: &[Curve]) -> Cells {
    let mut vertices: BTreeSet<P> = curves.iter().flat_map(|curve| ends(curve).to_vec()).collect();
    for (i, a) in curves.iter().enumerate() {
        vertices.extend(curves[..i].iter().filter_map(|b| crossing(a, b)));
    }
    let mut edges = BTreeSet::new();
    for curve in curves {
        let Curve::Straight(shape, [p, q]) = curve else { continue };
        let on_it = vertices.iter().filter(|v| has_point(curve, v)).cloned().map(Some);
        let is_open = |end| match shape {
            Shape::Segment => false,
            Shape::Ray => p.cmp(q) == end,
            Shape::Line => true,
        };
        let low = is_open(Ordering::Greater).then_some(None);
        let high = is_open(Ordering::Less).then_some(None);
        let stops: Vec<Option<P>> = low.into_iter().chain(on_it).chain(high).collect();
        let line = line_key(p, q);
        edges.extend(stops.windows(2).map(|pair| ([pair[0].clone(), pair[1].clone()], line.clone())));
    }
    let counts = count(&vertices, &edges);
    Cells { counts, vertices, edges }
}

/// Counts, by Euler's formula on the sphere that one point at infinity makes of the plane.
fn count(vertices: &BTreeSet<P>, edges: &BTreeSet<EdgeKey>) -> Counts {
    let numbers: BTreeMap<&P, usize> = vertices.iter().zip(0..).collect();
    let infinity = vertices.len();
    let number = |end: &Option<P>| end.as_ref().map_or(infinity, |p| numbers[p]);
    let mut on_sphere = Components::new(infinity + 1);
    let mut in_plane = Components::new(infinity + 1);
    let (mut lines, mut is_isolated) = (0, vec![true; infinity + 1]);
    for (ends, _) in edges {
        let [a, b] = ends.each_ref().map(number);
        is_isolated[a] = false;
        is_isolated[b] = false;
        on_sphere.join(a, b);
        match ends {
            [None, None] => lines += 1,
            [Some(_), Some(_)] => in_plane.join(a, b),
            _ => {}
        }
    }
    let has_infinity = usize::from(!is_isolated[infinity]);
    let components = on_sphere.count - 1 + has_infinity;
    Counts {
        vertices: vertices.len(),
        edges: edges.len(),
        faces: 1 + components + edges.len() - vertices.len() - has_infinity,
        isolated: is_isolated[..infinity].iter().filter(|&&is| is).count(),
        components: in_plane.count - 1 + lines,
    }
}

/// Union and find.
#[derive(Clone, Debug)]
pub(crate) struct Components {
    parents: Vec<usize>,
    pub(crate) count: usize,
}

impl Components {
    pub(crate) fn new(count: usize) -> Self {
        Self { parents: (0..count).collect(), count }
    }

    pub(crate) fn root(&self, mut i: usize) -> usize {
        while self.parents[i] != i {
            i = self.parents[i];
        }
        i
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        if a != b {
            self.parents[a] = b;
            self.count -= 1;
        }
    }
}

/// The vertices and the edges that an arrangement has, as its user sees them, in coordinates. The ends of an edge are
/// sorted; infinity is `None`, and the least.
pub(crate) fn cells_of<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
) -> (BTreeSet<P>, Vec<[Option<P>; 2]>) {
    let view = arrangement.user_view();
    let coordinates = |v| arrangement.point(v).map(Point2::coordinates);
    let vertices = view.vertices().filter_map(coordinates).collect();
    let edges = view.edges().map(|edge| {
        let mut ends = view.ends(edge).map(coordinates);
        ends.sort();
        ends
    });
    (vertices, edges.collect())
}

#[test]
fn brute_force_counts_what_is_known() {
    let segments =
        crate::curves::parse("segment 0 0 2 2, segment 0 2 2 0, segment 1 1 5 1, point 3 1, point 9 9");
    let counts = brute_force(&segments).counts;
    assert_eq!((counts.vertices, counts.edges, counts.faces), (8, 6, 1));
    assert_eq!((counts.isolated, counts.components), (1, 2));
    let lines = crate::curves::parse("line 0 0 1 0, line 0 1 1 1, line 0 0 0 1, ray 5 5 6 6");
    let counts = brute_force(&lines).counts;
    assert_eq!((counts.vertices, counts.edges, counts.faces), (3, 8, 6));
    assert_eq!(counts.components, 2);
    assert_eq!(rational(0), Rational::ZERO);
}
