//! Six sweeps.

use crate::connected::{KnownEdge, of_connected};
use crate::map::{CubicalArrangement, SideArrangement};
use crate::pieces::{CORNERS_OF_BORDER, CubicalPieces, SidePieces, border_of, side_behind};
use crate::stitch::{Patch, stitch};
use arrangement::Arrangement;
use arrangement::models::{Segment, SegmentTraits};
use arrangement::topology::BoundedPlane;
use dcel::EdgeId;
use exact::gnomonic::CubeSide;
use exact::planar::{Point2, compare_xy};

/// For each side and each of its edges, the number of its arc.
pub(crate) type ArcNumbers = [Vec<Option<u32>>; 6];

impl CubicalArrangement {
    /// Makes the arrangement of geodesic arcs, circles and points, by one sweep a side.
    ///
    /// # Complexity
    /// O((n + k) log n) for n arcs that meet k times.
    ///
    /// # References
    /// Thesis, section 3.3.1.
    pub fn of_pieces(pieces: CubicalPieces) -> Self {
        Self::of_pieces_with_arcs(pieces).0
    }

    /// Makes the arrangement, and tells for each edge of each side, by its number, which arc runs along it: none along an artificial edge, nor
    /// where several overlap.
    ///
    /// The segment of the edge is directed as the arc.
    pub fn of_pieces_with_arcs(pieces: CubicalPieces) -> (Self, [Vec<Option<u32>>; 6]) {
        Self::of_sides(pieces, sweep_side)
    }

    fn of_sides(
        pieces: CubicalPieces,
        make: impl Fn(CubeSide, SidePieces) -> (Patch, Vec<Option<u32>>),
    ) -> (Self, ArcNumbers) {
        let mut arcs = ArcNumbers::default();
        let mut patches = Vec::with_capacity(6);
        for (side, pieces) in CubeSide::ALL.into_iter().zip(pieces.sides) {
            let (patch, of_edges) = make(side, pieces);
            patches.push(patch);
            arcs[side.index()] = of_edges;
        }
        let patches = <[Patch; 6]>::try_from(patches).expect("a cube has six sides");
        (stitch(patches), arcs)
    }

    /// Makes the arrangement of arcs of which it is known how they meet, and tells which arc runs along each edge, as
    /// [`CubicalArrangement::of_pieces_with_arcs`] does, but without a sweep.
    ///
    /// # Preconditions
    /// The arcs were pushed between [ends](CubicalPieces::add_end), which are all different, and each of which is one of an arc. They meet in common ends
    /// only. They are connected, and not all within one side; or there is none. There are no circles and no points. Debug builds check it.
    ///
    /// # Complexity
    /// Linear, but for the order of the vertices: O(n log n).
    ///
    /// ```
    /// use exact::spherical::{Direction, GreatCircle};
    /// use splitstar_cubical::{CubicalArrangement, CubicalPieces};
    /// let directions = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    /// let mut pieces = CubicalPieces::new();
    /// let ends = directions.map(|p| pieces.add_end(&Direction::from_i64(p).expect("not zero")));
    /// for i in 0..3 {
    ///     let circle = GreatCircle::from_i64(directions[(i + 2) % 3]).expect("not zero");
    ///     pieces.push_arc_between(&circle, ends[i], ends[(i + 1) % 3]);
    /// }
    /// let (triangle, _) = CubicalArrangement::of_connected_pieces_with_arcs(pieces.clone());
    /// let counts = triangle.counts();
    /// assert_eq!((counts.vertices, counts.edges, counts.faces), (3, 3, 2));
    /// assert_eq!(triangle.counts_with_artificial(), CubicalArrangement::of_pieces(pieces).counts_with_artificial());
    /// ```
    pub fn of_connected_pieces_with_arcs(pieces: CubicalPieces) -> (Self, [Vec<Option<u32>>; 6]) {
        Self::of_sides(pieces, |_, pieces| connect_side(pieces))
    }

    /// The cube without arcs: one face.
    pub fn new() -> Self {
        Self::of_pieces(CubicalPieces::new())
    }
}

impl Default for CubicalArrangement {
    fn default() -> Self {
        Self::new()
    }
}

/// The arrangement of what is on one side, and the arcs of its edges.
fn sweep_side(side: CubeSide, pieces: SidePieces) -> (Patch, Vec<Option<u32>>) {
    let SidePieces { mut pieces, arcs, places, given, covered, .. } = pieces;
    let real = pieces.curves().len();
    for (border, covered) in covered.into_iter().enumerate() {
        let covered = covered.into_iter().map(|ends| ends.map(|end| places[end as usize].clone()));
        for segment in uncovered(side, border, covered.collect()) {
            pieces.push_curve(segment);
        }
    }
    let artificial = real..pieces.curves().len();
    let arrangement: SideArrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
    let support = |e: usize| arrangement.support(EdgeId::new(e)).index();
    let edges = arrangement.dcel().edge_bound();
    // What is artificial overlaps nothing; where several arcs overlap, the support is none of them.
    let is_real_edge = (0..edges).map(|e| !artificial.contains(&support(e))).collect();
    let of_edges = (0..edges).map(|e| arcs.get(support(e)).copied()).collect();
    let given = given.into_iter().map(|place| places[place as usize].clone());
    let is_given = given_on_border(&arrangement, given.collect());
    (Patch { arrangement, is_real_edge, is_given }, of_edges)
}

/// The arrangement of arcs that meet in common ends only, and the arcs of its edges.
fn connect_side(pieces: SidePieces) -> (Patch, Vec<Option<u32>>) {
    let SidePieces { pieces, arcs, ends, places, on_border, given, covered } = pieces;
    let (mut curves, _) = pieces.into_parts();
    let real = curves.len();
    let mut edges = Vec::with_capacity(real + on_border.iter().map(|places| places.len() + 1).sum::<usize>());
    for (support, ([source, target], curve)) in (0..).zip(ends.into_iter().zip(&curves)) {
        let ends = if curve.is_directed_right() { [source, target] } else { [target, source] };
        edges.push(KnownEdge { support, ends });
    }
    for ((mut between, covered), [from, to]) in on_border.into_iter().zip(covered).zip(CORNERS_OF_BORDER) {
        between.sort_unstable_by(|&p, &q| compare_xy(&places[p as usize], &places[q as usize]));
        between.push(to);
        let support = curves.len() as u32;
        let mut at = from;
        for place in between {
            let ends = [std::mem::replace(&mut at, place), place];
            if !covered.contains(&ends) {
                edges.push(KnownEdge { support, ends });
            }
        }
        let [from, to] = [from, to].map(|corner| places[corner as usize].clone());
        curves.push(Segment::new(from, to).expect("corners are different"));
    }
    let (arrangement, ids) = of_connected(places, curves, &edges);
    let mut is_given = vec![false; ids.len()];
    given.into_iter().for_each(|place| is_given[ids[place as usize].index()] = true);
    let is_real_edge = (0..edges.len()).map(|e| e < real).collect();
    let of_edges = (0..edges.len()).map(|e| arcs.get(e).copied()).collect();
    (Patch { arrangement, is_real_edge, is_given }, of_edges)
}

/// What arcs do not cover of an edge of the square.
fn uncovered(side: CubeSide, border: usize, mut covered: Vec<[Point2; 2]>) -> Vec<Segment> {
    let [from, to] = ends_of_border(side, border);
    let mut segments = Vec::new();
    covered.sort_unstable_by(|a, b| compare_xy(&a[0], &b[0]));
    let mut at = from;
    for [min, max] in covered {
        if compare_xy(&at, &min).is_lt() {
            segments.extend(Segment::new(at.clone(), min));
        }
        if compare_xy(&at, &max).is_lt() {
            at = max;
        }
    }
    segments.extend(Segment::new(at, to));
    segments
}

/// The corners between which an edge of the square lies, the lesser one first.
fn ends_of_border(side: CubeSide, border: usize) -> [Point2; 2] {
    debug_assert_eq!(border_of(side, side_behind(side, border)), border);
    let at = if border % 2 == 1 { 1 } else { -1 };
    [-1, 1].map(|free| Point2::from_i64(if border < 2 { [at, free] } else { [free, at] }))
}

/// For each vertex, whether a point was given there, or an arc ends there. Only vertices on the border are asked about.
fn given_on_border(arrangement: &SideArrangement, mut given: Vec<Point2>) -> Vec<bool> {
    let dcel = arrangement.dcel();
    let mut is_given = vec![false; dcel.vertex_bound()];
    if given.is_empty() {
        return is_given;
    }
    given.sort_unstable_by(compare_xy);
    let outer = crate::stitch::border_cycle(arrangement);
    for v in outer.map(|h| dcel.source(h)) {
        let point = arrangement.point(v).expect("in the bounded plane every vertex has a point");
        is_given[v.index()] = given.binary_search_by(|other| compare_xy(other, point)).is_ok();
    }
    is_given
}
