//! The forms of a file: the same block, the same answers, and mistakes at their places in the file.

use crate::support::{LREAL, answers, block, said};
use portable::{Literal, RealKind};
use st::{Dialect, Signal};

/// The text itself.
pub const PLAIN: &str = "(* probe.st *)
FUNCTION_BLOCK probe
VAR_INPUT
    x : LREAL := 1.0; (* the input; start 1.0 *)
    Enable : BOOL := TRUE;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    n : UDINT;
END_VAR
IF Enable AND (x < 10.0) THEN
    n := n + 1;
    y := (y + x) * (0.5 (* share *));
ELSE
    y := UDINT_TO_LREAL(n);
END_IF;
END_FUNCTION_BLOCK
";

/// A `.TcPOU`.
pub const TWINCAT: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1">
  <POU Name="probe" Id="{4e1a5b9c-0000-4000-8000-000000000000}" SpecialFunc="None">
    <Declaration><![CDATA[{attribute 'qualified_only'}
FUNCTION_BLOCK probe
VAR_INPUT
    x : LREAL := 1.0; // the input
    Enable : BOOL := TRUE;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    n : UDINT;
END_VAR
VAR CONSTANT
    share : LREAL := 0.5;
    limit_of_x : LREAL := 5.0 * 2.0;
END_VAR]]></Declaration>
    <Implementation>
      <ST><![CDATA[IF Enable AND F_axgen_in_range_LREAL(value := x, largest := limit_of_x) AND (x < 10.0) THEN
    n := n + 1;
    y := (y + x) * share;
ELSE
    y := UDINT_TO_LREAL(n);
END_IF;]]></ST>
    </Implementation>
  </POU>
</TcPlcObject>
"#;

/// PLCopen XML.
pub const CODESYS: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0200">
  <fileHeader companyName="" productName="axgen" productVersion="0.1.0" creationDateTime="2000-01-01T00:00:00" />
  <types>
    <dataTypes />
    <pous>
      <pou name="F_axgen_in_range_LREAL" pouType="function">
        <interface><returnType><BOOL /></returnType></interface>
        <body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">not read</xhtml></ST></body>
      </pou>
      <pou name="probe" pouType="functionBlock">
        <interface>
          <inputVars>
            <variable name="x">
              <type><LREAL /></type>
              <initialValue><simpleValue value="1.0" /></initialValue>
              <documentation><xhtml xmlns="http://www.w3.org/1999/xhtml">the input</xhtml></documentation>
            </variable>
            <variable name="Enable">
              <type><BOOL /></type>
              <initialValue><simpleValue value="TRUE" /></initialValue>
            </variable>
          </inputVars>
          <outputVars>
            <variable name="y"><type><LREAL /></type></variable>
          </outputVars>
          <localVars>
            <variable name="n"><type><UDINT /></type></variable>
          </localVars>
          <localVars constant="true">
            <variable name="share">
              <type><LREAL /></type>
              <initialValue><simpleValue value="0.5" /></initialValue>
            </variable>
            <variable name="limit_of_x">
              <type><LREAL /></type>
              <initialValue><simpleValue value="10.0" /></initialValue>
            </variable>
          </localVars>
        </interface>
        <body>
          <ST>
            <xhtml xmlns="http://www.w3.org/1999/xhtml">IF Enable AND F_axgen_in_range_LREAL(largest := limit_of_x, value := x) AND (x &lt; 10.0) THEN
    n := n + 1;
    y := (y + x) * share;
ELSE
    y := UDINT_TO_LREAL(n);
END_IF;</xhtml>
          </ST>
        </body>
      </pou>
    </pous>
  </types>
  <instances><configurations /></instances>
</project>
"#;

/// An external source of SCL.
pub const SCL: &str = "(* probe.scl *)
FUNCTION_BLOCK \"probe\"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR_INPUT
    x : LREAL := 1.0; (* the input *)
    Enable : BOOL := TRUE;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    n : UDINT;
END_VAR
VAR_TEMP
    sum : LREAL;
END_VAR
VAR CONSTANT
    share : LREAL := 0.5;
    limit_of_x : LREAL := 10.0;
END_VAR
BEGIN
IF #Enable AND (#x < #limit_of_x) THEN
    #n := #n + 1;
    #sum := #y + #x;
    #y := #sum * #share;
ELSE
    #y := UDINT_TO_LREAL(#n);
END_IF;
END_FUNCTION_BLOCK
";

/// What the block answers to some inputs.
pub fn found(dialect: Dialect, text: &str, set: &[(&str, bool)]) -> Vec<Literal> {
    let block = block(dialect, text, "probe", RealKind::F64);
    let inputs = [1.0, 4.0, f64::NAN, 3.0, 10.0, f64::INFINITY, -10.0];
    answers(&block, &[("x", LREAL)], &inputs.map(|x| vec![Literal::F64(x)]), &[("y", LREAL)], set).concat()
}

#[test]
fn the_forms_answer_alike() {
    let expected = [0.5, 2.25, 2.0, 2.5, 3.0, 3.0, -3.5].map(Literal::F64);
    assert_eq!(found(Dialect::Plain, PLAIN, &[("ENABLE", true)]), expected);
    assert_eq!(found(Dialect::TwinCat, TWINCAT, &[("Enable", true)]), expected);
    assert_eq!(found(Dialect::Codesys, CODESYS, &[]), expected);
    assert_eq!(found(Dialect::Scl, SCL, &[]), expected);
    assert_eq!(found(Dialect::TwinCat, &format!("\u{feff}{TWINCAT}"), &[]), expected);
    assert_eq!(found(Dialect::TwinCat, &TWINCAT.replace('\n', "\r\n"), &[]), expected);
}

#[test]
fn only_the_tools_honour_initial_values() {
    let zero = [0.0; 7].map(Literal::F64);
    assert_eq!(found(Dialect::Plain, PLAIN, &[]), zero);
    assert_eq!(found(Dialect::TwinCat, TWINCAT, &[("Enable", false)]), zero);
    assert_eq!(found(Dialect::Scl, SCL, &[("Enable", false)]), zero);
}

#[test]
fn mistakes_have_their_places_in_the_file() {
    let said = |dialect, text: &str| said(dialect, text, "probe", RealKind::F64);
    let text = TWINCAT.replace("n := n + 1;", "n := n XOR 2;").replace("5.0 * 2.0", "1E1");
    assert_eq!(
        said(Dialect::TwinCat, &text),
        ["18:27: found `1E1`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`", "22:12: found `XOR`; write `<>`",]
    );
    let text = CODESYS
        .replace("n := n + 1;", "n := n XOR 2;")
        .replace("\"10.0\"", "\"1E1\"")
        .replace("(x &lt;", "(z &lt; 1 AND x &gt;");
    assert_eq!(
        said(Dialect::Codesys, &text),
        [
            "37:15: found `1E1`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`",
            "43:134: found `z`, which is not declared; write a declared variable",
            "44:12: found `XOR`; write `<>`",
        ]
    );
}

#[test]
fn what_the_forms_may_not_hold() {
    let said = |dialect, text: &str, replaced: &str, by: &str| {
        assert!(text.contains(replaced), "{replaced}");
        said(dialect, &text.replacen(replaced, by, 1), "probe", RealKind::F64)
    };
    let rows = [
        (
            Dialect::TwinCat,
            "TcPlcObject",
            "TcObject",
            "29:1: found XML that is broken (expected 'TcObject' tag, not 'TcPlcObject' at 29:1); write well-formed XML",
        ),
        (
            Dialect::TwinCat,
            "</TcPlcObject>",
            "",
            "1:1: found XML that is broken (the root node was opened but never closed); write well-formed XML",
        ),
        (
            Dialect::TwinCat,
            "<POU Name=\"probe\"",
            "<POU Name=\"other\"",
            "5:16: found the block `probe` in the file of `other`; write one name in both places",
        ),
        (Dialect::TwinCat, " Name=\"probe\"", "", "3:3: found a `<POU>` without `Name`; write `Name`"),
        (
            Dialect::TwinCat,
            "POU",
            "ITF",
            "28:3: found XML that is broken (expected 'ITF' tag, not 'POU' at 28:3); write well-formed XML",
        ),
        (
            Dialect::TwinCat,
            "Declaration>",
            "Decl>",
            "19:11: found XML that is broken (expected 'Decl' tag, not 'Declaration' at 19:11); write well-formed XML",
        ),
        (
            Dialect::TwinCat,
            "<ST>",
            "<LD>",
            "26:11: found XML that is broken (expected 'LD' tag, not 'ST' at 26:11); write well-formed XML",
        ),
        (
            Dialect::TwinCat,
            "    </Implementation>",
            "    </Implementation><Method Name=\"run\" />",
            "27:22: found `<Method>`; write one body",
        ),
        (
            Dialect::TwinCat,
            "{attribute 'qualified_only'}",
            "{warning 'old'}",
            "4:27: found a pragma; write `{attribute ...}`, or a comment",
        ),
        (
            Dialect::TwinCat,
            "END_VAR]]>",
            "END_VAR\ny := x;]]>",
            "20:1: found a statement in the declaration; write the statement in the body",
        ),
        (
            Dialect::TwinCat,
            "<ST><![CDATA[",
            "<ST><![CDATA[VAR k : BOOL; END_VAR\n",
            "21:20: found a `VAR` block in the body; write the `VAR` block in the declaration",
        ),
        (
            Dialect::TwinCat,
            "share : LREAL := 0.5",
            "share : LREAL",
            "17:5: found a constant without a value; write `:=` and its value",
        ),
        (
            Dialect::TwinCat,
            "n := n + 1;",
            "share := 1.0;",
            "22:5: found the constant `share` left of `:=`; write a variable of its own",
        ),
        (
            Dialect::TwinCat,
            "value := x, largest := limit_of_x",
            "x, limit_of_x",
            "21:57: found the argument `x`; write `value := x, largest := y`",
        ),
        (
            Dialect::TwinCat,
            "value := x, largest := limit_of_x",
            "value := x",
            "21:34: found `F_axgen_in_range_LREAL(value := x)`; write `value := x, largest := y` in the parentheses",
        ),
        (
            Dialect::TwinCat,
            "value := x, largest := limit_of_x",
            "value := x, largest => limit_of_x",
            "21:69: found the argument `largest => limit_of_x`; write `value := x, largest := y`",
        ),
        (
            Dialect::TwinCat,
            "value := x, largest := limit_of_x",
            "value := x, largest := n",
            "21:80: found a UDINT where a LREAL belongs; write a LREAL",
        ),
        (
            Dialect::TwinCat,
            "in_range_LREAL",
            "in_range_REAL",
            "21:34: found a call of `F_axgen_in_range_REAL`; write what it computes, in operators",
        ),
        (
            Dialect::Codesys,
            "tc6_0200",
            "tc6_0201",
            "2:1: found `<project>`; write `<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\">`",
        ),
        (
            Dialect::Codesys,
            "pouType=\"functionBlock\"",
            "pouType=\"program\"",
            "11:7: found a `<pou>` of another type; write `pouType=\"functionBlock\"`",
        ),
        (
            Dialect::Codesys,
            "localVars>",
            "tempVars>",
            "29:11: found XML that is broken (expected 'tempVars' tag, not 'localVars' at 29:11); write well-formed XML",
        ),
        (Dialect::Codesys, "constant=\"true\"", "retain=\"true\"", "30:11: found `RETAIN`; write the block without it"),
        (
            Dialect::Codesys,
            "<UDINT />",
            "<derived name=\"ST_x\" />",
            "28:13: found the type `ST_x`; write `LREAL`, `BOOL`, `DINT` or `UDINT`",
        ),
        (
            Dialect::Codesys,
            "name=\"n\"",
            "name=\"n : BOOL; m\"",
            "28:13: found `<variable>` without a name or a type; write a word",
        ),
        (
            Dialect::Codesys,
            "name=\"n\"",
            "name=\"n\" address=\"%MD1\"",
            "28:13: found `address`; write a variable without an address",
        ),
        (
            Dialect::Codesys,
            "value=\"0.5\"",
            "value=\"0.5; z : BOOL\"",
            "33:15: found this initial value; write `<simpleValue value=\"...\"/>` with a literal",
        ),
        (
            Dialect::Codesys,
            "&lt;",
            "&less;",
            "43:136: found XML that is broken (unknown entity reference 'less' at 43:136); write well-formed XML",
        ),
        (Dialect::Codesys, "n := n + 1;", "n := n + 1; // count", "44:17: found `//`; write `(* *)`"),
        (
            Dialect::Codesys,
            "name=\"probe\"",
            "name=\"other\"",
            "11:7: found no block `probe`; write `FUNCTION_BLOCK probe`",
        ),
    ];
    for (dialect, replaced, by, expected) in rows {
        let text = if dialect == Dialect::TwinCat { TWINCAT } else { CODESYS };
        assert_eq!(said(dialect, text, replaced, by), [expected], "{replaced} -> {by}");
    }
}

#[test]
fn an_instance_asks_for_signals_that_are_there() {
    let block = block(Dialect::Plain, PLAIN, "probe", RealKind::F64);
    let start = |inputs: &[Signal<'_>], outputs: &[Signal<'_>], set: &[(&str, bool)]| {
        let mistakes = block.start(inputs, outputs, set).err().unwrap_or_default();
        mistakes.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(start(&[("X", LREAL)], &[("Y", LREAL)], &[("enable", true)]), [""; 0]);
    assert_eq!(
        start(&[("x", Literal::U32(0)), ("y", LREAL)], &[("x", LREAL)], &[("x", true)]),
        [
            "2:16: found no `x : UDINT` in `VAR_INPUT`; write its declaration",
            "2:16: found no `y : LREAL` in `VAR_INPUT`; write its declaration",
            "2:16: found no `x : LREAL` in `VAR_OUTPUT`; write its declaration",
            "2:16: found no `x : BOOL` in `VAR_INPUT`; write its declaration",
        ]
    );
    let said = start(&[("x", Literal::F32(0.0))], &[], &[]);
    assert_eq!(said, ["2:16: found no `x : REAL` in `VAR_INPUT`; write its declaration"]);
}
