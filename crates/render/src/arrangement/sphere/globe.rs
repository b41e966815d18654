//! A sphere from outside: two hemispheres in orthographic projection.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{Along, ApproxTraits, UMonotoneTraits};
use dcel::{FaceId, HalfedgeId};

use super::disc::Disc;
use super::outline::{Outlines, SIDES};
use super::rim::{Boundary, area_of};
use super::view::{GlobeOptions, Vector, View};
use super::{is_collapsed, is_sphere, rim_face};
use crate::arrangement::cells::Cells;
use crate::arrangement::look::Look;
use crate::colour::Colour;
use crate::error::{RenderError, finite};
use crate::frame::Frame;
use crate::scene::{Item, Layer, Scene, Shape};
use crate::style::{Stroke, Style};
use crate::trig::cos_sin_turns;

impl Scene {
    /// The picture of an arrangement on a sphere, seen from outside: two discs of radius 1, the hemisphere in front at the left, and
    /// beside it the other one, seen from the opposite side. Layers are `faces`, `graticule`, `frame`, `edges`, `vertices`; cells
    /// have the names that they have in [`Scene::of_arrangement`], and faces that share an edge have different colours, of eight.
    ///
    /// A face is one region, with parts in one disc or in both. Edges and vertices on the boundary of both hemispheres are drawn in
    /// both discs, with the same name; so are the parts of an edge that crosses it. Meridians and parallels are those of space,
    /// wherever the identification is. Vertices are those of [`Arrangement::user_view`]: neither the identification nor a pole shows,
    /// unless somebody put a vertex there.
    ///
    /// # Errors
    /// If the surface is not a sphere, or a parameter is not finite.
    ///
    /// # Complexity
    /// O(n log n) for n cells, and linear in the number of points of all edges, but for sorting, in each face, the edges that cross from
    /// one disc to the other.
    pub fn of_globe<G: ApproxTraits + UMonotoneTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        options: &GlobeOptions,
    ) -> Result<Self, RenderError> {
        if !is_sphere(&arrangement.topology().sides()) {
            return Err(RenderError::NotASphere);
        }
        let globe = Globe::new(arrangement, options)?;
        let mut scene = Self::new(Frame::new([-2.1, -1.05], [2.1, 1.05])?);
        let (faces, are_collapsed) = globe.faces()?;
        scene.set_collapsed(are_collapsed || is_collapsed(arrangement));
        scene.push_layer(faces);
        if options.has_graticule() {
            scene.push_layer(globe.graticule()?);
        }
        scene.push_layer(globe.frame()?);
        scene.push_layer(globe.edges()?);
        scene.push_layer(globe.vertices()?);
        Ok(scene)
    }
}

/// An arrangement as it is seen.
struct Globe<'a, G: ApproxTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    cells: Cells,
    view: View,
    /// The edges, by their ids.
    chains: Vec<Vec<Vector>>,
    discs: [Disc; 2],
    look: Look,
}

impl<'a, G: ApproxTraits + UMonotoneTraits, T: Topology<G>> Globe<'a, G, T> {
    fn new(arrangement: &'a Arrangement<G, T>, options: &GlobeOptions) -> Result<Self, RenderError> {
        let view = View::new(options)?;
        let outlines = Outlines::new(arrangement)?;
        let mut chains = vec![Vec::new(); arrangement.dcel().edge_bound()];
        for e in arrangement.dcel().edges() {
            chains[e.index()] = view.chain(outlines.edge(e));
        }
        let ends = || chains.iter().flat_map(|chain| chain.first().into_iter().chain(chain.last())).copied();
        let discs = Disc::pair(ends);
        let look = Look::new(arrangement.vertices().count());
        let cells = Cells::new(arrangement);
        Ok(Self { arrangement, cells, view, chains, discs, look })
    }

    /// The faces, and whether they overlap.
    fn faces(&self) -> Result<(Layer, bool), RenderError> {
        let boundaries: Vec<(FaceId, [Boundary; 2])> =
            self.cells.faces().map(|(f, _)| (f, self.boundaries(f))).collect();
        let rim_face = rim_face(boundaries.iter().map(|(f, both)| (*f, both.as_slice())));
        let mut faces = Layer::new("faces");
        let mut filled = [0.0; 2];
        let looks = self.cells.faces().zip(self.cells.colours(self.arrangement));
        for ((f, boundaries), ((_, name), colour)) in boundaries.into_iter().zip(looks) {
            let mut all = Vec::new();
            for ((disc, boundary), filled) in self.discs.iter().zip(boundaries).zip(&mut filled) {
                let rings = disc.rim().rings(boundary, rim_face == Some(f));
                *filled += area_of(&rings);
                all.extend(rings);
            }
            let style = Style::filled("face", colour);
            faces.push(Item::new(Shape::region(all), style).with_id(name))?;
        }
        let are_collapsed =
            self.discs.iter().zip(filled).any(|(disc, filled)| disc.rim().is_missed_by(filled));
        Ok((faces, are_collapsed))
    }

    /// The boundary of a face in both discs.
    fn boundaries(&self, f: FaceId) -> [Boundary; 2] {
        let dcel = self.arrangement.dcel();
        let mut boundaries = [(); 2].map(|()| Boundary::default());
        for ccb in dcel.face_ccbs(f) {
            let mut cycle: Vec<Vector> = Vec::new();
            for h in dcel.ccb_cycle(ccb) {
                let chain = self.along(h);
                // Chains meet in equal points.
                cycle.extend(chain.iter().take(chain.len().saturating_sub(1)));
            }
            for (disc, boundary) in self.discs.iter().zip(&mut boundaries) {
                disc.add_cycle(&cycle, boundary);
            }
        }
        boundaries
    }

    fn along(&self, h: HalfedgeId) -> Vec<Vector> {
        let mut chain = self.chains[h.edge()].clone();
        if !h.is_even() {
            chain.reverse();
        }
        chain
    }

    fn graticule(&self) -> Result<Layer, RenderError> {
        let mut layer = Layer::new("graticule");
        let style = Style::default().with_stroke(Stroke::new(Colour::GREY, 0.5).with_opacity(0.5));
        let style = Style { class: "graticule".into(), ..style };
        let steps = |count: i32| (0..=count).map(move |k| f64::from(k) / f64::from(count));
        // In turns: 30 degrees are a twelfth.
        let parallels = (-2..=2).map(|k| steps(120).map(|t| [t, f64::from(k) / 12.0]).collect());
        let meridians = (0..12).map(|k| steps(60).map(|t| [f64::from(k) / 12.0, t / 2.0 - 0.25]).collect());
        let lines: Vec<Vec<[f64; 2]>> = parallels.chain(meridians).collect();
        for line in lines {
            let seen = line.into_iter().map(|[u, v]| {
                let ((cos_u, sin_u), (cos_v, sin_v)) = (cos_sin_turns(u), cos_sin_turns(v));
                self.view.seen([cos_v * cos_u, cos_v * sin_u, sin_v])
            });
            let line: Vec<Vector> = seen.collect();
            for part in self.discs.iter().flat_map(|disc| disc.visible(&line)) {
                layer.push(Item::new(Shape::Polyline(part), style.clone()))?;
            }
        }
        Ok(layer)
    }

    fn frame(&self) -> Result<Layer, RenderError> {
        let mut frame = Layer::new("frame");
        for (disc, title) in self.discs.iter().zip(["front", "back"]) {
            let style = Style::stroked("rim", Colour::GREY, 1.0);
            let rim = Shape::ClosedPolyline(disc.rim().corners().to_vec());
            frame.push(Item::new(rim, style).with_title(title))?;
        }
        Ok(frame)
    }

    fn edges(&self) -> Result<Layer, RenderError> {
        let mut edges = Layer::new("edges");
        for (e, name) in self.cells.edges() {
            for part in self.discs.iter().flat_map(|disc| disc.visible(&self.chains[e.index()])) {
                let item = Item::new(Shape::Polyline(part), self.look.edge());
                edges.push(item.with_id(name.clone()))?;
            }
        }
        Ok(edges)
    }

    fn vertices(&self) -> Result<Layer, RenderError> {
        let arrangement = self.arrangement;
        let mut vertices = Layer::new("vertices");
        for (v, name) in self.cells.vertices() {
            let Some(point) = arrangement.point(v) else { continue };
            let [u, height] = arrangement.traits().approx_point(point);
            finite("a parameter", &[u, height])?;
            let height = match arrangement.topology().point_location(arrangement.traits(), point).v {
                Along::Low => SIDES[1][0],
                Along::Inside => height,
                Along::High => SIDES[1][1],
            };
            let place = self.view.place([u, height]);
            let style = self.look.vertex(arrangement.dcel().outgoing(v).is_none());
            for disc in self.discs.iter().filter(|disc| disc.shows(place)) {
                let item = Item::new(Shape::disc(disc.place(place), self.look.size), style.clone());
                vertices.push(item.with_id(name.clone()))?;
            }
        }
        Ok(vertices)
    }
}
