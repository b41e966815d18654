//! The page on the format shows what is written.

use super::{comes_back, read};

#[test]
fn the_examples_of_the_page_are_what_is_written() {
    let page = include_str!("../../../../docs/star.md");
    let blocks = page.split("```star-gaussian\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    let mut counts = Vec::new();
    for example in blocks {
        let map = read(example);
        assert_eq!(comes_back(&map), example);
        counts.push(map.make_polytope().counts().to_array());
    }
    assert_eq!(counts, [[4, 6, 4], [2, 1, 0], [4, 6, 4]]);
}
