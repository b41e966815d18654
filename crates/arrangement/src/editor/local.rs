//! Edits whose neighbours are known.

use super::Editor;
use super::place::At;
use crate::edit::{Edit, Observer, Operation};
use crate::topology::{Site, Topology};
use crate::traits::UMonotoneTraits;
use crate::trapezoids::{Found, NewSite, side};
use dcel::VertexId;

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts a point: an isolated vertex in a face, or a vertex that divides an edge. At a vertex, nothing changes, but an artificial one
    /// becomes an ordinary one.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order.
    pub fn insert_point(&mut self, point: &G::Point) -> VertexId {
        self.operate(Operation::InsertPoint, |editor| editor.add_point(point).v)
    }

    /// Adds a point: a vertex of its own, or on an edge.
    pub(super) fn add_point(&mut self, point: &G::Point) -> At {
        let arrangement = &self.arrangement;
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        let location = place.location;
        match self.trapezoids.find(arrangement, &place) {
            Found::Within(t) => {
                let below = self.trapezoids.trapezoid(t).below;
                let is_on = !below.is_none() && {
                    let curve = self.trapezoids.rail(below).curve;
                    side(arrangement, &place, &arrangement.curves()[curve as usize]).is_eq()
                };
                if is_on {
                    return self.split_rail(below, point, location);
                }
                let face = self.trapezoids.face_of(arrangement, t);
                let edit = Edit::AddIsolatedVertex { point: point.clone(), is_artificial: false, face };
                let v = self.arrangement.apply(edit, &mut self.observers).vertex();
                At { v, site: self.trapezoids.add_site(NewSite::Vertex(v), location, t) }
            }
            Found::Site(site) => {
                let v = self.trapezoids.vertex(site).expect("a point is not at an end without one");
                self.make_ordinary(v);
                At { v, site }
            }
        }
    }
}
