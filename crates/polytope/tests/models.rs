//! The models of the repository against what is known of them: `models/expected.json`.

use splitstar_polytope::{
    MeshSummary, OverlayCounts, Polytope, convex_hull, minkowski_sum, minkowski_sum_by_hull, overlay_counts,
};
use testkit::{SumRow, assert_same, expected, model, model_mesh, model_names, rotation};

/// General turns, some about an axis, and one that maps axes to axes.
const QUATERNIONS: [[i64; 4]; 5] = [[1, 1, 1, 1], [3, 0, 1, 0], [5, 1, 0, 2], [7, -3, 2, 1], [2, 1, -5, 4]];

/// The rows of two summands.
fn pairs() -> Vec<SumRow> {
    let rows: Vec<_> = SumRow::all().into_iter().filter(|row| row.summands.len() == 2).collect();
    assert_eq!(rows.len(), 36);
    rows
}

fn meetings(p: &Polytope, q: &Polytope) -> Option<[usize; 3]> {
    let OverlayCounts { crossings, common_normals, normals_on_arcs, .. } = overlay_counts(p, q);
    Some([crossings, common_normals, normals_on_arcs])
}

#[test]
fn every_convex_model_is_as_told() {
    let table = expected();
    let (mut models, mut with_paper) = (0, 0);
    for name in model_names("convex").into_iter().chain(model_names("maxfacets")) {
        let facts = &table["models"][&name];
        let counts = ["V", "E", "F"].map(|key| facts[key].as_u64().expect("counts are known") as usize);
        let volume: exact::Rational =
            facts["volume"].as_str().expect("the volume is known").parse().expect("a number");
        let polytope = model(&name); // panics if it is not convex as it stands
        assert_eq!(polytope.counts().to_array(), counts, "{name}");
        assert_eq!(polytope.volume(), volume, "{name}");
        assert_eq!(polytope.check_valid(), [], "{name}");
        let hull = convex_hull(polytope.points()).expect("a model has vertices");
        assert_same(&polytope, &hull, &name);

        let summary = MeshSummary::of(&model_mesh(&name));
        assert_eq!([summary.vertices, summary.edges, summary.facets], counts, "{name}");
        assert!(summary.convex && summary.closed && summary.defect.is_none(), "{name}");
        assert_eq!((summary.components, summary.genus), (1, vec![Some(0)]), "{name}");
        assert_eq!((summary.dimension, summary.volume), (Some(3), Some(volume)), "{name}");
        models += 1;
        with_paper += usize::from(facts["paper"].is_array());
    }
    assert!(models == 37 && with_paper == 14, "{models} models, {with_paper} of the papers");
}

#[test]
fn every_sum_by_overlay_in_both_orders_and_turned() {
    for row in pairs() {
        let [p, q] = [&row.summands[0], &row.summands[1]];
        let sum = minkowski_sum(&[p, q]);
        row.check(&sum, "as it stands");
        assert_eq!(meetings(p, q), row.meetings, "{}", row.name());
        let swapped = minkowski_sum(&[q, p]);
        row.check(&swapped, "swapped");
        assert_eq!(meetings(q, p), row.meetings, "{} swapped", row.name());
        assert_same(&sum, &swapped, row.name());
        for quaternion in QUATERNIONS {
            let turn = rotation(quaternion);
            let [p, q] = [p, q].map(|p| p.transformed(&turn));
            let turned = minkowski_sum(&[&p, &q]);
            let context = format!("turned by {quaternion:?}");
            row.check(&turned, &context);
            assert_eq!(meetings(&p, &q), row.meetings, "{} {context}", row.name());
            assert!(turned.same_set(&sum.transformed(&turn)), "{} {context}", row.name());
        }
    }
}

/// The hull takes all pairwise sums: 230,000 points for two ellipsoids.
#[test]
fn every_sum_by_hull_in_both_orders_and_turned() {
    for row in pairs() {
        let [p, q] = [&row.summands[0], &row.summands[1]];
        let sum = minkowski_sum_by_hull(&[p, q]);
        row.check(&sum, "by hull");
        assert_same(&sum, &minkowski_sum(&[p, q]), row.name());
        assert_same(&sum, &minkowski_sum_by_hull(&[q, p]), row.name());
        let small = row.vertex_sums() <= 20_000;
        for quaternion in if small { &QUATERNIONS[..] } else { &QUATERNIONS[3..4] } {
            let turn = rotation(*quaternion);
            let turned = minkowski_sum_by_hull(&[&p.transformed(&turn), &q.transformed(&turn)]);
            row.check(&turned, "by hull, turned");
            assert!(turned.same_set(&sum.transformed(&turn)), "{} turned by {quaternion:?}", row.name());
        }
    }
}

#[test]
fn the_three_tetrahedra() {
    let row = SumRow::all().into_iter().find(|row| row.summands.len() == 3).expect("a sum of three");
    // k tetrahedra have at most 5k^2 - k facets.
    assert_eq!((row.counts, row.volume.is_some()), ([38, 78, 42], true));
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for quaternion in QUATERNIONS {
            let turn = rotation(quaternion);
            let turned = order.map(|i: usize| row.summands[i].transformed(&turn));
            let sum = minkowski_sum(&turned.each_ref());
            let context = format!("{order:?} {quaternion:?}");
            row.check(&sum, &context);
            assert_same(&sum, &minkowski_sum_by_hull(&turned.each_ref()), context);
        }
    }
}

#[test]
fn sums_of_the_maximal_family_have_the_greatest_number_of_facets() {
    let sizes = [4, 5, 7, 11, 21];
    for m in sizes {
        for n in sizes {
            let p = model(&format!("maxfacets/p{m}.off"));
            let q = model(&format!("maxfacets/p{n}_rot90y.off"));
            let facets = 4 * m * n + 26 - 9 * (m + n);
            for sum in [minkowski_sum(&[&p, &q]), minkowski_sum(&[&q, &p]), minkowski_sum_by_hull(&[&p, &q])]
            {
                assert_eq!(sum.counts().facets, facets, "{m} and {n}");
                assert_eq!(sum.check_valid(), [], "{m} and {n}");
            }
        }
    }
}
