//! Making cells, and noting from which cells of the operands they come.

use super::{Cell, Provenance};
use crate::arrangement::Arrangement;
use crate::arrangement::build::{BuildTag, Builder, Built};
use crate::sweep::{Around, CellNumbers, Event, SweepInput, SweepVisitor};
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits};
use dcel::{Dcel, EdgeId, FaceId, HalfedgeId, VertexId};
use std::ops::ControlFlow;

/// Which cell of which operand the sites and curves of the input are.
#[derive(Debug)]
pub(super) struct Origins {
    /// For each curve and site of the input, the operand and the cell; curves and sites beyond are free.
    pub(super) curves: Vec<(u32, EdgeId)>,
    pub(super) sites: Vec<(u32, VertexId)>,
}

impl Origins {
    pub(super) fn of(numbers: Vec<CellNumbers>) -> Self {
        let mut origins = Self { curves: Vec::new(), sites: Vec::new() };
        for (operand, numbers) in (0..).zip(numbers) {
            debug_assert_eq!(numbers.first_curve, origins.curves.len());
            debug_assert_eq!(numbers.first_site, origins.sites.len());
            origins.curves.extend(numbers.edges.into_iter().map(|e| (operand, e)));
            origins.sites.extend(numbers.vertices.into_iter().map(|v| (operand, v)));
        }
        origins
    }
}

/// The builder, with provenance.
pub(super) struct OverlayVisitor<'s, 'a, G: BasicTraits, T> {
    builder: Builder<'s, G::Point>,
    operands: &'a [&'a Arrangement<G, T>],
    origins: &'a Origins,
    input: &'a SweepInput<'a, G>,
    provenance: Provenance,
    /// The faces of the operands in the gap below all strands.
    bottom: Vec<FaceId>,
    /// The faces in the gap that is looked at.
    gap: Vec<FaceId>,
}

impl<'s, 'a, G: BasicTraits, T: Topology<G>> OverlayVisitor<'s, 'a, G, T> {
    pub(super) fn new(
        builder: Builder<'s, G::Point>,
        operands: &'a [&'a Arrangement<G, T>],
        origins: &'a Origins,
        input: &'a SweepInput<'a, G>,
    ) -> Self {
        let mut provenance = Provenance::new(operands.len());
        for v in 0..builder.points.len() {
            // The vertices that stand for sides are the first ones of every arrangement on the surface.
            provenance.vertices.extend(operands.iter().map(|_| Cell::Vertex(VertexId::new(v))));
        }
        let bottom: Vec<FaceId> = operands.iter().map(|operand| operand.corner_face()).collect();
        Self { builder, operands, origins, input, provenance, gap: bottom.clone(), bottom }
    }

    fn dcel(&self, operand: usize) -> &'a Dcel {
        self.operands[operand].dcel()
    }

    /// The face of an operand above an edge of the overlay.
    #[inline]
    fn face_above(&self, edge: u32, operand: usize) -> FaceId {
        match self.provenance.edges[edge as usize * self.operands.len() + operand] {
            Cell::Edge(e) => self.dcel(operand).face(e.halfedge()),
            Cell::Face(f) => f,
            Cell::Vertex(_) => unreachable!("an edge does not lie in a vertex"),
        }
    }

    fn set_gap_above(&mut self, below: Option<BuildTag>) {
        match below {
            None => self.gap.copy_from_slice(&self.bottom),
            Some(tag) => {
                for operand in 0..self.operands.len() {
                    self.gap[operand] = self.face_above(tag.edge, operand);
                }
            }
        }
    }

    fn note_vertex(&mut self, event: &Event<'_, G>, around: &Around<'_, BuildTag>) {
        let k = self.operands.len();
        let first = self.provenance.vertices.len();
        self.provenance.vertices.extend(self.gap.iter().map(|&f| Cell::Face(f)));
        let cells = &mut self.provenance.vertices[first..];
        let edges = &self.provenance.edges;
        for tag in around.left.iter().map(|strand| strand.tag) {
            for (operand, cell) in cells.iter_mut().enumerate() {
                if let found @ Cell::Edge(_) = edges[tag.edge as usize * k + operand] {
                    *cell = found;
                }
            }
        }
        for i in 0..around.right.len() {
            for (operand, edge) in around.curves_of(i).filter_map(|curve| self.origins.curves.get(curve)) {
                cells[*operand as usize] = Cell::Edge(*edge);
            }
        }
        // The edges of a vertex on an identified side may all be at other places of its point: then an image of its site is here.
        let originals = event.input_sites.iter().map(|&site| self.input.original_site(site as usize));
        for (operand, vertex) in originals.filter_map(|site| self.origins.sites.get(site)) {
            cells[*operand as usize] = Cell::Vertex(*vertex);
        }
    }

    /// Notes where the edges come from that begin at an event; `gap` has the faces below the first one.
    fn note_edges(&mut self, around: &Around<'_, BuildTag>) {
        for i in 0..around.right.len() {
            let first = self.provenance.edges.len();
            self.provenance.edges.extend(self.gap.iter().map(|&f| Cell::Face(f)));
            for (operand, edge) in around.curves_of(i).filter_map(|curve| self.origins.curves.get(curve)) {
                self.provenance.edges[first + *operand as usize] = Cell::Edge(*edge);
                let (operand, h) = (*operand as usize, edge.halfedge());
                self.gap[operand] = self.dcel(operand).face(h);
            }
        }
    }

    pub(super) fn finish(self, topology: &T) -> (Built<G::Point>, Provenance) {
        let k = self.operands.len();
        let Self { builder, operands, mut provenance, .. } = self;
        let built = builder.finish(topology);
        for v in 0..operands.first().map_or(0, |operand| operand.contractions.len()) {
            for (operand, arrangement) in operands.iter().enumerate() {
                if let Some(face) = arrangement.face_of_absent(VertexId::new(v)) {
                    provenance.vertices[v * k + operand] = Cell::Face(face);
                }
            }
        }
        let dcel = &built.dcel;
        let face_of = |cell: Cell, operand: usize, h: HalfedgeId| match cell {
            Cell::Edge(e) if h.is_even() => operands[operand].dcel().face(e.halfedge()),
            Cell::Edge(e) => operands[operand].dcel().face(e.halfedge().twin()),
            Cell::Face(f) => f,
            Cell::Vertex(v) => {
                let face = operands[operand].dcel().isolated_face(v);
                face.expect("a vertex without edges has none in an operand")
            }
        };
        for f in dcel.faces() {
            let boundary = dcel.face_ccbs(f).next().map(|ccb| dcel.ccb_halfedge(ccb));
            let inside = dcel.isolated_vertices(f).next();
            for (operand, arrangement) in operands.iter().enumerate() {
                let face = match (boundary, inside) {
                    (Some(h), _) => face_of(provenance.edges[h.edge() * k + operand], operand, h),
                    (None, Some(v)) => {
                        face_of(provenance.vertices[v.index() * k + operand], operand, HalfedgeId(0))
                    }
                    (None, None) => arrangement.corner_face(),
                };
                provenance.faces.push(face);
            }
        }
        (built, provenance)
    }
}

impl<G: BasicTraits, T: Topology<G>> SweepVisitor<G> for OverlayVisitor<'_, '_, G, T> {
    type Tag = BuildTag;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, BuildTag>) -> ControlFlow<()> {
        let vertices = self.builder.points.len();
        self.builder.event(event, around)?;
        self.set_gap_above(around.below);
        if self.builder.points.len() > vertices {
            self.note_vertex(event, around);
        }
        let is_bottom = event.site.location.v == Along::Low && event.site.location.u == Along::Inside;
        if is_bottom {
            // What is below all strands to the right of here: for each operand, what lies below its lowest edge that begins here, or
            // above its highest one that ends here.
            if let Some(last) = around.left.last() {
                self.set_gap_above(Some(last.tag));
                self.bottom.copy_from_slice(&self.gap);
            }
            for i in (0..around.right.len()).rev() {
                for (operand, edge) in around.curves_of(i).filter_map(|curve| self.origins.curves.get(curve))
                {
                    self.bottom[*operand as usize] =
                        self.dcel(*operand as usize).face(edge.halfedge().twin());
                }
            }
            self.set_gap_above(around.below);
        }
        self.note_edges(around);
        ControlFlow::Continue(())
    }
}
