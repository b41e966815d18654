//! The answers of `distance` about one placement: a table, a line, or a JSON object.

use crate::approx::approx_root;
use crate::report::one_line_of_json;
use serde::Serialize;
use splitstar::exact::{Integer, Rational};
use std::fmt::Write;

/// What is known of one placement.
pub(crate) struct Found {
    pub(crate) relation: &'static str,
    pub(crate) squared_distance: Rational,
    /// The square of the least depth, and a direction of the move that ends the overlap.
    pub(crate) penetration: Option<(Rational, [Integer; 3])>,
    pub(crate) along: Option<Rational>,
    /// The closest points of both, where the second is placed.
    pub(crate) closest: [[Rational; 3]; 2],
    pub(crate) features: [NumberedFeature; 2],
}

/// A feature by the numbers of its vertices in the file.
#[derive(Serialize, Clone)]
#[serde(rename_all = "lowercase")]
pub(crate) enum NumberedFeature {
    Vertex([usize; 1]),
    Edge([usize; 2]),
    Facet(Vec<usize>),
}

/// One of each operand.
#[derive(Serialize)]
struct Both<T> {
    a: T,
    b: T,
}

/// The object that `distance --json` prints.
#[derive(Serialize)]
struct DistanceReport {
    relation: &'static str,
    squared_distance: String,
    penetration_squared: Option<String>,
    direction: Option<[String; 3]>,
    along: Option<String>,
    closest: Both<[String; 3]>,
    witness: Both<NumberedFeature>,
}

fn shown<T: ToString>(numbers: &[T; 3]) -> [String; 3] {
    numbers.each_ref().map(T::to_string)
}

impl Found {
    /// One line.
    pub(crate) fn json(&self) -> String {
        let [a, b] = &self.closest;
        let [of_a, of_b] = self.features.clone();
        one_line_of_json(&DistanceReport {
            relation: self.relation,
            squared_distance: self.squared_distance.to_string(),
            penetration_squared: self.penetration.as_ref().map(|(squared, _)| squared.to_string()),
            direction: self.penetration.as_ref().map(|(_, direction)| shown(direction)),
            along: self.along.as_ref().map(Rational::to_string),
            closest: Both { a: shown(a), b: shown(b) },
            witness: Both { a: of_a, b: of_b },
        })
    }

    /// The relation, the square of the distance or of the depth, and the depth along a direction if one was given: one line.
    pub(crate) fn line(&self) -> String {
        let squared = self.penetration.as_ref().map_or(&self.squared_distance, |(squared, _)| squared);
        let along = self.along.as_ref().map(|along| format!(" {along}")).unwrap_or_default();
        format!("{} {squared}{along}\n", self.relation)
    }

    pub(crate) fn table(&self) -> String {
        let mut text = String::new();
        let mut row = |name: &str, value: &dyn std::fmt::Display| {
            writeln!(text, "{name:<20} {value}").expect("writing to memory does not fail");
        };
        row("relation", &self.relation);
        match &self.penetration {
            Some((squared, direction)) => {
                row("penetration", &approx_root(squared));
                row("penetration squared", squared);
                row("direction", &shown(direction).join(" "));
            }
            None => {
                row("distance", &approx_root(&self.squared_distance));
                row("squared distance", &self.squared_distance);
            }
        }
        if let Some(along) = &self.along {
            row("along", along);
        }
        for (name, point) in ["closest a", "closest b"].into_iter().zip(&self.closest) {
            row(name, &shown(point).join(" "));
        }
        for (name, feature) in ["witness a", "witness b"].into_iter().zip(&self.features) {
            row(name, &feature.shown());
        }
        text
    }
}

impl NumberedFeature {
    fn shown(&self) -> String {
        let (name, numbers): (&str, &[usize]) = match self {
            Self::Vertex(numbers) => ("vertex", numbers),
            Self::Edge(numbers) => ("edge", numbers),
            Self::Facet(numbers) => ("facet", numbers),
        };
        numbers.iter().fold(name.to_owned(), |text, number| format!("{text} {number}"))
    }
}
