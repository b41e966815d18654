//! Insertion of many curves at once, by one sweep.

use crate::arrangement::build::Builder;
use crate::arrangement::{Arrangement, assemble::assemble};
use crate::overlay::{Provenance, overlay_with_pieces};
use crate::sweep::{Progress, SweepInput, Watched, sweep};
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, BasicTraits, CurveEnd, Piece, UMonotoneTraits};
use std::ops::ControlFlow;

/// u-monotone curves and points, to be inserted.
#[derive(Clone, Debug)]
pub struct Pieces<G: BasicTraits> {
    /// The curves.
    pub curves: Vec<G::UMonotoneCurve>,
    /// For each end of each curve, whether it is artificial.
    pub is_artificial: Vec<[bool; 2]>,
    /// The points.
    pub points: Vec<G::Point>,
}

impl<G: BasicTraits> Default for Pieces<G> {
    fn default() -> Self {
        Self { curves: Vec::new(), is_artificial: Vec::new(), points: Vec::new() }
    }
}

impl<G: ArrangementTraits> Pieces<G> {
    /// Cuts general curves into u-monotone ones.
    pub fn of_curves<'a>(traits: &G, curves: impl IntoIterator<Item = &'a G::Curve>) -> Self
    where
        G::Curve: 'a,
    {
        let mut pieces = Self::default();
        let mut buffer = Vec::new();
        for curve in curves {
            traits.make_u_monotone(curve, &mut buffer);
            for piece in buffer.drain(..) {
                match piece {
                    Piece::Curve { curve, is_artificial } => {
                        pieces.curves.push(curve);
                        pieces.is_artificial.push(is_artificial);
                    }
                    Piece::Point(point) => pieces.points.push(point),
                }
            }
        }
        pieces
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Makes the arrangement of u-monotone curves and points, by one sweep.
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
            let builder = Builder::new(&topology, &flags);
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
    /// That of [`sweep`], over old edges and new curves: for few curves, insertion one by one is quicker.
    pub fn insert_pieces(&mut self, pieces: Pieces<G>) -> Provenance {
        let (parts, provenance) = overlay_with_pieces(&self.traits, &self.topology, &[self], pieces);
        self.set_parts(parts);
        provenance
    }
}

impl<G: ArrangementTraits, T: Topology<G>> Arrangement<G, T> {
    /// Makes the arrangement of general curves, by one sweep.
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

    /// Inserts general curves, by one sweep over them and the edges that are there: see [`Arrangement::insert_pieces`].
    pub fn insert_curves<'a>(&mut self, curves: impl IntoIterator<Item = &'a G::Curve>) -> Provenance
    where
        G::Curve: 'a,
    {
        let pieces = Pieces::of_curves(&self.traits, curves);
        self.insert_pieces(pieces)
    }
}
