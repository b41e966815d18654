//! What zones cost, in calls of predicates.

use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::wrappers::CountingTraits;
use splitstar_arrangement::{Arrangement, Editor};
use testkit::{long_segments, short_segments};

fn segments(drawn: &[[i64; 4]]) -> Vec<Segment> {
    drawn.iter().map(|&[x, y, z, w]| Segment::from_i64([[x, y], [z, w]]).unwrap()).collect()
}

struct Figures {
    /// Predicates for each long segment, on the average.
    predicates: u64,
    /// Vertices and edges met by all of them.
    met: usize,
    /// Predicates for each long segment when it is asked only whether it meets anything.
    until_first: u64,
}

/// The zones of 100 long segments among 10,000 short ones.
fn figures(bits: u32) -> Figures {
    let short = segments(&short_segments(10_000, bits, 1).objects);
    let editor =
        Editor::new(Arrangement::of_curves(CountingTraits::new(SegmentTraits), BoundedPlane, &short));
    let long = segments(&long_segments(100, 2).objects);
    let counters = editor.traits().counters();
    counters.reset();
    let cells: Vec<Cell> = long.iter().flat_map(|segment| editor.zone_cells(segment)).collect();
    let predicates = counters.total() / 100;
    counters.reset();
    let meet = long.iter().filter(|segment| editor.meets_anything(segment)).count();
    assert!(meet > 20, "{meet}");
    let met = cells.iter().filter(|cell| !matches!(cell, Cell::Face(_))).count();
    Figures { predicates, met, until_first: counters.total() / 100 }
}

/// There are thousands of holes, which stop walls: so most of them are not asked.
#[test]
fn among_short_segments() {
    let Figures { predicates, met, until_first } = figures(15);
    assert!(met > 1_000, "{met}");
    assert!(predicates < 2_600 && until_first < 100, "{predicates}, {until_first}");
}

/// Walls end at holes; where holes are almost points, most walls are crossed.
#[test]
fn among_tiny_segments() {
    for (bits, most) in [(12, 6_000), (8, 19_000)] {
        let Figures { predicates, .. } = figures(bits);
        assert!(predicates < most, "{predicates}");
    }
}
