//! Many inputs come at once, by one sweep.

use super::record::Place;
use super::{ArrangementWithHistory, History, Input, InputId};
use crate::arrangement::build::{BuildTag, Builder, Built};
use crate::arrangement::{Arrangement, CurveId, Parts, assemble::assemble};
use crate::edit::Observer;
use crate::insert::Pieces;
use crate::sweep::{Around, CellNumbers, Event, SweepInput, SweepVisitor, sweep};
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, BasicTraits, CurveEnd, Piece, UMonotoneTraits};
use dcel::{EdgeId, VertexId};
use std::ops::ControlFlow;

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> ArrangementWithHistory<G, T, O> {
    /// Inserts general curves, by one sweep over them and the edges that are there, and gives their ids in the order of the
    /// curves.
    ///
    /// All cells get new ids; inputs keep theirs.
    ///
    /// # Complexity
    /// That of [`sweep`], over old edges and new curves, and linear in the number of pairs of an edge and an input on it; and that of
    /// [`Editor::new`](crate::Editor::new).
    pub fn insert_curves<'a>(&mut self, curves: impl IntoIterator<Item = &'a G::Curve>) -> Vec<InputId>
    where
        G::Curve: 'a,
    {
        self.insert_curves_and_points(curves, [])
    }

    /// Inserts points by one sweep, and gives their ids in the order of the points: see [`Self::insert_curves`].
    ///
    /// # Preconditions
    /// Those of [`Editor`](crate::Editor) on points.
    ///
    /// # Complexity
    /// As of [`Self::insert_curves`].
    pub fn insert_points(&mut self, points: impl IntoIterator<Item = G::Point>) -> Vec<InputId> {
        self.insert_curves_and_points([], points)
    }

    /// Inserts general curves and points by one sweep, and gives their ids, those of curves first: see [`Self::insert_curves`].
    ///
    /// # Preconditions
    /// Those of [`Editor`](crate::Editor) on points.
    ///
    /// # Complexity
    /// As of [`Self::insert_curves`].
    ///
    /// # Examples
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::history::{ArrangementWithHistory, Input};
    /// use splitstar_arrangement::{models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = Segment::from_i64([[0, 0], [4, 0]]).expect("the ends are different");
    /// let mut arrangement = ArrangementWithHistory::new(SegmentTraits, BoundedPlane);
    /// let ids = arrangement.insert_curves_and_points([&segment], [Point2::from_i64([2, 0])]);
    /// assert_eq!(arrangement.edges_of(ids[0]).count(), 2);
    /// assert_eq!(arrangement.remove(ids[1]), Some(Input::Point(Point2::from_i64([2, 0]))));
    /// assert_eq!(arrangement.edges_of(ids[0]).count(), 1);
    /// ```
    pub fn insert_curves_and_points<'a>(
        &mut self,
        curves: impl IntoIterator<Item = &'a G::Curve>,
        points: impl IntoIterator<Item = G::Point>,
    ) -> Vec<InputId>
    where
        G::Curve: 'a,
    {
        let mut owned = Owned { pieces: Pieces::new(), curves: Vec::new(), points: Vec::new() };
        let mut ids = Vec::new();
        let mut buffer = Vec::new();
        for curve in curves {
            let id = self.put(Input::Curve(curve.clone()));
            self.traits().make_u_monotone(curve, &mut buffer);
            for piece in buffer.drain(..) {
                let owners =
                    if matches!(piece, Piece::Curve { .. }) { &mut owned.curves } else { &mut owned.points };
                owners.push(id);
                owned.pieces.extend([piece]);
            }
            ids.push(id);
        }
        for point in points {
            let id = self.put(Input::Point(point.clone()));
            owned.points.push(id);
            owned.pieces.push_point(point);
            ids.push(id);
        }
        let (parts, history) = place_all(self.arrangement(), self.history(), owned);
        self.editor.replace_all(parts, |observers| observers.0 = history);
        ids
    }
}

/// Pieces of inputs that come.
struct Owned<G: BasicTraits> {
    pieces: Pieces<G>,
    /// Whose the curves are, and whose the points.
    curves: Vec<InputId>,
    points: Vec<InputId>,
}

/// Cells, and where the sites of the input came to lie.
struct Swept<P> {
    built: Built<P>,
    /// Which cells of the old arrangement the first sites and curves were. The sites of ends of free curves follow, then those of points.
    numbers: CellNumbers,
    /// For each site, the vertex that it became.
    vertices: Vec<VertexId>,
}

/// Makes the cells of an arrangement and pieces, and says what runs where.
fn place_all<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    old: &History,
    owned: Owned<G>,
) -> (Parts<G>, History) {
    let Swept { mut built, numbers, vertices } = sweep_all(arrangement, &owned.pieces);
    let mut history = old.without_cells();
    let mut new_vertex = vec![VertexId::NONE; arrangement.dcel().vertex_bound()];
    for (&v, &new) in numbers.vertices.iter().zip(&vertices) {
        new_vertex[v.index()] = new;
    }
    // For each piece that is a curve, the vertex at its min end.
    let mut starts = vec![VertexId::NONE; history.piece_bound()];
    for piece in 0..history.piece_bound() as u32 {
        match history.piece(piece).place {
            Place::Curve { first, .. } => {
                starts[piece as usize] = new_vertex[arrangement.dcel().ends(first)[0].index()];
            }
            Place::Point(v) => {
                let v = new_vertex[v.index()];
                history.set_place(piece, Place::Point(v));
                history.add_to_vertex(v, piece);
            }
            Place::Nowhere => {}
        }
    }
    let mut site = numbers.vertices.len();
    let mut new_pieces = Vec::with_capacity(owned.curves.len());
    for (i, &input) in owned.curves.iter().enumerate() {
        let curve = CurveId((arrangement.curves().len() + i) as u32);
        let is_artificial = owned.pieces.is_artificial[i];
        let piece = history.add_piece(input, Place::Curve { curve, first: EdgeId(0), is_artificial });
        starts.resize(history.piece_bound(), VertexId::NONE);
        starts[piece as usize] = vertices[site];
        new_pieces.push(piece);
        site += 1;
    }
    site += owned.curves.len();
    for (&input, &v) in owned.points.iter().zip(&vertices[site..]) {
        let piece = history.add_piece(input, Place::Point(v));
        history.add_to_vertex(v, piece);
    }
    let swept = numbers.edges.len();
    let mut overlaps = built.overlaps.iter().peekable();
    for (e, curve) in (0..).map(EdgeId).zip(&built.edge_curves) {
        let members = match overlaps.next_if(|(edge, _)| *edge == e.0) {
            Some((_, members)) => &members[..],
            None => std::slice::from_ref(curve),
        };
        let min = built.dcel.ends(e)[0];
        for &member in members {
            let member = member as usize;
            let pieces = match numbers.edges.get(member) {
                Some(old_edge) => old.of_edges.get(old_edge.index()),
                None => &new_pieces[member - swept..][..1],
            };
            for &piece in pieces {
                history.add_to_edge(e, piece);
                if let Place::Curve { curve, is_artificial, .. } = history.piece(piece).place
                    && starts[piece as usize] == min
                {
                    history.set_place(piece, Place::Curve { curve, first: e, is_artificial });
                }
            }
        }
    }
    if G::OVERLAPS_ARE_PLAIN {
        built.overlaps.clear();
    }
    let support_of = |curve: u32| match numbers.edges.get(curve as usize) {
        Some(&e) => arrangement.support(e).0,
        None => (arrangement.curves().len() + curve as usize - swept) as u32,
    };
    let curves = arrangement.curves().iter().cloned().chain(owned.pieces.curves).collect();
    let parts = assemble(arrangement.traits(), arrangement.topology(), built, curves, support_of);
    (parts, history)
}

fn sweep_all<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    pieces: &Pieces<G>,
) -> Swept<G::Point> {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let mut input = SweepInput::empty();
    let numbers = input.push_arrangement(arrangement, 0);
    input.push_free(traits, topology, &pieces.curves, &pieces.points);
    let sites = input.site_count();
    let mut flags: Vec<bool> =
        numbers.vertices.iter().map(|&v| arrangement.is_artificial[v.index()]).collect();
    for end in CurveEnd::BOTH {
        flags.extend(pieces.is_artificial.iter().map(|is| is[end as usize]));
    }
    flags.extend(pieces.points.iter().map(|_| false));
    input.mirror(topology);
    // Images on other sides decide nothing.
    flags.resize(input.site_count(), true);
    let mut builder = Builder::new(traits, topology, &flags);
    builder.keep_overlaps();
    let mut visitor = Placing { builder, vertices: vec![VertexId::NONE; sites] };
    let _ = sweep(traits, topology, &input, &mut visitor);
    Swept { built: visitor.builder.finish(topology), numbers, vertices: visitor.vertices }
}

/// The builder, which notes where sites lie.
struct Placing<'s, P> {
    builder: Builder<'s, P>,
    vertices: Vec<VertexId>,
}

impl<G: BasicTraits> SweepVisitor<G> for Placing<'_, G::Point> {
    type Tag = BuildTag;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, BuildTag>) -> ControlFlow<()> {
        self.builder.event(event, around)?;
        for &site in event.input_sites {
            // Images on other sides have greater numbers.
            if let Some(vertex) = self.vertices.get_mut(site as usize) {
                *vertex = self.builder.last_vertex;
            }
        }
        ControlFlow::Continue(())
    }
}
