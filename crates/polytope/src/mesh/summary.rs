//! Facts about any mesh, convex or not, closed or not.

use super::weld::Compact;
use super::{MeshError, Note, closed};
use crate::measure::{Bounds, signed_volume};
use crate::{Facets, PolygonMesh, Polytope, convex_hull};
use dcel::Mesh;
use exact::{Point3, Rational, Sign, Vector3, predicate};
use std::collections::{HashMap, HashSet};

/// What a mesh is.
#[derive(Clone, Debug)]
pub struct MeshSummary {
    /// Vertices, equal ones counted once, without those inside a flat facet or a straight edge.
    pub vertices: usize,
    /// Edges, without those between coplanar facets, collinear neighbours counted once.
    pub edges: usize,
    /// Facets, connected coplanar ones counted once.
    pub facets: usize,
    /// The dimension of the affine hull; none for no point.
    pub dimension: Option<u8>,
    /// Whether it is the boundary of a convex polytope (of any dimension).
    pub convex: bool,
    /// Whether every edge joins two facets and every vertex has one cycle of facets.
    pub closed: bool,
    /// The number of connected pieces of the surface.
    pub components: usize,
    /// The genus of each piece; none for a piece with a border or a non-manifold edge.
    pub genus: Vec<Option<u32>>,
    /// The enclosed volume; none if the surface is not closed or has non-planar facets.
    pub volume: Option<Rational>,
    /// The smallest box; none for no point.
    pub bounds: Option<Bounds>,
    /// What had to be mended to say so.
    pub notes: Vec<Note>,
    /// Why it is not convex.
    pub defect: Option<MeshError>,
}

impl MeshSummary {
    /// Collects the facts.
    ///
    /// ```
    /// use exact::Point3;
    /// use splitstar_polytope::{MeshSummary, PolygonMesh};
    /// let mut mesh = PolygonMesh::default();
    /// mesh.points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map(Point3::from_i64).to_vec();
    /// mesh.facets.push(&[0, 1, 2]);
    /// mesh.facets.push(&[0, 2, 3]);
    /// let facts = MeshSummary::of(&mesh);
    /// // Two triangles of a square: one facet, four edges, a border all around.
    /// assert_eq!([facts.vertices, facts.edges, facts.facets], [4, 4, 1]);
    /// assert!(!facts.closed && facts.volume.is_none());
    /// ```
    ///
    /// # Panics
    /// If a corner of a facet is no vertex.
    ///
    /// # Complexity
    /// Linear, but for a convex hull where facets are coplanar.
    pub fn of(mesh: &PolygonMesh) -> Self {
        let mut notes = Vec::new();
        let defect = match Polytope::from_mesh(mesh, &mut notes) {
            Ok(polytope) => return Self::of_polytope(&polytope, notes),
            Err(defect) => defect,
        };
        let compact = Compact::new(mesh);
        if mesh.facets.iter().all(|corners| corners.len() == 2) {
            return Self::of_edges(&compact, notes, defect);
        }
        let mut surface = closed(&compact).ok();
        let mut welded = compact.weld();
        if surface.is_none() && welded.points.len() < compact.points.len() {
            surface = closed(&welded).ok();
        } else {
            welded = compact;
        }
        let (components, genus) = match &surface {
            Some(halfedges) => genera(halfedges),
            None => {
                let pieces = pieces(&welded.facets);
                (pieces, vec![None; pieces])
            }
        };
        let planar = !matches!(defect, MeshError::NonPlanar { .. });
        let volume = surface.is_some() && planar;
        let [vertices, edges, facets] = Merged::new(&welded.points, &welded.facets).counts();
        Self {
            vertices,
            edges,
            facets,
            dimension: convex_hull(&welded.points).map(|hull| hull.dimension),
            convex: false,
            closed: surface.is_some(),
            components,
            genus,
            volume: volume.then(|| signed_volume(&welded.points, &welded.facets).abs()),
            bounds: Bounds::of(&welded.points),
            notes,
            defect: Some(defect),
        }
    }

    /// Of facets of two vertices that are not one segment.
    fn of_edges(compact: &Compact, notes: Vec<Note>, defect: MeshError) -> Self {
        let welded = compact.weld_labels();
        let mut groups = Groups::new(welded.len());
        let mut edges = HashSet::new();
        for ends in compact.facets.iter() {
            let [a, b] = [ends[0], ends[1]].map(|v| welded[v as usize]);
            groups.join(a as usize, b as usize);
            if a != b {
                edges.insert([a.min(b), a.max(b)]);
            }
        }
        // Vertices at the position of another one have no group of their own.
        let vertices = welded.iter().enumerate().filter(|(v, label)| *v == **label as usize).count();
        let components = groups.count() - (welded.len() - vertices);
        Self {
            vertices,
            edges: edges.len(),
            facets: 0,
            dimension: convex_hull(&compact.points).map(|hull| hull.dimension),
            convex: false,
            closed: false,
            components,
            genus: vec![None; components],
            volume: None,
            bounds: Bounds::of(&compact.points),
            notes,
            defect: Some(defect),
        }
    }

    fn of_polytope(polytope: &Polytope, notes: Vec<Note>) -> Self {
        let counts = polytope.counts();
        Self {
            vertices: counts.vertices,
            edges: counts.edges,
            facets: counts.facets,
            dimension: Some(polytope.dimension),
            convex: true,
            closed: true,
            components: 1,
            genus: vec![Some(0)],
            volume: Some(polytope.volume()),
            bounds: Some(polytope.bounds()),
            notes,
            defect: None,
        }
    }
}

/// The components of a closed surface and their genera.
fn genera(mesh: &Mesh) -> (usize, Vec<Option<u32>>) {
    let (label, count) = mesh.components();
    let mut euler = vec![0i64; count as usize];
    for f in mesh.facets() {
        euler[label[f.index()] as usize] += 1;
    }
    for h in mesh.edges() {
        euler[label[mesh.facet(h).index()] as usize] -= 1;
    }
    for v in mesh.vertices() {
        euler[label[mesh.facet(mesh.outgoing(v)).index()] as usize] += 1;
    }
    (count as usize, euler.into_iter().map(|e| u32::try_from((2 - e) / 2).ok()).collect())
}

/// The number of pieces of a surface with borders, joined across edges of any number of facets.
fn pieces(facets: &Facets) -> usize {
    let mut groups = Groups::new(facets.len());
    for sides in edge_table(facets).values() {
        sides.windows(2).for_each(|pair| groups.join(pair[0].0, pair[1].0));
    }
    groups.count()
}

/// For every edge (lower end first) the facets that have it, and whether from the lower end.
fn edge_table(facets: &Facets) -> HashMap<[u32; 2], Vec<(usize, bool)>> {
    let mut table: HashMap<[u32; 2], Vec<(usize, bool)>> = HashMap::new();
    for (f, cycle) in facets.iter().enumerate() {
        for i in 0..cycle.len() {
            let (a, b) = (cycle[i], cycle[(i + 1) % cycle.len()]);
            table.entry([a.min(b), a.max(b)]).or_default().push((f, a < b));
        }
    }
    table
}

/// The cells that remain when coplanar neighbours and collinear edges are joined.
struct Merged<'m> {
    points: &'m [Point3],
    facets: &'m Facets,
    normals: Vec<Option<Vector3>>,
}

impl<'m> Merged<'m> {
    fn new(points: &'m [Point3], facets: &'m Facets) -> Self {
        let normal = |cycle: &[u32]| {
            let corner = |i: usize| &points[cycle[i % cycle.len()] as usize];
            let side = |i: usize| corner(i).direction_to(corner(i + 1));
            let cross = |i: usize| side(i).cross(&side(i + 1));
            // The corner at the lexicographically highest vertex that is not straight is convex.
            let mut order: Vec<usize> = (0..cycle.len()).collect();
            order.sort_by(|&i, &j| corner(j + 1).cmp(corner(i + 1)));
            order.into_iter().map(cross).find(|n| !n.is_zero())
        };
        Self { points, facets, normals: facets.iter().map(normal).collect() }
    }

    fn coplanar(&self, f: usize, g: usize) -> bool {
        let (Some(m), Some(n)) = (&self.normals[f], &self.normals[g]) else { return true };
        if !m.cross(n).is_zero() || predicate::same_direction(m, n) != Sign::Positive {
            return false;
        }
        let point = |f: usize| &self.points[self.facets.get(f)[0] as usize];
        predicate::plane_side(m, point(f), point(g)) == Sign::Zero
    }

    fn counts(&self) -> [usize; 3] {
        let mut groups = Groups::new(self.facets.len());
        let mut left: HashMap<u32, Vec<u32>> = HashMap::new();
        let mut edges = 0;
        for v in self.facets.corners() {
            left.entry(*v).or_default();
        }
        for ([a, b], sides) in edge_table(self.facets) {
            match sides[..] {
                [(f, up), (g, other)] if up != other && self.coplanar(f, g) => groups.join(f, g),
                _ => {
                    edges += 1;
                    left.entry(a).or_default().push(b);
                    left.entry(b).or_default().push(a);
                }
            }
        }
        let mut vertices = 0;
        for (v, neighbours) in &left {
            let at = |w: u32| self.points[*v as usize].direction_to(&self.points[w as usize]);
            match neighbours[..] {
                [] => {}
                [a, b] if at(a).cross(&at(b)).is_zero() => edges -= 1,
                _ => vertices += 1,
            }
        }
        [vertices, edges, groups.count()]
    }
}

/// Disjoint sets of facets or vertices.
struct Groups {
    parent: Vec<usize>,
    count: usize,
}

impl Groups {
    fn new(size: usize) -> Self {
        Self { parent: (0..size).collect(), count: size }
    }

    fn find(&mut self, mut f: usize) -> usize {
        while self.parent[f] != f {
            self.parent[f] = self.parent[self.parent[f]];
            f = self.parent[f];
        }
        f
    }

    fn join(&mut self, f: usize, g: usize) {
        let (f, g) = (self.find(f), self.find(g));
        if f != g {
            self.parent[f] = g;
            self.count -= 1;
        }
    }

    fn count(&self) -> usize {
        self.count
    }
}
