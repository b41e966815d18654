//! The pairs of operands, who runs on each, and what must be reached.

use std::path::PathBuf;

use crate::library;
use crate::shell;
use crate::solids::{self, Solid};

/// Another program that sums.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Method {
    /// CGAL, overlay of spherical Gaussian maps, exact.
    Sgm,
    /// CGAL, convex hull of all pairwise sums, exact.
    Hull,
    /// Manifold, floating point.
    Manifold,
    /// SciPy, convex hull of all pairwise sums, floating point.
    Scipy,
    /// Our own spherical maps, beside those on a cube.
    OurSgm,
}

impl Method {
    /// Whether it is a package of the Python environment.
    pub(super) fn is_python(self) -> bool {
        matches!(self, Method::Manifold | Method::Scipy)
    }
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Method::Sgm => "CGAL SGM",
            Method::Hull => "CGAL hull",
            Method::Manifold => "Manifold",
            Method::Scipy => "SciPy hull",
            Method::OurSgm => "our SGM",
        })
    }
}

/// Where an operand comes from.
#[derive(Debug, Clone, Copy)]
pub(super) enum Operand {
    /// A file of `models/convex`.
    Model(&'static str),
    /// The geodesic sphere of that frequency.
    Sphere(usize),
    /// The same, turned exactly by [`solids::TURN`].
    TurnedSphere(usize),
}

impl Operand {
    /// The file, in the repository or among the inputs that are made.
    pub(super) fn path(self) -> PathBuf {
        let made = |frequency: usize, what: &str| {
            shell::root().join(format!("peers/inputs/icosphere{}{what}.xoff", 10 * frequency * frequency + 2))
        };
        match self {
            Operand::Model(name) => shell::root().join("models/convex").join(name),
            Operand::Sphere(frequency) => made(frequency, ""),
            Operand::TurnedSphere(frequency) => made(frequency, "_turned"),
        }
    }

    /// The solid, where it is made.
    pub(super) fn solid(self) -> Option<Solid> {
        match self {
            Operand::Model(_) => None,
            Operand::Sphere(frequency) => Some(solids::geodesic_sphere(frequency)),
            Operand::TurnedSphere(frequency) => Some(solids::geodesic_sphere(frequency).turned(solids::TURN)),
        }
    }
}

/// We are `factor` times faster than the fastest of `than`.
#[derive(Debug)]
pub(super) struct Requirement {
    pub(super) factor: f64,
    pub(super) than: &'static [Method],
}

/// Two operands and who sums them.
#[derive(Debug)]
pub(super) struct Pair {
    pub(super) name: &'static str,
    pub(super) a: Operand,
    pub(super) b: Operand,
    /// How we sum.
    pub(super) by: library::Method,
    pub(super) methods: &'static [Method],
    pub(super) requirements: &'static [Requirement],
}

const fn times(factor: f64, than: &'static [Method]) -> Requirement {
    Requirement { factor, than }
}

/// All pairs, from small to large. The hull of 10,242² pairwise sums does not fit into memory.
pub(super) const PAIRS: [Pair; 7] = [
    Pair {
        name: "dp+odp",
        a: Operand::Model("dp.off"),
        b: Operand::Model("odp.xoff"),
        by: library::Method::Walk,
        methods: &[Method::Sgm, Method::Hull],
        requirements: &[times(30.0, &[Method::Sgm, Method::Hull])],
    },
    Pair {
        name: "gs4+rgs4",
        a: Operand::Model("gs4.off"),
        b: Operand::Model("rgs4.xoff"),
        by: library::Method::Walk,
        methods: &[Method::Sgm, Method::Hull],
        requirements: &[times(100.0, &[Method::Sgm])],
    },
    Pair {
        name: "el16+oel16",
        a: Operand::Model("el16.off"),
        b: Operand::Model("oel16.xoff"),
        by: library::Method::Walk,
        methods: &[Method::Sgm, Method::Hull],
        requirements: &[times(100.0, &[Method::Sgm])],
    },
    Pair {
        name: "sgm:el16+oel16",
        a: Operand::Model("el16.off"),
        b: Operand::Model("oel16.xoff"),
        by: library::Method::Sgm,
        methods: &[Method::Sgm],
        requirements: &[times(10.0, &[Method::Sgm])],
    },
    Pair {
        name: "cgm:el16+oel16",
        a: Operand::Model("el16.off"),
        b: Operand::Model("oel16.xoff"),
        by: library::Method::Cgm,
        methods: &[Method::Sgm, Method::OurSgm],
        requirements: &[times(10.0, &[Method::Sgm]), times(1.0, &[Method::OurSgm])],
    },
    Pair {
        name: "icosphere2562",
        a: Operand::Sphere(16),
        b: Operand::TurnedSphere(16),
        by: library::Method::Walk,
        methods: &[Method::Sgm, Method::Hull, Method::Manifold, Method::Scipy],
        requirements: &[times(100.0, &[Method::Sgm]), times(40.0, &[Method::Manifold])],
    },
    Pair {
        name: "icosphere10242",
        a: Operand::Sphere(32),
        b: Operand::TurnedSphere(32),
        by: library::Method::Walk,
        methods: &[Method::Sgm],
        requirements: &[times(100.0, &[Method::Sgm])],
    },
];
