//! Straight paths around the strip, cut where they cross the seam.

use crate::strip::{Band, Piece as StripPiece, Strip};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::models::Segment;
use splitstar_arrangement::traits::{ArrangementTraits, Piece, SideKind};
use splitstar_arrangement::{Arrangement, Counts};

pub(crate) type Made<const MEET_ONCE: bool> = Arrangement<Strip<MEET_ONCE>, Band>;

/// A curve in the universal cover of the strip, where u is any number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Curve {
    /// From a point to another one; if they are equal, a point.
    Path([[i64; 2]; 2]),
    /// Once around, at a height.
    Parallel(i64),
}

impl Curve {
    pub(crate) fn moved(self, by: i64) -> Self {
        match self {
            Self::Path(ends) => Self::Path(ends.map(|[u, v]| [u + by, v])),
            parallel @ Self::Parallel(_) => parallel,
        }
    }

    pub(crate) fn mirrored(self) -> Self {
        match self {
            Self::Path(ends) => Self::Path(ends.map(|[u, v]| [-u, v])),
            parallel @ Self::Parallel(_) => parallel,
        }
    }

    pub(crate) fn swapped(self) -> Self {
        match self {
            Self::Path([p, q]) => Self::Path([q, p]),
            parallel @ Self::Parallel(_) => parallel,
        }
    }
}

impl<const MEET_ONCE: bool> ArrangementTraits for Strip<MEET_ONCE> {
    type Curve = Curve;

    fn make_u_monotone(&self, curve: &Curve, out: &mut Vec<Piece<Point2, StripPiece>>) {
        let width = self.size[0];
        let ([mut p, mut q], is_closed) = match *curve {
            Curve::Path(ends) => (ends, false),
            Curve::Parallel(v) => ([[0, v], [width, v]], true),
        };
        let home = |[u, v]: [i64; 2]| [u.rem_euclid(width), v];
        if p == q {
            return out.push(Piece::Point(Point2::from_i64(home(p))));
        }
        if p[0] == q[0] {
            let segment = Segment::from_i64([home(p), home(q)]).unwrap();
            return out.push(Piece::Curve { curve: self.piece(segment), is_artificial: [false; 2] });
        }
        if p[0] > q[0] {
            (p, q) = (q, p);
        }
        let [du, dv] = [q[0] - p[0], q[1] - p[1]];
        let mut sheet = p[0].div_euclid(width);
        loop {
            let [from, to] = [p[0].max(sheet * width), q[0].min((sheet + 1) * width)];
            let at = |u: i64| {
                let rise = Rational::from(dv * (u - p[0])).checked_div(&Rational::from(du)).unwrap();
                Point2::from_rationals(&[Rational::from(u - sheet * width), Rational::from(p[1]) + rise])
            };
            let segment = Segment::new(at(from), at(to)).unwrap();
            let is_artificial = [is_closed || from > p[0], is_closed || to < q[0]];
            out.push(Piece::Curve { curve: self.piece(segment), is_artificial });
            if to == q[0] {
                return;
            }
            sheet += 1;
        }
    }
}

pub(crate) fn make<const MEET_ONCE: bool>(
    size: [i64; 2],
    v: [SideKind; 2],
    curves: &[Curve],
) -> Made<MEET_ONCE> {
    Arrangement::of_curves(Strip { size, v }, Band(v), curves)
}

pub(crate) fn cells(counts: &Counts) -> [usize; 3] {
    [counts.vertices, counts.edges, counts.faces]
}
