//! What edits ask of the geometry and change in the cells, counted: neither a clock nor a cache has a part in it.

use arrangement::edit::{Done, EditOf, Observer};
use arrangement::models::{GeodesicTraits, Segment, SegmentTraits};
use arrangement::topology::{BoundedPlane, Sphere, Topology};
use arrangement::traits::{BasicTraits, UMonotoneTraits};
use arrangement::wrappers::CountingTraits;
use arrangement::{Arrangement, Editor};
use testkit::{Rng, geodesic_arcs, short_segments};

use crate::Failure;
use crate::peers::arrangements::{Holes, Operation, arcs};

/// Curves whose zones are asked for, as where time is measured.
const CROSSING: usize = 100;

/// The work of an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Counted {
    /// Calls of predicates, and primitive changes of the cells.
    pub(super) work: u64,
    /// Cells that are found; or else vertices that come or go, or faces that are split off.
    pub(super) steps: usize,
}

impl Counted {
    /// The work of each step.
    pub(super) fn per_step(self) -> f64 {
        self.work as f64 / self.steps as f64
    }
}

/// How many primitive changes were made.
#[derive(Debug, Default)]
struct Changes(u64);

impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for Changes {
    fn after(&mut self, _: &Arrangement<G, T>, _: &EditOf<G>, _: &Done) {
        self.0 += 1;
    }
}

type Counting<G, T> = Editor<CountingTraits<G>, T, Changes>;
type Plane = Counting<SegmentTraits, BoundedPlane>;

/// An editor of what a sweep makes, whose work is not counted.
fn editor(segments: &[Segment]) -> Result<Plane, Failure> {
    edited(Arrangement::of_curves(CountingTraits::new(SegmentTraits), BoundedPlane, segments))
}

/// An editor whose work is counted from now on.
fn edited<G, T>(arrangement: Arrangement<CountingTraits<G>, T>) -> Result<Counting<G, T>, Failure>
where
    G: UMonotoneTraits,
    T: Topology<CountingTraits<G>>,
{
    let editor = Editor::with_observers(arrangement, Changes::default())?;
    editor.traits().counters().reset();
    Ok(editor)
}

/// The work since the editor was made.
fn work<G, T>(editor: &Counting<G, T>) -> u64
where
    G: UMonotoneTraits,
    T: Topology<CountingTraits<G>>,
{
    editor.traits().counters().total() + editor.observers().0
}

/// Short segments with steps of so many bits.
fn short(count: usize, bits: u32, seed: u64) -> Result<Vec<Segment>, Failure> {
    let segment =
        |&[a, b, c, d]: &[i64; 4]| Segment::from_i64([[a, b], [c, d]]).ok_or("a curve has equal ends");
    Ok(short_segments(count, bits, seed).objects.iter().map(segment).collect::<Result<_, _>>()?)
}

/// Insertion, removal or zones on short segments, as they are measured in time.
///
/// # Errors
/// If it is another operation.
pub(super) fn of_short(operation: Operation, count: usize, bits: u32) -> Result<Counted, Failure> {
    let segments = short(count, bits, 1)?;
    let vertices = |editor: &Plane| editor.counts_with_splits().vertices;
    match operation {
        Operation::Insert => {
            let mut editor = editor(&[])?;
            segments.iter().for_each(|segment| drop(editor.insert_curve(segment)));
            Ok(Counted { work: work(&editor), steps: vertices(&editor) })
        }
        Operation::Remove => {
            let mut editor = editor(&segments)?;
            let steps = vertices(&editor);
            let mut edges: Vec<_> = editor.dcel().edges().collect();
            Rng::new(1).shuffle(&mut edges);
            for e in edges {
                editor.remove_edge(e);
            }
            Ok(Counted { work: work(&editor), steps })
        }
        Operation::Zone => {
            let editor = editor(&segments)?;
            let cells = |segment: &Segment| editor.zone_cells_of(segment).len();
            let steps = short(CROSSING, bits, 2)?.iter().map(cells).sum();
            Ok(Counted { work: work(&editor), steps })
        }
        _ => Err(format!("{operation} is not counted").into()),
    }
}

/// A sweep over arcs on a sphere, or insertion of them one by one, as they are measured in time. Steps are vertices of the user's view.
///
/// # Errors
/// If it is another operation.
pub(super) fn of_arcs(operation: Operation, count: usize) -> Result<Counted, Failure> {
    let arcs = arcs(&geodesic_arcs(count, 1).objects)?;
    let traits = CountingTraits::new(GeodesicTraits::new());
    match operation {
        Operation::Build => {
            let arrangement = Arrangement::of_curves(traits, Sphere, &arcs);
            let work = arrangement.traits().counters().total();
            Ok(Counted { work, steps: arrangement.counts().vertices })
        }
        Operation::Insert => {
            let mut editor = edited(Arrangement::new(traits, Sphere))?;
            arcs.iter().for_each(|arc| drop(editor.insert_curve(arc)));
            Ok(Counted { work: work(&editor), steps: editor.counts().vertices })
        }
        _ => Err(format!("{operation} is not counted").into()),
    }
}

/// So many small faces are split off one with so many holes.
///
/// # Errors
/// If there are fewer holes than faces, or a face is missing.
pub(super) fn of_holes(holes: usize, steps: usize) -> Result<Counted, Failure> {
    let holes = Holes::new(holes, steps)?;
    let mut editor = editor(&holes.segments)?;
    holes.insert(&mut editor)?;
    Ok(Counted { work: work(&editor), steps })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_counted() {
        // A ring around a hole: four edges, four vertices, and a face that gets a hole.
        let ring = of_holes(30, 1).expect("there are enough holes");
        assert!(ring.steps == 1 && ring.work > 40 && ring.work < 2_000, "{ring:?}");
        assert!(of_holes(3, 4).is_err());
        for operation in [Operation::Insert, Operation::Remove, Operation::Zone] {
            let counted = of_short(operation, 50, 17).expect("it is counted");
            assert!(counted.steps > 20 && counted.per_step() > 1.0, "{operation}: {counted:?}");
            assert_eq!(of_short(operation, 50, 17).expect("it is counted"), counted, "the same again");
        }
        assert!(of_short(Operation::Overlay, 50, 17).is_err());
        for operation in [Operation::Build, Operation::Insert] {
            let counted = of_arcs(operation, 20).expect("it is counted");
            assert!(counted.steps > 40 && counted.per_step() > 1.0, "{operation}: {counted:?}");
        }
        assert!(of_arcs(Operation::Remove, 20).is_err());
    }
}
