//! The worked figures of the manual (ISG FCT-D2 "Feedforward control", 4.1 and 4.2) and of the formulas next to it, to the
//! last digit that they are printed with; what the drive gets is an integer and compared as one.

use generator::axis::{Axis, Enable, Motor, Ratio, Resolution, TimeBase, Torque, Velocity, Width};
use generator::blocks::{Designed, blocks};
use generator::config::ListOptions;
use generator::design::delay::delay as design_delay;
use generator::design::rounding::rounded;
use generator::design::scale::{self, angular_acceleration};
use generator::pipeline::read;
use portable::{Block, RealKind};
use reference::feedforward::{Feedforward, Inputs};
use reference::ipc::{Ipc, mode_dryrun, mode_off, mode_on};
use reference::position_control::PositionControl;
use reference::{delay, process_data};
use std::path::Path;

fn example(name: &str) -> Axis {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/feedforward.toml");
    let (set, report) = read(&path, &ListOptions::default());
    let axes = set.unwrap_or_else(|| panic!("{report}")).axes;
    axes.into_iter().find(|of| of.axis.name == name).expect("an axis of the example").axis
}

/// What the drive of an axis gets for a constant input, after the delays have run full.
fn steady(axis: &Axis, inputs: Inputs<f64>) -> [i32; 2] {
    let coeffs = Designed::from(axis.clone()).feedforward;
    let inputs = Inputs { feedforward_active: true, feedforward_percentage: 100, position_controlled: true, ..inputs };
    let (mut state, mut outputs) = (<Feedforward as Block<f64>>::state(), <Feedforward as Block<f64>>::outputs());
    for _ in 0..10 {
        <Feedforward as Block<f64>>::step(&mut state, &coeffs, &inputs, &mut outputs);
    }
    assert!(!outputs.fault);
    [outputs.additive_velocity, outputs.additive_torque]
}

fn with_velocity(reso: Ratio, time_base: TimeBase, cycle_time_ns: u32) -> Axis {
    let mut axis = Axis { cycle_time_ns, ..example("V") };
    let feedforward = axis.control.feedforward.as_mut().expect("it has feedforward");
    feedforward.velocity = Some(Velocity { reso, time_base, width: Width::Int32 });
    axis
}

fn at(v: f64) -> Inputs<f64> {
    Inputs { v_interpolator: v, ..Inputs::default() }
}

/// 4.1: pitch 10 mm, 1e-4 rpm: 10000 increments at 10 mm/min; with a gear of 3 at 3.333 mm/min.
#[test]
fn ten_thousand_increments() {
    let plain = with_velocity(Ratio { num: 10_000, denom: 10_000 }, TimeBase::Minute, 1_000_000);
    assert_eq!(steady(&plain, at(10_000.0 / 60.0)), [10_000, 0]);
    let gear = example("V");
    assert_eq!(steady(&gear, at(3_333.0 / 60.0)), [10_000, 0]);
    // 3333 is rounded: at 10 mm/min 30003 increments go out, a part in ten thousand too many; the exact pair gives 30000.
    assert_eq!(steady(&gear, at(10_000.0 / 60.0)), [30_003, 0]);
    let exact = with_velocity(Ratio { num: 30_000, denom: 10_000 }, TimeBase::Minute, 1_000_000);
    assert_eq!(steady(&exact, at(10_000.0 / 60.0)), [30_000, 0]);
}

/// The defaults 1/36: per second, per cycle of 2 ms, and per minute, where an increment is 1e-4 rpm = 0.036 deg/min.
#[test]
fn every_time_base() {
    let reso = Ratio { num: 1, denom: 36 };
    assert_eq!(steady(&with_velocity(reso, TimeBase::Second, 1_000_000), at(36.0)), [1, 0]);
    assert_eq!(steady(&with_velocity(reso, TimeBase::Cycle, 2_000_000), at(18_000.0)), [1, 0]);
    assert_eq!(steady(&with_velocity(reso, TimeBase::Minute, 1_000_000), at(36.0 / 60.0)), [1, 0]);
}

fn resolution_of_the_manual() -> Resolution {
    let one = Ratio { num: 1, denom: 1 };
    Resolution { incr_per_rev: 1 << 20, wegauf: Ratio { num: 3, ..one }, feed_const: Ratio { num: 50_000, ..one } }
}

/// 4.2: 2^20 increments, gear 3, 5 mm: R = 62.91456 increments per 0.1 um; 1 m/s^2 turns the motor with 3769.911 rad/s^2.
#[test]
fn path_resolution() {
    let resolution = resolution_of_the_manual();
    assert_eq!(scale::resolution(&resolution).to_bits(), 62.914_56_f64.to_bits());
    let alpha = 1e6 * angular_acceleration(&resolution);
    assert_eq!(format!("{alpha:.3}"), "3769.911");
    assert_eq!(format!("{:.3}", 0.48 * alpha), "1809.557");
    // Increments per revolution cancel where they make up the resolution.
    let coarse = Resolution { incr_per_rev: 1024, ..resolution };
    assert!((angular_acceleration(&coarse) / angular_acceleration(&resolution) - 1.0).abs() < 1e-15, "rounding alone");
    // Without a feed constant the path resolution stands by itself.
    let own = Resolution { feed_const: Ratio { num: 1, denom: 1 }, ..resolution };
    assert_eq!(scale::resolution(&own).to_bits(), 3.0_f64.to_bits());
}

/// 4.2: 500 increments at the nominal torque of 0.45 Nm, 600 with the weight 12/10; the example's own load at 1 m/s^2 is
/// far beyond 16 bits.
#[test]
fn nominal_torque() {
    let axis = example("T");
    let torque = axis.control.feedforward.as_ref().unwrap().torque_scale.unwrap();
    let nominal = 0.45 / (0.48 * angular_acceleration(&torque.resolution));
    assert_eq!(steady(&axis, Inputs { a_interpolator: nominal, ..Inputs::default() }), [0, 600]);
    assert_eq!(steady(&axis, Inputs { a_interpolator: -nominal, ..Inputs::default() }), [0, -600]);
    let mut plain = axis.clone();
    plain.control.feedforward.as_mut().unwrap().acceleration = Ratio { num: 1, denom: 1 };
    assert_eq!(steady(&plain, Inputs { a_interpolator: nominal, ..Inputs::default() }), [0, 500]);
    assert_eq!(steady(&axis, Inputs { a_interpolator: 1e6, ..Inputs::default() }), [0, 32_767]);
    assert_eq!(steady(&axis, Inputs { a_interpolator: -1e6, ..Inputs::default() }), [0, -32_768]);
}

/// A linear motor: F = m a, 200 kg at 1.5 m/s^2 are 300 N.
#[test]
fn linear_motor() {
    let torque = Torque {
        resolution: resolution_of_the_manual(),
        motor: Motor::Linear,
        load: 200.0,
        reference: 300.0,
        scale: Ratio { num: 1000, denom: 1 },
        width: Width::Int16,
    };
    assert!((scale::torque(&torque) * 1.5e6 - 1000.0).abs() < 1e-9, "rounding alone");
}

/// Kv = 0.01/s times P-AXIS-00099; 1 m/min gives multi_gain_z / multi_gain_n increments.
#[test]
fn position_controller() {
    let axis = example("X");
    let coeffs = Designed::from(axis).position_control;
    assert_eq!((coeffs.kv, coeffs.lag), (20.0, 0.05));
    let mut inputs = <PositionControl as Block<f64>>::inputs(&coeffs);
    inputs.x_command = 1e6 / 60.0 / 20.0; // a lag that is 1 m/min at 20/s
    let (mut state, mut outputs) =
        (<PositionControl as Block<f64>>::state(), <PositionControl as Block<f64>>::outputs());
    <PositionControl as Block<f64>>::step(&mut state, &coeffs, &inputs, &mut outputs);
    assert_eq!(outputs.manipulated_variable, 20_000);
}

/// A ramp of 1 per cycle of 1 ms, after a delay: 150 us are 0.15 cycles, 5999 us are 5.999.
#[test]
fn ramps() {
    for (us, cycles) in [(0, 0.0), (150, 0.15), (1000, 1.0), (2500, 2.5), (5999, 5.999)] {
        let coeffs = design_delay(us, 1_000_000);
        let mut state = delay::State::default();
        delay::preset(&mut state, 0.0);
        let mut delayed = delay::Delayed::default();
        for n in 0..100 {
            delay::step(&mut state, &coeffs, f64::from(n), &mut delayed);
            if n > 6 {
                let (found, expected) = (delayed.y, f64::from(n) - cycles);
                assert!((found - expected).abs() < 1e-13, "{us} us: {found}, {expected}: rounding of two products");
            }
        }
    }
}

#[test]
fn halves_and_ends() {
    for (width, x, expected) in [
        (Width::Int16, 0.5, (1, false)),
        (Width::Int16, -0.5, (-1, false)),
        (Width::Int16, 0.499_999_999_999_999_94, (0, false)),
        (Width::Int16, 2.5, (3, false)),
        (Width::Int16, -2.5, (-3, false)),
        (Width::Int16, 32_766.5, (32_767, false)),
        (Width::Int16, 32_767.0, (32_767, false)),
        (Width::Int16, 32_767.499_999_999_99, (32_767, false)),
        (Width::Int16, 32_767.5, (32_767, true)),
        (Width::Int16, -32_767.5, (-32_768, false)),
        (Width::Int16, -32_768.0, (-32_768, false)),
        (Width::Int16, -32_768.499_999_999_99, (-32_768, false)),
        (Width::Int16, -32_768.5, (-32_768, true)),
        (Width::Int32, 2_147_483_646.5, (2_147_483_647, false)),
        (Width::Int32, -2_147_483_647.5, (-2_147_483_648, false)),
        (Width::Int32, -2_147_483_647.3, (-2_147_483_647, false)),
        (Width::Int32, 2_147_483_647.499_999_8, (2_147_483_647, false)),
        (Width::Int32, 2_147_483_647.5, (2_147_483_647, true)),
        (Width::Int32, -2_147_483_648.499_999_5, (-2_147_483_648, false)),
        (Width::Int32, -2_147_483_648.5, (-2_147_483_648, true)),
        (Width::Int32, f64::NAN, (0, true)),
        (Width::Int32, 1e300, (2_147_483_647, true)),
        (Width::Int32, -1e300, (-2_147_483_648, true)),
    ] {
        let mut datum = process_data::Datum::default();
        process_data::round(&mut datum, &scale::range(width, RealKind::F64), x);
        assert_eq!((datum.value, datum.limited), expected, "{x:?} in {width:?}");
    }
    for (width, x, expected) in [
        (Width::Int32, 0.499_999_97_f32, (0, false)),
        (Width::Int32, 0.5, (1, false)),
        (Width::Int32, 8_388_607.5, (8_388_608, false)),
        (Width::Int32, -3.5, (-4, false)),
        // The last number below 2^31, and 2^31: what 2147483647 becomes in single precision.
        (Width::Int32, 2_147_483_520.0, (2_147_483_520, false)),
        (Width::Int32, 2_147_483_648.0, (2_147_483_647, true)),
        (Width::Int32, -2_147_483_520.0, (-2_147_483_520, false)),
        (Width::Int32, -2_147_483_648.0, (-2_147_483_648, false)),
        (Width::Int32, -2_147_483_904.0, (-2_147_483_648, true)),
        (Width::Int32, 3e9, (2_147_483_647, true)),
        (Width::Int16, 32_767.498, (32_767, false)),
        (Width::Int16, 32_767.5, (32_767, true)),
        (Width::Int16, -32_768.496, (-32_768, false)),
        (Width::Int16, -32_768.5, (-32_768, true)),
    ] {
        let mut datum = process_data::Datum::default();
        process_data::round(&mut datum, &rounded(&scale::range(width, RealKind::F32), RealKind::F32), x);
        assert_eq!((datum.value, datum.limited), expected, "{x:?} in {width:?}");
    }
}

/// Improved position control on a gantry slave is the error 70600, also where the mode is set at run time.
#[test]
fn a_gantry_slave_refuses_its_mode() {
    let mut axis = example("Y1");
    axis.control.master = Some(9);
    axis.ipc.enable = Enable::Off;
    assert_eq!(blocks(&Designed::from(axis.clone())).expect("a slave has blocks").len(), 3);
    let coeffs = Designed::from(axis).ipc;
    let (mut state, mut outputs) = (<Ipc as Block<f64>>::state(), <Ipc as Block<f64>>::outputs());
    for (mode, expected) in [(mode_off(), 0), (mode_on(), 70_600), (mode_dryrun(), 70_600), (7, 2), (mode_off(), 0)] {
        let inputs = reference::ipc::Inputs { mode, ..<Ipc as Block<f64>>::inputs(&coeffs) };
        <Ipc as Block<f64>>::step(&mut state, &coeffs, &inputs, &mut outputs);
        assert_eq!((outputs.error_id, outputs.fault, outputs.v_add), (expected, expected != 0, 0.0), "{mode}");
    }
}
