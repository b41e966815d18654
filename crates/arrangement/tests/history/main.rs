//! Arrangements with history: whatever comes and goes, what is left is the arrangement of the inputs that are left.

#[path = "../common/drawn.rs"]
mod drawn;
mod rows;
mod script;

use drawn::{grid_point, linear};
use exact::Rational;
use exact::planar::Point2;
use script::{Pool, play};
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{
    LinearTraits, MinimalSegmentTraits, Segment, SegmentTraits, TorusSegmentTraits,
};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use splitstar_arrangement::wrappers::{ConsolidatedTraits, DataSet, WithData};
use testkit::Rng;

/// Two different points.
fn ends(rng: &mut Rng, size: u64) -> [Point2; 2] {
    loop {
        let ends = [grid_point(rng, size), grid_point(rng, size)];
        if ends[0] != ends[1] {
            return ends;
        }
    }
}

fn segment(rng: &mut Rng, size: u64) -> Segment {
    let [p, q] = ends(rng, size);
    Segment::new(p, q).expect("the ends are different")
}

#[test]
fn segments() {
    for seed in 1..60 {
        let size = 3 + seed % 4;
        let curve = move |rng: &mut Rng| segment(rng, size);
        let point = move |rng: &mut Rng| grid_point(rng, size);
        let pool = Pool { traits: SegmentTraits, curve: &curve, point: &point };
        play(BoundedPlane, &pool, seed, 25, |_, _| {});
    }
}

#[test]
fn lines_and_rays() {
    for seed in 1..60 {
        let size = 2 + seed % 4;
        let curve = move |rng: &mut Rng| {
            let ends = ends(rng, size);
            linear(rng, ends).unwrap()
        };
        let point = move |rng: &mut Rng| grid_point(rng, size);
        let pool = Pool { traits: LinearTraits, curve: &curve, point: &point };
        play(UnboundedPlane, &pool, seed, 25, |_, _| {});
    }
}

/// Segments with numbers: the support of an edge has those of all segments that are left there.
#[test]
fn segments_with_data() {
    for seed in 1..60 {
        let size = 3 + seed % 3;
        let curve = move |rng: &mut Rng| {
            let segment = segment(rng, size);
            WithData::new(segment, DataSet::single(rng.below(1000)))
        };
        let point = move |rng: &mut Rng| grid_point(rng, size);
        let traits = ConsolidatedTraits::<_, u64>::consolidated(SegmentTraits);
        let pool = Pool { traits, curve: &curve, point: &point };
        play(BoundedPlane, &pool, seed, 25, |made, context| {
            for e in made.dcel().edges() {
                let data = made.curves_of(e).flat_map(|id| made.curve(id).unwrap().data.iter().copied());
                assert_eq!(made.curve_of(e).data, data.collect::<DataSet<u64>>(), "{context}");
            }
        });
    }
}

/// Polylines that turn, run back upon themselves, and have joints in common.
#[test]
fn polylines() {
    for seed in 1..40 {
        let size = 3 + seed % 3;
        let traits = PolycurveTraits::new(MinimalSegmentTraits);
        let maker = traits;
        let curve = move |rng: &mut Rng| {
            let count = 2 + rng.index(4);
            let vertices: Vec<Point2> = (0..count).map(|_| grid_point(rng, size)).collect();
            maker.make_polyline(vertices).unwrap()
        };
        let point = move |rng: &mut Rng| grid_point(rng, size);
        let pool = Pool { traits, curve: &curve, point: &point };
        play(BoundedPlane, &pool, seed, 20, |_, _| {});
    }
}

#[test]
fn paths_on_a_torus() {
    for seed in 1..60 {
        let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
        let (paths, points) = (traits.clone(), traits.clone());
        let curve = move |rng: &mut Rng| {
            let start = grid_point(rng, 4);
            loop {
                let way = [(); 2].map(|()| Rational::from(rng.below(9) as i64 - 4));
                if let Ok(path) = paths.path(&start, &way) {
                    return path;
                }
            }
        };
        let point = move |rng: &mut Rng| points.point(&grid_point(rng, 4));
        let pool = Pool { traits, curve: &curve, point: &point };
        play(FlatTorus, &pool, seed, 15, |_, _| {});
    }
}
