//! A usual cycle of a spindle does what any cycle would do: the same outputs and the same state, bit by bit. That the
//! one is faster is measured by `tests/bench/run`.

use axgen_tests::model::spindle::{Inputs, Parameters, block, history};
use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use compiler::leaves;
use generator::blocks;
use portable::{Block, Literal, Portable, copy};
use rayon::prelude::*;
use reference::{ipc, spindle, spindle_axis};

const HISTORIES: u64 = 100;
const CYCLES: usize = 2000;

/// The bits of a real, which NaN it is not counted; other values as they are.
fn bits(leaf: Literal) -> Result<u64, Literal> {
    match leaf {
        Literal::F64(value) if value.is_nan() => Ok(f64::NAN.to_bits()),
        Literal::F64(value) => Ok(value.to_bits()),
        Literal::F32(value) if value.is_nan() => Ok(f32::NAN.to_bits().into()),
        Literal::F32(value) => Ok(value.to_bits().into()),
        other => Err(other),
    }
}

/// Runs `step` and any cycle from the same state, cycle after cycle; gives how many cycles could be usual ones.
fn assert_same<B: Block<f64>>(
    inputs: impl Iterator<Item = B::Inputs>,
    coeffs: &B::Coeffs,
    any_cycle: impl Fn(&mut B::State, &B::Inputs, &mut B::Outputs),
    is_usual: impl Fn(&B::State) -> bool,
) -> usize
where
    B::State: Clone,
    B::Outputs: Clone,
{
    let (mut state, mut outputs) = (B::state(), B::outputs());
    let mut usual = 0;
    for (cycle, inputs) in inputs.enumerate() {
        let (mut other_state, mut other_outputs) = (state.clone(), outputs.clone());
        usual += usize::from(is_usual(&state));
        any_cycle(&mut other_state, &inputs, &mut other_outputs);
        B::step(&mut state, coeffs, &inputs, &mut outputs);
        let bits = |state: &B::State, outputs: &B::Outputs| {
            [leaves(outputs), leaves(state)].concat().into_iter().map(bits).collect()
        };
        let found: [Vec<_>; 2] = [bits(&state, &outputs), bits(&other_state, &other_outputs)];
        assert_eq!(found[0], found[1], "cycle {cycle}: {:?}", leaves(&inputs));
    }
    usual
}

/// At least a sixth of the cycles must have been usual ones, else little is compared. A whole spindle in the CNC
/// stops with a lag that the histories, which have no loop of their own, do not avoid.
fn assert_many(usual: usize) {
    let all = usize::try_from(HISTORIES).expect("a number") * CYCLES;
    assert!(usual * 6 > all, "{usual} of {all} cycles were usual ones");
}

#[test]
fn a_usual_cycle_of_the_changeover_is_like_any() {
    let usual = |seed: u64| {
        let p = Parameters::random(&mut Rng::new(seed));
        let mut coeffs = block::coefficients(&p);
        // Calls of every second one are counted: one is missing now and then, one is there twice.
        coeffs.call_rate.active = seed.is_multiple_of(2);
        let counted = |(cycle, of): (usize, &_)| {
            let cycle = u32::try_from(cycle).expect("a cycle");
            spindle::Inputs { cycle_counter: cycle + 1 + (cycle / 90) % 2, ..block::inputs_of(of) }
        };
        let all = history(seed, CYCLES, &p);
        let inputs = all.iter().enumerate().map(counted);
        let any = |state: &mut _, inputs: &_, outputs: &mut _| spindle::any_cycle(state, &coeffs, inputs, outputs);
        assert_same::<spindle::Spindle>(inputs, &coeffs, any, |state| state.usual != spindle::usual_none())
    };
    assert_many((0..HISTORIES).into_par_iter().map(usual).sum());
}

/// In the drive with an additive velocity, and in the CNC with all that an axis has.
const SPINDLES: [&str; 2] = [
    "kenngr.antr_typ = 'SERCOS'
antr.sercos.op_mode_for_velocity_control = 1
antr.nbr_delay_cycles = 4
process_data.additive_velocity = 'INT32'
lr_param.improved_position_control.stage = [{ mode = 'SET_POINT', osc_damping = 0.5, filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]
",
    "vorsteuer.vorsteuerung = 'VEL'
lr_param.improved_position_control.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]
",
];

fn axis_inputs(of: &Inputs, mode: i32) -> spindle_axis::Inputs<f64> {
    let mut inputs = spindle_axis::Inputs { v_motor: of.v_actual, mode, ..spindle_axis::Inputs::default() };
    copy!(inputs = of:
        x_command, v_interpolator, x_actual, v_actual, s_word, s_position, m3, m4, m5, m19, putax, g74, job_done, drive_on,
        operation_mode_display, feedforward_active, feedforward_percentage, reset, task_cycle_ns);
    inputs
}

#[test]
fn a_usual_cycle_of_a_whole_spindle_is_like_any() {
    let designed = SPINDLES.map(|of| {
        subject::read(&format!(
            "cycle_time = '2ms'\n[axis.X]\nkenngr.achs_typ = 'ACHSTYP_SPINDEL'
antr.sai_op_mode_change.v_velocity_control_on = 1200000
antr.sai_op_mode_change.v_position_control_on = 300000
getriebe = [{{ kv = 2000, dynamik = {{ vb_max = 18000000 }} }}]
lr_param.improved_position_control.enable = 'ON'
lr_param.improved_position_control.v_add_max_fact = 100
{of}"
        ))
    });
    let kind = blocks::named("spindle_axis").expect("the registry has the block");
    let usual = |seed: u64| {
        let designed = &designed[usize::from(seed.is_multiple_of(2))];
        let mut leaves = kind.coefficients(designed).into_iter();
        let coeffs: spindle_axis::Coeffs<f64> = Portable::build(&mut || leaves.next().expect("all coefficients"));
        let of = &coeffs.spindle;
        let p = Parameters {
            in_cnc: !of.in_drive,
            position_mode: of.position_mode,
            velocity_mode: of.velocity_mode,
            cycle_ns: of.cycle_time_ns,
            cycle: of.cycle_time,
            ..Parameters::example()
        };
        let mut rng = Rng::new(seed);
        let mut mode = ipc::mode_on();
        let inputs = history(seed, CYCLES, &p).into_iter().map(|of| {
            if rng.chance(1) {
                mode = *rng.pick(&[ipc::mode_on(), ipc::mode_on(), ipc::mode_dryrun(), ipc::mode_off()]);
            }
            axis_inputs(&of, mode)
        });
        let any = |state: &mut _, inputs: &_, outputs: &mut _| {
            let mut of_spindle = spindle::Inputs::default();
            spindle_axis::read(&mut of_spindle, inputs);
            spindle_axis::any_cycle(state, &coeffs, inputs, &of_spindle, outputs);
        };
        assert_same::<spindle_axis::SpindleAxis>(inputs, &coeffs, any, |state| {
            state.spindle.usual != spindle::usual_none()
        })
    };
    assert_many((0..HISTORIES).into_par_iter().map(usual).sum());
}
