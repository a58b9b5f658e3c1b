//! The numbers that no literal is: -0.0 and the smallest DINT, in each form of a file.

use crate::forms::{CODESYS, PLAIN, SCL, TWINCAT, found};
use crate::support::{answers, block};
use portable::{Literal, RealKind};
use st::Dialect;

/// The forms that have constants, each with `share` as -0.0.
fn with_a_constant() -> [(Dialect, String); 3] {
    let declared = |text: &str| text.replace("share : LREAL := 0.5;", "share : LREAL := -1.0 * 0.0;");
    [
        (Dialect::TwinCat, declared(TWINCAT)),
        (Dialect::Codesys, CODESYS.replace("value=\"0.5\"", "value=\"-1.0 * 0.0\"")),
        (Dialect::Scl, declared(SCL)),
    ]
}

#[test]
fn minus_zero_is_a_product() {
    for (dialect, text) in with_a_constant() {
        assert_eq!(found(dialect, &text, &[])[0], Literal::F64(-0.0), "{dialect:?}");
    }
    let forms =
        [(Dialect::Plain, PLAIN), (Dialect::TwinCat, TWINCAT), (Dialect::Codesys, CODESYS), (Dialect::Scl, SCL)];
    for (dialect, text) in forms {
        let text = text.replace("UDINT_TO_LREAL(n)", "-1.0 * 0.0").replace("UDINT_TO_LREAL(#n)", "-1.0 * 0.0");
        assert_eq!(found(dialect, &text, &[("Enable", true)])[2], Literal::F64(-0.0), "{dialect:?}");
    }
}

#[test]
fn minus_zero_is_a_product_in_a_block_of_real() {
    for (dialect, text) in with_a_constant() {
        let text = text.replace("UDINT_TO_LREAL(n)", "-1.0 * 0.0").replace("UDINT_TO_LREAL(#n)", "-1.0 * 0.0");
        // As REAL no number stands in a condition, and one operation in a statement.
        let text =
            text.replace("10.0)", "limit_of_x)").replace("(y + x) * share", "x * share").replace("LREAL", "REAL");
        let block = block(dialect, &text, "probe", RealKind::F32);
        let start = Literal::F32(0.0);
        let samples = [1.0, f32::NAN].map(|x| vec![Literal::F32(x)]);
        let found = answers(&block, &[("x", start)], &samples, &[("y", start)], &[]).concat();
        assert_eq!(found, [-0.0, -0.0].map(Literal::F32), "{dialect:?}");
    }
}

#[test]
fn the_smallest_dint_is_a_difference() {
    let declared = |text: &str| text.replacen("    n : UDINT;", "    n : UDINT;\n    i : DINT := -2147483647 - 1;", 1);
    let variable = "<variable name=\"i\"><type><DINT /></type><initialValue><simpleValue value=\"-2147483647 - 1\" /></initialValue></variable>";
    for (dialect, text) in [
        (Dialect::TwinCat, declared(TWINCAT)),
        (Dialect::Codesys, CODESYS.replacen("</localVars>", &format!("{variable}</localVars>"), 1)),
        (Dialect::Scl, declared(SCL)),
    ] {
        let text =
            text.replace("UDINT_TO_LREAL(n)", "DINT_TO_LREAL(i)").replace("UDINT_TO_LREAL(#n)", "DINT_TO_LREAL(#i)");
        assert_eq!(found(dialect, &text, &[])[2], Literal::F64(-2_147_483_648.0), "{dialect:?}");
    }
}
