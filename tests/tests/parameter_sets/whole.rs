//! The blocks `axis` and `spindle_axis` with parameter sets, on the inputs of the golden cases, faults of the caller among them: in each
//! cycle they do what the blocks with constants do. Those have the numbers of the set in use, and the mode OFF until it is in use.

use axgen_tests::cases;
use compiler::program::Type;
use generator::axis::Numbers;
use generator::blocks::{Block, Designed};
use golden::case::{self, Case, named_block};
use golden::samples::Signal;
use golden::subject::{Subject, number};

/// Cycles of a run.
const CYCLES: usize = 6_000;

/// A block of an axis with other numbers of improved position control.
fn form(case: &Case, numbers: Numbers, fact: u32) -> (Designed, Block) {
    let mut axis = case.axis.axis.clone();
    (axis.ipc.numbers, axis.ipc.v_add_max_fact) = (numbers, fact);
    let designed = Designed::from(axis);
    let block = named_block(&designed, case.block.program.block).unwrap();
    (designed, block)
}

/// The cases of a whole axis that improves its position control.
fn whole() -> Vec<Case> {
    let mut cases = cases::in_both_real_types();
    cases.retain(|case| {
        let is_whole = ["axis", "spindle_axis"].contains(&case.block.program.block);
        is_whole && case.axis.axis.ipc.is_active() && case.axis.axis.control.master.is_none()
    });
    cases
}

#[test]
fn a_set_in_use_acts_like_constants() {
    let cases = whole();
    assert!(cases.len() >= 6);
    for case in cases {
        let taken = compared(&case);
        assert!(
            taken[0] > 0 && taken[1] > taken[0],
            "{}: the sets were in use from the cycles {taken:?} on",
            cases::title(&case)
        );
    }
}

/// Runs a case in three forms; gives the cycles in which its own set, and one with half the limit, were taken over.
fn compared(case: &Case) -> [usize; 2] {
    let sets = Numbers::Sets { lowest_f0: None };
    let fact = case.axis.axis.ipc.v_add_max_fact;
    let (designed, block) = form(case, sets, fact);
    let mut tested = Subject::start(&designed, &block);
    // The axis, and its form with half the limit, with constants.
    let mut constants = [fact, fact / 2].map(|fact| {
        let (designed, block) = form(case, Numbers::Fixed, fact);
        Subject::start(&designed, &block)
    });
    let (_, other) = form(case, sets, fact / 2);
    let own = &block.for_axis.program;
    let reals = own.inputs.iter().filter(|input| own.in_set(input).is_some() && input.ty == Type::Real).count();
    let pieces = if block.program.real == portable::RealKind::F64 { 4 } else { 3 };
    let inputs = case::inputs(case, CYCLES).unwrap();
    // In the second half of the run; the check takes a cycle, and one for each piece of a number.
    let offered = inputs.len() / 2;
    let left = offered + 1 + pieces * reals;
    let id = |of: &Block| {
        let start = of.program.inputs.iter().find(|input| input.path == "params.set_id").unwrap().start;
        number(start.at_run_time())
    };
    let (own_id, other_id) = (id(&block), id(&other));
    let (mut taken, mut acting) = ([0; 2], 0);
    let mut values = Vec::new();
    for cycle in 0..inputs.len() {
        inputs.read(cycle, &mut values);
        let at = |n: usize| number(values[n]);
        // This test offers its own sets.
        let is_signal = |of: &(usize, &Signal)| !of.1.name.starts_with("params.");
        for (n, signal) in inputs.shape.signals.iter().enumerate().filter(is_signal) {
            tested.set(&signal.name, at(n));
            constants.iter_mut().for_each(|of| assert!(of.set(&signal.name, at(n)), "{}", signal.name));
        }
        let mode = tested.input("mode").unwrap();
        if cycle == offered {
            for (input, own) in other.program.inputs.iter().zip(&block.program.inputs) {
                if other.program.in_set(input).is_some() {
                    assert!(tested.set(&own.path, number(input.start.at_run_time())), "{}", own.path);
                }
            }
        }
        tested.step();
        let active = tested.get("active_set");
        acting = if active == other_id { 1 } else { acting };
        if active == 0.0 && cycle > left {
            // The numbers of the other set were copied at fade 0.
            acting = 1;
        }
        for (n, of) in constants.iter_mut().enumerate() {
            let is_in_use = active == [own_id, other_id][n];
            let leaves = n == 0 && cycle >= left && mode == 1.0;
            // An invalid mode stays a fault.
            let is_mode = [0.0, 1.0, 2.0].contains(&mode);
            of.set(
                "mode",
                if is_mode && !is_in_use {
                    0.0
                } else if leaves {
                    2.0
                } else {
                    mode
                },
            );
            of.step();
            if is_in_use && taken[n] == 0 {
                taken[n] = cycle;
            }
        }
        for signal in &constants[acting].outputs.shape.signals {
            let [got, expected] = [&tested, &constants[acting]].map(|of| of.output(&signal.name).unwrap());
            assert!(
                got.to_bits() == expected.to_bits(),
                "{}, cycle {cycle}: {} is {got} in the place of {expected}",
                cases::title(case),
                signal.name
            );
        }
    }
    taken
}
