//! Any mesh made fit for use, without a tolerance: what every operation does that reads one.

use super::join::{Joined, join};
use super::shape::Shape;
use super::weld::Compact;
use super::{MeshError, Note, check_corners, check_loose};
use crate::measure::signed_volume;
use crate::{Facets, HoleError, PolygonMesh, triangulate_with_holes};
use exact::Sign;

/// What is mended besides what always is; by default nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[non_exhaustive]
pub struct Mending<'l> {
    /// Whether flat edges are joined: coplanar neighbors that face the same side become one facet, and
    /// collinear edges one edge. Facets without area go with that.
    pub join: bool,
    /// A label for each facet of the mesh that is given, its object for example: only facets with equal labels
    /// become one. None if any may.
    pub labels: Option<&'l [u32]>,
}

impl<'l> Mending<'l> {
    /// Nothing more.
    pub const fn new() -> Self {
        Self { join: false, labels: None }
    }

    /// Joins flat edges.
    pub const fn joining() -> Self {
        Self { join: true, labels: None }
    }

    /// The same, but no two facets become one that have different labels: there is one for each facet.
    #[must_use]
    pub const fn within(self, labels: &'l [u32]) -> Self {
        Self { labels: Some(labels), ..self }
    }
}

/// A mesh that was mended, with the way back to the one that was given.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Mended {
    /// The vertices, and the outer cycles of the facets.
    pub mesh: PolygonMesh,
    /// The holes, sorted by their facets. Only joining makes some.
    pub holes: Vec<Hole>,
    /// For each facet the first one in the given mesh that it was made from.
    pub facet_origin: Vec<u32>,
    /// For each vertex the first one in the given mesh that it was made from.
    pub vertex_origin: Vec<u32>,
}

/// A hole of a facet.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Hole {
    /// The facet.
    pub facet: u32,
    /// Its vertices, clockwise seen from outside. Two for an edge inside the facet, or from its boundary
    /// inwards, at which other facets meet it.
    pub cycle: Vec<u32>,
}

impl PolygonMesh {
    /// Mends what can be mended without a tolerance, whatever the mesh is: convex or not, closed or not. What
    /// was mended is added to `notes`.
    ///
    /// 1. Vertices on no facet are dropped. If there is no facet, all are kept but repeated ones.
    /// 2. If the facets do not form a closed surface by their indices, vertices at equal positions are
    ///    welded. Facets that are left with fewer than three vertices go.
    /// 3. If the surface encloses a negative volume, all facets are turned round. So a void stays a void.
    /// 4. On demand, flat edges are joined ([`Mending::join`]), perhaps of facets with equal labels only
    ///    ([`Mending::labels`]). A facet may have holes then; its cycles are simple, and may touch one another at
    ///    vertices.
    ///
    /// Degenerate: a surface that encloses no volume keeps its orientation, and so does one with borders.
    /// Facets without area are kept unless flat edges are joined; then a vertex of theirs that lies inside an
    /// edge of a neighbor becomes a vertex of the neighbor, whatever the labels. If no facet has area, none of
    /// them goes. A vertex inside a straight edge goes from the facets of all labels at once. Facets
    /// of two vertices are kept, if there are no others.
    ///
    /// ```
    /// use exact::Point3;
    /// use splitstar_polytope::{Mending, PolygonMesh};
    /// let mut mesh = PolygonMesh::default();
    /// mesh.points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [7, 7, 7]].map(Point3::from_i64).to_vec();
    /// mesh.facets.push(&[0, 1, 2]);
    /// mesh.facets.push(&[0, 2, 3]);
    /// let mut notes = Vec::new();
    /// let square = mesh.mended(Mending::joining(), &mut notes)?;
    /// assert_eq!(square.mesh.facets.get(0), [0, 1, 2, 3]);
    /// assert_eq!(notes[0].to_string(), "1 unused vertex dropped");
    /// # Ok::<(), splitstar_polytope::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// No vertex, an index that is none, a facet of two vertices beside larger ones, or a facet of four or
    /// more corners that do not lie in one plane ([`triangulated`](Self::triangulated) is a way out).
    ///
    /// # Panics
    /// If there are labels, but not one for each facet.
    ///
    /// # Complexity
    /// `n log n`, and about ten times the memory of the mesh.
    pub fn mended(&self, what: Mending<'_>, notes: &mut Vec<Note>) -> Result<Mended, MeshError> {
        if let Some(labels) = what.labels {
            assert_eq!(labels.len(), self.facets.len(), "there is a label for each facet");
        }
        if self.points.is_empty() {
            return Err(MeshError::Empty);
        }
        check_corners(self)?;
        let mut compact = Compact::new(self, notes);
        if self.facets.is_empty() {
            compact.weld(0, notes);
            return Ok(compact.into());
        }
        if self.facets.iter().all(|cycle| cycle.len() == 2) {
            compact.weld(2, notes);
            return Ok(compact.into());
        }
        check_loose(self)?;
        let closed = compact.close(3, notes).is_ok();
        check_planar(&compact)?;
        if (closed || compact.is_balanced())
            && signed_volume(&compact.points, &compact.facets).sign() == Sign::Negative
        {
            compact.reverse();
            notes.push(Note::TurnedInsideOut);
        }
        if !what.join {
            return Ok(compact.into());
        }
        let from = [compact.points.len(), compact.facets.len()];
        let joined = join(compact, what.labels);
        let to = [joined.compact.points.len(), joined.compact.facets.len()];
        if from != to {
            notes.push(Note::Joined { from, to });
        }
        Ok(joined.into())
    }
}

/// Every facet must lie in a plane.
fn check_planar(compact: &Compact) -> Result<(), MeshError> {
    for (f, cycle) in compact.facets.iter().enumerate().filter(|(_, cycle)| cycle.len() > 3) {
        if let Shape::Bent { vertex, squared_distance } = Shape::of(&compact.points, cycle) {
            return Err(MeshError::NonPlanar {
                facet: compact.facet_names[f],
                vertex: compact.vertex_names[vertex as usize],
                squared_distance,
            });
        }
    }
    Ok(())
}

impl Mended {
    /// The holes of a facet.
    pub fn holes_of(&self, facet: usize) -> &[Hole] {
        let start = self.holes.partition_point(|hole| (hole.facet as usize) < facet);
        let count = self.holes[start..].partition_point(|hole| hole.facet as usize == facet);
        &self.holes[start..start + count]
    }

    /// The same with every facet that has holes cut into triangles, which take its place in the list.
    ///
    /// # Errors
    /// The first facet that cannot be cut, by its index here: its boundary crosses itself.
    pub fn without_holes(self) -> Result<Self, (u32, HoleError)> {
        if self.holes.is_empty() {
            return Ok(self);
        }
        let corners = self.mesh.facets.corners().len() + 3 * self.holes.len();
        let mut facets = Facets::with_capacity(self.mesh.facets.len(), corners);
        let mut facet_origin = Vec::with_capacity(self.facet_origin.len());
        for (f, cycle) in self.mesh.facets.iter().enumerate() {
            let holes: Vec<&[u32]> = self.holes_of(f).iter().map(|hole| &hole.cycle[..]).collect();
            if holes.is_empty() {
                facets.push(cycle);
            } else {
                let triangles = triangulate_with_holes(&self.mesh.points, cycle, &holes);
                triangles.map_err(|error| (f as u32, error))?.iter().for_each(|t| facets.push(t));
            }
            facet_origin.resize(facets.len(), self.facet_origin[f]);
        }
        let mesh = PolygonMesh { points: self.mesh.points, facets };
        Ok(Self { mesh, holes: Vec::new(), facet_origin, vertex_origin: self.vertex_origin })
    }
}

impl From<Compact> for Mended {
    fn from(compact: Compact) -> Self {
        let Compact { points, facets, vertex_names, facet_names } = compact;
        Self {
            mesh: PolygonMesh { points, facets },
            holes: Vec::new(),
            facet_origin: facet_names,
            vertex_origin: vertex_names,
        }
    }
}

impl From<Joined> for Mended {
    fn from(joined: Joined) -> Self {
        let hole = |(&facet, cycle): (&u32, &[u32])| Hole { facet, cycle: cycle.to_vec() };
        let holes = joined.hole_facets.iter().zip(joined.holes.iter()).map(hole).collect();
        Self { holes, ..joined.compact.into() }
    }
}
