//! An oracle for faces: the plane is cut by the pieces and the sides of the strip, and the faces are glued along the sides.

use crate::paths::Curve;
use crate::strip::Strip;
use exact::planar::Point2;
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::traits::{ArrangementTraits, BasicTraits, Piece, SideKind};
use splitstar_arrangement::{Arrangement, Pieces};
use std::collections::BTreeMap;

/// The number of faces, counted without any surface but the plane.
pub(crate) fn face_count(size: [i64; 2], v: [SideKind; 2], curves: &[Curve]) -> usize {
    let [width, height] = size;
    let strip = Strip::<true> { size, v };
    let mut pieces = Vec::new();
    for curve in curves {
        strip.make_u_monotone(curve, &mut pieces);
    }
    let mut planar = Pieces::<SegmentTraits>::new();
    let mut segments: Vec<Segment> = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Curve { curve, .. } => segments.push(curve.segment),
            Piece::Point(point) => planar.push_point(point),
        }
    }
    let opposite = |p: &Point2| {
        let u = p.coordinates()[0].clone();
        let by = if u == 0.into() {
            width
        } else if u == width.into() {
            -width
        } else {
            return None;
        };
        Some(p.translated(&[by.into(), 0.into()]))
    };
    let ends = segments.iter().flat_map(|segment| [segment.min(), segment.max()]);
    let seam: Vec<Point2> = ends.chain(planar.points()).filter_map(opposite).collect();
    for point in seam {
        planar.push_point(point);
    }
    let corners = [[0, 0], [width, 0], [width, height], [0, height]];
    for i in 0..4 {
        planar.push_curve(Segment::from_i64([corners[i], corners[(i + 1) % 4]]).unwrap());
    }
    for segment in &segments {
        planar.push_curve(segment.clone());
    }
    let plane = Arrangement::of_pieces(SegmentTraits, BoundedPlane, planar);
    let dcel = plane.dcel();
    // Two more nodes: what lies beyond the bottom and the top.
    let count = dcel.face_bound();
    let mut parents: Vec<usize> = (0..count + 2).collect();
    fn find(parents: &mut [usize], mut node: usize) -> usize {
        while parents[node] != node {
            parents[node] = parents[parents[node]];
            node = parents[node];
        }
        node
    }
    let mut on_right = BTreeMap::new();
    let mut pairs = Vec::new();
    let key = |p: &Point2| p.coordinates()[1].clone();
    let mut on_left = Vec::new();
    for e in dcel.edges() {
        let [p, q] = dcel.ends(e).map(|v| plane.point(v).unwrap());
        let [above, below] = [e.halfedge(), e.halfedge().twin()].map(|h| dcel.face(h).index());
        let is_covered =
            segments.iter().any(|segment| [p, q].iter().all(|p| SegmentTraits.is_on_curve(p, segment)));
        let both = |axis: usize, at: i64| [p, q].iter().all(|p| p.coordinates()[axis] == at.into());
        if both(0, 0) {
            on_left.push((key(p), below, is_covered));
        } else if both(0, width) {
            on_right.insert(key(p), above);
        } else if both(1, 0) && v[0] == SideKind::Closed && !is_covered {
            pairs.push([above, count]);
        } else if both(1, height) && v[1] == SideKind::Closed && !is_covered {
            pairs.push([below, count + 1]);
        }
    }
    assert_eq!(on_left.len(), on_right.len(), "both sides are cut alike");
    for (v, face, is_covered) in on_left {
        let other = on_right[&v];
        if !is_covered {
            pairs.push([face, other]);
        }
    }
    for pair in pairs {
        let [a, b] = pair.map(|face| find(&mut parents, face));
        parents[a] = b;
    }
    let beyond = (0..2).filter(|&side| v[side] == SideKind::Closed).map(|side| count + side);
    let inside = dcel.faces().map(|f| f.index()).filter(|&f| f != plane.corner_face().index());
    let mut roots: Vec<usize> = inside.chain(beyond).collect();
    for node in &mut roots {
        *node = find(&mut parents, *node);
    }
    roots.sort_unstable();
    roots.dedup();
    roots.len()
}
