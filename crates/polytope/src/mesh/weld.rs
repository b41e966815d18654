//! Vertices at equal positions made one, unused ones dropped.

use super::edges::{EdgeTable, Groups};
use super::positions::first_at_position;
use super::{Note, closed};
use crate::{Facets, PolygonMesh};
use dcel::{Defect, Mesh};
use exact::{Point3, share_weight};

/// A mesh in which every vertex is used, with the way back to the mesh it came from.
pub(super) struct Compact {
    pub(super) points: Vec<Point3>,
    pub(super) facets: Facets,
    /// The index in the given mesh of each vertex (the first one of those welded).
    pub(super) vertex_names: Vec<u32>,
    /// The index in the given mesh of each facet.
    pub(super) facet_names: Vec<u32>,
}

impl Compact {
    /// Drops the vertices that are on no facet, and gives the points one weight if that keeps them
    /// narrow. If there is no facet, all vertices are kept.
    pub(super) fn new(mesh: &PolygonMesh, notes: &mut Vec<Note>) -> Self {
        let mut compact = Self {
            points: mesh.points.clone(),
            facets: mesh.facets.clone(),
            vertex_names: (0..mesh.points.len() as u32).collect(),
            facet_names: (0..mesh.facets.len() as u32).collect(),
        };
        if !mesh.facets.is_empty() {
            compact.drop_unused(&[]);
        }
        let vertices = mesh.points.len() - compact.points.len();
        if vertices > 0 {
            notes.push(Note::Unused { vertices });
        }
        share_weight(&mut compact.points);
        compact
    }

    /// Drops the vertices that are neither on a facet nor in one of the other cycles, and gives those that
    /// are kept their new index.
    pub(super) fn drop_unused(&mut self, others: &[&[u32]]) -> Option<Vec<u32>> {
        let mut used = vec![false; self.points.len()];
        let corners = self.facets.corners().iter().chain(others.iter().copied().flatten());
        corners.for_each(|&v| used[v as usize] = true);
        if !used.contains(&false) {
            return None;
        }
        let mut kept = 0;
        let label: Vec<u32> = used
            .iter()
            .map(|&used| {
                kept += u32::from(used);
                if used { kept - 1 } else { u32::MAX }
            })
            .collect();
        let keep = |v: &mut usize| {
            *v += 1;
            used[*v - 1]
        };
        let (mut v, mut w) = (0, 0);
        self.points.retain(|_| keep(&mut v));
        self.vertex_names.retain(|_| keep(&mut w));
        self.facets.relabel(&label);
        Some(label)
    }

    /// The closed surface of the facets by their indices, or else after vertices at equal positions are
    /// welded. Facets with less than `least` different corners in a row go with that.
    pub(super) fn close(&mut self, least: usize, notes: &mut Vec<Note>) -> Result<Mesh, Defect> {
        if let Ok(halfedges) = closed(self) {
            return Ok(halfedges);
        }
        self.weld(least, notes);
        closed(self)
    }

    /// Makes vertices at equal positions one.
    pub(super) fn weld(&mut self, least: usize, notes: &mut Vec<Note>) {
        let label = self.weld_labels();
        let from = self.points.len();
        let to = (0_u32..).zip(&label).filter(|(v, label)| v == *label).count();
        let collapsed = self.merge(&label, least);
        if to < from {
            notes.push(Note::Welded { from, to });
        }
        if collapsed > 0 {
            notes.push(Note::Collapsed { facets: collapsed });
        }
    }

    /// Makes the ends of every edge without length one vertex.
    pub(super) fn contract(&mut self) {
        let mut groups = Groups::new(self.points.len());
        for cycle in self.facets.iter() {
            for (i, &a) in cycle.iter().enumerate() {
                let b = cycle[(i + 1) % cycle.len()];
                if self.points[a as usize] == self.points[b as usize] {
                    groups.join(a as usize, b as usize);
                }
            }
        }
        if groups.count() < self.points.len() {
            let label: Vec<u32> = (0..self.points.len()).map(|v| groups.find(v) as u32).collect();
            self.merge(&label, 3);
        }
    }

    /// Makes each vertex the one that `label` names. Corners that become equal to the one before them go, and
    /// so do facets that are left with too few, whose number is given, and vertices that are on no facet then
    /// (but not if there is no facet any more).
    fn merge(&mut self, label: &[u32], least: usize) -> usize {
        let mut facets = Facets::with_capacity(self.facets.len(), self.facets.corners().len());
        let mut facet_names = Vec::with_capacity(self.facets.len());
        let mut cycle: Vec<u32> = Vec::new();
        for (f, corners) in self.facets.iter().enumerate() {
            cycle.clear();
            for &corner in corners {
                let corner = label[corner as usize];
                if cycle.last() != Some(&corner) {
                    cycle.push(corner);
                }
            }
            while cycle.len() > 1 && cycle.first() == cycle.last() {
                cycle.pop();
            }
            if cycle.len() >= least {
                facets.push(&cycle);
                facet_names.push(self.facet_names[f]);
            }
        }
        let collapsed = self.facets.len() - facets.len();
        (self.facets, self.facet_names) = (facets, facet_names);
        if self.facets.is_empty() {
            let distinct: Vec<u32> = (0_u32..).zip(label).filter(|(v, l)| v == *l).map(|(v, _)| v).collect();
            self.drop_unused(&[&distinct]);
        } else {
            self.drop_unused(&[]);
        }
        collapsed
    }

    /// For each vertex the first one at the same position.
    pub(super) fn weld_labels(&self) -> Vec<u32> {
        first_at_position(&self.points)
    }

    /// Whether the facets enclose a volume, with any number of facets at an edge.
    pub(super) fn is_balanced(&self) -> bool {
        EdgeTable::new(self.points.len(), &self.facets).is_balanced()
    }

    pub(super) fn reverse(&mut self) {
        self.facets.reverse();
    }
}
