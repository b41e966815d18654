//! The rows of the table: who asks what along which placements, and how long it may take us.

use super::super::pairs::Operand;

/// What is asked of a placement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Query {
    /// The distance of disjoint polytopes.
    Distance,
    /// Whether they meet, of placements of every kind.
    Relation,
    /// The least depth of overlapping polytopes.
    Penetration,
}

impl Query {
    /// As the drivers call it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Relation => "relation",
            Self::Penetration => "penetration",
        }
    }
}

/// How one placement follows the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// In steps of a thousandth of the diameter.
    Coherent,
    /// Uniform in a sphere of one and a half diameters.
    Random,
}

impl Order {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Coherent => "coherent",
            Self::Random => "random",
        }
    }
}

/// Another program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Peer {
    Parry,
    Coal,
}

impl std::fmt::Display for Peer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Parry => "parry3d-f64",
            Self::Coal => "coal",
        })
    }
}

/// A geodesic sphere and another one that is turned, and what is asked of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// The frequency of both spheres.
    pub(super) frequency: usize,
    pub(super) query: Query,
    pub(super) order: Order,
    /// Our processor nanoseconds a query are at most this.
    pub(super) reach: f64,
}

impl Row {
    pub(super) fn name(&self) -> String {
        let vertices = 10 * self.frequency * self.frequency + 2;
        format!("{}-{}-{vertices}", self.query.name(), self.order.name())
    }

    pub(super) fn operands(&self) -> [Operand; 2] {
        operands(self.frequency)
    }
}

/// A geodesic sphere of that frequency, and one that is turned.
pub(super) fn operands(frequency: usize) -> [Operand; 2] {
    [Operand::Sphere(frequency), Operand::TurnedSphere(frequency)]
}

/// All rows: for each query and order, both sizes.
pub(super) fn rows() -> Vec<Row> {
    let reaches = [
        (Query::Distance, Order::Coherent, [500.0, 700.0]),
        (Query::Distance, Order::Random, [1_200.0, 3_000.0]),
        (Query::Relation, Order::Coherent, [150.0, 250.0]),
        (Query::Relation, Order::Random, [600.0, 1_500.0]),
        (Query::Penetration, Order::Coherent, [4_000.0, 12_000.0]),
        (Query::Penetration, Order::Random, [6_000.0, 20_000.0]),
    ];
    let of = |(query, order, reaches): (Query, Order, [f64; 2])| {
        [4, 16].into_iter().zip(reaches).map(move |(frequency, reach)| Row { frequency, query, order, reach })
    };
    reaches.into_iter().flat_map(of).collect()
}
