//! All is numbered anew, dropped, or swept again: no id stays what it was.

use super::Editor;
use crate::arrangement::build::{Builder, CORNER_FACE};
use crate::arrangement::{CurveId, Parts};
use crate::edit::Observer;
use crate::insert::Pieces;
use crate::overlay::Provenance;
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, UMonotoneTraits};
use crate::trapezoids::Trapezoids;
use dcel::{CcbId, Compaction, EdgeId, FaceId, HalfedgeId, VertexId};

/// The new ids that [`Editor::compact`] gave; none for what had been removed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Renumbering {
    cells: Compaction,
    curves: Vec<Option<CurveId>>,
}

impl Renumbering {
    /// The new id of a vertex.
    pub fn vertex(&self, old: VertexId) -> Option<VertexId> {
        self.cells.vertex(old)
    }

    /// The new id of an edge.
    pub fn edge(&self, old: EdgeId) -> Option<EdgeId> {
        self.cells.edge(old)
    }

    /// The new id of a halfedge: an even one if the old one is.
    pub fn halfedge(&self, old: HalfedgeId) -> Option<HalfedgeId> {
        self.cells.halfedge(old)
    }

    /// The new id of a CCB.
    pub fn ccb(&self, old: CcbId) -> Option<CcbId> {
        self.cells.ccb(old)
    }

    /// The new id of a face.
    pub fn face(&self, old: FaceId) -> Option<FaceId> {
        self.cells.face(old)
    }

    /// The new id of a curve; none for one on which no edge lies.
    pub fn curve(&self, old: CurveId) -> Option<CurveId> {
        self.curves.get(old.index()).copied().flatten()
    }
}

/// Changes of all at once. Observers are told that all is replaced, and no more.
impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Makes the ids of each kind dense again, in the order that they have, and drops curves on which no edge lies. Gives the new ids.
    ///
    /// What finds places is built anew, edges in random order. So this also helps after an adverse order of edits.
    ///
    /// # Complexity
    /// Expected O(n log n), for n cells and curves.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let [e, f] = [[[0, 0], [1, 0]], [[0, 1], [1, 1]]].map(|ends| {
    ///     editor.insert_disjoint(Segment::from_i64(ends).expect("the ends are different"))
    /// });
    /// editor.remove_edge(e);
    /// let renumbering = editor.compact();
    /// assert_eq!((renumbering.edge(e), renumbering.edge(f)), (None, Some(e)));
    /// assert_eq!(editor.curves().len(), 1);
    /// ```
    pub fn compact(&mut self) -> Renumbering {
        let renumbering = self.arrangement.apply_global(&mut self.observers, |arrangement| {
            let (dcel, supports) = (&mut arrangement.dcel, &mut arrangement.supports);
            let mut is_used = vec![false; arrangement.curves.len()];
            for e in dcel.edges() {
                is_used[supports[e.index()] as usize] = true;
            }
            let mut next = 0;
            let curves: Vec<Option<CurveId>> = is_used
                .iter()
                .map(|&is| {
                    next += u32::from(is);
                    is.then(|| CurveId(next - 1))
                })
                .collect();
            let cells = dcel.compact();
            arrangement.corner_face = cells.face(arrangement.corner_face).expect("the corner face stays");
            keep(&mut arrangement.curves, |i| is_used[i]);
            keep(supports, |i| cells.edge(EdgeId::new(i)).is_some());
            for support in supports {
                *support = curves[*support as usize].expect("the curve of an edge stays").0;
            }
            let stays = |i| cells.vertex(VertexId::new(i)).is_some();
            keep(&mut arrangement.points, stays);
            keep(&mut arrangement.is_artificial, stays);
            Renumbering { cells, curves }
        });
        self.trapezoids = Trapezoids::of(&self.arrangement);
        renumbering
    }

    /// Removes all: one face is left.
    ///
    /// # Complexity
    /// Linear, to drop what was there.
    pub fn clear(&mut self) {
        self.arrangement.apply_global(&mut self.observers, |arrangement| {
            let (traits, topology) = (&arrangement.traits, &arrangement.topology);
            let built = Builder::new(traits, topology, &[]).finish(topology);
            arrangement.set_parts(Parts {
                dcel: built.dcel,
                points: built.points,
                is_artificial: built.is_artificial,
                curves: Vec::new(),
                supports: Vec::new(),
                corner_face: CORNER_FACE,
            });
        });
        self.trapezoids = Trapezoids::of(&self.arrangement);
    }

    /// Inserts u-monotone curves and points by one sweep over them and the edges that are there: see [`Arrangement::insert_pieces`].
    ///
    /// For many curves that is faster than to insert them one by one. All cells get new ids; the answer tells for every new cell in
    /// which old one it lies.
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// # Complexity
    /// That of a [`sweep`](crate::sweep::sweep) over old edges and new curves, and expected O(n log n) for what finds places.
    ///
    /// [`Arrangement::insert_pieces`]: crate::Arrangement::insert_pieces
    pub fn insert_pieces(&mut self, pieces: Pieces<G>) -> Provenance {
        let provenance = self
            .arrangement
            .apply_global(&mut self.observers, |arrangement| arrangement.insert_pieces(pieces));
        self.trapezoids = Trapezoids::of(&self.arrangement);
        provenance
    }

    /// Inserts points by one sweep: see [`Editor::insert_pieces`]. One by one: [`Editor::insert_point`].
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// # Complexity
    /// As of [`Editor::insert_pieces`].
    pub fn insert_points(&mut self, points: impl IntoIterator<Item = G::Point>) -> Provenance {
        self.insert_pieces(Pieces { points: points.into_iter().collect(), ..Pieces::new() })
    }
}

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts general curves by one sweep: see [`Editor::insert_pieces`]. One by one: [`Editor::insert_curve`].
    ///
    /// # Complexity
    /// As of [`Editor::insert_pieces`].
    ///
    /// # References
    /// Thesis, section 2.4.1.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// use splitstar_arrangement::overlay::Cell;
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let old = editor.insert_curve(&segment([[0, 0], [4, 0]]));
    /// let provenance = editor.insert_curves(&[segment([[2, -1], [2, 1]]), segment([[3, -1], [3, 1]])]);
    /// let on_old = |e: &_| provenance.of_edge(*e) == [Cell::Edge(old[0])];
    /// assert_eq!(editor.dcel().edges().filter(on_old).count(), 3);
    /// ```
    pub fn insert_curves<'a>(&mut self, curves: impl IntoIterator<Item = &'a G::Curve>) -> Provenance
    where
        G::Curve: 'a,
    {
        self.insert_curves_and_points(curves, [])
    }

    /// Inserts general curves and points by one sweep: see [`Editor::insert_pieces`].
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// # Complexity
    /// As of [`Editor::insert_pieces`].
    pub fn insert_curves_and_points<'a>(
        &mut self,
        curves: impl IntoIterator<Item = &'a G::Curve>,
        points: impl IntoIterator<Item = G::Point>,
    ) -> Provenance
    where
        G::Curve: 'a,
    {
        let mut pieces = Pieces::of_curves(self.arrangement.traits(), curves);
        pieces.points.extend(points);
        self.insert_pieces(pieces)
    }
}

/// Keeps the items at some positions.
fn keep<X>(items: &mut Vec<X>, stays: impl Fn(usize) -> bool) {
    let mut position = 0;
    items.retain(|_| {
        position += 1;
        stays(position - 1)
    });
    items.shrink_to_fit();
}
