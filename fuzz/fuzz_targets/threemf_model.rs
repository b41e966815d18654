//! The model within a 3MF archive: changed bytes of the archive itself hardly ever get past its checksums.
#![no_main]

use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    archive.start_file("3D/3dmodel.model", options).expect("memory takes it");
    archive.write_all(bytes).expect("memory takes it");
    let packed = archive.finish().expect("memory takes it").into_inner();
    splitstar_fuzz::check(&packed, "cube.3mf");
});
