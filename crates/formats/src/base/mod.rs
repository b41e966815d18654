//! What all formats share: the model, places, errors, numbers, words, and the limit on memory.

pub(crate) mod budget;
pub(crate) mod error;
pub(crate) mod float;
pub(crate) mod maker;
pub(crate) mod model;
pub(crate) mod number;
pub(crate) mod numerals;
pub(crate) mod places;
pub(crate) mod scan;
pub(crate) mod words;
