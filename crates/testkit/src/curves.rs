//! Curves of published measurements: segments, lines, rays and polylines with coordinates of 20 bits, arcs of great circles with
//! coordinates of 11 bits.
//!
//! The same call gives the same curves on every machine, number by number, and a [`Drawn::hash`] that other programs with the
//! same generator print too: inputs with one hash are one input. The measurements of CGAL that `cargo xtask peers arrangements`
//! repeats use seed 1, seed 2 for the second operand of an overlay, and seed 1000 for the points of queries.
//!
//! An object that is refused is thrown away whole and drawn again; it is not hashed.

use crate::random::Rng;

/// Coordinates are in `0..2^COORDINATE_BITS`.
pub const COORDINATE_BITS: u32 = 20;
/// Vertices of each of the [`polylines`].
pub const POLYLINE_VERTICES: usize = 10;
/// Steps of the [`polylines`] are in `-2^16..2^16`.
const STEP_BITS: u32 = 17;
/// Coordinates of directions are in `-2^10..2^10`.
const DIRECTION_BITS: u32 = 11;

/// Objects, and the hash of all their numbers in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drawn<T> {
    /// What was drawn, in order.
    pub objects: Vec<T>,
    /// FNV-style, over the coordinates in the order in which they were drawn.
    pub hash: u64,
}

/// What the two points of a linear curve mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LinearKind {
    /// The line through both.
    Line,
    /// From the first through the second.
    Ray,
    /// Between them.
    Segment,
}

/// The generator, with the hash of what was accepted so far.
struct Source {
    rng: Rng,
    hash: u64,
}

impl Source {
    fn new(seed: u64) -> Self {
        Source { rng: Rng::new(seed), hash: 0xcbf2_9ce4_8422_2325 }
    }

    /// In `0..2^bits`.
    fn unsigned(&mut self, bits: u32) -> i64 {
        (self.rng.bits() >> (u64::BITS - bits)) as i64
    }

    /// In `-2^(bits-1)..2^(bits-1)`.
    fn signed(&mut self, bits: u32) -> i64 {
        self.unsigned(bits) - (1 << (bits - 1))
    }

    fn point(&mut self) -> [i64; 2] {
        [(); 2].map(|()| self.unsigned(COORDINATE_BITS))
    }

    /// Not zero; what is thrown away is not the object it is drawn for.
    fn direction(&mut self) -> [i64; 3] {
        loop {
            let direction = [(); 3].map(|()| self.signed(DIRECTION_BITS));
            if direction != [0; 3] {
                return direction;
            }
        }
    }

    fn accept(&mut self, values: &[i64]) {
        for &value in values {
            self.hash = (self.hash ^ value as u64).wrapping_mul(0x100_0000_01b3);
        }
    }

    fn drawn<T>(self, objects: Vec<T>) -> Drawn<T> {
        Drawn { objects, hash: self.hash }
    }
}

fn is_inside([x, y]: [i64; 2]) -> bool {
    let range = 0..1 << COORDINATE_BITS;
    range.contains(&x) && range.contains(&y)
}

/// Segments `[x1, y1, x2, y2]` between two random points of the square: more than a fifth of all pairs cross.
///
/// ```
/// let drawn = splitstar_testkit::long_segments(100, 1);
/// assert_eq!(drawn.objects.len(), 100);
/// assert_eq!(drawn.hash, 0xd769_6c6d_8e31_2ad1);
/// ```
pub fn long_segments(count: usize, seed: u64) -> Drawn<[i64; 4]> {
    let mut source = Source::new(seed);
    let mut objects = Vec::with_capacity(count);
    while objects.len() < count {
        let ([x1, y1], [x2, y2]) = (source.point(), source.point());
        if [x1, y1] != [x2, y2] {
            source.accept(&[x1, y1, x2, y2]);
            objects.push([x1, y1, x2, y2]);
        }
    }
    source.drawn(objects)
}

/// Segments `[x1, y1, x2, y2]` from a random point by a step in `-2^(bits-1)..2^(bits-1)` in both directions, within the square.
///
/// A segment has as many crossings with four times as many segments and one bit less.
///
/// # Panics
/// If `bits` is not in `1..=21`: the wider the steps, the more are refused.
pub fn short_segments(count: usize, bits: u32, seed: u64) -> Drawn<[i64; 4]> {
    assert!((1..=COORDINATE_BITS + 1).contains(&bits), "steps of {bits} bits");
    let mut source = Source::new(seed);
    let mut objects = Vec::with_capacity(count);
    while objects.len() < count {
        let [x, y] = source.point();
        let [dx, dy] = [(); 2].map(|()| source.signed(bits));
        let end = [x + dx, y + dy];
        if [dx, dy] != [0, 0] && is_inside(end) {
            let segment = [x, y, end[0], end[1]];
            source.accept(&segment);
            objects.push(segment);
        }
    }
    source.drawn(objects)
}

/// Lines `[x1, y1, x2, y2]` through the end points of [`long_segments`]: the same numbers, and the same hash.
pub fn lines(count: usize, seed: u64) -> Drawn<[i64; 4]> {
    long_segments(count, seed)
}

/// A line, a ray, a segment, and so on, through the end points of [`long_segments`]: the same numbers, and the same hash.
pub fn mixed_curves(count: usize, seed: u64) -> Drawn<(LinearKind, [i64; 4])> {
    const KINDS: [LinearKind; 3] = [LinearKind::Line, LinearKind::Ray, LinearKind::Segment];
    let Drawn { objects, hash } = long_segments(count, seed);
    Drawn { objects: KINDS.into_iter().cycle().zip(objects).collect(), hash }
}

/// Random walks of [`POLYLINE_VERTICES`] vertices within the square; they may cross themselves.
///
/// A step that is zero or leaves the square is drawn again, without the steps before it.
pub fn polylines(count: usize, seed: u64) -> Drawn<Vec<[i64; 2]>> {
    let mut source = Source::new(seed);
    let mut walk = |_| {
        let mut last = source.point();
        source.accept(&last);
        let mut vertices = vec![last];
        while vertices.len() < POLYLINE_VERTICES {
            let [dx, dy] = [(); 2].map(|()| source.signed(STEP_BITS));
            let next = [last[0] + dx, last[1] + dy];
            if [dx, dy] != [0, 0] && is_inside(next) {
                source.accept(&next);
                vertices.push(next);
                last = next;
            }
        }
        vertices
    };
    let objects = (0..count).map(&mut walk).collect();
    source.drawn(objects)
}

/// Points of the square, some of them repeated if there are many.
pub fn query_points(count: usize, seed: u64) -> Drawn<[i64; 2]> {
    let mut source = Source::new(seed);
    let mut draw = |_| {
        let point = source.point();
        source.accept(&point);
        point
    };
    let objects = (0..count).map(&mut draw).collect();
    source.drawn(objects)
}

/// Arcs of great circles `[x1, y1, z1, x2, y2, z2]` between two random directions, which are neither equal nor opposite: the shorter arc.
///
/// ```
/// let drawn = splitstar_testkit::geodesic_arcs(100, 1);
/// assert_eq!(drawn.objects.len(), 100);
/// assert_eq!(drawn.hash, 0xc82f_1f6a_deab_5e08);
/// ```
pub fn geodesic_arcs(count: usize, seed: u64) -> Drawn<[i64; 6]> {
    let mut source = Source::new(seed);
    let mut objects = Vec::with_capacity(count);
    while objects.len() < count {
        let ([a, b, c], [d, e, f]) = (source.direction(), source.direction());
        if [b * f - c * e, c * d - a * f, a * e - b * d] != [0; 3] {
            let arc = [a, b, c, d, e, f];
            source.accept(&arc);
            objects.push(arc);
        }
    }
    source.drawn(objects)
}

/// Directions, some of them repeated if there are many.
pub fn query_directions(count: usize, seed: u64) -> Drawn<[i64; 3]> {
    let mut source = Source::new(seed);
    let mut draw = |_| {
        let direction = source.direction();
        source.accept(&direction);
        direction
    };
    let objects = (0..count).map(&mut draw).collect();
    source.drawn(objects)
}
