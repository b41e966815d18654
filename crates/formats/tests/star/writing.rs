//! Meshes that come back, and numbers.

use crate::{CUBE, model, read, records, write};
use exact::{Integer, Point3, Vector3};
use polytope::{Facets, Mending, PolygonMesh};
use splitstar_formats::{
    Cell, Complex, Edge, Encoding, Facet, Format, Model, Object, Rule, Shape, Unit, Vertex, WriteError,
    WriteNote, WriteOptions,
};

fn mesh(points: usize, facets: &[&[u32]]) -> PolygonMesh {
    let points = (0..points as i64).map(|i| Point3::from_i64([i, i * i, i * i * i])).collect();
    let mut mesh = PolygonMesh { points, facets: Facets::new() };
    facets.iter().for_each(|cycle| mesh.facets.push(cycle));
    mesh
}

#[test]
fn meshes_come_back_the_same() {
    let rows: [(usize, &[&[u32]]); 5] = [
        (3, &[]),
        (2, &[&[1, 0]]),
        (4, &[&[0, 1], &[2, 3], &[3, 0]]),
        (4, &[&[0, 2, 1, 3]]),
        (4, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[0, 2, 3]]),
    ];
    for (points, facets) in rows {
        let mesh = mesh(points, facets);
        let mut model = Model::of_mesh(mesh.clone());
        model.unit = Some(Unit::Micron);
        let object = |name: &str, first_facet| Object { name: name.into(), first_facet };
        model.objects = vec![object("first", 0), object("behind \"all\"", facets.len() as u32)];
        let text = write(&model);
        let again = read(&text).model;
        let got = again.shape.mesh().unwrap();
        assert_eq!((&got.points, &got.facets), (&mesh.points, &mesh.facets), "{text}");
        assert_eq!((&again.objects, again.unit), (&model.objects, model.unit), "{text}");
        // The complex of the mesh is the same, and the text of it too.
        let mut as_complex = crate::model(Complex::of_mesh(&mesh));
        (as_complex.objects, as_complex.unit) = (model.objects, model.unit);
        assert_eq!(write(&as_complex), text);
        let got = Complex::of_mesh(&mesh).as_mesh().unwrap();
        assert_eq!((got.points, got.facets), (mesh.points, mesh.facets));
    }
}

#[test]
fn vertices_without_a_facet_are_left_out() {
    let mesh = mesh(6, &[&[5, 2, 1]]);
    let text = records("vertex 0 1 1 1\nvertex 1 2 4 8\nvertex 2 5 25 125\nfacet 2 1 0 sides 0 0\n");
    let options = WriteOptions::new(Format::Star);
    let written = splitstar_formats::write(&Model::of_mesh(mesh.clone()), &options).unwrap();
    assert_eq!(String::from_utf8(written.bytes).unwrap(), text);
    assert_eq!(written.notes, [WriteNote::UnusedVertices(3)]);
    assert_eq!(write(&model(Complex::of_mesh(&mesh))), text);
}

#[test]
fn segments_are_written_once() {
    let mut mesh = mesh(3, &[&[0, 1], &[1, 0], &[2, 1]]);
    mesh.points[2] = Point3::from_i64([0, 0, 9]);
    let text = records("vertex 0 0 0 0\nvertex 1 1 1 1\nvertex 2 0 0 9\nedge 0 1\nedge 2 1\n");
    assert_eq!(write(&Model::of_mesh(mesh.clone())), text);
    assert_eq!(write(&model(Complex::of_mesh(&mesh))), text);
}

/// A square grid of so many steps, cut into triangles, not flat.
fn grid(steps: u32) -> PolygonMesh {
    let mut mesh = PolygonMesh::default();
    for [i, j] in (0..=steps).flat_map(|i| (0..=steps).map(move |j| [i, j])) {
        mesh.points.push(Point3::from_i64([i.into(), j.into(), (i * j % 7).into()]));
    }
    for corner in (0..steps).flat_map(|i| (0..steps).map(move |j| i * (steps + 1) + j)) {
        let [a, b, c, d] = [corner, corner + steps + 1, corner + steps + 2, corner + 1];
        mesh.facets.push(&[a, b, c]);
        mesh.facets.push(&[a, c, d]);
    }
    mesh
}

#[test]
fn a_large_packed_mesh_comes_back() {
    let mesh = grid(320);
    assert_eq!(mesh.facets.len(), 204_800);
    let encoding = Encoding::from_file_name("grid.star.gz").unwrap();
    let written =
        splitstar_formats::write(&Model::of_mesh(mesh.clone()), &WriteOptions::new(encoding)).unwrap();
    let again = splitstar_formats::read(&written.bytes, None).unwrap().model.shape.into_mesh().unwrap();
    assert_eq!((again.points, again.facets), (mesh.points, mesh.facets));
}

#[test]
fn a_joined_mesh_may_be_a_complex() {
    // A flat ring: a square with a square hole, in eight triangles.
    let mut ring = mesh(8, &[]);
    for (at, [x, y]) in
        [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [2, 1], [2, 2], [1, 2]].into_iter().enumerate()
    {
        ring.points[at] = Point3::from_i64([x, y, 0]);
    }
    for a in 0..4 {
        let b = (a + 1) % 4;
        ring.facets.push(&[a, b, b + 4]);
        ring.facets.push(&[a, b + 4, a + 4]);
    }
    let mended = ring.mended(Mending::joining(), &mut Vec::new()).unwrap();
    let mut model = Model::of_mesh(PolygonMesh::default());
    model.shape = Shape::of_mended(mended);
    assert!(write(&model).contains("\nfacet 0 1 2 3 hole 5 4 7 6 sides 0 0\n"), "{}", write(&model));
    let mended = ring.mended(Mending::new(), &mut Vec::new()).unwrap();
    assert_eq!(Complex::of_mended(mended.clone()), Complex::of_mesh(&ring));
    assert!(Shape::of_mended(mended).mesh().is_some());
}

#[test]
fn floats_are_for_coordinates_only() {
    let text = records(
        "vertex 0 1/3 0 0\ndirection 1 1 3 0\ndirection 2 -1 -3 0\nvertex 3 1/2 0 0\nedge 1 2 through 0 2/3 0\n",
    );
    let mut options = WriteOptions::new(Format::Star);
    options.float = true;
    let written = splitstar_formats::write(&read(&text).model, &options).unwrap();
    let expected = records(
        "vertex 0 0.3333333333333333 0 0\ndirection 1 1 3 0\ndirection 2 -1 -3 0\nvertex 3 0.5 0 0\n\
         edge 1 2 through 0 0.6666666666666666 0\n",
    );
    assert_eq!(String::from_utf8(written.bytes).unwrap(), expected);
    assert_eq!(written.largest_rounding.to_string(), "1/15000000000000000");
    let large = read(&records("vertex 0 1e309 0 0\n")).model;
    let error = splitstar_formats::write(&large, &options).unwrap_err();
    assert_eq!(error, WriteError::TooLargeForFloat { vertex: 0 });
}

#[test]
fn a_complex_against_the_rules_is_not_written() {
    let triangle = || Facet::of_cycle(vec![0, 1, 2], [0, 1]);
    let mut base = Complex::default();
    base.vertices = (0..3).map(|i| Vertex::point(Point3::from_i64([i, i * i, 0]))).collect();
    type Row = (fn(&mut Complex, Facet), Cell, Rule, &'static str);
    let rows: [Row; 4] = [
        (
            |complex, _| complex.edges.extend([[0, 1], [1, 2], [2, 1]].map(Edge::segment)),
            Cell::Edge(2),
            Rule::RepeatedEdge(1),
            "edge 2: edge 1 is the same; remove one of them",
        ),
        (
            |complex, facet| complex.facets.extend([facet, Facet::of_cycle(vec![0, 1, 3], [0, 1])]),
            Cell::Facet(1),
            Rule::UnknownVertex(3),
            "facet 1: there is no vertex 3; declare it",
        ),
        (
            |complex, facet| complex.facets.push(Facet { sides: [0, 2], ..facet }),
            Cell::Facet(0),
            Rule::UnknownVolume(2),
            "facet 0: there is no volume 2; declare it",
        ),
        (
            |complex, _| complex.vertices.push(Vertex::direction(Vector3::new([0, 0, 0].map(Integer::from)))),
            Cell::Vertex(3),
            Rule::ZeroDirection,
            "vertex 3: the direction is zero; give one that points somewhere",
        ),
    ];
    for (change, cell, rule, message) in rows {
        let mut complex = base.clone();
        change(&mut complex, triangle());
        let malformed = complex.check().unwrap_err();
        assert_eq!((malformed.cell, malformed.rule), (cell, rule));
        for format in [Format::Star, Format::Off] {
            let error = splitstar_formats::write(&model(complex.clone()), &WriteOptions::new(format));
            assert_eq!(error.unwrap_err().to_string(), message);
        }
    }
}

#[test]
fn long_cycles_are_checked_too() {
    let mut complex = Complex::default();
    complex.vertices = (0..50).map(|i| Vertex::point(Point3::from_i64([i, i * i, 0]))).collect();
    complex.facets.push(Facet::of_cycle((0..50).collect(), [0, 1]));
    assert_eq!(complex.check(), Ok(()));
    complex.facets[0].outer[40] = 7;
    assert_eq!(complex.check().unwrap_err().rule, Rule::Repeated(7));
}

#[test]
fn numbers_are_not_rounded() {
    let digits = "123456789".repeat(30);
    let text = records(&format!("vertex 0 1/{digits} -{digits} 1/3\nvertex 1 0 0 0\nedge 0 1\n"));
    assert_eq!(write(&read(&text).model), text);
    assert_eq!(write(&read(&records(CUBE)).model), records(CUBE));
}
