//! Summaries, and complexes under maps.

use crate::{CUBE, complex, examples, model, records, write};
use exact::{Affine3, Linear3, Rational};
use splitstar_formats::ComplexSummary;

fn short(summary: &ComplexSummary) -> String {
    let ComplexSummary {
        dimension,
        bounded,
        vertices,
        directions,
        edges,
        facets,
        holes,
        volumes,
        unmarked,
        ..
    } = *summary;
    let dimension = dimension.map_or("empty".to_string(), |dimension| dimension.to_string());
    let bounded = if bounded { "bounded" } else { "unbounded" };
    let un = [unmarked.vertices, unmarked.edges, unmarked.facets, unmarked.volumes];
    format!("{dimension} {bounded} {vertices}+{directions} {edges} {facets}-{holes} {volumes} {un:?}")
}

#[test]
fn summaries_count_the_cells() {
    let examples = examples();
    let rows = [
        (examples[1].clone(), "3 bounded 8+0 12 6-0 2 [8, 12, 6, 1]"),
        (examples[2].clone(), "2 bounded 10+0 9 1-1 1 [0, 0, 0, 1]"),
        (examples[3].clone(), "3 unbounded 0+4 0 1-0 2 [0, 0, 0, 1]"),
        (examples[4].clone(), "2 unbounded 1+2 2 1-0 1 [1, 1, 0, 1]"),
        (examples[5].clone(), "1 unbounded 2+3 3 0-0 1 [0, 0, 0, 1]"),
        (records(""), "empty bounded 0+0 0 0-0 1 [0, 0, 0, 1]"),
        (records("volume 0 marked\n"), "3 unbounded 0+0 0 0-0 1 [0, 0, 0, 0]"),
        (records("vertex 0 0 0 0 unmarked\n"), "empty bounded 1+0 0 0-0 1 [1, 0, 0, 1]"),
    ];
    for (text, expected) in rows {
        assert_eq!(short(&complex(&text).summary()), expected, "{text}");
    }
}

#[test]
fn an_unmarked_unbounded_cell_does_not_make_a_set_unbounded() {
    let quarter = "vertex 0 0 0 0\ndirection 1 1 0 0\ndirection 2 0 1 0\nfacet 0 1 2 sides 0 0 unmarked\n";
    let rows =
        [("", false), ("edge 0 1 unmarked\n", false), ("edge 1 0 unmarked\nedge 0 2 unmarked\n", true)];
    for (edges, bounded) in rows {
        let complex = complex(&records(&format!("{quarter}{edges}")));
        assert_eq!(complex.summary().bounded, bounded, "{edges}");
    }
}

fn diagonal(entries: [i64; 3]) -> Affine3 {
    let number = |value: i64| Rational::from(value);
    let rows =
        [0, 1, 2].map(|row| [0, 1, 2].map(|column| number(if row == column { entries[row] } else { 0 })));
    let shift = Affine3::translation(&[number(10), number(0), number(0)]);
    Affine3::from(Linear3::from_rationals(&rows)).then(&shift)
}

#[test]
fn maps_turn_cycles_round_if_they_reflect() {
    let text = records(
        "vertex 0 0 0 0\ndirection 1 1 0 0\ndirection 2 0 1 0\nvertex 3 1 1 0 unmarked\nvertex 4 2 1 0\nvertex 5 1 2 0\n\
         direction 6 -1 0 0\nfacet 0 1 2 hole 3 5 4\nfacet 1 2 6 through 0 0 5 unmarked\nedge 1 6 through 3 3 3\n",
    );
    let reflected = records(
        "vertex 0 10 0 0\ndirection 1 -1 0 0\ndirection 2 0 1 0\nvertex 3 8 1 0 unmarked\nvertex 4 6 1 0\nvertex 5 8 2 0\n\
         direction 6 1 0 0\nfacet 2 1 0 hole 4 5 3\nfacet 6 2 1 through 10 0 5 unmarked\nedge 1 6 through 4 3 3\n",
    );
    let complex = complex(&text);
    let map = diagonal([-2, 1, 1]);
    let image = complex.transformed(&map).unwrap();
    assert_eq!(write(&model(image.clone())), reflected);
    let moved = complex.transformed(&diagonal([2, 1, 1])).unwrap();
    assert_eq!(moved.facets[0].outer, [0, 1, 2]);
    assert_eq!(complex.transformed(&diagonal([0, 1, 1])), None);
    assert_eq!(complex.transformed(&Affine3::identity()), Some(complex));
}

#[test]
fn flat_maps_are_fine_without_directions() {
    let mesh = crate::read(&records(CUBE)).model.shape.mesh().unwrap().clone();
    let flat = splitstar_formats::Complex::of_mesh(&mesh).transformed(&diagonal([1, 1, 0])).unwrap();
    assert_eq!(flat.summary().dimension, Some(3));
}
