//! Polylines on a flat torus, against the same paths without chains. Periods and coordinates are so small that sides and corners
//! are met all the time.

use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::{Polycurve, PolycurveError, PolycurveTraits};
use splitstar_arrangement::models::{TorusSegment, TorusSegmentTraits};
use splitstar_arrangement::overlay::overlay_all;
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::{ArrangementTraits, DirectionalTraits, Piece};
use splitstar_arrangement::{Arrangement, Counts, Pieces};
use testkit::Rng;

type Vertices = Vec<[i64; 2]>;
type Made = Arrangement<PolycurveTraits<TorusSegmentTraits>, FlatTorus>;

fn p([u, v]: [i64; 2]) -> Point2 {
    Point2::from_i64([u, v])
}

fn torus([u, v]: [i64; 2]) -> TorusSegmentTraits {
    TorusSegmentTraits::new([u.into(), v.into()]).unwrap()
}

fn polyline(
    traits: &PolycurveTraits<TorusSegmentTraits>,
    vertices: &Vertices,
) -> Polycurve<Point2, TorusSegment> {
    traits.make_cover_polyline(vertices.iter().copied().map(p)).unwrap()
}

fn arrangement(period: [i64; 2], polylines: &[Vertices]) -> Made {
    let traits = PolycurveTraits::new(torus(period));
    let curves: Vec<_> = polylines.iter().map(|vertices| polyline(&traits, vertices)).collect();
    Arrangement::of_curves(traits, FlatTorus, &curves)
}

/// Whether a path that moves by `b` returns upon one that moves by `a`.
fn turns_back(a: [i64; 2], b: [i64; 2]) -> bool {
    a[0] * b[1] == a[1] * b[0] && a[0] * b[0] + a[1] * b[1] < 0
}

/// The paths between vertices as they are without chains. Joints are artificial, unless the polyline returns upon itself.
fn paths(traits: &TorusSegmentTraits, vertices: &Vertices, pieces: &mut Pieces<TorusSegmentTraits>) {
    let mut corners = vertices.clone();
    corners.dedup();
    let ways: Vec<[i64; 2]> = corners.windows(2).map(|w| [0, 1].map(|i| w[1][i] - w[0][i])).collect();
    let count = ways.len();
    if count == 0 {
        pieces.push_point(traits.point(&p(corners[0])));
        return;
    }
    let is_closed = count > 1 && traits.point(&p(corners[0])) == traits.point(&p(corners[count]));
    let is_joint = |i: usize| {
        (i > 0 && i < count || is_closed) && !turns_back(ways[(i + count - 1) % count], ways[i % count])
    };
    for (i, way) in ways.iter().enumerate() {
        let mut cut = Vec::new();
        traits.make_u_monotone(&traits.path(&p(corners[i]), &way.map(Rational::from)).unwrap(), &mut cut);
        let last = cut.len() - 1;
        for (number, piece) in cut.into_iter().enumerate() {
            let Piece::Curve { curve, mut is_artificial } = piece else { panic!("the vertices differ") };
            let [source, target] = if traits.is_directed_right(&curve) { [0, 1] } else { [1, 0] };
            is_artificial[source] |= number == 0 && is_joint(i);
            is_artificial[target] |= number == last && is_joint(i + 1);
            pieces.push_piece(curve, is_artificial);
        }
    }
}

fn counts_of_paths(period: [i64; 2], polylines: &[Vertices]) -> Counts {
    let traits = torus(period);
    let mut pieces = Pieces::new();
    polylines.iter().for_each(|vertices| paths(&traits, vertices, &mut pieces));
    Arrangement::of_pieces(traits, FlatTorus, pieces).counts()
}

fn seen(arrangement: &Made) -> [usize; 3] {
    let counts = arrangement.counts();
    [counts.vertices, counts.edges, counts.faces]
}

fn vertices_of(text: &str) -> Vertices {
    let numbers: Vec<i64> = text.split_whitespace().map(|word| word.parse().unwrap()).collect();
    numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// Periods 6 and 5.
#[test]
fn polylines_with_known_answers() {
    let rows: &[(&str, &[&str], [usize; 3])] = &[
        ("a tip on the right side that was crossed", &["3 3 7 1 0 1"], [3, 3, 1]),
        ("onto a loop, and down it", &["3 1 1 6 1 0"], [3, 3, 1]),
        ("through a loop, and down it", &["-1 3 2 6 2 0"], [3, 3, 1]),
        ("a tip on the right side", &["3 3 6 3 4 3"], [3, 2, 1]),
        ("a tip on the left side", &["3 3 0 3 5 3"], [3, 2, 1]),
        ("a tip on the top side", &["3 3 3 5 3 4"], [3, 2, 1]),
        ("a tip on the bottom side", &["3 3 3 0 3 1"], [3, 2, 1]),
        ("a tip in a corner", &["3 3 6 5 3 3"], [2, 1, 1]),
        ("a tip along the left side, in a corner", &["0 3 0 0 0 1"], [3, 2, 1]),
        ("a tip along the right side, in a corner", &["6 3 6 5 6 4"], [3, 2, 1]),
        ("a tip along the top side", &["1 5 3 5 2 5"], [3, 2, 1]),
        ("a loop and back", &["2 0 2 5 2 3"], [2, 2, 1]),
        ("a loop, there and back", &["2 0 2 5 2 0"], [1, 1, 1]),
        ("a loop up in two paths", &["2 0 2 3 2 5"], [1, 1, 1]),
        ("a loop down in two paths, and on", &["2 5 2 3 2 0 4 2"], [2, 2, 1]),
        ("twice round", &["2 0 2 5 2 10"], [1, 1, 1]),
        ("round the left side and the bottom", &["0 0 6 0 6 5"], [1, 2, 1]),
        ("a corner on a side", &["3 3 6 4 9 3"], [1, 1, 1]),
        ("turned back at a side", &["3 3 6 4 3 5"], [2, 1, 1]),
        ("a polygon round a corner", &["5 4 7 4 7 6 5 6 5 4"], [1, 1, 2]),
        ("a point", &["7 -1 7 -1"], [1, 0, 1]),
        ("one path round", &["1 1 7 1"], [1, 1, 1]),
    ];
    for (name, texts, expected) in rows {
        let polylines: Vec<Vertices> = texts.iter().map(|text| vertices_of(text)).collect();
        let made = arrangement([6, 5], &polylines);
        assert!(made.check_valid().is_empty(), "{name}: {:?}", made.check_valid());
        assert_eq!(made.counts(), counts_of_paths([6, 5], &polylines), "{name}: the paths");
        assert_eq!(&seen(&made), expected, "{name}");
    }
}

/// Few coordinates, so that most vertices are on sides, and many paths run along them or once round.
fn random_polyline(rng: &mut Rng, period: [i64; 2], size: i64) -> Vertices {
    let count = 2 + rng.index(5);
    let on_sides = rng.one_in(3);
    let mut vertices: Vertices = (0..count)
        .map(|_| {
            [0, 1].map(|i| match on_sides && rng.one_in(2) {
                true => rng.within(2) * period[i],
                false => rng.within(size),
            })
        })
        .collect();
    for i in 1..vertices.len() {
        match rng.below(5) {
            0 => vertices[i][0] = vertices[i - 1][0],
            1 => vertices[i][1] = vertices[i - 1][1],
            2 if i > 1 => vertices[i] = vertices[i - 2],
            _ => {}
        }
    }
    if rng.one_in(4) {
        // It closes, perhaps in another copy of the rectangle.
        vertices.push([0, 1].map(|i| vertices[0][i] + rng.within(1) * period[i]));
    }
    vertices
}

fn fuzz(seed: u64, rounds: usize) {
    let mut rng = Rng::new(seed);
    for round in 0..rounds {
        let period = [1 + rng.below(6) as i64, 1 + rng.below(6) as i64];
        let count = 1 + rng.index(4);
        let size = 1 + rng.below(7) as i64;
        let polylines: Vec<Vertices> = (0..count).map(|_| random_polyline(&mut rng, period, size)).collect();
        let context = format!("seed {seed}, round {round}: periods {period:?}, {polylines:?}");
        let whole = arrangement(period, &polylines);
        let violations = whole.check_valid();
        assert!(violations.is_empty(), "{context}: {violations:?}");
        assert_eq!(whole.counts(), counts_of_paths(period, &polylines), "{context}");
        let (first, second) = polylines.split_at(rng.index(count + 1));
        let mut halves = arrangement(period, first);
        let traits = halves.traits().clone();
        let curves: Vec<_> = second.iter().map(|vertices| polyline(&traits, vertices)).collect();
        halves.insert_curves(&curves);
        assert!(halves.check_valid().is_empty(), "{context}: halves");
        assert!(halves.difference(&whole).is_none(), "{context}: halves, {:?}", halves.difference(&whole));
        let (overlay, _) = overlay_all(&[&arrangement(period, first), &arrangement(period, second)]);
        assert!(overlay.check_valid().is_empty(), "{context}: overlay");
        assert!(overlay.difference(&whole).is_none(), "{context}: overlay, {:?}", overlay.difference(&whole));
    }
}

#[test]
fn arrangements_on_a_torus_are_those_of_the_paths() {
    fuzz(2005, 400);
}

#[test]
fn what_is_closed_and_what_is_too_long() {
    let traits = PolycurveTraits::new(torus([6, 5]));
    let flags = |text: &str| {
        let made = polyline(&traits, &vertices_of(text));
        let ends = made.parts().iter().map(|part| match part {
            Piece::Curve { is_artificial, .. } => *is_artificial,
            Piece::Point(p) => panic!("a point {p}"),
        });
        (made.is_closed(), ends.collect::<Vec<_>>())
    };
    // A path from a point back to it has ends, two such paths in a row do not have.
    assert_eq!(flags("2 0 2 5"), (true, vec![[false; 2]]));
    assert_eq!(flags("2 0 2 5 2 10"), (true, vec![[true; 2]; 2]));
    assert_eq!(flags("2 5 2 0 2 5"), (true, vec![[false; 2]; 2]));
    assert_eq!(
        flags("2 1 2 6 2 0"),
        (false, vec![[false, true], [true, false], [true, false], [false, true]])
    );
    let make = |vertices: Vertices| traits.make_cover_polyline(vertices.into_iter().map(p)).map(|_| ());
    assert_eq!(make(vec![]), Err(PolycurveError::Empty));
    assert_eq!(make(vec![[0, 0], [1, 1], [1 << 40, 1]]), Err(PolycurveError::TooManyPieces));
    assert_eq!(
        PolycurveError::TooManyPieces.to_string(),
        "the polycurve winds round the torus so often that it is cut at more than 1048576 places"
    );
}
