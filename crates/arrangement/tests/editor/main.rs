//! Editing cell by cell, against sweeps.

#![allow(clippy::unwrap_used)]

#[path = "../common/drawn.rs"]
mod drawn;
mod global;
mod local;
mod merge;
mod remove;
mod scenes;
#[path = "../common/swept_again.rs"]
mod swept_again;
