//! Meshes of any shape, mended: what is done and noted, and what stays as it was.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Point3, Rational, Vector3};
use splitstar_polytope::{
    Facets, Mended, Mending, MeshError, MeshSummary, Note, PolygonMesh, triangulate_with_holes,
};
use std::collections::{BTreeMap, BTreeSet};
use testkit::{Rng, cube_mesh, fan_triangulated, mesh, model_mesh, model_names, random_rotation, soup};

const KEEP: Mending = Mending { join: false };
const JOIN: Mending = Mending { join: true };

fn mend(mesh: &PolygonMesh, what: Mending) -> (Mended, Vec<Note>) {
    let mut notes = Vec::new();
    let mended = mesh.mended(what, &mut notes).unwrap_or_else(|error| panic!("{error}"));
    check_origins(mesh, &mended);
    (mended, notes)
}

fn check_origins(given: &PolygonMesh, mended: &Mended) {
    let Mended { mesh, holes, facet_origin, vertex_origin } = mended;
    assert_eq!([facet_origin.len(), vertex_origin.len()], [mesh.facets.len(), mesh.points.len()]);
    assert!(facet_origin.iter().all(|&f| (f as usize) < given.facets.len()));
    for (point, &origin) in mesh.points.iter().zip(vertex_origin) {
        assert_eq!(*point, given.points[origin as usize]);
    }
    assert!(vertex_origin.is_sorted() && facet_origin.is_sorted(), "the order stays");
    assert!(holes.is_sorted_by_key(|hole| hole.facet));
    assert_eq!((0..mesh.facets.len()).map(|f| mended.holes_of(f).len()).sum::<usize>(), holes.len());
    if !mesh.facets.is_empty() {
        let used: BTreeSet<u32> = cycles(mended).into_iter().flatten().copied().collect();
        assert_eq!(used.len(), mesh.points.len(), "every vertex is used");
    }
}

/// All cycles, outer ones and holes.
fn cycles(mended: &Mended) -> Vec<&[u32]> {
    mended.mesh.facets.iter().chain(mended.holes.iter().map(|hole| &hole.cycle[..])).collect()
}

/// Six times the signed volume, by fans: holes count with their own sign.
fn volume(points: &[Point3], cycles: &[&[u32]]) -> Rational {
    let at = |v: u32| points[v as usize].coordinates();
    let mut sum = Rational::from(0);
    for cycle in cycles {
        for pair in cycle[1..].windows(2) {
            let [a, b, c] = [cycle[0], pair[0], pair[1]].map(at);
            let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
            sum = sum + &a[0] * &minor(1, 2) + &a[1] * &minor(2, 0) + &a[2] * &minor(0, 1);
        }
    }
    sum
}

/// The sum of the cross products of the fans of the facets in each direction: what each plane is covered by.
fn areas(points: &[Point3], cycles: &[&[u32]]) -> BTreeMap<String, String> {
    let mut sums: BTreeMap<String, [Rational; 3]> = BTreeMap::new();
    for cycle in cycles {
        let mut sum: [Rational; 3] = Default::default();
        for pair in cycle[1..].windows(2) {
            let [a, b, c] = [cycle[0], pair[0], pair[1]].map(|v| points[v as usize].coordinates());
            let (p, q): ([Rational; 3], [Rational; 3]) =
                (std::array::from_fn(|i| &b[i] - &a[i]), std::array::from_fn(|i| &c[i] - &a[i]));
            for (i, total) in sum.iter_mut().enumerate() {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                *total = total.clone() + &p[j] * &q[k] - &p[k] * &q[j];
            }
        }
        let normal = Point3::ORIGIN.direction_to(&Point3::from_rationals(&sum)).primitive();
        if normal.is_zero() {
            continue;
        }
        // A plane is known by its normal and height, but a hole has the opposite normal.
        let height = (0..3).fold(Rational::from(0), |h, i| {
            h + points[cycle[0] as usize].coordinate(i) * Rational::from(normal.coordinate(i))
        });
        let flipped = (0..3).map(|i| normal.sign(i)).find(|s| !s.is_zero()) == Some(exact::Sign::Negative);
        let (normal, height) = if flipped { (-normal, -height) } else { (normal, height) };
        let total = sums.entry(format!("{:?} {height}", normal.coordinates())).or_default();
        for (total, part) in total.iter_mut().zip(sum) {
            *total = total.clone() + part;
        }
    }
    let text = |sum: [Rational; 3]| sum.map(|c| c.to_string()).join(" ");
    sums.into_iter().map(|(plane, sum)| (plane, text(sum))).filter(|(_, sum)| sum != "0 0 0").collect()
}

/// The edges with a surplus of facets in one direction.
fn borders(cycles: &[&[u32]]) -> usize {
    let mut count: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for cycle in cycles {
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            *count.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    count.values().filter(|count| **count != 0).count()
}

fn plain(mesh: &PolygonMesh) -> Vec<&[u32]> {
    mesh.facets.iter().collect()
}

/// What holds of every joined mesh. Gives the mesh without holes, in triangles.
fn check_joined(name: &str, given: &PolygonMesh, joined: &Mended) -> PolygonMesh {
    let points = &joined.mesh.points;
    let all = cycles(joined);
    assert_eq!(volume(points, &all), volume(&given.points, &plain(given)), "{name}: volume");
    assert_eq!(areas(points, &all), areas(&given.points, &plain(given)), "{name}: areas");
    let mut notes = Vec::new();
    let cut =
        joined.clone().without_holes().unwrap_or_else(|(f, error)| panic!("{name}: facet {f}: {error}"));
    let triangles = cut.mesh.triangulated().unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(borders(&plain(&triangles)), borders(&all), "{name}: borders");
    assert_eq!(volume(points, &plain(&triangles)), volume(points, &all), "{name}: triangles");
    assert_eq!(areas(points, &plain(&triangles)), areas(points, &all), "{name}: triangles");
    // Joined again, the same cells are found, in any mesh of them.
    for again in [&cut.mesh, &triangles] {
        let second = again.mended(JOIN, &mut notes).expect("what was mended is mended");
        let counts =
            |mended: &Mended| [mended.mesh.points.len(), mended.mesh.facets.len(), mended.holes.len()];
        assert_eq!(counts(&second), counts(joined), "{name}: joined again");
    }
    triangles
}

fn inside_out(mesh: &PolygonMesh) -> PolygonMesh {
    let mut mesh = mesh.clone();
    mesh.facets.reverse();
    mesh
}

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
type Row = (&'static str, PolygonMesh, Mending, [usize; 3], &'static [&'static str]);

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
            &["coplanar facets and collinear edges joined: 1 facets and 7 vertices became 1 and 6"],
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
            &["coplanar facets and collinear edges joined: 1 facets and 5 vertices became 1 and 4"],
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
            &["coplanar facets and collinear edges joined: 1 facets and 13 vertices became 2 and 13"],
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

/// Vertices of one facet on an edge of another, and facets without area there: they go, in whatever way they are cut.
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

/// The boundary of cells of a grid, in squares or triangles, with one vertex for each place.
fn cells(rng: &mut Rng, size: i64, odds: u64, cut: bool) -> PolygonMesh {
    let mut filled = BTreeSet::new();
    for x in 0..size {
        for y in 0..size {
            filled.extend((0..size).map(|z| [x, y, z]).filter(|_| rng.below(100) < odds));
        }
    }
    let mut index: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let (mut points, mut facets) = (Vec::new(), Facets::new());
    for &cell in &filled {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beyond = cell;
                beyond[axis] += 2 * side - 1;
                if filled.contains(&beyond) {
                    continue;
                }
                let corner = |u: i64, v: i64| {
                    let mut at = cell;
                    at[axis] += side;
                    at[(axis + 1) % 3] += u;
                    at[(axis + 2) % 3] += v;
                    at
                };
                let mut square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                if side == 0 {
                    square.reverse();
                }
                let mut cycle = square.map(|at| {
                    *index.entry(at).or_insert_with(|| {
                        points.push(Point3::from_i64(at));
                        points.len() as u32 - 1
                    })
                });
                let turn = rng.below(4) as usize;
                cycle.rotate_left(turn);
                let [a, b, c, d] = cycle;
                if cut && rng.one_in(2) {
                    facets.push(&[a, b, c]);
                    facets.push(&[a, c, d]);
                } else {
                    facets.push(&cycle);
                }
            }
        }
    }
    PolygonMesh { points, facets }
}

/// The number of facets that cells must have: squares of one plane and side that have an edge in common, of which there
/// are no other facets.
fn facets_of_cells(mesh: &PolygonMesh) -> usize {
    let normal = |f: usize| -> (Vec<String>, String) {
        let [a, b, c] = [0, 1, 2].map(|i| &mesh.points[mesh.facets.get(f)[i] as usize]);
        let normal: Vector3 = a.direction_to(b).cross(&a.direction_to(c));
        let axis = (0..3).find(|&axis| !normal.sign(axis).is_zero()).expect("a square has a normal");
        let sides = (0..3).map(|axis| format!("{:?}", normal.sign(axis))).collect();
        (sides, a.coordinate(axis).to_string())
    };
    let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (f, cycle) in mesh.facets.iter().enumerate() {
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            edges.entry([a.min(b), a.max(b)]).or_default().push(f);
        }
    }
    let mut group: Vec<usize> = (0..mesh.facets.len()).collect();
    let mut count = group.len();
    for facets in edges.values() {
        if let &[f, g] = &facets[..]
            && normal(f) == normal(g)
            && group[f] != group[g]
        {
            let (keep, gone) = (group[f], group[g]);
            group.iter_mut().filter(|g| **g == gone).for_each(|g| *g = keep);
            count -= 1;
        }
    }
    count
}

fn shuffled(rng: &mut Rng, mesh: &PolygonMesh) -> PolygonMesh {
    let mut order: Vec<usize> = (0..mesh.points.len()).collect();
    rng.shuffle(&mut order);
    let mut label = vec![0; order.len()];
    (0..).zip(&order).for_each(|(new, &old)| label[old] = new);
    let mut cycles: Vec<Vec<u32>> = mesh.facets.iter().map(<[u32]>::to_vec).collect();
    rng.shuffle(&mut cycles);
    let mut facets = Facets::new();
    for cycle in &mut cycles {
        let turn = rng.below(cycle.len() as u64) as usize;
        cycle.rotate_left(turn);
        facets.push(cycle);
    }
    facets.relabel(&label);
    PolygonMesh { points: order.iter().map(|&v| mesh.points[v].clone()).collect(), facets }
}

/// Cells of a grid have everything: facets with holes and with islands in them, edges of four facets, vertices
/// where cells touch.
#[test]
fn cells_of_grids() {
    const SEED: u64 = 0x3e4d_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let (mut holes, mut joins) = (0, 0);
    for case in 0..400 {
        let (size, odds, cut) = (2 + case % 4, 20 + rng.below(75), case % 3 > 0);
        let given = cells(&mut rng, size, odds, cut);
        if given.facets.is_empty() {
            continue;
        }
        let name = format!("case {case}");
        let (joined, notes) = mend(&given, JOIN);
        check_joined(&name, &given, &joined);
        assert_eq!(borders(&cycles(&joined)), 0, "{name}");
        assert_eq!(joined.mesh.facets.len(), facets_of_cells(&given), "{name}");
        // Cycles are simple.
        for cycle in cycles(&joined) {
            assert_eq!(cycle.iter().collect::<BTreeSet<_>>().len(), cycle.len(), "{name}: {cycle:?}");
        }
        assert!(!notes.contains(&Note::TurnedInsideOut), "{name}");
        // In another order, turned inside out, as a soup, and turned in space.
        let map = random_rotation(&mut rng, 3);
        let moved = shuffled(&mut rng, &inside_out(&soup(&given))).transformed(&map);
        let (other, notes) = mend(&moved, JOIN);
        assert!(notes.contains(&Note::TurnedInsideOut), "{name}");
        let outline = |mended: &Mended| -> BTreeSet<Vec<String>> {
            let of = |cycle: &[u32]| {
                let names: Vec<String> =
                    cycle.iter().map(|&v| mended.mesh.points[v as usize].to_string()).collect();
                let least = (0..names.len()).min_by_key(|&i| &names[i]).expect("a cycle has corners");
                [&names[least..], &names[..least]].concat()
            };
            cycles(mended).into_iter().map(of).collect()
        };
        let mut expected = joined.clone();
        expected.mesh = expected.mesh.transformed(&map);
        assert_eq!(outline(&other), outline(&expected), "{name}: moved");
        holes += joined.holes.len();
        joins += given.facets.len() - joined.mesh.facets.len();
    }
    println!("{holes} holes, {joins} facets joined");
    assert!(holes > 200 && joins > 5000, "{holes} holes, {joins} facets joined");
}

/// Any facets over few points are mended or refused, and joining is no worse than that.
#[test]
fn any_facets() {
    const SEED: u64 = 0x3e4d_0002;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut mended = 0;
    for case in 0..20_000 {
        let points: Vec<[i64; 3]> = (0..3 + rng.below(6))
            .map(|_| [0, 1, 2].map(|axis| rng.below([3, 3, case % 3 + 1][axis]) as i64))
            .collect();
        let mut given = mesh(&points, &[]);
        for _ in 0..1 + rng.below(6) {
            let cycle: Vec<u32> =
                (0..3 + rng.below(3)).map(|_| rng.below(points.len() as u64) as u32).collect();
            given.facets.push(&cycle);
        }
        for what in [KEEP, JOIN] {
            let mut notes = Vec::new();
            let Ok(result) = given.mended(what, &mut notes) else { continue };
            check_origins(&given, &result);
            let before = borders(&plain(&given.mended(KEEP, &mut Vec::new()).expect("mended before").mesh));
            if before == 0 && !result.mesh.facets.is_empty() {
                assert_eq!(borders(&cycles(&result)), 0, "case {case}: {given:?} {result:?}");
            }
            for f in 0..result.mesh.facets.len() {
                let holes: Vec<&[u32]> = result.holes_of(f).iter().map(|hole| &hole.cycle[..]).collect();
                let _ = triangulate_with_holes(&result.mesh.points, result.mesh.facets.get(f), &holes);
            }
            mended += 1;
        }
        let _ = MeshSummary::of(&given);
    }
    assert!(mended > 5000, "{mended} mended");
}
