//! An arrangement, written: one text for each.

use super::course::{Links, course_of};
use super::family::{Base, Family, StarText};
use crate::base::numerals::put;
use arrangement::{Arrangement, CellOrder};
use dcel::{CcbKind, Dcel, FaceId, HalfedgeId};

/// Writes an arrangement in the native format, kind `arrangement`: see `docs/star.md`.
///
/// There is one text for each arrangement: it depends on the cells alone, and not on ids, nor on the curves that were inserted, their
/// order and their directions. A curve of the text goes straight on from vertex to vertex as far as there are edges.
///
/// # Complexity
/// O(n log n).
///
/// ```
/// use arrangement::{Arrangement, models::{Linear, LinearTraits}, topology::UnboundedPlane};
/// use exact::planar::Point2;
/// use splitstar_formats::{read_arrangement, write_arrangement};
///
/// let [p, q, r] = [[0, 0], [2, 0], [1, -1]].map(Point2::from_i64);
/// let line = Linear::line(&p, &q).expect("the points are different");
/// let ray = Linear::ray(r, &Point2::from_i64([1, 0])).expect("the points are different");
/// let arrangement = Arrangement::of_curves(LinearTraits, UnboundedPlane, &[line, ray]);
/// let text = write_arrangement(&arrangement);
/// assert!(text.starts_with(b"star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 0\n"));
/// let again = read_arrangement(&text, None)?;
/// assert_eq!(again.counts().faces, 3);
/// assert_eq!(write_arrangement(&again), text);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn write_arrangement(arrangement: &impl StarText) -> Vec<u8> {
    arrangement.star_text()
}

pub(super) fn text<B: Base, G: Family<B>>(arrangement: &Arrangement<G, G::Surface>) -> Vec<u8> {
    let mut text = b"star 1 arrangement\n".to_vec();
    put_records(arrangement, &mut text, |_, _| ());
    text.extend_from_slice(b"end\n");
    text
}

/// Writes all but the first line and `end`; `put_of_face` writes what is known of a face, behind its number.
pub(super) fn put_records<B: Base, G: Family<B>>(
    arrangement: &Arrangement<G, G::Surface>,
    text: &mut Vec<u8>,
    mut put_of_face: impl FnMut(&mut Vec<u8>, FaceId),
) {
    let dcel = arrangement.dcel();
    let CellOrder { vertices, edges, ccbs, faces } = arrangement.cell_order();
    arrangement.traits().base().put_surface(text);

    // Curves in the order of their first edges.
    const NEW: u32 = u32::MAX;
    let links = Links::new(arrangement, &vertices);
    let mut curve_numbers = vec![NEW; dcel.edge_bound()];
    let mut curve_count = 0;
    for &e in &edges {
        if curve_numbers[e.index()] != NEW {
            continue;
        }
        links.run(e).for_each(|e| curve_numbers[e.index()] = curve_count);
        let course = course_of(arrangement, links.run(e)).expect("a curve has an edge");
        put(text, format_args!("curve {curve_count} "));
        B::put_course(&course, text);
        text.push(b'\n');
        curve_count += 1;
    }
    drop(links);

    let mut vertex_numbers = vec![NEW; dcel.vertex_bound()];
    for (number, &v) in (0..).zip(&vertices) {
        vertex_numbers[v.index()] = number;
        put(text, format_args!("vertex {number}"));
        B::put_point(arrangement.point(v).expect("vertices in order have points"), text);
        text.extend_from_slice(if arrangement.is_artificial(v) { b" artificial\n" } else { b"\n" });
    }

    let mut edge_numbers = vec![NEW; dcel.edge_bound()];
    for (number, &e) in (0..).zip(&edges) {
        edge_numbers[e.index()] = number;
        put(text, format_args!("edge {number}"));
        for v in dcel.ends(e) {
            match vertex_numbers[v.index()] {
                NEW => text.extend_from_slice(b" infinity"),
                number => put(text, format_args!(" {number}")),
            }
        }
        put(text, format_args!(" curve {}\n", curve_numbers[e.index()]));
    }

    let mut ccbs_of_faces: Vec<Vec<HalfedgeId>> = vec![Vec::new(); dcel.face_bound()];
    for h in ccbs {
        ccbs_of_faces[dcel.face(h).index()].push(h);
    }
    for (number, &face) in (0_u32..).zip(&faces) {
        put(text, format_args!("face {number}\n"));
        put_of_face(text, face);
        let firsts = ccbs_of_faces[face.index()].iter().copied();
        put_boundaries(dcel, firsts, &edge_numbers, text);
        let isolated = dcel.isolated_vertices(face).map(|v| vertex_numbers[v.index()]);
        // Infinity has no number, nor has a pole at which nothing is.
        let mut isolated: Vec<u32> = isolated.filter(|&number| number != NEW).collect();
        isolated.sort_unstable();
        isolated.iter().for_each(|number| put(text, format_args!("isolated {number}\n")));
    }
}

/// Writes the boundaries of a face, given by their first halfedges: outer ones before inner ones.
pub(in crate::star) fn put_boundaries(
    dcel: &Dcel,
    firsts: impl Iterator<Item = HalfedgeId> + Clone,
    edge_numbers: &[u32],
    text: &mut Vec<u8>,
) {
    for (kind, keyword) in [(CcbKind::Outer, "outer"), (CcbKind::Inner, "inner")] {
        for first in firsts.clone().filter(|&h| dcel.ccb_kind(dcel.ccb(h)) == kind) {
            text.extend_from_slice(keyword.as_bytes());
            for h in dcel.cycle(first) {
                let sign = if h.is_even() { '+' } else { '-' };
                put(text, format_args!(" {sign}{}", edge_numbers[h.edge()]));
            }
            text.push(b'\n');
        }
    }
}
