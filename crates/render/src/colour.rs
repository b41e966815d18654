//! Colours: a palette without end, in the perceptual space Oklab.
//!
//! The first eight are chosen so that any two of them are easy to tell apart, also for those who do not see all hues.
//! After them hues go on by the golden angle, so that indices that are near each other are far apart in hue, whatever
//! their number; lightness goes through four bands, so that neighbours differ in it too, for every sight.
//!
//! # References
//! Ottosson, A perceptual color space for image processing, 2020 (Oklab).

use crate::trig::cos_sin_turns;

/// A colour.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Colour {
    /// Red, green and blue of sRGB.
    Rgb([u8; 3]),
    /// A colour of the palette. Every index has one.
    Palette {
        /// Which one; neighbours are easy to tell apart.
        index: u32,
        /// Its variant.
        tone: Tone,
    },
}

/// A variant of a colour of the palette.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Tone {
    /// For large areas, under black strokes and letters.
    Pale,
    /// For markers and thick strokes.
    Plain,
    /// For strokes and letters on white or on the pale tone.
    Deep,
}

impl Colour {
    /// White.
    pub const WHITE: Self = Self::Rgb([255; 3]);
    /// Black, but for a little: what strokes and letters have.
    pub const INK: Self = Self::Rgb([34, 36, 42]);
    /// Grey, for what is of no importance.
    pub const GREY: Self = Self::Rgb([128, 132, 140]);

    /// A colour of the palette, for large areas.
    pub fn pale(index: u32) -> Self {
        Self::Palette { index, tone: Tone::Pale }
    }

    /// A colour of the palette.
    pub fn plain(index: u32) -> Self {
        Self::Palette { index, tone: Tone::Plain }
    }

    /// A colour of the palette, for strokes and letters.
    pub fn deep(index: u32) -> Self {
        Self::Palette { index, tone: Tone::Deep }
    }

    /// Red, green and blue of sRGB.
    ///
    /// ```
    /// use splitstar_render::Colour;
    /// assert_eq!(Colour::WHITE.to_rgb(), [255, 255, 255]);
    /// assert_ne!(Colour::pale(0).to_rgb(), Colour::pale(1).to_rgb());
    /// ```
    pub fn to_rgb(self) -> [u8; 3] {
        match self {
            Self::Rgb(rgb) => rgb,
            Self::Palette { index, tone } => palette(index, tone),
        }
    }

    /// As CSS writes it, `#rgb` where that is enough.
    pub fn to_hex(self) -> String {
        let rgb = self.to_rgb();
        if rgb.iter().all(|c| c >> 4 == c & 15) {
            rgb.iter().fold("#".to_owned(), |text, c| text + &format!("{:x}", c & 15))
        } else {
            rgb.iter().fold("#".to_owned(), |text, c| text + &format!("{c:02x}"))
        }
    }
}

/// Hue, in turns, and lightness, from 0 to 1 within the tone, of the first colours. Of what a random search found, these
/// eight are the farthest from each other in the tone and for the sight where they are the nearest: full sight,
/// deuteranopia, protanopia and tritanopia.
const FIRST: [[f64; 2]; 8] = [
    [0.732, 0.46],
    [0.298, 0.57],
    [0.011, 0.47],
    [0.414, 0.94],
    [0.765, 0.00],
    [0.822, 1.00],
    [0.988, 0.00],
    [0.290, 0.08],
];

/// The first colours by their hues, blue, yellow, red and green: those of one hue differ in lightness.
pub(crate) const HUES: [u8; 8] = [0, 1, 2, 3, 0, 0, 2, 1];

/// 2^32 times the golden angle, in turns.
const GOLDEN: u32 = 0x61C8_8647;
/// The lightness of the colours after the first ones goes through these: great steps, dark and light in turn.
const BANDS: [f64; 4] = [1.0, 0.0, 0.8, 0.15];

fn palette(index: u32, tone: Tone) -> [u8; 3] {
    let [hue, level] = FIRST.get(index as usize).copied().unwrap_or_else(|| {
        [f64::from(index.wrapping_mul(GOLDEN)) / 4_294_967_296.0, BANDS[(index % 4) as usize]]
    });
    let ([dark, light], chroma) = match tone {
        Tone::Pale => ([0.80, 0.95], 0.085),
        Tone::Plain => ([0.55, 0.85], 0.15),
        Tone::Deep => ([0.36, 0.56], 0.13),
    };
    in_gamut(dark + level * (light - dark), chroma, hue)
}

/// The colour of that lightness and hue (in turns) with the greatest chroma up to the given one that sRGB has.
fn in_gamut(lightness: f64, chroma: f64, hue: f64) -> [u8; 3] {
    let (cos, sin) = cos_sin_turns(hue);
    let at = |chroma: f64| linear_rgb([lightness, chroma * cos, chroma * sin]);
    let fits = |rgb: [f64; 3]| rgb.iter().all(|c| (0.0..=1.0).contains(c));
    if fits(at(chroma)) {
        return at(chroma).map(encode);
    }
    let (mut low, mut high) = (0.0, chroma);
    for _ in 0..20 {
        let middle = (low + high) / 2.0;
        if fits(at(middle)) {
            low = middle;
        } else {
            high = middle;
        }
    }
    at(low).map(encode)
}

/// From Oklab to linear red, green and blue.
fn linear_rgb([l, a, b]: [f64; 3]) -> [f64; 3] {
    let cube = |c: f64| c * c * c;
    let long = cube(l + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let medium = cube(l - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let short = cube(l - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    [
        4.076_741_662_1 * long - 3.307_711_591_3 * medium + 0.230_969_929_2 * short,
        -1.268_438_004_6 * long + 2.609_757_401_1 * medium - 0.341_319_396_5 * short,
        -0.004_196_086_3 * long - 0.703_418_614_7 * medium + 1.707_614_701_0 * short,
    ]
}

/// The transfer function of sRGB, in 8 bits.
fn encode(linear: f64) -> u8 {
    let value = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        // The power 5/12, by operations that are the same on every machine.
        let twelfth = cube_root(linear).sqrt().sqrt();
        1.055 * (twelfth * twelfth * twelfth * twelfth * twelfth) - 0.055
    };
    // A cast of floats saturates, so this cannot leave the range.
    (value * 255.0).round() as u8
}

/// The cube root of a number in (0.003, 1], by Newton's iteration from above, which converges monotonically.
fn cube_root(value: f64) -> f64 {
    let mut root = 1.0_f64;
    for _ in 0..24 {
        root = (2.0 * root + value / (root * root)) / 3.0;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_root_is_that_of_mathematics() {
        for k in 0..1000 {
            let value = 0.004 + f64::from(k) / 1000.0 * 0.996;
            assert!((cube_root(value) - value.cbrt()).abs() < 1e-14);
        }
    }

    /// To linear light and Oklab, the plain way.
    fn oklab(linear: [f64; 3]) -> [f64; 3] {
        let row = |m: [f64; 3], v: [f64; 3]| m[0] * v[0] + m[1] * v[1] + m[2] * v[2];
        let lms = [
            row([0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9], linear),
            row([0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6], linear),
            row([0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5], linear),
        ]
        .map(f64::cbrt);
        [
            row([0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8], lms),
            row([1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9], lms),
            row([0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0], lms),
        ]
    }

    fn linear(rgb: [u8; 3]) -> [f64; 3] {
        rgb.map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        })
    }

    /// Deuteranopia, protanopia and tritanopia on linear light (Machado, Oliveira and Fernandes 2009, severity 1).
    const SIGHTS: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ];

    fn distance(sight: usize, a: Colour, b: Colour) -> f64 {
        let seen = |colour: Colour| {
            let light = linear(colour.to_rgb());
            oklab(
                SIGHTS[sight]
                    .map(|row| (row[0] * light[0] + row[1] * light[1] + row[2] * light[2]).clamp(0.0, 1.0)),
            )
        };
        let (a, b) = (seen(a), seen(b));
        (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn neighbours_differ_for_every_sight() {
        for (tone, least, among_eight) in
            [(Tone::Pale, 0.05, 0.06), (Tone::Plain, 0.10, 0.11), (Tone::Deep, 0.04, 0.07)]
        {
            for sight in 0..SIGHTS.len() {
                let colour = |index| Colour::Palette { index, tone };
                let near = (0..600).map(|i| distance(sight, colour(i), colour(i + 1))).fold(9.0, f64::min);
                let mut first = 9.0_f64;
                for i in 0..8 {
                    for j in 0..i {
                        first = first.min(distance(sight, colour(i), colour(j)));
                    }
                }
                assert!(near > least, "{tone:?} {sight}: {near}");
                assert!(first > among_eight, "{tone:?} {sight}: {first} among the first eight");
            }
        }
    }

    #[test]
    fn colours_of_one_hue_are_near_on_the_circle() {
        for (i, [a, _]) in FIRST.iter().enumerate() {
            for (j, [b, _]) in FIRST.iter().enumerate() {
                let turn = (a - b).abs();
                assert_eq!(turn.min(1.0 - turn) < 0.1, HUES[i] == HUES[j], "{i} {j}");
            }
        }
    }

    #[test]
    fn hundreds_are_all_different() {
        let mut all: Vec<_> = (0..300).map(|i| Colour::plain(i).to_rgb()).collect();
        all.sort_unstable();
        all.dedup();
        assert!(all.len() > 290, "{}", all.len());
    }

    #[test]
    fn hex_is_short_where_it_can_be() {
        assert_eq!(Colour::WHITE.to_hex(), "#fff");
        assert_eq!(Colour::Rgb([1, 32, 255]).to_hex(), "#0120ff");
    }
}
