//! Adds the signals of PLCopen function blocks to a block: Enable, Valid, Busy, Error, ErrorID, NoticeID.

use crate::pass::Defect;
use crate::program::{Constant, Expr, Local, Off, Program, Statement, Switch, Type, Var, Variable, rename};
use portable::{Binary, Brake, Literal};

/// The signals that every block gets.
const SWITCH: [&str; 3] = ["Enable", "Valid", "Busy"];
/// The renamed outputs with their new names.
pub const RENAMED: [(&str, &str); 2] = [("fault", "Error"), ("error_id", "ErrorID")];
/// The output with the id of a notice, which is not a fault.
pub const NOTICE: &str = "NoticeID";
/// The ids that `error_id` may have without a fault, by the names of their functions in the reference.
pub const NOTICES: [&str; 6] = [
    "error_tuning",
    "error_unstable",
    "error_set_structure",
    "error_set_unsound",
    "error_set_damaged",
    "error_reversal",
];
/// The ids among [`NOTICES`] that are never a fault.
pub const ONLY_NOTICES: [&str; 3] = ["error_tuning", "error_unstable", "error_reversal"];

/// The data for the signals of a cycle, for callers that know the block's own outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cycle {
    pub fault: bool,
    pub error_id: u32,
    pub is_enabled: bool,
    /// whether the block has to be called on when it is not enabled
    pub works: bool,
}

impl Cycle {
    /// The value of one of the signals; `None` for any other output.
    pub fn value(self, path: &str) -> Option<Literal> {
        let busy = self.is_enabled || self.works;
        Some(match path {
            "Valid" => Literal::Bool(busy && !self.fault),
            "Busy" => Literal::Bool(busy),
            "Error" => Literal::Bool(busy && self.fault),
            "ErrorID" => Literal::U32(if busy && self.fault { self.error_id } else { 0 }),
            NOTICE => Literal::U32(if self.fault { 0 } else { self.error_id }),
            _ => return None,
        })
    }
}

/// The program with these signals, which come before the others.
///
/// - `Enable` FALSE turns the block off: mode OFF, or a BOOL; with TRUE that input applies.
/// - `Busy`: enabled, or not yet at rest: it fades out, or it brakes.
/// - `Valid`: `Busy`, and no fault in this cycle. It falls with the last value to be used, not earlier.
/// - `Error`, `ErrorID`: `fault` and its id while `Busy` is TRUE: a block that `Enable` FALSE has brought to rest shows no
///   error.
/// - `NoticeID`: `error_id` in a cycle without a fault.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let missing = |what: &str| Defect { pass: "enable", message: format!("{} has no {what}", program.block) };
    let switch = program.switch.take().ok_or_else(|| missing("input to turn it off"))?;
    let output = |path: &str| program.outputs.iter().position(|variable| variable.path == path);
    let [error, error_id] = RENAMED.map(|(path, _)| output(path).ok_or_else(|| missing(path)));
    let brake = match &switch.off {
        Off::Brake(brake) => {
            Some(output(brake.velocity).zip(output(brake.state)).ok_or_else(|| missing(brake.velocity))?)
        }
        Off::Mode(..) | Off::False | Off::Execute(_) => None,
    };
    let moved = add_signals(&mut program, &switch.off, [error?, error_id?]);
    let works = match &switch.off {
        Off::Mode(_, works) | Off::Execute(works) => works.map(Expr::Var),
        Off::False => None,
        Off::Brake(of) => brake.map(|(velocity, state)| works(&program, of, [velocity, state].map(&moved))),
    };
    combine(&mut program, switch);
    let enable = Expr::Var(Var::Input(0));
    let busy = works.map_or(enable.clone(), |works| Expr::binary(Binary::Or, enable, works));
    put_out(&mut program, busy);
    Ok(program)
}

/// The block reads the input that turns it off combined with `Enable`, instead of the input alone.
fn combine(program: &mut Program, switch: Switch) {
    let (input, enabled) = (Var::Input(switch.input + 1), Var::Local(program.locals.len()));
    let variable = &program.inputs[switch.input + 1];
    program.locals.push(Local { path: format!("{}_enabled", variable.path), ty: Some(variable.ty) });
    rename(&mut program.step, &|var| if var == input { enabled } else { var });
    let off = match switch.off {
        Off::Mode(off, _) => {
            let known = program.constants.iter().position(|constant| *constant == off);
            Expr::Var(Var::Constant(known.unwrap_or_else(|| {
                program.constants.push(off);
                program.constants.len() - 1
            })))
        }
        other => Expr::Literal(other.value()),
    };
    let (then, otherwise) = (vec![assign(enabled, Expr::Var(input))], vec![assign(enabled, off)]);
    program.step.insert(0, Statement::If { condition: Expr::Var(Var::Input(0)), then, otherwise });
}

/// Assigns the signals after all statements of the block.
fn put_out(program: &mut Program, is_busy: Expr) {
    let [valid, busy, error, error_id, notice] = [0, 1, 2, 3, 4].map(Var::Output);
    let and = |left, right| Expr::binary(Binary::And, left, right);
    let none = || Expr::Literal(Literal::U32(0));
    let shown = and(Expr::Var(error), Expr::Var(busy));
    program.step.extend([assign(busy, is_busy), assign(valid, and(Expr::Var(busy), Expr::not(Expr::Var(error))))]);
    if has_notices(program) {
        program.step.push(Statement::If {
            condition: Expr::Var(error),
            then: vec![assign(notice, none())],
            otherwise: vec![assign(notice, Expr::Var(error_id))],
        });
    }
    let otherwise = vec![assign(error_id, none())];
    program
        .step
        .extend([Statement::If { condition: shown.clone(), then: Vec::new(), otherwise }, assign(error, shown)]);
}

/// Whether a braking block is not at rest yet.
fn works(program: &Program, brake: &Brake, [velocity, state]: [Var; 2]) -> Expr {
    let zero = match program.real {
        portable::RealKind::F64 => Literal::F64(0.0),
        portable::RealKind::F32 => Literal::F32(0.0),
    };
    let compared = |operator, var, with| Expr::binary(operator, Expr::Var(var), Expr::Literal(with));
    let or = |left, right| Expr::binary(Binary::Or, left, right);
    let moves = or(compared(Binary::Greater, velocity, zero), compared(Binary::Less, velocity, zero));
    let named = |number: i32| {
        let is_it =
            |constant: &Constant| constant.value == Literal::I32(number) && constant.path.starts_with(brake.state);
        let known = program.constants.iter().position(is_it);
        known.map_or(Expr::Literal(Literal::I32(number)), |index| Expr::Var(Var::Constant(index)))
    };
    let differs = |number: i32| Expr::binary(Binary::NotEqual, Expr::Var(state), named(number));
    let (input, number) = brake.drive;
    let drive = program.inputs.iter().position(|variable| variable.path == input);
    let drive = drive.map(|index| or(Expr::Var(Var::Input(index)), differs(number)));
    let changes = brake.resting.iter().map(|number| differs(*number)).chain(drive);
    let changes = changes.reduce(|left, right| Expr::binary(Binary::And, left, right));
    changes.map_or(moves.clone(), |changes| or(moves, changes))
}

/// Whether the block may report a notice.
fn has_notices(program: &Program) -> bool {
    program.constants.iter().any(|constant| NOTICES.contains(&constant.path.as_str()))
}

/// Inserts the new signals before the others; the two renamed outputs follow them. Returns the new position of each output. No
/// statement uses the new signals yet.
fn add_signals(program: &mut Program, off: &Off, renamed: [usize; 2]) -> impl Fn(usize) -> Var + use<> {
    let bool = |path: &str, doc| Variable { path: path.to_owned(), doc, ty: Type::Bool, start: Literal::Bool(false) };
    let [enable, valid, busy] = [0, 1, 2].map(|of| bool(SWITCH[of], docs(off)[of]));
    program.inputs.insert(0, enable);
    let mut old: Vec<Option<Variable>> = std::mem::take(&mut program.outputs).into_iter().map(Some).collect();
    program.outputs = vec![valid, busy];
    for ((index, (_, name)), doc) in renamed.iter().zip(RENAMED).zip(OF_ERRORS) {
        program.outputs.extend(old[*index].take().map(|old| Variable { path: name.to_owned(), doc, ..old }));
    }
    if has_notices(program) {
        program.outputs.push(Variable {
            path: NOTICE.to_owned(),
            doc: OF_NOTICE,
            ty: Type::U32,
            start: Literal::U32(0),
        });
    }
    let first = program.outputs.len();
    let rest: Vec<usize> = (0..old.len()).filter(|index| old[*index].is_some()).collect();
    program.outputs.extend(old.into_iter().flatten());
    let place = move |index: usize| {
        let among = |list: &[usize]| list.iter().position(|old| *old == index);
        Var::Output(among(&renamed).map(|at| 2 + at).or_else(|| among(&rest).map(|at| first + at)).unwrap_or_default())
    };
    let moved = |var| match var {
        Var::Input(index) => Var::Input(index + 1),
        Var::Output(index) => place(index),
        other => other,
    };
    rename(&mut program.init, &moved);
    rename(&mut program.step, &moved);
    place
}

const OF_ERRORS: [&str; 2] = [
    "fault while Busy is TRUE; ErrorID gives the reason. After Enable FALSE it ends as soon as the block is at rest",
    "why Error is TRUE: 0 none",
];
const OF_NOTICE: &str = "id of a notice: it needs attention but is not a fault: 0 none";

/// The meanings of Enable, Valid and Busy, by what turns the block off.
const MODE: [&str; 3] = [
    "FALSE: acts as mode OFF, v_add fades out; TRUE: the input mode applies",
    "TRUE: add v_add; the block is enabled or still fades out, and has no fault in this cycle",
    "TRUE: keep calling the block; it is enabled or still fades out",
];
const FALSE: [&str; 3] = [
    "FALSE: acts as position_controlled FALSE, at once and without a ramp; TRUE: the input position_controlled applies",
    "TRUE: enabled, and no part has a fault in this cycle; the outputs are valid in any case: do not gate them with Valid",
    "TRUE: keep calling the block; it is enabled",
];
const EXECUTE: [&str; 3] = [
    "FALSE: acts as execute FALSE, no design begins, an active one goes on; TRUE: the input execute applies",
    "TRUE: enabled or still designing, and no input was refused; params is a set only while designed is TRUE",
    "TRUE: keep calling the block; it is enabled or still designs",
];
const BRAKE: [&str; 3] = [
    "FALSE: acts as reset TRUE: velocity control brakes to standstill, under position control the interpolator stops; \
     TRUE: the input reset applies",
    "TRUE: enabled or still braking, and no fault in this cycle; the outputs are valid in any case: do not gate them with Valid",
    "TRUE: keep calling the block; it is enabled, the spindle turns, or it is not yet back from velocity control",
];

fn docs(off: &Off) -> [&'static str; 3] {
    match off {
        Off::Mode(..) => MODE,
        Off::False => FALSE,
        Off::Execute(_) => EXECUTE,
        Off::Brake(_) => BRAKE,
    }
}

/// The meanings of one of the signals, which depend on the block; none for any other name.
pub fn meanings(name: &str) -> Vec<&'static str> {
    let of_switch = [MODE, FALSE, EXECUTE, BRAKE].into_iter().flat_map(|docs| SWITCH.into_iter().zip(docs));
    let of_errors = RENAMED.iter().map(|(_, name)| *name).zip(OF_ERRORS);
    let all = of_switch.chain(of_errors).chain([(NOTICE, OF_NOTICE)]);
    let mut found = Vec::new();
    for (_, doc) in all.filter(|(known, _)| *known == name) {
        if !found.contains(&doc) {
            found.push(doc);
        }
    }
    found
}

fn assign(target: Var, value: Expr) -> Statement {
    Statement::Assign { target, value }
}
