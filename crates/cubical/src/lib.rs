//! Planar arrangements on the six sides of a cube, stitched to one map of all directions.
