//! Command lines and what they say.

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
fn a_placement_may_be_negative() {
    let placing = run("distance a b --move-b -1,-1/2,3 --quat-b -1,0,0,1 --along=0,-1,0").placing;
    assert_eq!(placing.translation.unwrap().map(|c| c.to_string()), ["-1", "-1/2", "3"]);
    assert_eq!(placing.turn.unwrap().map(|c| c.to_string()), ["-1", "0", "0", "1"]);
    assert_eq!(placing.along.unwrap().map(|c| c.to_string()), ["0", "-1", "0"]);
    assert!(placing.path.is_none());
    assert_eq!(run("distance a b --path -").placing.path, Some(Place::Standard));
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
        (
            "",
            "a verb is missing: sum, hull, info, convert, distance, arrange, locate or gauss; see `splitstar --help`",
        ),
        (
            "add a b",
            "unknown verb `add`; the verbs are sum, hull, info, convert, distance, arrange, locate and gauss, see `splitstar --help`",
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
            "sum: unknown method `fast`: overlay, sgm, cgm, lp, hull; see `splitstar sum --help`",
        ),
        (
            "gauss a -o b.off",
            "gauss: a Gaussian map is not written as `.off`; use .star or .svg, each also with .gz, or --format: \
             star or svg; see `splitstar gauss --help`",
        ),
        (
            "gauss a --cubical --identification 1,0",
            "gauss: `--cubical` and `--identification` exclude each other: a cube is not cut open; \
             see `splitstar gauss --help`",
        ),
        (
            "gauss a -o b.svg --view globe --cubical",
            "gauss: `--cubical` and `--view` exclude each other: the sides of a cube are unfolded; \
             see `splitstar gauss --help`",
        ),
        (
            "gauss a -o b.star --view globe",
            "gauss: `--view` says how a picture looks, and none is written: -o OUT.svg; \
             see `splitstar gauss --help`",
        ),
        (
            "gauss a --format svg",
            "gauss: `--format` says what to write, and where is missing: -o OUT; see `splitstar gauss --help`",
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
            "distance a",
            "distance: the files of two polytopes expected, 1 given; see `splitstar distance --help`",
        ),
        (
            "distance a b c",
            "distance: the files of two polytopes expected, 3 given; see `splitstar distance --help`",
        ),
        ("distance a b -o c", "distance: unknown option `-o`; see `splitstar distance --help`"),
        (
            "distance a - --path -",
            "distance: standard input `-` can be read once only; see `splitstar distance --help`",
        ),
        (
            "distance a b --path c --move-b 1,2,3",
            "distance: `--path` has all placements, and excludes `--move-b` and `--quat-b`; \
             see `splitstar distance --help`",
        ),
        (
            "distance a b --quat-b 0,0,0,0",
            "distance: the quaternion of `--quat-b` is zero; 1,0,0,0 does not rotate; \
             see `splitstar distance --help`",
        ),
        (
            "distance a b --along 0,0,0",
            "distance: the direction of `--along` is zero; give another one, such as 1,0,0; \
             see `splitstar distance --help`",
        ),
        (
            "distance a b --move-b 1,2",
            "distance: `--move-b 1,2`: 2 numbers given, X,Y,Z expected; see `splitstar distance --help`",
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
