//! One mesh for each thing that is mended, what is refused, and the models.

use super::*;
use splitstar_polytope::{Facets, MeshError, MeshSummary};
use testkit::{cube_mesh, fan_triangulated, mesh, model_mesh, model_names, soup};

fn with_point(mesh: &PolygonMesh, at: [i64; 3]) -> PolygonMesh {
    let mut mesh = mesh.clone();
    mesh.points.push(Point3::from_i64(at));
    mesh
}

fn with_facet(mesh: &PolygonMesh, cycle: &[u32]) -> PolygonMesh {
    let mut mesh = mesh.clone();
    mesh.facets.push(cycle);
    mesh
}

/// Name, mesh, what to mend, and the vertices, facets and holes that come out, with the notes.
type Row = (&'static str, PolygonMesh, Mending<'static>, [usize; 3], &'static [&'static str]);

const TURNED: &str = "the mesh is inside out; its facets were turned round";

fn rows() -> Vec<Row> {
    let cube = cube_mesh();
    let triangles = fan_triangulated(&cube);
    let (ring, void) = (model_mesh("nonconvex/ring.off"), model_mesh("nonconvex/void_cube.off"));
    let square = [[0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 0]];
    vec![
        ("a cube", cube.clone(), KEEP, [8, 6, 0], &[]),
        ("a cube, joined", cube.clone(), JOIN, [8, 6, 0], &[]),
        ("an unused vertex", with_point(&cube, [9, 9, 9]), KEEP, [8, 6, 0], &["1 unused vertex dropped"]),
        ("a soup", soup(&cube), KEEP, [8, 6, 0], &["24 vertices welded to 8 at equal positions"]),
        ("inside out", inside_out(&cube), KEEP, [8, 6, 0], &[TURNED]),
        (
            "all together",
            with_point(&inside_out(&soup(&triangles)), [0, 0, 0]),
            JOIN,
            [8, 6, 0],
            &[
                "1 unused vertex dropped",
                "36 vertices welded to 8 at equal positions",
                TURNED,
                "coplanar facets and collinear edges joined: 12 facets and 8 vertices became 6 and 8",
            ],
        ),
        ("triangles", triangles.clone(), KEEP, [8, 12, 0], &[]),
        (
            "the ring",
            ring.clone(),
            JOIN,
            [16, 10, 2],
            &["coplanar facets and collinear edges joined: 16 facets and 24 vertices became 10 and 16"],
        ),
        ("a void stays a void", void.clone(), JOIN, [16, 12, 0], &[]),
        ("a void inside out", inside_out(&void), KEEP, [16, 12, 0], &[TURNED]),
        (
            "a cube welded though it is open",
            {
                let mut open = soup(&cube);
                let mut facets = Facets::new();
                open.facets.iter().skip(1).for_each(|cycle| facets.push(cycle));
                open.facets = facets;
                open
            },
            KEEP,
            [8, 5, 0],
            &["4 unused vertices dropped", "20 vertices welded to 8 at equal positions"],
        ),
        (
            "vertices at one place, but closed without welding",
            {
                let mut two = cube.clone();
                two.points.extend(cube.points.iter().map(|p| p.plus(&Point3::from_i64([2, 2, 2]))));
                cube.facets
                    .iter()
                    .for_each(|c| two.facets.push(&c.iter().map(|v| v + 8).collect::<Vec<_>>()));
                two
            },
            KEEP,
            [16, 12, 0],
            &[],
        ),
        ("points", mesh(&[[0; 3], [1, 0, 0], [2, 0, 0]], &[]), JOIN, [3, 0, 0], &[]),
        (
            "repeated points",
            mesh(&[[0; 3], [1, 0, 0], [0; 3], [1, 0, 0]], &[]),
            JOIN,
            [2, 0, 0],
            &["4 vertices welded to 2 at equal positions"],
        ),
        (
            "segments",
            mesh(&[[0; 3], [1, 0, 0], [1, 0, 0], [2, 0, 0], [5, 5, 5]], &[&[0, 1], &[2, 3]]),
            JOIN,
            [3, 2, 0],
            &["1 unused vertex dropped", "4 vertices welded to 3 at equal positions"],
        ),
        ("one polygon", mesh(&square, &[&[0, 1, 2, 3]]), JOIN, [4, 1, 0], &[]),
        (
            "an L with a straight corner",
            mesh(
                &[[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]],
                &[&[0, 1, 2, 3, 4, 5, 6]],
            ),
            JOIN,
            [6, 1, 0],
            &["coplanar facets and collinear edges joined: 1 facet and 7 vertices became 1 and 6"],
        ),
        (
            "facets that turn different ways are not joined",
            mesh(&square, &[&[0, 1, 2], &[0, 3, 2]]),
            JOIN,
            [4, 2, 0],
            &[],
        ),
        (
            "a facet folded back on the other",
            mesh(&[[0, 0, 0], [4, 0, 0], [4, 4, 0], [1, 2, 0]], &[&[0, 1, 2], &[0, 2, 3], &[2, 0, 3]]),
            JOIN,
            [4, 3, 0],
            &[],
        ),
        (
            "a triangle that collapses",
            with_facet(&with_point(&triangles, [0, 0, 0]), &[0, 8, 1]),
            KEEP,
            [8, 12, 0],
            &[
                "9 vertices welded to 8 at equal positions",
                "1 facet dropped that has fewer than three different vertices",
            ],
        ),
        (
            "a facet that goes there and back",
            mesh(&[[0; 3], [1, 0, 0], [0, 1, 0]], &[&[0, 1, 2], &[0, 0, 1], &[2, 1, 1]]),
            KEEP,
            [3, 1, 0],
            &["2 facets dropped that have fewer than three different vertices"],
        ),
        (
            "facets that all collapse",
            mesh(&[[0; 3], [1, 0, 0], [0; 3]], &[&[0, 1, 2]]),
            KEEP,
            [2, 0, 0],
            &[
                "3 vertices welded to 2 at equal positions",
                "1 facet dropped that has fewer than three different vertices",
            ],
        ),
        (
            "a keyhole becomes a hole",
            mesh(
                &[&square[..], &[[2, 2, 0], [2, 4, 0], [4, 4, 0], [4, 2, 0]]].concat(),
                &[&[0, 1, 2, 3, 0, 4, 5, 6, 7, 4]],
            ),
            JOIN,
            [8, 1, 1],
            &[],
        ),
        (
            "a spike goes",
            mesh(&[&square[..], &[[9, 9, 0]]].concat(), &[&[0, 1, 2, 4, 2, 3]]),
            JOIN,
            [4, 1, 0],
            &["coplanar facets and collinear edges joined: 1 facet and 5 vertices became 1 and 4"],
        ),
        (
            "two lobes with a hole in each",
            mesh(
                &[
                    [0, 0, 0],
                    [9, 1, 0],
                    [9, 9, 0],
                    [1, 9, 0],
                    [-9, -1, 0],
                    [-9, -9, 0],
                    [-1, -9, 0],
                    [4, 4, 0],
                    [4, 6, 0],
                    [6, 4, 0],
                    [-4, -4, 0],
                    [-4, -6, 0],
                    [-6, -4, 0],
                ],
                &[&[0, 1, 2, 3, 0, 10, 11, 12, 10, 0, 4, 5, 6, 0, 7, 8, 9, 7]],
            ),
            JOIN,
            [13, 2, 2],
            &["coplanar facets and collinear edges joined: 1 facet and 13 vertices became 2 and 13"],
        ),
        (
            "a wall in the middle of a floor",
            mesh(
                &[&square[..], &[[2, 3, 0], [4, 3, 0], [4, 3, 1], [2, 3, 1]]].concat(),
                &[&[0, 1, 5, 4], &[1, 2, 5], &[2, 3, 4, 5], &[3, 0, 4], &[4, 5, 6, 7]],
            ),
            JOIN,
            [8, 2, 1],
            &["coplanar facets and collinear edges joined: 5 facets and 8 vertices became 2 and 8"],
        ),
        (
            "a wall from the border of a floor",
            mesh(
                &[&square[..], &[[3, 3, 0], [3, 3, 1], [0, 0, 1]]].concat(),
                &[&[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4], &[0, 4, 5, 6]],
            ),
            JOIN,
            [7, 2, 1],
            &["coplanar facets and collinear edges joined: 5 facets and 7 vertices became 2 and 7"],
        ),
    ]
}

#[test]
fn every_row_and_its_notes() {
    for (name, given, what, counts, expected) in rows() {
        let (mended, notes) = mend(&given, what);
        let found = [mended.mesh.points.len(), mended.mesh.facets.len(), mended.holes.len()];
        assert_eq!(found, counts, "{name}");
        assert_eq!(notes.iter().map(Note::to_string).collect::<Vec<_>>(), expected, "{name}");
        if what == JOIN
            && mended.mesh.facets.iter().all(|cycle| cycle.len() > 2)
            && !name.contains("together")
        {
            check_joined(name, &given, &mended);
        }
        // What was mended needs no mending.
        let mut notes = Vec::new();
        if mended.holes.is_empty() {
            let again = mended.mesh.mended(what, &mut notes).expect("it was mended");
            assert!(notes.is_empty() && again.mesh.facets == mended.mesh.facets, "{name}: {notes:?}");
        }
    }
}

/// Vertices of one facet on an edge of another, and facets without area there: they go, in whatever way they
/// are cut.
#[test]
fn facets_without_area() {
    // A box of height 1 over a square; vertices 8 to 11 lie on the edge from 0 to 1.
    let points = [
        [0, 0, 0],
        [6, 0, 0],
        [6, 6, 0],
        [0, 6, 0],
        [0, 0, 1],
        [6, 0, 1],
        [6, 6, 1],
        [0, 6, 1],
        [1, 0, 0],
        [2, 0, 0],
        [3, 0, 0],
        [4, 0, 0],
    ];
    let sides: [&[u32]; 4] = [&[4, 5, 6, 7], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
    let rows: [(&str, &[&[u32]]); 7] = [
        ("a triangle", &[&[0, 3, 2, 1], &[0, 1, 8], &[0, 8, 5, 4], &[8, 1, 5]]),
        ("a fan", &[&[0, 3, 2, 1], &[0, 1, 8], &[8, 1, 9], &[9, 1, 10], &[0, 8, 9, 10, 5, 4], &[10, 1, 5]]),
        ("on both sides", &[&[0, 3, 2, 8], &[8, 2, 1], &[0, 8, 1, 9], &[0, 9, 5, 4], &[9, 1, 5]]),
        (
            "on both sides, cut the wrong way",
            &[&[0, 3, 2, 8], &[8, 2, 1], &[0, 8, 1], &[0, 1, 9], &[0, 9, 5, 4], &[9, 1, 5]],
        ),
        (
            "on both sides, in turn",
            &[
                &[0, 3, 2, 8],
                &[8, 2, 10],
                &[10, 2, 1],
                &[0, 8, 10, 1, 11, 9],
                &[0, 9, 5, 4],
                &[9, 11, 5],
                &[11, 1, 5],
            ],
        ),
        ("stacked", &[&[0, 3, 2, 1], &[0, 1, 9], &[0, 9, 1], &[0, 1, 8], &[0, 8, 5, 4], &[8, 1, 5]]),
        ("there and back", &[&[0, 3, 2, 1], &[0, 1, 8], &[0, 8, 1], &[0, 1, 5, 4]]),
    ];
    for (name, facets) in rows {
        let given = mesh(&points, &[&sides, facets].concat());
        let (kept, _) = mend(&given, KEEP);
        assert_eq!(kept.mesh.facets.len(), given.facets.len(), "{name}");
        let (joined, notes) = mend(&given, JOIN);
        assert_eq!(
            [joined.mesh.points.len(), joined.mesh.facets.len(), joined.holes.len()],
            [8, 6, 0],
            "{name}"
        );
        assert!(matches!(notes[..], [.., Note::Joined { to: [8, 6], .. }]), "{name}: {notes:?}");
        assert_eq!(borders(&cycles(&joined)), 0, "{name}");
        check_joined(name, &given, &joined);
    }
    // Nothing has area: nothing goes.
    let line = mesh(&points, &[&[0, 8, 9], &[8, 0, 9]]);
    assert_eq!(mend(&line, JOIN).0.mesh.facets.len(), 2);
    // Vertices at one place that are not welded, since the surface is closed: the edge between them goes.
    let split = mesh(
        &[[0; 3], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]],
        &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 4], &[1, 4, 3], &[2, 0, 3], &[2, 3, 4]],
    );
    let (joined, _) = mend(&split, JOIN);
    assert_eq!([joined.mesh.points.len(), joined.mesh.facets.len()], [4, 4]);
}

/// A mesh made to grow: many facets on one line, each with an edge over all vertices of it. It does not.
#[test]
fn a_line_of_many_long_edges() {
    const N: u32 = 400;
    let mut points = vec![[0, 0, 0], [i64::from(N) + 1, 0, 0]];
    points.extend((1..=i64::from(N)).map(|x| [x, 0, 0]));
    points.extend((0..i64::from(N)).map(|x| [x, 1, x * x]));
    let mut given = mesh(&points, &[]);
    (2..N + 2).for_each(|v| given.facets.push(&[0, 1, v]));
    (N + 2..2 * N + 2).for_each(|v| given.facets.push(&[1, 0, v]));
    let (joined, _) = mend(&given, JOIN);
    let corners = joined.mesh.facets.corners().len();
    assert!(corners <= 9 * given.facets.corners().len(), "{corners} corners");
}

#[test]
fn what_is_refused() {
    let error = |mesh: &PolygonMesh| mesh.mended(KEEP, &mut Vec::new()).expect_err("refused");
    assert_eq!(error(&PolygonMesh::default()), MeshError::Empty);
    let bent = model_mesh("invalid/non_planar_quad.off");
    let squared_distance: Rational = "4/5".parse().expect("a number");
    assert_eq!(error(&bent), MeshError::NonPlanar { facet: 1, vertex: 7, squared_distance });
    let square = [[0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 1], [9, 9, 9]];
    let open = mesh(&square, &[&[0, 1, 2], &[4, 0, 1], &[0, 1, 2, 3]]);
    assert!(matches!(error(&open), MeshError::NonPlanar { facet: 2, vertex: 3, .. }));
    assert_eq!(error(&mesh(&square, &[&[0, 1, 2], &[0, 1]])), MeshError::LooseEdge { facet: 1 });
    assert_eq!(error(&mesh(&square, &[&[0, 1, 5]])), MeshError::NoSuchVertex { facet: 0, index: 5 });
    // Indices are those of the mesh that was given, also after others went.
    let late = mesh(&[[5; 3], [0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 1]], &[&[1, 2, 1], &[1, 2, 3, 4]]);
    assert!(matches!(error(&late), MeshError::NonPlanar { facet: 1, vertex: 4, .. }));
}

#[test]
fn all_models() {
    let mut holes = 0;
    for name in ["convex", "nonconvex", "maxfacets"].into_iter().flat_map(model_names) {
        let given = model_mesh(&name);
        let facts = MeshSummary::of(&given);
        for (which, variant) in
            [given.clone(), fan_cut(&given), soup(&given), inside_out(&soup(&fan_cut(&given)))]
                .iter()
                .enumerate()
        {
            let name = format!("{name}, variant {which}");
            let (joined, notes) = mend(variant, JOIN);
            assert_eq!(notes.contains(&Note::TurnedInsideOut), which == 3, "{name}");
            let counts = [joined.mesh.points.len(), joined.mesh.facets.len()];
            assert_eq!(counts, [facts.vertices, facts.facets], "{name}");
            let triangles = check_joined(&name, if which == 3 { &given } else { variant }, &joined);
            let after = MeshSummary::of(&triangles);
            assert_eq!(
                [after.vertices, after.edges, after.facets],
                [facts.vertices, facts.edges, facts.facets]
            );
            assert_eq!((after.genus, after.volume), (facts.genus.clone(), facts.volume.clone()), "{name}");
            holes += joined.holes.len();
        }
    }
    assert!(holes >= 8, "{holes} holes");
}

/// Cut into triangles by the library, which knows facets that are not convex.
fn fan_cut(mesh: &PolygonMesh) -> PolygonMesh {
    mesh.triangulated().expect("models have simple facets")
}
