use exact::*;
use splitstar_polytope::*;
fn main() {
    let n: u64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let mut s = 12345u64;
    let mut r = move || {
        s = s.wrapping_add(0x9E3779B97F4A7C15);
        let mut z = s;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58476D1CE4E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D049BB133111EB);
        z ^ (z >> 31)
    };
    let mut bad = 0;
    let mut dims = std::collections::BTreeMap::new();
    let mut tot = OverlayCounts::default();
    for i in 0..n {
        let range = [1, 2, 5][(i % 3) as usize];
        let mut mk = || {
            let k = if r() % 8 == 0 { 1 + r() % 4 } else { 4 + r() % 9 };
            let p: Vec<Point3> = (0..k)
                .map(|_| {
                    Point3::from_i64([0, 0, 0].map(|_: i64| (r() % (2 * range + 1)) as i64 - range as i64))
                })
                .collect();
            convex_hull(&p).unwrap()
        };
        let (a, b) = (mk(), mk());
        *dims.entry((a.dimension(), b.dimension())).or_insert(0) += 1;
        let s = minkowski_sum(&[&a, &b]);
        let h = minkowski_sum_by_hull(&[&a, &b]);
        let v = s.check_valid();
        let o = overlay_counts(&a, &b);
        tot.crossings += o.crossings;
        tot.common_normals += o.common_normals;
        tot.normals_on_arcs += o.normals_on_arcs;
        tot.overlaps += o.overlaps;
        tot.arcs_through_normals += o.arcs_through_normals;
        if !v.is_empty()
            || s.counts() != h.counts()
            || !s.same_set(&h)
            || s.dimension() != h.dimension()
            || s.volume() != h.volume()
            || !h.check_valid().is_empty()
        {
            bad += 1;
            if bad < 6 {
                println!(
                    "case {i} dims {} {} : {:?} vs {:?} {:?} {:?}",
                    a.dimension(),
                    b.dimension(),
                    s.counts(),
                    h.counts(),
                    v.first(),
                    h.check_valid().first()
                );
            }
        }
    }
    println!("bad {bad} of {n} {dims:?} {tot:?}");
}
