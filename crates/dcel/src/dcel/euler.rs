//! Components, and Euler's relation on surfaces of any genus.

use super::{Dcel, DcelViolation};
use crate::{VertexId, VertexMap};

/// What the connectivity says about the surface. All of it presumes that
/// [`check_valid`](Dcel::check_valid) finds nothing.
impl Dcel {
    /// Numbers the connected components of vertices and edges, in the order of their lowest vertices: a
    /// label for each vertex, and how many there are. An isolated vertex is a component.
    ///
    /// # Complexity
    /// Linear.
    pub fn components(&self) -> (VertexMap<u32>, usize) {
        const NEW: u32 = u32::MAX;
        let mut label = VertexMap::filled(self, NEW);
        let mut count = 0;
        let mut stack: Vec<VertexId> = Vec::new();
        for seed in self.vertices() {
            if label[seed] != NEW {
                continue;
            }
            label[seed] = count;
            stack.push(seed);
            while let Some(v) = stack.pop() {
                for h in self.around(v) {
                    let w = self.target(h);
                    if label[w] == NEW {
                        label[w] = count;
                        stack.push(w);
                    }
                }
            }
            count += 1;
        }
        (label, count as usize)
    }

    /// The number of connected components of vertices and edges, isolated vertices included.
    ///
    /// # Complexity
    /// Linear.
    pub fn component_count(&self) -> usize {
        self.components().1
    }

    /// For each component, in the order of [`components`](Self::components), the genus of the surface
    /// that arises if each of its CCBs is closed by a disc: `V - E + CCBs = 2 - 2 g`.
    ///
    /// # Complexity
    /// Linear.
    pub fn genus_of_components(&self) -> Vec<usize> {
        let (label, count) = self.components();
        self.ribbon_genera(&label, count)
    }

    fn ribbon_genera(&self, label: &VertexMap<u32>, count: usize) -> Vec<usize> {
        let mut characteristic = vec![0i64; count];
        for v in self.vertices() {
            // An isolated vertex has one boundary, though no CCB.
            characteristic[label[v] as usize] += if self.outgoing(v).is_some() { 1 } else { 2 };
        }
        for e in self.edges() {
            characteristic[label[self.ends(e)[0]] as usize] -= 1;
        }
        for c in self.ccbs() {
            characteristic[label[self.source(self.ccb_halfedge(c))] as usize] += 1;
        }
        characteristic.into_iter().map(|x| usize::try_from((2 - x) / 2).unwrap_or(0)).collect()
    }

    /// The least genus that a connected surface with this arrangement can have: the sum of the
    /// [genera of the components](Self::genus_of_components) and the number of independent cycles of the
    /// graph of components and faces, in which every CCB and every isolated vertex is a link. The genus
    /// of the surface is this one if every face is a sphere with holes, and higher if not.
    ///
    /// # Complexity
    /// Linear, but for a forest of disjoint sets: at worst the logarithm of its size for each link.
    ///
    /// # Examples
    /// ```
    /// use splitstar_dcel::{CcbKind::Outer, CcbSplit, Dcel, FaceId};
    /// // A closed curve around the handle of a torus: a vertex, an edge, and a face with two outer CCBs.
    /// let mut torus = Dcel::new();
    /// let v = torus.add_vertex();
    /// torus.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Outer], new_face: None });
    /// assert_eq!(torus.genus_of_components(), [0]);
    /// assert_eq!(torus.least_genus(), 1);
    /// assert!(torus.check_euler(1).is_empty());
    /// assert_eq!(torus.check_euler(0).len(), 2);
    /// ```
    pub fn least_genus(&self) -> usize {
        let (label, count) = self.components();
        self.surface(&label, count).0
    }

    /// The least genus, and the number of connected pieces of the graph of components and faces.
    fn surface(&self, label: &VertexMap<u32>, count: usize) -> (usize, usize) {
        // A forest of faces and components; faces come first.
        let faces = self.face_bound();
        let mut parent: Vec<u32> = (0..(faces + count) as u32).collect();
        let mut pieces = self.face_count() + count;
        let mut cycles = 0;
        let mut connect = |face: usize, component: u32| {
            let (a, b) = (root(&mut parent, face), root(&mut parent, faces + component as usize));
            if a == b {
                cycles += 1;
            } else {
                parent[b] = a as u32;
                pieces -= 1;
            }
        };
        for c in self.ccbs() {
            connect(self.ccb_face(c).index(), label[self.source(self.ccb_halfedge(c))]);
        }
        for v in self.vertices() {
            if let Some(f) = self.isolated_face(v) {
                connect(f.index(), label[v]);
            }
        }
        let genera: usize = self.ribbon_genera(label, count).into_iter().sum();
        (genera + cycles, pieces)
    }

    /// Lists what says that this is no arrangement on a connected surface of this genus: the graph of
    /// components and faces falls in pieces, the [least genus](Self::least_genus) is higher, or, for
    /// genus 0 (the sphere, and the plane with its one unbounded face), `V - E + F` is not `1 + C`, where
    /// `C` is the number of components. If the structure is not valid, gives what `check_valid` finds.
    ///
    /// # Complexity
    /// As [`least_genus`](Self::least_genus).
    pub fn check_euler(&self, genus: usize) -> Vec<DcelViolation> {
        let mut found = self.check_valid();
        if !found.is_empty() {
            return found;
        }
        let (label, components) = self.components();
        let (least, pieces) = self.surface(&label, components);
        if pieces > 1 {
            found.push(DcelViolation::Pieces(pieces));
        }
        if least > genus {
            found.push(DcelViolation::Genus { least, given: genus });
        }
        let [v, e, f] = [self.vertex_count(), self.edge_count(), self.face_count()].map(|n| n as i64);
        if genus == 0 && v - e + f != 1 + components as i64 {
            found.push(DcelViolation::Euler { characteristic: v - e + f, components });
        }
        found
    }
}

/// The root of a tree of the forest. Halves the path that it walks.
fn root(parent: &mut [u32], mut i: usize) -> usize {
    while parent[i] as usize != i {
        let up = parent[parent[i] as usize];
        parent[i] = up;
        i = up as usize;
    }
    i
}
