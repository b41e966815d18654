//! Files made at random, and files changed at random.

use crate::good::GOOD;
use crate::{A, B, C, Corners, D, TETRAHEDRON, binary, binary_with, floats, shown};
use splitstar_formats::{Format, ReadNote, WriteOptions, read, write};
use testkit::{Rng, mutate};

#[test]
fn written_is_what_was_read_for_random_floats() {
    const SEED: u64 = 0x0571_F10A;
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    let triangles: Vec<Corners> = (0..500)
        .map(|_| {
            [(); 3].map(|()| {
                // Few different ones, so that corners meet; all exponents of finite floats.
                [(); 3].map(|()| {
                    f32::from_bits(((random.index(3) * 85 + 3) as u32) << 23 | random.index(2) as u32)
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
    let mut random = Rng::new(SEED);
    let mut accepted = 0;
    for case in 0..CASES {
        let mut bytes = bases[random.index(bases.len())].clone();
        for _ in 0..=random.index(3) {
            mutate(&mut bytes, SPLICES, &mut random);
        }
        match read(&bytes, Some("x.stl")) {
            Ok(model) => {
                accepted += 1;
                if let Ok(written) = write(&model.model, &WriteOptions::new(Format::StlAscii)) {
                    let again =
                        read(&written.bytes, None).unwrap_or_else(|error| panic!("case {case}: {error}"));
                    if written.largest_rounding.is_zero() {
                        assert_eq!(shown(&again).1.len(), shown(&model).1.len(), "case {case}");
                    }
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
