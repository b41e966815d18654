//! Gaussian maps as arrangements, on the sphere and on the cube: polytopes, their reflections and their Minkowski sums.
