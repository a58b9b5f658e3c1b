//! What Structured Text is to the printer, and what its dialects do differently inside a block. There are more parentheses
//! than the standard asks for: implementations read `NOT`, signs and mixed operators in more than one way.

mod literal;

pub use literal::literal;

use super::language::{Appearance, Form, Language, Level, Operation, PRIMARY, Piece, Question};
use super::names::Words;
use crate::program::{Expr, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// Any compiler of the standard's second edition. Some drop every initial value inside an instance, silently: nothing may
/// depend on one, and a block's numbers stand in its statements.
pub static PLAIN: Language = Language {
    is_reserved: |name| RESERVED.have(&name.to_ascii_lowercase()),
    kept: &["Enable", "Valid", "Busy", "Error", "ErrorID"],
    ty: type_name,
    literal,
    operand: literal::operand,
    form,
    appearances: among_statements,
    before: [""; 5],
    has_structs: false,
    declaration: None,
    assign: " :=",
    question: Question { first: "IF ", next: "ELSIF ", then: " THEN", otherwise: "ELSE", end: "END_IF;" },
    comment: ["(* ", "   ", " *)"],
};

/// TwinCAT 3 and CODESYS 3.5, one family of runtimes: a comparison with a NaN can stop them, so that [`in_range`] looks at a
/// sample's bits before it is compared.
pub static CODESYS: Language = Language { form: form_of_codesys, appearances: declared, ..PLAIN };

/// Siemens SCL for S7-1200 and S7-1500.
pub static SCL: Language = Language { appearances: declared, before: ["#"; 5], ..PLAIN };

/// Keywords of the standard's editions and of its dialects, standard functions and blocks, and words that a block uses.
static RESERVED: Words = Words::new(
    "
    abstract abs acos action actions adr and any any_bit any_date any_int any_num any_real array asin at atan atan2 begin
    bitadr bool by byte cal calc calcn case char class concat configuration const constant continue cos ctd ctu ctud
    data_block date date_and_time delete derivative dint div do dt dword else elsif en end_action end_case end_class
    end_configuration end_for end_function end_function_block end_if end_interface end_method end_namespace end_program
    end_property end_repeat end_resource end_step end_struct end_transition end_type end_union end_var end_while enable eno eq
    error errorid busy exit exp expt extends f_edge f_trig false final find for from function function_block ge goto gt
    hysteresis if implements in initial_step insert int integral interface internal interval jmp jmpc jmpcn label ldate
    ldt le left len limit lint ln log lower_bound lreal lt ltime ltod lword max method mid min mod move mul mux namespace nan
    ne non_retain not null of on or or_else override persistent pid pointer priority private program property protected
    public r_edge r_trig ramp read_only read_write real ref reference region repeat replace resource ret retain return
    right rol ror rs rtc sel sema shl shr sin single sint sizeof sqrt sr st step string struct sub super tan task then this
    time tod time_of_day to tof ton tp transition true trunc type udint uint ulint union until upper_bound usint using valid var
    var_access var_config var_external var_global var_in_out var_input var_inst var_output var_stat var_temp vartype wchar
    while with word wstring xor xorn add sub
",
);

/// A sign always gets parentheses.
const SIGN: Level = 0;
const LOGIC: Level = 1;
const COMPARISON: Level = 2;
const SUM: Level = 3;
const PRODUCT: Level = 4;

/// The name of a type.
#[must_use]
pub fn type_name(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "BOOL",
        (Type::I32, _) => "DINT",
        (Type::U32, _) => "UDINT",
        (Type::Real, RealKind::F64) => "LREAL",
        (Type::Real, RealKind::F32) => "REAL",
    }
}

/// The function that looks at a sample's exponent bits.
#[must_use]
pub fn in_range(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "F_axgen_in_range_LREAL",
        RealKind::F32 => "F_axgen_in_range_REAL",
    }
}

fn form(operation: Operation, _: Type, real: RealKind) -> Form {
    match operation {
        Operation::Unary(Unary::Negate) => Form::Pieces(SIGN, &[Piece::Text("-"), Piece::Operand(0, PRIMARY)]),
        Operation::Unary(Unary::Not) => Form::Pieces(SIGN, &[Piece::Text("NOT "), Piece::Operand(0, PRIMARY)]),
        Operation::Binary(operator) => match operator {
            Binary::Add => Form::Infix(SUM, "+", [SUM, PRODUCT]),
            Binary::Subtract => Form::Infix(SUM, "-", [SUM, PRODUCT]),
            Binary::Multiply => Form::Infix(PRODUCT, "*", [PRODUCT, PRIMARY]),
            Binary::Divide => Form::Infix(PRODUCT, "/", [PRODUCT, PRIMARY]),
            Binary::Less => Form::Infix(COMPARISON, "<", [SUM, SUM]),
            Binary::LessEqual => Form::Infix(COMPARISON, "<=", [SUM, SUM]),
            Binary::Greater => Form::Infix(COMPARISON, ">", [SUM, SUM]),
            Binary::GreaterEqual => Form::Infix(COMPARISON, ">=", [SUM, SUM]),
            Binary::Equal => Form::Infix(COMPARISON, "=", [SUM, SUM]),
            Binary::NotEqual => Form::Infix(COMPARISON, "<>", [SUM, SUM]),
            Binary::And => Form::Infix(LOGIC, "AND", [PRIMARY, PRIMARY]),
            Binary::Or => Form::Infix(LOGIC, "OR", [PRIMARY, PRIMARY]),
        },
        Operation::Intrinsic(intrinsic) => match (intrinsic, real) {
            (Intrinsic::InRange | Intrinsic::Within, _) => Form::Pieces(
                LOGIC,
                &[
                    Piece::Text("(-"),
                    Piece::Operand(1, PRIMARY),
                    Piece::Text(" <= "),
                    Piece::Operand(0, SUM),
                    Piece::Text(")"),
                    Piece::Blank,
                    Piece::Text("AND ("),
                    Piece::Operand(0, SUM),
                    Piece::Text(" <= "),
                    Piece::Operand(1, SUM),
                    Piece::Text(")"),
                ],
            ),
            (Intrinsic::FromU32, RealKind::F64) => Form::Pieces(PRIMARY, const { &call("UDINT_TO_LREAL(") }),
            (Intrinsic::FromU32, RealKind::F32) => Form::Pieces(PRIMARY, const { &call("UDINT_TO_REAL(") }),
            (Intrinsic::FromI32, RealKind::F64) => Form::Pieces(PRIMARY, const { &call("DINT_TO_LREAL(") }),
            (Intrinsic::FromI32, RealKind::F32) => Form::Pieces(PRIMARY, const { &call("DINT_TO_REAL(") }),
            // The only conversion to an integer on which implementations agree.
            (Intrinsic::Truncate, _) => Form::Pieces(PRIMARY, const { &call("TRUNC(") }),
            (Intrinsic::Nearest, _) => panic!("st: a legalising pass spells out the rounding"),
        },
    }
}

fn form_of_codesys(operation: Operation, ty: Type, real: RealKind) -> Form {
    match (operation, real) {
        (Operation::Intrinsic(Intrinsic::InRange), RealKind::F64) => {
            Form::Pieces(LOGIC, const { &look("F_axgen_in_range_LREAL(value := ") })
        }
        (Operation::Intrinsic(Intrinsic::InRange), RealKind::F32) => {
            Form::Pieces(LOGIC, const { &look("F_axgen_in_range_REAL(value := ") })
        }
        _ => form(operation, ty, real),
    }
}

const fn call(function: &'static str) -> [Piece; 3] {
    [Piece::Text(function), Piece::Operand(0, SIGN), Piece::Text(")")]
}

const fn look(function: &'static str) -> [Piece; 5] {
    let [value, largest] = [Piece::Operand(0, SIGN), Piece::Operand(1, SIGN)];
    [Piece::Text(function), value, Piece::Text(", largest := "), largest, Piece::Text(")")]
}

fn declared(program: &Program) -> Vec<Appearance> {
    vec![Appearance::Declared; program.constants.len()]
}

/// Digits in an expression are LREAL in every implementation: they must not stand beside a REAL.
fn among_statements(program: &Program) -> Vec<Appearance> {
    let of = |value| if matches!(value, Literal::F32(_)) { Appearance::Assigned } else { Appearance::Inline };
    let mut appearances: Vec<Appearance> = program.constants.iter().map(|constant| of(constant.value)).collect();
    let mut look = |expr: &Expr| expr.parts(&mut |part| assign_alone(part, program, &mut appearances));
    program.step.iter().for_each(|statement: &Statement| statement.expressions(&mut look));
    appearances
}

/// Digits have no type of their own: an operator or a conversion that has nothing but integer digits would be anything.
fn assign_alone(expr: &Expr, program: &Program, appearances: &mut [Appearance]) {
    let operands: &[&Expr] = match expr {
        Expr::Unary(_, operand) => &[operand],
        Expr::Binary(_, left, right) => &[left, right],
        Expr::Intrinsic(_, operands) => &operands.iter().collect::<Vec<_>>(),
        Expr::Literal(_) | Expr::Var(_) => return,
    };
    let is_integer = |value: Literal| matches!(value, Literal::I32(_) | Literal::U32(_));
    let is_digits = |operand: &&Expr| match operand {
        Expr::Literal(value) => is_integer(*value),
        Expr::Var(Var::Constant(index)) => is_integer(program.constants[*index].value),
        _ => false,
    };
    if operands.iter().all(is_digits) {
        for operand in operands {
            if let Expr::Var(Var::Constant(index)) = operand {
                appearances[*index] = Appearance::Assigned;
            }
        }
    }
}
