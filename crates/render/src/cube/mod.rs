//! Pictures of maps on the sides of a cube, which are unfolded to a cross.
//!
//! | file | role |
//! |---|---|
//! | this one | the scene |
//! | `net` | where each side lies, and how it is turned |

mod net;

use arrangement::traits::ApproxTraits;
use cubical::{At, CubeSide, CubicalArrangement};
use dcel::VertexId;

use crate::arrangement::Look;
use crate::colour::Colour;
use crate::error::{RenderError, finite};
use crate::frame::{Frame, Point};
use crate::scene::{Item, Layer, Scene, Shape};
use crate::style::{Dash, Stroke, Style};

impl Scene {
    /// The picture of a map on the sides of a cube, unfolded to a cross: layers `faces`, `seams`, `edges`, `vertices`, `labels`. The
    /// side x = 1 is in the middle, z = 1 above it.
    ///
    /// The parts of one face of the sphere have one colour and one name, `f0`, on all sides. What is only an edge of the cube is
    /// dashed, and what is a vertex only there is small and white; edges and vertices of the map are drawn as in other pictures. Edges
    /// and vertices have the side, counted as in [`CubeSide`], and their id there as names: `e0.7`, `v0.4`. What is on an edge of the
    /// cube has a copy, with a name of its own, on each side.
    ///
    /// # Errors
    /// If a coordinate is not finite; on a cube they are.
    ///
    /// # Complexity
    /// Linear.
    pub fn of_cube(map: &CubicalArrangement) -> Result<Self, RenderError> {
        let [min, max] = net::FRAME;
        let mut scene = Self::new(Frame::new(min, max)?);
        let look = Look::new(CubeSide::ALL.iter().map(|&side| map.side(side).vertices().count()).sum());
        let layers = [faces(map)?, seams(map)?, edges(map, look)?, vertices(map, look)?, labels()?];
        layers.into_iter().for_each(|layer| scene.push_layer(layer));
        Ok(scene)
    }
}

/// Where a vertex of a side is drawn.
fn place(map: &CubicalArrangement, side: CubeSide, id: VertexId) -> Result<Point, RenderError> {
    let arrangement = map.side(side);
    let point = arrangement.point(id).expect("in the bounded plane every vertex has a point");
    let place = net::place(side, arrangement.traits().approx_point(point));
    finite("a coordinate", &place)?;
    Ok(place)
}

fn faces(map: &CubicalArrangement) -> Result<Layer, RenderError> {
    let mut faces = Layer::new("faces");
    for side in CubeSide::ALL {
        let dcel = map.side(side).dcel();
        let ring = |ccb| dcel.ccb_cycle(ccb).map(|h| place(map, side, dcel.source(h))).collect();
        for id in dcel.faces() {
            let Some(face) = map.face_of(At { side, id }) else { continue };
            let rings = dcel.face_ccbs(id).map(ring).collect::<Result<Vec<Vec<Point>>, _>>()?;
            let style = Style::filled("face", Colour::pale(face.0));
            faces.push(Item::new(Shape::region(rings), style).with_id(format!("f{}", face.0)))?;
        }
    }
    Ok(faces)
}

/// The edges of the cube that are no edges of the map.
fn seams(map: &CubicalArrangement) -> Result<Layer, RenderError> {
    let stroke = Stroke::new(Colour::GREY, 1.0).with_dash(Dash::Dashed);
    let style = Style { class: "artificial".into(), ..Style::default() }.with_stroke(stroke);
    lines(map, Layer::new("seams"), &style, false)
}

fn edges(map: &CubicalArrangement, look: Look) -> Result<Layer, RenderError> {
    lines(map, Layer::new("edges"), &look.edge(), true)
}

/// All edges that are real, or all that are not.
fn lines(
    map: &CubicalArrangement,
    mut layer: Layer,
    style: &Style,
    is_real: bool,
) -> Result<Layer, RenderError> {
    for side in CubeSide::ALL {
        let dcel = map.side(side).dcel();
        for id in dcel.edges().filter(|&id| map.is_real_edge(At { side, id }) == is_real) {
            let [a, b] = dcel.ends(id);
            let line = Shape::Polyline(vec![place(map, side, a)?, place(map, side, b)?]);
            layer.push(Item::new(line, style.clone()).with_id(format!("e{}.{}", side.index(), id.0)))?;
        }
    }
    Ok(layer)
}

/// Those that are artificial below the others.
fn vertices(map: &CubicalArrangement, look: Look) -> Result<Layer, RenderError> {
    let mut vertices = Layer::new("vertices");
    let artificial =
        Style::filled("vertex artificial", Colour::WHITE).with_stroke(Stroke::new(Colour::GREY, 1.0));
    for is_real in [false, true] {
        for side in CubeSide::ALL {
            let dcel = map.side(side).dcel();
            for id in dcel.vertices().filter(|&id| map.is_real_vertex(At { side, id }) == is_real) {
                let (style, size) = match is_real {
                    true => (look.vertex(map.real_around(At { side, id }).next().is_none()), look.size),
                    false => (artificial.clone(), look.size * 0.7),
                };
                let disc = Item::new(Shape::disc(place(map, side, id)?, size), style);
                vertices.push(disc.with_id(format!("v{}.{}", side.index(), id.0)))?;
            }
        }
    }
    Ok(vertices)
}

/// The equations of the sides, beside the cross.
fn labels() -> Result<Layer, RenderError> {
    let mut labels = Layer::new("labels");
    for side in CubeSide::ALL {
        let (at, offset, anchor) = net::label(side);
        let label = Shape::Label { at, text: side.to_string(), anchor, offset, size: 13.0 };
        labels.push(Item::new(label, Style::filled("side", Colour::INK)))?;
    }
    Ok(labels)
}
