//! Location and vertical rays in coordinates: without predicates of the library.

use crate::agree::Answer;
use crate::curves::{P, fraction, rational};
use crate::oracle::{Cells, EdgeKey, LineKey, line_key};
use dcel::{EdgeId, FaceId, VertexId};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{SideKind, UMonotoneTraits};
use testkit::Rng;

/// The cells of an arrangement in the coordinates of the closed parameter space.
pub(crate) struct Rays {
    vertices: Vec<(VertexId, P)>,
    edges: Vec<Drawn>,
    /// What is added to a coordinate to come to the opposite side, if that is the same.
    periods: [Option<Rational>; 2],
    /// The vertices where curves end at the bottom and top, if these are contracted.
    poles: [Option<VertexId>; 2],
    /// The face of what is beside everything.
    outside: Option<FaceId>,
}

/// An edge: ends, `None` where it is unbounded, and its line.
struct Drawn {
    e: EdgeId,
    ends: [Option<P>; 2],
    line: LineKey,
    above: FaceId,
    below: FaceId,
}

/// A stretch of an edge beside a vertical line: where it comes to the line, and how it is inclined.
type Hit<'a> = ((Rational, Rational), &'a Drawn);

impl Drawn {
    fn height(&self, u: &Rational) -> Option<Rational> {
        let (slope, offset) = &self.line;
        slope.as_ref().map(|slope| slope * u + offset)
    }

    fn has_inside(&self, p: &P) -> bool {
        let [min, max] = &self.ends;
        let is_on_line = match self.height(&p[0]) {
            Some(v) => v == p[1],
            None => self.line.1 == p[0],
        };
        is_on_line && min.as_ref().is_none_or(|min| min < p) && max.as_ref().is_none_or(|max| p < max)
    }

    /// Where the line of one u is crossed, not in an end.
    fn crossed(&self, u: &Rational) -> Option<Rational> {
        let [min, max] = &self.ends;
        let is_within =
            min.as_ref().is_none_or(|min| min[0] < *u) && max.as_ref().is_none_or(|max| *u < max[0]);
        self.height(u).filter(|_| is_within)
    }
}

impl Rays {
    /// Of an arrangement whose edges have ends in a closed parameter space and are straight.
    pub(crate) fn new<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        size: [Rational; 2],
        ends: impl Fn(&G::UMonotoneCurve) -> [P; 2],
    ) -> Self {
        let sides = arrangement.topology().sides();
        let [width, height] = size;
        let periods = [sides.is_u_identified().then_some(width), sides.is_v_identified().then_some(height)];
        let key = |e| {
            let [min, max] = ends(&arrangement.make_edge_curve(e));
            let line = line_key(&min, &max);
            ([Some(min), Some(max)], line)
        };
        Self::of_keys(arrangement, key, periods, None)
    }

    /// Of an arrangement in the plane, of which brute force has found the edges.
    pub(crate) fn in_plane<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        cells: &Cells,
    ) -> Self {
        let key = |e| {
            let ends = arrangement.dcel().ends(e).map(|v| arrangement.point(v).map(Point2::coordinates));
            let curve = arrangement.make_edge_curve(e);
            let is_it = |key: &&EdgeKey| {
                let middle = Point2::from_rationals(&sample(key));
                key.0 == ends && arrangement.traits().is_on_curve(&middle, &curve)
            };
            cells.edges.iter().find(is_it).expect("brute force knows every edge").clone()
        };
        let are_bounded = cells.edges.iter().all(|(ends, _)| ends.iter().all(Option::is_some));
        let outside = are_bounded.then_some(arrangement.corner_face());
        Self::of_keys(arrangement, key, [const { None }; 2], outside)
    }

    fn of_keys<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        key: impl Fn(EdgeId) -> EdgeKey,
        periods: [Option<Rational>; 2],
        outside: Option<FaceId>,
    ) -> Self {
        let dcel = arrangement.dcel();
        let drawn = |e: EdgeId| {
            let (ends, line) = key(e);
            Drawn { e, ends, line, above: dcel.face(e.halfedge()), below: dcel.face(e.halfedge().twin()) }
        };
        let (kinds, vertices) = (arrangement.topology().sides().v, arrangement.topology().side_vertices());
        let pole = |side: usize| {
            let v = vertices[2 + side].map(VertexId).filter(|_| kinds[side] == SideKind::Contracted);
            v.filter(|&v| dcel.degree(v) > 0)
        };
        let coordinates = |v| Some((v, arrangement.point(v)?.coordinates()));
        Self {
            vertices: arrangement.vertices().filter_map(coordinates).collect(),
            edges: dcel.edges().map(drawn).collect(),
            periods,
            poles: [pole(0), pole(1)],
            outside: if dcel.edge_count() == 0 { Some(arrangement.corner_face()) } else { outside },
        }
    }

    /// The point with the coordinates of the left and bottom side.
    fn home(&self, p: &P) -> P {
        let home =
            |i: usize| if self.periods[i].as_ref() == Some(&p[i]) { Rational::ZERO } else { p[i].clone() };
        [home(0), home(1)]
    }

    /// The vertex or edge at a point.
    fn at(&self, p: &P) -> Option<Cell> {
        let vertex = self.vertices.iter().find(|(_, q)| p == q).map(|(v, _)| Cell::Vertex(*v));
        vertex.or_else(|| self.edges.iter().find(|edge| edge.has_inside(p)).map(|edge| Cell::Edge(edge.e)))
    }

    /// What crosses the line immediately to the right of a point, or to the left, and where.
    fn hits(&self, u: &Rational, is_right: bool) -> Vec<Hit<'_>> {
        let from_left = |edge: &Drawn| {
            let [min, max] = &edge.ends;
            let behind = |p: &P| if is_right { p[0] <= *u } else { p[0] < *u };
            let before = |p: &P| if is_right { *u < p[0] } else { *u <= p[0] };
            min.as_ref().is_none_or(behind) && max.as_ref().is_none_or(before)
        };
        let key = |edge: &Drawn| {
            let slope = edge.line.0.clone()?;
            Some((edge.height(u)?, if is_right { slope } else { -&slope }))
        };
        let edges = self.edges.iter().filter(|edge| from_left(edge));
        edges.filter_map(|edge| Some((key(edge)?, edge))).collect()
    }

    /// The face straight above or below a point, unless a vertical edge is there; `None` if too little is in its column.
    fn face_beside(&self, p: &P, is_up: bool) -> Option<FaceId> {
        let period = self.periods[0].clone().filter(|_| p[0] == Rational::ZERO);
        let on_right = period.unwrap_or_else(|| p[0].clone());
        for hits in [self.hits(&p[0], true), self.hits(&on_right, false)] {
            let is_below = |hit: &&Hit<'_>| if is_up { hit.0.0 <= p[1] } else { hit.0.0 < p[1] };
            let key = |hit: &&Hit<'_>| hit.0.clone();
            let below = hits.iter().filter(is_below).max_by_key(key);
            let round = || hits.iter().max_by_key(key).filter(|_| self.periods[1].is_some());
            let above = || hits.iter().filter(|hit| !is_below(hit)).min_by_key(key);
            let face = below.or_else(round).map(|(_, edge)| edge.above);
            if let Some(face) = face.or_else(|| above().map(|(_, edge)| edge.below)) {
                return Some(face);
            }
        }
        self.outside
    }

    fn locate(&self, p: &P) -> Option<Cell> {
        self.at(p).or_else(|| self.face_beside(p, true).map(Cell::Face))
    }

    fn shoot(&self, p: &P, is_up: bool) -> Option<Cell> {
        let leaves_along = |edge: &&Drawn| {
            let starts = edge.ends[usize::from(!is_up)].as_ref().is_some_and(|end| self.home(end) == *p);
            edge.line.0.is_none() && (starts || edge.has_inside(p))
        };
        if let Some(edge) = self.edges.iter().find(leaves_along) {
            return Some(Cell::Edge(edge.e));
        }
        let vertices =
            self.vertices.iter().filter(|(_, q)| q[0] == p[0]).map(|(v, q)| (q[1].clone(), Cell::Vertex(*v)));
        let edges = self.edges.iter().filter_map(|edge| Some((edge.crossed(&p[0])?, Cell::Edge(edge.e))));
        let mut met: Vec<(Rational, Cell)> = vertices.chain(edges).filter(|(v, _)| *v != p[1]).collect();
        met.sort();
        if !is_up {
            met.reverse();
        }
        if let Some((_, cell)) = met.iter().find(|(v, _)| (*v > p[1]) == is_up) {
            return Some(*cell);
        }
        if self.periods[1].is_some() {
            return met.first().map(|(_, cell)| *cell).or_else(|| self.locate(p));
        }
        self.poles[usize::from(is_up)]
            .map(Cell::Vertex)
            .or_else(|| self.face_beside(p, is_up).map(Cell::Face))
    }

    /// Compares answers with its own, as far as it knows them; tells how many.
    pub(crate) fn check(&self, points: &[Point2], answers: &[Answer], context: &str) -> usize {
        let mut known = 0;
        for (point, found) in points.iter().zip(answers) {
            let p = point.coordinates();
            let expected = [self.locate(&p), self.shoot(&p, true), self.shoot(&p, false)];
            for (expected, found) in expected.into_iter().zip(found) {
                if let Some(expected) = expected {
                    assert_eq!(*found, expected, "at {point}, {:?}, {context}", answers);
                    known += 1;
                }
            }
        }
        known
    }

    /// Points of all kinds: vertices, points of edges, points straight above and below these, others on a grid, and some far outside.
    pub(crate) fn points(&self, rng: &mut Rng, most: usize) -> Vec<P> {
        let mut all: Vec<P> = self.vertices.iter().map(|(_, p)| p.clone()).collect();
        all.extend(self.edges.iter().map(|edge| sample(&(edge.ends.clone(), edge.line.clone()))));
        rng.shuffle(&mut all);
        all.truncate(most);
        let cells = all.len();
        for _ in 0..most {
            let grid = [0; 2].map(|_| fraction(rng.below(17) as i64 - 2, *rng.choose(&[1, 1, 2, 3])));
            if cells == 0 {
                all.push(grid);
                continue;
            }
            let [p, q] = [0; 2].map(|_| all[rng.index(cells)].clone());
            all.push(match rng.index(6) {
                0 => grid,
                1 => [p[0].clone(), grid[1].clone()],
                2 => [grid[0].clone(), p[1].clone()],
                3 => [p[0].clone(), (&p[1] + &q[1]) * fraction(1, 2)],
                4 => [rational(1000 * rng.within(1)), &p[1] + rational(rng.within(1000))],
                _ => [0, 1].map(|i| &p[i] + (&q[i] - &p[i]) * fraction(1, 3)),
            });
        }
        all
    }
}

/// A point of an edge, not an end of it.
fn sample(([min, max], (slope, offset)): &EdgeKey) -> P {
    let step = match slope {
        Some(slope) => [Rational::ONE, slope.clone()],
        None => [Rational::ZERO, Rational::ONE],
    };
    match (min, max) {
        (Some(min), Some(max)) => [0, 1].map(|i| (&min[i] + &max[i]) * fraction(1, 2)),
        (Some(min), None) => [0, 1].map(|i| &min[i] + &step[i]),
        (None, Some(max)) => [0, 1].map(|i| &max[i] - &step[i]),
        (None, None) => match slope {
            Some(_) => [Rational::ZERO, offset.clone()],
            None => [offset.clone(), Rational::ZERO],
        },
    }
}
