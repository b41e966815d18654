//! Curves that carry a set of data.

use super::data::{CurveDataTraits, DataRule};
use std::cmp::Ordering;
use std::fmt::{self, Debug};
use std::sync::Arc;

/// The traits of any model, for curves that carry a set of data: where curves overlap, the union of their sets.
///
/// So an edge of an arrangement says from which curves it comes. Only curves with equal sets are merged.
///
/// # References
/// CGAL, 2D Arrangements, section 5.4.2, "The Consolidated Curve-Data Traits Class" (the manual).
pub type ConsolidatedTraits<G, D> = CurveDataTraits<G, DataSet<D>, Union>;

impl<G, D: Ord + Clone> ConsolidatedTraits<G, D> {
    /// Wraps the traits of a model.
    pub fn consolidated(traits: G) -> Self {
        Self::with_rule(traits, Union)
    }
}

/// A set of data that overlapping curves share. A copy costs nothing: the elements are shared.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DataSet<D>(Arc<[D]>);

impl<D> Default for DataSet<D> {
    fn default() -> Self {
        Self(Arc::new([]))
    }
}

impl<D: Debug> Debug for DataSet<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.0.iter()).finish()
    }
}

impl<D> DataSet<D> {
    /// The set of one element.
    pub fn single(element: D) -> Self {
        Self(Arc::new([element]))
    }

    /// The elements, each once, in their order.
    pub fn iter(&self) -> std::slice::Iter<'_, D> {
        self.0.iter()
    }

    /// The number of elements.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Tells whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<D: Ord> DataSet<D> {
    /// Tells whether an element is in the set.
    pub fn has(&self, element: &D) -> bool {
        self.0.binary_search(element).is_ok()
    }

    /// Tells whether every element of `other` is in this set.
    pub fn has_all(&self, other: &Self) -> bool {
        other.len() <= self.len() && other.iter().all(|element| self.has(element))
    }
}

impl<D: Ord + Clone> DataSet<D> {
    /// The elements of both sets.
    ///
    /// # Complexity
    /// O(n log n) comparisons for n elements; if one set contains the other, it is shared and not copied.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        if Arc::ptr_eq(&self.0, &other.0) || self.has_all(other) {
            return self.clone();
        }
        if other.has_all(self) {
            return other.clone();
        }
        let (mut a, mut b) = (self.iter().peekable(), other.iter().peekable());
        let mut union = Vec::with_capacity(self.len() + other.len());
        loop {
            let by_value = match (a.peek(), b.peek()) {
                (None, None) => break,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(x), Some(y)) => x.cmp(y),
            };
            let from_a = if by_value.is_le() { a.next() } else { None };
            let from_b = if by_value.is_ge() { b.next() } else { None };
            union.extend(from_a.or(from_b).cloned());
        }
        Self(union.into())
    }
}

impl<D: Ord> FromIterator<D> for DataSet<D> {
    fn from_iter<I: IntoIterator<Item = D>>(elements: I) -> Self {
        let mut elements: Vec<D> = elements.into_iter().collect();
        elements.sort();
        elements.dedup_by(|x, y| (*x).cmp(&*y).is_eq());
        Self(elements.into())
    }
}

impl<'a, D> IntoIterator for &'a DataSet<D> {
    type Item = &'a D;
    type IntoIter = std::slice::Iter<'a, D>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// A common piece carries the union of both sets; only curves of equal sets are merged.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Union;

impl<D: Ord + Clone + Send + Sync> DataRule<DataSet<D>> for Union {
    fn overlap(&self, a: &DataSet<D>, b: &DataSet<D>) -> DataSet<D> {
        a.union(b)
    }

    fn merge(&self, a: &DataSet<D>, b: &DataSet<D>) -> Option<DataSet<D>> {
        (a == b).then(|| a.clone())
    }
}
