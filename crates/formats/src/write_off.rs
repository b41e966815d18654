//! The OFF format, written exactly or, on request, with floats.

use exact::{Point3, Rational, Sign};
use polytope::{Facets, PolygonMesh};
use std::fmt;
use std::io::Write;

/// How coordinates are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[non_exhaustive]
pub enum Coordinates {
    /// As they are: an integer, or `p/q` in lowest terms. Read back, the file gives the same values.
    #[default]
    Exact,
    /// Each rounded to the nearest double (ties to even), as the shortest decimal that reads back as
    /// this double. Facets are in general no longer planar.
    Float,
}

/// How a mesh is written.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct WriteOptions {
    /// How coordinates are written.
    pub coordinates: Coordinates,
}

impl WriteOptions {
    /// The default with other coordinates.
    pub fn with_coordinates(coordinates: Coordinates) -> Self {
        Self { coordinates }
    }
}

/// What writing changed.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct WriteReport {
    /// The largest difference between a coordinate and the double written for it; zero in exact files.
    pub largest_rounding: Rational,
}

/// Why a mesh cannot be written as asked.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum WriteError {
    /// A coordinate lies beyond the largest double. Exact coordinates have no such limit.
    TooLargeForFloat {
        /// The index of the vertex.
        vertex: usize,
    },
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLargeForFloat { vertex } => write!(
                f,
                "vertex {vertex} has a coordinate beyond the largest float; write exact coordinates, or scale down"
            ),
        }
    }
}

impl std::error::Error for WriteError {}

/// Writes a mesh as ASCII OFF.
///
/// A mesh without facets becomes a point set; facets of two vertices become segments. The third count
/// is the number of pairs of vertices that follow each other in some facet. The same mesh gives the
/// same bytes.
///
/// # Errors
/// Only with [`Coordinates::Float`], if a coordinate is too large for a double.
///
/// # Complexity
/// O(n log n) for n corners of facets (the edges are counted by sorting), and linear in the digits
/// for coordinates of bounded width.
pub fn write_off(mesh: &PolygonMesh, options: &WriteOptions) -> Result<(Vec<u8>, WriteReport), WriteError> {
    let mut text = Vec::with_capacity(24 * mesh.points.len() + 8 * mesh.facets.corners().len());
    let counts = [mesh.points.len(), mesh.facets.len(), count_edges(&mesh.facets)];
    put(&mut text, format_args!("OFF\n{} {} {}\n", counts[0], counts[1], counts[2]));
    let mut largest_rounding = Rational::from(0);
    for (vertex, point) in mesh.points.iter().enumerate() {
        match options.coordinates {
            Coordinates::Exact => put_exact(&mut text, point),
            Coordinates::Float => {
                let rounding = put_float(&mut text, point).ok_or(WriteError::TooLargeForFloat { vertex })?;
                if rounding > largest_rounding {
                    largest_rounding = rounding;
                }
            }
        }
    }
    for cycle in mesh.facets.iter() {
        put(&mut text, format_args!("{}", cycle.len()));
        for index in cycle {
            put(&mut text, format_args!(" {index}"));
        }
        text.push(b'\n');
    }
    Ok((text, WriteReport { largest_rounding }))
}

fn put_exact(text: &mut Vec<u8>, point: &Point3) {
    if let Some([x, y, z, 1]) = point.as_narrow() {
        return put(text, format_args!("{x} {y} {z}\n"));
    }
    for axis in 0..3 {
        put(text, format_args!("{}{}", point.coordinate(axis), ending(axis)));
    }
}

/// Gives the largest rounding, or `None` if a coordinate is too large.
fn put_float(text: &mut Vec<u8>, point: &Point3) -> Option<Rational> {
    let mut largest = Rational::from(0);
    for axis in 0..3 {
        let coordinate = point.coordinate(axis);
        let float = coordinate.approx_f64();
        let rounding = (&Rational::try_from(float).ok()? - &coordinate).abs();
        if rounding > largest {
            largest = rounding;
        }
        // Both forms have the fewest digits that read back as the same double. Plain zeros are kept
        // few; a negative number that rounds to zero is written without its sign.
        let magnitude = float.abs();
        if coordinate.sign() == Sign::Zero || magnitude == 0.0 {
            put(text, format_args!("0{}", ending(axis)));
        } else if (1e-5..1e16).contains(&magnitude) {
            put(text, format_args!("{float}{}", ending(axis)));
        } else {
            put(text, format_args!("{float:e}{}", ending(axis)));
        }
    }
    Some(largest)
}

fn ending(axis: usize) -> char {
    if axis == 2 { '\n' } else { ' ' }
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

fn put(text: &mut Vec<u8>, arguments: fmt::Arguments<'_>) {
    text.write_fmt(arguments).expect("writing to memory does not fail");
}
