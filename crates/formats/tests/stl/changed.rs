//! Files made at random, and files changed at random.

use crate::good::GOOD;
use crate::{A, B, C, Corners, D, TETRAHEDRON, binary, binary_with, floats, shown};
use splitstar_formats::{Format, ReadNote, WriteOptions, read, write};

#[test]
fn written_is_what_was_read_for_random_floats() {
    const SEED: u64 = 0x0571_F10A;
    println!("seed {SEED:#x}");
    let mut random = Random(SEED);
    let triangles: Vec<Corners> = (0..500)
        .map(|_| {
            [(); 3].map(|()| {
                // Few different ones, so that corners meet; all exponents of finite floats.
                [(); 3].map(|()| {
                    f32::from_bits(((random.below(3) * 85 + 3) as u32) << 23 | random.below(2) as u32)
                })
            })
        })
        .collect();
    let model = read(&binary(&triangles), None).unwrap();
    let written = write(&model.model, &WriteOptions::new(Format::Stl)).unwrap();
    assert!(written.largest_rounding.is_zero());
    let kept =
        |corners: &&Corners| corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
    let kept: Vec<&Corners> = triangles.iter().filter(kept).collect();
    for (facet, corners) in kept.iter().enumerate() {
        assert_eq!(floats(&written.bytes, facet)[3..], *corners.as_flattened());
    }
    assert_eq!(written.bytes.len(), 84 + 50 * kept.len());
    assert_eq!(model.notes, [ReadNote::DegenerateDropped { facets: 500 - kept.len() }]);
}

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }
}

const SPLICES: &[&[u8]] = &[
    b"solid",
    b"endsolid\nsolid x\n",
    b"facet",
    b"endfacet",
    b"vertex",
    b"outer",
    b"endloop",
    b" ",
    b"\n",
    b"\0",
    b"#",
    b"\xFF",
    b"-",
    b"1e400",
    b"1e-400",
    b"1e401",
    b"1/0",
    b"1/3",
    b"nan",
    b"inf",
    b"123456789012345678901234567890",
    b"\x7F\x80\0\0",
    b"\0\0\x80\x7F",
    b"\xFF\xFF\xFF\xFF",
    b"\x01\0\0\0",
];

fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len() + 1);
    let end = (at + random.below(60)).min(bytes.len());
    let splice = SPLICES[random.below(SPLICES.len())];
    match random.below(6) {
        0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
        1 => drop(bytes.splice(at..at, splice.iter().copied())),
        2 => drop(bytes.splice(at..(at + splice.len()).min(bytes.len()), splice.iter().copied())),
        3 => drop(bytes.drain(at..end)),
        4 => {
            let copy = bytes[at..end].to_vec();
            let to = random.below(bytes.len() + 1);
            drop(bytes.splice(to..to, copy));
        }
        _ if random.below(8) == 0 => bytes.truncate(at),
        _ => {}
    }
}

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x0571_5EED;
    const CASES: usize = 10_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut bases: Vec<Vec<u8>> = GOOD.iter().map(|row| row.text.as_bytes().to_vec()).collect();
    bases.extend([
        binary(&TETRAHEDRON),
        binary_with(b"solid x\0", 4, &TETRAHEDRON),
        binary(&[[A, B, A], [B, C, D]]),
    ]);
    let mut random = Random(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let mut bytes = bases[random.below(bases.len())].clone();
        for _ in 0..=random.below(3) {
            mutate(&mut bytes, &mut random);
        }
        match read(&bytes, Some("x.stl")) {
            Ok(model) => {
                accepted += 1;
                if let Ok(written) = write(&model.model, &WriteOptions::new(Format::StlAscii)) {
                    let again =
                        read(&written.bytes, None).unwrap_or_else(|error| panic!("case {case}: {error}"));
                    assert_eq!(shown(&again).1.len(), shown(&model).1.len(), "case {case}");
                }
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    println!("{accepted} accepted");
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
}
