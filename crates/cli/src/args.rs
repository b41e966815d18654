//! The command line, from words to values. Knows every verb and option; opens nothing.

use crate::failure::Failure;
use lexopt::Arg;
use lexopt::prelude::*;
use splitstar::exact::Rational;
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
}

/// A file, or a standard stream.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Place {
    Standard,
    File(PathBuf),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Verb {
    Sum,
    Hull,
    Info,
    Convert,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum Method {
    #[default]
    Overlay,
    Hull,
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

impl Verb {
    pub(crate) const ALL: [Self; 4] = [Self::Sum, Self::Hull, Self::Info, Self::Convert];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Sum => "sum",
            Self::Hull => "hull",
            Self::Info => "info",
            Self::Convert => "convert",
        }
    }

    fn options(self) -> &'static [&'static str] {
        match self {
            Self::Sum => &["output", "format", "method", "hull", "triangulate", "float", "json", "quiet"],
            Self::Hull => &["output", "format", "float", "json", "quiet"],
            Self::Info => &["json", "quiet"],
            Self::Convert => &[
                "output",
                "format",
                "unit",
                "scale",
                "reflect",
                "rotate",
                "quat",
                "translate",
                "triangulate",
                "join",
                "lossy",
                "float",
                "json",
                "quiet",
            ],
        }
    }

    fn from_name(name: &OsStr) -> Option<Self> {
        Self::ALL.into_iter().find(|verb| name == verb.name())
    }
}

/// Reads the words after the program's name.
pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Command, Failure> {
    let mut parser = lexopt::Parser::from_args(words);
    match parser.next().map_err(|error| lexical(&error, None))? {
        None => Err(Failure::usage("a verb is missing: sum, hull, info or convert; see `splitstar --help`")),
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
            "unknown verb `{}`; the verbs are sum, hull, info and convert, see `splitstar --help`",
            word.to_string_lossy()
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
            run.method = match word.to_str() {
                Some("overlay") => Method::Overlay,
                Some("hull") => Method::Hull,
                _ => {
                    let word = word.to_string_lossy();
                    return Err(usage(verb, format!("unknown method `{word}`: overlay or hull")));
                }
            };
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
            let quaternion: [Rational; 4] = numbers(verb, "--quat", "W,X,Y,Z", &value()?)?;
            if quaternion.iter().all(Rational::is_zero) {
                return Err(usage(verb, "the quaternion of `--quat` is zero; 1,0,0,0 does not rotate"));
            }
            run.motion.rotation = Some(Rotation::Quaternion(quaternion));
        }
        "translate" => run.motion.translate = Some(numbers(verb, "--translate", "X,Y,Z", &value()?)?),
        "reflect" => run.motion.reflect = true,
        "triangulate" => run.triangulate = true,
        "hull" => run.hull = true,
        "float" => run.float = true,
        "lossy" => run.lossy = true,
        "join" => run.join = true,
        "json" => run.json = true,
        "quiet" => run.quiet = true,
        _ => unreachable!("every option in the lists of the verbs is set here"),
    }
    Ok(())
}

/// What only the whole command line shows.
fn check(run: &Run, given: &[&str]) -> Result<(), Failure> {
    let verb = run.verb;
    let (least, most) = match verb {
        Verb::Sum => (2, usize::MAX),
        Verb::Hull => (1, usize::MAX),
        Verb::Info | Verb::Convert => (1, 1),
    };
    let count = run.operands.len();
    if count < least {
        let wanted = if least == 1 { "a file to read" } else { "two or more files to add" };
        return Err(usage(verb, format!("{wanted} expected, {count} given")));
    }
    if count > most {
        return Err(usage(verb, format!("one file to read expected, {count} given")));
    }
    if run.operands.iter().filter(|operand| **operand == Place::Standard).count() > 1 {
        return Err(usage(verb, "standard input `-` can be read once only"));
    }
    if verb != Verb::Info && run.output.is_none() {
        return Err(usage(verb, "where to write is missing: -o OUT, or -o - for standard output"));
    }
    if let (Some(output), None) = (&run.output, run.format) {
        encoding_of_name(output).map_err(|sentence| usage(verb, sentence))?;
    }
    if run.json && run.output == Some(Place::Standard) {
        return Err(usage(verb, "`-o -` and `--json` both want standard output; write the mesh to a file"));
    }
    if given.contains(&"rotate") && given.contains(&"quat") {
        return Err(usage(verb, "`--rotate` and `--quat` exclude each other"));
    }
    Ok(())
}

impl Run {
    /// What to write: the format that was asked for, or that of the output's name.
    pub(crate) fn encoding(&self) -> Encoding {
        let by_name = || encoding_of_name(self.output.as_ref()?).ok();
        self.format.or_else(by_name).unwrap_or(Encoding::from(Format::Off))
    }
}

/// The format by the ending of a name; OFF where a name has no ending.
fn encoding_of_name(output: &Place) -> Result<Encoding, String> {
    let Place::File(path) = output else { return Ok(Format::Off.into()) };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let Some((_, ending)) = name.rsplit_once('.') else { return Ok(Format::Off.into()) };
    Encoding::from_file_name(&name).ok_or_else(|| {
        format!("`.{ending}` is the ending of no format; use another, or --format: {}", format_names())
    })
}

fn format_names() -> String {
    format!("{}, each also with .gz", Format::ALL.map(Format::name).join(", "))
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
mod tests {
    use super::*;

    fn words(line: &str) -> Result<Command, Failure> {
        parse(line.split_whitespace().map(OsString::from))
    }

    fn run(line: &str) -> Run {
        match words(line) {
            Ok(Command::Run(run)) => *run,
            other => panic!("{line}: {other:?}"),
        }
    }

    #[test]
    fn values_may_be_negative() {
        let run = run("convert a.off -o b.off --scale -1/2 --rotate 0,-1,0,-90.5 --translate -1,2e-1,-3/4");
        assert_eq!(run.motion.scale.unwrap().to_string(), "-1/2");
        assert_eq!(run.motion.translate.unwrap().map(|c| c.to_string()), ["-1", "1/5", "-3/4"]);
        let Some(Rotation::Axis { axis, degrees }) = run.motion.rotation else { panic!("no axis") };
        assert_eq!(axis.map(|c| c.to_string()), ["0", "-1", "0"]);
        assert_eq!(degrees.to_string(), "-181/2");
    }

    #[test]
    fn options_stand_anywhere() {
        let run = run("sum --json a.off --method=hull -o out.off - -q --hull -- -b.off");
        assert_eq!(run.operands.len(), 3);
        assert_eq!(run.operands[1], Place::Standard);
        assert_eq!(run.operands[2], Place::File("-b.off".into()));
        assert_eq!(run.output, Some(Place::File("out.off".into())));
        assert_eq!(run.method, Method::Hull);
        assert!(run.json && run.quiet && run.hull && !run.float);
    }

    #[test]
    fn wrong_lines_say_why() {
        let rows = [
            ("", "a verb is missing: sum, hull, info or convert; see `splitstar --help`"),
            (
                "add a b",
                "unknown verb `add`; the verbs are sum, hull, info and convert, see `splitstar --help`",
            ),
            ("--json sum", "`--json` before the verb; see `splitstar --help`"),
            ("sum a -o c", "sum: two or more files to add expected, 1 given; see `splitstar sum --help`"),
            ("hull -o c", "hull: a file to read expected, 0 given; see `splitstar hull --help`"),
            ("info a b", "info: one file to read expected, 2 given; see `splitstar info --help`"),
            ("info a -o b", "info: unknown option `-o`; see `splitstar info --help`"),
            (
                "sum a b",
                "sum: where to write is missing: -o OUT, or -o - for standard output; see `splitstar sum --help`",
            ),
            ("sum a b -o c --rotate 1", "sum: unknown option `--rotate`; see `splitstar sum --help`"),
            ("sum a b -o", "sum: missing argument for option '-o'; see `splitstar sum --help`"),
            ("sum a b -o c --json --json", "sum: `--json` is given twice; see `splitstar sum --help`"),
            ("sum a b -o c -o d", "sum: `-o` is given twice; see `splitstar sum --help`"),
            ("sum - - -o c", "sum: standard input `-` can be read once only; see `splitstar sum --help`"),
            (
                "sum a b -o - --json",
                "sum: `-o -` and `--json` both want standard output; write the mesh to a file; \
                 see `splitstar sum --help`",
            ),
            (
                "sum a b -o c --method fast",
                "sum: unknown method `fast`: overlay or hull; see `splitstar sum --help`",
            ),
            (
                "convert a -o b --scale 0",
                "convert: `--scale 0` makes a point of everything; give another number; \
                 see `splitstar convert --help`",
            ),
            (
                "convert a -o b --translate 1,2",
                "convert: `--translate 1,2`: 2 numbers given, X,Y,Z expected; see `splitstar convert --help`",
            ),
            (
                "convert a -o b --translate 1,2,x",
                "convert: `--translate 1,2,x`: `x` is not a number, X,Y,Z expected; \
                 see `splitstar convert --help`",
            ),
            (
                "convert a -o b --rotate 0,0,0,90",
                "convert: the axis of `--rotate` is zero; give a direction; see `splitstar convert --help`",
            ),
            (
                "convert a -o b --quat 0,0,0,0",
                "convert: the quaternion of `--quat` is zero; 1,0,0,0 does not rotate; \
                 see `splitstar convert --help`",
            ),
            (
                "convert a -o b --quat 1,0,0,0 --rotate 0,0,1,90",
                "convert: `--rotate` and `--quat` exclude each other; see `splitstar convert --help`",
            ),
            (
                "sum a b -o c --json=yes",
                "sum: unexpected argument for option '--json': \"yes\"; see `splitstar sum --help`",
            ),
        ];
        for (line, message) in rows {
            match words(line) {
                Err(Failure::Usage(sentence)) => assert_eq!(sentence, message, "{line}"),
                other => panic!("{line}: {other:?}"),
            }
        }
    }

    #[test]
    fn help_and_version_win_over_the_rest() {
        assert!(matches!(words("--help"), Ok(Command::Help(None))));
        assert!(matches!(words("help"), Ok(Command::Help(None))));
        assert!(matches!(words("help info"), Ok(Command::Help(Some(Verb::Info)))));
        assert!(matches!(words("sum a -h"), Ok(Command::Help(Some(Verb::Sum)))));
        assert!(matches!(words("-V"), Ok(Command::Version)));
    }
}
