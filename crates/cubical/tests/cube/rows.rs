//! Arcs with known counts.

use crate::agree::{assert_agrees, direction, map_of};
use arrangement::models::Geodesic;
use exact::spherical::GreatCircle;
use splitstar_cubical::{At, CubeSide, CubicalArrangement, Place};

fn arc(p: [i64; 3], q: [i64; 3]) -> Geodesic {
    Geodesic::arc(direction(p), direction(q)).expect("neither equal nor opposite")
}

fn around(p: [i64; 3], q: [i64; 3], normal: [i64; 3]) -> Geodesic {
    Geodesic::arc_around(direction(p), direction(q), circle_of(normal)).expect("on the circle")
}

fn circle_of(normal: [i64; 3]) -> GreatCircle {
    GreatCircle::from_i64(normal).expect("not zero")
}

fn circle(normal: [i64; 3]) -> Geodesic {
    Geodesic::circle(circle_of(normal))
}

fn point(p: [i64; 3]) -> Geodesic {
    Geodesic::point(direction(p))
}

struct Row {
    name: &'static str,
    geodesics: Vec<Geodesic>,
    /// Real vertices, edges, faces, isolated vertices, components.
    real: [usize; 5],
    /// Vertices and edges of all sides, and faces without the unbounded ones.
    stored: [usize; 3],
}

fn row(name: &'static str, geodesics: Vec<Geodesic>, real: [usize; 5], stored: [usize; 3]) -> Row {
    Row { name, geodesics, real, stored }
}

fn rows() -> Vec<Row> {
    let cube_edges = || -> Vec<Geodesic> {
        (0..3)
            .flat_map(|axis| (0..4).map(move |i| (axis, 2 * (i & 1) - 1, 2 * (i >> 1) - 1)))
            .map(|(axis, s, t)| {
                let mut ends = [[0; 3]; 2];
                for (end, at) in ends.iter_mut().zip([-1, 1]) {
                    (end[axis], end[(axis + 1) % 3], end[(axis + 2) % 3]) = (at, s, t);
                }
                arc(ends[0], ends[1])
            })
            .collect()
    };
    vec![
        row("nothing", vec![], [0, 0, 1, 0, 0], [24, 24, 6]),
        row("a point within a side", vec![point([5, 1, 2])], [1, 0, 1, 1, 1], [25, 24, 6]),
        row("a point on an edge of the cube", vec![point([2, 2, 1])], [1, 0, 1, 1, 1], [26, 26, 6]),
        row("a point at a corner", vec![point([-1, 1, 1])], [1, 0, 1, 1, 1], [24, 24, 6]),
        row("an arc within a side", vec![arc([5, 1, 2], [5, -1, 2])], [2, 1, 1, 0, 1], [26, 25, 6]),
        row("an arc over an edge", vec![arc([3, 1, 0], [1, 3, 0])], [2, 1, 1, 0, 1], [28, 28, 6]),
        row(
            "an arc over a corner, and on along an edge",
            vec![arc([3, 1, 1], [1, 3, 3])],
            [2, 1, 1, 0, 1],
            [27, 27, 6],
        ),
        row("an arc from an edge", vec![arc([1, 1, 0], [1, 0, 0])], [2, 1, 1, 0, 1], [27, 27, 6]),
        row(
            "an arc from a corner to a corner across",
            vec![arc([1, 1, 1], [1, -1, -1])],
            [2, 1, 1, 0, 1],
            [24, 25, 7],
        ),
        row("a part of an edge of the cube", vec![arc([2, 2, 1], [2, 2, -1])], [2, 1, 1, 0, 1], [28, 28, 6]),
        row("a whole edge of the cube", vec![arc([1, 1, 1], [1, 1, -1])], [2, 1, 1, 0, 1], [24, 24, 6]),
        row("an edge of the cube and more", vec![arc([1, 1, 2], [1, 1, -2])], [2, 1, 1, 0, 1], [26, 26, 6]),
        row("all edges of the cube", cube_edges(), [8, 12, 6, 0, 1], [24, 24, 6]),
        row("the equator", vec![circle([0, 0, 1])], [1, 1, 2, 0, 1], [32, 36, 10]),
        row("a circle through six sides", vec![circle([1, 1, 1])], [1, 1, 2, 0, 1], [36, 42, 12]),
        row("a circle along edges of the cube", vec![circle([1, -1, 0])], [1, 1, 2, 0, 1], [24, 26, 8]),
        row("a circle through two corners", vec![circle([1, 2, -3])], [1, 1, 2, 0, 1], [28, 32, 10]),
        row(
            "a circle with a vertex",
            vec![around([1, 0, 0], [1, 0, 0], [0, 0, 1])],
            [1, 1, 2, 0, 1],
            [33, 37, 10],
        ),
        row(
            "a circle with a vertex on an edge of the cube",
            vec![around([1, 1, 0], [1, 1, 0], [0, 0, 1])],
            [1, 1, 2, 0, 1],
            [32, 36, 10],
        ),
        row(
            "a circle along edges of the cube with a vertex at a corner",
            vec![around([1, 1, 1], [1, 1, 1], [1, -1, 0])],
            [1, 1, 2, 0, 1],
            [24, 26, 8],
        ),
        row("half a circle", vec![around([1, 0, 0], [-1, 0, 0], [0, 0, 1])], [2, 1, 1, 0, 1], [30, 31, 7]),
        row(
            "a long arc that ends on the side of its begin",
            vec![around([5, 1, 0], [5, -1, 0], [0, 0, 1])],
            [2, 1, 1, 0, 1],
            [34, 37, 9],
        ),
        row(
            "three circles",
            vec![circle([1, 0, 0]), circle([0, 1, 0]), circle([0, 0, 1])],
            [6, 12, 8, 0, 1],
            [54, 72, 24],
        ),
        row(
            "a crossing on an edge of the cube",
            vec![circle([0, 1, 0]), circle([1, 1, -1])],
            [2, 4, 4, 0, 1],
            [40, 50, 16],
        ),
        row(
            "a crossing with an arc along an edge of the cube",
            vec![arc([2, 2, 1], [2, 2, -1]), arc([3, 1, 0], [1, 3, 0])],
            [5, 4, 1, 0, 1],
            [32, 32, 6],
        ),
        row(
            "arcs that overlap along an edge of the cube",
            vec![arc([2, 2, 1], [2, 2, -1]), arc([3, 3, 2], [4, 4, 0])],
            [4, 3, 1, 0, 1],
            [32, 32, 6],
        ),
        row(
            "an arc and a point on it, on an edge of the cube",
            vec![arc([3, 1, 0], [1, 3, 0]), point([1, 1, 0])],
            [3, 2, 1, 0, 1],
            [28, 28, 6],
        ),
        row(
            "the same circle twice",
            vec![circle([0, 0, 1]), circle([0, 0, -1])],
            [1, 1, 2, 0, 1],
            [32, 36, 10],
        ),
    ]
}

#[test]
fn every_row_has_its_counts_and_agrees_with_the_sphere() {
    for row in rows() {
        let map = map_of(&row.geodesics);
        assert_agrees(&map, &row.geodesics, row.name);
        let counts = map.counts();
        let real = [counts.vertices, counts.edges, counts.faces, counts.isolated, counts.components];
        assert_eq!(real, row.real, "{}", row.name);
        let stored = map.counts_with_artificial();
        assert_eq!([stored.vertices, stored.edges, stored.faces - 6], row.stored, "{}", row.name);
        let reversed: Vec<Geodesic> = row.geodesics.iter().rev().map(Geodesic::reversed).collect();
        let other = map_of(&reversed);
        assert_agrees(&other, &row.geodesics, row.name);
        assert_eq!(other.counts_with_artificial(), stored, "{}", row.name);
    }
}

#[test]
fn the_empty_cube_is_all_artificial() {
    let map = CubicalArrangement::default();
    assert_eq!(map.check_valid(), []);
    for side in CubeSide::ALL {
        assert!(map.side(side).dcel().edges().all(|id| !map.is_real_edge(At { side, id })));
        for id in map.corners(side) {
            let v = At { side, id };
            assert_eq!(
                (map.place(v), map.copies(v).count(), map.is_real_vertex(v)),
                (Place::Corner, 3, false)
            );
            assert_eq!(map.around(v).count(), 3, "three edges of the cube");
        }
    }
    assert_eq!(map.parts(map.faces().next().expect("there is one face")).count(), 6);
}

#[test]
fn arcs_of_edges_are_told() {
    use splitstar_cubical::CubicalPieces;
    let mut pieces = CubicalPieces::new();
    let given = [arc([3, 1, 0], [1, 3, 0]), circle([0, 0, 1]), arc([1, 1, 2], [1, 1, 3])];
    given.iter().for_each(|geodesic| pieces.push_geodesic(geodesic));
    assert_eq!(pieces.arc_count(), 3);
    let (map, arcs) = CubicalArrangement::of_pieces_with_arcs(pieces);
    for side in CubeSide::ALL {
        for id in map.side(side).dcel().edges() {
            let e = At { side, id };
            let Some(arc) = arcs[side.index()][id.index()] else {
                continue;
            };
            assert!(map.is_real_edge(e));
            let is_right = map.side(side).curve_of(id).is_directed_right();
            let h = if is_right { id.halfedge() } else { id.halfedge().twin() };
            assert_eq!(Some(&map.circle(At { side, id: h })), given[arc as usize].great_circle());
        }
    }
    // The first one lies on the second: where they overlap, none is told.
    let told: Vec<u32> = arcs.iter().flatten().copied().flatten().collect();
    assert!(!told.contains(&0) && told.contains(&1) && told.contains(&2));
}
