//! Families of curves that implement the [geometry traits](crate::traits).
//!
//! | model | curves | refinements |
//! |---|---|---|
//! | [`polycurve`] | chains of the curves of another model, polylines among them | those of the other model, and directional |

pub mod polycurve;
