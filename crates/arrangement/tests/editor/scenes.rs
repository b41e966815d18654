//! Degenerate random curves of several families, and what every test checks.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use crate::drawn::{grid_point, linear};
use crate::swept_again::swept_again;
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::edit::{Mirror, Undo};
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use splitstar_arrangement::traits::{ArrangementTraits, UMonotoneTraits};
use splitstar_arrangement::{Arrangement, Editor};
use testkit::Rng;

/// Curves and points of one family.
pub(crate) struct Scene<G: ArrangementTraits, T> {
    pub(crate) traits: G,
    pub(crate) topology: T,
    pub(crate) curves: Vec<G::Curve>,
    pub(crate) points: Vec<Point2>,
}

impl<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>> Scene<G, T> {
    /// The arrangement of the first curves and of all points.
    pub(crate) fn sweep(&self, count: usize) -> Arrangement<G, T> {
        let (traits, points) = (self.traits.clone(), self.points.iter().cloned());
        Arrangement::of_curves_and_points(traits, self.topology.clone(), &self.curves[..count], points)
    }

    pub(crate) fn sweep_all(&self) -> Arrangement<G, T> {
        self.sweep(self.curves.len())
    }

    pub(crate) fn empty(&self) -> Arrangement<G, T> {
        Arrangement::new(self.traits.clone(), self.topology.clone())
    }
}

/// Something that holds for every scene of every family.
pub(crate) trait Law {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>;
}

fn point(rng: &mut Rng, size: u64) -> Point2 {
    let denominator = if rng.one_in(6) { 2_i64 } else { 1 };
    let coordinate = |rng: &mut Rng| {
        let numerator = rng.below(size * denominator as u64) as i64;
        Rational::new(numerator.into(), denominator.into()).unwrap()
    };
    let [u, v] = [coordinate(rng), coordinate(rng)];
    Point2::from_rationals(&[u, v])
}

fn points(rng: &mut Rng, size: u64) -> Vec<Point2> {
    (0..rng.below(4)).map(|_| point(rng, size)).collect()
}

/// Checks a law on so many scenes of each family.
pub(crate) fn for_all(law: &impl Law, cases: u64, seed: u64) {
    for case in 0..cases {
        let mut rng = Rng::new(seed + case);
        println!("seed {}", seed + case);
        let size = 3 + rng.below(4);
        let curves = (0..1 + rng.below(9))
            .filter_map(|_| Segment::new(point(&mut rng, size), point(&mut rng, size)))
            .collect();
        let points = points(&mut rng, size);
        let (traits, topology) = (SegmentTraits, BoundedPlane);
        law.check(&Scene { traits, topology, curves, points }, &mut rng);

        let curves = (0..1 + rng.below(7))
            .filter_map(|_| {
                let points = two_points(&mut rng, size);
                linear(&mut rng, points)
            })
            .collect();
        let (traits, topology) = (LinearTraits, UnboundedPlane);
        let points = self::points(&mut rng, size);
        law.check(&Scene { traits, topology, curves, points }, &mut rng);

        let traits = PolycurveTraits::new(SegmentTraits);
        let polyline = |rng: &mut Rng| {
            let length = 2 + rng.below(4);
            traits.make_polyline((0..length).map(|_| point(rng, size)).collect::<Vec<_>>()).ok()
        };
        let curves = (0..1 + rng.below(4)).filter_map(|_| polyline(&mut rng)).collect();
        let (topology, points) = (BoundedPlane, self::points(&mut rng, size));
        law.check(&Scene { traits, topology, curves, points }, &mut rng);

        let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
        let path = |rng: &mut Rng| {
            let start = grid_point(rng, 4);
            if rng.one_in(3) {
                return traits.closed_path(&start, [rng.within(2), rng.within(2)]).ok();
            }
            let way = [rng.within(5), rng.within(5)].map(Rational::from);
            traits.path(&start, &way).ok()
        };
        let curves = (0..1 + rng.below(5)).filter_map(|_| path(&mut rng)).collect();
        let (topology, points) = (FlatTorus, self::points(&mut rng, 4));
        law.check(&Scene { traits: traits.clone(), topology, curves, points }, &mut rng);
    }
}

fn two_points(rng: &mut Rng, size: u64) -> [Point2; 2] {
    [point(rng, size), point(rng, size)]
}

/// An editor with a copy of the cells that is kept by what observers are told, and a record of operations.
pub(crate) type Watched<G, T> = Editor<G, T, (Mirror<G>, Undo<G>)>;

pub(crate) fn watch<G: UMonotoneTraits, T: Topology<G>>(arrangement: Arrangement<G, T>) -> Watched<G, T> {
    let observers = (Mirror::new(&arrangement), Undo::new(&arrangement));
    Editor::with_observers(arrangement, observers).unwrap()
}

/// The arrangement is valid, the copy is the same, and a sweep of its edges and isolated vertices gives it again.
pub(crate) fn check<G: UMonotoneTraits + Clone, T: Topology<G>>(editor: &Watched<G, T>) {
    let arrangement = editor.arrangement();
    assert_eq!(arrangement.check_valid(), []);
    let is_shown_alike = |a: &_, b: &_| format!("{a:?}") == format!("{b:?}");
    assert_eq!(editor.observers().0.difference(arrangement, is_shown_alike), None);
    assert_eq!(arrangement.difference(&swept_again(arrangement)), None);
}

/// Takes all operations back, and expects the states that were.
pub(crate) fn take_back<G: UMonotoneTraits + Clone, T: Topology<G>>(
    editor: &mut Watched<G, T>,
    mut states: Vec<Arrangement<G, T>>,
) {
    while let Some(recorded) = editor.observers_mut().1.pop() {
        editor.take_back(recorded).unwrap();
        let before = states.pop().unwrap();
        assert_eq!(before.difference(editor.arrangement()), None);
        assert!(before.dcel().edges().eq(editor.arrangement().dcel().edges()), "ids come again");
        check(editor);
    }
    assert!(states.is_empty(), "every operation was recorded");
}
