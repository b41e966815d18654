//! The closest feature of M.
//!
//! The walk goes from feature to feature, each nearer to the point, until the point lies in the Voronoi region of the
//! feature. It begins at a feature of a *visible* facet (one that has the point above it) and stays with these:
//!
//! | from | to | why it is nearer |
//! |---|---|---|
//! | facet | the edge or the vertex of its boundary nearest to the point | as near as the closed facet |
//! | edge | an end, if the point projects on it or beyond | as near as the closed edge |
//! | edge | a visible facet of the edge, if the point projects to the side of the facet | strictly nearer |
//! | vertex | an edge of a visible facet, if the point projects beyond the vertex on it | strictly nearer |
//!
//! The steps that are not strict go down in dimension, so the walk ends. It ends at the right place:
//!
//! * An edge with a visible facet f and a facet g that is not. If the point projects to the side of g, the dihedral angle is acute, and
//!   it projects to the side of f as well. So g need not be looked at.
//! * A vertex that is not the closest point. The tangent cone of M there has a nearest point to s other than the apex; it lies in
//!   a visible facet of the cone, spanned by two edges, and along one of these the distance decreases.
//!
//! Without the rule of visibility the walk could end on the far side of a thin M, where the distance to the boundary has a
//! local minimum.
//!
//! # References
//! M. Lin, J. Canny, "A fast algorithm for incremental distance calculation" (1991), for walks over Voronoi regions.

use crate::answer::Cell;
use crate::cells::Cells;
use exact::Sign;
use exact::proximity::QueryPoint;
use polytope::Polytope;

/// Walks to the feature of M closest to a point outside, from a feature of which the facet is visible.
pub(crate) fn closest(sum: &Polytope, cells: &Cells, s: &QueryPoint, start: Cell) -> Cell {
    let walk = Walk { sum, cells, s };
    let mut cell = start;
    loop {
        let next = match cell {
            Cell::Facet(f) => walk.beside_facet(f),
            Cell::Edge(k) => walk.beside_edge(k),
            Cell::Vertex(k) => walk.beside_vertex(k),
        };
        match next {
            Some(next) => cell = next,
            None => return cell,
        }
    }
}

struct Walk<'a> {
    sum: &'a Polytope,
    cells: &'a Cells,
    s: &'a QueryPoint,
}

impl Walk<'_> {
    #[inline]
    fn beyond(&self, k: u32) -> Sign {
        self.cells.beyond(self.sum, k, self.s)
    }

    #[inline]
    fn ahead(&self, k: u32) -> Sign {
        self.cells.ahead(self.sum, k, self.s)
    }

    #[inline]
    fn is_visible(&self, facet: u32) -> bool {
        self.cells.side_of_facet(self.sum, facet, self.s) == Sign::Positive
    }

    /// The part of the boundary of a facet nearest to the point; `None` if the point projects into the facet.
    #[inline]
    fn beside_facet(&self, f: u32) -> Option<Cell> {
        let cells = self.cells;
        let mut is_inside = true;
        for k in cells.halfedges(f) {
            if self.beyond(k) != Sign::Positive {
                continue;
            }
            is_inside = false;
            if self.ahead(k) == Sign::Negative {
                // Before the source: at the source, unless it is ahead of it along the halfedge before.
                if self.ahead(cells.twin(cells.prev(k))) != Sign::Positive {
                    return Some(Cell::Vertex(k));
                }
            } else if self.ahead(cells.twin(k)) == Sign::Negative {
                let next = cells.next(k);
                if self.ahead(next) != Sign::Positive {
                    return Some(Cell::Vertex(next));
                }
            } else {
                return Some(Cell::Edge(k));
            }
        }
        assert!(is_inside, "a point outside of a convex polygon is nearest to an edge or a vertex");
        None
    }

    /// The facet of the halfedge is visible.
    #[inline]
    fn beside_edge(&self, k: u32) -> Option<Cell> {
        let cells = self.cells;
        if self.ahead(k) != Sign::Positive {
            return Some(Cell::Vertex(k));
        }
        let twin = cells.twin(k);
        if self.ahead(twin) != Sign::Positive {
            return Some(Cell::Vertex(cells.next(k)));
        }
        if self.beyond(k) == Sign::Negative {
            return Some(Cell::Facet(cells.facet(k)));
        }
        if self.beyond(twin) == Sign::Negative && self.is_visible(cells.facet(twin)) {
            return Some(Cell::Facet(cells.facet(twin)));
        }
        None
    }

    /// The facet of the halfedge is visible.
    #[inline]
    fn beside_vertex(&self, k: u32) -> Option<Cell> {
        let cells = self.cells;
        let mut h = k;
        loop {
            let twin = cells.twin(h);
            if self.ahead(h) == Sign::Positive {
                if self.is_visible(cells.facet(h)) {
                    return Some(Cell::Edge(h));
                }
                if self.is_visible(cells.facet(twin)) {
                    return Some(Cell::Edge(twin));
                }
            }
            h = cells.next(twin);
            if h == k {
                return None;
            }
        }
    }
}
