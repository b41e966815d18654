use super::*;
use crate::Arrangement;
use crate::topology::Sphere;
use exact::spherical::GreatCircle;

fn direction(coordinates: [i64; 3]) -> Direction {
    Direction::from_i64(coordinates).unwrap()
}

fn circle(normal: [i64; 3]) -> Geodesic {
    Geodesic::circle(GreatCircle::from_i64(normal).unwrap())
}

fn identifications() -> Vec<GeodesicTraits> {
    [[-1, 0], [0, 1], [1, 1], [2, -1], [-3, 1], [1, 0]]
        .into_iter()
        .map(|[x, y]| GeodesicTraits::with_identification([x.into(), y.into()]).unwrap())
        .collect()
}

/// Vertices, edges and faces under every identification.
fn assert_counts(name: &str, curves: &[Geodesic], expected: [usize; 3]) {
    for traits in identifications() {
        let arrangement = Arrangement::of_curves(traits.clone(), Sphere, curves);
        let identification = traits.identification();
        assert_eq!(arrangement.check_valid(), [], "{name}, {identification}");
        let counts = arrangement.counts();
        assert_eq!([counts.vertices, counts.edges, counts.faces], expected, "{name}, {identification}");
    }
}

fn arcs(ends: &[[[i64; 3]; 2]]) -> Vec<Geodesic> {
    ends.iter().map(|ends| ends.map(direction)).map(|[p, q]| Geodesic::arc(p, q).unwrap()).collect()
}

fn via(p: [i64; 3], via: [i64; 3], q: [i64; 3]) -> Geodesic {
    Geodesic::arc_via(direction(p), &direction(via), direction(q)).unwrap()
}

#[test]
fn arrangements_of_great_circles() {
    let range = || -1..=1_i64;
    let all = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    // One of each pair of opposite normals.
    let normals: Vec<_> = all.filter(|&n| n > [0; 3]).collect();
    let thirteen: Vec<_> = normals.iter().map(|&n| circle(n)).collect();
    assert_counts("axes of the cube", &thirteen, [50, 144, 96]);
    let is_mirror = |n: &&[i64; 3]| n.iter().filter(|&&x| x != 0).count() < 3;
    let nine: Vec<_> = normals.iter().filter(is_mirror).map(|&n| circle(n)).collect();
    assert_counts("mirrors of the cube", &nine, [26, 72, 48]);
    let planes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(circle);
    assert_counts("octahedron", &planes, [6, 12, 8]);
    for axis in [[0, 0, 1], [1, 0, 0], [1, 1, 1], [-1, 0, 2]] {
        for k in 2..6_usize {
            let through = (0..k as i64).map(|i| {
                let other = direction([i * i - 2, 3 * i + 1, 1 - i]);
                Geodesic::circle(GreatCircle::through(&direction(axis), &other).unwrap())
            });
            assert_counts("pencil", &through.collect::<Vec<_>>(), [2, 2 * k, 2 * k]);
        }
    }
    assert_counts("one circle", &[circle([1, 2, 3])], [1, 1, 2]);
    assert_counts("the equator, twice", &[circle([0, 0, 1]), circle([0, 0, -1])], [1, 1, 2]);
    assert_counts("a meridian", &[circle([0, 1, 0])], [1, 1, 2]);
}

#[test]
fn arrangements_of_arcs() {
    let octant = [[[1, 0, 0], [0, 1, 0]], [[0, 1, 0], [0, 0, 1]], [[0, 0, 1], [1, 0, 0]]];
    assert_counts("a triangle at the pole", &arcs(&octant), [3, 3, 2]);
    let around = [[[1, 0, 1], [-1, 1, 1]], [[-1, 1, 1], [-1, -1, 1]], [[-1, -1, 1], [1, 0, 1]]];
    assert_counts("a triangle around the pole", &arcs(&around), [3, 3, 2]);
    assert_counts("an arc", &arcs(&[[[-1, -1, 0], [-1, 1, 1]]]), [2, 1, 1]);
    let over = via([1, 0, 0], [0, 0, 1], [-1, 0, 0]);
    assert_counts("over the pole", std::slice::from_ref(&over), [2, 1, 1]);
    let lower = via([1, 0, 0], [0, 0, -1], [-1, 0, 0]);
    assert_counts("over both poles", &[over.clone(), lower.clone()], [2, 2, 2]);
    assert_counts("and the equator", &[over, lower, circle([0, 0, 1])], [2, 4, 4]);
    let full = Geodesic::arc_around(
        direction([1, 0, 0]),
        direction([1, 0, 0]),
        GreatCircle::from_i64([0, 1, 0]).unwrap(),
    );
    assert_counts("a meridian with a vertex", &[full.unwrap()], [1, 1, 2]);
    assert_counts("half", &[via([1, 1, 1], [-1, 0, 0], [-1, -1, -1])], [2, 1, 1]);
    let long = [via([1, 0, 0], [-1, 0, 0], [0, 1, 0]), via([1, 0, 1], [-1, 0, -1], [0, 1, 0])];
    assert_counts("long arcs of two circles", &long, [4, 4, 2]);
}
