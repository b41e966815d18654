//! Curves as data.

use crate::space::{
    Matrix, P, at, between, compare_way, cross, dot, image, image_of_normal, is_zero, opposite, primitive,
    turn,
};
use exact::{Integer, Sign};
use std::cmp::Ordering;
use std::fmt;

/// A curve on the sphere, or a point.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Curve {
    Point(P),
    /// The shorter arc between two points.
    Short(P, P),
    /// The arc from the first point through the second to the third.
    Via(P, P, P),
    /// From the first point to the second, counterclockwise round the third; all round, if both are the same.
    Around(P, P, P),
    /// All round a normal.
    Circle(P),
}

impl fmt::Debug for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut write = |kind: &str, points: &[&P]| {
            f.write_str(kind)?;
            points.iter().try_for_each(|[x, y, z]| write!(f, "  {x} {y} {z}"))
        };
        match self {
            Self::Point(p) => write("point", &[p]),
            Self::Short(p, q) => write("arc", &[p, q]),
            Self::Via(p, r, q) => write("arc through", &[p, r, q]),
            Self::Around(p, q, n) => write("arc around", &[p, q, n]),
            Self::Circle(n) => write("circle", &[n]),
        }
    }
}

/// What a curve is: a point, or a part of an oriented circle.
#[derive(Clone, Debug)]
pub(crate) struct Arc {
    /// Without a common factor; all zero for a point.
    pub(crate) normal: P,
    /// The points where it begins and ends, counterclockwise; the same for a point, and for a circle with a vertex.
    pub(crate) ends: Option<[P; 2]>,
}

impl Arc {
    pub(crate) fn is_point(&self) -> bool {
        is_zero(&self.normal)
    }

    /// Whether a point is on it, ends included.
    pub(crate) fn has(&self, p: &P) -> bool {
        match &self.ends {
            Some([a, _]) if self.is_point() => a == p,
            Some([a, b]) => self.is_on_circle(p) && (a == b || compare_way(&self.normal, a, p, b).is_le()),
            None => self.is_on_circle(p),
        }
    }

    pub(crate) fn has_inside(&self, p: &P) -> bool {
        !self.is_point() && self.has(p) && !self.ends.iter().flatten().any(|end| end == p)
    }

    fn is_on_circle(&self, p: &P) -> bool {
        dot(&self.normal, p).is_zero()
    }

    /// Where it begins, or any point of a circle.
    pub(crate) fn start(&self) -> P {
        match &self.ends {
            Some([start, _]) => start.clone(),
            None => crate::space::orthogonal(&self.normal),
        }
    }

    /// The common points of two arcs on different circles.
    pub(crate) fn crossings(&self, other: &Self) -> Vec<P> {
        let axis = cross(&self.normal, &other.normal);
        if is_zero(&axis) {
            return Vec::new();
        }
        let p = primitive(&axis);
        let both = [opposite(&p), p];
        both.into_iter().filter(|p| self.has(p) && other.has(p)).collect()
    }

    /// Some points of the interior.
    pub(crate) fn inner_points(&self) -> Vec<P> {
        let [a, b] = self.ends.as_ref().expect("the arc has ends");
        let ahead = primitive(&self.forward(a));
        let behind = opposite(&ahead);
        let mut candidates = vec![between(a, &ahead), between(a, &behind), ahead, opposite(a), behind];
        if !is_zero(&cross(a, b)) {
            candidates.extend([between(a, b), opposite(&between(a, b))]);
        }
        candidates.retain(|p| self.has_inside(p));
        candidates
    }

    /// Compares points on it by the way from the start.
    pub(crate) fn compare(&self, a: &P, b: &P) -> Ordering {
        compare_way(&self.normal, &self.start(), a, b)
    }

    /// Where it goes from a point on it.
    pub(crate) fn forward(&self, p: &P) -> P {
        cross(&self.normal, p)
    }
}

impl Curve {
    pub(crate) fn arc(&self) -> Arc {
        let zero = [Integer::ZERO, Integer::ZERO, Integer::ZERO];
        let (normal, ends) = match self {
            Self::Point(p) => (zero, Some([p, p])),
            Self::Short(p, q) => (cross(p, q), Some([p, q])),
            Self::Via(p, r, q) => {
                let normal = if is_zero(&cross(p, r)) { cross(r, q) } else { cross(p, r) };
                let is_met_first = compare_way(&normal, p, r, q).is_lt();
                (if is_met_first { normal } else { opposite(&normal) }, Some([p, q]))
            }
            Self::Around(p, q, n) => (n.clone(), Some([p, q])),
            Self::Circle(n) => (n.clone(), None),
        };
        let normal = if is_zero(&normal) { normal } else { primitive(&normal) };
        Arc { normal, ends: ends.map(|ends| ends.map(primitive)) }
    }

    /// The image under a linear map.
    pub(crate) fn mapped(&self, map: &Matrix) -> Self {
        let of = |p| image(map, p);
        match self {
            Self::Point(p) => Self::Point(of(p)),
            Self::Short(p, q) => Self::Short(of(p), of(q)),
            Self::Via(p, r, q) => Self::Via(of(p), of(r), of(q)),
            Self::Around(p, q, n) => Self::Around(of(p), of(q), image_of_normal(map, n)),
            Self::Circle(n) => Self::Circle(image_of_normal(map, n)),
        }
    }

    /// The other way round.
    pub(crate) fn swapped(&self) -> Self {
        match self.clone() {
            Self::Point(p) => Self::Point(p),
            Self::Short(p, q) => Self::Short(q, p),
            Self::Via(p, r, q) => Self::Via(q, r, p),
            Self::Around(p, q, n) => Self::Around(q, p, opposite(&n)),
            Self::Circle(n) => Self::Circle(opposite(&n)),
        }
    }
}

pub(crate) fn mapped(curves: &[Curve], map: &Matrix) -> Vec<Curve> {
    curves.iter().map(|curve| curve.mapped(map)).collect()
}

pub(crate) fn point(p: [i64; 3]) -> Curve {
    Curve::Point(at(p))
}

pub(crate) fn short(p: [i64; 3], q: [i64; 3]) -> Curve {
    Curve::Short(at(p), at(q))
}

pub(crate) fn via(p: [i64; 3], r: [i64; 3], q: [i64; 3]) -> Curve {
    Curve::Via(at(p), at(r), at(q))
}

pub(crate) fn around(p: [i64; 3], q: [i64; 3], normal: [i64; 3]) -> Curve {
    Curve::Around(at(p), at(q), at(normal))
}

pub(crate) fn circle(normal: [i64; 3]) -> Curve {
    Curve::Circle(at(normal))
}

#[test]
fn arcs_go_where_they_are_told() {
    let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let minus = |a: [i64; 3]| a.map(|c| -c);
    let [p, q, r] = [x, y, z].map(at);
    let quarter = short(x, y).arc();
    assert_eq!(
        (&quarter.normal, quarter.has(&at([1, 1, 0])), quarter.has(&at([-1, 1, 0]))),
        (&r, true, false)
    );
    let long = via(x, minus(y), y).arc();
    assert_eq!(long.normal, opposite(&r));
    assert!(long.has(&opposite(&p)) && !long.has(&at([1, 1, 0])) && long.has(&q));
    let half = via(x, y, minus(x)).arc();
    assert!(half.has_inside(&q) && !half.has(&opposite(&q)) && half.has(&p) && !half.has_inside(&p));
    let full = around(x, x, z).arc();
    assert!(full.has(&at([-3, 4, 0])) && !full.has(&r) && !full.has_inside(&p));
    assert_eq!(circle(x).arc().crossings(&circle(y).arc()).len(), 2);
    assert_eq!(long.crossings(&circle(x).arc()), [q.clone(), opposite(&q)]);
    assert_eq!(turn(&p, &at([0, 1, 0]), &r), Sign::Positive);
}
