//! What mesh formats refuse, and the regular part.

use crate::{CUBE, examples, read, records};
use polytope::HoleError;
use splitstar_formats::{Format, Loss, Shape, WriteError, WriteNote, WriteOptions};

/// A tetrahedron far away, from vertex 20 on, around a volume.
fn tetrahedron(at: i32, volumes: [u32; 2]) -> String {
    let [front, behind] = volumes;
    let [a, b, c, d] = [at, at + 1, at + 2, at + 3];
    let vertices = [(a, 0, 0, 0), (b, 1, 0, 0), (c, 0, 1, 0), (d, 0, 0, 1)];
    let mut text = String::new();
    for (id, x, y, z) in vertices {
        text += &format!("vertex {id} {} {y} {z}\n", x + at);
    }
    for [p, q, r] in [[a, c, b], [a, b, d], [b, c, d], [c, a, d]] {
        text += &format!("facet {p} {q} {r} sides {front} {behind}\n");
    }
    text
}

fn off(text: &str, lossy: bool) -> Result<(String, Vec<WriteNote>), WriteError> {
    let mut options = WriteOptions::new(Format::Off);
    options.lossy = lossy;
    let written = splitstar_formats::write(&read(text).model, &options)?;
    Ok((String::from_utf8(written.bytes).unwrap(), written.notes))
}

#[test]
fn losses_are_named_all_and_the_rest_is_written_on_request() {
    let triangle = "vertex 20 9 0 0\nvertex 21 9 1 0\nvertex 22 9 0 1\n";
    let rows: [(&str, &[Loss]); 10] = [
        ("vertex 20 9 9 9\n", &[Loss::Points(1)]),
        ("vertex 20 9 9 9\nedge 6 20\n", &[Loss::Edges(1)]),
        ("vertex 20 9 9 9\nedge 6 20 unmarked\n", &[Loss::Marks(1), Loss::Edges(1)]),
        ("edge 0 1 unmarked\nedge 2 1 unmarked\n", &[Loss::Marks(2)]),
        ("direction 20 1 0 0\nedge 6 20\n", &[Loss::Edges(1), Loss::Unbounded(1)]),
        ("direction 20 1 0 0\n", &[Loss::Unbounded(1)]),
        ("+facet 20 21 22 sides 0 0\n", &[Loss::Sheets(1)]),
        ("+facet 20 21 22 sides 1 1\n", &[Loss::Walls(1)]),
        ("+facet 20 21 22 sides 0 0 unmarked\n", &[Loss::Marks(1), Loss::Sheets(1)]),
        ("+volume 2 unmarked\nfacet 20 21 22 sides 0 2\n", &[Loss::Sheets(1), Loss::Volumes(1)]),
    ];
    let cube = off(&records(CUBE), false).unwrap().0;
    for (more, losses) in rows {
        let more = more.strip_prefix('+').map_or(more.to_string(), |more| format!("{triangle}{more}"));
        let text = records(&format!("{CUBE}{more}"));
        let expected = WriteError::Loses { format: Format::Off, losses: losses.to_vec() };
        assert_eq!(off(&text, false), Err(expected), "{text}");
        let notes: Vec<WriteNote> = losses.iter().copied().map(WriteNote::LeftOut).collect();
        assert_eq!(off(&text, true), Ok((cube.clone(), notes)), "{text}");
    }
}

#[test]
fn the_message_says_the_way_out() {
    let text = records(&format!("{CUBE}vertex 20 9 9 9\nedge 6 20 unmarked\n"));
    assert_eq!(
        off(&text, false).unwrap_err().to_string(),
        "OFF cannot hold 1 mark of its own, and 1 edge of its own; write star, or allow it to be left out"
    );
}

#[test]
fn volumes_are_names_only() {
    // A hollow, and a second body that is not one with the first.
    let hollow = tetrahedron(20, [2, 1]);
    let body = tetrahedron(30, [3, 0]);
    let text = records(&format!("{CUBE}volume 2 unmarked\nvolume 3\n{hollow}{body}"));
    let (off, notes) = off(&text, false).unwrap();
    assert_eq!(notes, [WriteNote::LeftOut(Loss::Volumes(2))]);
    // The body has its volume in front, and is turned round.
    assert!(off.contains("\n3 8 10 9\n") && off.contains("\n3 13 14 12\n"), "{off}");
}

#[test]
fn sets_without_a_bounded_inside_have_no_mesh() {
    let [polygon, cube, plane, half_space, quarter, lines] = examples().try_into().unwrap();
    assert!(off(&polygon, false).is_ok());
    assert!(off(&cube, true).is_ok());
    let inverse = records(&format!("volume 0 marked\nvolume 1 unmarked\n{CUBE}"));
    let rows = [
        (plane, WriteError::NothingLeft),
        (half_space, WriteError::Unbounded),
        (quarter, WriteError::NothingLeft),
        (lines, WriteError::NothingLeft),
        (inverse, WriteError::Unbounded),
        (records("volume 0 marked\n"), WriteError::Unbounded),
        (records(""), WriteError::NothingLeft),
    ];
    for (text, error) in rows {
        assert!(matches!(off(&text, false), Err(WriteError::Loses { .. })), "{text}");
        assert_eq!(off(&text, true), Err(error), "{text}");
    }
    assert_eq!(
        off(&records(""), false).unwrap_err().to_string(),
        "OFF cannot hold the empty set; write star, or allow it to be left out"
    );
}

#[test]
fn objects_move_with_their_facets() {
    let text = records(&format!(
        "{CUBE}object \"sheet\"\nfacet 0 1 2 sides 0 0\nobject \"far\"\n{}",
        tetrahedron(20, [0, 1])
    ));
    let mut options = WriteOptions::new(Format::Star);
    let model = read(&text).model;
    options.lossy = true;
    // Star holds everything.
    assert_eq!(splitstar_formats::write(&model, &options).unwrap().notes, []);
    let (off, notes) = off(&text, true).unwrap();
    assert_eq!(notes, [WriteNote::LeftOut(Loss::Sheets(1)), WriteNote::NoObjects(2)]);
    assert!(off.starts_with("OFF\n12 10 18\n"), "{off}");
}

/// A cube with a square tunnel, whose openings are holes.
fn tunnel() -> String {
    let mut text = CUBE.replace("facet 3 2 1 0\n", "").replace("facet 4 5 6 7\n", "");
    for (id, z) in [(8, 0), (12, 1)] {
        for (at, [x, y]) in [[1, 1], [3, 1], [3, 3], [1, 3]].into_iter().enumerate() {
            let line = format!("vertex {} {x}/4 {y}/4 {z}\n", id + at);
            text.insert_str(text.find("facet").unwrap(), &line);
        }
    }
    text += "facet 3 2 1 0 hole 8 9 10 11\nfacet 7 6 5 4 hole 12 13 14 15 sides 1 0\n";
    text + "facet 8 12 13 9\nfacet 9 13 14 10\nfacet 10 14 15 11\nfacet 11 15 12 8\n"
}

#[test]
fn facets_with_holes_are_cut() {
    let text = records(&tunnel());
    let expected = WriteError::Loses { format: Format::Off, losses: vec![Loss::Holes(2)] };
    assert_eq!(off(&text, false), Err(expected));
    let (off, notes) = off(&text, true).unwrap();
    assert_eq!(notes, [WriteNote::CutHoles { from: 2, to: 16 }]);
    assert_eq!(notes[0].to_string(), "the format has no holes: 2 facets with holes cut into 16 triangles");
    let mesh = read(&off).model.shape.mesh().unwrap().clone();
    assert_eq!((mesh.points.len(), mesh.facets.len()), (16, 8 + 16));
    // Closed and oriented: each side of a facet is one of another, the other way.
    let mut sides: Vec<[u32; 2]> = Vec::new();
    for cycle in mesh.facets.iter() {
        sides.extend((0..cycle.len()).map(|at| [cycle[at], cycle[(at + 1) % cycle.len()]]));
    }
    let count = sides.len();
    sides.sort_unstable();
    sides.dedup();
    assert_eq!(sides.len(), count);
    assert!(sides.iter().all(|&[a, b]| sides.binary_search(&[b, a]).is_ok()));
}

#[test]
fn holes_without_an_area_become_vertices() {
    let text = records(&CUBE.replace("facet 3 2 1 0", "vertex 8 1/2 1/2 0 unmarked\nfacet 3 2 1 0 hole 8"));
    let (off, notes) = off(&text, true).unwrap();
    assert_eq!(notes, [WriteNote::LeftOut(Loss::Marks(1)), WriteNote::CutHoles { from: 1, to: 4 }]);
    assert_eq!(notes[0].to_string(), "left out: 1 mark of its own");
    let mesh = read(&off).model.shape.mesh().unwrap().clone();
    assert_eq!((mesh.points.len(), mesh.facets.len()), (9, 5 + 4));
}

#[test]
fn a_complex_cut_into_triangles_is_the_same_set() {
    let shape = read(&records(&tunnel())).model.shape;
    let Shape::Complex(complex) = shape else { panic!("it has holes") };
    let (cut, origin) = complex.triangulated().unwrap();
    assert_eq!((cut.facets.len(), origin.len()), (8 * 2 + 16, 32));
    assert!(origin.is_sorted() && cut.check().is_ok());
    assert_eq!(cut.as_mesh().unwrap().facets.len(), 32);
    // The edges inside a facet that does not belong to the set do not either; those around it do.
    let open = tunnel().replace("facet 3 2 1 0 hole 8 9 10 11", "facet 3 2 1 0 hole 8 9 10 11 unmarked");
    let Shape::Complex(complex) = read(&records(&open)).model.shape else { panic!("it has a mark") };
    let (cut, _) = complex.triangulated().unwrap();
    let counts = cut.summary();
    assert_eq!((counts.unmarked.facets, counts.unmarked.edges), (8, 8));
    assert_eq!(counts.dimension, complex.summary().dimension);
}

#[test]
fn edges_inside_repeated_facets_are_said_once() {
    let text = records(&format!("{CUBE}{}", "facet 3 2 1 0 unmarked\n".repeat(3)));
    let Shape::Complex(complex) = read(&text).model.shape else { panic!("it has marks") };
    let (cut, _) = complex.triangulated().unwrap();
    assert_eq!((cut.facets.len(), cut.edges.len(), cut.check()), (2 * 9, 1, Ok(())));
}

#[test]
fn a_facet_that_is_not_planar_is_named() {
    // Written as part of the whole, and because something else is left out.
    let bent = CUBE
        .replace("vertex 6 1 1 1", "vertex 6 1 1 1 unmarked")
        .replace("vertex 2 1 1 0", "vertex 2 1 1 1/3");
    let text = records(&bent);
    let message = "facet 0 is not planar: vertex 0 is off its plane, the square of the distance is 1/11; move the vertex, \
                   or write star";
    let error = off(&text, true).unwrap_err();
    assert!(matches!(error, WriteError::NotPlanar { facet: 0, .. }), "{error}");
    assert_eq!(error.to_string(), message);
    let Shape::Complex(complex) = read(&text).model.shape else { panic!("it has a mark") };
    assert_eq!(complex.check(), Ok(()));
    assert!(complex.regular_part().is_none());
    assert!(matches!(complex.triangulated(), Err((0, HoleError::NotPlanar { .. }))));
    // A complex that says no more than a mesh.
    let mesh = read(&text.replace(" unmarked", "")).model.shape.into_mesh().unwrap();
    let model = crate::model(splitstar_formats::Complex::of_mesh(&mesh));
    let error = splitstar_formats::write(&model, &WriteOptions::new(Format::Off)).unwrap_err();
    assert_eq!(error.to_string(), message);
}

#[test]
fn a_facet_that_cannot_be_cut_is_named() {
    let text = records(&tunnel()).replace("vertex 8 1/4 1/4 0", "vertex 8 1/4 1/4 1/9");
    let error = off(&text, true).unwrap_err();
    assert!(matches!(error, WriteError::CutHoles { facet: 4, .. }), "{error}");
    let message = error.to_string();
    assert!(message.starts_with("the format has no holes, and facet 4 cannot be cut: "), "{message}");
    assert!(message.contains("vertex 8"), "{message}");
}
