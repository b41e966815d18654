//! The overlay of maps: six overlays, then stitching.

use crate::map::{At, CubicalArrangement, CubicalFaceId};
use crate::stitch::{Patch, border_cycle, stitch};
use arrangement::overlay::{Cell, Provenance};
use dcel::{EdgeId, FaceId, VertexId};
use exact::gnomonic::CubeSide;

/// For every cell of an overlay, the cell of each operand in which it lies.
///
/// Cells of a side lie in cells of the same side: [`CubicalProvenance::of_side`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CubicalProvenance {
    sides: [Provenance; 6],
}

impl CubicalProvenance {
    /// How many operands there were.
    pub fn operand_count(&self) -> usize {
        self.sides[0].operand_count()
    }

    /// From where the cells of one side come.
    pub fn of_side(&self, side: CubeSide) -> &Provenance {
        &self.sides[side.index()]
    }

    /// The cells, one of each operand, of the same side, in which a vertex lies.
    pub fn of_vertex(&self, v: At<VertexId>) -> &[Cell] {
        self.of_side(v.side).of_vertex(v.id)
    }

    /// The cells, one of each operand, of the same side, in which an edge lies.
    pub fn of_edge(&self, e: At<EdgeId>) -> &[Cell] {
        self.of_side(e.side).of_edge(e.id)
    }

    /// The faces, one of each operand, of the same side, in which a face of a side lies.
    pub fn of_part(&self, f: At<FaceId>) -> &[FaceId] {
        self.of_side(f.side).of_face(f.id)
    }
}

/// Overlays any number of maps, and tells where each cell comes from.
///
/// An edge is real if it lies on a real edge of an operand. A vertex on an edge of the cube is real if it lies on a real vertex of an operand, or if more than two real
/// edges meet there: so it is if artificial ones of two operands coincide where their arcs cross.
///
/// # Panics
/// If there is no operand.
///
/// # Complexity
/// That of six sweeps: O((n + k) log n) for n edges and k meetings of edges of different operands.
///
/// # References
/// Thesis, section 3.3.2.
///
/// ```
/// use exact::spherical::GreatCircle;
/// use splitstar_cubical::{CubicalArrangement, CubicalPieces, overlay_all};
/// let circle = |normal| {
///     let mut pieces = CubicalPieces::new();
///     pieces.push_circle(&GreatCircle::from_i64(normal).expect("not zero"));
///     CubicalArrangement::of_pieces(pieces)
/// };
/// // Both run through two edges of the cube at (1, 0, 1) and at (-1, 0, -1), where they cross.
/// let (red, blue) = (circle([0, 1, 0]), circle([1, 1, -1]));
/// let (map, provenance) = overlay_all(&[&red, &blue]);
/// let counts = map.counts();
/// assert_eq!((counts.vertices, counts.edges, counts.faces), (2, 4, 4));
/// assert!(map.faces().all(|face| provenance.of_part(map.part(face)).len() == 2));
/// ```
pub fn overlay_all(operands: &[&CubicalArrangement]) -> (CubicalArrangement, CubicalProvenance) {
    assert!(!operands.is_empty(), "an overlay has operands");
    let mut patches = Vec::with_capacity(6);
    let mut provenances = Vec::with_capacity(6);
    for side in CubeSide::ALL {
        let of_side: Vec<_> = operands.iter().map(|operand| operand.side(side)).collect();
        let (arrangement, provenance) = arrangement::overlay::overlay_all(&of_side);
        let dcel = arrangement.dcel();
        let own: Vec<_> = operands.iter().map(|operand| &operand.sides[side.index()]).collect();
        let mut is_real_edge = vec![false; dcel.edge_bound()];
        for e in dcel.edges() {
            let mut cells = own.iter().zip(provenance.of_edge(e));
            is_real_edge[e.index()] =
                cells.any(|(own, &cell)| matches!(cell, Cell::Edge(id) if own.is_real_edge[id.index()]));
        }
        // Those within the side are real anyhow.
        let mut is_given = vec![false; dcel.vertex_bound()];
        for v in border_cycle(&arrangement).map(|h| dcel.source(h)) {
            let mut cells = own.iter().zip(provenance.of_vertex(v));
            is_given[v.index()] =
                cells.any(|(own, &cell)| matches!(cell, Cell::Vertex(id) if own.is_real_vertex[id.index()]));
        }
        patches.push(Patch { arrangement, is_real_edge, is_given });
        provenances.push(provenance);
    }
    let patches = <[Patch; 6]>::try_from(patches).expect("a cube has six sides");
    let sides = <[Provenance; 6]>::try_from(provenances).expect("a cube has six sides");
    (stitch(patches), CubicalProvenance { sides })
}

impl CubicalProvenance {
    /// The faces of the spheres of the operands in which a face of the overlay lies.
    pub fn of_face<'a>(
        &'a self,
        map: &CubicalArrangement,
        operands: &'a [&CubicalArrangement],
        face: CubicalFaceId,
    ) -> impl Iterator<Item = CubicalFaceId> + 'a {
        let part = map.part(face);
        operands.iter().zip(self.of_part(part)).map(move |(operand, &id)| {
            operand.face_of(At { side: part.side, id }).expect("a bounded face lies in bounded ones")
        })
    }
}
