//! The gain from which a position loop in the CNC is unstable, against the loop itself, cycle by cycle; and what an analysis
//! says of a loop without stages.

use super::{read_set, said_of_set};
use std::collections::VecDeque;

/// Whether a deviation grows in the loop with this Kv T: the position is the sum of the velocities up to the last cycle, and the
/// velocity follows the command after the delay, behind the time constant of which `rest` is left after a cycle.
fn grows(gain: f64, cycles: usize, rest: f64) -> bool {
    let mut commands: VecDeque<f64> = std::iter::repeat_n(0.0, cycles).collect();
    let [mut position, mut velocity] = [1.0_f64, 0.0];
    let mut largest = 0.0_f64;
    for n in 0..1_000_000 {
        position += velocity;
        commands.push_back(-gain * position);
        let arrives = commands.pop_front().expect("a command for each cycle of the delay");
        velocity = rest * velocity + (1.0 - rest) * arrives;
        if position.abs() > 1e9 {
            return true;
        }
        if n >= 990_000 {
            largest = largest.max(position.abs());
        }
    }
    assert!(largest < 1e-9, "{gain} {cycles} {rest}: {largest} is neither");
    false
}

/// What is refused is what grows: a thousandth above the gain that the message allows, and not a thousandth below.
#[test]
fn the_refused_gains_are_those_of_an_unstable_loop() {
    for (cycles, time_constant_ms) in [(1, 0), (2, 0), (3, 0), (10, 0), (1, 1), (1, 3), (2, 20), (5, 4)] {
        let drive = match time_constant_ms {
            0 => format!("drive.delay = {cycles}"),
            ms => format!("drive = {{ delay = {cycles}, time_constant = '{ms}ms' }}"),
        };
        let said = said_of_set(&format!("cycle_time = '1ms'\n[axis.X]\n{drive}\ngetriebe = [{{ kv = 4000000 }}]\n"));
        let (_, limit) = said.split_once("allowed: kv below ").unwrap_or_else(|| panic!("{drive}: {said}"));
        let (limit, _) = limit.split_once(' ').unwrap_or_else(|| panic!("{drive}: {said}"));
        let limit: f64 = limit.parse().unwrap_or_else(|_| panic!("{drive}: {said}"));
        let rest = if time_constant_ms == 0 { 0.0 } else { (-1.0 / f64::from(time_constant_ms)).exp() };
        let [below, above] = [0.999, 1.001].map(|part| grows(limit / 1e5 * part, cycles, rest));
        assert_eq!([below, above], [false, true], "{drive}: {limit}");
    }
}

/// An analysis names the gain of an axis whether a stage is active or not.
#[test]
fn an_analysis_names_the_gain_of_an_axis_without_a_stage() {
    for (keys, position) in [
        ("getriebe = [{ kv = 2000 }]", "position loop with Kv 20/s"),
        ("getriebe = [{ dynamik.vb_max = 5000 }]", "without its position loop: Kv (P-AXIS-00099) is not given"),
    ] {
        let (set, report) = read_set(format!("cycle_time = '1ms'\n[axis.X]\n{keys}\ndrive.delay = 1\n"));
        let set = set.unwrap_or_else(|| panic!("{report}"));
        let lines = format!(
            "axis X: cycle 1000 us, {position}\n  no stage looks at v_motor or v_direct: the stages close no loop\n"
        );
        assert_eq!(generator::analysis::text(&set.axes[0]), lines);
    }
}
