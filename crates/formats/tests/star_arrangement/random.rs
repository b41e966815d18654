//! Random arrangements come back, their texts do not depend on the order of curves, and changed texts are read or refused.

use super::models::{
    Row, linear_arrangement, polycurve_arrangement, torus_arrangement, torus_polycurve_arrangement,
};
use super::{comes_back, read, write};
use splitstar_formats::{StarArrangement, read_arrangement};

/// Numbers of a sequence that a seed gives.
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) fn new(seed: u64) -> Self {
        println!("seed {seed}");
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    fn coordinate(&mut self, bound: u64) -> i64 {
        self.below(bound) as i64
    }

    pub(crate) fn pair(&mut self, bound: u64) -> [i64; 2] {
        [self.coordinate(bound), self.coordinate(bound)]
    }

    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i as u64 + 1) as usize);
        }
    }

    /// Straight curves and points, and polylines if asked for, with few coordinates: everything degenerate happens.
    fn plane(&mut self, has_polylines: bool) -> Vec<Row> {
        let count = self.below(9);
        let row = |numbers: &mut Self| {
            let ([a, b], [c, d]) = (numbers.pair(7), numbers.pair(7));
            match numbers.below(if has_polylines { 9 } else { 6 }) {
                0..3 => Row::Segment([a, b, c, d]),
                3 => Row::Ray([a, b, c, d]),
                4 => Row::Line([a, b, c, d]),
                5 => Row::Point([a, b]),
                _ => {
                    let points = 1 + numbers.below(6);
                    Row::Polyline((0..points).map(|_| numbers.pair(7)).collect())
                }
            }
        };
        (0..count).map(|_| row(self)).collect()
    }

    fn torus(&mut self, has_polylines: bool) -> Vec<Row> {
        let count = self.below(6);
        let row = |numbers: &mut Self| {
            let start = numbers.pair(8);
            let [dx, dy] = numbers.pair(19).map(|d| d - 9);
            match numbers.below(if has_polylines { 9 } else { 6 }) {
                6.. => {
                    let points = 1 + numbers.below(6);
                    Row::Polyline((0..points).map(|_| numbers.pair(11)).collect())
                }
                0 => Row::Point(start),
                1 => Row::Closed(start, [dx % 3, dy % 3]),
                _ => Row::Path(start, [dx, dy]),
            }
        };
        (0..count).map(|_| row(self)).collect()
    }
}

/// The same curves in another order, and turned round.
pub(crate) fn turned(row: &Row) -> Row {
    match row {
        Row::Segment([a, b, c, d]) => Row::Segment([*c, *d, *a, *b]),
        Row::Line([a, b, c, d]) => Row::Line([*c, *d, 2 * c - a, 2 * d - b]),
        Row::Polyline(points) => Row::Polyline(points.iter().rev().copied().collect()),
        row => row.clone(),
    }
}

pub(crate) type Make = fn(&[Row]) -> StarArrangement;

fn torus(rows: &[Row]) -> StarArrangement {
    torus_arrangement([2, 1], rows)
}

fn torus_polycurves(rows: &[Row]) -> StarArrangement {
    torus_polycurve_arrangement([2, 1], rows)
}

pub(crate) const MAKERS: [(&str, Make); 4] = [
    ("linear", linear_arrangement),
    ("polycurves", polycurve_arrangement),
    ("torus", torus),
    ("torus polycurves", torus_polycurves),
];

fn rows(numbers: &mut Numbers, name: &str) -> Vec<Row> {
    match name {
        "torus" => numbers.torus(false),
        "torus polycurves" => numbers.torus(true),
        name => numbers.plane(name == "polycurves"),
    }
}

#[test]
fn texts_come_back_and_do_not_depend_on_the_order() {
    let mut numbers = Numbers::new(1);
    for (name, make) in MAKERS {
        let mut longest = 0;
        for case in 0..1500 {
            let mut rows = rows(&mut numbers, name);
            println!("{name} {case} {rows:?}");
            let text = comes_back(&make(&rows));
            longest = longest.max(text.len());
            numbers.shuffle(&mut rows);
            let again: Vec<Row> = rows.iter().map(turned).collect();
            assert_eq!(write(&make(&again)), text, "{name} {case}: {rows:?}");
        }
        assert!(longest > 1000, "{name}: {longest}");
    }
}

/// Whatever is changed in a text, it is read, and then is an arrangement, or it is refused with a short message and a line.
#[test]
fn changed_texts_are_read_or_refused() {
    let mut numbers = Numbers::new(2);
    let (mut read_back, mut refused) = (0, 0);
    for (name, make) in MAKERS {
        for case in 0..400 {
            let text = write(&make(&rows(&mut numbers, name)));
            for _ in 0..8 {
                let changed = changed(&text, &mut numbers);
                match read_arrangement(changed.as_bytes(), None) {
                    Ok(arrangement) => {
                        comes_back(&arrangement);
                        read_back += 1;
                    }
                    Err(error) => {
                        let message = error.to_string();
                        assert!(message.len() < 400 && !message.contains(char::is_control), "{message}");
                        assert!(message.starts_with("line "), "{name} {case}: {message}\n{changed}");
                        refused += 1;
                    }
                }
            }
        }
    }
    println!("{read_back} read, {refused} refused");
    assert!(read_back > 200 && refused > 2000, "{read_back} {refused}");
}

/// A word changed for another one of the text, a line left out, or two lines exchanged.
pub(crate) fn changed(text: &str, numbers: &mut Numbers) -> String {
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let any = |numbers: &mut Numbers, count: usize| numbers.below(count as u64) as usize;
    for _ in 0..1 + numbers.below(2) {
        // The first line stays.
        let (i, j) = (1 + any(numbers, lines.len() - 1), 1 + any(numbers, lines.len() - 1));
        match numbers.below(8) {
            0 if lines.len() > 3 => drop(lines.remove(i)),
            1 => lines.swap(i, j),
            2 => lines.insert(i, lines[j].clone()),
            _ => {
                let other: Vec<&str> = lines[j].split(' ').collect();
                let other = other[any(numbers, other.len())].to_string();
                let mut words: Vec<String> = lines[i].split(' ').map(String::from).collect();
                let at = any(numbers, words.len());
                match numbers.below(6) {
                    0 => drop(words.remove(at)),
                    1 => words.insert(at, other),
                    2 => words[at] = words[at].replace('+', "-"),
                    3 => words[at] = words[at].replace('-', "+"),
                    4 => words[at] = numbers.below(7).to_string(),
                    _ => words[at] = other,
                }
                lines[i] = words.join(" ");
            }
        }
    }
    lines.join("\n")
}

#[test]
fn prefixes_are_refused() {
    let mut numbers = Numbers::new(3);
    for (name, make) in MAKERS {
        let text = write(&make(&rows(&mut numbers, name)));
        for length in 0..text.len() - 1 {
            assert!(read_arrangement(&text.as_bytes()[..length], None).is_err(), "{name} {length}");
        }
        read(&text[..text.len() - 1]);
    }
}
