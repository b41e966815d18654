//! Pieces put in a row, and cut into u-monotone chains.

use super::curve::{Numbered, PolycurveOf};
use super::{Chain, PieceTraits, Polycurve, PolycurveError, PolycurveTraits};
use crate::traits::{CurveEnd, Piece};

/// A piece of a polycurve.
struct Link<C> {
    curve: C,
    is_right: bool,
    is_vertical: bool,
    /// For both ends, the `Min` one first, whether the model had to cut there.
    is_artificial: [bool; 2],
}

impl<C> Link<C> {
    /// The end at which the polycurve comes to the piece.
    fn entry(&self) -> CurveEnd {
        if self.is_right { CurveEnd::Min } else { CurveEnd::Max }
    }

    /// The end at which it leaves the piece.
    fn exit(&self) -> CurveEnd {
        self.entry().opposite()
    }

    fn is_artificial(&self, end: CurveEnd) -> bool {
        self.is_artificial[end as usize]
    }
}

/// What a polycurve does between two pieces.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Joint {
    /// It goes on, in one chain.
    Smooth,
    /// It has to be cut.
    Cut,
    /// It returns upon itself: an end of its own.
    Tip,
}

impl<S: PieceTraits> PolycurveTraits<S> {
    /// Puts pieces in a row, and cuts the row into chains.
    pub(super) fn assemble(&self, pieces: Numbered<S>) -> Result<PolycurveOf<S>, PolycurveError> {
        let is_point = |piece: &(usize, Piece<_, _>)| matches!(piece.1, Piece::Point(_));
        if pieces.iter().all(is_point) {
            return self.assemble_points(pieces);
        }
        let is_first_right = self.first_direction(&pieces);
        let directions = match self.orient(&pieces, is_first_right) {
            Ok(directions) => directions,
            Err(first) => self
                .orient(&pieces, !is_first_right)
                .map_err(|second| PolycurveError::NotConnected { curve: first.max(second) })?,
        };
        let is_one_curve = pieces.iter().all(|(number, _)| *number == pieces[0].0);
        let mut directions = directions.into_iter();
        let links: Vec<_> = pieces
            .into_iter()
            .filter_map(|(_, piece)| match piece {
                Piece::Point(_) => None,
                Piece::Curve { curve, is_artificial } => {
                    let is_right = directions.next().expect("every piece has got a direction");
                    let is_vertical = self.pieces.is_vertical(&curve);
                    Some(Link { curve, is_right, is_vertical, is_artificial })
                }
            })
            .collect();
        Ok(self.cut(links, is_one_curve))
    }

    /// Whether the first piece is expected to run to the right.
    fn first_direction(&self, pieces: &Numbered<S>) -> bool {
        let mut curves = pieces.iter().filter_map(|(_, piece)| match piece {
            Piece::Curve { curve, .. } => Some(curve),
            Piece::Point(_) => None,
        });
        curves.next().and_then(|curve| self.pieces.direction(curve)).unwrap_or(true)
    }

    /// Curves all of which are points: one point.
    fn assemble_points(&self, pieces: Numbered<S>) -> Result<PolycurveOf<S>, PolycurveError> {
        let mut points = pieces.into_iter().filter_map(|(number, piece)| match piece {
            Piece::Point(point) => Some((number, point)),
            Piece::Curve { .. } => None,
        });
        let (_, first) = points.next().ok_or(PolycurveError::Empty)?;
        match points.find(|(_, point)| !self.pieces.is_same_point(&first, point)) {
            Some((curve, _)) => Err(PolycurveError::NotConnected { curve }),
            None => Ok(Polycurve::new(vec![Piece::Point(first)], false)),
        }
    }

    /// Finds for each piece whether the polycurve runs through it to the right, if it does so in the first one. Points are left
    /// out. The error is the number of the first curve that is not connected.
    fn orient(&self, pieces: &Numbered<S>, is_first_right: bool) -> Result<Vec<bool>, usize> {
        let mut directions = Vec::with_capacity(pieces.len());
        // Where the polycurve is, once it has begun.
        let mut at: Option<Option<&S::Point>> = None;
        for (number, piece) in pieces {
            let is_here = |p: Option<&S::Point>| match (at, p) {
                (None, _) => true,
                (Some(Some(at)), Some(p)) => self.pieces.is_same_point(at, p),
                (Some(_), _) => false,
            };
            match piece {
                Piece::Point(p) if is_here(Some(p)) => at = Some(Some(p)),
                Piece::Point(_) => return Err(*number),
                Piece::Curve { curve, .. } => {
                    let [min, max] = CurveEnd::BOTH.map(|end| self.pieces.end_point(curve, end));
                    let is_right = match directions.is_empty() {
                        true => is_first_right,
                        // A curve from a point back to it does not tell by its ends.
                        false if is_here(min) && is_here(max) => self.pieces.direction(curve).unwrap_or(true),
                        false => is_here(min),
                    };
                    let (from, to) = if is_right { (min, max) } else { (max, min) };
                    if !is_here(from) {
                        return Err(*number);
                    }
                    directions.push(is_right);
                    at = Some(to);
                }
            }
        }
        Ok(directions)
    }

    fn cut(&self, mut links: Vec<Link<S::UMonotoneCurve>>, is_one_curve: bool) -> PolycurveOf<S> {
        let (first, last) = (&links[0], &links[links.len() - 1]);
        let start = self.pieces.end_point(&first.curve, first.entry());
        let end = self.pieces.end_point(&last.curve, last.exit());
        let is_closed = start.zip(end).is_some_and(|(p, q)| self.pieces.is_same_point(p, q));
        // Where a closed polycurve was begun does not show, if it is cut elsewhere.
        if is_closed && !is_one_curve && self.joint(last, first) == Joint::Smooth {
            let is_cut = |i: &usize| self.joint(&links[i - 1], &links[*i]) != Joint::Smooth;
            let begin = (1..links.len()).find(is_cut).unwrap_or(0);
            links.rotate_left(begin);
        }
        let (first, last) = (&links[0], &links[links.len() - 1]);
        // Else its start is cut, whatever it does there. Of one curve, only the model knows.
        let [at_start, at_end] = match is_closed && !is_one_curve {
            true => [self.joint(last, first) != Joint::Tip; 2],
            false => [first.is_artificial(first.entry()), last.is_artificial(last.exit())],
        };
        let mut parts = Vec::new();
        let mut run: Vec<Link<S::UMonotoneCurve>> = Vec::new();
        let mut is_source_artificial = at_start;
        for link in links {
            let joint = run.last().map_or(Joint::Smooth, |previous| self.joint(previous, &link));
            if joint != Joint::Smooth {
                let is_cut = joint == Joint::Cut;
                parts.push(chain(&mut run, [is_source_artificial, is_cut]));
                is_source_artificial = is_cut;
            }
            run.push(link);
        }
        parts.push(chain(&mut run, [is_source_artificial, at_end]));
        Polycurve::new(parts, is_closed)
    }

    fn joint(&self, before: &Link<S::UMonotoneCurve>, after: &Link<S::UMonotoneCurve>) -> Joint {
        let (a, b) = (&before.curve, &after.curve);
        let end = before.exit();
        let Some(p) = self.pieces.end_point(a, end) else { return Joint::Cut };
        if !self.pieces.is_joint_allowed(p) {
            let is_tip = before.is_right != after.is_right && self.pieces.is_foldback_on_side(a, b, end);
            return if is_tip { Joint::Tip } else { Joint::Cut };
        }
        if before.is_vertical != after.is_vertical {
            return Joint::Cut;
        }
        if before.is_right == after.is_right {
            let is_cut = before.is_artificial(end) || after.is_artificial(after.entry());
            return if is_cut { Joint::Cut } else { Joint::Smooth };
        }
        // Vertical curves that end together overlap.
        let is_tip = before.is_vertical
            || match end {
                CurveEnd::Min => self.pieces.compare_v_at_u_right(a, b, p).is_eq(),
                CurveEnd::Max => self.pieces.compare_v_at_u_left(a, b, p).is_eq(),
            };
        if is_tip { Joint::Tip } else { Joint::Cut }
    }
}

/// Makes a chain of pieces that follow each other, and leaves none. The flags are those of the source and of the target.
fn chain<P, C>(run: &mut Vec<Link<C>>, [at_source, at_target]: [bool; 2]) -> Piece<P, Chain<C>> {
    let is_right = run[0].is_right;
    if !is_right {
        run.reverse();
    }
    let pieces: Vec<C> = run.drain(..).map(|link| link.curve).collect();
    let is_artificial = if is_right { [at_source, at_target] } else { [at_target, at_source] };
    Piece::Curve { curve: Chain::new(pieces, is_right), is_artificial }
}
