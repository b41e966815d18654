//! The overlay of arrangements: all their cells cut by one another.
//!
//! One sweep over the edges of all operands. Those of one operand are known not to meet, and are not asked. Where each cell comes
//! from is noted on the way: an edge knows the edges that run along it, and the gap below a strand knows the face of each operand.

mod traits;
mod visitor;

pub use traits::OverlayTraits;

use crate::arrangement::assemble::assemble;
use crate::arrangement::build::Builder;
use crate::arrangement::{Arrangement, Parts};
use crate::insert::Pieces;
use crate::sweep::{Progress, SweepInput, Watched, sweep};
use crate::topology::Topology;
use crate::traits::{CurveEnd, UMonotoneTraits};
use dcel::{EdgeId, FaceId, VertexId};
use std::ops::ControlFlow;
use visitor::{Origins, OverlayVisitor};

/// A cell of an arrangement.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Cell {
    /// A vertex.
    Vertex(VertexId),
    /// An edge, without its ends.
    Edge(EdgeId),
    /// A face, without its boundary.
    Face(FaceId),
}

/// For every cell of an overlay, the cell of each operand in which it lies.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Provenance {
    operands: usize,
    vertices: Vec<Cell>,
    edges: Vec<Cell>,
    faces: Vec<FaceId>,
}

impl Provenance {
    fn new(operands: usize) -> Self {
        Self { operands, vertices: Vec::new(), edges: Vec::new(), faces: Vec::new() }
    }

    /// How many operands there were.
    pub fn operand_count(&self) -> usize {
        self.operands
    }

    /// The cells, one of each operand, in which a vertex of the overlay lies.
    pub fn of_vertex(&self, v: VertexId) -> &[Cell] {
        &self.vertices[v.index() * self.operands..][..self.operands]
    }

    /// The cells, edges or faces, one of each operand, in which an edge of the overlay lies.
    pub fn of_edge(&self, e: EdgeId) -> &[Cell] {
        &self.edges[e.index() * self.operands..][..self.operands]
    }

    /// The faces, one of each operand, in which a face of the overlay lies.
    pub fn of_face(&self, f: FaceId) -> &[FaceId] {
        &self.faces[f.index() * self.operands..][..self.operands]
    }
}

/// Overlays any number of arrangements on one surface, and tells where each cell comes from.
///
/// The result has the traits and the topology of the first operand.
///
/// Degenerate: edges that overlap become one edge, which comes from all of them; vertices that coincide become one.
///
/// # Preconditions
/// The traits of the operands are alike: a curve or a point of one means the same to all. Those of tori have the same periods, those of spheres the
/// same identification.
/// Otherwise the result is not valid.
///
/// # Panics
/// If there is no operand.
///
/// # Complexity
/// That of a sweep over n edges: O((n + k) log n) predicates for k meetings of edges of different operands. The provenance of a
/// cell takes 8 bytes an operand, that of a face 4.
///
/// # References
/// Thesis, section 2.4.2.
pub fn overlay_all<G: UMonotoneTraits + Clone, T: Topology<G>>(
    operands: &[&Arrangement<G, T>],
) -> (Arrangement<G, T>, Provenance) {
    overlay_all_with(operands, |_| ControlFlow::Continue(())).expect("nobody stops the sweep")
}

/// Overlays any number of arrangements, as [`overlay_all`] does; now and then `watch` is told how far the sweep has come, and may stop
/// it. Then there is no overlay.
///
/// # Panics
/// If there is no operand.
///
/// # Complexity
/// That of [`overlay_all`]. `watch` is called once in about a thousand events.
pub fn overlay_all_with<G: UMonotoneTraits + Clone, T: Topology<G>>(
    operands: &[&Arrangement<G, T>],
    watch: impl FnMut(Progress) -> ControlFlow<()>,
) -> Option<(Arrangement<G, T>, Provenance)> {
    let (first, _) = operands.split_first().expect("an overlay has operands");
    let (traits, topology) = (first.traits(), first.topology());
    let (parts, provenance) = overlay_with_pieces(traits, topology, operands, Pieces::new(), watch)?;
    Some((Arrangement::of_valid_parts(traits.clone(), topology.clone(), parts), provenance))
}

/// Overlays two arrangements, and calls one of ten functions for each cell of the result.
///
/// # Preconditions
/// Those of [`overlay_all`]: the traits of the operands are alike.
///
/// # References
/// Thesis, section 2.4.2, where the ten cases are numbered.
pub fn overlay<G: UMonotoneTraits + Clone, T: Topology<G>>(
    red: &Arrangement<G, T>,
    blue: &Arrangement<G, T>,
    traits: &mut impl OverlayTraits,
) -> Arrangement<G, T> {
    overlay_with(red, blue, traits, |_| ControlFlow::Continue(())).expect("nobody stops the sweep")
}

/// Overlays two arrangements, as [`overlay`] does; now and then `watch` is told how far the sweep has come, and may stop it. Then there
/// is no overlay, and no function was called.
///
/// # Complexity
/// That of [`overlay_all`]. `watch` is called once in about a thousand events.
pub fn overlay_with<G: UMonotoneTraits + Clone, T: Topology<G>>(
    red: &Arrangement<G, T>,
    blue: &Arrangement<G, T>,
    traits: &mut impl OverlayTraits,
    watch: impl FnMut(Progress) -> ControlFlow<()>,
) -> Option<Arrangement<G, T>> {
    let (arrangement, provenance) = overlay_all_with(&[red, blue], watch)?;
    traits::call(&arrangement, &provenance, traits);
    Some(arrangement)
}

/// Overlays arrangements and free curves; `None` if `watch` stops it.
pub(crate) fn overlay_with_pieces<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    operands: &[&Arrangement<G, T>],
    pieces: Pieces<G>,
    watch: impl FnMut(Progress) -> ControlFlow<()>,
) -> Option<(Parts<G>, Provenance)> {
    let Pieces { curves, is_artificial, points } = pieces;
    let mut curve_supports: Vec<u32> = Vec::new();
    let mut first_support = 0;
    let (built, provenance) = {
        let mut input = SweepInput::empty();
        let numbers: Vec<_> =
            (0..).zip(operands).map(|(group, operand)| input.push_arrangement(operand, group)).collect();
        let mut flags = Vec::with_capacity(input.site_count());
        for (operand, numbers) in operands.iter().zip(&numbers) {
            flags.extend(numbers.vertices.iter().map(|&v| operand.is_artificial[v.index()]));
            curve_supports.extend(numbers.edges.iter().map(|&e| first_support + operand.support(e).0));
            first_support += operand.curves().len() as u32;
        }
        input.push_free(traits, topology, &curves, &points);
        for end in CurveEnd::BOTH {
            flags.extend(is_artificial.iter().map(|is| is[end as usize]));
        }
        flags.extend(points.iter().map(|_| false));
        input.mirror(topology);
        // Images on other sides decide nothing.
        flags.resize(input.site_count(), true);
        let origins = Origins::of(numbers);
        let builder = Builder::new(traits, topology, &flags);
        let visitor = OverlayVisitor::new(builder, operands, &origins, &input);
        let mut watched = Watched::new(visitor, input.site_count(), watch);
        if sweep(traits, topology, &input, &mut watched).is_break() {
            return None;
        }
        watched.into_inner().finish(topology)
    };
    let swept = curve_supports.len() as u32;
    let support_of = |curve: u32| match curve_supports.get(curve as usize) {
        Some(&support) => support,
        None => first_support + (curve - swept),
    };
    // One allocation: there are many, and they are large.
    let mut supports = Vec::with_capacity(first_support as usize + curves.len());
    operands.iter().for_each(|operand| supports.extend_from_slice(operand.curves()));
    supports.extend(curves);
    Some((assemble(traits, topology, built, supports, support_of), provenance))
}
