//! The command line, from words to values. Knows every verb and option; opens nothing.

mod check;
mod names;
mod verb;

use check::check;
pub(crate) use names::{CellEncoding, CellFormat, Method, Ray, Strategy, Surface, View};
pub(crate) use verb::Verb;

use crate::failure::Failure;
use lexopt::Arg;
use lexopt::prelude::*;
use names::{cells_of_name, encoding_of_name, format_names};
use splitstar::exact::{Rational, Sign};
use splitstar::formats::{Encoding, Format, Unit};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// What to do.
#[derive(Debug)]
pub(crate) enum Command {
    Help(Option<Verb>),
    Version,
    Run(Box<Run>),
}

/// A verb with its operands and options. Options that the verb does not have are at their defaults.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) verb: Verb,
    pub(crate) operands: Vec<Place>,
    /// Set for every verb that writes.
    pub(crate) output: Option<Place>,
    pub(crate) json: bool,
    pub(crate) quiet: bool,
    /// Asked for by name; otherwise the ending of the output's name decides.
    pub(crate) format: Option<Encoding>,
    pub(crate) float: bool,
    pub(crate) lossy: bool,
    pub(crate) unit: Option<Unit>,
    pub(crate) join: bool,
    pub(crate) hull: bool,
    pub(crate) method: Method,
    pub(crate) motion: Motion,
    pub(crate) triangulate: bool,
    pub(crate) surface: Option<Surface>,
    /// The periods of a torus, both positive.
    pub(crate) period: Option<[Rational; 2]>,
    /// Where the sphere is cut open: the horizontal direction of a half circle from pole to pole, not zero.
    pub(crate) identification: Option<[Rational; 2]>,
    /// How a picture shows the sphere.
    pub(crate) view: Option<View>,
    /// What an arrangement is written as, asked for by name.
    pub(crate) cells: Option<CellEncoding>,
    /// How cells are found, asked for by name.
    pub(crate) strategy: Option<Strategy>,
    /// What is asked: what a ray meets, and not where a point lies.
    pub(crate) ray: Option<Ray>,
    /// The map on the sides of a cube, and not the one on the sphere.
    pub(crate) cubical: bool,
    pub(crate) placing: Placing,
}

/// Where the second of two polytopes is.
#[derive(Debug, Default)]
pub(crate) struct Placing {
    /// The quaternion by which it is turned about the origin first, not zero.
    pub(crate) turn: Option<[Rational; 4]>,
    pub(crate) translation: Option<[Rational; 3]>,
    /// A direction in which it is to be moved, not zero.
    pub(crate) along: Option<[Rational; 3]>,
    /// A file of placements, which stands for the first two.
    pub(crate) path: Option<Place>,
}

/// A file, or a standard stream.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Place {
    Standard,
    File(PathBuf),
}

/// The parts of a motion, in the order in which they are applied.
#[derive(Debug, Default)]
pub(crate) struct Motion {
    pub(crate) scale: Option<Rational>,
    pub(crate) reflect: bool,
    pub(crate) rotation: Option<Rotation>,
    pub(crate) translate: Option<[Rational; 3]>,
}

#[derive(Debug)]
pub(crate) enum Rotation {
    Axis { axis: [Rational; 3], degrees: Rational },
    Quaternion([Rational; 4]),
}

/// Reads the words after the program's name.
pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Command, Failure> {
    let mut parser = lexopt::Parser::from_args(words);
    match parser.next().map_err(|error| lexical(&error, None))? {
        None => {
            Err(Failure::usage(format!("a verb is missing: {}; see `splitstar --help`", Verb::names("or"))))
        }
        Some(Short('h') | Long("help")) => Ok(Command::Help(None)),
        Some(Short('V') | Long("version")) => Ok(Command::Version),
        Some(Value(word)) if word == "help" => match parser.next().map_err(|error| lexical(&error, None))? {
            Some(Value(word)) => Ok(Command::Help(Some(verb(&word)?))),
            _ => Ok(Command::Help(None)),
        },
        Some(Value(word)) => parse_run(verb(&word)?, &mut parser),
        Some(argument) => {
            let shown = shown(&argument);
            Err(Failure::usage(format!("`{shown}` before the verb; see `splitstar --help`")))
        }
    }
}

fn verb(word: &OsStr) -> Result<Verb, Failure> {
    Verb::from_name(word).ok_or_else(|| {
        Failure::usage(format!(
            "unknown verb `{}`; the verbs are {}, see `splitstar --help`",
            word.to_string_lossy(),
            Verb::names("and")
        ))
    })
}

fn parse_run(verb: Verb, parser: &mut lexopt::Parser) -> Result<Command, Failure> {
    let mut run = Run {
        verb,
        operands: Vec::new(),
        output: None,
        json: false,
        quiet: false,
        format: None,
        float: false,
        lossy: false,
        unit: None,
        join: false,
        hull: false,
        method: Method::default(),
        motion: Motion::default(),
        triangulate: false,
        surface: None,
        period: None,
        identification: None,
        view: None,
        cells: None,
        strategy: None,
        ray: None,
        cubical: false,
        placing: Placing::default(),
    };
    let mut given: Vec<&'static str> = Vec::new();
    while let Some(argument) = parser.next().map_err(|error| lexical(&error, Some(verb)))? {
        let name = match &argument {
            Value(word) => {
                run.operands.push(place(word));
                continue;
            }
            Short('h') | Long("help") => return Ok(Command::Help(Some(verb))),
            Short('V') | Long("version") => return Ok(Command::Version),
            Short('o') => "output",
            Short('q') => "quiet",
            Short(_) => "",
            Long(name) => name,
        };
        let Some(&option) = verb.options().iter().find(|option| **option == name) else {
            return Err(usage(verb, format!("unknown option `{}`", shown(&argument))));
        };
        if given.contains(&option) {
            return Err(usage(verb, format!("`{}` is given twice", shown(&argument))));
        }
        given.push(option);
        set(&mut run, option, parser)?;
    }
    check(&run, &given)?;
    Ok(Command::Run(Box::new(run)))
}

fn set(run: &mut Run, option: &'static str, parser: &mut lexopt::Parser) -> Result<(), Failure> {
    let verb = run.verb;
    let mut value = || parser.value().map_err(|error| lexical(&error, Some(verb)));
    match option {
        "output" => {
            let word = value()?;
            if word.is_empty() {
                return Err(usage(
                    verb,
                    "the name behind -o is empty; name a file, or - for standard output",
                ));
            }
            run.output = Some(place(&word));
        }
        "format" if matches!(verb, Verb::Arrange | Verb::Gauss) => {
            let word = value()?;
            run.cells = Some(word.to_str().and_then(CellEncoding::from_name).ok_or_else(|| {
                usage(
                    verb,
                    format!("unknown format `{}`: star or svg, each also with .gz", word.to_string_lossy()),
                )
            })?);
        }
        "format" => {
            let word = value()?;
            run.format = Some(word.to_str().and_then(Encoding::from_name).ok_or_else(|| {
                usage(verb, format!("unknown format `{}`: {}", word.to_string_lossy(), format_names()))
            })?);
        }
        "unit" => {
            let word = value()?;
            run.unit = Some(word.to_str().and_then(Unit::from_name).ok_or_else(|| {
                let names = Unit::ALL.map(Unit::name).join(", ");
                usage(verb, format!("unknown unit `{}`: {names}", word.to_string_lossy()))
            })?);
        }
        "method" => {
            let word = value()?;
            run.method = word.to_str().and_then(Method::from_name).ok_or_else(|| {
                let names = Method::ALL.map(Method::name).join(", ");
                usage(verb, format!("unknown method `{}`: {names}", word.to_string_lossy()))
            })?;
        }
        "scale" => {
            let [scale] = numbers(verb, "--scale", "S", &value()?)?;
            if scale.is_zero() {
                return Err(usage(verb, "`--scale 0` makes a point of everything; give another number"));
            }
            run.motion.scale = Some(scale);
        }
        "rotate" => {
            let [x, y, z, degrees] = numbers(verb, "--rotate", "AX,AY,AZ,DEG", &value()?)?;
            let axis = [x, y, z];
            if axis.iter().all(Rational::is_zero) {
                return Err(usage(verb, "the axis of `--rotate` is zero; give a direction"));
            }
            run.motion.rotation = Some(Rotation::Axis { axis, degrees });
        }
        "quat" => {
            let quaternion = not_zero(verb, "--quat", "W,X,Y,Z", &value()?, QUATERNION_ZERO)?;
            run.motion.rotation = Some(Rotation::Quaternion(quaternion));
        }
        "quat-b" => {
            let quaternion = not_zero(verb, "--quat-b", "W,X,Y,Z", &value()?, QUATERNION_ZERO)?;
            run.placing.turn = Some(quaternion);
        }
        "move-b" => run.placing.translation = Some(numbers(verb, "--move-b", "X,Y,Z", &value()?)?),
        "along" => {
            let zero = "the direction of `--along` is zero; give another one, such as 1,0,0";
            run.placing.along = Some(not_zero(verb, "--along", "X,Y,Z", &value()?, zero)?);
        }
        "path" => {
            let word = value()?;
            if word.is_empty() {
                return Err(usage(
                    verb,
                    "the name behind --path is empty; name a file, or - for standard input",
                ));
            }
            run.placing.path = Some(place(&word));
        }
        "translate" => run.motion.translate = Some(numbers(verb, "--translate", "X,Y,Z", &value()?)?),
        "surface" => {
            let word = value()?;
            run.surface = Some(word.to_str().and_then(Surface::from_name).ok_or_else(|| {
                let word = word.to_string_lossy();
                usage(verb, format!("unknown surface `{word}`: plane, torus or sphere"))
            })?);
        }
        "view" => {
            let word = value()?;
            run.view = Some(word.to_str().and_then(View::from_name).ok_or_else(|| {
                usage(verb, format!("unknown view `{}`: globe or unfolded", word.to_string_lossy()))
            })?);
        }
        "identification" => {
            let zero = "`--identification 0,0` is no direction; give another one, such as -1,0";
            let direction = not_zero(verb, "--identification", "X,Y", &value()?, zero)?;
            run.identification = Some(direction);
        }
        "strategy" => {
            let word = value()?;
            run.strategy = Some(word.to_str().and_then(Strategy::from_name).ok_or_else(|| {
                let names = Strategy::ALL.map(Strategy::name).join(", ");
                usage(verb, format!("unknown strategy `{}`: {names}", word.to_string_lossy()))
            })?);
        }
        "ray" => {
            let word = value()?;
            run.ray = Some(word.to_str().and_then(Ray::from_name).ok_or_else(|| {
                usage(verb, format!("unknown direction `{}` of a ray: up or down", word.to_string_lossy()))
            })?);
        }
        "period" => {
            let period: [Rational; 2] = numbers(verb, "--period", "P,Q", &value()?)?;
            if period.iter().any(|period| period.sign() != Sign::Positive) {
                return Err(usage(verb, "a period of `--period` is not larger than 0; give two that are"));
            }
            run.period = Some(period);
        }
        "reflect" => run.motion.reflect = true,
        "triangulate" => run.triangulate = true,
        "hull" => run.hull = true,
        "cubical" => run.cubical = true,
        "float" => run.float = true,
        "lossy" => run.lossy = true,
        "join" => run.join = true,
        "json" => run.json = true,
        "quiet" => run.quiet = true,
        _ => unreachable!("every option in the lists of the verbs is set here"),
    }
    Ok(())
}

impl Run {
    /// What to write: the format that was asked for, or that of the output's name.
    pub(crate) fn encoding(&self) -> Encoding {
        let by_name = || encoding_of_name(self.output.as_ref()?).ok();
        self.format.or_else(by_name).unwrap_or(Encoding::from(Format::Off))
    }

    /// What to write an arrangement as.
    pub(crate) fn cell_encoding(&self) -> CellEncoding {
        let by_name = || cells_of_name(self.output.as_ref()?, "").ok();
        self.cells.or_else(by_name).unwrap_or(CellEncoding::DEFAULT)
    }
}

fn place(word: &OsStr) -> Place {
    if word == "-" { Place::Standard } else { Place::File(word.into()) }
}

fn numbers<const N: usize>(
    verb: Verb,
    option: &str,
    shape: &str,
    value: &OsStr,
) -> Result<[Rational; N], Failure> {
    let text = value.to_string_lossy();
    let wrong = |why: String| usage(verb, format!("`{option} {text}`: {why}, {shape} expected"));
    let parsed: Vec<Rational> = text
        .split(',')
        .map(|token| token.trim().parse::<Rational>())
        .collect::<Result<_, _>>()
        .map_err(|error| wrong(error.to_string()))?;
    let count = parsed.len();
    <[Rational; N]>::try_from(parsed).map_err(|_| wrong(format!("{count} numbers given")))
}

/// What is said of a zero quaternion, with the option for `{}`.
const QUATERNION_ZERO: &str = "the quaternion of `{}` is zero; 1,0,0,0 does not rotate";

/// Numbers that are not all zero, or the usage error that says so.
fn not_zero<const N: usize>(
    verb: Verb,
    option: &str,
    shape: &str,
    value: &OsStr,
    zero: &str,
) -> Result<[Rational; N], Failure> {
    let numbers: [Rational; N] = numbers(verb, option, shape, value)?;
    if numbers.iter().all(Rational::is_zero) {
        return Err(usage(verb, zero.replace("{}", option)));
    }
    Ok(numbers)
}

fn usage(verb: Verb, sentence: impl std::fmt::Display) -> Failure {
    let name = verb.name();
    Failure::usage(format!("{name}: {sentence}; see `splitstar {name} --help`"))
}

fn lexical(error: &lexopt::Error, verb: Option<Verb>) -> Failure {
    match verb {
        Some(verb) => usage(verb, error),
        None => Failure::usage(format!("{error}; see `splitstar --help`")),
    }
}

fn shown(argument: &Arg<'_>) -> String {
    match argument {
        Short(letter) => format!("-{letter}"),
        Long(name) => format!("--{name}"),
        Value(word) => word.to_string_lossy().into_owned(),
    }
}

#[cfg(test)]
mod tests;
