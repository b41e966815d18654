//! Archives for the tests of 3MF.

// Not every test uses all of it.
#![allow(dead_code, clippy::unwrap_used)]

use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

pub(crate) const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
pub(crate) const RELATIONSHIPS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
pub(crate) const TYPE: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// A tetrahedron.
pub(crate) const MESH: &str = "<mesh>\n<vertices>\n<vertex x='0' y='0' z='0'/>\n<vertex x='1' y='0' z='0'/>\n\
    <vertex x='0' y='1' z='0'/>\n<vertex x='0' y='0' z='0.1'/>\n</vertices>\n<triangles>\n\
    <triangle v1='0' v2='2' v3='1'/>\n<triangle v1='0' v2='1' v3='3'/>\n<triangle v1='1' v2='2' v3='3'/>\n\
    <triangle v1='2' v2='0' v3='3'/>\n</triangles>\n</mesh>";

/// The text of a model.
pub(crate) fn model(attributes: &str, resources: &str, build: &str) -> String {
    format!(
        "<?xml version='1.0' encoding='UTF-8'?>\n<model {attributes} xmlns='{CORE}'>\n\
         <resources>{resources}</resources>\n{build}</model>\n"
    )
}

/// An archive of these files.
pub(crate) fn archive(files: &[(&str, &[u8])]) -> Vec<u8> {
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        writer.start_file(*name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// An archive with only the model.
pub(crate) fn package(text: &str) -> Vec<u8> {
    archive(&[("3D/3dmodel.model", text.as_bytes())])
}
