//! The door. A map is read by making it again: the points of the faces have a hull, the hull has a map, and the map has one text, which
//! must be that of the file. So nothing that a file says is believed, and there is one thing only to get wrong.

use super::StarGaussianMap;
use super::write::write_gaussian_map;
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, ReadError};
use crate::base::maker::{reserve_corners, reserve_vertex, wide_bytes};
use crate::base::model::{Model, ReadModel};
use crate::base::number::point;
use crate::base::places::{Place, PlaceList, Places};
use crate::base::scan::Token;
use crate::base::words::read_coordinate;
use crate::format::Format;
use crate::star::arrangement::read_sphere;
use crate::star::door::read_star;
use crate::star::first::{StarKind, read_first_line};
use crate::star::line::{Line, Lines};
use exact::Point3;
use gauss::{CubicalGaussianMap, SphericalGaussianMap};
// tidy: convex_hull, because a map is that of the hull of the points of its faces
use polytope::{Polytope, convex_hull as hull_of};

/// Reads a Gaussian map from a file of the native format, kind `gaussian`: see `docs/star.md`. Gzip may be around it.
///
/// Nothing is believed: the map of the hull of the points of all faces is made, and the file must be its text, as [`write_gaussian_map`]
/// writes it, but for blanks and comments.
///
/// # Errors
/// The first line that is not that of the map, with what it should be; before, the first line of a point that cannot be read. A file that
/// would take more than 64 times its length, as it is stored, and 64 MiB, is refused.
///
/// # Complexity
/// O(n log n) for n bytes, unpacked, as long as coordinates have few digits.
///
/// ```
/// use splitstar_formats::read_gaussian_map;
///
/// let point = b"star 1 gaussian\nsurface sphere -1 0\nface 0\nprimal 1 2/3 0\nend\n";
/// assert_eq!(read_gaussian_map(point, None)?.make_polytope().dimension(), 0);
///
/// let two = b"star 1 gaussian\nsurface sphere -1 0\nface 0\nprimal 1 2/3 0\nface 1\nprimal 0 0 0\nend\n";
/// assert!(read_gaussian_map(two, None).is_err());
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_gaussian_map(bytes: &[u8], file_name: Option<&str>) -> Result<StarGaussianMap, ReadError> {
    read_star(bytes, file_name, StarKind::Gaussian, read_text)
}

/// Reads the polytope for which a map stands.
pub(in crate::star) fn read_polytope(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let mesh = read_text(bytes, budget)?.make_polytope().to_mesh();
    for point in &mesh.points {
        reserve_vertex(budget, wide_bytes(point))?;
    }
    reserve_corners(budget, mesh.facets.corners().len() as u64)?;
    Ok(ReadModel {
        model: Model::of_mesh(mesh),
        format: Format::Star,
        // A polytope gives nobody a reason to ask for a place.
        places: Places { part: None, vertices: PlaceList::lines(), facets: PlaceList::lines() },
        notes: Vec::new(),
    })
}

/// For each point of the file: the list of them, their hull with the lists from which it is made, the points of the map.
const OF_POINT: u64 = 512;
/// So often is a point that takes something on the heap there: in the file's list, in the hull, in the map, and in its text.
const COPIES: u64 = 4;
/// For each edge of the hull, its arcs on the sphere or the cube with their ends, and the text of all of them, while numbers are short.
const OF_EDGE: u64 = 3 << 10;
/// For each bit of the vector of an edge that is not short: the normals at its ends have twice the bits, and each is stored and written
/// a few times, with three coordinates.
const OF_BIT: u64 = 64;
/// The bits of a vector that takes nothing on the heap, nor do the normals made of it.
const SHORT: u32 = 30;

const SECOND: &str = "the second line `surface sphere DX DY` or `surface cube`";
const ENDS_BEFORE: &str =
    "the map of the hull of all `primal` points ends before this line; remove it, or make the map again";
const SURFACE: &str = "`sphere` or `cube`";

fn read_text(bytes: &[u8], budget: &mut Budget) -> Result<StarGaussianMap, Located> {
    let mut lines = Lines::new(bytes);
    read_first_line(&mut lines, &[StarKind::Gaussian])?;
    let Some((word, mut line)) = lines.next_record() else {
        return Err(Fault::Truncated { expected: "`surface` was expected".into() }.at(lines.last()));
    };
    if word.bytes != b"surface" {
        return Err(word.unexpected(SECOND));
    }
    let name = line.expect(SURFACE)?;
    let sphere = match name.bytes {
        b"sphere" => Some(read_sphere(&mut line, budget)?),
        b"cube" => None,
        _ => return Err(name.unexpected(SURFACE)),
    };
    line.end()?;
    let (points, end) = read_points(&mut lines, budget)?;
    let hull = hull_of(&points).ok_or_else(|| {
        malformed(end, "the file has no `primal`: write the vertex of the polytope behind each face".into())
    })?;
    drop(points);
    charge_map(&hull, budget).at_line(end)?;
    let map = match sphere {
        Some(traits) => SphericalGaussianMap::of_polytope_with(&hull, traits).into(),
        None => CubicalGaussianMap::of_polytope(&hull).into(),
    };
    drop(hull);
    compare(bytes, &write_gaussian_map(&map))?;
    Ok(map)
}

/// Takes what the map of a polytope and its text need. Where the polytope lies does not matter: cells have the digits of edge vectors.
fn charge_map(hull: &Polytope, budget: &mut Budget) -> Result<(), Fault> {
    for h in hull.mesh().edges() {
        let bits = match hull.edge_vector(h).bits() {
            0..=SHORT => 0,
            bits => OF_BIT * u64::from(bits),
        };
        budget.charge(OF_EDGE + bits)?;
    }
    Ok(())
}

/// Reads the points of all faces, up to the end of the file, and gives the line of `end`.
fn read_points(lines: &mut Lines<'_>, budget: &mut Budget) -> Result<(Vec<Point3>, u32), Located> {
    const RECORD: &str = "a record or `end` was expected";
    const COORDINATE: &str = "one of three coordinates";
    let mut points = Vec::new();
    let end = loop {
        let Some((word, mut line)) = lines.next_record() else {
            return Err(Fault::Truncated { expected: RECORD.into() }.at(lines.last()));
        };
        match word.bytes {
            b"end" => {
                line.end()?;
                break word.line;
            }
            b"primal" => {
                let words = [(); 3].map(|()| line.expect(COORDINATE));
                let [x, y, z] = words;
                let words = [x?, y?, z?];
                line.end()?;
                let [x, y, z] = words.map(read_coordinate);
                let point = point([x?, y?, z?]);
                let wide = if point.as_narrow().is_some() { 0 } else { COPIES * wide_bytes(&point) };
                budget.charge(OF_POINT + wide).at_line(word.line)?;
                points.push(point);
            }
            _ => {}
        }
    };
    match lines.next_record() {
        Some((word, _)) => Err(word.fault(|token| Fault::AfterEnd { token, end: "the map".into() })),
        None => Ok((points, end)),
    }
}

/// Finds the first line of a file that is not that of the text which it should be.
fn compare(file: &[u8], text: &[u8]) -> Result<(), Located> {
    let (mut file, mut text) = (Lines::new(file), Lines::new(text));
    loop {
        match (file.next_record(), text.next_record()) {
            (None, None) => return Ok(()),
            (Some(found), Some(wanted)) => compare_lines(found, wanted)?,
            (Some((found, _)), None) => return Err(malformed(found.line, ENDS_BEFORE.into())),
            (None, Some((wanted, rest))) => {
                return Err(Fault::Malformed { why: sentence(vec![wanted], rest) }.at(file.last()));
            }
        }
    }
}

fn compare_lines(
    (first, mut found): (Token<'_>, Line<'_>),
    (keyword, mut wanted): (Token<'_>, Line<'_>),
) -> Result<(), Located> {
    let (mut word, mut should) = (Some(first), Some(keyword));
    let mut before = Vec::new();
    loop {
        match (word, should) {
            (None, None) => return Ok(()),
            (Some(is), Some(must)) if is.bytes == must.bytes => before.push(must),
            (_, must) => {
                before.extend(must);
                return Err(malformed(first.line, sentence(before, wanted)));
            }
        }
        (word, should) = (found.word(), wanted.word());
    }
}

/// What is said of a line that is not this one, of which the first words are given, and the rest.
fn sentence<'a>(mut line: Vec<Token<'a>>, mut rest: Line<'a>) -> String {
    /// So many words of a line are shown.
    const MANY: usize = 8;
    line.extend(std::iter::from_fn(|| rest.word()));
    let shown: Vec<String> = line.iter().take(MANY).map(Token::shown).collect();
    let rest = if line.len() > MANY { " ..." } else { "" };
    format!(
        "the map of the hull of all `primal` points has `{}{rest}` here; write it so, or correct the points, or make the map again",
        shown.join(" ")
    )
}

fn malformed(line: u32, why: String) -> Located {
    Fault::Malformed { why }.at(Place::Line(line))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each of two texts may be the longer one, whatever is known of how they end.
    #[test]
    fn a_text_that_ends_early_is_malformed() {
        let [short, long] = [b"face 0\n".as_slice(), b"face 0\nface 1 # more\n"];
        assert!(compare(short, short).is_ok());
        for (file, text, line) in [(short, long, 1), (long, short, 2), (b"", short, 0)] {
            let error = compare(file, text).expect_err("the texts differ");
            assert_eq!(error.place, Some(Place::Line(line)));
            assert!(matches!(error.fault, Fault::Malformed { .. }));
        }
    }
}
