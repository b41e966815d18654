//! The sweep: curves are met from left to right, and a visitor is told of every event.
//!
//! | layer | files | role |
//! |---|---|---|
//! | input | `input`, `cells` | sites and curves between them; those of an arrangement |
//! | structures | `status`, `queue` | what meets the sweep line; meetings that lie ahead |
//! | algorithm | `engine`, `left`, `right` | events in order; what ends at an event, and what begins there in which order |
//! | output | `visitor`, `watched` | events, with the subcurves around them; how far it has come |
//!
//! # The algorithm
//! Bentley and Ottmann's, without general position:
//!
//! 1. The sites of the input are sorted once. Meetings of curves wait in a heap beside them, and equal ones come together.
//! 2. An event knows the strands that end in its point or pass through it: those of curves that end there, and those whose meeting was
//!    found. Only where there are none, the point is looked for on the status line, and a strand may pass through it.
//! 3. A *strand* is one curve or several that overlap. It stays together until one of its curves ends, or two of them part. What
//!    goes on from an event and what begins there is sorted by its order to the right, and equal curves are one strand again. So
//!    overlaps need no case of their own. Curves that [meet once](crate::traits::BasicTraits::MEET_ONCE) never part: who ends leaves
//!    the strand, and the others stay. Of others, the end of the overlap of a pair is an event, known from its beginning on; and the
//!    strand is dissolved into its curves there, and where one of them ends.
//! 4. New neighbours are asked where they meet next.
//!
//! A curve is not cut: an edge is a curve between two events.
//!
//! # Complexity
//! O((n + k) log n) predicates for n curves and k incidences of strands with events on them; where a strand of m curves is dissolved,
//! they count one by one. The heap may hold meetings of strands that are not neighbours any more, and some twice: at most
//! two for each event so far, if curves meet once; else one more for each curve that begins or goes on at an event.
//!
//! # References
//! Thesis, section 2.4.1; de Berg et al., Computational Geometry, section 2.1.

mod cells;
mod engine;
mod input;
mod left;
mod queue;
mod right;
mod status;
mod visitor;
mod watched;

pub use cells::CellNumbers;
pub use engine::sweep;
pub use input::{NO_GROUP, SweepInput};
pub use visitor::{Around, Event, Members, Strand, SweepVisitor};
pub use watched::{Progress, Watched};
