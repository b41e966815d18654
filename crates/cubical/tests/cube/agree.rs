//! Is a map the same as the arrangement on the sphere?

use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::overlay::Cell;
use arrangement::topology::Sphere;
use arrangement::{Arrangement, locate_all};
use exact::spherical::Direction;
use splitstar_cubical::{CubicalArrangement, CubicalCell, CubicalFaceId, CubicalPieces};
use std::collections::HashMap;

pub(crate) fn direction(p: [i64; 3]) -> Direction {
    Direction::from_i64(p).expect("not zero")
}

pub(crate) fn map_of(geodesics: &[Geodesic]) -> CubicalArrangement {
    let mut pieces = CubicalPieces::new();
    geodesics.iter().for_each(|geodesic| pieces.push_geodesic(geodesic));
    CubicalArrangement::of_pieces(pieces)
}

/// Which face of the map is which of the sphere, as far as it is known.
#[derive(Default)]
struct Faces {
    of_map: HashMap<CubicalFaceId, dcel::FaceId>,
    of_sphere: HashMap<dcel::FaceId, CubicalFaceId>,
}

impl Faces {
    #[track_caller]
    fn pair(&mut self, own: CubicalFaceId, other: dcel::FaceId, context: &str) {
        assert_eq!(*self.of_map.entry(own).or_insert(other), other, "{context}: face {own:?}");
        assert_eq!(*self.of_sphere.entry(other).or_insert(own), own, "{context}: face {other:?}");
    }
}

/// What leaves a vertex, counterclockwise: the circle, the end, and how the face on the left is known.
type Leaving<F> = Vec<(String, String, F)>;

fn turned<F: Clone>(leaving: &Leaving<F>) -> Leaving<F> {
    let mut leaving = leaving.clone();
    let key = |i: usize| (&leaving[i].0, &leaving[i].1);
    let first = (0..leaving.len()).min_by_key(|&i| key(i)).unwrap_or(0);
    leaving.rotate_left(first);
    leaving
}

/// Panics unless a map is valid, and has the same cells as the arrangement of the same geodesics on the sphere.
#[track_caller]
pub(crate) fn assert_agrees(map: &CubicalArrangement, geodesics: &[Geodesic], context: &str) {
    assert_eq!(map.check_valid(), [], "{context}");
    let sphere = Arrangement::of_curves(GeodesicTraits::new(), Sphere, geodesics);
    assert_eq!(map.counts(), sphere.counts(), "{context}");
    let (dcel, view, mut faces) = (sphere.dcel(), sphere.user_view(), Faces::default());

    let mut of_sphere: HashMap<String, Leaving<dcel::FaceId>> = HashMap::new();
    let name = |v| sphere.point(v).expect("on a sphere every vertex has a point").to_string();
    for v in view.vertices().filter(|&v| !sphere.is_artificial(v)) {
        let leaving = dcel.around(v).map(|h| {
            let circle = sphere.curve_of(h.edge_id()).circle();
            let circle = if h.is_even() { circle.clone() } else { circle.opposite() };
            let last = view.chain(h).last().expect("a chain is not empty");
            (circle.to_string(), name(dcel.target(last)), dcel.face(h))
        });
        of_sphere.insert(name(v), turned(&leaving.collect()));
    }
    let mut vertices = 0;
    for v in map.real_vertices() {
        let leaving = map.real_around(v).map(|h| {
            let last = map.chain(h).last().expect("a chain is not empty");
            (map.circle(h).to_string(), map.direction(map.target(last)).to_string(), map.face(h))
        });
        let own = turned(&leaving.collect());
        let at = map.direction(v).to_string();
        let other = of_sphere.get(&at).unwrap_or_else(|| panic!("{context}: a vertex at {at}"));
        assert_eq!(own.len(), other.len(), "{context}: around {at}");
        for (own, other) in own.iter().zip(other) {
            assert_eq!((&own.0, &own.1), (&other.0, &other.1), "{context}: around {at}");
            faces.pair(own.2, other.2, context);
        }
        // Clockwise it is the same, in the other order.
        let mut clockwise: Vec<_> = map.clockwise_around(v).collect();
        clockwise.reverse();
        let first = usize::from(!clockwise.is_empty());
        clockwise.rotate_right(first);
        assert_eq!(clockwise, map.around(v).collect::<Vec<_>>(), "{context}: around {at}");
        vertices += 1;
    }
    assert_eq!(vertices, of_sphere.len(), "{context}");

    let queries: Vec<Direction> = (0..343)
        .map(|i| [i / 49 - 3, i / 7 % 7 - 3, i % 7 - 3])
        .filter(|&p| p != [0; 3])
        .map(direction)
        .chain(geodesics.iter().filter_map(|geodesic| geodesic.source().cloned()))
        .collect();
    for (query, cell) in queries.iter().zip(locate_all(&sphere, &queries)) {
        match (map.locate(query), cell) {
            (CubicalCell::Face(own), Cell::Face(other)) => faces.pair(own, other, context),
            (CubicalCell::Vertex(own), Cell::Vertex(other)) => {
                assert!(!sphere.is_artificial(other), "{context}: {query}");
                assert_eq!(&map.direction(own), query, "{context}");
            }
            (CubicalCell::Edge(own), Cell::Edge(_)) => assert!(map.is_real_edge(own), "{context}: {query}"),
            (CubicalCell::Edge(_), Cell::Vertex(v)) => assert!(sphere.is_artificial(v), "{context}: {query}"),
            (own, other) => panic!("{context}: {query} is in {own:?} and in {other:?}"),
        }
    }
}
