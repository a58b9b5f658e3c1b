//! A reset of the whole axis of a spindle: the additive velocity ends at once, the position loop still holds the spindle.

use axgen_tests::model::subject;
use generator::blocks;
use portable::{Block, Portable};
use reference::spindle_axis::{Coeffs, SpindleAxis};
use std::cmp::Ordering;
use std::f64::consts::TAU;

const SET: &str = include_str!("spindle_reset.toml");

#[test]
fn a_reset_ends_what_is_added_to_a_spindle() {
    let designed = subject::read(SET);
    let kind = blocks::named("spindle_axis").expect("the registry has the block");
    let mut leaves = kind.coefficients(&designed).into_iter();
    let coeffs: Coeffs<f64> = Portable::build(&mut || leaves.next().expect("all coefficients"));
    let mut inputs = <SpindleAxis as Block<f64>>::inputs(&coeffs);
    let mut state = <SpindleAxis as Block<f64>>::state();
    inputs.drive_on = true;
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
            assert_eq!(
                f64::from(outputs.manipulated_variable).total_cmp(&closed.round()),
                Ordering::Equal,
                "cycle {cycle}"
            );
            assert!(outputs.v_command > 0.0, "cycle {cycle}: the loop holds the position");
        }
        if inputs.reset {
            assert_eq!((outputs.v_add, outputs.v_add_calculated, outputs.tripped), (0.0, 0.0, false), "cycle {cycle}");
        }
        // It fades in again, and the watch sees the vibration again.
        assert!(cycle != 5050 || outputs.v_add != 0.0 && outputs.error_id == 0);
        assert!(![2999, 5999].contains(&cycle) || outputs.tripped, "cycle {cycle}");
    }
}
