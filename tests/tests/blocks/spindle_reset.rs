//! A reset of the whole axis of a spindle: the additive velocity ends at once, the position loop still holds the spindle.

use axgen_tests::model::subject;
use generator::blocks;
use portable::{Block, Portable};
use reference::spindle_axis::{Coeffs, SpindleAxis};
use std::f64::consts::TAU;

const SET: &str = "cycle_time = '1ms'
[axis.X]
watch = true
accept_unstable = true
kenngr.achs_typ = 'ACHSTYP_SPINDEL'
kenngr.antr_typ = 'SERCOS'
antr.operation_mode = 'CNC_POSITION_CONTROL'
antr.sai_op_mode_change.v_velocity_control_on = 1200000
antr.sai_op_mode_change.v_position_control_on = 300000
antr.nbr_delay_cycles = 1
getriebe = [{ kv = 10000, multi_gain_z = 10000000, multi_gain_n = 360, dynamik.vb_max = 9000000 }]
[axis.X.lr_param.improved_position_control]
enable = 'ON'
v_add_max_fact = 50
stage = [{ mode = 'DIRECT', weight_fact_num = 2, filter = [{ order = 1, fg_f0 = 53.0, q_factor = 10.0 }] }]
";

#[test]
fn a_reset_ends_what_is_added_to_a_spindle() {
    let designed = subject::read(SET);
    let kind = blocks::named("spindle_axis").expect("the registry has the block");
    let mut leaves = kind.coefficients(&designed).into_iter();
    let coeffs: Coeffs<f64> = Portable::build(&mut || leaves.next().expect("all coefficients"));
    let mut inputs = <SpindleAxis as Block<f64>>::inputs(&coeffs);
    let mut state = <SpindleAxis as Block<f64>>::state();
    inputs.drive_on = true;
    let mut tripped_at = None;
    for cycle in 0..6000u32 {
        // The motor vibrates as in an unstable loop, about a position that lags by 1 degree. A reset in the seconds 4 and 5.
        inputs.v_motor = if cycle < 500 { 0.0 } else { 2e6 * (TAU * 0.053 * f64::from(cycle)).sin() };
        inputs.x_actual = 359_000.0;
        inputs.reset = (3000..5000).contains(&cycle);
        let mut outputs = <SpindleAxis as Block<f64>>::outputs();
        SpindleAxis::step(&mut state, &coeffs, &inputs, &mut outputs);
        if cycle >= 100 {
            assert_eq!((outputs.spindle_state as u32, outputs.loop_closed), (0, true), "cycle {cycle}");
            let closed = coeffs.axis.position_control.manipulated_scale * (outputs.v_command + outputs.v_add);
            assert_eq!(outputs.manipulated_variable, closed.round() as i32, "cycle {cycle}");
            assert!(outputs.v_command > 0.0, "cycle {cycle}: the loop holds the position");
        }
        if outputs.tripped && tripped_at.is_none() {
            tripped_at = Some(cycle);
        }
        if inputs.reset {
            assert_eq!((outputs.v_add, outputs.v_add_calculated, outputs.tripped), (0.0, 0.0, false), "cycle {cycle}");
        }
        // It fades in again, and the watch sees the vibration again.
        assert!(cycle != 5050 || outputs.v_add != 0.0 && outputs.error_id == 0);
        assert!(cycle != 5999 || outputs.tripped);
    }
    assert!(tripped_at.is_some_and(|cycle| cycle < 3000), "{tripped_at:?}");
}
