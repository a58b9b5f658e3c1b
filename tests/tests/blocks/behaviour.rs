//! What designed blocks do in operation: at a constant velocity over a grid of designs, and with their states over all
//! golden cases. What does not need a design is tested next to the reference.

use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::by_depth;
use generator::axis::{Axis, DirectSource, Enable, Filter, Ipc as IpcAxis, Mode, Numbers, Prototype, Stage};
use generator::blocks;
use generator::blocks::Designed;
use golden::case::{self, Case};
use portable::{Block, Literal, RealKind};
use rayon::prelude::*;
use reference::ipc::Ipc;

const DIRECT: Mode = Mode::Direct { source: DirectSource::Motor };
/// Centre frequencies at 1 ms, from a millionth to 0.45 of the sampling frequency [Hz].
const FREQUENCIES: [f64; 9] = [0.001, 0.01, 0.1, 1.0, 11.0, 53.0, 160.0, 300.0, 450.0];

/// Not the last bit, whatever stands after the band-pass.
#[test]
fn a_constant_velocity_gives_exactly_0_where_a_band_pass_comes_first() {
    for (band_pass, all_pass) in filters() {
        let behind = [Filter::NoFilter, all_pass, band_pass];
        for filters in behind.map(|behind| [band_pass, behind]).into_iter().chain([[Filter::NoFilter, band_pass]]) {
            assert_eq!(largest(DIRECT, filters).to_bits(), 0, "{filters:?}");
        }
    }
}

/// Rounding of the states, and below a hundredth of the sampling frequency that of the oscillation's coefficients: its gain
/// at DC is not exactly 1, and what is missing comes in slowly.
#[test]
fn a_constant_velocity_gives_next_to_nothing_behind_an_all_pass_or_an_oscillation() {
    for (band_pass, all_pass) in filters() {
        let rest = largest(DIRECT, [all_pass, band_pass]);
        assert!(rest < 1e-15, "{rest:e}: {all_pass:?}, {band_pass:?}");
    }
    for f0 in FREQUENCIES {
        let allowed = if f0 > 10.0 { 1e-12 } else { 1e-9 };
        let band_pass = Filter::Bandpass { prototype: Prototype::CritDamping, order: 1, f0, q_factor: 1.0 };
        for hundredths in 1..=99 {
            let mode = Mode::Indirect { osc_damping: f64::from(hundredths) / 100.0 };
            let rest = largest(mode, [band_pass, Filter::NoFilter]);
            assert!(rest < allowed, "{rest:e}: {mode:?}, {f0} Hz");
        }
    }
}

/// On a PLC a subnormal number can cost a hundred times the time of another.
#[test]
fn no_state_of_a_golden_case_is_ever_subnormal_or_no_number() {
    in_both_real_types().par_iter().for_each(assert_states_normal);
}

fn assert_states_normal(case: &Case) {
    let count = by_depth(5_000, 5_000, 200_000);
    let samples = case::inputs(case, count).unwrap_or_else(|mistake| panic!("{mistake}"));
    let kind = blocks::named(case.block.program.block).expect("the axis has the block");
    let (mut reference, mut values, mut outputs) = (kind.start(&case.axis), Vec::new(), Vec::new());
    let specialised = kind.program(&case.axis, None).expect("the block has a program");
    let places: Vec<usize> = (0..specialised.state.len()).collect();
    for sample in 0..samples.len() {
        samples.read(sample, &mut values);
        reference.step(&values, &mut outputs);
        let is_bad = |leaf: &Literal| match *leaf {
            Literal::F64(value) => value != 0.0 && !value.is_normal(),
            Literal::F32(value) => value != 0.0 && !value.is_normal(),
            _ => false,
        };
        let mut bad = None;
        reference.state(&places, &mut |leaf| bad = bad.or(Some(leaf).filter(is_bad)));
        assert_eq!(bad, None, "{}: sample {sample}", title(case));
    }
}

/// Every prototype and order at every frequency, narrow and wide, each with an all-pass in the same band.
fn filters() -> Vec<(Filter, Filter)> {
    let mut filters = Vec::new();
    for prototype in [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel] {
        for (order, f0) in (1..=3).flat_map(|order| FREQUENCIES.map(|f0| (order, f0))) {
            for q_factor in [1.0, 2.5, 10.0] {
                let all_pass = Filter::Allpass { f0, q_factor };
                filters.push((Filter::Bandpass { prototype, order, f0, q_factor }, all_pass));
            }
        }
    }
    filters
}

/// The largest |v_add_calculated| of a block with one stage of weight 1 that is switched on at a constant velocity, as a
/// part of that velocity.
fn largest(mode: Mode, filter: [Filter; 2]) -> f64 {
    let stage = Stage { mode, weight_fact_num: 1, weight_fact_denom: 1, filter };
    let ipc = IpcAxis {
        enable: Enable::On,
        v_add_max_fact: 2000,
        v_max: 500_000.0,
        fade: 0.0,
        ride_through: 0,
        numbers: Numbers::Fixed,
        watch: false,
        delay_cycles: None,
        stage: [Some(stage), None, None],
    };
    let axis = Axis {
        name: "X".to_owned(),
        short_names: false,
        counts_calls: false,
        real: RealKind::F64,
        cycle_time_ns: 1_000_000,
        ipc,
        control: generator::axis::Control::default(),
        canonical: String::new(),
        excitation: None,
        drive: Default::default(),
        canonical_of: Default::default(),
    };
    let coeffs = Designed::from(axis).ipc;
    let (mut state, mut outputs) = (<Ipc as Block<f64>>::state(), <Ipc as Block<f64>>::outputs());
    let mut inputs = <Ipc as Block<f64>>::inputs(&coeffs);
    inputs.v_motor = 123_456.789;
    let mut largest = 0.0;
    for _ in 0..2_000 {
        <Ipc as Block<f64>>::step(&mut state, &coeffs, &inputs, &mut outputs);
        largest = f64::max(largest, outputs.v_add_calculated.abs());
    }
    largest / inputs.v_motor
}
