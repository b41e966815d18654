//! Where models must lie for the printed counts of their Gaussian maps: a search of small exact rotations.
//!
//! All primitive quaternions with small integer components are tried, one of each pair of opposite ones, the smallest first. For the
//! spherical map that is also a search of the identification: a rotation about the axis of the poles moves it.

use super::maps::columns;
use super::paths;
use super::rows::{POLYTOPES, Row, SUMS};
use crate::Failure;
use crate::library::{self, MapCounts};

/// No component is larger.
const LARGEST: i64 = 4;

/// Searches for all rows, or for one.
///
/// # Errors
/// If a model cannot be read.
pub(super) fn run(name: Option<&str>) -> Result<(), Failure> {
    let turns = turns();
    println!("{} placements", turns.len());
    for row in POLYTOPES.iter().chain(&SUMS).filter(|row| name.is_none_or(|name| name == row.name)) {
        search(row, &turns)?;
    }
    Ok(())
}

fn search(row: &Row, turns: &[[i64; 4]]) -> Result<(), Failure> {
    // The map of a sum depends on the sum alone.
    let sum = library::sum(&library::polytopes(&paths(row.maps_of))?);
    for (column, map, count) in columns(row) {
        let mut nearest: Option<(usize, [i64; 4], MapCounts)> = None;
        let mut tried = 0;
        for &turn in turns {
            tried += 1;
            let counted = count(&[library::turned(&sum, turn)]);
            let distance = counted.distance(map.printed);
            if nearest.is_none_or(|(least, ..)| distance < least) {
                nearest = Some((distance, turn, counted));
            }
            if distance == 0 {
                break;
            }
        }
        if let Some((distance, turn, counted)) = nearest {
            let how = if distance == 0 { "found" } else { "nearest" };
            println!(
                "{} {column}: {how} {turn:?} after {tried}: {counted}, printed {}",
                row.name, map.printed
            );
        }
    }
    Ok(())
}

/// The quaternions, the smallest first.
fn turns() -> Vec<[i64; 4]> {
    let range = -LARGEST..=LARGEST;
    let mut turns = Vec::new();
    for w in 0..=LARGEST {
        for x in range.clone() {
            for y in range.clone() {
                for z in range.clone() {
                    let turn = [w, x, y, z];
                    let is_first = turn.iter().find(|&&c| c != 0).is_some_and(|&c| c > 0);
                    if is_first && turn.iter().fold(0, |divisor, &c| gcd(divisor, c.abs())) == 1 {
                        turns.push(turn);
                    }
                }
            }
        }
    }
    turns.sort_by_key(|turn| (turn.iter().map(|c| c * c).sum::<i64>(), turn.map(|c| -c)));
    turns
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_primitive_and_different() {
        let turns = turns();
        assert_eq!(turns[0], [1, 0, 0, 0]);
        assert!(
            turns.contains(&[2, -1, 0, 3])
                && !turns.contains(&[2, -2, 0, 4])
                && !turns.contains(&[-1, 1, 0, 0])
        );
        let mut sorted = turns.clone();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), turns.len());
    }
}
