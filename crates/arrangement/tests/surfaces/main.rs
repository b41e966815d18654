//! Surfaces of mixed sides: a strip whose left side is glued to the right one, and whose bottom and top are open, closed or contracted.
//! With open ends it is a cylinder, with contracted ones a sphere.

#![allow(clippy::unwrap_used)]

mod glue;
mod increments;
mod landmarks;
mod paths;
mod random;
mod rectangle;
mod strip;
mod tables;
mod transposed;
mod tube;
