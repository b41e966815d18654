//! A Gaussian map, written: one text for each.

use super::StarGaussianMap;
use super::cube::put_cube;
use crate::base::numerals::put;
use crate::star::arrangement::put_sphere;
use exact::Point3;

/// Writes a Gaussian map in the native format, kind `gaussian`: see `docs/star.md`.
///
/// There is one text for each map: it depends on the polytope alone, and on the sphere on the identification, and not on how the map was
/// made.
///
/// # Complexity
/// O(n log n).
///
/// ```
/// use exact::Point3;
/// use gauss::SphericalGaussianMap;
/// use polytope::Polytope;
/// use splitstar_formats::{read_gaussian_map, write_gaussian_map};
///
/// let segment = Polytope::segment(Point3::ORIGIN, Point3::from_i64([0, 0, 2]));
/// let text = write_gaussian_map(&SphericalGaussianMap::of_polytope(&segment).into());
/// assert_eq!(text, b"star 1 gaussian\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\n\
///     edge 0 0 0 curve 0\nface 0\nprimal 0 0 0\nouter -0\nface 1\nprimal 0 0 2\nouter +0\nend\n");
/// let again = read_gaussian_map(&text, None)?;
/// assert!(again.make_polytope().same_set(&segment));
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn write_gaussian_map(map: &StarGaussianMap) -> Vec<u8> {
    let mut text = b"star 1 gaussian\n".to_vec();
    match map {
        StarGaussianMap::Spherical(map) => {
            put_sphere(map.arrangement(), &mut text, |text, face| put_primal(text, map.point(face)));
        }
        StarGaussianMap::Cubical(map) => put_cube(map, &mut text),
    }
    text.extend_from_slice(b"end\n");
    text
}

/// The vertex of the polytope that is extreme in the directions of a face.
pub(super) fn put_primal(text: &mut Vec<u8>, point: &Point3) {
    let [x, y, z] = point.coordinates();
    put(text, format_args!("primal {x} {y} {z}\n"));
}
