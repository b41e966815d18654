//! What was printed.

use crate::library::{Counts, MapCounts};

/// One row of table 3.3 or 3.4.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) name: &'static str,
    /// The solid the name stands for, or both summands.
    pub(super) models: &'static [&'static str],
    pub(super) primal: Counts,
    /// Why counted and printed differ; empty where they must agree.
    pub(super) why: &'static str,
    /// Other readings of the name, counted as well.
    pub(super) others: &'static [&'static [&'static str]],
    /// The reading of which the Gaussian maps are counted: the one with the printed primal counts, where there is one.
    pub(super) maps_of: &'static [&'static str],
    pub(super) spherical: Map,
    pub(super) cubical: Map,
}

/// The columns of one kind of map.
#[derive(Debug)]
pub(super) struct Map {
    pub(super) printed: MapCounts,
    /// The solid that is the hull of these points, in place of the model; empty where it is the model.
    pub(super) points: &'static [[i64; 3]],
    /// The quaternion w, x, y, z that turns all models of the row before their maps are made: of those that were tried, the first that
    /// gives the printed counts, or else the first of the nearest.
    pub(super) turn: [i64; 4],
    /// What these points are.
    pub(super) note: &'static str,
    /// Why counted and printed differ; empty where they must agree.
    pub(super) why: &'static str,
}

/// What is counted as it is in the file.
pub(super) const AS_FILED: [i64; 4] = [1, 0, 0, 0];

const fn counts([vertices, edges, facets]: [usize; 3]) -> Counts {
    Counts { vertices, edges, facets }
}

/// The printed counts, which the models have where they are turned so.
const fn map(printed: [usize; 3], turn: [i64; 4]) -> Map {
    Map { printed: MapCounts::new(printed), points: &[], turn, note: "", why: "" }
}

/// The printed counts, which another solid has.
const fn solid(printed: [usize; 3], points: &'static [[i64; 3]], note: &'static str) -> Map {
    Map { points, note, ..map(printed, AS_FILED) }
}

/// The printed counts, which nothing that was tried has.
const fn other(printed: [usize; 3], turn: [i64; 4], why: &'static str) -> Map {
    Map { why, ..map(printed, turn) }
}

const fn row(
    name: &'static str,
    models: &'static [&'static str],
    primal: [usize; 3],
    [spherical, cubical]: [Map; 2],
) -> Row {
    Row { name, models, primal: counts(primal), why: "", others: &[], maps_of: models, spherical, cubical }
}

/// The corner of a box.
const CORNER: [[i64; 3]; 4] = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]];
const CORNER_NOTE: &str =
    "with edges 1, 2 and 3 along the axes; no turn that was tried gives these counts of the regular one";

/// A pyramid over a polygon of 16 corners, four of which are on the axes: its lateral facets beside these are mapped to edges of the cube.
const PYRAMID: [[i64; 3]; 17] = [
    [10_000, 0, 0],
    [9_239, 0, 3_827],
    [7_071, 0, 7_071],
    [3_827, 0, 9_239],
    [0, 0, 10_000],
    [-3_827, 0, 9_239],
    [-7_071, 0, 7_071],
    [-9_239, 0, 3_827],
    [-10_000, 0, 0],
    [-9_239, 0, -3_827],
    [-7_071, 0, -7_071],
    [-3_827, 0, -9_239],
    [0, 0, -10_000],
    [3_827, 0, -9_239],
    [7_071, 0, -7_071],
    [9_239, 0, -3_827],
    [0, -10_000, 0],
];
const PYRAMID_NOTE: &str =
    "as high as its radius, with corners on the axes; the model, which is 0.7 of that high, fits the sum";

/// Table 3.3.
pub(super) const POLYTOPES: [Row; 8] = [
    row(
        "Tetrahedron",
        &["tetrahedron.off"],
        [4, 6, 4],
        [solid([4, 12, 4], &CORNER, CORNER_NOTE), solid([42, 102, 21], &CORNER, CORNER_NOTE)],
    ),
    row(
        "Octahedron",
        &["octahedron.off"],
        [6, 12, 8],
        [map([10, 28, 6], AS_FILED), map([24, 48, 12], AS_FILED)],
    ),
    row(
        "Icosahedron",
        &["icosahedron.off"],
        [12, 30, 20],
        [map([21, 62, 12], [2, 0, 1, 0]), map([72, 192, 36], [2, 1, 0, 0])],
    ),
    row(
        "DP",
        &["dp.off"],
        [17, 32, 17],
        [solid([25, 80, 17], &PYRAMID, PYRAMID_NOTE), solid([97, 280, 55], &PYRAMID, PYRAMID_NOTE)],
    ),
    Row {
        why: "printed counts are those of the dual solid, the snub dodecahedron",
        others: &[&["ph_snub_dodecahedron.off"]],
        maps_of: &["ph_snub_dodecahedron.off"],
        ..row(
            "PH",
            &["pentagonal_hexecontahedron.xoff"],
            [60, 150, 92],
            [map([101, 318, 60], [2, 1, 0, 0]), map([200, 600, 112], [3, 2, 0, 0])],
        )
    },
    row(
        "TI",
        &["truncated_icosidodecahedron.xoff"],
        [120, 180, 62],
        [map([77, 390, 120], [1, 1, 1, 0]), map([230, 840, 202], [3, 2, 0, 0])],
    ),
    Row {
        why: "4^l triangles per face cannot give 500; printed counts are those of edges in 5 parts",
        others: &[&["gs4.off"]],
        maps_of: &["gs4.off"],
        ..row(
            "GS4",
            &["gs_freq4.off"],
            [252, 750, 500],
            [map([506, 1512, 252], [1, 1, 0, 0]), map([708, 2124, 366], AS_FILED)],
        )
    },
    row(
        "El16",
        &["el16.off"],
        [482, 992, 512],
        [map([528, 2016, 482], AS_FILED), map([776, 2752, 612], AS_FILED)],
    ),
];

/// Table 3.4.
pub(super) const SUMS: [Row; 5] = [
    row(
        "Icosahedron + Icosahedron",
        &["icosahedron.off", "icosahedron.off"],
        [12, 30, 20],
        [map([21, 62, 12], [2, 0, 1, 0]), map([72, 192, 36], [2, 1, 0, 0])],
    ),
    row(
        "DP + ODP",
        &["dp.off", "odp.xoff"],
        [131, 261, 132],
        [
            map([141, 540, 131], [2, 0, 0, 1]),
            other(
                [242, 832, 186],
                [4, 3, 0, -4],
                "the nearest of 2,928 turns; the printed counts need facets on edges of the cube",
            ),
        ],
    ),
    Row {
        why: "impossible for these summands: 340 facets leave too few edge sides for the facets of TI; \
              the printed Gaussian map (429 faces) fits snub dodecahedron + turned TI",
        others: &[
            &["ph_snub_dodecahedron.off", "truncated_icosidodecahedron.xoff"],
            &["ph_snub_dodecahedron.off", "truncated_icosidodecahedron_rotated.xoff"],
        ],
        maps_of: &["ph_snub_dodecahedron.off", "truncated_icosidodecahedron_rotated.xoff"],
        ..row(
            "PH + TI",
            &["pentagonal_hexecontahedron.xoff", "truncated_icosidodecahedron.xoff"],
            [248, 586, 340],
            [
                map([429, 1712, 429], [2, 0, 0, 1]),
                other(
                    [514, 1670, 333],
                    AS_FILED,
                    "impossible beside the printed spherical map: 333 faces are fewer than the 429 vertices of the sum",
                ),
            ],
        )
    },
    Row {
        why: "angle not published; an exact turn about a twofold axis makes 2 mod 4 crossings, \
              the 536 of the printed row need rounding",
        others: &[&["gs4.off", "rgs4_6degrees.xoff"], &["gs4.off", "rgs4_general.xoff"]],
        ..row(
            "GS4 + RGS4",
            &["gs4.off", "rgs4.xoff"],
            [1048, 2582, 1536],
            [
                other(
                    [1564, 5220, 1048],
                    [3, 1, 2, 1],
                    "the primal counts differ, see above; 28 artificial vertices are as printed",
                ),
                other(
                    [1906, 6288, 1250],
                    [4, 1, -1, 1],
                    "the primal counts differ, see above; the nearest of 2,928 turns",
                ),
            ],
        )
    },
    row(
        "El16 + OEl16",
        &["el16.off", "oel16.xoff"],
        [2260, 4580, 2322],
        [map([2354, 9224, 2260], AS_FILED), map([2826, 10648, 2510], AS_FILED)],
    ),
];

/// Table 3.2: the sides of the cube for the dioctagonal pyramid, in the order of the thesis: x, y, z = -1, then 1.
pub(super) const SIDES: [[usize; 3]; 6] =
    [[12, 32, 6], [28, 80, 14], [12, 32, 6], [12, 32, 6], [21, 72, 17], [12, 32, 6]];
