//! Ways along arcs through the cells that brute force found: location, rays and zones.

use crate::arcs::{Arc, Curve};
use crate::graph::{Graph, Place};
use crate::random::random_point;
use crate::space::{P, compare_way, cross, is_zero, north, opposite, orthogonal, primitive, turn};
use exact::Sign;
use std::collections::BTreeSet;
use testkit::Rng;

/// Where an arc meets an edge or a vertex.
struct Hit {
    at: P,
    place: Place,
}

/// What is next to a place in some direction: an edge, or what has the number of a face.
enum Beside {
    Edge(usize),
    Face(usize),
}

impl Graph {
    /// The vertices that an arc meets and the edges that it crosses, in their order.
    fn hits(&self, arc: &Arc) -> Vec<Hit> {
        let on_arc = self.vertices.iter().enumerate().filter(|(_, p)| arc.has(p));
        let mut hits: Vec<Hit> =
            on_arc.map(|(v, p)| Hit { at: p.clone(), place: Place::Vertex(v) }).collect();
        for (e, edge) in self.edges.iter().enumerate() {
            let inside = arc.crossings(edge).into_iter().filter(|p| edge.has_inside(p));
            hits.extend(inside.map(|at| Hit { at, place: Place::Edge(e) }));
        }
        hits.sort_by(|a, b| arc.compare(&a.at, &b.at));
        hits
    }

    /// What comes after a hit in a direction: an edge, a boundary, or an isolated vertex.
    fn beside(&self, hit: &Hit, way: &P) -> Beside {
        match hit.place {
            Place::Vertex(v) => {
                let Some(&first) = self.around[v].first() else { return Beside::Face(self.isolated[&v]) };
                let start = self.tangent(first);
                let compare = |dart: usize| compare_way(&hit.at, &start, &self.tangent(dart), way);
                let before = self.around[v].iter().rev().find(|&&dart| compare(dart).is_le());
                let &before = before.expect("the first is where the turn begins");
                if compare(before).is_eq() {
                    Beside::Edge(before / 2)
                } else {
                    Beside::Face(self.boundaries[before])
                }
            }
            Place::Edge(e) => match turn(&hit.at, &self.edges[e].forward(&hit.at), way) {
                Sign::Positive => Beside::Face(self.boundaries[2 * e]),
                Sign::Zero => Beside::Edge(e),
                Sign::Negative => Beside::Face(self.boundaries[2 * e + 1]),
            },
            Place::Face(_) => unreachable!("a face is not hit"),
        }
    }

    fn place_beside(&self, hit: &Hit, way: &P) -> Place {
        match self.beside(hit, way) {
            Beside::Edge(e) => Place::Edge(e),
            Beside::Face(boundary) => Place::Face(self.faces[boundary]),
        }
    }

    /// An arc from one vertex to another.
    pub(crate) fn arc_between(&self, v: usize, w: usize) -> Arc {
        arc_between(&self.vertices[v], &self.vertices[w])
    }

    /// Boundaries, or isolated vertices, that are of one face because an arc goes from one to the other.
    pub(crate) fn faces_along(&self, arc: &Arc) -> Vec<[usize; 2]> {
        let hits = self.hits(arc);
        let pairs = hits.windows(2).filter_map(|pair| {
            let after = self.beside(&pair[0], &arc.forward(&pair[0].at));
            let before = self.beside(&pair[1], &opposite(&arc.forward(&pair[1].at)));
            match [after, before] {
                [Beside::Face(a), Beside::Face(b)] => Some([a, b]),
                [Beside::Edge(a), Beside::Edge(b)] if a == b => None,
                _ => panic!("what comes after a hit comes before the next"),
            }
        });
        pairs.collect()
    }

    /// The cell in which a point lies.
    pub(crate) fn locate(&self, p: &P) -> Place {
        if let Some(v) = self.vertices.iter().position(|q| q == p) {
            return self.seen(Place::Vertex(v));
        }
        if let Some(e) = self.edges.iter().position(|edge| edge.has(p)) {
            return Place::Edge(e);
        }
        let Some(some) = self.vertices.first() else { return Place::Face(0) };
        let arc = arc_between(p, some);
        let hits = self.hits(&arc);
        self.place_beside(&hits[0], &opposite(&arc.forward(&hits[0].at)))
    }

    /// The vertex or edge that is first on the meridian up or down from a point, or the face through which it goes; `None` at a pole.
    pub(crate) fn shoot(&self, p: &P, is_up: bool) -> Option<Place> {
        let pole = if is_up { north() } else { opposite(&north()) };
        if is_zero(&cross(p, &pole)) {
            return None;
        }
        let arc = arc_between(p, &pole);
        let place = match self.locate(p) {
            Place::Vertex(v) => {
                self.place_beside(&Hit { at: p.clone(), place: Place::Vertex(v) }, &arc.forward(p))
            }
            Place::Edge(e) => {
                self.place_beside(&Hit { at: p.clone(), place: Place::Edge(e) }, &arc.forward(p))
            }
            face => face,
        };
        if matches!(place, Place::Edge(_)) {
            return Some(place);
        }
        let first = self.hits(&arc).into_iter().find(|hit| hit.at != *p);
        Some(first.map_or(place, |hit| self.seen(hit.place)))
    }

    /// The face or edge next to a point in a direction.
    pub(crate) fn beside_point(&self, p: &P, way: &P) -> Place {
        let vertex = self.vertices.iter().position(|q| q == p).map(Place::Vertex);
        match vertex.unwrap_or_else(|| self.locate(p)) {
            Place::Face(f) => Place::Face(f),
            place => self.place_beside(&Hit { at: p.clone(), place }, way),
        }
    }

    /// The artificial vertex is not seen, but the circle on which it lies.
    fn seen(&self, place: Place) -> Place {
        match place {
            Place::Vertex(v) if self.has_free_circle && v + 1 == self.vertices.len() => {
                Place::Edge(self.around[v][0] / 2)
            }
            place => place,
        }
    }

    /// All cells that a curve meets, and whether it meets a vertex or an edge between its ends.
    pub(crate) fn zone(&self, curve: &Curve) -> (BTreeSet<Place>, bool) {
        let arc = curve.arc();
        let start = self.locate(&arc.start());
        let mut zone = BTreeSet::from([start]);
        if arc.is_point() {
            return (zone, false);
        }
        let hits = self.hits(&arc);
        // If nothing is hit, it is all within one cell.
        let mut is_met = hits.is_empty() && matches!(start, Place::Edge(_));
        for hit in hits {
            let way = arc.forward(&hit.at);
            let is_end = |end: usize| arc.ends.as_ref().is_some_and(|ends| ends[end] == hit.at);
            let is_closed = is_end(0) && is_end(1);
            for (end, way) in [opposite(&way), way].iter().enumerate() {
                if is_closed || !is_end(end) {
                    let beside = self.place_beside(&hit, way);
                    is_met |= matches!(beside, Place::Edge(_));
                    zone.insert(beside);
                }
            }
            is_met |= !is_end(0) && !is_end(1);
            zone.insert(self.seen(hit.place));
        }
        (zone, is_met)
    }

    /// Points of all cells: the vertices, points of each edge, and others that are straight above and below these, or opposite.
    pub(crate) fn points(&self, rng: &mut Rng, most: usize) -> Vec<P> {
        let mut all = self.vertices.clone();
        for edge in &self.edges {
            all.extend(edge.inner_points());
        }
        rng.shuffle(&mut all);
        all.truncate(most);
        all.extend([north(), opposite(&north())]);
        for _ in 0..most {
            let other = random_point(rng, 4);
            let known = rng.choose(&all).clone();
            all.push(match rng.index(6) {
                0 => other,
                1 => [known[0].clone(), known[1].clone(), other[2].clone()],
                2 => opposite(&known),
                3 => [(-1).into(), 0.into(), other[2].clone()],
                4 => [-&known[0], -&known[1], other[2].clone()],
                _ => [0, 1, 2].map(|i| &known[i] + &other[i]),
            });
        }
        all.retain(|p| !is_zero(p));
        all.iter().map(primitive).collect()
    }
}

/// Some arc between two different points.
fn arc_between(p: &P, q: &P) -> Arc {
    let normal = cross(p, q);
    let normal = if is_zero(&normal) { orthogonal(p) } else { primitive(&normal) };
    Arc { normal, ends: Some([p.clone(), q.clone()]) }
}
