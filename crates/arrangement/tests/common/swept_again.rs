//! An arrangement made anew of its own cells.

use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::UMonotoneTraits;
use splitstar_arrangement::{Arrangement, Pieces};

/// The edges and isolated vertices of an arrangement, swept anew.
pub(crate) fn swept_again<G: UMonotoneTraits + Clone, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
) -> Arrangement<G, T> {
    let dcel = arrangement.dcel();
    let mut pieces = Pieces::<G>::new();
    for e in dcel.edges() {
        pieces.push_piece(arrangement.make_edge_curve(e), dcel.ends(e).map(|v| arrangement.is_artificial(v)));
    }
    for v in arrangement.vertices().filter(|&v| dcel.outgoing(v).is_none()) {
        pieces.push_point(arrangement.point(v).expect("an isolated vertex is a point").clone());
    }
    Arrangement::of_pieces(arrangement.traits().clone(), arrangement.topology().clone(), pieces)
}
