//! Gzip around files: members, padding, damage, bombs.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use splitstar_formats::{Encoding, Fault, Format, ReadError, ReadModel, WriteOptions, read, write};
use std::time::{Duration, Instant};

const TRIANGLE: &[u8] = b"OFF\n3 1 3\n0 0 0\n1/2 0 0\n0 1 0\n3 0 1 2\n";

/// Packs as the writer does.
fn pack(bytes: &[u8]) -> Vec<u8> {
    use std::io::Write;
    let mut packer = flate2::GzBuilder::new().mtime(0).write(Vec::new(), flate2::Compression::default());
    packer.write_all(bytes).unwrap();
    packer.finish().unwrap()
}

fn assert_triangle(read: Result<ReadModel, ReadError>, what: &str) {
    let read = read.unwrap_or_else(|error| panic!("{what}: {error}"));
    assert_eq!(read.format, Format::Off, "{what}");
    let mesh = read.model.shape.mesh().unwrap();
    assert_eq!((mesh.points.len(), mesh.facets.len()), (3, 1), "{what}");
    assert_eq!(mesh.points[1].coordinates()[0].to_string(), "1/2", "{what}");
}

#[test]
fn members_and_padding_are_read() {
    let whole = pack(TRIANGLE);
    assert_triangle(read(&whole, None), "one member");
    let (first, second) = TRIANGLE.split_at(17);
    assert_triangle(read(&[pack(first), pack(second)].concat(), None), "two members");
    assert_triangle(read(&[pack(b""), pack(TRIANGLE), pack(b"")].concat(), None), "empty members");
    assert_triangle(read(&[&whole[..], &[0; 1000]].concat(), None), "padding");
    assert_triangle(read(&whole, Some("off.gz")), "with an ending");
    let mut packer = flate2::GzBuilder::new()
        .filename("a.off")
        .comment("a triangle")
        .write(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut packer, TRIANGLE).unwrap();
    assert_triangle(read(&packer.finish().unwrap(), None), "name and comment");
}

#[test]
fn what_is_written_comes_back() {
    let model = read(TRIANGLE, None).unwrap().model;
    let encoding = Encoding { format: Format::Off, gzip: true };
    let written = write(&model, &WriteOptions::new(encoding)).unwrap().bytes;
    // No time, no name, no system.
    assert_eq!(written[..10], [0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 255]);
    assert_eq!(written, write(&model, &WriteOptions::new(encoding)).unwrap().bytes);
    assert_triangle(read(&written, None), "written");
}

#[test]
fn damage_is_told() {
    let whole = pack(TRIANGLE);
    let length = whole.len();
    let changed = |at: usize, value: u8| {
        let mut bytes = whole.clone();
        bytes[at] = value;
        bytes
    };
    let after = |bytes: &[u8]| [&whole[..], bytes].concat();
    let early = "byte 0: the packed data is damaged: it ends too early; pack it again";
    let header = "byte 0: the packed data is damaged: its header is wrong; pack it again";
    let checksum = "byte 0: the packed data is damaged: what it unpacks to is not what was packed, by its checksum; \
                    pack it again";
    let follows = format!(
        "byte {length}: the packed data is damaged: something that is not gzip follows the end; pack it again"
    );
    let second = format!("byte {length}: the packed data is damaged: it ends too early; pack it again");
    let rows = [
        ("only the magic", whole[..2].to_vec(), early),
        ("half a header", whole[..7].to_vec(), early),
        ("half the data", whole[..length / 2].to_vec(), early),
        ("half a checksum", whole[..length - 6].to_vec(), early),
        ("another method", changed(2, 7), header),
        ("a reserved flag", changed(3, 0xE0), header),
        ("a wrong checksum", changed(length - 8, whole[length - 8] ^ 1), checksum),
        ("a wrong length", changed(length - 1, 7), checksum),
        (
            "a wrong block",
            changed(10, 0xFF),
            "byte 0: the packed data is damaged: it is not what a packer writes; pack it again",
        ),
        ("garbage behind", after(b"garbage"), &follows),
        ("garbage behind padding", after(b"\0\0\0garbage"), &follows),
        ("half a second member", after(&whole[..length - 10]), &second),
        ("gzip within gzip", pack(&whole), "gzip within gzip cannot be read; unpack it once"),
        ("nothing", pack(b""), "the file is empty; a model was expected"),
    ];
    for (name, bytes, message) in rows {
        assert_eq!(read(&bytes, None).unwrap_err().to_string(), message, "{name}");
    }
}

#[test]
fn bombs_stop_early() {
    // 10 MB of zeros to a member, a thousand to one.
    let member = pack(&vec![0; 10_000_000]);
    assert!(member.len() < 20_000);
    for (name, count) in [("100 MB", 10), ("1 GB", 100)] {
        let bomb = member.repeat(count);
        let start = Instant::now();
        let error = read(&bomb, None).unwrap_err();
        let elapsed = start.elapsed();
        assert_eq!(
            error.fault,
            Fault::TooMuchMemory { allowed: 62 * bomb.len() as u64 + (58 << 20) },
            "{name}"
        );
        assert!(elapsed < Duration::from_secs(2), "{name}: {elapsed:?}");
    }
    // What fits is unpacked, and then it is no mesh.
    let error = read(&member, None).unwrap_err();
    assert_eq!(error.to_string().split(':').next(), Some("line 1"), "{error}");
}

#[test]
fn many_empty_members_end_soon() {
    let members = |count: usize| [pack(b"").repeat(count), pack(TRIANGLE)].concat();
    assert_triangle(read(&members(10_000), None), "10,000 empty members");
    let bytes = members(500_000);
    let start = Instant::now();
    let error = read(&bytes, None).unwrap_err();
    assert_eq!(error.fault, Fault::TooMuchMemory { allowed: 62 * bytes.len() as u64 + (58 << 20) });
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
}

#[test]
fn all_parts_of_a_header_are_read() {
    let whole = pack(TRIANGLE);
    let with = |flags: u8, parts: &[u8]| [&whole[..3], &[flags], &whole[4..10], parts, &whole[10..]].concat();
    assert_triangle(read(&with(4, b"\x03\0abc"), None), "an extra field");
    assert_triangle(read(&with(4 | 8 | 16, b"\0\0a.off\0a triangle\0"), None), "all three");
    let mut crc = flate2::Crc::new();
    crc.update(&with(2, b"")[..10]);
    let sum = (crc.sum() as u16).to_le_bytes();
    assert_triangle(read(&with(2, &sum), None), "a checksum of the header");
    let wrong = read(&with(2, &[sum[0] ^ 1, sum[1]]), None).unwrap_err();
    assert_eq!(wrong.to_string(), "byte 0: the packed data is damaged: its header is wrong; pack it again");
    for flags in [4, 8, 16] {
        let bytes = [&whole[..3], &[flags], &whole[4..10], b"\x01"].concat();
        let error = read(&bytes, None).unwrap_err();
        assert_eq!(error.to_string(), "byte 0: the packed data is damaged: it ends too early; pack it again");
    }
}

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x671F_5EED;
    println!("seed {SEED:#x}");
    let mut state = SEED;
    let mut random = |bound: usize| {
        // SplitMix64 (Steele, Lea and Flood 2014).
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    };
    let base = [pack(TRIANGLE), pack(b"\n"), vec![0; 4]].concat();
    for case in 0..5_000 {
        let mut bytes = base.clone();
        for _ in 0..=random(3) {
            let at = random(bytes.len());
            if bytes.is_empty() {
                break;
            }
            match random(4) {
                0 => bytes[at] ^= 1 << random(8),
                1 => bytes[at] = random(256) as u8,
                2 => drop(bytes.drain(at..(at + random(9)).min(bytes.len()))),
                _ => bytes.truncate(at.max(1)),
            }
        }
        if let Err(error) = read(&bytes, None) {
            let message = error.to_string();
            assert!(message.len() < 300 && !message.contains(char::is_control), "case {case}: {message}");
        }
    }
}
