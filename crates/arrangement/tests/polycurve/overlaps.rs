//! Chains that run together, part, and run together again.

use super::{Curve, TRAITS, polyline_of};
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::{Chain, ConnectTraits, PieceTraits, PolycurveTraits};
use splitstar_arrangement::models::{Linear, LinearTraits, SegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, UnboundedPlane};
use splitstar_arrangement::traits::{CurveEnd, Intersection, Piece, UMonotoneTraits};
use splitstar_arrangement::wrappers::{ConsolidatedTraits, CountingTraits, DataSet, Method, WithData};
use splitstar_arrangement::{Arrangement, Counts};
use testkit::Rng;

/// The vertices of a path from left to right through a few gates: two such paths often have pieces in common.
fn random_path(rng: &mut Rng, length: usize) -> Vec<[i64; 2]> {
    let start = rng.index(length) as i64;
    let end = start + 1 + rng.index(length) as i64;
    (start..=end).map(|u| [2 * u, 2 * rng.index(2) as i64]).collect()
}

fn one_chain<P, C: Clone>(parts: &[Piece<P, Chain<C>>]) -> Chain<C> {
    match parts {
        [Piece::Curve { curve, .. }] => curve.clone(),
        _ => panic!("a path is one chain"),
    }
}

/// The end of each common piece is found from its beginning, and from each of its joints.
fn check_ends_of_overlaps<S: PieceTraits>(
    traits: &PolycurveTraits<S>,
    a: &Chain<S::UMonotoneCurve>,
    b: &Chain<S::UMonotoneCurve>,
    context: &str,
) -> usize {
    let mut common = Vec::new();
    traits.intersect(a, b, &mut common);
    let mut asked = 0;
    for intersection in common {
        let Intersection::Overlap(overlap) = intersection else { continue };
        let pieces = overlap.pieces();
        let end = traits.inner().end_point(&pieces[pieces.len() - 1], CurveEnd::Max);
        for piece in pieces {
            let start = traits.inner().end_point(piece, CurveEnd::Min);
            for (a, b) in [(a, b), (b, a)] {
                let found = traits.end_of_overlap(a, b, start);
                let is_same = match (&found, end) {
                    (Some(p), Some(q)) => traits.inner().is_same_point(p, q),
                    (found, end) => found.is_none() && end.is_none(),
                };
                assert!(is_same, "{context}: from {start:?} to {end:?}, not {found:?}");
                asked += 1;
            }
        }
    }
    asked
}

fn check_model<S: ConnectTraits>(
    traits: &PolycurveTraits<S>,
    point: impl Fn([i64; 2]) -> S::Point,
    seed: u64,
) -> usize {
    let mut rng = Rng::new(seed);
    let mut asked = 0;
    for round in 0..500 {
        let [a, b] = [(); 2].map(|()| {
            let vertices = random_path(&mut rng, 5);
            one_chain(traits.make_polyline(vertices.into_iter().map(&point)).unwrap().parts())
        });
        asked += check_ends_of_overlaps(traits, &a, &b, &format!("seed {seed}, round {round}"));
    }
    asked
}

#[test]
fn the_end_of_an_overlap_is_that_of_the_common_piece() {
    let asked = [
        check_model(&TRAITS(), super::point, 3001),
        check_model(&PolycurveTraits::new(SegmentTraits), Point2::from_i64, 3002),
        check_model(&PolycurveTraits::new(LinearTraits), Point2::from_i64, 3003),
    ];
    assert!(asked.iter().all(|&asked| asked > 300), "{asked:?}");
}

#[test]
fn overlaps_may_come_from_infinity_and_go_there() {
    let traits = PolycurveTraits::new(LinearTraits);
    let [o, far] = [[0, 0], [-1, 0]].map(Point2::from_i64);
    let tail = Linear::ray(o.clone(), &far).unwrap();
    let path = |turns: &[[i64; 2]], direction: [i64; 2]| {
        let points: Vec<_> = [[0, 0]].iter().chain(turns).copied().map(Point2::from_i64).collect();
        let segments = points.windows(2).map(|p| Linear::segment(p[0].clone(), p[1].clone()).unwrap());
        let last = points[points.len() - 1].clone();
        let ray = Linear::ray(last, &Point2::from_i64(direction)).unwrap();
        traits.make_polycurve([tail.clone()].into_iter().chain(segments).chain([ray])).unwrap()
    };
    let low = path(&[[2, 1]], [4, 0]);
    let high = path(&[[2, 1]], [4, 3]);
    let long = path(&[[2, 1], [4, 0]], [6, -1]);
    let [a, b, c] = [&low, &high, &long].map(|curve| one_chain(curve.parts()));
    let parting = Point2::from_i64([2, 1]);
    assert_eq!(traits.end_of_overlap(&a, &b, None), Some(parting.clone()));
    assert_eq!(traits.end_of_overlap(&a, &b, Some(&o)), Some(parting.clone()));
    // The ray and the segment with the ray after it lie on one line, and never part.
    assert_eq!(traits.end_of_overlap(&a, &c, None), None);
    assert_eq!(traits.end_of_overlap(&c, &a, Some(&parting)), None);
    let arrangement = Arrangement::of_curves(traits, UnboundedPlane, [&low, &high, &long]);
    assert_eq!(arrangement.check_valid(), []);
    let counts = arrangement.counts();
    assert_eq!([counts.vertices, counts.edges, counts.faces], [1, 3, 3]);
}

fn counted(copies: usize, teeth: i64) -> (u64, u64, Counts) {
    let traits = CountingTraits::new(PolycurveTraits::new(SegmentTraits));
    let zigzag = |from: i64, step: i64| {
        let vertices = (0..=teeth).map(|i| Point2::from_i64([i * step, from * (1 - 2 * (i % 2))]));
        PolycurveTraits::new(SegmentTraits).make_polyline(vertices).unwrap()
    };
    let bundle = zigzag(1, 2);
    let across = zigzag(-1, 2);
    let curves: Vec<_> = (0..copies).map(|_| &bundle).chain([&across]).collect();
    let arrangement = Arrangement::of_curves(traits, BoundedPlane, curves);
    let counters = arrangement.traits().counters();
    (counters.total(), counters.count(Method::Intersect), arrangement.counts())
}

/// What crosses a bundle of many curves asks as often as what crosses one.
#[test]
fn a_bundle_stays_together_where_it_is_crossed() {
    let (copies, teeth) = (100, 400);
    let (one, _, of_one) = counted(1, teeth);
    let (many, intersected, of_many) = counted(copies, teeth);
    assert_eq!((of_one.vertices, of_one.edges), (of_many.vertices, of_many.edges));
    assert!(of_one.vertices > 400);
    assert_eq!(intersected, 0, "overlaps are not looked for among all that two curves have in common");
    let of_bundle = 40 * copies as u64;
    assert!(many < one + of_bundle, "{one} calls for one curve, {many} for {copies}");
}

/// Paths through gates, as a multigraph: which of them run along each edge is known.
#[test]
fn every_edge_knows_the_paths_along_it() {
    let seed = 3004;
    let mut rng = Rng::new(seed);
    let mut deepest = 0;
    for round in 0..200 {
        let count = 2 + rng.index(15);
        let curves: Vec<Curve> = (0..count).map(|_| polyline_of(random_path(&mut rng, 3))).collect();
        let of = |order: &mut dyn Iterator<Item = usize>| {
            let traits = ConsolidatedTraits::consolidated(TRAITS());
            let curves: Vec<_> =
                order.map(|i| WithData::new(curves[i].clone(), DataSet::single(i))).collect();
            Arrangement::of_curves(traits, BoundedPlane, &curves)
        };
        let [arrangement, reversed] = [of(&mut (0..count)), of(&mut (0..count).rev())];
        let context = format!("seed {seed}, round {round}: {curves:?}");
        assert_eq!(arrangement.check_valid(), [], "{context}");
        assert_eq!(reversed.difference(&arrangement), None, "{context}");
        for e in arrangement.dcel().edges() {
            let edge = arrangement.make_edge_curve(e);
            let runs_along = |i: &usize| {
                let mut common = Vec::new();
                TRAITS().intersect(&edge.curve, &one_chain(curves[*i].parts()), &mut common);
                let is_whole = |c: &Intersection<_, Chain<_>>| matches!(c, Intersection::Overlap(chain) if same_ends(chain, &edge.curve));
                common.iter().any(is_whole)
            };
            let expected: Vec<usize> = (0..count).filter(runs_along).collect();
            assert_eq!(edge.data.iter().copied().collect::<Vec<_>>(), expected, "{context}: {edge:?}");
            deepest = deepest.max(expected.len());
        }
    }
    assert!(deepest > 5, "at most {deepest} together");
}

fn same_ends(a: &Chain<super::Segment>, b: &Chain<super::Segment>) -> bool {
    let ends = |chain: &Chain<super::Segment>| {
        let pieces = chain.pieces();
        [pieces[0].0[0].clone(), pieces[pieces.len() - 1].0[1].clone()]
    };
    ends(a) == ends(b)
}
