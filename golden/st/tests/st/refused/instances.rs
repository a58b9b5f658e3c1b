//! Refused: instances of other blocks, and their calls.

use crate::support::{block, said_with};
use portable::RealKind;
use st::{Block, Dialect};

const INNER: &str = "FUNCTION_BLOCK gain
VAR_INPUT
    x : LREAL;
    n : DINT;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    k : LREAL;
END_VAR
k := 2.0;
y := k * x;
END_FUNCTION_BLOCK
";

fn inner(real: RealKind) -> Block {
    let text = if real == RealKind::F32 { INNER.replace("LREAL", "REAL") } else { INNER.to_owned() };
    block(Dialect::Plain, &text, "gain", real)
}

/// What is reported for a body from line 15 on, after the declarations `g : gain`, `h : unheard_of` in line 14.
fn check(body: &str) -> String {
    let text = format!(
        "FUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\n    p : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n\
         END_VAR\nVAR\n    g : gain;\nEND_VAR\n\n{body}\nEND_FUNCTION_BLOCK\n"
    );
    said_with(Dialect::Plain, &text, "probe", RealKind::F64, &[inner(RealKind::F64)]).join("; ")
}

#[test]
fn calls() {
    for (body, expected) in [
        ("g(x := x, n := 1);\ny := g.y;", ""),
        ("g();\ng(n := -1);", ""),
        ("g(x);", "15:3: found an argument without a name; write `input := value`"),
        ("g(x := x, 1);", "15:11: found an argument without a name; write `input := value`"),
        ("g(y => y);", "15:3: found `y => y`; write `input := value`, and an output after the call"),
        ("g(z := x);", "15:3: found `z`, which is not an input of `gain`; write one of its inputs"),
        ("g(y := x);", "15:3: found `y`, which is not an input of `gain`; write one of its inputs"),
        ("g(k := x);", "15:3: found `k`, which is not an input of `gain`; write one of its inputs"),
        ("g(x := x, X := x);", "15:11: found `X` a second time; write each input once"),
        ("g(x := i);", "15:8: found a DINT for a LREAL; write `DINT_TO_LREAL`, or a LREAL"),
        ("g(x := 1);", "15:8: found the integer `1` where a LREAL belongs; write `1.0`"),
        ("g(n := u);", "15:8: found a UDINT for a DINT; write a DINT"),
        ("g(n := x);", "15:8: found a LREAL for a DINT; write a DINT"),
        ("g(n := 1 + 0);", "15:8: found `+` of two integer literals; write its result"),
        ("g(x := z);", "15:8: found `z`, which is not declared; write a declared variable"),
        ("g(n := g);", "15:8: found the instance `g` by itself; write a variable, or one of its outputs"),
        ("g(x := x)", "15:1: found `g(x := x)`; write declarations, `:=` and `IF`"),
        ("g(x := x);;", "15:11: found `;` without a statement; write nothing"),
        ("f(x := x);", "15:1: found a call as a statement; write what it does"),
        ("y(x := x);", "15:1: found a call as a statement; write what it does"),
        ("g.y(x := x);", "15:1: found a call as a statement; write what it does"),
        ("y := g(x := x);", "15:6: found a call of `g` in an expression; write the call as a statement before it"),
    ] {
        assert_eq!(check(body), expected, "{body}");
    }
}

#[test]
fn outputs() {
    for (body, expected) in [
        ("y := g.x;", "15:8: found `x`, which is not an output of `gain`; write one of its outputs"),
        ("y := g.k;", "15:8: found `k`, which is not an output of `gain`; write one of its outputs"),
        ("y := g.z;", "15:8: found `z`, which is not an output of `gain`; write one of its outputs"),
        ("y := g;", "15:6: found the instance `g` by itself; write a variable, or one of its outputs"),
        (
            "y := g . y;",
            "15:6: found an output away from its instance; write the instance, `.` and the output without blanks",
        ),
        ("y := x.y;", "15:6: found `x.y`; write a variable, a number or an operation on them"),
        ("y := g.y.y;", "15:6: found `g.y.y`; write a variable, a number or an operation on them"),
        ("y := g[0].y;", "15:6: found `g[0].y`; write a variable, a number or an operation on them"),
        ("p := g.y > 0.0;", "15:1: found the input `p` left of `:=`; write a variable of its own"),
        ("IF g.y THEN\n    y := x;\nEND_IF;", "15:4: found a condition of type LREAL; write a BOOL"),
        ("g.x := x;", "15:1: found `g.x` left of `:=`; write a variable"),
        ("g.y := x;", "15:1: found `g.y` left of `:=`; write a variable"),
        ("g := x;", "15:1: found the instance `g` by itself; write a variable, or one of its outputs"),
    ] {
        assert_eq!(check(body), expected, "{body}");
    }
}

#[test]
fn declarations() {
    let check = |declared: &str, real: RealKind| {
        let text = format!(
            "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\n{declared}\ny := 1.0;\nEND_FUNCTION_BLOCK\n"
        );
        said_with(Dialect::Plain, &text, "probe", RealKind::F64, &[inner(real)]).join("; ")
    };
    let types = "write `LREAL`, `BOOL`, `DINT` or `UDINT`";
    for (declared, expected) in [
        ("VAR\n    g : GAIN;\nEND_VAR", String::new()),
        (
            "VAR_INPUT\n    g : gain;\nEND_VAR",
            "6:9: found an instance that is not a variable of `VAR`; write the instance in `VAR`".to_owned(),
        ),
        (
            "VAR_OUTPUT\n    g : gain;\nEND_VAR",
            "6:9: found an instance that is not a variable of `VAR`; write the instance in `VAR`".to_owned(),
        ),
        (
            "VAR\n    g : gain := (x := 1.0);\nEND_VAR",
            "6:17: found an initial value of an instance; write arguments of its call".to_owned(),
        ),
        (
            "VAR\n    g : gain;\n    G : LREAL;\nEND_VAR",
            "7:5: found `G`, which is declared already; write another name".to_owned(),
        ),
        ("VAR\n    y : gain;\nEND_VAR", "6:5: found `y`, which is declared already; write another name".to_owned()),
        (
            "VAR\n    g, h : gain;\nEND_VAR",
            "6:8: found a second name in a declaration; write one declaration for each name".to_owned(),
        ),
        (
            "VAR\n    ramp : gain;\nEND_VAR",
            "6:5: found the name `ramp`, which some compiler takes for its own; write another name".to_owned(),
        ),
        ("VAR\n    g : loss;\nEND_VAR", format!("6:9: found the type `loss`; {types}")),
        ("VAR\n    g : ARRAY[0..1] OF gain;\nEND_VAR", format!("6:9: found the type `ARRAY[0..1] OF gain`; {types}")),
    ] {
        assert_eq!(check(declared, RealKind::F64), expected, "{declared}");
    }
    assert_eq!(
        check("VAR\n    g : gain;\nEND_VAR", RealKind::F32),
        "6:9: found `gain`, a block of REAL; write a block of LREAL"
    );
    // What was refused already is not refused again where it is used.
    let text = "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\nVAR\n    g : loss;\nEND_VAR\ng(x := y);\ny := g.y;\nEND_FUNCTION_BLOCK\n";
    let said = said_with(Dialect::Plain, text, "probe", RealKind::F64, &[]).join("; ");
    assert_eq!(said, format!("6:9: found the type `loss`; {types}"));
}

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
        said_with(Dialect::Scl, &text, "FB_probe", RealKind::F64, &[inner(RealKind::F64)]).join("; ")
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
