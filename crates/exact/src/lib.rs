//! Exact numbers and the decisions made with them.
//!
//! | module | what |
//! |---|---|
//! | [`Integer`], [`Rational`] | numbers of any size; text and floats are read exactly |
//! | [`Vector3`], [`Point3`], [`Plane`] | geometry in integers: the storage follows the size of each object |
//! | [`predicate`] | signs of integer polynomials, each written once, decided by a cascade of tiers |
//! | [`tier`] | the tiers and their types; counters and forcing for tests |
//! | [`filter`], [`fixed`], [`interval`] | the numbers of the tiers |
//! | [`planar`] | exact points and lines of the plane: crossings, their order, sides |
//! | [`spherical`] | exact directions and great circles of the sphere: crossings, their order, sides |
//! | [`gnomonic`] | the central projection of the sphere to the sides of a cube |
//! | [`proximity`] | one point and many planes: sides, depths |
//! | [`Quaternion`], [`Affine3`], [`Linear3`] | exact rotations and affine maps |
//!
//! No decision is made with a tolerance, and nothing is rounded except by methods called `approx_*`. This crate knows no geometry
//! beyond vectors, planes and determinants: no mesh, no file.

// The tests compare floats bit by bit on purpose, and print their seeds.
#![cfg_attr(test, allow(clippy::float_cmp, clippy::print_stderr))]

mod affine;
pub mod filter;
pub mod fixed;
mod gcd;
pub mod gnomonic;
mod integer;
pub mod interval;
mod parse;
pub mod planar;
mod plane;
mod point;
pub mod predicate;
pub mod proximity;
mod quaternion;
mod rational;
mod sign;
pub mod spherical;
mod stage;
#[cfg(test)]
mod testing;
pub mod tier;
mod trigonometry;
mod vector;

pub use affine::{Affine3, Linear3};
pub use integer::Integer;
pub use parse::{MAX_DIGITS, MAX_EXPONENT, ParseNumberError, ParseNumberErrorKind};
pub use plane::Plane;
pub use point::{Adder, Point3, PointKey, share_weight};
pub use quaternion::{Quaternion, ZeroAxis};
pub use rational::{NotFinite, Rational};
pub use sign::Sign;
pub use vector::{Vector3, Width};
