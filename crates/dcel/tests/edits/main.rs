//! Random scripts of edits, against a slow model after each step, and each edit undone by its inverse.

mod model;
mod undo;

use model::Model;
use splitstar_dcel::CcbKind::{self, Inner, Outer};
use splitstar_dcel::{CcbId, CcbSplit, Dcel, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId};
use undo::{Gone, Signature};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    fn is_heads(&mut self) -> bool {
        self.below(2) == 0
    }

    fn pick<T: Copy>(&mut self, items: impl Iterator<Item = T>) -> Option<T> {
        let items: Vec<T> = items.collect();
        (!items.is_empty()).then(|| items[self.below(items.len())])
    }

    fn kind(&mut self) -> CcbKind {
        if self.is_heads() { Outer } else { Inner }
    }

    fn fate(&mut self) -> EndFate {
        if self.is_heads() { EndFate::Isolate } else { EndFate::Remove }
    }
}

struct Script {
    random: Random,
    dcel: Dcel,
    model: Model,
    /// Whether a new edge between two places of a CCB always splits the face.
    sphere: bool,
    /// The genus that the edits so far need.
    genus: usize,
    /// How often each kind of edit was made.
    made: [usize; 14],
}

impl Script {
    fn new(seed: u64, sphere: bool) -> Self {
        Self { random: Random(seed), dcel: Dcel::new(), model: Model::new(), sphere, genus: 0, made: [0; 14] }
    }

    /// A vertex without edges: a new one, or an isolated one of the face.
    fn end(&mut self, face: FaceId) -> VertexId {
        let isolated = self.random.pick(self.dcel.isolated_vertices(face));
        match isolated {
            Some(v) if self.random.is_heads() => v,
            _ => self.dcel.add_vertex(),
        }
    }

    fn face(&mut self) -> FaceId {
        self.random.pick(self.dcel.faces()).expect("there is a face")
    }

    fn split(&mut self) -> CcbSplit {
        let side = if self.random.is_heads() { Side::Even } else { Side::Odd };
        let new_face = (self.sphere || self.random.below(4) > 0).then_some(side);
        self.genus += usize::from(new_face.is_none());
        CcbSplit { kinds: [self.random.kind(), self.random.kind()], new_face }
    }

    /// After an edge that made two CCBs: marks them, and moves some of what the face has.
    fn mark_split(&mut self, e: EdgeId, old: FaceId, split: CcbSplit) {
        for (side, kind) in [Side::Even, Side::Odd].into_iter().zip(split.kinds) {
            let cycle = self.model.cycle_of(e.half(side));
            let is_new = split.new_face == Some(side);
            let face = if is_new { self.dcel.face(e.half(side)) } else { old };
            assert!(!is_new || self.model.faces.insert(face), "the new face is new");
            self.model.mark(&cycle, face, kind);
        }
        let Some(side) = split.new_face else { return };
        let new = self.dcel.face(e.half(side));
        let stays = [Side::Even, Side::Odd].map(|side| self.dcel.ccb(e.half(side)));
        for ccb in self.dcel.face_ccbs(old).collect::<Vec<_>>() {
            if !stays.contains(&ccb) && self.random.is_heads() {
                self.dcel.move_ccb(ccb, new);
                let cycle: Vec<_> = self.dcel.ccb_cycle(ccb).collect();
                self.model.mark(&cycle, new, self.dcel.ccb_kind(ccb));
            }
        }
        for v in self.dcel.isolated_vertices(old).collect::<Vec<_>>() {
            if self.random.is_heads() {
                self.dcel.move_isolated_vertex(v, new);
                self.model.isolated.insert(v, new);
            }
        }
    }

    fn insert(&mut self) {
        let prev1 = self.random.pick(self.dcel.halfedges());
        let Some(prev1) = prev1.filter(|_| self.random.below(5) > 0) else {
            return self.insert_inside();
        };
        let face = self.dcel.face(prev1);
        let same_face = self.dcel.face_ccbs(face).flat_map(|c| self.dcel.ccb_cycle(c));
        let prev2 = self.random.pick(same_face).expect("prev1 itself, at least");
        match self.random.below(4) {
            0 => {
                self.made[2] += 1;
                let v = self.end(face);
                let kind = self.model.sides[&prev1].1;
                let e = if self.random.is_heads() {
                    self.dcel.insert_edge_from(prev1, v)
                } else {
                    self.dcel.insert_edge_to(v, prev1)
                };
                let [from, to] = [e.halfedge(), e.halfedge().twin()];
                let [near, far] = if self.dcel.target(from) == v { [from, to] } else { [to, from] };
                assert_eq!(self.dcel.next(prev1), near);
                self.model.put_after(prev1, near);
                self.model.put_alone(v, far);
                self.model.mark(&[near, far], face, kind);
            }
            _ if self.dcel.ccb(prev1) == self.dcel.ccb(prev2) => {
                self.made[if prev1 == prev2 { 4 } else { 3 }] += 1;
                let split = self.split();
                let e = self.dcel.insert_edge_between(prev1, prev2, split);
                self.model.put_after(prev1, e.halfedge());
                self.model.put_after(prev2, e.halfedge().twin());
                self.mark_split(e, face, split);
            }
            _ => {
                self.made[5] += 1;
                let kind = self.random.kind();
                let e = self.dcel.insert_edge_joining(prev1, prev2, kind);
                self.model.put_after(prev1, e.halfedge());
                self.model.put_after(prev2, e.halfedge().twin());
                let cycle = self.model.cycle_of(e.halfedge());
                self.model.mark(&cycle, face, kind);
            }
        }
    }

    fn insert_inside(&mut self) {
        let face = self.face();
        let v = self.end(face);
        if self.random.is_heads() {
            self.made[1] += 1;
            let split = self.split();
            let e = self.dcel.insert_loop(v, face, split);
            self.model.put_alone(v, e.halfedge());
            self.model.put_after(e.halfedge().twin(), e.halfedge().twin());
            return self.mark_split(e, face, split);
        }
        self.made[0] += 1;
        let other = self.random.pick(self.dcel.isolated_vertices(face)).filter(|&w| w != v);
        let w = other.unwrap_or_else(|| self.dcel.add_vertex());
        let kind = self.random.kind();
        let e = self.dcel.insert_edge_in_face(v, w, face, kind);
        self.model.put_alone(v, e.halfedge());
        self.model.put_alone(w, e.halfedge().twin());
        self.model.mark(&[e.halfedge(), e.halfedge().twin()], face, kind);
    }

    fn remove(&mut self, e: EdgeId) {
        let [h, twin] = [e.halfedge(), e.halfedge().twin()];
        let [v, w] = self.dcel.ends(e);
        let survivor = if self.random.is_heads() { Side::Even } else { Side::Odd };
        let fates = [self.random.fate(), self.random.fate()];
        let (kept, gone) = match survivor {
            Side::Even => (self.dcel.face(h), self.dcel.face(twin)),
            Side::Odd => (self.dcel.face(twin), self.dcel.face(h)),
        };
        let other = |h: HalfedgeId| if h.edge_id() == e { None } else { Some(h) };
        let [near, far] = [other(self.dcel.prev(h)), other(self.dcel.prev(twin))];
        let kinds = [self.model.sides[&h].1, self.model.sides[&twin].1];
        let removed = self.dcel.remove_edge(e, fates, survivor);
        self.model.take(h);
        self.model.take(twin);
        for (v, fate) in [v, w].into_iter().zip(fates) {
            let is_bare = !self.model.around.contains_key(&v) && !self.model.isolated.contains_key(&v);
            if is_bare && fate == EndFate::Isolate {
                self.model.isolated.insert(v, kept);
            }
            if v == w {
                break;
            }
        }
        let was_face = kept != gone;
        if was_face {
            self.model.faces.remove(&gone);
            self.model.sides.values_mut().filter(|side| side.0 == gone).for_each(|side| side.0 = kept);
            self.model.isolated.values_mut().filter(|f| **f == gone).for_each(|f| *f = kept);
        }
        let rest = near.or(far);
        match removed {
            Removed::Antenna { ccb } => {
                self.made[6] += 1;
                assert_eq!(self.dcel.ccb(rest.expect("the rest of the CCB")), ccb);
            }
            Removed::Split { at_source, at_target } => {
                self.made[7] += 1;
                assert_eq!(near.map(|h| self.dcel.ccb(h)), Some(at_source));
                assert_eq!(far.map(|h| self.dcel.ccb(h)), Some(at_target));
            }
            Removed::Joined { ccb, faces } => {
                self.made[8] += 1;
                self.genus -= usize::from(!was_face);
                assert_eq!(faces.map(|f| (f.kept, f.gone)), was_face.then_some((kept, gone)));
                let kind = if kinds.contains(&Inner) { Inner } else { Outer };
                let cycle = self.model.cycle_of(rest.expect("the rest of the CCBs"));
                assert_eq!(self.dcel.ccb(cycle[0]), ccb);
                self.model.mark(&cycle, kept, kind);
            }
            Removed::Vanished { faces } => {
                self.made[9] += 1;
                self.genus -= usize::from(v == w && !was_face);
                assert_eq!(faces.map(|f| (f.kept, f.gone)), was_face.then_some((kept, gone)));
                assert_eq!(rest, None);
            }
        }
    }

    /// Edits that change no cycle but by a vertex, or turn an edge round.
    fn refine(&mut self) {
        let Some(e) = self.random.pick(self.dcel.edges()) else { return };
        let [h, twin] = [e.halfedge(), e.halfedge().twin()];
        let rename = |model: &mut Model, from: HalfedgeId, to: HalfedgeId| {
            for out in model.around.values_mut().flatten().filter(|h| **h == from) {
                *out = to;
            }
        };
        match self.random.below(3) {
            0 => {
                self.made[10] += 1;
                let before = Signature::of(&self.dcel);
                let v = self.dcel.add_vertex();
                let new = self.dcel.split_edge(e, v);
                rename(&mut self.model, twin, new.halfedge().twin());
                self.model.around.insert(v, vec![twin, new.halfedge()]);
                for (old, new) in [(h, new.halfedge()), (twin, new.halfedge().twin())] {
                    let side = self.model.sides[&old];
                    self.model.sides.insert(new, side);
                }
                let mut back = self.dcel.clone();
                assert_eq!(back.merge_edges(e, v), new);
                assert_eq!(Signature::of(&back), before, "merging undoes a split");
            }
            1 => {
                let v = self.dcel.ends(e)[self.random.below(2)];
                let around: Vec<_> = self.dcel.around(v).collect();
                if let [a, b] = around[..]
                    && a.edge_id() != b.edge_id()
                {
                    self.made[11] += 1;
                    let gone = self.dcel.merge_edges(e, v);
                    let away = if a.edge_id() == e { b } else { a };
                    assert_eq!(away.edge_id(), gone);
                    let kept = if a.edge_id() == e { a } else { b };
                    rename(&mut self.model, away.twin(), kept);
                    self.model.around.remove(&v);
                    self.model.sides.remove(&away);
                    self.model.sides.remove(&away.twin());
                }
            }
            _ => {
                self.made[12] += 1;
                let before = Signature::of(&self.dcel);
                self.dcel.reverse_edge(e);
                for out in self.model.around.values_mut().flatten().filter(|h| h.edge_id() == e) {
                    *out = out.twin();
                }
                let [side, twin_side] = [self.model.sides[&h], self.model.sides[&twin]];
                self.model.sides.insert(h, twin_side);
                self.model.sides.insert(twin, side);
                let mut back = self.dcel.clone();
                back.reverse_edge(e);
                assert_eq!(Signature::of(&back), before, "turned round twice");
            }
        }
    }

    fn vertices(&mut self) {
        self.made[13] += 1;
        let isolated = self.random.pick(self.model.isolated.keys().copied());
        match isolated {
            Some(v) if self.model.isolated.len() > 6 => {
                self.dcel.remove_isolated_vertex(v);
                self.model.isolated.remove(&v);
            }
            _ => {
                let face = self.face();
                let v = self.dcel.add_isolated_vertex(face);
                self.model.isolated.insert(v, face);
            }
        }
    }

    fn step(&mut self, limit: usize) {
        let old = self.dcel.clone();
        let edges = self.dcel.edge_count();
        match self.random.below(10) {
            0 => self.vertices(),
            1 | 2 => self.refine(),
            3..=5 if edges < limit => self.insert(),
            _ => {
                if let Some(e) = self.random.pick(self.dcel.edges()) {
                    let mut back = old.clone();
                    Gone::remove(&mut back, e, [self.random.fate(), self.random.fate()], Side::Even)
                        .put_back(&mut back);
                    assert_eq!(Signature::of(&back), Signature::of(&old), "{e:?} put back");
                    self.remove(e);
                } else {
                    self.insert();
                }
            }
        }
        if edges < self.dcel.edge_count() && old.edge_bound() == old.edge_count() {
            // Insertions are undone too: their edge is the last one.
            let e = EdgeId::new(self.dcel.edge_bound() - 1);
            let mut back = self.dcel.clone();
            Gone::remove(&mut back, e, [EndFate::Remove; 2], Side::Odd).put_back(&mut back);
            assert_eq!(Signature::of(&back), Signature::of(&self.dcel), "{e:?} put back");
        }
    }
}

fn run(seed: u64, sphere: bool, steps: usize, limit: usize) -> [usize; 14] {
    let mut script = Script::new(seed, sphere);
    for step in 0..steps {
        script.step(if step / 400 % 2 == 0 { limit } else { limit / 8 });
        let hint = format!("seed {seed}, step {step}");
        script.model.assert_agrees(&script.dcel, &hint);
        assert_eq!(script.dcel.least_genus(), script.genus, "{hint}");
        assert_eq!(script.dcel.check_euler(script.genus), [], "{hint}");
        assert!(!sphere || script.genus == 0, "{hint}");
        if step % 50 == 0 {
            assert_compact(&script.dcel, &hint);
        }
    }
    script.made
}

fn assert_compact(dcel: &Dcel, hint: &str) {
    let mut dense = dcel.clone();
    let maps = dense.compact();
    assert_eq!(dense.check_valid(), [], "{hint}");
    assert_eq!(
        (dense.vertex_bound(), dense.edge_bound()),
        (dcel.vertex_count(), dcel.edge_count()),
        "{hint}"
    );
    assert_eq!((dense.ccb_bound(), dense.face_bound()), (dcel.ccb_count(), dcel.face_count()), "{hint}");
    for h in dcel.halfedges() {
        let new = maps.halfedge(h).expect("it stays");
        assert_eq!(maps.halfedge(dcel.next(h)), Some(dense.next(new)), "{hint}");
        assert_eq!(maps.vertex(dcel.source(h)), Some(dense.source(new)), "{hint}");
        assert_eq!(maps.ccb(dcel.ccb(h)), Some(dense.ccb(new)), "{hint}");
        assert_eq!(maps.edge(h.edge_id()), Some(new.edge_id()), "{hint}");
    }
    for f in dcel.faces() {
        let new = maps.face(f).expect("it stays");
        let ccbs: Vec<Option<CcbId>> = dcel.face_ccbs(f).map(|c| maps.ccb(c)).collect();
        assert_eq!(ccbs, dense.face_ccbs(new).map(Some).collect::<Vec<_>>(), "{hint}");
        let isolated: Vec<_> = dcel.isolated_vertices(f).map(|v| maps.vertex(v)).collect();
        assert_eq!(isolated, dense.isolated_vertices(new).map(Some).collect::<Vec<_>>(), "{hint}");
    }
    assert_eq!(dense.clone().compact().vertex(VertexId::new(dense.vertex_bound())), None);
}

#[test]
fn random_edits_agree_with_the_model_on_the_sphere() {
    let made = run(1, true, 10_000, 40);
    assert!(made.iter().all(|&n| n > 50), "edits not made: {made:?}");
}

#[test]
fn random_edits_agree_with_the_model_on_any_genus() {
    let made = run(2, false, 10_000, 40);
    assert!(made.iter().all(|&n| n > 50), "edits not made: {made:?}");
}

#[test]
fn small_structures_meet_every_degenerate_case() {
    for seed in 100..110 {
        let made = run(seed, seed % 2 == 0, 600, 5);
        assert!(made.iter().all(|&n| n > 0), "seed {seed}: edits not made: {made:?}");
    }
}
