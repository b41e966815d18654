//! The cells of a file as they are read: a mesh as long as a mesh can say them all, then a complex.

use crate::base::budget::Budget;
use crate::base::error::{Count, Fault, Located};
use crate::base::maker::{reserve_corners, reserve_vertex, wide_bytes};
use crate::base::model::Shape;
use crate::base::places::{Place, PlaceList};
use crate::complex::{
    Complex, Edge, Facet, Position, Rule, Vertex, check_polygon, check_segment, repeated_segment,
};
use exact::{Point3, PointKey};
use polytope::PolygonMesh;

/// A growing list takes up to twice the size of what it holds.
const GROWTH: u64 = 2;
/// In a mesh, with its line. An edge also has a place in the list that finds repeated ones.
const FLAT_VERTEX: u64 = GROWTH * (size_of::<Point3>() + 4) as u64 + 1;
const FLAT_FACET: u64 = GROWTH * (4 + 4);
const FLAT_CORNER: u64 = GROWTH * 4;
const FLAT_EDGE: u64 = FLAT_FACET + 2 * FLAT_CORNER + 12;
/// In a complex, with its line, and what it takes in a mesh that the complex becomes.
const OF_VERTEX: u64 = GROWTH * (size_of::<Vertex>() + size_of::<Point3>() + 4) as u64;
const OF_FACET: u64 = GROWTH * (size_of::<Facet>() + 8) as u64;
const OF_EDGE: u64 = GROWTH * (size_of::<Edge>() + 24) as u64;
const OF_CORNER: u64 = 3 * 4;
const OF_CYCLE: u64 = GROWTH * (size_of::<Vec<u32>>() + 16) as u64;
const OF_LINE: u64 = GROWTH * size_of::<([u32; 2], PointKey, u32)>() as u64;
const OF_VOLUME: u64 = 32;

/// Why a cell is refused.
pub(super) enum Refusal {
    Rule(Rule),
    Fault(Fault),
}

impl From<Rule> for Refusal {
    fn from(rule: Rule) -> Self {
        Self::Rule(rule)
    }
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

pub(super) struct Cells<'b> {
    pub(super) budget: &'b mut Budget,
    /// A mesh, until there is a complex: marked points, and facets of two vertices or of more.
    mesh: PolygonMesh,
    /// What the first facet of the mesh has in front and behind. If there are others, all have 0 and 1.
    sides: [u32; 2],
    complex: Option<Complex>,
    vertex_places: PlaceList,
    facet_places: PlaceList,
    edge_places: PlaceList,
}

/// All cells, and where they stand.
pub(super) struct Finished {
    pub(super) shape: Shape,
    pub(super) vertex_places: PlaceList,
    /// Of edges if there is no facet.
    pub(super) facet_places: PlaceList,
    /// Whether there is no facet.
    pub(super) of_edges: bool,
}

impl<'b> Cells<'b> {
    pub(super) fn new(budget: &'b mut Budget) -> Self {
        Self {
            budget,
            mesh: PolygonMesh::default(),
            sides: [0, 1],
            complex: None,
            vertex_places: PlaceList::lines(),
            facet_places: PlaceList::lines(),
            edge_places: PlaceList::lines(),
        }
    }

    /// How many facets and edges there are.
    pub(super) fn counts(&self) -> [u32; 2] {
        let (facets, edges) = match &self.complex {
            Some(complex) => (complex.facets.len(), complex.edges.len()),
            None if self.has_segments() => (0, self.mesh.facets.len()),
            None => (self.mesh.facets.len(), 0),
        };
        [facets as u32, edges as u32]
    }

    /// Whether there is such a volume.
    pub(super) fn has_volume(&self, volume: u32) -> bool {
        self.complex.as_ref().map_or(volume <= 1, |complex| complex.has_volume(volume))
    }

    pub(super) fn vertex(&mut self, vertex: Vertex, place: Place) -> Result<(), Fault> {
        let wide = match &vertex.position {
            Position::Point(point) if point.as_narrow().is_none() => wide_bytes(point),
            _ => 0,
        };
        reserve_vertex(self.budget, wide)?;
        match vertex {
            Vertex { position: Position::Point(point), marked: true } if self.complex.is_none() => {
                self.budget.charge(FLAT_VERTEX + wide)?;
                self.mesh.points.push(point);
            }
            vertex => {
                self.complex()?;
                self.budget.charge(OF_VERTEX + wide)?;
                self.complex()?.vertices.push(vertex);
            }
        }
        self.vertex_places.push(place);
        Ok(())
    }

    pub(super) fn volume(&mut self, id: u32, marked: bool) -> Result<(), Fault> {
        if id > 1 || marked != Complex::default_mark(id) {
            self.budget.charge(OF_VOLUME)?;
            self.complex()?.volumes.insert(id, marked);
        }
        Ok(())
    }

    /// An edge between vertices that there are.
    pub(super) fn edge(&mut self, edge: Edge, place: Place) -> Result<(), Refusal> {
        reserve_corners(self.budget, 2)?;
        let fits =
            edge.marked && edge.through.is_none() && (self.mesh.facets.is_empty() || self.has_segments());
        if self.complex.is_none() && fits {
            check_segment(edge.ends)?;
            self.budget.charge(FLAT_EDGE)?;
            count(self.mesh.facets.len(), Count::Edges)?;
            self.mesh.facets.push(&edge.ends);
        } else {
            let line = edge.through.as_ref().map_or(0, |point| OF_LINE + wide_bytes(point));
            let complex = self.complex()?;
            complex.check_edge(&edge)?;
            count(complex.edges.len(), Count::Edges)?;
            self.budget.charge(OF_EDGE + line)?;
            self.complex()?.edges.push(edge);
        }
        self.edge_places.push(place);
        Ok(())
    }

    /// A facet between vertices and volumes that there are: its outer cycle, and all the rest of it.
    pub(super) fn facet(&mut self, outer: &[u32], rest: Facet, place: Place) -> Result<(), Refusal> {
        reserve_corners(self.budget, outer.len() as u64)?;
        let plain = rest.marked && rest.through.is_none() && rest.holes.is_empty();
        let is_first = self.mesh.facets.is_empty();
        let between = match rest.sides {
            [0, 1] => is_first || self.sides == [0, 1],
            // A polygon, if no other comes.
            sides => is_first && sides == [0, 0],
        };
        if self.complex.is_none() && plain && between && !self.has_segments() {
            check_polygon(outer)?;
            self.budget.charge(FLAT_FACET + FLAT_CORNER * outer.len() as u64)?;
            count(self.mesh.facets.len(), Count::Facets)?;
            if is_first {
                self.sides = rest.sides;
            }
            self.mesh.facets.push(outer);
        } else {
            self.complex()?;
            let through = rest.through.as_ref().map_or(0, wide_bytes);
            self.budget.charge(OF_FACET + OF_CYCLE + OF_CORNER * outer.len() as u64 + through)?;
            let facet = Facet { outer: outer.to_vec(), ..rest };
            let complex = self.complex()?;
            complex.check_facet(&facet)?;
            count(complex.facets.len(), Count::Facets)?;
            complex.facets.push(facet);
        }
        self.facet_places.push(place);
        Ok(())
    }

    /// For a hole of so many vertices.
    pub(super) fn charge_hole(&mut self, size: usize) -> Result<(), Fault> {
        reserve_corners(self.budget, size as u64)?;
        self.budget.charge(OF_CYCLE + OF_CORNER * size as u64)
    }

    /// Whether the mesh has facets of two vertices.
    fn has_segments(&self) -> bool {
        !self.mesh.facets.is_empty() && self.mesh.facets.get(0).len() == 2
    }

    /// The complex, which from now on takes all cells.
    fn complex(&mut self) -> Result<&mut Complex, Fault> {
        if self.complex.is_none() {
            let complex = self.made_complex()?;
            self.complex = Some(complex);
        }
        Ok(self.complex.get_or_insert_default())
    }

    /// A complex of the cells of the mesh, which takes them all, also those that repeat one.
    #[cold]
    fn made_complex(&mut self) -> Result<Complex, Fault> {
        let [facets, edges] = self.counts().map(u64::from);
        let (points, corners) = (self.mesh.points.len() as u64, self.mesh.facets.corners().len() as u64);
        let of_facets = facets * (OF_FACET + OF_CYCLE) + corners * OF_CORNER;
        self.budget.charge(points * OF_VERTEX + of_facets + edges * OF_EDGE)?;
        let PolygonMesh { points, facets } = std::mem::take(&mut self.mesh);
        let vertices = points.into_iter().map(Vertex::point).collect();
        let mut complex = Complex { vertices, ..Complex::default() };
        for cycle in facets.iter() {
            match *cycle {
                [a, b] => complex.edges.push(Edge::segment([a, b])),
                _ => complex.facets.push(Facet::of_cycle(cycle.to_vec(), self.sides)),
            }
        }
        Ok(complex)
    }

    /// What the cells are, all together.
    pub(super) fn finish(mut self) -> Result<Finished, Located> {
        let [facets, _] = self.counts();
        let repeated = match &self.complex {
            Some(complex) => complex.repeated_edge(),
            None if self.has_segments() => {
                repeated_segment(self.mesh.facets.iter().map(|ends| [ends[0], ends[1]]))
            }
            None => None,
        };
        if let Some([first, again]) = repeated {
            let first = self.edge_places.get(first).map_or(String::new(), |place| format!(" in {place}"));
            let why = format!("the edge stands{first} already; remove one of the two");
            return Err(Located { place: self.edge_places.get(again), fault: Fault::Malformed { why } });
        }
        if self.complex.is_none() && !self.is_mesh() {
            self.complex()?;
        }
        let shape = match self.complex {
            Some(complex) => complex.into_mesh().map_or_else(Shape::Complex, Shape::Mesh),
            None => Shape::Mesh(self.mesh),
        };
        let facet_places = if facets == 0 { self.edge_places } else { self.facet_places };
        Ok(Finished { shape, vertex_places: self.vertex_places, facet_places, of_edges: facets == 0 })
    }

    /// Whether the mesh says all: there is a vertex, and none is isolated beside other cells.
    fn is_mesh(&self) -> bool {
        let PolygonMesh { points, facets } = &self.mesh;
        let mut used = vec![facets.is_empty(); points.len()];
        facets.corners().iter().for_each(|&corner| used[corner as usize] = true);
        !points.is_empty() && used.into_iter().all(|used| used)
    }
}

/// One more must have an index below 2^32 - 1.
fn count(already: usize, of: Count) -> Result<(), Fault> {
    let fits = already < u32::MAX as usize - 1;
    let fault = || Fault::CountTooLarge { token: (already as u64 + 1).to_string(), of };
    fits.then_some(()).ok_or_else(fault)
}
