//! Files of every format that are cut off, spoiled, or promise what they do not have.

use crate::encode::{Encoded, Kind, Mesh, PART, zip};
use crate::{Folder, model, run};
use std::fs;

/// What `sum` says of each of them: an error, or a note where the file can be read.
const EXPECTED: &str = include_str!("damaged.txt");

#[test]
fn damaged_files_of_every_format() {
    let folder = Folder::new("damaged");
    let cube = model("convex/cube.off");
    let mut expected = EXPECTED.lines();
    for (what, kind, bytes) in damaged() {
        let file = folder.path(&format!("damaged.{}", kind.ending()));
        fs::write(&file, &bytes).unwrap();
        let out = folder.path("out.star");
        let run = run(&["sum", &file, &cube, "-o", &out, "--json"]);
        let said = format!("{kind:?}, {what}: {}", run.stderr.trim_end().replace(&file, "FILE"));
        assert_eq!(Some(said.as_str()), expected.next());
        if run.stderr.starts_with("error") {
            run.error(1);
        } else {
            run.json();
            fs::remove_file(&out).unwrap();
        }
        fs::remove_file(&file).unwrap();
        assert_eq!(folder.names(), [""; 0], "{said}");
    }
    assert_eq!(expected.next(), None);
}

/// A cube in every format, damaged in every way that is not a matter of its mesh.
fn damaged() -> Vec<(&'static str, Kind, Vec<u8>)> {
    let garbage = fs::read(model("invalid/binary_garbage.off")).unwrap();
    let cube = Mesh::of_off(&model("convex/cube.off"));
    let mut rows = Vec::new();
    for kind in Kind::ALL {
        let Encoded { bytes, vertices, facets, .. } = cube.encode(kind);
        let starts = starts_of_lines(&bytes);
        if kind != Kind::ThreeMf {
            // Where vertex 5 and facet 3 begin.
            let start = |place: usize| if kind.is_binary() { place } else { starts[place - 1] };
            let [vertex, facet] = [vertices[5], facets[3]].map(start);
            rows.push(("cut before a vertex", kind, bytes[..vertex].to_vec()));
            rows.push(("cut within a vertex", kind, bytes[..vertex + 4].to_vec()));
            rows.push(("cut before a facet", kind, bytes[..facet].to_vec()));
            rows.push(("cut within a facet", kind, bytes[..facet + 5].to_vec()));
            rows.push(("garbage from a vertex on", kind, [&bytes[..vertex], &garbage].concat()));
        }
        if kind == Kind::ThreeMf {
            // The text as it stands in the archive.
            let start = 30 + PART.len();
            let length = bytes[start..].windows(4).position(|word| word == b"PK\x01\x02").unwrap();
            let text = &bytes[start..start + length];
            let starts = starts_of_lines(text);
            let [vertex, facet] = [starts[vertices[5] - 1], starts[facets[3] - 1]];
            rows.push(("cut before a vertex", kind, zip(&[(PART, &text[..vertex])])));
            rows.push(("cut within a vertex", kind, zip(&[(PART, &text[..vertex + 4])])));
            rows.push(("cut before a facet", kind, zip(&[(PART, &text[..facet])])));
            rows.push(("cut within a facet", kind, zip(&[(PART, &text[..facet + 5])])));
            let spoiled = [&text[..vertex], &garbage].concat();
            rows.push(("garbage from a vertex on", kind, zip(&[(PART, &spoiled)])));
            rows.push(("empty text", kind, zip(&[(PART, b"")])));
            rows.push(("other name", kind, zip(&[("3D/other.txt", text)])));
            rows.push(("archive cut in the middle", kind, bytes[..bytes.len() / 2].to_vec()));
            let mut changed = bytes.clone();
            changed[start + facet + 15] ^= 1;
            rows.push(("one bit changed", kind, changed));
        }
        if kind != Kind::Obj {
            rows.push(("cut within the header", kind, bytes[..20].to_vec()));
        }
        rows.push(("garbage behind the end", kind, [&bytes[..], &garbage].concat()));
        rows.push(("garbage", kind, garbage.clone()));
        rows.push(("empty", kind, Vec::new()));
        let nothing = Mesh { points: Vec::new(), facets: Vec::new(), promised: [None; 2] };
        rows.push(("zero of everything", kind, nothing.encode(kind).bytes));
        for (what, promised) in [
            ("too many vertices promised", [Some(11), None]),
            ("too few vertices promised", [Some(5), None]),
            ("too many facets promised", [None, Some(15)]),
            ("too few facets promised", [None, Some(3)]),
            ("very many vertices promised", [Some(4_000_000_000), None]),
            ("very many facets promised", [None, Some(4_000_000_000)]),
        ] {
            let bytes = Mesh { promised, ..cube.clone() }.encode(kind).bytes;
            if bytes != cube.encode(kind).bytes {
                rows.push((what, kind, bytes));
            }
        }
    }
    rows
}

fn starts_of_lines(bytes: &[u8]) -> Vec<usize> {
    let ends = (0..bytes.len()).filter(|&at| bytes[at] == b'\n');
    std::iter::once(0).chain(ends.map(|end| end + 1)).collect()
}
