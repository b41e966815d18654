//! What the cells on a flat torus are, found by brute force in the universal cover.

use crate::curves::{P, rational};
use crate::oracle::{Components, cross, minus};
use exact::{Rational, Sign};
use splitstar_arrangement::Counts;
use std::collections::{BTreeMap, BTreeSet};

/// A curve on a torus.
#[derive(Clone, Debug)]
pub(crate) enum TorusCurve {
    Point(P),
    /// From a point by a vector.
    Path(P, P),
    /// The closed geodesic through a point that winds so often.
    Closed(P, [i64; 2]),
}

/// A path in the cover.
struct Track {
    start: P,
    step: P,
    is_closed: bool,
}

pub(crate) struct TorusCells {
    pub(crate) counts: Counts,
    /// The vertices that are not only there because a closed curve has none.
    pub(crate) vertices: BTreeSet<P>,
}

fn floor(value: &Rational, period: &Rational) -> Rational {
    Rational::from(value.checked_div(period).expect("a period is positive").floor())
}

/// Takes the periods off, and tells how many.
pub(crate) fn reduce(p: &P, period: &P) -> (P, P) {
    let turns = [0, 1].map(|i| floor(&p[i], &period[i]));
    ([0, 1].map(|i| &p[i] - &turns[i] * &period[i]), turns)
}

impl Track {
    fn new(curve: &TorusCurve, period: &P) -> Self {
        let (start, step, is_closed) = match curve {
            TorusCurve::Point(p) => (p, at_zero(), false),
            TorusCurve::Path(p, step) => (p, step.clone(), false),
            TorusCurve::Closed(p, winding) => (p, [0, 1].map(|i| rational(winding[i]) * &period[i]), true),
        };
        Self { start: reduce(start, period).0, step, is_closed }
    }

    /// Points between the vertices on the track.
    fn middles(&self, vertices: &BTreeSet<P>, period: &P) -> Vec<P> {
        let mut times: BTreeSet<Rational> = vertices.iter().flat_map(|v| self.times(v, period)).collect();
        times.extend([Rational::ZERO, Rational::ONE]);
        let times: Vec<Rational> = times.into_iter().collect();
        let half = rational(2).recip().expect("2 is not zero");
        let middle = |pair: &[Rational]| reduce(&self.at(&((&pair[0] + &pair[1]) * &half)), period).0;
        times.windows(2).map(middle).collect()
    }

    fn at(&self, time: &Rational) -> P {
        [0, 1].map(|i| &self.start[i] + &self.step[i] * time)
    }

    /// Copies of the rectangle that the track may touch, by their numbers.
    fn copies(&self, period: &P) -> Vec<[Rational; 2]> {
        let end = self.at(&Rational::ONE);
        let range = |i: usize| {
            let (low, high) =
                if self.start[i] < end[i] { (&self.start[i], &end[i]) } else { (&end[i], &self.start[i]) };
            let mut turns = floor(low, &period[i]) - Rational::ONE;
            let last = floor(high, &period[i]) + Rational::ONE;
            let mut all = Vec::new();
            while turns <= last {
                all.push(turns.clone());
                turns += Rational::ONE;
            }
            all
        };
        let (us, vs) = (range(0), range(1));
        us.iter().flat_map(|u| vs.iter().map(move |v| [u.clone(), v.clone()])).collect()
    }

    /// The times at which the track is at a point of the torus.
    fn times(&self, p: &P, period: &P) -> BTreeSet<Rational> {
        let square = &self.step[0] * &self.step[0] + &self.step[1] * &self.step[1];
        let copies = self.copies(period).into_iter().filter_map(|[u, v]| {
            let to_p = minus(&[&p[0] + u * &period[0], &p[1] + v * &period[1]], &self.start);
            let along = &self.step[0] * &to_p[0] + &self.step[1] * &to_p[1];
            let time = along.checked_div(&square)?;
            let is_on = cross(&self.step, &to_p).is_zero() && time.sign() != Sign::Negative;
            let is_before_end = if self.is_closed { time < Rational::ONE } else { time <= Rational::ONE };
            (is_on && is_before_end).then_some(time)
        });
        copies.collect()
    }

    /// The points of the torus where two tracks cross.
    fn crossings(&self, other: &Self, period: &P) -> Vec<P> {
        let Some(inverse) = cross(&self.step, &other.step).recip() else { return Vec::new() };
        let is_time = |t: &Rational| t.sign() != Sign::Negative && *t <= Rational::ONE;
        let (mine, others) = (self.copies(period), other.copies(period));
        let shifts: BTreeSet<[Rational; 2]> =
            mine.iter().flat_map(|a| others.iter().map(move |b| minus(a, b))).collect();
        let meet = shifts.into_iter().filter_map(|[u, v]| {
            let start = [&other.start[0] + u * &period[0], &other.start[1] + v * &period[1]];
            let between = minus(&start, &self.start);
            let time = cross(&between, &other.step) * &inverse;
            let other_time = cross(&between, &self.step) * &inverse;
            (is_time(&time) && is_time(&other_time)).then(|| reduce(&self.at(&time), period).0)
        });
        meet.collect()
    }
}

/// The points that curves have in common, as `intersections` says it, and whether any two meet. One that moves by nothing is a point.
pub(crate) fn meetings(curves: &[TorusCurve], period: &P, do_ends_count: bool) -> (Vec<P>, bool) {
    let cells = brute_force(curves, period);
    let tracks: Vec<Track> = curves.iter().map(|curve| Track::new(curve, period)).collect();
    let is_point = |track: &Track| track.step == at_zero();
    let is_on = |track: &Track, p: &P| match is_point(track) {
        true => track.start == *p,
        false => !track.times(p, period).is_empty(),
    };
    let is_end = |track: &Track, p: &P| {
        is_on(track, p)
            && (is_point(track)
                || !track.is_closed
                    && (track.start == *p || reduce(&track.at(&Rational::ONE), period).0 == *p))
    };
    let are_parallel = |a: &Track, b: &Track| cross(&a.step, &b.step).is_zero();
    let is_common = |p: &P| {
        let through = tracks.iter().filter(|track| is_on(track, p)).count();
        let ending = tracks.iter().filter(|track| is_end(track, p)).count();
        through > 1 && (do_ends_count || ending < through)
    };
    let is_given = |p: &&P| {
        let through: Vec<&Track> = tracks.iter().filter(|track| is_on(track, p)).collect();
        // Curves that are not parallel, or one that crosses itself, are not met: straight curves through one point do not turn.
        let do_coincide = through.iter().all(|track| !is_end(track, p) && are_parallel(track, through[0]));
        is_common(p) && !do_coincide
    };
    // Curves that run together do so at the middle of an edge, or all along a closed geodesic.
    let overlap = tracks.iter().enumerate().any(|(i, a)| {
        tracks[..i].iter().any(|b| {
            let is_shared = |p: &P| is_on(a, p) && is_on(b, p);
            !is_point(a)
                && !is_point(b)
                && are_parallel(a, b)
                && a.middles(&cells.vertices, period).iter().any(is_shared)
        })
    });
    let given = cells.vertices.iter().filter(is_given).cloned().collect();
    (given, overlap || cells.vertices.iter().any(is_common))
}

/// Finds the cells of an arrangement on a torus.
///
/// Faces are counted by homology: there is one, one more for each independent cycle of the graph, and one less for each independent
/// way in which cycles go round the torus.
pub(crate) fn brute_force(curves: &[TorusCurve], period: &P) -> TorusCells {
    let mut vertices = BTreeSet::new();
    let mut tracks = Vec::new();
    for curve in curves {
        let track = Track::new(curve, period);
        let is_point = track.step == at_zero();
        if is_point || !track.is_closed {
            vertices.insert(track.start.clone());
            vertices.insert(reduce(&track.at(&Rational::ONE), period).0);
        }
        if !is_point {
            tracks.push(track);
        }
    }
    for (i, a) in tracks.iter().enumerate() {
        for b in &tracks[..=i] {
            vertices.extend(a.crossings(b, period));
        }
    }
    let numbers: BTreeMap<&P, usize> = vertices.iter().zip(0..).collect();
    // Ends, and how often the edge goes round from the first to the second; by middle and vector, as edges that overlap are one.
    let mut edges: BTreeMap<(P, P), ([usize; 2], P)> = BTreeMap::new();
    let mut circles: BTreeMap<(P, Rational), P> = BTreeMap::new();
    for track in &tracks {
        let mut times: BTreeSet<Rational> = BTreeSet::new();
        for v in &vertices {
            times.extend(track.times(v, period));
        }
        let mut times: Vec<Rational> = times.into_iter().collect();
        match times.first().cloned() {
            None => {
                let (key, winding) = circle(track, period);
                circles.insert(key, winding);
            }
            Some(first) if track.is_closed => times.push(first + Rational::ONE),
            Some(_) => {}
        }
        for pair in times.windows(2) {
            let ends = [0, 1].map(|i| track.at(&pair[i]));
            let mut step = minus(&ends[1], &ends[0]);
            if step < at_zero() {
                step = minus(&at_zero(), &step);
            }
            let half = rational(2).recip().expect("2 is not zero");
            let middle = [0, 1].map(|i| (&ends[0][i] + &ends[1][i]) * &half);
            let [(a, turns_a), (b, turns_b)] = ends.each_ref().map(|end| reduce(end, period));
            let edge = ([numbers[&a], numbers[&b]], minus(&turns_b, &turns_a));
            edges.insert((reduce(&middle, period).0, step), edge);
        }
    }
    let counts = count(
        vertices.len(),
        &edges.into_values().collect::<Vec<_>>(),
        &circles.into_values().collect::<Vec<_>>(),
    );
    TorusCells { counts, vertices }
}

fn at_zero() -> P {
    [Rational::ZERO, Rational::ZERO]
}

/// What is the same of all tracks along one closed geodesic: how it winds, and where it meets an axis.
fn circle(track: &Track, period: &P) -> ((P, Rational), P) {
    let turns = [0, 1].map(|i| track.step[i].checked_div(&period[i]).expect("a period is positive"));
    let [p, q] = turns.each_ref().map(|t| t.numerator());
    let divisor = Rational::from(p.gcd(&q));
    let mut winding = turns.map(|t| t.checked_div(&divisor).expect("a closed track moves"));
    if winding < at_zero() {
        winding = minus(&at_zero(), &winding);
    }
    let place = [0, 1].map(|i| track.start[i].checked_div(&period[i]).expect("a period is positive"));
    let offset = cross(&place, &winding);
    let fraction = &offset - Rational::from(offset.floor());
    ((winding.clone(), fraction), winding)
}

fn count(vertices: usize, edges: &[([usize; 2], P)], circles: &[P]) -> Counts {
    let mut components = Components::new(vertices);
    let mut places: Vec<Option<P>> = vec![None; vertices];
    let mut is_isolated = vec![true; vertices];
    let mut windings: Vec<P> = circles.to_vec();
    for ([a, b], _) in edges {
        components.join(*a, *b);
        is_isolated[*a] = false;
        is_isolated[*b] = false;
    }
    // Where each vertex is in the cover, if one goes there along a tree; an edge that disagrees closes a cycle that goes round.
    for seed in 0..vertices {
        if places[seed].is_some() {
            continue;
        }
        places[seed] = Some(at_zero());
        let mut stack = vec![seed];
        while let Some(v) = stack.pop() {
            let here = places[v].clone().expect("a vertex on the stack has its place");
            for ([a, b], turns) in edges {
                let there = [0, 1].map(|i| &here[i] + &turns[i]);
                let back = minus(&here, turns);
                for (from, to, place) in [(*a, *b, there), (*b, *a, back)] {
                    if from != v {
                        continue;
                    }
                    match &places[to] {
                        None => {
                            places[to] = Some(place);
                            stack.push(to);
                        }
                        Some(known) => windings.push(minus(known, &place)),
                    }
                }
            }
        }
    }
    let first = windings.iter().find(|w| **w != at_zero());
    let rank = first.map_or(0, |first| 1 + usize::from(windings.iter().any(|w| !cross(first, w).is_zero())));
    let [v, e, c] = [vertices, edges.len(), components.count].map(|n| n + circles.len());
    Counts {
        vertices: v,
        edges: e,
        faces: 1 + e + c - v - rank,
        isolated: is_isolated.iter().filter(|&&is| is).count(),
        components: c,
    }
}
