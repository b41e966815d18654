//! Who is told what, and what stamps say.

use super::scenes::{Plane, plane};
use crate::edit::{
    Done, Edit, EditOf, Mirror, MirrorDifference, Observer, Operation, Stale, Stamp, Stamped, Undo,
};
use crate::models::{Segment, SegmentTraits};
use crate::topology::BoundedPlane;
use dcel::{EndFate, FaceId, Side, VertexId};
use exact::planar::Point2;
use std::cell::RefCell;
use std::rc::Rc;

/// Writes down what it is told, and by which name it goes.
struct Log {
    name: &'static str,
    lines: Rc<RefCell<Vec<String>>>,
    is_stale: Option<Stamp>,
}

impl Log {
    fn write(&self, line: String) {
        self.lines.borrow_mut().push(format!("{}: {line}", self.name));
    }
}

impl Observer<SegmentTraits, BoundedPlane> for Log {
    fn before(&mut self, arrangement: &Plane, _: &EditOf<SegmentTraits>) {
        self.write(format!("before, {} vertices", arrangement.dcel().vertex_count()));
    }
    fn after(&mut self, arrangement: &Plane, _: &EditOf<SegmentTraits>, done: &Done) {
        self.write(format!("after, {} vertices, {done:?}", arrangement.dcel().vertex_count()));
    }
    fn begin_operation(&mut self, _: &Plane, operation: Operation) {
        self.write(format!("begin {operation:?}"));
    }
    fn end_operation(&mut self, _: &Plane, operation: Operation) {
        self.write(format!("end {operation:?}"));
    }
    fn before_global(&mut self, arrangement: &Plane) {
        self.write(format!("before all, {} edges", arrangement.dcel().edge_count()));
    }
    fn after_global(&mut self, arrangement: &Plane) {
        self.write(format!("after all, {} edges", arrangement.dcel().edge_count()));
    }
    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        self.is_stale.map_or(Ok(()), |mine| Stale::check(mine, stamp))
    }
}

fn add(x: i64) -> EditOf<SegmentTraits> {
    Edit::AddIsolatedVertex { point: Point2::from_i64([x, 0]), is_artificial: false, face: FaceId(0) }
}

fn curve() -> Segment {
    Segment::from_i64([[0, 0], [1, 0]]).expect("the ends are different")
}

/// What all observers are told that go by these names.
fn told(names: &[&str]) -> Vec<String> {
    let lines = [
        "begin InsertPoint",
        "before, 0 vertices",
        "after, 1 vertices, Vertex(VertexId(0))",
        "end InsertPoint",
        "before all, 0 edges",
        "after all, 1 edges",
    ];
    lines.iter().flat_map(|line| names.iter().map(move |name| format!("{name}: {line}"))).collect()
}

fn run(observer: &mut impl Observer<SegmentTraits, BoundedPlane>) {
    let mut arrangement = plane(&[], &[]);
    observer.begin_operation(&arrangement, Operation::InsertPoint);
    arrangement.apply(add(0), observer);
    observer.end_operation(&arrangement, Operation::InsertPoint);
    arrangement.apply_global(observer, |arrangement| arrangement.insert_curves(&[curve()]));
}

#[test]
fn observers_consist_of_observers() {
    let lines = Rc::new(RefCell::new(Vec::new()));
    let log = |name| Log { name, lines: Rc::clone(&lines), is_stale: None };
    let told_now = || std::mem::take(&mut *lines.borrow_mut());
    run(&mut ());
    assert_eq!(told_now(), Vec::<String>::new());
    run(&mut log("a"));
    assert_eq!(told_now(), told(&["a"]));
    run(&mut (log("a"), log("b")));
    assert_eq!(told_now(), told(&["a", "b"]));
    run(&mut (log("a"), &mut log("b"), log("c")));
    assert_eq!(told_now(), told(&["a", "b", "c"]));
    run(&mut (log("a"), (), None::<Log>, Some(log("d"))));
    assert_eq!(told_now(), told(&["a", "d"]));
    let mut list: Vec<Box<dyn Observer<SegmentTraits, BoundedPlane> + '_>> =
        vec![Box::new(log("a")), Box::new((log("b"), log("c")))];
    run(&mut list);
    assert_eq!(told_now(), told(&["a", "b", "c"]));
}

#[test]
fn one_part_that_is_stale_makes_all_stale() {
    let [old, new] = [plane(&[], &[]), plane(&[], &[])];
    let log = |stamp| Log { name: "", lines: Rc::default(), is_stale: Some(stamp) };
    let (fresh, stale) = (log, log);
    let stamp = new.stamp();
    assert_eq!((fresh(stamp), fresh(stamp)).check_stamp(stamp), Ok(()));
    let error = (fresh(stamp), stale(old.stamp())).check_stamp(stamp).expect_err("one is stale");
    assert_eq!((error.stamp, error.of_arrangement), (old.stamp(), stamp));
    assert!(vec![fresh(stamp), stale(old.stamp())].check_stamp(stamp).is_err());
    assert!(Some(stale(old.stamp())).check_stamp(stamp).is_err());
    let mut observer = stale(old.stamp());
    let (lent, boxed) = (&mut observer, Box::new(stale(old.stamp())));
    assert!(lent.check_stamp(stamp).is_err() && boxed.check_stamp(stamp).is_err());
    assert_eq!(Observer::<SegmentTraits, BoundedPlane>::check_stamp(&(), stamp), Ok(()));
    assert!(Observer::<SegmentTraits, BoundedPlane>::check_stamp(&Mirror::new(&old), stamp).is_err());
    assert!(Observer::<SegmentTraits, BoundedPlane>::check_stamp(&Undo::new(&old), stamp).is_err());
}

#[test]
fn stamps_change_with_every_change() {
    let mut arrangement = plane(&[], &[]);
    let mut stamps = vec![arrangement.stamp()];
    let copy = arrangement.clone();
    assert_eq!(copy.stamp(), arrangement.stamp(), "a clone has the same contents");
    arrangement.apply(add(0), &mut ());
    stamps.push(arrangement.stamp());
    arrangement.insert_curves(&[curve()]);
    stamps.push(arrangement.stamp());
    arrangement.apply_global(&mut (), |_| ());
    stamps.push(arrangement.stamp());
    stamps.push(plane(&[], &[]).stamp());
    for (i, stamp) in stamps.iter().enumerate() {
        assert!(!stamps[..i].contains(stamp), "{i}");
    }
    assert_eq!(copy.stamp(), stamps[0]);
}

#[test]
fn what_is_stale_is_not_given() {
    let mut arrangement = plane(&[], &[]);
    let mut names = Stamped::new(&arrangement, vec!["the plane"]);
    assert!(names.is_current(&arrangement) && names.get(&arrangement).is_ok());
    arrangement.apply(add(0), &mut ());
    assert!(!names.is_current(&arrangement) && names.get_mut(&arrangement).is_err());
    names.renew(&arrangement).push("a point");
    assert_eq!(names.get(&arrangement), Ok(&vec!["the plane", "a point"]));
    assert!(names.get(&plane(&[], &[])).is_err(), "another arrangement");
    assert_eq!(names.into_inner().len(), 2);
}

#[test]
fn a_mirror_notices_what_it_is_not_told() {
    let mut arrangement = plane(&[[0, 0, 2, 0]], &[]);
    let mut mirror = Mirror::new(&arrangement);
    assert!(mirror.equals(&arrangement));
    arrangement.apply(add(5), &mut ());
    assert_eq!(mirror.difference(&arrangement, |_, _| true), Some(MirrorDifference::Track));
    arrangement.apply(add(6), &mut mirror);
    assert!(!mirror.equals(&arrangement), "it was told of the second point only");
    arrangement.apply_global(&mut mirror, |_| ());
    assert!(mirror.equals(&arrangement));
    // Behind its back, without a stamp.
    let good = arrangement.clone();
    arrangement.supports[0] = 7;
    assert!(matches!(mirror.difference(&arrangement, |_, _| true), Some(MirrorDifference::Support(_))));
    arrangement = good.clone();
    arrangement.is_artificial[1] = true;
    assert_eq!(mirror.difference(&arrangement, |_, _| true), Some(MirrorDifference::Vertex(VertexId(1))));
    arrangement = good.clone();
    arrangement.curves.push(curve());
    assert!(matches!(mirror.difference(&arrangement, |_, _| true), Some(MirrorDifference::Curve(_))));
    arrangement = good;
    arrangement.curves[0] = curve();
    assert!(mirror.difference(&arrangement, |_, _| true).is_none() && !mirror.equals(&arrangement));
}

#[test]
fn undo_goes_no_further_than_it_knows() {
    let mut arrangement = plane(&[], &[]);
    let mut undo = Undo::new(&arrangement);
    assert_eq!(undo.take_back(&mut arrangement, &mut ()), Ok(false));
    arrangement.apply(add(0), &mut undo);
    arrangement.apply(add(1), &mut ());
    assert!(undo.take_back(&mut arrangement, &mut ()).is_err(), "it was not told of the last point");
    arrangement.apply(add(2), &mut undo);
    assert_eq!(undo.operation_count(), 1);
    assert_eq!(undo.take_back(&mut arrangement, &mut ()), Ok(true));
    assert_eq!(undo.take_back(&mut arrangement, &mut ()), Ok(false));
    assert_eq!(arrangement.dcel().vertex_count(), 2);
    arrangement.apply(add(3), &mut undo);
    arrangement.apply_global(&mut undo, |_| ());
    assert_eq!(undo.operation_count(), 0, "all was replaced");
}

/// A recorder that is told of the undoing, too, stays as it is.
#[test]
fn undo_among_those_who_are_told() {
    let mut arrangement = plane(&[], &[]);
    let mut observers = (Undo::new(&arrangement), Mirror::new(&arrangement));
    for x in 0..3 {
        observers.begin_operation(&arrangement, Operation::InsertPoint);
        arrangement.apply(add(x), &mut observers);
        arrangement.apply(add(x + 10), &mut observers);
        observers.end_operation(&arrangement, Operation::InsertPoint);
    }
    observers.begin_operation(&arrangement, Operation::InsertPoint);
    observers.end_operation(&arrangement, Operation::InsertPoint);
    for left in (0..3).rev() {
        let recorded = observers.0.pop().expect("there are operations");
        assert_eq!(recorded.take_back(&mut arrangement, &mut observers), Ok(()));
        assert_eq!((observers.0.operation_count(), arrangement.dcel().vertex_count()), (left, 2 * left));
        assert!(observers.1.equals(&arrangement));
    }
    assert!(observers.0.pop().is_none());
}

#[test]
#[should_panic(expected = "a vertex that stands for a side is not removed")]
fn infinity_is_not_removed() {
    let mut arrangement = super::scenes::whole_plane(&[(2, [0, 0, 1, 0])], &[]);
    let e = arrangement.dcel().edges().next().expect("a line is an edge");
    let edit = Edit::RemoveEdge { e, ends: [EndFate::Remove; 2], survivor: Side::Even };
    arrangement.apply(edit, &mut ());
}

#[test]
#[should_panic(expected = "u grows from one edge to the other")]
fn edges_that_come_from_one_side_are_not_merged() {
    let mut arrangement = plane(&[[0, 0, 2, 0], [0, 0, 2, 1]], &[]);
    let v = arrangement.vertices().find(|&v| arrangement.dcel().degree(v) == 2).expect("both begin there");
    let kept = arrangement.dcel().edges().next().expect("there are two");
    arrangement.apply(Edit::MergeEdges { kept, v }, &mut ());
}
