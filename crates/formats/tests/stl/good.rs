//! What can be read.

use crate::{A, B, C, Corners, D, TETRAHEDRON, TETRAHEDRON_FACETS, binary, binary_with, objects, shown};
use exact::Rational;
use splitstar_formats::{Format, Place, PlaceList, ReadNote, read};

#[test]
fn equal_corners_of_binary_files_are_one_vertex() {
    let bytes = binary(&TETRAHEDRON);
    let model = read(&bytes, None).unwrap();
    assert_eq!(model.format, Format::Stl);
    let (points, facets) = shown(&model);
    let tenth = "13421773/134217728";
    assert_eq!(points[..3], ["0 0 0".to_string(), format!("0 {tenth} 0"), "3/2 0 0".to_string()]);
    assert_eq!(points[3], "0 0 -1000000015047466219876688855040");
    assert_eq!(facets, TETRAHEDRON_FACETS);
    assert_eq!((model.notes.as_slice(), objects(&model).as_slice()), ([].as_slice(), [].as_slice()));
    // Where each is mentioned first.
    assert_eq!(model.places.vertices, PlaceList::Bytes(vec![96, 108, 120, 170]));
    assert_eq!(model.places.facets.get(3), Some(Place::Byte(234)));
    assert_eq!(model.places.facets.get(4), None);
}

#[test]
fn zero_has_no_sign_and_small_floats_are_themselves() {
    let tiny = f32::from_bits(1);
    let triangles =
        [[[0.0, -0.0, 0.0], [1.0, 0.0, 0.0], [0.0, tiny, 0.0]], [[-0.0, 0.0, -0.0], [0.0, -tiny, 0.0], B]];
    let model = read(&binary(&triangles), None).unwrap();
    let (points, facets) = shown(&model);
    assert_eq!(facets, [[0, 1, 2], [0, 3, 4]]);
    let exact = |float: f32| Rational::try_from(f64::from(float)).unwrap().to_string();
    assert_eq!(points[2], format!("0 {} 0", exact(tiny)));
    assert_eq!(points[3], format!("0 {} 0", exact(-tiny)));
}

#[test]
fn a_binary_file_is_known_by_its_length_whatever_its_header() {
    let headers: [&[u8]; 9] = [
        b"",
        b"solid",
        b"solid made by a binary exporter",
        b"solid x\nfacette",
        b"solid\0",
        b"\0",
        b"OFF",
        b"v 0 0 0",
        b"COLOR=\xFF\xFF\xFF\xFF",
    ];
    for header in headers {
        for name in [None, Some("mesh.stl"), Some("mesh.off")] {
            let bytes = binary_with(header, 4, &TETRAHEDRON);
            let model = read(&bytes, name).unwrap_or_else(|error| panic!("{header:?}: {error}"));
            assert_eq!(model.format, Format::Stl, "{header:?}");
            assert_eq!(shown(&model).1, TETRAHEDRON_FACETS, "{header:?}");
        }
    }
}

#[test]
fn facets_with_equal_corners_are_left_out_with_a_note() {
    let [first, second, third, fourth] = TETRAHEDRON;
    let rows: [(&[Corners], usize, &[u64]); 4] = [
        (&[first, [A, A, B], second, third, fourth], 1, &[84, 184, 234, 284]),
        (&[[A, C, A], first, second, third, [D, C, C], fourth], 2, &[134, 184, 234, 334]),
        (&[first, second, third, fourth, [B, B, B]], 1, &[84, 134, 184, 234]),
        (&[first, second, third, fourth], 0, &[84, 134, 184, 234]),
    ];
    for (triangles, dropped, places) in rows {
        let model = read(&binary(triangles), None).unwrap();
        assert_eq!(model.model.shape.mesh().unwrap().facets.len(), 4);
        let expected = (dropped > 0).then_some(ReadNote::DegenerateDropped { facets: dropped });
        assert_eq!(model.notes, Vec::from_iter(expected));
        let found: Vec<_> = (0..5).map_while(|facet| model.places.facets.get(facet)).collect();
        assert_eq!(found, places.iter().map(|&byte| Place::Byte(byte)).collect::<Vec<_>>());
    }
    let note = |facets| ReadNote::DegenerateDropped { facets }.to_string();
    assert_eq!(note(1), "1 facet has two corners at the same position: left out");
    assert_eq!(note(2), "2 facets have two corners at the same position: left out");
}

pub(crate) struct Good {
    name: &'static str,
    pub(crate) text: &'static str,
    points: &'static [&'static str],
    facets: &'static [[u32; 3]],
    objects: &'static [(&'static str, u32)],
}

const POINTS: &[&str] = &["0 0 0", "1/10 0 0", "0 1/3 -2000"];
const ONE: &[[u32; 3]] = &[[0, 1, 2]];

const fn good(name: &'static str, text: &'static str, objects: &'static [(&'static str, u32)]) -> Good {
    Good { name, text, points: POINTS, facets: ONE, objects }
}

pub(crate) const GOOD: &[Good] = &[
    good(
        "as everybody writes it",
        "solid part\n  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 0.1 0 0\n      \
         vertex 0 1/3 -2e3\n    endloop\n  endfacet\nendsolid part\n",
        &[("part", 0)],
    ),
    good(
        "no name, no line break at the end",
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\nvertex 0 1/3 -2e3\nendloop\n\
         endfacet\nendsolid",
        &[],
    ),
    good(
        "any case",
        "solid Part\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVertex 1E-1 0 0\nvertex 0 1/3 -2E+3\nEndLoop\n\
         ENDFACET\nENDSOLID Part\n",
        &[("Part", 0)],
    ),
    good(
        "a name with blanks, that looks like something else",
        "solid  facet normal #1 of 2\t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\n\
         vertex 0 1/3 -2e3\nendloop\nendfacet\nendsolid facet normal #1\n",
        &[("facet normal #1 of 2", 0)],
    ),
    good(
        "CR LF, tabs, a byte order mark",
        "\u{feff}solid\tx\r\n\tfacet\tnormal 0 0 1\r\n\r\nouter loop\r\nvertex 0 0 0\r\nvertex 0.10 0 0\r\n\
         vertex 0 1/3 -2e3\r\nendloop\r\nendfacet\r\nendsolid x\r\n\r\n",
        &[("x", 0)],
    ),
    good(
        "CR, few lines",
        "solid x\rfacet normal 0 0 1 outer loop vertex 0 0 0 vertex .1 -0 0 vertex 0 1/3 -2000 endloop endfacet endsolid\r",
        &[("x", 0)],
    ),
    good(
        "normals that are no numbers",
        "solid x\nfacet normal nan -nan(ind) 1.#QNAN\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\nvertex 0 1/3 -2e3\n\
         endloop\nendfacet\nendsolid x\n",
        &[("x", 0)],
    ),
    Good {
        name: "several solids, one of them empty, one without a name",
        text: "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\nvertex 0 1/3 -2e3\nendloop\n\
               endfacet\nendsolid a\nsolid\nendsolid\n\nsolid \u{e9} 2\nfacet normal 0 0 0\nouter loop\n\
               vertex 0 1/3 -2000\nvertex 1e-1 0 0\nvertex 0.0 0 -0\nendloop\nendfacet\nendsolid a\n",
        points: POINTS,
        facets: &[[0, 1, 2], [2, 1, 0]],
        objects: &[("a", 0), ("", 1), ("\u{e9} 2", 1)],
    },
    Good {
        name: "long numbers",
        text: "solid\nfacet normal 0 0 0\nouter loop\nvertex 1e40 0 0\nvertex 0 0.1234567890123456789012345 0\n\
               vertex 0 0 1e-30\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\n\
               vertex 0 0.12345678901234567890123450 0\nvertex 10e39 0 0\nvertex 7 0 0\nendloop\nendfacet\nendsolid",
        points: &[
            "10000000000000000000000000000000000000000 0 0",
            "0 246913578024691357802469/2000000000000000000000000 0",
            "0 0 1/1000000000000000000000000000000",
            "7 0 0",
        ],
        facets: &[[0, 1, 2], [1, 0, 3]],
        objects: &[],
    },
];

#[test]
fn every_good_text_gives_its_mesh() {
    for row in GOOD {
        for name in [None, Some("x.STL")] {
            let model =
                read(row.text.as_bytes(), name).unwrap_or_else(|error| panic!("{}: {error}", row.name));
            assert_eq!(model.format, Format::StlAscii, "{}", row.name);
            assert_eq!(shown(&model).0, row.points, "{}", row.name);
            assert_eq!(shown(&model).1, row.facets, "{}", row.name);
            assert_eq!(objects(&model), row.objects, "{}", row.name);
            assert_eq!(model.notes, [], "{}", row.name);
        }
    }
    let upper = GOOD[0].text.replacen("solid", "SOLID", 1);
    assert_eq!(shown(&read(upper.as_bytes(), Some("x.stl")).unwrap()).1, ONE);
}

#[test]
fn a_text_knows_its_lines_and_what_it_leaves_out() {
    let text = "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0.5 0 0\nvertex 0 0 0.0\nendloop\n\
                endfacet\nfacet normal 0 0 0\nouter loop\nvertex 5e-1 0 0\nvertex 0 0 0\n\nvertex 0 7 0\nendloop\n\
                endfacet\nendsolid\n";
    let model = read(text.as_bytes(), None).unwrap();
    assert_eq!(shown(&model).1, [[1, 0, 2]]);
    assert_eq!(model.notes, [ReadNote::DegenerateDropped { facets: 1 }]);
    assert_eq!(model.places.vertices, PlaceList::Lines(vec![4, 5, 14]));
    assert_eq!(model.places.facets, PlaceList::Lines(vec![9]));
}
