//! Insertion of many curves at once, by one sweep.

#[cfg(test)]
mod tests;

use crate::arrangement::build::Builder;
use crate::arrangement::{Arrangement, assemble::assemble};
use crate::overlay::{Provenance, overlay_with_pieces};
use crate::sweep::{Progress, SweepInput, Watched, sweep};
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, BasicTraits, CurveEnd, Piece, UMonotoneTraits};
use std::ops::ControlFlow;

/// u-monotone curves and points, to be inserted.
///
/// Each end of a curve is a vertex, or *artificial*: a place where a longer curve was only cut.
///
/// # Preconditions
/// Where sides of the parameter space are identified, points have the coordinates by which the traits know them: on a torus, those
/// that [`TorusSegmentTraits::point`] gives, at least zero and below the periods. Curves are made by the traits of the arrangement, or
/// by equal ones. With other ones the result is not valid; [`BasicTraits::is_canonical`] and [`BasicTraits::is_own_curve`] tell. Debug
/// builds ask them on insertion, and panic.
///
/// # Examples
///
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::{Arrangement, Pieces, models::{Segment, SegmentTraits}, topology::BoundedPlane};
///
/// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
/// let mut pieces = Pieces::<SegmentTraits>::new();
/// // The segment from (0, 0) to (4, 0), cut at (2, 0), where no vertex is wanted.
/// pieces.push_piece(segment([[0, 0], [2, 0]]), [false, true]);
/// pieces.push_piece(segment([[2, 0], [4, 0]]), [true, false]);
/// pieces.push_curve(segment([[0, 1], [4, 1]]));
/// pieces.push_point(Point2::from_i64([1, 3]));
/// let counts = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces).counts();
/// assert_eq!((counts.vertices, counts.edges, counts.isolated), (5, 2, 1));
/// ```
///
/// [`TorusSegmentTraits::point`]: crate::models::TorusSegmentTraits::point
#[derive(Clone, Debug)]
pub struct Pieces<G: BasicTraits> {
    pub(crate) curves: Vec<G::UMonotoneCurve>,
    /// For each end of each curve, whether it is artificial: as many as there are curves.
    pub(crate) is_artificial: Vec<[bool; 2]>,
    pub(crate) points: Vec<G::Point>,
}

impl<G: BasicTraits> Default for Pieces<G> {
    fn default() -> Self {
        Self { curves: Vec::new(), is_artificial: Vec::new(), points: Vec::new() }
    }
}

impl<G: BasicTraits> Pieces<G> {
    /// Makes what has no curve and no point.
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes room for so many more curves.
    pub fn reserve(&mut self, curves: usize) {
        self.curves.reserve(curves);
        self.is_artificial.reserve(curves);
    }

    /// Takes the curves and the points out.
    pub fn into_parts(self) -> (Vec<G::UMonotoneCurve>, Vec<G::Point>) {
        (self.curves, self.points)
    }

    /// Appends a curve of which both ends are vertices.
    pub fn push_curve(&mut self, curve: G::UMonotoneCurve) {
        self.push_piece(curve, [false; 2]);
    }

    /// Appends a curve, and tells of its `Min` and of its `Max` end whether it is artificial.
    pub fn push_piece(&mut self, curve: G::UMonotoneCurve, is_artificial: [bool; 2]) {
        self.curves.push(curve);
        self.is_artificial.push(is_artificial);
    }

    /// Appends a point. Where it lies on no curve, it becomes an isolated vertex.
    pub fn push_point(&mut self, point: G::Point) {
        self.points.push(point);
    }

    /// The curves, in the order in which they came.
    pub fn curves(&self) -> &[G::UMonotoneCurve] {
        &self.curves
    }

    /// For each curve, which of its ends, `Min` and `Max`, are artificial.
    pub fn is_artificial(&self) -> &[[bool; 2]] {
        &self.is_artificial
    }

    /// The points, in the order in which they came.
    pub fn points(&self) -> &[G::Point] {
        &self.points
    }
}

/// Appends what [`ArrangementTraits::make_u_monotone`] gives.
impl<G: BasicTraits> Extend<Piece<G::Point, G::UMonotoneCurve>> for Pieces<G> {
    fn extend<I: IntoIterator<Item = Piece<G::Point, G::UMonotoneCurve>>>(&mut self, pieces: I) {
        for piece in pieces {
            match piece {
                Piece::Curve { curve, is_artificial } => self.push_piece(curve, is_artificial),
                Piece::Point(point) => self.push_point(point),
            }
        }
    }
}

impl<G: ArrangementTraits> Pieces<G> {
    /// Cuts general curves into u-monotone ones.
    pub fn of_curves<'a>(traits: &G, curves: impl IntoIterator<Item = &'a G::Curve>) -> Self
    where
        G::Curve: 'a,
    {
        let mut pieces = Self::new();
        let mut buffer = Vec::new();
        for curve in curves {
            traits.make_u_monotone(curve, &mut buffer);
            pieces.extend(buffer.drain(..));
        }
        pieces
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Makes the arrangement of u-monotone curves and points, by one sweep.
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points; and the curves are of these traits.
    ///
    /// # Complexity
    /// That of [`sweep`].
    pub fn of_pieces(traits: G, topology: T, pieces: Pieces<G>) -> Self {
        Self::of_pieces_with(traits, topology, pieces, |_| ControlFlow::Continue(()))
            .expect("nobody stops the sweep")
    }

    /// Makes the arrangement of u-monotone curves and points, by one sweep; now and then `watch` is told how far the sweep has come,
    /// and may stop it. Then there is no arrangement.
    ///
    /// # Complexity
    /// That of [`sweep`]. `watch` is called once in about a thousand events.
    pub fn of_pieces_with(
        traits: G,
        topology: T,
        pieces: Pieces<G>,
        watch: impl FnMut(Progress) -> ControlFlow<()>,
    ) -> Option<Self> {
        let Pieces { curves, is_artificial, points } = pieces;
        let built = {
            let input = SweepInput::of_curves(&traits, &topology, &curves, &points);
            // The sites of the ends, those of the points, and images of these on other sides, which decide nothing.
            let ends = CurveEnd::BOTH
                .into_iter()
                .flat_map(|end| is_artificial.iter().map(move |is| is[end as usize]));
            let mut flags: Vec<bool> = ends.chain(points.iter().map(|_| false)).collect();
            flags.resize(input.site_count(), true);
            let builder = Builder::new(&traits, &topology, &flags);
            let mut watched = Watched::new(builder, input.site_count(), watch);
            if sweep(&traits, &topology, &input, &mut watched).is_break() {
                return None;
            }
            watched.into_inner().finish(&topology)
        };
        let parts = assemble(&traits, &topology, built, curves, |curve| curve);
        Some(Self::of_valid_parts(traits, topology, parts))
    }

    /// Inserts u-monotone curves and points, by one sweep over them and the edges that are there.
    ///
    /// All cells get new ids. The answer tells for every new cell in which old one it lies: its only operand is the arrangement as
    /// it was. A new edge that does not lie on an old one lies in an old face.
    ///
    /// # Complexity
    /// That of [`sweep`], over old edges and new curves: so insert many curves at once.
    pub fn insert_pieces(&mut self, pieces: Pieces<G>) -> Provenance {
        self.insert_pieces_with(pieces, |_| ControlFlow::Continue(())).expect("nobody stops the sweep")
    }

    /// Inserts u-monotone curves and points, by one sweep over them and the edges that are there; now and then `watch` is told how far
    /// the sweep has come, and may stop it. Then nothing is inserted, and the arrangement stays as it is, ids included.
    ///
    /// # Complexity
    /// That of [`Arrangement::insert_pieces`]. `watch` is called once in about a thousand events.
    ///
    /// ```
    /// use splitstar_arrangement::{Arrangement, Pieces, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// use std::ops::ControlFlow;
    /// let segments = |u: i64| (0..2000).map(move |v| Segment::from_i64([[u, v], [u + 1, v]]).expect("the ends are different"));
    /// let pieces = |u| {
    ///     let mut pieces = Pieces::<SegmentTraits>::new();
    ///     segments(u).for_each(|segment| pieces.push_curve(segment));
    ///     pieces
    /// };
    /// let mut arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces(0));
    /// let stopped = arrangement.insert_pieces_with(pieces(5), |progress| {
    ///     assert_eq!(progress.sites, 8000);
    ///     if progress.sites_met > progress.sites / 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    /// });
    /// assert!(stopped.is_none());
    /// assert_eq!(arrangement.counts().edges, 2000);
    /// ```
    pub fn insert_pieces_with(
        &mut self,
        pieces: Pieces<G>,
        watch: impl FnMut(Progress) -> ControlFlow<()>,
    ) -> Option<Provenance> {
        let (parts, provenance) = overlay_with_pieces(&self.traits, &self.topology, &[self], pieces, watch)?;
        self.set_parts(parts);
        Some(provenance)
    }

    /// Inserts points, by one sweep over them and the edges that are there: see [`Arrangement::insert_pieces`].
    ///
    /// Degenerate: a point on an edge divides it, one at a vertex changes nothing, but an artificial vertex becomes an ordinary one.
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::overlay::Cell;
    /// use splitstar_arrangement::{Arrangement, models::SegmentTraits, topology::BoundedPlane};
    /// let mut arrangement = Arrangement::new(SegmentTraits, BoundedPlane);
    /// let plane = arrangement.corner_face();
    /// let provenance = arrangement.insert_points([[0, 0], [1, 2]].map(Point2::from_i64));
    /// assert_eq!(arrangement.counts().isolated, 2);
    /// assert!(arrangement.vertices().all(|v| provenance.of_vertex(v) == [Cell::Face(plane)]));
    /// ```
    pub fn insert_points(&mut self, points: impl IntoIterator<Item = G::Point>) -> Provenance {
        self.insert_pieces(Pieces { points: points.into_iter().collect(), ..Pieces::new() })
    }
}

impl<G: ArrangementTraits, T: Topology<G>> Arrangement<G, T> {
    /// Makes the arrangement of general curves, by one sweep. With points besides: [`Arrangement::of_curves_and_points`].
    ///
    /// # Complexity
    /// That of [`sweep`].
    ///
    /// # References
    /// Thesis, section 2.4.1.
    pub fn of_curves<'a>(traits: G, topology: T, curves: impl IntoIterator<Item = &'a G::Curve>) -> Self
    where
        G::Curve: 'a,
    {
        let pieces = Pieces::of_curves(&traits, curves);
        Self::of_pieces(traits, topology, pieces)
    }

    /// Makes the arrangement of general curves and points, by one sweep. Points on no curve become isolated vertices.
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// # Complexity
    /// That of [`sweep`].
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::{Arrangement, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = Segment::from_i64([[0, 0], [2, 0]]).expect("the ends are different");
    /// let points = [[1, 0], [1, 1]].map(Point2::from_i64);
    /// let arrangement = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, [&segment], points);
    /// let counts = arrangement.counts();
    /// assert_eq!((counts.vertices, counts.edges, counts.isolated), (4, 2, 1));
    /// ```
    pub fn of_curves_and_points<'a>(
        traits: G,
        topology: T,
        curves: impl IntoIterator<Item = &'a G::Curve>,
        points: impl IntoIterator<Item = G::Point>,
    ) -> Self
    where
        G::Curve: 'a,
    {
        let mut pieces = Pieces::of_curves(&traits, curves);
        pieces.points.extend(points);
        Self::of_pieces(traits, topology, pieces)
    }

    /// Inserts general curves, by one sweep over them and the edges that are there: see [`Arrangement::insert_pieces`].
    ///
    /// # Complexity
    /// As of [`Arrangement::insert_pieces`].
    pub fn insert_curves<'a>(&mut self, curves: impl IntoIterator<Item = &'a G::Curve>) -> Provenance
    where
        G::Curve: 'a,
    {
        self.insert_curves_and_points(curves, [])
    }

    /// Inserts general curves and points, by one sweep over them and the edges that are there: see [`Arrangement::insert_pieces`].
    ///
    /// # Preconditions
    /// Those of [`Pieces`] on points.
    ///
    /// # Complexity
    /// As of [`Arrangement::insert_pieces`].
    pub fn insert_curves_and_points<'a>(
        &mut self,
        curves: impl IntoIterator<Item = &'a G::Curve>,
        points: impl IntoIterator<Item = G::Point>,
    ) -> Provenance
    where
        G::Curve: 'a,
    {
        let mut pieces = Pieces::of_curves(&self.traits, curves);
        pieces.points.extend(points);
        self.insert_pieces(pieces)
    }
}
