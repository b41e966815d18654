//! Taking changes back, one by one.

mod inverse;

use super::{Done, EditOf, Observer, Operation, Stale, Stamp};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use inverse::{Pending, StepOf};

/// Records how to take changes back.
///
/// What is taken back leaves vertices, edges, halfedges and faces with the ids that they had. What may differ: which CCB has which id
/// (the CCBs of a loop that is alone on its component may be exchanged) and with which halfedge it begins; the order in which a face lists
/// its CCBs and isolated vertices; and the curves that were added stay.
///
/// Taking back is an operation of its own, [`Operation::Undo`], which is told to other observers and is not recorded here. Where all was
/// replaced, and where the recorder missed a change, the records before are dropped.
///
/// # Complexity
/// A record takes constant time and memory; but that of a removal, or of faces that are merged, is linear in the number of CCBs and isolated
/// vertices of the face that goes.
#[derive(Clone, Debug)]
pub struct Undo<G: BasicTraits> {
    steps: Vec<StepOf<G>>,
    /// Where the operations begin.
    starts: Vec<usize>,
    pending: Pending<G::Point, G::UMonotoneCurve>,
    stamp: Stamp,
    state: State,
}

/// Where the recorder is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum State {
    /// Between operations: a change is an operation of its own.
    Between,
    /// In an operation.
    Within,
    /// Between operations: the last one was given away, and nothing was changed since.
    Popped,
    /// In one that takes changes back.
    Undoing,
}

impl<G: BasicTraits> Undo<G> {
    /// Begins to record.
    pub fn new<T>(arrangement: &Arrangement<G, T>) -> Self {
        Self {
            steps: Vec::new(),
            starts: Vec::new(),
            pending: Pending::Known(Vec::new()),
            stamp: arrangement.stamp(),
            state: State::Between,
        }
    }

    /// The number of operations that can be taken back.
    pub fn operation_count(&self) -> usize {
        self.starts.len()
    }

    /// Forgets all that was recorded, and goes on with the present state of an arrangement.
    pub fn restart<T>(&mut self, arrangement: &Arrangement<G, T>) {
        *self = Self::new(arrangement);
    }

    /// Gives the last operation, which is recorded no more, to be taken back before anything else is done.
    ///
    /// Whoever takes back something else, changes something, or asks for another operation first, has lost the way back: then all
    /// records are dropped.
    pub fn pop(&mut self) -> Option<Recorded<G>> {
        if self.state == State::Popped {
            self.forget();
        }
        let start = self.starts.pop()?;
        self.state = State::Popped;
        Some(Recorded { steps: self.steps.split_off(start), stamp: self.stamp })
    }

    /// Drops all records.
    fn forget(&mut self) {
        self.steps.clear();
        self.starts.clear();
        self.state = State::Between;
    }

    /// Takes the last operation back, if there is one, and tells so. For a recorder that is not among those who are told;
    /// else: [`Undo::pop`], and [`Recorded::take_back`].
    ///
    /// # Errors
    /// If the arrangement is not in the state to which the last change led it. Then the operation is still recorded.
    #[cfg(test)]
    pub(crate) fn take_back<T: Topology<G>, O: Observer<G, T> + ?Sized>(
        &mut self,
        arrangement: &mut Arrangement<G, T>,
        observer: &mut O,
    ) -> Result<bool, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        let Some(recorded) = self.pop() else { return Ok(false) };
        recorded.take_back(arrangement, observer)?;
        self.stamp = arrangement.stamp();
        self.state = State::Between;
        Ok(true)
    }
}

/// An operation, with all that is needed to take it back.
#[derive(Clone, Debug)]
pub struct Recorded<G: BasicTraits> {
    steps: Vec<StepOf<G>>,
    stamp: Stamp,
}

impl<G: BasicTraits> Recorded<G> {
    /// Takes the operation back, and tells so. A recorder among those who are told knows that it is to record nothing of it.
    ///
    /// # Errors
    /// If the arrangement is not in the state to which the operation led it.
    ///
    /// # Complexity
    /// As of the changes that are made.
    pub(crate) fn take_back<T: Topology<G>, O: Observer<G, T> + ?Sized>(
        self,
        arrangement: &mut Arrangement<G, T>,
        observer: &mut O,
    ) -> Result<(), Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        observer.begin_operation(arrangement, Operation::Undo);
        for step in self.steps.into_iter().rev() {
            step.into_iter().for_each(|inverse| inverse.run(arrangement, observer));
        }
        observer.end_operation(arrangement, Operation::Undo);
        Ok(())
    }
}

impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for Undo<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        if self.stamp != arrangement.stamp() {
            let state = self.state;
            self.restart(arrangement);
            self.state = state;
        }
        if self.state == State::Popped {
            self.forget();
        }
        if self.state != State::Undoing {
            self.pending = Pending::of(arrangement, edit);
        }
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        self.stamp = arrangement.stamp();
        if self.state == State::Undoing {
            return;
        }
        let pending = std::mem::replace(&mut self.pending, Pending::Known(Vec::new()));
        let step = pending.inverse(edit, *done);
        if self.state == State::Between || self.starts.is_empty() {
            self.starts.push(self.steps.len());
        }
        self.steps.push(step);
    }

    fn begin_operation(&mut self, _: &Arrangement<G, T>, operation: Operation) {
        // What is taken back is the operation that was given away, or one of somebody else.
        if (operation == Operation::Undo) != (self.state == State::Popped) {
            self.forget();
        }
        if operation == Operation::Undo {
            self.state = State::Undoing;
        } else {
            self.state = State::Within;
            self.starts.push(self.steps.len());
        }
    }

    fn end_operation(&mut self, _: &Arrangement<G, T>, _: Operation) {
        // One that changed nothing is none.
        if self.state == State::Within && self.starts.last() == Some(&self.steps.len()) {
            self.starts.pop();
        }
        self.state = State::Between;
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        self.restart(arrangement);
    }

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        Stale::check(self.stamp, stamp)
    }
}
