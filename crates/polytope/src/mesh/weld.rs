//! Vertices at equal positions made one, unused ones dropped.

use crate::{Facets, PolygonMesh};
use exact::{Point3, share_weight};
use std::collections::HashMap;

/// A mesh in which every vertex is used, with the way back to the mesh it came from.
pub(super) struct Compact {
    pub(super) points: Vec<Point3>,
    pub(super) facets: Facets,
    /// The index in the given mesh of each vertex (the first one of those welded).
    pub(super) vertex_names: Vec<u32>,
    /// The index in the given mesh of each facet.
    pub(super) facet_names: Vec<u32>,
    /// How many vertices were on no facet.
    pub(super) unused: usize,
}

impl Compact {
    /// Drops the vertices that are on no facet, and gives the points one weight if that keeps them
    /// narrow.
    pub(super) fn new(mesh: &PolygonMesh) -> Self {
        let mut used = vec![false; mesh.points.len()];
        mesh.facets.corners().iter().for_each(|&v| used[v as usize] = true);
        let facet_names = (0..mesh.facets.len() as u32).collect();
        let (mut points, facets, vertex_names) = if used.contains(&false) {
            let mut label = vec![u32::MAX; used.len()];
            let mut names = Vec::new();
            for v in (0..used.len()).filter(|&v| used[v]) {
                label[v] = names.len() as u32;
                names.push(v as u32);
            }
            let points = names.iter().map(|&v| mesh.points[v as usize].clone()).collect();
            let mut facets = mesh.facets.clone();
            facets.relabel(&label);
            (points, facets, names)
        } else {
            (mesh.points.clone(), mesh.facets.clone(), (0..used.len() as u32).collect())
        };
        let unused = mesh.points.len() - vertex_names.len();
        share_weight(&mut points);
        Self { points, facets, vertex_names, facet_names, unused }
    }

    /// Makes vertices at equal positions one. Corners that become equal to the one before them go, and
    /// so do facets that are left with fewer than three corners.
    pub(super) fn weld(&self) -> Self {
        let mut first = HashMap::with_capacity(self.points.len());
        let mut label = Vec::with_capacity(self.points.len());
        let (mut points, mut vertex_names) = (Vec::new(), Vec::new());
        for (v, point) in self.points.iter().enumerate() {
            let index = *first.entry(point.canonical_key()).or_insert_with(|| {
                points.push(point.clone());
                vertex_names.push(self.vertex_names[v]);
                points.len() as u32 - 1
            });
            label.push(index);
        }
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
            if cycle.len() >= 3 {
                facets.push(&cycle);
                facet_names.push(self.facet_names[f]);
            }
        }
        Self { points, facets, vertex_names, facet_names, unused: self.unused }
    }

    /// For each vertex the first one at the same position.
    pub(super) fn weld_labels(&self) -> Vec<u32> {
        let mut first = HashMap::with_capacity(self.points.len());
        let label = |(v, point): (usize, &Point3)| *first.entry(point.canonical_key()).or_insert(v as u32);
        self.points.iter().enumerate().map(label).collect()
    }

    pub(super) fn reverse(&mut self) {
        self.facets.reverse();
    }
}
