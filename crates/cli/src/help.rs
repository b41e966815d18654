//! The help texts.

use crate::args::Verb;

pub(crate) const VERSION: &str = concat!("splitstar ", env!("CARGO_PKG_VERSION"), "\n");

pub(crate) fn text(verb: Option<Verb>) -> &'static str {
    match verb {
        None => GENERAL,
        Some(Verb::Sum) => SUM,
        Some(Verb::Hull) => HULL,
        Some(Verb::Info) => INFO,
        Some(Verb::Convert) => CONVERT,
        Some(Verb::Distance) => DISTANCE,
        Some(Verb::Arrange) => ARRANGE,
        Some(Verb::Locate) => LOCATE,
        Some(Verb::Gauss) => GAUSS,
    }
}

const GENERAL: &str = "\
splitstar: exact computational geometry

usage: splitstar VERB FILE... [OPTIONS]

verbs:
  sum      the Minkowski sum of two or more convex polytopes
  hull     the convex hull of the points of one or more files
  info     what a file is: format, counts, dimension, convexity, volume, bounds
  convert  another format; scale, reflect, rotate, move, triangulate; any mesh
  distance whether two convex polytopes overlap, how far apart they are, how deep they overlap
  arrange  the arrangement of curves in the plane, on a torus or on the sphere: counts, cells, a picture
  locate   in which cells of an arrangement points lie, or what is above or below them
  gauss    the Gaussian map of a convex polytope, on the sphere or on a cube: counts, cells, a picture

  splitstar VERB --help tells all about a verb, with an example.

options of all verbs:
  --json         one JSON object on standard output
  -q, --quiet    no notes, no summary, no progress bar
  -h, --help     this text
  -V, --version  the version

Read: OFF, OBJ, STL, PLY, 3MF, VRML 2 and star, each perhaps packed with gzip; the content tells
which. Written: these and glTF (.glb); the ending of the output's name tells which, or --format.
`arrange` reads files of curves (text, WKT, GeoJSON) instead, and writes star and pictures (SVG).
`locate` reads such a star file, and points.
A decimal counts exactly as written, a binary float as the fraction it is; what a format must round
is told. A file without facets is a point set and stands for its hull; a file whose only facet is a
polygon, or has two vertices, is one of dimension 2 or 1.
`-` is standard input or standard output.

exit code: 0 done; 1 error: FILE:LINE: what, and what to do; 2 wrong command line; 130 interrupted

example:
  splitstar sum cube.off octahedron.off -o sum.off
";

const SUM: &str = "\
splitstar sum: the Minkowski sum of two or more convex polytopes, exact

usage: splitstar sum A B [C ...] -o OUT [OPTIONS]

  A B C ...         files of convex polytopes of dimension 0 to 3; `-` is standard input
  -o, --output OUT  where to write the sum; `-` is standard output
  --format FORMAT   what to write; without it the ending of OUT decides (off where it has none)
  --method METHOD   all give the same polytope; the slower ones check the others:
                    overlay  walk over both Gaussian maps (default, the fastest)
                    sgm      overlay of the Gaussian maps as arrangements on the sphere
                    cgm      the same on the six sides of a cube
                    lp       from vertex to vertex of the sum by linear programs
                    hull     convex hull of all sums of vertices; fewer than 2^28 of them
  --hull            take the convex hull of a file that is not convex, and tell how far a vertex
                    of the mesh lies inside it at most
  --triangulate     cut facets into triangles first; the way out for facets that are not planar
  --float           write floats, rounded to nearest, and tell the largest rounding
  --json            one JSON object on standard output: counts, volume, bounds, method, times
  -q, --quiet       no notes, no summary, no progress bar

A file that is not convex is refused, and the edge named where it is not.

example:
  splitstar sum cube.off octahedron.off -o sum.off
  splitstar info sum.off
";

const HULL: &str = "\
splitstar hull: the convex hull of the points of one or more files, exact

usage: splitstar hull A [B ...] -o OUT [OPTIONS]

  A B ...           files, of which only the points are used; `-` is standard input
  -o, --output OUT  where to write the hull; `-` is standard output
  --format FORMAT   what to write; without it the ending of OUT decides (off where it has none)
  --float           write floats, rounded to nearest, and tell the largest rounding
  --json            one JSON object on standard output: counts, volume, bounds, times
  -q, --quiet       no notes, no summary, no progress bar

The hull of coplanar points is a polygon, of collinear points a segment, of equal points a point.

example:
  splitstar hull star.off -o hull.off
";

const INFO: &str = "\
splitstar info: what a file is

usage: splitstar info A [--json]

  A            a file of any format, convex or not, closed or not; `-` is standard input
  --json       one JSON object on standard output
  -q, --quiet  no notes

Coplanar facets that share an edge count as one facet, and edges and vertices that vanish thereby
are not counted; `filed` are the numbers in the file. Components are boundary shells. The volume is
exact, and there is none if the boundary is not closed.

example:
  splitstar info cube.off --json
";

const CONVERT: &str = "\
splitstar convert: another format; scale, reflect, rotate, move, triangulate; any mesh, exact

usage: splitstar convert A -o OUT [OPTIONS]

  A                     a file of any format, convex or not; `-` is standard input
  -o, --output OUT      where to write; `-` is standard output
  --format FORMAT       what to write: off, obj, stl, stl-ascii, ply, ply-big-endian, ply-ascii,
                        3mf, glb, wrl or star, each also with .gz behind it (stl.gz); without it
                        the ending of OUT decides (off where it has none)

mended first, with a note each: equal positions are welded where the surface is not closed without
it, vertices on no facet are dropped, a mesh that is inside out is turned round.

  --join                join coplanar facets and collinear edges
  --triangulate         cut facets into triangles, with holes too; the way out for facets that are
                        not planar. With --join: what is joined is cut

then applied, in this order:
  --unit UNIT           micron, millimeter, centimeter, inch, foot or meter: coordinates in another
                        unit are converted exactly; a file without a unit gets this one
  --scale S             multiply by S, not zero; a negative S also reflects
  --reflect             x to -x, for all three coordinates
  --rotate AX,AY,AZ,DEG turn about an axis through the origin, counterclockwise, by DEG degrees:
                        exact for multiples of 90 about a coordinate axis, else by a rational
                        rotation less than 1e-12 away; its quaternion is printed
  --quat W,X,Y,Z        turn by a quaternion, exactly; its length does not matter
  --translate X,Y,Z     move

  --lossy               where the format cannot hold it all (holes, marks, pieces of lower
                        dimension), write the regular part and tell what is left out
  --float               write floats, rounded to nearest, and tell the largest rounding
  --json                one JSON object on standard output
  -q, --quiet           no notes, no summary, no progress bar

A number may be an integer, a decimal or a fraction p/q. Facets keep their orientation: if the map
reflects, they are turned round.

example:
  splitstar convert cube.stl -o cube.3mf --unit millimeter
  splitstar convert cube.off -o turned.off --scale 1/2 --rotate 0,0,1,30 --translate -1,0,0.5
";

const DISTANCE: &str = "\
splitstar distance: whether two convex polytopes overlap, how far apart, how deep, exact

usage: splitstar distance A B [OPTIONS]

  A B               files of convex polytopes of dimension 0 to 3; `-` is standard input
  --quat-b W,X,Y,Z  turn B about the origin by a quaternion, exactly; its length does not matter
  --move-b X,Y,Z    then move it
  --along X,Y,Z     tell how many times B must be moved by X,Y,Z until they overlap no more
  --path FILE       many placements instead, one a line: X Y Z, or X Y Z W X Y Z with a
                    quaternion; `#` starts a comment. Prints one line, or one object, for each
  --hull            take the convex hull of a file that is not convex, and tell how far a vertex
                    of the mesh lies inside it at most
  --triangulate     cut facets into triangles first; the way out for facets that are not planar
  --json            a JSON object for each placement: relation, squared distance, squared
                    penetration, closest points, features
  -q, --quiet       no notes, no progress bar

The relation is disjoint, touching (only boundaries meet) or overlapping (interiors meet). A point,
a segment and a polygon overlap a solid if they meet its interior. The penetration is the length of
the shortest move of B that ends the overlap; its direction is told. Roots may be irrational: the
squares are exact. Witnesses are features by the numbers of their vertices in the files. A line of
--path is the relation, the square of distance or penetration, and with --along the number of times.

example:
  splitstar distance cube.off octahedron.off --move-b 3,0,1/2 --along 0,0,1
  splitstar distance cube.off octahedron.off --path motion.txt
";

const ARRANGE: &str = "\
splitstar arrange: the arrangement of curves in the plane, on a flat torus or on the sphere, exact

usage: splitstar arrange CURVES [CURVES ...] [-o OUT.star|OUT.svg] [OPTIONS]

  CURVES            files of curves, which are put together; `-` is standard input. One curve a
                    line: segment x1 y1 x2 y2, ray x1 y1 x2 y2, line x1 y1 x2 y2,
                    polyline x y x y ..., point x y, a geometry of WKT or an object of GeoJSON
  -o, --output OUT  where to write the cells; `-` is standard output. Without it only their
                    numbers are printed
  --format FORMAT   star: all cells, exact; svg: a picture; each also with .gz behind it (svg.gz);
                    without it the ending of OUT decides (star where it has none)
  --surface SURFACE plane (default), torus, which needs its periods, or sphere
  --period P,Q      the periods of a torus, for files without the record `period P Q`
  --json            one JSON object on standard output: numbers of cells, times
  -q, --quiet       no notes, no summary, no progress bar

on the sphere:
  CURVES            one a line: arc x1 y1 z1 x2 y2 z2 (the shorter arc of a great circle between
                    two points), the same with via x y z (through a third point), circle nx ny nz
                    (by its normal), polyline x y z x y z ..., point x y z, with directions of any
                    length; in WKT and GeoJSON longitude and latitude in degrees: rational points
                    of the unit sphere less than 1.5e-9 radians away
  --identification X,Y  the half circle from pole to pole through (X, Y, 0), where the sphere is cut
                    open (-1,0): what is artificial depends on it, nothing else
  --view VIEW       what a picture shows: globe (two hemispheres, default) or unfolded (longitude
                    and latitude)

Points of the file are isolated vertices unless a curve runs through them. Joints of polylines are
no vertices. The numbers with splits count the vertices, too, at which curves had to be cut.

example:
  splitstar arrange curves.txt
  splitstar arrange curves.txt -o curves.svg
  splitstar arrange --surface sphere coast.geojson -o coast.svg
";

const LOCATE: &str = "\
splitstar locate: in which cells of an arrangement points lie, exact

usage: splitstar locate ARRANGEMENT.star POINTS [OPTIONS]

  ARRANGEMENT.star     a file that `splitstar arrange -o` has written; `-` is standard input
  POINTS               a file of points; `-` is standard input. One a line: x y, point x y, a POINT
                       of WKT or an object of GeoJSON; integers, decimals or fractions p/q. On a
                       torus any coordinates will do. On the sphere x y z or point x y z, and in
                       WKT and GeoJSON longitude and latitude
  --ray DIRECTION      up or down: tell not where a point lies, but which vertex or edge a vertical
                       ray from there meets first; if none, the face through which it leaves. On
                       the sphere it goes along the meridian, and ends in the pole
  --strategy STRATEGY  how cells are found; all give the same answers:
                       naive       look at every cell
                       walk        walk along a vertical line, face by face
                       landmarks   walk from a point nearby whose cell is known
                       trapezoids  search the vertical decomposition, which is made first
                       sweep       one sweep over cells and points; not with --ray
                       without it the number of points decides
  -o, --output OUT     where to write the answers; without it, and for `-`, standard output
  --json               one JSON object on standard output: answers, counts, strategy, times
  -q, --quiet          no notes, no summary, no progress bar

An answer a line, in the order of the points: `vertex 12`, `edge 5` or `face 0`, numbered as in the
file of the arrangement.

example:
  splitstar locate curves.star points.txt
  echo 1/2 0.25 | splitstar locate curves.star - --ray up
";

const GAUSS: &str = "\
splitstar gauss: the Gaussian map of a convex polytope, exact

usage: splitstar gauss A [-o OUT.star|OUT.svg] [OPTIONS]

  A                 a file of a convex polytope of dimension 0 to 3, or of a Gaussian map; `-` is
                    standard input
  -o, --output OUT  where to write the map; `-` is standard output. Without it only the numbers of
                    its cells are printed
  --format FORMAT   star: all cells with the vertices of the polytope, exact; svg: a picture; each
                    also with .gz behind it (svg.gz); without it the ending of OUT decides (star
                    where it has none)
  --cubical         the map projected to the six sides of a cube, and not that on the sphere
  --identification X,Y  the half circle from pole to pole through (X, Y, 0), where the sphere is cut
                    open (-1,0): what is artificial depends on it, nothing else
  --view VIEW       what a picture of the sphere shows: globe (two hemispheres, default) or unfolded
                    (longitude and latitude); a cube is shown as the cross of its sides
  --hull            take the convex hull of a file that is not convex
  --triangulate     cut facets into triangles first; the way out for facets that are not planar
  --json            one JSON object on standard output: numbers of cells, times
  -q, --quiet       no notes, no summary, no progress bar

A facet of the polytope is a vertex of the map (its outer normal), an edge is an edge, a vertex is a
face. The numbers with splits count what is artificial, too: where the sphere is cut open, and the
edges of the cube. `sum`, `info`, `hull` and `convert` read the file of a map as its polytope.

example:
  splitstar gauss cube.off -o cube.svg
  splitstar gauss cube.off --cubical -o cube.star
  splitstar sum cube.star octahedron.off -o sum.off
";
