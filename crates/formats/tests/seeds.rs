//! The seeds of the fuzz targets, and what these have found: every one is read, and a model that comes of it is
//! written in every format and comes back.

use splitstar_formats::{Format, WriteOptions, read, write};
use std::path::Path;

#[test]
fn every_seed_is_read_and_written() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    let (mut models, mut refused) = (0, 0);
    for target in std::fs::read_dir(folder).expect("the seeds are there") {
        let target = target.expect("a folder can be read").path();
        for seed in std::fs::read_dir(&target).expect("the seeds are there") {
            let seed = seed.expect("a folder can be read").path();
            let bytes = std::fs::read(&seed).expect("a seed can be read");
            match read(&bytes, Some("cube.obj")) {
                Ok(read) => {
                    models += 1;
                    check(&read.model, &seed);
                }
                Err(error) => {
                    refused += 1;
                    assert!(error.to_string().len() < 600, "{}", seed.display());
                }
            }
        }
    }
    assert!(models > 50 && refused < models, "{models} models, {refused} refused");
}

fn check(model: &splitstar_formats::Model, seed: &Path) {
    let star = WriteOptions::new(Format::Star);
    let text = write(model, &star).expect("the native format holds every model").bytes;
    let again = read(&text, None).unwrap_or_else(|error| panic!("{}: {error}", seed.display())).model;
    assert_eq!(write(&again, &star).expect("as before").bytes, text, "{}", seed.display());
    for format in Format::ALL {
        let mut options = WriteOptions::new(format);
        options.lossy = true;
        let Ok(written) = write(model, &options) else { continue };
        if format != Format::Glb && written.largest_rounding.is_zero() {
            read(&written.bytes, None)
                .unwrap_or_else(|error| panic!("{}: {format:?}: {error}", seed.display()));
        }
    }
}
