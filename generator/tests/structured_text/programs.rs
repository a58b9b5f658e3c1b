//! What a dialect changes in a program, run by the interpreter: the values stay.

use super::{MACHINE, files};
use crate::set_of;
use compiler::interp::Machine;
use compiler::legalise::{RENAMED, WITH_ENABLE};
use compiler::print::st::literal;
use compiler::program::{Expr, Program, Statement, Var, Variable};
use generator::blocks::{Block, blocks};
use portable::Literal;

fn all_blocks() -> Vec<Block> {
    set_of(MACHINE).axes.iter().flat_map(|axis| blocks(axis).unwrap()).collect()
}

/// Runs a program on the inputs of the block's trial.
fn run(program: &Program, block: &Block) -> Vec<Vec<Literal>> {
    let mut machine = Machine::start(program);
    let mut outputs = Vec::new();
    let cycle = |inputs: Vec<Literal>| {
        machine.step(&inputs, &mut outputs);
        outputs.clone()
    };
    block.trial_inputs().into_iter().map(cycle).collect()
}

/// What the program's own outputs are among all.
fn own(block: &Block, outputs: &[Literal]) -> Vec<Literal> {
    block.for_axis.outputs.iter().map(|output| outputs[*output]).collect()
}

#[test]
fn a_trial_shows_something() {
    for block in all_blocks() {
        let outputs = run(&block.program, &block);
        let at = |path: &str| block.program.outputs.iter().position(|output| output.path == path).unwrap();
        let shows =
            |path: &str, usual: fn(&Literal) -> bool| outputs.iter().filter(|sample| !usual(&sample[at(path)])).count();
        let is_zero = |value: &Literal| matches!(value, Literal::F64(0.0) | Literal::F32(0.0));
        assert!(shows("v_add_calculated", is_zero) > 60, "it moves");
        assert!(shows("v_add", is_zero) > 60, "it acts");
        assert!(shows("fault", |value| *value == Literal::Bool(false)) > 2, "a wrong cycle time is refused");
    }
}

/// Signals that an axis does not have are not missed.
#[test]
fn a_block_with_its_own_signals_does_what_it_did() {
    for block in all_blocks() {
        let mut machine = Machine::start(&block.for_axis.program);
        let mut outputs = Vec::new();
        for (inputs, expected) in block.trial_inputs().iter().zip(run(&block.program, &block)) {
            let inputs: Vec<Literal> = block.for_axis.inputs.iter().map(|input| inputs[*input]).collect();
            machine.step(&inputs, &mut outputs);
            assert_eq!(outputs, own(&block, &expected));
            for (output, variable) in expected.iter().zip(&block.program.outputs) {
                let is_own = block.for_axis.program.outputs.iter().any(|own| own.path == variable.path);
                assert!(is_own || *output == variable.start, "{}", variable.path);
            }
        }
    }
}

/// The program after one of the legalising passes.
fn legal(pass: &str, program: Program) -> Program {
    let (_, pass) = WITH_ENABLE.iter().find(|(name, _)| *name == pass).expect("a pass has that name");
    pass(program).unwrap()
}

/// The outputs of an enabled program in the order that they have without: of the four before the others, `Valid` and `Busy` are new.
fn parts<'o>(program: &Program, plain: &Program, outputs: &'o [Literal]) -> ([&'o Literal; 2], Vec<Literal>) {
    let renamed = |path: &str| RENAMED.iter().find(|(old, _)| *old == path).map_or("", |(_, new)| new);
    let at = |path: &str| {
        let is_it = |output: &Variable| output.path == path || output.path == renamed(path);
        outputs[program.outputs.iter().position(is_it).unwrap()]
    };
    assert_eq!(
        program.outputs[..4].iter().map(|output| output.path.as_str()).collect::<Vec<_>>(),
        ["Valid", "Busy", "Error", "ErrorID"]
    );
    assert_eq!(program.outputs.len(), plain.outputs.len() + 2, "each error is there once");
    ([&outputs[0], &outputs[1]], plain.outputs.iter().map(|output| at(&output.path)).collect())
}

#[test]
fn enabled_a_block_does_what_it_did() {
    for block in all_blocks() {
        let program = legal("enabled", block.program.clone());
        let mut machine = Machine::start(&program);
        let mut outputs = Vec::new();
        let fault = block.program.outputs.iter().position(|output| output.path == "fault").unwrap();
        for (inputs, expected) in block.trial_inputs().iter().zip(run(&block.program, &block)) {
            machine.step(&[&[Literal::Bool(true)], inputs.as_slice()].concat(), &mut outputs);
            let ([valid, busy], rest) = parts(&program, &block.program, &outputs);
            assert_eq!(rest, expected);
            assert_eq!(*valid, Literal::Bool(expected[fault] == Literal::Bool(false)));
            assert_eq!(*busy, Literal::Bool(true));
        }
    }
}

#[test]
fn not_enabled_a_block_does_what_it_does_in_off() {
    for block in all_blocks() {
        let program = legal("enabled", block.program.clone());
        let mode = block.program.inputs.iter().position(|input| input.path == "mode").unwrap();
        // Enabled for a while, then not: it fades out, and is busy until it has.
        let fade = 300;
        let trial = block.trial_inputs();
        let inputs: Vec<&Vec<Literal>> = (0..4 * fade).map(|index| &trial[index % 90]).collect();
        let is_on = |index: usize| index < fade;
        let mut plain = Machine::start(&block.program);
        let mut wrapped = Machine::start(&program);
        let (mut expected, mut found, mut was_busy, mut is_busy) = (Vec::new(), Vec::new(), 0, true);
        for (index, inputs) in inputs.into_iter().enumerate() {
            let mut in_mode = inputs.clone();
            in_mode[mode] = Literal::I32(i32::from(is_on(index)));
            let mut enabled = vec![Literal::Bool(is_on(index))];
            enabled.extend(inputs.iter().copied());
            enabled[mode + 1] = Literal::I32(1);
            plain.step(&in_mode, &mut expected);
            wrapped.step(&enabled, &mut found);
            let ([valid, busy], rest) = parts(&program, &block.program, &found);
            assert_eq!(rest, expected, "sample {index}");
            assert_eq!(valid, busy, "valid: as long as it fades");
            assert!(*busy == Literal::Bool(true) || !is_on(index), "busy");
            is_busy = *busy == Literal::Bool(true);
            was_busy += usize::from(is_busy && !is_on(index));
        }
        assert!(was_busy > 0 && !is_busy, "{was_busy} cycles of fading out");
    }
}

/// A program whose `init` asks for more than zeros.
#[test]
fn what_init_does_moves_into_the_first_cycle() {
    for block in all_blocks() {
        let mut program = block.program.clone();
        let fade = program.state.iter().position(|state| state.path == "fade").unwrap();
        program.init.push(Statement::Assign { target: Var::State(fade), value: Expr::Literal(Literal::U32(7)) });
        let moved = legal("started", program.clone());
        assert!(moved.init.is_empty());
        assert_eq!(moved.state.len(), program.state.len() + 1);
        assert_eq!(run(&moved, &block), run(&program, &block));
        let clear = legal("started", block.program.clone());
        assert_eq!((clear.state.len(), clear.init.len()), (block.program.state.len(), 0), "zeros are there already");
        assert_eq!(run(&clear, &block), run(&block.program, &block));
    }
}

/// The constants of real blocks, in the files themselves.
#[test]
fn every_constant_of_the_example_is_in_its_files_with_its_bits() {
    let files = files(MACHINE);
    let mut constants = 0;
    for axis in set_of(MACHINE).axes {
        let name = axis.axis.name.to_ascii_lowercase();
        let text = &files[&format!("axis_{name}_ipc.st")];
        for constant in &blocks(&axis).unwrap()[0].program.constants {
            if let value @ (Literal::F64(_) | Literal::F32(_)) = constant.value {
                constants += 1;
                assert!(text.contains(&literal(value)), "{name}: {}", constant.path);
            }
        }
    }
    assert!(constants > 40, "{constants}");
}
