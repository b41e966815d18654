//! An arrangement of what was read, or what is wrong with it.

use super::cells::Cells;
use super::course::piece_beside;
use super::curves::{Curves, List, malformed};
use super::family::{Family, Straight};
use super::model::StarArrangement;
use super::numbers::Numbers;
use crate::base::error::Located;
use arrangement::models::LinearTraits;
use arrangement::models::polycurve::PolycurveTraits;
use arrangement::topology::{FlatTorus, UnboundedPlane};
use arrangement::traits::CurveEnd;
use arrangement::{Arrangement, Parts, Violation};
use dcel::{CcbKind, Dcel, DcelViolation, FaceId, VertexId};
use exact::planar::{Line2, Point2};
use std::mem::take;

/// Puts curves and cells together. `end` is the line where the file ends.
pub(super) fn finish(
    curves: Curves,
    numbers: &Numbers,
    cells: &mut Cells,
    end: u32,
) -> Result<StarArrangement, Located> {
    match curves {
        Curves::Plane(List::Single(curves)) => {
            arrangement_of(LinearTraits, UnboundedPlane, curves, numbers, cells, end)
                .map(StarArrangement::Linear)
        }
        Curves::Plane(List::Chains(curves)) => {
            let traits = PolycurveTraits::new(LinearTraits);
            arrangement_of(traits, UnboundedPlane, curves, numbers, cells, end)
                .map(StarArrangement::Polycurves)
        }
        Curves::Torus(traits, List::Single(curves)) => {
            arrangement_of(traits, FlatTorus, curves, numbers, cells, end).map(StarArrangement::Torus)
        }
        Curves::Torus(traits, List::Chains(curves)) => {
            let traits = PolycurveTraits::new(traits);
            arrangement_of(traits, FlatTorus, curves, numbers, cells, end)
                .map(StarArrangement::TorusPolycurves)
        }
    }
}

fn arrangement_of<G: Family>(
    traits: G,
    topology: G::Surface,
    curves: Vec<G::UMonotoneCurve>,
    numbers: &Numbers,
    cells: &mut Cells,
    end: u32,
) -> Result<Arrangement<G, G::Surface>, Located> {
    define_points::<G>(&curves, cells);
    let raw = cells.raw_dcel(end)?;
    let parts = Parts {
        dcel: Dcel::from_parts(raw),
        points: take(&mut cells.points),
        is_artificial: take(&mut cells.is_artificial),
        curves,
        supports: cells.supports.clone(),
        // The text begins with it.
        corner_face: FaceId(0),
    };
    Arrangement::from_parts(traits, topology, parts).map_err(|violations| {
        let said = violations.first().map(|violation| sentence(violation, cells, numbers));
        let (line, why) = said.unwrap_or_else(|| (None, "the cells contradict the curves".into()));
        malformed(line.unwrap_or(end), why)
    })
}

/// Lets vertices be ends of curves or crossings of two, where they are: these have the degree that they had at first, and coordinates
/// have a higher one.
fn define_points<G: Family>(curves: &[G::UMonotoneCurve], cells: &mut Cells) {
    /// What is known of a vertex.
    #[derive(Clone, Copy)]
    enum Known<'a> {
        Nothing,
        Line(&'a Line2),
        Done,
    }
    let mut known = vec![Known::Nothing; cells.points.len()];
    for (index, halfedge) in cells.halfedges.iter().enumerate() {
        let v = halfedge.source.index();
        let Some(point) = &mut cells.points[v] else { continue };
        let pieces = G::pieces(&curves[cells.supports[index / 2] as usize]);
        let piece = &pieces[piece_beside(pieces, point, CurveEnd::Max)];
        let line = piece.line();
        let mut ends = CurveEnd::BOTH.into_iter().filter_map(|end| piece.point(end));
        if let Some(end) = ends.find(|&end| end == point) {
            *point = end.clone();
            known[v] = Known::Done;
            continue;
        }
        known[v] = match known[v] {
            Known::Nothing => Known::Line(line),
            Known::Line(other) if other != line => {
                let crossing = Point2::crossing(other, line).filter(|crossing| crossing == point);
                if let Some(crossing) = crossing {
                    *point = crossing;
                }
                Known::Done
            }
            same => same,
        };
    }
}

/// Says what is wrong in numbers of the file, and in which line; `None` if in none.
fn sentence(violation: &Violation, cells: &Cells, numbers: &Numbers) -> (Option<u32>, String) {
    let vertex = |v: VertexId| cells.vertex_name(v);
    let edge = |e: dcel::EdgeId| cells.edges.id(e.index());
    let edge_line = |e: dcel::EdgeId| Some(cells.edges.line(e.index()));
    let curve = |e: dcel::EdgeId| numbers.id(cells.supports[e.index()] as usize);
    let face = |f: dcel::FaceId| cells.faces.id(f.index());
    match *violation {
        Violation::OffSupport(v, e) if cells.vertex_line(v).is_none() => {
            (edge_line(e), format!("curve {} does not go to infinity at this end of the edge", curve(e)))
        }
        Violation::OffSupport(v, e) => (edge_line(e), format!("{} is not on curve {}", vertex(v), curve(e))),
        Violation::EndOrder(e) => (
            edge_line(e),
            "the ends of the edge are equal or in the wrong order; write the lesser one first".into(),
        ),
        Violation::Rotation(v) => (
            cells.vertex_line(v),
            format!("the boundaries around {} contradict the order of its edges", vertex(v)),
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
            (cells.vertex_line(later), format!("{} and {} are one point", vertex(v.min(w)), vertex(later)))
        }
        Violation::VertexOnEdge(v, e) => {
            (edge_line(e), format!("{} lies within the edge; cut the edge there", vertex(v)))
        }
        Violation::Crossing(d, e) => {
            let later = d.max(e);
            (edge_line(later), format!("the edge meets edge {} where no vertex is", edge(d.min(e))))
        }
        Violation::Overlap(d, e) => {
            let later = d.max(e);
            (edge_line(later), format!("the edge and edge {} have a piece in common", edge(d.min(e))))
        }
        Violation::WrongFace(v, by_cells, found) => {
            let (by_cells, found) = (face(by_cells), face(found));
            let why = format!(
                "at {}, the boundaries say face {by_cells} where the curves say face {found}",
                vertex(v)
            );
            (cells.vertex_line(v), why)
        }
        Violation::CornerFace(f) => {
            let why = format!("face {} is not the one at the lower left; write that first", face(f));
            (Some(cells.faces.line(f.index())), why)
        }
        Violation::Cells(DcelViolation::VertexCycle(v)) => {
            (cells.vertex_line(v), format!("the boundaries do not run round {} in one turn", vertex(v)))
        }
        Violation::Cells(_) => (None, "faces and boundaries do not make up the surface".into()),
        Violation::Unseen(v) => {
            (cells.vertex_line(v), format!("the edges of {} contradict the curves", vertex(v)))
        }
        _ => (None, "the cells contradict the curves".into()),
    }
}
