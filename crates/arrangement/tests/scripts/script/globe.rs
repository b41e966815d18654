//! Families on the sphere: arcs of great circles, and chains of them.

use super::draw::Draw;
use super::drawn::{CurveOf, Drawn, Made, PieceOf, PointOf};
use super::globe_scan::{Scan, Stroke, V, primitive};
use exact::spherical::{Direction, GreatCircle};
use splitstar_arrangement::models::polycurve::{Chain, PolycurveTraits};
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::traits::CurveEnd;

/// Arcs, circles and points.
#[derive(Debug)]
pub(super) struct Globe {
    traits: GeodesicTraits,
}

impl Globe {
    /// On the sphere with this identification.
    pub(super) fn new(identification: [i64; 2]) -> Self {
        let traits = GeodesicTraits::with_identification(identification.map(Into::into));
        Self { traits: traits.expect("a direction is not zero") }
    }
}

fn direction(draw: &mut Draw<'_>) -> Direction {
    Direction::from_i64(draw.direction()).expect("a direction is not zero")
}

/// An arc between two points: the shorter one, or the longer one.
fn arc(source: Direction, target: Direction, is_long: bool) -> Option<Geodesic> {
    if is_long {
        let circle = GreatCircle::through(&source, &target)?.opposite();
        Geodesic::arc_around(source, target, circle).ok()
    } else {
        Geodesic::arc(source, target).ok()
    }
}

fn geodesic(draw: &mut Draw<'_>) -> Option<Geodesic> {
    let (p, q) = (direction(draw), direction(draw));
    match draw.below(12) {
        0 => Some(Geodesic::circle(GreatCircle::from_i64(draw.direction())?)),
        // Half round.
        1 => Geodesic::arc_via(p.clone(), &q, p.opposite()).ok(),
        // All round, with a vertex.
        2 => {
            let circle = GreatCircle::through(&p, &q)?;
            Geodesic::arc_around(p.clone(), p, circle).ok()
        }
        // A part of a meridian.
        3 => {
            let [[x, y, _], [.., z]] = [p.coordinates(), q.coordinates()];
            Geodesic::arc(p, Direction::new([x, y, z])?).ok()
        }
        // Through a pole.
        4 => {
            let [[x, y, _], [.., z]] = [p.coordinates(), q.coordinates()];
            let pole = Direction::from_i64([0, 0, if draw.one_in(2) { 1 } else { -1 }])?;
            Geodesic::arc_via(p, &pole, Direction::new([-x, -y, z])?).ok()
        }
        5 if draw.one_in(3) => Some(Geodesic::point(p)),
        kind => arc(p, q, kind > 8),
    }
}

fn stroke_of(arc: &GeodesicArc) -> Stroke {
    Stroke { normal: arc.circle().coordinates(), ends: CurveEnd::BOTH.map(|end| arc.end(end).coordinates()) }
}

fn inner_point(strokes: &[Stroke], draw: &mut Draw<'_>) -> Option<Direction> {
    let points = draw.choose(strokes)?.inner_points();
    Direction::new(draw.choose(&points)?)
}

fn scan<F: Drawn<Place = V, Stroke = Stroke>>(
    family: &F,
    arrangement: &Made<F>,
    points: &[PointOf<F>],
) -> Vec<Option<Cell>> {
    let scan = Scan::new(family, arrangement);
    points.iter().map(|point| scan.locate(&family.place(point))).collect()
}

impl Drawn for Globe {
    type Traits = GeodesicTraits;
    type Surface = Sphere;
    type Place = V;
    type Stroke = Stroke;

    fn traits(&self) -> GeodesicTraits {
        self.traits.clone()
    }
    fn surface(&self) -> Sphere {
        Sphere
    }
    fn curve(&self, draw: &mut Draw<'_>) -> Option<Geodesic> {
        geodesic(draw)
    }
    fn point(&self, draw: &mut Draw<'_>) -> Direction {
        direction(draw)
    }
    fn place(&self, point: &Direction) -> V {
        primitive(&point.coordinates())
    }
    fn strokes(&self, curve: &GeodesicArc) -> Vec<Stroke> {
        vec![stroke_of(curve)]
    }
    fn inner_point(&self, curve: &GeodesicArc, draw: &mut Draw<'_>) -> Option<Direction> {
        inner_point(&self.strokes(curve), draw)
    }
    fn scan(&self, arrangement: &Made<Self>, points: &[Direction]) -> Vec<Option<Cell>> {
        scan(self, arrangement, points)
    }
}

/// Chains of arcs, some of them closed.
#[derive(Debug)]
pub(super) struct GlobeChains {
    globe: Globe,
}

impl GlobeChains {
    /// On the sphere with this identification.
    pub(super) fn new(identification: [i64; 2]) -> Self {
        Self { globe: Globe::new(identification) }
    }
}

impl Drawn for GlobeChains {
    type Traits = PolycurveTraits<GeodesicTraits>;
    type Surface = Sphere;
    type Place = V;
    type Stroke = Stroke;

    fn traits(&self) -> Self::Traits {
        PolycurveTraits::new(self.globe.traits())
    }
    fn surface(&self) -> Sphere {
        Sphere
    }
    fn curve(&self, draw: &mut Draw<'_>) -> Option<CurveOf<Self>> {
        // Circles and half circles, too.
        if draw.one_in(4) {
            return self.traits().make_polycurve_of([&geodesic(draw)?]).ok();
        }
        let mut corners: Vec<Direction> = (0..2 + draw.below(3)).map(|_| direction(draw)).collect();
        if draw.one_in(3) {
            corners.push(corners[0].clone());
        }
        let longs = draw.below(8);
        let arcs = corners.windows(2).enumerate().map(|(i, ends)| {
            let [p, q] = [0, 1].map(|i| ends[i].clone());
            arc(p, q, longs == i as u64)
        });
        let arcs: Vec<Geodesic> = arcs.collect::<Option<_>>()?;
        self.traits().make_polycurve_of(&arcs).ok()
    }
    fn point(&self, draw: &mut Draw<'_>) -> Direction {
        direction(draw)
    }
    fn place(&self, point: &Direction) -> V {
        self.globe.place(point)
    }
    fn strokes(&self, curve: &Chain<GeodesicArc>) -> Vec<Stroke> {
        curve.pieces().iter().map(stroke_of).collect()
    }
    fn inner_point(&self, curve: &PieceOf<Self>, draw: &mut Draw<'_>) -> Option<Direction> {
        inner_point(&self.strokes(curve), draw)
    }
    fn scan(&self, arrangement: &Made<Self>, points: &[Direction]) -> Vec<Option<Cell>> {
        scan(self, arrangement, points)
    }
}

/// A scan that told nothing would agree with everything.
#[test]
fn a_scan_of_the_sphere_tells_most() {
    use splitstar_arrangement::{Arrangement, locate_by_sweep};
    let (mut told, mut untold) = ([0; 3], 0);
    let mut bytes = [7_u8; super::STEP];
    for case in 0..200 {
        bytes = std::array::from_fn(|i| bytes[i].wrapping_mul(77).wrapping_add(bytes[(i + 5) % 16] ^ case));
        let mut draw = Draw::new(&bytes, 5, 1);
        let globe = Globe::new([[-1, 0], [2, 1]][usize::from(case % 2)]);
        let curves: Vec<Geodesic> = (0..5).filter_map(|_| globe.curve(&mut draw)).collect();
        let made = Arrangement::of_curves(globe.traits(), Sphere, &curves);
        let mut points: Vec<Direction> = (0..6).map(|_| globe.point(&mut draw)).collect();
        let inner = |e| globe.inner_point(&made.make_edge_curve(e), &mut draw);
        points.extend(made.dcel().edges().filter_map(inner));
        let cells = locate_by_sweep(&made, &points);
        for (cell, scanned) in cells.into_iter().zip(globe.scan(&made, &points)) {
            match scanned {
                Some(Cell::Vertex(_)) => told[0] += 1,
                Some(Cell::Edge(_)) => told[1] += 1,
                Some(Cell::Face(_)) => told[2] += 1,
                None => untold += 1,
            }
            assert_eq!(scanned.unwrap_or(cell), cell, "case {case}: {curves:?}");
        }
    }
    assert!(told.iter().all(|&count| count > 100) && told[2] > 5 * untold, "{told:?}, {untold}");
}
