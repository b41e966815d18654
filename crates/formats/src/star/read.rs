//! The star format, read.

use super::cells::{Cells, Finished, Refusal};
use super::first::{StarKind, read_first_line};
use super::line::{Line, Lines};
use crate::base::budget::Budget;
use crate::base::error::{At, Count, Fault, Located};
use crate::base::model::{Model, Object, ReadModel, Unit};
use crate::base::number::point;
use crate::base::places::{Place, Places};
use crate::base::scan::Token;
use crate::base::words::{parse_u32, read_coordinate};
use crate::complex::{Complex, Edge, Facet, Position, Rule, Vertex};
use crate::format::Format;
use exact::{Point3, Vector3};

/// Reads a file of version 1. A mesh is given if it says all that the file says; of a Gaussian map, its polytope.
pub(crate) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let mut lines = Lines::new(bytes);
    if read_first_line(&mut lines, &[StarKind::Complex, StarKind::Gaussian])? == StarKind::Gaussian {
        return super::gaussian::read_polytope(bytes, budget);
    }
    let mut reader = Reader::new(budget);
    loop {
        let Some((word, mut line)) = lines.next_record() else {
            return Err(Fault::Truncated { expected: RECORD.into() }.at(lines.last()));
        };
        if word.bytes == b"end" {
            line.end()?;
            break;
        }
        reader.record(word, &mut line)?;
    }
    if let Some((word, _)) = lines.next_record() {
        return Err(word.fault(|token| Fault::AfterEnd { token, end: "the complex".into() }));
    }
    reader.finish()
}

const RECORD: &str = "a record or `end` was expected";
const KEYWORD: &str =
    "`vertex`, `direction`, `volume`, `object`, `facet`, `edge`, `unit`, `end` or a comment";
const VERTEX: &str = "the number of a vertex or direction declared above";
const VOLUME: &str = "the number of a volume: 0, 1 or one declared above";

/// A name twice, as the list of objects may grow to twice its size. The list of numbers of vertices may too.
const OF_OBJECT: u64 = 2 * (size_of::<NewObject>() + size_of::<Object>()) as u64;
const OF_NUMBER: u64 = 2 * 4;

struct NewObject {
    name: String,
    facets: u32,
    edges: u32,
}

struct Reader<'b> {
    cells: Cells<'b>,
    /// The numbers of vertices and directions, ascending.
    ids: Vec<u32>,
    /// The last volume that was declared.
    last_volume: Option<u32>,
    unit: Option<Unit>,
    objects: Vec<NewObject>,
    /// How many there are of all facets.
    corners: u32,
    /// The outer cycle, or the hole, that is being read.
    cycle: Vec<u32>,
}

impl<'b> Reader<'b> {
    fn new(budget: &'b mut Budget) -> Self {
        Self {
            cells: Cells::new(budget),
            ids: Vec::new(),
            last_volume: None,
            unit: None,
            objects: Vec::new(),
            corners: 0,
            cycle: Vec::new(),
        }
    }

    fn record(&mut self, keyword: Token<'_>, line: &mut Line<'_>) -> Result<(), Located> {
        match keyword.bytes {
            b"vertex" => self.vertex(line),
            b"facet" => self.facet(line),
            b"edge" => self.edge(line),
            b"direction" => self.direction(line),
            b"volume" => self.volume(line),
            b"object" => self.object(line),
            b"unit" => self.unit(keyword, line),
            _ => Err(keyword.unexpected(KEYWORD)),
        }
    }

    fn unit(&mut self, keyword: Token<'_>, line: &mut Line<'_>) -> Result<(), Located> {
        const UNITS: &str = "`micron`, `millimeter`, `centimeter`, `inch`, `foot` or `meter`";
        let word = line.expect(UNITS)?;
        let unit = std::str::from_utf8(word.bytes).ok().and_then(Unit::from_name);
        let unit = unit.ok_or_else(|| word.unexpected(UNITS))?;
        if self.unit.replace(unit).is_some() {
            return Err(keyword.fault(|_| Fault::Malformed { why: "a second unit; remove one".into() }));
        }
        line.end()
    }

    fn vertex(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        let id = self.new_id(line)?;
        let position = read_point(line)?;
        let marked = mark(line.word(), true, "`marked`, `unmarked` or the end of the line")?;
        line.end()?;
        self.push_vertex(id, Vertex { position: Position::Point(position), marked }, line)
    }

    fn direction(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        let id = self.new_id(line)?;
        // A positive multiple of a direction is the same.
        let point = read_point(line)?;
        let direction = Vector3::new([0, 1, 2].map(|axis| point.numerator(axis))).primitive();
        line.end()?;
        if direction.is_zero() {
            return Err(malformed(&Rule::ZeroDirection, line));
        }
        self.push_vertex(id, Vertex::direction(direction), line)
    }

    fn push_vertex(&mut self, id: u32, vertex: Vertex, line: &Line<'_>) -> Result<(), Located> {
        self.cells.budget.charge(OF_NUMBER).at_line(line.number)?;
        self.cells.vertex(vertex, Place::Line(line.number)).at_line(line.number)?;
        self.ids.push(id);
        Ok(())
    }

    fn new_id(&mut self, line: &mut Line<'_>) -> Result<u32, Located> {
        const ID: &str = "the number of the vertex, below 4294967295,";
        let token = line.expect(ID)?;
        let id = parse_u32(token.bytes).filter(|&id| id < u32::MAX).ok_or_else(|| token.unexpected(ID))?;
        match self.ids.last() {
            Some(&last) if id <= last => {
                Err(token.unexpected(&format!("a number above {last}, the one before,")))
            }
            _ => Ok(id),
        }
    }

    fn volume(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        const ID: &str = "the number of the volume";
        let token = line.expect(ID)?;
        let id = parse_u32(token.bytes).filter(|&id| id < u32::MAX).ok_or_else(|| token.unexpected(ID))?;
        let marked =
            mark(line.word(), Complex::default_mark(id), "`marked`, `unmarked` or the end of the line")?;
        line.end()?;
        if let Some(last) = self.last_volume.replace(id).filter(|&last| id <= last) {
            return Err(token.unexpected(&format!("a number above {last}, the volume before,")));
        }
        self.cells.volume(id, marked).at_line(line.number)
    }

    fn object(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        let name = line.name()?;
        line.end()?;
        self.cells.budget.charge(OF_OBJECT + name.len() as u64).at_line(line.number)?;
        let [facets, edges] = self.cells.counts();
        self.objects.push(NewObject { name, facets, edges });
        Ok(())
    }

    fn edge(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        let mut end = || self.known_vertex(line.expect(VERTEX)?);
        let ends = [end()?, end()?];
        let mut expected = "`through`, `marked`, `unmarked` or the end of the line";
        let mut word = line.word();
        let through = read_through(&mut word, line)?;
        if through.is_some() {
            expected = "`marked`, `unmarked` or the end of the line";
        }
        let marked = mark(word, true, expected)?;
        line.end()?;
        let edge = Edge { ends, through, marked };
        self.cells.edge(edge, Place::Line(line.number)).map_err(|why| self.refused(why, line))
    }

    fn facet(&mut self, line: &mut Line<'_>) -> Result<(), Located> {
        let mut word = self.cycle(line)?;
        let outer = std::mem::take(&mut self.cycle);
        let mut holes = Vec::new();
        while word.is_some_and(|word| word.bytes == b"hole") {
            word = self.cycle(line)?;
            self.cells.charge_hole(self.cycle.len()).at_line(line.number)?;
            holes.push(self.cycle.clone());
        }
        let mut expected =
            "a vertex, `hole`, `through`, `sides`, `marked`, `unmarked` or the end of the line";
        let through = read_through(&mut word, line)?;
        if through.is_some() {
            expected = "`sides`, `marked`, `unmarked` or the end of the line";
        }
        let mut sides = [0, 1];
        if word.is_some_and(|word| word.bytes == b"sides") {
            sides = [self.known_volume(line)?, self.known_volume(line)?];
            word = line.word();
            expected = "`marked`, `unmarked` or the end of the line";
        }
        let marked = mark(word, true, expected)?;
        line.end()?;
        holes.shrink_to_fit();
        let rest = Facet { outer: Vec::new(), holes, through, sides, marked };
        let result = self.cells.facet(&outer, rest, Place::Line(line.number));
        // The next cycle takes its room.
        self.cycle = outer;
        result.map_err(|why| self.refused(why, line))
    }

    /// Reads vertices up to a word that begins with no digit, and gives that word.
    fn cycle<'a>(&mut self, line: &mut Line<'a>) -> Result<Option<Token<'a>>, Located> {
        self.cycle.clear();
        let word = loop {
            match line.word() {
                Some(word) if word.bytes.first().is_some_and(u8::is_ascii_digit) => {
                    let vertex = self.known_vertex(word)?;
                    self.cycle.push(vertex);
                }
                other => break other,
            }
        };
        let corners = u32::try_from(self.cycle.len()).ok().and_then(|new| self.corners.checked_add(new));
        let too_many = || Fault::CountTooLarge { token: (1_u64 << 32).to_string(), of: Count::Corners };
        self.corners = corners.ok_or_else(too_many).at_line(line.number)?;
        Ok(word)
    }

    fn known_vertex(&self, token: Token<'_>) -> Result<u32, Located> {
        let index = parse_u32(token.bytes).and_then(|id| {
            // Numbers that begin with 0 and leave none out are indices.
            if self.ids.get(id as usize) == Some(&id) {
                return Some(id);
            }
            self.ids.binary_search(&id).ok().map(|index| index as u32)
        });
        index.ok_or_else(|| token.unexpected(VERTEX))
    }

    fn known_volume(&self, line: &mut Line<'_>) -> Result<u32, Located> {
        let token = line.expect(VOLUME)?;
        let volume = parse_u32(token.bytes).filter(|&volume| self.cells.has_volume(volume));
        volume.ok_or_else(|| token.unexpected(VOLUME))
    }

    /// The rule names a vertex by its index; the file by its number.
    #[cold]
    fn refused(&self, why: Refusal, line: &Line<'_>) -> Located {
        let rule = match why {
            Refusal::Rule(rule) => rule,
            Refusal::Fault(fault) => return fault.at(Place::Line(line.number)),
        };
        let id = |index: u32| self.ids.get(index as usize).copied().unwrap_or(index);
        let rule = match rule {
            Rule::Loop(vertex) => Rule::Loop(id(vertex)),
            Rule::Repeated(vertex) => Rule::Repeated(id(vertex)),
            other => other,
        };
        malformed(&rule, line)
    }

    fn finish(self) -> Result<ReadModel, Located> {
        let Finished { shape, vertex_places, facet_places, of_edges } = self.cells.finish()?;
        let object = |object: NewObject| {
            let first_facet = if of_edges { object.edges } else { object.facets };
            Object { name: object.name, first_facet }
        };
        let objects = self.objects.into_iter().map(object).collect();
        Ok(ReadModel {
            model: Model { shape, objects, unit: self.unit },
            format: Format::Star,
            places: Places { part: None, vertices: vertex_places, facets: facet_places },
            notes: Vec::new(),
        })
    }
}

fn read_point(line: &mut Line<'_>) -> Result<Point3, Located> {
    let mut coordinate = || read_coordinate(line.expect("one of three coordinates")?);
    Ok(point([coordinate()?, coordinate()?, coordinate()?]))
}

/// If the word is `through`, reads its point and the next word.
fn read_through<'a>(word: &mut Option<Token<'a>>, line: &mut Line<'a>) -> Result<Option<Point3>, Located> {
    if word.is_none_or(|word| word.bytes != b"through") {
        return Ok(None);
    }
    let point = read_point(line)?;
    *word = line.word();
    Ok(Some(point))
}

fn mark(word: Option<Token<'_>>, default: bool, expected: &str) -> Result<bool, Located> {
    match word {
        None => Ok(default),
        Some(word) if word.bytes == b"marked" => Ok(true),
        Some(word) if word.bytes == b"unmarked" => Ok(false),
        Some(word) => Err(word.unexpected(expected)),
    }
}

fn malformed(rule: &Rule, line: &Line<'_>) -> Located {
    Fault::Malformed { why: rule.to_string() }.at(Place::Line(line.number))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of triangles, as OFF and as star.
    fn grid(steps: u32) -> [String; 2] {
        let (vertices, facets) = ((steps + 1).pow(2), 2 * steps * steps);
        let mut texts = [format!("OFF\n{vertices} {facets} 0\n"), "star 1 complex\n".to_string()];
        for id in 0..vertices {
            let point = format!("{} {} 1/3\n", id / (steps + 1), id % (steps + 1));
            texts[0] += &point;
            texts[1] += &format!("vertex {id} {point}");
        }
        for a in (0..steps).flat_map(|i| (0..steps).map(move |j| i * (steps + 1) + j)) {
            let c = a + steps + 2;
            for cycle in [format!("{a} {} {c}\n", c - 1), format!("{a} {c} {}\n", a + 1)] {
                texts[0] += &format!("3 {cycle}");
                texts[1] += &format!("facet {cycle}");
            }
        }
        texts[1] += "end\n";
        texts
    }

    #[test]
    fn a_mesh_takes_the_memory_that_it_takes_in_off() {
        let [off, star] = grid(60);
        let taken = |read: &dyn Fn(&mut Budget) -> Result<ReadModel, Located>| {
            let mut budget = Budget::of_file(1 << 20);
            let before = budget.left();
            assert!(read(&mut budget).unwrap().model.shape.mesh().is_some());
            before - budget.left()
        };
        let of_off = taken(&|budget| crate::off::read(off.as_bytes(), budget));
        let of_star = taken(&|budget| read(star.as_bytes(), budget));
        assert!(2 * of_star <= 3 * of_off, "{of_star} {of_off}");
    }
}
