//! One harness for all models, topologies and routes.
//!
//! Curves are data (`curves`): a table of degenerate families with stated counts (`rows`, `families`), and random ones of small
//! coordinates, so that everything degenerate happens. Every model that can carry them (`models`) makes the arrangement by every
//! route (`routes`); all must be valid and the same. Brute force on all pairs, written without the predicates of the library, says
//! what the cells are (`oracle`, on the torus `torus_oracle`). `laws` checks each predicate by itself,
//! `queries` what one sweep answers, and `provenance` where the cells of overlays come from, both with a scan over all cells (`scan`).

/// A test for each model: so many cases of `run`, and whether all curves are bounded.
macro_rules! test_models {
    ($($name:ident: $model:ident, $cases:literal, $are_bounded:literal;)*) => {
        $(
            #[test]
            fn $name() {
                run(&$model, $cases, $are_bounded);
            }
        )*
    };
}

mod curves;
mod families;
#[path = "../common/family.rs"]
mod family;
mod invariance;
mod laws;
mod models;
mod oracle;
mod provenance;
mod queries;
mod random;
mod routes;
mod rows;
mod scan;
mod torus;
mod torus_laws;
mod torus_oracle;
mod torus_queries;
mod torus_rows;
