//! The inverse of a primitive change: what of it is known before, and the rest after.

use crate::arrangement::{Arrangement, CurveId};
use crate::edit::{Done, Edit, EditOf, Observer};
use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd};
use dcel::{CcbId, CcbKind, Dcel, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId};

/// The changes that take one change back, in their order.
pub(super) type StepOf<G> = Vec<Inverse<<G as BasicTraits>::Point, <G as BasicTraits>::UMonotoneCurve>>;

/// A change that takes back another one or a part of it. CCBs are named by halfedges, which keep their ids.
#[derive(Clone, Debug)]
pub(super) enum Inverse<P, C> {
    Edit(Edit<P, C>),
    SplitFace { h: HalfedgeId },
    MoveCcb { h: HalfedgeId, face: FaceId },
    SetCcbKind { h: HalfedgeId, kind: CcbKind },
}

/// What has to be known of the time before a change.
#[derive(Clone, Debug)]
pub(super) enum Pending<P, C> {
    /// The inverse is known at once.
    Known(Vec<Inverse<P, C>>),
    /// The inverse is the removal of what the edit makes, and then these. The ends that had no edge and no face are removed, and added
    /// again.
    Inserted { ends: [EndFate; 2], then: Vec<Inverse<P, C>> },
    /// The face that is split.
    SplitFace { face: FaceId },
    /// The edge that goes.
    Removal(Removal<P, C>),
}

#[derive(Clone, Debug)]
pub(super) struct Removal<P, C> {
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

impl<P: Clone, C: Clone> Inverse<P, C> {
    pub(super) fn run<G, T, O>(self, arrangement: &mut Arrangement<G, T>, observer: &mut O)
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
            Edit::SetCornerFace { .. } => {
                known(Inverse::Edit(Edit::SetCornerFace { face: self.arrangement.corner_face() }))
            }
            Edit::SetSupport { e, .. } => known(self.support(e)),
            Edit::SetPoint { v, .. } => {
                let point = self.arrangement.inner_point(v);
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
        let point =
            self.arrangement.inner_point(v).expect("only a vertex that is a point is removed").clone();
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

impl<P: Clone, C: Clone> Pending<P, C> {
    /// What has to be known before an edit.
    pub(super) fn of<G, T>(arrangement: &Arrangement<G, T>, edit: &Edit<P, C>) -> Self
    where
        G: BasicTraits<Point = P, UMonotoneCurve = C>,
        T: Topology<G>,
    {
        Before { arrangement, dcel: &arrangement.dcel }.pending(edit)
    }

    /// The inverse, once it is known what came of the edit.
    pub(super) fn inverse(self, edit: &Edit<P, C>, done: Done) -> Vec<Inverse<P, C>> {
        match self {
            Self::Known(step) => step,
            Self::SplitFace { face } => {
                vec![Inverse::Edit(Edit::MergeFaces { kept: face, gone: done.face() })]
            }
            Self::Removal(removal) => removal.inverse(done.removed()),
            Self::Inserted { ends, then } => {
                let inverse = match (edit, done) {
                    (Edit::SplitEdge { e, v, .. }, _) => Edit::MergeEdges { kept: *e, v: *v },
                    (_, Done::Vertex(v)) => Edit::RemoveIsolatedVertex { v },
                    (_, done) => Edit::RemoveEdge { e: done.edge(), ends, survivor: Side::Even },
                };
                std::iter::once(Inverse::Edit(inverse)).chain(then).collect()
            }
        }
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
