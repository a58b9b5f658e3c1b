//! Names and comments, as a printed block has them.

use compiler::print::Printer;
use compiler::print::c::LANGUAGE;
use compiler::print::comment::{harmless, wrapped};
use compiler::program::{Constant, Origin, Program};
use portable::{Literal, RealKind};

#[test]
fn lines_are_broken_at_blanks() {
    assert_eq!(wrapped(&["one two three"], 7, "|"), "one two|three");
    assert_eq!(wrapped(&["a-long-word b"], 3, "|"), "a-long-word|b");
    assert_eq!(wrapped(&[""], 10, "|"), "");
}

#[test]
fn a_comment_cannot_be_ended_from_inside() {
    assert_eq!(harmless("a */ b *) c /* d (* e"), "a * / b * ) c / * d ( * e");
}

#[test]
fn a_name_is_given_once() {
    let constant =
        |path: &str| Constant { path: path.to_owned(), doc: "", value: Literal::U32(0), origin: Origin::Function };
    let program = Program {
        block: "names",
        switch: None,
        usual_first: false,
        fractions: &[],
        set: None,
        made: None,
        is_made_single: false,
        typed: false,
        real: RealKind::F64,
        inputs: Vec::new(),
        outputs: Vec::new(),
        state: Vec::new(),
        rows: Vec::new(),
        constants: ["a[0].b", "float", "A0_B", "float", "a[0].b"].map(constant).into(),
        locals: Vec::new(),
        init: Vec::new(),
        step: Vec::new(),
    };
    assert_eq!(
        Printer::new(&program, &LANGUAGE, "names").names().constants,
        ["a0_b", "float_value", "A0_B_2", "float_2", "a0_b_3"]
    );
}
