//! An oracle from the plane: arcs are projected to the faces of a cube, where they are segments; these are arranged in the plane, and
//! the six arrangements are stitched together along the edges of the cube. Besides counting cells, it walks round the faces.

use crate::arcs::{Arc, Curve};
use crate::incidences::{Cycle, Incidences};
use crate::space::{P, at, between, compare_way, cross, orthogonal, primitive};
use dcel::HalfedgeId;
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

    /// Counterclockwise in these coordinates is counterclockwise seen from outside.
    fn other_axes(self) -> [usize; 2] {
        let [j, k] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        if self.is_negative { [k, j] } else { [j, k] }
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

/// A halfedge on one of the faces of the cube.
type Place = (usize, HalfedgeId);

/// The six arrangements, and how they hang together.
struct Stitched<'a> {
    arcs: &'a [Arc],
    planes: [Plane; 6],
    /// The vertices in space.
    points: [Vec<P>; 6],
    /// Of the faces of all planes, which are one.
    faces: Classes,
    /// The number of the first face of each plane.
    offsets: [usize; 6],
    edges: BTreeSet<[P; 2]>,
    /// What lies on an edge of the cube along which there is no arc: where one gets who passes it.
    across: BTreeMap<Place, Place>,
}

impl<'a> Stitched<'a> {
    fn new(arcs: &'a [Arc]) -> Self {
        let (mut parts, mut places) = (BTreeSet::new(), BTreeSet::new());
        for arc in arcs {
            let stops = stops(arc);
            if !arc.is_point() {
                parts.extend(stops.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]));
            }
            places.extend(stops);
        }
        let planes = Side::all().map(|side| arrange(side, &parts, &places));
        let points = [0, 1, 2, 3, 4, 5].map(|i| {
            let plane: &Plane = &planes[i];
            let lift = |v| Side::all()[i].lift(plane.point(v).expect("it is bounded"));
            plane.dcel().vertices().map(lift).collect::<Vec<P>>()
        });
        let mut offsets = [0; 6];
        for i in 1..6 {
            offsets[i] = offsets[i - 1] + planes[i - 1].dcel().face_bound();
        }
        let faces = Classes::new(offsets[5] + planes[5].dcel().face_bound());
        let (edges, across) = (BTreeSet::new(), BTreeMap::new());
        let mut stitched = Self { arcs, planes, points, faces, offsets, edges, across };
        stitched.stitch();
        stitched
    }

    fn point(&self, (i, h): Place) -> &P {
        &self.points[i][self.planes[i].dcel().source(h).index()]
    }

    /// The number of the face on the left; `None` outside of the square.
    fn face(&self, (i, h): Place) -> Option<usize> {
        let f = self.planes[i].dcel().face(h);
        (f != self.planes[i].corner_face()).then(|| self.offsets[i] + f.index())
    }

    fn stitch(&mut self) {
        let covers = |arc: &Arc, [p, q]: &[P; 2]| {
            !arc.is_point() && arc.has(p) && arc.has(q) && arc.has(&between(p, q))
        };
        // Parts of edges of the cube along which there is no arc, with the halfedges that have the inside on the left.
        let mut seams: BTreeMap<[P; 2], Vec<Place>> = BTreeMap::new();
        for i in 0..6 {
            for e in self.planes[i].dcel().edges() {
                let sides = [e.halfedge(), e.halfedge().twin()].map(|h| (i, h));
                let mut ends = sides.map(|place| self.point(place).clone());
                ends.sort();
                let is_seam = is_on_cube_edge(&ends[0]) && is_on_cube_edge(&ends[1]) && {
                    is_on_cube_edge(&between(&ends[0], &ends[1]))
                };
                if !is_seam || self.arcs.iter().any(|arc| covers(arc, &ends)) {
                    self.edges.insert(ends);
                } else {
                    let inner: Vec<Place> =
                        sides.into_iter().filter(|&place| self.face(place).is_some()).collect();
                    assert_eq!(inner.len(), 1, "a side of a square has the outside on one side");
                    seams.entry(ends).or_default().extend(inner);
                }
            }
        }
        for beside in seams.into_values() {
            let [a, b] = beside[..] else { panic!("two faces of the cube have an edge in common") };
            assert_ne!(self.point(a), self.point(b), "they run against each other");
            let [of_a, of_b] = [a, b].map(|place| self.face(place).expect("it is inside"));
            self.faces.join(of_a, of_b);
            self.across.extend([(a, b), (b, a)]);
        }
    }

    fn real(&self) -> BTreeSet<&P> {
        self.arcs.iter().flat_map(|arc| arc.ends.iter().flatten()).collect()
    }

    /// What follows on the boundary of the face on the left: past all edges of the cube that are not there.
    fn next(&self, (i, h): Place) -> Place {
        let mut place = (i, self.planes[i].dcel().next(h));
        while let Some(&(j, other)) = self.across.get(&place) {
            place = (j, self.planes[j].dcel().next(other));
        }
        place
    }

    /// Walks round all faces.
    fn cycles(&self) -> Vec<Vec<Cycle>> {
        let real = self.real();
        let mut degrees: BTreeMap<&P, usize> = BTreeMap::new();
        self.edges.iter().flatten().for_each(|p| *degrees.entry(p).or_default() += 1);
        let is_seen = |p: &P| real.contains(p) || degrees[p] != 2;
        let mut faces: BTreeMap<usize, Vec<Cycle>> = BTreeMap::new();
        let mut is_met: BTreeSet<Place> = BTreeSet::new();
        let all = (0..6).flat_map(|i| self.planes[i].dcel().halfedges().map(move |h| (i, h)));
        for start in all {
            let Some(face) = self.face(start) else { continue };
            if self.across.contains_key(&start) || is_met.contains(&start) {
                continue;
            }
            let face = self.faces.root(face);
            let (mut cycle, mut hidden) = (Cycle::new(), Vec::new());
            let mut place = start;
            while is_met.insert(place) {
                let next = self.next(place);
                assert_eq!(
                    self.face(next).map(|f| self.faces.root(f)),
                    Some(face),
                    "one face is on the left"
                );
                let source = self.point(place);
                let (j, h) = place;
                let target = &self.points[j][self.planes[j].dcel().target(h).index()];
                let normal = primitive(&cross(source, target));
                if is_seen(source) {
                    cycle.push((Some(source.clone()), normal));
                } else {
                    hidden.push((None, normal));
                }
                place = next;
            }
            if cycle.is_empty() {
                hidden.dedup();
                assert_eq!(hidden.len(), 1, "a circle has one normal");
                cycle = hidden;
            }
            faces.entry(face).or_default().push(cycle);
        }
        self.add_isolated(&degrees, &mut faces);
        faces.into_values().collect()
    }

    /// Points on no arc, and the face all around if there is nothing else.
    fn add_isolated(&self, degrees: &BTreeMap<&P, usize>, faces: &mut BTreeMap<usize, Vec<Cycle>>) {
        for &p in self.real().iter().filter(|p| !degrees.contains_key(**p)) {
            let places = (0..6).flat_map(|i| {
                let dcel = self.planes[i].dcel();
                let v = self.points[i].iter().position(|q| q == p).map(dcel::VertexId::new);
                let v = v.into_iter();
                let around = v.clone().flat_map(|v| dcel.around(v)).filter_map(move |h| self.face((i, h)));
                let inside = v.filter_map(|v| dcel.isolated_face(v));
                around.chain(inside.map(move |f| self.offsets[i] + f.index())).collect::<Vec<_>>()
            });
            let places: BTreeSet<usize> = places.map(|f| self.faces.root(f)).collect();
            assert_eq!(places.len(), 1, "an isolated vertex is in one face");
            for face in places {
                faces.entry(face).or_default().push(vec![(Some(p.clone()), at([0; 3]))]);
            }
        }
        if faces.is_empty() {
            faces.insert(0, Vec::new());
        }
    }

    fn counts(&self) -> Counts {
        let of_plane = |i: usize| {
            let plane = &self.planes[i];
            let inner = plane.dcel().faces().filter(|&f| f != plane.corner_face());
            inner.map(move |f| self.faces.root(self.offsets[i] + f.index()))
        };
        let inner: BTreeSet<usize> = (0..6).flat_map(of_plane).collect();
        let [vertices, edges, isolated, components] = count_graph(&self.real(), &self.edges);
        Counts { vertices, edges, faces: inner.len(), isolated, components }
    }
}

/// Counts the cells on the sphere.
pub(crate) fn counts(curves: &[Curve]) -> Counts {
    let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
    Stitched::new(&arcs).counts()
}

/// What bounds the faces on the sphere.
pub(crate) fn incidences(curves: &[Curve]) -> Incidences {
    let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
    let stitched = Stitched::new(&arcs);
    Incidences::new(stitched.counts(), stitched.cycles())
}

/// Counts vertices, edges, isolated vertices and components as a user sees them.
fn count_graph(real: &BTreeSet<&P>, edges: &BTreeSet<[P; 2]>) -> [usize; 4] {
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
