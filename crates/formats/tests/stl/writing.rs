//! What is written, and read again.

use crate::good::GOOD;
use crate::{TETRAHEDRON, binary, floats, objects, shown};
use exact::{Point3, Rational};
use polytope::{Facets, PolygonMesh};
use splitstar_formats::{Format, Model, Object, WriteError, WriteNote, WriteOptions, read, write};

fn model_of(points: &[[&str; 3]], facets: &[[u32; 3]]) -> Model {
    let number = |text: &str| text.parse::<Rational>().unwrap();
    let points = points.iter().map(|point| Point3::from_rationals(&point.map(number))).collect();
    let mut cycles = Facets::new();
    facets.iter().for_each(|facet| cycles.push(facet));
    Model::of_mesh(PolygonMesh { points, facets: cycles })
}

#[test]
fn a_binary_file_is_written_with_normals() {
    let points = [["0", "0", "0"], ["2", "0", "0"], ["0", "1/4", "0"], ["4", "0", "0"], ["3", "3", "3"]];
    let model = model_of(&points, &[[0, 1, 2], [2, 1, 0], [0, 1, 3]]);
    let written = write(&model, &WriteOptions::new(Format::Stl)).unwrap();
    assert_eq!(written.bytes.len(), 84 + 3 * 50);
    assert!(written.bytes.starts_with(b"binary STL by splitstar\0"));
    assert_eq!(written.bytes[80..84], [3, 0, 0, 0]);
    assert_eq!(written.bytes[132..134], [0, 0]);
    assert_eq!(floats(&written.bytes, 0), [0., 0., 1., 0., 0., 0., 2., 0., 0., 0., 0.25, 0.]);
    assert_eq!(floats(&written.bytes, 1), [0., 0., -1., 0., 0.25, 0., 2., 0., 0., 0., 0., 0.]);
    // There is no normal where the corners are on a line.
    assert_eq!(floats(&written.bytes, 2)[..3], [0.; 3]);
    assert_eq!(written.largest_rounding, Rational::from(0));
    assert_eq!(read(&written.bytes, None).unwrap().model.shape.mesh().unwrap().points.len(), 4);
}

#[test]
fn a_binary_file_rounds_once_and_says_how_much() {
    let points = [["1/3", "0", "0"], ["0", "16777217.0000000000000000000001", "0"], ["0", "0", "1e-50"]];
    let written = write(&model_of(&points, &[[0, 1, 2]]), &WriteOptions::new(Format::Stl)).unwrap();
    let all = floats(&written.bytes, 0);
    assert_eq!(all[3..], [1.0 / 3.0, 0., 0., 0., 16_777_218.0, 0., 0., 0., 0.]);
    assert_eq!(written.largest_rounding, "0.9999999999999999999999".parse().unwrap());
    let huge = |text| model_of(&[["0", "0", "0"], ["0", text, "0"], ["0", "0", "1"]], &[[0, 1, 2]]);
    let error = write(&huge("-1e39"), &WriteOptions::new(Format::Stl)).unwrap_err();
    assert_eq!(error, WriteError::TooLargeForFloat { vertex: 1 });
    let text = write(&huge("-1e39"), &WriteOptions::new(Format::StlAscii)).unwrap();
    assert_eq!(text.largest_rounding, Rational::from(0));
    // A third has no decimal.
    let error = write(&huge("1e400"), &WriteOptions::new(Format::StlAscii)).unwrap_err();
    assert_eq!(error, WriteError::TooLargeForFloat { vertex: 1 });
}

#[test]
fn corners_that_rounding_makes_one_are_told() {
    let near = [["1", "0", "0"], ["1.0000000001", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]];
    let model = model_of(&near, &[[0, 1, 2], [0, 2, 3], [3, 1, 0]]);
    for format in [Format::Stl, Format::Glb] {
        let written = write(&model, &WriteOptions::new(format)).unwrap();
        assert_eq!(written.notes, [WriteNote::Collapsed(2)]);
    }
    let text = WriteNote::Collapsed(2).to_string();
    assert_eq!(text, "2 facets have two corners at the same position once rounded");
    assert!(write(&model, &WriteOptions::new(Format::StlAscii)).unwrap().notes.is_empty());
}

#[test]
fn a_text_is_written_as_one_solid() {
    let points = [["0", "0", "0"], ["0.1", "0", "0"], ["0", "1/3", "0"], ["0", "0", "1e20"]];
    let mut model = model_of(&points, &[[0, 1, 2], [0, 2, 3], [3, 2, 1]]);
    let object = |name: &str, first_facet| Object { name: name.into(), first_facet };
    model.objects = vec![object(" upper\n\tpart ", 1), object("", 2), object("empty", 3)];
    let written = write(&model, &WriteOptions::new(Format::StlAscii)).unwrap();
    let text = String::from_utf8(written.bytes).unwrap();
    assert_eq!(written.notes, [WriteNote::NoObjects(3)]);
    let expected = "solid\n\
        facet normal 0 0 1\n  outer loop\n    vertex 0 0 0\n    vertex 0.1 0 0\n    vertex 0 0.3333333333333333 0\n  \
        endloop\nendfacet\nfacet normal 1 0 0\n";
    assert_eq!(text[..expected.len()], *expected);
    assert!(text.ends_with("endfacet\nendsolid\n"));
    assert_eq!(written.largest_rounding.to_string(), "1/30000000000000000");
    let again = read(text.as_bytes(), None).unwrap();
    assert_eq!(objects(&again), []);
    assert_eq!(shown(&again).1, [[0, 1, 2], [0, 2, 3], [3, 2, 1]]);
    // The name of a single object is kept, as far as a line can have it.
    model.objects = vec![object(" upper\n\tpart ", 0)];
    let written = write(&model, &WriteOptions::new(Format::StlAscii)).unwrap();
    assert!(written.bytes.starts_with(b"solid upper  part\n"));
    assert_eq!(written.notes, [WriteNote::NamesChanged(1)]);
    assert_eq!(objects(&read(&written.bytes, None).unwrap()), [("upper  part", 0)]);
}

#[test]
fn what_is_read_is_written_and_read_again() {
    let mut files: Vec<Vec<u8>> = GOOD.iter().map(|row| row.text.as_bytes().to_vec()).collect();
    files.push(binary(&TETRAHEDRON));
    for bytes in files {
        let first = read(&bytes, None).unwrap();
        for format in [Format::Stl, Format::StlAscii] {
            let Ok(written) = write(&first.model, &WriteOptions::new(format)) else {
                continue;
            };
            let again = read(&written.bytes, None).unwrap();
            assert_eq!(again.format, format);
            if written.largest_rounding.is_zero() {
                assert_eq!(shown(&again), shown(&first));
            }
            if format == Format::StlAscii && first.model.objects.len() < 2 {
                assert_eq!(objects(&again), objects(&first));
            }
            let third = write(&again.model, &WriteOptions::new(format)).unwrap();
            assert_eq!(third.bytes, written.bytes);
        }
    }
    // Polygons are cut, and points have no place.
    let square = read(b"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", None).unwrap().model;
    let written = write(&square, &WriteOptions::new(Format::Stl)).unwrap();
    assert_eq!(written.notes, [WriteNote::Triangulated { from: 1, to: 2 }]);
    let points = read(b"OFF\n1 0 0\n1 2 3\n", None).unwrap().model;
    let error = write(&points, &WriteOptions::new(Format::StlAscii)).unwrap_err();
    assert_eq!(error, WriteError::NoFacets { format: Format::StlAscii });
}
