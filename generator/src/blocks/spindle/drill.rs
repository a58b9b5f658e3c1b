//! The sequence of a self-test that goes through the changeover: noise alone would never reach velocity control. No noise.

use super::super::Drill;
use portable::Extreme;
use portable::Literal;
use reference::spindle::Coeffs;

/// M3 above Von, the drive's answer, M19, and the way back; then an error and the reset.
pub(super) fn through_all_states(coeffs: &Coeffs<f64>) -> Vec<Drill> {
    let speed = 2.0 * coeffs.v_velocity_control_on + 6000.0;
    // The drive must be able to detect the direction.
    let reached = match coeffs.in_drive {
        true => (coeffs.v_velocity_control_on + coeffs.v_largest.smaller(speed)) / 2.0,
        false => speed,
    };
    let part = |input, value, samples| Drill { input, value, samples };
    let mut parts = vec![
        part("reset", Literal::Bool(true), 0..2),
        part("m3", Literal::Bool(true), 12..14),
        part("s_word", Literal::F64(speed), 12..13),
        part("v_interpolator", Literal::F64(reached), 14..15),
        part("m19", Literal::Bool(true), 20..22),
        part("s_word", Literal::F64(speed), 20..21),
        part("job_done", Literal::Bool(true), 34..36),
        part("m4", Literal::Bool(true), 36..38),
        part("m5", Literal::Bool(true), 40..41),
        part("putax", Literal::Bool(true), 42..43),
        part("g74", Literal::Bool(true), 44..45),
        part("x_command", Literal::F64(180_000.0), 46..47),
        part("reset", Literal::Bool(true), 52..54),
        part("job_done", Literal::Bool(false), 63..64),
    ];
    if coeffs.in_drive {
        parts.push(part("operation_mode_display", Literal::I32(coeffs.velocity_mode), 17..26));
    }
    parts
}
