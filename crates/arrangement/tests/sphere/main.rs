//! The sphere: arcs of great circles, by every route and with every operation, against oracles.
//!
//! Curves are data (`arcs`), of families with stated counts (`families`, and those of the plane by central projection: `planar`), and
//! random ones of small coordinates, so that everything degenerate happens (`random`). What the cells are, brute force tells in integer
//! vectors (`space`, `graph`, `walks`), and the plane tells (`cube`): arcs are segments on the faces of a cube; both tell
//! what bounds the faces (`incidences`). `matching` says which
//! cell is which, `routes` makes arrangements in every way, `laws` turns and mirrors them and moves the identification. `edits`,
//! `zones`, `places`, `queries`, `provenance`, `data` and `chains` are about everything else.

#![allow(clippy::unwrap_used)]

#[path = "../location/agree.rs"]
mod agree;
mod arcs;
mod chains;
mod chains_singly;
mod cube;
#[path = "../harness/curves.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod curves;
mod data;
mod edits;
mod families;
mod free_edits;
mod graph;
#[path = "../history/script.rs"]
mod history;
mod incidences;
mod laws;
mod laws_of_decompositions;
mod matching;
mod own;
mod places;
mod planar;
mod provenance;
mod queries;
mod random;
mod routes;
#[path = "../harness/rows.rs"]
mod rows;
mod space;
#[path = "../common/swept_again.rs"]
mod swept_again;
mod walks;
mod zones;
