//! Visitors of zones: all cells, and whether there are any but faces.

use super::{Passage, ZonePlace, ZoneVisitor};
use crate::overlay::Cell;
use crate::traits::BasicTraits;
use dcel::{EdgeId, FaceId, VertexId};
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// Collects the cells that a curve meets, in their order along it.
///
/// A cell comes again if the curve comes back to it after another one. Where a curve touches an edge, so does the face. Vertices at
/// infinity are not among the cells.
#[derive(Clone, Debug, Default)]
pub struct ZoneCells {
    cells: Vec<Cell>,
}

impl ZoneCells {
    /// The cells.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Gives the cells away.
    pub fn into_cells(self) -> Vec<Cell> {
        self.cells
    }

    fn push(&mut self, cell: Cell) -> ControlFlow<()> {
        if self.cells.last() != Some(&cell) {
            self.cells.push(cell);
        }
        ControlFlow::Continue(())
    }
}

impl<G: BasicTraits> ZoneVisitor<G> for ZoneCells {
    fn begins(&mut self, place: &ZonePlace<'_, G>) -> ControlFlow<()> {
        match place.cell {
            Cell::Face(f) => self.push(Cell::Face(f)),
            Cell::Vertex(_) | Cell::Edge(_) => ControlFlow::Continue(()),
        }
    }

    fn vertex(&mut self, v: VertexId, _: &ZonePlace<'_, G>, _: Passage<Cell>) -> ControlFlow<()> {
        self.push(Cell::Vertex(v))
    }

    fn edge(&mut self, e: EdgeId, _: &ZonePlace<'_, G>, _: Passage<Ordering>) -> ControlFlow<()> {
        self.push(Cell::Edge(e))
    }

    fn along(&mut self, e: EdgeId, _: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        self.push(Cell::Edge(e))
    }

    fn enters_face(&mut self, f: FaceId, _: &ZonePlace<'_, G>) -> ControlFlow<()> {
        self.push(Cell::Face(f))
    }
}

/// Stops at the first vertex or edge that a curve meets.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MeetingFinder {
    /// Whether the ends of the curve count.
    do_ends_count: [bool; 2],
    found: Option<Cell>,
}

impl Default for MeetingFinder {
    fn default() -> Self {
        Self::new()
    }
}

impl MeetingFinder {
    /// Everything counts.
    pub fn new() -> Self {
        Self::with_ends([true; 2])
    }

    /// Says for each end of the curve whether what is met there counts.
    pub fn with_ends(do_ends_count: [bool; 2]) -> Self {
        Self { do_ends_count, found: None }
    }

    /// The vertex or the edge that was met.
    pub fn found(&self) -> Option<Cell> {
        self.found
    }

    fn meet<W>(&mut self, cell: Cell, passage: &Passage<W>) -> ControlFlow<()> {
        let counts = |is_end: bool, i: usize| !is_end || self.do_ends_count[i];
        if counts(passage.before.is_none(), 0) && counts(passage.after.is_none(), 1) {
            self.found = Some(cell);
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

impl<G: BasicTraits> ZoneVisitor<G> for MeetingFinder {
    fn vertex(&mut self, v: VertexId, _: &ZonePlace<'_, G>, passage: Passage<Cell>) -> ControlFlow<()> {
        self.meet(Cell::Vertex(v), &passage)
    }

    fn edge(&mut self, e: EdgeId, _: &ZonePlace<'_, G>, passage: Passage<Ordering>) -> ControlFlow<()> {
        self.meet(Cell::Edge(e), &passage)
    }

    fn along(&mut self, e: EdgeId, _: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        self.found = Some(Cell::Edge(e));
        ControlFlow::Break(())
    }
}
