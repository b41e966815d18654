//! The tasks of the table, what must be found, who else runs, and what must be reached.

use super::once::Counts;
use super::task::{Family, Operation, Question, Strategy, Task};

/// Another program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Peer {
    /// CGAL, 2D Arrangements over its exact kernel.
    Cgal,
    /// GEOS, noding with floating-point numbers: no faces, and rounded vertices.
    Geos,
    /// Ourselves without history.
    Plain,
}

impl Peer {
    /// Whether its counts must be ours.
    pub(super) fn is_exact(self) -> bool {
        self != Peer::Geos
    }
}

impl std::fmt::Display for Peer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Peer::Cgal => "CGAL",
            Peer::Geos => "GEOS",
            Peer::Plain => "no history",
        })
    }
}

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// Processor seconds.
    Seconds,
    /// Peak memory of a process that does the task once.
    Memory,
}

impl std::fmt::Display for Measure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Measure::Seconds => "less time",
            Measure::Memory => "less memory",
        })
    }
}

/// We need that many times less than the peer.
#[derive(Debug)]
pub(super) struct Requirement {
    pub(super) factor: f64,
    pub(super) measure: Measure,
    pub(super) than: Peer,
}

/// Our task without history, for a task with it.
pub(super) fn plain(task: &Task) -> Option<Task> {
    let operation = match task.operation {
        Operation::History => Operation::Ready,
        Operation::InsertHistory => Operation::Insert,
        _ => return None,
    };
    Some(Task { operation, ..*task })
}

/// A task and all that is asked of it.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) task: Task,
    /// Of the arrangement, edges and vertices of splits included, but not on a sphere; for location, of the one where points are located.
    pub(super) counts: Counts,
    /// How many cells curves meet, each as often as it is met.
    pub(super) zone: Option<usize>,
    pub(super) peers: &'static [Peer],
    pub(super) requirements: &'static [Requirement],
    /// How many microseconds a query may take at most.
    pub(super) microseconds: Option<f64>,
}

/// History may cost a third of the time without it.
const PLAIN: f64 = 0.75;

const fn times(factor: f64, than: Peer) -> Requirement {
    Requirement { factor, measure: Measure::Seconds, than }
}

const fn task(operation: Operation, family: Family, count: usize) -> Task {
    Task { operation, family, count }
}

const fn counts(vertices: usize, edges: usize, faces: usize) -> Counts {
    Counts { vertices, edges, faces }
}

/// The arrangement of 300 long segments.
const LONG_300: Counts = counts(11_235, 21_570, 10_340);

/// The arrangement of 300 arcs on the sphere.
const ARCS_300: Counts = counts(6_145, 11_390, 5_247);

/// All rows. The counts are those of CGAL 5.5.1; those of `long1000` were found by brute force, too. On the sphere they are those of brute
/// force (a test finds them), without the cuts of CGAL.
pub(super) const ROWS: [Row; 32] = [
    Row {
        name: "long1000",
        task: task(Operation::Build, Family::Long, 1_000),
        counts: counts(113_476, 223_952, 110_479),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(4.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "long3000",
        task: task(Operation::Build, Family::Long, 3_000),
        counts: counts(1_034_374, 2_059_748, 1_025_377),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[
            times(4.0, Peer::Cgal),
            Requirement { factor: 3.0, measure: Measure::Memory, than: Peer::Cgal },
        ],
        microseconds: None,
    },
    Row {
        name: "short100000",
        task: task(Operation::Build, Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal, Peer::Geos],
        requirements: &[times(4.0, Peer::Cgal), times(1.0, Peer::Geos)],
        microseconds: None,
    },
    Row {
        name: "lines1000",
        task: task(Operation::Build, Family::Lines, 1_000),
        counts: counts(499_500, 1_000_000, 500_501),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(4.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "polylines1000",
        task: task(Operation::Build, Family::Polylines, 1_000),
        counts: counts(66_532, 126_009, 59_479),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(4.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "overlay1000",
        task: task(Operation::Overlay, Family::Long, 1_000),
        counts: counts(459_813, 913_626, 453_815),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(6.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "locate10000",
        task: task(Operation::Locate, Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(4.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "insert10000",
        task: task(Operation::Insert, Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(100.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "insert1000",
        task: task(Operation::Insert, Family::Long, 1_000),
        counts: counts(113_476, 223_952, 110_479),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(3.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "zone100",
        task: task(Operation::Zone, Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: Some(308),
        peers: &[Peer::Cgal],
        requirements: &[times(100.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "zone100long",
        task: task(Operation::ZoneLong, Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: Some(8_210),
        peers: &[Peer::Cgal],
        requirements: &[times(100.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "history1000",
        task: task(Operation::History, Family::Long, 1_000),
        counts: counts(113_476, 223_952, 110_479),
        zone: None,
        peers: &[Peer::Plain, Peer::Cgal],
        requirements: &[times(PLAIN, Peer::Plain)],
        microseconds: None,
    },
    Row {
        name: "history10000",
        task: task(Operation::InsertHistory, Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Plain],
        requirements: &[times(PLAIN, Peer::Plain)],
        microseconds: None,
    },
    Row {
        name: "inserthistory1000",
        task: task(Operation::InsertHistory, Family::Long, 1_000),
        counts: counts(113_476, 223_952, 110_479),
        zone: None,
        peers: &[Peer::Plain, Peer::Cgal],
        requirements: &[times(PLAIN, Peer::Plain)],
        microseconds: None,
    },
    Row {
        name: "trapezoids100000",
        task: task(Operation::Prepare(Strategy::Trapezoids), Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(10.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "ask100000",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Cell), Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "together100000",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Cells), Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: Some(1.5),
    },
    Row {
        name: "ray100000",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Above), Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "trapezoids300",
        task: task(Operation::Prepare(Strategy::Trapezoids), Family::Long, 300),
        counts: LONG_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(10.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "ask300",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Cell), Family::Long, 300),
        counts: LONG_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: Some(0.8),
    },
    Row {
        name: "ray300",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Above), Family::Long, 300),
        counts: LONG_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "landmarks10000",
        task: task(Operation::Ask(Strategy::Landmarks, Question::Cell), Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(100.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "makelandmarks10000",
        task: task(Operation::Prepare(Strategy::Landmarks), Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "walk10000",
        task: task(Operation::Ask(Strategy::Walk, Question::Cell), Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "naive10000",
        task: task(Operation::Ask(Strategy::Naive, Question::Cell), Family::Short(15), 10_000),
        counts: counts(24_539, 19_078, 584),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: None,
    },
    Row {
        name: "decompose100000",
        task: task(Operation::Decompose, Family::Short(14), 100_000),
        counts: counts(312_962, 325_924, 36_065),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(4.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "sphere1000",
        task: task(Operation::Build, Family::Arcs, 1_000),
        counts: counts(66_315, 129_630, 63_317),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(5.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "sphere3000",
        task: task(Operation::Build, Family::Arcs, 3_000),
        counts: counts(574_601, 1_140_202, 565_603),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(5.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "sphereoverlay300",
        task: task(Operation::Overlay, Family::Arcs, 300),
        counts: counts(23_871, 45_942, 22_073),
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(6.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "sphereinsert300",
        task: task(Operation::Insert, Family::Arcs, 300),
        counts: ARCS_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[times(50.0, Peer::Cgal)],
        microseconds: None,
    },
    Row {
        name: "sphereask300",
        task: task(Operation::Ask(Strategy::Trapezoids, Question::Cell), Family::Arcs, 300),
        counts: ARCS_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: Some(1.5),
    },
    Row {
        name: "spherelandmarks300",
        task: task(Operation::Ask(Strategy::Landmarks, Question::Cell), Family::Arcs, 300),
        counts: ARCS_300,
        zone: None,
        peers: &[Peer::Cgal],
        requirements: &[],
        microseconds: Some(8.0),
    },
];
