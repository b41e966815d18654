//! The sweep over every model, against oracles that know nothing of it.

mod linear;
mod torus;
mod watcher;
