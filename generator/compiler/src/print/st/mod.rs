//! The description of Structured Text and its dialects for the printer. There are more parentheses than the standard
//! requires: implementations interpret `NOT`, signs and mixed operators differently.

mod literal;

pub use literal::literal;

use super::language::{Appearance, Cases, Form, Language, Level};
use crate::program::values::Signal;
use crate::program::{Constant, Expr, Origin, Program, Type, Var};
use portable::{Intrinsic, Literal, RealKind, Unary};
use std::collections::HashSet;
use std::sync::LazyLock;

/// Any compiler of the standard's second edition. Some ignore every initial value inside an instance without a message:
/// nothing may depend on one, and a block's numbers are in its statements.
pub static PLAIN: Language = Language {
    is_reserved: |name| RESERVED.contains(&*name.to_ascii_lowercase()),
    significant: None,
    kept: &["Enable", "Valid", "Busy", "Error", "ErrorID", "NoticeID"],
    types: ["BOOL", "DINT", "UDINT", "LREAL", "REAL"],
    literal,
    operand: literal::operand,
    symbols: ["+", "-", "*", "/", "MOD", "<", "<=", ">", ">=", "=", "<>", "AND", "OR"],
    logic: [Level::Primary; 2],
    form,
    has_enumerations: false,
    appearances: among_statements,
    before: [""; 5],
    inside: ".",
    has_structs: false,
    has_capitals: false,
    locals: None,
    assign: " :=",
    choice: ["IF ", "ELSIF ", " THEN", "ELSE", "END_IF;"],
    nothing_else: None,
    cases: Cases {
        asks: ["CASE ", " OF"],
        label: ["", ", ", ":"],
        by_name: false,
        others: "ELSE",
        nothing: "",
        ends: [""; 2],
        end: "END_CASE;",
    },
    // Not every compiler has an index of UDINT.
    index: ["[UDINT_TO_DINT(", ")]"],
    call: "", // nothing stands apart
    comment: ["(* ", "   ", " *)"],
};

/// TwinCAT 3 and CODESYS 3.5, one family of runtimes: a comparison with a NaN can stop them, so a function checks a sample's
/// bits before the comparison.
pub static CODESYS: Language = Language { form: form_of_codesys, appearances: declared, ..PLAIN };

/// Siemens SCL for S7-1200 and S7-1500.
pub static SCL: Language = Language { appearances: declared, before: ["#"; 5], ..PLAIN };

/// Keywords of the standard's editions and of its dialects, standard functions and blocks, and words that a block uses.
static RESERVED: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    "
        abstract abs acos action actions adr and andn any any_bit any_date any_int any_num any_real array asin at atan atan2
        begin bitadr bool by byte cal calc calcn case char class concat configuration const constant continue cos ctd
        ctu ctud data_block date date_and_time delete derivative dint div do dt dword else elsif en end_action end_case
        end_class end_configuration end_for end_function end_function_block end_if end_interface end_method
        end_namespace end_program end_property end_repeat end_resource end_step end_struct end_transition end_type
        end_union end_var end_while enable eno eq error errorid busy exit exp expt extends f_edge f_trig false final
        find for from function function_block ge goto gt hysteresis if implements in initial_step insert int integral
        interface internal interval jmp jmpc jmpcn label ld ldate ldn ldt le left len limit lint ln log lower_bound lreal lt
        ltime ltod lword max method mid min mod move mul mux namespace nan ne non_retain not null of on or or_else orn
        override persistent pid pointer priority private program property protected public r r_edge r_trig ramp read_only
        read_write real ref reference region repeat replace resource ret retain retc retcn return right rol ror rs rtc s sel sema shl
        shr sin single sint sizeof sqrt sr st step stn string struct sub super tan task then this time tod time_of_day to
        tof ton tp transition true trunc type udint uint ulint union until upper_bound usint using valid var var_access
        var_config var_external var_global var_in_out var_input var_inst var_output var_stat var_temp vartype wchar
        while with word wstring xor xorn add sub
    "
    .split_ascii_whitespace()
    .collect()
});

/// A sign and a negation always get parentheses: they are `Any`.
fn form(operation: &Expr, _: Type, real: RealKind) -> Option<Form> {
    use Level::{And, Any, Primary, Sum};
    let (level, text, least) = match operation {
        Expr::Unary(Unary::Negate, _) => (Any, "-{0}", [Primary; 2]),
        Expr::Unary(Unary::Not, _) => (Any, "NOT {0}", [Primary; 2]),
        Expr::Intrinsic(intrinsic, _) => match (intrinsic, real) {
            // No sign before a 0.
            (Intrinsic::InRange | Intrinsic::Within, _) if operation.is_about_zero() => {
                (And, "{0} = {1}", [Sum, Primary])
            }
            (Intrinsic::InRange | Intrinsic::Within, _) => (And, "(-{1} <= {0})\nAND ({0} <= {1})", [Sum, Primary]),
            (Intrinsic::FromU32, RealKind::F64) => (Primary, "UDINT_TO_LREAL({0})", [Any; 2]),
            (Intrinsic::FromU32, RealKind::F32) => (Primary, "UDINT_TO_REAL({0})", [Any; 2]),
            (Intrinsic::FromI32, RealKind::F64) => (Primary, "DINT_TO_LREAL({0})", [Any; 2]),
            (Intrinsic::FromI32, RealKind::F32) => (Primary, "DINT_TO_REAL({0})", [Any; 2]),
            (Intrinsic::Narrow, _) => (Primary, "LREAL_TO_REAL({0})", [Any; 2]),
            (Intrinsic::Unsigned, _) => (Primary, "DINT_TO_UDINT({0})", [Any; 2]),
            // The only conversion of a real on which implementations agree.
            (Intrinsic::Truncate, _) => (Primary, "TRUNC({0})", [Any; 2]),
            (Intrinsic::Nearest, _) => panic!("st: a legalising pass spells out the rounding"),
        },
        _ => return None,
    };
    Some(Form { level, text, least })
}

fn form_of_codesys(operation: &Expr, ty: Type, real: RealKind) -> Option<Form> {
    let Expr::Intrinsic(Intrinsic::InRange, _) = operation else { return form(operation, ty, real) };
    let text = match real {
        RealKind::F64 => "F_axgen_in_range_LREAL(value := {0}, largest := {1})",
        RealKind::F32 => "F_axgen_in_range_REAL(value := {0}, largest := {1})",
    };
    Some(Form { level: Level::And, text, least: [Level::Any; 2] })
}

/// The smallest DINT is not always a valid literal, so a constant must not have this value.
fn declared(program: &Program, _: &[Signal]) -> Vec<Appearance> {
    let appearance = |constant: &Constant| match (constant.origin, constant.value) {
        (Origin::Runtime(_), _) | (_, Literal::I32(i32::MIN)) => Appearance::Inline,
        _ => Appearance::Declared,
    };
    program.constants.iter().map(appearance).collect()
}

/// Digits in an expression are LREAL in every implementation: they must not be combined with a REAL.
fn among_statements(program: &Program, _: &[Signal]) -> Vec<Appearance> {
    let usual = |value| if matches!(value, Literal::F32(_)) { Appearance::Assigned } else { Appearance::Inline };
    let mut appearances: Vec<Appearance> = program.constants.iter().map(|constant| usual(constant.value)).collect();
    // Digits have no own type: an operator or a conversion with integer digits only would have an undefined type.
    let is_digits =
        |operand: &Expr| matches!(operand.known(&program.constants), Some(Literal::I32(_) | Literal::U32(_)));
    let mut assign_alone = |part: &Expr| {
        if part.operands().all(is_digits) {
            for operand in part.operands() {
                if let Expr::Var(Var::Constant(index)) = operand {
                    appearances[*index] = Appearance::Assigned;
                }
            }
        }
    };
    program.step.iter().for_each(|statement| statement.expressions(&mut |expr| expr.parts(&mut assign_alone)));
    appearances
}
