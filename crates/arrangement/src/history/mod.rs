//! Arrangements that know which input runs where.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the arrangement with its inputs, and what can be asked |
//! | `sets` | for each edge, or vertex, a small set of pieces |
//! | `record` | which pieces run along which edges, kept by watching; why there is a vertex |
//! | `insert` | an input comes |
//! | `remove` | an input goes: edges that were its own, vertices without a reason, supports |
//! | `aggregate` | many inputs come at once, by one sweep |
//! | `global` | all is numbered anew, or dropped |
//!
//! Curves are cut into u-monotone *pieces*, which have a number each. An edge has the set of pieces that run along it, and a piece its
//! first edge; the others are found by going from vertex to vertex, to the edge that has the piece, too. So nothing has to be
//! kept in order when edges are split and merged.
//!
//! A vertex of degree 2 is looked at when an input goes that ran through it. The sets of its two edges tell which pieces end there and
//! which pass. If no piece ends, the vertex goes; if all that end were only cut there, it is artificial; otherwise it is ordinary. That
//! is what a sweep over the inputs that are left says of it.

mod aggregate;
mod global;
mod insert;
mod record;
mod remove;
mod sets;

pub use record::History;

use crate::arrangement::Arrangement;
use crate::edit::{Observer, Stale};
use crate::editor::Editor;
use crate::topology::Topology;
use crate::traits::ArrangementTraits;
use dcel::{EdgeId, VertexId};
use record::Place;
use std::fmt;
use std::ops::Deref;

/// Names an input of an arrangement with history. The number of one that was removed is used again.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct InputId(pub u32);

impl InputId {
    /// The position of the input.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What was inserted: a general curve, or a point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Input<C, P> {
    /// A curve, as it was given.
    Curve(C),
    /// A point.
    Point(P),
}

/// An input of these traits.
type InputOf<G> = Input<<G as ArrangementTraits>::Curve, <G as crate::traits::BasicTraits>::Point>;

/// An arrangement that knows of each edge which of the curves that were inserted run along it, and of each curve its edges; and from
/// which curves can be removed.
///
/// It reads as the [`Arrangement`] that it has. Other observers may watch it, too: `O`.
///
/// Laws:
/// 1. After any insertions and removals, the arrangement is isomorphic to that of the inputs that are left, made by one sweep,
///    artificial vertices included. Without inputs it is empty.
/// 2. An edge is one of [`edges_of`](Self::edges_of) an input if and only if it lies on the curve, and then the input is one of
///    [`curves_of`](Self::curves_of) the edge.
///
/// What it reads from the arrangement names curves by [`CurveId`](crate::CurveId), as [`Arrangement::curves`] and
/// [`Arrangement::support`] do; its own methods name inputs by [`InputId`], [`curve`](Self::curve) too. Where a point lies,
/// [`editor`](Self::editor) tells.
///
/// For these laws, edges and vertices cannot be changed but by inputs: a point that is inserted divides an edge, and the edge is
/// whole again when the point is removed.
///
/// # Examples
///
/// ```
/// use splitstar_arrangement::history::ArrangementWithHistory;
/// use splitstar_arrangement::{models::{Segment, SegmentTraits}, topology::BoundedPlane};
///
/// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
/// let mut arrangement = ArrangementWithHistory::new(SegmentTraits, BoundedPlane);
/// let a = arrangement.insert(&segment([[0, 0], [4, 0]]));
/// let b = arrangement.insert(&segment([[2, 0], [6, 0]]));
/// let c = arrangement.insert(&segment([[3, 1], [3, -1]]));
///
/// let edges: Vec<_> = arrangement.edges_of(a).collect();
/// let inputs: Vec<Vec<_>> = edges.iter().map(|&e| arrangement.curves_of(e).collect()).collect();
/// assert_eq!(inputs, [vec![a], vec![a, b], vec![a, b]]);
///
/// arrangement.remove(c);
/// assert_eq!(arrangement.edges_of(a).count(), 2, "nothing crosses the overlap any more");
/// arrangement.remove(a);
/// let counts = arrangement.counts();
/// assert_eq!((counts.vertices, counts.edges), (2, 1));
/// arrangement.remove(b);
/// assert_eq!(arrangement.counts().vertices, 0);
/// ```
///
/// # References
/// Thesis, sections 2.3 and 2.4.4; CGAL, 2D Arrangements, section 7, "Arrangements with History" (the manual).
pub struct ArrangementWithHistory<G: ArrangementTraits, T, O = ()> {
    editor: Editor<G, T, (History, O)>,
    inputs: Vec<Option<InputOf<G>>>,
    free: Vec<InputId>,
}

impl<G: ArrangementTraits + Clone, T: Clone, O: Clone> Clone for ArrangementWithHistory<G, T, O> {
    fn clone(&self) -> Self {
        let Self { editor, inputs, free } = self;
        Self { editor: editor.clone(), inputs: inputs.clone(), free: free.clone() }
    }
}

impl<G: ArrangementTraits + fmt::Debug, T: Topology<G>, O: Observer<G, T>> fmt::Debug
    for ArrangementWithHistory<G, T, O>
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.inputs().count();
        f.debug_struct("ArrangementWithHistory")
            .field("inputs", &count)
            .field("arrangement", self.arrangement())
            .finish()
    }
}

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> Deref for ArrangementWithHistory<G, T, O> {
    type Target = Arrangement<G, T>;

    fn deref(&self) -> &Arrangement<G, T> {
        self.editor.arrangement()
    }
}

impl<G: ArrangementTraits, T: Topology<G>> ArrangementWithHistory<G, T> {
    /// The surface without curves.
    pub fn new(traits: G, topology: T) -> Self {
        Self::with_observers(traits, topology, |_| ()).expect("nobody watches")
    }

    /// Makes the arrangement of general curves, by one sweep. Their ids are 0, 1, 2 and so on.
    ///
    /// # Complexity
    /// That of [`sweep`](crate::sweep::sweep), and linear in the number of pairs of an edge and a curve on it; and that of
    /// [`Editor::new`].
    pub fn of_curves<'a>(traits: G, topology: T, curves: impl IntoIterator<Item = &'a G::Curve>) -> Self
    where
        G::Curve: 'a,
    {
        let mut arrangement = Self::new(traits, topology);
        arrangement.insert_curves(curves);
        arrangement
    }
}

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> ArrangementWithHistory<G, T, O> {
    /// The surface without curves, to be watched; `observe` gets the empty arrangement, and gives the observers.
    ///
    /// # Errors
    /// If an observer is up to date with another arrangement.
    pub fn with_observers(
        traits: G,
        topology: T,
        observe: impl FnOnce(&Arrangement<G, T>) -> O,
    ) -> Result<Self, Stale> {
        let arrangement = Arrangement::new(traits, topology);
        let observers = (History::default(), observe(&arrangement));
        let editor = Editor::with_observers(arrangement, observers)?;
        Ok(Self { editor, inputs: Vec::new(), free: Vec::new() })
    }

    /// The arrangement, as it is now.
    pub fn arrangement(&self) -> &Arrangement<G, T> {
        self.editor.arrangement()
    }

    /// The editor of the arrangement, to ask where things are.
    pub fn editor(&self) -> &Editor<G, T, (History, O)> {
        &self.editor
    }

    /// Those who watch.
    pub fn observers(&self) -> &O {
        &self.editor.observers().1
    }

    /// Those who watch, to be changed.
    pub fn observers_mut(&mut self) -> &mut O {
        &mut self.editor.observers_mut().1
    }

    /// Forgets the inputs.
    pub fn finish(self) -> (Arrangement<G, T>, O) {
        let (arrangement, (_, observers)) = self.editor.finish();
        (arrangement, observers)
    }

    fn history(&self) -> &History {
        &self.editor.observers().0
    }

    /// An input; `None` if there is none of this id.
    pub fn input(&self, id: InputId) -> Option<&Input<G::Curve, G::Point>> {
        self.inputs.get(id.index())?.as_ref()
    }

    /// A curve that was inserted; `None` if there is none of this id, or it is a point.
    pub fn curve(&self, id: InputId) -> Option<&G::Curve> {
        match self.input(id)? {
            Input::Curve(curve) => Some(curve),
            Input::Point(_) => None,
        }
    }

    /// The inputs, in the order of their ids.
    pub fn inputs(&self) -> impl Iterator<Item = (InputId, &Input<G::Curve, G::Point>)> {
        let ids = (0..).map(InputId);
        ids.zip(&self.inputs).filter_map(|(id, input)| Some((id, input.as_ref()?)))
    }

    /// The number of inputs.
    pub fn input_count(&self) -> usize {
        self.inputs.len() - self.free.len()
    }

    /// The edges along which an input runs: piece by piece as [`ArrangementTraits::make_u_monotone`] gives them, each from its
    /// min to its max end. No edges if there is no such input.
    ///
    /// Degenerate: where several pieces of one curve overlap, an edge comes several times.
    ///
    /// # Complexity
    /// Linear in the degrees of the vertices on the way.
    pub fn edges_of(&self, id: InputId) -> impl Iterator<Item = EdgeId> + '_ {
        let (history, arrangement) = (self.history(), self.arrangement());
        history.pieces_of(id).flat_map(move |piece| history.edges_of_piece(arrangement, piece))
    }

    /// The vertices at the isolated points of an input, or at the point that it is.
    pub fn points_of(&self, id: InputId) -> impl Iterator<Item = VertexId> + '_ {
        let history = self.history();
        history.pieces_of(id).filter_map(|piece| match history.piece(piece).place {
            Place::Point(v) => Some(v),
            Place::Curve { .. } | Place::Nowhere => None,
        })
    }

    /// The inputs that run along an edge, each once, in the order of their ids.
    ///
    /// # Complexity
    /// Linear in their number.
    pub fn curves_of(&self, e: EdgeId) -> impl Iterator<Item = InputId> + '_ {
        let history = self.history();
        let mut last = None;
        let inputs = history.of_edges.get(e.index()).iter().map(|&piece| history.piece(piece).input);
        inputs.filter(move |&input| last.replace(input) != Some(input))
    }

    /// The inputs that have an end at a vertex, pass there or have a point there, each once, in the order of their ids.
    ///
    /// # Panics
    /// If there never was such a vertex.
    ///
    /// # Complexity
    /// O(k log k), if k inputs run along the edges at the vertex, each counted as often as it does.
    pub fn curves_at(&self, v: VertexId) -> Vec<InputId> {
        let history = self.history();
        let points = history.of_vertices.get(v.index()).iter();
        let edges = self.arrangement().dcel().around(v).flat_map(|h| history.of_edges.get(h.edge()));
        let mut inputs: Vec<InputId> = points.chain(edges).map(|&piece| history.piece(piece).input).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }
}
