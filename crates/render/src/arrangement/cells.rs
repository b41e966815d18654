//! The cells in the order in which they are numbered and drawn.

use ::arrangement::topology::Topology;
use ::arrangement::traits::{ApproxTraits, UMonotoneTraits};
use ::arrangement::{Arrangement, CellOrder};
use dcel::{EdgeId, FaceId, VertexId};

use super::colouring;
use crate::colour::Colour;

/// Cells with their names: a letter, and the place in [`Arrangement::cell_order`].
pub(super) struct Cells {
    order: CellOrder,
    /// Whether the user's view does without a vertex, by its place.
    is_hidden: Vec<bool>,
}

impl Cells {
    pub(super) fn new<G: ApproxTraits + UMonotoneTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
    ) -> Self {
        let (order, view) = (arrangement.cell_order(), arrangement.user_view());
        let is_hidden = order.vertices.iter().map(|&v| view.is_hidden(v)).collect();
        Self { order, is_hidden }
    }

    /// The vertices that a user sees.
    pub(super) fn vertices(&self) -> impl Iterator<Item = (VertexId, String)> + '_ {
        let vertices = self.order.vertices.iter().zip(&self.is_hidden).enumerate();
        vertices.filter(|(_, (_, is_hidden))| !**is_hidden).map(|(number, (&v, _))| (v, format!("v{number}")))
    }

    /// All vertices that are points.
    pub(super) fn stored_vertices(&self) -> &[VertexId] {
        &self.order.vertices
    }

    pub(super) fn edges(&self) -> impl Iterator<Item = (EdgeId, String)> + '_ {
        self.order.edges.iter().enumerate().map(|(number, &e)| (e, format!("e{number}")))
    }

    pub(super) fn faces(&self) -> impl Iterator<Item = (FaceId, String)> + '_ {
        self.order.faces.iter().enumerate().map(|(number, &f)| (f, format!("f{number}")))
    }

    /// For each face, in their order, a colour that no face beside it has.
    pub(super) fn colours<G: ApproxTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
    ) -> Vec<Colour> {
        let dcel = arrangement.dcel();
        let mut numbers = vec![0; dcel.face_bound()];
        for (number, f) in (0_u32..).zip(&self.order.faces) {
            numbers[f.index()] = number;
        }
        let sides = |e: &EdgeId| {
            let h = e.halfedge();
            [h, h.twin()].map(|h| numbers[dcel.face(h).index()])
        };
        let pairs = self.order.edges.iter().map(sides);
        colouring::colours(self.order.faces.len(), pairs).into_iter().map(Colour::pale).collect()
    }
}
