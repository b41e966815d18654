//! From vertices with their rays to the polytope.

use super::{Ray, Traversal};
use crate::Polytope;
use crate::polytope::corner_normal;
use crate::vectors::{LazyVectors, VectorList};
use dcel::{FacetId, HalfedgeId, Mesh, VertexId};
use exact::Point3;

impl Traversal<'_> {
    /// The polytope of all that was found. The rays at any vertex tell the dimension.
    pub(super) fn assemble(self) -> Polytope {
        let points = self.points();
        match self.rays(0).len() {
            0 => Polytope::point(points[0].clone()),
            1 => {
                let [source, target] = <[Point3; 2]>::try_from(points).expect("a segment has two vertices");
                Polytope::segment(source, target)
            }
            2 => Polytope::polygon(self.outline().map(|v| points[v as usize].clone()).collect()),
            _ => self.solid(points),
        }
    }

    /// The vertices of a polygon in order.
    fn outline(&self) -> impl Iterator<Item = u32> + '_ {
        let mut previous = self.rays(0)[1].target;
        let mut at = Some(0);
        std::iter::from_fn(move || {
            let v = at?;
            let [a, b]: [Ray; 2] =
                self.rays(v as usize).try_into().expect("a polygon has two edges at a vertex");
            let next = if a.target == previous { b.target } else { a.target };
            previous = v;
            at = (next != 0).then_some(next);
            Some(v)
        })
    }

    fn solid(&self, points: Vec<Point3>) -> Polytope {
        let (halfedges, sources) = self.pair();
        // The halfedge to the left of each one, around its source.
        let mut left = vec![HalfedgeId(0); halfedges.len()];
        for v in 0..points.len() {
            let of_vertex = &halfedges[self.starts[v]..self.starts[v + 1]];
            for (ray, h) in self.rays(v).iter().zip(of_vertex) {
                left[h.index()] = of_vertex[ray.left as usize];
            }
        }
        // The facet on the left of h lies between h and the halfedge to the left: the twin of that one
        // comes before h.
        let mut facets = vec![FacetId::NONE; left.len()];
        let mut facet_count = 0;
        for first in 0..left.len() {
            let mut h = first;
            if facets[h] != FacetId::NONE {
                continue;
            }
            while facets[h] == FacetId::NONE {
                facets[h] = FacetId::new(facet_count);
                h = left[h].twin().index();
            }
            facet_count += 1;
        }
        let mut even = vec![0; halfedges.len() / 2];
        for (ray, h) in self.rays.iter().zip(&halfedges).filter(|(_, h)| h.0 & 1 == 0) {
            even[h.edge()] = ray.direction;
        }
        let edges: VectorList =
            even.into_iter().map(|direction| self.directions.vector(direction).clone()).collect();
        let mesh = Mesh::from_halfedges(points.len(), facet_count, sources, facets);
        let normals = mesh.facets().map(|f| corner_normal(&mesh, &edges, mesh.boundary(f))).collect();
        Polytope { dimension: 3, points, mesh, vectors: LazyVectors::given(edges, normals) }
    }

    /// Numbers the halfedges: those of all rays in their order, and the source of each halfedge. The
    /// even halfedge of an edge starts at the vertex that was met first.
    fn pair(&self) -> (Vec<HalfedgeId>, Vec<VertexId>) {
        let mut halfedges = vec![HalfedgeId::NONE; self.rays.len()];
        let mut sources = Vec::with_capacity(self.rays.len());
        for v in 0..self.starts.len() - 1 {
            for (r, ray) in (self.starts[v]..).zip(self.rays(v)) {
                let target = ray.target as usize;
                if target < v {
                    continue;
                }
                let twin = self
                    .rays(target)
                    .binary_search_by_key(&(ray.direction ^ 1), |ray| ray.direction)
                    .expect("an edge of the sum is found from both of its ends");
                let h = HalfedgeId::new(sources.len());
                sources.extend([VertexId::new(v), VertexId(ray.target)]);
                halfedges[r] = h;
                halfedges[self.starts[target] + twin] = h.twin();
            }
        }
        (halfedges, sources)
    }
}
