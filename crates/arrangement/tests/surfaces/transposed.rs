//! The same surfaces with u and v exchanged: the cells are the same.

use crate::glue::face_count;
use crate::paths::{Curve, cells, make};
use crate::random::{SIZE, check_provenance, random_curves};
use crate::strip::Strip;
use crate::tube::{Transposed, Tube};
use splitstar_arrangement::overlay::overlay_all;
use splitstar_arrangement::traits::SideKind;
use splitstar_arrangement::{Arrangement, Pieces};
use testkit::Rng;

#[test]
fn the_cells_are_those_of_the_strip() {
    use SideKind::{Contracted, Open};
    for (number, kinds) in (0..).zip([[Open; 2], [Contracted; 2], [Open, Contracted]]) {
        let seed = 5001 + number;
        let mut rng = Rng::new(seed);
        let traits = Transposed { strip: Strip { size: SIZE, v: kinds } };
        let made = |curves: &[Curve]| Arrangement::of_curves(traits, Tube(kinds), curves);
        for round in 0..400 {
            let curves = random_curves(&mut rng, kinds, 8);
            let context = format!("seed {seed}, round {round}, {kinds:?}: {curves:?}");
            let arrangement = made(&curves);
            assert_eq!(arrangement.check_valid(), [], "{context}");
            let [counts, stored] = [arrangement.counts(), arrangement.counts_with_splits()];
            let strip = make::<true>(SIZE, kinds, &curves);
            assert_eq!(cells(&counts), cells(&strip.counts()), "{context}");
            assert_eq!(stored.isolated, strip.counts_with_splits().isolated, "{context}");
            assert_eq!(counts.faces, face_count(SIZE, kinds, &curves), "{context}");
            let (first, second) = curves.split_at(rng.index(curves.len() + 1));
            let operands = [made(first), made(second)];
            let (overlay, provenance) = overlay_all(&[&operands[0], &operands[1]]);
            assert_eq!(overlay.difference(&arrangement), None, "overlay, {context}");
            assert_eq!(overlay.check_valid(), [], "overlay, {context}");
            check_provenance(&overlay, &operands, &provenance, &context);
            let mut grown = operands[0].clone();
            grown.insert_pieces(Pieces::of_curves(&traits, second));
            assert_eq!(grown.difference(&arrangement), None, "insertion, {context}");
        }
    }
}
