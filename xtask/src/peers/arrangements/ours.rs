//! The one place where arrangements of the library are called.
//!
//! Every function prepares its operands, does the operation once, and times that alone.

use super::once::{Found, timed};
use super::task::Curves;
use crate::Failure;

/// Aggregated insertion of all curves into an empty arrangement.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn build(_curves: &Curves) -> Result<Found, Failure> {
    let ((), _seconds) = timed(|| ());
    Err(MISSING.into())
}

/// Overlay of the arrangements of both, which are made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn overlay(_red: &Curves, _blue: &Curves) -> Result<Found, Failure> {
    Err(MISSING.into())
}

/// Batched location of points in the arrangement of the curves, which is made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn locate(_curves: &Curves, _points: &[[i64; 2]]) -> Result<Found, Failure> {
    Err(MISSING.into())
}

const MISSING: &str = "the library has no arrangements yet";
