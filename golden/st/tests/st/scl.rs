//! What is refused in SCL: a small source for every rule, and that it takes the source without the mistake.

use crate::support::said;
use portable::RealKind;
use st::Dialect;

/// A source with everything that a source may have.
const SOURCE: &str = "(* c *)
FUNCTION_BLOCK \"FB_x\"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR_INPUT
    a : LREAL := 0.0;
    r : LREAL;
    n : UDINT := 0; (* c *)
    i : DINT := -1;
END_VAR
VAR_OUTPUT
    o : LREAL;
    p : LREAL;
END_VAR
VAR
    s : BOOL;
END_VAR
VAR_TEMP
    t : LREAL;
END_VAR
VAR CONSTANT
    c : LREAL := 1.5E-3;
    d : LREAL := -2.0;
END_VAR
BEGIN
IF (#n <> 0) AND NOT #s THEN
    #t := #c * (#a - #c);
ELSIF #i MOD 4 = 2 THEN
    #t := UDINT_TO_LREAL(#n + 1) / #a;
ELSE
    #t := 0.0;
END_IF;
#s := (-#c <= #t) OR #s;
#o := -#t;
#p := #r * #d + UDINT_TO_LREAL(#n);
END_FUNCTION_BLOCK
";

fn check(text: &str) -> String {
    said(Dialect::Scl, text, "FB_x", RealKind::F64).join("; ")
}

#[test]
fn the_source_without_a_mistake_passes() {
    assert_eq!(check(SOURCE), "");
    let two = SOURCE.to_owned() + &SOURCE.replace("FB_x", "FB_y");
    assert_eq!(check(&two), "");
    assert_eq!(check(""), "1:1: found no block `FB_x`; write `FUNCTION_BLOCK FB_x`");
}

/// What is replaced, by what, and the first thing that is reported.
#[rustfmt::skip]
const MISTAKES: &[(&str, &str, &str)] = &[
    // the block
    ("\"FB_x\"", "FB_x",
     "2:16: found `FB_x`; write `\"name\"`"),
    ("\"FB_x\"", "\"FB_x",
     "2:16: found `\"FB_x`; write `\"name\"`"),
    ("\"FB_x\"", "\"FB__x\"",
     "2:17: found the name `FB__x`; write a name without `__` and without `_` at its end"),
    ("'TRUE'", "'FALSE'",
     "3:26: found `'FALSE'`; write `'TRUE'`"),
    ("{ S7_Optimized_Access := 'TRUE' }\n", "",
     "3:1: found `VERSION`; write `{`"),
    ("VERSION : 0.1", "VERSION : 0.2",
     "4:11: found `0.2`; write `0.1`"),
    ("VERSION : 0.1\n", "",
     "4:1: found `VAR_INPUT`; write `VERSION`"),
    ("BEGIN\n", "",
     "25:1: found `IF`; write `BEGIN`"),
    ("END_FUNCTION_BLOCK\n", "",
     "36:1: found the end; write `END_FUNCTION_BLOCK`"),
    ("END_FUNCTION_BLOCK\n", "END_FUNCTION_BLOCK;\n",
     "36:19: found `;`; write `FUNCTION_BLOCK`"),
    // sections
    ("VAR\n    s : BOOL;\nEND_VAR\nVAR_TEMP\n    t : LREAL;\nEND_VAR\n", "VAR_TEMP\n    t : LREAL;\nEND_VAR\nVAR\n    s : BOOL;\nEND_VAR\n",
     "18:1: found `VAR`; write `BEGIN`"),
    ("    s : BOOL;\n", "",
     "15:1: found a `VAR` block that declares nothing; write no such block"),
    ("VAR_TEMP", "VAR_IN_OUT",
     "18:1: found `VAR_IN_OUT`; write `BEGIN`"),
    ("s : BOOL;\nEND_VAR", "s : BOOL;",
     "18:5: found `t`; write declarations, `:=` and `IF`"),
    // declarations
    ("    s : BOOL;", "    s BOOL;",
     "16:5: found `s BOOL;`; write declarations, `:=` and `IF`"),
    ("    s : BOOL;", "    s : BOOL",
     "16:13: found no `;`; write `;`"),
    ("    s : BOOL;", "    s : INT;",
     "16:9: found the type `INT`; write `LREAL`, `BOOL`, `DINT` or `UDINT`"),
    ("    s : BOOL;", "    s : bool;",
     "16:9: found `bool`; write `BOOL`"),
    ("    s : BOOL;", "    A : BOOL;\n    s : BOOL;",
     "16:5: found `A`, which is declared already; write another name"),
    ("    s : BOOL;", "    Limit : BOOL;\n    s : BOOL;",
     "16:5: found the name `Limit`, which some compiler takes for its own; write another name"),
    ("    s : BOOL;", "    udint_to_real : BOOL;\n    s : BOOL;",
     "16:5: found the name `udint_to_real`, which some compiler takes for its own; write another name"),
    ("    s : BOOL;", "    s_ : BOOL;\n    s : BOOL;",
     "16:5: found the name `s_`; write a name without `__` and without `_` at its end"),
    ("    s : BOOL;", "    s : BOOL := 0;",
     "16:17: found the initial value `0`; write a literal of BOOL"),
    ("a : LREAL := 0.0", "a : LREAL := 0",
     "6:18: found the initial value `0`; write a literal of LREAL"),
    ("a : LREAL := 0.0", "a : LREAL := 1.0E+999",
     "6:18: found `1.0E+999`, a magnitude outside 1.18E-38 .. 3.4E38; write a product of numbers inside it"),
    ("d : LREAL := -2.0", "d : LREAL := 3.5E+38",
     "23:18: found `3.5E+38`, a magnitude outside 1.18E-38 .. 3.4E38; write a product of numbers inside it"),
    ("n : UDINT := 0", "n : UDINT := -1",
     "8:18: found the initial value `-1`; write a literal of UDINT"),
    ("n : UDINT := 0", "n : UDINT := 4294967296",
     "8:18: found the initial value `4294967296`; write a literal of UDINT"),
    ("i : DINT := -1", "i : DINT := 2147483648",
     "9:17: found the initial value `2147483648`; write a literal of DINT"),
    ("i : DINT := -1", "i : DINT := 1.0",
     "9:17: found the initial value `1.0`; write a literal of DINT"),
    ("t : LREAL;", "t : LREAL := 0.0;",
     "19:18: found an initial value of a temporary; write an assignment in each cycle"),
    ("c : LREAL := 1.5E-3", "c : LREAL",
     "22:5: found a constant without a value; write `:=` and its value"),
    ("c : LREAL := 1.5E-3", "c : LREAL := 1.5 * 2.0",
     "22:18: found the initial value `1.5 * 2.0`; write a literal of LREAL"),
    ("c : LREAL := 1.5E-3", "c : LREAL := --1.5",
     "22:18: found the initial value `--1.5`; write a literal of LREAL"),
    ("d : LREAL := -2.0", "d : LREAL := -0.0",
     "23:18: found `-0.0`; write `-1.0 * 0.0`"),
    ("i : DINT := -1", "i : DINT := -2147483648",
     "9:17: found the initial value `-2147483648`; write `-2147483647 - 1`"),
    // numbers
    ("1.5E-3", "1.E-3",
     "22:18: found `1.E-3`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"),
    ("1.5E-3", ".5",
     "22:18: found `.5`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"),
    ("1.5E-3", "1.5E3",
     "22:18: found `1.5E3`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"),
    ("1.5E-3", "1.5E-",
     "22:21: found `E-`; write declarations, `:=` and `IF`"),
    ("1.5E-3", "1E-3",
     "22:18: found `1E-3`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"),
    ("1.5E-3", "16#1",
     "22:18: found the initial value `16#1`; write a literal of LREAL"),
    ("1.5E-3", "1_0.0",
     "22:18: found `1_0.0`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"),
    // comments and letters
    ("(* c *)", "(* c",
     "9:5: found `i`; write `FUNCTION_BLOCK`"),
    ("#p :=", "(* c\n#p :=",
     "38:1: found the end; write `END_FUNCTION_BLOCK`"),
    ("(* c *)", "// c\n",
     "1:1: found `/`; write `FUNCTION_BLOCK`"),
    ("(* c *)", "\t",
     "1:1: found `\t`; write `FUNCTION_BLOCK`"),
    ("#o", "\u{e4}",
     "34:1: found \"ä\"; write ASCII"),
    // statements
    ("#s := (-#c", "s := (-#c",
     "33:1: found `s`; write `#s`"),
    ("#o := -#t;", "#o := -t;",
     "34:8: found `t`; write `#t`"),
    ("#o := -#t;", "#o = -#t;",
     "34:2: found `o = - t`; write declarations, `:=` and `IF`"),
    ("#o := -#t;", "#o := -#t",
     "34:10: found no `;`; write `;`"),
    ("#o := -#t;", ";",
     "34:1: found `;` without a statement; write nothing"),
    ("#o := -#t;", "RETURN;",
     "34:1: found `RETURN`; write `IF` around the rest"),
    ("#o := -#t;", "#o := - -#t;",
     "34:7: found two signs before an operand; write one sign, or parentheses"),
    ("#o := -#t;", "#o := ABS(#t);",
     "34:7: found the standard function `ABS`; write `IF`"),
    ("#o := -#t;", "#o := UDINT_TO_LREAL(#i);",
     "34:23: found a DINT where a UDINT belongs; write the conversion from its type"),
    ("#o := -#t;", "#o := (#t;",
     "34:10: found no `)`; write `)`"),
    ("END_IF;", "END_IF",
     "32:7: found no `;` after `END_IF`; write `END_IF;`"),
    ("END_IF;\n", "",
     "34:36: found no `END_IF`; write `END_IF`"),
    (" THEN\n    #t := UDINT", "\n    #t := UDINT",
     "28:1: found `ELSIF  i MOD 4 = 2...`; write declarations, `:=` and `IF`"),
    ("    #t := 0.0;\n", "",
     "30:1: found `ELSE` without a statement; write a statement"),
    // names
    ("#o := -#t;", "#q := -#t;",
     "34:2: found `q`, which is not declared; write a declared variable"),
    ("#o := -#t;", "#o := -#q;",
     "34:9: found `q`, which is not declared; write a declared variable"),
    ("#o := -#t;", "#a := -#t;",
     "34:2: found the input `a` left of `:=`; write a variable of its own"),
    ("#o := -#t;", "#c := -#t;",
     "34:2: found the constant `c` left of `:=`; write a variable of its own"),
    // types
    ("    r : LREAL;", "    r : REAL;",
     "7:9: found the type `REAL`; write `LREAL`, `BOOL`, `DINT` or `UDINT`"),
    ("UDINT_TO_LREAL(#n);", "UDINT_TO_REAL(#n);",
     "35:17: found the standard function `UDINT_TO_REAL`; write a conversion to LREAL, the type of this block"),
    ("#o := -#t;", "#o := #t * 2;",
     "34:12: found the integer `2` where a LREAL belongs; write `2.0`"),
    ("#o := -#t;", "#o := #t * 2.0;",
     "34:12: found `2.0` in an expression; write a LREAL variable that was assigned it"),
    ("#o := -#t;", "#o := 2;",
     "34:7: found the integer `2` where a LREAL belongs; write `2.0`"),
    ("#o := -#t;", "#o := -0.0;",
     "34:7: found `-0.0`; write `-1.0 * 0.0`"),
    ("#o := -#t;", "#o := #t - -1.0 * 0.0;",
     "34:12: found `-1.0` in an expression; write a LREAL variable that was assigned it"),
    ("#o := -#t;", "#s := NOT (#s);",
     "34:7: found `NOT` of an expression, which one compiler translates wrongly; write a BOOL variable that was assigned the condition"),
    ("#o := -#t;", "#o := 2.0 * 3.0;",
     "34:7: found `2.0` in an expression; write a LREAL variable that was assigned it"),
    ("#o := -#t;", "#o := #s;",
     "34:8: found a BOOL for a LREAL; write a LREAL"),
    ("#o := -#t;", "#o := -#s;",
     "34:7: found `-` of BOOL; write a REAL, LREAL or DINT"),
    ("#o := -#t;", "#s := NOT #n;",
     "34:7: found `NOT` of UDINT; write a BOOL"),
    ("#o := -#t;", "#s := #n AND #n;",
     "34:10: found `AND` of UDINT; write BOOLs, or arithmetic"),
    ("#o := -#t;", "#s := #s < #s;",
     "34:10: found `<` of BOOL; write `AND`, `OR`, `NOT`, `=` or `<>`"),
    ("#o := -#t;", "#s := #s + #s;",
     "34:10: found `+` of BOOL; write `AND`, `OR`, `NOT`, `=` or `<>`"),
    ("#o := -#t;", "#s := #n = #i;",
     "34:10: found `=` of UDINT and DINT; write one type on both sides"),
    ("#o := -#t;", "#s := #n = 1.0;",
     "34:12: found `1.0` in an expression; write a LREAL variable that was assigned it"),
    ("#i MOD 4 = 2", "#i / 0 = 1",
     "28:12: found a divisor that is not a positive literal; write an integer literal from 1 on"),
    ("#i MOD 4 = 2", "#i",
     "28:8: found a condition of type DINT; write a BOOL"),
    // temporaries
    ("#a - #c", "#a - #t",
     "27:23: found `t`, which has no value here on some way; write an assignment before it"),
    ("#i MOD 4 = 2", "#t = #a",
     "28:8: found `t`, which has no value here on some way; write an assignment before it"),
    ("ELSE\n    #t := 0.0;\n", "",
     "31:16: found `t`, which has no value here on some way; write an assignment before it"),
    ("    #t := 0.0;\n", "    #o := 0.0;\n",
     "33:16: found `t`, which has no value here on some way; write an assignment before it"),
    ("    #t := #c * (#a - #c);\n", "    #s := TRUE;\n",
     "33:16: found `t`, which has no value here on some way; write an assignment before it"),
    ("IF (#n <> 0)", "#o := #t;\nIF (#n <> 0)",
     "26:8: found `t`, which has no value here on some way; write an assignment before it"),
    ("#n + 1", "#n + 16#1", "29:34: found `1`; write declarations, `:=` and `IF`"),
];

#[test]
fn every_mistake_is_refused_for_its_reason() {
    for (from, to, reason) in MISTAKES {
        assert!(SOURCE.contains(from), "{from}");
        let said = check(&SOURCE.replacen(from, to, 1));
        assert!(said.contains(reason), "`{from}` -> `{to}`: {said}");
    }
}
