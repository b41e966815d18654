//! Arcs that carry numbers: every edge has those of all curves that run along it.

use crate::arcs::{Arc, Curve};
use crate::families::rows;
use crate::own::{own, traits_of};
use crate::random::random_curves;
use crate::space::{P, cross, is_zero};
use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
use splitstar_arrangement::overlay::overlay_all;
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::traits::CurveEnd;
use splitstar_arrangement::wrappers::{ConsolidatedTraits, DataSet, WithData};
use splitstar_arrangement::{Arrangement, Editor};
use testkit::Rng;

type Traits = ConsolidatedTraits<GeodesicTraits, u32>;
type Made = Arrangement<Traits, Sphere>;
type Numbered = WithData<Geodesic, DataSet<u32>>;

/// Checks the numbers of all edges; tells how many edges have several.
fn check(made: &Made, arcs: &[Arc], context: &str) -> usize {
    assert_eq!(made.check_valid(), [], "{context}");
    let mut count = 0;
    for e in made.dcel().edges() {
        let curve = made.make_edge_curve(e);
        let normal: P = curve.curve.circle().coordinates();
        let ends = CurveEnd::BOTH.map(|end| curve.curve.end(end).coordinates());
        let edge = Arc { normal, ends: Some(ends) };
        let inner = edge.inner_points();
        let runs_along = |arc: &Arc| {
            !arc.is_point() && is_zero(&cross(&arc.normal, &edge.normal)) && inner.iter().all(|p| arc.has(p))
        };
        let expected: Vec<u32> = (0..).zip(arcs).filter(|(_, arc)| runs_along(arc)).map(|(i, _)| i).collect();
        let found: Vec<u32> = made.curve_of(e).data.iter().copied().collect();
        assert_eq!(found, expected, "{edge:?}, {context}");
        count += usize::from(found.len() > 1);
    }
    count
}

fn check_routes(curves: &[Curve], identification: [i64; 2], rng: &mut Rng, context: &str) -> usize {
    let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
    let number = |(i, curve)| WithData::new(curve, DataSet::single(i));
    let numbered: Vec<Numbered> = (0..).zip(own(curves)).map(number).collect();
    let traits = || Traits::consolidated(traits_of(identification));
    let swept: Made = Arrangement::of_curves(traits(), Sphere, &numbered);
    let count = check(&swept, &arcs, context);
    let mut shuffled = numbered;
    rng.shuffle(&mut shuffled);
    let mut editor = Editor::new(Arrangement::new(traits(), Sphere));
    shuffled.iter().for_each(|curve| drop(editor.insert_curve(curve)));
    check(&editor, &arcs, &format!("one by one, {context}"));
    assert_eq!(editor.difference(&swept), None, "{context}");
    let (first, last) = shuffled.split_at(rng.index(shuffled.len() + 1));
    let halves = [first, last].map(|half| Arrangement::of_curves(traits(), Sphere, half));
    let overlay = overlay_all(&halves.each_ref()).0;
    check(&overlay, &arcs, &format!("overlay, {context}"));
    assert_eq!(overlay.difference(&swept), None, "{context}");
    count
}

#[test]
fn families_with_numbers() {
    let mut rng = Rng::new(81);
    let mut count = 0;
    for row in rows() {
        let identification = *rng.choose(&[[-1, 0], [0, 1], [1, 2]]);
        let context = format!("{}, {identification:?}: {:?}", row.name, row.curves);
        count += check_routes(&row.curves, identification, &mut rng, &context);
    }
    assert!(count > 200, "{count}");
}

#[test]
fn random_curves_with_numbers() {
    let mut rng = Rng::new(82);
    let mut count = 0;
    for case in 0..600 {
        let seed = rng.state();
        let curves = random_curves(&mut rng, 2 + case % 14, 1 + case as i64 % 2);
        let identification = *rng.choose(&[[-1, 0], [0, 1], [1, 1]]);
        let context = format!("case {case}, seed {seed}, {identification:?}: {curves:?}");
        count += check_routes(&curves, identification, &mut rng, &context);
    }
    assert!(count > 300, "{count}");
}
