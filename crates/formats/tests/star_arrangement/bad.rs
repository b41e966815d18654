//! What is refused, with its message.

use super::read;
use splitstar_formats::read_arrangement;

/// A cross of two segments, lines 1 to 21; the horizontal one is curve 0.
const CROSS: &str = "\
star 1 arrangement
surface plane
curve 0 segment 0 1 2 1
curve 1 segment 1 0 1 2
vertex 0 0 1
vertex 1 1 0
vertex 2 1 1
vertex 3 1 2
vertex 4 2 1
vertex 5 5 5
edge 0 0 2 curve 0
edge 1 1 2 curve 1
edge 2 2 4 curve 0
edge 3 2 3 curve 1
face 0
inner -0 +0 -1 +1 -2
isolated 5
end
";

fn cross() -> String {
    CROSS.replace("inner -0 +0 -1 +1 -2", "inner -0 +0 +3 -3 +2 -2 -1 +1")
}

pub(crate) fn message(text: &str) -> String {
    match read_arrangement(text.as_bytes(), None) {
        Ok(_) => panic!("it is read:\n{text}"),
        Err(error) => error.to_string(),
    }
}

/// What is written in place of what, and the message.
const CHANGES: &[(&str, &str, &str)] = &[
    (
        "arrangement\n",
        "complex\n",
        "line 1: a mesh (star kind `complex`) as an arrangement cannot be read; give a file that begins with `star 1 arrangement`, or curves",
    ),
    (
        "arrangement\n",
        "map\n",
        "line 1: star kind `map` cannot be read; this program knows the kinds `complex`, `arrangement` and `gaussian` only: update it, or correct the kind",
    ),
    (
        "star 1",
        "star 2",
        "line 1: star version 2 cannot be read; this program knows version 1 only: update it",
    ),
    (
        "star 1 arrangement",
        "OFF",
        "line 1: a file of OFF as an arrangement cannot be read; give a star file, which begins with `star 1 arrangement`",
    ),
    (
        "surface plane\n",
        "",
        "line 2: `curve` where the second line `surface plane`, `surface torus P Q` or `surface sphere DX DY` was expected; correct it",
    ),
    (
        "surface plane",
        "surface bottle",
        "line 2: `bottle` where `plane`, `torus` or `sphere` was expected; correct it",
    ),
    ("surface plane", "surface torus 1 0", "line 2: the period along v is not positive; give one that is"),
    ("curve 0 segment", "surface plane\ncurve 0 segment", "line 3: a second surface; remove one"),
    (
        "surface plane",
        "surface torus 3 3",
        "line 3: `segment` where `path`, the only curve on a torus, was expected; correct it",
    ),
    ("curve 1", "curve 0", "line 4: `0` where a number above 0, the one before, was expected; correct it"),
    (
        "curve 0 segment",
        "curve x segment",
        "line 3: `x` where the number of the curve, below 1073741824, was expected; correct it",
    ),
    (
        "segment 0 1 2 1",
        "circle 0 1 2 1",
        "line 3: `circle` where `segment`, `ray`, `line` or `polyline` was expected; correct it",
    ),
    (
        "segment 0 1 2 1",
        "segment 0 1 2",
        "line 3: the line ends where one of four coordinates was expected; complete it",
    ),
    (
        "segment 0 1 2 1",
        "segment 0 1 2 1 1",
        "line 3: `1` where the end of the line was expected; correct it",
    ),
    (
        "segment 0 1 2 1",
        "ray 0 1 0 1",
        "line 3: both points of the ray are the same; give two different ones",
    ),
    (
        "segment 0 1 2 1",
        "segment 0 1 2 1,5",
        "line 3: `1,5` is no number; write an integer, a decimal or a fraction p/q",
    ),
    (
        "segment 0 1 2 1",
        "polyline 0 1",
        "line 3: the polyline has no piece; give it two points, or a point and `infinity dx dy`",
    ),
    (
        "segment 0 1 2 1",
        "polyline 0 1 1 1 1 1 2 1",
        "line 3: a point of the polyline is the same as the one before it; remove one",
    ),
    (
        "segment 0 1 2 1",
        "polyline 0 1 2 1 1 3",
        "line 3: the curve turns back in x, or is vertical in part only; cut it there into curves of their own",
    ),
    (
        "segment 0 1 2 1",
        "polyline infinity 0 0 0 1 2 1",
        "line 3: the direction is zero; give one that is not",
    ),
    (
        "vertex 1 1 0",
        "vertex 1 1",
        "line 6: the line ends where one of two coordinates was expected; complete it",
    ),
    (
        "vertex 1 1 0",
        "vertex 1 1 0 marked",
        "line 6: `marked` where `artificial` or the end of the line was expected; correct it",
    ),
    (
        "vertex 2 1 1",
        "vertex 2 1 1 artificial",
        "line 7: vertex 2 joins 4 edges and not 2; remove `artificial`",
    ),
    (
        "edge 0 0 2",
        "edge 0 0 7",
        "line 11: `7` where the number of a vertex declared above, or `infinity`, was expected; correct it",
    ),
    (
        "2 curve 0\n",
        "2 curve 7\n",
        "line 11: `7` where the number of a curve declared above was expected; correct it",
    ),
    ("2 curve 0\n", "2 of 0\n", "line 11: `of` where `curve` was expected; correct it"),
    ("face 0\n", "", "line 15: `inner` before the first face; write `face` and its number before it"),
    (
        "-0 +0 +3",
        "-0 0 +3",
        "line 16: `0` where an edge declared above with its sign, as `+0` or `-0`, was expected; correct it",
    ),
    (
        "inner -0 +0 +3",
        "inner\n",
        "line 16: the line ends where an edge declared above with its sign, as `+0` or `-0`, was expected; complete it",
    ),
    (
        "-0 +0 +3 -3",
        "-0 +0 -3 +3",
        "line 16: +0 ends at vertex 2, and -3 begins at vertex 3; let each begin where the one before it ends",
    ),
    (" -1 +1\n", " -1 +1 -0 +0\n", "line 16: the boundary has more members than there are; each stands once"),
    (
        "-0 +0 +3 -3 +2 -2 -1 +1",
        "-0 +0 -0 +0",
        "line 16: -0 stands in this line already; remove one of the two",
    ),
    ("isolated 5", "inner -0 +0\nisolated 5", "line 17: -0 stands in line 16 already; remove one of the two"),
    (" -1 +1\n", "\n", "line 12: +1 is in no boundary; add it to that of the face left of it"),
    ("isolated 5\n", "", "line 10: vertex 5 has no edge; add `isolated` to the face in which it lies"),
    ("isolated 5\n", "isolated 4\nisolated 5\n", "line 17: vertex 4 has edges; remove it here"),
    (
        "isolated 5\n",
        "isolated 5\nisolated 5\n",
        "line 18: vertex 5 is isolated in a line before; remove one of the two",
    ),
    ("isolated 5\n", "isolated 5\nface 1\n", "line 18: the face has no boundary; add `outer` or `inner`"),
    ("end\n", "", "line 17: the file ends where a record or `end` was expected; complete it"),
    ("end\n", "end\nvertex 9 9 9\n", "line 19: `vertex` after the end of the arrangement; remove it"),
    (
        "end\n",
        "cell 1\nend\n",
        "line 18: `cell` where `curve`, `vertex`, `edge`, `face`, `outer`, `inner`, `isolated`, `end` or a comment was expected; correct it",
    ),
    // What contradicts the curves.
    (
        "vertex 0 0 1",
        "vertex 0 0 2",
        "line 11: vertex 0 is not on curve 0; move it there, or name another vertex or curve",
    ),
    (
        "vertex 0 0 1",
        "vertex 0 -1 1",
        "line 11: vertex 0 is not on curve 0; move it there, or name another vertex or curve",
    ),
    (
        "edge 0 0 2 curve 0",
        "edge 0 infinity 2 curve 0",
        "line 5: vertex 0 has no edge; add `isolated` to the face in which it lies",
    ),
    (
        "2 4 curve 0",
        "2 4 curve 1",
        "line 13: vertex 4 is not on curve 1; move it there, or name another vertex or curve",
    ),
    ("vertex 5 5 5", "vertex 5 1/2 1", "line 11: vertex 5 lies within the edge; cut the edge there"),
    (
        "vertex 5 5 5",
        "vertex 5 2 1",
        "line 10: vertex 4 and vertex 5 are one point; remove one of them, and name the other one instead",
    ),
    ("inner -0", "outer -0", "line 16: the boundary is no outer one; write `inner`"),
    (
        "+0 +3 -3 +2 -2 -1 +1",
        "+0 +2 -2 +3 -3 -1 +1",
        "line 7: the boundaries around vertex 2 contradict the order of its edges; let each go on there with the next edge clockwise",
    ),
    (
        "-0 +0 +3 -3 +2 -2 -1 +1",
        "-0 +0\ninner +3 -3 +2 -2 -1 +1",
        "line 7: the boundaries do not run round vertex 2 in one turn; let each go on there with the next edge clockwise",
    ),
    ("isolated 5", "face 1\nisolated 5", "line 17: the face has no boundary; add `outer` or `inner`"),
];

pub(crate) fn check(text: &str, expected: &str, wrong: &mut Vec<String>) {
    let found = message(text);
    if found != expected {
        wrong.push(format!("found    {found}\nexpected {expected}\n{text}"));
    }
}

#[test]
fn every_change_is_refused_with_its_message() {
    let text = cross();
    assert_eq!(read(&text).counts().edges, 4);
    let mut wrong = Vec::new();
    for (from, to, expected) in CHANGES {
        assert!(text.contains(from), "{from}");
        let changed = text.replacen(from, to, 1);
        check(&changed, expected, &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whole files: what is wrong with them is in several lines.
const FILES: &[(&str, &str)] = &[
    (
        "",
        "the file is empty; an arrangement was expected, as `splitstar arrange CURVES -o OUT.star` writes it",
    ),
    (
        "# nothing\n",
        "the file is empty; an arrangement was expected, as `splitstar arrange CURVES -o OUT.star` writes it",
    ),
    ("star 1 arrangement\n", "line 1: the file ends where `surface` was expected; complete it"),
    (
        "star 1 arrangement\nsurface plane\nend\n",
        "line 3: the file has no face; add one: also the surface without curves is a face",
    ),
    (
        "star 1 arrangement\nsurface plane\nface 0\nface 1\nend\n",
        "line 4: the face has no boundary; add `outer` or `inner`",
    ),
    (
        "star 1 arrangement\nsurface torus 1 1\nvertex 0 1 0\nface 0\nisolated 0\nend\n",
        "line 3: a coordinate is negative, or not below its period; add or subtract periods",
    ),
    (
        "star 1 arrangement\nsurface torus 1 1\ncurve 0 path 1/2 0 1 0\nend\n",
        "line 3: the path leaves the rectangle of the periods; cut it there into paths of their own",
    ),
    (
        "star 1 arrangement\nsurface torus 1 1\ncurve 0 path 1/2 0 1e99 0\nend\n",
        "line 3: the path leaves the rectangle of the periods; cut it there into paths of their own",
    ),
    (
        "star 1 arrangement\nsurface torus 1 1\ncurve 0 path 1/2 0 0 0\nend\n",
        "line 3: a piece of the path has no length; remove it",
    ),
    // Edges that cross, or overlap.
    (
        "star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 0\ncurve 1 line 0 0 0 1\n\
         edge 0 infinity infinity curve 0\nedge 1 infinity infinity curve 1\n\
         face 0\nouter -0 -1\nface 1\nouter +0 +1\nend\n",
        "line 11: the boundaries do not run round infinity in one turn; let each go on there with the next edge clockwise",
    ),
    (
        "star 1 arrangement\nsurface plane\ncurve 0 segment 0 0 2 0\nvertex 0 0 0\nvertex 1 2 0\n\
         edge 0 0 1 curve 0\nedge 1 0 1 curve 0\nface 0\ninner -0 +1\nface 1\nouter +0 -1\nend\n",
        "line 7: the edge and edge 0 have a piece in common; write that once, as an edge of its own",
    ),
    (
        "star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 0\nedge 0 infinity infinity curve 0\n\
         face 0\nouter +0\nface 1\nouter -0\nend\n",
        "line 5: face 0 is not the one at the lower left; write that first",
    ),
    (
        "star 1 arrangement\nsurface plane\ncurve 0 segment 0 0 2 2\ncurve 1 segment 0 2 2 0\n\
         vertex 0 0 0\nvertex 1 2 2\nvertex 2 0 2\nvertex 3 2 0\nedge 5 0 1 curve 0\nedge 7 2 3 curve 1\n\
         face 0\ninner -5 +5\ninner -7 +7\nend\n",
        "line 10: the edge meets edge 5 where no vertex is; add one there, and cut both edges",
    ),
    // A curve that is bounded does not go to infinity.
    (
        "star 1 arrangement\nsurface plane\ncurve 0 segment 0 0 1 0\nvertex 0 0 0\nedge 0 0 infinity curve 0\n\
         face 0\nouter +0 -0\nend\n",
        "line 5: curve 0 does not go to infinity at this end of the edge; name the vertex that is there",
    ),
    // Ends in the wrong order.
    (
        "star 1 arrangement\nsurface plane\ncurve 0 segment 0 0 1 0\nvertex 0 0 0\nvertex 1 1 0\n\
         edge 0 1 0 curve 0\nface 0\ninner +0 -0\nend\n",
        "line 6: the ends of the edge are equal or in the wrong order; write the lesser one first",
    ),
    // A segment in a face that it is not in.
    (
        "star 1 arrangement\nsurface plane\ncurve 0 line 0 0 1 0\ncurve 1 segment 0 1 1 1\nvertex 0 0 1\nvertex 1 1 1\n\
         edge 0 infinity infinity curve 0\nedge 1 0 1 curve 1\n\
         face 0\nouter -0\ninner +1 -1\nface 1\nouter +0\nend\n",
        "line 5: at vertex 0, the boundaries say face 0 where the curves say face 1; write what is there behind `face 1`",
    ),
    // A boundary of its own: the faces fall apart.
    (
        "star 1 arrangement\nsurface plane\ncurve 0 segment 0 0 1 0\nvertex 0 0 0\nvertex 1 1 0\nvertex 2 5 5\n\
         edge 0 0 1 curve 0\nface 0\nisolated 2\nface 1\ninner +0 -0\nend\n",
        "line 8: the face has no boundary; add `outer` or `inner`",
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

#[test]
fn kinds_are_told_apart() {
    let error = splitstar_formats::read(cross().as_bytes(), None).unwrap_err();
    let expected = "line 1: an arrangement (star kind `arrangement`) as a mesh cannot be read; it has curves of a surface \
                    and no facets: give a mesh";
    assert_eq!(error.to_string(), expected);
    let named = |text: &[u8], name| read_arrangement(text, Some(name)).unwrap_err().to_string();
    assert_eq!(
        named(b"1 2 3\n", "a.obj"),
        "line 1: a file of OBJ as an arrangement cannot be read; give a star file, which begins with `star 1 arrangement`"
    );
    assert_eq!(
        named(b"segment 0 0 1 1\n", "a.txt"),
        "line 1: `segment` where the first line `star 1 arrangement` was expected; correct it"
    );
    assert_eq!(named(b"\xFF\xFEs\0", "a"), "a text in UTF-16 cannot be read; write it in UTF-8");
}

/// Every pair of so many edges meets: the reader must not look for all pairs.
#[test]
fn many_edges_that_meet_take_no_memory() {
    let count = 4000;
    let mut text = "star 1 arrangement\nsurface plane\n".to_string();
    for i in 0..count {
        text += &format!("curve {i} line 0 {} 1 {}\n", i * i, i * i + 2 * i);
    }
    (0..count).for_each(|i| text += &format!("edge {i} infinity infinity curve {i}\n"));
    text += "face 0\nouter -0\n";
    (1..count).for_each(|i| text += &format!("face {i}\nouter +{} -{i}\n", i - 1));
    text += &format!("face {count}\nouter +{}\nend\n", count - 1);
    assert!(message(&text).starts_with("line "), "{}", message(&text));
}
