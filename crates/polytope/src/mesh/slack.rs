//! Facets without area taken out of a mesh.
//!
//! Programs put them where a vertex of one facet lies inside an edge of another: so the surface is closed by
//! its indices. Facets without area that hang together lie on one line. Taken out all at once, they leave
//! edges that overlap; when these get all vertices of the facets taken out that lie between their ends, they
//! match again. For each of those facets ran, between any two neighboring vertices of the line, as often
//! forth as back.

use super::edges::{EdgeTable, Groups};
use super::shape::Shape;
use super::weld::Compact;
use crate::Facets;
use exact::Point3;

/// How many vertices a component may insert into edges, for each corner of it and each of these edges. More
/// come only from a mesh that is made to grow; then the component is kept.
const MOST_INSERTED: usize = 8;

const NONE: u32 = u32::MAX;

/// Facets without area that hang together.
#[derive(Default)]
struct Component {
    /// Its vertices, in their order on the line.
    vertices: Vec<u32>,
    /// The corners of other facets whose edges it shares.
    edges: Vec<u32>,
    corners: usize,
}

/// Takes out the facets without area. The mesh must have no edge without length.
pub(super) fn take_out(compact: &mut Compact, shapes: &mut Vec<Shape>) {
    let slack: Vec<bool> = shapes.iter().map(|shape| matches!(shape, Shape::Line)).collect();
    if !slack.contains(&true) {
        return;
    }
    let table = EdgeTable::new(compact.points.len(), &compact.facets);
    let (mut component_of, components) = components(compact, &table, &slack);
    // What is inserted behind which corner.
    let mut inserted: Vec<(u32, Vec<u32>)> = Vec::new();
    let mut kept = vec![false; components.len()];
    for (component, kept) in components.iter().zip(&mut kept) {
        let between = |&corner: &u32| component.between(&compact.points, &table, corner);
        let count: usize = component.edges.iter().map(|corner| between(corner).0.len()).sum();
        *kept = count > MOST_INSERTED * (component.corners + component.edges.len());
        if !*kept {
            inserted.extend(component.edges.iter().map(|corner| {
                let (vertices, backward) = between(corner);
                let mut vertices = vertices.to_vec();
                if backward {
                    vertices.reverse();
                }
                (*corner, vertices)
            }));
        }
    }
    inserted.retain(|(_, vertices)| !vertices.is_empty());
    inserted.sort_unstable();
    for component in component_of.iter_mut().filter(|component| **component != NONE) {
        if kept[*component as usize] {
            *component = NONE;
        }
    }
    rebuild(compact, shapes, &component_of, &inserted);
}

/// The component of each facet (`NONE` for one with area), and the components.
fn components(compact: &Compact, table: &EdgeTable<'_>, slack: &[bool]) -> (Vec<u32>, Vec<Component>) {
    let is_slack = |corner: &u32| slack[table.facet(*corner)];
    let mut groups = Groups::new(slack.len());
    for edge in table.edges() {
        let mut facets = edge.iter().filter(|&corner| is_slack(corner)).map(|&corner| table.facet(corner));
        if let Some(first) = facets.next() {
            facets.for_each(|other| groups.join(first, other));
        }
    }
    let mut component_of = vec![NONE; slack.len()];
    let mut components: Vec<Component> = Vec::new();
    for f in (0..slack.len()).filter(|&f| slack[f]) {
        // The lowest facet of each comes first.
        let first = groups.find(f);
        if first == f {
            component_of[f] = components.len() as u32;
            components.push(Component::default());
        }
        component_of[f] = component_of[first];
        let component = &mut components[component_of[f] as usize];
        component.vertices.extend_from_slice(compact.facets.get(f));
        component.corners += compact.facets.get(f).len();
    }
    for edge in table.edges() {
        if let Some(&corner) = edge.iter().find(|&corner| is_slack(corner)) {
            let component = &mut components[component_of[table.facet(corner)] as usize];
            component.edges.extend(edge.iter().filter(|&corner| !is_slack(corner)));
        }
    }
    for component in &mut components {
        component.vertices.sort_unstable_by_key(|&v| (&compact.points[v as usize], v));
        component.vertices.dedup();
    }
    (component_of, components)
}

impl Component {
    /// The vertices between the ends of an edge, and whether the edge runs against their order.
    fn between(&self, points: &[Point3], table: &EdgeTable<'_>, corner: u32) -> (&[u32], bool) {
        let [source, target] = [table.source(corner), table.target(corner)].map(|v| {
            let place =
                self.vertices.binary_search_by_key(&(&points[v as usize], v), |&w| (&points[w as usize], w));
            place.expect("a facet of the component has the edge")
        });
        (&self.vertices[source.min(target) + 1..source.max(target)], source > target)
    }
}

/// Leaves out the facets of components, and inserts vertices.
fn rebuild(
    compact: &mut Compact,
    shapes: &mut Vec<Shape>,
    component_of: &[u32],
    inserted: &[(u32, Vec<u32>)],
) {
    let mut facets = Facets::with_capacity(compact.facets.len(), compact.facets.corners().len());
    let (mut names, mut kept) = (Vec::new(), Vec::new());
    let mut inserted = inserted.iter().peekable();
    let mut corner = 0;
    for ((f, cycle), shape) in compact.facets.iter().enumerate().zip(std::mem::take(shapes)) {
        let mut longer = Vec::new();
        for (i, &v) in cycle.iter().enumerate() {
            if !longer.is_empty() {
                longer.push(v);
            }
            if let Some((_, vertices)) = inserted.next_if(|(at, _)| *at == corner) {
                if longer.is_empty() {
                    longer.extend_from_slice(&cycle[..=i]);
                }
                longer.extend_from_slice(vertices);
            }
            corner += 1;
        }
        if component_of[f] == NONE {
            names.push(compact.facet_names[f]);
            facets.push(if longer.is_empty() { cycle } else { &longer });
            kept.push(if longer.is_empty() { shape } else { Shape::of(&compact.points, &longer) });
        }
    }
    compact.facets = facets;
    compact.facet_names = names;
    *shapes = kept;
}
