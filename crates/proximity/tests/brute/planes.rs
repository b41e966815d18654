//! Penetration by all candidates of separating directions: normals of facets, and cross products of edges.

use crate::number::{Fraction, Number, Triple, cross, dot, is_zero, keep_least, negated};
use crate::solid::{Solid, rank};
use exact::{Integer, Rational};
use polytope::Polytope;
use std::cmp::Ordering;
use std::collections::HashSet;

/// With so many edges, floats rule out at once what is far from a candidate.
const MANY: usize = 100;

/// What brute force says about the place of one polytope beside another.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub(crate) enum Place {
    Disjoint,
    Touching,
    Overlapping,
}

/// A direction in which a facet of the set of all `p - q` looks.
#[derive(Clone, Debug)]
pub(crate) struct Candidate<N> {
    pub(crate) normal: Triple<N>,
    /// How far that set extends.
    pub(crate) height: N,
    pub(crate) squared_length: N,
}

/// Two polytopes, over one scale, and the candidates.
#[derive(Clone, Debug)]
pub(crate) struct Brute<N> {
    pub(crate) p: Solid<N>,
    pub(crate) q: Solid<N>,
    /// What coordinates were multiplied by.
    pub(crate) scale: Integer,
    /// Empty where no translation makes the interiors of sums meet: both lie in parallel planes.
    pub(crate) candidates: Vec<Candidate<N>>,
    /// Edges of both are in more than parallel planes.
    pub(crate) is_full: bool,
}

impl<N: Number> Brute<N> {
    /// Finds the candidates; `scale` must make all coordinates integers.
    pub(crate) fn new(p: &Polytope, q: &Polytope, scale: Integer) -> Self {
        let (p, q) = (Solid::<N>::new(p, &scale), Solid::<N>::new(q, &scale));
        let vectors = |solid: &Solid<N>| -> Vec<Triple<N>> {
            solid.edges.iter().map(|&edge| solid.edge_vector(edge)).collect()
        };
        let [of_p, of_q] = [&p, &q].map(vectors);
        let is_full = rank(&[&of_p[..], &of_q[..]].concat()) == 3;
        let mut brute = Self { p, q, scale, candidates: Vec::new(), is_full };
        if is_full {
            let mut met = HashSet::new();
            let facets = [&brute.p, &brute.q].map(|solid| solid.facets.clone());
            for (_, normal) in facets.iter().flatten() {
                brute.offer(normal, &mut met);
            }
            let floats = [&brute.p, &brute.q].map(Solid::floats);
            let approx = |v: &Triple<N>| v.each_ref().map(Number::approx);
            for u in &of_p {
                for v in &of_q {
                    if brute.p.edges.len() < MANY || may_support(&floats, &approx(u), &approx(v)) {
                        brute.offer(&cross(u, v), &mut met);
                    }
                }
            }
        }
        brute
    }

    /// Keeps a direction and its opposite, where the extreme points span a facet.
    fn offer(&mut self, normal: &Triple<N>, met: &mut HashSet<Vec<String>>) {
        if is_zero(normal) {
            return;
        }
        let divisor = normal[0].gcd(&normal[1]).gcd(&normal[2]);
        let primitive = [0, 1, 2].map(|i: usize| normal[i].div_exact(&divisor));
        for normal in [negated(&primitive), primitive] {
            if met.insert(normal.iter().map(|c| c.integer().to_string()).collect()) {
                self.keep_facet(normal);
            }
        }
    }

    fn keep_facet(&mut self, normal: Triple<N>) {
        let (height_p, of_p) = self.p.extreme(&normal);
        let (height_q, of_q) = self.q.extreme(&negated(&normal));
        let edges = |solid: &Solid<N>, vertices: &[usize]| -> Vec<Triple<N>> {
            vertices[1..].iter().map(|&v| solid.edge_vector([vertices[0], v])).collect()
        };
        let spanned = [edges(&self.p, &of_p), edges(&self.q, &of_q)].concat();
        if rank(&spanned) == 2 {
            let squared_length = dot(&normal, &normal);
            self.candidates.push(Candidate { normal, height: height_p.add(&height_q), squared_length });
        }
    }

    /// How far a translation lies inside of a candidate; negative outside.
    fn slack(candidate: &Candidate<N>, s: &Triple<N>) -> N {
        candidate.height.sub(&dot(&candidate.normal, s))
    }

    /// Where `q + s` lies beside `p`; `s` is over the scale.
    pub(crate) fn place(&self, s: &Triple<N>) -> Place {
        if !self.is_full {
            return if self.squared_distance(s).0.is_zero() { Place::Touching } else { Place::Disjoint };
        }
        let mut place = Place::Overlapping;
        for candidate in &self.candidates {
            match Self::slack(candidate, s).sign() {
                Ordering::Less => return Place::Disjoint,
                Ordering::Equal => place = Place::Touching,
                Ordering::Greater => {}
            }
        }
        place
    }

    /// The square of the shortest translation that separates overlapping polytopes, not yet divided by the square of the scale.
    pub(crate) fn minimum_penetration(&self, s: &Triple<N>) -> Fraction<N> {
        let mut least = None;
        for candidate in &self.candidates {
            let slack = Self::slack(candidate, s);
            keep_least(&mut least, Fraction(slack.mul(&slack), candidate.squared_length.clone()));
        }
        least.expect("a solid has facets")
    }

    /// How often overlapping polytopes must be moved by `r` until their interiors do not meet, not yet divided by the scale.
    pub(crate) fn directional_penetration(&self, s: &Triple<N>, r: &Triple<N>) -> Fraction<N> {
        let mut least = None;
        for candidate in &self.candidates {
            let speed = dot(&candidate.normal, r);
            if speed.sign().is_gt() {
                keep_least(&mut least, Fraction(Self::slack(candidate, s), speed));
            }
        }
        least.expect("a solid is bounded in every direction")
    }

    /// Whether all of `q + s` lies beyond or on a plane with this normal, outside of the interior of `p`, and by how much, squared and
    /// divided by the square of the normal; of the polytopes as they are.
    pub(crate) fn gap(&self, normal: &Triple<N>, s: &Triple<N>) -> (Ordering, Rational) {
        let (height_p, _) = self.p.extreme(normal);
        let (height_q, _) = self.q.extreme(&negated(normal));
        let gap = dot(normal, s).sub(&height_p).sub(&height_q);
        let squared = Fraction(gap.mul(&gap), dot(normal, normal));
        (gap.sign(), squared.rational(&(&self.scale * &self.scale)))
    }
}

/// Whether floats do not show that the ends of both edges are clearly not the extreme points in the directions that are perpendicular
/// to both. Only to save time.
fn may_support([p, q]: &[Vec<[f64; 3]>; 2], u: &[f64; 3], v: &[f64; 3]) -> bool {
    let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
    let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
    // Whether the two extreme vertices in a direction are about as far.
    let is_edge = |vertices: &[[f64; 3]], sign: f64| {
        let (mut first, mut second, mut least) = (f64::NEG_INFINITY, f64::NEG_INFINITY, f64::INFINITY);
        for vertex in vertices {
            let height = sign * (vertex[0] * normal[0] + vertex[1] * normal[1] + vertex[2] * normal[2]);
            least = least.min(height);
            second = second.max(height.min(first));
            first = first.max(height);
        }
        first - second <= 1e-6 * (first - least)
    };
    [1.0, -1.0].iter().any(|&sign| is_edge(p, sign) && is_edge(q, -sign))
}
