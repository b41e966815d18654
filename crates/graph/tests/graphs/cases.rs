//! Arrangements of every kind, behind one trait.

use arrangement::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusPath, TorusSegmentTraits};
use arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use arrangement::traits::BasicTraits;
use arrangement::{Arrangement, Counts, Pieces};
use dcel::{Dcel, EdgeId, EndFate, FaceId, Side, VertexId};
use splitstar_graph::{Dual, Primal};
use testkit::Rng;

/// What the tests ask of an arrangement, whatever its curves and its surface are.
pub(crate) trait Case {
    fn primal(&self) -> Primal<'_>;
    fn dual(&self) -> Dual<'_>;
    fn dcel(&self) -> &Dcel;
    fn stored(&self) -> Counts;
    fn is_at_infinity(&self, v: VertexId) -> bool;
    fn corner_face(&self) -> FaceId;
    fn genus(&self) -> u32;
}

impl<G: BasicTraits, T: Topology<G>> Case for Arrangement<G, T> {
    fn primal(&self) -> Primal<'_> {
        Primal::new(self)
    }

    fn dual(&self) -> Dual<'_> {
        Dual::new(self)
    }

    fn dcel(&self) -> &Dcel {
        Arrangement::dcel(self)
    }

    fn stored(&self) -> Counts {
        self.counts_with_splits()
    }

    fn is_at_infinity(&self, v: VertexId) -> bool {
        Arrangement::is_at_infinity(self, v)
    }

    fn corner_face(&self) -> FaceId {
        Arrangement::corner_face(self)
    }

    fn genus(&self) -> u32 {
        self.topology().genus()
    }
}

/// A point of the plane, of all families here.
pub(crate) type Point2 = <SegmentTraits as BasicTraits>::Point;
pub(crate) type Bounded = Arrangement<SegmentTraits, BoundedPlane>;
pub(crate) type Unbounded = Arrangement<LinearTraits, UnboundedPlane>;
pub(crate) type Torus = Arrangement<TorusSegmentTraits, FlatTorus>;

pub(crate) fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).expect("the ends are different")
}

/// The sides of a square.
pub(crate) fn square([x, y]: [i64; 2], side: i64) -> [Segment; 4] {
    let corners = [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    [0, 1, 2, 3].map(|i| segment([corners[i], corners[(i + 1) % 4]]))
}

pub(crate) fn line([p, q]: [[i64; 2]; 2]) -> Linear {
    Linear::line(&Point2::from_i64(p), &Point2::from_i64(q)).expect("the points are different")
}

pub(crate) fn point(rng: &mut Rng, range: u64) -> [i64; 2] {
    [0; 2].map(|_| rng.below(range + 1) as i64)
}

/// Two different points.
fn points(rng: &mut Rng, range: u64) -> [[i64; 2]; 2] {
    loop {
        let ends = [0; 2].map(|_| point(rng, range));
        if ends[0] != ends[1] {
            return ends;
        }
    }
}

pub(crate) fn segments(rng: &mut Rng, most: usize, range: u64) -> Vec<Segment> {
    (0..rng.index(most + 1)).map(|_| segment(points(rng, range))).collect()
}

pub(crate) fn lines(rng: &mut Rng, most: usize, range: u64) -> Vec<Linear> {
    (0..rng.index(most + 1)).map(|_| line(points(rng, range))).collect()
}

/// Segments and isolated points.
pub(crate) fn bounded(rng: &mut Rng) -> Bounded {
    let range = rng.between(2, 8);
    let mut pieces = Pieces::default();
    for segment in segments(rng, 14, range) {
        pieces.push_curve(segment);
    }
    for _ in 0..rng.index(4) {
        pieces.push_point(Point2::from_i64(point(rng, range)));
    }
    Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces)
}

/// Segments, rays, lines and isolated points.
pub(crate) fn unbounded(rng: &mut Rng) -> Unbounded {
    let range = rng.between(2, 8);
    let mut pieces = Pieces::default();
    for _ in 0..rng.index(9) {
        let [p, q] = points(rng, range).map(Point2::from_i64);
        let curve = match rng.index(4) {
            0 => Linear::line(&p, &q),
            1 | 2 => Linear::ray(p, &q),
            _ => Linear::segment(p, q),
        };
        pieces.push_curve(curve.expect("the points are different"));
    }
    for _ in 0..rng.index(3) {
        pieces.push_point(Point2::from_i64(point(rng, range)));
    }
    Arrangement::of_pieces(LinearTraits, UnboundedPlane, pieces)
}

/// Closed and open paths on a torus of 4 by 4.
pub(crate) fn torus(rng: &mut Rng) -> Torus {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    let path = |rng: &mut Rng| -> TorusPath {
        let start = Point2::from_i64(point(rng, 4));
        let vector = [0; 2].map(|_| rng.between(0, 4) as i64 - 2);
        let path = if rng.one_in(2) {
            traits.closed_path(&start, vector)
        } else {
            traits.path(&start, &vector.map(|x| (3 * x).into()))
        };
        path.expect("it is short")
    };
    let paths: Vec<_> = (0..rng.index(6)).map(|_| path(rng)).collect();
    Arrangement::of_curves(traits, FlatTorus, &paths)
}

/// Removes edges at random, and leaves gaps in the ids: those that have two faces, and those with a free end.
pub(crate) fn thinned(rng: &mut Rng, whole: Bounded, one_in: u64) -> Bounded {
    let mut parts = whole.into_parts();
    let dcel = &mut parts.dcel;
    let edges: Vec<EdgeId> = dcel.edges().collect();
    for e in edges {
        let [even, odd] = [e.halfedge(), e.halfedge().twin()];
        let faces = [dcel.face(even), dcel.face(odd)];
        let has_free_end = dcel.ends(e).into_iter().any(|v| dcel.degree(v) == 1);
        if !rng.one_in(one_in) || (faces[0] == faces[1] && !has_free_end) {
            continue;
        }
        // The corner face stays.
        let survivor = if faces[1] == FaceId(0) { Side::Odd } else { Side::Even };
        let fate = if rng.one_in(3) { EndFate::Isolate } else { EndFate::Remove };
        dcel.remove_edge(e, [fate; 2], survivor);
    }
    Arrangement::from_parts(SegmentTraits, BoundedPlane, parts).expect("an edge less is an arrangement, too")
}

/// Cases that are known, then random ones.
pub(crate) fn cases(seed: u64, random: usize) -> Vec<(String, Box<dyn Case>)> {
    println!("seed {seed}");
    let mut rng = Rng::new(seed);
    let mut cases: Vec<(String, Box<dyn Case>)> = Vec::new();
    let mut known = |name: &str, case: Box<dyn Case>| cases.push((name.to_owned(), case));
    let bounded_of = |curves: &[Segment]| Box::new(Bounded::of_curves(SegmentTraits, BoundedPlane, curves));
    known("nothing, bounded", bounded_of(&[]));
    known("nothing, unbounded", Box::new(Unbounded::new(LinearTraits, UnboundedPlane)));
    let sparse = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    known("nothing, torus", Box::new(Torus::new(sparse.clone(), FlatTorus)));
    known("one segment", bounded_of(&[segment([[0, 0], [1, 2]])]));
    let holes: Vec<_> = [([0, 0], 20), ([1, 1], 2), ([5, 1], 2), ([9, 1], 6), ([10, 2], 2)]
        .into_iter()
        .flat_map(|(at, side)| square(at, side))
        .collect();
    known("holes in holes", bounded_of(&holes));
    let parallels = [0, 1, 2].map(|y| line([[0, y], [1, y]]));
    known("parallel lines", Box::new(Unbounded::of_curves(LinearTraits, UnboundedPlane, &parallels)));
    let around = sparse.closed_path(&Point2::from_i64([0, 1]), [1, 0]).expect("it is short");
    known("one loop around a torus", Box::new(Torus::of_curves(sparse, FlatTorus, &[around])));
    for i in 0..random {
        let case: Box<dyn Case> = match i % 4 {
            0 => Box::new(bounded(&mut rng)),
            1 => Box::new(unbounded(&mut rng)),
            2 => Box::new(torus(&mut rng)),
            _ => {
                let (whole, one_in) = (bounded(&mut rng), rng.between(1, 4));
                Box::new(thinned(&mut rng, whole, one_in))
            }
        };
        cases.push((format!("random {i}"), case));
    }
    cases
}
