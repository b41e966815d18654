//! Meshes of any shape, mended: what is done and noted, and what stays as it was.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

mod grids;
mod joins;
mod rows;

use exact::{Point3, Rational};
use splitstar_polytope::{Mended, Mending, Note, PolygonMesh};
use std::collections::{BTreeMap, BTreeSet};

const KEEP: Mending<'static> = Mending::new();
const JOIN: Mending<'static> = Mending::joining();

fn mend(mesh: &PolygonMesh, what: Mending<'_>) -> (Mended, Vec<Note>) {
    let mut notes = Vec::new();
    let mended = mesh.mended(what, &mut notes).unwrap_or_else(|error| panic!("{error}"));
    check_origins(mesh, &mended);
    (mended, notes)
}

fn check_origins(given: &PolygonMesh, mended: &Mended) {
    let Mended { mesh, holes, facet_origin, vertex_origin, .. } = mended;
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
