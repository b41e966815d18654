//! An operation and its input.

use std::fmt::Write as _;

use testkit::{
    Drawn, geodesic_arcs, lines, long_segments, polylines, query_directions, query_points, short_segments,
};

use crate::Failure;

/// Seed of the first operand.
const FIRST: u64 = 1;
/// Seed of the second operand of an overlay, and of the curves whose zones are asked for.
const SECOND: u64 = 2;
/// Curves whose zones are asked for.
const CROSSING: usize = 100;
/// Points that are located, fewer where each costs more, and their seed.
const QUERIES: usize = 10_000;
const FEW_QUERIES: usize = 200;
const QUERY_SEED: u64 = 1_000;

/// What is done; the drivers of peers have the same words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    /// Aggregated insertion into an empty arrangement.
    Build,
    /// Insertion one by one into an empty arrangement, in the order of the input.
    Insert,
    /// Removal of all edges of an arrangement that exists, in random order.
    Remove,
    /// Aggregated insertion into an empty arrangement that is ready to be edited.
    Ready,
    /// The same, and the arrangement knows from which curves its edges come.
    History,
    /// What `Insert` does, and the arrangement knows from which curves its edges come.
    InsertHistory,
    /// The cells that curves of the same family meet in an arrangement that is ready to be edited.
    Zone,
    /// The cells that long segments meet there.
    ZoneLong,
    /// Overlay of two arrangements that exist.
    Overlay,
    /// Batched location of points in an arrangement that exists.
    Locate,
    /// What a strategy does before it is asked about points of an arrangement that exists.
    Prepare(Strategy),
    /// One point after the other, by a strategy that is ready.
    Ask(Strategy, Question),
    /// Vertical decomposition of an arrangement that exists.
    Decompose,
}

/// How cells are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Strategy {
    Naive,
    Walk,
    Landmarks,
    Trapezoids,
}

/// What is asked about a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Question {
    /// Where it lies.
    Cell,
    /// Where it lies, and where others do that are handed over together.
    Cells,
    /// What a ray up meets first.
    Above,
}

/// Which curves of `testkit` are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Family {
    Long,
    /// With steps of so many bits.
    Short(u32),
    Lines,
    Polylines,
    /// Arcs of great circles.
    Arcs,
}

/// An operation on so many curves of a family; all seeds are fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Task {
    pub(crate) operation: Operation,
    pub(crate) family: Family,
    pub(crate) count: usize,
}

/// Curves of one kind, or the points of queries.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Curves {
    Segments(Vec<[i64; 4]>),
    /// Through two points each.
    Lines(Vec<[i64; 4]>),
    Polylines(Vec<Vec<[i64; 2]>>),
    /// On a sphere, between two directions each: the shorter way.
    Arcs(Vec<[i64; 6]>),
    Points(Vec<[i64; 2]>),
    /// Points of a sphere.
    Directions(Vec<[i64; 3]>),
}

/// One input of a task.
#[derive(Debug, Clone)]
pub(super) struct Operand {
    /// Names the file.
    pub(super) name: String,
    pub(super) curves: Curves,
    /// What names the curves in the measurements of every program.
    pub(super) hash: u64,
}

/// All operations, in the words of the drivers.
const WORDS: [(&str, Operation); 19] = [
    ("build", Operation::Build),
    ("insert", Operation::Insert),
    ("remove", Operation::Remove),
    ("ready", Operation::Ready),
    ("history", Operation::History),
    ("insert-history", Operation::InsertHistory),
    ("zone", Operation::Zone),
    ("zone-long", Operation::ZoneLong),
    ("overlay", Operation::Overlay),
    ("locate", Operation::Locate),
    ("make-landmarks", Operation::Prepare(Strategy::Landmarks)),
    ("make-trapezoids", Operation::Prepare(Strategy::Trapezoids)),
    ("naive", Operation::Ask(Strategy::Naive, Question::Cell)),
    ("walk", Operation::Ask(Strategy::Walk, Question::Cell)),
    ("landmarks", Operation::Ask(Strategy::Landmarks, Question::Cell)),
    ("trapezoids", Operation::Ask(Strategy::Trapezoids, Question::Cell)),
    ("trapezoids-together", Operation::Ask(Strategy::Trapezoids, Question::Cells)),
    ("ray", Operation::Ask(Strategy::Trapezoids, Question::Above)),
    ("decompose", Operation::Decompose),
];

impl Operation {
    /// Whether it finds cells, which are compared.
    pub(super) fn finds_cells(self) -> bool {
        use Operation::{Ask, Decompose, Locate, Zone, ZoneLong};
        matches!(self, Locate | Ask(..) | Zone | ZoneLong | Decompose)
    }

    /// How many points it asks about, if it does.
    pub(super) fn queries(self) -> Option<usize> {
        match self {
            // Every cell is looked at for each, or all that is around the faces on the way.
            Operation::Ask(Strategy::Naive | Strategy::Walk, _) => Some(FEW_QUERIES),
            Operation::Locate | Operation::Ask(..) => Some(QUERIES),
            _ => None,
        }
    }
}

impl std::fmt::Display for Operation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (word, _) =
            WORDS.iter().find(|(_, operation)| operation == self).expect("the table has all operations");
        f.write_str(word)
    }
}

impl std::fmt::Display for Family {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Family::Long => f.write_str("long"),
            Family::Short(bits) => write!(f, "s{bits}"),
            Family::Lines => f.write_str("lines"),
            Family::Polylines => f.write_str("polylines"),
            Family::Arcs => f.write_str("arcs"),
        }
    }
}

impl Family {
    /// The CGAL driver for curves of this kind.
    pub(super) fn driver(self) -> &'static str {
        match self {
            Family::Long | Family::Short(_) => "arr_segments",
            Family::Lines => "arr_linear",
            Family::Polylines => "arr_polylines",
            Family::Arcs => "arr_sphere",
        }
    }

    /// Whether every program cuts curves elsewhere, where its parameter space ends. Then faces are compared, and how many more edges than
    /// vertices there are.
    pub(super) fn is_cut(self) -> bool {
        self == Family::Arcs
    }

    /// So many curves.
    fn operand(self, count: usize, seed: u64) -> Operand {
        let segments = |Drawn { objects, hash }| (Curves::Segments(objects), hash);
        let (curves, hash) = match self {
            Family::Long => segments(long_segments(count, seed)),
            Family::Short(bits) => segments(short_segments(count, bits, seed)),
            Family::Lines => {
                let drawn = lines(count, seed);
                (Curves::Lines(drawn.objects), drawn.hash)
            }
            Family::Polylines => {
                let drawn = polylines(count, seed);
                (Curves::Polylines(drawn.objects), drawn.hash)
            }
            Family::Arcs => {
                let drawn = geodesic_arcs(count, seed);
                (Curves::Arcs(drawn.objects), drawn.hash)
            }
        };
        Operand { name: format!("{self}_{count}_{seed}"), curves, hash }
    }

    /// So many points of the surface.
    fn queries(self, count: usize) -> Operand {
        let (name, curves, hash) = if self == Family::Arcs {
            let Drawn { objects, hash } = query_directions(count, QUERY_SEED);
            ("directions", Curves::Directions(objects), hash)
        } else {
            let Drawn { objects, hash } = query_points(count, QUERY_SEED);
            ("points", Curves::Points(objects), hash)
        };
        Operand { name: format!("{name}_{count}_{QUERY_SEED}"), curves, hash }
    }
}

impl Task {
    /// The three words of [`Task::words`].
    ///
    /// # Errors
    /// If a word is not one of them.
    pub(super) fn parse([operation, family, count]: [&str; 3]) -> Result<Task, Failure> {
        let known = WORDS.iter().find(|(word, _)| *word == operation);
        let (_, operation) = *known.ok_or_else(|| format!("no such operation: {operation}"))?;
        let bits = || family.strip_prefix('s')?.parse().ok().filter(|bits| (1..=20).contains(bits));
        let family = match family {
            "long" => Family::Long,
            "lines" => Family::Lines,
            "polylines" => Family::Polylines,
            "arcs" => Family::Arcs,
            _ => Family::Short(bits().ok_or_else(|| format!("no such family of curves: {family}"))?),
        };
        Ok(Task { operation, family, count: count.parse()? })
    }

    /// What [`Task::parse`] reads.
    pub(super) fn words(&self) -> [String; 3] {
        [self.operation.to_string(), self.family.to_string(), self.count.to_string()]
    }

    /// One operand, or two.
    pub(super) fn operands(&self) -> Vec<Operand> {
        let first = self.family.operand(self.count, FIRST);
        let second = match self.operation {
            Operation::Zone => Some(self.family.operand(CROSSING, SECOND)),
            Operation::ZoneLong => Some(Family::Long.operand(CROSSING, SECOND)),
            Operation::Overlay => Some(self.family.operand(self.count, SECOND)),
            other => other.queries().map(|count| self.family.queries(count)),
        };
        [first].into_iter().chain(second).collect()
    }
}

impl Curves {
    /// One curve a line, as `splitstar arrange` reads them.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        let mut line = |kind: &str, numbers: &mut dyn Iterator<Item = i64>| {
            text.push_str(kind);
            for number in numbers {
                write!(text, " {number}").expect("a string takes all text");
            }
            text.push('\n');
        };
        match self {
            Curves::Segments(all) => all.iter().for_each(|ends| line("segment", &mut ends.iter().copied())),
            Curves::Lines(all) => all.iter().for_each(|points| line("line", &mut points.iter().copied())),
            Curves::Polylines(all) => {
                all.iter().for_each(|walk| line("polyline", &mut walk.iter().flatten().copied()));
            }
            Curves::Arcs(all) => all.iter().for_each(|ends| line("arc", &mut ends.iter().copied())),
            Curves::Points(all) => all.iter().for_each(|point| line("point", &mut point.iter().copied())),
            Curves::Directions(all) => all.iter().for_each(|point| line("point", &mut point.iter().copied())),
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_back() {
        let families = [Family::Long, Family::Short(9), Family::Lines, Family::Polylines, Family::Arcs];
        for (_, operation) in WORDS {
            for family in families {
                let task = Task { operation, family, count: 12 };
                let words = task.words();
                let read = Task::parse([&words[0], &words[1], &words[2]]).expect("they are right");
                assert_eq!(read, task);
            }
        }
        for wrong in
            [["sew", "long", "1"], ["build", "s99", "1"], ["build", "medium", "1"], ["build", "long", "x"]]
        {
            assert!(Task::parse(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn text_is_a_curve_a_line() {
        assert_eq!(Curves::Segments(vec![[1, 2, 3, 4]]).text(), "segment 1 2 3 4\n");
        assert_eq!(Curves::Lines(vec![[1, 2, 3, 4], [-1, 0, 0, 5]]).text(), "line 1 2 3 4\nline -1 0 0 5\n");
        assert_eq!(Curves::Polylines(vec![vec![[1, 2], [3, 4], [5, 6]]]).text(), "polyline 1 2 3 4 5 6\n");
        assert_eq!(Curves::Arcs(vec![[1, 2, 3, -4, 5, 6]]).text(), "arc 1 2 3 -4 5 6\n");
        assert_eq!(Curves::Points(vec![[7, 8]]).text(), "point 7 8\n");
        assert_eq!(Curves::Directions(vec![[7, 8, 9]]).text(), "point 7 8 9\n");
    }

    #[test]
    fn operands_have_the_published_hashes() {
        let task = Task::parse(["overlay", "long", "1000"]).expect("it is a task");
        let hashes: Vec<u64> = task.operands().iter().map(|operand| operand.hash).collect();
        assert_eq!(hashes, [0xa218_6390_7182_c844, 0xe40b_f83e_092e_eed0]);
        let task = Task::parse(["locate", "s15", "1000"]).expect("it is a task");
        assert_eq!(task.operands()[1].hash, 0x19d3_c591_bd35_d28b);
        let task = Task::parse(["trapezoids", "arcs", "300"]).expect("it is a task");
        let hashes: Vec<u64> = task.operands().iter().map(|operand| operand.hash).collect();
        assert_eq!(hashes, [0xd117_972a_a606_757b, 0xfd37_8613_c0c9_dbf2]);
    }
}
