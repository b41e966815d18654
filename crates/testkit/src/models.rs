//! The model files of the repository.

use exact::Rational;
use polytope::{PolygonMesh, Polytope};
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Reads a model as it stands in its file, by its path in `models/`.
///
/// # Panics
/// If there is no such file, or it cannot be read.
pub fn model_mesh(path: &str) -> PolygonMesh {
    let bytes = std::fs::read(repository().join("models").join(path));
    let bytes = bytes.unwrap_or_else(|error| panic!("models/{path}: {error}"));
    let read = formats::read(&bytes, None).unwrap_or_else(|error| panic!("models/{path}: {error}"));
    read.model.shape.into_mesh().expect("an OFF file has a mesh")
}

/// Reads a convex model that needs no mending.
///
/// # Panics
/// If there is no such file, or it is not a convex polytope as it stands.
pub fn model(path: &str) -> Polytope {
    let mut notes = Vec::new();
    let polytope = Polytope::from_mesh(&model_mesh(path), &mut notes);
    let polytope = polytope.unwrap_or_else(|error| panic!("models/{path}: {error}"));
    assert!(notes.is_empty(), "models/{path}: {notes:?}");
    polytope
}

/// What is known of the models: `models/expected.json`.
///
/// # Panics
/// If the file is missing or is not JSON.
pub fn expected() -> Value {
    let bytes =
        std::fs::read(repository().join("models/expected.json")).expect("models/expected.json is there");
    serde_json::from_slice(&bytes).expect("models/expected.json is JSON")
}

/// The paths in `models/` of the meshes in a folder of it, sorted.
///
/// # Panics
/// If there is no such folder.
pub fn model_names(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(repository().join("models").join(folder)).expect("the folder is there");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("a folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "off" || extension == "xoff"))
        .filter_map(|path| Some(format!("{folder}/{}", path.file_name()?.to_str()?)))
        .collect();
    names.sort();
    names
}

/// A row of "Expected sums of convex models".
#[derive(Clone, Debug)]
pub struct SumRow {
    /// The paths of the summands in `models/`.
    pub names: Vec<String>,
    /// The summands.
    pub summands: Vec<Polytope>,
    /// Vertices, edges, facets.
    pub counts: [usize; 3],
    /// Crossings, common normals, normals on arcs; for sums of two.
    pub meetings: Option<[usize; 3]>,
    /// The volume, where a second program has computed it.
    pub volume: Option<Rational>,
}

impl SumRow {
    /// All rows.
    ///
    /// # Panics
    /// If `models/expected.json` has another form, or a model is missing.
    pub fn all() -> Vec<Self> {
        let table = expected();
        let rows = table["sums"].as_array().expect("the sums are a list");
        let mut models = HashMap::new();
        rows.iter().map(|row| Self::of(row, &mut models)).collect()
    }

    fn of(row: &Value, models: &mut HashMap<String, Polytope>) -> Self {
        let number = |key: &str| row[key].as_u64().map(|n| n as usize);
        let text = |value: &Value| value.as_str().expect("a text").to_owned();
        let names: Vec<String> = row["summands"].as_array().expect("a list").iter().map(text).collect();
        let polytope = |name: &String| models.entry(name.clone()).or_insert_with(|| model(name)).clone();
        let meetings = ["crossings", "common_normals", "normal_on_edge"].map(number);
        Self {
            summands: names.iter().map(polytope).collect(),
            names,
            counts: ["V", "E", "F"].map(|key| number(key).expect("a row has counts")),
            meetings: meetings.into_iter().collect::<Option<Vec<_>>>().and_then(|m| m.try_into().ok()),
            volume: row["volume"].as_str().map(|volume| volume.parse().expect("a volume is a fraction")),
        }
    }

    /// The names of the summands.
    pub fn name(&self) -> String {
        self.names.join(" + ")
    }

    /// The number of sums of one vertex of each summand: what the hull method works on.
    pub fn vertex_sums(&self) -> usize {
        self.summands.iter().map(|p| p.points().len()).product()
    }

    /// Panics unless a polytope has the counts and the volume of the row (an exact rotation changes
    /// neither) and is valid.
    ///
    /// # Panics
    /// In that case.
    #[track_caller]
    pub fn check(&self, sum: &Polytope, context: &str) {
        assert_eq!(sum.counts().to_array(), self.counts, "{} {context}", self.name());
        assert_eq!(sum.check_valid(), [], "{} {context}", self.name());
        if let Some(volume) = &self.volume {
            assert_eq!(sum.volume(), *volume, "{} {context}", self.name());
        }
    }
}
