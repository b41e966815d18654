//! Times the predicates. `cargo bench -p splitstar-exact [--features count-tiers]`.
fn main() {}
