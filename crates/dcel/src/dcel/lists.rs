//! Circular doubly linked lists through the records of an array: what a face has many of.
//!
//! A list is its head, or [`NONE`]; the last item is the one before the head, so items are added at the
//! end and removed anywhere in constant time.

/// No item.
pub(super) const NONE: u32 = u32::MAX;

/// The neighbours of an item in its list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Links {
    pub(super) prev: u32,
    pub(super) next: u32,
}

impl Links {
    pub(super) const NONE: Self = Self { prev: NONE, next: NONE };
}

/// A record that can be in a list.
pub(super) trait Linked {
    fn links(&self) -> Links;
    fn links_mut(&mut self) -> &mut Links;
}

/// Adds `item` at the end of the list.
pub(super) fn push_back<T: Linked>(items: &mut [T], head: &mut u32, item: u32) {
    if *head == NONE {
        *head = item;
        *items[item as usize].links_mut() = Links { prev: item, next: item };
        return;
    }
    let last = items[*head as usize].links().prev;
    *items[item as usize].links_mut() = Links { prev: last, next: *head };
    items[last as usize].links_mut().next = item;
    items[*head as usize].links_mut().prev = item;
}

/// Takes `item` out of the list.
pub(super) fn unlink<T: Linked>(items: &mut [T], head: &mut u32, item: u32) {
    let Links { prev, next } = items[item as usize].links();
    if next == item {
        *head = NONE;
    } else {
        items[prev as usize].links_mut().next = next;
        items[next as usize].links_mut().prev = prev;
        if *head == item {
            *head = next;
        }
    }
    *items[item as usize].links_mut() = Links::NONE;
}

/// The items of the list, from its head.
pub(super) fn iter<T: Linked>(items: &[T], head: u32) -> impl Iterator<Item = u32> + '_ {
    let mut at = head;
    std::iter::from_fn(move || {
        let item = (at != NONE).then_some(at)?;
        let next = items[item as usize].links().next;
        at = if next == head { NONE } else { next };
        Some(item)
    })
}
