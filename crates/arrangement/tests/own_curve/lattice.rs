//! The oracle: all curves consist of diagonal steps between points with integer (doubled) coordinates, so that an arrangement can
//! be read off a set of steps. Nothing of the model is used.

use super::own_curve::Curve;
use std::collections::{BTreeMap, BTreeSet};

pub(super) type Node = (i64, i64);

/// The u-monotone pieces of a curve, as the nodes that they go through, and whether their ends are artificial.
pub(super) fn pieces(curve: &Curve) -> Vec<(Vec<Node>, bool)> {
    let path = |range: [i64; 2], v: &dyn Fn(i64) -> i64| (range[0]..=range[1]).map(|u| (u, v(u))).collect();
    match *curve {
        Curve::Circle { centre, radius } => {
            let ([x, y], r) = (centre.map(|c| 2 * i64::from(c)), 2 * i64::from(radius));
            let lower: Vec<Node> = path([x - r, x + r], &|u| y - r + (u - x).abs());
            let upper: Vec<Node> = path([x - r, x + r], &|u| y + r - (u - x).abs());
            if r == 0 { vec![(lower, false)] } else { vec![(lower, true), (upper, true)] }
        }
        Curve::Arc { tip, opens_up, range } => {
            let ([x, y], [a, b]) = (tip.map(|c| 2 * i64::from(c)), range.map(|c| 2 * i64::from(c)));
            let v = |u: i64| if opens_up { y + (u - x).abs() } else { y - (u - x).abs() };
            vec![(path([a.min(b), a.max(b)], &v), false)]
        }
    }
}

/// The cells of the arrangement of some curves.
#[derive(PartialEq, Eq, Debug, Default)]
pub(super) struct Cells {
    pub(super) vertices: BTreeSet<Node>,
    /// Edges by the nodes that they go through, from left to right.
    pub(super) edges: BTreeSet<Vec<Node>>,
    pub(super) faces: usize,
    pub(super) isolated: usize,
    pub(super) components: usize,
    /// How many vertices the user's view does not show.
    pub(super) hidden: usize,
}

impl Cells {
    pub(super) fn of(curves: &[Curve]) -> Self {
        let mut cells = Self::default();
        let mut steps: BTreeSet<(Node, Node)> = BTreeSet::new();
        let mut artificial: BTreeMap<Node, bool> = BTreeMap::new();
        for (path, is_artificial) in curves.iter().flat_map(pieces) {
            steps.extend(path.windows(2).map(|step| (step[0], step[1])));
            for end in [path[0], path[path.len() - 1]] {
                *artificial.entry(end).or_insert(true) &= is_artificial;
            }
        }
        let mut degree: BTreeMap<Node, usize> = BTreeMap::new();
        for &(p, q) in &steps {
            *degree.entry(p).or_default() += 1;
            *degree.entry(q).or_default() += 1;
        }
        cells.vertices = artificial.keys().copied().collect();
        cells.vertices.extend(degree.iter().filter(|(_, degree)| **degree > 2).map(|(node, _)| *node));
        cells.isolated = cells.vertices.iter().filter(|v| !degree.contains_key(v)).count();
        for &(p, mut q) in steps.iter().filter(|(p, _)| cells.vertices.contains(p)) {
            let mut path = vec![p, q];
            while !cells.vertices.contains(&q) {
                let up = (q.0 + 1, q.1 + 1);
                q = if steps.contains(&(q, up)) { up } else { (q.0 + 1, q.1 - 1) };
                path.push(q);
            }
            cells.edges.insert(path);
        }
        let mut component: BTreeMap<Node, Node> = cells.vertices.iter().map(|&v| (v, v)).collect();
        for edge in &cells.edges {
            let [from, to] = [component[&edge[0]], component[&edge[edge.len() - 1]]];
            component.values_mut().filter(|name| **name == from).for_each(|name| *name = to);
        }
        let names: BTreeSet<Node> = component.values().copied().collect();
        cells.components = names.len();
        cells.faces = 1 + cells.components + cells.edges.len() - cells.vertices.len();
        let is_hidden = |v: &Node| artificial.get(v) == Some(&true) && degree.get(v) == Some(&2);
        let cycles = names
            .iter()
            .filter(|name| component.iter().filter(|(_, of)| of == name).all(|(v, _)| is_hidden(v)));
        cells.hidden = cells.vertices.iter().filter(|v| is_hidden(v)).count() - cycles.count();
        cells
    }
}
