//! The sphere.

#![allow(clippy::unwrap_used)]

mod arcs;
mod cube;
#[path = "../harness/curves.rs"]
#[allow(dead_code, reason = "the harness uses all of it")]
mod curves;
mod families;
mod graph;
mod planar;
mod random;
#[path = "../harness/rows.rs"]
mod rows;
mod space;
mod walks;

use testkit::Rng;
#[test]
fn oracles_agree() {
    let mut rng = Rng::new(1);
    for case in 0..500 {
        let seed = rng.state();
        let range = [1,2,2,3,9][rng.index(5)];
        let curves = random::random_curves(&mut rng, 1 + case % 9, range);
        let graph = graph::Graph::new(&curves);
        assert_eq!(graph.counts, cube::counts(&curves), "seed {seed} {curves:?}");
    }
}
#[test]
fn fam() {
    let mut bad = 0;
    let mut n = 0;
    for row in families::rows().into_iter().chain(planar::placements().iter().flat_map(planar::carried_rows)) {
        n += 1;
        let t = std::time::Instant::now();
        let c = graph::Graph::new(&row.curves).counts;
        let t1 = t.elapsed();
        let k = cube::counts(&row.curves);
        if t.elapsed().as_millis() > 40 {println!("{} {:?} {:?}", row.name, t1, t.elapsed()); }
        assert_eq!(c, k, "{}", row.name);
        let found = [c.vertices, c.edges, c.faces, c.isolated, c.components];
        if found != row.counts { bad += 1; println!("{}: {:?} found {found:?}: {:?}", row.name, row.counts, row.curves); }
    }
    println!("{n} rows");
    assert_eq!(bad, 0);
}
