//! How wide coordinates are after clearing denominators, and what width costs.

use std::fs;
use std::path::{Path, PathBuf};

use exact::{Integer, Point3, Rational};

use crate::solids::{Solid, TURN, geodesic_sphere};
use crate::{Failure, library, shell};

use super::{measure, write_input};

/// Upper ends of the classes of the histogram, in bits; the last class has none.
const CLASSES: [u32; 6] = [16, 32, 53, 64, 128, 256];
/// Widths at which the sum is timed.
const TIMED: [u32; 5] = [32, 53, 64, 128, 256];
/// Frequency of the spheres that are summed: 2,562 vertices.
const FREQUENCY: usize = 16;
/// Bits of the coordinates of `solids::geodesic_sphere`.
const SPHERE_BITS: u32 = 40;

/// Prints the histogram and the times.
///
/// # Errors
/// If a model cannot be read or summed.
pub(super) fn run() -> Result<(), Failure> {
    histogram()?;
    times()
}

fn histogram() -> Result<(), Failure> {
    print!("\n{:<42}", "bits of a coordinate, share in %");
    for end in CLASSES {
        print!(" {:>6}", format!("<={end}"));
    }
    println!(" {:>6} {:>6}", "more", "widest");
    let folder = shell::root().join("models/convex");
    let mut paths =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<PathBuf>, Failure>>()?;
    paths.sort();
    let mut all = Vec::new();
    for path in &paths {
        let widths = widths(&library::read(path)?.points);
        line(&name(path), &widths);
        all.extend(widths);
    }
    line("all models", &all);
    for (name, points) in float_meshes() {
        line(name, &widths(&points?));
    }
    Ok(())
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn line(name: &str, widths: &[u32]) {
    print!("{name:<42}");
    let share = |count: usize| 100.0 * count as f64 / widths.len() as f64;
    let mut below = 0;
    for end in CLASSES.into_iter().chain([u32::MAX]) {
        let count = widths.iter().filter(|&&width| width <= end).count();
        print!(" {:>6.1}", share(count - below));
        below = count;
    }
    println!(" {:>6}", widths.iter().max().unwrap_or(&0));
}

/// Bits of every coordinate over the least common denominator of the mesh.
fn widths(points: &[Point3]) -> Vec<u32> {
    let common = points.iter().fold(Integer::ONE, |common, point| common.lcm(&point.weight()));
    let scaled =
        |point: &Point3, axis| (&point.numerator(axis) * &common.div_exact(&point.weight())).bit_len();
    points.iter().flat_map(|point| [0, 1, 2].map(|axis| scaled(point, axis))).collect()
}

type Points = Result<Vec<Point3>, Failure>;

/// Meshes whose coordinates are floats: what arrives from STL files and from simulations.
fn float_meshes() -> [(&'static str, Points); 4] {
    let sphere = geodesic_sphere(FREQUENCY);
    let unit: Vec<[f64; 3]> =
        sphere.points.iter().map(|p| p.map(|x| x as f64 / sphere.denominator as f64)).collect();
    let mut noise = Noise(1);
    let mut spread = || {
        let exponent = i32::try_from(noise.below(60)).expect("a small number") - 30;
        (noise.below(1 << 53) as f64 / (1_u64 << 53) as f64) * f64::from(exponent).exp2()
    };
    let spread: Vec<[f64; 3]> = (0..2562).map(|_| [spread(), spread(), spread()]).collect();
    let single = |scale: f64| {
        let coordinate = |x: f64| f64::from((x * scale + scale) as f32);
        exact_points(unit.iter().map(|p| p.map(coordinate)))
    };
    [
        ("sphere, f64", exact_points(unit.iter().copied())),
        ("sphere, f32 as in STL, in [0, 2]", single(1.0)),
        ("sphere, f32 as in STL, in [0, 200]", single(100.0)),
        ("f64, exponents from -30 to 30", exact_points(spread.into_iter())),
    ]
}

fn exact_points(points: impl Iterator<Item = [f64; 3]>) -> Points {
    let point = |[x, y, z]: [f64; 3]| {
        Ok(Point3::from_rationals(&[Rational::try_from(x)?, Rational::try_from(y)?, Rational::try_from(z)?]))
    };
    points.map(point).collect()
}

fn times() -> Result<(), Failure> {
    println!("\n{:<42} {:>12} {:>10}", "sphere of 2562 vertices and its turn", "seconds", "ns/feature");
    let sphere = geodesic_sphere(FREQUENCY);
    let turned = sphere.turned(TURN);
    // The turn multiplies by 39 and nothing is divided here: six bits more.
    let turned_bits = SPHERE_BITS + 6;
    for bits in TIMED {
        let a = write_input(&format!("width{bits}"), &at_width(&sphere, SPHERE_BITS, bits))?;
        let b = write_input(&format!("width{bits}_turned"), &at_width(&turned, turned_bits, bits))?;
        let case = measure(&a, &b)?;
        let time = 1e9 * case.seconds / case.features;
        println!("{:<42} {:>12.6} {time:>10.0}", format!("integers of {bits} bits"), case.seconds);
    }
    Ok(())
}

/// The solid with integer coordinates of about `bits` bits as OFF: rounded down, or filled up with noise, which is far smaller
/// than the bend at any edge, so that the solid stays convex with the same facets.
fn at_width(solid: &Solid, from: u32, bits: u32) -> String {
    let mut noise = Noise(u64::from(bits));
    let mut widened = |x: i128| {
        let mut value = Integer::from(x >> from.saturating_sub(bits));
        let mut missing = bits.saturating_sub(from);
        while missing > 0 {
            let step = missing.min(32);
            value = (value << step) + Integer::from(noise.below(1 << step));
            missing -= step;
        }
        value.to_string()
    };
    let points: Vec<String> =
        solid.points.iter().map(|point| point.map(&mut widened).join(" ") + "\n").collect();
    let facets = solid.facets.iter().map(|facet| {
        let words: Vec<String> = facet.iter().map(ToString::to_string).collect();
        format!("{} {}\n", facet.len(), words.join(" "))
    });
    let head = format!("OFF\n{} {} 0\n", solid.points.len(), solid.facets.len());
    head + &points.concat() + &facets.collect::<String>()
}

/// The same sequence on every machine (D. E. Knuth's constants for a linear congruential generator).
struct Noise(u64);

impl Noise {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // The low bits of such a generator repeat soon.
        ((u128::from(self.0) * u128::from(limit)) >> 64) as u64
    }
}
