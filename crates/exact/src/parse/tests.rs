use super::*;
use crate::{Integer, Rational};
use ParseNumberErrorKind::{Empty, ExponentTooLarge, NotFinite, Word, ZeroDenominator};

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
fn errors_keep_a_short_token() {
    let error = "x".repeat(1000).parse::<Rational>().unwrap_err();
    assert_eq!(error.token.len(), 43);
    assert_eq!("1/0".parse::<Rational>().unwrap_err().to_string(), "`1/0` has a zero denominator");
}
