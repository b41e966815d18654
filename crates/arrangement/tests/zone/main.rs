//! Zones of curves against the overlay with the arrangement of the curve alone, and against all pairs.

#![allow(clippy::unwrap_used)]

#[path = "../common/drawn.rs"]
mod drawn;
mod oracle;
#[allow(dead_code, reason = "shared with the tests of surfaces, which use more of it")]
#[path = "../surfaces/paths.rs"]
mod paths;
mod random;
mod scale;
#[allow(dead_code, reason = "shared with the tests of surfaces, which use more of it")]
#[path = "../surfaces/strip.rs"]
mod strip;
mod surfaces;
mod tables;
