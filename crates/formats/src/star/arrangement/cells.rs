//! Vertices, edges and boundaries as they are read, and whether they fit together.

use super::curves::malformed;
use super::model::CellNumbers;
use super::numbers::Numbers;
use super::special::Special;
use crate::base::error::Located;
use dcel::{CcbId, CcbKind, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, VertexId};

/// The cells of a file, without the points of vertices.
#[derive(Debug)]
pub(super) struct Cells {
    pub(super) special: Special,
    pub(super) vertices: Numbers,
    pub(super) edges: Numbers,
    pub(super) faces: Numbers,
    pub(super) is_artificial: Vec<bool>,
    pub(super) supports: Vec<u32>,
    pub(super) halfedges: Vec<Halfedge>,
    ccbs: Vec<RawCcb>,
    ccb_lines: Vec<u32>,
    pub(super) isolated: Vec<(VertexId, FaceId)>,
    isolated_lines: Vec<u32>,
}

/// In growing lists, as an arrangement, and while that is checked.
pub(super) const fn of_vertex<P>() -> u64 {
    2 * size_of::<Option<P>>() as u64 + 250
}
pub(super) const OF_EDGE: u64 = 500;
pub(super) const OF_CCB: u64 = 100;
pub(super) const OF_FACE: u64 = 50;
pub(super) const OF_ISOLATED: u64 = 250;

impl Cells {
    pub(super) fn new(special: Special) -> Self {
        Self {
            special,
            vertices: Numbers::default(),
            edges: Numbers::default(),
            faces: Numbers::default(),
            // A pole at which nothing is.
            is_artificial: vec![!special.is_infinity(); special.count()],
            supports: Vec::new(),
            halfedges: Vec::new(),
            ccbs: Vec::new(),
            ccb_lines: Vec::new(),
            isolated: Vec::new(),
            isolated_lines: Vec::new(),
        }
    }

    /// The vertex with the number that digits say.
    pub(super) fn vertex(&self, digits: &[u8]) -> Option<VertexId> {
        self.vertices.find(digits).map(|record| self.special.vertex(record as usize))
    }

    /// A vertex as messages name it.
    pub(super) fn vertex_name(&self, v: VertexId) -> String {
        match self.special.record(v) {
            Some(record) => format!("vertex {}", self.vertices.id(record)),
            None => self.special.name(v).into(),
        }
    }

    /// The line of a vertex; `None` if it has no record.
    pub(super) fn vertex_line(&self, v: VertexId) -> Option<u32> {
        self.special.record(v).map(|record| self.vertices.line(record))
    }

    pub(super) fn halfedge_name(&self, h: HalfedgeId) -> String {
        format!("{}{}", if h.is_even() { '+' } else { '-' }, self.edges.id(h.edge()))
    }

    pub(super) fn ccb_line(&self, c: CcbId) -> u32 {
        self.ccb_lines[c.index()]
    }

    pub(super) fn ccb_kind(&self, c: CcbId) -> CcbKind {
        self.ccbs[c.index()].kind
    }

    pub(super) fn ccb_face(&self, c: CcbId) -> FaceId {
        self.ccbs[c.index()].face
    }

    /// Adds a vertex whose number is declared: the one that stands for a side, or another one.
    pub(super) fn push_vertex(
        &mut self,
        special: Option<VertexId>,
        is_artificial: bool,
        line: u32,
    ) -> Result<(), Located> {
        let Some(v) = special else {
            self.is_artificial.push(is_artificial);
            return Ok(());
        };
        if self.special.record(v).is_some() {
            let why =
                format!("{} is {} already; remove one of the two", self.vertex_name(v), self.special.name(v));
            return Err(malformed(line, why));
        }
        self.special.declare(v, self.vertices.len() - 1);
        self.is_artificial[v.index()] = is_artificial;
        Ok(())
    }

    /// Adds an edge whose number is declared.
    pub(super) fn push_edge(&mut self, ends: [VertexId; 2], support: u32) {
        let free =
            |source| Halfedge { next: HalfedgeId::NONE, prev: HalfedgeId::NONE, source, ccb: CcbId::NONE };
        self.halfedges.extend(ends.map(free));
        self.supports.push(support);
    }

    fn source(&self, h: HalfedgeId) -> VertexId {
        self.halfedges[h.index()].source
    }

    /// Adds a boundary of the last face. Its halfedges must follow one another, and be in no other.
    pub(super) fn push_ccb(&mut self, kind: CcbKind, cycle: &[HalfedgeId], line: u32) -> Result<(), Located> {
        let ccb = CcbId::new(self.ccbs.len());
        let (Some(&first), Some(&last)) = (cycle.first(), cycle.last()) else {
            unreachable!("a boundary has been read to have a halfedge")
        };
        let mut before = last;
        for &h in cycle {
            let record = self.halfedges[h.index()];
            if record.ccb != CcbId::NONE {
                let where_else = match record.ccb == ccb {
                    true => "in this line".into(),
                    false => format!("in line {}", self.ccb_line(record.ccb)),
                };
                let name = self.halfedge_name(h);
                return Err(malformed(
                    line,
                    format!("{name} stands {where_else} already; remove one of the two"),
                ));
            }
            let [target, source] = [self.source(before.twin()), record.source];
            if target != source {
                let why = format!(
                    "{} ends at {}, and {} begins at {}; let each begin where the one before it ends",
                    self.halfedge_name(before),
                    self.vertex_name(target),
                    self.halfedge_name(h),
                    self.vertex_name(source)
                );
                return Err(malformed(line, why));
            }
            self.halfedges[h.index()].ccb = ccb;
            self.halfedges[before.index()].next = h;
            before = h;
        }
        let face = self.last_face();
        self.ccbs.push(RawCcb { first, face, kind });
        self.ccb_lines.push(line);
        Ok(())
    }

    pub(super) fn push_isolated(&mut self, vertex: VertexId, line: u32) {
        self.isolated.push((vertex, self.last_face()));
        self.isolated_lines.push(line);
    }

    /// The face declared last.
    fn last_face(&self) -> FaceId {
        FaceId::new(self.faces.len() - 1)
    }

    /// Puts the cells together, if nothing is missing. A vertex that stands for a side and has no record is in the face that is given for
    /// it.
    pub(super) fn raw_dcel(
        &mut self,
        end: u32,
        face_around: impl Fn(&Self, VertexId) -> FaceId,
    ) -> Result<RawDcel, Located> {
        if self.faces.len() == 0 {
            return Err(malformed(
                end,
                "the file has no face; add one: also the surface without curves is a face".into(),
            ));
        }
        let mut outgoing = vec![HalfedgeId::NONE; self.is_artificial.len()];
        let mut degrees = vec![0_u32; self.is_artificial.len()];
        for h in (0..self.halfedges.len()).map(HalfedgeId::new) {
            if self.halfedges[h.index()].ccb == CcbId::NONE {
                let why = format!(
                    "{} is in no boundary; add it to that of the face left of it",
                    self.halfedge_name(h)
                );
                return Err(malformed(self.edges.line(h.edge()), why));
            }
            let source = self.source(h).index();
            outgoing[source] = h;
            degrees[source] += 1;
        }
        self.check_isolated(&outgoing)?;
        self.check_faces()?;
        for (index, &degree) in degrees.iter().enumerate() {
            let v = VertexId::new(index);
            if self.is_artificial[index]
                && degree != 2
                && let Some(line) = self.vertex_line(v)
            {
                let why =
                    format!("{} joins {degree} edges and not 2; remove `artificial`", self.vertex_name(v));
                return Err(malformed(line, why));
            }
        }
        let special = (0..self.special.count()).map(VertexId::new);
        let absent =
            special.filter(|&v| outgoing[v.index()] == HalfedgeId::NONE && self.special.record(v).is_none());
        let absent: Vec<_> = absent.map(|v| (v, face_around(self, v))).collect();
        let mut isolated = std::mem::take(&mut self.isolated);
        isolated.extend(absent);
        Ok(RawDcel {
            halfedges: std::mem::take(&mut self.halfedges),
            outgoing,
            // Messages ask for the kinds.
            ccbs: self.ccbs.clone(),
            face_count: self.faces.len(),
            isolated,
        })
    }

    /// The numbers that the file has for its cells.
    pub(super) fn into_numbers(self) -> CellNumbers {
        let records = (0..self.special.count()).map(|v| self.special.record(VertexId::new(v)));
        let special: Vec<_> = records.map(|record| record.map(|record| self.vertices.id(record))).collect();
        let [mut vertices, edges, faces] = [self.vertices, self.edges, self.faces].map(Numbers::into_ids);
        if special.iter().any(Option::is_some) {
            vertices.retain(|&number| !special.contains(&Some(number)));
        }
        CellNumbers { special, vertices, edges, faces }
    }

    /// A vertex has edges, or stands in one face.
    fn check_isolated(&self, outgoing: &[HalfedgeId]) -> Result<(), Located> {
        let mut is_isolated = vec![false; self.is_artificial.len()];
        for (&(v, _), &line) in self.isolated.iter().zip(&self.isolated_lines) {
            let name = self.vertex_name(v);
            if outgoing[v.index()] != HalfedgeId::NONE {
                return Err(malformed(line, format!("{name} has edges; remove it here")));
            }
            if std::mem::replace(&mut is_isolated[v.index()], true) {
                return Err(malformed(
                    line,
                    format!("{name} is isolated in a line before; remove one of the two"),
                ));
            }
        }
        for index in 0..self.is_artificial.len() {
            let v = VertexId::new(index);
            if outgoing[index] == HalfedgeId::NONE
                && !is_isolated[index]
                && let Some(line) = self.vertex_line(v)
            {
                let why = format!(
                    "{} has no edge; add `isolated` to the face in which it lies",
                    self.vertex_name(v)
                );
                return Err(malformed(line, why));
            }
        }
        Ok(())
    }

    /// A face has a boundary, if there is any edge.
    fn check_faces(&self) -> Result<(), Located> {
        let mut has_ccb = vec![self.edges.len() == 0; self.faces.len()];
        self.ccbs.iter().for_each(|ccb| has_ccb[ccb.face.index()] = true);
        let without = has_ccb.iter().position(|&has| !has);
        // Without edges, there is one face.
        match without.or((self.edges.len() == 0 && self.faces.len() > 1).then_some(1)) {
            Some(face) => Err(malformed(
                self.faces.line(face),
                "the face has no boundary; add `outer` or `inner`".into(),
            )),
            None => Ok(()),
        }
    }
}
