//! An arrangement from the cells that a sweep made and the curves that it swept over.

use super::Parts;
use super::build::{Built, CORNER_FACE};
use crate::topology::Topology;
use crate::traits::{CurveEnd, Intersection, UMonotoneTraits};
use dcel::EdgeId;
use std::collections::BTreeMap;

/// Puts an arrangement together. `curves` become its supports; `support_of` gives the support of a curve of the sweep. An edge along
/// which several curves run gets the overlap of their supports.
pub(crate) fn assemble<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    built: Built<G::Point>,
    curves: Vec<G::UMonotoneCurve>,
    support_of: impl Fn(u32) -> u32,
) -> Parts<G> {
    let Built { dcel, points, is_artificial, edge_curves, overlaps } = built;
    let supports = edge_curves.into_iter().map(&support_of).collect();
    let parts = Parts { dcel, points, is_artificial, curves, supports, corner_face: CORNER_FACE };
    let mut overlapping = Overlaps { traits, topology, parts };
    // Consecutive edges usually have the same overlap.
    let mut known: BTreeMap<Vec<u32>, Vec<u32>> = BTreeMap::new();
    for (edge, mut members) in overlaps {
        for member in &mut members {
            *member = support_of(*member);
        }
        members.sort_unstable();
        members.dedup();
        if members.len() == 1 {
            continue;
        }
        let edge = EdgeId(edge);
        let found = known
            .get(&members)
            .and_then(|supports| supports.iter().copied().find(|&support| overlapping.covers(support, edge)));
        let support = match found {
            Some(support) => support,
            None => {
                let overlap = overlapping.overlap(&members, edge);
                let support = u32::try_from(overlapping.parts.curves.len()).expect("fewer than 2^32 curves");
                overlapping.parts.curves.push(overlap);
                known.entry(members).or_default().push(support);
                support
            }
        };
        overlapping.parts.supports[edge.index()] = support;
    }
    overlapping.parts
}

/// Parts, while the supports of edges are looked for along which several curves run.
struct Overlaps<'a, G: UMonotoneTraits, T> {
    traits: &'a G,
    topology: &'a T,
    parts: Parts<G>,
}

impl<G: UMonotoneTraits, T: Topology<G>> Overlaps<'_, G, T> {
    /// The common piece of several supports on which an edge lies.
    fn overlap(&self, members: &[u32], edge: EdgeId) -> G::UMonotoneCurve {
        let (&first, others) = members.split_first().expect("several curves overlap");
        let mut curve = self.parts.curves[first as usize].clone();
        let mut common = Vec::new();
        for &other in others {
            common.clear();
            self.traits.intersect(&curve, &self.parts.curves[other as usize], &mut common);
            let overlap = common.drain(..).find_map(|intersection| match intersection {
                Intersection::Overlap(overlap) if self.covers_edge(&overlap, edge) => Some(overlap),
                _ => None,
            });
            // They overlap along the edge, because they had one order on both sides of all events.
            if let Some(overlap) = overlap {
                curve = overlap;
            }
        }
        curve
    }

    fn covers(&self, support: u32, edge: EdgeId) -> bool {
        self.covers_edge(&self.parts.curves[support as usize], edge)
    }

    fn covers_edge(&self, curve: &G::UMonotoneCurve, edge: EdgeId) -> bool {
        let ends = self.parts.dcel.ends(edge).map(|v| self.parts.points[v.index()].as_ref());
        covers(self.traits, self.topology, curve, ends)
    }
}

/// Tells whether the ends of an edge lie within those of a curve that is known to run along it somewhere.
pub(crate) fn covers<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curve: &G::UMonotoneCurve,
    [min, max]: [Option<&G::Point>; 2],
) -> bool {
    let is_in_order = |p: Option<&G::Point>, q: Option<&G::Point>| match (p, q) {
        (Some(p), Some(q)) => traits.compare_uv(p, q).is_le(),
        _ => true,
    };
    let is_interior = |end| topology.end_location(traits, curve, end).is_interior();
    let end = |end| traits.end_point(curve, end).filter(|_| is_interior(end));
    // An open end of the edge is an open end of the curve, too.
    (min.is_some() || end(CurveEnd::Min).is_none())
        && (max.is_some() || end(CurveEnd::Max).is_none())
        && is_in_order(end(CurveEnd::Min), min)
        && is_in_order(max, end(CurveEnd::Max))
}
