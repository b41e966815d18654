//! Counts of simple cases, by formulas.

use crate::laws::check;
use exact::planar::Point2;
use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
use splitstar_arrangement::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use splitstar_arrangement::traits::UMonotoneTraits;
use splitstar_arrangement::{Arrangement, Pieces};

/// Vertices, edges and faces of the complex.
fn cells<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, context: &str) -> [usize; 3] {
    check(arrangement, context);
    let complex = VerticalDecomposition::new(arrangement).complex(arrangement).unwrap();
    let dcel = complex.dcel();
    [dcel.vertex_count(), dcel.edge_count(), dcel.face_count()]
}

fn segments(ends: &[[[i64; 2]; 2]]) -> Arrangement<SegmentTraits, BoundedPlane> {
    let segments: Vec<Segment> = ends.iter().map(|&ends| Segment::from_i64(ends).unwrap()).collect();
    Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments)
}

#[test]
fn nothing_is_one_face() {
    assert_eq!(cells(&segments(&[]), "the plane"), [1, 0, 1]);
    let plane = Arrangement::new(LinearTraits, UnboundedPlane);
    assert_eq!(cells(&plane, "the open plane"), [1, 0, 1]);
    let torus = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    assert_eq!(cells(&Arrangement::new(torus, FlatTorus), "the torus"), [1, 2, 1]);
}

/// Segments one above the other, each within the range of the one below: of every upper end the walls meet the segment below, and a
/// side.
#[test]
fn stairs() {
    for n in 1..12 {
        let ends: Vec<_> = (0..n).map(|i| [[i, 3 * i], [2 * n + 7 - i, 3 * i + 1]]).collect();
        let arrangement = segments(&ends);
        let made = VerticalDecomposition::new(&arrangement);
        let n = n as usize;
        assert_eq!(made.trapezoid_count(), 3 * n + 1);
        // A foot for each end but those of the lowest; each end has two walls.
        let [v, e, f] = cells(&arrangement, "stairs");
        assert_eq!([v, f], [2 * n + 1 + 2 * (n - 1), 3 * n + 1]);
        assert_eq!(e, n + 2 * (n - 1) + 4 * n);
    }
}

/// Points straight above one another are on one line; what is between two of them is a wall of both.
#[test]
fn a_column_of_points() {
    for n in 1..8_i64 {
        let mut pieces = Pieces::new();
        (0..n).for_each(|v| pieces.push_point(Point2::from_i64([1, v])));
        let arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
        let made = VerticalDecomposition::new(&arrangement);
        let n = n as usize;
        assert_eq!(made.trapezoid_count(), n + 1);
        assert_eq!(made.trapezoids().filter(|&t| made.is_degenerate(t)).count(), n - 1);
        assert_eq!(cells(&arrangement, "a column"), [n + 1, n + 1, 2]);
        let walls: Vec<_> = made.sites().map(|site| made.walls(site)).collect();
        for (i, [below, above]) in walls.into_iter().enumerate() {
            let vertex = |i: usize| WallEnd::Vertex(made.vertex(made.sites().nth(i).unwrap()));
            assert_eq!(below, if i == 0 { WallEnd::Side } else { vertex(i - 1) });
            assert_eq!(above, if i + 1 == n { WallEnd::Side } else { vertex(i + 1) });
        }
    }
}

/// A wall that comes down and one that goes up meet an edge in one point.
#[test]
fn feet_from_both_sides_are_one() {
    let arrangement = segments(&[[[0, 0], [8, 0]], [[4, 2], [6, 3]], [[4, -2], [6, -3]]]);
    // Feet at 4 and at 6.
    assert_eq!(cells(&arrangement, "both sides"), [6 + 2 + 1, 3 + 2 + 12, 10]);
}

#[test]
fn a_vertical_edge_has_no_wall_beside_it() {
    let arrangement = segments(&[[[1, 0], [1, 4]]]);
    assert_eq!(cells(&arrangement, "a vertical segment"), [3, 3, 2]);
    let made = VerticalDecomposition::new(&arrangement);
    let walls: Vec<_> = made.sites().map(|site| made.walls(site)).collect();
    assert_eq!(walls, [[WallEnd::Side, WallEnd::Nothing], [WallEnd::Nothing, WallEnd::Side]]);
}

fn lines(points: &[[[i64; 2]; 2]]) -> Arrangement<LinearTraits, UnboundedPlane> {
    let line = |&points: &[[i64; 2]; 2]| {
        let [p, q] = points.map(Point2::from_i64);
        Linear::line(&p, &q).unwrap()
    };
    let lines: Vec<Linear> = points.iter().map(line).collect();
    Arrangement::of_curves(LinearTraits, UnboundedPlane, &lines)
}

/// n lines in general position, none vertical: each crossing has two walls.
#[test]
fn lines_in_general_position() {
    for n in 0..7_i64 {
        let points: Vec<_> = (0..n).map(|i| [[0, i * i * i], [1, i * i * i + i * 7 + i * i]]).collect();
        let arrangement = lines(&points);
        let crossings = arrangement.counts().vertices;
        let n = n as usize;
        assert_eq!(crossings, n * n.saturating_sub(1) / 2);
        let faces = arrangement.counts().faces;
        // A wall divides a face in two.
        assert_eq!(cells(&arrangement, "lines")[2], faces + 2 * crossings);
    }
    assert_eq!(cells(&lines(&[[[3, 0], [3, 1]]]), "a vertical line"), [1, 1, 2]);
    assert_eq!(cells(&lines(&[[[3, 0], [3, 1]], [[0, 0], [1, 0]]]), "a cross"), [2, 4, 4]);
}

/// The vertical through a point on a torus comes back to it: the feet on the identified sides are one.
#[test]
fn a_point_on_a_torus() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let torus = |point: [i64; 2]| {
        let point = traits.point(&Point2::from_i64(point));
        let mut arrangement = Arrangement::new(traits.clone(), FlatTorus);
        arrangement.insert_points([point]);
        cells(&arrangement, "a point on a torus")
    };
    // The corner, the point and a foot.
    assert_eq!(torus([1, 1]), [3, 5, 2]);
    // On the left side; on the bottom, with a wall up; in the corner.
    assert_eq!(torus([0, 1]), [2, 3, 1]);
    assert_eq!(torus([1, 0]), [2, 4, 2]);
    assert_eq!(torus([0, 0]), [1, 2, 1]);
}

/// An edge all along the bottom of a torus is no wall, but cuts it open.
#[test]
fn a_path_along_the_sides_of_a_torus() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let corner = Point2::from_i64([0, 0]);
    for way in [[1, 0], [0, 1]] {
        let path = traits.closed_path(&corner, way).unwrap();
        let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, [&path]);
        assert_eq!(cells(&arrangement, &format!("along {way:?}")), [1, 2, 1]);
    }
}

/// After a change, what needs the arrangement gives an error.
#[test]
fn a_decomposition_knows_its_arrangement() {
    let mut arrangement = segments(&[[[0, 0], [3, 1]]]);
    let made = VerticalDecomposition::new(&arrangement);
    let t = made.trapezoids().next().unwrap();
    assert_eq!(made.face_of(&arrangement, t), Ok(arrangement.corner_face()));
    arrangement.insert_points([Point2::from_i64([5, 5])]);
    assert!(made.face_of(&arrangement, t).is_err());
    assert!(made.complex(&arrangement).is_err());
    fn is_static<T: 'static + Send + Sync>(_: &T) {}
    is_static(&made);
}
