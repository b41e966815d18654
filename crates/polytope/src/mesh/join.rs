//! Flat edges joined: facets and edges become as large as they can be.
//!
//! 1. Edges without length are contracted, and facets without area taken out ([`super::slack`]).
//! 2. An edge goes if exactly two facets run through it, in opposite directions and in one plane with one
//!    normal, or one facet both ways.
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
use exact::{Integer, Point3, Rational, Sign, Vector3, predicate};

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

/// Joins what is flat, if any facet has area. Facets that are not planar, or have two vertices only, stay as
/// they are.
///
/// # Complexity
/// `n log n`; for a facet that is several by itself, its outer cycles times its holes.
pub(super) fn join(mut compact: Compact) -> Joined {
    let has_area = |cycle: &[u32]| !matches!(Shape::of(&compact.points, cycle), Shape::Line);
    if !compact.facets.iter().any(has_area) {
        return Joined { compact, hole_facets: Vec::new(), holes: Facets::new() };
    }
    compact.contract();
    let mut shapes: Vec<Shape> =
        compact.facets.iter().map(|cycle| Shape::of(&compact.points, cycle)).collect();
    slack::take_out(&mut compact, &mut shapes);
    let mut cycles = Boundaries { compact: &compact, shapes: &shapes }.cycles();
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
}

impl Boundaries<'_> {
    fn plane(&self, f: usize) -> Option<&FacetPlane> {
        match &self.shapes[f] {
            Shape::Plane(plane) => Some(plane),
            _ => None,
        }
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
            if table.source(c) != table.source(d) && self.coplanar(f, g) {
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
            let mut of: Vec<Vec<Cycle>> = outers.iter().map(|_| Vec::new()).collect();
            for hole in holes {
                let around = self.around(&cycles, &plane.normal, &outers, &hole);
                of[around].push(hole);
            }
            for (outer, holes) in outers.into_iter().zip(of) {
                sorted.push(outer);
                sorted.extend(holes.into_iter().map(|hole| Cycle { is_hole: true, ..hole }));
            }
        }
        cycles.list = sorted;
        cycles
    }

    /// The outer cycle around a hole.
    fn around(&self, cycles: &Cycles, normal: &Vector3, outers: &[Cycle], hole: &Cycle) -> usize {
        let points = |cycle: &Cycle| -> Vec<&Point3> {
            let vertices = &cycles.vertices[cycle.start as usize..cycle.end as usize];
            vertices.iter().map(|&v| &self.compact.points[v as usize]).collect()
        };
        if outers.len() == 1 {
            return 0;
        }
        let inner = points(hole);
        let least = inner.iter().min().expect("a cycle has corners");
        let holds = |outer: &Cycle| {
            let outer = points(outer);
            let range = [outer.iter().min(), outer.iter().max()];
            let within =
                range[0].is_some_and(|low| low <= least) && range[1].is_some_and(|high| least <= high);
            within && is_around(&outer, &inner, normal)
        };
        outers.iter().position(holds).unwrap_or(0)
    }
}

/// Whether a simple cycle lies inside another one that it does not cross, in a plane with that normal.
fn is_around(outer: &[&Point3], inner: &[&Point3], normal: &Vector3) -> bool {
    let corners = inner.iter().map(|&p| p.clone());
    let middles = (0..inner.len()).map(|i| middle(inner[i], inner[(i + 1) % inner.len()]));
    // The first point that is not on the boundary decides.
    let sides = corners.chain(middles).map(|p| winding(outer, &p, normal));
    sides.flatten().next().unwrap_or(false)
}

fn middle(p: &Point3, q: &Point3) -> Point3 {
    let half = Rational::new(Integer::from(1), Integer::from(2)).expect("two is not zero");
    Point3::from_rationals(&p.plus(q).coordinates().map(|c| c * half.clone()))
}

/// Whether a point of the plane lies inside a simple cycle; none on the boundary.
fn winding(cycle: &[&Point3], p: &Point3, normal: &Vector3) -> Option<bool> {
    let mut inside = false;
    for (i, &a) in cycle.iter().enumerate() {
        let b = cycle[(i + 1) % cycle.len()];
        // A ray upwards from the point: in the lexicographic order it lies to the right of all that is before
        // it.
        let (low, high) = if a <= b { (a, b) } else { (b, a) };
        if p == low || p == high {
            return None;
        }
        if low < p && p < high {
            match predicate::orientation(normal, &low.direction_to(high), &low.direction_to(p)) {
                Sign::Zero => return None,
                Sign::Negative => inside = !inside,
                Sign::Positive => {}
            }
        }
    }
    Some(inside)
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
