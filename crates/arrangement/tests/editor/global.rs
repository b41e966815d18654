//! Numbering anew, dropping all, and sweeps between edits.

use crate::scenes::{Law, Scene, check, for_all, watch};
use exact::planar::Point2;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::ArrangementTraits;
use testkit::Rng;

struct Compact;

impl Law for Compact {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.sweep_all());
        let edges: Vec<_> = editor.arrangement().dcel().edges().filter(|_| rng.one_in(2)).collect();
        for e in edges {
            editor.remove_edge(e);
        }
        let before = editor.arrangement().clone();
        let renumbering = editor.compact();
        check(&editor);
        let after = editor.arrangement();
        assert_eq!(before.difference(after), None);
        assert_eq!(after.dcel().edge_bound(), after.dcel().edge_count());
        assert_eq!(after.dcel().vertex_bound(), after.dcel().vertex_count());
        assert_eq!(after.dcel().face_bound(), after.dcel().face_count());
        for v in before.dcel().vertices() {
            assert_eq!(after.point(renumbering.vertex(v).unwrap()), before.point(v));
        }
        for e in before.dcel().edges() {
            let new = renumbering.edge(e).unwrap();
            assert_eq!(renumbering.curve(before.support(e)), Some(after.support(new)));
            let h = renumbering.halfedge(e.halfedge()).unwrap();
            let faces = [before.dcel().face(e.halfedge()), after.dcel().face(h)];
            assert_eq!(renumbering.face(faces[0]), Some(faces[1]));
            let ccbs = [before.dcel().ccb(e.halfedge()), after.dcel().ccb(h)];
            assert_eq!(renumbering.ccb(ccbs[0]), Some(ccbs[1]));
        }
        assert_eq!(renumbering.face(before.corner_face()), Some(after.corner_face()));
        // What finds places still does, and all that was removed comes again.
        for curve in &scene.curves {
            editor.insert_curve(curve);
        }
        check(&editor);
        editor.clear();
        assert_eq!(editor.arrangement().difference(&scene.empty()), None);
        check(&editor);
        assert!(editor.arrangement().curves().is_empty());
        for curve in &scene.curves {
            editor.insert_curve(curve);
            check(&editor);
        }
    }
}

#[test]
fn ids_are_made_dense() {
    for_all(&Compact, 40, 6000);
}

struct Mixed;

impl Law for Mixed {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.empty());
        let mut done = 0;
        while done < scene.curves.len() {
            if rng.one_in(2) {
                editor.insert_curve(&scene.curves[done]);
                done += 1;
            } else {
                let next = done + 1 + rng.index(scene.curves.len() - done);
                let before = editor.arrangement().clone();
                let provenance = editor.insert_curves(&scene.curves[done..next]);
                let after = editor.arrangement();
                for v in after.vertices() {
                    if let [Cell::Vertex(old)] = provenance.of_vertex(v) {
                        assert_eq!(after.point(v), before.point(*old));
                    }
                }
                done = next;
            }
            check(&editor);
        }
        editor.insert_points(scene.points.iter().cloned());
        check(&editor);
        assert_eq!(editor.arrangement().difference(&scene.sweep_all()), None);
        assert!(editor.observers_mut().1.pop().is_none(), "all that was before a sweep is dropped");
    }
}

#[test]
fn sweeps_and_single_curves_mix() {
    for_all(&Mixed, 40, 7000);
}
