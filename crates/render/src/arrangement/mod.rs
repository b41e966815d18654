//! Pictures of arrangements.
//!
//! | module | role |
//! |---|---|
//! | `cells` | the cells in the order in which they are numbered and drawn |
//! | `colouring` | colours for faces such that those that share an edge differ |
//! | `outline` | edges as chains of points, and the window that holds all that happens |
//! | `fill` | what the CCBs of a face enclose: closed along the window where it runs through infinity |
//! | `torus` | faces of a torus, unrolled into the plane |
//! | `sphere` | pictures of a sphere: unfolded, and as a globe |
//! | `components` | which cells hang together |
//! | `look` | how cells are painted in all of them |
//!
//! 1. The window is around all vertices, and is met by every edge; what is shown may be less.
//! 2. Every edge becomes a chain, from its min to its max vertex; an unbounded one ends on the window.
//! 3. A face is what its CCBs enclose, by the even-odd rule. Where a CCB runs through infinity, it goes on along the window,
//!    counterclockwise, because the face is on its left. On a torus a CCB is unrolled into the plane, and repeated.

mod cells;
mod colouring;
mod components;
mod fill;
mod look;
mod outline;
mod sphere;
mod torus;

pub(crate) use look::Look;
pub use sphere::GlobeOptions;

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{ApproxTraits, UMonotoneTraits};

use crate::colour::Colour;
use crate::error::RenderError;
use crate::frame::{Frame, Point};
use crate::scene::{Item, Layer, Scene, Shape};
use crate::style::{Dash, Stroke, Style};
use cells::Cells;
use components::Components;
use outline::Outlines;

impl Scene {
    /// The picture of an arrangement: layers `faces`, `edges`, `vertices`, and on a torus `frame` above the faces. Cells have
    /// their places in [`Arrangement::cell_order`] as names: `f0`, `e0`, `v0`. So the picture depends on the cells, and not on their ids.
    ///
    /// In the plane, bounded faces have the colour of the component of their outer CCB; unbounded ones, and those without outer
    /// CCB, a light grey. On a torus and on a sphere, faces that share an edge have different colours, of eight. Edges are those that are
    /// stored; vertices are those of [`Arrangement::user_view`], so that a closed curve shows the one that it keeps.
    ///
    /// `shown` is what the picture shows; `None` stands for all vertices and every edge, with a margin. On a torus it must be
    /// the rectangle whose sides are glued together, which is drawn, too; points on a seam, and edges along one, are drawn on
    /// both sides, with the same name.
    ///
    /// A sphere is unfolded to the rectangle of its parameters in radians, u from 0 to 2 pi and v from -pi/2 to pi/2. The sides at
    /// the left and at the right, which are identified, are drawn as on a torus; those below and above are one point each, and
    /// thick: grey, or black if that point is a vertex. [`Scene::of_globe`] shows the sphere from outside.
    ///
    /// Whether coordinates are too near each other, [`Scene::is_collapsed`] tells.
    ///
    /// # Errors
    /// If a coordinate is too large for a double.
    ///
    /// # Complexity
    /// O(n log n) for n cells, and linear in the number of points of all edges, on a torus of the copies that are seen; on a sphere, the
    /// edges of each face that come to a side are sorted.
    pub fn of_arrangement<G: ApproxTraits + UMonotoneTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        shown: Option<Frame>,
    ) -> Result<Self, RenderError> {
        if sphere::is_sphere(&arrangement.topology().sides()) {
            return sphere::unfolded_scene(arrangement, shown);
        }
        let is_torus = arrangement.topology().genus() > 0;
        let outlines = Outlines::new(arrangement, shown, is_torus)?;
        let cells = Cells::new(arrangement);
        let components = Components::new(arrangement, cells.stored_vertices());
        let colours = if is_torus { cells.colours(arrangement) } else { Vec::new() };
        let look = Look::new(arrangement.vertices().count());
        let dcel = arrangement.dcel();

        let mut faces = Layer::new("faces");
        for (number, (f, name)) in cells.faces().enumerate() {
            let Some(rings) = fill::rings(arrangement, &outlines, f, is_torus) else { continue };
            let style = match dcel.outer_ccbs(f).next() {
                _ if is_torus => Style::filled("face", colours[number]),
                Some(ccb) if !arrangement.is_unbounded(f) => {
                    let component = components.of(dcel.source(dcel.ccb_halfedge(ccb)));
                    Style::filled("face", Colour::pale(component))
                }
                _ => Style::filled("face unbounded", Colour::Rgb([246, 247, 249])),
            };
            faces.push(Item::new(Shape::region(rings), style).with_id(name))?;
        }

        let mut edges = Layer::new("edges");
        for (e, name) in cells.edges() {
            for chain in outlines.edge_copies(e) {
                edges.push(Item::new(Shape::Polyline(chain), look.edge()).with_id(name.clone()))?;
            }
        }

        let mut vertices = Layer::new("vertices");
        for (v, name) in cells.vertices() {
            let Some(point) = arrangement.point(v) else { continue };
            let location = arrangement.topology().point_location(arrangement.traits(), point);
            let style = look.vertex(dcel.outgoing(v).is_none());
            for at in outlines.copies(arrangement.traits().approx_point(point), location, is_torus) {
                let item = Item::new(Shape::disc(at, look.size), style.clone());
                vertices.push(item.with_id(name.clone()))?;
            }
        }

        let mut scene = Self::new(outlines.shown);
        scene.set_collapsed(outlines.is_collapsed);
        scene.push_layer(faces);
        if is_torus {
            let mut frame = Layer::new("frame");
            let stroke = Stroke::new(Colour::GREY, 1.0).with_dash(Dash::Dashed);
            let corners: Vec<Point> = outlines.shown.corners().to_vec();
            frame.push(Item::new(Shape::ClosedPolyline(corners), Style::default().with_stroke(stroke)))?;
            scene.push_layer(frame);
        }
        [edges, vertices].into_iter().for_each(|layer| scene.push_layer(layer));
        Ok(scene)
    }
}
