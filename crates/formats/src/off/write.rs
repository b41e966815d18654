//! The OFF format, written exactly or, on request, with floats.

use crate::base::numerals::{Numerals, Rounding, put, put_point};
use crate::write::{Body, Task, WriteError, too_large};
use polytope::Facets;

/// Writes a mesh as ASCII OFF. The third count is the number of pairs of vertices that follow each other in some facet.
pub(crate) fn write(task: &Task<'_>) -> Result<Body, WriteError> {
    let mesh = task.mesh;
    let mut bytes = Vec::with_capacity(24 * mesh.points.len() + 8 * mesh.facets.corners().len());
    let counts = [mesh.points.len(), mesh.facets.len(), count_edges(&mesh.facets)];
    put(&mut bytes, format_args!("OFF\n{} {} {}\n", counts[0], counts[1], counts[2]));
    let mut rounding = Rounding::none();
    let numerals = task.numerals(Numerals::Fractions);
    for (vertex, point) in mesh.points.iter().enumerate() {
        put_point(&mut bytes, point, numerals, &mut rounding).map_err(too_large(vertex))?;
        bytes.push(b'\n');
    }
    for cycle in mesh.facets.iter() {
        put(&mut bytes, format_args!("{}", cycle.len()));
        for index in cycle {
            put(&mut bytes, format_args!(" {index}"));
        }
        bytes.push(b'\n');
    }
    Ok(Body::new(bytes, rounding))
}

fn count_edges(facets: &Facets) -> usize {
    let mut pairs = Vec::with_capacity(facets.corners().len());
    for cycle in facets.iter() {
        let Some(&last) = cycle.last() else { continue };
        let mut source = last;
        for &target in cycle {
            pairs.push((source.min(target), source.max(target)));
            source = target;
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    pairs.len()
}
