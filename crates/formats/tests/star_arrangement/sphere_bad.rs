//! What is refused of arrangements on the sphere, with its message.

use super::bad::check;
use super::{comes_back, read};

/// A cross of two arcs, lines 1 to 20, the north pole and a point of the identification arc.
const CROSS: &str = "\
star 1 arrangement
surface sphere -1 0
curve 0 arc 1 -1 0 1 1 0
curve 1 arc 1 0 -1 1 0 1
vertex 0 -1 0 0
vertex 1 0 0 1
vertex 2 1 -1 0
vertex 3 1 0 -1
vertex 4 1 0 0
vertex 5 1 0 1
vertex 6 1 1 0
edge 0 2 4 curve 0
edge 1 3 4 curve 1
edge 2 4 6 curve 0
edge 3 4 5 curve 1
face 0
inner -0 +0 +3 -3 +2 -2 -1 +1
isolated 0
isolated 1
end
";

/// What is written in place of what, and the message.
const CHANGES: &[(&str, &str, &str)] = &[
    (
        "sphere -1 0",
        "sphere",
        "line 2: the line ends where one of two coordinates of the identification arc was expected; complete it",
    ),
    (
        "sphere -1 0",
        "sphere 0 0",
        "line 2: the direction of the identification arc is zero; give one that is not",
    ),
    ("sphere -1 0", "sphere -1 0 0", "line 2: `0` where the end of the line was expected; correct it"),
    (
        "sphere -1 0",
        "sphere 1 0",
        "line 3: the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own",
    ),
    ("sphere -1 0", "sphere x 0", "line 2: `x` is no number; write an integer, a decimal or a fraction p/q"),
    (
        "arc 1 -1 0 1 1 0",
        "segment 1 -1 0 1 1 0",
        "line 3: `segment` where `arc`, `circle` or `polyline` was expected; correct it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1",
        "line 3: the line ends where one of three coordinates was expected; complete it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0",
        "line 3: the line ends where one of three coordinates was expected; complete it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 2",
        "line 3: `2` where `around` or the end of the line was expected; correct it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 0 1 0",
        "line 3: `0` where `around` or the end of the line was expected; correct it",
    ),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 0 0 0", "line 3: the direction is zero; give one that is not"),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 2 -2 0",
        "line 3: both ends of the arc are the same; give two different ones",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 -1 1 0",
        "line 3: the ends of the arc are opposite to each other; add `around` and the normal of its circle",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 around",
        "line 3: the line ends where one of three coordinates of a normal was expected; complete it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 around 0 0 0",
        "line 3: the direction is zero; give one that is not",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 around 0 1 1",
        "line 3: an end of the arc is not on the circle around its normal; correct one of them",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 around 0 0 1 1",
        "line 3: `1` where `around` or the end of the line was expected; correct it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 via 1 0 0",
        "line 3: `via` where `around` or the end of the line was expected; correct it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "arc 1 -1 0 1 1 0 around 0 0 -1",
        "line 3: the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own",
    ),
    (
        "arc 1 0 -1 1 0 1",
        "arc 1 0 -1 1 0 1 around 0 1 0",
        "line 4: the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "circle 1 -1",
        "line 3: the line ends where one of three coordinates was expected; complete it",
    ),
    ("arc 1 -1 0 1 1 0", "circle 0 0 0", "line 3: the direction is zero; give one that is not"),
    (
        "arc 1 -1 0 1 1 0",
        "circle 1 -1 0",
        "line 3: the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "polyline 1 -1 0",
        "line 3: the line ends where one of three coordinates was expected; complete it",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "polyline 1 -1 0 1 1 0 1 0 1",
        "line 3: the curve turns back in longitude, or is vertical in part only; cut it there into curves of their own",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "polyline 1 -1 0 1 1 0 1 1 0",
        "line 3: both ends of the arc are the same; give two different ones",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "polyline 1 -1 0 1 1 0 1 1 1",
        "line 3: the curve turns back in longitude, or is vertical in part only; cut it there into curves of their own",
    ),
    (
        "arc 1 -1 0 1 1 0",
        "polyline 0 -1 0 1 1 0 -1 1 0 -1 -1 0",
        "line 3: the curve passes through a pole, or crosses the identification arc; cut it there into curves of their own",
    ),
    ("vertex 0 -1 0 0", "vertex 0 0 0 0", "line 5: the direction is zero; give one that is not"),
    (
        "vertex 0 -1 0 0",
        "vertex 0 -1 0",
        "line 5: the line ends where one of three coordinates was expected; complete it",
    ),
    (
        "vertex 0 -1 0 0",
        "vertex 0 -1 0 0 0",
        "line 5: `0` where `artificial` or the end of the line was expected; correct it",
    ),
    (
        "vertex 0 -1 0 0",
        "vertex 0 0 0 2",
        "line 6: vertex 0 is the north pole already; remove one of the two",
    ),
    (
        "vertex 0 -1 0 0",
        "vertex 0 1 0 0",
        "line 9: vertex 0 and vertex 4 are one point; remove one of them, and name the other one instead",
    ),
    ("vertex 0 -1 0 0", "vertex 0 2 1 0", "line 14: vertex 0 lies within the edge; cut the edge there"),
    (
        "vertex 1 0 0 1",
        "vertex 1 0 0 1 artificial",
        "line 6: vertex 1 joins 0 edges and not 2; remove `artificial`",
    ),
    (
        "vertex 4 1 0 0",
        "vertex 4 1 0 0 artificial",
        "line 9: vertex 4 joins 4 edges and not 2; remove `artificial`",
    ),
    (
        "vertex 2 1 -1 0",
        "vertex 2 1 -1 1",
        "line 12: vertex 2 is not on curve 0; move it there, or name another vertex or curve",
    ),
    (
        "vertex 2 1 -1 0",
        "vertex 2 -1 1 0",
        "line 12: vertex 2 is not on curve 0; move it there, or name another vertex or curve",
    ),
    (
        "vertex 2 1 -1 0",
        "vertex 2 0 -1 0",
        "line 12: vertex 2 is not on curve 0; move it there, or name another vertex or curve",
    ),
    (
        "vertex 3 1 0 -1",
        "vertex 3 0 0 -1",
        "line 13: vertex 3 is not on curve 1; move it there, or name another vertex or curve",
    ),
    (
        "edge 0 2 4",
        "edge 0 4 2",
        "line 17: +1 ends at vertex 4, and -0 begins at vertex 2; let each begin where the one before it ends",
    ),
    (
        "edge 0 2 4",
        "edge 0 infinity 4",
        "line 12: `infinity` where the number of a vertex declared above was expected; correct it",
    ),
    ("edge 3 4 5", "edge 3 4 1", "line 19: vertex 1 has edges; remove it here"),
    ("isolated 1\n", "", "line 6: vertex 1 has no edge; add `isolated` to the face in which it lies"),
    ("inner", "outer", "line 17: the boundary is no outer one; write `inner`"),
    (
        "+0 +3 -3 +2 -2 -1 +1",
        "+0 +2 -2 +3 -3 -1 +1",
        "line 9: the boundaries around vertex 4 contradict the order of its edges; let each go on there with the next edge clockwise",
    ),
    ("isolated 1\n", "face 1\nisolated 1\n", "line 19: the face has no boundary; add `outer` or `inner`"),
];

#[test]
fn every_change_is_refused_with_its_message() {
    assert_eq!(comes_back(&read(CROSS)), CROSS);
    let mut wrong = Vec::new();
    for (from, to, expected) in CHANGES {
        assert!(CROSS.contains(from), "{from}");
        check(&CROSS.replacen(from, to, 1), expected, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whole files: what is wrong with them is in several lines.
const FILES: &[(&str, &str)] = &[
    // The equator in one face, and turned round.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nouter +0\nend\n",
        "line 9: faces and boundaries do not make up the surface; put together what bounds one face, and take apart what bounds several",
    ),
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\n\
         edge 0 0 0 curve 0\nface 0\nouter +0\nface 1\nouter -0\nend\n",
        "line 6: face 0 is not the one at the south pole, next to the identification arc; write that first",
    ),
    // The vertex of a circle is on the identification arc.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 1 0 0\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nface 1\nouter +0\nend\n",
        "line 5: the ends of the edge are equal or in the wrong order; write the lesser one first",
    ),
    // A pole in the face on the other side of the equator.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\nvertex 1 0 0 1\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nisolated 1\nface 1\nouter +0\nend\n",
        "line 5: at vertex 1, the boundaries say face 0 where the curves say face 1; write what is there behind `face 1`",
    ),
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\nvertex 1 0 0 -1\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nface 1\nouter +0\nisolated 1\nend\n",
        "line 7: face 0 is not the one at the south pole, next to the identification arc; write that first",
    ),
    // Two circles that cross twice.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 1 1\ncurve 1 circle 0 -1 2\n\
         vertex 0 -1 0 0\nedge 0 0 0 curve 0\nedge 1 0 0 curve 1\n\
         face 0\nouter -0 -1\nface 1\nouter +0 +1\nend\n",
        "line 5: the boundaries do not run round vertex 0 in one turn; let each go on there with the next edge clockwise",
    ),
    // Half circles from pole to pole: one of them twice.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 0 0 -1 0 0 1 around 0 1 0\n\
         vertex 0 0 0 -1\nvertex 1 0 0 1\nedge 0 0 1 curve 0\nedge 1 0 1 curve 0\n\
         face 0\nouter +0 -1\nface 1\nouter +1 -0\nend\n",
        "line 7: the edge and edge 0 have a piece in common; write that once, as an edge of its own",
    ),
    // Arcs that cross.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 -1 -1 1 1 1\ncurve 1 arc 1 -1 1 1 1 -1\n\
         vertex 0 1 -1 -1\nvertex 1 1 -1 1\nvertex 2 1 1 -1\nvertex 3 1 1 1\nedge 3 0 3 curve 0\nedge 8 1 2 curve 1\n\
         face 0\ninner -3 +3\ninner -8 +8\nend\n",
        "line 10: the edge meets edge 3 where no vertex is; add one there, and cut both edges",
    ),
    // An edge from the wrong pole: any vertex that stands for a side was taken for the one at the end of a curve.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 0 0 -1 1 0 0\nvertex 0 0 0 1\nvertex 1 1 0 0\n\
         edge 0 0 1 curve 0\nface 0\nouter -0 +0\nend\n",
        "line 6: vertex 0 is not on curve 0; move it there, or name another vertex or curve",
    ),
    // An edge over the end of its curve, up to a pole.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 0 0 1 0 2\nvertex 0 1 0 0\nvertex 1 0 0 1\n\
         edge 0 0 1 curve 0\nface 0\nouter -0 +0\nend\n",
        "line 6: vertex 1 is not on curve 0; move it there, or name another vertex or curve",
    ),
    // Nothing says of a pole without a record in which face it is, but curves end there.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 0 0 0 0 1\nvertex 0 1 0 0\nvertex 1 1 0 3\nvertex 2 0 0 -1\n\
         edge 0 0 1 curve 0\nedge 1 1 2 curve 0\nface 0\nouter -0 +0 +1 -1\nend\n",
        "line 8: vertex 2 is not on curve 0; move it there, or name another vertex or curve",
    ),
    // Ends in the wrong order, and in a face where they are not.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 0 0 0 1 0\nvertex 0 1 0 0\nvertex 1 0 1 0\n\
         edge 0 1 0 curve 0\nface 0\ninner -0 +0\nend\n",
        "line 6: the ends of the edge are equal or in the wrong order; write the lesser one first",
    ),
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\ncurve 1 arc 1 0 1 0 1 1\n\
         vertex 0 -1 0 0 artificial\nvertex 1 0 1 1\nvertex 2 1 0 1\nedge 0 0 0 curve 0\nedge 1 2 1 curve 1\n\
         face 0\nouter -0\ninner -1 +1\nface 1\nouter +0\nend\n",
        "line 7: at vertex 2, the boundaries say face 0 where the curves say face 1; write what is there behind `face 1`",
    ),
];

#[test]
fn whole_files_are_refused_with_their_messages() {
    let mut wrong = Vec::new();
    for (text, expected) in FILES {
        check(text, expected, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
