//! 3MF: what is wrong with a file is told, with the part and the line; and no file takes long or much memory.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod threemf_archives;

use splitstar_formats::{Fault, Format, WriteOptions, read, write};
use std::fmt::Write;
use std::time::{Duration, Instant};
use threemf_archives::{MESH, RELATIONSHIPS, TYPE, archive, model, package};

/// A correct model; its lines are counted on in the rows.
fn good() -> String {
    model("", &format!("<object id='1'>{MESH}</object>"), "<build><item objectid='1'/></build>")
}

/// The message for the good model with one thing replaced.
const CHANGED: &[(&str, &str, &str, &str)] = &[
    (
        "a missing attribute",
        " z='0.1'",
        "",
        "line 8: `<vertex>` where <vertex> with the attribute z was expected; correct it",
    ),
    (
        "a missing corner",
        "v1='0' v2='1' v3='3'",
        "v1='0' v2='1'",
        "line 12: `<triangle>` where <triangle> with the attribute v3 was expected; correct it",
    ),
    (
        "an index out of range",
        "v3='1'",
        "v3='4'",
        "line 11: vertex index 4, but there are 4 vertices; indices run from 0 to 3",
    ),
    (
        "a negative index",
        "v3='1'",
        "v3='-1'",
        "line 11: vertex index -1, but there are 4 vertices; indices run from 0 to 3",
    ),
    (
        "a word for an index",
        "v3='1'",
        "v3='one'",
        "line 11: `one` is no vertex index; write whole numbers counted from 0",
    ),
    (
        "triangles before vertices",
        "<vertices>",
        "<triangles><triangle v1='0' v2='1' v3='2'/></triangles>\n<vertices>",
        "line 4: vertex index 0, but there is no vertex; write the vertices first",
    ),
    (
        "a repeated index",
        "v3='1'",
        "v3='2'",
        "line 11: the facet has vertex 2 twice in a row; name every vertex of a facet once",
    ),
    (
        "a repeated index around",
        "v3='1'",
        "v3='0'",
        "line 11: the facet has vertex 0 twice in a row; name every vertex of a facet once",
    ),
    ("not a number", "z='0.1'", "z='nan'", "line 8: `nan` is not finite; write a finite number"),
    ("an infinite number", "z='0.1'", "z='-INF'", "line 8: `-INF` is not finite; write a finite number"),
    (
        "a word for a number",
        "z='0.1'",
        "z='1,5'",
        "line 8: `1,5` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "an empty number",
        "z='0.1'",
        "z=' '",
        "line 8: `` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "a large exponent",
        "z='0.1'",
        "z='1e999999999'",
        "line 8: the exponent of `1e999999999` is too large in magnitude; the largest allowed is 400",
    ),
    (
        "a zero denominator",
        "z='0.1'",
        "z='1/0'",
        "line 8: `1/0` has the denominator zero; write a fraction p/q with q not zero",
    ),
    (
        "an attribute twice",
        "z='0.1'",
        "z='0.1' z='2'",
        "line 8: `<vertex>` where <vertex> with one attribute z was expected; correct it",
    ),
    (
        "an attribute without a value",
        "z='0.1'",
        "z",
        "line 8: `<vertex>` where <vertex> with attributes written as name=\"value\" was expected; correct it",
    ),
    (
        "a mismatched end tag",
        "</vertices>",
        "</vertex>",
        "line 9: `</vertex>` where </vertices> was expected; correct it",
    ),
    (
        "an end tag too many",
        "</model>",
        "</model></model>",
        "line 17: `</model>` where the end of the text was expected; correct it",
    ),
    (
        "an element behind",
        "</model>",
        "</model><model/>",
        "line 17: `<model/>` after the end of the model; remove it",
    ),
    ("text behind", "</model>", "</model>\nend", "line 18: `end` after the end of the model; remove it"),
    ("text before", "<model", "start <model", "line 2: `start` where <model> was expected; correct it"),
    (
        "a DTD",
        "<model",
        "<!DOCTYPE model [<!ENTITY a 'b'>]>\n<model",
        "line 2: a document type (DTD) cannot be read; remove it",
    ),
    (
        "an entity in a value",
        "z='0.1'",
        "z='&a;'",
        "line 8: the entity in `&a;` cannot be read; write what it stands for",
    ),
    (
        "an entity in the text",
        "<resources>",
        "<resources>&a;",
        "line 3: the entity `&a;` cannot be read; write what it stands for",
    ),
    (
        "another encoding",
        "encoding='UTF-8'",
        "encoding='ISO-8859-1'",
        "line 1: a text in ISO-8859-1 cannot be read; write it in UTF-8",
    ),
    (
        "an unknown unit",
        "<model",
        "<model unit='yard'",
        "line 2: `yard` where a unit (micron, millimeter, centimeter, inch, foot or meter) was expected; correct it",
    ),
    (
        "another root",
        "<model",
        "<svg",
        "line 2: `<svg>` where <model> of the namespace http://schemas.microsoft.com/3dmanufacturing/core/2015/02 was expected; correct it",
    ),
    (
        "another namespace",
        "core/2015/02",
        "core/2042/02",
        "line 2: `<model>` where <model> of the namespace http://schemas.microsoft.com/3dmanufacturing/core/2015/02 was expected; correct it",
    ),
    (
        "a required extension",
        "<model",
        "<model requiredextensions='b' xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02'",
        "line 2: a model that requires the extension `b` (beamlattice/2017/02) of 3MF cannot be read; export it without extensions, as plain triangles",
    ),
    (
        "an extension without a namespace",
        "<model",
        "<model requiredextensions='q'",
        "line 2: `q` where the prefix of a namespace was expected; correct it",
    ),
    (
        "another part",
        "objectid='1'",
        "objectid='1' p:path='/3D/a.model' xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'",
        "line 17: a model in several parts (`p:path`) cannot be read; export it as one part",
    ),
    (
        "an unknown object",
        "objectid='1'",
        "objectid='7'",
        "line 17: `7` where the id of an object was expected; correct it",
    ),
    (
        "an item without an object",
        "objectid='1'",
        "",
        "line 17: `<item>` where <item> with the attribute objectid was expected; correct it",
    ),
    (
        "a word for an object",
        "objectid='1'",
        "objectid='-1'",
        "line 17: `-1` where the number of an object was expected; correct it",
    ),
    (
        "an object without a number",
        "id='1'>",
        ">",
        "line 3: `<object>` where <object> with the attribute id was expected; correct it",
    ),
    (
        "a number twice",
        "<resources>",
        "<resources><object id='1'/>",
        "line 3: `1` where the id of only one object was expected; correct it",
    ),
    (
        "an unknown type",
        "<object",
        "<object type='brick'",
        "line 3: `brick` where a type (model, solidsupport, support, surface or other) was expected; correct it",
    ),
    (
        "two meshes",
        "<mesh>",
        "<mesh></mesh><mesh>",
        "line 3: `<mesh>` where one mesh, or components was expected; correct it",
    ),
    (
        "eleven numbers",
        "objectid='1'",
        "objectid='1' transform='1 0 0 0 1 0 0 0 1 0 0'",
        "line 17: `1 0 0 0 1 0 0 0 1 0 0` where a transform of 12 numbers was expected; correct it",
    ),
    (
        "thirteen numbers",
        "objectid='1'",
        "objectid='1' transform='1 0 0 0 1 0 0 0 1 0 0 0 0'",
        "line 17: `1 0 0 0 1 0 0 0 1 0 0 0 0` where a transform of 12 numbers was expected; correct it",
    ),
    (
        "a flat transform",
        "objectid='1'",
        "objectid='1' transform='1 0 0 2 0 0 0 0 1 0 0 0'",
        "line 17: `1 0 0 2 0 0 0 0 1 0 0 0` where a transform whose determinant is not zero was expected; correct it",
    ),
    (
        "a word in a transform",
        "objectid='1'",
        "objectid='1' transform='1 0 0 0 1 0 0 0 1 0 0 x'",
        "line 17: `x` is no number; write an integer, a decimal or a fraction p/q",
    ),
];

#[test]
fn what_is_wrong_with_a_model_is_told() {
    for (name, from, to, message) in CHANGED {
        let text = good().replacen(from, to, 1);
        assert_ne!(text, good(), "{name}");
        let error = read(&package(&text), None).expect_err(name);
        assert_eq!(error.to_string(), format!("3D/3dmodel.model: {message}"), "{name}");
        assert_eq!(error.format, Some(Format::ThreeMf), "{name}");
        assert_eq!(error.part.as_deref(), Some("3D/3dmodel.model"), "{name}");
    }
}

#[test]
fn other_models_that_are_wrong() {
    let cut = |at: &str| good().split(at).next().unwrap().to_string();
    let components = |component: &str| {
        model(
            "",
            &format!("\n<object id='2'><components>{component}</components></object>"),
            "<build><item objectid='2'/></build>",
        )
    };
    let deep = format!("{}{}", "<a>".repeat(100), "</a>".repeat(100));
    let rows = [
        ("empty", String::new(), "the file ends where `<model>` was expected; complete it"),
        (
            "a model without anything",
            model("", "", ""),
            "the mesh is empty: it has no vertex; at least one is needed",
        ),
        (
            "cut in a tag",
            cut(" v2='1' v3='3'"),
            "line 12: the file ends where the end of a tag or a comment was expected; complete it",
        ),
        (
            "cut in a value",
            cut("1' v3='3'"),
            "line 12: the file ends where the end of a tag or a comment was expected; complete it",
        ),
        (
            "cut behind a tag",
            cut("<triangle v1='1'"),
            "line 12: the file ends where `</triangles>` was expected; complete it",
        ),
        (
            "cut before the end",
            cut("</model>"),
            "line 17: the file ends where `</model>` was expected; complete it",
        ),
        (
            "cut in a comment",
            cut("<vertices>") + "<!-- ",
            "line 4: the file ends where the end of a tag or a comment was expected; complete it",
        ),
        (
            "a component of itself",
            components("<component objectid='2'/>"),
            "line 4: `component` where an object that is no component of itself was expected; correct it",
        ),
        (
            "an object without anything",
            model("", "\n<object id='2'/>", ""),
            "line 4: `<object>` where an object with a mesh or components was expected; correct it",
        ),
        (
            "deep",
            model("", &deep, ""),
            "line 3: a text with more than 64 elements within each other cannot be read; export the model again",
        ),
    ];
    for (name, text, message) in rows {
        let error = read(&package(&text), None).expect_err(name);
        let prefix = if name == "empty" { "3D/3dmodel.model: line 1: " } else { "3D/3dmodel.model: " };
        assert_eq!(error.to_string(), format!("{prefix}{message}"), "{name}");
    }
    let wide: Vec<u8> = good().encode_utf16().flat_map(u16::to_le_bytes).collect();
    let error = read(&archive(&[("3D/3dmodel.model", &wide)]), None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "3D/3dmodel.model: line 1: a text in UTF-16 cannot be read; write it in UTF-8"
    );
    let latin: Vec<u8> =
        good().replace("id='1'>", "id='1' name='\u{e9}'>").chars().map(|c| c as u8).collect();
    let error = read(&archive(&[("3D/3dmodel.model", &latin)]), None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "3D/3dmodel.model: line 3: `\\xe9` where text in UTF-8 was expected; correct it"
    );
}

#[test]
fn what_is_wrong_with_an_archive_is_told() {
    let whole = package(&good());
    let at = |signature: &[u8]| whole.windows(4).position(|bytes| bytes == signature).unwrap();
    let (local, central) = (at(b"PK\x03\x04"), at(b"PK\x01\x02"));
    let changed = |changes: &[(usize, u8)]| {
        let mut bytes = whole.clone();
        for &(at, value) in changes {
            bytes[at] = value;
        }
        bytes
    };
    let relation = format!(
        "<Relationships xmlns='{RELATIONSHIPS}'><Relationship Target='/a.model' Type='{TYPE}'/></Relationships>"
    );
    let broken = relation.replace("</Rel", "</rel");
    let list = "the packed data is damaged: the list of the files in the zip archive is wrong, or missing; pack it again";
    let data = local + 30 + "3D/3dmodel.model".len();
    let rows = [
        ("only a beginning", b"PK\x03\x04".to_vec(), list.to_string()),
        ("half an archive", whole[..whole.len() / 2].to_vec(), list.to_string()),
        ("an empty archive", archive(&[]), "a zip archive without a 3MF model cannot be read; a 3MF file has it as 3D/3dmodel.model; give other files unpacked".into()),
        ("another archive", archive(&[("readme.txt", b"hello")]), "a zip archive without a 3MF model cannot be read; a 3MF file has it as 3D/3dmodel.model; give other files unpacked".into()),
        ("a missing model", archive(&[("_rels/.rels", relation.as_bytes())]), "_rels/.rels: the packed data is damaged: it says that the model is /a.model, which is missing; pack it again".into()),
        ("wrong relationships", archive(&[("_rels/.rels", broken.as_bytes())]), "_rels/.rels: line 1: `</relationships>` where </Relationships> was expected; correct it".into()),
        ("an encrypted model", changed(&[(local + 6, 1), (central + 8, 1)]), "3D/3dmodel.model: an encrypted file cannot be read; pack the archive again with deflate".into()),
        ("another method", changed(&[(local + 8, 12), (central + 10, 12)]), "3D/3dmodel.model: a file packed by the method Bzip2 cannot be read; pack the archive again with deflate".into()),
        ("a wrong checksum", changed(&[(local + 14, whole[local + 14] ^ 1), (central + 16, whole[central + 16] ^ 1)]), "3D/3dmodel.model: the packed data is damaged: what it unpacks to is not what was packed, by its checksum; pack it again".into()),
        ("wrong data", changed(&[(data, 0xFF)]), "3D/3dmodel.model: the packed data is damaged: it is not what a packer writes; pack it again".into()),
    ];
    for (name, bytes, message) in rows {
        assert_eq!(read(&bytes, None).expect_err(name).to_string(), message, "{name}");
    }
}

/// Reading must fail for want of memory, and soon.
fn assert_stops(bytes: &[u8], name: &str) {
    let start = Instant::now();
    let error = read(bytes, None).expect_err(name);
    let elapsed = start.elapsed();
    assert_eq!(
        error.fault,
        Fault::TooMuchMemory { allowed: 62 * bytes.len() as u64 + (58 << 20) },
        "{name}: {error}"
    );
    assert!(elapsed < Duration::from_secs(10), "{name}: {elapsed:?}");
    println!("{name}: {elapsed:?}");
}

/// Objects each of which has ten components, and so on down to this one.
fn tower(levels: u32, attributes: &str, mesh: &str) -> String {
    let mut objects = format!("<object id='1'>{mesh}</object>");
    for level in 2..=levels + 1 {
        let component = format!("<component objectid='{}' {attributes}/>", level - 1);
        write!(objects, "<object id='{level}'><components>{}</components></object>", component.repeat(10))
            .unwrap();
    }
    model("", &objects, &format!("<build><item objectid='{}'/></build>", levels + 1))
}

#[test]
fn bombs_stop_early() {
    let zeros = vec![b' '; 50_000_000];
    assert_stops(&package(std::str::from_utf8(&zeros).unwrap()), "50 MB of blanks");
    assert_stops(
        &archive(&[("_rels/.rels", &zeros), ("3D/3dmodel.model", good().as_bytes())]),
        "relationships",
    );
    // Of what the archive says of sizes nothing is allocated; that more comes than was said is damage.
    let lying = |bytes: &[u8], size: u32| {
        let mut lying = bytes.to_vec();
        let central = lying.windows(4).rposition(|bytes| bytes == b"PK\x01\x02").unwrap();
        lying[22..26].copy_from_slice(&size.to_le_bytes());
        lying[central + 24..central + 28].copy_from_slice(&size.to_le_bytes());
        lying
    };
    let bomb = package(std::str::from_utf8(&zeros).unwrap());
    assert_stops(&lying(&bomb, 4_000_000_000), "a size that lies");
    let error = read(&lying(&bomb, 10), None).unwrap_err();
    assert!(matches!(error.fault, Fault::Packed { .. }), "{error}");
    assert!(read(&lying(&package(&good()), 4_000_000_000), None).is_ok());
    assert_stops(&package(&tower(10, "", MESH)), "ten to the tenth");
    assert_stops(&package(&tower(10, "transform='0 1 0 -1 0 0 0 0 1 0.1 0 0'", MESH)), "turned");
    assert_stops(&package(&tower(10, "", "<mesh></mesh>")), "of nothing");
    let blanks = format!("<mesh>{}</mesh>", " ".repeat(1 << 20));
    assert_stops(&package(&tower(10, "", &blanks)), "of blanks");
    let long = "transform='1e-99 1e99 7 -1 0 1e88 0 3 1e-77 0.1 0 0'";
    assert_stops(&package(&tower(10, long, MESH)), "of long numbers");
    let vertices = "<vertex x='1e400' y='1/7' z='1e-400'/>".repeat(200_000);
    assert_stops(
        &package(&model(
            "",
            &format!("<object id='1'><mesh><vertices>{vertices}</vertices></mesh></object>"),
            "",
        )),
        "long vertices",
    );
}

#[test]
fn components_may_be_nested_deep() {
    let mut objects = format!("<object id='1'>{MESH}</object>");
    let depth = 20_000;
    for id in 2..=depth {
        write!(
            objects,
            "<object id='{id}'><components><component objectid='{}'/></components></object>",
            id - 1
        )
        .unwrap();
    }
    let read = read(&package(&model("", &objects, "")), None).unwrap();
    assert_eq!(read.model.shape.mesh().unwrap().points.len(), 4);
}

#[test]
fn the_digits_of_nested_transforms_add_up() {
    let mut objects = format!("<object id='1'>{MESH}</object>\n");
    for id in 2..=100 {
        writeln!(
            objects,
            "<object id='{id}'><components><component objectid='{}' \
             transform='1e-99 1e99 7 -1 0 1e88 0 3 1e-77 0.1 0 0'/></components></object>",
            id - 1
        )
        .unwrap();
    }
    let error = read(&package(&model("", &objects, "")), None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "3D/3dmodel.model: line 50: transforms with so many digits cannot be read; write them with fewer digits"
    );
}

#[test]
fn changed_files_never_break_the_reader() {
    const SEED: u64 = 0x3DF_5EED;
    const CASES: usize = 6_000;
    println!("seed {SEED:#x}, {CASES} cases");
    let mut state = SEED;
    let mut random = |bound: usize| {
        // SplitMix64 (Steele, Lea and Flood 2014).
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    };
    let splices = [
        "<",
        ">",
        "/>",
        "'",
        "\"",
        "&",
        "&amp;",
        "&#0;",
        "&x;",
        "<!--",
        "-->",
        "<![CDATA[",
        "]]>",
        "<?",
        "?>",
        "<!DOCTYPE",
        " ",
        "\r",
        "\n",
        "=",
        ":",
        "<mesh>",
        "</mesh>",
        "<vertex x='1/3' y='1e400' z='-0'/>",
        "<object id='3'>",
        "</object>",
        "1e-400",
        "nan",
        "4294967296",
        " transform='1 0 0 0 1 0 0 0 1 0 0 1/3'",
        " objectid='2'",
        "\u{FEFF}",
        "\u{e9}",
        "xmlns='urn:x'",
        "xmlns:p='urn:x'",
        "p:",
    ];
    let text = tower(2, "transform='0 1 0 -1 0 0 0 0 1 0.1 0 0'", MESH).replace(" x=", " \n x=");
    let packed = package(&text);
    let mut accepted = 0;
    for case in 0..CASES {
        // Either the text is changed and then packed, or the archive.
        let mut bytes = if case % 2 == 0 { text.clone().into_bytes() } else { packed.clone() };
        for _ in 0..=random(3) {
            let at = random(bytes.len() + 1);
            let end = (at + random(40)).min(bytes.len());
            match random(6) {
                0 if at < bytes.len() => bytes[at] ^= 1 << random(8),
                1 if at < bytes.len() => bytes[at] = random(256) as u8,
                2 => drop(bytes.drain(at..end)),
                3 => {
                    let copy = bytes[at..end].to_vec();
                    let to = random(bytes.len());
                    drop(bytes.splice(to..to, copy));
                }
                4 if random(6) == 0 => bytes.truncate(at),
                _ => drop(bytes.splice(at..at, splices[random(splices.len())].bytes())),
            }
        }
        if case % 2 == 0 {
            bytes = archive(&[("3D/3dmodel.model", &bytes)]);
        } else if !bytes.starts_with(b"PK") {
            continue;
        }
        let start = Instant::now();
        match read(&bytes, None) {
            Ok(read) => {
                accepted += 1;
                if let Ok(written) = write(&read.model, &WriteOptions::new(Format::ThreeMf)) {
                    let again = splitstar_formats::read(&written.bytes, None);
                    let again = again.unwrap_or_else(|error| panic!("case {case}: {error}"));
                    let facets = |model: &splitstar_formats::Model| model.shape.mesh().unwrap().facets.len();
                    assert_eq!(facets(&again.model), facets(&read.model), "case {case}");
                }
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 400 && !message.contains(char::is_control), "case {case}: {message}");
            }
        }
        assert!(start.elapsed() < Duration::from_secs(10), "case {case}: {:?}", start.elapsed());
    }
    println!("{accepted} accepted");
    assert!(accepted > CASES / 50, "{accepted} accepted");
}
