//! Reading an arrangement takes no more than 64 times the file and 64 MiB. In a process of its own: the peak is that of the process.

// What was measured is worth seeing: `cargo test --test star_arrangement_memory -- --nocapture`.
#![allow(clippy::print_stdout, clippy::unwrap_used)]
#![cfg(target_os = "linux")]

use splitstar_formats::read_arrangement;
use std::fmt::Write;
use std::fs;
use std::time::Instant;

const MIB: u64 = 1 << 20;

/// The greatest resident size since the last call of [`forget_peak`].
fn peak() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM")).unwrap();
    let kib: u64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
    kib << 10
}

fn forget_peak() {
    fs::write("/proc/self/clear_refs", "5").unwrap();
}

/// Short segments of their own, in one face.
fn segments(count: usize) -> String {
    let mut text = "star 1 arrangement\nsurface plane\n".to_string();
    let mut put = |line: std::fmt::Arguments<'_>| text.write_fmt(line).unwrap();
    (0..count).for_each(|i| put(format_args!("curve {i} segment {i} 0 {i} 1\n")));
    (0..count).for_each(|i| put(format_args!("vertex {} {i} 0\nvertex {} {i} 1\n", 2 * i, 2 * i + 1)));
    (0..count).for_each(|i| put(format_args!("edge {i} {} {} curve {i}\n", 2 * i, 2 * i + 1)));
    put(format_args!("face 0\n"));
    (0..count).for_each(|i| put(format_args!("inner -{i} +{i}\n")));
    text + "end\n"
}

/// One line or curve cut into many edges.
fn cut(curve: &str, y: impl Fn(usize) -> usize, count: usize) -> String {
    let mut text = format!("star 1 arrangement\nsurface plane\ncurve 0 {curve}\n");
    let mut put = |line: std::fmt::Arguments<'_>| text.write_fmt(line).unwrap();
    (0..count).for_each(|i| put(format_args!("vertex {i} {i} {}\n", y(i))));
    (1..count).for_each(|i| put(format_args!("edge {i} {} {i} curve 0\n", i - 1)));
    put(format_args!("face 0\ninner"));
    (1..count).for_each(|i| put(format_args!(" +{i}")));
    (1..count).rev().for_each(|i| put(format_args!(" -{i}")));
    text + "\nend\n"
}

fn zigzag(count: usize) -> String {
    let mut text = "polyline".to_string();
    (0..count).for_each(|i| write!(text, " {i} {}", i % 2).unwrap());
    text
}

/// A chain of many pieces that is one edge.
fn chain(count: usize) -> String {
    let last = count - 1;
    let curve = zigzag(count);
    format!(
        "star 1 arrangement\nsurface plane\ncurve 0 {curve}\nvertex 0 0 0\nvertex 1 {last} {}\nedge 0 0 1 curve 0\n\
         face 0\ninner -0 +0\nend\n",
        last % 2
    )
}

fn points(surface: &str, rest: &str, count: usize) -> String {
    let mut text = format!("star 1 arrangement\nsurface {surface}\n");
    (0..count).for_each(|i| writeln!(text, "vertex {i} {i} {rest}").unwrap());
    text += "face 0\n";
    (0..count).for_each(|i| writeln!(text, "isolated {i}").unwrap());
    text + "end\n"
}

/// Short arcs of their own on the sphere, in one face.
fn arcs(count: usize) -> String {
    let mut text = "star 1 arrangement\nsurface sphere -1 0\n".to_string();
    let mut put = |line: std::fmt::Arguments<'_>| text.write_fmt(line).unwrap();
    (0..count).for_each(|i| put(format_args!("curve {i} arc {count} {i} 0 {count} {i} 1\n")));
    (0..count).for_each(|i| {
        put(format_args!("vertex {} {count} {i} 0\nvertex {} {count} {i} 1\n", 2 * i, 2 * i + 1));
    });
    (0..count).for_each(|i| put(format_args!("edge {i} {} {} curve {i}\n", 2 * i, 2 * i + 1)));
    put(format_args!("face 0\n"));
    (0..count).for_each(|i| put(format_args!("inner -{i} +{i}\n")));
    text + "end\n"
}

/// A chain of many arcs that is cut into as many edges, or is one.
fn arc_chain(count: usize, is_cut: bool) -> String {
    let mut text = "star 1 arrangement\nsurface sphere -1 0\ncurve 0 polyline".to_string();
    (0..count).for_each(|i| write!(text, " {count} {i} {}", i % 2).unwrap());
    let step = if is_cut { 1 } else { count - 1 };
    let mut put = |line: std::fmt::Arguments<'_>| text.write_fmt(line).unwrap();
    put(format_args!("\n"));
    let vertices = (0..count).step_by(step);
    vertices.clone().enumerate().for_each(|(v, i)| put(format_args!("vertex {v} {count} {i} {}\n", i % 2)));
    let edges = vertices.count() - 1;
    (0..edges).for_each(|e| put(format_args!("edge {e} {e} {} curve 0\n", e + 1)));
    put(format_args!("face 0\ninner"));
    (0..edges).for_each(|e| put(format_args!(" +{e}")));
    (0..edges).rev().for_each(|e| put(format_args!(" -{e}")));
    text + "\nend\n"
}

#[test]
fn reading_is_within_the_bound() {
    let texts = [
        ("points", points("plane", "0", 200_000)),
        ("segments", segments(100_000)),
        ("line", cut("segment 0 0 299999 0", |_| 0, 300_000)),
        ("zigzag", cut(&zigzag(100_000), |i| i % 2, 100_000)),
        ("chain", chain(20_000)),
        ("long chain", chain(400_000)),
        ("directions", points("sphere -1 0", "0 1", 200_000)),
        ("arcs", arcs(100_000)),
        ("cut chain of arcs", arc_chain(100_000, true)),
        ("chain of arcs", arc_chain(20_000, false)),
    ];
    for (name, text) in texts {
        let bound = 64 * text.len() as u64 + 64 * MIB;
        forget_peak();
        let before = peak();
        let start = Instant::now();
        let result = read_arrangement(text.as_bytes(), None);
        let taken = peak() - before + text.len() as u64;
        let refused = result.as_ref().err().map_or(String::new(), |error| error.to_string());
        let time = start.elapsed();
        println!(
            "{name}: {} MiB of {} for {} bytes, {time:?} {refused}",
            taken / MIB,
            bound / MIB,
            text.len()
        );
        assert!(taken <= bound, "{name}: {} MiB of {}", taken / MIB, bound / MIB);
        assert!(result.is_ok() || name == "long chain", "{name}: {refused}");
    }
}
