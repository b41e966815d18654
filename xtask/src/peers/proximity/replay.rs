//! Deep overlaps for which programs with floats report too small a depth: ours must be the least over all facets of the sum, exactly.

use std::fs;

use exact::Rational;
use proximity::RelativePlacement;
use serde_json::{Value, json};

use super::placements::{self, Place};
use super::rows::{Peer, operands};
use super::{Tools, ours};
use crate::{Failure, shell};

/// How many overlaps are drawn, and how many are replayed.
const DRAWN: usize = 30_000;
const REPLAYED: usize = 1_000;
/// The frequency of the spheres.
const FREQUENCY: usize = 4;
/// A depth that is smaller by this is too small; the polytopes have a diameter of two.
const MARGIN: f64 = 1e-3;

/// What came of it.
#[derive(Debug)]
pub(super) struct Replay {
    /// For how many of all the drawn overlaps a peer reports too small a depth, and by how much at most.
    of_peers: Vec<(Peer, usize, f64)>,
    /// Of those, how many were replayed; of all, if no peer is there.
    replayed: usize,
    /// How many of our depths are the least over all facets of the sum.
    exact: usize,
    troubles: Vec<String>,
}

/// Asks everybody, and compares our depths with those of all facets.
///
/// # Errors
/// If an input cannot be read or written.
pub(super) fn run(tools: &Tools) -> Result<Replay, Failure> {
    println!("replay of deep overlaps ...");
    let operands = operands(FREQUENCY);
    let [a, b] = ours::polytopes(operands)?;
    let sum = RelativePlacement::new(&a, &b);
    let places = placements::deep(DRAWN);
    let path = shell::root().join("peers/inputs/placements-deep.txt");
    fs::write(&path, placements::text(&places))?;
    let translations = ours::translations(&places);
    let squared: Vec<Rational> = translations
        .iter()
        .map(|s| sum.minimum_penetration(s, None).map(|found| found.squared_depth()))
        .collect::<Option<_>>()
        .ok_or("a placement near the middle does not overlap")?;
    let depths: Vec<f64> = squared.iter().map(|squared| squared.approx_f64().sqrt()).collect();
    let mut replay = Replay { of_peers: Vec::new(), replayed: 0, exact: 0, troubles: Vec::new() };
    let mut is_too_small = vec![false; places.len()];
    for peer in [Peer::Parry, Peer::Coal] {
        let Some(mut command) = tools.command(peer, "depths", &operands, &path) else { continue };
        match theirs(&mut command, &places) {
            Ok(found) => {
                let short: Vec<f64> = depths.iter().zip(&found).map(|(ours, theirs)| ours - theirs).collect();
                short.iter().zip(&mut is_too_small).for_each(|(short, mark)| *mark |= *short > MARGIN);
                let count = short.iter().filter(|short| **short > MARGIN).count();
                replay.of_peers.push((peer, count, short.iter().copied().fold(0.0, f64::max)));
            }
            Err(failure) => replay.troubles.push(format!("replay: {peer}: {failure}")),
        }
    }
    if replay.of_peers.is_empty() {
        is_too_small.fill(true);
    }
    let facets = facets(&sum);
    let chosen = (0..places.len()).filter(|&number| is_too_small[number]).take(REPLAYED);
    for number in chosen {
        replay.replayed += 1;
        if squared[number] == least(&facets, &translations[number].coordinates()) {
            replay.exact += 1;
        } else {
            replay.troubles.push(format!("replay: the depth at {:?} is not the least", places[number]));
        }
    }
    if replay.replayed < REPLAYED {
        replay.troubles.push(format!("replay: only {} overlaps to be replayed", replay.replayed));
    }
    Ok(replay)
}

/// The normal and the height of every facet of the sum, and the squared length of the normal.
fn facets(sum: &RelativePlacement) -> Vec<([Rational; 3], Rational, Rational)> {
    let sum = sum.sum();
    let facet = |f| {
        let normal = sum.facet_normal(f).coordinates().map(Rational::from);
        let vertex = sum.facet_cycle(f).next().expect("a facet has vertices");
        let height = dot(&normal, &sum.points()[vertex.index()].coordinates());
        let squared = dot(&normal, &normal);
        (normal, height, squared)
    };
    sum.mesh().facets().map(facet).collect()
}

/// The least squared distance of a point inside to the plane of a facet.
fn least(facets: &[([Rational; 3], Rational, Rational)], s: &[Rational; 3]) -> Rational {
    let squared = |(normal, height, squared): &([Rational; 3], Rational, Rational)| {
        let slack = height - dot(normal, s);
        (&slack * &slack).checked_div(squared).expect("a normal is not zero")
    };
    facets.iter().map(squared).min().expect("a solid has facets")
}

fn dot(a: &[Rational; 3], b: &[Rational; 3]) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The depths that a driver reports.
fn theirs(command: &mut std::process::Command, places: &[Place]) -> Result<Vec<f64>, Failure> {
    let record = super::driver(command, &placements::hash(places))?;
    let depths = record["depths"].as_array().ok_or("the driver gave no depths")?;
    let depths: Option<Vec<f64>> = depths.iter().map(Value::as_f64).collect();
    let depths = depths.ok_or("a depth of the driver is no number")?;
    if depths.len() == places.len() { Ok(depths) } else { Err("the driver gave too few depths".into()) }
}

impl Replay {
    pub(super) fn print(&self) {
        println!("\nreplay of deep overlaps, {DRAWN} drawn");
        for (peer, count, worst) in &self.of_peers {
            let percent = 100.0 * *count as f64 / DRAWN as f64;
            println!("  {peer:<12} too small a depth for {count} ({percent:.1} %), at worst by {worst:.3}");
        }
        println!(
            "  splitstar    {} of {} replayed are the exact minimum over all facets",
            self.exact, self.replayed
        );
    }

    pub(super) fn failures(&self) -> Vec<String> {
        self.troubles.clone()
    }

    pub(super) fn record(&self) -> Value {
        let of_peers: Vec<Value> = self
            .of_peers
            .iter()
            .map(|(peer, count, worst)| json!({ "peer": peer.to_string(), "too_small": count, "worst": worst }))
            .collect();
        json!({
            "row": "replay",
            "drawn": DRAWN,
            "margin": MARGIN,
            "of_peers": of_peers,
            "replayed": self.replayed,
            "exact": self.exact,
            "troubles": self.troubles,
        })
    }
}
