//! Editing: curves that come one by one give what one sweep over all of them gives, whatever their order, on every model and every
//! degenerate family of the harness (`increments`); and random scripts of edits of all kinds (`random`, by `script`), after each step of
//! which everything is checked.
//!
//! The models and families are those of the harness. What interprets scripts is shared with the fuzz target `edits`.

#[path = "../harness/curves.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod curves;
#[path = "../common/family.rs"]
mod family;
mod increments;
#[path = "../harness/models.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod models;
#[path = "../harness/oracle.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod oracle;
mod random;
#[path = "../harness/rows.rs"]
mod rows;
mod script;
#[path = "../common/swept_again.rs"]
mod swept_again;
#[path = "../harness/torus_oracle.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod torus_oracle;
#[path = "../harness/torus_rows.rs"]
mod torus_rows;
