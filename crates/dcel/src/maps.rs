//! Property maps: what a user attaches to cells.

use crate::{Dcel, EdgeId, FaceId, HalfedgeId, VertexId};
use std::ops::{Index, IndexMut};

macro_rules! map {
    ($(#[$doc:meta])* $name:ident, $id:ident, $bound:ident, $has:ident) => {
        $(#[$doc])*
        ///
        /// The values stand in the order of the ids. Indexing panics for an id at or above the bound
        /// that the map was made for; edits that add cells are followed by
        /// [`get_mut_or_default`](Self::get_mut_or_default). The id of a removed cell keeps its value
        /// until it is set again.
        #[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
        pub struct $name<T> {
            values: Vec<T>,
        }

        impl<T> $name<T> {
            /// The same value for all.
            pub fn filled(dcel: &Dcel, value: T) -> Self
            where
                T: Clone,
            {
                Self { values: vec![value; dcel.$bound()] }
            }

            /// A value made for each cell; the default for ids of removed cells.
            pub fn from_fn(dcel: &Dcel, mut value: impl FnMut($id) -> T) -> Self
            where
                T: Default,
            {
                let ids = (0..dcel.$bound()).map($id::new);
                Self { values: ids.map(|id| if dcel.$has(id) { value(id) } else { T::default() }).collect() }
            }

            /// The value of `id`; none at or above the bound.
            pub fn get(&self, id: $id) -> Option<&T> {
                self.values.get(id.index())
            }

            /// The value of `id`, to be changed; none at or above the bound.
            pub fn get_mut(&mut self, id: $id) -> Option<&mut T> {
                self.values.get_mut(id.index())
            }

            /// The value of `id`, to be changed. The map grows to have one.
            pub fn get_mut_or_default(&mut self, id: $id) -> &mut T
            where
                T: Default,
            {
                if id.index() >= self.values.len() {
                    self.values.resize_with(id.index() + 1, T::default);
                }
                &mut self.values[id.index()]
            }

            /// All values in the order of the ids, those of removed cells included.
            pub fn values(&self) -> &[T] {
                &self.values
            }
        }

        /// From the values in the order of the ids.
        impl<T> From<Vec<T>> for $name<T> {
            fn from(values: Vec<T>) -> Self {
                Self { values }
            }
        }

        impl<T> Index<$id> for $name<T> {
            type Output = T;

            #[inline]
            fn index(&self, id: $id) -> &T {
                &self.values[id.index()]
            }
        }

        impl<T> IndexMut<$id> for $name<T> {
            #[inline]
            fn index_mut(&mut self, id: $id) -> &mut T {
                &mut self.values[id.index()]
            }
        }
    };
}

map!(
    /// A value for each vertex.
    VertexMap,
    VertexId,
    vertex_bound,
    has_vertex
);
map!(
    /// A value for each edge.
    EdgeMap,
    EdgeId,
    edge_bound,
    has_edge
);
map!(
    /// A value for each halfedge.
    HalfedgeMap,
    HalfedgeId,
    halfedge_bound,
    has_halfedge
);
map!(
    /// A value for each face.
    FaceMap,
    FaceId,
    face_bound,
    has_face
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CcbKind, EndFate, Side};

    #[test]
    fn maps_grow_and_skip_removed_cells() {
        let mut dcel = Dcel::new();
        let [v, w] = [dcel.add_vertex(), dcel.add_vertex()];
        let e = dcel.insert_edge_in_face(v, w, FaceId(0), CcbKind::Inner);
        let x = dcel.add_vertex();
        let f = dcel.insert_edge_from(e.halfedge(), x);
        dcel.remove_edge(e, [EndFate::Remove, EndFate::Remove], Side::Even);
        let mut seen = Vec::new();
        let edges = EdgeMap::from_fn(&dcel, |e| {
            seen.push(e);
            e.0 + 10
        });
        assert_eq!(seen, [f]);
        assert_eq!((edges.values(), edges[f], edges.get(EdgeId(2))), (&[0, 11][..], 11, None));
        let mut degrees = VertexMap::from_fn(&dcel, |v| dcel.degree(v));
        assert_eq!(degrees.values(), [0, 1, 1]);
        *degrees.get_mut_or_default(VertexId(5)) += 3;
        degrees[VertexId(4)] = 2;
        assert_eq!(degrees.values(), [0, 1, 1, 0, 2, 3]);
        assert_eq!(degrees.get_mut(VertexId(6)), None);
        assert_eq!(HalfedgeMap::filled(&dcel, 'a').values(), ['a'; 4]);
        assert_eq!(FaceMap::from(vec![true])[FaceId(0)], FaceMap::filled(&dcel, true)[FaceId(0)]);
    }

    #[test]
    #[should_panic(expected = "index out of bounds")]
    fn indexing_above_the_bound_panics() {
        let _ = FaceMap::filled(&Dcel::new(), 0)[FaceId(1)];
    }
}
