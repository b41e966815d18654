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
/// Linear: two determinants per constraint, degree 3; degree 4 where constraints have parallel d'.
///
/// # References
/// K. Fukuda: From the zonotope construction to the Minkowski addition of convex polytopes, 2004;
/// thesis, section 3.6.
pub(super) fn solve<'a>(
    axis: &Vector3,
    constraints: impl IntoIterator<Item = (usize, &'a Vector3)>,
) -> Program {
    use Sign::{Negative, Positive, Zero};
    type Named<'a> = (usize, &'a Vector3);
    let mut cone: Option<[Named<'a>; 2]> = None;
    for new in constraints {
        let Some([right, left]) = &mut cone else {
            if axis.cross(new.1).is_zero() {
                return Program::Infeasible;
            }
            cone = Some([new, new]);
            continue;
        };
        let from_right = predicate::orientation(axis, right.1, new.1);
        let to_left = predicate::orientation(axis, new.1, left.1);
        match (from_right, to_left) {
            // Between the two.
            (Positive, Positive) => {}
            (Positive, Negative) => *left = new,
            (Negative, Positive) => *right = new,
            (Zero, Positive) => *right = farther(axis, *right, new),
            (Positive, Zero) => *left = farther(axis, *left, new),
            // Opposite to the angle, or to one of its sides.
            (Negative, Negative | Zero) | (Zero, Negative) => return Program::Infeasible,
            // Both sides are one and d' is parallel to it, or d' is zero.
            (Zero, Zero) => match predicate::same_direction(&axis.cross(right.1), &axis.cross(new.1)) {
                Positive => {
                    *right = farther(axis, *right, new);
                    *left = *right;
                }
                _ => return Program::Infeasible,
            },
        }
    }
    match cone {
        None => Program::Free,
        Some([right, left]) => Program::Feasible { right: right.0, left: left.0 },
    }
}

/// Of two vectors in one half-plane through the axis, the one that encloses the greater angle with it;
/// the first if the angles are equal.
fn farther<'a>(
    axis: &Vector3,
    first: (usize, &'a Vector3),
    second: (usize, &'a Vector3),
) -> (usize, &'a Vector3) {
    let turn = first.1.cross(second.1);
    match predicate::same_direction(&axis.cross(first.1), &turn) {
        Sign::Positive => second,
        _ => first,
    }
}
