//! `splitstar locate`.

use super::counted;
use crate::args::{Place, Ray, Run, Strategy};
use crate::console::Console;
use crate::failure::{Failure, one_line};
use crate::located::{Answer, LocateReport, LocateSeconds, Located};
use crate::output;
use crate::points::{ArrangementOperand, PointOperand, Points};
use crate::report::Clock;
use splitstar::arrangement::location::{
    BatchStrategy, Landmarks, Naive, PointLocation, TrapezoidalMap, VerticalRay, Walk,
};
use splitstar::arrangement::overlay::Cell;
use splitstar::arrangement::sweep::Progress;
use splitstar::arrangement::topology::Topology;
use splitstar::arrangement::traits::{ApproxTraits, UMonotoneTraits};
use splitstar::arrangement::{Arrangement, locate_by_sweep_with};
use splitstar::formats::{self, StarArrangement};
use std::ops::ControlFlow;

pub(crate) fn locate(run: &Run) -> Result<(), Failure> {
    let [arrangement, points] = &run.operands[..] else { unreachable!("two operands were asked for") };
    if let Some(output) = &run.output {
        output::probe(output)?;
    }
    // The operands, the work, the writing.
    let mut console = Console::new(run.quiet, run.operands.len() + 2);
    let mut clock = Clock::start();
    let arrangement = ArrangementOperand::read(arrangement, points, &console)?;
    let points = PointOperand::read(points, &arrangement, &console)?;
    points.tell_notes(&console);
    points.check_period(&arrangement)?;
    let seconds = LocateSeconds { read: clock.lap(), ..LocateSeconds::default() };
    console.step(run.verb.name());
    let strategy =
        run.strategy.unwrap_or_else(|| chosen(points.points.len(), run.ray, &arrangement.arrangement));
    let mut work = Work { strategy, ray: run.ray, console: &console, clock: &mut clock, seconds };
    let cells = work.cells(&arrangement.arrangement, points.points);
    let mut seconds = work.seconds;
    let answers: Vec<Answer> = cells.iter().map(|&cell| Answer::of(cell, &arrangement.numbers)).collect();
    seconds.compute = clock.lap();
    console.step_done();
    console.step("writing");
    let mut report = LocateReport {
        strategy: strategy.name(),
        ray: run.ray.map(Ray::name),
        points: answers.len(),
        located: Located::of(&answers),
        answers,
        seconds,
    };
    if let Some(output) = &run.output {
        let lines = report.lines().into_bytes();
        output::write(output, &if output.is_packed() { formats::pack_gzip(&lines) } else { lines })?;
    }
    report.seconds.write = clock.lap();
    console.close();
    if run.json {
        return output::report(&report.json());
    }
    match &run.output {
        None => output::report(&report.lines()),
        Some(output) => {
            console.say(&summary(&report, output));
            Ok(())
        }
    }
}

/// Fewer points than this are not worth a search structure.
const FEW: usize = 16;

/// The strategy for so many points.
fn chosen(points: usize, ray: Option<Ray>, arrangement: &StarArrangement) -> Strategy {
    if ray.is_some() {
        return if points < FEW { Strategy::Naive } else { Strategy::Trapezoids };
    }
    let batch = match arrangement {
        StarArrangement::Linear(arrangement) => BatchStrategy::choose(arrangement, points),
        StarArrangement::Polycurves(arrangement) => BatchStrategy::choose(arrangement, points),
        StarArrangement::Torus(arrangement) => BatchStrategy::choose(arrangement, points),
        StarArrangement::TorusPolycurves(arrangement) => BatchStrategy::choose(arrangement, points),
        StarArrangement::Sphere(arrangement) => BatchStrategy::choose(arrangement, points),
        StarArrangement::SpherePolycurves(arrangement) => BatchStrategy::choose(arrangement, points),
        _ => unreachable!("no other arrangement is read"),
    };
    match batch {
        BatchStrategy::Naive => Strategy::Naive,
        BatchStrategy::Sweep => Strategy::Sweep,
        BatchStrategy::Trapezoids => Strategy::Trapezoids,
    }
}

/// What is asked of an arrangement, and who is told how far it has come.
struct Work<'a> {
    strategy: Strategy,
    ray: Option<Ray>,
    console: &'a Console,
    clock: &'a mut Clock,
    seconds: LocateSeconds,
}

impl Work<'_> {
    /// The cells of the points, in their order.
    fn cells(&mut self, arrangement: &StarArrangement, points: Points) -> Vec<Cell> {
        match (arrangement, points) {
            (StarArrangement::Linear(arrangement), Points::Flat(points)) => self.find(arrangement, &points),
            (StarArrangement::Polycurves(arrangement), Points::Flat(points)) => {
                self.find(arrangement, &points)
            }
            (StarArrangement::Torus(arrangement), Points::Flat(points)) => {
                let traits = arrangement.traits();
                self.find(arrangement, &points.iter().map(|point| traits.point(point)).collect::<Vec<_>>())
            }
            (StarArrangement::TorusPolycurves(arrangement), Points::Flat(points)) => {
                let traits = arrangement.traits().inner();
                self.find(arrangement, &points.iter().map(|point| traits.point(point)).collect::<Vec<_>>())
            }
            (StarArrangement::Sphere(arrangement), Points::Sphere(points)) => self.find(arrangement, &points),
            (StarArrangement::SpherePolycurves(arrangement), Points::Sphere(points)) => {
                self.find(arrangement, &points)
            }
            _ => {
                unreachable!("points are read as those of the arrangement, and no other arrangement is read")
            }
        }
    }

    fn find<G: UMonotoneTraits + ApproxTraits, T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        points: &[G::Point],
    ) -> Vec<Cell> {
        match self.strategy {
            Strategy::Naive => self.ask(arrangement, points, |_| Naive),
            Strategy::Walk => self.ask(arrangement, points, |_| Walk),
            Strategy::Landmarks => self.ask(arrangement, points, Landmarks::new),
            Strategy::Trapezoids => self.ask(arrangement, points, TrapezoidalMap::new),
            Strategy::Sweep => {
                let tell = |progress: Progress| {
                    self.console.step_at("locate", progress.sites_met, progress.sites);
                    ControlFlow::Continue(())
                };
                locate_by_sweep_with(arrangement, points, tell).expect("nobody stops the sweep")
            }
        }
    }

    /// Prepares a strategy, and asks it about some points after others.
    fn ask<G: UMonotoneTraits, T: Topology<G>, S: PointLocation<G, T>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        points: &[G::Point],
        prepare: impl FnOnce(&Arrangement<G, T>) -> S,
    ) -> Vec<Cell> {
        /// How many points pass between two words to the console.
        const STRIDE: usize = 1024;
        let location = prepare(arrangement);
        self.seconds.prepare = self.clock.lap();
        let ray = self.ray.map(|ray| match ray {
            Ray::Up => VerticalRay::Up,
            Ray::Down => VerticalRay::Down,
        });
        let mut answers = Vec::with_capacity(points.len());
        for some in points.chunks(STRIDE) {
            self.console.step_at("locate", answers.len(), points.len());
            let cells = match ray {
                None => location.locate_all(arrangement, some),
                Some(ray) => some.iter().map(|point| location.shoot(arrangement, point, ray)).collect(),
            };
            answers.extend(cells.expect("nobody has edited the arrangement"));
        }
        answers
    }
}

fn summary(report: &LocateReport, output: &Place) -> String {
    let LocateSeconds { read, prepare, compute, write } = report.seconds;
    let Located { vertices, edges, faces } = report.located;
    let ray = report.ray.map(|ray| format!(", ray {ray}")).unwrap_or_default();
    format!(
        "locate ({}{ray}): {}, {vertices} on vertices, {edges} on edges, {faces} in faces: {}, {:.3} s",
        report.strategy,
        counted(report.points, ["point", "points"]),
        one_line(&output.shown()),
        read + prepare + compute + write
    )
}
