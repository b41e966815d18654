//! Families on the sphere: what is drawn, and how many cells it has. The identification is at (-1, 0, 0), unless somebody turns it.

mod sides;

use crate::arcs::{Curve, around, circle, point, short, via};
use sides::{along_one_circle, at_poles, at_the_identification};

pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) curves: Vec<Curve>,
    /// Vertices, edges, faces, isolated vertices, components.
    pub(crate) counts: [usize; 5],
}

type V = [i64; 3];

const NORTH: V = [0, 0, 1];
const SOUTH: V = [0, 0, -1];

fn cross([a, b, c]: V, [d, e, f]: V) -> V {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn minus(p: V) -> V {
    p.map(|c| -c)
}

/// Axes of pairs of antipodes: the poles, on the identification, and elsewhere; with two normals of circles through each.
const AXES: [(V, [V; 2]); 5] = [
    (NORTH, [[1, 0, 0], [0, 1, 0]]),
    ([-1, 0, 0], [[0, 1, 0], [0, 0, 1]]),
    ([-1, 0, 2], [[0, 1, 0], [2, 0, 1]]),
    ([1, 2, 3], [[2, -1, 0], [3, 0, -1]]),
    ([0, 1, 0], [[1, 0, 0], [0, 0, 1]]),
];

/// The normals of k circles through both points of an axis.
fn pencil([a, b]: [V; 2], k: i64) -> impl Iterator<Item = V> {
    let weights = [[1, 0], [0, 1], [1, 1], [1, -1], [1, 2], [2, 1], [1, -2], [2, -1], [1, 3]];
    weights.into_iter().take(k as usize).map(move |[s, t]| [0, 1, 2].map(|i| s * a[i] + t * b[i]))
}

/// All with coordinates of -1, 0 and 1, up to the sign, of which so many are not zero.
fn cube_axes(counts: &[usize]) -> Vec<V> {
    let all = (0..27).map(|i| [i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1]);
    let is_wanted = |v: &V| *v > minus(*v) && counts.contains(&v.iter().filter(|c| **c != 0).count());
    all.filter(is_wanted).collect()
}

/// The circles in which the symmetries of the cube mirror.
fn mirrors_of_the_cube() -> Vec<Curve> {
    cube_axes(&[1, 2]).into_iter().map(circle).collect()
}

fn mirrors_of_the_tetrahedron() -> Vec<Curve> {
    cube_axes(&[2]).into_iter().map(circle).collect()
}

/// Normal to the axes through corners, edges and faces of a cube.
fn normal_to_the_axes_of_the_cube() -> Vec<Curve> {
    cube_axes(&[1, 2, 3]).into_iter().map(circle).collect()
}

fn edges_of_the_octahedron() -> Vec<Curve> {
    let corners = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]];
    let sides = (0..4).map(|i| short(corners[i], corners[(i + 1) % 4]));
    sides.chain(corners.iter().flat_map(|&p| [short(p, NORTH), short(SOUTH, p)])).collect()
}

fn edges_of_the_cube() -> Vec<Curve> {
    let corners: Vec<V> = (0..8).map(|i| [0, 1, 2].map(|k| 2 * (i >> k & 1) - 1)).collect();
    let pairs = corners.iter().flat_map(|p| corners.iter().map(move |q| (*p, *q)));
    let are_next = |p: &V, q: &V| p < q && (0..3).filter(|&i| p[i] != q[i]).count() == 1;
    pairs.filter(|(p, q)| are_next(p, q)).map(|(p, q)| short(p, q)).collect()
}

/// k half circles from a point to its antipode.
fn lunes((axis, [a, b]): (V, [V; 2]), k: i64) -> Vec<Curve> {
    pencil([a, b], k).map(|normal| via(axis, cross(normal, axis), minus(axis))).collect()
}

/// A polygon of k corners about a point; size r.
fn polygon(center: V, k: i64, r: i64) -> Vec<Curve> {
    let corners: &[[i64; 2]] =
        if k == 3 { &[[2, -1], [-1, 2], [-1, -1]] } else { &[[1, 1], [-1, 1], [-1, -1], [1, -1]] };
    let other = if center[0] == 0 && center[1] == 0 { [1, 0, 0] } else { NORTH };
    let east = cross(other, center);
    let ahead = cross(center, east);
    let corner = |i: usize| {
        let [x, y] = corners[i % corners.len()];
        [0, 1, 2].map(|c| 20 * center[c] + r * (x * east[c] + y * ahead[c]))
    };
    (0..corners.len()).map(|i| short(corner(i), corner(i + 1))).collect()
}

fn star(center: V, k: i64) -> Vec<Curve> {
    let ends =
        [[3, 1, 2], [-3, 2, 1], [1, 4, -1], [-1, -4, 2], [2, -3, -2], [-5, 1, -1], [-2, -1, 4], [4, 4, 1]];
    ends.into_iter().take(k as usize).map(|end| short(center, end)).collect()
}

/// k arcs, one after the other, all round.
fn end_to_end(normal: V, start: V, k: usize) -> Vec<Curve> {
    let ahead = cross(normal, start);
    let steps: &[[i64; 2]] = match k {
        3 => &[[1, 0], [-1, 2], [-1, -2]],
        4 => &[[1, 0], [0, 1], [-1, 0], [0, -1]],
        _ => &[[1, 0], [1, 2], [-1, 2], [-1, 0], [-1, -1], [0, -1], [2, -1]],
    };
    let at = |i: usize| [0, 1, 2].map(|c| steps[i % k][0] * start[c] + steps[i % k][1] * ahead[c]);
    (0..k).map(|i| around(at(i), at(i + 1), normal)).collect()
}

fn with(mut curves: Vec<Curve>, more: &[Curve]) -> Vec<Curve> {
    curves.extend_from_slice(more);
    curves
}

/// Where things happen: at both poles, on the identification, opposite to it, and elsewhere.
const PLACES: [V; 6] = [NORTH, SOUTH, [-1, 0, 0], [-1, 0, 1], [1, 0, 0], [1, 2, -2]];

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    let mut add = |name: &str, curves: Vec<Curve>, counts| {
        rows.push(Row { name: name.into(), curves, counts });
    };
    add("nothing", vec![], [0, 0, 1, 0, 0]);
    whole(&mut add);
    at_places(&mut add);
    at_poles(&mut add);
    at_the_identification(&mut add);
    along_one_circle(&mut add);
    rows
}

type Add<'a> = &'a mut dyn FnMut(&str, Vec<Curve>, [usize; 5]);

/// Solids, pencils and grids.
fn whole(add: Add<'_>) {
    add("mirrors of the cube", mirrors_of_the_cube(), [26, 72, 48, 0, 1]);
    add("mirrors of the tetrahedron", mirrors_of_the_tetrahedron(), [14, 36, 24, 0, 1]);
    add("circles normal to the axes of the cube", normal_to_the_axes_of_the_cube(), [50, 144, 96, 0, 1]);
    add("coordinate circles", cube_axes(&[1]).into_iter().map(circle).collect(), [6, 12, 8, 0, 1]);
    add("circles normal to diagonals", cube_axes(&[3]).into_iter().map(circle).collect(), [12, 24, 14, 0, 1]);
    add("the octahedron", edges_of_the_octahedron(), [6, 12, 8, 0, 1]);
    add("the cube", edges_of_the_cube(), [8, 12, 6, 0, 1]);
    let both = with(edges_of_the_cube(), &edges_of_the_octahedron());
    add("the cube and the octahedron", both, [26, 48, 24, 0, 1]);
    let over = with(edges_of_the_octahedron(), &cube_axes(&[1]).into_iter().map(circle).collect::<Vec<_>>());
    add("the octahedron under circles", over, [6, 12, 8, 0, 1]);
    let axes: Vec<V> = cube_axes(&[1, 2, 3]).into_iter().flat_map(|v| [v, minus(v)]).collect();
    let points: Vec<Curve> = axes.iter().map(|&v| point(v)).collect();
    add("points on the axes of the cube", points.clone(), [26, 0, 1, 26, 26]);
    add("mirrors and points on their vertices", with(mirrors_of_the_cube(), &points), [26, 72, 48, 0, 1]);
    add("the cube and points", with(edges_of_the_cube(), &points), [26, 24, 6, 6, 7]);
    for k in [2, 3, 5, 8_usize] {
        for (axis, normals) in AXES {
            let circles: Vec<Curve> = pencil(normals, k as i64).map(circle).collect();
            let name = format!("{k} circles through {axis:?}");
            add(&name, circles.clone(), [2, 2 * k, 2 * k, 0, 1]);
            let with_points = with(circles.clone(), &[point(axis), point(minus(axis))]);
            add(&format!("{name} and points there"), with_points, [2, 2 * k, 2 * k, 0, 1]);
            let with_lunes = with(circles, &lunes((axis, normals), k as i64));
            add(&format!("{name} and halves"), with_lunes, [2, 2 * k, 2 * k, 0, 1]);
            add(&format!("{k} halves from {axis:?}"), lunes((axis, normals), k as i64), [2, k, k, 0, 1]);
        }
        let meridians = lunes(AXES[0], k as i64);
        let with_equator = with(meridians.clone(), &[circle(NORTH)]);
        add(&format!("{k} meridians and the equator"), with_equator, [k + 2, 3 * k, 2 * k, 0, 1]);
    }
    for (k, m) in [(1_usize, 1_usize), (2, 1), (2, 3), (3, 4)] {
        let meridians = pencil([[1, 1, 0], [1, -1, 0]], k as i64).map(circle);
        let others = pencil([[0, 2, 1], [0, 1, -3]], m as i64).map(circle);
        let [f, e, v] = match (k, m) {
            (1, 1) => [4, 4, 2],
            (2, 1) => [8, 12, 6],
            _ => [2 * k * m + 2 * k + 2 * m - 2, 4 * k * m + 2 * k + 2 * m, 4 + 2 * k * m],
        };
        add(&format!("a grid of {k} meridians and {m}"), meridians.chain(others).collect(), [v, e, f, 0, 1]);
    }
}

/// What may happen anywhere, where it is most difficult.
fn at_places(add: Add<'_>) {
    for p in PLACES {
        add("a point", vec![point(p)], [1, 0, 1, 1, 1]);
        add("a point twice", vec![point(p), point(p.map(|c| 2 * c))], [1, 0, 1, 1, 1]);
        add("antipodes", vec![point(p), point(minus(p))], [2, 0, 1, 2, 2]);
        add("a circle around", vec![circle(p)], [1, 1, 2, 0, 1]);
        add("a circle and its middle", vec![circle(p), point(p)], [2, 1, 2, 1, 2]);
        for k in [1, 3, 8_usize] {
            add(&format!("{k} arcs from {p:?}"), star(p, k as i64), [k + 1, k, 1, 0, 1]);
            let with_point = with(star(p, k as i64), &[point(p)]);
            add(&format!("{k} arcs from {p:?} and the point"), with_point, [k + 1, k, 1, 0, 1]);
        }
        for corners in [3, 4_usize] {
            let nested: Vec<Curve> =
                [3, 4, 7, 9].iter().flat_map(|&r| polygon(p, corners as i64, r)).collect();
            let name = format!("polygons of {corners} about {p:?}");
            add(&name, nested.clone(), [4 * corners, 4 * corners, 5, 0, 4]);
            let with_point = with(nested.clone(), &[point(p), point(minus(p))]);
            add(&format!("{name} and antipodes"), with_point, [4 * corners + 2, 4 * corners, 5, 2, 6]);
            let others: Vec<Curve> = [3, 4].iter().flat_map(|&r| polygon(minus(p), 3, r)).collect();
            let name = format!("{name} and others opposite");
            add(&name, with(nested, &others), [4 * corners + 6, 4 * corners + 6, 7, 0, 6]);
        }
        let q = cross(p, [5, 3, 1]);
        add("a quarter", vec![short(p, q)], [2, 1, 1, 0, 1]);
        add("three quarters", vec![around(q, p, cross(p, q))], [2, 1, 1, 0, 1]);
        add("half of a circle", vec![via(p, q, minus(p))], [2, 1, 1, 0, 1]);
        add("both halves", vec![via(p, q, minus(p)), via(p, minus(q), minus(p))], [2, 2, 2, 0, 1]);
        add("all round", vec![around(p, p, cross(p, q))], [1, 1, 2, 0, 1]);
        add(
            "all round, and the circle",
            vec![around(p, p, cross(p, q)), circle(cross(q, p))],
            [1, 1, 2, 0, 1],
        );
        add("through it", vec![via(q, p, minus(q))], [2, 1, 1, 0, 1]);
        add("through it, with the point", vec![via(q, p, minus(q)), point(p)], [3, 2, 1, 0, 1]);
        let r = [0, 1, 2].map(|i| 3 * p[i] + 2 * q[i]);
        let s = [0, 1, 2].map(|i| 3 * p[i] - q[i]);
        add("through it, shorter", vec![short(r, s)], [2, 1, 1, 0, 1]);
        add("through it, and to it", vec![short(r, s), short(p, cross(q, p))], [4, 3, 1, 0, 1]);
        let t = [0, 1, 2].map(|i| p[i] + 3 * cross(q, p)[i]);
        let u = [0, 1, 2].map(|i| 2 * p[i] - cross(q, p)[i]);
        add("two through it", vec![short(r, s), short(t, u)], [5, 4, 1, 0, 1]);
        add(
            "two through it and two to it",
            vec![short(r, s), short(t, u), short(p, [7, 1, 5]), short(p, [1, -7, 3])],
            [7, 6, 1, 0, 1],
        );
        add("one to it and one from it", vec![short(r, p), short(p, u)], [3, 2, 1, 0, 1]);
    }
}
