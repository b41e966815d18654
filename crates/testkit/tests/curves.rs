//! The generators of curves against the hashes that were published with the measurements of CGAL.

use splitstar_testkit::{
    LinearKind, POLYLINE_VERTICES, geodesic_arcs, lines, long_segments, mixed_curves, polylines,
    query_directions, query_points, short_segments,
};

#[test]
fn hashes_are_the_published_ones() {
    let long = |count, seed| long_segments(count, seed).hash;
    let short = |count, bits, seed| short_segments(count, bits, seed).hash;
    let rows: &[(&str, u64, u64)] = &[
        ("long 100", long(100, 1), 0xd769_6c6d_8e31_2ad1),
        ("long 300", long(300, 1), 0xa438_5fba_a1d5_47ce),
        ("long 1000", long(1_000, 1), 0xa218_6390_7182_c844),
        ("long 3000", long(3_000, 1), 0x6176_0c7e_e386_0df2),
        ("long 100, second", long(100, 2), 0xfe2d_5d29_9589_12c2),
        ("long 300, second", long(300, 2), 0x4d24_cbe6_94c7_461b),
        ("long 1000, second", long(1_000, 2), 0xe40b_f83e_092e_eed0),
        ("lines 1000", lines(1_000, 1).hash, 0xa218_6390_7182_c844),
        ("mixed 300", mixed_curves(300, 1).hash, 0xa438_5fba_a1d5_47ce),
        ("s15 1000", short(1_000, 15, 1), 0xf345_1c19_3db6_6dad),
        ("s15 3000", short(3_000, 15, 1), 0x8ee8_c259_6c30_0259),
        ("s15 10000", short(10_000, 15, 1), 0x8e74_7ed9_26f1_00be),
        ("s15 10000, second", short(10_000, 15, 2), 0x8864_86e2_11f3_0afa),
        ("s14 100000", short(100_000, 14, 1), 0xe551_5c59_1f8d_33e8),
        ("polyline 100", polylines(100, 1).hash, 0xb4b1_4b96_213c_ac86),
        ("polyline 300", polylines(300, 1).hash, 0xf32a_0ca6_217f_8da6),
        ("polyline 1000", polylines(1_000, 1).hash, 0x7d1f_4127_2e8e_6956),
        ("sphere 100", geodesic_arcs(100, 1).hash, 0xc82f_1f6a_deab_5e08),
        ("sphere 300", geodesic_arcs(300, 1).hash, 0xd117_972a_a606_757b),
        ("sphere 300, second", geodesic_arcs(300, 2).hash, 0x4d22_76ab_2d5f_463d),
        ("sphere 1000", geodesic_arcs(1_000, 1).hash, 0xa56e_79ef_cf51_288c),
        ("sphere 3000", geodesic_arcs(3_000, 1).hash, 0x686d_acf6_844b_6fad),
        ("queries on the sphere 10000", query_directions(10_000, 1_000).hash, 0xfd37_8613_c0c9_dbf2),
        ("queries 10000", query_points(10_000, 1_000).hash, 0x19d3_c591_bd35_d28b),
    ];
    for (name, hash, published) in rows {
        assert_eq!(hash, published, "{name}: {hash:016x} instead of {published:016x}");
    }
}

#[test]
fn first_curves_are_as_computed_by_another_program() {
    assert_eq!(
        long_segments(2, 1).objects,
        [[594_082, 782_008, 1_018_170, 465_944], [465_845, 799_952, 919_966, 548_475]]
    );
    assert_eq!(
        short_segments(2, 14, 1).objects,
        [[594_082, 782_008, 601_798, 781_096], [465_845, 799_952, 472_027, 800_329]]
    );
    assert_eq!(query_points(2, 1_000).objects, [[246_251, 853_929], [810_982, 324_877]]);
    assert_eq!(
        geodesic_arcs(2, 1).objects,
        [[136, 503, 964, -114, -115, 538], [772, 47, -440, 602, -197, 215]]
    );
    assert_eq!(query_directions(2, 1_000).objects, [[-544, 643, 559], [-390, 367, 692]]);
    let walk = &polylines(1, 1).objects[0];
    assert_eq!(walk.len(), POLYLINE_VERTICES);
    assert_eq!(walk[..3], [[594_082, 782_008], [655_817, 774_715], [648_511, 809_173]]);
    assert_eq!(walk[POLYLINE_VERTICES - 1], [685_855, 916_553]);
}

#[test]
fn kinds_alternate() {
    let drawn = mixed_curves(7, 1);
    let kinds: Vec<LinearKind> = drawn.objects.iter().map(|&(kind, _)| kind).collect();
    assert_eq!(kinds[..3], [LinearKind::Line, LinearKind::Ray, LinearKind::Segment]);
    assert_eq!(kinds[..3], kinds[3..6]);
    let points: Vec<[i64; 4]> = drawn.objects.iter().map(|&(_, points)| points).collect();
    assert_eq!(points, long_segments(7, 1).objects);
}

#[test]
fn a_longer_input_begins_like_a_shorter_one() {
    assert_eq!(short_segments(100, 12, 5).objects[..10], short_segments(10, 12, 5).objects);
    assert_eq!(polylines(20, 5).objects[..10], polylines(10, 5).objects);
    assert_eq!(geodesic_arcs(100, 5).objects[..10], geodesic_arcs(10, 5).objects);
    assert!(short_segments(0, 12, 5).objects.is_empty());
}
