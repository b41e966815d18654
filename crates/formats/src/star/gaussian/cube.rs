//! The six sides of a cube: a planar map each, whose edges are straight.

use super::write::put_primal;
use crate::base::numerals::put;
use crate::star::arrangement::put_boundaries;
use ::cubical::{At, CubeSide, CubicalArrangement};
use arrangement::CellOrder;
use dcel::HalfedgeId;
use exact::Point3;
use gauss::CubicalGaussianMap;

/// Writes the surface and its sides, in the order of the thesis.
pub(super) fn put_cube(map: &CubicalGaussianMap, text: &mut Vec<u8>) {
    text.extend_from_slice(b"surface cube\n");
    for side in CubeSide::ALL {
        let sign = if side.is_positive() { '+' } else { '-' };
        put(text, format_args!("side {sign}{}\n", ["x", "y", "z"][side.axis()]));
        put_side(map.arrangement(), side, map.points(), text);
    }
}

fn put_side(map: &CubicalArrangement, side: CubeSide, points: &[Point3], text: &mut Vec<u8>) {
    let arrangement = map.side(side);
    let dcel = arrangement.dcel();
    let CellOrder { vertices, edges, ccbs, faces } = arrangement.cell_order();
    let put_reality = |text: &mut Vec<u8>, is_real: bool| {
        text.extend_from_slice(if is_real { b"\n" } else { b" artificial\n" });
    };

    let mut vertex_numbers = vec![0_u32; dcel.vertex_bound()];
    for (number, &id) in (0..).zip(&vertices) {
        vertex_numbers[id.index()] = number;
        let [u, v] = arrangement.point(id).expect("vertices in order have points").coordinates();
        put(text, format_args!("vertex {number} {u} {v}"));
        put_reality(text, map.is_real_vertex(At { side, id }));
    }

    let mut edge_numbers = vec![0_u32; dcel.edge_bound()];
    for (number, &id) in (0..).zip(&edges) {
        edge_numbers[id.index()] = number;
        let [min, max] = dcel.ends(id).map(|v| vertex_numbers[v.index()]);
        put(text, format_args!("edge {number} {min} {max}"));
        put_reality(text, map.is_real_edge(At { side, id }));
    }

    let mut ccbs_of_faces: Vec<Vec<HalfedgeId>> = vec![Vec::new(); dcel.face_bound()];
    ccbs.iter().for_each(|&h| ccbs_of_faces[dcel.face(h).index()].push(h));
    // The unbounded face is no part of the sphere.
    let bounded = faces.iter().filter_map(|&id| Some((id, map.face_of(At { side, id })?)));
    for (number, (id, face)) in (0_u32..).zip(bounded) {
        put(text, format_args!("face {number}\n"));
        put_primal(text, &points[face.index()]);
        put_boundaries(dcel, ccbs_of_faces[id.index()].iter().copied(), &edge_numbers, text);
    }
}
