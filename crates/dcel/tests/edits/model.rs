//! A slow model of an arrangement: for each vertex the halfedges around it, for each halfedge its face
//! and the kind of its CCB. Cycles are made anew from the rotations whenever they are asked for.

use splitstar_dcel::{CcbKind, Dcel, EdgeId, FaceId, HalfedgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

#[derive(Clone, Default)]
pub(crate) struct Model {
    /// The halfedges that leave each vertex, counterclockwise; none for an isolated vertex.
    pub(crate) around: BTreeMap<VertexId, Vec<HalfedgeId>>,
    pub(crate) sides: BTreeMap<HalfedgeId, (FaceId, CcbKind)>,
    pub(crate) isolated: BTreeMap<VertexId, FaceId>,
    pub(crate) faces: BTreeSet<FaceId>,
}

impl Model {
    pub(crate) fn new() -> Self {
        Self { faces: [FaceId(0)].into(), ..Self::default() }
    }

    /// The vertex that `h` leaves.
    fn source(&self, h: HalfedgeId) -> VertexId {
        let found = self.around.iter().find(|(_, out)| out.contains(&h));
        *found.expect("each halfedge leaves a vertex").0
    }

    /// The halfedge after `h`: clockwise from its twin.
    fn next_in(&self, source: &BTreeMap<HalfedgeId, VertexId>, h: HalfedgeId) -> HalfedgeId {
        let out = &self.around[&source[&h.twin()]];
        let at = out.iter().position(|&o| o == h.twin()).expect("the twin leaves its source");
        out[(at + out.len() - 1) % out.len()]
    }

    fn sources(&self) -> BTreeMap<HalfedgeId, VertexId> {
        self.around.iter().flat_map(|(&v, out)| out.iter().map(move |&h| (h, v))).collect()
    }

    /// All cycles, each from its lowest halfedge.
    pub(crate) fn cycles(&self) -> Vec<Vec<HalfedgeId>> {
        let source = self.sources();
        let mut seen = BTreeSet::new();
        let mut cycles = Vec::new();
        for &h in source.keys() {
            if seen.contains(&h) {
                continue;
            }
            let mut cycle = vec![h];
            loop {
                let next = self.next_in(&source, *cycle.last().expect("not empty"));
                if next == h {
                    break;
                }
                cycle.push(next);
            }
            seen.extend(cycle.iter().copied());
            cycles.push(cycle);
        }
        cycles
    }

    pub(crate) fn cycle_of(&self, h: HalfedgeId) -> Vec<HalfedgeId> {
        self.cycles().into_iter().find(|cycle| cycle.contains(&h)).expect("each halfedge is in a cycle")
    }

    /// Puts the halfedge `out` at the target of `prev` so that it follows `prev`.
    pub(crate) fn put_after(&mut self, prev: HalfedgeId, out: HalfedgeId) {
        let v = self.source(prev.twin());
        let around = self.around.get_mut(&v).expect("it has a twin of prev");
        let at = around.iter().position(|&h| h == prev.twin()).expect("it has a twin of prev");
        around.insert(at, out);
    }

    pub(crate) fn put_alone(&mut self, v: VertexId, out: HalfedgeId) {
        self.isolated.remove(&v);
        self.around.insert(v, vec![out]);
    }

    /// Takes a halfedge away; its source goes with its last one.
    pub(crate) fn take(&mut self, h: HalfedgeId) {
        let v = self.source(h);
        let around = self.around.get_mut(&v).expect("it has the halfedge");
        around.retain(|&o| o != h);
        if around.is_empty() {
            self.around.remove(&v);
        }
        self.sides.remove(&h);
    }

    pub(crate) fn mark(&mut self, halfedges: &[HalfedgeId], face: FaceId, kind: CcbKind) {
        for &h in halfedges {
            self.sides.insert(h, (face, kind));
        }
    }

    pub(crate) fn edges(&self) -> BTreeSet<EdgeId> {
        self.sides.keys().map(|h| h.edge_id()).collect()
    }

    /// Everything that the two have in common.
    pub(crate) fn assert_agrees(&self, dcel: &Dcel, hint: &str) {
        assert_eq!(dcel.check_valid(), [], "{hint}");
        assert_eq!(dcel.faces().collect::<BTreeSet<_>>(), self.faces, "{hint}: faces");
        assert_eq!(dcel.edges().collect::<BTreeSet<_>>(), self.edges(), "{hint}: edges");
        assert_eq!((dcel.edge_count(), dcel.face_count()), (self.edges().len(), self.faces.len()), "{hint}");
        let vertices: BTreeSet<_> = self.around.keys().chain(self.isolated.keys()).copied().collect();
        assert_eq!(dcel.vertices().collect::<BTreeSet<_>>(), vertices, "{hint}: vertices");
        assert_eq!(dcel.vertex_count(), vertices.len(), "{hint}");
        for (&v, out) in &self.around {
            let mut around: Vec<_> = dcel.around(v).collect();
            let first = out.iter().position(|h| Some(h) == around.first()).expect("a halfedge of the vertex");
            around.rotate_right(first);
            assert_eq!(&around, out, "{hint}: around {v:?}");
        }
        for (&v, &f) in &self.isolated {
            assert_eq!(dcel.isolated_face(v), Some(f), "{hint}: {v:?}");
        }
        let cycles = self.cycles();
        let mut ccbs = BTreeSet::new();
        for cycle in &cycles {
            let ccb = dcel.ccb(cycle[0]);
            assert!(ccbs.insert(ccb), "{hint}: {ccb:?} has two cycles");
            assert_eq!(&dcel.cycle(cycle[0]).collect::<Vec<_>>(), cycle, "{hint}: {ccb:?}");
            for &h in cycle {
                let side = (dcel.face(h), dcel.ccb_kind(dcel.ccb(h)));
                assert_eq!((dcel.ccb(h), side), (ccb, self.sides[&h]), "{hint}: {h:?}");
            }
        }
        assert_eq!(dcel.ccb_count(), cycles.len(), "{hint}: CCBs");
    }
}
