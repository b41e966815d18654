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
        match self.search(arrangement, &place, &Toward::Here) {
            (Found::Site(site), _) => Cell::Vertex(self.vertex(site)),
            (Found::Within(t), is_on_curve) => {
                let below = self.trapezoid(t).below;
                if is_on_curve && !below.is_none() {
                    let rail = self.rail(below);
                    if side(arrangement, &place, &arrangement.curves()[rail.curve as usize]).is_eq() {
                        return Cell::Edge(rail.edge);
                    }
                }
                Cell::Face(self.face_of(arrangement, t))
            }
        }
    }
}
