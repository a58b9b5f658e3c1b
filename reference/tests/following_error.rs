//! Position control in single precision: positions of metres lose what a following error keeps.

use portable::Block;
use reference::position_control::{Coeffs, Inputs, PositionControl};

fn v_command(inputs: &Inputs<f32>) -> f32 {
    let coeffs = Coeffs { kv: 20.0, ..Coeffs::default() };
    let mut state = <PositionControl as Block<f32>>::state();
    let mut outputs = <PositionControl as Block<f32>>::outputs();
    <PositionControl as Block<f32>>::step(&mut state, &coeffs, inputs, &mut outputs);
    outputs.v_command
}

#[test]
fn a_lag_of_a_tenth_of_a_micrometre_counts_at_3_m() {
    // The caller subtracts increments of 0.1 um.
    let [command, actual] = [30_000_001_i32, 30_000_000_i32];
    let usual = <PositionControl as Block<f32>>::inputs(&Coeffs::default());
    #[expect(clippy::cast_precision_loss, reason = "a few increments")]
    let following_error = (command - actual) as f32 * 0.1;
    assert_eq!(v_command(&Inputs { following_error, ..usual }).to_bits(), 2.0_f32.to_bits());
    // A position is not looked at: in this precision both are the same.
    let [x_command, x_actual] = [3_000_000.1_f32, 3_000_000.0];
    assert_eq!(x_command.to_bits(), x_actual.to_bits());
    assert_eq!(v_command(&Inputs { x_command, x_actual, ..usual }).to_bits(), 0.0_f32.to_bits());
}
