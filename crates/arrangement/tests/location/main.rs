//! Point location and vertical rays: every strategy gives what the naive one gives (`agree`), on all models and families of the harness
//! (`planes`, `tori`) and on surfaces of mixed sides (`strips`); and the naive one gives what a scan in coordinates gives (`rays`).

#![allow(clippy::unwrap_used)]

mod agree;
#[path = "../harness/curves.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod curves;
#[path = "../common/family.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod family;
#[path = "../harness/models.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod models;
#[path = "../harness/oracle.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod oracle;
#[path = "../surfaces/paths.rs"]
#[allow(dead_code, reason = "the tests of surfaces use all of it")]
mod paths;
mod planes;
mod rays;
#[path = "../harness/rows.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod rows;
#[path = "../surfaces/strip.rs"]
#[allow(dead_code, reason = "the tests of surfaces use all of it")]
mod strip;
mod strips;
mod tori;
#[path = "../harness/torus_oracle.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod torus_oracle;
#[path = "../harness/torus_rows.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod torus_rows;
#[path = "../surfaces/tube.rs"]
mod tube;
