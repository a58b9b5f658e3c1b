//! A block that counts its calls reads the counter and the cycle time of its task if the caller passes 0.
//!
//! ```text
//! IF cycle_counter = 0 THEN seen := the task's count ELSE seen := cycle_counter
//! ```

use crate::pass::Defect;
use crate::program::{Constant, Expr, Local, Origin, Program, Statement, Type, Var, rename};
use portable::{Binary, Literal};

/// The input that counts the controller's cycles: a block without it is unchanged.
const COUNTER: &str = "cycle_counter";

/// An input, the variable of TwinCAT for it, and its factor.
const KNOWN: [(&str, &str, u32); 2] = [
    (COUNTER, "TwinCAT_SystemInfoVarList._TaskInfo[GETCURTASKINDEXEX()].CycleCount", 1),
    // TwinCAT's unit is 100 ns.
    ("task_cycle_ns", "TwinCAT_SystemInfoVarList._TaskInfo[GETCURTASKINDEXEX()].CycleTime", 100),
];

/// Whether the block counts its calls.
pub(super) fn is_needed(program: &Program) -> bool {
    program.inputs.iter().any(|input| input.path == COUNTER)
}

/// The program with variables of TwinCAT's runtime.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    if !is_needed(&program) {
        return Ok(program);
    }
    for (path, text, times) in KNOWN {
        let Some(position) = program.inputs.iter().position(|input| input.path == path) else { continue };
        let (input, seen) = (Var::Input(position), Var::Local(program.locals.len()));
        program.locals.push(Local { path: format!("{path}_seen"), ty: Some(Type::U32) });
        rename(&mut program.step, &|var| if var == input { seen } else { var });
        let known = Var::Constant(program.constants.len());
        program.constants.push(Constant {
            path: format!("task_{path}"),
            doc: "task information of the controller's runtime; 0 without a task",
            value: Literal::U32(0),
            origin: Origin::Runtime(text),
        });
        let number = |value| Expr::Literal(Literal::U32(value));
        let of_task = match times {
            1 => Expr::Var(known),
            times => Expr::binary(Binary::Multiply, number(times), Expr::Var(known)),
        };
        let condition = Expr::binary(Binary::Equal, Expr::Var(input), number(0));
        let assign = |value| vec![Statement::Assign { target: seen, value }];
        let (then, otherwise) = (assign(of_task), assign(Expr::Var(input)));
        program.step.insert(0, Statement::If { condition, then, otherwise });
    }
    Ok(program)
}
