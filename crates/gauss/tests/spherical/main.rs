//! The Gaussian map on the sphere.

mod degenerate;
mod features;
mod models;
mod random;
mod violations;
