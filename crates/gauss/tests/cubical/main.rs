//! The Gaussian map on the cube.

mod degenerate;
mod features;
mod models;
mod random;
mod table;
mod violations;
