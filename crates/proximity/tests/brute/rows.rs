//! Named cases with known answers: brute force must know them, and the library.

use crate::check::{Expected, Subject};
use crate::number::Number;
use crate::planes::{Brute, Place};
use exact::{Integer, Rational, Vector3};
use polytope::Polytope;
use splitstar_proximity::{Feature, Pair, RelativePlacement, Translation};
use testkit::{hull, segment};

pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) p: Polytope,
    pub(crate) q: Polytope,
    /// The translation of `q`, each coordinate over two.
    pub(crate) halves: [i64; 3],
    pub(crate) place: Place,
    /// The squared distance of disjoint polytopes, the squared penetration of overlapping ones, 0 of touching ones.
    pub(crate) squared: &'static str,
    /// How often `q` must be moved by (1, 2, 2) until interiors do not meet.
    pub(crate) along: &'static str,
}

pub(crate) const DIRECTION: [i64; 3] = [1, 2, 2];

/// The cube from 0 to 2.
fn cube() -> Polytope {
    hull(&[0, 1, 2, 3, 4, 5, 6, 7].map(|i| [2 * (i & 1), i & 2, (i & 4) >> 1]))
}

fn square() -> Polytope {
    hull(&[[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
}

fn point() -> Polytope {
    hull(&[[0, 0, 0]])
}

/// All rows.
pub(crate) fn rows() -> Vec<Row> {
    use Place::{Disjoint, Overlapping, Touching};
    let row = |name, [p, q]: [Polytope; 2], halves, place, squared, along| Row {
        name,
        p,
        q,
        halves,
        place,
        squared,
        along,
    };
    let cubes = || [cube(), cube()];
    let octahedron = || hull(&[[2, 0, 0], [-2, 0, 0], [0, 2, 0], [0, -2, 0], [0, 0, 2], [0, 0, -2]]);
    vec![
        row("the same place", cubes(), [0, 0, 0], Overlapping, "4", "1"),
        row(
            "an edge to an edge, crossing",
            [cube(), hull(&[[0, 0, 0], [0, 2, 0], [0, 2, 2], [1, 2, 1], [1, 0, 1]])],
            [-2, 2, 2],
            Touching,
            "0",
            "0",
        ),
        row("facet to facet, the same", cubes(), [4, 0, 0], Touching, "0", "0"),
        row("facet to facet, shifted", cubes(), [4, 1, -3], Touching, "0", "0"),
        row("facet to edge", cubes(), [4, 4, 0], Touching, "0", "0"),
        row("vertex to vertex", cubes(), [4, 4, 4], Touching, "0", "0"),
        row("vertex to vertex, from below", cubes(), [-4, -4, -4], Touching, "0", "0"),
        row("a vertex from a vertex", cubes(), [5, 6, 5], Disjoint, "3/2", "0"),
        row("a facet from a facet", cubes(), [1, -1, 7], Disjoint, "9/4", "0"),
        row("an edge from an edge, parallel", cubes(), [6, 1, 6], Disjoint, "2", "0"),
        row("half inside", cubes(), [2, 0, 0], Overlapping, "1", "1"),
        row("half inside, the other way", cubes(), [-2, 0, 0], Overlapping, "1", "1"),
        row("nearly through", cubes(), [0, 0, 3], Overlapping, "1/4", "1/4"),
        row("a vertex in a facet", [cube(), octahedron()], [8, 2, 2], Touching, "0", "0"),
        row("a vertex above a facet", [cube(), octahedron()], [9, 2, 2], Disjoint, "1/4", "0"),
        row("a facet above a vertex", [cube(), octahedron()], [6, 6, 6], Disjoint, "1/3", "0"),
        row("an edge beside an edge, crossing", [cube(), octahedron()], [8, 8, 2], Disjoint, "2", "0"),
        row("a segment inside of a cube", [cube(), segment([1, 0, 0])], [1, 2, 2], Overlapping, "1", "1/2"),
        row("a segment through a cube", [cube(), segment([8, 0, 0])], [-6, 2, 2], Overlapping, "1", "1/2"),
        row("a segment along an edge", [cube(), segment([1, 0, 0])], [1, 0, 0], Touching, "0", "0"),
        row("a segment in a facet", [cube(), segment([1, 0, 0])], [1, 1, 0], Touching, "0", "0"),
        row("a segment past a cube", [cube(), segment([0, 0, 9])], [-2, -2, -9], Disjoint, "2", "0"),
        row("a point in the middle", [cube(), point()], [2, 2, 2], Overlapping, "1", "1/2"),
        row("a point in a facet", [cube(), point()], [4, 1, 1], Touching, "0", "0"),
        row("a point on an edge", [cube(), point()], [4, 4, 1], Touching, "0", "0"),
        row("a point on a vertex", [cube(), point()], [4, 4, 4], Touching, "0", "0"),
        row("a point beside a cube", [point(), cube()], [1, 1, 1], Disjoint, "3/4", "0"),
        row("a cube around a point", [point(), cube()], [-2, -2, -2], Overlapping, "1", "1/2"),
        row("a square cuts a cube", [cube(), square()], [1, 1, 2], Overlapping, "1", "1/2"),
        row("a square on a cube", [cube(), square()], [1, 1, 4], Touching, "0", "0"),
        row(
            "squares across",
            [square(), hull(&[[0, 0, 0], [2, 0, 0], [2, 0, 2], [0, 0, 2]])],
            [1, 2, -1],
            Overlapping,
            "1/4",
            "1/4",
        ),
        row("the same square", [square(), square()], [0, 0, 0], Touching, "0", "0"),
        row("squares side by side", [square(), square()], [4, 1, 0], Touching, "0", "0"),
        row("squares apart in their plane", [square(), square()], [6, 6, 0], Disjoint, "2", "0"),
        row("squares above each other", [square(), square()], [1, 1, 3], Disjoint, "9/4", "0"),
        row("segments that cross", [segment([2, 2, 0]), segment([2, -2, 0])], [0, 4, 0], Touching, "0", "0"),
        row(
            "segments over each other",
            [segment([2, 2, 0]), segment([2, -2, 0])],
            [0, 4, 3],
            Disjoint,
            "9/4",
            "0",
        ),
        row(
            "segments one behind the other",
            [segment([2, 2, 0]), segment([1, 1, 0])],
            [4, 4, 0],
            Touching,
            "0",
            "0",
        ),
        row(
            "segments in a line, apart",
            [segment([2, 2, 0]), segment([1, 1, 0])],
            [6, 6, 0],
            Disjoint,
            "2",
            "0",
        ),
        row("segments that overlap", [segment([2, 2, 0]), segment([1, 1, 0])], [1, 1, 0], Touching, "0", "0"),
        row("segments side by side", [segment([2, 2, 0]), segment([1, 1, 0])], [1, 1, 2], Disjoint, "1", "0"),
        row("the same point", [point(), point()], [0, 0, 0], Touching, "0", "0"),
        row("two points", [point(), point()], [1, 2, 2], Disjoint, "9/4", "0"),
    ]
}

impl Row {
    pub(crate) fn translation(&self) -> [Rational; 3] {
        self.halves.map(|c| Rational::new(c.into(), 2.into()).expect("two is not zero"))
    }
}

fn brute_force_knows<N: Number>(row: &Row) {
    let scale = Integer::from(2);
    let brute = Brute::<N>::new(&row.p, &row.q, scale.clone());
    let s = row.halves.map(|c| N::of(&Integer::from(c)));
    assert_eq!(brute.place(&s), row.place, "{}", row.name);
    let (mut squared, mut along) = (Rational::from(0), Rational::from(0));
    match row.place {
        Place::Disjoint => squared = brute.squared_distance(&s).rational(&(&scale * &scale)),
        Place::Touching => {}
        Place::Overlapping => {
            squared = brute.minimum_penetration(&s).rational(&(&scale * &scale));
            let direction = DIRECTION.map(|c| N::of(&Integer::from(c)));
            along = brute.directional_penetration(&s, &direction).rational(&scale);
        }
    }
    assert_eq!(squared.to_string(), row.squared, "{}", row.name);
    assert_eq!(along.to_string(), row.along, "{}", row.name);
}

#[test]
fn brute_force_knows_the_rows() {
    for row in rows() {
        brute_force_knows::<i128>(&row);
        brute_force_knows::<Integer>(&row);
    }
}

#[test]
fn the_library_knows_the_rows() {
    for row in rows() {
        let s = Translation::new(&row.translation());
        let zero = Rational::from(0);
        let squared: Rational = row.squared.parse().expect("a number");
        let expected = Expected {
            place: row.place,
            squared_distance: if row.place == Place::Disjoint { squared.clone() } else { zero },
            squared_depth: (row.place == Place::Overlapping).then_some(squared),
            along: row.along.parse().expect("a number"),
        };
        let (sum, pair) = (RelativePlacement::new(&row.p, &row.q), Pair::new(&row.p, &row.q));
        let brute = Brute::<Integer>::new(&row.p, &row.q, Integer::from(2));
        let over_scale = row.halves.map(Integer::from);
        for subject in [Subject::Sum(&sum), Subject::Pair(&pair, None)] {
            let witness = subject.check(&s, DIRECTION, &expected, None, row.name);
            subject.check(&s, DIRECTION, &expected, Some(witness), row.name);
            subject.check_closest([&row.p, &row.q], &s, &expected, row.name);
            subject.check_direction(&brute, &over_scale, &s, row.name);
        }
    }
}

/// The first of the closest points where there are many, and the smallest features that hold all of them.
#[test]
fn closest_points_are_the_first_of_many() {
    let cubes = [cube(), cube()];
    let squares = [square(), square()];
    /// Name, polytopes, translation over two, closest points, features.
    type Row<'a> = (&'a str, &'a [Polytope; 2], [i64; 3], [&'a str; 3], [&'a str; 3], &'a str);
    let rows: [Row<'_>; 7] = [
        ("facets apart", &cubes, [1, -1, 7], ["1/2", "0", "2"], ["1/2", "0", "7/2"], "facet facet"),
        ("facets in contact", &cubes, [4, 1, -3], ["2", "1/2", "0"], ["2", "1/2", "0"], "facet facet"),
        ("edges apart", &cubes, [6, 1, 6], ["2", "1/2", "2"], ["3", "1/2", "3"], "edge edge"),
        ("vertices apart", &cubes, [-5, -6, 5], ["0", "0", "2"], ["-1/2", "-1", "5/2"], "vertex vertex"),
        (
            "squares above each other",
            &squares,
            [1, 1, 3],
            ["1/2", "1/2", "0"],
            ["1/2", "1/2", "3/2"],
            "facet facet",
        ),
        ("squares side by side", &squares, [4, 1, 0], ["2", "1/2", "0"], ["2", "1/2", "0"], "edge edge"),
        ("the same squares", &squares, [0, 0, 0], ["0", "0", "0"], ["0", "0", "0"], "facet facet"),
    ];
    for (name, [p, q], halves, on_p, on_q, kinds) in rows {
        let s =
            Translation::new(&halves.map(|c| Rational::new(c.into(), 2.into()).expect("two is not zero")));
        let (sum, pair) = (RelativePlacement::new(p, q), Pair::new(p, q));
        for subject in [Subject::Sum(&sum), Subject::Pair(&pair, None)] {
            let separation = subject.separation(&s, None);
            let points = separation.closest_points().map(|point| point.map(|c| c.to_string()));
            assert_eq!(points, [on_p, on_q].map(|point| point.map(str::to_owned)), "{name}");
            let found = separation.features().map(|feature| match feature {
                Feature::Vertex(_) => "vertex",
                Feature::Edge(_) => "edge",
                Feature::Facet(_) => "facet",
            });
            assert_eq!(found.join(" "), kinds, "{name}");
        }
    }
}

/// There is no way out along no direction, and none is needed where nothing overlaps.
#[test]
fn the_zero_direction_has_no_depth() {
    let zero = Vector3::from_i64([0, 0, 0]);
    let (p, q) = (cube(), cube());
    let (sum, pair) = (RelativePlacement::new(&p, &q), Pair::new(&p, &q));
    for subject in [Subject::Sum(&sum), Subject::Pair(&pair, None)] {
        let along = |s: [i64; 3]| {
            let s = Translation::from_i64(s);
            subject.along(&s, &zero, None).map(|along| along.depth())
        };
        assert_eq!(along([1, 1, 1]), None);
        assert_eq!(along([2, 1, 1]), Some(Rational::from(0)));
        assert_eq!(along([3, 1, 1]), Some(Rational::from(0)));
    }
}
