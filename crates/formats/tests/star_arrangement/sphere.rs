//! Arrangements on the sphere: what their texts hold.

use super::{comes_back, read, write};
use arrangement::Arrangement;
use arrangement::models::polycurve::PolycurveTraits;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::topology::Sphere;
use dcel::VertexId;
use exact::spherical::{Direction, GreatCircle};
use splitstar_formats::{StarArrangement, read_arrangement, read_numbered_arrangement, write_arrangement};

/// A curve of a test.
#[derive(Clone, Debug)]
pub(crate) enum Arc {
    /// The shorter way; nothing if the ends are equal or opposite.
    Short([i64; 3], [i64; 3]),
    /// Through the second point; nothing if that is not between the others.
    Via([i64; 3], [i64; 3], [i64; 3]),
    Circle([i64; 3]),
    /// Once around a normal, from a point that is a vertex; nothing if that is not on the circle.
    Full([i64; 3], [i64; 3]),
    Polyline(Vec<[i64; 3]>),
    Point([i64; 3]),
}

pub(crate) fn direction(p: [i64; 3]) -> Direction {
    Direction::from_i64(p).unwrap()
}

fn circle(normal: [i64; 3]) -> GreatCircle {
    GreatCircle::from_i64(normal).unwrap()
}

/// A curve; `None` if there is none, or if it is several.
fn geodesic(arc: &Arc) -> Option<Geodesic> {
    match arc {
        Arc::Short(p, q) => Geodesic::arc(direction(*p), direction(*q)).ok(),
        Arc::Via(p, r, q) => Geodesic::arc_via(direction(*p), &direction(*r), direction(*q)).ok(),
        Arc::Circle(n) => Some(Geodesic::circle(circle(*n))),
        Arc::Full(p, n) => Geodesic::arc_around(direction(*p), direction(*p), circle(*n)).ok(),
        Arc::Point(p) => Some(Geodesic::point(direction(*p))),
        Arc::Polyline(_) => None,
    }
}

/// The arcs of a polyline, but for those that have equal or opposite ends.
fn pieces(points: &[[i64; 3]]) -> Vec<Vec<Geodesic>> {
    let mut runs = vec![Vec::new()];
    for pair in points.windows(2) {
        match Geodesic::arc(direction(pair[0]), direction(pair[1])) {
            Ok(arc) => runs.last_mut().unwrap().push(arc),
            Err(_) => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

pub(crate) fn traits([x, y]: [i64; 2]) -> GeodesicTraits {
    GeodesicTraits::with_identification([x.into(), y.into()]).unwrap()
}

/// Arcs, circles and points; polylines as arcs of their own.
pub(crate) fn sphere(identification: [i64; 2], arcs: &[Arc]) -> StarArrangement {
    let curves = arcs.iter().flat_map(|arc| match arc {
        Arc::Polyline(points) => pieces(points).into_iter().flatten().collect(),
        arc => geodesic(arc).into_iter().collect::<Vec<_>>(),
    });
    let curves: Vec<Geodesic> = curves.collect();
    Arrangement::of_curves(traits(identification), Sphere, &curves).into()
}

/// All of them, polylines as chains.
pub(crate) fn chains(identification: [i64; 2], arcs: &[Arc]) -> StarArrangement {
    let traits = PolycurveTraits::new(traits(identification));
    let curves = arcs.iter().flat_map(|arc| match arc {
        Arc::Polyline(points) => pieces(points),
        arc => geodesic(arc).into_iter().map(|curve| vec![curve]).collect(),
    });
    let curves: Vec<_> = curves.map(|pieces| traits.make_polycurve_of(&pieces).unwrap()).collect();
    Arrangement::of_curves(traits, Sphere, &curves).into()
}

pub(crate) const IDENTIFICATIONS: [[i64; 2]; 6] = [[-1, 0], [1, 0], [0, 1], [1, 1], [-1, -1], [2, -1]];

fn lines<'a>(text: &'a str, keyword: &str) -> Vec<&'a str> {
    text.lines().filter(|line| line.split(' ').next() == Some(keyword)).collect()
}

/// The records of a kind, without keywords and numbers.
fn bodies<'a>(text: &'a str, keyword: &str) -> Vec<&'a str> {
    lines(text, keyword).into_iter().map(|line| line.splitn(3, ' ').nth(2).unwrap()).collect()
}

fn poles(text: &str) -> Vec<&str> {
    bodies(text, "vertex").into_iter().filter(|body| body.starts_with("0 0 ")).collect()
}

#[test]
fn the_empty_sphere_has_one_face() {
    for [x, y] in IDENTIFICATIONS {
        let text = comes_back(&sphere([x, y], &[]));
        assert_eq!(text, format!("star 1 arrangement\nsurface sphere {x} {y}\nface 0\nend\n"));
    }
    // Multiples are the same arc.
    let text = write(&read("star 1 arrangement\nsurface sphere 3/2 -0.75\nface 7\nend\n"));
    assert_eq!(lines(&text, "surface"), ["surface sphere 2 -1"]);
}

/// The planes in which a cube is its own mirror image.
fn mirrors() -> Vec<Arc> {
    let normals = [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [1, 1, 0],
        [1, -1, 0],
        [1, 0, 1],
        [1, 0, -1],
        [0, 1, 1],
        [0, 1, -1],
    ];
    normals.map(Arc::Circle).to_vec()
}

#[test]
fn the_mirror_circles_of_the_cube_come_back() {
    for identification in IDENTIFICATIONS {
        let mut circles = mirrors();
        let made = sphere(identification, &circles);
        let counts = made.counts();
        assert_eq!([counts.vertices, counts.edges, counts.faces], [26, 72, 48]);
        let text = comes_back(&made);
        assert_eq!(write(&chains(identification, &circles)), text);
        circles.reverse();
        let opposite = circles.iter().map(|arc| match arc {
            Arc::Circle(n) => Arc::Circle(n.map(|x| -x)),
            other => other.clone(),
        });
        assert_eq!(write(&sphere(identification, &opposite.collect::<Vec<_>>())), text);
        // Those through the poles are two curves each; of the others, each is one.
        let curves = lines(&text, "curve");
        assert_eq!(curves.iter().filter(|curve| curve.contains(" circle ")).count(), 5);
        assert_eq!(curves.len(), 5 + 2 * 4, "{text}");
    }
}

#[test]
fn a_pole_has_a_record_if_something_is_there() {
    let [south, north] = [[0, 0, -1], [0, 0, 1]];
    // What there is, and the lines of poles.
    let rows: [(&[Arc], &[&str]); 7] = [
        (&[Arc::Circle([0, 0, 1])], &[]),
        (&[Arc::Point(north)], &["0 0 1"]),
        (&[Arc::Point(south), Arc::Point(north)], &["0 0 -1", "0 0 1"]),
        (&[Arc::Short([1, 0, 0], north)], &["0 0 1"]),
        (&[Arc::Short([1, 0, 2], [0, 1, 2]), Arc::Short([1, 0, 2], [-1, 0, 2])], &["0 0 1 artificial"]),
        (&[Arc::Via(south, [0, 1, 0], north)], &["0 0 -1", "0 0 1"]),
        (&[Arc::Circle([1, 0, 0]), Arc::Circle([0, 1, 0])], &["0 0 -1", "0 0 1"]),
    ];
    for (arcs, expected) in rows {
        for identification in IDENTIFICATIONS {
            let text = comes_back(&sphere(identification, arcs));
            assert_eq!(poles(&text), expected, "{text}");
        }
    }
    // A circle that passes through both and has no vertex keeps one.
    let text = comes_back(&sphere([-1, 0], &[Arc::Circle([1, 0, 0])]));
    assert_eq!(lines(&text, "vertex").len(), 2);
    assert!(lines(&text, "vertex").iter().all(|line| line.ends_with(" artificial")), "{text}");
}

/// Nothing tells in which face a pole lies at which nothing is: it is found.
#[test]
fn poles_without_a_record_lie_in_the_faces_where_they_are() {
    let around_north = [[4, 0, 3], [0, 4, 3], [-4, 0, 3], [0, -4, 3], [4, 0, 3]];
    let rows: &[&[Arc]] = &[
        &[Arc::Circle([0, 0, 1])],
        &[Arc::Circle([1, 0, 2]), Arc::Circle([0, 1, 2])],
        &[Arc::Polyline(around_north.to_vec())],
        // Beside the identification arc, from both sides and along it.
        &[Arc::Polyline(around_north.to_vec()), Arc::Short([-1, 0, 0], [-1, 1, 5]), Arc::Point([-1, 0, 6])],
        &[Arc::Polyline(around_north.to_vec()), Arc::Short([-1, 0, 0], [-1, -1, 5])],
        &[Arc::Short([-1, 0, 1], [-1, 0, -1]), Arc::Circle([0, 1, 1])],
        &[Arc::Short([-1, 0, 0], [-1, 1, 5]), Arc::Short([-1, 0, 0], [-1, 1, 1]), Arc::Circle([1, 1, 9])],
        &[Arc::Short([-1, 0, 0], [-1, -1, 5]), Arc::Short([-1, 0, 0], [-1, -1, 1]), Arc::Circle([1, 1, 9])],
    ];
    for arcs in rows {
        for identification in IDENTIFICATIONS {
            let text = comes_back(&sphere(identification, arcs));
            assert_eq!(poles(&text), [""; 0], "{text}");
            comes_back(&chains(identification, arcs));
        }
    }
}

#[test]
fn curves_have_the_shortest_text() {
    let rows: [(&[Arc], &[&str]); 8] = [
        (&[Arc::Short([2, 0, 0], [0, 3, 3])], &["arc 1 0 0 0 1 1"]),
        (&[Arc::Short([0, 3, 3], [2, 0, 0])], &["arc 1 0 0 0 1 1"]),
        // Half a circle, and more.
        (&[Arc::Via([0, -1, 0], [1, 0, 0], [0, 1, 0])], &["arc 0 -1 0 0 1 0 around 0 0 1"]),
        (&[Arc::Via([-1, 1, 0], [1, 0, 0], [-1, -1, 0])], &["arc -1 -1 0 -1 1 0 around 0 0 1"]),
        // All around.
        (&[Arc::Circle([0, 0, -3])], &["circle 0 0 1"]),
        (&[Arc::Full([-1, 0, 0], [0, 1, 1])], &["circle 0 1 1"]),
        (&[Arc::Circle([0, 3, 0])], &["arc 0 0 -1 0 0 1 around 0 1 0", "arc 0 0 -1 0 0 1 around 0 -1 0"]),
        // Over the identification arc.
        (&[Arc::Short([-1, 1, 0], [-1, -1, 0])], &["arc -1 0 0 -1 -1 0", "arc -1 1 0 -1 0 0"]),
    ];
    for (arcs, expected) in rows {
        let text = comes_back(&sphere([-1, 0], arcs));
        let mut curves = bodies(&text, "curve");
        let mut expected = expected.to_vec();
        curves.sort_unstable();
        expected.sort_unstable();
        assert_eq!(curves, expected, "{text}");
        assert_eq!(write(&chains([-1, 0], arcs)), text);
    }
}

#[test]
fn chains_bend_between_vertices() {
    let bent = Arc::Polyline(vec![[1, 0, 0], [1, 1, 1], [0, 1, 0], [-1, 2, 0]]);
    let text = comes_back(&chains([-1, 0], std::slice::from_ref(&bent)));
    assert_eq!(lines(&text, "curve"), ["curve 0 polyline 1 0 0 1 1 1 0 1 0 -1 2 0"]);
    // A vertex where it is straight, and one where it bends.
    let text = comes_back(&chains([-1, 0], &[bent.clone(), Arc::Short([1, 1, -1], [1, 1, 1])]));
    assert_eq!(
        lines(&text, "curve"),
        ["curve 0 arc 1 0 0 1 1 1", "curve 1 arc 1 1 -1 1 1 1", "curve 2 polyline 1 1 1 0 1 0 -1 2 0"]
    );
    let straight = comes_back(&chains([-1, 0], &[bent, Arc::Point([-1, 3, 0]), Arc::Point([-1, 1, 9])]));
    assert_eq!(lines(&straight, "curve"), ["curve 0 polyline 1 0 0 1 1 1 0 1 0 -1 2 0"]);
    // A piece that is longer than half a circle.
    let long = "star 1 arrangement\nsurface sphere -1 0\n\
                curve 0 polyline -1 -1 0 -1 1 0 around 0 0 1 -3 1 1\n\
                vertex 0 -1 -1 0\nvertex 1 -3 1 1\nedge 0 0 1 curve 0\nface 0\ninner -0 +0\nend\n";
    assert_eq!(comes_back(&read(long)), long);
    assert!(matches!(read(long), StarArrangement::SpherePolycurves(_)));
}

/// The pole where the meridian begins was taken for a point left of the chain, and its first circle was crossed with the meridian.
#[test]
fn a_meridian_from_a_pole_meets_the_right_piece_of_a_chain() {
    let chain = vec![[-1, -1, 1], [1, 0, 1], [1, 2, -2], [-1, 0, -2], [0, -1, 0]];
    let text = comes_back(&chains([2, -1], &[Arc::Polyline(chain), Arc::Circle([1, -2, 0])]));
    assert!(bodies(&text, "vertex").contains(&"4 2 1"), "{text}");
    assert!(!bodies(&text, "vertex").contains(&"2 1 0"), "{text}");
}

/// A ring of arcs has no vertex of its own, wherever it was begun.
#[test]
fn a_ring_has_one_text_wherever_it_begins() {
    let corners = [[3, 0, 1], [1, 1, 1], [0, 2, -1], [1, 0, -2], [2, -1, -1]];
    for identification in IDENTIFICATIONS {
        let texts: Vec<String> = (0..corners.len())
            .map(|start| {
                let ring = (0..=corners.len()).map(|i| corners[(start + i) % corners.len()]).collect();
                comes_back(&chains(identification, &[Arc::Polyline(ring)]))
            })
            .collect();
        assert!(texts.iter().all(|text| *text == texts[0]), "{texts:?}");
        assert!(lines(&texts[0], "vertex").iter().all(|line| line.ends_with(" artificial")), "{}", texts[0]);
    }
}

#[test]
fn overlaps_do_not_show() {
    let [a, b] = [Arc::Short([1, 0, 0], [1, 2, 0]), Arc::Short([2, 1, 0], [0, 1, 0])];
    let texts = [vec![a.clone(), b.clone()], vec![b, a]].map(|arcs| comes_back(&sphere([-1, 0], &arcs)));
    assert_eq!(texts[0], texts[1]);
    assert_eq!(lines(&texts[0], "curve"), ["curve 0 arc 1 0 0 0 1 0"]);
    let along =
        [Arc::Short([-1, 0, -3], [-1, 0, 1]), Arc::Short([-1, 0, 0], [0, 0, 1]), Arc::Point([-1, 0, 0])];
    let text = comes_back(&sphere([-1, 0], &along));
    assert_eq!(lines(&text, "curve"), ["curve 0 arc -1 0 -3 0 0 1"]);
}

#[test]
fn crossings_are_crossings_again() {
    let arcs = [
        Arc::Short([500_000, -200_001, 100_000], [300_000, 700_000, 200_003]),
        Arc::Short([500_000, -200_003, 300_001], [300_000, 700_003, -200_000]),
        Arc::Short([300_000, -400_003, 3_000_001], [300_000, 700_003, -2_000_000]),
    ];
    let StarArrangement::Sphere(made) = sphere([-1, 0], &arcs) else { panic!("arcs") };
    let StarArrangement::Sphere(again) = read_arrangement(&write_arrangement(&made), None).unwrap() else {
        panic!("arcs")
    };
    let explicit = [&made, &again].map(|arrangement| {
        let points = arrangement.vertices().filter_map(|v| arrangement.point(v));
        points.filter(|point| point.is_explicit()).count()
    });
    assert_eq!((made.counts().vertices, explicit), (9, [6, 6]));
}

#[test]
fn cells_have_the_numbers_of_the_file() {
    let text = "star 1 arrangement\nsurface sphere -1 0\ncurve 4 arc 0 0 -1 1 0 1\n\
                vertex 3 1 0 1\nvertex 5 0 0 2\nvertex 8 0 1 1\nvertex 9 0 0 -1/2\n\
                edge 6 9 3 curve 4\nface 2\nouter -6 +6\nisolated 8\nisolated 5\nend\n";
    let (arrangement, numbers) = read_numbered_arrangement(text.as_bytes(), None).unwrap();
    let StarArrangement::Sphere(arrangement) = arrangement else { panic!("arcs") };
    let named = arrangement.vertices().map(|v| {
        let point = arrangement.point(v).unwrap().to_string();
        (numbers.vertex(v).unwrap(), point)
    });
    let mut named: Vec<_> = named.collect();
    named.sort();
    let expected = [(3, "(1, 0, 1)"), (5, "(0, 0, 1)"), (8, "(0, 1, 1)"), (9, "(0, 0, -1)")];
    assert_eq!(named, expected.map(|(number, point)| (number, point.to_string())));
    assert_eq!([0, 1].map(|v| numbers.vertex(VertexId(v))), [Some(9), Some(5)]);
    assert_eq!(numbers.edge(arrangement.dcel().edges().next().unwrap()), 6);
    assert_eq!(numbers.face(arrangement.corner_face()), 2);
    let (_, numbers) =
        read_numbered_arrangement(text.replace("vertex 5 0 0 2", "vertex 5 0 1 2").as_bytes(), None).unwrap();
    assert_eq!(
        [0, 1, 2, 3, 4].map(|v| numbers.vertex(VertexId(v))),
        [Some(9), None, Some(3), Some(5), Some(8)]
    );
}
