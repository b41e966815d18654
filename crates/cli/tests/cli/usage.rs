//! Wrong command lines, help, version.

use crate::{Folder, run};

#[test]
fn wrong_command_lines_end_with_code_2_and_one_line() {
    let folder = Folder::new("usage");
    let out = folder.path("out.off");
    let rows: &[(&[&str], &str)] = &[
        (&[], "a verb is missing"),
        (&["add", "a", "b"], "unknown verb `add`"),
        (&["--fast"], "`--fast` before the verb"),
        (&["sum"], "two or more files"),
        (&["sum", "a.off", "-o", &out], "two or more files"),
        (&["sum", "a.off", "b.off"], "where to write is missing"),
        (&["sum", "a.off", "b.off", "-o", &out, "--fast"], "unknown option `--fast`"),
        (&["sum", "a.off", "b.off", "-o", &out, "--join"], "unknown option `--join`"),
        (&["convert", "a.off", "-o", &out, "--format", "step"], "unknown format `step`: off, obj, stl"),
        (&["convert", "a.off", "-o", &out, "--unit", "mile"], "unknown unit `mile`: micron"),
        (&["convert", "a.off", "-o", "b.step"], "`.step` is the ending of no format"),
        (&["sum", "a.off", "b.off", "-o", "c.gz"], "`.gz` is the ending of no format"),
        (&["sum", "-", "-", "-o", &out], "read once only"),
        (&["sum", "a.off", "b.off", "-o", "-", "--json"], "both want standard output"),
        (&["hull", "a.off", "-o", "-", "--json"], "both want standard output"),
        (&["convert", "a.off", "-o", "-", "--json"], "both want standard output"),
        (&["info"], "a file to read expected"),
        (&["info", "a.off", "b.off"], "one file to read expected, 2 given"),
        (&["convert", "a.off", "-o", &out, "--scale", "0"], "--scale 0"),
        (&["convert", "a.off", "-o", &out, "--scale", "1/0"], "zero denominator"),
        (&["convert", "a.off", "-o", &out, "--rotate", "0,0,0,1"], "axis of `--rotate` is zero"),
        (&["convert", "a.off", "-o", &out, "--rotate", "0,0,1"], "3 numbers given"),
        (&["convert", "a.off", "-o", &out, "--quat", "0,0,0,0"], "quaternion of `--quat` is zero"),
        (&["convert", "a.off", "-o", &out, "--translate", "1,2,three"], "`three` is not a number"),
    ];
    for (words, expected) in rows {
        let message = run(words).error(2);
        assert!(message.contains(expected), "{words:?}: {message}");
        assert!(message.contains("splitstar"), "{words:?} has no hint: {message}");
        assert_eq!(folder.names(), [""; 0]);
    }
}

#[test]
fn a_usage_error_is_found_before_any_file_is_read() {
    let message = run(&["sum", "no_such_file.off", "--json"]).error(2);
    assert!(message.contains("two or more files"), "{message}");
}

#[test]
fn help_is_complete() {
    let general = run(&["--help"]).ok();
    assert_eq!(run(&["help"]).ok(), general);
    for verb in ["sum", "hull", "info", "convert", "distance", "arrange", "locate", "gauss"] {
        assert!(general.contains(&format!("\n  {verb} ")), "{general}");
        let help = run(&[verb, "--help"]).ok();
        assert_eq!(run(&["help", verb]).ok(), help);
        assert_eq!(run(&[verb, "no_such_file.off", "-h"]).ok(), help);
        assert!(help.contains(&format!("usage: splitstar {verb} ")), "{help}");
        assert!(help.contains(&format!("example:\n  splitstar {verb} ")), "{help}");
        assert!(help.lines().all(|line| line.len() <= 100), "{help}");
    }
    let options = [
        "--output",
        "--scale",
        "--reflect",
        "--rotate",
        "--quat",
        "--translate",
        "--triangulate",
        "--float",
        "--json",
        "--quiet",
    ];
    let convert = run(&["convert", "--help"]).ok();
    let sum = run(&["sum", "--help"]).ok();
    assert!(options.iter().all(|option| convert.contains(option)), "{convert}");
    assert!(["--method", "--hull", "--float", "--json"].iter().all(|option| sum.contains(option)), "{sum}");
}

#[test]
fn the_version_is_that_of_the_package() {
    assert_eq!(run(&["--version"]).ok(), concat!("splitstar ", env!("CARGO_PKG_VERSION"), "\n"));
}
