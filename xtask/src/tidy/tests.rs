use super::tree::{Member, Text, Tree};
use super::{checks, source};

/// A tree of two crates in which nothing is wrong.
fn good() -> Tree {
    let architecture = "\
| layer | crate | uses | from outside | absent |
|---|---|---|---|---|
| ground | `low` | | `numbers` | `*Mesh*` |
| apps | `high` | `low` | | |

| from | absent | why |
|---|---|---|
| every crate | `unsafe` | nothing needs it |
| every library | `println!` `pub f64` | libraries return values |
| every crate but `low` | `numbers::*` | newtypes |
";
    Tree {
        architecture: architecture.to_owned(),
        dependencies: "| `numbers` | `low` | because |".to_owned(),
        outside: vec!["numbers".to_owned()],
        crates: vec![member("low", &[], &["numbers"]), member("high", &["low"], &[])],
        texts: Vec::new(),
    }
}

fn member(name: &str, uses: &[&str], outside: &[&str]) -> Member {
    Member {
        name: name.to_owned(),
        manifest: format!("crates/{name}/Cargo.toml"),
        uses: uses.iter().map(|&s| s.to_owned()).collect(),
        outside: outside.iter().map(|&s| s.to_owned()).collect(),
        for_tests: vec!["testkit".to_owned()],
        takes_lints: true,
        sources: vec![text("fn nothing() {}")],
        tests: Vec::new(),
    }
}

fn text(content: &str) -> Text {
    Text { path: "some/file.rs".to_owned(), content: content.to_owned() }
}

/// What the rules say when `change` is made to the good tree.
fn after(change: impl FnOnce(&mut Tree)) -> Vec<String> {
    let mut tree = good();
    change(&mut tree);
    checks::all(&tree).iter().map(ToString::to_string).collect()
}

fn replaced(from: &str, to: &str) -> Vec<String> {
    assert!(good().architecture.contains(from), "{from}");
    after(|tree| tree.architecture = tree.architecture.replace(from, to))
}

#[test]
fn a_tidy_tree_has_no_problem() {
    assert_eq!(after(|_| ()), Vec::<String>::new());
}

#[test]
fn the_order_of_the_crates_is_one_way() {
    let upward = after(|tree| {
        tree.crates[0].uses.push("high".to_owned());
        tree.architecture = tree.architecture.replace("| ground | `low` | |", "| ground | `low` | `high` |");
    });
    assert_eq!(upward, ["ARCHITECTURE.md:3: `low` uses `high`, which does not stand above it"]);
    let unsaid = after(|tree| tree.crates[0].uses.push("high".to_owned()));
    assert_eq!(
        unsaid,
        [
            "ARCHITECTURE.md:3: crates/low/Cargo.toml depends on `high`, which is not in column *uses* of `low`"
        ]
    );
    let stale = after(|tree| tree.crates[1].uses.clear());
    assert_eq!(
        stale,
        ["ARCHITECTURE.md:4: column *uses* of `high` names `low`, but crates/high/Cargo.toml does not"]
    );
}

#[test]
fn every_crate_has_its_row() {
    let missing = after(|tree| tree.crates.push(member("new", &[], &[])));
    assert_eq!(missing, ["ARCHITECTURE.md: no row for the crate `new`"]);
    let gone = after(|tree| drop(tree.crates.pop()));
    assert_eq!(gone, ["ARCHITECTURE.md:4: there is no crate `high`"]);
    assert_eq!(
        replaced("| layer | crate | uses |", "| layer | crate | may use |"),
        ["ARCHITECTURE.md: no table with the heading `| layer | crate | uses | from outside | absent |`"]
    );
    assert_eq!(
        replaced("| ground | `low` | |", "| ground | `low` |"),
        ["ARCHITECTURE.md:3: 5 cells expected, 4 found"]
    );
    assert_eq!(
        replaced("every library", "all"),
        ["ARCHITECTURE.md:9: `every crate` or `every library` expected"]
    );
}

#[test]
fn what_is_absent_is_not_in_the_code() {
    let low = |content: &str| after(|tree| tree.crates[0].sources = vec![text(content)]);
    let high = |content: &str| after(|tree| tree.crates[1].sources = vec![text(content)]);
    let absent = |what: &str, line: usize, name: &str| {
        vec![format!("some/file.rs:{line}: `{what}` is absent from `{name}` by ARCHITECTURE.md")]
    };
    let clean = Vec::<String>::new();
    assert_eq!(low("struct PolygonMesh;"), absent("*Mesh*", 1, "low"));
    assert_eq!(high("struct PolygonMesh;"), clean);
    assert_eq!(low("fn f() {\n    println!();\n}"), absent("println!", 2, "low"));
    assert_eq!(high("fn f() { println!() }"), clean, "an app prints");
    assert_eq!(high("use numbers::Big;"), absent("numbers::*", 1, "high"));
    assert_eq!(low("use numbers::Big;"), clean, "the exception of the row");
    assert_eq!(low("pub fn f(x: f64) {}"), absent("pub f64", 1, "low"));
    assert_eq!(low("// tidy: pub f64, because it is rounded outward\npub fn f(x: f64) {}"), clean);
    assert_eq!(low("// A Mesh in a comment, \"unsafe\".\nfn f() -> &'static str { \"Mesh\" }"), clean);
    assert_eq!(low("#[cfg(test)]\nmod tests {\n    fn f() { println!() }\n}"), clean);
}

#[test]
fn manifests_lengths_reasons_and_paths() {
    let lints = after(|tree| tree.crates[0].takes_lints = false);
    assert_eq!(lints, ["crates/low/Cargo.toml: `[lints]` with `workspace = true` is missing"]);
    let for_tests = after(|tree| tree.crates[0].for_tests.push("high".to_owned()));
    assert_eq!(
        for_tests,
        [
            "crates/low/Cargo.toml: `high` is a dependency of the tests: only `testkit`, and what the crate uses, may be"
        ]
    );

    let long = "x();\n".repeat(500);
    let without_reason = after(|tree| tree.crates[0].sources = vec![text(&long)]);
    assert_eq!(without_reason.len(), 1, "{without_reason:?}");
    let with_reason =
        after(|tree| tree.crates[0].sources = vec![text(&format!("//! Long: one table.\n{long}"))]);
    assert_eq!(with_reason, Vec::<String>::new());
    let too_long = after(|tree| tree.crates[0].tests = vec![text(&"//! Long: no.\nx();\n".repeat(801))]);
    assert_eq!(too_long, ["some/file.rs: 801 lines of code: split it above 800"]);
    let comments = after(|tree| tree.crates[0].sources = vec![text(&"// x\n\n".repeat(900))]);
    assert_eq!(comments, Vec::<String>::new());
    let inline = format!("#[cfg(test)]\nmod tests {{\n{}}}\n", "x();\n".repeat(300));
    let inline = after(|tree| tree.crates[0].sources = vec![text(&inline)]);
    assert_eq!(inline, ["some/file.rs: 303 lines of unit tests: above 200 they move to a file `tests.rs`"]);

    let no_reason = after(|tree| tree.outside.push("more".to_owned()));
    assert_eq!(no_reason, ["docs/dependencies.md: no row for the dependency `more`"]);
    let stale = after(|tree| tree.outside.clear());
    assert_eq!(stale, ["docs/dependencies.md: `numbers` is not a dependency of the workspace"]);

    let folder = ["/ho", "me/me/x"].concat();
    let path = after(|tree| tree.texts.push(text(&format!("fine\nsee {folder}"))));
    assert_eq!(path.len(), 1, "{path:?}");
    let address = after(|tree| tree.texts.push(text(&format!("https://example.org{folder}"))));
    assert_eq!(address, Vec::<String>::new());
}

#[test]
fn words_and_stars() {
    let code = "let my_mesh = PolygonMesh::new();\nfs::read(x)";
    assert_eq!(source::lines_with(code, "Mesh"), [] as [usize; 0]);
    assert_eq!(source::lines_with(code, "*Mesh"), [1]);
    assert_eq!(source::lines_with(code, "*Mes*"), [1]);
    assert_eq!(source::lines_with(code, "mesh*"), [] as [usize; 0]);
    assert_eq!(source::lines_with(code, "fs::"), [2]);
    assert_eq!(source::lines_with(code, "*"), [] as [usize; 0]);
}

#[test]
fn literals_and_comments_are_no_code() {
    let rows = [
        ("a /* b /* c */ d */ e", "a                   e"),
        ("f(\"x\\\"y\") + g", "f(      ) + g"),
        ("r#\"a\"b\"# c", "         c"),
        ("'x' 'a 'b '\\'' z", "    'a 'b      z"),
        ("x // y\nz", "x     \nz"),
        ("\"open", "     "),
    ];
    for (text, code) in rows {
        assert_eq!(source::code(text), code, "{text}");
    }
}

#[test]
fn floats_in_public_signatures() {
    let rows: [(&str, &[usize]); 14] = [
        ("pub fn f<A, B: Into<f64>>(a: A) {}", &[1]),
        ("pub const fn f(a: [i64; 3]) -> Vec<f64> { 1 }", &[1]),
        ("pub fn f(\n    a: i64,\n    b: f32,\n) {}", &[3]),
        ("pub fn approx_f64(&self) -> f64 { 1.0 }", &[]),
        ("pub(crate) fn f(x: f64) {}", &[]),
        ("fn f(x: f64) {}", &[]),
        ("pub fn f(x: i64) { let y: f64 = 0.0; }", &[]),
        ("pub struct S { a: f64, pub b: f64 }", &[1]),
        ("pub struct S([f64; 3]);", &[]),
        ("pub struct S(pub [f64; 3]);", &[1]),
        ("pub enum E {\n    A(f64),\n}", &[2]),
        ("pub trait T {\n    fn a(&self) -> f64;\n    fn approx_b(&self) -> f64;\n}", &[2]),
        ("pub const LIMIT: f64 = 1.0;\npub const BITS: u32 = f64::DIGITS;", &[1]),
        ("impl TryFrom<f64> for X { fn try_from(x: f64) {} }", &[]),
    ];
    for (code, lines) in rows {
        assert_eq!(source::float_signatures(code), lines, "{code}");
    }
}
