//! Editing cell by cell, against sweeps.

#![allow(clippy::unwrap_used)]

mod global;
mod local;
mod merge;
mod remove;
mod scenes;
