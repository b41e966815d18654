use exact::spherical::{Direction, GreatCircle};
use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::location::{PointLocation, Naive, Walk, TrapezoidalMap, VerticalRay};
use splitstar_arrangement::{Arrangement, Editor};

fn d(c: [i64; 3]) -> Direction { Direction::from_i64(c).unwrap() }
fn circle(n: [i64; 3]) -> Geodesic { Geodesic::circle(GreatCircle::from_i64(n).unwrap()) }
fn arc(p: [i64; 3], q: [i64; 3]) -> Geodesic { Geodesic::arc(d(p), d(q)).unwrap() }

fn check(name: &str, curves: &[Geodesic], expected: [usize; 3]) {
    let a = Arrangement::of_curves(GeodesicTraits::new(), Sphere, curves);
    assert_eq!(a.check_valid(), [], "{name}");
    let c = a.counts();
    assert_eq!([c.vertices, c.edges, c.faces], expected, "{name}: {:?}", a.counts_with_splits());
    let mut e = Editor::new(Arrangement::new(GeodesicTraits::new(), Sphere));
    let mut edges = Vec::new();
    for curve in curves {
        edges.push(e.insert_curve(curve));
        assert_eq!(e.arrangement().check_valid(), [], "{name} by increments");
    }
    assert_eq!(e.arrangement().difference(&a), None, "{name}");
    let map = TrapezoidalMap::new(&a);
    for x in -2..=2 { for y in -2..=2 { for z in -2..=2 {
        let Some(p) = Direction::from_i64([x, y, z]) else { continue };
        let n = Naive.locate(&a, &p);
        assert_eq!(Walk.locate(&a, &p), n, "{name} {p} walk");
        assert_eq!(map.locate(&a, &p), n, "{name} {p} map");
        for ray in [VerticalRay::Up, VerticalRay::Down] {
            let n = Naive.shoot(&a, &p, ray);
            assert_eq!(Walk.shoot(&a, &p, ray), n, "{name} {p} walk {ray:?}");
            assert_eq!(map.shoot(&a, &p, ray), n, "{name} {p} map {ray:?}");
        }
    }}}
}

#[test]
fn tables() {
    check("nothing", &[], [0, 0, 1]);
    check("equator", &[circle([0, 0, 1])], [1, 1, 2]);
    check("meridian circle", &[circle([1, 0, 0])], [1, 1, 2]);
    check("seam circle", &[circle([0, 1, 0])], [1, 1, 2]);
    check("tilted", &[circle([1, 2, 3])], [1, 1, 2]);
    check("coordinate circles", &[circle([1, 0, 0]), circle([0, 1, 0]), circle([0, 0, 1])], [6, 12, 8]);
    check("pole point", &[Geodesic::point(d([0, 0, 1]))], [1, 0, 1]);
    check("south point", &[Geodesic::point(d([0, 0, -1]))], [1, 0, 1]);
    check("both", &[Geodesic::point(d([0, 0, -1])), Geodesic::point(d([0, 0, 1])), Geodesic::point(d([-1, 0, 0]))], [3, 0, 1]);
    check("arc over the pole", &[arc([1, 0, 1], [-1, 0, 1])], [2, 1, 1]);
    check("arc over the pole 2", &[arc([1, 1, 1], [-1, -1, 1])], [2, 1, 1]);
    check("arc to the pole", &[arc([1, 1, 1], [0, 0, 1])], [2, 1, 1]);
    check("arc on the seam to the pole", &[arc([-1, 0, 1], [0, 0, 1])], [2, 1, 1]);
    check("point on arc over pole", &[arc([1, 1, 1], [-1, -1, 1]), Geodesic::point(d([0, 0, 1]))], [3, 2, 1]);
    check("octant", &[arc([1, 0, 0], [0, 1, 0]), arc([0, 1, 0], [0, 0, 1]), arc([0, 0, 1], [1, 0, 0])], [3, 3, 2]);
    let mut mirrors = vec![[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    mirrors.extend([[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]);
    let nine: Vec<_> = mirrors.iter().map(|&n| circle(n)).collect();
    check("nine", &nine, [26, 72, 48]);
    mirrors.extend([[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]);
    let thirteen: Vec<_> = mirrors.iter().map(|&n| circle(n)).collect();
    check("thirteen", &thirteen, [50, 144, 96]);
}
