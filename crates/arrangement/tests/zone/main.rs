//! Zones of curves against the overlay with the arrangement of the curve alone, and against all pairs.

#![allow(clippy::unwrap_used)]

mod oracle;
mod random;
mod scale;
mod tables;
