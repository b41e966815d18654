//! An arrangement of what was read, or what is wrong with it.

use super::around::Around;
use super::cells::Cells;
use super::course::piece_at;
use super::curves::{List, malformed};
use super::family::{Base, Family};
use super::model::StarArrangement;
use super::numbers::Numbers;
use crate::base::error::Located;
use arrangement::models::polycurve::PolycurveTraits;
use arrangement::traits::CurveEnd;
use arrangement::{Arrangement, Parts, Violation};
use dcel::{CcbKind, Dcel, DcelViolation, FaceId, HalfedgeId, VertexId};
use std::mem::{replace, take};

/// What to do with boundaries that do not go round a vertex.
const ROUND: &str = "let each go on there with the next edge clockwise";

const CONTRADICTION: &str = "the cells contradict the curves; correct the one or the other";

/// Puts curves, points and cells together. `end` is the line where the file ends.
pub(super) fn finish<B: Base>(
    base: B,
    curves: List<B::UMonotoneCurve>,
    numbers: &Numbers,
    points: Vec<Option<B::Point>>,
    cells: &mut Cells,
    end: u32,
) -> Result<StarArrangement, Located> {
    match curves {
        List::Single(curves) => {
            arrangement_of::<B, B>(base, curves, numbers, points, cells, end).map(B::of_single)
        }
        List::Chains(curves) => {
            let traits = PolycurveTraits::new(base);
            arrangement_of::<B, _>(traits, curves, numbers, points, cells, end).map(B::of_chains)
        }
    }
}

fn arrangement_of<B: Base, G: Family<B>>(
    traits: G,
    curves: Vec<G::UMonotoneCurve>,
    numbers: &Numbers,
    mut points: Vec<Option<B::Point>>,
    cells: &mut Cells,
    end: u32,
) -> Result<Arrangement<G, G::Surface>, Located> {
    define_points::<B, G>(traits.base(), &curves, &mut points, cells);
    let face_around = |cells: &Cells, v: VertexId| {
        let pieces = |edge: usize| G::pieces(&curves[cells.supports[edge] as usize]);
        traits.base().face_around(v, &Around { points: &points, cells, pieces: &pieces })
    };
    let raw = cells.raw_dcel(end, face_around)?;
    // An arrangement knows the poles.
    points[..cells.special.count()].fill(None);
    let parts = Parts {
        dcel: Dcel::from_parts(raw),
        points,
        is_artificial: take(&mut cells.is_artificial),
        curves,
        supports: cells.supports.clone(),
        // The text begins with it.
        corner_face: FaceId(0),
    };
    Arrangement::from_parts(traits, G::Surface::default(), parts).map_err(|violations| {
        let said = violations.first().map(|violation| sentence::<B>(violation, cells, numbers));
        let (line, why) = said.unwrap_or_else(|| (None, CONTRADICTION.into()));
        malformed(line.unwrap_or(end), why)
    })
}

/// Lets vertices be ends of curves or crossings of two, where they are: these have the degree that they had at first, and coordinates
/// have a higher one.
fn define_points<B: Base, G: Family<B>>(
    base: &B,
    curves: &[G::UMonotoneCurve],
    points: &mut [Option<B::Point>],
    cells: &Cells,
) {
    /// What is known of a vertex.
    enum Known<'a, L> {
        Nothing,
        Line(&'a L),
        Done,
    }
    let mut known: Vec<Known<'_, B::Line>> = points.iter().map(|_| Known::Nothing).collect();
    for (index, halfedge) in cells.halfedges.iter().enumerate() {
        let v = halfedge.source.index();
        let Some(point) = &mut points[v] else { continue };
        let end = if HalfedgeId::new(index).is_even() { CurveEnd::Min } else { CurveEnd::Max };
        let pieces = G::pieces(&curves[cells.supports[index / 2] as usize]);
        let (piece, is_end) = piece_at(base, pieces, point, end);
        let piece = &pieces[piece];
        let line = B::line(piece);
        // A joint of a chain is an end of pieces.
        let known_end = base.end_point(piece, end).filter(|&end| is_end || pieces.len() > 1 && end == point);
        if let Some(end) = known_end {
            *point = end.clone();
            known[v] = Known::Done;
            continue;
        }
        known[v] = match replace(&mut known[v], Known::Nothing) {
            Known::Nothing => Known::Line(line),
            Known::Line(other) if other != line => {
                if let Some(crossing) = B::crossing([other, line], point) {
                    *point = crossing;
                }
                Known::Done
            }
            same => same,
        };
    }
}

/// Says what is wrong in numbers of the file, and in which line; `None` if in none.
fn sentence<B: Base>(violation: &Violation, cells: &Cells, numbers: &Numbers) -> (Option<u32>, String) {
    let vertex = |v: VertexId| cells.vertex_name(v);
    let edge = |e: dcel::EdgeId| cells.edges.id(e.index());
    let edge_line = |e: dcel::EdgeId| Some(cells.edges.line(e.index()));
    let curve = |e: dcel::EdgeId| numbers.id(cells.supports[e.index()] as usize);
    let face = |f: dcel::FaceId| cells.faces.id(f.index());
    match *violation {
        Violation::OffSupport(v, e) if cells.vertex_line(v).is_none() => {
            (edge_line(e), format!("curve {} does not go to infinity at this end of the edge; name the vertex that is there", curve(e)))
        }
        Violation::OffSupport(v, e) => (
            edge_line(e),
            format!("{} is not on curve {}; move it there, or name another vertex or curve", vertex(v), curve(e)),
        ),
        Violation::EndOrder(e) => (
            edge_line(e),
            "the ends of the edge are equal or in the wrong order; write the lesser one first".into(),
        ),
        Violation::Rotation(v) => (
            cells.vertex_line(v),
            format!("the boundaries around {} contradict the order of its edges; {ROUND}", vertex(v)),
        ),
        Violation::Kind(c) => {
            let [is, other] = match cells.ccb_kind(c) {
                CcbKind::Outer => ["outer", "inner"],
                CcbKind::Inner => ["inner", "outer"],
            };
            (Some(cells.ccb_line(c)), format!("the boundary is no {is} one; write `{other}`"))
        }
        Violation::SamePoint(v, w) => {
            let later = v.max(w);
            let why = format!(
                "{} and {} are one point; remove one of them, and name the other one instead",
                vertex(v.min(w)),
                vertex(later)
            );
            (cells.vertex_line(later), why)
        }
        Violation::VertexOnEdge(v, e) => {
            (edge_line(e), format!("{} lies within the edge; cut the edge there", vertex(v)))
        }
        Violation::Crossing(d, e) => {
            let later = d.max(e);
            let why = format!(
                "the edge meets edge {} where no vertex is; add one there, and cut both edges",
                edge(d.min(e))
            );
            (edge_line(later), why)
        }
        Violation::Overlap(d, e) => {
            let later = d.max(e);
            let why = format!(
                "the edge and edge {} have a piece in common; write that once, as an edge of its own",
                edge(d.min(e))
            );
            (edge_line(later), why)
        }
        Violation::WrongFace(v, by_cells, found) => {
            let (by_cells, found) = (face(by_cells), face(found));
            let why = format!(
                "at {}, the boundaries say face {by_cells} where the curves say face {found}; write what is there \
                 behind `face {found}`",
                vertex(v)
            );
            (cells.vertex_line(v), why)
        }
        Violation::CornerFace(f) => {
            let why = format!("face {} is not the one {}; write that first", face(f), B::CORNER);
            (Some(cells.faces.line(f.index())), why)
        }
        Violation::Cells(DcelViolation::VertexCycle(v)) => {
            (cells.vertex_line(v), format!("the boundaries do not run round {} in one turn; {ROUND}", vertex(v)))
        }
        Violation::Cells(_) => (
            None,
            "faces and boundaries do not make up the surface; put together what bounds one face, and take apart \
             what bounds several"
                .into(),
        ),
        Violation::Unseen(v) => {
            (cells.vertex_line(v), format!("the edges of {} contradict the curves; correct its coordinates, or the ends of its edges", vertex(v)))
        }
        _ => (None, CONTRADICTION.into()),
    }
}
