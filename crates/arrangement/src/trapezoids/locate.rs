//! The cell of a point.

use super::{Found, Toward, Trapezoids, side};
use crate::arrangement::Arrangement;
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::BasicTraits;

impl<G: BasicTraits> Trapezoids<G> {
    /// The cell in which a point lies.
    ///
    /// # Complexity
    /// That of a search. A face is named by an edge of its boundary, so holes cost nothing; on identified sides it may take a step for each
    /// vertex there from which no edge goes to the right.
    pub(crate) fn locate<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Cell {
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        if let Some(cell) = arrangement.cell_at_contraction(place.location) {
            return cell;
        }
        let (found, is_on_curve) = self.search(arrangement, &place, &Toward::Here);
        self.cell(arrangement, &place, found, is_on_curve)
    }

    /// The cells in which points lie, in their order: see [`search_all`](Self::search_all).
    pub(crate) fn locate_all<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        points: &[G::Point],
    ) -> Vec<Cell> {
        let places = points.iter().map(|p| Site::of_point(arrangement.topology(), arrangement.traits(), p));
        let mut cells = Vec::with_capacity(points.len());
        self.search_all(arrangement, places, |place, found, is_on_curve| {
            cells.push(self.cell(arrangement, place, found, is_on_curve));
        });
        cells
    }

    fn cell<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        found: Found,
        is_on_curve: bool,
    ) -> Cell {
        if let Some(cell) = arrangement.cell_at_contraction(place.location) {
            return cell;
        }
        let t = match found {
            Found::Site(site) => return Cell::Vertex(self.vertex(site)),
            Found::Within(t) => t,
        };
        let below = self.trapezoid(t).below;
        if is_on_curve && !below.is_none() {
            let rail = self.rail(below);
            if side(arrangement, place, &arrangement.curves()[rail.curve as usize]).is_eq() {
                return Cell::Edge(rail.edge);
            }
        }
        Cell::Face(self.face_of(arrangement, t))
    }
}
