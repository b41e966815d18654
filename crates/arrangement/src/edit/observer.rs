//! Those who watch the changes of an arrangement.

use super::{Done, EditOf, Stale, Stamp};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;

/// An operation of a user, which consists of primitive changes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Operation {
    /// A point is inserted.
    InsertPoint,
    /// An edge is inserted whose neighbours are known.
    InsertEdge,
    /// A curve is inserted wherever it runs.
    InsertCurve,
    /// An edge is split.
    SplitEdge,
    /// Two edges are merged.
    MergeEdges,
    /// Points or curves are replaced by equal ones, or by others in the same place.
    Modify,
    /// An edge is removed.
    RemoveEdge,
    /// A vertex is removed, with its edges if it has some.
    RemoveVertex,
    /// The edges of a curve are removed.
    RemoveCurve,
    /// An operation is taken back.
    Undo,
}

/// Watches the changes of an arrangement.
///
/// Every method does nothing unless it is overridden; so `()` observes nothing and costs nothing. `(A, B)`, up to four, `&mut A`,
/// `Box<A>`, `Vec<A>` and `Option<A>` observe if their parts do, all in their order; with boxes, a list at run time:
/// `Vec<Box<dyn Observer<G, T>>>`.
///
/// Laws:
/// 1. Each primitive change is told twice: [`before`](Self::before) and [`after`](Self::after), with nothing in between.
/// 2. Primitive changes lie between [`begin_operation`](Self::begin_operation) and [`end_operation`](Self::end_operation), and so do no
///    other brackets. Outside of them, the arrangement is valid. Within, an edge may be in and its face not split yet.
/// 3. Where all is replaced (aggregated insertion, numbering anew), no primitives are told, but [`before_global`](Self::before_global) and
///    [`after_global`](Self::after_global).
///
/// # Examples
///
/// Something that counts edges:
///
/// ```
/// use splitstar_arrangement::Arrangement;
/// use splitstar_arrangement::edit::{Done, EditOf, Observer};
/// use splitstar_arrangement::{topology::Topology, traits::BasicTraits};
///
/// #[derive(Default)]
/// struct EdgeCounter {
///     count: usize,
/// }
///
/// impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for EdgeCounter {
///     fn after(&mut self, _: &Arrangement<G, T>, _: &EditOf<G>, done: &Done) {
///         match done {
///             Done::Edge(_) => self.count += 1,
///             Done::Removed(_) | Done::Merged(_) => self.count -= 1,
///             _ => {}
///         }
///     }
///
///     fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
///         self.count = arrangement.dcel().edge_count();
///     }
/// }
/// ```
///
/// # References
/// Thesis, section 6.1.1.
pub trait Observer<G: BasicTraits, T: Topology<G>> {
    /// A primitive change is going to be made.
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        let _ = (arrangement, edit);
    }

    /// A primitive change was made.
    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        let _ = (arrangement, edit, done);
    }

    /// An operation begins.
    fn begin_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
        let _ = (arrangement, operation);
    }

    /// An operation is over.
    fn end_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
        let _ = (arrangement, operation);
    }

    /// All cells are going to be replaced.
    fn before_global(&mut self, arrangement: &Arrangement<G, T>) {
        let _ = arrangement;
    }

    /// All cells were replaced.
    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        let _ = arrangement;
    }

    /// Tells whether the observer can go on from this state of an arrangement.
    ///
    /// One that keeps something about the cells answers by the stamp of the state for which it has it: [`Stale::check`].
    ///
    /// # Errors
    /// If what it keeps is for another state.
    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        let _ = stamp;
        Ok(())
    }
}

/// Observes nothing.
impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for () {}

/// The methods of an observer that consists of others; `$each!` calls a method on all of them.
macro_rules! forward_to {
    ($each:ident) => {
        fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
            $each!(self, before(arrangement, edit));
        }
        fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
            $each!(self, after(arrangement, edit, done));
        }
        fn begin_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
            $each!(self, begin_operation(arrangement, operation));
        }
        fn end_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
            $each!(self, end_operation(arrangement, operation));
        }
        fn before_global(&mut self, arrangement: &Arrangement<G, T>) {
            $each!(self, before_global(arrangement));
        }
        fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
            $each!(self, after_global(arrangement));
        }
    };
}

macro_rules! the_inner_one {
    ($self:ident, $method:ident ( $($argument:expr),* )) => { (**$self).$method($($argument),*) };
}

macro_rules! each_item {
    ($self:ident, $method:ident ( $($argument:expr),* )) => {
        for part in $self.iter_mut() {
            part.$method($($argument),*);
        }
    };
}

impl<G: BasicTraits, T: Topology<G>, O: Observer<G, T> + ?Sized> Observer<G, T> for &mut O {
    forward_to!(the_inner_one);

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        (**self).check_stamp(stamp)
    }
}

impl<G: BasicTraits, T: Topology<G>, O: Observer<G, T> + ?Sized> Observer<G, T> for Box<O> {
    forward_to!(the_inner_one);

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        (**self).check_stamp(stamp)
    }
}

impl<G: BasicTraits, T: Topology<G>, O: Observer<G, T>> Observer<G, T> for Vec<O> {
    forward_to!(each_item);

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        self.iter().try_for_each(|part| part.check_stamp(stamp))
    }
}

impl<G: BasicTraits, T: Topology<G>, O: Observer<G, T>> Observer<G, T> for Option<O> {
    forward_to!(each_item);

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        self.iter().try_for_each(|part| part.check_stamp(stamp))
    }
}

macro_rules! observe_by_tuple {
    ($($part:ident $place:tt),+) => {
        impl<G: BasicTraits, T: Topology<G>, $($part: Observer<G, T>),+> Observer<G, T> for ($($part,)+) {
            fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
                $(self.$place.before(arrangement, edit);)+
            }
            fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
                $(self.$place.after(arrangement, edit, done);)+
            }
            fn begin_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
                $(self.$place.begin_operation(arrangement, operation);)+
            }
            fn end_operation(&mut self, arrangement: &Arrangement<G, T>, operation: Operation) {
                $(self.$place.end_operation(arrangement, operation);)+
            }
            fn before_global(&mut self, arrangement: &Arrangement<G, T>) {
                $(self.$place.before_global(arrangement);)+
            }
            fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
                $(self.$place.after_global(arrangement);)+
            }
            fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
                $(self.$place.check_stamp(stamp)?;)+
                Ok(())
            }
        }
    };
}

observe_by_tuple!(A 0, B 1);
observe_by_tuple!(A 0, B 1, C 2);
observe_by_tuple!(A 0, B 1, C 2, D 3);
