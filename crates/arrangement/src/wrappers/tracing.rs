//! What is asked and what is answered, call by call.

use super::{Method, Watch, WatchedTraits};
use std::fmt::{self, Debug};

/// The traits of any model, which tell a sink of every call.
///
/// ```
/// use splitstar_arrangement::traits::BasicTraits;
/// use splitstar_arrangement::wrappers::{Call, TracingTraits};
/// use std::sync::Mutex;
///
/// fn trace_of_comparison<G: BasicTraits>(traits: G, p: &G::Point, q: &G::Point) -> Vec<String> {
///     let lines = Mutex::new(Vec::new());
///     let traced = TracingTraits::new(traits, |call: &Call<'_>| lines.lock().unwrap().push(call.to_string()));
///     traced.compare_uv(p, q);
///     lines.into_inner().unwrap()
/// }
/// ```
pub type TracingTraits<G, S> = WatchedTraits<G, Tracer<S>>;

impl<G, S: Sink> TracingTraits<G, S> {
    /// Wraps the traits of a model.
    pub fn new(traits: G, sink: S) -> Self {
        Self { traits, watch: Tracer(sink) }
    }

    /// The sink.
    pub fn sink(&self) -> &S {
        &self.watch.0
    }
}

/// A call of a method, which has been answered. Its text is one line, `method(argument, ...) = answer`.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Call<'a> {
    /// The method.
    pub method: Method,
    /// The arguments, without the buffer to which the method appends. A curve that has no text is `_`.
    pub arguments: &'a [&'a dyn Debug],
    /// The answer, or what was appended to the buffer.
    pub answer: &'a dyn Debug,
}

impl fmt::Display for Call<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}(", self.method)?;
        for (i, argument) in self.arguments.iter().enumerate() {
            write!(f, "{}{argument:?}", if i == 0 { "" } else { ", " })?;
        }
        write!(f, ") = {:?}", self.answer)
    }
}

/// Where a trace goes. Functions of a call are sinks; one that writes somewhere brings its own lock.
pub trait Sink: Send + Sync {
    /// Takes one call.
    fn take(&self, call: &Call<'_>);
}

impl<F: Fn(&Call<'_>) + Send + Sync> Sink for F {
    fn take(&self, call: &Call<'_>) {
        self(call);
    }
}

/// Hands every call to a sink.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tracer<S>(S);

impl<S: Sink> Watch for Tracer<S> {
    fn watch(&self, method: Method, arguments: &[&dyn Debug], answer: &dyn Debug) {
        self.0.take(&Call { method, arguments, answer });
    }
}
