//! Arcs, circles and points of the sphere, cut along the edges of the cube.

use arrangement::Pieces;
use arrangement::models::{Geodesic, GeodesicError, Segment, SegmentTraits};
use exact::gnomonic::{CubeSide, Exit, SideSet};
use exact::planar::{Point2, compare_xy};
use exact::spherical::{Direction, GreatCircle, crossing_side, side_of_circle};
use exact::{Sign, gnomonic};

/// What comes to one side of the cube.
#[derive(Clone, Debug)]
pub(crate) struct SidePieces {
    /// Segments; points of their own, and ends of arcs on edges of the cube.
    pub(crate) pieces: Pieces<SegmentTraits>,
    /// For each segment, the number of its arc.
    pub(crate) arcs: Vec<u32>,
    /// For each segment, its ends among the places: the source and the target.
    pub(crate) ends: Vec<[u32; 2]>,
    /// The four corners, ends of arcs, and where arcs pass over the border. Where arcs do not meet but in common ends, each is there once.
    pub(crate) places: Vec<Point2>,
    /// The places between the corners on each edge of the square, in the order of [`border_of`], unsorted.
    pub(crate) on_border: [Vec<u32>; 4],
    /// Those of the points and of the ends of arcs that are on the border.
    pub(crate) given: Vec<u32>,
    /// What arcs cover of the border, in the order of [`border_of`]: ends in lexicographic order.
    pub(crate) covered: [Vec<[u32; 2]>; 4],
}

impl Default for SidePieces {
    fn default() -> Self {
        Self {
            pieces: Pieces::new(),
            arcs: Vec::new(),
            ends: Vec::new(),
            places: [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(Point2::from_i64).to_vec(),
            on_border: Default::default(),
            given: Vec::new(),
            covered: Default::default(),
        }
    }
}

impl SidePieces {
    fn add_place(&mut self, place: Point2) -> u32 {
        self.places.push(place);
        u32::try_from(self.places.len() - 1).expect("fewer than 2^32 places")
    }

    fn add_border_place(&mut self, border: usize, place: Point2) -> u32 {
        let number = self.add_place(place);
        self.on_border[border].push(number);
        number
    }
}

/// The places of the corners at the ends of an edge of a square, the lesser one first.
pub(crate) const CORNERS_OF_BORDER: [[u32; 2]; 4] = [[0, 1], [2, 3], [0, 2], [1, 3]];

/// The place of a corner of the cube on a side. The corner lies on these sides.
fn corner_on(side: CubeSide, sides: SideSet) -> u32 {
    let [u, v] = side.axes().map(|axis| u32::from(sides.contains(CubeSide::new(axis, true))));
    2 * u + v
}

/// The four edges of the square: u = -1, u = 1, v = -1, v = 1.
pub(crate) fn border_of(side: CubeSide, other: CubeSide) -> usize {
    let [u, _] = side.axes();
    2 * usize::from(other.axis() != u) + usize::from(other.is_positive())
}

/// The side behind one of the four edges of a square.
pub(crate) fn side_behind(side: CubeSide, border: usize) -> CubeSide {
    CubeSide::new(side.axes()[border / 2], border % 2 == 1)
}

/// Geodesic arcs, great circles and points, cut into segments and points of the sides of the cube.
///
/// Arcs are numbered in the order in which they come; circles are arcs, too.
///
/// Degenerate: an arc along an edge of the cube is put into both sides, a point on an edge into two, one at a corner into three. Arcs may cross and overlap.
///
/// ```
/// use arrangement::models::Geodesic;
/// use exact::spherical::Direction;
/// use splitstar_cubical::{CubicalArrangement, CubicalPieces};
/// let [p, q] = [[2, 1, 0], [1, 3, 0]].map(|p| Direction::from_i64(p).expect("not zero"));
/// let mut pieces = CubicalPieces::new();
/// pieces.push_geodesic(&Geodesic::arc(p, q)?);
/// let counts = CubicalArrangement::of_pieces(pieces).counts();
/// assert_eq!((counts.vertices, counts.edges, counts.faces), (2, 1, 1));
/// # Ok::<(), arrangement::models::GeodesicError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct CubicalPieces {
    pub(crate) sides: [SidePieces; 6],
    arc_count: u32,
    ends: Vec<End>,
    /// The places of all ends on their sides.
    places: Vec<u32>,
}

/// Names an end of arcs: see [`CubicalPieces::add_end`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ArcEnd(u32);

/// An end of arcs.
#[derive(Clone, Debug)]
struct End {
    direction: Direction,
    sides: SideSet,
    /// Where its places begin, one for each side.
    first_place: usize,
}

/// Where an arc runs on: across a side, or along the edge between two.
#[derive(Clone, Copy)]
enum Way {
    Across(CubeSide),
    Along([CubeSide; 2]),
}

impl CubicalPieces {
    /// Makes what has no arc and no point.
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes what has no arc and no point, with room for about so many ends and arcs between them.
    pub fn with_capacity(ends: usize, arcs: usize) -> Self {
        let mut made = Self::new();
        made.ends.reserve(ends);
        made.places.reserve(ends);
        for side in &mut made.sides {
            // A little more than a sixth, because arcs are cut.
            let segments = arcs / 4;
            side.pieces.reserve(segments);
            side.arcs.reserve(segments);
            side.ends.reserve(segments);
            side.places.reserve(ends / 4);
        }
        made
    }

    /// The number of arcs and circles.
    pub fn arc_count(&self) -> usize {
        self.arc_count as usize
    }

    /// Appends an arc, a circle or a point.
    ///
    /// # Complexity
    /// An arc makes up to seven segments: a circle passes through up to six sides, and an arc may end on the side on which it begins.
    pub fn push_geodesic(&mut self, geodesic: &Geodesic) {
        match (geodesic.as_point(), geodesic.great_circle(), geodesic.source(), geodesic.target()) {
            (Some(point), ..) => self.push_point(point),
            (_, Some(circle), Some(source), Some(target)) => {
                self.push_arc(circle, source, target).expect("a geodesic ends on its own circle");
            }
            (_, Some(circle), ..) => self.push_circle(circle),
            (_, None, ..) => unreachable!("what is no point has a circle"),
        }
    }

    /// Appends a point. Where it lies on no arc, it becomes an isolated vertex.
    pub fn push_point(&mut self, point: &Direction) {
        let sides = CubeSide::of(point);
        for side in sides {
            let number = self.add_place(side, sides, point);
            let pieces = &mut self.sides[side.index()];
            pieces.pieces.push_point(pieces.places[number as usize].clone());
        }
    }

    /// Adds the place of a point that lies on these sides to one of them.
    fn add_place(&mut self, side: CubeSide, sides: SideSet, point: &Direction) -> u32 {
        let pieces = &mut self.sides[side.index()];
        let number = match sides.count_sides() {
            1 => return pieces.add_place(point_on(side, point)),
            2 => {
                let other = sides.into_iter().find(|&other| other != side).expect("there are two");
                pieces.add_border_place(border_of(side, other), point_on(side, point))
            }
            _ => corner_on(side, sides),
        };
        pieces.given.push(number);
        number
    }

    /// Adds an end for arcs to come, and projects it to its sides: once, for any number of arcs.
    ///
    /// Degenerate: an end of no arc is a vertex if it lies on an edge of the cube, and nothing if not.
    pub fn add_end(&mut self, direction: &Direction) -> ArcEnd {
        let (sides, first_place) = (CubeSide::of(direction), self.places.len());
        for side in sides {
            let number = self.add_place(side, sides, direction);
            if sides.count_sides() > 1 {
                let pieces = &mut self.sides[side.index()];
                pieces.pieces.push_point(pieces.places[number as usize].clone());
            }
            self.places.push(number);
        }
        let end = ArcEnd(u32::try_from(self.ends.len()).expect("fewer than 2^32 ends"));
        self.ends.push(End { direction: direction.clone(), sides, first_place });
        end
    }

    /// The place of an end on one of its sides.
    fn place_of(&self, ArcEnd(end): ArcEnd, side: CubeSide) -> u32 {
        let End { sides, first_place, .. } = &self.ends[end as usize];
        let before = sides.take_while(|&other| other != side).count();
        self.places[first_place + before]
    }

    /// Where a walk is, as a place of a side.
    fn place_at(&self, stand: Stand, side: CubeSide) -> u32 {
        match stand {
            Stand::End(end) => self.place_of(end, side),
            Stand::Corner(sides) => corner_on(side, sides),
            Stand::Entered(place) => place,
        }
    }

    /// Adds the place where an arc passes from one side to another, to both.
    fn add_passage(&mut self, from: CubeSide, to: CubeSide, [here, there]: [Point2; 2]) -> [u32; 2] {
        let here = self.sides[from.index()].add_border_place(border_of(from, to), here);
        let there = self.sides[to.index()].add_border_place(border_of(to, from), there);
        [here, there]
    }

    /// Appends a whole great circle. It has no vertex of its own.
    pub fn push_circle(&mut self, circle: &GreatCircle) {
        // It passes through the inside of any side to whose axis its normal is orthogonal. If there is none, then of any but one
        // along whose axis the normal has its greatest coordinate.
        let far = CubeSide::of(&circle.pole()).first().axis();
        let axis = (0..3).find(|&axis| circle.sign(axis).is_zero()).unwrap_or((far + 1) % 3);
        let first = CubeSide::new(axis, true);
        match first.exit(circle).expect("the circle passes through the side") {
            Exit::Edge { to, here, there } => {
                let [_, there] = self.add_passage(first, to, [here, there]);
                self.walk(circle, Way::Across(to), Stand::Entered(there), Stop::AfterSide(first));
            }
            Exit::Corner(corner) => {
                let sides = CubeSide::of(&corner);
                let way = entered(circle, &corner, sides);
                self.walk(circle, way, Stand::Corner(sides), Stop::AfterSide(first));
            }
        }
        self.arc_count += 1;
    }

    /// Appends the arc of a circle from one point to another, in the sense of the circle; the whole circle, with a vertex, if they are equal.
    ///
    /// # Errors
    /// [`GeodesicError::NotOnCircle`] if one of the points is not on the circle. Then nothing is appended.
    ///
    /// ```
    /// use arrangement::models::GeodesicError;
    /// use exact::spherical::{Direction, GreatCircle};
    /// use splitstar_cubical::CubicalPieces;
    /// let equator = GreatCircle::from_i64([0, 0, 1]).expect("not zero");
    /// let [p, q, pole] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| Direction::from_i64(p).expect("not zero"));
    /// let mut pieces = CubicalPieces::new();
    /// assert_eq!(pieces.push_arc(&equator, &p, &q), Ok(()));
    /// assert_eq!(pieces.push_arc(&equator, &p, &pole), Err(GeodesicError::NotOnCircle));
    /// assert_eq!(pieces.arc_count(), 1);
    /// ```
    pub fn push_arc(
        &mut self,
        circle: &GreatCircle,
        source: &Direction,
        target: &Direction,
    ) -> Result<(), GeodesicError> {
        if [source, target].iter().any(|end| !side_of_circle(end, circle).is_zero()) {
            return Err(GeodesicError::NotOnCircle);
        }
        let [source, target] = [source, target].map(|end| self.add_end(end));
        self.append_arc(circle, source, target);
        Ok(())
    }

    /// Appends the arc of a circle from one end to another, as [`CubicalPieces::push_arc`] does.
    ///
    /// # Panics
    /// If an end is not on the circle, or is one of other pieces that is not there.
    pub fn push_arc_between(&mut self, circle: &GreatCircle, source: ArcEnd, target: ArcEnd) {
        let is_on_circle =
            |end: &ArcEnd| side_of_circle(&self.ends[end.0 as usize].direction, circle).is_zero();
        assert!([source, target].iter().all(is_on_circle), "both ends of an arc lie on its circle");
        self.append_arc(circle, source, target);
    }

    /// Appends an arc whose ends are known to be on its circle.
    fn append_arc(&mut self, circle: &GreatCircle, source: ArcEnd, target: ArcEnd) {
        let End { direction, sides, .. } = &self.ends[source.0 as usize];
        let way = entered(circle, direction, *sides);
        self.walk(circle, way, Stand::End(source), Stop::At(target));
        self.arc_count += 1;
    }

    /// Follows a circle from a point of the first side of a way, up to a place on the circle.
    fn walk(&mut self, circle: &GreatCircle, mut way: Way, mut stand: Stand, stop: Stop) {
        // A circle runs through six sides at most, and once more through the first one if it stops behind its begin.
        for step in 0..7 {
            let side = way.first();
            let here = self.place_at(stand, side);
            let end = self.end_on(stop, way).filter(|&end| {
                let places = &self.sides[side.index()].places;
                step > 0 || is_ahead(circle, side, &places[here as usize], &places[end as usize])
            });
            match way {
                Way::Across(side) => {
                    if let Some(end) = end {
                        return self.push_segment(side, circle, [here, end]);
                    }
                    let is_last = matches!(stop, Stop::AfterSide(last) if last == side);
                    match side.exit(circle).expect("the circle passes through the side") {
                        Exit::Edge { to, here: place, there } => {
                            let [place, there] = self.add_passage(side, to, [place, there]);
                            self.push_segment(side, circle, [here, place]);
                            (way, stand) = (Way::Across(to), Stand::Entered(there));
                        }
                        Exit::Corner(corner) => {
                            let sides = CubeSide::of(&corner);
                            self.push_segment(side, circle, [here, corner_on(side, sides)]);
                            (way, stand) = (entered(circle, &corner, sides), Stand::Corner(sides));
                        }
                    }
                    if is_last {
                        return;
                    }
                }
                Way::Along([side, other]) => {
                    let corner = corner_ahead(circle, side, other);
                    let sides = CubeSide::of(&corner);
                    let target = match stop {
                        Stop::At(target) if end.is_some() => Stand::End(target),
                        _ => Stand::Corner(sides),
                    };
                    for [own, behind] in [[side, other], [other, side]] {
                        let [source, target] = [stand, target].map(|at| self.place_at(at, own));
                        self.cover(own, border_of(own, behind), [source, target]);
                        self.push_segment(own, circle, [source, target]);
                    }
                    if end.is_some() {
                        return;
                    }
                    (way, stand) = (entered(circle, &corner, sides), Stand::Corner(sides));
                }
            }
        }
        panic!("a walk around a circle comes to every place on it within seven segments");
    }

    /// The place at which a walk is to stop, if it lies on the way.
    fn end_on(&self, stop: Stop, way: Way) -> Option<u32> {
        let Stop::At(target) = stop else { return None };
        let sides = self.ends[target.0 as usize].sides;
        let is_on_way = match way {
            Way::Across(side) => sides.contains(side),
            Way::Along(both) => both.iter().all(|&side| sides.contains(side)),
        };
        is_on_way.then(|| self.place_of(target, way.first()))
    }

    /// Notes that an arc covers a part of the border.
    fn cover(&mut self, side: CubeSide, border: usize, [source, target]: [u32; 2]) {
        let pieces = &mut self.sides[side.index()];
        let is_less = compare_xy(&pieces.places[source as usize], &pieces.places[target as usize]).is_lt();
        pieces.covered[border].push(if is_less { [source, target] } else { [target, source] });
    }

    fn push_segment(&mut self, side: CubeSide, circle: &GreatCircle, ends: [u32; 2]) {
        let line = side.line_of(circle).expect("the circle passes through the side");
        let pieces = &mut self.sides[side.index()];
        let [source, target] = ends.map(|end| pieces.places[end as usize].clone());
        let segment = Segment::on_line(line, source, target).expect("a circle has a way through a side");
        pieces.pieces.push_curve(segment);
        pieces.ends.push(ends);
        pieces.arcs.push(self.arc_count);
    }
}

/// Where a walk is.
#[derive(Clone, Copy)]
enum Stand {
    End(ArcEnd),
    /// At the corner of these sides.
    Corner(SideSet),
    /// At this place of the side that was entered.
    Entered(u32),
}

/// Where a walk stops.
#[derive(Clone, Copy)]
enum Stop {
    /// At an end.
    At(ArcEnd),
    /// Where it leaves a side.
    AfterSide(CubeSide),
}

impl Way {
    fn first(self) -> CubeSide {
        match self {
            Self::Across(side) | Self::Along([side, _]) => side,
        }
    }
}

fn point_on(side: CubeSide, p: &Direction) -> Point2 {
    side.point_of(p).expect("the point lies on the side")
}

/// Tells whether a circle comes to `end` after `here`, on one side.
fn is_ahead(circle: &GreatCircle, side: CubeSide, here: &Point2, end: &Point2) -> bool {
    let [u, v] = side.axes();
    // It runs in the direction (n_v, -n_u), because the side faces outwards.
    let is_to_right = match circle.sign(v) {
        Sign::Zero => circle.sign(u).is_negative(),
        sign => sign.is_positive(),
    };
    let order = compare_xy(here, end);
    if is_to_right { order.is_lt() } else { order.is_gt() }
}

/// The way on which a circle leaves one of its points, which lies on these sides.
fn entered(circle: &GreatCircle, p: &Direction, mut sides: SideSet) -> Way {
    let first = sides.next().expect("a direction lies on a side");
    sides.fold(Way::Across(first), |way, side| {
        // Along a circle, what grows faster at p is greater for the next half turn.
        match crossing_side(circle, &gnomonic::diagonal(way.first(), side), p) {
            Sign::Negative => way,
            Sign::Positive => Way::Across(side),
            Sign::Zero => Way::Along([way.first(), side]),
        }
    })
}

/// The end of the edge between two sides to which a circle runs that passes along it.
fn corner_ahead(circle: &GreatCircle, side: CubeSide, other: CubeSide) -> Direction {
    let free = 3 - side.axis() - other.axis();
    let [a, b] = [(free + 1) % 3, (free + 2) % 3];
    let of_b = if side.axis() == b { side } else { other };
    let mut corner = [0; 3];
    for known in [side, other] {
        corner[known.axis()] = if known.is_positive() { 1 } else { -1 };
    }
    // The normal is n_a (e_a - s e_b) for a sign s; what it makes with the edge grows along the free axis by 2 n_a p_b.
    let grows = circle.sign(a) * of_b.sign();
    corner[free] = if grows.is_positive() { 1 } else { -1 };
    Direction::from_i64(corner).expect("not zero")
}
