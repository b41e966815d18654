//! Edits whose neighbours are known.

use super::Editor;
use super::curve::Next;
use super::place::At;
use crate::arrangement::CurveId;
use crate::edit::{Edit, Observer, Operation};
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::{CurveEnd, UMonotoneTraits};
use crate::trapezoids::{Found, NewSite, TrapezoidId, side};
use crate::zone::Hit;
use dcel::{EdgeId, FaceId, VertexId};

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts a point: an isolated vertex in a face, or a vertex that divides an edge. At a vertex, nothing changes, but an artificial one
    /// becomes an ordinary one.
    ///
    /// # Preconditions
    /// Those of [`Editor`] on points.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order.
    ///
    /// # Examples
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// editor.insert_curve(&Segment::from_i64([[0, 0], [4, 0]]).expect("the ends are different"));
    /// let [alone, middle, again] = [[1, 1], [2, 0], [2, 0]].map(|at| editor.insert_point(&Point2::from_i64(at)));
    /// assert_eq!(editor.dcel().isolated_face(alone), Some(editor.corner_face()));
    /// assert_eq!((editor.dcel().degree(middle), again), (2, middle));
    /// ```
    pub fn insert_point(&mut self, point: &G::Point) -> VertexId {
        self.operate(Operation::InsertPoint, |editor| editor.add_point(point))
    }

    /// Inserts an isolated vertex in a face.
    ///
    /// # Preconditions
    /// The point lies in the face.
    ///
    /// # Panics
    /// In debug builds, if it does not.
    ///
    /// # Complexity
    /// As of [`Editor::insert_point`].
    pub fn insert_point_in_face(&mut self, point: &G::Point, face: FaceId) -> VertexId {
        debug_assert_eq!(self.locate(point), Cell::Face(face), "the point lies in face {}", face.0);
        self.insert_point(point)
    }

    /// Inserts a curve in a face: an edge with two new vertices, one if the curve has an end on a side that is a vertex.
    ///
    /// It gives the same as `insert_curve` of the same curve, and so do the other insertions of this kind; they only ask less.
    ///
    /// # Preconditions
    /// The curve lies in the interior of the face, ends included that are not on sides that are vertices. So it does not close the face
    /// of a torus: the ends are different points.
    ///
    /// # Panics
    /// In debug builds, if that is not so.
    ///
    /// # Complexity
    /// Expected O(log n) to locate the ends if curves came in random order; and linear in the number of trapezoids through which the
    /// curve runs, and, if it splits the face, in what [`Editor`] says of that.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// A triangle:
    ///
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let plane = editor.corner_face();
    /// let base = editor.insert_edge_in_face(segment([[0, 0], [4, 0]]), plane);
    /// let [left, right] = editor.dcel().ends(base);
    /// let side = editor.insert_edge_from(left, segment([[0, 0], [2, 3]]));
    /// let top = editor.dcel().ends(side)[1];
    /// editor.insert_edge_between([top, right], segment([[2, 3], [4, 0]]));
    /// assert_eq!(editor.counts().faces, 2);
    /// ```
    pub fn insert_edge_in_face(&mut self, curve: G::UMonotoneCurve, face: FaceId) -> EdgeId {
        let are_in = |editor: &Self| editor.are_new_ends_in(&curve, CurveEnd::BOTH, Some(face));
        debug_assert!(are_in(self), "the ends lie in face {}", face.0);
        self.insert_known(curve, [None; 2])
    }

    /// Inserts a curve that begins at a vertex: its max vertex is new, unless that end is on a side that is a vertex.
    ///
    /// # Preconditions
    /// The min end of the curve is the point of the vertex. The rest of it lies in the interior of a face, but for a max end on a side
    /// that is a vertex.
    ///
    /// # Panics
    /// If there is no such vertex. In debug builds, if the preconditions do not hold.
    ///
    /// # Complexity
    /// As of [`Editor::insert_edge_in_face`], with one end to be located.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    pub fn insert_edge_from(&mut self, v: VertexId, curve: G::UMonotoneCurve) -> EdgeId {
        let is_in = |editor: &Self| editor.are_new_ends_in(&curve, [CurveEnd::Max], None);
        debug_assert!(is_in(self), "the max end of the edge from vertex {} lies in a face", v.0);
        self.insert_known(curve, [Some(v), None])
    }

    /// Inserts a curve that ends at a vertex: its min vertex is new, unless that end is on a side that is a vertex.
    ///
    /// # Preconditions
    /// Those of [`Editor::insert_edge_from`], with the ends exchanged.
    ///
    /// # Panics
    /// If there is no such vertex. In debug builds, if the preconditions do not hold.
    ///
    /// # Complexity
    /// As of [`Editor::insert_edge_from`].
    pub fn insert_edge_to(&mut self, curve: G::UMonotoneCurve, v: VertexId) -> EdgeId {
        let is_in = |editor: &Self| editor.are_new_ends_in(&curve, [CurveEnd::Min], None);
        debug_assert!(is_in(self), "the min end of the edge to vertex {} lies in a face", v.0);
        self.insert_known(curve, [None, Some(v)])
    }

    /// Inserts a curve from one vertex to another, or, where sides are identified, to the same one.
    ///
    /// # Preconditions
    /// The min end of the curve is the point of the first vertex, or is on the side for which that stands; so is the max end for the
    /// second vertex. The interior of the curve lies in the interior of a face.
    ///
    /// # Panics
    /// If there is no such vertex. In debug builds, if the preconditions do not hold.
    ///
    /// # Complexity
    /// As of [`Editor::insert_edge_in_face`], with no end to be located; but around a vertex with more edges to the right, or on a side,
    /// directions are compared as `insert_curve` does it.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    pub fn insert_edge_between(&mut self, ends: [VertexId; 2], curve: G::UMonotoneCurve) -> EdgeId {
        self.insert_known(curve, ends.map(Some))
    }

    /// Inserts a curve whose interior meets nothing; its ends are located.
    ///
    /// Degenerate: an end may lie on an edge, which is split, or at a vertex.
    ///
    /// # Preconditions
    /// The interior of the curve lies in the interior of a face.
    ///
    /// # Panics
    /// In debug builds, if it does not.
    ///
    /// # Complexity
    /// As of [`Editor::insert_edge_in_face`].
    ///
    /// # References
    /// Thesis, section 2.4.2.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// editor.insert_disjoint(segment([[0, 0], [4, 0]]));
    /// editor.insert_disjoint(segment([[2, 0], [2, 3]]));
    /// let counts = editor.counts();
    /// assert_eq!((counts.vertices, counts.edges), (4, 3));
    /// ```
    pub fn insert_disjoint(&mut self, curve: G::UMonotoneCurve) -> EdgeId {
        self.insert_known(curve, [None; 2])
    }

    /// Inserts a curve whose interior meets nothing, and of whose ends some are at known vertices.
    fn insert_known(&mut self, curve: G::UMonotoneCurve, known: [Option<VertexId>; 2]) -> EdgeId {
        for v in known.into_iter().flatten() {
            let is_vertex = self.arrangement.dcel().has_vertex(v);
            assert!(is_vertex, "vertex {} does not exist: only at a vertex an edge begins or ends", v.0);
        }
        self.operate(Operation::InsertEdge, |editor| {
            let support = editor.arrangement.apply(Edit::AddCurve { curve }, &mut editor.observers).curve();
            let ends = CurveEnd::BOTH.map(|end| match known[end as usize] {
                Some(v) => editor.known_vertex(v, support, end),
                None => editor.vertex_at_end(support, end, false),
            });
            let first = editor.first_of(support, ends[0].site);
            debug_assert_eq!(
                editor.obstacle(support, ends, first),
                None,
                "the interior of the curve is free"
            );
            editor.insert_edge(support, ends, first)
        })
    }

    /// What a stored curve meets, or runs along, before it comes to its max end; it goes through the trapezoid first.
    fn obstacle(&self, support: CurveId, ends: [At; 2], first: TrapezoidId) -> Option<Cell> {
        match self.next_from(support, ends[0].site, first) {
            Next::Along(e, _) => Some(Cell::Edge(e)),
            Next::Through(_, Hit::Site { site, is_end: true }) if site == ends[1].site => None,
            Next::Through(_, Hit::Site { site, .. }) => Some(Cell::Vertex(self.trapezoids.vertex(site))),
            Next::Through(_, Hit::Edge { rail, .. }) => Some(Cell::Edge(self.trapezoids.rail(rail).edge)),
            Next::Through(_, Hit::End { .. }) => unreachable!("there is a vertex at the max end"),
        }
    }

    /// A known vertex, at the place where a stored curve has an end.
    fn known_vertex(&mut self, v: VertexId, support: CurveId, end: CurveEnd) -> At {
        let arrangement = &self.arrangement;
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let curve = arrangement.curve(support);
        let location = topology.end_location(traits, curve, end);
        let Some(point) = arrangement.inner_point(v).cloned() else {
            let on_side = self.side_vertex(location);
            debug_assert_eq!(on_side, Some(v), "the curve ends on the side of vertex {}", v.0);
            return self.vertex_at_end(support, end, false);
        };
        debug_assert!(
            traits.end_point(curve, end).is_some_and(|end| traits.is_same_point(end, &point)),
            "the curve ends at vertex {}",
            v.0
        );
        self.make_ordinary(v);
        At { v, site: self.site_at(v, &point, location) }
    }

    /// Tells whether ends of a curve lie in the interior of a face, of the one given if one is; ends on sides that are vertices count not.
    fn are_new_ends_in(
        &self,
        curve: &G::UMonotoneCurve,
        ends: impl IntoIterator<Item = CurveEnd>,
        face: Option<FaceId>,
    ) -> bool {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        ends.into_iter().all(|end| {
            let location = topology.end_location(traits, curve, end);
            let point = traits.end_point(curve, end).filter(|_| self.side_vertex(location).is_none());
            point.is_none_or(|point| match self.locate(point) {
                Cell::Face(f) => face.is_none_or(|face| face == f),
                _ => false,
            })
        })
    }

    /// Adds a point: a vertex of its own, or on an edge.
    pub(super) fn add_point(&mut self, point: &G::Point) -> VertexId {
        let arrangement = &self.arrangement;
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        let location = place.location;
        if let Some(v) = arrangement.contraction_at(location) {
            self.make_ordinary(v);
            return v;
        }
        match self.trapezoids.find(arrangement, &place) {
            Found::Within(t) => {
                let below = self.trapezoids.trapezoid(t).below;
                let is_on = !below.is_none() && {
                    let curve = self.trapezoids.rail(below).curve;
                    side(arrangement, &place, &arrangement.curves()[curve as usize]).is_eq()
                };
                if is_on {
                    return self.split_rail(below, point, location, false).v;
                }
                let face = self.trapezoids.face_of(arrangement, t);
                let edit = Edit::AddIsolatedVertex { point: point.clone(), is_artificial: false, face };
                let v = self.arrangement.apply(edit, &mut self.observers).vertex();
                self.trapezoids.add_site(&self.arrangement, NewSite::Vertex(v), location, t);
                v
            }
            Found::Site(site) => {
                let v = self.trapezoids.vertex(site);
                self.make_ordinary(v);
                v
            }
        }
    }
}
