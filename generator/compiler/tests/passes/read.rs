//! Small programs from text: the language in which `compiler::dump` writes them, without the kinds of variables. No pass.
//!
//! Inputs are `x`, `on`, `also` and `n`; outputs `y`, which starts at 7, `flag` and `z`; parts of the state `s`, `count`, `phase`,
//! `other`, `turn` and `row.a` to `row.c`; constants are in [`program`]. A local has its number: `a%0`. `2u` is of the type
//! U32, `2` of I32, `2.0` is real.

use compiler::program::{Constant, Expr, Local, Origin, Program, Statement, Type, Var, Variable};
use portable::{Binary, EnumDef, Intrinsic, Literal, RealKind, Unary, Variant, VariantDef};
use std::iter::Peekable;

pub static PHASE: EnumDef = EnumDef {
    name: "Phase",
    doc: "",
    variants: &[
        VariantDef { name: "Rest", doc: "at rest" },
        VariantDef { name: "Rise", doc: "rises" },
        VariantDef { name: "Hold", doc: "holds" },
        VariantDef { name: "Fall", doc: "falls" },
    ],
};

fn variable(path: &str, ty: Type, start: Literal) -> Variable {
    Variable { path: path.to_owned(), doc: "", ty, start }
}

fn constant(path: &str, value: Literal, origin: Origin) -> Constant {
    Constant { path: path.to_owned(), doc: "", value, origin }
}

fn variant(path: &str, index: u32) -> Constant {
    let of = Variant { of: &PHASE, index };
    constant(path, Literal::Variant(of).at_run_time(), Origin::Variant(of))
}

fn empty(real: RealKind) -> Program {
    Program {
        block: "small",
        switch: None,
        usual_first: false,
        fractions: &[],
        set: None,
        made: None,
        is_made_single: false,
        typed: false,
        real,
        inputs: vec![
            variable("x", Type::Real, number(real, 0.0)),
            variable("on", Type::Bool, Literal::Bool(false)),
            variable("also", Type::Bool, Literal::Bool(false)),
            variable("n", Type::U32, Literal::U32(0)),
        ],
        outputs: vec![
            variable("y", Type::Real, number(real, 7.0)),
            variable("flag", Type::Bool, Literal::Bool(false)),
            variable("z", Type::Real, number(real, 0.0)),
        ],
        state: vec![
            variable("s", Type::Real, number(real, 0.0)),
            variable("count", Type::I32, Literal::I32(0)),
            variable("phase", Type::I32, Literal::I32(0)),
            variable("other", Type::I32, Literal::I32(0)),
            variable("turn", Type::U32, Literal::U32(0)),
            variable("row.a", Type::Real, number(real, 0.0)),
            variable("row.b", Type::Real, number(real, 0.0)),
            variable("row.c", Type::Real, number(real, 0.0)),
        ],
        rows: Vec::new(),
        constants: vec![
            constant("a", number(real, 2.0), Origin::Coefficient(0)),
            constant("mode", Literal::I32(8), Origin::Coefficient(1)),
            constant("one", number(real, 1.0), Origin::Function),
            constant("minus_one", number(real, -1.0), Origin::Function),
            variant("phase_rest", 0),
            variant("phase_rise", 1),
            variant("phase_hold", 2),
        ],
        locals: Vec::new(),
        init: Vec::new(),
        step: Vec::new(),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a number that both types have")]
fn number(real: RealKind, value: f64) -> Literal {
    match real {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    }
}

/// The program with these statements; its locals have the type real, or none before the typing pass.
pub fn program(real: RealKind, text: &str, local: Option<Type>) -> Program {
    let mut program = empty(real);
    let mut lines = text.lines().peekable();
    program.step = statements(&mut program, &mut lines, 0);
    assert_eq!(lines.next(), None, "an indentation");
    program.locals.iter_mut().for_each(|known| known.ty = local);
    program
}

type Lines<'t> = Peekable<std::str::Lines<'t>>;

/// The line, if it is indented by a level.
fn line<'t>(lines: &mut Lines<'t>, level: usize) -> Option<&'t str> {
    let indent = "    ".repeat(level);
    let line = lines.peek()?.strip_prefix(&*indent)?;
    if line.starts_with(' ') { None } else { Some(line) }
}

fn statements(program: &mut Program, lines: &mut Lines<'_>, level: usize) -> Vec<Statement> {
    let mut list = Vec::new();
    while let Some(text) = line(lines, level).filter(|text| *text != "else") {
        lines.next();
        let statement = if let Some(note) = text.strip_prefix("# ") {
            Statement::Note(note.to_owned())
        } else if let Some(condition) = text.strip_prefix("if ") {
            let condition = expression(program, condition);
            let then = statements(program, lines, level + 1);
            let has_else = line(lines, level) == Some("else");
            let otherwise = if has_else { lines.next().map(|_| statements(program, lines, level + 1)) } else { None };
            Statement::If { condition, then, otherwise: otherwise.unwrap_or_default() }
        } else {
            let (target, value) = text.split_once(" = ").unwrap_or_else(|| panic!("no statement: {text}"));
            let Expr::Var(target) = expression(program, target) else { panic!("no variable: {target}") };
            Statement::Assign { target, value: expression(program, value) }
        };
        list.push(statement);
    }
    list
}

fn expression(program: &mut Program, text: &str) -> Expr {
    let text = text.replace('(', " ( ").replace(')', " ) ").replace(',', " , ");
    let mut words = text.split_ascii_whitespace().peekable();
    let value = operation(program, &mut words);
    assert_eq!(words.next(), None, "{text}");
    value
}

type Words<'t> = Peekable<std::str::SplitAsciiWhitespace<'t>>;

/// Operands with operators between them, from the left on.
fn operation(program: &mut Program, words: &mut Words<'_>) -> Expr {
    let mut value = operand(program, words);
    while let Some(operator) = words.peek().and_then(|word| operator(word)) {
        words.next();
        value = Expr::Binary(operator, Box::new(value), Box::new(operand(program, words)));
    }
    value
}

fn operator(word: &str) -> Option<Binary> {
    Some(match word {
        "+" => Binary::Add,
        "-" => Binary::Subtract,
        "*" => Binary::Multiply,
        "/" => Binary::Divide,
        "<" => Binary::Less,
        "<=" => Binary::LessEqual,
        ">" => Binary::Greater,
        ">=" => Binary::GreaterEqual,
        "==" => Binary::Equal,
        "!=" => Binary::NotEqual,
        "and" => Binary::And,
        "or" => Binary::Or,
        _ => return None,
    })
}

fn operand(program: &mut Program, words: &mut Words<'_>) -> Expr {
    let word = words.next().expect("an operand");
    let listed = |program: &mut Program, words: &mut Words<'_>| {
        let mut list = vec![operation(program, words)];
        while words.next() == Some(",") {
            list.push(operation(program, words));
        }
        list
    };
    match word {
        "(" => listed(program, words).remove(0),
        "not" => Expr::Unary(Unary::Not, Box::new(operand(program, words))),
        "minus" => Expr::Unary(Unary::Negate, Box::new(operand(program, words))),
        "true" | "false" => Expr::Literal(Literal::Bool(word == "true")),
        "inrange" | "within" => {
            words.next();
            let intrinsic = if word == "within" { Intrinsic::Within } else { Intrinsic::InRange };
            Expr::Intrinsic(intrinsic, listed(program, words))
        }
        _ if word.starts_with(|c: char| c.is_ascii_digit() || c == '-') => Expr::Literal(literal(program.real, word)),
        _ => Expr::Var(variable_of(program, word)),
    }
}

fn literal(real: RealKind, word: &str) -> Literal {
    fn read<T: std::str::FromStr>(word: &str) -> T {
        word.parse().unwrap_or_else(|_| panic!("no number: {word}"))
    }
    match (word.contains('.'), word.strip_suffix("usize"), word.strip_suffix('u')) {
        (true, ..) => number(real, read(word)),
        (_, Some(word), _) => Literal::Usize(read(word)),
        (.., Some(word)) => Literal::U32(read(word)),
        _ => Literal::I32(read(word)),
    }
}

fn variable_of(program: &mut Program, word: &str) -> Var {
    if let Some((path, index)) = word.split_once('%') {
        let index: usize = index.parse().expect("the number of a local");
        let Program { locals, .. } = program;
        locals.resize(locals.len().max(index + 1), Local { path: "unused".to_owned(), ty: None });
        path.clone_into(&mut locals[index].path);
        return Var::Local(index);
    }
    let in_list = |list: &[Variable]| list.iter().position(|known| known.path == word);
    let constants = || program.constants.iter().position(|known| known.path == word);
    (in_list(&program.inputs).map(Var::Input))
        .or_else(|| in_list(&program.outputs).map(Var::Output))
        .or_else(|| in_list(&program.state).map(Var::State))
        .or_else(|| constants().map(Var::Constant))
        .unwrap_or_else(|| panic!("no variable: {word}"))
}
