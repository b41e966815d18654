//! The parameter space of a sphere, unfolded to a rectangle.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{Along, ApproxTraits, UMonotoneTraits};
use dcel::{CcbId, FaceId, HalfedgeId};

use super::outline::{Outlines, SIDES, at_right, rectangle};
use super::rim::{Boundary, Rim, area_of};
use super::{is_collapsed, rim_face};
use crate::arrangement::cells::Cells;
use crate::arrangement::look::Look;
use crate::colour::Colour;
use crate::error::{RenderError, finite};
use crate::frame::{Frame, Point};
use crate::scene::{Item, Layer, Scene, Shape};
use crate::style::{Dash, Stroke, Style};

/// The picture of the rectangle, or of the part of it that is shown.
pub(in crate::arrangement) fn scene<G: ApproxTraits + UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    shown: Option<Frame>,
) -> Result<Scene, RenderError> {
    let look = Look::new(arrangement.vertices().count());
    let outlines = Outlines::new(arrangement)?;
    let cells = Cells::new(arrangement);
    let mut scene = Scene::new(shown.map_or_else(rectangle, Ok)?);
    let (faces, are_collapsed) = faces(arrangement, &cells, &outlines)?;
    scene.set_collapsed(are_collapsed || is_collapsed(arrangement));
    scene.push_layer(faces);
    scene.push_layer(frame()?);
    let mut edges = Layer::new("edges");
    for (e, name) in cells.edges() {
        let edge = outlines.edge(e);
        let copy = edge.is_along_seam.then(|| at_right(&edge.points));
        for points in [edge.points.clone()].into_iter().chain(copy) {
            edges.push(Item::new(Shape::Polyline(points), look.edge()).with_id(name.clone()))?;
        }
    }
    scene.push_layer(edges);
    scene.push_layer(vertices(arrangement, &cells, look)?);
    Ok(scene)
}

/// The faces, and whether they overlap.
fn faces<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    cells: &Cells,
    outlines: &Outlines,
) -> Result<(Layer, bool), RenderError> {
    let dcel = arrangement.dcel();
    let boundary = |f: FaceId| {
        let mut boundary = Boundary::default();
        for ccb in dcel.face_ccbs(f) {
            add_ccb(arrangement, outlines, ccb, &mut boundary);
        }
        boundary
    };
    let boundaries: Vec<(FaceId, [Boundary; 1])> = cells.faces().map(|(f, _)| (f, [boundary(f)])).collect();
    let rim_face = rim_face(boundaries.iter().map(|(f, boundaries)| (*f, boundaries.as_slice())));
    let [[left, right], [bottom, top]] = SIDES;
    let rim = Rim::new([(left + right) / 2.0, (bottom + top) / 2.0], rectangle()?.corners().to_vec());
    let mut faces = Layer::new("faces");
    let mut filled = 0.0;
    let looks = cells.faces().zip(cells.colours(arrangement));
    for ((f, [boundary]), ((_, name), colour)) in boundaries.into_iter().zip(looks) {
        let rings = rim.rings(boundary, rim_face == Some(f));
        filled += area_of(&rings);
        let style = Style::filled("face", colour);
        faces.push(Item::new(Shape::region(rings), style).with_id(name))?;
    }
    Ok((faces, rim.is_missed_by(filled)))
}

/// Cuts a CCB where it goes through a pole or over the identification.
fn add_ccb<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    ccb: CcbId,
    boundary: &mut Boundary,
) {
    let mut halfedges: Vec<HalfedgeId> = arrangement.dcel().ccb_cycle(ccb).collect();
    let is_cut: Vec<bool> = halfedges.iter().map(|&h| leaves_at_target(arrangement, outlines, h)).collect();
    let Some(last) = is_cut.iter().position(|&is| is) else {
        // Ends that meet are given once.
        let points = halfedges.iter().flat_map(|&h| {
            let mut points = outlines.along(h);
            points.pop();
            points
        });
        boundary.loops.push(points.collect());
        return;
    };
    halfedges.rotate_left(last + 1);
    let mut chain: Vec<Point> = Vec::new();
    for (i, h) in halfedges.iter().enumerate() {
        let points = outlines.along(*h);
        chain.extend(&points[usize::from(!chain.is_empty())..]);
        if is_cut[(last + 1 + i) % is_cut.len()] {
            boundary.chains.push(std::mem::take(&mut chain));
        }
    }
}

/// Whether the boundary of the face leaves the rectangle where a halfedge ends: it goes on over the identification, or around a pole.
/// What touches the identification on one side is as if it did not.
fn leaves_at_target<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    h: HalfedgeId,
) -> bool {
    let [_, end] = outlines.ends_along(h);
    let [start, _] = outlines.ends_along(arrangement.dcel().next(h));
    end.v != Along::Inside || end.u != start.u
}

/// The sides that are identified are dashed, as on a torus; those that are points are thick.
fn frame() -> Result<Layer, RenderError> {
    let mut frame = Layer::new("frame");
    let [a, b, c, d] = rectangle()?.corners();
    let identified = Style::stroked("identified", Colour::GREY, 1.0);
    let dashed = identified.clone().with_stroke(Stroke::new(Colour::GREY, 1.0).with_dash(Dash::Dashed));
    let contracted = Style::stroked("contracted", Colour::GREY, 3.0);
    for (side, style) in [([a, d], &dashed), ([b, c], &dashed), ([a, b], &contracted), ([d, c], &contracted)]
    {
        frame.push(Item::new(Shape::Polyline(side.to_vec()), style.clone()))?;
    }
    Ok(frame)
}

/// Vertices on the identification are drawn on both sides; poles are sides.
fn vertices<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    cells: &Cells,
    look: Look,
) -> Result<Layer, RenderError> {
    let [[left, right], [bottom, top]] = SIDES;
    let mut vertices = Layer::new("vertices");
    let mut push =
        |shape: Shape, style: Style, name: &str| vertices.push(Item::new(shape, style).with_id(name));
    for (v, name) in cells.vertices() {
        let Some(point) = arrangement.point(v) else { continue };
        let location = arrangement.topology().point_location(arrangement.traits(), point);
        let is_isolated = arrangement.dcel().outgoing(v).is_none();
        let [u, height] = arrangement.traits().approx_point(point);
        finite("a parameter", &[u, height])?;
        let pole = match location.v {
            Along::Low => Some(bottom),
            Along::Inside => None,
            Along::High => Some(top),
        };
        if let Some(pole) = pole {
            push(Shape::Polyline(vec![[left, pole], [right, pole]]), look.pole(is_isolated), &name)?;
            continue;
        }
        let us = if location.u == Along::Inside { vec![u] } else { vec![left, right] };
        for u in us {
            push(Shape::disc([u, height], look.size), look.vertex(is_isolated), &name)?;
        }
    }
    Ok(vertices)
}
