//! What a visitor is told, and what it has to be told by the overlay.

use dcel::{EdgeId, FaceId, VertexId};
use exact::planar::Point2;
use splitstar_arrangement::overlay::{Cell, Provenance, overlay_all};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, CurveEnd, Intersection, Piece, SideKind,
};
use splitstar_arrangement::zone::{MeetingFinder, Passage, ZonePlace, ZoneVisitor};
use splitstar_arrangement::{Arrangement, Editor, Pieces};
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// A place, as far as it can be compared: the point and the cell.
pub(crate) type Place = (Option<Point2>, Cell);

/// One call of a visitor.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Step {
    Begins(Place),
    Vertex(VertexId, Place, Passage<Cell>),
    Edge(EdgeId, Place, Passage<Ordering>),
    Along(EdgeId, [Place; 2]),
    Enters(FaceId, Place),
    Leaves(FaceId, [Place; 2]),
    Ends(Place),
}

/// Notes all calls, and stops at one of them.
pub(crate) struct Recorder {
    pub(crate) steps: Vec<Step>,
    pub(crate) most: usize,
}

impl Recorder {
    pub(crate) fn new(most: usize) -> Self {
        Self { steps: Vec::new(), most }
    }

    fn note(&mut self, step: Step) -> ControlFlow<()> {
        self.steps.push(step);
        if self.steps.len() == self.most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

fn place<G: BasicTraits<Point = Point2>>(place: &ZonePlace<'_, G>) -> Place {
    (place.site.point().cloned(), place.cell)
}

impl<G: BasicTraits<Point = Point2>> ZoneVisitor<G> for Recorder {
    fn begins(&mut self, at: &ZonePlace<'_, G>) -> ControlFlow<()> {
        self.note(Step::Begins(place(at)))
    }

    fn vertex(&mut self, v: VertexId, at: &ZonePlace<'_, G>, passage: Passage<Cell>) -> ControlFlow<()> {
        self.note(Step::Vertex(v, place(at), passage))
    }

    fn edge(&mut self, e: EdgeId, at: &ZonePlace<'_, G>, passage: Passage<Ordering>) -> ControlFlow<()> {
        self.note(Step::Edge(e, place(at), passage))
    }

    fn along(&mut self, e: EdgeId, ends: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        self.note(Step::Along(e, ends.map(place)))
    }

    fn enters_face(&mut self, f: FaceId, start: &ZonePlace<'_, G>) -> ControlFlow<()> {
        self.note(Step::Enters(f, place(start)))
    }

    fn leaves_face(&mut self, f: FaceId, ends: [&ZonePlace<'_, G>; 2]) -> ControlFlow<()> {
        self.note(Step::Leaves(f, ends.map(place)))
    }

    fn ends(&mut self, at: &ZonePlace<'_, G>) -> ControlFlow<()> {
        self.note(Step::Ends(place(at)))
    }
}

/// What has been seen, so that tests can tell that it was.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Seen {
    pub(crate) pieces: usize,
    pub(crate) crossings: usize,
    pub(crate) touches: usize,
    pub(crate) vertices: usize,
    pub(crate) overlaps: usize,
    /// Overlaps that begin or end within an edge.
    pub(crate) partial: usize,
    pub(crate) meets: [usize; 2],
    pub(crate) interior_meets: [usize; 2],
}

/// The curve in the overlay: its vertices and, between them, its edges.
struct Blue<G: BasicTraits, T> {
    overlay: Arrangement<G, T>,
    provenance: Provenance,
    vertices: Vec<VertexId>,
    edges: Vec<EdgeId>,
}

impl<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>> Blue<G, T> {
    fn new(arrangement: &Arrangement<G, T>, curve: &G::UMonotoneCurve) -> Self {
        let mut pieces = Pieces::new();
        pieces.push_curve(curve.clone());
        let (traits, topology) = (arrangement.traits().clone(), arrangement.topology().clone());
        let alone = Arrangement::of_pieces(traits, topology, pieces);
        let (overlay, provenance) = overlay_all(&[arrangement, &alone]);
        let dcel = overlay.dcel();
        let start = alone.dcel().ends(alone.dcel().edges().next().unwrap())[0];
        let is_start = |&v: &VertexId| match alone.is_at_infinity(start) {
            true => v == start,
            false => !overlay.is_at_infinity(v) && provenance.of_vertex(v)[1] == Cell::Vertex(start),
        };
        let mut rest: Vec<EdgeId> =
            dcel.edges().filter(|&e| matches!(provenance.of_edge(e)[1], Cell::Edge(_))).collect();
        let mut vertices = vec![dcel.vertices().find(is_start).unwrap()];
        let mut edges = Vec::new();
        while !rest.is_empty() {
            let last = vertices[vertices.len() - 1];
            let next = rest.iter().position(|&e| dcel.ends(e)[0] == last).unwrap();
            let e = rest.swap_remove(next);
            vertices.push(dcel.ends(e)[1]);
            edges.push(e);
        }
        Self { overlay, provenance, vertices, edges }
    }

    fn place(&self, i: usize) -> Place {
        let v = self.vertices[i];
        let is_point = !self.overlay.is_at_infinity(v);
        let cell = if is_point { self.provenance.of_vertex(v)[0] } else { Cell::Vertex(v) };
        (self.overlay.point(v).cloned(), cell)
    }

    fn stretch(&self, i: usize) -> Cell {
        self.provenance.of_edge(self.edges[i])[0]
    }

    /// What the visitor has to be told. The passage by an edge is copied from what it was told, because the overlay does not say
    /// all of it.
    fn expected(&self, red: &Arrangement<G, T>, told: &[Step], context: &str) -> Vec<Step> {
        let last = self.edges.len();
        let mut steps = vec![Step::Begins(self.place(0))];
        for i in 0..=last {
            let at = self.place(i);
            match at.1 {
                Cell::Vertex(v) if is_on_open_side(red, v) => assert!(i == 0 || i == last, "{context}"),
                Cell::Vertex(v) => {
                    let before = i.checked_sub(1).map(|s| self.stretch(s));
                    let after = (i < last).then(|| self.stretch(i));
                    steps.push(Step::Vertex(v, at.clone(), Passage { before, after }));
                }
                Cell::Edge(e) => {
                    let Some(Step::Edge(_, _, passage)) = told.get(steps.len()) else {
                        panic!("no edge at {at:?}: {told:?}, {context}")
                    };
                    self.check_passage(red, e, i, *passage, context);
                    steps.push(Step::Edge(e, at.clone(), *passage));
                }
                Cell::Face(_) => assert!(i == 0 || i == last, "{context}"),
            }
            if i < last {
                let ends = [at, self.place(i + 1)];
                match self.stretch(i) {
                    Cell::Edge(e) => steps.push(Step::Along(e, ends)),
                    Cell::Face(f) => {
                        steps.extend([Step::Enters(f, ends[0].clone()), Step::Leaves(f, ends)]);
                    }
                    Cell::Vertex(_) => panic!("an edge in a vertex"),
                }
            }
        }
        steps.push(Step::Ends(self.place(last)));
        steps
    }

    fn check_passage(
        &self,
        red: &Arrangement<G, T>,
        e: EdgeId,
        i: usize,
        passage: Passage<Ordering>,
        context: &str,
    ) {
        let context = format!("{passage:?} at {:?}, {context}", self.place(i));
        let stretches = [i.checked_sub(1), (i < self.edges.len()).then_some(i)];
        for (stretch, side) in stretches.into_iter().zip([passage.before, passage.after]) {
            assert_eq!(stretch.is_some(), side.is_some(), "{context}");
            let Some((stretch, side)) = stretch.zip(side) else { continue };
            let cell = match side {
                Ordering::Less => Cell::Face(red.dcel().face(e.halfedge().twin())),
                Ordering::Equal => Cell::Edge(e),
                Ordering::Greater => Cell::Face(red.dcel().face(e.halfedge())),
            };
            assert_eq!(self.stretch(stretch), cell, "{context}");
        }
        if passage.is_crossing() || passage.is_touching() {
            assert_eq!(passage.is_crossing(), self.is_crossing(i), "{context}");
        }
    }

    /// Whether the curve crosses the one edge that is at vertex `i`: their halves take turns around it.
    fn is_crossing(&self, i: usize) -> bool {
        let is_blue = |h: dcel::HalfedgeId| matches!(self.provenance.of_edge(h.edge_id())[1], Cell::Edge(_));
        let around: Vec<bool> = self.overlay.dcel().around(self.vertices[i]).map(is_blue).collect();
        assert_eq!(around.len(), 4, "two halves each");
        around[0] != around[1] && around[1] != around[2]
    }
}

fn is_on_open_side<G: BasicTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, v: VertexId) -> bool {
    let sides = arrangement.topology().sides();
    let kinds = [sides.u[0], sides.u[1], sides.v[0], sides.v[1]];
    let mut sides = arrangement.topology().side_vertices().into_iter().zip(kinds);
    sides.any(|(side, kind)| side == Some(v.0) && kind == SideKind::Open)
}

/// Forgets the points of vertices that stand for sides: some traits know such points, the arrangement does not.
fn without_side_points<G: BasicTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, steps: &mut [Step]) {
    let clean = |(point, cell): &mut Place| {
        if matches!(cell, Cell::Vertex(v) if arrangement.is_at_infinity(*v)) {
            *point = None;
        }
    };
    for step in steps {
        match step {
            Step::Begins(place) | Step::Ends(place) | Step::Enters(_, place) => clean(place),
            Step::Vertex(_, place, _) => clean(place),
            Step::Edge(_, place, _) => clean(place),
            Step::Along(_, ends) | Step::Leaves(_, ends) => ends.iter_mut().for_each(clean),
        }
    }
}

/// The calls for a u-monotone curve, compared with the overlay.
fn check_piece<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    editor: &Editor<G, T>,
    curve: &G::UMonotoneCurve,
    seen: &mut Seen,
    context: &str,
) -> Vec<Step> {
    let mut recorder = Recorder::new(usize::MAX);
    assert!(editor.zone(curve, &mut recorder).is_continue());
    let mut steps = recorder.steps;
    let told = steps.clone();
    without_side_points(editor, &mut steps);
    let expected = Blue::new(editor.arrangement(), curve).expected(editor.arrangement(), &steps, context);
    assert_eq!(steps, expected, "{context}");
    seen.pieces += 1;
    for step in &steps {
        match step {
            Step::Vertex(..) => seen.vertices += 1,
            Step::Edge(_, _, passage) => {
                seen.crossings += usize::from(passage.is_crossing());
                seen.touches += usize::from(passage.is_touching());
                let sides = [passage.before, passage.after];
                seen.partial += usize::from(sides.contains(&Some(Ordering::Equal)));
            }
            Step::Along(..) => seen.overlaps += 1,
            _ => {}
        }
    }
    told
}

/// The cells of calls, without repetition.
fn cells_of(steps: &[Step]) -> Vec<Cell> {
    let mut cells: Vec<Cell> = steps
        .iter()
        .filter_map(|step| match step {
            Step::Begins((_, cell @ Cell::Face(_))) => Some(*cell),
            Step::Vertex(v, ..) => Some(Cell::Vertex(*v)),
            Step::Edge(e, ..) | Step::Along(e, _) => Some(Cell::Edge(*e)),
            Step::Enters(f, _) => Some(Cell::Face(*f)),
            _ => None,
        })
        .collect();
    cells.dedup();
    cells
}

/// What a curve meets by the overlay, piece by piece; and all that is made of it.
pub(crate) fn check<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    editor: &Editor<G, T>,
    curve: &G::Curve,
    seen: &mut Seen,
    context: &str,
) {
    let mut pieces = Vec::new();
    editor.traits().make_u_monotone(curve, &mut pieces);
    let mut all = Vec::new();
    let (mut meets, mut interior_meets) = (false, false);
    for piece in &pieces {
        let steps = match piece {
            Piece::Curve { curve, .. } => check_piece(editor, curve, seen, context),
            Piece::Point(point) => {
                let cell = editor.locate(point);
                let place = (Some(point.clone()), cell);
                let mut steps = vec![Step::Begins(place.clone())];
                match cell {
                    Cell::Vertex(v) => steps.push(Step::Vertex(v, place.clone(), Passage::NONE)),
                    Cell::Edge(e) => steps.push(Step::Edge(e, place.clone(), Passage::NONE)),
                    Cell::Face(_) => {}
                }
                steps.push(Step::Ends(place));
                steps
            }
        };
        let is_end = |is_first: bool, is_last: bool| match piece {
            Piece::Curve { is_artificial, .. } => {
                is_first && !is_artificial[0] || is_last && !is_artificial[1]
            }
            Piece::Point(_) => true,
        };
        for step in &steps {
            let ends = match step {
                Step::Vertex(_, _, passage) => (passage.before.is_none(), passage.after.is_none()),
                Step::Edge(_, _, passage) => (passage.before.is_none(), passage.after.is_none()),
                Step::Along(..) => (false, false),
                _ => continue,
            };
            meets = true;
            interior_meets |= !is_end(ends.0, ends.1);
        }
        all.extend(steps);
    }
    let mut recorder = Recorder::new(usize::MAX);
    assert!(editor.zone_of(curve, &mut recorder).is_continue());
    assert_eq!(recorder.steps, all, "{context}");
    assert_eq!(editor.zone_cells_of(curve), cells_of(&all), "{context}");
    assert_eq!(editor.meets_anything(curve), meets, "{context}");
    assert_eq!(editor.interior_meets_anything(curve), interior_meets, "{context}");
    let mut finder = MeetingFinder::new();
    let _ = editor.zone_of(curve, &mut finder);
    let first = cells_of(&all).into_iter().find(|cell| !matches!(cell, Cell::Face(_)));
    assert_eq!(finder.found(), first, "{context}");
    seen.meets[usize::from(meets)] += 1;
    seen.interior_meets[usize::from(interior_meets)] += 1;
    // Wherever it is stopped, nothing more comes.
    for most in 1..=all.len() {
        let mut recorder = Recorder::new(most);
        assert!(editor.zone_of(curve, &mut recorder).is_break(), "{context}");
        assert_eq!(recorder.steps, all[..most], "{context}");
    }
}

/// Whether a curve meets anything, and whether it does so between its ends, by all pairs. In the plane.
pub(crate) fn meets_by_pairs<G: ArrangementTraits<Point = Point2>, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    curve: &G::Curve,
) -> [bool; 2] {
    let traits = arrangement.traits();
    let (mut pieces, mut common) = (Vec::new(), Vec::new());
    traits.make_u_monotone(curve, &mut pieces);
    let (mut meets, mut interior_meets) = (false, false);
    for piece in &pieces {
        let (curve, is_artificial) = match piece {
            Piece::Curve { curve, is_artificial } => (curve, is_artificial),
            Piece::Point(p) => {
                let is_vertex = arrangement.vertices().any(|v| arrangement.point(v) == Some(p));
                let mut edges = arrangement.dcel().edges().map(|e| arrangement.make_edge_curve(e));
                meets |= is_vertex || edges.any(|curve| traits.is_on_curve(p, &curve));
                continue;
            }
        };
        let is_end = |p: &Point2| {
            let is = |end: CurveEnd| !is_artificial[end as usize] && traits.end_point(curve, end) == Some(p);
            CurveEnd::BOTH.into_iter().any(is)
        };
        let isolated = arrangement.vertices().filter(|&v| arrangement.dcel().outgoing(v).is_none());
        let on_it = isolated.filter_map(|v| arrangement.point(v)).filter(|p| traits.is_on_curve(p, curve));
        let mut meet = |is_end: bool| {
            meets = true;
            interior_meets |= !is_end;
        };
        on_it.for_each(|p| meet(is_end(p)));
        for e in arrangement.dcel().edges() {
            common.clear();
            traits.intersect(&arrangement.make_edge_curve(e), curve, &mut common);
            for intersection in &common {
                match intersection {
                    Intersection::Point(p, _) => meet(is_end(p)),
                    Intersection::Overlap(_) => meet(false),
                }
            }
        }
    }
    [meets, interior_meets]
}
