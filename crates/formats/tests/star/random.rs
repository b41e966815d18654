//! Random complexes come back, and changed files never do harm.

use crate::{CUBE, examples, model, read, records, write};
use exact::{Integer, Point3, Vector3};
use splitstar_formats::{Complex, Edge, Facet, Object, Shape, Vertex};
use testkit::Rng;

const SEED: u64 = 0x57A2_5EED;

/// Random cells.
struct Random(Rng);

impl Random {
    fn new(seed: u64) -> Self {
        Self(Rng::new(seed))
    }

    fn below(&mut self, bound: usize) -> usize {
        self.0.index(bound)
    }

    fn point(&mut self) -> Point3 {
        let numerators = [0, 1, 2].map(|_| Integer::from(self.below(41) as i64 - 20));
        Point3::new(numerators, Integer::from(1 + self.below(6) as i64)).unwrap()
    }

    /// Different vertices, in any order.
    fn cycle(&mut self, vertices: usize, size: usize) -> Vec<u32> {
        let mut all: Vec<u32> = (0..vertices as u32).collect();
        (0..size.min(vertices)).map(|_| all.swap_remove(self.below(all.len()))).collect()
    }

    fn complex(&mut self) -> Complex {
        let mut complex = Complex::default();
        for _ in 0..self.below(14) {
            let axis = self.below(3);
            let vertex = if self.below(4) == 0 {
                let sign = 1 - 2 * self.below(2) as i64;
                let entries = [0, 1, 2].map(|i| if i == axis { sign } else { 0 });
                Vertex::direction(Vector3::from_i64(entries))
            } else {
                Vertex { marked: self.below(8) > 0, ..Vertex::point(self.point()) }
            };
            complex.vertices.push(vertex);
        }
        for volume in 0..self.below(5) as u32 {
            complex.volumes.insert(
                volume,
                if volume < 2 && self.below(4) > 0 { volume == 1 } else { self.below(2) == 0 },
            );
        }
        let vertices = complex.vertices.len();
        // What breaks a rule is dropped again.
        for _ in 0..self.below(12) {
            let through = (self.below(3) == 0).then(|| self.point());
            let outer = {
                let size = 3 + self.below(3);
                self.cycle(vertices, size)
            };
            let holes = (0..self.below(6) / 3)
                .map(|_| {
                    let size = 1 + self.below(4);
                    self.cycle(vertices, size)
                })
                .collect();
            let sides =
                if self.below(2) == 0 { [0, 1] } else { [self.below(5) as u32, self.below(5) as u32] };
            complex.facets.push(Facet { outer, holes, through, sides, marked: self.below(5) > 0 });
            if complex.check().is_err() {
                complex.facets.pop();
            }
        }
        for _ in 0..self.below(12) {
            let through = (self.below(3) == 0).then(|| self.point());
            let &[a, b] = self.cycle(vertices, 2).as_slice() else { continue };
            complex.edges.push(Edge { ends: [a, b], through, marked: self.below(3) > 0 });
            if complex.check().is_err() {
                complex.edges.pop();
            }
        }
        complex
    }
}

#[test]
fn random_complexes_come_back() {
    println!("seed {SEED:#x}");
    let mut random = Random::new(SEED);
    let (mut same, mut meshes, mut lines) = (0, 0, 0);
    for _ in 0..3_000 {
        let complex = random.complex();
        lines += complex.edges.iter().filter(|edge| edge.through.is_some()).count();
        let mut model = model(complex.clone());
        let first_facet = random.below(1 + complex.facets.len()) as u32;
        model.objects.push(Object { name: "a \\ \"b\"\n".into(), first_facet });
        let text = write(&model);
        let again = read(&text).model;
        assert_eq!(write(&again), text);
        match again.shape {
            Shape::Mesh(mesh) => {
                meshes += 1;
                assert_eq!(mesh.points.len(), complex.vertices.len());
            }
            Shape::Complex(read) => {
                assert_eq!((&read.vertices, &read.facets), (&complex.vertices, &complex.facets), "{text}");
                assert!(complex.edges.len() >= read.edges.len(), "{text}");
                same += usize::from(read == complex);
                assert_eq!(read.summary(), complex.summary(), "{text}");
            }
        }
    }
    assert!(same > 1_500 && meshes > 50 && lines > 40, "{same} {meshes} {lines}");
}

const SPLICES: &[&str] = &[
    " ",
    "\n",
    "\r\n",
    "#",
    "\"",
    "\\",
    "\\u{",
    "}",
    "\0",
    "-",
    "/",
    ".",
    "e",
    "0",
    "9",
    "4294967295",
    "4294967294",
    "1e400",
    "1e401",
    "1e99999999",
    "1/0",
    "-7/999999999999999999",
    "unmarked",
    "marked",
    "hole",
    "sides",
    "sides 0 0",
    "through",
    "through 0 0 0",
    "vertex",
    "direction",
    "volume",
    "object",
    "facet",
    "edge",
    "unit",
    "inch",
    "end",
    "star",
    "complex",
];

const RECORDS: &[&str] = &[
    "vertex 90 1/3 2 3\n",
    "direction 91 -1 0 0\n",
    "volume 7 unmarked\n",
    "object \"x\"\n",
    "edge 0 1\n",
    "facet 0 1 2\n",
    "facet 0 1 2 hole 2 3 sides 7 1\n",
    "edge 1 2 unmarked\n",
    "# comment\n",
];

fn mutate(text: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(text.len() + 1);
    match random.below(7) {
        0 if at < text.len() => text[at] ^= 1 << random.below(8),
        1 if at < text.len() => text[at] = random.0.bits() as u8,
        2 => {
            let to = (at + 1 + random.below(40)).min(text.len());
            text.drain(at.min(to)..to);
        }
        3 => {
            // A line is said twice, or moved.
            let lines: Vec<Vec<u8>> = text.split_inclusive(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
            if !lines.is_empty() {
                let line = lines[random.below(lines.len())].clone();
                let before: usize = lines.iter().take(random.below(lines.len())).map(Vec::len).sum();
                text.splice(before..before, line);
            }
        }
        4 => {
            // A number is another.
            let digits: Vec<usize> = (0..text.len()).filter(|&at| text[at].is_ascii_digit()).collect();
            if !digits.is_empty() {
                text[digits[random.below(digits.len())]] = b'0' + random.below(10) as u8;
            }
        }
        5 => {
            // A record more.
            let starts: Vec<usize> = (1..text.len()).filter(|&at| text[at - 1] == b'\n').collect();
            if !starts.is_empty() {
                let start = starts[random.below(starts.len())];
                let record = RECORDS[random.below(RECORDS.len())].as_bytes();
                text.splice(start..start, record.iter().copied());
            }
        }
        _ => {
            let splice = SPLICES[random.below(SPLICES.len())].as_bytes();
            text.splice(at..at, splice.iter().copied());
        }
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    println!("seed {SEED:#x}");
    let mut random = Random::new(SEED);
    let mut files = examples();
    files.push(records(CUBE));
    let mut accepted = 0;
    for _ in 0..30_000 {
        // The first word says the format, and stays.
        let (word, rest) = files[random.below(files.len())].split_at(4);
        let mut text = rest.as_bytes().to_vec();
        for _ in 0..1 + random.below(3) {
            mutate(&mut text, &mut random);
        }
        text.splice(0..0, word.bytes());
        let Ok(read) = splitstar_formats::read(&text, Some("star")) else { continue };
        if read.format != splitstar_formats::Format::Star {
            continue;
        }
        accepted += 1;
        let written = write(&read.model);
        let again = crate::read(&written).model;
        assert_eq!(write(&again), written);
        if let Shape::Complex(complex) = &read.model.shape {
            assert_eq!(complex.check(), Ok(()));
            complex.summary();
            let mut options = splitstar_formats::WriteOptions::new(splitstar_formats::Format::Off);
            options.lossy = true;
            let _ = splitstar_formats::write(&read.model, &options);
        }
    }
    assert!(accepted > 2_000, "{accepted}");
}

#[test]
fn short_files_take_little_memory() {
    // The shortest records, many: none may be refused for its memory.
    for record in ["vertex # 0 0 0\n", "object \"\"\n", "volume #\n"] {
        let mut text = "star 1 complex\n".to_string();
        for id in 0..300_000 {
            text += &record.replace('#', &id.to_string());
        }
        text += "end\n";
        assert!(splitstar_formats::read(text.as_bytes(), None).is_ok(), "{record}");
    }
    for record in ["facet 0 1 2\n", "facet 0 1 2 hole 3\n", "facet 0 1 2 unmarked\n"] {
        let vertices = "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\nvertex 3 0 0 1\n";
        let text = records(&format!("{vertices}{}", record.repeat(300_000)));
        assert!(splitstar_formats::read(text.as_bytes(), None).is_ok(), "{record}");
    }
    for mark in ["", " unmarked"] {
        let mut text = "star 1 complex\n".to_string();
        for id in 0..550 {
            text += &format!("vertex {id} {id} 0 0\n");
            (0..id).for_each(|other| text += &format!("edge {other} {id}{mark}\n"));
        }
        text += "end\n";
        assert!(splitstar_formats::read(text.as_bytes(), None).is_ok(), "{mark}");
    }
}
