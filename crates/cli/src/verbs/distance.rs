//! `splitstar distance`.

use super::common_unit;
use super::sum::convex;
use crate::args::{Place, Run};
use crate::console::Console;
use crate::failure::Failure;
use crate::input::{self, Operand};
use crate::output;
use crate::placed::{Found, NumberedFeature};
use splitstar::exact::{Integer, Point3, Quaternion, Rational};
use splitstar::formats::{self, FilePlacement, ReadError};
use splitstar::polytope::Polytope;
use splitstar::proximity::{Feature, Pair, Relation, RelativePlacement, Translation, Witness};
use std::collections::HashMap;

/// How many placements pass between two words to the console.
const STRIDE: usize = 256;

pub(crate) fn distance(run: &Run) -> Result<(), Failure> {
    let placing = &run.placing;
    // The operands, perhaps a path, the work.
    let mut console = Console::new(run.quiet, run.operands.len() + usize::from(placing.path.is_some()) + 1);
    let operands: Vec<Operand> =
        run.operands.iter().map(|place| Operand::read(place, &console)).collect::<Result<_, _>>()?;
    operands.iter().for_each(|operand| operand.tell_notes(&console));
    let path = placing.path.as_ref().map(|place| read_path(place, &console)).transpose()?;
    console.step(run.verb.name());
    common_unit(&operands)?;
    let [a, b] = &operands[..] else { unreachable!("two operands were asked for") };
    let [a, b] = [Numbered::new(a, run, &console)?, Numbered::new(b, run, &console)?];
    let is_single = path.is_none();
    let placements = path.unwrap_or_else(|| {
        let zero = || [0; 3].map(Rational::from);
        let translation = Point3::from_rationals(&placing.translation.clone().unwrap_or_else(zero));
        let rotation = placing.turn.as_ref().map(|q| {
            Box::new(Quaternion::from_rationals(q).expect("a quaternion that is zero is refused before"))
        });
        vec![FilePlacement { translation, rotation }]
    });
    let mut player = Player::new(&a, &b, placing.along.as_ref());
    let mut text = String::new();
    for (number, placement) in placements.iter().enumerate() {
        if number.is_multiple_of(STRIDE) {
            console.step_at(run.verb.name(), number, placements.len());
        }
        let found = player.place(placement);
        text += &match (run.json, is_single) {
            (true, _) => found.json(),
            (false, true) => found.table(),
            (false, false) => found.line(),
        };
    }
    console.close();
    output::report(&text)
}

/// Reads the placements of a file or of standard input.
fn read_path(place: &Place, console: &Console) -> Result<Vec<FilePlacement>, Failure> {
    let check = |start: &[u8], file_name: Option<&str>| -> Result<(), ReadError> {
        input::check_lines(start, formats::read_placements(start, file_name))
    };
    let bytes = input::bytes(place, console, check)?;
    let name = place.shown();
    let placements = formats::read_placements(&bytes, place.file_name().as_deref());
    let placements = placements.map_err(|error| Failure::read(&name, &error))?;
    if placements.is_empty() {
        console.note(&name, None, "the file has no placement");
    }
    console.step_done();
    Ok(placements)
}

/// A polytope whose vertices have the numbers of its file.
struct Numbered {
    polytope: Polytope,
    numbers: Vec<usize>,
}

impl Numbered {
    fn new(operand: &Operand, run: &Run, console: &Console) -> Result<Self, Failure> {
        let polytope = convex(operand, run, console)?;
        let first = operand.read.format.first_index() as usize;
        let mut known = HashMap::new();
        for (number, point) in operand.mesh()?.points.iter().enumerate() {
            known.entry(point.canonical_key()).or_insert(number + first);
        }
        let number = |point: &Point3| known[&point.canonical_key()];
        let numbers = polytope.points().iter().map(number).collect();
        Ok(Self { polytope, numbers })
    }

    fn feature(&self, feature: Feature) -> NumberedFeature {
        let mesh = self.polytope.mesh();
        let number = |vertex: splitstar::polytope::VertexId| self.numbers[vertex.index()];
        match feature {
            Feature::Vertex(v) => NumberedFeature::Vertex([number(v)]),
            Feature::Edge(h) => NumberedFeature::Edge([mesh.source(h), mesh.target(h)].map(number)),
            Feature::Facet(f) => NumberedFeature::Facet(self.polytope.facet_cycle(f).map(number).collect()),
        }
    }
}

/// Two polytopes, and where the last question about them has ended.
struct Player<'a> {
    a: &'a Numbered,
    b: &'a Numbered,
    /// What is known as long as the second is not turned; made when it is needed.
    sum: Option<RelativePlacement>,
    pair: Pair<'a>,
    along: Option<&'a [Rational; 3]>,
    last: Option<Witness>,
}

impl<'a> Player<'a> {
    fn new(a: &'a Numbered, b: &'a Numbered, along: Option<&'a [Rational; 3]>) -> Self {
        Self { a, b, sum: None, pair: Pair::new(&a.polytope, &b.polytope), along, last: None }
    }

    /// Asks everything about one placement.
    fn place(&mut self, placement: &FilePlacement) -> Found {
        let s = Translation::new(&placement.translation.coordinates());
        let rotation = placement.rotation.as_deref().filter(|rotation| {
            let [_, x, y, z] = rotation.components();
            ![x, y, z].into_iter().all(Integer::is_zero)
        });
        // A direction with integers, and how many times it is the one that was asked for.
        let along = self.along.map(|along| {
            let direction = Point3::ORIGIN.direction_to(&Point3::from_rationals(along));
            let axis =
                along.iter().position(|c| !c.is_zero()).expect("a direction of zero is refused before");
            let times = Rational::from(direction.coordinate(axis)).checked_div(&along[axis]);
            (direction, times.expect("the coordinate is not zero"))
        });
        let hint = self.last;
        let (separation, penetration, depth) = match rotation {
            None => {
                let sum = self
                    .sum
                    .get_or_insert_with(|| RelativePlacement::new(&self.a.polytope, &self.b.polytope));
                (
                    sum.separation(&s, hint),
                    sum.minimum_penetration(&s, hint),
                    along.as_ref().map(|(direction, _)| sum.directional_penetration(&s, direction, hint)),
                )
            }
            Some(_) => {
                let pair = &self.pair;
                (
                    pair.separation(&s, rotation, hint),
                    pair.minimum_penetration(&s, rotation, hint),
                    along
                        .as_ref()
                        .map(|(direction, _)| pair.directional_penetration(&s, rotation, direction, hint)),
                )
            }
        };
        self.last = Some(separation.witness());
        let depth = depth.map(|depth| depth.expect("the direction is not zero").depth());
        let features = penetration.as_ref().map_or_else(|| separation.features(), |found| found.features());
        Found {
            relation: match separation.relation() {
                Relation::Disjoint => "disjoint",
                Relation::Touching => "touching",
                Relation::Overlapping => "overlapping",
            },
            squared_distance: separation.squared_distance(),
            penetration: penetration.map(|found| (found.squared_depth(), found.direction().coordinates())),
            along: along.zip(depth).map(|((_, times), depth)| depth * times),
            closest: separation.closest_points(),
            features: [self.a.feature(features[0]), self.b.feature(features[1])],
        }
    }
}
