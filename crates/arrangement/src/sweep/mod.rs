//! The sweep: curves are met from left to right, and a visitor is told of every event.
//!
//! | layer | files | role |
//! |---|---|---|
//! | input | `input` | sites and curves between them |
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
//! 3. A *strand* is one curve or several that overlap. Strands live from one event on them to the next. At an event all strands
//!    through it are dissolved into their curves; the curves that go on and those that begin are sorted by their order to the
//!    right, and equal ones are strands again. So overlaps need no case of their own.
//! 4. New neighbours are asked where they meet next.
//!
//! A curve is not cut: an edge is a curve between two events.
//!
//! # Complexity
//! O((n + k) log n) predicates for n curves and k incidences of curves with events on them: a curve that runs together with m others
//! counts at every event on them. The heap may hold meetings of strands that are not neighbours any more, and some twice: at most
//! two for each event so far.
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

pub(crate) use cells::CellNumbers;
pub use engine::sweep;
pub use input::{NO_GROUP, SweepInput};
pub use visitor::{Around, Event, Members, Strand, SweepVisitor};
pub use watched::{Progress, Watched};
