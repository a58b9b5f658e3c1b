//! Real numbers as decimal text that every compiler reads back to the same bits. No suffix, no sign rules of a language.

use portable::Literal;

/// The shortest decimal that reads back to the same bits, with a digit on each side of the point: `0.1`, `1.0e-30`.
pub(super) fn decimal(value: Literal) -> String {
    let mut text = match value {
        Literal::F64(value) if value.is_finite() => format!("{value:?}"),
        Literal::F32(value) if value.is_finite() => format!("{value:?}"),
        other => panic!("number: {other:?} cannot be written"),
    };
    if let Some(exponent) = text.find('e')
        && !text[..exponent].contains('.')
    {
        text.insert_str(exponent, ".0");
    }
    text
}
