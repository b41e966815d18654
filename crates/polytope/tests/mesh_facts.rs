//! Facts about the meshes of the repository and about meshes made from hulls: what [`MeshSummary`] and
//! [`hull_depth`] say, and that polytopes come back from their meshes.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Point3, Rational, Vector3};
use splitstar_polytope::{
    Defect, MeshError, MeshSummary, Note, PolygonMesh, Polytope, convex_hull, hull_depth,
};
use testkit::{
    Rng, assert_same, expected, fan_triangulated, geodesic_sphere, mesh, model, model_mesh, model_names,
    random_hull, random_rotation, scaling, soup, stl_like_mesh,
};

#[test]
fn models_that_are_broken() {
    let outcome = |name: &str| {
        let mut notes = Vec::new();
        let result = Polytope::from_mesh(&model_mesh(&format!("invalid/{name}")), &mut notes);
        (result.map(|p| p.counts().to_array()), notes)
    };
    let cube = Ok([8, 12, 6]);
    assert_eq!(outcome("inside_out.off"), (cube.clone(), vec![Note::TurnedInsideOut]));
    assert_eq!(outcome("duplicate_vertex_unused.off"), (cube.clone(), vec![Note::Unused { vertices: 1 }]));
    assert_eq!(outcome("facet_soup.off"), (cube.clone(), vec![Note::Welded { from: 24, to: 8 }]));
    assert_eq!(outcome("huge_exponent.off"), (cube.clone(), vec![]));
    assert_eq!(outcome("zero_facets.off"), (cube, vec![Note::PointSet]));
    let joined = Note::Joined { from: [5, 6], to: [4, 4] };
    assert_eq!(outcome("zero_area_facet.off"), (Ok([4, 6, 4]), vec![joined]));
    assert_eq!(outcome("flat.off"), (Ok([3, 3, 1]), vec![Note::Flat { dimension: 2 }]));

    let error = |name: &str| outcome(name).0.expect_err(name);
    let open = Defect::Border { edge: [0, 3], facet: 0 };
    assert_eq!(error("open_mesh.off"), MeshError::NotClosed(open));
    let flipped = Defect::Orientation { edge: [2, 1], facets: [0, 3] };
    assert_eq!(error("flipped_facet.off"), MeshError::NotClosed(flipped));
    let four = Defect::NonManifoldEdge { edge: [1, 6], facets: 4 };
    assert_eq!(error("non_manifold_edge.off"), MeshError::NotClosed(four));
    let pinched = Defect::NonManifoldVertex { vertex: 6 };
    assert_eq!(error("non_manifold_vertex.off"), MeshError::NotClosed(pinched));
    let squared_distance: Rational = "4/5".parse().expect("a number");
    let bent = MeshError::NonPlanar { facet: 1, vertex: 7, squared_distance };
    assert_eq!(error("non_planar_quad.off"), bent);
    assert_eq!(error("overlapping_shells.off"), MeshError::SeveralShells { shells: 2, facets: [0, 6] });
    assert!(matches!(error("self_intersecting.off"), MeshError::ReflexEdge { .. }));
}

#[test]
fn models_that_are_not_convex() {
    let table = expected();
    let mut models = 0;
    for name in model_names("nonconvex") {
        let mesh = model_mesh(&name);
        let facts = &table["models"][&name];
        let summary = MeshSummary::of(&mesh);
        let mut counts = ["V", "E", "F"].map(|key| facts[key].as_u64().expect("known") as usize);
        if name == "nonconvex/ring.off" {
            // Top and bottom are one facet each: 8 of 40 edges go, and 8 vertices inside straight edges
            // with 8 more.
            counts = [16, 24, 10];
        } else {
            assert_eq!(facts["flat_edges"].as_u64(), Some(0), "{name}");
        }
        assert_eq!([summary.vertices, summary.edges, summary.facets], counts, "{name}");
        assert!(summary.closed && !summary.convex, "{name}");
        assert_eq!(summary.dimension, Some(3), "{name}");
        assert_eq!(summary.components as u64, facts["components"].as_u64().expect("known"), "{name}");
        let genus = facts["genus"].as_array().expect("known").iter();
        assert_eq!(summary.genus, genus.map(|g| g.as_u64().map(|g| g as u32)).collect::<Vec<_>>(), "{name}");
        let volume = facts["volume"].as_str().expect("known").parse().expect("a number");
        assert_eq!(summary.volume, Some(volume), "{name}");
        let Some(MeshError::ReflexEdge { edge, facets }) = summary.defect else {
            panic!("{name}: {:?}", summary.defect)
        };
        assert!(is_reflex(&mesh, edge, facets), "{name}: {edge:?}");
        let hull = convex_hull(&mesh.points).expect("a model has vertices");
        assert_eq!(hull_depth(&mesh.points, &hull), depth_by_brute_force(&mesh.points, &hull), "{name}");
        models += 1;
    }
    assert_eq!(models, 7);
}

/// Whether two facets share an edge, and a corner of the second lies above the first.
fn is_reflex(mesh: &PolygonMesh, [a, b]: [u32; 2], [f, g]: [u32; 2]) -> bool {
    let cycles = [f, g].map(|f| mesh.facets.get(f as usize));
    let has = |cycle: &[u32], from: u32, to: u32| {
        (0..cycle.len()).any(|i| cycle[i] == from && cycle[(i + 1) % cycle.len()] == to)
    };
    let point = |v: u32| &mesh.points[v as usize];
    let normal = |cycle: &[u32]| -> Vector3 {
        // Newell: the sum of the corners' cross products, for facets of one weight.
        let first = point(cycle[0]);
        cycle[1..].windows(2).fold(Vector3::from_i64([0, 0, 0]), |sum, pair| {
            &sum + &first.direction_to(point(pair[0])).cross(&first.direction_to(point(pair[1])))
        })
    };
    // Seen along the edge from a to b, the normal turns clockwise.
    let [m, n] = cycles.map(normal);
    let along = point(a).direction_to(point(b));
    has(cycles[0], a, b) && has(cycles[1], b, a) && m.cross(&n).dot(&along).sign() == exact::Sign::Negative
}

fn depth_by_brute_force(points: &[Point3], hull: &Polytope) -> Rational {
    let depth = |p: &Point3| {
        let squares = hull.mesh().facets().map(|f| {
            let plane = hull.facet_plane(f);
            let height = plane.height(p);
            let length = Rational::from(plane.normal.dot(&plane.normal));
            (&height * &height).checked_div(&length).expect("a normal is not zero")
        });
        squares.min().expect("a solid has facets")
    };
    points.iter().map(depth).max().unwrap_or_default()
}

#[test]
fn depth_below_the_hull() {
    const SEED: u64 = 0x3e5_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut solids = 0;
    for case in 0..300 {
        let hull = random_hull(&mut rng, 5);
        if hull.dimension() < 3 {
            assert_eq!(hull_depth(hull.points(), &hull), Rational::from(0), "case {case}");
            continue;
        }
        let turn = random_rotation(&mut rng, 5);
        let centre = hull.centroid();
        let half = |p: &Point3, q: &Point3| scaling(1, 2).apply(&p.plus(q));
        let mut inner: Vec<Point3> = hull.points().iter().map(|p| half(p, &centre)).collect();
        inner.push(centre.clone());
        inner.push(half(&hull.points()[0], &hull.points()[1]));
        rng.shuffle(&mut inner);
        let expected = depth_by_brute_force(&inner, &hull);
        assert_eq!(hull_depth(&inner, &hull), expected, "case {case}");
        let moved: Vec<Point3> = inner.iter().map(|p| turn.apply(p)).collect();
        assert_eq!(hull_depth(&moved, &hull.transformed(&turn)), expected, "case {case}, turned");
        assert_eq!(hull_depth(hull.points(), &hull), Rational::from(0), "case {case}");
        solids += 1;
    }
    assert!(solids > 200, "{solids} solids");
}

#[test]
fn models_cut_into_triangles() {
    for name in ["el16", "dp", "ball1", "cube", "ph_snub_dodecahedron"] {
        let path = format!("convex/{name}.off");
        let (plain, polytope) = (model_mesh(&path), model(&path));
        for mesh in [fan_triangulated(&plain), plain.triangulated().expect("facets are polygons")] {
            let mut notes = Vec::new();
            let found =
                Polytope::from_mesh(&mesh, &mut notes).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_same(&found, &polytope, name);
            let counts = polytope.counts();
            let from = [counts.vertices, mesh.facets.len()];
            assert_eq!(notes, [Note::Joined { from, to: [counts.vertices, counts.facets] }], "{name}");
            // One vertex pushed in: not convex any more.
            let mut dented = mesh.clone();
            let centre = polytope.centroid();
            dented.points[1] = centre;
            let error = Polytope::from_mesh(&dented, &mut Vec::new());
            assert!(matches!(error, Err(MeshError::ReflexEdge { .. })), "{name}: {error:?}");
        }
    }
}

fn inside_out(mesh: &PolygonMesh) -> PolygonMesh {
    let mut mesh = mesh.clone();
    mesh.facets.reverse();
    mesh
}

/// Hulls written out and read again, as they are, as soups, inside out, and in floats.
#[test]
fn round_trips() {
    const SEED: u64 = 0x3e5_0002;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    for case in 0..600 {
        let range = [1, 2, 5][case % 3];
        let turn = random_rotation(&mut rng, 5);
        let polytope = random_hull(&mut rng, range).transformed(&turn);
        let plain = polytope.to_mesh();
        let mut meshes = vec![plain.clone()];
        if polytope.dimension() == 3 {
            let triangles = fan_triangulated(&plain);
            meshes.extend([
                soup(&plain),
                inside_out(&plain),
                soup(&triangles),
                inside_out(&triangles),
                triangles,
            ]);
        }
        for (i, mesh) in meshes.iter().enumerate() {
            let found = Polytope::from_mesh(mesh, &mut Vec::new());
            let found = found.unwrap_or_else(|error| panic!("case {case}, mesh {i}: {error}"));
            assert_same(&found, &polytope, format!("case {case}, mesh {i}"));
        }
    }
    for spread in [0, 8, 40, 100] {
        let mesh = stl_like_mesh(&mut rng, 50, spread);
        let mut notes = Vec::new();
        let polytope = Polytope::from_mesh(&mesh, &mut notes).expect("a hull is convex");
        assert_same(&polytope, &convex_hull(&mesh.points).expect("fifty points"), format!("spread {spread}"));
        assert!(matches!(notes[0], Note::Welded { .. }), "{notes:?}");
    }
}

/// A sphere with one vertex moved a little: the last digit decides.
#[test]
fn nearly_convex() {
    let sphere = geodesic_sphere(4, 9);
    assert!(Polytope::from_mesh(&sphere, &mut Vec::new()).is_ok());
    // Onto the plane of three neighbours (convex with coplanar facets), and one billionth below it.
    let flat = mesh(
        &[
            [0, 0, 0],
            [2_000_000_000, 0, 0],
            [0, 2_000_000_000, 0],
            [0, 0, 2_000_000_000],
            [500_000_000, 500_000_000, 1_000_000_000],
        ],
        &[&[0, 2, 1], &[0, 3, 2], &[0, 1, 3], &[1, 2, 4], &[2, 3, 4], &[3, 1, 4]],
    );
    let mut notes = Vec::new();
    let tetrahedron = Polytope::from_mesh(&flat, &mut notes).expect("the vertex lies in a facet");
    assert_eq!(tetrahedron.counts().to_array(), [4, 6, 4]);
    assert_eq!(notes, [Note::Joined { from: [5, 6], to: [4, 4] }]);
    let moved = |by: i64| {
        let mut mesh = flat.clone();
        mesh.points[4] = mesh.points[4].plus(&Point3::from_i64([by, 0, 0]));
        Polytope::from_mesh(&mesh, &mut Vec::new()).map(|p| p.counts().to_array())
    };
    assert_eq!(moved(1), Ok([5, 9, 6]));
    assert!(matches!(moved(-1), Err(MeshError::ReflexEdge { .. })));
}

/// Facets of two vertices that are not one segment are described as what they are.
#[test]
fn facts_of_scattered_edges() {
    let points = [[0; 3], [1, 0, 0], [0, 1, 0], [5, 5, 5], [6, 5, 5], [0; 3]];
    let facts = MeshSummary::of(&mesh(&points, &[&[0, 1], &[1, 2], &[2, 5], &[5, 1], &[3, 4]]));
    assert_eq!([facts.vertices, facts.edges, facts.facets], [5, 4, 0]);
    assert_eq!((facts.dimension, facts.components, facts.genus), (Some(3), 2, vec![None, None]));
    assert!(!facts.closed && !facts.convex && facts.volume.is_none());
}
