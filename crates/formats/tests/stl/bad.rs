//! What cannot be read, and why.

use crate::{TETRAHEDRON, binary, binary_with};
use splitstar_formats::{Format, check_start, read};

/// A text with other lines in the place of the second and the third vertex.
fn text_with(lines: &str) -> Vec<u8> {
    format!("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n{lines}\nendloop\nendfacet\nendsolid x\n")
        .into_bytes()
}

#[test]
fn every_bad_text_gives_its_error() {
    let empty = "the mesh is empty: it has no vertex; at least one is needed";
    let facet =
        |end: &str| format!("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n{end}").into_bytes();
    let rows: Vec<(Vec<u8>, &str)> = vec![
        (b"solid x\nendsolid x\n".to_vec(), empty),
        (b"solid".to_vec(), "line 1: the file ends where `facet` or `endsolid` was expected; complete it"),
        (b"solid x\n".to_vec(), "line 1: the file ends where `facet` or `endsolid` was expected; complete it"),
        (b"solid x\nvertex 0 0 0\n".to_vec(), "line 2: `vertex` where `facet` or `endsolid` was expected; correct it"),
        (b"solid x\nendsolid\nfacet".to_vec(), "line 3: `facet` where `solid`, or the end of the file, was expected; correct it"),
        (b"solid x\nfacet 0 0 1\n".to_vec(), "line 2: `0` where `normal` was expected; correct it"),
        (b"solid x\nfacet normal 0 0\nouter loop\n".to_vec(), "line 3: `outer` where a normal of three numbers was expected; correct it"),
        (b"solid x\nfacet normal 0 0 1\nvertex 0 0 0\n".to_vec(), "line 3: `vertex` where `outer loop` was expected; correct it"),
        (b"solid x\nfacet normal 0 0 1\nouter\nvertex 0 0 0\n".to_vec(), "line 4: `vertex` where `outer loop` was expected; correct it"),
        (facet(""), "line 4: the file ends where the second `vertex` was expected; complete it"),
        (facet("vertex 1 0"), "line 5: the file ends where a coordinate was expected; complete it"),
        (facet("endloop\nendfacet\nendsolid\n"), "line 5: `endloop` where the second `vertex` was expected; correct it"),
        (text_with("vertex 1 0 0"), "line 6: `endloop` where the third `vertex` was expected; correct it"),
        (text_with("vertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1"), "line 7: `vertex` where `endloop` behind three vertices was expected; correct it"),
        (text_with("vertex 1 0 0\nvertex 0 1 0 0"), "line 6: `0` where `endloop` behind three vertices was expected; correct it"),
        (text_with("vertex 1 0\nvertex 0 1 0"), "line 6: `vertex` is no number; write an integer, a decimal or a fraction p/q"),
        (text_with("vertex 1 0 0\nvertex 0 nan 0"), "line 6: `nan` is not finite; write a finite number"),
        (text_with("vertex 1 0 -inf\nvertex 0 0 0"), "line 5: `-inf` is not finite; write a finite number"),
        (text_with("vertex 1 1,5 0\nvertex 0 0 0"), "line 5: `1,5` is no number; write an integer, a decimal or a fraction p/q"),
        (text_with("vertex 1/0 0 0\nvertex 0 0 0"), "line 5: `1/0` has the denominator zero; write a fraction p/q with q not zero"),
        (text_with("vertex 1e999999999 0 0\nvertex 0 0 0"), "line 5: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400"),
        (b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nfacet".to_vec(), "line 8: `facet` where `endfacet` was expected; correct it"),
        (b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\n".to_vec(), "line 9: the file ends where `facet` or `endsolid` was expected; complete it"),
    ];
    for (bytes, message) in rows {
        let error = read(&bytes, None).unwrap_err();
        assert_eq!(error.to_string(), message, "{}", String::from_utf8_lossy(&bytes));
        assert_eq!(error.format, Some(Format::StlAscii));
    }
}

#[test]
fn every_bad_binary_file_gives_its_error() {
    let whole = binary(&TETRAHEDRON);
    let solid = binary_with(b"solid \0", 4, &TETRAHEDRON);
    let with = |at: usize, float: f32| {
        let mut bytes = whole.clone();
        bytes[at..at + 4].copy_from_slice(&float.to_le_bytes());
        bytes
    };
    let longer = |tail: &[u8]| [&whole, tail].concat();
    let rows: Vec<(Vec<u8>, &str)> = vec![
        (binary(&[]), "byte 80: the mesh is empty: it has no vertex; at least one is needed"),
        (
            binary_with(b"solid", 0, &[]),
            "byte 80: the mesh is empty: it has no vertex; at least one is needed",
        ),
        (
            whole[..233].to_vec(),
            "byte 233: the file ends where a facet was expected, after 2 of the 4 that the header promises; complete it",
        ),
        (
            solid[..283].to_vec(),
            "byte 283: the file ends where a facet was expected, after 3 of the 4 that the header promises; complete it",
        ),
        (
            whole[..84].to_vec(),
            "byte 84: the file ends where a facet was expected, after 0 of the 4 that the header promises; complete it",
        ),
        (
            whole[..83].to_vec(),
            "byte 83: the file ends where the header of binary STL was expected: 80 bytes, and the number of facets; complete it",
        ),
        (
            b"solid\0".to_vec(),
            "byte 6: the file ends where the header of binary STL was expected: 80 bytes, and the number of facets; complete it",
        ),
        (
            binary_with(b"x\0", u32::MAX, &[]),
            "byte 84: the file ends where a facet was expected, after 0 of the 4294967295 that the header promises; complete it",
        ),
        (
            binary_with(b"x\0", 5, &TETRAHEDRON),
            "byte 284: the file ends where a facet was expected, after 4 of the 5 that the header promises; complete it",
        ),
        (
            longer(b"\n"),
            "byte 284: `\\n` after the end of the mesh, whose header promises 4 facets; remove it",
        ),
        (
            longer(&[0; 50]),
            "byte 284: `\\0\\0\\0\\0\\0\\0\\0\\0` after the end of the mesh, whose header promises 4 facets; remove it",
        ),
        (
            binary_with(b"x\0", 1, &TETRAHEDRON[..2]),
            "byte 134: `\\xff\\xff\\xff\\xff\\xff\\xff\\xff\\xff` after the end of the mesh, whose header promises 1 facet; remove it",
        ),
        (with(96, f32::NAN), "byte 96: `NaN` is not finite; write a finite number"),
        (with(150, f32::INFINITY), "byte 150: `inf` is not finite; write a finite number"),
        (with(278, f32::NEG_INFINITY), "byte 278: `-inf` is not finite; write a finite number"),
        (Vec::new(), "the file is empty; a model was expected"),
        (b" \n\n".to_vec(), "the file is empty; a model was expected"),
        (
            b"hello world".to_vec(),
            "line 1: `hello` where `solid`, or the header of binary STL, was expected; correct it",
        ),
        (
            [b"\n\nfacet normal".as_slice(), &[b' '; 500]].concat(),
            "line 3: `facet` where `solid`, or the header of binary STL, was expected; correct it",
        ),
        (
            vec![0; 7],
            "byte 7: the file ends where the header of binary STL was expected: 80 bytes, and the number of facets; complete it",
        ),
        (
            [0x81, 0, 0xFE].repeat(30),
            "byte 90: the file ends where a facet was expected, after 0 of the 4261446142 that the header promises; complete it",
        ),
    ];
    for (bytes, message) in rows {
        let error = read(&bytes, Some("x.stl")).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

/// The length that the header promises may be half or twice the length of the file, but not less or more.
#[test]
fn without_a_name_a_broken_binary_file_is_told_by_its_length() {
    let four = |count: u32| binary_with(b"made by a test\0", count, &TETRAHEDRON);
    let short = |count: u32| {
        format!(
            "byte 284: the file ends where a facet was expected, after 4 of the {count} that the header promises; complete it"
        )
    };
    let long = "byte 184: `\\xff\\xff\\xff\\xff\\xff\\xff\\xff\\xff` after the end of the mesh, whose header promises 2 \
                facets; remove it";
    let unknown = "line 1: no known format: the file begins with `made`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read";
    let mut nan = four(4);
    nan[96..100].copy_from_slice(&f32::NAN.to_le_bytes());
    let rows = [
        (four(5), short(5)),
        (four(9), short(9)),
        (four(10), unknown.into()),
        (four(u32::MAX), unknown.into()),
        (four(2), long.into()),
        (four(1), unknown.into()),
        (four(0), unknown.into()),
        (nan, "byte 96: `NaN` is not finite; write a finite number".into()),
        (binary_with(b"made by a test", 5, &[]), unknown.into()),
    ];
    for (bytes, message) in rows {
        assert_eq!(read(&bytes, None).unwrap_err().to_string(), message);
        let is_known = message != unknown;
        // One with an end that has not come yet may be anything.
        if is_known {
            assert_eq!(check_start(&bytes, None), Ok(()), "{message}");
        }
    }
}

/// The first word of a header is no word of another format, if the file is cut short and its name is known.
#[test]
fn a_header_that_begins_as_another_format_does_not_decide() {
    for header in
        ["o my object", "v", "s", "f 1 2 3", "g", "mtllib x", "OFF", "star 1", "#VRML V2.0 utf8", "<", "{"]
    {
        let header = format!("{header}\0");
        let whole = binary_with(header.as_bytes(), 4, &TETRAHEDRON);
        assert_eq!(read(&whole, None).unwrap().format, Format::Stl, "{header}");
        let cut = &whole[..233];
        let message = "byte 233: the file ends where a facet was expected, after 2 of the 4 that the header promises; \
                       complete it";
        for name in [Some("x.stl"), None] {
            let error = read(cut, name).unwrap_err();
            assert_eq!(error.to_string(), message, "{header} {name:?}");
            assert_eq!(check_start(cut, name), Ok(()));
        }
    }
}

#[test]
fn a_stream_may_be_binary_if_it_promises_more_and_is_no_text() {
    let start = |count: u32, padding: u8| {
        let mut bytes = vec![padding; 80];
        bytes.extend(count.to_le_bytes());
        bytes
    };
    let triangles = |bytes: Vec<u8>| [bytes, binary(&TETRAHEDRON)[84..].repeat(300)].concat();
    assert_eq!(check_start(&triangles(start(1201, 0)), None), Ok(()));
    assert_eq!(check_start(&triangles(start(1200, b'x')), None), Ok(()));
    let mut nan = triangles(start(9000, 0));
    for facet in nan[84..].chunks_mut(50) {
        facet[12..16].copy_from_slice(&f32::NAN.to_le_bytes());
        facet[48..].fill(0);
    }
    assert_eq!(check_start(&nan, None), Ok(()));
    // Far fewer than there are, none, a text, and noise.
    let noise = |at: u32| (at.wrapping_mul(0x9E37_79B9) >> 13) as u8;
    let noise = [vec![0; 84], (0..60_000).map(noise).collect()].concat();
    let mut noise_with_count = noise.clone();
    noise_with_count[80..84].copy_from_slice(&[0xFF; 4]);
    for bytes in [triangles(start(599, 0)), vec![0; 65_536], b"y\n".repeat(32_768), noise, noise_with_count] {
        assert!(check_start(&bytes, None).is_err());
        assert_eq!(check_start(&bytes, Some("x.stl")), Ok(()));
    }
}
