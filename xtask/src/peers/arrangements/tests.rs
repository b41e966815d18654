use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::once::{Counts, Located, Measured, timed};
use super::rows::{Peer, ROWS, Row, plain};
use super::table::{self, Outcome, Run};
use super::task::{Curves, Family, Operation};

/// What a driver prints for that row.
fn printed(row: &Row, seconds: f64, peak: u64) -> Value {
    let Counts { vertices, edges, faces } = row.counts;
    let mut record = json!({
        "method": "some", "input_hash": format!("{:016x}", row.task.operands()[0].hash), "repetitions": 3,
        "seconds": seconds, "peak_bytes": peak, "vertices": vertices, "edges": edges, "faces": faces,
    });
    if row.task.operation == Operation::Locate {
        record["located"] = json!({ "vertices": 1, "edges": 2, "faces": 9_997, "around": 5 });
    }
    record
}

fn outcome(row: &'static Row, ours: Value, theirs: Value) -> Outcome {
    let run = |peer, record| Run { peer, measured: Measured::read(record).expect("it is complete") };
    let mut outcome = Outcome {
        row,
        ours: Some(run(None, ours)),
        peers: vec![run(Some(Peer::Cgal), theirs)],
        troubles: Vec::new(),
    };
    table::check(&mut outcome);
    outcome
}

fn row(name: &str) -> &'static Row {
    ROWS.iter().find(|row| row.name == name).expect("there is such a row")
}

#[test]
fn what_a_driver_prints_is_read() {
    let built = printed(row("short100000"), 0.5, 1024);
    assert_eq!(Measured::read(built).expect("it is complete").located, None);
    let record = printed(row("locate10000"), 0.5, 1024);
    let measured = Measured::read(record.clone()).expect("it is complete");
    assert_eq!(measured.counts, Some(row("locate10000").counts));
    assert_eq!(measured.located, Some(Located { vertices: 1, edges: 2, faces: 9_997, around: 5 }));
    for key in ["seconds", "peak_bytes", "input_hash"] {
        let mut less = record.clone();
        less[key] = Value::Null;
        assert!(Measured::read(less).is_err(), "without {key}");
    }
}

#[test]
fn every_requirement_can_fail() {
    let row = row("long3000");
    let passes = outcome(row, printed(row, 1.0, 100), printed(row, 4.0, 300));
    assert_eq!(table::failures(&passes), Vec::<String>::new());
    let slow = outcome(row, printed(row, 1.0, 100), printed(row, 3.9, 300));
    assert_eq!(table::failures(&slow), ["long3000: 3.90 times less time than CGAL, 4 is asked"]);
    let large = outcome(row, printed(row, 1.0, 101), printed(row, 4.0, 300));
    assert_eq!(table::failures(&large), ["long3000: 2.97 times less memory than CGAL, 3 is asked"]);
    let mut alone = outcome(row, printed(row, 1.0, 100), printed(row, 4.0, 300));
    alone.peers.clear();
    assert_eq!(table::failures(&alone).len(), 2);
}

#[test]
fn slow_queries_fail() {
    let row = row("together100000");
    let with = |seconds: f64| {
        let mut record = printed(row, seconds, 100);
        record["located"] = json!({ "vertices": 1, "edges": 2, "faces": 9_997, "around": 5 });
        outcome(row, record.clone(), record)
    };
    assert_eq!(table::failures(&with(0.015)), Vec::<String>::new());
    assert_eq!(table::failures(&with(0.0151)), ["together100000: 1.510 us a query, 1.5 are allowed"]);
    let mut missing = with(0.001);
    missing.ours = None;
    assert_eq!(table::failures(&missing), ["together100000: the time of a query is not known"]);
}

#[test]
fn other_inputs_and_other_cells_are_troubles() {
    let row = row("locate10000");
    let right = printed(row, 1.0, 100);
    let with = |key: &str, value: Value| {
        let mut record = right.clone();
        record[key] = value;
        record
    };
    assert!(outcome(row, right.clone(), right.clone()).troubles.is_empty());
    let place = json!({ "vertices": 0, "edges": 0, "faces": 10_000, "around": 7 });
    let wrong = [
        with("input_hash", json!("00")),
        with("faces", json!(1)),
        with("located", place),
        with("located", Value::Null),
    ];
    for record in wrong {
        assert_eq!(outcome(row, record.clone(), right.clone()).troubles.len(), 1, "ours: {record}");
        assert_eq!(outcome(row, right.clone(), record.clone()).troubles.len(), 1, "theirs: {record}");
    }
}

#[test]
fn zones_have_the_known_cells() {
    let row = row("zone100");
    let mut record = printed(row, 1.0, 100);
    record["located"] = json!({ "vertices": 0, "edges": 104, "faces": 204, "around": 18 });
    assert!(outcome(row, record.clone(), record.clone()).troubles.is_empty());
    record["located"] = json!({ "vertices": 0, "edges": 103, "faces": 204, "around": 18 });
    assert_eq!(outcome(row, record.clone(), record).troubles.len(), 2);
}

#[test]
fn cuts_of_peers_do_not_count() {
    let row = row("sphere1000");
    let ours = printed(row, 1.0, 100);
    let mut theirs = printed(row, 5.0, 100);
    theirs["vertices"] = json!(66_596);
    theirs["edges"] = json!(129_911);
    assert_eq!(table::failures(&outcome(row, ours.clone(), theirs.clone())), Vec::<String>::new());
    assert_eq!(outcome(row, theirs.clone(), theirs.clone()).troubles.len(), 1, "ours are not seen");
    for (key, wrong) in [("vertices", 66_597), ("edges", 129_910), ("faces", 63_316)] {
        let mut theirs = theirs.clone();
        theirs[key] = json!(wrong);
        assert_eq!(outcome(row, ours.clone(), theirs).troubles.len(), 1, "{key}");
    }
}

/// The counts of shorter arcs of which no three have a point in common, none ends on another, and all hang together: by looking at all
/// pairs. Two of them cross where each separates the ends of the other, and on the same half of the sphere.
fn brute_force(arcs: &[[i64; 6]]) -> Counts {
    let cross = |a: [i64; 3], b: [i64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let is_left = |n: [i64; 3], p: [i64; 3]| {
        let side: i64 = (0..3).map(|i| n[i] * p[i]).sum();
        assert_ne!(side, 0, "an end is on another circle");
        side > 0
    };
    let arcs = arcs.iter().map(|&[a, b, c, d, e, f]| ([a, b, c], [d, e, f], cross([a, b, c], [d, e, f])));
    let arcs: Vec<_> = arcs.collect();
    let mut parents: Vec<usize> = (0..arcs.len()).collect();
    let root = |parents: &mut Vec<usize>, mut i: usize| {
        while parents[i] != i {
            parents[i] = parents[parents[i]];
            i = parents[i];
        }
        i
    };
    let (mut crossings, mut components) = (0, arcs.len());
    for (i, &(p, q, n)) in arcs.iter().enumerate() {
        for (j, &(r, s, m)) in arcs[..i].iter().enumerate() {
            let sides = [is_left(n, r), is_left(n, s), is_left(m, p), is_left(m, q)];
            if sides[0] != sides[1] && sides[2] != sides[3] && sides[0] != sides[2] {
                crossings += 1;
                let [a, b] = [i, j].map(|k| root(&mut parents, k));
                components -= usize::from(a != b);
                parents[a] = b;
            }
        }
    }
    let (vertices, edges) = (2 * arcs.len() + crossings, arcs.len() + 2 * crossings);
    Counts { vertices, edges, faces: edges + 1 + components - vertices }
}

#[test]
fn counts_on_the_sphere_are_those_of_brute_force() {
    for row in ROWS.iter().filter(|row| row.task.family == Family::Arcs) {
        let operands = row.task.operands().into_iter().filter_map(|operand| match operand.curves {
            Curves::Arcs(arcs) => Some(arcs),
            _ => None,
        });
        let arcs: Vec<[i64; 6]> = operands.flatten().collect();
        assert_eq!(brute_force(&arcs), row.counts, "{}", row.name);
    }
}

#[test]
fn a_peer_may_be_asked_about_fewer_points() {
    let row = row("sphereask300");
    let mut ours = printed(row, 0.01, 100);
    ours["located"] = json!({ "vertices": 0, "edges": 0, "faces": 10_000, "around": 60_000 });
    let mut theirs = ours.clone();
    theirs["seconds"] = json!(0.5);
    theirs["asked"] = json!(20);
    let outcome = outcome(row, ours, theirs);
    assert_eq!(table::failures(&outcome), Vec::<String>::new());
    let times = &table::record(&outcome)["microseconds"];
    assert_eq!(*times, json!({ "a_query": 1.0, "at_most": 1.5, "of_peers": [25_000.0] }));
}

#[test]
fn history_is_compared_with_none() {
    for row in ROWS.iter().filter(|row| row.peers.contains(&Peer::Plain)) {
        assert!(plain(&row.task).is_some(), "{}", row.name);
    }
}

#[test]
fn names_of_rows_differ() {
    for (index, row) in ROWS.iter().enumerate() {
        assert!(ROWS[..index].iter().all(|other| other.name != row.name), "{}", row.name);
    }
}

#[test]
fn time_is_that_of_the_work() {
    let ((), seconds) = timed(|| {
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_millis(5) {}
    });
    assert!(seconds > 0.0);
    // Where the kernel keeps account, sleep costs nothing.
    if std::path::Path::new("/proc/thread-self/schedstat").exists() {
        let ((), seconds) = timed(|| thread::sleep(Duration::from_millis(100)));
        assert!(seconds < 0.09, "{seconds}");
    }
}
