//! Cells of grids and any facets: generated meshes with many coincidences.

use super::*;
use exact::Vector3;
use splitstar_polytope::{Facets, MeshSummary, triangulate_with_holes};
use testkit::{Rng, mesh, random_rotation, soup};

/// The boundary of cells of a grid, in squares or triangles, with one vertex for each place.
fn cells(rng: &mut Rng, size: i64, odds: u64, cut: bool) -> PolygonMesh {
    let mut filled = BTreeSet::new();
    for x in 0..size {
        for y in 0..size {
            filled.extend((0..size).map(|z| [x, y, z]).filter(|_| rng.below(100) < odds));
        }
    }
    let mut index: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let (mut points, mut facets) = (Vec::new(), Facets::new());
    for &cell in &filled {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beyond = cell;
                beyond[axis] += 2 * side - 1;
                if filled.contains(&beyond) {
                    continue;
                }
                let corner = |u: i64, v: i64| {
                    let mut at = cell;
                    at[axis] += side;
                    at[(axis + 1) % 3] += u;
                    at[(axis + 2) % 3] += v;
                    at
                };
                let mut square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                if side == 0 {
                    square.reverse();
                }
                let mut cycle = square.map(|at| {
                    *index.entry(at).or_insert_with(|| {
                        points.push(Point3::from_i64(at));
                        points.len() as u32 - 1
                    })
                });
                let turn = rng.below(4) as usize;
                cycle.rotate_left(turn);
                let [a, b, c, d] = cycle;
                if cut && rng.one_in(2) {
                    facets.push(&[a, b, c]);
                    facets.push(&[a, c, d]);
                } else {
                    facets.push(&cycle);
                }
            }
        }
    }
    PolygonMesh { points, facets }
}

/// The number of facets that cells must have: squares of one plane and side that have an edge in common, of
/// which there are no other facets.
fn facets_of_cells(mesh: &PolygonMesh) -> usize {
    let normal = |f: usize| -> (Vec<String>, String) {
        let [a, b, c] = [0, 1, 2].map(|i| &mesh.points[mesh.facets.get(f)[i] as usize]);
        let normal: Vector3 = a.direction_to(b).cross(&a.direction_to(c));
        let axis = (0..3).find(|&axis| !normal.sign(axis).is_zero()).expect("a square has a normal");
        let sides = (0..3).map(|axis| format!("{:?}", normal.sign(axis))).collect();
        (sides, a.coordinate(axis).to_string())
    };
    let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (f, cycle) in mesh.facets.iter().enumerate() {
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            edges.entry([a.min(b), a.max(b)]).or_default().push(f);
        }
    }
    let mut group: Vec<usize> = (0..mesh.facets.len()).collect();
    let mut count = group.len();
    for facets in edges.values() {
        if let &[f, g] = &facets[..]
            && normal(f) == normal(g)
            && group[f] != group[g]
        {
            let (keep, gone) = (group[f], group[g]);
            group.iter_mut().filter(|g| **g == gone).for_each(|g| *g = keep);
            count -= 1;
        }
    }
    count
}

fn shuffled(rng: &mut Rng, mesh: &PolygonMesh) -> PolygonMesh {
    let mut order: Vec<usize> = (0..mesh.points.len()).collect();
    rng.shuffle(&mut order);
    let mut label = vec![0; order.len()];
    (0..).zip(&order).for_each(|(new, &old)| label[old] = new);
    let mut cycles: Vec<Vec<u32>> = mesh.facets.iter().map(<[u32]>::to_vec).collect();
    rng.shuffle(&mut cycles);
    let mut facets = Facets::new();
    for cycle in &mut cycles {
        let turn = rng.below(cycle.len() as u64) as usize;
        cycle.rotate_left(turn);
        facets.push(cycle);
    }
    facets.relabel(&label);
    PolygonMesh { points: order.iter().map(|&v| mesh.points[v].clone()).collect(), facets }
}

/// Cells of a grid have everything: facets with holes and with islands in them, edges of four facets,
/// vertices where cells touch.
#[test]
fn cells_of_grids() {
    const SEED: u64 = 0x3e4d_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let (mut holes, mut joins) = (0, 0);
    for case in 0..400 {
        let (size, odds, cut) = (2 + case % 4, 20 + rng.below(75), case % 3 > 0);
        let given = cells(&mut rng, size, odds, cut);
        if given.facets.is_empty() {
            continue;
        }
        let name = format!("case {case}");
        let (joined, notes) = mend(&given, JOIN);
        check_joined(&name, &given, &joined);
        assert_eq!(borders(&cycles(&joined)), 0, "{name}");
        assert_eq!(joined.mesh.facets.len(), facets_of_cells(&given), "{name}");
        // Cycles are simple.
        for cycle in cycles(&joined) {
            assert_eq!(cycle.iter().collect::<BTreeSet<_>>().len(), cycle.len(), "{name}: {cycle:?}");
        }
        assert!(!notes.contains(&Note::TurnedInsideOut), "{name}");
        // In another order, turned inside out, as a soup, and turned in space.
        let map = random_rotation(&mut rng, 3);
        let moved = shuffled(&mut rng, &inside_out(&soup(&given))).transformed(&map);
        let (other, notes) = mend(&moved, JOIN);
        assert!(notes.contains(&Note::TurnedInsideOut), "{name}");
        let outline = |mended: &Mended| -> BTreeSet<Vec<String>> {
            let of = |cycle: &[u32]| {
                let names: Vec<String> =
                    cycle.iter().map(|&v| mended.mesh.points[v as usize].to_string()).collect();
                let least = (0..names.len()).min_by_key(|&i| &names[i]).expect("a cycle has corners");
                [&names[least..], &names[..least]].concat()
            };
            cycles(mended).into_iter().map(of).collect()
        };
        let mut expected = joined.clone();
        expected.mesh = expected.mesh.transformed(&map);
        assert_eq!(outline(&other), outline(&expected), "{name}: moved");
        holes += joined.holes.len();
        joins += given.facets.len() - joined.mesh.facets.len();
    }
    println!("{holes} holes, {joins} facets joined");
    assert!(holes > 200 && joins > 5000, "{holes} holes, {joins} facets joined");
}

/// Any facets over few points are mended or refused, and joining is no worse than that.
#[test]
fn any_facets() {
    const SEED: u64 = 0x3e4d_0002;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut mended = 0;
    for case in 0..20_000 {
        let points: Vec<[i64; 3]> = (0..3 + rng.below(6))
            .map(|_| [0, 1, 2].map(|axis| rng.below([3, 3, case % 3 + 1][axis]) as i64))
            .collect();
        let mut given = mesh(&points, &[]);
        for _ in 0..1 + rng.below(6) {
            let cycle: Vec<u32> =
                (0..3 + rng.below(3)).map(|_| rng.below(points.len() as u64) as u32).collect();
            given.facets.push(&cycle);
        }
        for what in [KEEP, JOIN] {
            let mut notes = Vec::new();
            let Ok(result) = given.mended(what, &mut notes) else { continue };
            check_origins(&given, &result);
            let before = borders(&plain(&given.mended(KEEP, &mut Vec::new()).expect("mended before").mesh));
            if before == 0 && !result.mesh.facets.is_empty() {
                assert_eq!(borders(&cycles(&result)), 0, "case {case}: {given:?} {result:?}");
            }
            for f in 0..result.mesh.facets.len() {
                let holes: Vec<&[u32]> = result.holes_of(f).iter().map(|hole| &hole.cycle[..]).collect();
                let _ = triangulate_with_holes(&result.mesh.points, result.mesh.facets.get(f), &holes);
            }
            mended += 1;
        }
        let _ = MeshSummary::of(&given);
    }
    assert!(mended > 5000, "{mended} mended");
}
