//! Taking changes back, one by one.

use super::{Done, Edit, EditOf, Observer, Operation, Stale, Stamp};
use crate::arrangement::{Arrangement, CurveId};
use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd};
use dcel::{CcbId, CcbKind, Dcel, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId};

/// Records how to take changes back.
///
/// What is taken back leaves vertices, edges, halfedges and faces with the ids that they had. What may differ: which CCB has which id (the
/// CCBs of a loop that is alone on its component may be exchanged) and with which halfedge it begins; the order in which a face lists its CCBs
/// and isolated vertices; and the curves that were added stay.
///
/// Taking back is an operation of its own, [`Operation::Undo`], which is told to other observers and is not recorded here. Where all was
/// replaced, and where the recorder missed a change, the records before are dropped.
///
/// # Complexity
/// A record takes constant time and memory; but that of a removal, or of faces that are merged, is linear in the number of CCBs and isolated
/// vertices of the face that goes.
#[derive(Clone, Debug)]
pub struct Undo<G: BasicTraits> {
    steps: Vec<StepOf<G>>,
    /// Where the operations begin.
    starts: Vec<usize>,
    pending: Pending<G::Point, G::UMonotoneCurve>,
    stamp: Stamp,
    state: State,
}

/// Where the recorder is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum State {
    /// Between operations: a change is an operation of its own.
    Between,
    /// In an operation.
    Within,
    /// In one that takes changes back.
    Undoing,
}

type StepOf<G> = Vec<Inverse<<G as BasicTraits>::Point, <G as BasicTraits>::UMonotoneCurve>>;

/// A change that takes back another one or a part of it. CCBs are named by halfedges, which keep their ids.
#[derive(Clone, Debug)]
enum Inverse<P, C> {
    Edit(Edit<P, C>),
    SplitFace { h: HalfedgeId },
    MoveCcb { h: HalfedgeId, face: FaceId },
    SetCcbKind { h: HalfedgeId, kind: CcbKind },
}

/// What has to be known of the time before a change.
#[derive(Clone, Debug)]
enum Pending<P, C> {
    /// The inverse is known at once.
    Known(Vec<Inverse<P, C>>),
    /// The inverse is the removal of what the edit makes, and then these. The ends that had no edge and no face are removed, and added again.
    Inserted { ends: [EndFate; 2], then: Vec<Inverse<P, C>> },
    /// The face that is split.
    SplitFace { face: FaceId },
    /// The edge that goes.
    Removal(Removal<P, C>),
}

#[derive(Clone, Debug)]
struct Removal<P, C> {
    e: EdgeId,
    ends: [VertexId; 2],
    /// The halfedges that the two halves follow.
    prevs: [HalfedgeId; 2],
    kinds: [CcbKind; 2],
    support: CurveId,
    survivor: Side,
    kept: FaceId,
    /// The ends that go, in the order in which they come again.
    revived: Vec<Inverse<P, C>>,
    /// What the face that goes has besides.
    moved: Vec<Inverse<P, C>>,
}

impl<G: BasicTraits> Undo<G> {
    /// Begins to record.
    pub fn new<T>(arrangement: &Arrangement<G, T>) -> Self {
        Self {
            steps: Vec::new(),
            starts: Vec::new(),
            pending: Pending::Known(Vec::new()),
            stamp: arrangement.stamp(),
            state: State::Between,
        }
    }

    /// The number of operations that can be taken back.
    pub fn operation_count(&self) -> usize {
        self.starts.len()
    }

    /// Forgets all that was recorded, and goes on with the present state of an arrangement.
    pub fn restart<T>(&mut self, arrangement: &Arrangement<G, T>) {
        *self = Self::new(arrangement);
    }

    /// Gives the last operation, which is recorded no more.
    pub fn pop(&mut self) -> Option<Recorded<G>> {
        let start = self.starts.pop()?;
        Some(Recorded { steps: self.steps.split_off(start), stamp: self.stamp })
    }

    /// Takes the last operation back, if there is one, and tells so. For a recorder that is not among those who are told;
    /// else: [`Undo::pop`], and [`Recorded::take_back`].
    ///
    /// # Errors
    /// If the arrangement is not in the state to which the last change led it. Then the operation is still recorded.
    #[cfg_attr(not(test), expect(dead_code, reason = "for the editor"))]
    pub(crate) fn take_back<T: Topology<G>, O: Observer<G, T> + ?Sized>(
        &mut self,
        arrangement: &mut Arrangement<G, T>,
        observer: &mut O,
    ) -> Result<bool, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        let Some(recorded) = self.pop() else { return Ok(false) };
        recorded.take_back(arrangement, observer)?;
        self.stamp = arrangement.stamp();
        Ok(true)
    }
}

/// An operation, with all that is needed to take it back.
#[derive(Clone, Debug)]
pub struct Recorded<G: BasicTraits> {
    steps: Vec<StepOf<G>>,
    stamp: Stamp,
}

impl<G: BasicTraits> Recorded<G> {
    /// Takes the operation back, and tells so. A recorder among those who are told knows that it is to record nothing of it.
    ///
    /// # Errors
    /// If the arrangement is not in the state to which the operation led it.
    ///
    /// # Complexity
    /// As of the changes that are made.
    pub(crate) fn take_back<T: Topology<G>, O: Observer<G, T> + ?Sized>(
        self,
        arrangement: &mut Arrangement<G, T>,
        observer: &mut O,
    ) -> Result<(), Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        observer.begin_operation(arrangement, Operation::Undo);
        for step in self.steps.into_iter().rev() {
            step.into_iter().for_each(|inverse| inverse.run(arrangement, observer));
        }
        observer.end_operation(arrangement, Operation::Undo);
        Ok(())
    }
}

impl<P: Clone, C: Clone> Inverse<P, C> {
    fn run<G, T, O>(self, arrangement: &mut Arrangement<G, T>, observer: &mut O)
    where
        G: BasicTraits<Point = P, UMonotoneCurve = C>,
        T: Topology<G>,
        O: Observer<G, T> + ?Sized,
    {
        let ccb = |h| arrangement.dcel.ccb(h);
        let edit = match self {
            Self::Edit(edit) => edit,
            Self::SplitFace { h } => Edit::SplitFace { ccb: ccb(h) },
            Self::MoveCcb { h, face } => Edit::MoveCcb { ccb: ccb(h), face },
            Self::SetCcbKind { h, kind } if arrangement.dcel.ccb_kind(ccb(h)) == kind => return,
            Self::SetCcbKind { h, kind } => Edit::SetCcbKind { ccb: ccb(h), kind },
        };
        arrangement.apply(edit, observer);
    }
}

/// What is read of the time before a change.
struct Before<'a, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    dcel: &'a Dcel,
}

impl<G: BasicTraits, T: Topology<G>> Before<'_, G, T> {
    fn pending(&self, edit: &EditOf<G>) -> Pending<G::Point, G::UMonotoneCurve> {
        let known = |inverse| Pending::Known(vec![inverse]);
        match *edit {
            Edit::AddVertex { .. } | Edit::AddIsolatedVertex { .. } => {
                Pending::Inserted { ends: [EndFate::Isolate; 2], then: Vec::new() }
            }
            Edit::RemoveIsolatedVertex { v } => known(self.revived(v)),
            Edit::InsertEdgeInFace { ends, .. } => self.inserted(ends.map(Some)),
            Edit::InsertLoop { v, .. } | Edit::InsertEdgeTo { v, .. } => self.inserted([Some(v), None]),
            Edit::InsertEdgeFrom { v, .. } => self.inserted([None, Some(v)]),
            Edit::InsertEdgeBetween { .. } => self.inserted([None; 2]),
            Edit::InsertEdgeJoining { prevs, .. } => {
                let then = prevs.map(|h| self.kind(h)).into();
                Pending::Inserted { ends: [EndFate::Isolate; 2], then }
            }
            Edit::RemoveEdge { e, ends, survivor } => Pending::Removal(self.removal(e, ends, survivor)),
            Edit::SplitEdge { v, .. } => {
                Pending::Inserted { ends: [EndFate::Isolate; 2], then: vec![self.revived(v)] }
            }
            Edit::MergeEdges { kept, v } => Pending::Known(self.split_again(kept, v)),
            Edit::SplitFace { ccb } => Pending::SplitFace { face: self.dcel.ccb_face(ccb) },
            Edit::MergeFaces { gone, .. } => Pending::Known(self.face_again(gone)),
            Edit::MoveCcb { ccb, .. } => known(self.place(ccb, self.dcel.ccb_face(ccb))),
            Edit::MoveIsolatedVertex { v, .. } => {
                let face = self.dcel.isolated_face(v).expect("only an isolated vertex lies in a face");
                known(Inverse::Edit(Edit::MoveIsolatedVertex { v, face }))
            }
            Edit::SetCcbKind { ccb, .. } => known(self.kind(self.dcel.ccb_halfedge(ccb))),
            Edit::SetSupport { e, .. } => known(self.support(e)),
            Edit::SetPoint { v, .. } => {
                let point = self.arrangement.point(v);
                let edit = point.map(|point| Edit::SetPoint { v, point: point.clone() });
                Pending::Known(edit.map(Inverse::Edit).into_iter().collect())
            }
            Edit::SetArtificial { v, .. } => {
                let is_artificial = self.arrangement.is_artificial[v.index()];
                known(Inverse::Edit(Edit::SetArtificial { v, is_artificial }))
            }
            Edit::AddCurve { .. } => Pending::Known(Vec::new()),
        }
    }

    /// A vertex without edges, to come again where it was.
    fn revived(&self, v: VertexId) -> Inverse<G::Point, G::UMonotoneCurve> {
        let point = self.arrangement.point(v).expect("only a vertex that is a point is removed").clone();
        let is_artificial = self.arrangement.is_artificial[v.index()];
        Inverse::Edit(match self.dcel.isolated_face(v) {
            Some(face) => Edit::AddIsolatedVertex { point, is_artificial, face },
            None => Edit::AddVertex { point, is_artificial },
        })
    }

    fn kind(&self, h: HalfedgeId) -> Inverse<G::Point, G::UMonotoneCurve> {
        Inverse::SetCcbKind { h, kind: self.dcel.ccb_kind(self.dcel.ccb(h)) }
    }

    fn support(&self, e: EdgeId) -> Inverse<G::Point, G::UMonotoneCurve> {
        Inverse::Edit(Edit::SetSupport { e, curve: self.arrangement.support(e) })
    }

    fn place(&self, ccb: CcbId, face: FaceId) -> Inverse<G::Point, G::UMonotoneCurve> {
        Inverse::MoveCcb { h: self.dcel.ccb_halfedge(ccb), face }
    }

    /// Of the ends that have no edge, those that are in no face either.
    fn inserted(&self, ends: [Option<VertexId>; 2]) -> Pending<G::Point, G::UMonotoneCurve> {
        let is_bare = |&v: &VertexId| self.dcel.isolated_face(v).is_none();
        let bare = ends.map(|v| v.filter(is_bare));
        // The one that is removed last comes first again.
        let then = bare.into_iter().rev().flatten().map(|v| self.revived(v)).collect();
        Pending::Inserted {
            ends: bare.map(|v| if v.is_some() { EndFate::Remove } else { EndFate::Isolate }),
            then,
        }
    }

    fn removal(
        &self,
        e: EdgeId,
        fates: [EndFate; 2],
        survivor: Side,
    ) -> Removal<G::Point, G::UMonotoneCurve> {
        let halves = [e.halfedge(), e.halfedge().twin()];
        let ends = self.dcel.ends(e);
        let faces = halves.map(|h| self.dcel.face(h));
        let (kept, gone) = match survivor {
            Side::Even => (faces[0], faces[1]),
            Side::Odd => (faces[1], faces[0]),
        };
        let goes = |i: usize| {
            let is_last = self.dcel.around(ends[i]).all(|h| h.edge_id() == e);
            // For a loop the first fate counts.
            is_last && fates[i] == EndFate::Remove && !(i == 1 && ends[0] == ends[1])
        };
        let revived = [1, 0].into_iter().filter(|&i| goes(i)).map(|i| self.revived(ends[i])).collect();
        let own = halves.map(|h| self.dcel.ccb(h));
        Removal {
            e,
            ends,
            prevs: halves.map(|h| self.dcel.prev(h)),
            kinds: own.map(|ccb| self.dcel.ccb_kind(ccb)),
            support: self.arrangement.support(e),
            survivor,
            kept,
            revived,
            moved: if kept == gone { Vec::new() } else { self.contents(gone, &own) },
        }
    }

    /// What a face has, to be moved there again.
    fn contents(&self, face: FaceId, but: &[CcbId]) -> StepOf<G> {
        let ccbs =
            self.dcel.face_ccbs(face).filter(|ccb| !but.contains(ccb)).map(|ccb| self.place(ccb, face));
        let isolated = self.dcel.isolated_vertices(face);
        ccbs.chain(isolated.map(|v| Inverse::Edit(Edit::MoveIsolatedVertex { v, face }))).collect()
    }

    fn face_again(&self, gone: FaceId) -> StepOf<G> {
        let first = self.dcel.face_ccbs(gone).next().expect("one of two faces has a CCB");
        let mut step = vec![Inverse::SplitFace { h: self.dcel.ccb_halfedge(first) }];
        step.extend(self.contents(gone, &[first]));
        step
    }

    fn split_again(&self, kept: EdgeId, v: VertexId) -> StepOf<G> {
        let end = if self.dcel.ends(kept)[1] == v { CurveEnd::Min } else { CurveEnd::Max };
        let gone = self.dcel.around(v).find(|h| h.edge_id() != kept).expect("two edges are merged").edge_id();
        vec![self.revived(v), Inverse::Edit(Edit::SplitEdge { e: kept, v, kept: end }), self.support(gone)]
    }
}

impl<P: Clone, C: Clone> Removal<P, C> {
    /// The edge is inserted again: see [`Removed`] for what there is then to insert it into.
    fn inverse(self, removed: Removed) -> Vec<Inverse<P, C>> {
        let Self { e, ends: [min, max], prevs, kinds, support, survivor, kept, .. } = self;
        let [is_even_alone, is_odd_alone] = prevs.map(|h| h.edge_id() == e);
        let between = |prevs, is_reversed| Edit::InsertEdgeBetween { prevs, is_reversed, support };
        let insertion = match removed {
            Removed::Antenna { .. } if is_even_alone => {
                Edit::InsertEdgeTo { v: min, prev: prevs[1], support }
            }
            Removed::Antenna { .. } => Edit::InsertEdgeFrom { prev: prevs[0], v: max, support },
            Removed::Split { .. } => Edit::InsertEdgeJoining { prevs, kind: kinds[0], support },
            Removed::Vanished { .. } if min == max => Edit::InsertLoop { v: min, face: kept, kinds, support },
            Removed::Vanished { .. } => {
                Edit::InsertEdgeInFace { ends: [min, max], face: kept, kind: kinds[0], support }
            }
            Removed::Joined { .. } if is_even_alone => between([prevs[1]; 2], false),
            Removed::Joined { .. } if is_odd_alone => between([prevs[0]; 2], true),
            Removed::Joined { .. } => between(prevs, false),
        };
        let mut step = self.revived;
        step.push(Inverse::Edit(insertion));
        let halves = [e.halfedge(), e.halfedge().twin()];
        step.extend([0, 1].map(|i| Inverse::SetCcbKind { h: halves[i], kind: kinds[i] }));
        let (Removed::Joined { faces, .. } | Removed::Vanished { faces }) = removed else { return step };
        if faces.is_some() {
            let h = if survivor == Side::Even { halves[1] } else { halves[0] };
            step.push(Inverse::SplitFace { h });
            step.extend(self.moved);
        }
        step
    }
}

impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for Undo<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        if self.stamp != arrangement.stamp() {
            let state = self.state;
            self.restart(arrangement);
            self.state = state;
        }
        if self.state != State::Undoing {
            self.pending = Before { arrangement, dcel: &arrangement.dcel }.pending(edit);
        }
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        self.stamp = arrangement.stamp();
        if self.state == State::Undoing {
            return;
        }
        let step = match std::mem::replace(&mut self.pending, Pending::Known(Vec::new())) {
            Pending::Known(step) => step,
            Pending::SplitFace { face } => {
                vec![Inverse::Edit(Edit::MergeFaces { kept: face, gone: done.face() })]
            }
            Pending::Removal(removal) => removal.inverse(done.removed()),
            Pending::Inserted { ends, then } => {
                let inverse = match (edit, *done) {
                    (Edit::SplitEdge { e, v, .. }, _) => Edit::MergeEdges { kept: *e, v: *v },
                    (_, Done::Vertex(v)) => Edit::RemoveIsolatedVertex { v },
                    (_, done) => Edit::RemoveEdge { e: done.edge(), ends, survivor: Side::Even },
                };
                std::iter::once(Inverse::Edit(inverse)).chain(then).collect()
            }
        };
        if self.state == State::Between || self.starts.is_empty() {
            self.starts.push(self.steps.len());
        }
        self.steps.push(step);
    }

    fn begin_operation(&mut self, _: &Arrangement<G, T>, operation: Operation) {
        if operation == Operation::Undo {
            self.state = State::Undoing;
        } else {
            self.state = State::Within;
            self.starts.push(self.steps.len());
        }
    }

    fn end_operation(&mut self, _: &Arrangement<G, T>, _: Operation) {
        // One that changed nothing is none.
        if self.state == State::Within && self.starts.last() == Some(&self.steps.len()) {
            self.starts.pop();
        }
        self.state = State::Between;
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        self.restart(arrangement);
    }

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        Stale::check(self.stamp, stamp)
    }
}
