//! `splitstar info`.

use crate::args::Run;
use crate::console::Console;
use crate::explain::mesh_error;
use crate::failure::Failure;
use crate::input::Operand;
use crate::output;
use crate::report::Report;
use splitstar::formats::Shape;
use splitstar::polytope::MeshSummary;

pub(crate) fn info(run: &Run) -> Result<(), Failure> {
    let mut console = Console::new(run.quiet, 2);
    let operand = Operand::read(&run.operands[0], &console)?;
    console.step("info");
    operand.tell_notes(&console);
    let model = &operand.read.model;
    let report = match &model.shape {
        Shape::Mesh(mesh) => {
            let summary = MeshSummary::of(mesh);
            console.close();
            for note in &summary.notes {
                console.note(&operand.name, None, &note.to_string());
            }
            if let Some(defect) = &summary.defect {
                let (place, what) = mesh_error(defect, &operand);
                console.note(&operand.name, place, &what);
            }
            Report::of_summary(&summary).filed(mesh.points.len(), mesh.facets.len())
        }
        Shape::Complex(complex) => Report::of_complex(complex),
    };
    console.close();
    let report = report.file(operand.read.format, model);
    output::report(&if run.json { report.json() } else { report.table() })
}
