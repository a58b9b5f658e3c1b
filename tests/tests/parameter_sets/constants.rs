//! The blocks with parameter sets, on the inputs of the golden cases, faults of the caller among them: in each cycle they do what the
//! blocks with constants do, which an independent model is held against. Those have the numbers of the set in use, and the mode OFF
//! until it is in use.

use axgen_tests::cases;
use compiler::program::Type;
use generator::axis::Numbers;
use generator::blocks::{Block, Designed};
use golden::case::{self, Case, named_block};
use golden::samples::Signal;
use golden::subject::{Subject, number};
use rayon::prelude::*;
use std::collections::BTreeSet;

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

/// The cases with improved position control whose numbers are fixed.
fn cases_with_constants() -> Vec<Case> {
    let mut cases = cases::in_both_real_types();
    cases.retain(|case| {
        let ipc = &case.axis.axis.ipc;
        let is_inside = ["ipc", "axis", "spindle_axis"].contains(&case.block.program.block) && ipc.is_active();
        let is_usual = ipc.tuning().is_none() && !ipc.watch && case.axis.axis.control.master.is_none();
        is_inside && is_usual && ipc.v_add_max_fact > 1 && case.axis.ipc.fade_cycles <= 2_000
    });
    cases
}

#[test]
fn a_set_in_use_acts_like_constants() {
    let cases = cases_with_constants();
    let blocks: BTreeSet<&str> = cases.iter().map(|case| case.block.program.block).collect();
    assert!(blocks.len() == 3 && cases.len() >= 20, "{blocks:?}");
    cases.par_iter().for_each(|case| {
        let [own, other] = compared(case);
        assert!(own > 0 && other > own, "{}: taken over in the cycles {own} and {other}", cases::title(case));
    });
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
    let ids = [&block, &other].map(set_id);
    let (mut taken, mut acting) = ([0; 2], 0);
    let mut values = Vec::new();
    for cycle in 0..inputs.len() {
        inputs.read(cycle, &mut values);
        // This test offers its own sets.
        let all = inputs.shape.signals.iter().zip(&values).filter(|(of, _)| !of.name.starts_with("params."));
        for (Signal { name, .. }, value) in all {
            let subjects = constants.iter_mut().chain([&mut tested]);
            subjects.for_each(|of| _ = of.set(name, number(*value)));
        }
        let mode = tested.input("mode").unwrap();
        if cycle == offered {
            offer(&mut tested, &other);
        }
        tested.step();
        let active = tested.get("active_set");
        // The numbers of the other set are copied at fade 0.
        acting |= usize::from(active == ids[1] || active == 0.0 && cycle > left);
        for (n, of) in constants.iter_mut().enumerate() {
            let is_in_use = active == ids[n];
            let leaves = n == 0 && cycle >= left;
            let acts_as = if is_in_use { [0.0, if leaves { 2.0 } else { 1.0 }, 2.0] } else { [0.0; 3] };
            // An invalid mode stays a fault.
            of.set(
                "mode",
                [0.0, 1.0, 2.0].iter().position(|known| *known == mode).map_or(mode, |known| acts_as[known]),
            );
            of.step();
            taken[n] = if is_in_use && taken[n] == 0 { cycle } else { taken[n] };
        }
        for Signal { name, .. } in &constants[acting].outputs.shape.signals {
            let [got, expected] = [&tested, &constants[acting]].map(|of| of.output(name).unwrap());
            let title = cases::title(case);
            assert_eq!(got.to_bits(), expected.to_bits(), "{title}, cycle {cycle}: {name} is {got}, not {expected}");
        }
    }
    taken
}

/// The mode in which a block runs while it takes a set over is not the caller's: it does not rearm a tripped watch.
#[test]
fn a_change_of_the_set_rearms_no_watch() {
    let cases = cases_with_constants();
    let mut blocks = BTreeSet::new();
    for case in cases.iter().filter(|case| case.block.program.block != "ipc") {
        let mut watched = case.clone();
        watched.axis.axis.ipc.watch = true;
        let [(designed, block), (_, other)] =
            [2, 1].map(|fact| form(&watched, Numbers::Sets { lowest_f0: None }, fact));
        let mut tested = Subject::start(&designed, &block);
        let inputs = case::inputs(case, CYCLES).unwrap();
        let (mut tripped, mut values) = (0, Vec::new());
        for cycle in 0..CYCLES {
            inputs.read(cycle.min(inputs.len() - 1), &mut values);
            for (signal, value) in inputs.shape.signals.iter().zip(&values) {
                tested.set(&signal.name, number(*value));
            }
            // The limit is the smallest: any vibration is beyond it.
            let v = (cycle as f64 * 0.3).sin() * 1e5;
            for (input, value) in [("mode", 1.0), ("reset", 0.0), ("v_motor", v), ("v_direct", v)] {
                tested.set(input, value);
            }
            if tripped > 0 {
                offer(&mut tested, &other);
            }
            tested.step();
            assert!(tripped == 0 || tested.get("tripped") == 1.0, "{}, cycle {cycle}", cases::title(case));
            tripped += usize::from(tested.get("tripped") == 1.0);
        }
        if tripped > 1000 && tested.get("active_set") == set_id(&other) {
            blocks.insert(block.program.block);
        }
    }
    assert_eq!(blocks.into_iter().collect::<Vec<_>>(), ["axis", "spindle_axis"]);
}

/// Offers the set that a block was generated with.
fn offer(to: &mut Subject, of: &Block) {
    for input in of.program.inputs.iter().filter(|input| of.program.in_set(input).is_some()) {
        assert!(to.set(&input.path, number(input.start.at_run_time())), "{}", input.path);
    }
}

fn set_id(of: &Block) -> f64 {
    let input = of.program.inputs.iter().find(|input| input.path == "params.set_id").unwrap();
    number(input.start.at_run_time())
}
