//! A program with its blocks: structures, `VAR_IN_OUT`, process data, variables of the runtime; and what is refused there.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use crate::support::said;
use portable::{Literal, RealKind};
use st::{Block, Dialect, Mistake, Program};

fn dut(name: &str, fields: &str) -> String {
    format!(
        "<TcPlcObject><DUT Name=\"{name}\"><Declaration><![CDATA[TYPE {name} :\nSTRUCT\n{fields}\nEND_STRUCT\nEND_TYPE\n]]></Declaration></DUT>\
         </TcPlcObject>"
    )
}

fn gvl(text: &str) -> String {
    format!("<TcPlcObject><GVL Name=\"G\"><Declaration><![CDATA[{text}]]></Declaration></GVL></TcPlcObject>")
}

fn pou(name: &str, declaration: &str, body: &str) -> String {
    format!(
        "<TcPlcObject><POU Name=\"{name}\"><Declaration><![CDATA[{declaration}]]></Declaration><Implementation><ST><![CDATA[\n{body}]]></ST>\
         </Implementation></POU></TcPlcObject>"
    )
}

const OUTER: &str = "    inside : Inside;\n    n : DINT;";
const GLOBALS: &str = include_str!("forms/globals.st");
const BLOCK: &str = "FUNCTION_BLOCK FB_step\nVAR_IN_OUT\n    Axis : Outer;\nEND_VAR\nVAR_INPUT\n    width : DINT;\nEND_VAR\nVAR_OUTPUT\n    \
                     seen : DINT;\nEND_VAR\n";
const STEP: &str = "seen := Axis.n;\nAxis.n := Axis.n + width;\nAxis.inside.x := DINT_TO_LREAL(Axis.n);";
const MAIN: &str =
    "// the program\nPROGRAM MAIN\nVAR\n    a : Outer;\n    b : Outer;\n    step_one : FB_step;\nEND_VAR\n";
const BODY: &str = "step_one(Axis := a, width := G.count);\nstep_one(Axis := b, width := UINT_TO_DINT(G.status));\nG.offset := \
                    DINT_TO_INT(step_one.seen);\nb.inside.x := G.scale * b.inside.x;\nb.n := b.n + a.n;";

/// What was read before the program.
fn start() -> Program {
    let mut program = Program::new(RealKind::F64);
    program.structure(&dut("Inside", "    x : LREAL;")).unwrap();
    program.structure(&dut("Outer", OUTER)).unwrap();
    program.runtime("_Info[HERE()].Cycle");
    program.globals(&gvl(GLOBALS)).unwrap();
    program.block(&pou("FB_step", BLOCK, STEP), "FB_step").unwrap();
    program
}

fn all(read: Result<Block, Vec<Mistake>>) -> String {
    read.err().unwrap_or_default().iter().map(Mistake::to_string).collect::<Vec<_>>().join("; ")
}

#[test]
fn what_a_caller_gives_is_read_and_written() {
    let block = start().read(&pou("MAIN", MAIN, BODY), "MAIN").unwrap();
    let mut run = block.start(&[], &[], &[]).unwrap();
    assert!(run.set("G.status", Literal::U32(7)) && run.set("B.n", Literal::I32(100)));
    run.cycle(&[], &mut Vec::new());
    let found = ["a.n", "a.inside.x", "b.n", "b.inside.x", "G.offset"].map(|path| run.get(path).unwrap());
    // The second call saw what stood in b, and left a alone.
    let expected = [Literal::I32(5), Literal::F64(5.0), Literal::I32(112), Literal::F64(267.5), Literal::I32(100)];
    assert_eq!(found, expected);
    run.cycle(&[], &mut Vec::new());
    assert_eq!(["a.n", "b.n"].map(|path| run.get(path).unwrap()), [Literal::I32(10), Literal::I32(129)]);
    assert!(!run.set("b.n", Literal::U32(1)) && !run.set("none", Literal::U32(1)));
    assert_eq!(run.get("b"), None);
}

#[test]
fn a_part_of_a_structure_starts_with_its_value() {
    let mut program = start();
    program.structure(&dut("Started", "    n : DINT := 5;\n    x : LREAL := -2.5;")).unwrap();
    let main = "PROGRAM MAIN\nVAR\n    s : Started;\n    n : DINT;\nEND_VAR\n";
    let block = program.read(&pou("MAIN", main, "n := s.n;"), "MAIN").unwrap();
    let run = block.start(&[], &[], &[]).unwrap();
    assert_eq!(["s.n", "s.x"].map(|path| run.get(path).unwrap()), [Literal::I32(5), Literal::F64(-2.5)]);
}

/// A structure is a value in a program: a variable of it, an output of an instance.
#[test]
fn a_structure_is_assigned_whole() {
    let mut program = start();
    let declaration =
        "FUNCTION_BLOCK FB_pass\nVAR_INPUT\n    given : Outer;\nEND_VAR\nVAR_OUTPUT\n    made : Outer;\nEND_VAR\n";
    program.block(&pou("FB_pass", declaration, "made := given;\nmade.n := made.n + 1;"), "FB_pass").unwrap();
    let main = "PROGRAM MAIN\nVAR\n    a : Outer;\n    b : Outer;\n    one : FB_pass;\n    two : FB_pass;\nEND_VAR\n";
    let block =
        program.read(&pou("MAIN", main, "one(given := a);\ntwo(given := one.made);\nb := two.made;"), "MAIN").unwrap();
    let mut run = block.start(&[], &[], &[]).unwrap();
    assert!(run.set("a.n", Literal::I32(7)) && run.set("a.inside.x", Literal::F64(2.5)));
    run.cycle(&[], &mut Vec::new());
    let found = ["a.n", "a.inside.x", "b.n", "b.inside.x"].map(|path| run.get(path).unwrap());
    assert_eq!(found, [Literal::I32(7), Literal::F64(2.5), Literal::I32(9), Literal::F64(2.5)]);
    let read = program.read(&pou("FB_pass", declaration, "given := made;"), "FB_pass");
    assert_eq!(all(read), "9:1: found the input `given` left of `:=`; write a variable of its own");
}

#[test]
fn an_int_holds_what_fits_and_nothing_by_chance() {
    let main = "PROGRAM MAIN\nVAR\n    n : DINT;\nEND_VAR\n";
    let block = start().read(&pou("MAIN", main, "G.offset := DINT_TO_INT(n);"), "MAIN").unwrap();
    let mut run = block.start(&[], &[], &[]).unwrap();
    for (given, found) in [(32767, 32767), (-32768, -32768), (32768, 0x5555), (-32769, 0x5555)] {
        assert!(run.set("n", Literal::I32(given)));
        run.cycle(&[], &mut Vec::new());
        assert_eq!(run.get("G.offset"), Some(Literal::I32(found)), "{given}");
    }
}

#[test]
fn a_variable_of_the_runtime_is_read() {
    let main = "PROGRAM MAIN\nVAR\n    ns : UDINT;\nEND_VAR\n";
    let block = start().read(&pou("MAIN", main, "ns := 100 * _Info[HERE()].Cycle;"), "MAIN").unwrap();
    let mut run = block.start(&[], &[], &[]).unwrap();
    assert!(run.set("_Info[HERE()].Cycle", Literal::U32(10_000)));
    run.cycle(&[], &mut Vec::new());
    assert_eq!(run.get("ns"), Some(Literal::U32(1_000_000)));
}

/// The mistakes of a body.
pub fn refused(body: &str) -> Vec<String> {
    let mistakes = start().read(&pou("MAIN", MAIN, body), "MAIN").err().unwrap_or_default();
    mistakes.iter().map(Mistake::to_string).collect()
}

/// Only the program sees what is global: a block that used it would have two names for what its caller gives.
#[test]
fn a_block_sees_no_global_variable() {
    let declaration = "FUNCTION_BLOCK FB_other\nVAR\n    n : DINT;\nEND_VAR\n";
    let read = start().read(&pou("FB_other", declaration, "n := G.count;"), "FB_other");
    assert_eq!(all(read), "6:6: found `G.count`; write a variable, a number or an operation on them");
}

#[test]
fn declarations_that_are_refused() {
    let mut program = start();
    let mistakes =
        |read: Result<(), Vec<Mistake>>| all(read.map(|()| start().read(&pou("MAIN", MAIN, BODY), "MAIN").unwrap()));
    let said = mistakes(program.structure(&dut("Bad", "    s : STRING;\n    t : Later;")));
    let instead = "write a type of a variable, or a structure of a file before this one";
    assert_eq!(said, format!("3:9: found the type `STRING`; {instead}; 4:9: found the type `Later`; {instead}"));
    let said = mistakes(program.globals(&gvl("VAR_GLOBAL\n    s : FB_step;\nEND_VAR\n")));
    assert_eq!(said, "2:9: found an instance that is not a variable of `VAR`; write the instance in `VAR`");
    let said = mistakes(program.globals(&gvl("VAR_GLOBAL\n    n AT %MD4 : DINT;\nEND_VAR\n")));
    assert_eq!(said, "2:10: found `AT`; write a variable without an address");
    let said = mistakes(program.globals(&dut("G", OUTER)));
    assert_eq!(said, "1:1: found no `<GVL Name=...><Declaration>`; write the file of one object");
    for (declaration, expected) in [
        (
            "VAR_IN_OUT\n    n : DINT;\nEND_VAR\n",
            "found `VAR_IN_OUT` of `DINT`; write a structure, or an input and an output",
        ),
        (
            "VAR CONSTANT\n    s : Outer;\nEND_VAR\n",
            "found a structure that is not a variable; write the structure in `VAR` or `VAR_IN_OUT`",
        ),
        (
            "VAR\n    s : Outer := 5;\nEND_VAR\n",
            "found an initial value of a structure; write assignments to its parts",
        ),
        ("VAR\n    s : Outer;\n    S : DINT;\nEND_VAR\n", "found `S`, which is declared already; write another name"),
    ] {
        let text = format!("FUNCTION_BLOCK FB_bad\nVAR_OUTPUT\n    y : DINT;\nEND_VAR\n{declaration}");
        let said = all(program.read(&pou("FB_bad", &text, "y := 1;"), "FB_bad"));
        assert!(said.ends_with(expected), "{declaration}: {said}");
    }
}

/// What is emitted for every compiler has none of it.
#[test]
fn an_emitted_block_is_read_as_strictly_as_ever() {
    let read = |declaration: &str, body: &str| {
        said(
            Dialect::TwinCat,
            &pou("FB_x", &format!("FUNCTION_BLOCK FB_x\n{declaration}"), body),
            "FB_x",
            RealKind::F64,
        )
    };
    for (declaration, body) in [
        ("VAR_IN_OUT\n    n : DINT;\nEND_VAR\nVAR\n    k : DINT;\nEND_VAR\n", "k := 1;"),
        ("VAR\n    n : INT;\n    k : DINT;\nEND_VAR\n", "k := 1;"),
        ("VAR\n    n AT %Q* : DINT;\nEND_VAR\n", "n := 1;"),
        ("VAR\n    k : DINT;\nEND_VAR\n", "k := UINT_TO_DINT(k);"),
        ("VAR\n    override : DINT;\nEND_VAR\n", "override := 1;"),
        ("VAR\n    k : DINT;\nEND_VAR\n", "k := G.count;"),
        ("VAR\n    k : Outer;\n    n : Outer;\nEND_VAR\n", "k := n;"),
    ] {
        assert!(!read(declaration, body).is_empty(), "{declaration}{body}");
    }
    let program = pou("MAIN", "PROGRAM MAIN\nVAR\n    k : DINT;\nEND_VAR\n", "k := 1;");
    assert!(!said(Dialect::TwinCat, &program, "MAIN", RealKind::F64).is_empty());
}
