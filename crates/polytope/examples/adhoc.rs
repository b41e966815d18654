use exact::*;
use splitstar_polytope::*;
use std::time::Instant;
fn read(p: &str) -> PolygonMesh {
    let t = std::fs::read_to_string(p).unwrap();
    let mut l = t.lines().filter(|l| !l.trim().is_empty() && !l.starts_with('#'));
    l.next();
    let c: Vec<usize> = l.next().unwrap().split_whitespace().map(|x| x.parse().unwrap()).collect();
    let mut m = PolygonMesh::default();
    for _ in 0..c[0] {
        let q: Vec<Rational> =
            l.next().unwrap().split_whitespace().take(3).map(|x| x.parse().unwrap()).collect();
        m.points.push(Point3::from_rationals(&[q[0].clone(), q[1].clone(), q[2].clone()]));
    }
    for _ in 0..c[1] {
        let q: Vec<u32> = l.next().unwrap().split_whitespace().map(|x| x.parse().unwrap()).collect();
        m.facets.push(&q[1..1 + q[0] as usize]);
    }
    m
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let dir = &a[1];
    let md = std::fs::read_to_string(format!("{dir}/README.md")).unwrap();
    let mut on = false;
    let mut bad = 0;
    for line in md.lines() {
        if line.starts_with("## Expected sums of convex") {
            on = true
        } else if line.starts_with("## ") {
            on = false
        }
        if !on || !line.starts_with("| ") || line.starts_with("| sum") {
            continue;
        }
        let c: Vec<&str> = line.split('|').map(|x| x.trim()).collect();
        let Some((p, q)) = c[1].split_once(" + ") else { continue };
        let (mp, mq) = (read(&format!("{dir}/{p}")), read(&format!("{dir}/{q}")));
        let mut n = vec![];
        let (pp, qq) = match (Polytope::from_mesh(&mp, &mut n), Polytope::from_mesh(&mq, &mut n)) {
            (Ok(a), Ok(b)) => (a, b),
            (x, y) => {
                println!("{p} {q} {:?} {:?}", x.err(), y.err());
                bad += 1;
                continue;
            }
        };
        let s = minkowski_sum(&[&pp, &qq]);
        let cc = s.counts();
        let got = format!("{}/{}/{}", cc.vertices, cc.edges, cc.facets);
        let o = overlay_counts(&pp, &qq);
        let ok = got == c[2]
            && o.crossings.to_string() == c[3]
            && o.common_normals.to_string() == c[4]
            && o.normals_on_arcs.to_string() == c[5];
        let v = s.check_valid();
        let mut best = f64::MAX;
        let mut parts = [f64::MAX; 2];
        for _ in 0..if cc.edges < 3000 { 50 } else { 10 } {
            let t = Instant::now();
            let mut n = vec![];
            let a = Polytope::from_mesh(&mp, &mut n).unwrap();
            let b = Polytope::from_mesh(&mq, &mut n).unwrap();
            let t1 = t.elapsed().as_secs_f64();
            let s = minkowski_sum(&[&a, &b]);
            std::hint::black_box(&s);
            let e = t.elapsed().as_secs_f64();
            best = best.min(e);
            parts[0] = parts[0].min(t1);
            parts[1] = parts[1].min(e - t1);
        }
        if !ok || !v.is_empty() {
            bad += 1;
        }
        println!(
            "{} {p}+{q} {got} {} {:?} valid {:?} notes {:?}  {:.1} us ({:.1}+{:.1}) {:.0} ns/edge",
            if ok { "ok " } else { "BAD" },
            c[2],
            o,
            v.first(),
            n,
            best * 1e6,
            parts[0] * 1e6,
            parts[1] * 1e6,
            best * 1e9 / cc.edges as f64
        );
    }
    println!("bad {bad}");
}
