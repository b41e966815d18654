//! What keys must tell.

use super::*;

#[test]
fn keys_tell_most_of_random_input() {
    // No other test forces a tier meanwhile.
    let _guard = force(Start::Usual);
    let mut random = Random::new(76);
    for bits in [10, 20, 30, 50, 62] {
        let mut draw = || direction([(); 3].map(|()| random.around_zero((1 << bits) - 1)));
        let points: Vec<_> = (0..400).map(|_| draw()).collect();
        let circles: Vec<_> =
            points.chunks(2).filter_map(|pair| GreatCircle::through(&pair[0], &pair[1])).collect();
        let crossings: Vec<_> =
            circles.windows(2).filter_map(|pair| Direction::crossing(&pair[0], &pair[1])).collect();
        for meridian in meridians(&[[-1, 0], [355, 113]]) {
            let known = |points: &[Direction]| points.iter().filter(|p| meridian.order_key(p) != 0).count();
            assert!(known(&points) >= 390, "{bits} bits: {}", known(&points));
            assert!(known(&crossings) + 6 >= crossings.len(), "{bits} bits: {}", known(&crossings));
            let ranges = crossings.iter().filter(|p| meridian.order_range(p).1 < 1 << 12).count();
            assert!(ranges + 4 >= crossings.len(), "{bits} bits: {ranges}");
            let different: std::collections::HashSet<_> =
                points.iter().map(|p| meridian.order_key(p)).collect();
            assert!(bits < 20 || different.len() >= 390, "{bits} bits: {}", different.len());
        }
        let told = circles.iter().flat_map(|circle| points.iter().map(move |p| (p, circle)));
        let (mut asked, mut known) = (0, 0);
        for (p, circle) in told {
            asked += 1;
            known += usize::from(side_of_key(p, &circle.side_key()).is_some());
        }
        assert!(known * 100 > asked * 99 - 100 * 2 * circles.len(), "{bits} bits: {known} of {asked}");
    }
}

#[test]
fn points_on_a_circle_are_never_decided_by_its_key() {
    let mut random = Random::new(77);
    for bits in [3, 10, 20, 31, 50, 61] {
        for _ in 0..100 {
            let mut draw = || Direction::from_i64([(); 3].map(|()| random.around_zero(1 << bits)));
            let (Some(p), Some(q), Some(r)) = (draw(), draw(), draw()) else { continue };
            let Some(circle) = GreatCircle::through(&p, &q) else { continue };
            let other = GreatCircle::through(&r, &p).into_iter().chain(GreatCircle::new(&r.vector()));
            let crossings: Vec<_> = other.filter_map(|other| Direction::crossing(&circle, &other)).collect();
            for on in [p, q].iter().chain(&crossings) {
                assert_eq!(side_of_key(on, &circle.side_key()), None, "{on} by the key of {circle}");
            }
        }
    }
}

#[test]
fn keys_are_not_asked_where_boxes_are_not() {
    let (p, circle) = (direction([1, 2, 3]), circle([1, 1, 1]));
    for start in ALL_STARTS {
        let _guard = force(start);
        let are_boxes_asked = matches!(start, Start::Usual | Start::Float);
        assert_eq!(side_of_key(&p, &circle.side_key()).is_some(), are_boxes_asked, "{start:?}");
        assert_eq!(Meridian::default().order_key(&p) != 0, are_boxes_asked, "{start:?}");
    }
}
