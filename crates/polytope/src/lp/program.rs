//! The linear program that tells the edges of a sum from other directions.

use exact::{Sign, Vector3, predicate};

/// The answer of a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Program {
    /// No vector satisfies all constraints.
    Infeasible,
    /// There is no constraint.
    Free,
    /// The constraints that bind; all others follow from these two.
    Feasible {
        /// The one farthest clockwise around the axis, seen from its tip.
        right: usize,
        /// The one farthest counterclockwise.
        left: usize,
    },
}

/// Solves the program: find c with c . axis = 0 and c . d < 0 for every constraint d.
///
/// The equation leaves two variables: c lives in the plane perpendicular to the axis, where each
/// constraint is an open half-plane behind its projection d'. There is a solution exactly if the d' lie
/// in an open half-plane, so in an angle below half a turn; the two that bound it bind. They are kept
/// while the constraints come one by one, in any order.
///
/// Laws:
/// 1. Positive multiples of the arguments, and multiples of the axis added to constraints, change
///    neither whether there is a solution nor the half-planes that bind.
/// 2. The order of the constraints changes at most the choice among parallel ones.
/// 3. Every prefix of a feasible list of constraints is feasible.
///
/// Degenerate: constraints in one half-plane through the axis have the same d'; the one that encloses
/// the greatest angle with the axis is given. A constraint parallel to the axis cannot be satisfied.
/// If all d' point the same way, `right` and `left` are equal.
///
/// # Complexity
/// Linear: two determinants per constraint, as products with a vector that is kept; degree 3, and degree 4
/// where constraints have parallel d'.
///
/// # References
/// K. Fukuda: From the zonotope construction to the Minkowski addition of convex polytopes, 2004;
/// thesis, section 3.6.
pub(super) fn solve<'a>(
    axis: &Vector3,
    constraints: impl IntoIterator<Item = (usize, &'a Vector3)>,
) -> Program {
    use Sign::{Negative, Positive, Zero};
    let mut constraints = constraints.into_iter();
    let Some((index, first)) = constraints.next() else { return Program::Free };
    let mut right = Side::new(axis, index, first);
    let mut left = right.clone();
    if right.normal.is_zero() {
        return Program::Infeasible;
    }
    for (index, new) in constraints {
        let from_right = predicate::side_of_circle(&right.normal, new);
        let to_left = -predicate::side_of_circle(&left.normal, new);
        match (from_right, to_left) {
            // Between the two.
            (Positive, Positive) => {}
            (Positive, Negative) => left = Side::new(axis, index, new),
            (Negative, Positive) => right = Side::new(axis, index, new),
            (Zero, Positive) => right.take_if_farther(axis, index, new),
            (Positive, Zero) => left.take_if_farther(axis, index, new),
            // Opposite to the angle, or to one of its sides.
            (Negative, Negative | Zero) | (Zero, Negative) => return Program::Infeasible,
            // Both sides are one and d' is parallel to it, or d' is zero.
            (Zero, Zero) => match predicate::same_direction(&right.normal, &axis.cross(new)) {
                Positive => {
                    right.take_if_farther(axis, index, new);
                    left = right.clone();
                }
                _ => return Program::Infeasible,
            },
        }
    }
    Program::Feasible { right: right.index, left: left.index }
}

/// A constraint that bounds the angle.
#[derive(Clone)]
struct Side<'a> {
    index: usize,
    vector: &'a Vector3,
    /// The cross product of the axis and the vector: its product with another vector is their determinant.
    normal: Vector3,
}

impl<'a> Side<'a> {
    fn new(axis: &Vector3, index: usize, vector: &'a Vector3) -> Self {
        Self { index, vector, normal: axis.cross(vector) }
    }

    /// Becomes another vector in the same half-plane through the axis, if that encloses a greater angle
    /// with it.
    fn take_if_farther(&mut self, axis: &Vector3, index: usize, other: &'a Vector3) {
        let turn = self.vector.cross(other);
        if predicate::same_direction(&self.normal, &turn) == Sign::Positive {
            *self = Self::new(axis, index, other);
        }
    }
}
