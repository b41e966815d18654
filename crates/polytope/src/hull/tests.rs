//! Tests of the hull: a table of degenerate sets, an oracle by brute force, and what must hold for every
//! answer.
//!
//! All sets are written in small integers. An embedding turns them into points of some width and weight in a
//! way that keeps the hull, so that one expected answer serves all of them.

use std::collections::{BTreeMap, BTreeSet};

use exact::predicate::plane_side;
use exact::{Integer, Point3, Sign};

use super::{HullFacets, hull, hull_with};
use crate::facets::Facets;

type P = [i64; 3];

/// A hull by its vertices as written in the test, in a form that does not depend on the order of the input.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Shape {
    Empty,
    Point(P),
    /// The smaller end first.
    Segment([P; 2]),
    /// Beginning with the smallest vertex, then its smaller neighbour.
    Polygon(Vec<P>),
    /// Cycles, each beginning with its smallest vertex.
    Solid(BTreeSet<Vec<P>>),
}

impl Shape {
    /// Returns dimension, vertices, edges and facets.
    fn counts(&self) -> (i32, usize, usize, usize) {
        match self {
            Shape::Empty => (-1, 0, 0, 0),
            Shape::Point(_) => (0, 1, 0, 0),
            Shape::Segment(_) => (1, 2, 1, 0),
            Shape::Polygon(cycle) => (2, cycle.len(), cycle.len(), 1),
            Shape::Solid(cycles) => {
                let vertices: BTreeSet<&P> = cycles.iter().flatten().collect();
                (3, vertices.len(), cycles.iter().map(Vec::len).sum::<usize>() / 2, cycles.len())
            }
        }
    }
}

fn from_smallest(mut cycle: Vec<P>) -> Vec<P> {
    let start = (0..cycle.len()).min_by_key(|&i| cycle[i]).unwrap();
    cycle.rotate_left(start);
    cycle
}

fn unoriented(cycle: Vec<P>) -> Vec<P> {
    let mut cycle = from_smallest(cycle);
    if cycle[cycle.len() - 1] < cycle[1] {
        cycle[1..].reverse();
    }
    cycle
}

/// Splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    fn within(&mut self, range: i64) -> i64 {
        self.below(2 * range as u64 + 1) as i64 - range
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i as u64 + 1) as usize);
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Embedding {
    /// As written.
    Plain,
    /// Each point with a small weight of its own.
    Weights,
    /// Each point with a weight of more than 64 bits of its own.
    WideWeights,
    /// One odd weight of about 30 bits.
    SharedWeight,
    /// Moved so far that all points have the same approximation, while the coordinates still fit a word.
    FarAway,
    /// Coordinates of 1100 bits, beyond the range of f64.
    Huge,
    /// Coordinates of 1100 bits that differ in the last ones only.
    HugeAndFarAway,
}

impl Embedding {
    const ALL: [Embedding; 7] = [
        Embedding::Plain,
        Embedding::Weights,
        Embedding::WideWeights,
        Embedding::SharedWeight,
        Embedding::FarAway,
        Embedding::Huge,
        Embedding::HugeAndFarAway,
    ];

    fn embed(self, points: &[P]) -> Vec<Point3> {
        let huge = Integer::from(2).pow(1100);
        let far = |p: P, distance: &Integer| p.map(|x| &Integer::from(x) + distance);
        let weighted =
            |p: P, weight: Integer| Point3::new(p.map(|x| &Integer::from(x) * &weight), weight).unwrap();
        let with = |(i, &p): (usize, &P)| match self {
            Embedding::Plain => Point3::from_i64(p),
            Embedding::Weights => weighted(p, Integer::from(1 + (i as i64 * 7) % 11)),
            Embedding::WideWeights => weighted(p, Integer::from(3 + i as i64).pow(50)),
            Embedding::SharedWeight => {
                Point3::new(p.map(Integer::from), Integer::from(1_073_741_827)).unwrap()
            }
            Embedding::FarAway => Point3::from_i64(p.map(|x| x + (1 << 60))),
            Embedding::Huge => Point3::new(p.map(|x| &Integer::from(x) * &huge), Integer::from(1)).unwrap(),
            Embedding::HugeAndFarAway => Point3::new(far(p, &huge), Integer::from(1)).unwrap(),
        };
        points.iter().enumerate().map(with).collect()
    }
}

/// Sizes above which a cone is searched by halving: all cones, as usual, none.
const SCANNED: [usize; 3] = [2, super::SCANNED, usize::MAX];

/// Computes the hull in all ways, checks all that must hold for any answer, and returns its shape.
fn shape_of(points: &[P], embedding: Embedding) -> Shape {
    let embedded = embedding.embed(points);
    let shape = shape_with(points, &embedded, SCANNED[0]);
    for scanned in &SCANNED[1..] {
        assert_eq!(shape_with(points, &embedded, *scanned), shape, "{embedding:?}, {scanned}, {points:?}");
    }
    shape
}

fn shape_with(points: &[P], embedded: &[Point3], scanned: usize) -> Shape {
    let at = |i: u32| points[i as usize];
    match hull_with(embedded, scanned) {
        None => Shape::Empty,
        Some(HullFacets::Point(a)) => Shape::Point(at(a)),
        Some(HullFacets::Segment([a, b])) => Shape::Segment([at(a).min(at(b)), at(a).max(at(b))]),
        Some(HullFacets::Polygon(cycle)) => Shape::Polygon(unoriented(cycle.into_iter().map(at).collect())),
        Some(HullFacets::Solid(facets)) => {
            check_solid(embedded, &facets);
            let cycles = facets.iter().map(|cycle| from_smallest(cycle.iter().map(|&i| at(i)).collect()));
            Shape::Solid(cycles.collect())
        }
    }
}

/// Checks with the predicates: closed surface, Euler's relation, each vertex under one number, strictly
/// convex facets in different planes, and every point on the inner side or in the plane of every facet.
fn check_solid(points: &[Point3], facets: &Facets) {
    let mut facet_of_edge = BTreeMap::new();
    for (f, cycle) in facets.iter().enumerate() {
        assert!(cycle.len() >= 3, "facet {f} has {} vertices", cycle.len());
        for i in 0..cycle.len() {
            let edge = (cycle[i], cycle[(i + 1) % cycle.len()]);
            assert!(facet_of_edge.insert(edge, f).is_none(), "{edge:?} occurs twice");
        }
    }
    let vertices: BTreeSet<u32> = facet_of_edge.keys().map(|&(a, _)| a).collect();
    let edges = facet_of_edge.len() / 2;
    assert_eq!(vertices.len() + facets.len(), edges + 2, "Euler's relation");
    let canonical: BTreeSet<Point3> = vertices.iter().map(|&v| points[v as usize].clone()).collect();
    assert_eq!(canonical.len(), vertices.len(), "a vertex has two numbers");

    let at = |i: u32| &points[i as usize];
    for cycle in facets.iter() {
        let corner = |i: usize| at(cycle[i % cycle.len()]);
        let normal = corner(0).direction_to(corner(1)).cross(&corner(1).direction_to(corner(2)));
        assert!(!normal.is_zero());
        for i in 0..cycle.len() {
            // An edge and the normal span a plane with the rest of the facet strictly on one side.
            let inwards = normal.cross(&corner(i).direction_to(corner(i + 1)));
            assert_eq!(
                plane_side(&inwards, corner(i), corner(i + 2)),
                Sign::Positive,
                "facet not strictly convex"
            );
        }
        let corners: BTreeSet<u32> = cycle.iter().copied().collect();
        for p in points {
            assert_ne!(plane_side(&normal, corner(0), p), Sign::Positive, "a point outside");
        }
        for &v in vertices.difference(&corners) {
            assert_eq!(plane_side(&normal, corner(0), at(v)), Sign::Negative, "two facets in one plane");
        }
        for i in 0..cycle.len() {
            let edge = (cycle[(i + 1) % cycle.len()], cycle[i]);
            assert!(facet_of_edge.contains_key(&edge), "{edge:?} has no twin");
        }
    }
}

// --- The oracle: all planes through three points. -----------------------------------------------

fn sub(a: P, b: P) -> P {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: P, b: P) -> P {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: P, b: P) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn oracle(points: &[P]) -> Shape {
    let distinct: Vec<P> = points.iter().copied().collect::<BTreeSet<P>>().into_iter().collect();
    let [first, .., last] = distinct[..] else {
        return distinct.first().map_or(Shape::Empty, |&p| Shape::Point(p));
    };
    let is_on_line = |&p: &P| cross(sub(last, first), sub(p, first)) == [0; 3];
    if distinct.iter().all(is_on_line) {
        return Shape::Segment([first, last]);
    }
    let mut facets = BTreeSet::new();
    for &a in &distinct {
        for &b in &distinct {
            for &c in &distinct {
                let normal = cross(sub(b, a), sub(c, a));
                if normal == [0; 3] {
                    continue;
                }
                let heights = || distinct.iter().map(|&p| dot(normal, sub(p, a)));
                if heights().all(|h| h <= 0) {
                    let in_plane: Vec<P> =
                        distinct.iter().copied().filter(|&p| dot(normal, sub(p, a)) == 0).collect();
                    let cycle = facet_cycle(&in_plane, normal);
                    if in_plane.len() == distinct.len() {
                        return Shape::Polygon(unoriented(cycle));
                    }
                    facets.insert(from_smallest(cycle));
                }
            }
        }
    }
    Shape::Solid(facets)
}

/// Finds the edges among all pairs: the others are strictly to the left, or on the line between the two.
fn facet_cycle(points: &[P], normal: P) -> Vec<P> {
    let is_edge = |a: P, b: P| {
        a != b
            && points.iter().all(|&p| {
                let turn = dot(normal, cross(sub(b, a), sub(p, a)));
                turn > 0 || (turn == 0 && dot(sub(p, a), sub(p, b)) <= 0)
            })
    };
    let edges: BTreeMap<P, P> = points
        .iter()
        .flat_map(|&a| points.iter().filter(move |&&b| is_edge(a, b)).map(move |&b| (a, b)))
        .collect();
    let start = *edges.keys().next().unwrap();
    let mut cycle = vec![start];
    while edges[&cycle[cycle.len() - 1]] != start {
        cycle.push(edges[&cycle[cycle.len() - 1]]);
    }
    assert_eq!(cycle.len(), edges.len());
    cycle
}

// --- The table. ---------------------------------------------------------------------------------

/// All points of the grid 0..=n in each coordinate.
fn grid(n: i64) -> Vec<P> {
    (0..=n).flat_map(|x| (0..=n).flat_map(move |y| (0..=n).map(move |z| [x, y, z]))).collect()
}

fn octahedron(r: i64) -> Vec<P> {
    vec![[r, 0, 0], [-r, 0, 0], [0, r, 0], [0, -r, 0], [0, 0, r], [0, 0, -r]]
}

/// A convex polygon of n vertices in the plane z = height, tilted by z = height + slope * x.
fn parabola(n: i64, height: i64, slope: i64) -> Vec<P> {
    (0..n).map(|i| [i, i * i, height + slope * i]).collect()
}

fn joined<const N: usize>(parts: [Vec<P>; N]) -> Vec<P> {
    parts.concat()
}

fn repeated(points: Vec<P>, times: usize) -> Vec<P> {
    points.iter().copied().cycle().take(points.len() * times).collect()
}

/// Name, points, and the counts of the hull.
type Row = (&'static str, Vec<P>, (i32, usize, usize, usize));

fn table() -> Vec<Row> {
    let cube = || grid(1).into_iter().map(|p| p.map(|x| 4 * x)).collect::<Vec<P>>();
    let on_edges =
        || grid(4).into_iter().filter(|p| p.iter().filter(|&&x| x % 4 != 0).count() == 1).collect();
    let on_facets =
        || grid(4).into_iter().filter(|p| p.iter().filter(|&&x| x % 4 != 0).count() == 2).collect();
    let hexagon = |z| vec![[2, 0, z], [4, 0, z], [6, 2, z], [4, 4, z], [2, 4, z], [0, 2, z]];
    let hexagon_middles = |z| vec![[3, 0, z], [5, 1, z], [5, 3, z], [3, 4, z], [1, 3, z], [1, 1, z]];
    let line = |n| (0..n).map(|i| [1 + 2 * i, 2 - 3 * i, 5 * i]).collect::<Vec<P>>();
    let flat = |n| grid(n).into_iter().map(|[x, y, _]| [x + y, x - y, 3 * y]).collect::<Vec<P>>();
    vec![
        ("nothing", vec![], (-1, 0, 0, 0)),
        ("one point", vec![[3, 1, 4]], (0, 1, 0, 0)),
        ("all equal", repeated(vec![[3, -1, 4]], 50), (0, 1, 0, 0)),
        ("the origin, repeated", repeated(vec![[0; 3]], 3), (0, 1, 0, 0)),
        ("two points", vec![[0, 0, 0], [0, 0, -1]], (1, 2, 1, 0)),
        ("two points, repeated", repeated(vec![[1, 2, 3], [3, 2, 1]], 20), (1, 2, 1, 0)),
        ("collinear", line(20), (1, 2, 1, 0)),
        ("collinear, repeated", repeated(line(5), 5), (1, 2, 1, 0)),
        ("parallel to an axis", (0..9).map(|i| [7, 7, i * i]).collect(), (1, 2, 1, 0)),
        ("triangle", vec![[1, 0, 0], [0, 1, 0], [0, 0, 1]], (2, 3, 3, 1)),
        ("triangle with a point on an edge", vec![[0, 0, 0], [2, 0, 0], [4, 0, 0], [0, 4, 0]], (2, 3, 3, 1)),
        ("square with inner and edge points", flat(4), (2, 4, 4, 1)),
        ("square, repeated", repeated(flat(1), 4), (2, 4, 4, 1)),
        ("square upright in x", grid(3).into_iter().map(|[_, y, z]| [5, y, z]).collect(), (2, 4, 4, 1)),
        ("square upright in y", grid(3).into_iter().map(|[x, _, z]| [x, 5, z]).collect(), (2, 4, 4, 1)),
        ("parabola", parabola(200, 7, 0), (2, 200, 200, 1)),
        ("tilted parabola", parabola(200, 7, -3), (2, 200, 200, 1)),
        ("tetrahedron", vec![[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], (3, 4, 6, 4)),
        ("needle", vec![[0, 0, 0], [1000, 1, 0], [2000, 3, 1], [3000, 4, 2], [1500, 2, 1]], (3, 4, 6, 4)),
        ("cube", cube(), (3, 8, 12, 6)),
        ("cube, repeated", repeated(cube(), 6), (3, 8, 12, 6)),
        ("grid", grid(4), (3, 8, 12, 6)),
        ("edges of a cube", joined([on_edges(), cube()]), (3, 8, 12, 6)),
        ("edges without corners", on_edges(), (3, 24, 36, 14)),
        ("facets of a cube", joined([on_facets(), on_edges(), cube()]), (3, 8, 12, 6)),
        ("facets without edges", on_facets(), (3, 24, 48, 26)),
        ("octahedron", octahedron(2), (3, 6, 12, 8)),
        ("octahedron with its centre", joined([vec![[0; 3]], octahedron(2), vec![[0; 3]]]), (3, 6, 12, 8)),
        ("octahedra", joined([octahedron(1), octahedron(3), octahedron(2)]), (3, 6, 12, 8)),
        (
            "cuboctahedron",
            grid(2).into_iter().filter(|p| p.iter().filter(|&&x| x == 1).count() == 1).collect(),
            (3, 12, 24, 14),
        ),
        ("hexagonal prism", joined([hexagon(0), hexagon(5)]), (3, 12, 18, 8)),
        (
            "hexagonal prism with points on edges and in facets",
            joined([
                hexagon_middles(0),
                hexagon(5),
                hexagon_middles(5),
                hexagon(0),
                hexagon(2),
                hexagon_middles(3),
                vec![[3, 2, 0], [3, 2, 5], [3, 2, 1]],
            ]),
            (3, 12, 18, 8),
        ),
        (
            "pyramid",
            joined([hexagon_middles(0), vec![[3, 2, 9], [3, 2, 0], [3, 2, 4]], hexagon(0)]),
            (3, 7, 12, 7),
        ),
        ("bipyramid", joined([vec![[3, 2, 9]], hexagon(0), vec![[3, 2, -9]]]), (3, 8, 18, 12)),
        (
            "prism over a parabola",
            joined([parabola(60, 0, 0), parabola(60, 1, 0), parabola(60, 2, 0)]),
            (3, 120, 180, 62),
        ),
        ("moment curve", (0..40).map(|i: i64| [i, i * i, i * i * i]).collect(), (3, 40, 114, 76)),
    ]
}

#[test]
fn every_embedding_gives_every_row() {
    for (name, points, counts) in table() {
        let plain = shape_of(&points, Embedding::Plain);
        assert_eq!(plain.counts(), counts, "{name}");
        for embedding in Embedding::ALL {
            assert_eq!(shape_of(&points, embedding), plain, "{name}, {embedding:?}");
        }
    }
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    let mut random = Random(1);
    for (name, mut points, counts) in table() {
        let expected = shape_of(&points, Embedding::Plain);
        assert_eq!(expected.counts(), counts, "{name}");
        for round in 0..4 {
            random.shuffle(&mut points);
            assert_eq!(shape_of(&points, Embedding::Plain), expected, "{name}, round {round}");
        }
    }
}

#[test]
fn the_oracle_agrees_on_the_small_rows() {
    let mut count = 0;
    for (name, points, _) in table().into_iter().filter(|(_, points, _)| points.len() <= 130) {
        assert_eq!(shape_of(&points, Embedding::Plain), oracle(&points), "{name}");
        count += 1;
    }
    assert!(count >= 30, "{count} rows");
}

#[test]
#[expect(clippy::print_stderr, reason = "the suite reports what it met")]
fn random_small_sets_agree_with_the_oracle() {
    const CASES: u64 = 9_000;
    let mut met = [0; 5];
    let (mut merged, mut hidden) = (0, 0);
    for seed in 0..CASES {
        let mut random = Random(seed);
        let range = [1, 2, 5][(seed % 3) as usize];
        let count = 1 + random.below(12) as usize;
        let mut points: Vec<P> =
            (0..count).map(|_| [random.within(range), random.within(range), random.within(range)]).collect();
        // Each seventh set is pressed into a plane or a line, which is not one of the coordinate planes.
        if random.below(7) == 0 {
            let line = random.below(3) == 0;
            for p in &mut points {
                *p = if line {
                    [2 * p[0], p[0] + 1, -p[0]]
                } else {
                    [p[0] - p[1], p[1] + 2 * p[0], p[0] + p[1] + 4]
                };
            }
        }
        let expected = oracle(&points);
        let embedding = Embedding::ALL[(seed / 3 % 7) as usize];
        for embedding in [Embedding::Plain, embedding] {
            assert_eq!(shape_of(&points, embedding), expected, "seed {seed}, {embedding:?}, {points:?}");
        }
        random.shuffle(&mut points);
        assert_eq!(shape_of(&points, Embedding::Plain), expected, "seed {seed}, shuffled {points:?}");

        let (dimension, vertices, ..) = expected.counts();
        met[(dimension + 1) as usize] += 1;
        if let Shape::Solid(cycles) = &expected {
            merged += u32::from(cycles.iter().any(|cycle| cycle.len() > 3));
            hidden += u32::from(vertices < points.iter().collect::<BTreeSet<_>>().len());
        }
    }
    eprintln!(
        "dimensions -1 to 3: {met:?}; facets of more than 3 vertices: {merged}; inner points: {hidden}"
    );
    assert!(met[1..].iter().all(|&n| n >= 300), "{met:?}");
    assert!(merged >= 1000 && hidden >= 1000, "{merged}, {hidden}");
}

#[test]
fn points_near_a_sphere() {
    let mut random = Random(5);
    let mut points = Vec::new();
    while points.len() < 1500 {
        let p = [0; 3].map(|_| random.within(1 << 20));
        let length = (dot(p, p) as f64).sqrt();
        if (1000.0..f64::from(1 << 20)).contains(&length) {
            points.push(p.map(|x| (x as f64 / length * 1e9) as i64));
        }
    }
    let shape = shape_of(&points, Embedding::Plain);
    let (dimension, vertices, edges, facets) = shape.counts();
    assert_eq!((dimension, edges, facets), (3, 3 * vertices - 6, 2 * vertices - 4));
    assert!(vertices > 1490, "{vertices}");
    random.shuffle(&mut points);
    assert_eq!(shape_of(&points, Embedding::SharedWeight), shape);
}

#[test]
fn large_cones() {
    // Many points in few planes over a polygon of many vertices: a vertex among them has a large cone with
    // coplanar triangles in it, and leaves many points to distribute. Checked by what must hold, for each way
    // to search.
    let mut random = Random(11);
    for round in 0..12 {
        let rim: Vec<P> = parabola(50, 0, 0).into_iter().map(|p| p.map(|x| 64 * x)).collect();
        let on_chord = |random: &mut Random, height: i64| {
            let [a, b] = [0; 2].map(|_| rim[random.below(50) as usize]);
            let t = random.below(9) as i64;
            [0, 1, 2].map(|axis| (a[axis] * t + b[axis] * (8 - t)) / 8 + if axis == 2 { height } else { 0 })
        };
        let mut points: Vec<P> = (0..150).map(|i| on_chord(&mut random, 1 + i % 3 * (round % 4))).collect();
        points.extend(&rim);
        points.push([1600, 70_000, [-1, -100_000][round as usize % 2]]);
        random.shuffle(&mut points);
        for embedding in [Embedding::Plain, Embedding::FarAway] {
            assert_eq!(shape_of(&points, embedding).counts().0, 3, "round {round}");
        }
    }
}

#[test]
fn large_facets() {
    let n = 10_000;
    let prism = joined([parabola(n, 0, 0), parabola(n, 1, 0)]);
    let points = Embedding::Plain.embed(&prism);
    let Some(HullFacets::Solid(facets)) = hull(&points) else { panic!("a prism is a solid") };
    assert_eq!(facets.len(), n as usize + 2);
    assert_eq!(facets.iter().filter(|cycle| cycle.len() == n as usize).count(), 2);

    let wedge = Embedding::FarAway.embed(&joined([parabola(n, 0, 0), vec![[n / 2, n * n / 3, 1]]]));
    let Some(HullFacets::Solid(facets)) = hull(&wedge) else { panic!("a pyramid is a solid") };
    assert_eq!(facets.len(), n as usize + 1);
}
