//! Random scripts of edits.

use crate::script::{FAMILIES, HEADER, STEP, run};
use std::panic::{AssertUnwindSafe, catch_unwind};
use testkit::Rng;

/// Scripts of each family: 2,500 of all.
const SCRIPTS: u64 = 250;

/// The most steps of a script.
const STEPS: u64 = 48;

/// What scripts do: all of it happens in every family.
const KINDS: [&str; 18] = [
    "insert [",
    "insert point",
    "insert at once",
    "insert In",
    "insert From",
    "insert To",
    "insert Between",
    "insert Anyhow",
    "split",
    "remove edge",
    "remove vertex",
    "merge",
    "modify vertex",
    "modify edge",
    "compact",
    "clear",
    "take back",
    "take all back",
];

/// What a script did; and what it says if it did not run through.
fn outcome(bytes: &[u8]) -> Result<Vec<String>, (Vec<String>, String)> {
    let mut log = Vec::new();
    let result = catch_unwind(AssertUnwindSafe(|| run(bytes, &mut |text| log.push(text))));
    let Err(panic) = result else { return Ok(log) };
    let text = panic.downcast_ref::<String>().cloned();
    let text = text.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
    Err((log, text.unwrap_or_default()))
}

/// Drops steps of a script that fails, as long as it still does.
fn shrink(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut length = 8;
    while length > 0 {
        let mut at = HEADER;
        while at < bytes.len() {
            let mut fewer = bytes.clone();
            fewer.drain(at..(at + length * STEP).min(bytes.len()));
            if outcome(&fewer).is_err() {
                bytes = fewer;
            } else {
                at += length * STEP;
            }
        }
        length /= 2;
    }
    bytes
}

fn run_scripts(family: u8, first_seed: u64, scripts: u64) {
    let mut steps = Vec::new();
    for seed in first_seed..first_seed + scripts {
        let mut rng = Rng::new(seed);
        let count = HEADER + STEP * (1 + rng.below(STEPS) as usize);
        let mut bytes: Vec<u8> = (0..count).map(|_| rng.below(256) as u8).collect();
        bytes[0] = family;
        match outcome(&bytes) {
            Ok(log) => steps.extend(log),
            Err(_) => {
                let bytes = shrink(&bytes);
                let (log, text) = outcome(&bytes).expect_err("it still fails");
                panic!("family {family}, seed {seed}, {bytes:?}:\n{}\n{text}", log.join("\n"));
            }
        }
    }
    for kind in KINDS {
        let count = steps.iter().filter(|step| step.starts_with(kind)).count();
        assert!(count > 20, "{kind}: {count}");
    }
}

macro_rules! families {
    ($($name:ident $number:literal,)+) => {
        $(
            #[test]
            fn $name() {
                run_scripts($number, 1_000 * $number, SCRIPTS);
            }
        )+

        #[test]
        fn all_families_have_scripts() {
            assert_eq!([$($number),+].len(), usize::from(FAMILIES));
        }
    };
}

families! {
    segments 0,
    linear_curves 1,
    paths_on_a_torus 2,
    segments_with_data 3,
    polycurves_of_linear_curves 4,
    polylines_on_a_torus 5,
    minimal_segments 6,
    polylines 7,
    arcs_on_a_sphere 8,
    chains_on_a_sphere 9,
}

/// What fuzzing found, and where it begins.
#[test]
fn seeds_of_the_fuzz_target() {
    let folder = testkit::repository().join("fuzz/seeds/edits");
    let files = std::fs::read_dir(folder).expect("there are seeds");
    let mut count = 0;
    for file in files {
        let path = file.expect("the folder can be read").path();
        let bytes = std::fs::read(&path).expect("a seed can be read");
        if let Err((log, text)) = outcome(&bytes) {
            panic!("{}:\n{}\n{text}", path.display(), log.join("\n"));
        }
        count += 1;
    }
    assert!(count > 10, "{count}");
}
