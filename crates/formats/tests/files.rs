//! The model files of the repository: what the broken ones say, and that the others come back.

// A test fails by panicking, in its helpers too.
#![allow(clippy::unwrap_used)]

use polytope::PolygonMesh;
use splitstar_formats::{Format, Kind, Model, ReadError, WriteError, WriteOptions, read, write};
use std::path::{Path, PathBuf};

/// By the name of the files, so that the messages are those of the OFF reader.
fn read_off(bytes: &[u8]) -> Result<PolygonMesh, ReadError> {
    Ok(read(bytes, Some("off"))?.model.shape.into_mesh().expect("an OFF file has a mesh"))
}

/// The file, and the largest rounding.
fn write_off(mesh: &PolygonMesh, float: bool) -> Result<(Vec<u8>, exact::Rational), WriteError> {
    let mut options = WriteOptions::new(Format::Off);
    options.float = float;
    let written = write(&Model::of_mesh(mesh.clone()), &options)?;
    Ok((written.bytes, written.largest_rounding))
}

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models")
}

fn collect(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("the folder of models is there") {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, into);
        } else if path.extension().is_some_and(|extension| extension == "off" || extension == "xoff") {
            into.push(path);
        }
    }
}

#[test]
fn exact_files_come_back_the_same() {
    let mut paths = Vec::new();
    collect(&models(), &mut paths);
    let mut compared = 0;
    for path in paths {
        let bytes = std::fs::read(&path).unwrap();
        let Ok(read) = read_off(&bytes) else {
            assert!(path.components().any(|part| part.as_os_str() == "invalid"), "{}", path.display());
            continue;
        };
        let (text, rounding) = write_off(&read, false).unwrap();
        let again = read_off(&text).unwrap();
        assert_eq!(again.points, read.points, "{}", path.display());
        assert_eq!(again.facets, read.facets, "{}", path.display());
        assert_eq!(rounding.to_string(), "0");
        assert_eq!(write_off(&again, false).unwrap().0, text, "{}", path.display());
        compared += 1;
    }
    assert!(compared >= 40, "only {compared} models were found");
}

/// File of `models/invalid`, and the message.
const BROKEN: &[(&str, &str)] = &[
    ("coordinate_nan.off", "line 3: `nan` is not finite; write a finite number"),
    ("coordinate_inf.off", "line 3: `inf` is not finite; write a finite number"),
    ("coordinate_word.off", "line 3: `zero` is no number; write an integer, a decimal or a fraction p/q"),
    ("zero_denominator.xoff", "line 3: `1/0` has the denominator zero; write a fraction p/q with q not zero"),
    (
        "exponent_bomb.off",
        "line 3: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "two_vertex_facet.off",
        "line 17: a facet of two vertices beside polygons; remove it, or give it a third vertex",
    ),
    (
        "repeated_index.off",
        "line 16: the facet has vertex 0 twice in a row; name every vertex of a facet once",
    ),
    ("index_out_of_range.off", "line 16: vertex index 8, but there are 8 vertices; indices run from 0 to 7"),
    ("negative_index.off", "line 16: vertex index -1, but there are 8 vertices; indices run from 0 to 7"),
    (
        "truncated.off",
        "line 12: the file ends where a facet was expected, after 2 of 6 facets; \
         complete it",
    ),
    (
        "truncated_header.off",
        "line 2: the file ends where the numbers of vertices, facets and edges were expected; \
         complete it",
    ),
    (
        "wrong_counts.off",
        "line 16: the file ends where a facet was expected, after 6 of 9 facets; \
         complete it",
    ),
    (
        "huge_counts.off",
        "line 16: the file ends where a vertex was expected, after 14 of 4000000000 vertices; \
         complete it",
    ),
    (
        "no_header.off",
        "line 1: no known format: the file begins with `8`; OFF, OBJ, STL, PLY, 3MF, VRML and star can be read",
    ),
    ("empty.off", "the file is empty; a model was expected"),
    ("zero_everything.off", "line 2: the mesh is empty: it has no vertex; at least one is needed"),
];

/// Files of `models/invalid` that are correct files: what is wrong is the mesh.
const WELL_FORMED: &[&str] = &[
    "duplicate_vertex_unused.off",
    "facet_soup.off",
    "flat.off",
    "flipped_facet.off",
    "huge_exponent.off",
    "inside_out.off",
    "non_manifold_edge.off",
    "non_manifold_vertex.off",
    "non_planar_quad.off",
    "open_mesh.off",
    "overlapping_shells.off",
    "self_intersecting.off",
    "zero_area_facet.off",
    "zero_facets.off",
];

#[test]
fn broken_files_say_what_is_wrong() {
    let folder = models().join("invalid");
    let mut paths = Vec::new();
    collect(&folder, &mut paths);
    assert!(!paths.is_empty());
    for path in paths {
        let name = path.file_name().unwrap().to_str().unwrap();
        let result = read_off(&std::fs::read(&path).unwrap());
        if name == "binary_garbage.off" {
            let message = result.unwrap_err().to_string();
            assert!(message.starts_with("line 1: no known format: the file begins with `"), "{message}");
            assert!(message.is_ascii(), "{message}");
        } else if name == "binary_after_header.off" {
            let message = result.unwrap_err().to_string();
            assert!(message.starts_with("line 3: `"), "{message}");
            assert!(message.is_ascii(), "{message}");
        } else if let Some((_, message)) = BROKEN.iter().find(|row| row.0 == name) {
            assert_eq!(result.unwrap_err().to_string(), *message, "{name}");
        } else {
            assert!(WELL_FORMED.contains(&name), "{name} has no row");
            let read = result.unwrap_or_else(|error| panic!("{name}: {error}"));
            let points = if name == "zero_facets.off" { Kind::Points } else { Kind::Surface };
            assert_eq!(Kind::of(&read), points, "{name}");
        }
    }
}

fn floats(text: &[u8]) -> Result<(String, String), WriteError> {
    let read = read_off(text).unwrap();
    let (written, rounding) = write_off(&read, true)?;
    Ok((String::from_utf8(written).unwrap(), rounding.to_string()))
}

#[test]
fn floats_are_the_nearest_and_shortest() {
    // Coordinates, as written, and the exact rounding.
    let rows = [
        ("0 -0 1", "0 0 1", "0"),
        ("1/2 -3/4 10", "0.5 -0.75 10", "0"),
        ("1/3 0 0", "0.3333333333333333 0 0", "1/30000000000000000"),
        ("0.1 0 0", "0.1 0 0", "0"),
        // Halfway between two doubles: the even one.
        ("9007199254740993 0 0", "9007199254740992 0 0", "1"),
        ("9007199254740995 0 0", "9007199254740996 0 0", "1"),
        ("1e16 1e-5 1e-6", "1e16 0.00001 1e-6", "0"),
        ("1e16 1e-5 1/3000000", "1e16 0.00001 3.3333333333333335e-7", "1/60000000000000000000000"),
        ("1e308 0 5e-324", "1e308 0 5e-324", ""),
        ("1e-400 -1e-400 0", "0 0 0", ""),
        ("1.7976931348623157e308 0 0", "1.7976931348623157e308 0 0", ""),
    ];
    for (exact, float, rounding) in rows {
        let (text, largest) = floats(format!("OFF\n1 0 0\n{exact}\n").as_bytes()).unwrap();
        assert_eq!(text, format!("OFF\n1 0 0\n{float}\n"));
        // The last rows have hundreds of digits; that they read back is what the next test checks.
        assert!(rounding.is_empty() || rounding == largest, "{exact}: {largest}");
    }
    let beyond = floats(b"OFF\n2 0 0\n0 0 0\n1.8e308 0 0\n").unwrap_err();
    assert_eq!(beyond, WriteError::TooLargeForFloat { vertex: 1 });
}

#[test]
fn floats_read_back_as_the_nearest_double() {
    let path = models().join("convex/odp.xoff");
    let read = read_off(&std::fs::read(path).unwrap()).unwrap();
    let (text, rounding) = write_off(&read, true).unwrap();
    let text = String::from_utf8(text).unwrap();
    let mut largest = exact::Rational::from(0);
    for (line, point) in text.lines().skip(2).zip(&read.points) {
        for (word, coordinate) in line.split(' ').zip(point.coordinates()) {
            let float: f64 = word.parse().unwrap();
            let back = exact::Rational::try_from(float).unwrap();
            assert!(back.approx_f64().to_bits() == coordinate.approx_f64().to_bits(), "{word}");
            let decimal: exact::Rational = word.parse().unwrap();
            largest = largest.max((&decimal - &coordinate).abs());
        }
    }
    assert!(!largest.is_zero());
    assert_eq!(largest, rounding);
}

#[test]
fn edges_are_counted() {
    let counts = |name: &str| {
        let read = read_off(&std::fs::read(models().join(name)).unwrap()).unwrap();
        let text = write_off(&read, false).unwrap().0;
        String::from_utf8(text).unwrap().lines().nth(1).unwrap().to_string()
    };
    assert_eq!(counts("convex/cube.off"), "8 6 12");
    assert_eq!(counts("invalid/open_mesh.off"), "8 5 12");
    assert_eq!(counts("invalid/zero_facets.off"), "8 0 0");
    assert_eq!(counts("convex/dp.off"), "17 17 32");
}
