//! An oracle from the plane: arcs are projected to the faces of a cube, where they are segments; these are arranged in the plane, and
//! the six arrangements are stitched together along the edges of the cube.

use crate::arcs::{Arc, Curve};
use crate::space::{P, at, between, compare_way, cross, orthogonal, primitive};
use exact::planar::Point2;
use exact::{Integer, Rational};
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::{Arrangement, Counts, Pieces};
use std::collections::{BTreeMap, BTreeSet};

type Plane = Arrangement<SegmentTraits, BoundedPlane>;

/// A face of the cube: the coordinate that is greatest there, and whether it is negative.
#[derive(Clone, Copy)]
struct Side {
    axis: usize,
    is_negative: bool,
}

impl Side {
    fn all() -> [Self; 6] {
        [0, 1, 2, 3, 4, 5].map(|i| Self { axis: i % 3, is_negative: i >= 3 })
    }

    fn height(self, p: &P) -> Integer {
        if self.is_negative { -&p[self.axis] } else { p[self.axis].clone() }
    }

    fn has(self, p: &P) -> bool {
        let height = self.height(p);
        p.iter().all(|c| c.abs() <= height)
    }

    fn other_axes(self) -> [usize; 2] {
        [(self.axis + 1) % 3, (self.axis + 2) % 3]
    }

    fn project(self, p: &P) -> Point2 {
        let coordinate = |axis: usize| {
            Rational::new(p[axis].clone(), self.height(p))
                .expect("the height of a point of a face is not zero")
        };
        Point2::from_rationals(&self.other_axes().map(coordinate))
    }

    fn lift(self, point: &Point2) -> P {
        let [x, y] = point.coordinates();
        let weight = x.denominator() * y.denominator();
        let mut p = [Integer::ZERO, Integer::ZERO, Integer::ZERO];
        let [j, k] = self.other_axes();
        (p[j], p[k]) = (x.numerator() * y.denominator(), y.numerator() * x.denominator());
        p[self.axis] = if self.is_negative { -weight } else { weight };
        primitive(&p)
    }
}

/// Whether a direction is on an edge of the cube.
fn is_on_cube_edge(p: &P) -> bool {
    let mut sizes = p.each_ref().map(Integer::abs);
    sizes.sort();
    sizes[1] == sizes[2]
}

/// The normals of the planes through opposite edges of the cube.
fn diagonals() -> [P; 6] {
    [[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]].map(at)
}

/// The ends of an arc and the places where it passes from one face of the cube to another, in their order.
fn stops(arc: &Arc) -> Vec<P> {
    let mut stops: Vec<P> = arc.ends.iter().flatten().cloned().collect();
    if arc.is_point() {
        return stops;
    }
    let is_closed = arc.ends.as_ref().is_none_or(|[a, b]| a == b);
    if is_closed {
        stops.truncate(1);
    }
    for normal in diagonals() {
        let axis = cross(&arc.normal, &normal);
        if axis.iter().all(Integer::is_zero) {
            continue;
        }
        let plane = Arc { normal, ends: None };
        let inside = arc.crossings(&plane).into_iter().filter(is_on_cube_edge);
        stops.extend(inside.collect::<Vec<_>>());
    }
    let start = arc.ends.as_ref().map_or_else(|| orthogonal(&arc.normal), |[a, _]| a.clone());
    stops.sort_by(|a, b| compare_way(&arc.normal, &start, a, b));
    stops.dedup();
    if is_closed {
        stops.push(stops[0].clone());
    }
    stops
}

/// Union and find.
struct Classes(Vec<usize>);

impl Classes {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn root(&self, mut i: usize) -> usize {
        while self.0[i] != i {
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a] = b;
    }

    fn count(&self) -> usize {
        (0..self.0.len()).filter(|&i| self.0[i] == i).count()
    }
}

/// The arrangement on one face of the cube: parts of arcs, the sides of the square, and all places where arcs are cut.
fn arrange(side: Side, parts: &BTreeSet<[P; 2]>, places: &BTreeSet<P>) -> Plane {
    let corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
    let mut pieces = Pieces::<SegmentTraits>::new();
    for i in 0..4 {
        pieces.push_curve(Segment::from_i64([corners[i], corners[(i + 1) % 4]]).expect("corners differ"));
    }
    for part in parts.iter().filter(|part| part.iter().all(|p| side.has(p))) {
        let [p, q] = part.each_ref().map(|p| side.project(p));
        pieces.push_curve(Segment::new(p, q).expect("the ends of a part differ"));
    }
    for place in places.iter().filter(|p| side.has(p)) {
        pieces.push_point(side.project(place));
    }
    Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces)
}

/// Counts the cells on the sphere.
pub(crate) fn counts(curves: &[Curve]) -> Counts {
    let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
    let (mut parts, mut places) = (BTreeSet::new(), BTreeSet::new());
    for arc in &arcs {
        let stops = stops(arc);
        if !arc.is_point() {
            parts.extend(stops.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]));
        }
        places.extend(stops);
    }
    let covers =
        |arc: &Arc, [p, q]: &[P; 2]| !arc.is_point() && arc.has(p) && arc.has(q) && arc.has(&between(p, q));
    let planes = Side::all().map(|side| arrange(side, &parts, &places));
    let mut offsets = vec![0];
    for plane in &planes {
        offsets.push(offsets[offsets.len() - 1] + plane.dcel().face_bound());
    }
    let mut faces = Classes::new(offsets[6]);
    let mut edges: BTreeSet<[P; 2]> = BTreeSet::new();
    // Parts of edges of the cube along which there is no arc, with the face beside each.
    let mut seams: BTreeMap<[P; 2], Vec<usize>> = BTreeMap::new();
    for (i, (plane, side)) in planes.iter().zip(Side::all()).enumerate() {
        for e in plane.dcel().edges() {
            let mut ends = plane.dcel().ends(e).map(|v| side.lift(plane.point(v).expect("it is bounded")));
            ends.sort();
            let is_seam = is_on_cube_edge(&ends[0]) && is_on_cube_edge(&ends[1]) && {
                is_on_cube_edge(&between(&ends[0], &ends[1]))
            };
            if !is_seam || arcs.iter().any(|arc| covers(arc, &ends)) {
                edges.insert(ends);
            } else {
                let around = [e.halfedge(), e.halfedge().twin()].map(|h| plane.dcel().face(h));
                let inner = around.into_iter().filter(|&f| f != plane.corner_face());
                let inner: Vec<usize> = inner.map(|f| offsets[i] + f.index()).collect();
                assert_eq!(inner.len(), 1, "a side of a square has the outside on one side");
                seams.entry(ends).or_default().extend(inner);
            }
        }
    }
    for beside in seams.into_values() {
        let [a, b] = beside[..] else { panic!("two faces of the cube have an edge in common") };
        faces.join(a, b);
    }
    let is_inner = |i: usize, f| f != planes[i].corner_face();
    let all = planes.iter().enumerate().flat_map(|(i, plane)| plane.dcel().faces().map(move |f| (i, f)));
    let inner: BTreeSet<usize> =
        all.filter(|&(i, f)| is_inner(i, f)).map(|(i, f)| faces.root(offsets[i] + f.index())).collect();
    let [vertices, edges, isolated, components] = count_graph(&arcs, &edges);
    Counts { vertices, edges, faces: inner.len(), isolated, components }
}

/// Counts vertices, edges, isolated vertices and components as a user sees them.
fn count_graph(arcs: &[Arc], edges: &BTreeSet<[P; 2]>) -> [usize; 4] {
    let real: BTreeSet<&P> = arcs.iter().flat_map(|arc| arc.ends.iter().flatten()).collect();
    let mut degrees: BTreeMap<&P, usize> = real.iter().map(|&p| (p, 0)).collect();
    for p in edges.iter().flatten() {
        *degrees.entry(p).or_default() += 1;
    }
    let numbers: BTreeMap<&P, usize> = degrees.keys().copied().zip(0..).collect();
    let mut components = Classes::new(numbers.len());
    for [p, q] in edges {
        components.join(numbers[p], numbers[q]);
    }
    let is_hidden = |p: &&P| degrees[*p] == 2 && !real.contains(*p);
    let hidden = degrees.keys().filter(|p| is_hidden(p)).count();
    let with_vertex: BTreeSet<usize> =
        degrees.keys().filter(|p| !is_hidden(p)).map(|&p| components.root(numbers[p])).collect();
    // A circle without a vertex keeps one.
    let free = components.count() - with_vertex.len();
    let isolated = degrees.values().filter(|&&degree| degree == 0).count();
    [degrees.len() - hidden + free, edges.len() - hidden + free, isolated, components.count()]
}
