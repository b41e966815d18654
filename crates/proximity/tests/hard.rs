//! Vertices of very high degree and facets with thousands of corners: right answers, and within a bound on time that only a wrong
//! kind of algorithm exceeds.

#![allow(clippy::print_stdout, reason = "tests print how long they took")]

use exact::{Rational, Vector3};
use polytope::Polytope;
use splitstar_proximity::{Feature, Relation, RelativePlacement, Translation};
use std::time::{Duration, Instant};
use testkit::{bipyramid, prism};

const CORNERS: usize = 1_000;
/// Many times what is needed on a slow machine.
const BOUND: Duration = Duration::from_secs(60);

fn within_bound(name: &str, work: impl FnOnce()) {
    let begin = Instant::now();
    work();
    let took = begin.elapsed();
    println!("{name}: {took:.1?}");
    assert!(took < BOUND, "{name}: {took:?}");
}

/// The heights of the highest and the lowest vertex.
fn heights(polytope: &Polytope) -> [Rational; 2] {
    let heights = || polytope.points().iter().map(|point| point.coordinate(2));
    [heights().max(), heights().min()].map(|height| height.expect("there are vertices"))
}

fn at(x: i64, height: &Rational) -> Translation {
    let tenth = Rational::new(x.into(), 10.into()).expect("ten is not zero");
    Translation::new(&[tenth, Rational::ZERO, height.clone()])
}

#[test]
fn a_vertex_of_the_sum_has_a_thousand_edges() {
    let spindle = bipyramid(CORNERS, 3);
    let [high, low] = heights(&spindle);
    let top = &high - &low;
    within_bound("bipyramids", || {
        let of = RelativePlacement::new(&spindle, &spindle);
        let apex = of.sum().points().iter().position(|point| point.coordinate(2) == top);
        let apex = polytope::VertexId(apex.expect("the apexes meet") as u32);
        assert_eq!(of.sum().mesh().vertex_cycle(apex).count(), CORNERS);
        let mut hint = None;
        for (height, relation) in [
            (top.clone(), Relation::Touching),
            (&top + &Rational::ONE, Relation::Disjoint),
            (&top - &"1/1000000".parse().expect("a number"), Relation::Overlapping),
        ] {
            let s = at(0, &height);
            for hint in [None, hint] {
                let separation = of.separation(&s, hint);
                assert_eq!(separation.relation(), relation);
                assert_eq!(of.relation(&s, hint).0, relation);
                if relation == Relation::Overlapping {
                    let found = of.minimum_penetration(&s, hint).expect("they overlap").squared_depth();
                    let away = &top - &height;
                    assert!(found < &away * &away && found.to_string() != "0");
                } else {
                    let gap = &height - &top;
                    assert_eq!(separation.squared_distance(), &gap * &gap);
                    assert!(matches!(separation.features(), [Feature::Vertex(_), Feature::Vertex(_)]));
                }
            }
            hint = Some(of.separation(&s, None).witness());
        }
    });
}

#[test]
fn a_facet_of_the_sum_has_thousands_of_corners() {
    // Polygons of different numbers of corners: few edges of one are parallel to edges of the other.
    let (plate, other) = (prism(CORNERS, 2), prism(CORNERS + 1, 2));
    let top = &heights(&plate)[0] - &heights(&other)[1];
    within_bound("prisms", || {
        let of = RelativePlacement::new(&plate, &other);
        let corners = |f| of.sum().facet_cycle(f).count();
        let greatest = of.sum().mesh().facets().map(corners).max().expect("there are facets");
        assert!(greatest >= CORNERS, "{greatest}");
        for (x, height, relation) in [
            (1, top.clone(), Relation::Touching),
            (-13, &top + &Rational::ONE, Relation::Disjoint),
            (3, &top - &"1/1000".parse().expect("a number"), Relation::Overlapping),
        ] {
            let s = at(x, &height);
            let separation = of.separation(&s, None);
            assert_eq!(separation.relation(), relation);
            let gap = &height - &top;
            match relation {
                Relation::Overlapping => {
                    let found = of.minimum_penetration(&s, None).expect("they overlap");
                    assert_eq!(found.squared_depth(), &gap * &gap);
                    let up = Vector3::from_i64([0, 0, 1]);
                    let found = of.directional_penetration(&s, &up, None).expect("the direction is not zero");
                    assert_eq!(found.depth(), -gap);
                }
                _ => assert_eq!(separation.squared_distance(), &gap * &gap),
            }
        }
    });
}
