//! The doors to files of curves and of points.

use super::lexer::Lexer;
use super::maker::{Collected, Maker};
use super::model::{CurveFile, PointFile, SphereCurveFile, SpherePointFile};
use super::plane::{self, Plane};
use super::sphere::{self, Sphere};
use crate::base::budget::Budget;
use crate::base::error::{Fault, Located, ReadError};
use crate::base::places::Place;
use crate::base::scan::Token;
use crate::format::{Content, Encoding, Format};
use crate::{gzip, star};

/// Reads a file of curves: one a line, in our own words, as a geometry of WKT or as an object of GeoJSON.
///
/// Coordinates are exact, and nothing is allocated by what a file promises, as for [`read`](crate::read). The name of
/// the file only helps the message when the file is of another kind. Gzip may be around the file.
///
/// A point of a polyline that repeats the one before it is left out, and a polyline of which one point is left becomes
/// that point, both with a note. A file without curves is none that is wrong; it has a note too.
///
/// # Errors
/// The first thing wrong with the file, with its line: text that is not in the grammar (`docs/curves.md`), segments, rays
/// and lines whose two points are the same, rings that are not closed, rays and lines on a torus. A file that would take
/// more than 64 times its length, as it is stored, and 64 MiB, is refused.
///
/// # Complexity
/// O(n) for n bytes, unpacked, as long as coordinates have few digits. In GeoJSON, coordinates that come before their
/// `type` are passed over first.
///
/// ```
/// use exact::planar::Point2;
/// use splitstar_formats::{InputCurve, read_curves};
///
/// let text = b"# three curves\nsegment 0 0 1/3 0.1\nLINESTRING (0 0, 1 0, 1 1)\n\
///     {\"type\": \"Point\", \"coordinates\": [0.25, 1e1]}\n";
/// let file = read_curves(text, None)?;
/// let point = InputCurve::Point(Point2::from_rationals(&["1/4".parse()?, "10".parse()?]));
/// assert_eq!((file.curves.len(), &file.curves[2]), (3, &point));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_curves(bytes: &[u8], file_name: Option<&str>) -> Result<CurveFile, ReadError> {
    read_packed(bytes, file_name, read_unpacked).map_err(of_no_format)
}

/// Reads a file of points to be asked about: one a line, as two coordinates, or in any of the ways in which [`read_curves`] reads points.
///
/// # Errors
/// As for [`read_curves`]; and a file with another curve than a point is refused, with the line of that.
///
/// # Complexity
/// That of [`read_curves`].
///
/// ```
/// use exact::planar::Point2;
/// use splitstar_formats::read_points;
///
/// let file = read_points(b"0 0.5 # a half\npoint 1 2\nMULTIPOINT (3 4, 5 6)\n", None)?;
/// assert_eq!(file.points.len(), 4);
/// assert_eq!(file.points[3], Point2::from_i64([5, 6]));
///
/// let error = read_points(b"0 0\nsegment 0 0 1 1\n", None).expect_err("a segment is no point");
/// assert!(error.to_string().starts_with("line 2: a segment in a file of points"), "{error}");
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_points(bytes: &[u8], file_name: Option<&str>) -> Result<PointFile, ReadError> {
    read_packed(bytes, file_name, read_unpacked_points).map_err(of_no_format)
}

/// Reads a file of curves on the sphere: arcs of great circles and points, one a line, in our own words, as a geometry of WKT or as an
/// object of GeoJSON.
///
/// In our own words a point is a direction `x y z` of any length. In WKT and GeoJSON it is a place, longitude and latitude in degrees, which becomes a
/// rational point of the unit sphere: see [`from_degrees`](exact::spherical::geographic::from_degrees). Consecutive points of a polyline
/// are joined by the shorter arc.
///
/// What is said of [`read_curves`] holds here too.
///
/// # Errors
/// As for [`read_curves`]; words for curves of the plane; the zero vector; arcs and polylines with antipodal points that do not tell which
/// way they go; points behind `via` that are not on an arc; latitudes that are none.
///
/// # Complexity
/// That of [`read_curves`].
///
/// ```
/// use exact::spherical::Direction;
/// use splitstar_formats::{SphereCurve, read_sphere_curves};
///
/// let text = b"arc 1 0 0  0 0.5 1/3\narc 1 0 0  -1 0 0  via 0 0 1\ncircle 0 0 1 # the equator\n\
///     {\"type\": \"Point\", \"coordinates\": [-90, 0]}\n";
/// let file = read_sphere_curves(text, None)?;
/// assert_eq!(file.curves.len(), 4);
/// let west = Direction::from_i64([0, -1, 0]).ok_or("zero")?;
/// assert_eq!(file.curves[3], SphereCurve::Point(west));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_sphere_curves(bytes: &[u8], file_name: Option<&str>) -> Result<SphereCurveFile, ReadError> {
    read_packed(bytes, file_name, read_unpacked_sphere).map_err(of_no_format)
}

/// Reads a file of points of the sphere to be asked about: one a line, as three coordinates, or in any of the ways in which
/// [`read_sphere_curves`] reads points.
///
/// # Errors
/// As for [`read_sphere_curves`]; and a file with another curve than a point is refused, with the line of that.
///
/// # Complexity
/// That of [`read_curves`].
///
/// ```
/// use splitstar_formats::read_sphere_points;
///
/// let file = read_sphere_points(b"0 0 2 # the north pole\npoint 1 0.5 1/3\nPOINT (13.4 52.5)\n", None)?;
/// assert_eq!(file.points.len(), 3);
/// assert_eq!(file.points[0].to_string(), "(0, 0, 1)");
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn read_sphere_points(bytes: &[u8], file_name: Option<&str>) -> Result<SpherePointFile, ReadError> {
    read_packed(bytes, file_name, read_unpacked_sphere_points).map_err(of_no_format)
}

pub(crate) fn of_no_format(Located { place, fault }: Located) -> ReadError {
    ReadError { format: None, part: None, place, fault }
}

/// Reads a text that is not packed.
pub(crate) type Unpacked<F> = fn(&[u8], Option<&str>, &mut Budget) -> Result<F, Located>;

/// Reads a text, which may be packed with gzip.
pub(crate) fn read_packed<F>(bytes: &[u8], file_name: Option<&str>, read: Unpacked<F>) -> Result<F, Located> {
    let mut budget = Budget::of_file(bytes.len());
    if !is_gzip(bytes) {
        return read(bytes, file_name, &mut budget);
    }
    let unpacked = gzip::unpack(bytes, &mut budget)?;
    if is_gzip(&unpacked) {
        return Err(unsupported("gzip within gzip", "unpack it once").into());
    }
    read(&unpacked, file_name, &mut budget)
}

fn is_gzip(bytes: &[u8]) -> bool {
    Format::of_content(bytes, bytes.len()) == Content::Gzip
}

pub(crate) fn unsupported(what: &str, instead: &str) -> Fault {
    Fault::Unsupported { what: what.into(), instead: instead.into() }
}

fn read_unpacked(bytes: &[u8], file_name: Option<&str>, budget: &mut Budget) -> Result<CurveFile, Located> {
    let mut maker = Maker::new(Plane::default(), budget);
    let read = |word, lexer: &mut _, first| plane::record(word, lexer, &mut maker, first);
    read_records(bytes, file_name, &CURVES, read)?;
    let Collected { surface, items, places, notes } = maker.finish();
    Ok(CurveFile { curves: items, places, period: surface.period, notes })
}

fn read_unpacked_points(
    bytes: &[u8],
    file_name: Option<&str>,
    budget: &mut Budget,
) -> Result<PointFile, Located> {
    let mut maker = Maker::of_points(Plane::default(), budget);
    read_records(bytes, file_name, &POINTS, |word, lexer, first| {
        if !begins_number(word) {
            return plane::record(word, lexer, &mut maker, first);
        }
        let y = lexer.coordinate_in_line("a point of two coordinates (`x y`)")?;
        let point = maker.point_of(word, y)?;
        maker.bare_point(point, word.line)?;
        Ok(Known::Yes)
    })?;
    let Collected { surface, items, places, notes } = maker.finish_points();
    Ok(PointFile { points: items, places, period: surface.period, notes })
}

fn read_unpacked_sphere(
    bytes: &[u8],
    file_name: Option<&str>,
    budget: &mut Budget,
) -> Result<SphereCurveFile, Located> {
    let mut maker = Maker::new(Sphere, budget);
    read_records(bytes, file_name, &SPHERE_CURVES, |word, lexer, _| sphere::record(word, lexer, &mut maker))?;
    let Collected { items, places, notes, .. } = maker.finish();
    Ok(SphereCurveFile { curves: items, places, notes })
}

fn read_unpacked_sphere_points(
    bytes: &[u8],
    file_name: Option<&str>,
    budget: &mut Budget,
) -> Result<SpherePointFile, Located> {
    let mut maker = Maker::of_points(Sphere, budget);
    read_records(bytes, file_name, &SPHERE_POINTS, |word, lexer, _| {
        if !begins_number(word) {
            return sphere::record(word, lexer, &mut maker);
        }
        let point = sphere::bare_point(word, lexer, &mut maker)?;
        maker.bare_point(point, word.line)?;
        Ok(Known::Yes)
    })?;
    let Collected { items, places, notes, .. } = maker.finish_points();
    Ok(SpherePointFile { points: items, places, notes })
}

fn begins_number(word: Token<'_>) -> bool {
    matches!(word.bytes.first(), Some(b'0'..=b'9' | b'+' | b'-' | b'.'))
}

/// How messages name what a file should have.
struct Wanted {
    /// What the file is one of, and how it is given.
    file: &'static str,
    how: &'static str,
    /// What may begin a record.
    records: &'static str,
    /// What to do with an arrangement.
    for_star: &'static str,
}

const CURVES: Wanted = Wanted {
    file: "curves",
    how: "give curves as text, WKT or GeoJSON",
    records: "`segment`, `ray`, `line`, `polyline`, `point`, a geometry of WKT or a GeoJSON object",
    for_star: "give the curves of which it was made; `splitstar locate` asks it about points",
};

const POINTS: Wanted = Wanted {
    file: "points",
    how: "give points as text, WKT or GeoJSON",
    records: "a point as `x y` or `point x y`, a POINT of WKT or a GeoJSON object",
    for_star: "give the arrangement first, and behind it the points that are asked about",
};

const SPHERE_CURVES: Wanted = Wanted {
    records: "`arc`, `circle`, `polyline`, `point`, a geometry of WKT or a GeoJSON object",
    ..CURVES
};

const SPHERE_POINTS: Wanted =
    Wanted { records: "a point as `x y z` or `point x y z`, a POINT of WKT or a GeoJSON object", ..POINTS };

/// Reads all records of a text by a function that is given the first word of each, and whether it is the first record.
fn read_records<'a>(
    bytes: &'a [u8],
    file_name: Option<&str>,
    wanted: &Wanted,
    mut record: impl FnMut(Token<'a>, &mut Lexer<'a>, bool) -> Result<Known, Located>,
) -> Result<(), Located> {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(unsupported("a text in UTF-16", "write it in UTF-8").into());
    }
    let mut lexer = Lexer::new(bytes);
    let mut first = true;
    while let Some(word) = lexer.token() {
        match record(word, &mut lexer, first)? {
            Known::Yes => lexer.end_line()?,
            Known::No => return Err(unknown(word, first.then_some(bytes), file_name, wanted)),
        }
        first = false;
    }
    Ok(())
}

/// Whether a record begins with a word that is known.
pub(super) enum Known {
    Yes,
    No,
}

/// No record begins with this word. If it is the first of the file, this may be a file of another kind, of which the
/// bytes are given.
#[cold]
fn unknown(word: Token<'_>, file: Option<&[u8]>, file_name: Option<&str>, wanted: &Wanted) -> Located {
    let content = file.map_or(Content::Unknown, |bytes| Format::of_content(bytes, bytes.len()));
    let by_name = file_name.and_then(Encoding::from_file_name).map(|encoding| encoding.format);
    let format = match content {
        Content::Known(format) | Content::Unlikely(format) => Some(format),
        Content::Gzip | Content::Xml | Content::Json | Content::Unknown => by_name.filter(|_| file.is_some()),
    };
    let place = Place::Line(word.line);
    if format == Some(Format::Star) && file.is_some_and(star::is_arrangement) {
        let why =
            format!("this is an arrangement (star), not a file of {}; {}", wanted.file, wanted.for_star);
        return Fault::Malformed { why }.at(place);
    }
    if let Some(format) = format {
        let why = format!("this is a model ({format}), not a file of {}; {}", wanted.file, wanted.how);
        return Fault::Malformed { why }.at(place);
    }
    if content == Content::Xml {
        return unsupported("XML (SVG, GML, KML)", wanted.how).at(place);
    }
    if word.bytes == b"[" {
        return word.unexpected("a GeoJSON object, which begins with `{`,");
    }
    word.unexpected(wanted.records)
}
