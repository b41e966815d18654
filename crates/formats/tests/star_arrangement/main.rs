//! Arrangements in the native format: one text for each, which comes back; and what is refused.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod bad;
mod models;
mod overlaps;
mod page;
mod random;
mod sphere;
mod sphere_bad;
mod sphere_random;

use splitstar_formats::{StarArrangement, read_arrangement, write_arrangement};

fn read(text: &str) -> StarArrangement {
    read_arrangement(text.as_bytes(), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn write(arrangement: &StarArrangement) -> String {
    String::from_utf8(write_arrangement(arrangement)).unwrap()
}

/// Writes, reads and writes again; gives the text.
fn comes_back(arrangement: &StarArrangement) -> String {
    let text = write(arrangement);
    let again = read(&text);
    assert_eq!(again.counts(), arrangement.counts(), "{text}");
    assert_eq!(again.counts_with_splits(), arrangement.counts_with_splits(), "{text}");
    assert_eq!(write(&again), text);
    text
}
