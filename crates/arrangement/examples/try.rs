use exact::Sign;
use exact::planar::*;
use splitstar_arrangement::topology::*;
use splitstar_arrangement::traits::*;
use splitstar_arrangement::*;
use std::cmp::Ordering;
#[derive(Clone, Debug)]
struct Seg {
    line: Line2,
    ends: [Point2; 2],
}
#[derive(Clone, Debug)]
struct Tr;
fn ord(s: Sign) -> Ordering {
    match s {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    }
}
impl BasicTraits for Tr {
    type Point = Point2;
    type UMonotoneCurve = Seg;
    const MEET_ONCE: bool = true;
    fn compare_u(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_x(p, q)
    }
    fn compare_uv(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_xy(p, q)
    }
    fn end_point<'a>(&self, c: &'a Seg, e: CurveEnd) -> Option<&'a Point2> {
        Some(&c.ends[e as usize])
    }
    fn is_vertical(&self, c: &Seg) -> bool {
        c.line.is_vertical()
    }
    fn compare_v_at_u(&self, p: &Point2, c: &Seg) -> Ordering {
        if c.line.is_vertical() {
            if compare_y(p, &c.ends[0]).is_lt() {
                Ordering::Less
            } else if compare_y(p, &c.ends[1]).is_gt() {
                Ordering::Greater
            } else {
                Ordering::Equal
            }
        } else {
            ord(side_of_line(p, &c.line))
        }
    }
    fn compare_v_at_u_right(&self, a: &Seg, b: &Seg, _: &Point2) -> Ordering {
        a.line.compare_slope(&b.line)
    }
}
impl BoundedTraits for Tr {}
impl UMonotoneTraits for Tr {
    fn intersect(&self, a: &Seg, b: &Seg, out: &mut Vec<Intersection<Point2, Seg>>) {
        let _ = (a, b, out);
        unimplemented!()
    }
    fn split(&self, _c: &Seg, _p: &Point2) -> [Seg; 2] {
        unimplemented!()
    }
    fn next_meeting(&self, below: &Seg, above: &Seg, w: Window<'_, Point2>) -> Meeting<Point2> {
        let until = w.until.unwrap();
        let s = if w.first_to_end == 0 {
            side_of_line(until, &above.line)
        } else {
            -side_of_line(until, &below.line)
        };
        match s {
            Sign::Negative => Meeting::Never,
            Sign::Zero => Meeting::AtEnd,
            Sign::Positive => {
                Meeting::At(Point2::crossing(&below.line, &above.line).unwrap(), Multiplicity::Odd)
            }
        }
    }
}
fn main() {
    let mut s = 1u64;
    let a: Vec<String> = std::env::args().collect();
    let n: usize = a[2].parse().unwrap();
    let mut next = move || {
        s = s.wrapping_add(0x9E3779B97F4A7C15);
        let mut z = s;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58476D1CE4E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D049BB133111EB);
        z ^ (z >> 31)
    };
    let mut segs = vec![];
    let d: Option<u32> = a[1].strip_prefix('s').map(|x| x.parse().unwrap());
    while segs.len() < n {
        let mut c = |k: u32| (next() >> (64 - k)) as i64;
        let v = match d {
            None => [c(20), c(20), c(20), c(20)],
            Some(d) => {
                let x = c(20);
                let y = c(20);
                let h = 1i64 << (d - 1);
                let p = c(d) - h;
                let q = c(d) - h;
                [x, y, x + p, y + q]
            }
        };
        let inr = |x: i64| (0..1 << 20).contains(&x);
        if (v[0] == v[2] && v[1] == v[3]) || !inr(v[2]) || !inr(v[3]) {
            continue;
        }
        let mut e = [Point2::from_i64([v[0], v[1]]), Point2::from_i64([v[2], v[3]])];
        if compare_xy(&e[0], &e[1]).is_gt() {
            e.swap(0, 1);
        }
        segs.push(Seg { line: Line2::through(&e[0], &e[1]).unwrap(), ends: e });
    }
    for _ in 0..3 {
        let p = Pieces::<Tr> { is_artificial: vec![[false; 2]; n], curves: segs.clone(), points: vec![] };
        let t = std::time::Instant::now();
        let arr = Arrangement::of_pieces(Tr, BoundedPlane, p);
        let dt = t.elapsed();
        println!("{:?} {:?}", arr.counts_with_splits(), dt);
    }
    let rss = std::fs::read_to_string("/proc/self/status").unwrap();
    for l in rss.lines() {
        if l.starts_with("VmHWM") {
            println!("{l}");
        }
    }
}
