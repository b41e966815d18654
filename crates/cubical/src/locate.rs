//! In which cell of the sphere a direction lies.

use crate::map::{At, CubicalArrangement, CubicalFaceId};
use arrangement::location::{PointLocation, Walk};
use arrangement::overlay::Cell;
use dcel::{EdgeId, VertexId};
use exact::gnomonic::CubeSide;
use exact::spherical::Direction;

/// A real cell of the sphere.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CubicalCell {
    /// A real vertex, by its first copy.
    Vertex(At<VertexId>),
    /// A real edge of a side, without its ends; or, if the vertex there is artificial, one of the two that meet there.
    Edge(At<EdgeId>),
    /// A face, without its boundary.
    Face(CubicalFaceId),
}

impl CubicalArrangement {
    /// Finds the real vertex, the real edge or the face in which a direction lies.
    ///
    /// # Complexity
    /// O(n) for n edges of the side, because nothing is prepared: the walk along a vertical line begins at the border of the side, and reads
    /// the whole boundary of every face through which it comes.
    ///
    /// For many queries, keep a structure for each side: a strategy of [`arrangement::location`] works with [`CubicalArrangement::side`] as
    /// with any arrangement.
    ///
    /// ```
    /// use exact::spherical::{Direction, GreatCircle};
    /// use splitstar_cubical::{CubicalArrangement, CubicalCell, CubicalPieces};
    /// let mut pieces = CubicalPieces::new();
    /// pieces.push_circle(&GreatCircle::from_i64([0, 0, 1]).expect("not zero"));
    /// let map = CubicalArrangement::of_pieces(pieces);
    /// let [on, above, below, corner] = [[1, 1, 0], [5, 2, 1], [0, 0, -1], [1, 1, 1]].map(|p| map.locate(&Direction::from_i64(p).expect("not zero")));
    /// assert!(matches!(on, CubicalCell::Edge(_)));
    /// assert!(above == corner && above != below);
    /// ```
    ///
    /// Many queries, with six k-d trees of landmarks:
    ///
    /// ```
    /// use arrangement::location::{Landmarks, PointLocation};
    /// use arrangement::overlay::Cell;
    /// use exact::spherical::{Direction, GreatCircle};
    /// use splitstar_cubical::{At, CubeSide, CubicalArrangement, CubicalCell, CubicalPieces};
    /// let mut pieces = CubicalPieces::new();
    /// for normal in [[1, 2, 3], [3, -1, 2], [0, 0, 1]] {
    ///     pieces.push_circle(&GreatCircle::from_i64(normal).expect("not zero"));
    /// }
    /// let map = CubicalArrangement::of_pieces(pieces);
    /// let landmarks = CubeSide::ALL.map(|side| Landmarks::new(map.side(side)));
    /// for i in 0..100 {
    ///     let query = Direction::from_i64([i - 40, 7, 3 * i % 20 - 11]).expect("not zero");
    ///     let side = CubeSide::of(&query).first();
    ///     let point = side.point_of(&query).expect("the direction lies on the side");
    ///     let cell = landmarks[side.index()].locate(map.side(side), &point)?;
    ///     if let Cell::Face(id) = cell {
    ///         let face = map.face_of(At { side, id }).expect("a direction does not lie outside of the cube");
    ///         assert_eq!(map.locate(&query), CubicalCell::Face(face));
    ///     }
    /// }
    /// # Ok::<(), arrangement::edit::Stale>(())
    /// ```
    pub fn locate(&self, p: &Direction) -> CubicalCell {
        let side = CubeSide::of(p).first();
        let point = side.point_of(p).expect("the direction lies on the side");
        let cell = Walk.locate(self.side(side), &point).expect("nothing was prepared");
        let face = |h| CubicalCell::Face(self.face(At { side, id: h }));
        match cell {
            Cell::Face(id) => CubicalCell::Face(
                self.face_of(At { side, id }).expect("a direction does not lie outside of the cube"),
            ),
            Cell::Edge(id) if self.is_real_edge(At { side, id }) => CubicalCell::Edge(At { side, id }),
            Cell::Edge(id) => face(self.inner_halfedge(At { side, id })),
            Cell::Vertex(id) => {
                let v = At { side, id };
                if self.is_real_vertex(v) {
                    return CubicalCell::Vertex(self.first_copy(v));
                }
                match self.real_around(v).next() {
                    Some(h) => CubicalCell::Edge(At { side: h.side, id: h.id.edge_id() }),
                    None => face(self.outgoing(v).expect("an artificial vertex has edges").id),
                }
            }
        }
    }
}
