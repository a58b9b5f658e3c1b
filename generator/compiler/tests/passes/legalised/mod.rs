//! Legalising passes that decide: each decision of `settle` and of `choose`, on programs that are small enough to be read.

mod choice;
mod settled;

use super::{ON, S, X, Y, assign, binary, real, variable};
use compiler::legalise::{WITH_DIGITS, WITH_OUTPUTS};
use compiler::program::{Constant, Expr, Local, Origin, Program, Statement, Type, Var};
use portable::{Binary, EnumDef, Literal, RealKind, Variant, VariantDef};

static PHASE: EnumDef = EnumDef {
    name: "Phase",
    doc: "",
    variants: &[
        VariantDef { name: "Rest", doc: "at rest" },
        VariantDef { name: "Rise", doc: "rises" },
        VariantDef { name: "Hold", doc: "holds" },
        VariantDef { name: "Fall", doc: "falls" },
    ],
};

fn constant(path: &str, value: Literal, origin: Origin) -> Constant {
    Constant { path: path.to_owned(), doc: "", value, origin }
}

fn variant(index: u32) -> Constant {
    let of = Variant { of: &PHASE, index };
    constant(&format!("phase_{index}"), Literal::Variant(of).at_run_time(), Origin::Variant(of))
}

/// Inputs x, on, also and n; outputs y, which starts at 7, flag and z; parts of the state s, count, phase and other; constants:
/// a coefficient, a whole one, the variants Rest, Rise and Hold.
fn program(locals: usize, step: Vec<Statement>) -> Program {
    Program {
        block: "small",
        switch: None,
        usual_first: false,
        fractions: &[],
        set: None,
        made: None,
        is_made_single: false,
        typed: false,
        real: RealKind::F64,
        inputs: vec![
            variable("x", Type::Real, Literal::F64(0.0)),
            variable("on", Type::Bool, Literal::Bool(false)),
            variable("also", Type::Bool, Literal::Bool(false)),
            variable("n", Type::U32, Literal::U32(0)),
        ],
        outputs: vec![
            variable("y", Type::Real, Literal::F64(7.0)),
            variable("flag", Type::Bool, Literal::Bool(false)),
            variable("z", Type::Real, Literal::F64(0.0)),
        ],
        state: vec![
            variable("s", Type::Real, Literal::F64(0.0)),
            variable("count", Type::I32, Literal::I32(0)),
            variable("phase", Type::I32, Literal::I32(0)),
            variable("other", Type::I32, Literal::I32(0)),
        ],
        constants: vec![
            constant("a", Literal::F64(2.0), Origin::Coefficient(0)),
            constant("mode", Literal::I32(8), Origin::Coefficient(1)),
            variant(0),
            variant(1),
            variant(2),
        ],
        locals: (0..locals).map(|index| Local { path: format!("l{index}"), ty: None }).collect(),
        init: Vec::new(),
        step,
    }
}

const ALSO: Expr = Expr::Var(Var::Input(2));
const N: Expr = Expr::Var(Var::Input(3));
const FLAG: Var = Var::Output(1);
const Z: Var = Var::Output(2);
const COUNT: Var = Var::State(1);
const PHASE_NOW: Var = Var::State(2);
const OTHER: Var = Var::State(3);

fn var(var: Var) -> Expr {
    Expr::Var(var)
}

fn yes(value: bool) -> Expr {
    Expr::Literal(Literal::Bool(value))
}

/// `y` gets a number.
fn put(value: f64) -> Statement {
    assign(Y, real(value))
}

fn when(condition: Expr, then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
    Statement::If { condition, then, otherwise }
}

/// A legalising pass by its name.
fn legal(pass: &str, program: Program) -> Program {
    let all = WITH_OUTPUTS.iter().chain(WITH_DIGITS);
    let (_, pass) = all.into_iter().find(|(name, _)| *name == pass).expect("a pass has that name");
    pass(program).expect("the program is sound")
}
