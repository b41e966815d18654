//! Flat edges joined: facets and edges become as large as they can be.
//!
//! 1. Edges without length are contracted, and facets without area taken out ([`super::slack`]).
//! 2. An edge goes if exactly two facets run through it, in opposite directions and in one plane with one
//!    normal, or one facet both ways. If facets have labels, those of the two must be equal.
//! 3. What is left of the boundaries is walked around: at the end of an edge, the fan of facets that are
//!    joined leads to the next one. So a walk goes around a connected inside, and where it comes to a vertex
//!    again, a cycle is closed there. All cycles are simple.
//! 4. Of the cycles of a facet those with positive area are outer ones, usually one; the others are holes,
//!    also those of two vertices: an edge that is run through both ways, and has other facets too.
//! 5. A vertex goes if all cycles there run straight through it, along the same two edges.
//!
//! Nothing but 1 and 5 needs a coordinate besides signs of planes and areas; no step needs a closed surface.

use super::edges::{EdgeTable, Groups};
use super::shape::{FacetPlane, Shape, area_sign};
use super::slack;
use super::weld::Compact;
use crate::Facets;
use crate::polytope::nonzero_axis;
use crate::triangulate::outer_cycles;
use exact::{Point3, Sign, Vector3, predicate};

const NONE: u32 = u32::MAX;

/// A mesh of facets with holes; what was joined has simple cycles.
pub(super) struct Joined {
    /// The outer cycles as facets, with their names.
    pub(super) compact: Compact,
    /// The facet of each hole, in order.
    pub(super) hole_facets: Vec<u32>,
    pub(super) holes: Facets,
}

impl Joined {
    /// The number of edges.
    pub(super) fn edges(&self) -> usize {
        let mut cycles = self.compact.facets.clone();
        self.holes.iter().for_each(|hole| cycles.push(hole));
        EdgeTable::new(self.compact.points.len(), &cycles).edges().count()
    }
}

/// Joins what is flat, if any facet has area, and what has one label, if there are some for the facets of the
/// mesh that was given. Facets that are not planar, or have two vertices only, stay as they are.
///
/// # Complexity
/// `n log n`.
pub(super) fn join(mut compact: Compact, labels: Option<&[u32]>) -> Joined {
    let has_area = |cycle: &[u32]| !matches!(Shape::of(&compact.points, cycle), Shape::Line);
    if !compact.facets.iter().any(has_area) {
        return Joined { compact, hole_facets: Vec::new(), holes: Facets::new() };
    }
    compact.contract();
    let mut shapes: Vec<Shape> =
        compact.facets.iter().map(|cycle| Shape::of(&compact.points, cycle)).collect();
    slack::take_out(&mut compact, &mut shapes);
    let mut cycles = Boundaries { compact: &compact, shapes: &shapes, labels }.cycles();
    straighten(&compact.points, &mut cycles);
    collect(compact, &cycles)
}

/// A cycle of a facet that was joined from others.
struct Cycle {
    /// The first of these.
    facet: u32,
    /// Holes come behind their outer cycle.
    is_hole: bool,
    start: u32,
    end: u32,
}

/// Cycles in the order of their facets, each outer one before its holes.
struct Cycles {
    vertices: Vec<u32>,
    list: Vec<Cycle>,
}

struct Boundaries<'m> {
    compact: &'m Compact,
    shapes: &'m [Shape],
    labels: Option<&'m [u32]>,
}

impl Boundaries<'_> {
    fn plane(&self, f: usize) -> Option<&FacetPlane> {
        match &self.shapes[f] {
            Shape::Plane(plane) => Some(plane),
            _ => None,
        }
    }

    /// Whether two facets have the same label, or there are none.
    fn alike(&self, f: usize, g: usize) -> bool {
        let label = |f: usize| self.labels.map(|labels| labels[self.compact.facet_names[f] as usize]);
        label(f) == label(g)
    }

    /// Whether two facets with a common edge lie in one plane and have the same normal.
    fn coplanar(&self, f: usize, g: usize) -> bool {
        let (Some(p), Some(q)) = (self.plane(f), self.plane(g)) else { return false };
        let cycle = self.compact.facets.get(g);
        let corner = |i: usize| &self.compact.points[cycle[(q.witness as usize + i) % cycle.len()] as usize];
        let on = &self.compact.points[self.compact.facets.get(f)[0] as usize];
        let axis = || nonzero_axis(&p.normal);
        f == g
            || (0..3).all(|i| predicate::plane_side(&p.normal, on, corner(i)) == Sign::Zero)
                && p.normal.sign(axis()) == q.normal.sign(axis())
    }

    fn cycles(&self) -> Cycles {
        let facets = &self.compact.facets;
        let table = EdgeTable::new(self.compact.points.len(), facets);
        // The corner on the other side of an edge that goes.
        let mut twin = vec![NONE; facets.corners().len()];
        let mut groups = Groups::new(facets.len());
        for edge in table.edges() {
            let &[c, d] = edge else { continue };
            let [f, g] = [c, d].map(|corner| table.facet(corner));
            if table.source(c) != table.source(d) && self.alike(f, g) && self.coplanar(f, g) {
                (twin[c as usize], twin[d as usize]) = (d, c);
                groups.join(f, g);
            }
        }
        let mut walk = Walk {
            cycles: Cycles { vertices: Vec::new(), list: Vec::new() },
            path: Vec::new(),
            place: vec![NONE; self.compact.points.len()],
        };
        let mut done = vec![false; twin.len()];
        for f in 0..facets.len() {
            let [start, end] = [f, f + 1].map(|f| facets.starts()[f]);
            if self.plane(f).is_none() {
                walk.cycles.push(f as u32, facets.get(f));
                continue;
            }
            let group = groups.find(f) as u32;
            for first in start..end {
                if done[first as usize] || twin[first as usize] != NONE {
                    continue;
                }
                let mut corner = first;
                while !done[corner as usize] {
                    done[corner as usize] = true;
                    walk.step(group, table.source(corner));
                    corner = table.next(corner);
                    while twin[corner as usize] != NONE {
                        corner = table.next(twin[corner as usize]);
                    }
                }
                walk.close(group, 0);
            }
        }
        let mut cycles = walk.cycles;
        cycles.list.sort_by_key(|cycle| cycle.facet);
        self.sort_holes(cycles)
    }

    /// Tells outer cycles from holes, and finds the outer cycle of each hole.
    fn sort_holes(&self, mut cycles: Cycles) -> Cycles {
        let list = std::mem::take(&mut cycles.list);
        let mut sorted: Vec<Cycle> = Vec::with_capacity(list.len());
        let mut list = list.into_iter().peekable();
        while let Some(first) = list.next() {
            let facet = first.facet;
            if list.peek().is_none_or(|other| other.facet != facet) {
                sorted.push(first);
                continue;
            }
            let mut group = vec![first];
            while let Some(other) = list.next_if(|other| other.facet == facet) {
                group.push(other);
            }
            let plane = self.plane(facet as usize).expect("only facets of a plane are cut into cycles");
            let axis = nonzero_axis(&plane.normal);
            let positive = plane.normal.sign(axis);
            let (mut outers, mut holes) = (Vec::new(), Vec::new());
            for cycle in group {
                let vertices = &cycles.vertices[cycle.start as usize..cycle.end as usize];
                let sign = area_sign(&self.compact.points, vertices, axis);
                if sign == positive { &mut outers } else { &mut holes }.push(cycle);
            }
            if outers.is_empty() {
                // Facets that cross themselves may have any area.
                outers.append(&mut holes);
            }
            let around = self.around(&cycles, &plane.normal, &outers, &holes);
            let mut of: Vec<Vec<Cycle>> = outers.iter().map(|_| Vec::new()).collect();
            for (hole, outer) in holes.into_iter().zip(around) {
                of[outer].push(hole);
            }
            for (outer, holes) in outers.into_iter().zip(of) {
                sorted.push(outer);
                sorted.extend(holes.into_iter().map(|hole| Cycle { is_hole: true, ..hole }));
            }
        }
        cycles.list = sorted;
        cycles
    }

    /// The outer cycle around each hole. If cycles cross, no such thing is known; then it is the first.
    fn around(&self, cycles: &Cycles, normal: &Vector3, outers: &[Cycle], holes: &[Cycle]) -> Vec<usize> {
        if outers.len() == 1 || holes.is_empty() {
            return vec![0; holes.len()];
        }
        let vertices = |cycle: &Cycle| &cycles.vertices[cycle.start as usize..cycle.end as usize];
        let all: Vec<&[u32]> = outers.iter().chain(holes).map(vertices).collect();
        outer_cycles(&self.compact.points, normal.clone(), &all, outers.len())
            .unwrap_or_else(|| vec![0; holes.len()])
    }
}

impl Cycles {
    fn push(&mut self, facet: u32, vertices: &[u32]) {
        let start = self.vertices.len() as u32;
        self.vertices.extend_from_slice(vertices);
        self.list.push(Cycle { facet, is_hole: false, start, end: self.vertices.len() as u32 });
    }
}

/// A walk around a boundary, cut into simple cycles.
struct Walk {
    cycles: Cycles,
    path: Vec<u32>,
    /// For each vertex on the path, its place there.
    place: Vec<u32>,
}

impl Walk {
    /// Comes to a vertex: for the second time perhaps.
    fn step(&mut self, facet: u32, vertex: u32) {
        let place = self.place[vertex as usize];
        if place != NONE {
            self.close(facet, place as usize);
        }
        self.place[vertex as usize] = self.path.len() as u32;
        self.path.push(vertex);
    }

    /// Makes the end of the path a cycle.
    fn close(&mut self, facet: u32, from: usize) {
        self.cycles.push(facet, &self.path[from..]);
        self.path.drain(from..).for_each(|v| self.place[v as usize] = NONE);
    }
}

/// Takes out the vertices through which all cycles run straight, along the same two edges.
fn straighten(points: &[Point3], cycles: &mut Cycles) {
    // The neighbors of each vertex on all cycles, and the vertices that have more than two, or end a slit.
    let mut neighbors = vec![[NONE; 2]; points.len()];
    let mut keep = vec![false; points.len()];
    for cycle in &cycles.list {
        let vertices = &cycles.vertices[cycle.start as usize..cycle.end as usize];
        let k = vertices.len();
        for (i, &v) in vertices.iter().enumerate() {
            let pair = [vertices[(i + k - 1) % k], vertices[(i + 1) % k]];
            let known = &mut neighbors[v as usize];
            if *known == [NONE; 2] {
                *known = pair;
            }
            keep[v as usize] |= pair[0] == pair[1] || (*known != pair && *known != [pair[1], pair[0]]);
        }
    }
    let mut gone = vec![false; points.len()];
    for v in 0..points.len() {
        let [a, b] = neighbors[v];
        if keep[v] || a == b {
            continue;
        }
        let arm = |w: u32| points[v].direction_to(&points[w as usize]);
        if arm(a).cross(&arm(b)).is_zero() {
            gone[v] = true;
            for (w, other) in [(a, b), (b, a)] {
                let slot = neighbors[w as usize].iter_mut().find(|slot| **slot == v as u32);
                slot.into_iter().for_each(|slot| *slot = other);
            }
        }
    }
    if !gone.contains(&true) {
        return;
    }
    // The list is not in the order of the vertices any more.
    let mut kept = Vec::with_capacity(cycles.vertices.len());
    for cycle in &mut cycles.list {
        let range = cycle.start as usize..cycle.end as usize;
        cycle.start = kept.len() as u32;
        kept.extend(cycles.vertices[range].iter().filter(|&&v| !gone[v as usize]));
        cycle.end = kept.len() as u32;
    }
    cycles.vertices = kept;
}

/// Makes a mesh of the cycles. Facets go that have no area now.
fn collect(mut compact: Compact, cycles: &Cycles) -> Joined {
    let mut facets = Facets::with_capacity(cycles.list.len(), cycles.vertices.len());
    let (mut names, mut hole_facets, mut holes) = (Vec::new(), Vec::new(), Facets::new());
    let mut outer_kept = false;
    for cycle in &cycles.list {
        let vertices = &cycles.vertices[cycle.start as usize..cycle.end as usize];
        if cycle.is_hole {
            if outer_kept {
                hole_facets.push(names.len() as u32 - 1);
                holes.push(vertices);
            }
        } else {
            outer_kept =
                vertices.len() >= 3 || compact.facets.get(cycle.facet as usize).len() == vertices.len();
            if outer_kept {
                facets.push(vertices);
                names.push(compact.facet_names[cycle.facet as usize]);
            }
        }
    }
    compact.facets = facets;
    compact.facet_names = names;
    if let Some(label) = compact.drop_unused(&[holes.corners()]) {
        holes.relabel(&label);
    }
    Joined { compact, hole_facets, holes }
}
