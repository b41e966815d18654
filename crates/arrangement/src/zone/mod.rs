//! The zone of a curve: the cells that it meets, in their order along it. The arrangement stays as it is.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the operations |
//! | `visitor` | who is told what a curve meets |
//! | `course` | a u-monotone curve from its first to its last cell |
//! | `next` | what a curve does next, from a place on it |
//! | `walk` | a curve through the trapezoids of a face, up to the first thing that it meets |
//! | `cells` | visitors: all cells, and whether there are any but faces |
//!
//! The insertion of a curve goes the same way by `next` and `walk`, and changes cells as it goes.
//!
//! # References
//! Thesis, section 2.4.3; de Berg, Cheong, van Kreveld and Overmars, Computational Geometry, section 8.3.

mod cells;
mod course;
mod next;
mod visitor;
mod walk;

pub use cells::{MeetingFinder, ZoneCells};
pub use visitor::{Passage, ZonePlace, ZoneVisitor};

pub(crate) use next::{Next, On, next, side_vertex};
pub(crate) use walk::{Hit, Walk};

use crate::edit::Observer;
use crate::editor::Editor;
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, Piece, UMonotoneTraits};
use course::Course;
use std::ops::ControlFlow;

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Goes along a u-monotone curve from its min to its max end, and tells a visitor what it meets; gives `Break` if the visitor
    /// stopped.
    ///
    /// Nothing changes. What the visitor is told, and when, [`ZoneVisitor`] says.
    ///
    /// # Complexity
    /// For each vertex and edge that is met, a search: expected O(log n) if edges came in random order, as after [`Editor::new`]. For each
    /// trapezoid on the way, a constant number of predicates. Nothing is done for what is behind the place where the visitor stops.
    ///
    /// There are as many trapezoids on the way as walls, which go straight up and down from each vertex to the next edge. In a face with h
    /// holes these are O(h) at worst, if the holes are so small that most walls pass by them. But holes stop walls: of 100
    /// long segments, which meet 41 vertices and edges each among 10,000 segments with steps of 15 bits in a square of 20 bits, one
    /// takes 2,401 predicates, and 88 to tell that it meets anything. With steps of 12 bits it takes 5,479 (meets 5); with steps of 8
    /// bits, which are almost points, 18,221 (meets none or one).
    ///
    /// # References
    /// Thesis, section 2.4.3.
    ///
    /// # Examples
    /// Stops at the first edge that is crossed:
    ///
    /// ```
    /// use dcel::EdgeId;
    /// use splitstar_arrangement::models::{Segment, SegmentTraits};
    /// use splitstar_arrangement::zone::{Passage, ZonePlace, ZoneVisitor};
    /// use splitstar_arrangement::{Arrangement, Editor, topology::BoundedPlane};
    /// use std::cmp::Ordering;
    /// use std::ops::ControlFlow;
    ///
    /// #[derive(Default)]
    /// struct FirstCrossing(Option<String>);
    ///
    /// impl ZoneVisitor<SegmentTraits> for FirstCrossing {
    ///     fn edge(
    ///         &mut self,
    ///         _: EdgeId,
    ///         place: &ZonePlace<'_, SegmentTraits>,
    ///         passage: Passage<Ordering>,
    ///     ) -> ControlFlow<()> {
    ///         if !passage.is_crossing() {
    ///             return ControlFlow::Continue(());
    ///         }
    ///         self.0 = place.site.point().map(ToString::to_string);
    ///         ControlFlow::Break(())
    ///     }
    /// }
    ///
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let posts = [1, 2, 3].map(|x| segment([[x, 0], [x, 5]]));
    /// let editor = Editor::new(Arrangement::of_curves(SegmentTraits, BoundedPlane, &posts));
    /// let mut first = FirstCrossing::default();
    /// // It begins on the first post.
    /// assert!(editor.zone(&segment([[1, 1], [5, 3]]), &mut first).is_break());
    /// assert_eq!(first.0.as_deref(), Some("(2, 3/2)"));
    /// ```
    pub fn zone<V: ZoneVisitor<G> + ?Sized>(
        &self,
        curve: &G::UMonotoneCurve,
        visitor: &mut V,
    ) -> ControlFlow<()> {
        Course::new(self.arrangement(), self.trapezoids(), curve).run(visitor)
    }

    /// Tells a visitor in which cell a point lies, as if it were a curve that begins and ends there at once.
    ///
    /// # Preconditions
    /// Those of [`Editor`] on points.
    ///
    /// # Complexity
    /// That of [`Editor::locate`].
    pub fn zone_of_point<V: ZoneVisitor<G> + ?Sized>(
        &self,
        point: &G::Point,
        visitor: &mut V,
    ) -> ControlFlow<()> {
        let site = crate::topology::Site::of_point(
            self.arrangement().topology(),
            self.arrangement().traits(),
            point,
        );
        let place = ZonePlace { site, cell: self.locate(point) };
        visitor.begins(&place)?;
        match place.cell {
            Cell::Vertex(v) => visitor.vertex(v, &place, Passage::NONE)?,
            Cell::Edge(e) => visitor.edge(e, &place, Passage::NONE)?,
            Cell::Face(_) => {}
        }
        visitor.ends(&place)
    }

    /// The cells that a u-monotone curve meets, in their order along it: see [`ZoneCells`].
    ///
    /// # Complexity
    /// That of [`Editor::zone`].
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::models::{Segment, SegmentTraits};
    /// use splitstar_arrangement::overlay::Cell;
    /// use splitstar_arrangement::{Arrangement, Editor, topology::BoundedPlane};
    ///
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let square = [[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[0, 4], [4, 4]], [[0, 0], [0, 4]]].map(segment);
    /// let editor = Editor::new(Arrangement::of_curves(SegmentTraits, BoundedPlane, &square));
    /// // In through a side, and out through a corner.
    /// let cells = editor.zone_cells(&segment([[-2, 1], [6, 5]]));
    /// let [Cell::Face(outside), Cell::Edge(_), Cell::Face(inside), Cell::Vertex(corner), Cell::Face(f)] = cells[..] else {
    ///     panic!("{cells:?}")
    /// };
    /// assert!(f == outside && f != inside);
    /// assert_eq!(editor.point(corner).map(ToString::to_string).as_deref(), Some("(4, 4)"));
    /// ```
    pub fn zone_cells(&self, curve: &G::UMonotoneCurve) -> Vec<Cell> {
        let mut cells = ZoneCells::default();
        let _ = self.zone(curve, &mut cells);
        cells.into_cells()
    }
}

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Tells a visitor what a general curve meets: the zones of its u-monotone pieces, one after the other in their order along the
    /// curve, each from its min to its max end; and those of its isolated points.
    ///
    /// # Complexity
    /// That of [`Editor::zone`] for each piece.
    pub fn zone_of<V: ZoneVisitor<G> + ?Sized>(&self, curve: &G::Curve, visitor: &mut V) -> ControlFlow<()> {
        let mut pieces = Vec::new();
        self.arrangement().traits().make_u_monotone(curve, &mut pieces);
        pieces.iter().try_for_each(|piece| match piece {
            Piece::Curve { curve, .. } => self.zone(curve, visitor),
            Piece::Point(point) => self.zone_of_point(point, visitor),
        })
    }

    /// The cells that a general curve meets: those of its u-monotone pieces, one piece after the other.
    ///
    /// # Complexity
    /// That of [`Editor::zone`] for each piece.
    pub fn zone_cells_of(&self, curve: &G::Curve) -> Vec<Cell> {
        let mut cells = ZoneCells::default();
        let _ = self.zone_of(curve, &mut cells);
        cells.into_cells()
    }

    /// Tells whether a curve meets any vertex or edge, with its ends or between them.
    ///
    /// That unbounded curves meet at infinity does not count. On a contracted side it does.
    ///
    /// # Complexity
    /// That of [`Editor::zone`] up to the first meeting.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::models::{Segment, SegmentTraits};
    /// use splitstar_arrangement::{Arrangement, Editor, topology::BoundedPlane};
    ///
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let post = [segment([[1, 0], [1, 5]])];
    /// let editor = Editor::new(Arrangement::of_curves(SegmentTraits, BoundedPlane, &post));
    /// assert!(!editor.meets_anything(&segment([[2, 2], [4, 3]])));
    /// let from_post = segment([[1, 2], [4, 3]]);
    /// assert!(editor.meets_anything(&from_post) && !editor.interior_meets_anything(&from_post));
    /// ```
    pub fn meets_anything(&self, curve: &G::Curve) -> bool {
        self.zone_of(curve, &mut MeetingFinder::new()).is_break()
    }

    /// Tells whether a curve without its ends meets any vertex or edge. If not, it can be inserted as one edge in one face, up to the
    /// places where its traits cut it.
    ///
    /// Where a curve is cut into pieces only because of the parameter space, it does not end. Isolated points of a curve count as
    /// ends, and so does a place where it turns back along itself.
    ///
    /// # Complexity
    /// That of [`Editor::zone`] up to the first meeting.
    pub fn interior_meets_anything(&self, curve: &G::Curve) -> bool {
        let mut pieces = Vec::new();
        self.arrangement().traits().make_u_monotone(curve, &mut pieces);
        pieces.iter().any(|piece| match piece {
            Piece::Curve { curve, is_artificial } => {
                self.zone(curve, &mut MeetingFinder::with_ends(*is_artificial)).is_break()
            }
            Piece::Point(_) => false,
        })
    }
}
