//! From meshes as files have them to polytopes: what is mended, what is refused, and what is said.

use exact::Point3;
use splitstar_polytope::{Defect, Facets, MeshError, MeshSummary, Note, PolygonMesh, Polytope};
use testkit::{assert_same, cube_mesh, fan_triangulated, hull, mesh, soup};

/// A mesh, and the polytope or the error that it must become.
struct Row {
    name: &'static str,
    mesh: PolygonMesh,
    outcome: Result<(Polytope, Vec<Note>), MeshError>,
}

fn mended(name: &'static str, mesh: PolygonMesh, polytope: &Polytope, notes: &[Note]) -> Row {
    Row { name, mesh, outcome: Ok((polytope.clone(), notes.to_vec())) }
}

fn refused(name: &'static str, mesh: PolygonMesh, error: MeshError) -> Row {
    Row { name, mesh, outcome: Err(error) }
}

fn check(rows: Vec<Row>) {
    for Row { name, mesh, outcome } in rows {
        let mut notes = Vec::new();
        match (Polytope::from_mesh(&mesh, &mut notes), outcome) {
            (Ok(polytope), Ok((expected, expected_notes))) => {
                assert_same(&polytope, &expected, name);
                assert_eq!(notes, expected_notes, "{name}");
                let summary = MeshSummary::of(&mesh);
                let counts = [summary.vertices, summary.edges, summary.facets];
                assert_eq!(counts, polytope.counts().to_array(), "{name}");
                assert!(summary.convex && summary.defect.is_none(), "{name}");
                assert_eq!((summary.notes, summary.dimension), (notes, Some(polytope.dimension())), "{name}");
            }
            (Err(error), Err(expected)) => {
                // Which facet shows that a surface winds twice depends on where the search begins.
                let both = [&error, &expected].map(|e| matches!(e, MeshError::NotOnHull { .. }));
                assert!(error == expected || both == [true; 2], "{name}: {error:?}, not {expected:?}");
                let summary = MeshSummary::of(&mesh);
                assert_eq!((summary.convex, summary.defect), (false, Some(error)), "{name}");
            }
            (found, expected) => panic!("{name}: {found:?} in place of {expected:?}"),
        }
    }
}

fn cube() -> Polytope {
    hull(&[[0, 0, 0], [0, 0, 2], [0, 2, 0], [0, 2, 2], [2, 0, 0], [2, 0, 2], [2, 2, 0], [2, 2, 2]])
}

fn with(mut mesh: PolygonMesh, points: &[[i64; 3]], change: impl Fn(&[u32]) -> Vec<Vec<u32>>) -> PolygonMesh {
    mesh.points.extend(points.iter().map(|&p| Point3::from_i64(p)));
    let cycles: Vec<Vec<u32>> = mesh.facets.iter().flat_map(change).collect();
    mesh.facets = Facets::new();
    cycles.iter().for_each(|cycle| mesh.facets.push(cycle));
    mesh
}

fn turned(mesh: &PolygonMesh) -> PolygonMesh {
    let mut mesh = mesh.clone();
    mesh.facets.reverse();
    mesh
}

/// The side of the cube with `from` behind `to`, with vertex 8 between.
fn split_edge(cycle: &[u32], from: u32, to: u32) -> Vec<u32> {
    let mut split = Vec::new();
    for (i, &v) in cycle.iter().enumerate() {
        split.push(v);
        if v == from && cycle[(i + 1) % cycle.len()] == to {
            split.push(8);
        }
    }
    split
}

#[test]
fn what_is_mended() {
    let joined = |from, to| Note::Joined { from, to };
    let plain = cube_mesh();
    // Vertex 8 in the middle of the edge from 0 to 4, in both of its facets.
    let on_edge = with(plain.clone(), &[[1, 0, 0]], |c| vec![split_edge(&split_edge(c, 0, 4), 4, 0)]);
    // Vertex 8 in the middle of the bottom side.
    let in_facet = with(plain.clone(), &[[1, 1, 0]], |c| match c {
        [0, 2, 6, 4] => vec![vec![0, 2, 8], vec![2, 6, 8], vec![6, 4, 8], vec![4, 0, 8]],
        _ => vec![c.to_vec()],
    });
    // The bottom cut into a quadrilateral and a non-convex hexagon.
    let non_convex_part = with(plain.clone(), &[[1, 1, 0]], |c| match c {
        [0, 2, 6, 4] => vec![vec![0, 2, 8], vec![8, 2, 6, 4, 0]],
        _ => vec![c.to_vec()],
    });
    let unused = with(plain.clone(), &[[9, 9, 9], [1, 1, 1]], |c| vec![c.to_vec()]);
    check(vec![
        mended("a cube", plain.clone(), &cube(), &[]),
        mended("triangles", fan_triangulated(&plain), &cube(), &[joined([8, 12], [8, 6])]),
        mended("a soup", soup(&plain), &cube(), &[Note::Welded { from: 24, to: 8 }]),
        mended(
            "a soup of triangles",
            soup(&fan_triangulated(&plain)),
            &cube(),
            &[Note::Welded { from: 36, to: 8 }, joined([8, 12], [8, 6])],
        ),
        mended("inside out", turned(&plain), &cube(), &[Note::TurnedInsideOut]),
        mended(
            "triangles inside out",
            turned(&fan_triangulated(&plain)),
            &cube(),
            &[Note::TurnedInsideOut, joined([8, 12], [8, 6])],
        ),
        mended(
            "a soup inside out",
            turned(&soup(&plain)),
            &cube(),
            &[Note::Welded { from: 24, to: 8 }, Note::TurnedInsideOut],
        ),
        mended("a vertex in an edge", on_edge, &cube(), &[joined([9, 6], [8, 6])]),
        mended("a vertex in a facet", in_facet, &cube(), &[joined([9, 9], [8, 6])]),
        mended("a non-convex part of a facet", non_convex_part, &cube(), &[joined([9, 7], [8, 6])]),
        mended("unused vertices", unused, &cube(), &[Note::Unused { vertices: 2 }]),
    ]);
}

#[test]
fn what_is_refused() {
    use MeshError::{LooseEdge, NonPlanar, NotClosed, NotOnHull, ReflexEdge, SeveralShells};
    let plain = cube_mesh();
    let without = |side: usize| {
        let mut at = 0..;
        let keep = plain.facets.iter().filter(|_| at.next() != Some(side));
        mesh_of(&plain, keep)
    };
    let flipped = with(plain.clone(), &[], |c| {
        let mut cycle = c.to_vec();
        if c == [0, 1, 3, 2] {
            cycle.reverse();
        }
        vec![cycle]
    });
    let t_junction = with(plain.clone(), &[[1, 0, 0]], |c| vec![split_edge(c, 0, 4)]);
    let twice = with(plain.clone(), &[], |c| vec![c.to_vec(), c.to_vec()]);
    let moved = |by: i64| {
        let mut both = plain.clone();
        let other = plain.points.iter().map(|p| p.plus(&Point3::from_i64([by, 0, 0])));
        both.points.extend(other.collect::<Vec<_>>());
        plain.facets.iter().for_each(|c| both.facets.push(&c.iter().map(|v| v + 8).collect::<Vec<_>>()));
        both
    };
    // One corner raised: the three sides around it are bent, or two of them with another one.
    let mut bent = plain.clone();
    bent.points[7] = Point3::from_i64([2, 2, 3]);
    let mut dented = fan_triangulated(&plain);
    dented.points[0] = Point3::from_i64([1, 1, 1]);
    let loose = with(plain.clone(), &[], |c| {
        if c == [0, 1, 3, 2] { vec![c.to_vec(), vec![0, 3]] } else { vec![c.to_vec()] }
    });
    check(vec![
        refused("nothing", mesh(&[], &[]), MeshError::Empty),
        refused("a side is missing", without(0), NotClosed(Defect::Border { edge: [1, 0], facet: 1 })),
        refused("a side is turned", flipped, NotClosed(Defect::Orientation { edge: [1, 0], facets: [0, 2] })),
        refused(
            "a vertex in one side of an edge",
            t_junction,
            NotClosed(Defect::Border { edge: [4, 0], facet: 4 }),
        ),
        refused("all sides twice", twice, NotClosed(Defect::NonManifoldEdge { edge: [0, 1], facets: 4 })),
        refused("two cubes apart", moved(5), SeveralShells { shells: 2, facets: [0, 6] }),
        refused("two cubes that overlap", moved(1), SeveralShells { shells: 2, facets: [0, 6] }),
        refused("two cubes at one place", moved(0), SeveralShells { shells: 2, facets: [0, 6] }),
        refused(
            "a bent side",
            bent,
            NonPlanar { facet: 5, vertex: 3, squared_distance: "4/5".parse().expect("a number") },
        ),
        refused("a dent", dented, ReflexEdge { edge: [0, 3], facets: [1, 0] }),
        refused("an edge beside sides", loose, LooseEdge { facet: 1 }),
        refused(
            "two segments",
            mesh(&[[0; 3], [1, 0, 0], [0, 1, 0]], &[&[0, 1], &[1, 2]]),
            MeshError::ScatteredEdges { facet: 1 },
        ),
        refused("pentagram", pentagram(), NotOnHull { facet: 0 }),
        refused("pentagram prism", star_prism(), NotOnHull { facet: 0 }),
        refused("pentagram bipyramid", star_bipyramid(false), NotOnHull { facet: 0 }),
        refused("bipyramid wound twice", star_bipyramid(true), NotOnHull { facet: 0 }),
    ]);
}

fn mesh_of<'a>(plain: &PolygonMesh, cycles: impl Iterator<Item = &'a [u32]>) -> PolygonMesh {
    let mut facets = Facets::new();
    cycles.for_each(|cycle| facets.push(cycle));
    PolygonMesh { points: plain.points.clone(), facets }
}

/// Five points in convex position, counterclockwise.
const PENTAGON: [[i64; 2]; 5] = [[5, 0], [2, 5], [-4, 3], [-4, -3], [2, -5]];

fn pentagon(height: i64) -> impl Iterator<Item = [i64; 3]> {
    PENTAGON.into_iter().map(move |[x, y]| [x, y, height])
}

/// One polygon that visits every other corner.
fn pentagram() -> PolygonMesh {
    mesh(&pentagon(0).collect::<Vec<_>>(), &[&[0, 2, 4, 1, 3]])
}

/// Every edge of it is convex.
fn star_prism() -> PolygonMesh {
    let points: Vec<_> = pentagon(0).chain(pentagon(3)).collect();
    let mut star = mesh(&points, &[&[3, 1, 4, 2, 0], &[5, 7, 9, 6, 8]]);
    for i in 0..5 {
        let j = (i + 2) % 5;
        star.facets.push(&[i, j, j + 5, i + 5]);
    }
    star
}

/// Locally convex everywhere but at the apices; winds around twice. With vertices of its own for the
/// second round if `doubled`: then over every other facet of the first one.
fn star_bipyramid(doubled: bool) -> PolygonMesh {
    let mut points: Vec<_> = pentagon(0).collect();
    let cycle: Vec<u32> = if doubled {
        points.extend(pentagon(0));
        (0..10).collect()
    } else {
        vec![0, 2, 4, 1, 3]
    };
    let (top, bottom) = (points.len() as u32, points.len() as u32 + 1);
    points.extend([[0, 0, 4], [0, 0, -4]]);
    let mut star = mesh(&points, &[]);
    for (i, &a) in cycle.iter().enumerate() {
        star.facets.push(&[a, cycle[(i + 1) % cycle.len()], top]);
    }
    for (i, &a) in cycle.iter().enumerate() {
        star.facets.push(&[cycle[(i + 1) % cycle.len()], a, bottom]);
    }
    star
}

#[test]
fn lower_dimensions() {
    let square = hull(&[[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]);
    let corners = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 0, 0]];
    let part = |n: usize| &corners[..n];
    let up = hull(&[[0, 0, 0], [0, 0, 3]]);
    let one = hull(&[[1, 2, 3]]);
    let flat = |dimension| Note::Flat { dimension };
    let joined = |from, to| Note::Joined { from, to };
    let tetrahedron: [&[u32]; 4] = [&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]];
    check(vec![
        mended("one point", mesh(&[[1, 2, 3]], &[]), &one, &[Note::PointSet]),
        mended("a point again and again", mesh(&[[1, 2, 3]; 4], &[]), &one, &[Note::PointSet]),
        mended("points on a line", mesh(&[[0, 0, 1], [0, 0, 0], [0, 0, 3]], &[]), &up, &[Note::PointSet]),
        mended("points in a plane", mesh(part(5), &[]), &square, &[Note::PointSet]),
        mended("points of a cube", mesh_of(&cube_mesh(), std::iter::empty()), &cube(), &[Note::PointSet]),
        mended("a segment", mesh(&[[0, 0, 0], [0, 0, 3]], &[&[1, 0]]), &up, &[]),
        mended("a segment without length", mesh(&[[1, 2, 3], [1, 2, 3]], &[&[1, 0]]), &one, &[]),
        mended("a polygon", mesh(part(4), &[&[0, 1, 2, 3]]), &square, &[]),
        mended("a polygon from behind", mesh(part(4), &[&[3, 2, 1, 0]]), &square, &[]),
        mended("a straight corner", mesh(part(5), &[&[0, 4, 1, 2, 3]]), &square, &[joined([5, 1], [4, 1])]),
        mended("an unused vertex", mesh(part(5), &[&[0, 1, 2, 3]]), &square, &[Note::Unused { vertices: 1 }]),
        mended("both sides", mesh(part(4), &[&[0, 1, 2, 3], &[3, 2, 1, 0]]), &square, &[flat(2)]),
        mended(
            "both sides in triangles",
            mesh(part(4), &[&[0, 1, 2], &[0, 2, 3], &[3, 2, 1], &[3, 1, 0]]),
            &square,
            &[flat(2)],
        ),
        mended(
            "both sides with a straight corner",
            mesh(part(5), &[&[0, 4, 1, 2, 3], &[3, 2, 1, 4, 0]]),
            &square,
            &[flat(2), joined([5, 2], [4, 1])],
        ),
        mended("a flat tetrahedron", mesh(part(4), &tetrahedron), &square, &[flat(2)]),
        mended(
            "a tetrahedron on a line",
            mesh(&[[0, 0, 0], [0, 0, 1], [0, 0, 3], [0, 0, 2]], &tetrahedron),
            &up,
            &[flat(1)],
        ),
        mended("a tetrahedron in a point", mesh(&[[1, 2, 3]; 4], &tetrahedron), &one, &[flat(0)]),
        refused(
            "a polygon that is not convex",
            mesh(&[[0, 0, 0], [3, 0, 0], [1, 1, 0], [0, 3, 0]], &[&[0, 1, 2, 3]]),
            MeshError::ReflexCorner { facet: 0, vertex: 2 },
        ),
        refused(
            "a polygon that crosses itself",
            mesh(part(4), &[&[0, 1, 3, 2]]),
            MeshError::NotOnHull { facet: 0 },
        ),
    ]);
}

/// A strip of nine unit squares that runs around an empty one; the last square lies over the first. It
/// has the area of its hull and is not convex.
#[test]
fn a_flat_strip_with_the_area_of_its_hull() {
    let corners = [[0, 0], [3, 0], [3, 3], [0, 3], [0, 0], [1, 0], [1, 2], [2, 2], [2, 1], [0, 1]]
        .map(|[x, y]| [x, y, 0]);
    let front: Vec<u32> = (0..10).collect();
    let back: Vec<u32> = (0..10).rev().collect();
    check(vec![
        refused("a strip", mesh(&corners, &[&front]), MeshError::ReflexCorner { facet: 0, vertex: 6 }),
        refused("both sides of a strip", mesh(&corners, &[&front, &back]), MeshError::NotOnHull { facet: 0 }),
    ]);
}

/// Facets of two vertices and no other are the segment that they make up, in any order and direction.
#[test]
fn edges_that_make_up_a_segment() {
    let points = [[0; 3], [1, 2, 3], [2, 4, 6], [3, 6, 9], [5, 10, 15]];
    type Row<'a> = (&'a str, &'a [&'a [u32]], Result<[i64; 3], MeshError>);
    let rows: [Row<'_>; 8] = [
        ("one", &[&[0, 1]], Ok([1, 2, 3])),
        ("one after the other", &[&[0, 1], &[1, 2]], Ok([2, 4, 6])),
        ("there and back", &[&[0, 2], &[2, 0]], Ok([2, 4, 6])),
        ("overlapping, in no order", &[&[3, 1], &[0, 2]], Ok([3, 6, 9])),
        ("one within another", &[&[0, 3], &[1, 2]], Ok([3, 6, 9])),
        ("a gap", &[&[0, 1], &[2, 3]], Err(MeshError::ScatteredEdges { facet: 1 })),
        ("a gap after a long one", &[&[3, 4], &[0, 2], &[0, 1]], Err(MeshError::ScatteredEdges { facet: 0 })),
        ("no such vertex", &[&[0, 1], &[1, 9]], Err(MeshError::NoSuchVertex { facet: 1, index: 9 })),
    ];
    for (name, facets, expected) in rows {
        let read = Polytope::from_mesh(&mesh(&points, facets), &mut Vec::new());
        match (read, expected) {
            (Ok(polytope), Ok(end)) => {
                assert_eq!(polytope.dimension(), 1, "{name}");
                let ends = [Point3::ORIGIN, Point3::from_i64(end)];
                assert!(ends.iter().all(|p| polytope.points().contains(p)), "{name}");
            }
            (Err(error), Err(expected)) => assert_eq!(error, expected, "{name}"),
            (read, expected) => panic!("{name}: {read:?} in place of {expected:?}"),
        }
    }
}
