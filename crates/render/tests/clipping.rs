//! Clipping against its definition: what is left is what lies in the frame.

use splitstar_render::{
    Frame, Point, clip_closed_polyline, clip_line, clip_polyline, clip_ray, clip_ring, clip_segment,
};

fn frame() -> Frame {
    Frame::new([0.0, 0.0], [4.0, 2.0]).expect("in order")
}

#[test]
fn segments() {
    let rows: &[(Point, Point, Option<[Point; 2]>)] = &[
        ([1.0, 1.0], [2.0, 1.5], Some([[1.0, 1.0], [2.0, 1.5]])),
        ([-1.0, 1.0], [5.0, 1.0], Some([[0.0, 1.0], [4.0, 1.0]])),
        ([5.0, 1.0], [-1.0, 1.0], Some([[4.0, 1.0], [0.0, 1.0]])),
        ([-1.0, 3.0], [3.0, -1.0], Some([[0.0, 2.0], [2.0, 0.0]])),
        // Along a side, through a corner, at a corner, beside.
        ([-1.0, 2.0], [9.0, 2.0], Some([[0.0, 2.0], [4.0, 2.0]])),
        ([-1.0, 1.0], [1.0, -1.0], Some([[0.0, 0.0], [0.0, 0.0]])),
        ([4.0, 2.0], [9.0, 9.0], Some([[4.0, 2.0], [4.0, 2.0]])),
        ([-1.0, 0.5], [0.5, -1.0], None),
        ([5.0, 0.0], [5.0, 2.0], None),
        // Points.
        ([1.0, 1.0], [1.0, 1.0], Some([[1.0, 1.0], [1.0, 1.0]])),
        ([5.0, 1.0], [5.0, 1.0], None),
    ];
    for &(a, b, expected) in rows {
        assert_eq!(clip_segment(&frame(), a, b), expected, "{a:?} {b:?}");
    }
}

#[test]
fn rays_and_lines() {
    let frame = frame();
    assert_eq!(clip_ray(&frame, [1.0, 1.0], [2.0, 0.0]), Some([[1.0, 1.0], [4.0, 1.0]]));
    assert_eq!(clip_ray(&frame, [5.0, 1.0], [2.0, 0.0]), None);
    assert_eq!(clip_ray(&frame, [-3.0, -3.0], [7.0, 7.0]), Some([[0.0, 0.0], [2.0, 2.0]]));
    assert_eq!(clip_line(&frame, [5.0, 1.0], [2.0, 0.0]), Some([[0.0, 1.0], [4.0, 1.0]]));
    assert_eq!(clip_line(&frame, [1.0, 77.0], [0.0, -1e-320]), Some([[1.0, 2.0], [1.0, 0.0]]));
    assert_eq!(clip_line(&frame, [5.0, 77.0], [0.0, 1.0]), None);
    assert_eq!(clip_line(&frame, [1.0, 1.0], [0.0, 0.0]), Some([[1.0, 1.0], [1.0, 1.0]]));
    assert_eq!(clip_ray(&frame, [1.0, 3.0], [0.0, 0.0]), None);
}

#[test]
fn huge_coordinates_do_not_overflow() {
    let huge = f64::MAX;
    let frame = Frame::new([-1.0, -1.0], [1.0, 1.0]).unwrap();
    assert_eq!(clip_segment(&frame, [-huge, 0.5], [huge, 0.5]), Some([[-1.0, 0.5], [1.0, 0.5]]));
    let all = Frame::new([-huge, -huge], [huge, huge]).unwrap();
    for direction in [[1.0, 0.0], [huge, -huge], [1e-320, 1e-310], [0.0, -5e-324]] {
        for point in [[0.0, 0.0], [huge, huge], [-huge, 3.0], [1.0, 1e-320]] {
            for [a, b] in
                clip_line(&all, point, direction).into_iter().chain(clip_ray(&all, point, direction))
            {
                assert!(all.contains(a) && all.contains(b), "{point:?} {direction:?}");
            }
        }
    }
    let ring = [[-huge, -huge], [huge, -huge], [huge, huge], [-huge, huge]];
    let clipped = clip_ring(&frame, &ring);
    assert_eq!(clipped.len(), 4);
    assert!(frame.corners().iter().all(|corner| clipped.contains(corner)));
}

#[test]
fn polylines_fall_into_parts() {
    let frame = frame();
    let zigzag = [[1.0, 1.0], [1.0, 3.0], [2.0, 3.0], [2.0, 1.0], [3.0, 1.0]];
    let parts = clip_polyline(&frame, &zigzag);
    assert_eq!(parts, [vec![[1.0, 1.0], [1.0, 2.0]], vec![[2.0, 2.0], [2.0, 1.0], [3.0, 1.0]]]);
    assert_eq!(clip_polyline(&frame, &[]), [] as [Vec<Point>; 0]);
    assert_eq!(clip_polyline(&frame, &[[4.0, 2.0]]), [[[4.0, 2.0]]]);

    // Closed, the part through the first point is one.
    let (parts, closed) = clip_closed_polyline(&frame, &zigzag);
    assert!(!closed);
    assert_eq!(parts, [vec![[2.0, 2.0], [2.0, 1.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0]]]);
    let triangle = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]];
    assert_eq!(clip_closed_polyline(&frame, &triangle), (vec![triangle.to_vec()], true));
    assert_eq!(clip_closed_polyline(&frame, &[[9.0, 9.0], [10.0, 9.0]]), (vec![], false));
    assert_eq!(clip_closed_polyline(&frame, &[]), (vec![], true));
}

fn twice_area(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

#[test]
fn rings_keep_their_winding() {
    let frame = frame();
    let around = [[-1.0, -1.0], [9.0, -1.0], [9.0, 9.0], [-1.0, 9.0]];
    assert!((twice_area(&clip_ring(&frame, &around)) - 16.0).abs() < 1e-12);
    let turned: Vec<Point> = around.iter().rev().copied().collect();
    assert!((twice_area(&clip_ring(&frame, &turned)) + 16.0).abs() < 1e-12);
    // A ring that leaves twice: two parts, joined along the side.
    let fork = [[1.0, 1.0], [5.0, 0.5], [5.0, 0.75], [3.0, 1.0], [5.0, 1.25], [5.0, 1.5]];
    let clipped = clip_ring(&frame, &fork);
    assert!(clipped.iter().all(|&point| frame.contains(point)));
    assert!(twice_area(&clipped) > 0.0 && twice_area(&clipped) < twice_area(&fork));
    assert!(clip_ring(&frame, &[[5.0, 0.0], [6.0, 0.0], [6.0, 1.0]]).is_empty());
    assert!(clip_ring(&frame, &[]).is_empty());
    let inside = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]];
    assert_eq!(clip_ring(&frame, &inside), inside);
}
