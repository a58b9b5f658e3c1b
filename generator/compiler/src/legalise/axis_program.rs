//! Leaves out the signals that an axis does not have: inputs that no cycle reads, and outputs that keep their start value. A
//! caller cannot connect them by mistake.

use crate::pass::prune;
use crate::program::{Expr, Program, Statement, Type, Var, Variable, map_expressions, retain_mut};

/// A program with the signals that its axis has.
#[derive(Clone, Debug)]
pub struct AxisProgram {
    pub program: Program,
    /// the position of each of its inputs among all inputs
    pub inputs: Vec<usize>,
    /// the position of each of its outputs among all outputs
    pub outputs: Vec<usize>,
}

impl AxisProgram {
    /// Its inputs outside the parameter set, by their position among all.
    pub fn signals(&self) -> Vec<usize> {
        let places = self.program.inputs.iter().zip(&self.inputs);
        places.filter(|(input, _)| self.program.in_set(input).is_none()).map(|(_, position)| *position).collect()
    }

    /// Its real inputs that are signals.
    pub fn reals(&self) -> Vec<RealInput> {
        let is_wanted =
            |input: &Variable| input.ty == Type::Real && self.program.in_set(input).is_none() && !self.program.typed;
        let reals = self.program.inputs.iter().enumerate().filter(|(_, input)| is_wanted(input));
        reals
            .map(|(place, input)| RealInput {
                position: self.inputs[place],
                in_axis: place,
                is_fraction: self.program.is_fraction(input),
            })
            .collect()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RealInput {
    /// its position among all inputs
    pub position: usize,
    /// its position among the inputs that the axis has
    pub in_axis: usize,
    /// whether it is a fraction from 0 to 1, not a sample
    pub is_fraction: bool,
}

/// Removes the other signals.
pub fn for_axis(program: &Program) -> AxisProgram {
    let (read, changing) = (read(program), changing(program));
    let mut program = program.clone();
    drop_outputs(&mut program, &changing);
    let kept = |flags: &[bool]| (0..flags.len()).filter(|index| flags[*index]).collect();
    let (inputs, outputs) = (kept(&read), kept(&changing));
    AxisProgram { program: prune::with_signals(program, (read, changing)), inputs, outputs }
}

/// The inputs that a cycle reads.
fn read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.inputs.len()];
    for statement in &program.step {
        statement.reads(&mut |var| {
            if let Var::Input(index) = var {
                read[index] = true;
            }
        });
    }
    read
}

/// The outputs that ever differ from their start value.
fn changing(program: &Program) -> Vec<bool> {
    let mut changing = vec![false; program.outputs.len()];
    for statement in &program.step {
        statement.assignments(&mut |target, value| {
            if let Var::Output(index) = target {
                changing[index] |= value.known(&program.constants) != Some(program.outputs[index].start);
            }
        });
    }
    changing
}

/// Replaces outputs that never change by their values.
fn drop_outputs(program: &mut Program, changing: &[bool]) {
    let outputs = &program.outputs;
    map_expressions(&mut program.step, &mut |expr| {
        expr.change(&mut |part| {
            if let Expr::Var(Var::Output(index)) = *part
                && !changing[index]
            {
                *part = Expr::Literal(outputs[index].start);
            }
        });
    });
    retain_mut(&mut program.step, &mut |statement| match statement {
        Statement::Assign { target: Var::Output(index), .. } => changing[*index],
        _ => true,
    });
}
