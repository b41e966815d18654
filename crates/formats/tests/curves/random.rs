//! Random curves come back, and changed files never break the reader.

use super::{read, shown};
use splitstar_formats::{CurvePoint, InputCurve, read_curves, write_curves};
use std::io::Write;
use std::time::{Duration, Instant};
use testkit::{Rng, mutate};

const SEED: u64 = 0xC0_4BE5;

fn point(random: &mut Rng) -> CurvePoint {
    let mut coordinate = || match random.below(4) {
        0 => format!("{}", random.below(5)).parse().unwrap(),
        1 => format!("-{}/{}", random.bits(), random.bits() | 1).parse().unwrap(),
        2 => format!("{}.{}", random.below(100), random.bits()).parse().unwrap(),
        _ => format!("{}e-{}", random.bits(), random.below(300)).parse().unwrap(),
    };
    CurvePoint::from_rationals(&[coordinate(), coordinate()])
}

fn different(random: &mut Rng) -> [CurvePoint; 2] {
    loop {
        let points = [point(random), point(random)];
        if points[0] != points[1] {
            return points;
        }
    }
}

fn curve(random: &mut Rng) -> InputCurve {
    match random.below(5) {
        0 => InputCurve::Segment(different(random)),
        1 => InputCurve::Ray(different(random)),
        2 => InputCurve::Line(different(random)),
        3 => InputCurve::Point(point(random)),
        _ => {
            let mut points = Vec::from(different(random));
            points.extend((0..random.below(5)).map(|_| point(random)));
            points.dedup();
            InputCurve::Polyline(points)
        }
    }
}

#[test]
fn curves_come_back() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for case in 0..500 {
        let curves: Vec<InputCurve> = (0..random.below(8)).map(|_| curve(&mut random)).collect();
        let text = write_curves(&curves);
        let again = read_curves(&text, None).unwrap_or_else(|error| panic!("case {case}: {error}"));
        assert_eq!(again.curves, curves, "case {case}");
        assert_eq!(write_curves(&again.curves), text, "case {case}");
    }
}

/// A segment as the three grammars write it, in decimals of random length.
#[test]
fn all_grammars_give_the_same_numbers() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for _ in 0..2_000 {
        let mut number = || {
            let sign = if random.one_in(2) { "-" } else { "" };
            let decimal = format!("{sign}{}.{}", random.below(1000), random.bits() >> random.below(64));
            if random.one_in(4) { format!("{decimal}e{}", random.below(40)) } else { decimal }
        };
        let [a, b, c, d] = [number(), number(), number(), number()];
        let own = read(&format!("polyline {a} {b} {c} {d}"));
        let wkt = read(&format!("LINESTRING({a} {b},{c} {d})"));
        let json = read(&format!("{{\"type\":\"LineString\",\"coordinates\":[[{a},{b}],[{c},{d}]]}}"));
        assert_eq!((&wkt.curves, &json.curves), (&own.curves, &own.curves), "{}", shown(&own));
    }
}

fn gzip(text: &[u8]) -> Vec<u8> {
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    packer.write_all(text).unwrap();
    packer.finish().unwrap()
}

#[test]
fn gzip_may_be_around_a_file() {
    let text = b"segment 0 0 1 1\nPOINT (1 2)\n";
    let file = read_curves(&gzip(text), Some("a.txt.gz")).unwrap();
    assert_eq!(shown(&file), "segment 0 0 1 1\npoint 1 2");
    let twice = read_curves(&gzip(&gzip(text)), None).unwrap_err();
    assert_eq!(twice.to_string(), "gzip within gzip cannot be read; unpack it once");
    let packed = gzip(text);
    let cut = read_curves(&packed[..packed.len() - 9], None).unwrap_err();
    assert_eq!(cut.to_string(), "byte 0: the packed data is damaged: it ends too early; pack it again");
}

/// A packed file may promise more points than there may be memory for.
#[test]
fn memory_is_bounded_by_the_file() {
    let zeros = "0 0,".repeat(8 << 20);
    let text = format!("MULTIPOINT({zeros}0 0)\n");
    let packed = gzip(text.as_bytes());
    let error = read_curves(&packed, None).unwrap_err();
    assert!(error.to_string().contains("too much for a file of this size"), "{error}");
    let digits = format!("point {}1e400 1e-400\n", "0".repeat(100)).repeat(300_000);
    let error = read_curves(&gzip(digits.as_bytes()), None).unwrap_err();
    assert!(error.to_string().contains("too much for a file of this size"), "{error}");
    // The points that are left out take none.
    let repeated = format!("LINESTRING({zeros}1 1)");
    assert_eq!(read_curves(repeated.as_bytes(), None).unwrap().curves.len(), 1);
}

const BASES: [&str; 4] = [
    "# a\nsegment 0 0 1/3 2.5\nray 0 0 1 1\nline 1e2 0 0 -1\npolyline 0 0 1 1 1 1 2 0\npoint .5 5.\n",
    "period 3 4.5\nsegment 0 0 3 0\nPOINT (1 1)\nSRID=4326;POLYGON Z ((0 0 1, 1 0 1, 0 1 1, 0 0 1))\n",
    "MULTIPOINT (1 2, (3 4))\nGEOMETRYCOLLECTION (POINT EMPTY,\nMULTILINESTRING ((0 0, 1 1), (2 2, 3 3, 3 3)))\n",
    "{\"type\":\"FeatureCollection\",\"features\":[{\"geometry\":{\"coordinates\":[[0,0,7],[1e-1,2]],\n\
     \"type\":\"LineString\"},\"properties\":{\"a\":[null,\"b\"]},\"type\":\"Feature\"}]}\npoint 0 0\n",
];

const SPLICES: &[&[u8]] = &[
    b"-",
    b".",
    b"e",
    b"/",
    b"#",
    b"\n",
    b"\r",
    b" ",
    b"\0",
    b"\xFF",
    b"0",
    b"9",
    b"(",
    b")",
    b",",
    b";",
    b"[",
    b"]",
    b"{",
    b"}",
    b":",
    b"\"",
    b"\\",
    b"1e400",
    b"1e401",
    b"1/0",
    b"-7/3",
    b"nan",
    b"EMPTY",
    b"Z",
    b"point",
    b"POINT(",
    b"line 0 0 ",
    b"segment 0 0 1 1\n",
    b"polyline ",
    b"period 1 1\n",
    b"\"type\"",
    b"\"Point\"",
    b"\"coordinates\":",
    b"\"geometries\":[",
    b"null",
    b"[[[[",
    b"GEOMETRYCOLLECTION(",
    b"SRID=",
    b"1 1, 1 1, ",
    b"123456789012345678901234567890",
    b"0.000000000000000000000000000000001",
];

#[test]
fn changed_files_never_break_the_reader() {
    const CASES: usize = 30_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Rng::new(SEED);
    let (mut accepted, mut slowest) = (0, Duration::ZERO);
    for case in 0..CASES {
        let mut text = BASES[random.index(BASES.len())].as_bytes().to_vec();
        for _ in 0..=random.index(2) {
            mutate(&mut text, SPLICES, &mut random);
        }
        let start = Instant::now();
        let result = read_curves(&text, None);
        slowest = slowest.max(start.elapsed());
        match result {
            Ok(file) => {
                accepted += 1;
                assert!(file.curves.capacity() <= text.len() / 2 + 4, "case {case}");
                let again = read_curves(&write_curves(&file.curves), None)
                    .unwrap_or_else(|error| panic!("case {case}: {error}"));
                assert_eq!(again.curves, file.curves, "case {case}");
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    println!("{accepted} accepted, slowest {slowest:?}");
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
    assert!(slowest < Duration::from_secs(2), "{slowest:?}");
}
