use super::*;
use crate::{Integer, Rational};
use ParseNumberErrorKind::{Empty, ExponentTooLarge, NotFinite, TooManyDigits, Word, ZeroDenominator};

#[test]
fn numbers_are_read_exactly() {
    let rows = [
        ("0", "0"),
        ("-0", "0"),
        ("+1", "1"),
        ("007", "7"),
        ("-1.25", "-5/4"),
        (".5", "1/2"),
        ("-.5", "-1/2"),
        ("5.", "5"),
        ("+5.e1", "50"),
        ("0.1", "1/10"),
        ("3e-2", "3/100"),
        ("3E+2", "300"),
        ("1.5e1", "15"),
        ("1.25e1", "25/2"),
        ("0e400", "0"),
        ("1e000000000000000002", "100"),
        ("6/4", "3/2"),
        ("-6/4", "-3/2"),
        ("6/-4", "-3/2"),
        ("+6/+4", "3/2"),
        ("0/5", "0"),
        ("123456789012345678", "123456789012345678"),
        ("1234567890123456789", "1234567890123456789"),
        ("-123456789012345678901234567890", "-123456789012345678901234567890"),
        ("0.00000000000000000001", "1/100000000000000000000"),
    ];
    for (text, shown) in rows {
        assert_eq!(text.parse::<Rational>().map(|value| value.to_string()), Ok(shown.into()), "{text}");
    }
    let ten = Rational::from(Integer::from(10).pow(400));
    assert_eq!("1e400".parse(), Ok(ten.clone()));
    assert_eq!("1e-400".parse(), Ok(ten.recip().unwrap()));
}

#[test]
fn what_is_no_number_is_refused_by_kind() {
    let rows = [
        ("", Empty),
        ("  ", Empty),
        ("-", Word),
        (".", Word),
        ("-.", Word),
        ("e5", Word),
        ("1e", Word),
        ("1e+", Word),
        ("1e5.0", Word),
        ("1.2.3", Word),
        ("--1", Word),
        ("+-1", Word),
        ("1 2", Word),
        (" 1", Word),
        ("1_000", Word),
        ("0x10", Word),
        ("1,5", Word),
        ("\u{0661}", Word),
        ("abc", Word),
        ("infinite", Word),
        ("/", Word),
        ("1/", Word),
        ("/2", Word),
        ("1/2/3", Word),
        ("1.5/2", Word),
        ("1/2e1", Word),
        ("nan", NotFinite),
        ("-NaN", NotFinite),
        ("nan(0x1)", NotFinite),
        ("inf", NotFinite),
        ("+Infinity", NotFinite),
        ("1/0", ZeroDenominator),
        ("0/-0", ZeroDenominator),
        ("1e401", ExponentTooLarge),
        ("1e-401", ExponentTooLarge),
        ("0e999", ExponentTooLarge),
        ("1e99999999999999999999999999", ExponentTooLarge),
    ];
    for (text, kind) in rows {
        let error = text.parse::<Rational>().expect_err(text);
        assert_eq!((error.kind, error.token.as_str()), (kind, text), "{text:?}");
        assert!(!error.to_string().is_empty());
    }
    for (text, kind) in [("1.5", Word), ("1/2", Word), ("", Empty), ("nan", NotFinite), ("1e2", Word)] {
        assert_eq!(text.parse::<Integer>().expect_err(text).kind, kind, "{text:?}");
    }
}

#[test]
fn the_number_of_digits_is_limited() {
    let nines = |count: u32| "9".repeat(count as usize);
    let (most, more) = (nines(MAX_DIGITS), nines(MAX_DIGITS + 1));
    let half = nines(MAX_DIGITS / 2);
    let all_nines = Integer::from(10).pow(MAX_DIGITS) - Integer::ONE;
    assert_eq!(most.parse::<Integer>(), Ok(all_nines.clone()));
    assert_eq!(format!("-{most}").parse::<Rational>(), Ok(-Rational::from(&all_nines)));
    let power = Integer::from(10).pow(MAX_DIGITS / 2);
    assert_eq!(format!("{half}.{half}").parse(), Ok(Rational::new(all_nines.clone(), power).unwrap()));
    assert_eq!(format!("{most}/-{most}").parse::<Rational>(), Ok(-Rational::ONE));
    let long_exponent = format!("{most}e-{}400", "0".repeat(MAX_DIGITS as usize));
    assert_eq!(long_exponent.parse(), Ok(Rational::new(all_nines, Integer::from(10).pow(400)).unwrap()));

    for text in [
        more.clone(),
        format!("+{more}"),
        format!("0{most}"),
        format!("{half}.{half}0"),
        format!(".{more}"),
        format!("{more}e5"),
        format!("{more}/1"),
        format!("1/-{more}"),
        format!("{most}/{}", "0".repeat(MAX_DIGITS as usize + 1)),
    ] {
        let error = text.parse::<Rational>().unwrap_err();
        assert_eq!((error.kind, error.token.len()), (TooManyDigits, 43), "{}", error.token);
        assert!(error.to_string().contains("5000"), "{error}");
    }
    assert_eq!(more.parse::<Integer>().unwrap_err().kind, TooManyDigits);
    // What is no number at all is said first.
    assert_eq!(format!("{more}x").parse::<Rational>().unwrap_err().kind, Word);
}

#[test]
fn errors_keep_a_short_token() {
    let error = "x".repeat(1000).parse::<Rational>().unwrap_err();
    assert_eq!(error.token.len(), 43);
    assert_eq!("1/0".parse::<Rational>().unwrap_err().to_string(), "`1/0` has a zero denominator");
    for text in ["1e401", "1e-401"] {
        let message =
            format!("the exponent of `{text}` is too large in magnitude; the largest allowed is 400");
        assert_eq!(text.parse::<Rational>().unwrap_err().to_string(), message);
    }
}
