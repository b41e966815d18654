//! The same under a map of the points.

use super::skeleton::{FaceMap, Skeleton};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;

const NONE: u32 = u32::MAX;

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Tells whether a map of the surface makes another arrangement of this one: `map` gives the images of the vertices, and
    /// `is_mirrored` says that it turns the orientation round.
    ///
    /// It compares which vertices are where, the order around them, and the faces; the curves of the edges it does not look at.
    /// A closed curve without a vertex but an artificial one is the same as any such curve between the same faces. Where a side is
    /// contracted, as on a sphere, which CCB of a face is an outer one depends on where that side is, and is not compared.
    ///
    /// # Complexity
    /// O(n log n) comparisons of points for n cells, and for each component, steps in proportion to its size and a degree. Where
    /// components can be mapped in several ways (lines through infinity, closed curves without vertices), all are tried, and
    /// what does not fit the faces found so far is dropped.
    pub fn is_isomorphic_under(
        &self,
        other: &Self,
        map: impl Fn(&G::Point) -> G::Point,
        is_mirrored: bool,
    ) -> bool {
        let (a, mut b) = (Skeleton::new(self), Skeleton::new(other));
        if is_mirrored {
            b.mirror();
        }
        if self.dcel.face_count() != other.dcel.face_count()
            || a.darts.len() != b.darts.len()
            || a.vertices.len() != b.vertices.len()
            || a.special_count != b.special_count
        {
            return false;
        }
        let mut search = Search {
            faces: FaceMap::new(self.dcel.face_bound(), other.dcel.face_bound()),
            images: vec![NONE; a.vertices.len()],
            free: [self.free_loops(&a), other.free_loops(&b)],
            dart_images: vec![NONE; a.darts.len()],
            is_image: vec![false; b.darts.len()],
            compares_kinds: self.contractions.iter().all(Option::is_none),
            a: &a,
            b: &b,
        };
        search.map_vertices(self, other, map) && search.map_isolated(self, other) && {
            let seeds = search.seeds();
            search.map_components(&seeds)
        }
    }

    /// For each vertex, whether it is artificial: the one vertex of a closed curve.
    fn free_loops(&self, skeleton: &Skeleton) -> Vec<bool> {
        skeleton.vertices.iter().map(|&v| self.is_artificial(v)).collect()
    }
}

struct Search<'s> {
    a: &'s Skeleton,
    b: &'s Skeleton,
    /// For each vertex of a, that of b.
    images: Vec<u32>,
    free: [Vec<bool>; 2],
    dart_images: Vec<u32>,
    is_image: Vec<bool>,
    compares_kinds: bool,
    faces: FaceMap,
}

/// The ways in which a component may be mapped that were not tried yet, and what the present one did.
struct Trial {
    candidates: std::vec::IntoIter<u32>,
    mapped: Vec<usize>,
    /// How much was known of the faces before.
    known: usize,
}

impl Search<'_> {
    /// Finds the images of all vertices that are not free; `false` if there are not the right ones.
    fn map_vertices<G: UMonotoneTraits, T: Topology<G>>(
        &mut self,
        first: &Arrangement<G, T>,
        second: &Arrangement<G, T>,
        map: impl Fn(&G::Point) -> G::Point,
    ) -> bool {
        let (a, b) = (self.a, self.b);
        let mut is_met = vec![false; b.vertices.len()];
        for (i, &v) in a.vertices.iter().enumerate() {
            if self.free[0][i] {
                continue;
            }
            let image = match first.point(v) {
                None => Ok(i),
                Some(point) => {
                    let point = map(point);
                    b.vertices.binary_search_by(|&w| second.compare_places(second.point(w), Some(&point)))
                }
            };
            match image {
                Ok(j) if !self.free[1][j] && !is_met[j] && a.degree(i) == b.degree(j) => {
                    is_met[j] = true;
                    self.images[i] = j as u32;
                }
                _ => return false,
            }
        }
        // Then there are as many free ones in both.
        is_met.iter().zip(&self.free[1]).all(|(is_met, is_free)| is_met != is_free)
    }

    fn map_isolated<G: UMonotoneTraits, T: Topology<G>>(
        &mut self,
        first: &Arrangement<G, T>,
        second: &Arrangement<G, T>,
    ) -> bool {
        (0..self.images.len()).filter(|&i| self.images[i] != NONE).all(|i| {
            let (v, w) = (self.a.vertices[i], self.b.vertices[self.images[i] as usize]);
            match (first.dcel.isolated_face(v), second.dcel.isolated_face(w)) {
                (Some(f), Some(g)) => self.faces.connect(f, g),
                (f, g) => f == g,
            }
        })
    }

    /// A dart of each component, of a vertex of least degree. Components that may go to several others come last.
    fn seeds(&self) -> Vec<usize> {
        let mut is_seen = vec![false; self.a.vertices.len()];
        let mut order: Vec<usize> = (0..self.a.vertices.len()).filter(|&v| self.a.degree(v) > 0).collect();
        order.sort_by_key(|&v| (self.free[0][v], self.a.degree(v)));
        let (mut seeds, mut stack) = (Vec::new(), Vec::new());
        for v in order {
            if is_seen[v] {
                continue;
            }
            seeds.push(self.a.first_darts[v] as usize);
            stack.push(v);
            is_seen[v] = true;
            while let Some(v) = stack.pop() {
                for dart in self.a.first_darts[v]..self.a.first_darts[v + 1] {
                    let w = self.a.sources[self.a.twins[dart as usize] as usize] as usize;
                    if !std::mem::replace(&mut is_seen[w], true) {
                        stack.push(w);
                    }
                }
            }
        }
        seeds
    }

    /// Maps the components of some darts, in all ways until one fits.
    fn map_components(&mut self, seeds: &[usize]) -> bool {
        // One for each component that is mapped, and one for the next.
        let mut trials: Vec<Trial> = Vec::new();
        let mut is_forward = true;
        loop {
            if is_forward {
                let Some(&seed) = seeds.get(trials.len()) else { return true };
                trials.push(Trial {
                    candidates: self.candidates(seed),
                    mapped: Vec::new(),
                    known: self.faces.len(),
                });
            }
            let seed = seeds[trials.len().saturating_sub(1)];
            let Some(trial) = trials.last_mut() else { return false };
            self.faces.forget(trial.known);
            for dart in trial.mapped.drain(..) {
                self.is_image[self.dart_images[dart] as usize] = false;
                self.dart_images[dart] = NONE;
            }
            is_forward = match trial.candidates.next() {
                Some(image) => self.map_component(seed, image as usize, &mut trial.mapped),
                None => {
                    trials.pop();
                    false
                }
            };
        }
    }

    /// The darts to which a dart may go.
    fn candidates(&self, dart: usize) -> std::vec::IntoIter<u32> {
        let darts = 0..self.b.darts.len() as u32;
        let images: Vec<u32> = match self.images[self.a.sources[dart] as usize] {
            NONE => darts.filter(|&d| self.free[1][self.b.sources[d as usize] as usize]).collect(),
            image => (self.b.first_darts[image as usize]..self.b.first_darts[image as usize + 1]).collect(),
        };
        images.into_iter()
    }

    /// Maps the component of a dart, if it goes to `image`. The darts that were mapped are appended, whether it fits or not.
    fn map_component(&mut self, seed: usize, image: usize, mapped: &mut Vec<usize>) -> bool {
        let (a, b) = (self.a, self.b);
        let mut stack = vec![(seed, image)];
        while let Some((d, e)) = stack.pop() {
            if self.dart_images[d] != NONE {
                if self.dart_images[d] as usize != e {
                    return false;
                }
                continue;
            }
            let (v, w) = (a.sources[d] as usize, b.sources[e] as usize);
            let is_right_vertex = match self.images[v] {
                NONE => self.free[1][w],
                image => image as usize == w,
            };
            if self.is_image[e]
                || !is_right_vertex
                || self.compares_kinds && a.is_outer[d] != b.is_outer[e]
                || !self.faces.connect(a.faces[d], b.faces[e])
            {
                return false;
            }
            self.dart_images[d] = e as u32;
            self.is_image[e] = true;
            mapped.push(d);
            stack.push((a.around(d), b.around(e)));
            stack.push((a.twins[d] as usize, b.twins[e] as usize));
        }
        true
    }
}
