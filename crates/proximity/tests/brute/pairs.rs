//! Twenty pairs of polytopes with at most thirty features each, of every dimension, many of them degenerate; and flat pairs besides.

use polytope::Polytope;
use testkit::{Rng, hull, hull_of_dimension, rotation, scaling, segment, translation};

/// The most vertices, edges and facets of one operand, in all.
const FEATURES: usize = 30;

pub(crate) struct Pair {
    pub(crate) name: &'static str,
    pub(crate) p: Polytope,
    pub(crate) q: Polytope,
}

fn cube() -> Polytope {
    block([1, 1, 1])
}

fn block([x, y, z]: [i64; 3]) -> Polytope {
    let corners: Vec<[i64; 3]> = (0..8)
        .map(|i| {
            [
                if i & 1 == 0 { -x } else { x },
                if i & 2 == 0 { -y } else { y },
                if i & 4 == 0 { -z } else { z },
            ]
        })
        .collect();
    hull(&corners)
}

fn tetrahedron() -> Polytope {
    hull(&[[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]])
}

fn octahedron() -> Polytope {
    hull(&[[2, 0, 0], [-2, 0, 0], [0, 2, 0], [0, -2, 0], [0, 0, 2], [0, 0, -2]])
}

fn triangular_prism() -> Polytope {
    hull(&[[0, 0, 0], [4, 0, 0], [0, 3, 0], [0, 0, 2], [4, 0, 2], [0, 3, 2]])
}

fn pyramid() -> Polytope {
    hull(&[[2, 2, 0], [-2, 2, 0], [-2, -2, 0], [2, -2, 0], [0, 0, 3]])
}

fn hexagonal_pyramid() -> Polytope {
    hull(&[[4, 0, 0], [2, 3, 0], [-2, 3, 0], [-4, 0, 0], [-2, -3, 0], [2, -3, 0], [1, 1, 5]])
}

fn bipyramid() -> Polytope {
    hull(&[[3, 0, 0], [-2, 2, 0], [-2, -3, 0], [0, 0, 4], [0, 0, -1]])
}

fn hexagon() -> Polytope {
    hull(&[[4, 0, 1], [2, 3, 1], [-2, 3, 1], [-4, 0, 1], [-2, -3, 1], [2, -3, 1]])
}

fn point(at: [i64; 3]) -> Polytope {
    hull(&[at])
}

/// A random polytope of that dimension with few features.
fn random(seed: u64, dimension: u8, range: i64) -> Polytope {
    let mut rng = Rng::new(seed);
    loop {
        let polytope = hull_of_dimension(&mut rng, dimension, range);
        if polytope.counts().to_array().iter().sum::<usize>() <= FEATURES {
            return polytope;
        }
    }
}

pub(crate) fn pair(name: &str) -> Pair {
    let pairs = pairs();
    let known = pairs.iter().map(|pair| pair.name).collect::<Vec<_>>().join(", ");
    let found = pairs.into_iter().find(|pair| pair.name == name);
    found.unwrap_or_else(|| panic!("no pair {name}; there are {known}"))
}

/// Pairs whose sums are solid, so that some placements overlap; the operands need not be.
pub(crate) fn pairs() -> Vec<Pair> {
    let of = |name, p, q| Pair { name, p, q };
    let turned = |polytope: Polytope, by| polytope.transformed(&rotation(by));
    vec![
        of("cubes", cube(), cube()),
        of("cube_and_tetrahedron", cube(), tetrahedron()),
        of("opposite_tetrahedra", tetrahedron(), tetrahedron().reflected()),
        of("same_tetrahedra", tetrahedron(), tetrahedron()),
        of("octahedron_and_cube", octahedron(), cube()),
        of("prisms", triangular_prism(), turned(triangular_prism(), [1, 1, 0, 0])),
        of("pyramid_and_octahedron", pyramid(), octahedron()),
        of("hulls", random(1, 3, 9), random(2, 3, 9)),
        of("large_hulls", random(3, 3, 100), random(4, 3, 100)),
        of("block_and_needle", block([3, 2, 1]), block([60, 1, 1])),
        of("hexagonal_pyramid_and_bipyramid", hexagonal_pyramid(), bipyramid()),
        of("cube_turned", cube().transformed(&translation([1, 2, 3], 6)), turned(cube(), [3, 1, 1, 0])),
        of("thirds", bipyramid().transformed(&scaling(1, 3)), pyramid().transformed(&scaling(3, 7))),
        of("cube_and_point", cube(), point([5, 1, 1])),
        of("hull_and_segment", random(5, 3, 9), segment([3, -2, 5])),
        of("hull_and_polygon", random(6, 3, 9), random(7, 2, 5)),
        of("skew_polygons", hexagon(), turned(hexagon(), [1, 1, 0, 0])),
        of("prism_and_parallel_polygon", triangular_prism(), hexagon()),
        of("polygon_and_segment_across", hexagon(), segment([1, 1, 5])),
        of("crossed_needles", block([40, 1, 1]), block([1, 40, 2])),
    ]
}

/// More pairs, whose sums lie in a plane: no translation makes them overlap.
pub(crate) fn flat_pairs() -> Vec<Pair> {
    let of = |name, p, q| Pair { name, p, q };
    vec![
        of("parallel_segments", segment([2, 4, 6]), segment([1, 2, 3])),
        of("opposite_segments", segment([2, 4, 6]), segment([-1, -2, -3])),
        of("points", point([1, 2, 3]), point([3, 2, 1])),
        of("point_and_segment", point([1, 2, 3]), segment([3, 0, 1])),
        of("point_and_polygon", point([1, 2, 3]), hexagon()),
        of("same_polygons", hexagon(), hexagon()),
        of("coplanar_polygons", hexagon(), hull(&[[0, 0, 0], [5, 0, 0], [0, 4, 0], [3, 3, 0]])),
        of("polygon_and_segment_in_its_plane", hexagon(), segment([6, 1, 0])),
        of("skew_segments", segment([4, 1, 0]), segment([0, 3, 2])),
    ]
}

#[test]
fn pairs_are_small() {
    assert_eq!(pairs().len(), 20);
    for Pair { name, p, q } in pairs() {
        for polytope in [p, q] {
            let counts = polytope.counts().to_array();
            assert!(counts.iter().sum::<usize>() <= FEATURES, "{name}: {counts:?}");
        }
    }
}
