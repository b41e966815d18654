//! VRML 2 (VRML97), with exact coordinates.
//!
//! | files | role |
//! |---|---|
//! | `lexer` | tokens, and how values are passed over |
//! | `outline` | one walk over the whole text: brackets close, and names have their places |
//! | `scene` | the walk over the nodes, from the scene down to the shapes |
//! | `frame` | translations and scales, composed |
//! | `geometry` | shapes to vertices and facets |
//! | `write` | the way out |
//!
//! VRML has 32-bit floats. A decimal is read here as what is written all the same, and fractions `p/q` may
//! stand where VRML has decimals. What is written has to please other readers too, so fractions are written
//! into a node of their own, `ExactCoordinate`, which the file defines: its field `point` has the nearest
//! floats, its field `exact` the coordinates, one string for each vertex. Others see the first, and we read
//! the second.

mod frame;
mod geometry;
mod lexer;
mod outline;
mod scene;
mod write;

pub(crate) use scene::read;
pub(crate) use write::{takes_name, write};
