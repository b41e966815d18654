//! From a mesh as a file has it to a polytope.
//!
//! A mesh whose facets and edges are all strictly convex is taken as it stands ([`strict`]). Otherwise,
//! where facets are coplanar or degenerate, the convex hull of its vertices is taken and the mesh is
//! compared with it: if every facet lies on the boundary of the hull, turned outwards, and the volumes
//! agree, the surface covers that boundary exactly once, and the hull is the polytope.
//!
//! A mesh that is to stay a mesh, of any shape, is mended by [`mend`], and its flat edges are joined by [`join`].

mod depth;
mod edges;
mod error;
mod flat;
mod join;
mod mend;
mod planar;
mod positions;
mod shape;
mod slack;
mod strict;
mod summary;
mod weld;

pub(crate) use shape::squared_distance;

pub use depth::hull_depth;
pub use error::{MeshError, Note};
pub use mend::{Hole, Mended, Mending};
pub use planar::corner_off_plane;
pub use summary::MeshSummary;

use crate::measure::signed_volume;
use crate::vectors::LazyVectors;
use crate::{PolygonMesh, Polytope, convex_hull};
use dcel::{Defect, FacetId, HalfedgeId, Mesh};
use exact::{Rational, Sign, Vector3};
use std::collections::HashMap;
use strict::Surface;
use weld::Compact;

impl Polytope {
    /// The polytope that a mesh bounds. What had to be mended is added to `notes`.
    ///
    /// Equal vertices are welded if the surface is not closed without that; unused vertices are
    /// dropped; a mesh that is inside out is turned; coplanar facets and collinear edges are joined.
    /// A mesh without facets stands for the convex hull of its points, one polygon for a polytope of
    /// dimension 2, facets of two vertices and no other for the segment that they make up. A surface
    /// that encloses no volume is read as what it covers.
    ///
    /// ```
    /// use exact::Point3;
    /// use splitstar_polytope::{PolygonMesh, Polytope};
    /// let mut mesh = PolygonMesh::default();
    /// mesh.points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [7, 7, 7]].map(Point3::from_i64).to_vec();
    /// for facet in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] {
    ///     mesh.facets.push(&facet);
    /// }
    /// let mut notes = Vec::new();
    /// let tetrahedron = Polytope::from_mesh(&mesh, &mut notes)?;
    /// assert_eq!(tetrahedron.volume().to_string(), "1/6");
    /// assert_eq!(notes[0].to_string(), "1 unused vertex dropped");
    /// # Ok::<(), splitstar_polytope::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// What keeps the mesh from being the boundary of a convex polytope: see [`MeshError`].
    ///
    /// # Complexity
    /// Linear if no two facets are coplanar; else that of a convex hull.
    pub fn from_mesh(mesh: &PolygonMesh, notes: &mut Vec<Note>) -> Result<Self, MeshError> {
        if mesh.points.is_empty() {
            return Err(MeshError::Empty);
        }
        if mesh.facets.is_empty() {
            notes.push(Note::PointSet);
            return convex_hull(&mesh.points).ok_or(MeshError::Empty);
        }
        check_corners(mesh)?;
        let edges_only = mesh.facets.iter().all(|corners| corners.len() == 2);
        if mesh.facets.len() == 1 && !edges_only {
            return from_polygon(mesh, notes);
        }
        let mut compact = Compact::new(mesh, notes);
        if edges_only {
            return flat::segment(&compact, notes);
        }
        check_loose(mesh)?;
        let halfedges =
            compact.close(3, notes).map_err(|defect| MeshError::NotClosed(named(defect, &compact)))?;
        Check { mesh: halfedges, compact, notes }.polytope()
    }
}

/// Every corner must be a vertex.
fn check_corners(mesh: &PolygonMesh) -> Result<(), MeshError> {
    let vertices = mesh.points.len();
    if mesh.facets.corners().iter().all(|&v| (v as usize) < vertices) {
        return Ok(());
    }
    let bad = |&v: &u32| v as usize >= vertices;
    let found = mesh.facets.iter().enumerate().find_map(|(f, c)| Some((f, *c.iter().find(|v| bad(v))?)));
    let (facet, index) = found.expect("one of the corners is no vertex");
    Err(MeshError::NoSuchVertex { facet: facet as u32, index })
}

/// There must be no facet of two vertices.
fn check_loose(mesh: &PolygonMesh) -> Result<(), MeshError> {
    match mesh.facets.iter().position(|corners| corners.len() < 3) {
        Some(f) => Err(MeshError::LooseEdge { facet: f as u32 }),
        None => Ok(()),
    }
}

fn closed(compact: &Compact) -> Result<Mesh, Defect> {
    Mesh::from_cycles(compact.points.len(), compact.facets.starts(), compact.facets.corners())
}

/// The defect with the names of the mesh that was given.
fn named(defect: Defect, compact: &Compact) -> Defect {
    let v = |vertex: u32| compact.vertex_names[vertex as usize];
    let f = |facet: u32| compact.facet_names[facet as usize];
    match defect {
        Defect::Border { edge, facet } => Defect::Border { edge: edge.map(v), facet: f(facet) },
        Defect::Orientation { edge, facets } => {
            Defect::Orientation { edge: edge.map(v), facets: facets.map(f) }
        }
        Defect::NonManifoldEdge { edge, facets } => Defect::NonManifoldEdge { edge: edge.map(v), facets },
        Defect::NonManifoldVertex { vertex } => Defect::NonManifoldVertex { vertex: v(vertex) },
        Defect::DegenerateCycle { facet } => Defect::DegenerateCycle { facet: f(facet) },
        other => other,
    }
}

/// One polygon and nothing else: both of its sides form a surface.
fn from_polygon(mesh: &PolygonMesh, notes: &mut Vec<Note>) -> Result<Polytope, MeshError> {
    let mut both = mesh.clone();
    let mut back = mesh.facets.get(0).to_vec();
    back.reverse();
    both.facets.push(&back);
    let mut found = Vec::new();
    let polytope = Polytope::from_mesh(&both, &mut found).map_err(|error| match error {
        MeshError::NotOnHull { .. } => match flat::reflex_corner(&mesh.points, mesh.facets.get(0)) {
            Some(vertex) => MeshError::ReflexCorner { facet: 0, vertex },
            None => MeshError::NotOnHull { facet: 0 },
        },
        other => other,
    })?;
    // That it has no volume is how it was meant, and the back facet is ours.
    notes.extend(found.into_iter().filter_map(|note| match note {
        Note::Flat { dimension: 2 } => None,
        Note::Joined { from: [v, n], to: [w, m] } => {
            (v != w).then_some(Note::Joined { from: [v, n / 2], to: [w, m] })
        }
        other => Some(other),
    }));
    Ok(polytope)
}

struct Check<'n> {
    mesh: Mesh,
    compact: Compact,
    notes: &'n mut Vec<Note>,
}

impl Check<'_> {
    fn polytope(mut self) -> Result<Polytope, MeshError> {
        let mut surface = self.surface()?;
        let mut turns = surface.turns();
        if turns.reflex > 0 && (turns.convex == 0 || self.volume().sign() == Sign::Negative) {
            drop(surface);
            self.turn_round();
            surface = self.surface()?;
            turns = surface.turns();
        }
        if let Some(h) = turns.first_reflex {
            return Err(self.reflex(h));
        }
        if turns.flat == 0 && surface.facets_are_convex() {
            // With more than one shell, the surface winds around more than once.
            if let Err(f) = surface.winds_once() {
                self.one_shell()?;
                return Err(self.not_on_hull(f));
            }
            let Surface { edges, normals, .. } = surface;
            let Self { mesh, compact, .. } = self;
            return Ok(Polytope {
                dimension: 3,
                points: compact.points,
                mesh,
                vectors: LazyVectors::given(edges, normals),
            });
        }
        drop(surface);
        self.one_shell()?;
        self.compare_with_hull()
    }

    fn one_shell(&self) -> Result<(), MeshError> {
        let (label, shells) = self.mesh.components();
        match label.iter().position(|&shell| shell == 1) {
            None => Ok(()),
            Some(other) => {
                let facets = [0, other].map(|f| self.compact.facet_names[f]);
                Err(MeshError::SeveralShells { shells, facets })
            }
        }
    }

    fn surface(&self) -> Result<Surface<'_>, MeshError> {
        Surface::new(&self.compact.points, &self.mesh).map_err(|error| match error {
            MeshError::NonPlanar { facet, vertex, squared_distance } => MeshError::NonPlanar {
                facet: self.compact.facet_names[facet as usize],
                vertex: self.compact.vertex_names[vertex as usize],
                squared_distance,
            },
            other => other,
        })
    }

    fn volume(&self) -> Rational {
        signed_volume(&self.compact.points, &self.compact.facets)
    }

    fn turn_round(&mut self) {
        self.compact.reverse();
        self.mesh = closed(&self.compact).expect("a closed surface stays closed when it is turned round");
        self.notes.push(Note::TurnedInsideOut);
    }

    fn reflex(&self, h: HalfedgeId) -> MeshError {
        let vertex = |v: dcel::VertexId| self.compact.vertex_names[v.index()];
        MeshError::ReflexEdge {
            edge: [vertex(self.mesh.source(h)), vertex(self.mesh.target(h))],
            facets: [h, h.twin()].map(|h| self.compact.facet_names[self.mesh.facet(h).index()]),
        }
    }

    fn not_on_hull(&self, f: FacetId) -> MeshError {
        MeshError::NotOnHull { facet: self.compact.facet_names[f.index()] }
    }

    /// Takes the convex hull, and checks that the surface is its boundary.
    fn compare_with_hull(self) -> Result<Polytope, MeshError> {
        let hull = convex_hull(&self.compact.points).ok_or(MeshError::Empty)?;
        let surface = self.surface()?;
        match hull.dimension {
            3 => {
                if let Some(f) = first_off_hull(&surface, &hull) {
                    return Err(self.not_on_hull(f));
                }
                if hull.volume() != self.volume() {
                    return Err(self.not_on_hull(FacetId(0)));
                }
                let counts = hull.counts();
                self.notes.push(Note::Joined {
                    from: [self.compact.points.len(), self.mesh.facet_count()],
                    to: [counts.vertices, counts.facets],
                });
            }
            2 => {
                if !flat::covers_once(&surface, &self.compact, &hull) {
                    return Err(self.not_on_hull(FacetId(0)));
                }
                self.notes.push(Note::Flat { dimension: 2 });
                if self.compact.points.len() != hull.points.len() {
                    self.notes.push(Note::Joined {
                        from: [self.compact.points.len(), self.mesh.facet_count()],
                        to: [hull.points.len(), 1],
                    });
                }
            }
            dimension => self.notes.push(Note::Flat { dimension }),
        }
        Ok(hull)
    }
}

/// The first facet of the surface that does not lie on the facet of the hull with the same normal.
fn first_off_hull(surface: &Surface<'_>, hull: &Polytope) -> Option<FacetId> {
    let key = |normal: &Vector3| normal.primitive().coordinates();
    let by_normal: HashMap<_, _> = hull.mesh.facets().map(|f| (key(hull.facet_normal(f)), f)).collect();
    surface.mesh.facets().find(|f| {
        let normal = &surface.normals[f.index()];
        if normal.is_zero() {
            return false; // a facet without area covers nothing
        }
        let corner = &surface.points[surface.mesh.source(surface.mesh.boundary(*f)).index()];
        by_normal.get(&key(normal)).is_none_or(|&g| {
            let on = &hull.points[hull.mesh.source(hull.mesh.boundary(g)).index()];
            exact::predicate::plane_side(hull.facet_normal(g), on, corner) != Sign::Zero
        })
    })
}
