//! Two polytopes, the second one turned: their extreme features, and the vertices of M one by one.

use crate::answer::Kind;
use crate::contact::extreme_face;
use crate::{Feature, Witness};
use dcel::VertexId;
use exact::{Affine3, Linear3, Point3, Quaternion, Sign, Vector3, predicate};
use polytope::Polytope;

/// P, and Q turned by a rotation.
#[derive(Clone, Debug)]
pub(crate) struct Bodies<'a> {
    pub(crate) p: &'a Polytope,
    pub(crate) q: &'a Polytope,
    /// From a point of Q to the point of M that it makes with the origin: the rotation, then the reflection.
    reflected: Affine3,
    turn: Option<Turn>,
}

#[derive(Clone, Debug)]
struct Turn {
    forth: Affine3,
    back: Linear3,
}

/// A vertex of M that has been met, or a point of it that need not be a vertex: the difference of a vertex of P and one of Q.
#[derive(Clone, Debug)]
pub(crate) struct Corner {
    pub(crate) of: [u32; 2],
    pub(crate) at: Point3,
}

impl<'a> Bodies<'a> {
    pub(crate) fn new(p: &'a Polytope, q: &'a Polytope, rotation: Option<&Quaternion>) -> Self {
        let turn = rotation.map(|rotation| {
            let [w, x, y, z] = rotation.components().clone();
            let back = Quaternion::new([w, -x, -y, -z]).expect("a quaternion is not zero");
            Turn { forth: Affine3::rotation(rotation), back: Linear3::rotation(&back) }
        });
        let reflected = match &turn {
            Some(turn) => turn.forth.then(&Affine3::reflection()),
            None => Affine3::reflection(),
        };
        Self { p, q, reflected, turn }
    }

    /// A vertex of Q after the rotation.
    pub(crate) fn turned(&self, v: VertexId) -> Point3 {
        let point = &self.q.points()[v.index()];
        self.turn.as_ref().map_or_else(|| point.clone(), |turn| turn.forth.apply(point))
    }

    /// The direction in which Q, before the rotation, is extreme where the reflection of the turned Q is extreme in `direction`.
    fn back(&self, direction: &Vector3) -> Vector3 {
        let opposite = -direction;
        self.turn.as_ref().map_or_else(|| opposite.clone(), |turn| turn.back.apply(&opposite).primitive())
    }

    /// The difference of a vertex of P and one of the turned Q.
    pub(crate) fn corner(&self, of: [u32; 2]) -> Corner {
        let q = self.reflected.apply(&self.q.points()[of[1] as usize]);
        Corner { of, at: self.p.points()[of[0] as usize].plus(&q) }
    }

    /// The extreme point of M in a direction, found by walking on P and Q from a vertex of each.
    ///
    /// A step crosses an arc of the Gaussian map of P or of Q towards the direction.
    pub(crate) fn extreme(&self, direction: &Vector3, from: [u32; 2]) -> [u32; 2] {
        [climb(self.p, from[0], direction), climb(self.q, from[1], &self.back(direction))]
    }

    /// The features of P and Q that make the face of M in a direction.
    pub(crate) fn faces(&self, direction: &Vector3) -> [Feature; 2] {
        let back = self.back(direction);
        let face = |body: &Polytope, d: &Vector3| extreme_face(body, VertexId(climb(body, 0, d)), d);
        [face(self.p, direction), face(self.q, &back)]
    }

    /// The pair of vertices where a walk begins.
    pub(crate) fn start(&self, hint: Option<Witness>) -> [u32; 2] {
        match hint {
            Some(Witness(Kind::Vertices([p, q])))
                if (p as usize) < self.p.points().len() && (q as usize) < self.q.points().len() =>
            {
                [p, q]
            }
            _ => [0, 0],
        }
    }
}

/// Walks to a vertex of a polytope that is extreme in a direction.
fn climb(body: &Polytope, from: u32, direction: &Vector3) -> u32 {
    let mesh = body.mesh();
    if mesh.edge_count() == 0 {
        return from;
    }
    let mut v = VertexId(from);
    let points = body.points();
    let higher = |v: VertexId| {
        let here = &points[v.index()];
        let rises =
            |w: &VertexId| predicate::plane_side(direction, here, &points[w.index()]) == Sign::Positive;
        mesh.vertex_cycle(v).map(|h| mesh.target(h)).find(rises)
    };
    while let Some(w) = higher(v) {
        v = w;
    }
    v.0
}
