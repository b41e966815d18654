//! Who is told what a curve meets.

use crate::overlay::Cell;
use crate::topology::Site;
use crate::traits::BasicTraits;
use dcel::{EdgeId, FaceId, VertexId};
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// A place on a curve, and the cell of the arrangement in which it lies.
#[derive(Debug)]
pub struct ZonePlace<'a, G: BasicTraits> {
    /// A point, or the end of the curve on an open side; and on which side of the parameter space it is.
    pub site: Site<'a, G>,
    /// A vertex; an edge, of which this is no end; or a face, if the curve begins or ends there.
    pub cell: Cell,
}

impl<G: BasicTraits> Clone for ZonePlace<'_, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G: BasicTraits> Copy for ZonePlace<'_, G> {}

/// Where a curve is immediately before a place and immediately after it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Passage<W> {
    /// Before the place; `None` if the curve begins there.
    pub before: Option<W>,
    /// After the place; `None` if the curve ends there.
    pub after: Option<W>,
}

impl<W> Passage<W> {
    /// Neither before nor after: the place is an isolated point.
    pub const NONE: Self = Self { before: None, after: None };

    /// Tells whether the curve begins or ends at the place.
    pub fn is_end(&self) -> bool {
        self.before.is_none() || self.after.is_none()
    }
}

impl Passage<Ordering> {
    /// Tells whether the curve comes to one side of the edge from the other.
    pub fn is_crossing(&self) -> bool {
        matches!(
            (self.before, self.after),
            (Some(Ordering::Less), Some(Ordering::Greater)) | (Some(Ordering::Greater), Some(Ordering::Less))
        )
    }

    /// Tells whether the curve touches the edge in one point and stays on its side.
    pub fn is_touching(&self) -> bool {
        self.before == self.after && matches!(self.before, Some(Ordering::Less | Ordering::Greater))
    }
}

/// Is told, step by step, what a u-monotone curve meets in an arrangement on its way from its min to its max end. Each method may stop
/// the walk with `Break`; each one goes on unless it is overridden.
///
/// Laws:
/// 1. The first call is [`begins`](Self::begins), the last one [`ends`](Self::ends), unless it is stopped.
/// 2. Between them, places and stretches take turns: at each place that is on a vertex or in an edge, ends included, [`vertex`](Self::vertex)
///    or [`edge`](Self::edge) is called; for each stretch [`along`](Self::along), or [`enters_face`](Self::enters_face) and then
///    [`leaves_face`](Self::leaves_face). A place in a face is no call of its own.
/// 3. What comes behind a place or a stretch is not looked for before the call that tells of it returns; but the cell in which the curve
///    leaves a place is known, and how far it runs along an edge.
/// 4. A vertex that stands for an open side of the parameter space, at infinity, is told by `begins` and `ends` only: the curve does not
///    pass through it.
///
/// # References
/// Thesis, section 2.4.3, `ZoneVisitor`.
pub trait ZoneVisitor<G: BasicTraits> {
    /// The curve begins.
    fn begins(&mut self, place: &ZonePlace<'_, G>) -> ControlFlow<()> {
        let _ = place;
        ControlFlow::Continue(())
    }

    /// The curve comes to a vertex. The passage tells the faces, or edges along which it runs, before and after.
    fn vertex(&mut self, v: VertexId, place: &ZonePlace<'_, G>, passage: Passage<Cell>) -> ControlFlow<()> {
        let _ = (v, place, passage);
        ControlFlow::Continue(())
    }

    /// The curve is at a point in the interior of an edge. The passage tells whether before and after it is below the edge (`Less`), runs
    /// along it (`Equal`), or is above it (`Greater`). Above a vertical edge is to the left of it: above is where the face of
    /// [`EdgeId::halfedge`] is.
    fn edge(&mut self, e: EdgeId, place: &ZonePlace<'_, G>, passage: Passage<Ordering>) -> ControlFlow<()> {
        let _ = (e, place, passage);
        ControlFlow::Continue(())
    }

    /// The curve has run along an edge: to its max vertex from its min vertex, if the places are on these; else from or to a point within.
    fn along(&mut self, e: EdgeId, ends: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        let _ = (e, ends);
        ControlFlow::Continue(())
    }

    /// The curve goes on into a face, or begins there. Where it will leave the face is not known yet.
    fn enters_face(&mut self, f: FaceId, start: &ZonePlace<'_, G>) -> ControlFlow<()> {
        let _ = (f, start);
        ControlFlow::Continue(())
    }

    /// The curve has come through a face from one place to another.
    fn leaves_face(&mut self, f: FaceId, ends: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        let _ = (f, ends);
        ControlFlow::Continue(())
    }

    /// The curve ends.
    fn ends(&mut self, place: &ZonePlace<'_, G>) -> ControlFlow<()> {
        let _ = place;
        ControlFlow::Continue(())
    }
}
