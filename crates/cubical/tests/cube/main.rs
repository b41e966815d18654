//! Six stitched arrangements against one on the sphere.
//!
//! `agree` compares a map with the arrangement of the same arcs on the sphere, cell by cell; `rows` are arcs with known counts, with everything that is degenerate
//! on a cube; `random` has arcs of small coordinates, so that all of that happens at once; `ends` are arcs that are refused; `laws` are about overlays and reflections; `table` is table 3.1 of the thesis.

mod agree;
mod ends;
mod laws;
mod random;
mod rows;
mod table;
