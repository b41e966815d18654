//! What is refused of arrangements on the sphere, with its message.

use super::bad::check;
use super::random::{Numbers, changed};
use super::sphere::{chains, random_arcs, sphere};
use super::{comes_back, read, write};
use splitstar_formats::read_arrangement;

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
    ("sphere -1 0", "sphere", ""),
    ("sphere -1 0", "sphere 0 0", ""),
    ("sphere -1 0", "sphere -1 0 0", ""),
    ("sphere -1 0", "sphere 1 0", ""),
    ("sphere -1 0", "sphere x 0", ""),
    ("arc 1 -1 0 1 1 0", "segment 1 -1 0 1 1 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 2", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 0 1 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 0 0 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 2 -2 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 -1 1 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 around", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 around 0 0 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 around 0 1 1", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 around 0 0 1 1", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 via 1 0 0", ""),
    ("arc 1 -1 0 1 1 0", "arc 1 -1 0 1 1 0 around 0 0 -1", ""),
    ("arc 1 0 -1 1 0 1", "arc 1 0 -1 1 0 1 around 0 1 0", ""),
    ("arc 1 -1 0 1 1 0", "circle 1 -1", ""),
    ("arc 1 -1 0 1 1 0", "circle 0 0 0", ""),
    ("arc 1 -1 0 1 1 0", "circle 1 -1 0", ""),
    ("arc 1 -1 0 1 1 0", "polyline 1 -1 0", ""),
    ("arc 1 -1 0 1 1 0", "polyline 1 -1 0 1 1 0 1 0 1", ""),
    ("arc 1 -1 0 1 1 0", "polyline 1 -1 0 1 1 0 1 1 0", ""),
    ("arc 1 -1 0 1 1 0", "polyline 1 -1 0 1 1 0 1 1 1", ""),
    ("arc 1 -1 0 1 1 0", "polyline 0 -1 0 1 1 0 -1 1 0 -1 -1 0", ""),
    ("vertex 0 -1 0 0", "vertex 0 0 0 0", ""),
    ("vertex 0 -1 0 0", "vertex 0 -1 0", ""),
    ("vertex 0 -1 0 0", "vertex 0 -1 0 0 0", ""),
    ("vertex 0 -1 0 0", "vertex 0 0 0 2", ""),
    ("vertex 0 -1 0 0", "vertex 0 1 0 0", ""),
    ("vertex 0 -1 0 0", "vertex 0 2 1 0", ""),
    ("vertex 1 0 0 1", "vertex 1 0 0 1 artificial", ""),
    ("vertex 4 1 0 0", "vertex 4 1 0 0 artificial", ""),
    ("vertex 2 1 -1 0", "vertex 2 1 -1 1", ""),
    ("vertex 2 1 -1 0", "vertex 2 -1 1 0", ""),
    ("vertex 2 1 -1 0", "vertex 2 0 -1 0", ""),
    ("vertex 3 1 0 -1", "vertex 3 0 0 -1", ""),
    ("edge 0 2 4", "edge 0 4 2", ""),
    ("edge 0 2 4", "edge 0 infinity 4", ""),
    ("edge 3 4 5", "edge 3 4 1", ""),
    ("isolated 1\n", "", ""),
    ("inner", "outer", ""),
    ("+0 +3 -3 +2 -2 -1 +1", "+0 +2 -2 +3 -3 -1 +1", ""),
    ("isolated 1\n", "face 1\nisolated 1\n", ""),
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
        "",
    ),
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\n\
         edge 0 0 0 curve 0\nface 0\nouter +0\nface 1\nouter -0\nend\n",
        "",
    ),
    // The vertex of a circle is on the identification arc.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 1 0 0\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nface 1\nouter +0\nend\n",
        "",
    ),
    // A pole in the face on the other side of the equator.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\nvertex 1 0 0 1\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nisolated 1\nface 1\nouter +0\nend\n",
        "",
    ),
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 0 1\nvertex 0 -1 0 0 artificial\nvertex 1 0 0 -1\n\
         edge 0 0 0 curve 0\nface 0\nouter -0\nface 1\nouter +0\nisolated 1\nend\n",
        "",
    ),
    // Two circles that cross twice.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 circle 0 1 1\ncurve 1 circle 0 -1 2\n\
         vertex 0 -1 0 0\nedge 0 0 0 curve 0\nedge 1 0 0 curve 1\n\
         face 0\nouter -0 -1\nface 1\nouter +0 +1\nend\n",
        "",
    ),
    // Half circles from pole to pole: one of them twice.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 0 0 -1 0 0 1 around 0 1 0\n\
         vertex 0 0 0 -1\nvertex 1 0 0 1\nedge 0 0 1 curve 0\nedge 1 0 1 curve 0\n\
         face 0\nouter +0 -1\nface 1\nouter +1 -0\nend\n",
        "",
    ),
    // Arcs that cross.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 -1 -1 1 1 1\ncurve 1 arc 1 -1 1 1 1 -1\n\
         vertex 0 1 -1 -1\nvertex 1 1 -1 1\nvertex 2 1 1 -1\nvertex 3 1 1 1\nedge 3 0 3 curve 0\nedge 8 1 2 curve 1\n\
         face 0\ninner -3 +3\ninner -8 +8\nend\n",
        "",
    ),
    // An edge over a pole that is a vertex of its own.
    (
        "star 1 arrangement\nsurface sphere -1 0\ncurve 0 arc 1 0 0 0 0 1\nvertex 0 1 0 0\nvertex 1 1 0 9\nvertex 2 0 0 1\n\
         edge 0 0 1 curve 0\nface 0\ninner -0 +0\nisolated 2\nend\n",
        "",
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

/// Whatever is changed in a text, it is read, and then is an arrangement, or it is refused with a short message and a line.
#[test]
fn changed_texts_are_read_or_refused() {
    let mut numbers = Numbers::new(23);
    let (mut read_back, mut refused) = (0, 0);
    for case in 0..1000 {
        let arcs = random_arcs(&mut numbers);
        let identification = [[-1, 0], [1, 1], [0, 1]][case % 3];
        let text =
            write(&if case % 2 == 0 { sphere(identification, &arcs) } else { chains(identification, &arcs) });
        for _ in 0..8 {
            let changed = changed(&text, &mut numbers);
            match read_arrangement(changed.as_bytes(), None) {
                Ok(arrangement) => {
                    comes_back(&arrangement);
                    read_back += 1;
                }
                Err(error) => {
                    let message = error.to_string();
                    assert!(message.len() < 400 && !message.contains(char::is_control), "{message}");
                    assert!(message.starts_with("line "), "{case}: {message}\n{changed}");
                    refused += 1;
                }
            }
        }
    }
    println!("{read_back} read, {refused} refused");
    assert!(read_back > 100 && refused > 2000, "{read_back} {refused}");
}

#[test]
fn prefixes_are_refused() {
    let mut numbers = Numbers::new(24);
    for case in 0..4 {
        let arcs = random_arcs(&mut numbers);
        let text = write(&if case % 2 == 0 { sphere([-1, 0], &arcs) } else { chains([-1, 0], &arcs) });
        for length in 0..text.len() - 1 {
            assert!(read_arrangement(&text.as_bytes()[..length], None).is_err(), "{case} {length}");
        }
        read(&text[..text.len() - 1]);
    }
}
