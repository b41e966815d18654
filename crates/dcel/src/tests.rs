//! Tests of the mesh: every defect, every violation, both ways of building.

use crate::{Defect, Edge, FacetId, HalfedgeId, Mesh, VertexId, Violation};

const CUBE: [[u32; 4]; 6] =
    [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

fn build(vertices: usize, facets: &[&[u32]]) -> Result<Mesh, Defect> {
    let mut starts = vec![0];
    let mut corners = Vec::new();
    for facet in facets {
        corners.extend_from_slice(facet);
        starts.push(corners.len() as u32);
    }
    Mesh::from_cycles(vertices, &starts, &corners)
}

fn cube() -> Mesh {
    let facets: Vec<&[u32]> = CUBE.iter().map(|f| &f[..]).collect();
    build(8, &facets).expect("the cube is closed")
}

#[test]
fn a_cube_has_the_cells_of_a_cube() {
    let mesh = cube();
    assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.facet_count()), (8, 12, 6));
    assert_eq!(mesh.euler_characteristic(), 2);
    assert_eq!(mesh.components().1, 1);
    assert_eq!(mesh.check_valid(), []);
    for (f, corners) in CUBE.iter().enumerate() {
        let cycle: Vec<u32> = mesh.facet_cycle(FacetId::new(f)).map(|h| mesh.source(h).0).collect();
        assert_eq!(cycle, corners);
    }
    for v in mesh.vertices() {
        assert_eq!(mesh.vertex_cycle(v).count(), 3);
    }
}

#[test]
fn every_defect_is_named() {
    let rows: &[(&str, usize, &[&[u32]], Defect)] = &[
        ("border", 3, &[&[0, 1, 2]], Defect::Border { edge: [0, 1], facet: 0 }),
        ("orientation", 3, &[&[0, 1, 2], &[0, 1, 2]], Defect::Orientation { edge: [0, 1], facets: [0, 1] }),
        (
            "three on an edge",
            3,
            &[&[0, 1, 2], &[2, 1, 0], &[0, 1, 2]],
            Defect::NonManifoldEdge { edge: [0, 1], facets: 3 },
        ),
        ("unused vertex", 4, &[&[0, 1, 2], &[2, 1, 0]], Defect::NonManifoldVertex { vertex: 3 }),
        (
            "two sheets at a vertex",
            5,
            &[&[0, 1, 2], &[2, 1, 0], &[0, 3, 4], &[4, 3, 0]],
            Defect::NonManifoldVertex { vertex: 0 },
        ),
        ("two corners", 3, &[&[0, 1], &[0, 1, 2]], Defect::DegenerateCycle { facet: 0 }),
        ("twice in a row", 3, &[&[0, 1, 1, 2]], Defect::DegenerateCycle { facet: 0 }),
        ("closing twice", 3, &[&[0, 1, 2, 0]], Defect::DegenerateCycle { facet: 0 }),
    ];
    for (name, vertices, facets, defect) in rows {
        assert_eq!(build(*vertices, facets), Err(*defect), "{name}");
    }
}

#[test]
fn digons_and_sheets_are_surfaces() {
    let edge = |left, right| Edge { source: 0, target: 1, left, right };
    let digons = Mesh::from_edges(2, 2, &[edge(0, 1), edge(1, 0)]);
    assert_eq!(digons.euler_characteristic(), 2);
    assert_eq!(digons.check_valid(), []);
    let sheet = build(3, &[&[0, 1, 2], &[2, 1, 0]]).expect("closed");
    assert_eq!(sheet.euler_characteristic(), 2);
    assert_eq!(sheet.check_valid(), []);
}

#[test]
fn edges_and_cycles_build_the_same_mesh() {
    let mesh = cube();
    let edges: Vec<Edge> = mesh
        .edges()
        .map(|h| Edge {
            source: mesh.source(h).0,
            target: mesh.target(h).0,
            left: mesh.facet(h).0,
            right: mesh.facet(h.twin()).0,
        })
        .collect();
    let again = Mesh::from_edges(8, 6, &edges);
    assert_eq!(again.check_valid(), []);
    for h in mesh.halfedges() {
        assert_eq!(mesh.next(h), again.next(h));
        assert_eq!(mesh.facet(h), again.facet(h));
    }
}

#[test]
fn two_shells_are_two_components() {
    let mesh = build(6, &[&[0, 1, 2], &[2, 1, 0], &[3, 4, 5], &[5, 4, 3]]).expect("closed");
    let (labels, count) = mesh.components();
    assert_eq!((labels, count), (vec![0, 0, 1, 1], 2));
}

#[test]
fn every_violation_is_reported() {
    let mut mesh = cube();
    mesh.next.swap(0, 2);
    assert!(mesh.check_valid().iter().any(|v| matches!(v, Violation::NextPrev(_))));

    let mut mesh = cube();
    mesh.source[0] = mesh.source[5];
    assert!(mesh.check_valid().iter().any(|v| matches!(v, Violation::Chain(_))));

    let mut mesh = cube();
    let other = mesh.facet(HalfedgeId(0).twin());
    mesh.facet[0] = other;
    assert!(mesh.check_valid().iter().any(|v| matches!(v, Violation::FacetOfNext(_))));

    let mut mesh = cube();
    mesh.source[1] = mesh.source[0];
    assert!(mesh.check_valid().contains(&Violation::Loop(HalfedgeId(0))));

    let mut mesh = cube();
    mesh.outgoing[3] = mesh.outgoing[4];
    assert_eq!(mesh.check_valid(), [Violation::Outgoing(VertexId(3))]);

    let mut mesh = cube();
    mesh.boundary[3] = mesh.boundary[4];
    assert_eq!(mesh.check_valid(), [Violation::Boundary(FacetId(3))]);

    // Two sheets that share a vertex: both cycles are sound, the vertex has two.
    let mut mesh = build(6, &[&[0, 1, 2], &[2, 1, 0], &[3, 4, 5], &[5, 4, 3]]).expect("closed");
    for v in &mut mesh.source {
        if v.0 == 3 {
            *v = VertexId(0);
        }
    }
    mesh.outgoing[3] = mesh.outgoing[0];
    let found = mesh.check_valid();
    assert!(
        found.contains(&Violation::VertexCycle(VertexId(0)))
            && found.contains(&Violation::Outgoing(VertexId(3)))
    );

    // Two cycles with the name of one facet.
    let mut mesh = build(6, &[&[0, 1, 2], &[2, 1, 0], &[3, 4, 5], &[5, 4, 3]]).expect("closed");
    for f in &mut mesh.facet {
        if f.0 == 2 {
            *f = FacetId(0);
        }
    }
    let found = mesh.check_valid();
    assert!(
        found.contains(&Violation::FacetCycle(FacetId(0)))
            && found.contains(&Violation::Boundary(FacetId(2)))
    );
}
