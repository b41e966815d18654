//! Where curves end: the two ends of a curve, and the sides of the parameter space.

/// One of the two ends of a u-monotone curve.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum CurveEnd {
    /// The lexicographically smaller end: the left one, or the lower one of a vertical curve.
    Min,
    /// The lexicographically greater end.
    Max,
}

impl CurveEnd {
    /// Both ends, the smaller first.
    pub const BOTH: [Self; 2] = [Self::Min, Self::Max];

    /// The other end.
    #[inline]
    pub fn opposite(self) -> Self {
        match self {
            Self::Min => Self::Max,
            Self::Max => Self::Min,
        }
    }
}

/// Where something lies along one axis of the parameter space.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub enum Along {
    /// On the side where the parameter is least, or approaching it: left for u, bottom for v.
    Low,
    /// Between the sides.
    #[default]
    Inside,
    /// On the side where the parameter is greatest, or approaching it: right for u, top for v.
    High,
}

/// Where the pre-image of a point or of a curve end lies in the parameter space.
///
/// # References
/// Thesis, section 2.5, "Parameter space in x" and "Parameter space in y".
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Location {
    /// Along u: left, between, right.
    pub u: Along,
    /// Along v: bottom, between, top.
    pub v: Along,
}

impl Location {
    /// Not on a side.
    pub const INTERIOR: Self = Self { u: Along::Inside, v: Along::Inside };

    /// Tells whether this is not on a side.
    #[inline]
    pub fn is_interior(self) -> bool {
        self == Self::INTERIOR
    }
}

/// What a side of the parameter space is on the surface.
///
/// # References
/// Thesis, section 2.2.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum SideKind {
    /// No curve reaches it, or its points are ordinary points: nothing has to be known of it.
    Closed,
    /// It is approached and never reached: curves are unbounded there.
    Open,
    /// The whole side is one point of the surface.
    Contracted,
    /// It is glued to the opposite side.
    Identified,
}

/// What the four sides of the parameter space are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Sides {
    /// The sides of least and of greatest u.
    pub u: [SideKind; 2],
    /// The sides of least and of greatest v.
    pub v: [SideKind; 2],
}

impl Sides {
    /// Four closed sides: no curve reaches a boundary.
    pub const CLOSED: Self = Self { u: [SideKind::Closed; 2], v: [SideKind::Closed; 2] };
    /// Four open sides: the whole plane.
    pub const OPEN: Self = Self { u: [SideKind::Open; 2], v: [SideKind::Open; 2] };
    /// Both pairs of opposite sides identified: a torus.
    pub const TORUS: Self = Self { u: [SideKind::Identified; 2], v: [SideKind::Identified; 2] };

    /// Tells whether a place is on a side that is one point.
    #[inline]
    pub fn is_contracted(&self, location: Location) -> bool {
        let is_on = |along, kinds: [SideKind; 2]| match along {
            Along::Low => kinds[0] == SideKind::Contracted,
            Along::Inside => false,
            Along::High => kinds[1] == SideKind::Contracted,
        };
        is_on(location.u, self.u) || is_on(location.v, self.v)
    }

    /// Tells whether the left side is glued to the right one.
    #[inline]
    pub fn is_u_identified(&self) -> bool {
        self.u[0] == SideKind::Identified
    }

    /// Tells whether the bottom side is glued to the top one.
    #[inline]
    pub fn is_v_identified(&self) -> bool {
        self.v[0] == SideKind::Identified
    }
}
