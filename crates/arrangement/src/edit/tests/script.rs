//! Random primitives on cells that mean nothing: connectivity alone, with a mirror and undo.

use super::scenes::{Plane, random_plane};
use super::{Rng, Snapshot, is_shown_alike};
use crate::edit::{Edit, Mirror, Observer, Operation, Undo};
use crate::models::{Segment, SegmentTraits};
use crate::topology::BoundedPlane;
use crate::traits::CurveEnd;
use dcel::{CcbKind, EdgeId, EndFate, FaceId, HalfedgeId, Side, VertexId};
use exact::planar::Point2;

type Watch<'a> = dyn Observer<SegmentTraits, BoundedPlane> + 'a;

struct Step<'a> {
    rng: &'a mut Rng,
    arrangement: &'a mut Plane,
    watch: &'a mut Watch<'a>,
}

impl Step<'_> {
    fn vertex(&mut self) -> VertexId {
        let point = Point2::from_i64([self.rng.within(9), self.rng.within(9)]);
        let is_artificial = self.rng.below(2) == 0;
        if self.rng.below(2) == 0 {
            let face = self.face();
            return self
                .arrangement
                .apply(Edit::AddIsolatedVertex { point, is_artificial, face }, self.watch)
                .vertex();
        }
        self.arrangement.apply(Edit::AddVertex { point, is_artificial }, self.watch).vertex()
    }

    /// A vertex that can be attached in a face.
    fn vertex_in(&mut self, face: FaceId) -> VertexId {
        let v = self.vertex();
        if self.arrangement.dcel().isolated_face(v).is_some_and(|f| f != face) {
            self.arrangement.apply(Edit::MoveIsolatedVertex { v, face }, self.watch);
        }
        v
    }

    fn face(&mut self) -> FaceId {
        let faces: Vec<FaceId> = self.arrangement.dcel().faces().collect();
        self.rng.choose(&faces).expect("there is a face")
    }

    fn halfedge(&mut self) -> Option<HalfedgeId> {
        let halfedges: Vec<HalfedgeId> = self.arrangement.dcel().halfedges().collect();
        self.rng.choose(&halfedges)
    }

    fn kind(&mut self) -> CcbKind {
        [CcbKind::Outer, CcbKind::Inner][self.rng.below(2)]
    }

    /// One operation; `None` if there is nothing that it could be done to.
    fn run(&mut self) -> Option<()> {
        let curve = Segment::from_i64([[0, 0], [1, self.rng.within(5)]]).expect("the ends are different");
        let support = match self.rng.below(3) {
            0 => self.arrangement.apply(Edit::AddCurve { curve }, self.watch).curve(),
            _ if self.arrangement.curves().is_empty() => return None,
            _ => crate::CurveId(self.rng.below(self.arrangement.curves().len()) as u32),
        };
        let edit = match self.rng.below(16) {
            0 => {
                let (face, kind) = (self.face(), self.kind());
                let ends = [self.vertex_in(face), self.vertex_in(face)];
                Edit::InsertEdgeInFace { ends, face, kind, support }
            }
            1 => {
                let (face, kinds) = (self.face(), [self.kind(), self.kind()]);
                Edit::InsertLoop { v: self.vertex_in(face), face, kinds, support }
            }
            2 => {
                let prev = self.halfedge()?;
                let v = self.vertex_in(self.arrangement.dcel().face(prev));
                Edit::InsertEdgeFrom { prev, v, support }
            }
            3 => {
                let prev = self.halfedge()?;
                let v = self.vertex_in(self.arrangement.dcel().face(prev));
                Edit::InsertEdgeTo { v, prev, support }
            }
            4 | 5 => {
                let prev = self.halfedge()?;
                let cycle: Vec<HalfedgeId> = self.arrangement.dcel().cycle(prev).collect();
                let prevs = [prev, self.rng.choose(&cycle)?];
                let is_reversed = prevs[0] == prevs[1] && self.rng.below(2) == 0;
                let e = self
                    .arrangement
                    .apply(Edit::InsertEdgeBetween { prevs, is_reversed, support }, self.watch)
                    .edge();
                if self.rng.below(2) == 0 {
                    let ccb = self.arrangement.dcel().ccb(e.half([Side::Even, Side::Odd][self.rng.below(2)]));
                    self.arrangement.apply(Edit::SplitFace { ccb }, self.watch);
                }
                return Some(());
            }
            6 => {
                let (a, b) = (self.halfedge()?, self.halfedge()?);
                let dcel = self.arrangement.dcel();
                if dcel.ccb(a) == dcel.ccb(b) || dcel.face(a) != dcel.face(b) {
                    return None;
                }
                Edit::InsertEdgeJoining { prevs: [a, b], kind: self.kind(), support }
            }
            7..10 => {
                let e = self.halfedge()?.edge_id();
                let ends = [0; 2].map(|_| [EndFate::Isolate, EndFate::Remove][self.rng.below(2)]);
                let sides = [Side::Even, Side::Odd];
                let survivor = sides[self.rng.below(2)];
                let faces = sides.map(|side| self.arrangement.dcel().face(e.half(side)));
                let kept = self.arrangement.dcel().face(e.half(survivor));
                self.keep_corner(kept, faces);
                Edit::RemoveEdge { e, ends, survivor }
            }
            10 => {
                let (e, v) = (self.halfedge()?.edge_id(), self.bare_vertex());
                Edit::SplitEdge { e, v, kept: CurveEnd::BOTH[self.rng.below(2)] }
            }
            11 => self.merge()?,
            12 => {
                let (h, face) = (self.halfedge()?, self.face());
                let ccb = self.arrangement.dcel().ccb(h);
                match self.rng.below(3) {
                    0 => Edit::SetCcbKind { ccb, kind: self.kind() },
                    1 => Edit::SplitFace { ccb },
                    // The face may be left with nothing: it cannot come again if it is merged then.
                    _ if self.arrangement.dcel().face_ccbs(self.arrangement.dcel().face(h)).count() < 2 => {
                        return None;
                    }
                    _ => Edit::MoveCcb { ccb, face },
                }
            }
            13 => Edit::SetCornerFace { face: self.face() },
            14 => {
                let (kept, gone) = (self.face(), self.face());
                if kept == gone || self.arrangement.dcel().face_ccbs(gone).next().is_none() {
                    return None;
                }
                self.keep_corner(kept, [kept, gone]);
                Edit::MergeFaces { kept, gone }
            }
            _ => {
                let isolated: Vec<VertexId> = {
                    let dcel = self.arrangement.dcel();
                    dcel.vertices().filter(|&v| dcel.isolated_face(v).is_some()).collect()
                };
                let v = self.rng.choose(&isolated)?;
                match self.rng.below(4) {
                    0 => Edit::RemoveIsolatedVertex { v },
                    1 => Edit::MoveIsolatedVertex { v, face: self.face() },
                    2 => Edit::SetPoint { v, point: Point2::from_i64([self.rng.within(9), 1]) },
                    _ => Edit::SetArtificial { v, is_artificial: self.rng.below(2) == 0 },
                }
            }
        };
        self.arrangement.apply(edit, self.watch);
        Some(())
    }

    /// Of two faces that become one, the other one is not the corner face.
    fn keep_corner(&mut self, kept: FaceId, faces: [FaceId; 2]) {
        if faces.contains(&self.arrangement.corner_face()) && self.rng.below(2) == 0
            || faces.iter().any(|&f| f != kept && f == self.arrangement.corner_face())
        {
            self.arrangement.apply(Edit::SetCornerFace { face: kept }, self.watch);
        }
    }

    fn bare_vertex(&mut self) -> VertexId {
        let point = Point2::from_i64([self.rng.within(9), self.rng.within(9)]);
        self.arrangement.apply(Edit::AddVertex { point, is_artificial: false }, self.watch).vertex()
    }

    fn merge(&mut self) -> Option<crate::edit::EditOf<SegmentTraits>> {
        let dcel = self.arrangement.dcel();
        let can_be_merged = |&v: &VertexId| {
            let around: Vec<HalfedgeId> = dcel.around(v).collect();
            matches!(around[..], [a, b] if a.edge_id() != b.edge_id() && a.is_even() != b.is_even())
        };
        let vertices: Vec<VertexId> = dcel.vertices().filter(can_be_merged).collect();
        let v = self.rng.choose(&vertices)?;
        let edges: Vec<EdgeId> = dcel.around(v).map(|h| h.edge_id()).collect();
        Some(Edit::MergeEdges { kept: self.rng.choose(&edges)?, v })
    }
}

#[test]
fn random_scripts_are_mirrored_and_taken_back() {
    let mut rng = Rng(20_261_122);
    let mut steps = 0;
    for _ in 0..400 {
        let seed = rng.0;
        let mut arrangement = random_plane(&mut rng);
        let (mut mirror, mut undo) = (Mirror::new(&arrangement), Undo::new(&arrangement));
        let mut states = vec![Snapshot::of(&arrangement)];
        for _ in 0..rng.below(60) {
            let stamp = arrangement.stamp();
            let mut watch = (&mut mirror, &mut undo);
            watch.begin_operation(&arrangement, Operation::Modify);
            Step { rng: &mut rng, arrangement: &mut arrangement, watch: &mut watch }.run();
            watch.end_operation(&arrangement, Operation::Modify);
            assert_eq!(arrangement.dcel().check_valid(), [], "seed {seed}");
            assert_eq!(mirror.difference(&arrangement, is_shown_alike), None, "seed {seed}");
            if arrangement.stamp() != stamp {
                states.push(Snapshot::of(&arrangement));
                steps += 1;
            }
        }
        while let Some(state) = states.pop() {
            assert_eq!(Snapshot::of(&arrangement), state, "seed {seed}");
            let watch = &mut mirror;
            assert_eq!(undo.take_back(&mut arrangement, watch), Ok(!states.is_empty()), "seed {seed}");
            assert_eq!(arrangement.dcel().check_valid(), [], "seed {seed}");
            assert_eq!(mirror.difference(&arrangement, is_shown_alike), None, "seed {seed}");
        }
    }
    assert!(steps > 5_000, "{steps}");
}
