//! Ten thousand random placements of each pair: a third anywhere, a third deep inside, a third exact touches.

use crate::check::{Expected, Subject, translation};
use crate::number::Number;
use crate::pairs;
use crate::placements::{Census, Made, PARTS, placement};
use crate::planes::{Brute, Place};
use crate::solid::{Solid, common_scale};
use exact::Integer;
use splitstar_proximity::{Pair, RelativePlacement};
use testkit::Rng;

/// Placements of each pair.
const COUNT: usize = 10_000;
/// The closest points of all placements are checked to belong to the polytopes and to be as far apart as they must. For the first three
/// of every so many placements, which is 15 %, also the choice among several closest points and the features are compared, since that
/// takes all pairs of edges.
const STRIDE: usize = 20;
/// Contacts of one kind in ten thousand placements, at least.
const CONTACTS: usize = 50;

fn compare(pair: &pairs::Pair, count: usize) -> Census {
    let pairs::Pair { name, p, q } = pair;
    let scale = common_scale(p, q) * Integer::from(PARTS);
    let brute = Brute::<i128>::new(p, q, scale.clone());
    let (sum, direct) = (RelativePlacement::new(p, q), Pair::new(p, q));
    let subjects = [Subject::Sum(&sum), Subject::Pair(&direct, None)];
    let seed = name.bytes().fold(9, |seed: u64, byte| seed.wrapping_mul(31).wrapping_add(byte.into()));
    println!("{name}: seed {seed}, {} candidates", brute.candidates.len());
    let mut rng = Rng::new(seed);
    let mut census = Census::default();
    let mut places = [0_usize; 3];
    let [mut deep, mut overlapping_deep] = [0_usize; 2];
    let solids = [p, q].map(|polytope| Solid::<Integer>::new(polytope, &scale));
    let mut hints = [None; 2];
    for number in 0..count {
        let state = rng.state();
        let made = placement(&brute, number, &mut rng);
        let direction = direction(&mut rng);
        census.note(made.made);
        let expected = Expected::new(&brute, &made.s, direction, || brute.squared_distance(&made.s));
        places[expected.place as usize] += 1;
        let s = translation(&made.s, &scale, number);
        let case = format!("{name}, placement {number}, state {state}: {made:?} over {scale}");
        match made.made {
            Made::Touch { .. } => assert_eq!(expected.place, Place::Touching, "{case}"),
            Made::Deep => {
                deep += 1;
                overlapping_deep += usize::from(expected.place == Place::Overlapping);
            }
            Made::Anywhere => {}
        }
        if expected.place == Place::Touching {
            census.note_contact(sum.separation(&s, None).features());
        }
        for (subject, hint) in subjects.iter().zip(&mut hints) {
            // With the last witness, and without.
            let witness = subject.check(&s, direction, &expected, hint.filter(|_| number % 5 != 0), &case);
            *hint = Some(witness);
            subject.check_membership(&solids, &scale, &s, &expected, *hint, &case);
            if number % STRIDE < 3 {
                subject.check_closest([p, q], &s, &expected, &case);
                subject.check_direction(&brute, &made.s, &s, &case);
            }
        }
    }
    let [disjoint, touching, overlapping] = places;
    println!("{name}: {disjoint} disjoint, {touching} touching, {overlapping} overlapping");
    assert!(touching >= count / 3 - 1, "{name}");
    // A mean of vertices lies on the boundary only if the same facet has all of them.
    let wanted = if brute.is_full { deep * 99 / 100 } else { 0 };
    assert!(overlapping_deep >= wanted, "{name}: {overlapping_deep} of {deep} overlap");
    assert!(brute.is_full || overlapping == 0, "{name}");
    assert!(disjoint > 0, "{name}");
    census
}

/// A direction that is not zero, often along an axis.
pub(crate) fn direction(rng: &mut Rng) -> [i64; 3] {
    loop {
        let direction = [0; 3].map(|_: i64| rng.within(3));
        if direction != [0; 3] {
            return direction;
        }
    }
}

/// The dimensions of the least features that contain a contact, which ten thousand placements of a pair must have.
fn contacts(name: &str) -> &'static [[usize; 2]] {
    match name {
        "hulls" | "large_hulls" | "octahedron_and_cube" | "pyramid_and_octahedron" | "same_tetrahedra" => {
            &[[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [2, 0]]
        }
        "prisms" => &[[0, 0], [0, 1], [1, 0], [1, 1], [1, 2], [2, 1], [2, 2]],
        "opposite_tetrahedra" => &[[0, 0], [1, 1], [2, 2]],
        "thirds" => &[[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2], [2, 0], [2, 1]],
        _ => &[[0, 0]],
    }
}

macro_rules! compare_pairs {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                let pair = pairs::pair(stringify!($name));
                let census = compare(&pair, COUNT);
                println!("{}: {census:?}", pair.name);
                for dimensions in contacts(pair.name) {
                    assert!(census.contacts(*dimensions) >= CONTACTS, "{}, {dimensions:?}: {census:?}", pair.name);
                }
            }
        )*

        #[test]
        fn no_pair_is_forgotten() {
            let tested = [$(stringify!($name)),*];
            let all: Vec<&str> = pairs::pairs().iter().map(|pair| pair.name).collect();
            assert_eq!(tested.len(), all.len());
            assert!(all.iter().all(|name| tested.contains(name)));
        }
    };
}

compare_pairs! {
    cubes
    cube_and_tetrahedron
    opposite_tetrahedra
    same_tetrahedra
    octahedron_and_cube
    prisms
    pyramid_and_octahedron
    hulls
    large_hulls
    block_and_needle
    hexagonal_pyramid_and_bipyramid
    cube_turned
    thirds
    cube_and_point
    hull_and_segment
    hull_and_polygon
    skew_polygons
    prism_and_parallel_polygon
    polygon_and_segment_across
    crossed_needles
}

/// Features of all dimensions touch: the extreme points of both in the direction of contact.
#[test]
fn touches_are_of_every_kind() {
    let mut met = Census::default();
    for name in ["cubes", "octahedron_and_cube", "cube_and_tetrahedron", "prisms"] {
        met.add(compare(&pairs::pair(name), COUNT / 10));
    }
    for dimensions in [[0, 0], [0, 1], [1, 0], [0, 2], [2, 0], [1, 1]] {
        assert!(met.has_touch(dimensions, false), "dimensions {dimensions:?}: {met:?}");
    }
    for dimensions in [[1, 1], [1, 2], [2, 1], [2, 2]] {
        assert!(met.has_touch(dimensions, true), "dimensions {dimensions:?}: {met:?}");
    }
}

#[test]
fn flat_pairs_never_overlap() {
    for pair in pairs::flat_pairs() {
        assert!(!Brute::<Integer>::new(&pair.p, &pair.q, common_scale(&pair.p, &pair.q)).is_full);
        compare(&pair, COUNT / 20);
    }
}

#[test]
fn machine_integers_do_not_overflow_in_brute_force() {
    for pairs::Pair { p, q, .. } in pairs::pairs().into_iter().chain(pairs::flat_pairs()) {
        let scale = common_scale(&p, &q) * Integer::from(PARTS);
        let (small, large) =
            (Brute::<i128>::new(&p, &q, scale.clone()), Brute::<Integer>::new(&p, &q, scale));
        let mut rng = Rng::new(1);
        for number in 0..30 {
            let s = placement(&small, number, &mut rng).s;
            let wide = s.map(|c| c.integer());
            assert_eq!(small.place(&s), large.place(&wide));
            let [a, b] = [
                small.squared_distance(&s).rational(&small.scale),
                large.squared_distance(&wide).rational(&small.scale),
            ];
            assert_eq!(a, b);
        }
    }
}
