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
    /// The quaternion w, x, y, z that turns all models of the row before their maps are made: of those that were tried, the first that
    /// gives the printed counts, or else the first of the nearest.
    pub(super) turn: [i64; 4],
    /// Why counted and printed differ; empty where they must agree.
    pub(super) why: &'static str,
}

/// What is counted as it is in the file.
const AS_FILED: [i64; 4] = [1, 0, 0, 0];

const fn counts([vertices, edges, facets]: [usize; 3]) -> Counts {
    Counts { vertices, edges, facets }
}

const fn map(printed: [usize; 3], turn: [i64; 4]) -> Map {
    Map { printed: MapCounts::new(printed), turn, why: "" }
}

const fn other(printed: [usize; 3], turn: [i64; 4], why: &'static str) -> Map {
    Map { printed: MapCounts::new(printed), turn, why }
}

const fn row(
    name: &'static str,
    models: &'static [&'static str],
    primal: [usize; 3],
    [spherical, cubical]: [Map; 2],
) -> Row {
    Row { name, models, primal: counts(primal), why: "", others: &[], maps_of: models, spherical, cubical }
}

/// Table 3.3.
pub(super) const POLYTOPES: [Row; 8] = [
    row(
        "Tetrahedron",
        &["tetrahedron.off"],
        [4, 6, 4],
        [map([4, 12, 4], AS_FILED), map([42, 102, 21], AS_FILED)],
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
        [map([21, 62, 12], AS_FILED), map([72, 192, 36], AS_FILED)],
    ),
    row("DP", &["dp.off"], [17, 32, 17], [map([25, 80, 17], AS_FILED), map([97, 280, 55], AS_FILED)]),
    Row {
        why: "printed counts are those of the dual solid, the snub dodecahedron",
        others: &[&["ph_snub_dodecahedron.off"]],
        maps_of: &["ph_snub_dodecahedron.off"],
        ..row(
            "PH",
            &["pentagonal_hexecontahedron.xoff"],
            [60, 150, 92],
            [map([101, 318, 60], AS_FILED), map([200, 600, 112], AS_FILED)],
        )
    },
    row(
        "TI",
        &["truncated_icosidodecahedron.xoff"],
        [120, 180, 62],
        [map([77, 390, 120], AS_FILED), map([230, 840, 202], AS_FILED)],
    ),
    Row {
        why: "4^l triangles per face cannot give 500; printed counts are those of edges in 5 parts",
        others: &[&["gs4.off"]],
        maps_of: &["gs4.off"],
        ..row(
            "GS4",
            &["gs_freq4.off"],
            [252, 750, 500],
            [map([506, 1512, 252], AS_FILED), map([708, 2124, 366], AS_FILED)],
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
        [map([21, 62, 12], AS_FILED), map([72, 192, 36], AS_FILED)],
    ),
    row(
        "DP + ODP",
        &["dp.off", "odp.xoff"],
        [131, 261, 132],
        [map([141, 540, 131], AS_FILED), map([242, 832, 186], AS_FILED)],
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
            [map([429, 1712, 429], AS_FILED), map([514, 1670, 333], AS_FILED)],
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
            [map([1564, 5220, 1048], AS_FILED), map([1906, 6288, 1250], AS_FILED)],
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
