//! parry3d-f64 on the placements that `cargo xtask peers proximity` has written.
//!
//! usage: parry-driver distance|relation|penetration|depths A B PLACEMENTS LEAST SECONDS
//!
//! A and B are OFF files, whose fractions become the nearest doubles; PLACEMENTS has a translation of B a line. Prints one JSON object
//! on one line: processor nanoseconds of a query, the median of at least LEAST passes over all placements and of about SECONDS. `depths`
//! is not timed: it prints the depth for each placement.

use std::fmt::Write;
use std::hint::black_box;

use parry3d_f64::math::{Pose3, Vec3};
use parry3d_f64::query;
use parry3d_f64::shape::ConvexPolyhedron;

/// What stops the driver: one sentence.
type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [query, a, b, placements, least, seconds] = &words[..] else {
        return Err(
            "usage: parry-driver distance|relation|penetration|depths A B PLACEMENTS LEAST SECONDS".into()
        );
    };
    let (a, b) = (hull(a)?, hull(b)?);
    let (placements, hash) = read_placements(placements)?;
    let answer = |placement: &[f64; 3]| -> f64 {
        let (fixed, moved) =
            (Pose3::identity(), Pose3::translation(placement[0], placement[1], placement[2]));
        let answered = "both shapes are convex polyhedra";
        match query.as_str() {
            "distance" => query::distance(&fixed, &a, &moved, &b).expect(answered).distance,
            "relation" => f64::from(u8::from(bool::from(
                query::intersection_test(&fixed, &a, &moved, &b).expect(answered).intersecting,
            ))),
            _ => query::contact(&fixed, &a, &moved, &b, 0.0)
                .expect(answered)
                .map_or(0.0, |contact| -contact.dist),
        }
    };
    let mut text = format!(
        "{{\"method\": \"parry3d-f64\", \"version\": \"{}\", \"input_hash\": \"{hash:016x}\"",
        version()
    );
    if query == "depths" {
        let depths: Vec<String> =
            placements.iter().map(|placement| format!("{:?}", answer(placement))).collect();
        write!(text, ", \"depths\": [{}]}}", depths.join(", "))?;
        println!("{text}");
        return Ok(());
    }
    let (least, seconds): (usize, f64) = (least.parse()?, seconds.parse()?);
    let mut times: Vec<f64> = Vec::new();
    let mut sum = 0.0;
    while times.len() < least || (times.iter().sum::<f64>() < seconds && times.len() < 2_000) {
        let begin = processor_seconds()?;
        sum = placements.iter().map(|placement| black_box(answer(black_box(placement)))).sum();
        times.push(processor_seconds()? - begin);
    }
    times.sort_by(f64::total_cmp);
    let median = (times[(times.len() - 1) / 2] + times[times.len() / 2]) / 2.0;
    let nanoseconds = median * 1e9 / placements.len() as f64;
    write!(
        text,
        ", \"placements\": {}, \"repetitions\": {}, \"nanoseconds\": {nanoseconds}, \"sum\": {sum:?}}}",
        placements.len(),
        times.len()
    )?;
    println!("{text}");
    Ok(())
}

/// The version of parry3d-f64 in the lock file.
fn version() -> &'static str {
    let lock = include_str!("../Cargo.lock");
    let entry = lock.split("[[package]]").find(|entry| entry.contains("name = \"parry3d-f64\""));
    entry.and_then(|entry| entry.split("version = \"").nth(1)?.split('"').next()).unwrap_or("unknown")
}

/// The hull of the vertices of an OFF file.
fn hull(path: &str) -> Result<ConvexPolyhedron, Failure> {
    let text = std::fs::read_to_string(path)?;
    let mut words = text.split_whitespace();
    if words.next() != Some("OFF") {
        return Err(format!("no OFF header in {path}").into());
    }
    let count: usize = words.next().ok_or("no number of vertices")?.parse()?;
    let mut words = words.skip(2);
    let mut points = Vec::new();
    for _ in 0..count {
        let mut next = || number(words.next().ok_or("the file ends within a vertex")?);
        points.push(Vec3::new(next()?, next()?, next()?));
    }
    ConvexPolyhedron::from_convex_hull(&points).ok_or_else(|| format!("{path} has no hull").into())
}

/// An integer, a decimal, or a fraction of two integers.
fn number(word: &str) -> Result<f64, Failure> {
    Ok(match word.split_once('/') {
        None => word.parse()?,
        Some((numerator, denominator)) => numerator.parse::<f64>()? / denominator.parse::<f64>()?,
    })
}

/// The translations of a file, and the hash of the bits of all numbers in order.
fn read_placements(path: &str) -> Result<(Vec<[f64; 3]>, u64), Failure> {
    let mut placements = Vec::new();
    let mut hash = 0xCBF2_9CE4_8422_2325_u64;
    for line in std::fs::read_to_string(path)?.lines() {
        let numbers: Vec<f64> = line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
        let placement = <[f64; 3]>::try_from(numbers).map_err(|_| format!("no placement: {line}"))?;
        hash = placement.iter().fold(hash, |hash, x| (hash ^ x.to_bits()).wrapping_mul(0x0100_0000_01B3));
        placements.push(placement);
    }
    Ok((placements, hash))
}

/// The processor seconds of this thread so far.
fn processor_seconds() -> Result<f64, Failure> {
    // The account is brought up to date when the thread is scheduled.
    std::thread::yield_now();
    let account = std::fs::read_to_string("/proc/thread-self/schedstat")?;
    let nanoseconds: f64 =
        account.split_whitespace().next().ok_or("no account of processor time")?.parse()?;
    Ok(nanoseconds * 1e-9)
}
