//! Geometry traits made of other geometry traits: they count or trace what is asked, or carry data along curves.
//!
//! | wrapper | what it adds | points | curves |
//! |---|---|---|---|
//! | [`CountingTraits`] | a counter for each method | unchanged | unchanged |
//! | [`TracingTraits`] | tells a sink of each call, with its arguments and its answer | unchanged | unchanged |
//! | [`WatchedTraits`] | what these two are made of: any [`Watch`] | unchanged | unchanged |
//! | [`CurveDataTraits`] | curves carry data, which parts of them keep | unchanged | [`WithData`] |
//! | [`ConsolidatedTraits`] | curves carry a set of data; where curves overlap, the union of theirs | unchanged | [`WithData`] |
//!
//! Every wrapper has every refinement that the wrapped model has, and forwards every method, provided ones too, so that a faster
//! version of the model is never lost. An exception: [`ConnectTraits`](crate::models::polycurve::ConnectTraits), which makes
//! curves of nothing but points, is not for curves with data.
//!
//! Wrappers may be wrapped.

mod consolidated;
mod counting;
mod data;
mod forward;
mod method;
mod tracing;
mod watched;

pub use consolidated::{ConsolidatedTraits, DataSet, Union};
pub use counting::{Counters, CountingTraits};
pub use data::{CurveDataTraits, DataRule, FirstData, RuleOf, WithData};
pub use method::Method;
pub use tracing::{Call, Sink, Tracer, TracingTraits};
pub use watched::{Watch, WatchedTraits};
