//! Curves and points one by one, in random orders, against one sweep.

use crate::curves::{Curve, P, at, fraction};
use crate::family::{CurveOf, Family};
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::rows::rows;
use crate::torus_oracle::TorusCurve;
use crate::torus_rows::{period, rows as torus_rows};
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{TorusPath, TorusSegmentTraits};
use splitstar_arrangement::topology::{FlatTorus, Topology};
use splitstar_arrangement::traits::ArrangementTraits;
use splitstar_arrangement::{Arrangement, Counts, Editor};
use testkit::Rng;

/// Something to insert.
#[derive(Clone, Debug)]
enum Item<C> {
    Curve(C),
    Point(Point2),
}

/// Orders in which each family is inserted.
const ORDERS: usize = 4;

/// Inserts items in random orders, and compares with one sweep, which must have the cells that the table says.
fn check<G, T>(traits: &G, topology: &T, items: &[Item<G::Curve>], counts: Counts, rng: &mut Rng, name: &str)
where
    G: ArrangementTraits<Point = Point2> + Clone,
    T: Topology<G>,
{
    let curves = items.iter().filter_map(|item| match item {
        Item::Curve(curve) => Some(curve),
        Item::Point(_) => None,
    });
    let points = items.iter().filter_map(|item| match item {
        Item::Curve(_) => None,
        Item::Point(point) => Some(point.clone()),
    });
    let swept = Arrangement::of_curves_and_points(traits.clone(), topology.clone(), curves, points);
    assert_eq!(swept.counts(), counts, "{name}");
    for order in 0..ORDERS {
        let context = format!("{name}, order {order}, seed {}", rng.state());
        let mut order: Vec<&Item<G::Curve>> = items.iter().collect();
        rng.shuffle(&mut order);
        let mut editor = Editor::new(Arrangement::new(traits.clone(), topology.clone()));
        for item in order {
            match item {
                Item::Curve(curve) => {
                    let edges = editor.insert_curve(curve);
                    assert!(!edges.is_empty(), "{context}");
                }
                Item::Point(point) => {
                    editor.insert_point(point);
                }
            }
            assert_eq!(editor.check_valid(), [], "{context}");
        }
        assert_eq!(editor.counts(), counts, "{context}");
        assert_eq!(editor.counts_with_splits(), swept.counts_with_splits(), "{context}");
        assert_eq!(editor.difference(&swept), None, "{context}");
        assert!(editor.is_isomorphic(&swept), "{context}");
    }
}

fn counts_of([vertices, edges, faces, isolated, components]: [usize; 5]) -> Counts {
    Counts { vertices, edges, faces, isolated, components }
}

fn items_of<M: Model>(model: &M, curves: &[Curve]) -> Option<Vec<Item<CurveOf<M>>>> {
    let (own, points) = model.own(curves)?;
    Some(own.into_iter().map(Item::Curve).chain(points.into_iter().map(Item::Point)).collect())
}

/// Checks all rows that a model can carry.
fn run(model: &impl Model) {
    let mut rng = Rng::new(20_261_122);
    let mut run = 0;
    for row in rows() {
        let Some(items) = items_of(model, &row.curves) else { continue };
        let name = format!("{model:?}, {}", row.name);
        check(&model.traits(), &model.surface(), &items, counts_of(row.counts), &mut rng, &name);
        run += 1;
    }
    assert!(run > 60, "{run}");
}

#[test]
fn segments() {
    run(&Segments);
}

#[test]
fn minimal_segments() {
    run(&MinimalSegments);
}

#[test]
fn linear_curves() {
    run(&Linears);
}

#[test]
fn polylines() {
    run(&Polylines);
}

#[test]
fn polycurves_of_linear_curves() {
    run(&Polylinears);
}

#[test]
fn segments_with_data() {
    run(&Numbered);
}

#[test]
fn torus_with_seams_through_the_origin() {
    run(&WideTorus::new([100, 90], at(0, 0)));
}

#[test]
fn torus_with_seams_between_integers() {
    run(&WideTorus::new([61, 57], [fraction(-1, 2), fraction(-2, 3)]));
}

/// What the edges carry, with their ends.
fn data<T: Topology<<Numbered as Family>::Traits>>(
    made: &Arrangement<<Numbered as Family>::Traits, T>,
) -> Vec<([P; 2], Vec<u32>)> {
    let of = |e| {
        let ends = made.dcel().ends(e).map(|v| made.point(v).expect("segments are bounded").coordinates());
        (ends, made.curve_of(e).data.iter().copied().collect())
    };
    let mut all: Vec<_> = made.dcel().edges().map(of).collect();
    all.sort();
    all
}

/// Where curves overlap, the edge has the data of both, whichever was there first.
#[test]
fn data_of_overlaps_unite() {
    let mut rng = Rng::new(77);
    let mut united = 0;
    for row in rows() {
        let Some((curves, points)) = Numbered.own(&row.curves) else { continue };
        let (traits, surface) = (Numbered.traits(), Numbered.surface());
        let swept = Arrangement::of_curves_and_points(traits, surface, &curves, points.clone());
        let expected = data(&swept);
        united += expected.iter().filter(|(_, numbers)| numbers.len() > 1).count();
        for _ in 0..ORDERS {
            let seed = rng.state();
            let mut order: Vec<_> = curves.iter().collect();
            rng.shuffle(&mut order);
            let mut editor = Editor::new(Arrangement::new(traits, surface));
            for curve in order {
                editor.insert_curve(curve);
            }
            points.iter().for_each(|point| {
                editor.insert_point(point);
            });
            assert_eq!(data(&editor), expected, "{}, seed {seed}", row.name);
        }
    }
    assert!(united > 100, "{united}");
}

/// The curves of a row on the torus: as paths, and as polylines with a joint.
type TorusItems = (Vec<Item<TorusPath>>, Vec<Option<[Point2; 3]>>);

fn torus_items(traits: &TorusSegmentTraits, curves: &[TorusCurve]) -> TorusItems {
    let place = |p: &P| Point2::from_rationals(p);
    let middle =
        |p: &P, way: &P, quarters: i64| place(&[0, 1].map(|i| &p[i] + &way[i] * fraction(quarters, 4)));
    let item = |curve: &TorusCurve| match curve {
        TorusCurve::Point(p) => (Item::Point(traits.point(&place(p))), None),
        TorusCurve::Path(p, way) => {
            let path = traits.path(&place(p), way).expect("the path is short");
            (Item::Curve(path), Some([0, 1, 4].map(|quarters| middle(p, way, quarters))))
        }
        TorusCurve::Closed(p, winding) => {
            let path = traits.closed_path(&place(p), *winding).expect("the path is short");
            let way = [0, 1].map(|i| fraction(winding[i], 1) * &traits.period()[i]);
            (Item::Curve(path), Some([0, 2, 4].map(|quarters| middle(p, &way, quarters))))
        }
    };
    curves.iter().map(item).unzip()
}

#[test]
fn curves_round_a_torus() {
    let traits = TorusSegmentTraits::new(period()).expect("the periods are positive");
    let mut rng = Rng::new(5);
    for row in torus_rows() {
        let (items, _) = torus_items(&traits, &row.curves);
        check(&traits, &FlatTorus, &items, counts_of(row.counts), &mut rng, row.name);
    }
}

/// A polyline of a closed geodesic is closed, too, and so is one of a path that closes, which has an end else.
#[test]
fn polylines_round_a_torus() {
    let inner = TorusSegmentTraits::new(period()).expect("the periods are positive");
    let traits = PolycurveTraits::new(inner.clone());
    let mut rng = Rng::new(6);
    for row in torus_rows() {
        let (items, vertices) = torus_items(&inner, &row.curves);
        let make = |(item, vertices): (Item<TorusPath>, Option<[Point2; 3]>)| match (item, vertices) {
            (Item::Curve(_), Some(vertices)) => {
                Item::Curve(traits.make_cover_polyline(vertices).expect("the polyline is short"))
            }
            (Item::Point(point), _) => Item::Point(point),
            (Item::Curve(_), None) => unreachable!("a curve has vertices"),
        };
        let items: Vec<_> = items.into_iter().zip(vertices).map(make).collect();
        let swept = sweep(&traits, &items);
        check(&traits, &FlatTorus, &items, swept.counts(), &mut rng, row.name);
    }
}

type Polyline = <PolycurveTraits<TorusSegmentTraits> as ArrangementTraits>::Curve;

fn sweep(
    traits: &PolycurveTraits<TorusSegmentTraits>,
    items: &[Item<Polyline>],
) -> Arrangement<PolycurveTraits<TorusSegmentTraits>, FlatTorus> {
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    for item in items {
        match item {
            Item::Curve(curve) => curves.push(curve),
            Item::Point(point) => points.push(point.clone()),
        }
    }
    Arrangement::of_curves_and_points(traits.clone(), FlatTorus, curves, points)
}
