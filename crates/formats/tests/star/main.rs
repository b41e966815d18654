//! The native format: what is read, what is refused, and that everything comes back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod cells;
mod losses;
mod random;
mod reading;
mod writing;

use splitstar_formats::{Complex, Format, Model, ReadModel, Shape, WriteOptions};

fn read(text: &str) -> ReadModel {
    splitstar_formats::read(text.as_bytes(), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn complex(text: &str) -> Complex {
    match read(text).model.shape {
        Shape::Complex(complex) => complex,
        _ => panic!("a mesh\n{text}"),
    }
}

/// With the first line before it, and `end` behind.
fn records(records: &str) -> String {
    format!("star 1 complex\n{records}end\n")
}

fn write(model: &Model) -> String {
    let written = splitstar_formats::write(model, &WriteOptions::new(Format::Star)).unwrap();
    assert_eq!(written.largest_rounding.to_string(), "0");
    assert_eq!(written.notes, []);
    String::from_utf8(written.bytes).unwrap()
}

fn model(complex: Complex) -> Model {
    let mut model = Model::of_mesh(polytope::PolygonMesh::default());
    model.shape = Shape::Complex(complex);
    model
}

/// The examples of the specification.
fn examples() -> Vec<String> {
    let page = include_str!("../../../../docs/star.md");
    let examples: Vec<String> =
        page.split("```star\n").skip(1).map(|rest| rest.split("```").next().unwrap().to_string()).collect();
    assert_eq!(examples.len(), 6);
    examples
}

const CUBE: &str = "vertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 1 1 0\nvertex 3 0 1 0\nvertex 4 0 0 1\n\
    vertex 5 1 0 1\nvertex 6 1 1 1\nvertex 7 0 1 1\nfacet 3 2 1 0\nfacet 4 5 6 7\nfacet 0 1 5 4\n\
    facet 1 2 6 5\nfacet 2 3 7 6\nfacet 3 0 4 7\n";
