//! Facts about any mesh, convex or not, closed or not.

use super::edges::{EdgeTable, Groups};
use super::join::join;
use super::weld::Compact;
use super::{MeshError, Note};
use crate::measure::{Bounds, signed_volume};
use crate::{PolygonMesh, Polytope, convex_hull};
use dcel::Mesh;
use exact::Rational;
use std::collections::HashSet;

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
        let mut compact = Compact::new(mesh, &mut Vec::new());
        if mesh.facets.iter().all(|corners| corners.len() == 2) {
            return Self::of_edges(&compact, notes, defect);
        }
        let surface = match defect {
            MeshError::LooseEdge { .. } => None,
            _ => compact.close(3, &mut Vec::new()).ok(),
        };
        let (components, genus) = match &surface {
            Some(halfedges) => genera(halfedges),
            None => {
                let pieces = EdgeTable::new(compact.points.len(), &compact.facets).pieces();
                (pieces, vec![None; pieces])
            }
        };
        let planar = !matches!(defect, MeshError::NonPlanar { .. });
        let volume = surface.is_some() && planar;
        let volume = volume.then(|| signed_volume(&compact.points, &compact.facets).abs());
        let dimension = convex_hull(&compact.points).map(|hull| hull.dimension);
        let bounds = Bounds::of(&compact.points);
        let joined = join(compact, None);
        Self {
            vertices: joined.compact.points.len(),
            edges: joined.edges(),
            facets: joined.compact.facets.len(),
            dimension,
            convex: false,
            closed: surface.is_some(),
            components,
            genus,
            volume,
            bounds,
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
