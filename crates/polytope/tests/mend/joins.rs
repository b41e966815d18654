//! Joining within labels, and the holes that it makes.

use super::*;
use testkit::{cube_mesh, fan_triangulated, mesh};

/// Facets of different labels keep the edges between them, in any number of objects.
#[test]
fn labels() {
    let given = fan_triangulated(&cube_mesh());
    // The facets of a cube come in pairs of triangles.
    let rows: [(&str, [u32; 12], usize); 4] = [
        ("one label", [7; 12], 6),
        ("one label for each square", [0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5], 6),
        ("all apart", [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], 12),
        ("one square apart", [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1], 7),
    ];
    for (name, labels, count) in rows {
        let (joined, notes) = mend(&given, JOIN.within(&labels));
        assert_eq!(joined.mesh.facets.len(), count, "{name}");
        assert_eq!(notes.is_empty(), count == 12, "{name}");
        // Labels are for joining only.
        assert_eq!(mend(&given, KEEP.within(&labels)).0.mesh.facets, given.facets, "{name}");
    }
    // Two squares side by side, each of two triangles, and the middle of all straight edges. Labels are those
    // of the facets that were given, also after one of these went.
    let points = [[0, 0, 0], [2, 0, 0], [4, 0, 0], [4, 2, 0], [2, 2, 0], [0, 2, 0], [2, 1, 0], [0, 1, 0]];
    let cycles: [&[u32]; 5] = [&[0, 1, 0], &[0, 1, 6, 7], &[7, 6, 4, 5], &[1, 2, 4, 6], &[2, 3, 4]];
    let given = mesh(&points, &cycles);
    let (joined, _) = mend(&given, JOIN);
    assert_eq!([joined.mesh.facets.len(), joined.mesh.points.len()], [1, 4]);
    let (joined, notes) = mend(&given, JOIN.within(&[1, 0, 0, 1, 1]));
    assert_eq!(plain(&joined.mesh), [[0, 1, 4, 5], [1, 2, 3, 4]]);
    assert_eq!((&joined.facet_origin[..], &joined.vertex_origin[..]), (&[1, 3][..], &[0, 1, 2, 3, 4, 5][..]));
    assert_eq!(
        notes.last().expect("joined").to_string(),
        "coplanar facets and collinear edges joined: 4 facets and 8 vertices became 2 and 6"
    );
}

/// A hole per square of a chain that touches itself: each finds its own.
#[test]
fn holes_in_a_chain() {
    const N: u32 = 2000;
    for turned in [false, true] {
        // Squares along a diagonal, as one facet that runs there below and back above, and into each on the
        // way. Turned, the squares stand on their corners, one above the other.
        let (mut points, mut cycle) = (vec![[0, 0, 0]], vec![]);
        for i in 0..i64::from(N) {
            let corners = [[10, 0], [10, 10], [0, 10], [8, 2], [4, 2], [4, 6], [8, 6]];
            let place = |[x, y]: [i64; 2]| [x + 10 * i, y + 10 * i];
            points
                .extend(corners.map(place).map(|[x, y]| if turned { [x - y, x + y, 0] } else { [x, y, 0] }));
        }
        let last = |i: u32| if i == 0 { 0 } else { 7 * i - 5 };
        for i in 0..N {
            let [b, inner] = [7 * i + 1, 7 * i + 4];
            cycle.extend([last(i), b, inner, inner + 1, inner + 2, inner + 3, inner, b]);
        }
        cycle.push(last(N));
        (0..N).rev().for_each(|i| cycle.extend([7 * i + 3, last(i)]));
        cycle.pop();
        let (joined, _) = mend(&mesh(&points, &[&cycle]), JOIN);
        assert_eq!(joined.mesh.facets.len(), N as usize);
        for f in 0..joined.mesh.facets.len() {
            let [hole] = joined.holes_of(f) else { panic!("facet {f} has {:?}", joined.holes_of(f)) };
            assert_eq!(hole.cycle.len(), 4);
        }
        let cut = joined.clone().without_holes().expect("each hole is in its square");
        assert_eq!(cut.mesh.facets.len(), 8 * N as usize);
        assert!(cut.holes.is_empty() && cut.mesh.facets.iter().all(|cycle| cycle.len() == 3));
        assert_eq!(cut.facet_origin, vec![0; 8 * N as usize]);
    }
}
