//! Standard streams, and files written whole or not at all.

use crate::{Folder, finish, model, program, run, run_with};
use std::fs;
use std::io::Write;
use std::process::Stdio;

#[test]
fn a_dash_is_standard_input_and_output() {
    let folder = Folder::new("dash");
    let [a, b] = ["convex/tetrahedron.off", "convex/cube.off"].map(model);
    let out = folder.path("out.off");
    run(&["sum", &a, &b, "-o", &out]).ok();
    let input = fs::read(&a).unwrap();
    let piped = run_with(&["sum", "-", &b, "-o", "-"], &input);
    assert!(piped.stderr.starts_with("sum (overlay): dimension 3, 16 vertices, 24 edges, 10 facets: -, "));
    assert_eq!(piped.ok(), folder.read("out.off"));
    let info = run_with(&["info", "-", "--json"], &input).json();
    assert_eq!(info["volume"], "8/3");
    assert_eq!(
        run_with(&["info", "-"], b"OFF\n1 0\n").error(1),
        "error: -:2: the file ends where the numbers of vertices, facets and edges were expected; complete it"
    );
}

#[test]
fn quiet_is_silent() {
    let folder = Folder::new("quiet");
    let file = model("invalid/facet_soup.off");
    let out = folder.path("out.off");
    for words in [
        &["sum", "--quiet", &file, &file, "-o", &out][..],
        &["hull", "-q", &file, "-o", &out],
        &["convert", "-q", &file, "-o", &out, "--rotate", "0,0,1,30", "--float"],
    ] {
        let run = run(words);
        assert_eq!(run.stderr, "", "{words:?}");
        assert_eq!(run.ok(), "", "{words:?}");
    }
    assert_eq!(run(&["info", "-q", &model("nonconvex/ring.off")]).stderr, "");
}

#[test]
fn in_a_pipe_there_is_no_bar() {
    let folder = Folder::new("no_bar");
    let cube = model("convex/cube.off");
    let run = run(&["sum", &cube, &cube, "-o", &folder.path("out.off")]);
    assert!(!run.stderr.contains(['\r', '\x1b']), "{:?}", run.stderr);
    assert_eq!(run.stderr.lines().count(), 1);
}

#[test]
fn a_file_is_written_whole_or_not_at_all() {
    let folder = Folder::new("whole");
    let cube = model("convex/cube.off");
    let kept = folder.write("kept.off", "what stood here");
    run(&["sum", &cube, &model("nonconvex/star.off"), "-o", &kept]).error(1);
    assert_eq!(folder.read("kept.off"), "what stood here");
    assert_eq!(folder.names(), ["kept.off"]);
    run(&["sum", &cube, &cube, "-o", &kept]).ok();
    assert!(folder.read("kept.off").starts_with("OFF\n8 6 12\n"));
    assert_eq!(folder.names(), ["kept.off"]);
}

#[test]
fn the_input_may_be_the_output() {
    let folder = Folder::new("in_place");
    let file = folder.write("cube.off", &fs::read_to_string(model("convex/unit_cube.off")).unwrap());
    run(&["convert", &file, "-o", &file, "--scale", "3"]).ok();
    assert_eq!(run(&["info", &file, "--json"]).json()["volume"], "27");
    assert_eq!(folder.names(), ["cube.off"]);
}

#[test]
fn what_cannot_be_written_is_refused_before_the_work() {
    let folder = Folder::new("unwritable");
    // The operand does not exist: the output is tried first.
    let message = |out: &str| run(&["hull", "no_such_file.off", "-o", out]).error(1);
    let directory = folder.path("");
    assert!(message(&directory).contains("it is a directory"), "{}", message(&directory));
    let nowhere = folder.path("none/out.off");
    assert_eq!(
        message(&nowhere),
        format!("error: {nowhere}: cannot be written: its directory does not exist; create it")
    );
    let locked = folder.write("locked.off", "kept");
    let mut permissions = fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&locked, permissions).unwrap();
    assert!(message(&locked).contains("permission denied"), "{}", message(&locked));
    assert_eq!(folder.read("locked.off"), "kept");
    assert_eq!(message(&folder.path("out.off")), "error: no_such_file.off: no such file; check the name");
    assert_eq!(folder.names(), ["locked.off"]);
}

#[test]
fn what_cannot_be_read_is_named() {
    let folder = Folder::new("unreadable");
    let directory = folder.path("");
    assert_eq!(
        run(&["info", &directory]).error(1),
        format!("error: {directory}: is a directory; give the name of a file")
    );
    assert_eq!(run(&["info", "no\nfile"]).error(1), "error: no\u{FFFD}file: no such file; check the name");
}

#[cfg(unix)]
#[test]
fn links_and_devices_stay_what_they_are() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    let folder = Folder::new("links");
    let cube = model("convex/cube.off");
    let file = folder.write("file.off", "");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.path("link.off");
    symlink(&file, &link).unwrap();
    run(&["hull", &cube, "-o", &link]).ok();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(folder.read("file.off").starts_with("OFF\n"));
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    run(&["hull", &cube, "-o", "/dev/null"]).ok();
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}

#[test]
fn a_closed_pipe_is_no_panic() {
    let cube = fs::read(model("convex/cube.off")).unwrap();
    // A report that nobody wants is no error; a mesh that is lost is.
    for (words, code) in [(&["info", "-"][..], 0), (&["hull", "-", "-o", "-", "-q"], 1)] {
        let mut command = program();
        command.args(words).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // The program still waits for its input.
        drop(child.stdout.take());
        child.stdin.take().unwrap().write_all(&cube).unwrap();
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{stderr}");
        assert!(!stderr.contains("panicked"), "{stderr}");
        assert_eq!(stderr.lines().count(), usize::try_from(code).unwrap(), "{stderr}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file_behind() {
    let folder = Folder::new("interrupt");
    let out = folder.path("out.off");
    for signal in ["-INT", "-TERM"] {
        let mut command = program();
        command.args(["hull", "-", "-o", &out]).stdin(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut input = child.stdin.take().unwrap();
        // More than a pipe holds: when all of it is taken, the program is reading. It begins like a file, or the
        // program would not read on.
        input.write_all(b"OFF\n").unwrap();
        input.write_all(&vec![b'#'; 1 << 20]).unwrap();
        let mut kill = std::process::Command::new("kill");
        kill.args([signal, &child.id().to_string()]);
        assert_eq!(finish(kill, b"").code, Some(0));
        let status = child.wait().unwrap();
        drop(input);
        assert_eq!(status.code(), Some(130), "{signal}");
        assert_eq!(folder.names(), [""; 0], "{signal}");
    }
}
