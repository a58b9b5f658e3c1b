//! Refused: instances of other blocks in SCL.

use super::gain;
use crate::support::said_with;
use portable::RealKind;
use st::Dialect;

const SCL: &str = "FUNCTION_BLOCK \"FB_probe\"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR_INPUT
    x : LREAL;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    g : \"Gain\";
END_VAR
VAR_TEMP
    t : DINT;
END_VAR
BEGIN
#t := 1;
#g(x := #x, n := #t);
#y := #g.y;
END_FUNCTION_BLOCK
";

#[test]
fn in_scl() {
    let check = |from: &str, to: &str| {
        assert!(SCL.contains(from), "{from}");
        let text = SCL.replacen(from, to, 1);
        said_with(Dialect::Scl, &text, "FB_probe", RealKind::F64, &[gain(RealKind::F64)]).join("; ")
    };
    for (from, to, expected) in [
        ("BEGIN", "BEGIN", ""),
        ("\"Gain\"", "Gain", "11:9: found `Gain`; write `\"Gain\"`"),
        ("\"Gain\"", "\"BOOL\"", "11:9: found `\"BOOL\"`; write `BOOL`"),
        ("#g(", "g(", "18:1: found `g`; write `#g`"),
        ("(x := #x", "(#x := #x", "18:4: found `#x`; write `x`"),
        (", n := #t", ", #n := #t", "18:13: found `#n`; write `n`"),
        ("(x := #x", "(x := x", "18:9: found `x`; write `#x`"),
        ("(x := #x", "(y => #y", "18:4: found `y =>  y`; write `input := value`, and an output after the call"),
        ("#g.y", "g.y", "19:7: found `g.y`; write `#g.y`"),
        (
            "#g.y",
            "#g.#y",
            "19:8: found an output away from its instance; write the instance, `.` and the output without blanks",
        ),
        ("#g.y", "#g.x", "19:10: found `x`, which is not an output of `gain`; write one of its outputs"),
        ("#t := 1;\n", "", "17:19: found `t`, which has no value here on some way; write an assignment before it"),
        ("x := #x", "x := 1.0", ""),
        (
            "x := #x",
            "x := #x * 1.0",
            "18:14: found `1.0` in an expression; write a LREAL variable that was assigned it",
        ),
        (
            "VAR\n    g : \"Gain\";\nEND_VAR\nVAR_TEMP\n",
            "VAR_TEMP\n    g : \"Gain\";\n",
            "11:10: found an instance that is not a variable of `VAR`; write the instance in `VAR`",
        ),
    ] {
        assert_eq!(check(from, to), expected, "{from} -> {to}");
    }
}
