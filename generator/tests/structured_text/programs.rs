//! What a dialect changes in a program, run by the interpreter: the values stay.

use super::{MACHINE, set};
use compiler::interp::Machine;
use compiler::legalise::WITH_ENABLE;
use compiler::program::{Expr, Program, Statement, Type, Var};
use generator::blocks::{Block, blocks};
use portable::Literal;

fn all_blocks() -> Vec<Block> {
    set(MACHINE).axes.iter().flat_map(|axis| blocks(axis).unwrap()).collect()
}

/// Runs a program on the inputs of the block's vector; `more` are the values of inputs before these.
fn run(program: &Program, block: &Block, more: &[Literal]) -> Vec<Vec<Literal>> {
    let mut machine = Machine::start(program);
    let mut outputs = Vec::new();
    let cycle = |inputs: &Vec<Literal>| {
        machine.step(&[more, inputs.as_slice()].concat(), &mut outputs);
        outputs.clone()
    };
    block.vector.inputs.iter().map(cycle).collect()
}

#[test]
fn the_vector_is_what_the_program_gives() {
    for block in all_blocks() {
        assert_eq!(run(&block.program, &block, &[]), block.vector.outputs);
    }
}

#[test]
fn a_vector_shows_something() {
    for block in all_blocks() {
        let at = |path: &str| block.program.outputs.iter().position(|output| output.path == path).unwrap();
        let shows = |path: &str, usual: fn(&Literal) -> bool| {
            block.vector.outputs.iter().filter(|sample| !usual(&sample[at(path)])).count()
        };
        let is_zero = |value: &Literal| matches!(value, Literal::F64(0.0) | Literal::F32(0.0));
        assert!(shows("v_add_calculated", is_zero) > 60, "it moves");
        assert!(shows("v_add", is_zero) > 20, "it acts");
        assert!(shows("fault", |value| *value == Literal::Bool(false)) > 0, "a wrong cycle time is refused");
    }
}

/// The program after one of the legalising passes.
fn legal(pass: &str, program: Program) -> Program {
    let (_, pass) = WITH_ENABLE.iter().find(|(name, _)| *name == pass).expect("a pass has that name");
    pass(program).unwrap()
}

#[test]
fn enabled_a_block_does_what_it_did() {
    for block in all_blocks() {
        let program = legal("enabled", block.program.clone());
        for (found, expected) in run(&program, &block, &[Literal::Bool(true)]).iter().zip(&block.vector.outputs) {
            let [valid, busy, error, error_id, rest @ ..] = found.as_slice() else { panic!("four outputs more") };
            assert_eq!(rest, expected);
            let at = |path: &str| expected[block.program.outputs.iter().position(|o| o.path == path).unwrap()];
            assert_eq!((*error, *error_id), (at("fault"), at("error_id")));
            assert_eq!(*valid, Literal::Bool(at("fault") == Literal::Bool(false)));
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
        let usual = block.vector.inputs[0].clone();
        let reals: Vec<usize> =
            (0..usual.len()).filter(|index| block.program.inputs[*index].ty == Type::Real).collect();
        let sample = |index: usize| {
            let mut sample = usual.clone();
            for real in &reals {
                sample[*real] = block.vector.inputs[index % 90][*real];
            }
            sample
        };
        let inputs: Vec<Vec<Literal>> = (0..4 * fade).map(sample).collect();
        let is_on = |index: usize| index < fade;
        let mut plain = Machine::start(&block.program);
        let mut wrapped = Machine::start(&program);
        let (mut expected, mut found, mut was_busy, mut is_busy) = (Vec::new(), Vec::new(), 0, true);
        for (index, inputs) in inputs.iter().enumerate() {
            let mut in_mode = inputs.clone();
            in_mode[mode] = Literal::I32(i32::from(is_on(index)));
            let mut enabled = vec![Literal::Bool(is_on(index))];
            enabled.extend(inputs.iter().copied());
            enabled[mode + 1] = Literal::I32(1);
            plain.step(&in_mode, &mut expected);
            wrapped.step(&enabled, &mut found);
            assert_eq!(found[4..], expected[..], "sample {index}");
            assert_eq!(found[0], Literal::Bool(is_on(index)), "valid");
            is_busy = found[1] == Literal::Bool(true);
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
        assert_eq!(run(&moved, &block, &[]), run(&program, &block, &[]));
        let clear = legal("started", block.program.clone());
        assert_eq!((clear.state.len(), clear.init.len()), (block.program.state.len(), 0), "zeros are there already");
        assert_eq!(run(&clear, &block, &[]), block.vector.outputs);
    }
}

#[test]
fn a_number_beside_a_variable_gets_a_name() {
    let blocks = all_blocks();
    let block = blocks.iter().find(|block| block.program.block == "ipc").unwrap();
    let mut program = block.program.clone();
    let number = |value| Box::new(Expr::Literal(Literal::F64(value)));
    let input = || Box::new(Expr::Var(Var::Input(1)));
    let sum = |value| Expr::Binary(portable::Binary::Add, input(), number(value));
    let v_add = Var::Output(0);
    let own = legal("named", program.clone()).constants.len();
    program.step.extend([0.5, 0.25, 0.5].map(|value| Statement::Assign { target: v_add, value: sum(value) }));
    program.step.push(Statement::Assign { target: Var::Output(1), value: *number(0.125) });
    let named = legal("named", program.clone());
    let added: Vec<Literal> = named.constants[own..].iter().map(|constant| constant.value).collect();
    let expected = [0.5, 0.25].map(Literal::F64);
    assert_eq!(added, expected, "0.5 once, 0.25, and what is assigned stays");
    for (number, constant) in named.constants[program.constants.len()..].iter().enumerate() {
        assert_eq!(constant.path, format!("number[{number}]"));
    }
    assert_eq!(run(&named, block, &[]), run(&program, block, &[]));
}
