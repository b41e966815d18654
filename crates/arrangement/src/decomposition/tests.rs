//! The decomposition against the one that is kept under edits.

#[path = "../../tests/decomposition/laws.rs"]
mod laws;

use super::*;
use crate::random::{
    Numbers, Scene, random_cylinder, random_globe, random_lines, random_paths, random_segments,
};
use crate::topology::Site;
use crate::traits::{ArrangementTraits, BasicTraits};
use crate::trapezoids as kept;
use crate::trapezoids::Trapezoids;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// Runs a test on arrangements made from seeds on a surface.
fn on<G: ArrangementTraits + Clone, T: Topology<G>>(
    seeds: u64,
    most: i64,
    make: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
) {
    for seed in 1..=seeds {
        let mut numbers = Numbers::of_seed(seed);
        let arrangement = make(&mut numbers, most).arrangement();
        agrees(&arrangement, seed);
    }
}

fn agrees<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, seed: u64) {
    let made = VerticalDecomposition::new(arrangement);
    let kept = Kept::new(arrangement);
    assert_eq!(made.trapezoid_count(), kept.trapezoids.count(), "seed {seed}");
    assert_eq!(made.site_count(), kept.sites.len(), "seed {seed}");
    assert_eq!(
        made.trapezoid_count(),
        1 + made.site_count() + arrangement.dcel().edge_count(),
        "seed {seed}"
    );
    // What is made, by what it looks like.
    let all: BTreeMap<Trapezoid, TrapezoidId> = made.trapezoids().map(|t| (made.trapezoid(t), t)).collect();
    assert_eq!(all.len(), made.trapezoid_count(), "seed {seed}: each is there once");
    let find = |t: kept::TrapezoidId| {
        let shape = kept.shape(t);
        *all.get(&shape).unwrap_or_else(|| panic!("seed {seed}: {shape:?} is not there"))
    };
    for s in made.sites() {
        let other = kept.sites[s.index()];
        let of_other = (kept.trapezoids.vertex(other), kept.trapezoids.location(other));
        assert_eq!((made.vertex(s), made.location(s)), of_other, "seed {seed}, {s:?}");
        assert_eq!(made.left_of(s), kept.trapezoids.left_of(other).map(find), "seed {seed}, {s:?}");
        assert_eq!(made.right_of(s), kept.trapezoids.right_of(other).map(find), "seed {seed}, {s:?}");
        assert!(made.sites_of(made.vertex(s)).any(|site| site == s), "seed {seed}, {s:?}");
        for t in made.left_of(s).into_iter().chain(made.right_of(s)) {
            let face = kept.trapezoids.face_of(arrangement, kept.find(&made.trapezoid(t)));
            assert_eq!(made.face_of(arrangement, t), Ok(face), "seed {seed}, {t:?}");
        }
    }
    for e in arrangement.dcel().edges() {
        let rail = kept.trapezoids.rail_of(e);
        let [below, above] = [kept::Side::Below, kept::Side::Above]
            .map(|side| kept.trapezoids.along(rail, side).map(find).collect::<Vec<_>>());
        assert_eq!(made.below(Some(e)), below, "seed {seed}, {e:?}");
        assert_eq!(made.above(Some(e)).map(TrapezoidId).collect::<Vec<_>>(), above, "seed {seed}, {e:?}");
    }
    is_in_order(&made, seed);
    walls_are_nearest(arrangement, &made, seed);
    laws::check(arrangement, &format!("seed {seed}"));
}

/// The decomposition that is kept under edits, and its sites in the order in which they are met.
struct Kept<G: BasicTraits> {
    trapezoids: Trapezoids<G>,
    sites: Vec<kept::SiteId>,
    rank: BTreeMap<u32, u32>,
    by_shape: BTreeMap<Trapezoid, kept::TrapezoidId>,
}

impl<G: UMonotoneTraits> Kept<G> {
    fn new<T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        let trapezoids = Trapezoids::of(arrangement);
        let dcel = arrangement.dcel();
        let ends = dcel.edges().flat_map(|e| trapezoids.rail(trapezoids.rail_of(e)).ends);
        let mut sites: Vec<_> = dcel.vertices().flat_map(|v| trapezoids.sites_of(v)).chain(ends).collect();
        sites.sort_by(|&a, &b| {
            let [a, b] = [a, b].map(|site| trapezoids.place(arrangement, site));
            arrangement.topology().compare_sites(arrangement.traits(), &a, &b)
        });
        sites.dedup();
        let rank = sites.iter().map(|site| site.0).zip(0..).collect();
        let mut kept = Self { trapezoids, sites, rank, by_shape: BTreeMap::new() };
        let at_sites =
            kept.sites.iter().flat_map(|&s| [kept.trapezoids.left_of(s), kept.trapezoids.right_of(s)]);
        let along = |side| {
            let kept = &kept;
            dcel.edges().flat_map(move |e| kept.trapezoids.along(kept.trapezoids.rail_of(e), side))
        };
        let all = at_sites.flatten().chain(along(kept::Side::Below)).chain(along(kept::Side::Above));
        kept.by_shape = all.map(|t| (kept.shape(t), t)).collect();
        kept
    }

    /// The trapezoid as it looks in the other decomposition.
    fn shape(&self, t: kept::TrapezoidId) -> Trapezoid {
        let kept::Trapezoid { left, right, below, above, .. } = *self.trapezoids.trapezoid(t);
        let site = |site: kept::SiteId| (!site.is_none()).then(|| SiteId(self.rank[&site.0]));
        let edge = |rail: kept::RailId| (!rail.is_none()).then(|| self.trapezoids.rail(rail).edge);
        Trapezoid { left: site(left), right: site(right), below: edge(below), above: edge(above) }
    }

    fn find(&self, shape: &Trapezoid) -> kept::TrapezoidId {
        self.by_shape[shape]
    }
}

/// Trapezoids are numbered along edges, and each is once above one and once below one.
fn is_in_order(made: &VerticalDecomposition, seed: u64) {
    let mut is_below = vec![false; made.trapezoid_count()];
    let edges = made.trapezoids().flat_map(|t| [made.trapezoid(t).below, made.trapezoid(t).above]).flatten();
    let edges: BTreeSet<Option<EdgeId>> = edges.map(Some).chain([None]).collect();
    let mut next = 0;
    for &e in &edges {
        let range = made.above(e);
        assert_eq!(range.start, next, "seed {seed}: above {e:?}");
        next = range.end;
        let above: Vec<TrapezoidId> = range.map(TrapezoidId).collect();
        assert!(above.iter().all(|&t| made.trapezoid(t).below == e), "seed {seed}: above {e:?}");
        assert!(made.below(e).iter().all(|&t| made.trapezoid(t).above == e), "seed {seed}: below {e:?}");
        for &t in made.below(e) {
            assert!(!std::mem::replace(&mut is_below[t.index()], true), "seed {seed}: {t:?}");
        }
        for along in [&above[..], made.below(e)] {
            for pair in along.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|t| made.trapezoid(t));
                assert!(a.right <= b.left && a.right.is_some(), "seed {seed}: {a:?}, {b:?}");
                assert!(e.is_none() || a.right == b.left, "seed {seed}: {a:?}, {b:?}");
            }
        }
    }
    assert_eq!(next as usize, made.trapezoid_count(), "seed {seed}");
    assert!(is_below.into_iter().all(|is| is), "seed {seed}");
}

/// What walls meet, found by asking all vertices and edges.
fn walls_are_nearest<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    made: &VerticalDecomposition,
    seed: u64,
) {
    for s in made.sites() {
        if made.location(s).is_interior() {
            check_walls(arrangement, made, s, seed);
        }
    }
}

fn check_walls<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    made: &VerticalDecomposition,
    s: SiteId,
    seed: u64,
) {
    let (traits, dcel) = (arrangement.traits(), arrangement.dcel());
    let (v, point) =
        (made.vertex(s), arrangement.point(made.vertex(s)).expect("a site in the interior is a point"));
    // The vertices of the same u in the interior, from bottom to top.
    let mut column: Vec<(&G::Point, VertexId)> = made
        .sites()
        .filter(|&s| made.location(s).is_interior())
        .map(|s| (arrangement.point(made.vertex(s)).expect("a point"), made.vertex(s)))
        .filter(|(p, _)| traits.compare_u(p, point).is_eq())
        .collect();
    column.sort_by(|a, b| traits.compare_uv(a.0, b.0));
    let at = column.iter().position(|&(_, w)| w == v).expect("it has its own u");
    let ends = |e: EdgeId| [e.halfedge(), e.halfedge().twin()].map(|h| arrangement.start_site(h));
    let is_vertical = |e: EdgeId| traits.is_vertical(arrangement.curve_of(e));
    // The edges that run over the point, none of them vertical.
    let compare = |a: &Site<'_, G>, b: &Site<'_, G>| arrangement.topology().compare_sites(traits, a, b);
    let here = Site::interior(point);
    let spans = |e: &EdgeId| {
        let [min, max] = ends(*e);
        let is_strict = |site: &Site<'_, G>| {
            site.point()
                .is_none_or(|p| site.location.u != Along::Inside || traits.compare_u(p, point).is_ne())
        };
        compare(&min, &here).is_lt()
            && compare(&here, &max).is_lt()
            && is_strict(&min)
            && is_strict(&max)
            && !is_vertical(*e)
    };
    let over: Vec<EdgeId> = dcel.edges().filter(spans).collect();
    let side_of = |p: &G::Point, e: EdgeId| traits.compare_v_at_u(p, arrangement.curve_of(e));
    for (way, wall) in [Ordering::Less, Ordering::Greater].into_iter().zip(made.walls(s)) {
        let context = format!("seed {seed}, {s:?}, {way:?}: {wall:?}");
        // A vertical edge that goes this way.
        let leaves = |h: dcel::HalfedgeId| is_vertical(h.edge_id()) && h.is_even() == way.is_gt();
        assert_eq!(wall == WallEnd::Nothing, dcel.around(v).any(leaves), "{context}");
        if wall == WallEnd::Nothing {
            continue;
        }
        let next = if way.is_gt() { column.get(at + 1) } else { at.checked_sub(1).map(|i| &column[i]) };
        // The edges on this side of the point, and not beyond the next vertex.
        let is_between = |e: &EdgeId| {
            side_of(point, *e) == way.reverse() && next.is_none_or(|&(p, _)| side_of(p, *e) == way)
        };
        let between: Vec<EdgeId> = over.iter().copied().filter(is_between).collect();
        match wall {
            WallEnd::Edge(e) => {
                assert!(between.contains(&e), "{context}");
                let is_nearer = |&f: &EdgeId| f != e && compare_edges(arrangement, f, e) == way.reverse();
                assert_eq!(between.iter().find(|f| is_nearer(f)), None, "{context}");
            }
            WallEnd::Vertex(w) if between.is_empty() && next.is_some_and(|next| next.1 == w) => {}
            WallEnd::Vertex(w) => {
                // One on a side: sites there are not in the column.
                let is_there =
                    |s: SiteId| made.location(s).v != Along::Inside && made.location(s).u == Along::Inside;
                assert!(made.sites_of(w).any(is_there) && between.is_empty() && next.is_none(), "{context}");
            }
            _ => assert!(between.is_empty() && next.is_none(), "{context}"),
        }
    }
}

/// Compares two edges over a common u, where the one begins that begins later; `Equal` if it begins on a side.
fn compare_edges<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    a: EdgeId,
    b: EdgeId,
) -> Ordering {
    let traits = arrangement.traits();
    let [curve_a, curve_b] = [a, b].map(|e| arrangement.curve_of(e));
    let start = |e: EdgeId| {
        let site = arrangement.start_site(e.halfedge());
        site.point().filter(|_| site.location.is_interior())
    };
    match (start(a), start(b)) {
        (Some(p), Some(q)) => match traits.compare_uv(p, q) {
            Ordering::Less => traits.compare_v_at_u(q, curve_a).reverse(),
            Ordering::Equal => traits.compare_v_at_u_right(curve_a, curve_b, p),
            Ordering::Greater => traits.compare_v_at_u(p, curve_b),
        },
        _ => Ordering::Equal,
    }
}

#[test]
fn segments() {
    on(400, 12, random_segments);
}

#[test]
fn lines_and_rays() {
    on(400, 10, random_lines);
}

#[test]
fn arcs_on_a_sphere() {
    on(600, 8, random_globe);
}

#[test]
fn paths_on_a_torus() {
    on(1000, 6, random_paths);
}

#[test]
fn paths_on_a_cylinder() {
    on(500, 6, random_cylinder);
}

/// The figures of the documentation.
#[test]
fn records_are_small() {
    assert_eq!([size_of::<TrapezoidRecord>(), size_of::<SiteRecord>()], [16, 28]);
}
